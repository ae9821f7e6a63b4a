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

#include "itkLeastSquaresIteration.h"
#include "itkLeastSquaresMetric.h"

#include "itkObjectToObjectOptimizerBase.h"

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>

namespace itk
{
/** \class LevenbergMarquardtOptimizerv4Enums
 * \brief Why a run of LevenbergMarquardtOptimizerv4 ended.
 * \ingroup RegistrationCommon
 */
class LevenbergMarquardtOptimizerv4Enums
{
public:
  /** StepTolerance and ValueTolerance are convergence, the others are not. NotFinite: value, residuals or Jacobian at
   * the best position are not all finite, so that there is no step to try. Exception: one of an observer or of the
   * metric went through. */
  enum class StopCondition : std::uint8_t
  {
    NotStarted,
    Running,
    StepTolerance,
    ValueTolerance,
    MaximumNumberOfIterations,
    MaximumNumberOfEvaluations,
    StoppedByObserver,
    NotFinite,
    Exception
  };
};

extern RegistrationCommon_EXPORT std::ostream &
                                 operator<<(std::ostream & os, LevenbergMarquardtOptimizerv4Enums::StopCondition value);

/** \class LevenbergMarquardtOptimizerv4
 * \brief Levenberg-Marquardt for v4 metrics that are, or are majorised by, sums of squares.
 *
 * The metric must be a LeastSquaresMetric, as SilhouettePoseMetricv4. A run starts at the metric's position and leaves
 * the metric at the best one found. With r and J from GetResiduals(), H = J'J and g = J'r, the step solves
 * (H + damping diag(H) + 1e-9 I) step = -g; the constant keeps a parameter that nothing observes where it is. The step
 * is shortened by a common factor to the metric's GetMaximumSteps(). It is accepted where it lowers the metric's
 * GetValue(), not the sum of squares: a robust metric is judged by its criterion, with its weights made anew at the
 * position that was tried. An accepted step lowers the damping tenfold, to 0 from 1e-4; a rejected one raises it
 * tenfold, to 1e-2 at least, and the next is tried from the same residuals.
 *
 * A run ends where a tried step, accepted or not, is shorter than StepTolerance by the metric's GetStepLength(), or
 * where an accepted one lowers the value by less than the part ValueTolerance of it. Those are convergence
 * (HasConverged()); GetStopCondition() has the other ends. Residuals fewer than parameters are no error: damping and
 * the constant make the equations solvable. Scales, weights and scales estimators of the base class are not used:
 * damping by diag(H) makes steps independent of the parameters' units. Bounds are the metric's affair.
 *
 * Events: StartEvent, when the value at the start is known; IterationEvent after every tried step, accepted or not;
 * EndEvent. In them GetCurrentPosition() and GetCurrentMetricValue() are the best so far and belong together, and
 * GetLastIteration() has all that is known; the metric itself stands where the step was tried. StopOptimization() in an
 * observer ends the run before the next evaluation. An exception thrown in an observer or by the metric passes through,
 * with the metric back at the best position; then there is no EndEvent.
 *
 * The same input gives the same bits. Runs share no state, so that each thread may run a Clone() with its own metric;
 * ReportIteration() passes what such a clone does on to the observers of its owner. A run with InitialDamping set to
 * GetDamping() of the one before goes on as if that had not ended; memory is kept from run to run.
 *
 * MINPACK, with a trust region instead of this rule, is available on the same interface:
 * itk::LevenbergMarquardtOptimizer with a LeastSquaresMetricCostFunction, for metrics whose value is the sum of
 * squares.
 *
 * Errors (ExceptionObject): no metric, one without residuals or without a free parameter, tolerances or damping that
 * are negative, residuals and Jacobian whose sizes disagree.
 *
 * Sources: Levenberg 1944; Marquardt, An algorithm for least-squares estimation of nonlinear parameters, 1963.
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

  /** Clone() makes a new optimizer with the same settings, without metric and observers. */
  itkNewMacro(Self);
  itkTypeMacro(LevenbergMarquardtOptimizerv4, ObjectToObjectOptimizerBaseTemplate);

  using StopConditionEnum = LevenbergMarquardtOptimizerv4Enums::StopCondition;
  using IterationType = LeastSquaresIteration;

  /** Most steps tried in a run, accepted or not; 1000 by default. The value at the start does not count. The base
   * class's NumberOfIterations, 100 by default, is the most steps accepted. */
  itkSetMacro(MaximumNumberOfEvaluations, SizeValueType);
  itkGetConstMacro(MaximumNumberOfEvaluations, SizeValueType);

  /** A run ends where a step is shorter than this, in the metric's own unit of step length; 1e-6 by default. */
  itkSetMacro(StepTolerance, double);
  itkGetConstMacro(StepTolerance, double);

  /** A run ends where an accepted step lowers the value by less than this part of it; 1e-8 by default, 0 is never. */
  itkSetMacro(ValueTolerance, double);
  itkGetConstMacro(ValueTolerance, double);

  /** Damping of the first step of a run, 0 (Gauss-Newton) by default. */
  itkSetMacro(InitialDamping, double);
  itkGetConstMacro(InitialDamping, double);

  /** Damping now or at the end of the last run, to go on with. */
  itkGetConstMacro(Damping, double);

  /** Steps tried in this or the last run; GetCurrentIteration() counts those accepted. */
  itkGetConstMacro(NumberOfEvaluations, SizeValueType);

  /** Whether the last step tried lowered the value. */
  itkGetConstMacro(StepAccepted, bool);

  /** Length of the last step tried, in the metric's own unit. */
  itkGetConstMacro(StepLength, double);

  /** Value where the last step was tried; GetCurrentMetricValue() is that at the best position. */
  itkGetConstMacro(TrialValue, MeasureType);

  /** The best position in events; the metric's position outside of them. */
  const ParametersType &
  GetCurrentPosition() const override;

  /** The last step tried, for ReportIteration() of another optimizer. */
  IterationType
  GetLastIteration() const;
  /** Runs from the metric's parameters to a stop; with true it only prepares the run. */
  void
  StartOptimization(bool doOnlyInitialization = false) override;

  /** Call it in an observer: the run ends before the next evaluation. */
  virtual void
  StopOptimization();

  /** For an owner that runs clones, perhaps in other threads: makes this object's state that of a step of a clone and
   * invokes IterationEvent, in the thread that calls. One call at a time, and not during a run of this object.
   * \return false where an observer called StopOptimization() since the last report: the owner should end its runs. */
  virtual bool
  ReportIteration(const IterationType & iteration);
  /** Why the last run ended. */
  itkGetEnumMacro(StopCondition, StopConditionEnum);

  /** Whether the last run ended by StepTolerance or ValueTolerance. */
  bool
  HasConverged() const;

  /** A sentence that says why the last run ended, after the name of the class. */
  const StopConditionReturnStringType
  GetStopConditionDescription() const override;

protected:
  LevenbergMarquardtOptimizerv4();
  ~LevenbergMarquardtOptimizerv4() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  LightObject::Pointer
  InternalClone() const override;

private:
  class EquationsType;

  const LeastSquaresMetric &
  CheckMetric() const;
  void
  CheckSettings() const;
  StopConditionEnum
  Iterate(const LeastSquaresMetric & residuals);
  // Both are false where there is no finite step.
  bool
  Linearize(const LeastSquaresMetric & residuals);
  bool
  ComputeTrialPosition();
  void
  MoveMetricToTrialPosition();
  void
  MoveMetricToBestPosition();

  SizeValueType     m_MaximumNumberOfEvaluations{ 1000 };
  double            m_StepTolerance{ 1e-6 };
  double            m_ValueTolerance{ 1e-8 };
  double            m_InitialDamping{ 0.0 };
  double            m_Damping{ 0.0 };
  SizeValueType     m_NumberOfEvaluations{ 0 };
  bool              m_StepAccepted{ false };
  double            m_StepLength{ 0.0 };
  MeasureType       m_TrialValue{ 0.0 };
  StopConditionEnum m_StopCondition{ StopConditionEnum::NotStarted };
  // The tolerance or number by which the last run ended, since the setting may change afterwards.
  double                         m_StopLimit{ 0.0 };
  bool                           m_StopRequested{ false };
  bool                           m_OwnsPosition{ false };
  bool                           m_MetricIsAtBestPosition{ true };
  ParametersType                 m_BestPosition;
  ParametersType                 m_TrialPosition;
  ParametersType                 m_MaximumSteps;
  std::unique_ptr<EquationsType> m_Equations;
};
} // namespace itk

#endif
