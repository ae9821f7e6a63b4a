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
#include "itkGemanMcClureKernel.h"

#include <cmath>

namespace itk
{
double
GemanMcClureKernel::GetWeight(double squaredDistance, double width) const
{
  return Weight(squaredDistance, width);
}

double
GemanMcClureKernel::GetWeightDerivative(double squaredDistance, double width) const
{
  const double c2 = width * width;
  const double a = c2 / (c2 + squaredDistance);
  return -2.0 * a * a * a / c2;
}

double
GemanMcClureKernel::GetCharge(double weight) const
{
  const double z = std::sqrt(weight) - 1.0;
  return z * z;
}

double
GemanMcClureKernel::GetChargeDerivative(double weight) const
{
  const double root = std::sqrt(weight);
  return root > 0.0 ? (root - 1.0) / root : 0.0;
}
} // namespace itk
