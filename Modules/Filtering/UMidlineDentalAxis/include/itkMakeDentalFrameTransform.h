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
#ifndef itkMakeDentalFrameTransform_h
#define itkMakeDentalFrameTransform_h

#include "itkVersorRigid3DTransform.h"

#include <array>

namespace itk
{
/** Mesh frame to dental frame, q = axes (p - origin) with the axes as rows: the one place where an estimated frame
 * becomes a transform. Throws where the axes are further from orthogonal than the tolerance. */
inline VersorRigid3DTransform<double>::Pointer
MakeDentalFrameTransform(const std::array<std::array<double, 3>, 3> & axes,
                         const std::array<double, 3> &                origin,
                         double                                       tolerance = 1e-10)
{
  VersorRigid3DTransform<double>::MatrixType       matrix;
  VersorRigid3DTransform<double>::OutputVectorType translation;
  for (unsigned int row = 0; row < 3; ++row)
  {
    translation[row] = 0.0;
    for (unsigned int column = 0; column < 3; ++column)
    {
      matrix(row, column) = axes[row][column];
      translation[row] -= axes[row][column] * origin[column];
    }
  }
  auto transform = VersorRigid3DTransform<double>::New();
  transform->SetMatrix(matrix, tolerance);
  transform->SetTranslation(translation);
  return transform;
}
} // namespace itk

#endif
