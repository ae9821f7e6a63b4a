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
#include "itkDentalPhantomCastBase.h"

#include <algorithm>
#include <utility>

namespace itk
{
namespace
{
using PointType = DentalPhantomDentition::PointType;

/** Ears of a simple polygon in the plane, best shaped first, in the polygon's own order of corners. */
std::vector<std::array<std::size_t, 3>>
ClipEars(const std::vector<std::array<double, 2>> & polygon)
{
  std::vector<std::size_t> left(polygon.size());
  double                   area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    left[i] = i;
    const auto & a = polygon[i];
    const auto & b = polygon[(i + 1) % polygon.size()];
    area += a[0] * b[1] - b[0] * a[1];
  }
  const double sign = area < 0.0 ? -1.0 : 1.0;
  const auto   cross = [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto & a = polygon[i];
    const auto & b = polygon[j];
    const auto & c = polygon[k];
    return sign * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
  };
  const auto quality = [&](std::size_t at) {
    const std::size_t n = left.size();
    const std::size_t i = left[(at + n - 1) % n];
    const std::size_t j = left[at];
    const std::size_t k = left[(at + 1) % n];
    const double      doubled = cross(i, j, k);
    if (doubled <= 1e-9)
    {
      return doubled - 1.0;
    }
    for (const std::size_t p : left)
    {
      if (p != i && p != j && p != k && cross(i, j, p) >= 0.0 && cross(j, k, p) >= 0.0 && cross(k, i, p) >= 0.0)
      {
        return -2.0;
      }
    }
    double longest = 0.0;
    for (const auto & side : { std::make_pair(i, j), std::make_pair(j, k), std::make_pair(k, i) })
    {
      const double dx = polygon[side.first][0] - polygon[side.second][0];
      const double dy = polygon[side.first][1] - polygon[side.second][1];
      longest = std::max(longest, dx * dx + dy * dy);
    }
    return doubled / longest;
  };
  std::vector<std::array<std::size_t, 3>> ears;
  std::vector<double>                     qualities;
  for (std::size_t at = 0; at < left.size(); ++at)
  {
    qualities.push_back(quality(at));
  }
  while (left.size() > 2)
  {
    const auto        best = std::max_element(qualities.begin(), qualities.end());
    const std::size_t at = static_cast<std::size_t>(best - qualities.begin());
    const std::size_t n = left.size();
    ears.push_back({ { left[(at + n - 1) % n], left[at], left[(at + 1) % n] } });
    left.erase(left.begin() + static_cast<long>(at));
    qualities.erase(best);
    // Neighbours change shape; corners that the clipped one blocked may be free: all that were blocked are asked again.
    for (std::size_t k = 0; k < left.size(); ++k)
    {
      if (k == at % left.size() || k == (at + left.size() - 1) % left.size() || qualities[k] == -2.0)
      {
        qualities[k] = quality(k);
      }
    }
  }
  return ears;
}
} // namespace

void
AddDentalPhantomCastBase(unsigned int                   jaw,
                         const DentalPhantomDentition & dentition,
                         const DentalPhantomGrid &      grid,
                         DentalPhantomJawSurface &      result)
{
  const DentalPhantomJaw & source = dentition.GetParameters().jaws[jaw];
  std::vector<PointType> & points = result.surface.points;
  auto &                   triangles = result.surface.triangles;
  // Below the border: walls, a plane bottom, and the two distal ends.
  double bottom = 1e9;
  for (const PointType & p : points)
  {
    bottom = std::min(bottom, p[2]);
  }
  bottom -= dentition.GetParameters().baseHeight;
  const auto add = [&](double x, double y, double o) {
    points.push_back({ { x, y, o } });
    result.labels.push_back(0);
    return static_cast<std::uint32_t>(points.size() - 1);
  };
  std::vector<std::uint32_t> keel;
  if (source.palate)
  {
    for (int i = 0; i <= grid.half; ++i)
    {
      keel.push_back(add(points[grid.ids[grid.half + i].back()][0], 0.0, bottom));
    }
  }
  std::vector<std::vector<std::uint32_t>> under(grid.columns);
  for (int c = 0; c < grid.columns; ++c)
  {
    const PointType buccal = points[grid.ids[c].front()];
    const PointType lingual = points[grid.ids[c].back()];
    double          unused[2];
    double          normal[2];
    dentition.GetArch().GetPoint(jaw, grid.stations[c], unused, normal);
    // A drafted wall, as a trimmer leaves it.
    const double draft = 1.5;
    const double outer[2] = { buccal[0] + draft * normal[0], buccal[1] + draft * normal[1] };
    if (source.palate)
    {
      under[c].push_back(keel[std::abs(c - grid.half)]);
    }
    else
    {
      under[c].push_back(grid.ids[c].back());
      for (int r = 1; r <= grid.wallRows; ++r)
      {
        const double t = static_cast<double>(r) / grid.wallRows;
        under[c].push_back(add(lingual[0], lingual[1], lingual[2] + t * (bottom - lingual[2])));
      }
    }
    const PointType from = points[under[c].back()];
    for (int r = 1; r <= grid.bottomRows; ++r)
    {
      const double t = static_cast<double>(r) / grid.bottomRows;
      under[c].push_back(add(from[0] + t * (outer[0] - from[0]), from[1] + t * (outer[1] - from[1]), bottom));
    }
    for (int r = 1; r < grid.wallRows; ++r)
    {
      const double t = static_cast<double>(r) / grid.wallRows;
      under[c].push_back(add(outer[0] + t * (buccal[0] - outer[0]),
                             outer[1] + t * (buccal[1] - outer[1]),
                             bottom + t * (buccal[2] - bottom)));
    }
    under[c].push_back(grid.ids[c].front());
  }
  for (int c = 0; c + 1 < grid.columns; ++c)
  {
    DentalPhantomGrid::AddStrip(result.surface, under[c], under[c + 1]);
  }
  // The two ends of a filled cast share a line from the palate's seam to the keel.
  std::vector<std::uint32_t> line;
  if (source.palate)
  {
    const PointType from = points[grid.ids[0].back()];
    for (int r = 1; r < grid.wallRows; ++r)
    {
      line.push_back(add(from[0], 0.0, from[2] + (bottom - from[2]) * r / grid.wallRows));
    }
  }
  for (const int c : { 0, grid.columns - 1 })
  {
    std::vector<std::uint32_t> ring(grid.ids[c].begin(), grid.ids[c].end());
    ring.insert(ring.end(), line.begin(), line.end());
    ring.insert(ring.end(), under[c].begin() + (source.palate ? 0 : 1), under[c].end() - 1);
    double unused[2];
    double normal[2];
    dentition.GetArch().GetPoint(jaw, grid.stations[c], unused, normal);
    std::vector<std::array<double, 2>> polygon;
    for (const std::uint32_t id : ring)
    {
      polygon.push_back({ { points[id][0] * normal[0] + points[id][1] * normal[1], points[id][2] } });
    }
    for (const auto & ear : ClipEars(polygon))
    {
      triangles.push_back(c == 0 ? TriangleSurface::TriangleType{ { ring[ear[0]], ring[ear[1]], ring[ear[2]] } }
                                 : TriangleSurface::TriangleType{ { ring[ear[0]], ring[ear[2]], ring[ear[1]] } });
    }
  }
}
} // namespace itk
