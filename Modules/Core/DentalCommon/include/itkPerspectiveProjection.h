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
#ifndef itkPerspectiveProjection_h
#define itkPerspectiveProjection_h

#include <array>

namespace itk
{
/** \struct PerspectiveProjection
 * \brief The projection as kernels speak it: nine multiplications and a division, free of ITK headers.
 *
 * Maps a point of the object's frame (mm) to a continuous pixel index: (u, v) = (row0.p, row1.p) / row2.p with p
 * homogeneous. row2 is scaled so that row2.p is positive between source and detector. Made by
 * CephalometricGeometry::GetProjection().
 *
 * \ingroup DentalCommon
 */
struct PerspectiveProjection
{
  /** 3x4, row-major. */
  std::array<double, 12> matrix{};
  /** The X-ray source in the object's frame, mm. */
  std::array<double, 3> source{};

  /** \return row2.p, the point's depth: positive in front of the source. */
  double
  Depth(const double point[3]) const
  {
    return matrix[8] * point[0] + matrix[9] * point[1] + matrix[10] * point[2] + matrix[11];
  }

  /** \return the point's depth; u and v are written. The caller checks that it is positive where it may not be. */
  double
  Project(const double point[3], double & u, double & v) const
  {
    const double depth = Depth(point);
    u = (matrix[0] * point[0] + matrix[1] * point[1] + matrix[2] * point[2] + matrix[3]) / depth;
    v = (matrix[4] * point[0] + matrix[5] * point[1] + matrix[6] * point[2] + matrix[7]) / depth;
    return depth;
  }
};
} // namespace itk

#endif
