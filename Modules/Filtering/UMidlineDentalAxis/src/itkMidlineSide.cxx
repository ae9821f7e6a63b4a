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
#include "itkMidlineSide.h"

namespace itk
{
std::vector<std::uint8_t>
SelectMidlineSide(const TriangleSurface &       surface,
                  const std::array<double, 3> & lateral,
                  const std::array<double, 3> & origin,
                  double                        side,
                  double                        margin)
{
  std::vector<std::uint8_t> keep(surface.triangles.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    double y = 0.0;
    for (const std::uint32_t id : surface.triangles[t])
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        y += lateral[d] * (surface.points[id][d] - origin[d]);
      }
    }
    keep[t] = side * y / 3.0 < margin ? 1 : 0;
  }
  return keep;
}
} // namespace itk
