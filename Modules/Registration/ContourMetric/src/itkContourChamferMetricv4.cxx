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
#include "itkContourChamferMetricv4.h"

#include <limits>

namespace itk
{
ContourChamferMetricv4::ContourChamferMetricv4()
  : m_Truncation(std::numeric_limits<double>::infinity())
{}

void
ContourChamferMetricv4::SetTruncation(double truncation)
{
  if (!(truncation > 0.0))
  {
    itkExceptionMacro("A truncation of " << truncation << " px makes every value 0; it must be positive.");
  }
  if (truncation != m_Truncation)
  {
    m_Truncation = truncation;
    this->Modified();
  }
}

void
ContourChamferMetricv4::InitializeContours(const ContourArrays & fixed, const ContourArrays & moving)
{
  m_Kernel.Initialize(fixed, moving, m_Distance);
}

auto
ContourChamferMetricv4::ComputeValue(const ContourSimilarity &            similarity,
                                     ContourChamferKernel::GradientType * gradient) const -> MeasureType
{
  return m_Kernel.Evaluate(similarity, m_Direction, gradient, m_Truncation);
}

auto
ContourChamferMetricv4::ComputeApproximateValue(const ContourSimilarity & similarity,
                                                SizeValueType             numberOfPoints) const -> MeasureType
{
  return m_Kernel.EvaluateApproximately(similarity, m_Direction, m_Truncation, numberOfPoints);
}

void
ContourChamferMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Direction: " << m_Direction << std::endl;
  os << indent << "Distance: " << m_Distance << std::endl;
  os << indent << "Truncation: " << m_Truncation << std::endl;
}
} // namespace itk
