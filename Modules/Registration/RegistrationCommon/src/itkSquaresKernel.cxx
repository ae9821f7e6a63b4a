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
#include "itkSquaresKernel.h"

namespace itk
{
double
SquaresKernel::GetWeight(double, double) const
{
  return 1.0;
}

double
SquaresKernel::GetWeightDerivative(double, double) const
{
  return 0.0;
}

double
SquaresKernel::GetCharge(double) const
{
  // A gate may let a residual go all the same; least squares do not charge for it.
  return 0.0;
}

double
SquaresKernel::GetChargeDerivative(double) const
{
  return 0.0;
}
} // namespace itk
