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
#ifndef itkSharedEdges_h
#define itkSharedEdges_h

#include "itkTriangleSurface.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace itk
{
namespace CrownRegionParts
{
/** Edges that two triangles share, found by the lower point's bucket. Calls body(triangle, other, a, b), a -> b in the
 * first triangle's order. Triangles whose flag is 0 are passed over. */
template <typename TBody>
void
ForEachSharedEdge(const std::vector<TriangleSurface::TriangleType> & triangles,
                  const std::vector<std::uint32_t> &                 ids,
                  const std::vector<std::uint8_t> &                  flags,
                  TBody &&                                           body)
{
  struct Half
  {
    std::uint32_t high;
    std::uint32_t triangle;
  };
  std::vector<std::uint32_t> begin(ids.size() + 2, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (flags[t] != 0)
    {
      for (unsigned int k = 0; k < 3; ++k)
      {
        ++begin[std::min(ids[triangles[t][k]], ids[triangles[t][(k + 1) % 3]]) + 2];
      }
    }
  }
  for (std::size_t i = 2; i < begin.size(); ++i)
  {
    begin[i] += begin[i - 1];
  }
  std::vector<Half> halves(begin.back());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (flags[t] == 0)
    {
      continue;
    }
    for (unsigned int k = 0; k < 3; ++k)
    {
      const std::uint32_t a = ids[triangles[t][k]];
      const std::uint32_t b = ids[triangles[t][(k + 1) % 3]];
      const std::uint32_t low = std::min(a, b);
      const std::uint32_t high = std::max(a, b);
      // Entries of this point so far lie in [start, end): start is the previous point's final end.
      std::uint32_t & end = begin[low + 1];
      for (std::uint32_t h = low == 0 ? 0 : begin[low]; h < end; ++h)
      {
        if (halves[h].high == high && halves[h].triangle != t)
        {
          body(static_cast<std::uint32_t>(t), halves[h].triangle, a, b);
          break;
        }
      }
      halves[end++] = { high, static_cast<std::uint32_t>(t) };
    }
  }
}
} // namespace CrownRegionParts
} // namespace itk

#endif
