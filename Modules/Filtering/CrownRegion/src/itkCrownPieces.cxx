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
#include "itkCrownPieces.h"

#include "itkDisjointSets.h"
#include "itkSharedEdges.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace CrownRegionParts
{
double
TriangleArea(const TriangleSurface & surface, std::size_t triangle)
{
  const TriangleSurface::PointType n = surface.AreaNormal(triangle);
  return std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

void
MergeSmallPieces(const TriangleSurface &            surface,
                 const std::vector<std::uint32_t> & ids,
                 double                             minimumArea,
                 std::vector<std::uint8_t> &        marks)
{
  DisjointSets                    sets(surface.triangles.size());
  std::vector<std::uint8_t>       bordering(surface.triangles.size(), 0);
  const std::vector<std::uint8_t> all(surface.triangles.size(), 1);
  ForEachSharedEdge(
    surface.triangles, ids, all, [&](std::uint32_t first, std::uint32_t second, std::uint32_t, std::uint32_t) {
      if (marks[first] == marks[second])
      {
        sets.Join(first, second);
      }
      else
      {
        bordering[first] = 1;
        bordering[second] = 1;
      }
    });
  std::vector<double> pieces(surface.triangles.size(), 0.0);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
  {
    const std::uint32_t root = sets.Find(t);
    pieces[root] += TriangleArea(surface, t);
    if (bordering[t] != 0)
    {
      bordering[root] = 1;
    }
  }
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
  {
    // A loose speck surrounds nothing and is surrounded by nothing: no crown.
    const std::uint32_t root = sets.Find(t);
    if (pieces[root] < minimumArea)
    {
      marks[t] = marks[t] == 0 && bordering[root] != 0 ? 1 : 0;
    }
  }
}
} // namespace CrownRegionParts
} // namespace itk
