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
#include "itkKeepTriangles.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace itk
{
TriangleSurface
KeepTriangles(const TriangleSurface & surface, const std::vector<std::uint8_t> & marks)
{
  if (marks.size() != surface.triangles.size())
  {
    throw std::invalid_argument("There are " + std::to_string(marks.size()) + " marks for " +
                                std::to_string(surface.triangles.size()) + " triangles; give one a triangle.");
  }
  constexpr std::uint32_t    unused = std::numeric_limits<std::uint32_t>::max();
  TriangleSurface            kept;
  std::vector<std::uint32_t> index(surface.points.size(), unused);
  for (std::size_t t = 0; t < marks.size(); ++t)
  {
    if (marks[t] == 0)
    {
      continue;
    }
    TriangleSurface::TriangleType triangle{};
    for (unsigned int k = 0; k < 3; ++k)
    {
      std::uint32_t & i = index[surface.triangles[t][k]];
      if (i == unused)
      {
        i = static_cast<std::uint32_t>(kept.points.size());
        kept.points.push_back(surface.points[surface.triangles[t][k]]);
      }
      triangle[k] = i;
    }
    kept.triangles.push_back(triangle);
  }
  return kept;
}
} // namespace itk
