/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#include "itkMarginCut.h"

#include "itkMinimumCut.h"
#include "itkSharedEdges.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace CrownRegionParts
{
namespace
{
constexpr std::uint32_t Gingiva = 0xffffffffu;
constexpr std::uint32_t Crown = 0xfffffffeu;

struct Bend
{
  std::uint32_t triangles[2];
  std::uint32_t points[2];
  double        length;
  /** Turning angle, concave positive, and the distance over which it turns, mm. */
  double angle;
  double width;
};
} // namespace

std::vector<std::uint8_t>
CutAtMargin(const TriangleSurface &            surface,
            const std::vector<std::uint32_t> & ids,
            double                             winding,
            const std::vector<float> &         inside,
            double                             reach)
{
  using PointType = TriangleSurface::PointType;
  /** Cost of a mm^2 at `reach` beyond the found margin, in mm of line. */
  constexpr double areaCost = 0.3;
  /** Curvature (1/mm) at which a mm of line costs half. */
  constexpr double halfCurvature = 0.2;
  constexpr double scale = 1e4;

  const std::size_t          count = surface.triangles.size();
  std::vector<PointType>     normals(count);
  std::vector<double>        areas(count);
  std::vector<double>        height(count);
  std::vector<std::uint32_t> node(count);
  std::uint32_t              nodes = 0;
  for (std::size_t t = 0; t < count; ++t)
  {
    const auto &    c = surface.triangles[t];
    const PointType n = surface.AreaNormal(t);
    areas[t] = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (unsigned int d = 0; d < 3; ++d)
    {
      normals[t][d] = areas[t] > 0.0 ? n[d] / areas[t] : 0.0;
    }
    height[t] = (static_cast<double>(inside[c[0]]) + inside[c[1]] + inside[c[2]]) / 3.0;
    // Large triangles of a base reach up to the margin: the lowest corner counts.
    const double lowest = std::min({ inside[c[0]], inside[c[1]], inside[c[2]] });
    node[t] = lowest <= -reach ? Gingiva : height[t] >= reach ? Crown : nodes++;
  }

  std::vector<Bend>               bends;
  std::vector<double>             turning(surface.points.size(), 0.0);
  std::vector<double>             over(surface.points.size(), 0.0);
  const std::vector<std::uint8_t> all(count, 1);
  ForEachSharedEdge(
    surface.triangles, ids, all, [&](std::uint32_t first, std::uint32_t second, std::uint32_t from, std::uint32_t to) {
      if (node[first] >= Crown && node[second] >= Crown)
      {
        return;
      }
      const PointType & a = surface.points[from];
      const PointType & b = surface.points[to];
      const PointType & m = normals[first];
      const PointType & k = normals[second];
      const double      e[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
      const double      l = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
      if (!(l > 1e-9))
      {
        return;
      }
      const double cosine = m[0] * k[0] + m[1] * k[1] + m[2] * k[2];
      const double sine =
        ((m[1] * k[2] - m[2] * k[1]) * e[0] + (m[2] * k[0] - m[0] * k[2]) * e[1] + (m[0] * k[1] - m[1] * k[0]) * e[2]) /
        l;
      const Bend bend = { { first, second },
                          { ids[from], ids[to] },
                          l,
                          -winding * std::atan2(sine, cosine),
                          std::max(2.0 / 3.0 * (areas[first] + areas[second]) / l, 0.02) };
      for (const std::uint32_t p : bend.points)
      {
        turning[p] += bend.angle * l;
        over[p] += bend.width * l;
      }
      bends.push_back(bend);
    });

  MinimumCut cut(nodes);
  for (const Bend & bend : bends)
  {
    // The neighbourhood's share keeps single facets from leading the line.
    const double own = bend.angle / bend.width;
    const double around =
      (turning[bend.points[0]] + turning[bend.points[1]]) / (over[bend.points[0]] + over[bend.points[1]]);
    const double curvature = std::max(0.0, 0.5 * (own + around)) / halfCurvature;
    const auto   cost = static_cast<std::int64_t>(scale * bend.length / (1.0 + curvature * curvature)) + 1;
    const auto   a = node[bend.triangles[0]];
    const auto   b = node[bend.triangles[1]];
    if (a < Crown && b < Crown)
    {
      cut.AddEdge(a, b, cost);
    }
    else
    {
      const bool crown = (a < Crown ? b : a) == Crown;
      cut.AddTies(a < Crown ? a : b, crown ? cost : 0, crown ? 0 : cost);
    }
  }
  for (std::size_t t = 0; t < count; ++t)
  {
    if (node[t] < Crown)
    {
      const double cost = scale * areaCost * areas[t] * std::min(std::abs(height[t]) / reach, 1.0);
      const auto   tie = static_cast<std::int64_t>(cost);
      cut.AddTies(node[t], height[t] > 0.0 ? tie : 0, height[t] > 0.0 ? 0 : tie);
    }
  }
  const std::vector<std::uint8_t> sides = cut.Solve();
  std::vector<std::uint8_t>       marks(count);
  for (std::size_t t = 0; t < count; ++t)
  {
    marks[t] = node[t] == Crown ? 1 : node[t] == Gingiva ? 0 : sides[node[t]];
  }
  return marks;
}
} // namespace CrownRegionParts
} // namespace itk
