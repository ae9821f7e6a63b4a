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
#include "itkCorrelatedNoiseModel.h"

#include <cmath>

namespace itk
{
double
CorrelatedNoiseModel::GetCorrelation(double arcDistance) const
{
  if (m_CorrelationLength <= 0.0)
  {
    return arcDistance == 0.0 ? 1.0 : 0.0;
  }
  const double exponent = arcDistance * arcDistance * (0.5 / (m_CorrelationLength * m_CorrelationLength));
  return exponent < 20.0 ? std::exp(-exponent) : 0.0;
}

void
CorrelatedNoiseModel::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "CorrelationLength: " << m_CorrelationLength << std::endl;
}
} // namespace itk
