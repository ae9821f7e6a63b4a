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
#ifndef itkDentalPhantomSpline_h
#define itkDentalPhantomSpline_h

#include <algorithm>
#include <array>
#include <vector>

namespace itk
{
/** Points of the uniform Catmull-Rom spline through the knots (Catmull, Rom 1974), so many to a span. A closed line
 * does not repeat its first point; an open one ends in its last knot, beyond which the knots at its ends stand twice.
 */
inline std::vector<std::array<double, 2>>
DentalPhantomSpline(const std::vector<std::array<double, 2>> & knots, bool closed, int pointsPerSpan)
{
  using KnotType = std::array<double, 2>;
  std::vector<KnotType> line;
  const int             n = static_cast<int>(knots.size());
  const int             spans = closed ? n : n - 1;
  const auto            at = [&](int i) { return knots[closed ? (i + n) % n : std::min(std::max(i, 0), n - 1)]; };
  for (int i = 0; i < spans; ++i)
  {
    const KnotType p[4] = { at(i - 1), at(i), at(i + 1), at(i + 2) };
    for (int k = 0; k < pointsPerSpan; ++k)
    {
      const double t = static_cast<double>(k) / pointsPerSpan;
      KnotType     q{};
      for (unsigned int d = 0; d < 2; ++d)
      {
        q[d] = 0.5 * (2.0 * p[1][d] + t * (p[2][d] - p[0][d]) +
                      t * t * (2.0 * p[0][d] - 5.0 * p[1][d] + 4.0 * p[2][d] - p[3][d]) +
                      t * t * t * (-p[0][d] + 3.0 * p[1][d] - 3.0 * p[2][d] + p[3][d]));
      }
      line.push_back(q);
    }
  }
  if (!closed)
  {
    line.push_back(knots.back());
  }
  return line;
}
} // namespace itk

#endif
