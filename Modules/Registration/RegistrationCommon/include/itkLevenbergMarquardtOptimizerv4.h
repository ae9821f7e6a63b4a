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
#ifndef itkLevenbergMarquardtOptimizerv4_h
#define itkLevenbergMarquardtOptimizerv4_h

#include "itkLeastSquaresMetric.h"

#include "itkObjectToObjectOptimizerBase.h"

#include <string>

namespace itk
{
/** \class LevenbergMarquardtOptimizerv4
 * \brief Levenberg-Marquardt (MINPACK's lmder, through VNL) for v4 metrics that are sums of squares.
 *
 * The metric must be a LeastSquaresMetric, as PartialContourMetricv4. Starts at the metric's position and leaves the
 * metric at the best one. Parameters are scaled by the columns of the Jacobian; scales, weights and scales estimators
 * are not used. Bounds are the metric's affair. Does not share state with other runs.
 *
 * Events: StartEvent, IterationEvent at the end of each iteration (a step that lowers the value), EndEvent. An
 * exception thrown in an observer or by the metric ends the run and is passed on.
 *
 * Errors (ExceptionObject): no metric, one without residuals, fewer residuals than parameters.
 *
 * Source: More, The Levenberg-Marquardt algorithm: implementation and theory, 1978.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT LevenbergMarquardtOptimizerv4 : public ObjectToObjectOptimizerBaseTemplate<double>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LevenbergMarquardtOptimizerv4);

  using Self = LevenbergMarquardtOptimizerv4;
  using Superclass = ObjectToObjectOptimizerBaseTemplate<double>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LevenbergMarquardtOptimizerv4, ObjectToObjectOptimizerBaseTemplate);

  /** Ends where the sum of squares falls by less than this part of itself, 1e-8 by default. */
  itkSetMacro(ValueTolerance, double);
  itkGetConstMacro(ValueTolerance, double);

  /** Ends where a step is smaller than this part of the position, 1e-8 by default. */
  itkSetMacro(StepTolerance, double);
  itkGetConstMacro(StepTolerance, double);

  /** Ends where the cosine of the angle between the residuals and every column of the Jacobian is smaller, 1e-8 by
   * default. */
  itkSetMacro(GradientTolerance, double);
  itkGetConstMacro(GradientTolerance, double);

  /** Evaluations of the residuals, and of the Jacobian, in the last run. */
  itkGetConstMacro(NumberOfEvaluations, SizeValueType);
  itkGetConstMacro(NumberOfJacobians, SizeValueType);

  void
  StartOptimization(bool doOnlyInitialization = false) override;

  const StopConditionReturnStringType
  GetStopConditionDescription() const override
  {
    return m_StopConditionDescription;
  }

protected:
  LevenbergMarquardtOptimizerv4();
  ~LevenbergMarquardtOptimizerv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  class FunctionType;

  double        m_ValueTolerance{ 1e-8 };
  double        m_StepTolerance{ 1e-8 };
  double        m_GradientTolerance{ 1e-8 };
  SizeValueType m_NumberOfEvaluations{ 0 };
  SizeValueType m_NumberOfJacobians{ 0 };
  std::string   m_StopConditionDescription;
};
} // namespace itk

#endif
