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
#include "itkLeastSquaresMetricCostFunction.h"

#include <algorithm>

namespace itk
{
void
LeastSquaresMetricCostFunction::SetMetric(MetricType * metric)
{
  if (metric != nullptr && dynamic_cast<LeastSquaresMetric *>(metric) == nullptr)
  {
    itkExceptionMacro("The metric " << metric->GetNameOfClass()
                                    << " has no residuals; give one that does, as SilhouettePoseMetricv4.");
  }
  if (m_Metric != metric)
  {
    m_Metric = metric;
    this->Modified();
  }
}

const LeastSquaresMetric &
LeastSquaresMetricCostFunction::GetResidualsOfMetric() const
{
  if (m_Metric.IsNull())
  {
    itkExceptionMacro("No metric: call SetMetric() first.");
  }
  return dynamic_cast<const LeastSquaresMetric &>(*m_Metric);
}

const LeastSquaresMetric &
LeastSquaresMetricCostFunction::MoveTo(const ParametersType & parameters) const
{
  const LeastSquaresMetric & residuals = this->GetResidualsOfMetric();
  MetricType::ParametersType position(parameters);
  m_Metric->SetParameters(position);
  return residuals;
}

auto
LeastSquaresMetricCostFunction::GetValue(const ParametersType & parameters) const -> MeasureType
{
  vnl_vector<double> residuals;
  this->MoveTo(parameters).GetResiduals(residuals, nullptr);
  MeasureType value(static_cast<unsigned int>(residuals.size()));
  std::copy(residuals.begin(), residuals.end(), value.begin());
  return value;
}

void
LeastSquaresMetricCostFunction::GetDerivative(const ParametersType & parameters, DerivativeType & derivative) const
{
  vnl_vector<double> residuals;
  vnl_matrix<double> jacobian;
  this->MoveTo(parameters).GetResiduals(residuals, &jacobian);
  derivative.SetSize(jacobian.cols(), jacobian.rows());
  for (unsigned int i = 0; i < jacobian.rows(); ++i)
  {
    for (unsigned int k = 0; k < jacobian.cols(); ++k)
    {
      derivative(k, i) = jacobian(i, k);
    }
  }
}

unsigned int
LeastSquaresMetricCostFunction::GetNumberOfValues() const
{
  return static_cast<unsigned int>(this->GetResidualsOfMetric().GetNumberOfResiduals());
}

unsigned int
LeastSquaresMetricCostFunction::GetNumberOfParameters() const
{
  this->GetResidualsOfMetric();
  return static_cast<unsigned int>(m_Metric->GetNumberOfParameters());
}

void
LeastSquaresMetricCostFunction::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(Metric);
}
} // namespace itk
