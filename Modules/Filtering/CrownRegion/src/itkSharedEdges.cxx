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
#include "itkSharedEdges.h"

#include <cmath>

namespace itk
{
namespace CrownRegionParts
{
namespace
{
using PointType = TriangleSurface::PointType;
}

std::vector<std::uint32_t>
WeldedIds(const TriangleSurface & surface)
{
  const std::size_t n = surface.points.size();
  std::size_t       size = 16;
  while (size < 2 * n)
  {
    size *= 2;
  }
  constexpr std::uint32_t    empty = 0xffffffffu;
  std::vector<std::uint32_t> table(size, empty);
  std::vector<std::uint32_t> ids(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const PointType & p = surface.points[i];
    std::uint64_t     hash = 0x9e3779b97f4a7c15ull;
    for (const double value : p)
    {
      // Raster of 1e-6 mm for the hash alone; equality below is exact. Adding 0 turns -0 into 0.
      hash = (hash ^ static_cast<std::uint64_t>(std::llround(std::clamp(value, -1e9, 1e9) * 1e6) + 0)) *
             0xbf58476d1ce4e5b9ull;
      hash ^= hash >> 29;
    }
    std::size_t slot = hash & (size - 1);
    while (table[slot] != empty && surface.points[table[slot]] != p)
    {
      slot = (slot + 1) & (size - 1);
    }
    if (table[slot] == empty)
    {
      table[slot] = static_cast<std::uint32_t>(i);
    }
    ids[i] = table[slot];
  }
  return ids;
}
} // namespace CrownRegionParts
} // namespace itk
