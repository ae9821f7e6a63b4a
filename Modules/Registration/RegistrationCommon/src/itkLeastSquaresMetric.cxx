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
#include "itkLeastSquaresMetric.h"

#include <cmath>

namespace itk
{
double
LeastSquaresMetric::GetStepLength(const ParametersType & from, const ParametersType & to) const
{
  double sum = 0.0;
  for (unsigned int i = 0; i < from.Size(); ++i)
  {
    sum += (to[i] - from[i]) * (to[i] - from[i]);
  }
  return std::sqrt(sum);
}

LeastSquaresMetric::ParametersType
LeastSquaresMetric::GetMaximumSteps() const
{
  return ParametersType(0);
}
} // namespace itk
