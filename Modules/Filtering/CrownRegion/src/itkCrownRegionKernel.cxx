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
#include "itkCrownRegionKernel.h"

#include "itkArchLine.h"
#include "itkCrownPieces.h"
#include "itkDistalTissue.h"
#include "itkGingivalMargin.h"
#include "itkMarginCut.h"
#include "itkOcclusalSurfaceFit.h"
#include "itkSharedEdges.h"
#include "itkSurfaceParts.h"
#include "itkValleyChart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
namespace
{
using PointType = TriangleSurface::PointType;
using namespace CrownRegionParts;

/** mm from each station to the middle between it and the next one with another mark. */
std::vector<double>
DistanceToChange(const std::vector<std::uint8_t> & marks)
{
  std::vector<double> distance(marks.size(), 1e3);
  double              left = 1e3;
  double              right = 1e3;
  for (std::size_t k = 1; k < marks.size(); ++k)
  {
    left = marks[k] != marks[k - 1] ? 0.5 * StationSpacing : left + StationSpacing;
    distance[k] = std::min(distance[k], left);
    const std::size_t j = marks.size() - 1 - k;
    right = marks[j] != marks[j + 1] ? 0.5 * StationSpacing : right + StationSpacing;
    distance[j] = std::min(distance[j], right);
  }
  return distance;
}

void
SumArea(const TriangleSurface & surface, CrownRegionResult & result)
{
  result.area = 0.0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (result.triangles[t] != 0)
    {
      result.area += TriangleArea(surface, t);
    }
  }
}
} // namespace

CrownRegionResult
ComputeCrownRegion(const TriangleSurface &                      surface,
                   ToothCode::JawEnum                           jaw,
                   const std::array<std::array<double, 3>, 3> & axes,
                   const std::array<double, 3> &                origin,
                   const CrownRegionOptions &                   options)
{
  if (jaw == ToothCode::JawEnum::Unknown)
  {
    throw std::invalid_argument("The jaw is unknown, and with it the side on which the crowns stand.");
  }
  CrownRegionResult result;
  const std::size_t n = surface.points.size();
  result.points.assign(n, 0);
  result.triangles.assign(surface.triangles.size(), 0);
  const auto aborted = [&]() { return options.abort && options.abort(); };

  // x anterior, y left, height toward the opposing teeth. This mirrors the upper jaw, which curvature does not mind.
  const double           sign = jaw == ToothCode::JawEnum::Upper ? -1.0 : 1.0;
  std::vector<PointType> q(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const PointType & p = surface.points[i];
    const double      d[3] = { p[0] - origin[0], p[1] - origin[1], p[2] - origin[2] };
    for (unsigned int r = 0; r < 3; ++r)
    {
      q[i][r] = axes[r][0] * d[0] + axes[r][1] * d[1] + axes[r][2] * d[2];
    }
    q[i][2] *= sign;
  }
  const std::vector<double> areas = surface.VertexAreas();

  // Occlusal surface, first about the frame's origin, then about the middle of the arch.
  Arch               arch;
  OcclusalSurface    occlusal;
  std::vector<float> depth(n, 0.0f);
  for (unsigned int pass = 0; pass < 2; ++pass)
  {
    if (aborted() || !FitOcclusalSurface(FindTops(q, areas, arch.centre[0], arch.centre[1]), occlusal))
    {
      return result;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      depth[i] = static_cast<float>(occlusal(q[i][0], q[i][1]) - q[i][2]);
    }
    if (pass == 0)
    {
      double low[2] = { 1e9, 1e9 };
      double high[2] = { -1e9, -1e9 };
      for (const SectorTop & top : FindTops(q, areas, 0.0, 0.0))
      {
        if (occlusal(top.x, top.y) - top.h < 3.0)
        {
          low[0] = std::min(low[0], top.x);
          high[0] = std::max(high[0], top.x);
          low[1] = std::min(low[1], top.y);
          high[1] = std::max(high[1], top.y);
        }
      }
      if (high[0] - low[0] < 10.0 || high[1] - low[1] < 15.0)
      {
        return result;
      }
      arch.centre[0] = low[0] + 0.4 * (high[0] - low[0]);
      arch.centre[1] = 0.5 * (low[1] + high[1]);
    }
  }
  if (aborted() || !FindArch(q, areas, depth, arch))
  {
    return result;
  }

  const std::size_t  stations = arch.points.size();
  const double       deepest = options.maximumCrownHeight + 1.5;
  const std::size_t  depths = static_cast<std::size_t>(deepest / DepthSpacing) + 2;
  std::vector<float> station(n, -1.0f);
  std::vector<float> offset(n, 0.0f);
  for (std::size_t i = 0; i < n; ++i)
  {
    if (depth[i] < deepest)
    {
      double       radial = 0.0;
      const double s = arch.Station(q[i][0], q[i][1], radial);
      if (s >= 0.0 && std::abs(radial) < options.archHalfWidth)
      {
        station[i] = static_cast<float>(s);
        offset[i] = static_cast<float>(radial);
      }
    }
  }

  // Curvature of the band, as turning angles at edges.
  const std::vector<std::uint32_t> ids = SurfaceParts::Weld(surface);
  std::vector<std::uint8_t>        band(surface.triangles.size(), 0);
  std::vector<PointType>           normals(surface.triangles.size());
  double                           facing = 0.0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto & corner = surface.triangles[t];
    if (station[corner[0]] < 0.0f || station[corner[1]] < 0.0f || station[corner[2]] < 0.0f)
    {
      continue;
    }
    const PointType & a = q[corner[0]];
    const PointType & b = q[corner[1]];
    const PointType & c = q[corner[2]];
    const double      u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const double      v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
    const PointType   m = { { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] } };
    const double      l = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    if (!(l > 1e-12))
    {
      continue;
    }
    band[t] = 1;
    normals[t] = { { m[0] / l, m[1] / l, m[2] / l } };
    if (depth[corner[0]] < 2.5f)
    {
      facing += m[2];
    }
  }
  // Tops face up: this is the winding as it is here.
  const double winding = facing < 0.0 ? -1.0 : 1.0;
  ValleyChart  chart(stations, depths);
  // Turning across valleys that run across the arch, at the height of crowns, a station.
  std::vector<double> transverse(stations + 1, 0.0);
  ForEachSharedEdge(
    surface.triangles, ids, band, [&](std::uint32_t first, std::uint32_t second, std::uint32_t from, std::uint32_t to) {
      const PointType & a = q[from];
      const PointType & b = q[to];
      const PointType & m = normals[first];
      const PointType & k = normals[second];
      const double      e[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
      const double      l = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
      const double      cosine = m[0] * k[0] + m[1] * k[1] + m[2] * k[2];
      const double      sine =
        ((m[1] * k[2] - m[2] * k[1]) * e[0] + (m[2] * k[0] - m[0] * k[2]) * e[1] + (m[0] * k[1] - m[1] * k[0]) * e[2]) /
        l;
      const double s = 0.5 * (station[from] + station[to]);
      const auto & tangent = arch.tangents[std::min(static_cast<std::size_t>(s + 0.5), stations - 1)];
      const double along = (e[0] * tangent[0] + e[1] * tangent[1]) / l;
      // Both curvatures of a dent are a valley; only the part along the arch is wanted.
      const double turning = -winding * std::atan2(sine, cosine) * l;
      const double middle = 0.5 * (static_cast<double>(depth[from]) + depth[to]);
      if (middle > 0.5 && middle < 5.0)
      {
        const double across = (e[0] * tangent[1] - e[1] * tangent[0]) / l;
        transverse[static_cast<std::size_t>(s + 0.5)] += turning * across * across;
      }
      chart.Splat(0.5f * (offset[from] + offset[to]) > 0.0f ? 1 : 0,
                  s,
                  middle / DepthSpacing,
                  turning * along * along / StationSpacing);
    });
  if (aborted())
  {
    return result;
  }
  chart.Smooth();

  GingivalMargin margins[2];
  for (unsigned int side = 0; side < 2; ++side)
  {
    margins[side] = TraceGingivalMargin(chart, side, arch.front, options);
    for (std::size_t s = 0; s < stations; ++s)
    {
      result.meanCrownHeight += 0.5 * margins[side].depth[s] / static_cast<double>(stations);
      result.marginAngle += 0.5 * margins[side].angle[s] / static_cast<double>(stations);
    }
  }

  // Stations whose highest half square millimetre is far below the occlusal surface have no tooth; further where there
  // is a margin, for a ridge has none.
  std::vector<double> high(stations + 1, 0.0);
  {
    // Mean turning angle at the margin within 2 mm.
    std::vector<double> limit(stations + 1);
    for (std::size_t k = 0; k <= stations; ++k)
    {
      double            sum = 0.0;
      const std::size_t from = k > 4 ? k - 4 : 0;
      const std::size_t to = std::min(k + 4, stations - 1);
      for (std::size_t j = from; j <= to; ++j)
      {
        sum += 0.5 * (std::min(margins[0].angle[j], 0.8) + std::min(margins[1].angle[j], 0.8));
      }
      const double angle = sum / static_cast<double>(to - from + 1);
      limit[k] = options.gapDepth + std::clamp(6.0 * (angle - 0.2), 0.0, 1.5);
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      if (station[i] >= 0.0f)
      {
        const auto k = static_cast<std::size_t>(station[i] + 0.5f);
        high[k] += depth[i] < limit[k] ? areas[i] : 0.0;
      }
    }
  }
  std::vector<std::uint8_t> gap(stations + 1, 0);
  for (std::size_t k = 0; k < gap.size(); ++k)
  {
    gap[k] = high[k] + (k > 0 ? high[k - 1] : 0.0) + (k < stations ? high[k + 1] : 0.0) < 0.5 ? 1 : 0;
  }
  CutDistalTissue(surface, band, station, offset, depth, transverse, arch.front, gap);

  // Height above the margin; along the arch a gap begins where its stations do.
  std::vector<float>        inside(n, -1e3f);
  const std::vector<double> border = DistanceToChange(gap);
  for (std::size_t i = 0; i < n; ++i)
  {
    if (station[i] < 0.0f)
    {
      continue;
    }
    const auto   k = std::min(static_cast<std::size_t>(station[i]), stations - 2);
    const auto   nearest = static_cast<std::size_t>(station[i] + 0.5f);
    const double f = station[i] - static_cast<double>(k);
    const double buccal = std::clamp(0.5 + offset[i] / 5.0, 0.0, 1.0);
    double       margin = 0.0;
    for (unsigned int side = 0; side < 2; ++side)
    {
      margin +=
        (side == 1 ? buccal : 1.0 - buccal) * ((1.0 - f) * margins[side].depth[k] + f * margins[side].depth[k + 1]);
    }
    inside[i] = static_cast<float>(
      std::min(margin - options.marginInset - depth[i], (gap[nearest] != 0 ? -1.0 : 1.0) * border[nearest]));
  }
  if (aborted())
  {
    return result;
  }
  // The upper jaw is mirrored in q, not in the surface.
  result.triangles = CutAtMargin(surface, ids, sign * winding, inside, options.marginReach);
  MergeSmallPieces(surface, ids, options.minimumPieceArea, result.triangles);
  std::fill(result.points.begin(), result.points.end(), std::uint8_t{ 0 });
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (result.triangles[t] != 0)
    {
      for (const std::uint32_t id : surface.triangles[t])
      {
        result.points[id] = 1;
      }
    }
  }
  SumArea(surface, result);
  result.valid = result.area > 0.0;
  return result;
}

CrownRegionResult
CrownRegionFromLabels(const TriangleSurface & surface, const std::vector<std::uint8_t> & labels)
{
  if (labels.size() != surface.points.size())
  {
    throw std::invalid_argument("There are " + std::to_string(labels.size()) + " tooth labels for " +
                                std::to_string(surface.points.size()) + " points; give one a point.");
  }
  CrownRegionResult result;
  result.points.resize(labels.size());
  std::transform(labels.begin(), labels.end(), result.points.begin(), [](std::uint8_t label) {
    return static_cast<std::uint8_t>(label != 0 ? 1 : 0);
  });
  result.triangles.resize(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto & corner = surface.triangles[t];
    result.triangles[t] = result.points[corner[0]] + result.points[corner[1]] + result.points[corner[2]] > 1 ? 1 : 0;
  }
  SumArea(surface, result);
  result.valid = result.area > 0.0;
  return result;
}
} // namespace itk
