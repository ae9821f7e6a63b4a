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
#include "itkProjectionRows.h"

namespace itk
{
std::array<double, 12>
ScaleColumns(const std::array<double, 12> & matrix, double factor)
{
  std::array<double, 12> scaled = matrix;
  for (unsigned int i = 0; i < 12; ++i)
  {
    scaled[i] *= i % 4 == 3 ? 1.0 : factor;
  }
  return scaled;
}

std::array<double, 12>
TimesRigidInverse(const std::array<double, 12> & matrix, const std::array<double, 12> & rigid)
{
  std::array<double, 12> product{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    product[4 * row + 3] = matrix[4 * row + 3];
    for (unsigned int column = 0; column < 3; ++column)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        product[4 * row + column] += matrix[4 * row + d] * rigid[4 * column + d];
      }
      product[4 * row + 3] -= product[4 * row + column] * rigid[4 * column + 3];
    }
  }
  return product;
}
} // namespace itk
