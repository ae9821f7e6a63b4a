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
#include "itkSurfaceSpikes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace itk
{
namespace
{
using PointType = TriangleSurface::PointType;

/** Of the distance to them, how far apart those that a spike is connected with may lie: a needle of one to four. */
constexpr double NeedleShare = 0.25;

double
SquaredDistance(const PointType & a, const PointType & b)
{
  double sum = 0.0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    sum += (a[d] - b[d]) * (a[d] - b[d]);
  }
  return sum;
}

/** What a point is connected with. */
struct Ring
{
  double    nearest{ std::numeric_limits<double>::max() };
  PointType low{
    { std::numeric_limits<double>::max(), std::numeric_limits<double>::max(), std::numeric_limits<double>::max() }
  };
  PointType high{ { std::numeric_limits<double>::lowest(),
                    std::numeric_limits<double>::lowest(),
                    std::numeric_limits<double>::lowest() } };

  void
  Add(const PointType & centre, const PointType & neighbour)
  {
    nearest = std::min(nearest, SquaredDistance(centre, neighbour));
    for (unsigned int d = 0; d < 3; ++d)
    {
      low[d] = std::min(low[d], neighbour[d]);
      high[d] = std::max(high[d], neighbour[d]);
    }
  }
};
} // namespace

std::vector<SurfaceSpike>
FindSurfaceSpikes(const TriangleSurface & surface, const std::vector<std::uint32_t> & welded, double length)
{
  // By the welded point. Nearly all triangles of a scan are far smaller: nothing is kept of the others.
  std::map<std::uint32_t, Ring> rings;
  for (const auto & triangle : surface.triangles)
  {
    for (unsigned int k = 0; k < 3; ++k)
    {
      const std::uint32_t a = welded[triangle[k]];
      const std::uint32_t b = welded[triangle[(k + 1) % 3]];
      const std::uint32_t c = welded[triangle[(k + 2) % 3]];
      const PointType &   from = surface.points[a];
      if (a != b && a != c && SquaredDistance(from, surface.points[b]) > length * length &&
          SquaredDistance(from, surface.points[c]) > length * length)
      {
        rings[a];
      }
    }
  }
  if (rings.empty())
  {
    return {};
  }
  for (const auto & triangle : surface.triangles)
  {
    for (unsigned int k = 0; k < 3; ++k)
    {
      const std::uint32_t a = welded[triangle[k]];
      const auto          ring = rings.find(a);
      for (unsigned int other = 1; other < 3 && ring != rings.end(); ++other)
      {
        const std::uint32_t b = welded[triangle[(k + other) % 3]];
        if (a != b)
        {
          ring->second.Add(surface.points[a], surface.points[b]);
        }
      }
    }
  }
  std::vector<SurfaceSpike> spikes;
  for (const auto & [point, ring] : rings)
  {
    const double nearest = std::sqrt(ring.nearest);
    if (nearest > length && std::sqrt(SquaredDistance(ring.low, ring.high)) < NeedleShare * nearest)
    {
      spikes.push_back({ point, nearest });
    }
  }
  return spikes;
}
} // namespace itk
