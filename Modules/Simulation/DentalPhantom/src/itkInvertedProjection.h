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
#ifndef itkInvertedProjection_h
#define itkInvertedProjection_h

#include "itkPerspectiveProjection.h"

#include <array>

namespace itk
{
/** Pixel to ray: with M the left 3x3 of the matrix, M (p - source) ~ (u, v, 1). Row-major; what the phantom's pictures
 * and outlines cast their rays with. */
inline std::array<double, 9>
InvertedProjection(const PerspectiveProjection & projection)
{
  const auto & m = projection.matrix;
  const double a0 = m[5] * m[10] - m[6] * m[9];
  const double a1 = m[6] * m[8] - m[4] * m[10];
  const double a2 = m[4] * m[9] - m[5] * m[8];
  const double det = m[0] * a0 + m[1] * a1 + m[2] * a2;
  return { { a0 / det,
             (m[2] * m[9] - m[1] * m[10]) / det,
             (m[1] * m[6] - m[2] * m[5]) / det,
             a1 / det,
             (m[0] * m[10] - m[2] * m[8]) / det,
             (m[2] * m[4] - m[0] * m[6]) / det,
             a2 / det,
             (m[1] * m[8] - m[0] * m[9]) / det,
             (m[0] * m[5] - m[1] * m[4]) / det } };
}
} // namespace itk

#endif
