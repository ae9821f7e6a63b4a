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
#ifndef itkLeastSquaresMetricCostFunction_h
#define itkLeastSquaresMetricCostFunction_h

#include "itkLeastSquaresMetric.h"

#include "itkMultipleValuedCostFunction.h"
#include "itkObjectToObjectMetricBase.h"

namespace itk
{
/** \class LeastSquaresMetricCostFunction
 * \brief A v4 metric that is a LeastSquaresMetric, as cost function of ITK's multiple-valued optimizers.
 *
 * SetMetric() takes an initialised metric; then itk::LevenbergMarquardtOptimizer::SetCostFunction(). Every evaluation
 * moves the metric there.
 *
 * Errors (ExceptionObject): a metric without residuals, or none.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT LeastSquaresMetricCostFunction : public MultipleValuedCostFunction
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LeastSquaresMetricCostFunction);

  using Self = LeastSquaresMetricCostFunction;
  using Superclass = MultipleValuedCostFunction;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LeastSquaresMetricCostFunction, MultipleValuedCostFunction);

  using MetricType = ObjectToObjectMetricBaseTemplate<double>;
  /** A metric that is a LeastSquaresMetric, initialised; any other is refused with an exception. Must be set. */
  virtual void
  SetMetric(MetricType * metric);
  itkGetModifiableObjectMacro(Metric, MetricType);
  /** The residuals. */
  MeasureType
  GetValue(const ParametersType & parameters) const override;

  /** A row a parameter, a column a residual, as ITK's optimizers take it. */
  void
  GetDerivative(const ParametersType & parameters, DerivativeType & derivative) const override;
  /** Number of residuals, and of the parameters that are free. */
  unsigned int
  GetNumberOfValues() const override;
  unsigned int
  GetNumberOfParameters() const override;

protected:
  LeastSquaresMetricCostFunction() = default;
  ~LeastSquaresMetricCostFunction() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  const LeastSquaresMetric &
  MoveTo(const ParametersType & parameters) const;
  const LeastSquaresMetric &
  GetResidualsOfMetric() const;

  MetricType::Pointer m_Metric;
};
} // namespace itk

#endif
