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
#include "itkLevenbergMarquardtOptimizerv4.h"

#include "itkDampedNormalEquations.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace itk
{
std::ostream &
operator<<(std::ostream & os, LevenbergMarquardtOptimizerv4Enums::StopCondition value)
{
  using StopCondition = LevenbergMarquardtOptimizerv4Enums::StopCondition;
  switch (value)
  {
    case StopCondition::NotStarted:
      return os << "itk::LevenbergMarquardtOptimizerv4Enums::StopCondition::NotStarted";
    case StopCondition::Running:
      return os << "itk::LevenbergMarquardtOptimizerv4Enums::StopCondition::Running";
    case StopCondition::StepTolerance:
      return os << "itk::LevenbergMarquardtOptimizerv4Enums::StopCondition::StepTolerance";
    case StopCondition::ValueTolerance:
      return os << "itk::LevenbergMarquardtOptimizerv4Enums::StopCondition::ValueTolerance";
    case StopCondition::MaximumNumberOfIterations:
      return os << "itk::LevenbergMarquardtOptimizerv4Enums::StopCondition::MaximumNumberOfIterations";
    case StopCondition::MaximumNumberOfEvaluations:
      return os << "itk::LevenbergMarquardtOptimizerv4Enums::StopCondition::MaximumNumberOfEvaluations";
    case StopCondition::StoppedByObserver:
      return os << "itk::LevenbergMarquardtOptimizerv4Enums::StopCondition::StoppedByObserver";
    case StopCondition::NotFinite:
      return os << "itk::LevenbergMarquardtOptimizerv4Enums::StopCondition::NotFinite";
    case StopCondition::Exception:
      return os << "itk::LevenbergMarquardtOptimizerv4Enums::StopCondition::Exception";
  }
  return os << "INVALID VALUE FOR itk::LevenbergMarquardtOptimizerv4Enums::StopCondition";
}

/** The equations and what the metric writes, kept from run to run. */
class LevenbergMarquardtOptimizerv4::EquationsType
{
public:
  DampedNormalEquations normal;
  vnl_vector<double>    residuals;
  vnl_matrix<double>    jacobian;
  std::vector<double>   step;
};

LevenbergMarquardtOptimizerv4::LevenbergMarquardtOptimizerv4()
  : m_Equations(new EquationsType)
{
  this->m_NumberOfIterations = 100;
}

LevenbergMarquardtOptimizerv4::~LevenbergMarquardtOptimizerv4() = default;

auto
LevenbergMarquardtOptimizerv4::GetCurrentPosition() const -> const ParametersType &
{
  return m_OwnsPosition ? m_BestPosition : Superclass::GetCurrentPosition();
}

auto
LevenbergMarquardtOptimizerv4::GetLastIteration() const -> IterationType
{
  IterationType iteration;
  iteration.position = m_BestPosition;
  iteration.value = this->m_CurrentMetricValue;
  iteration.trialValue = m_TrialValue;
  iteration.stepLength = m_StepLength;
  iteration.damping = m_Damping;
  iteration.accepted = m_StepAccepted;
  iteration.iteration = this->m_CurrentIteration;
  iteration.evaluations = m_NumberOfEvaluations;
  return iteration;
}

const LeastSquaresMetric &
LevenbergMarquardtOptimizerv4::CheckMetric() const
{
  if (this->m_Metric.IsNull())
  {
    itkExceptionMacro("No metric: call SetMetric() first.");
  }
  const auto * residuals = dynamic_cast<const LeastSquaresMetric *>(this->m_Metric.GetPointer());
  if (residuals == nullptr)
  {
    itkExceptionMacro("The metric " << this->m_Metric->GetNameOfClass()
                                    << " has no residuals; give one that does, as SilhouettePoseMetricv4, or take "
                                       "another optimizer, as LBFGSBOptimizerv4.");
  }
  if (this->m_Metric->GetNumberOfParameters() == 0)
  {
    // One that was not prepared may lack more than that, as a sum its terms: its own Initialize() knows what to call.
    this->m_Metric->Initialize();
  }
  if (this->m_Metric->GetNumberOfParameters() == 0)
  {
    itkExceptionMacro("No parameter of the metric "
                      << this->m_Metric->GetNameOfClass()
                      << " is free, all are held; free one with SetBlockFree() of the metric.");
  }
  return *residuals;
}

void
LevenbergMarquardtOptimizerv4::CheckSettings() const
{
  const auto check = [this](double value, const char * name) {
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      itkExceptionMacro(<< name << " is " << value << "; it must be 0 or more.");
    }
  };
  check(m_StepTolerance, "StepTolerance");
  check(m_ValueTolerance, "ValueTolerance");
  check(m_InitialDamping, "InitialDamping");
}

void
LevenbergMarquardtOptimizerv4::StartOptimization(bool doOnlyInitialization)
{
  // The base class would only prepare scales and weights, which are not used, and would refuse a metric whose number of
  // free parameters has changed since the last run.
  const LeastSquaresMetric & residuals = this->CheckMetric();
  this->CheckSettings();
  if (doOnlyInitialization)
  {
    return;
  }
  const ParametersType & start = this->m_Metric->GetParameters();
  m_BestPosition.SetSize(start.GetSize());
  m_TrialPosition.SetSize(start.GetSize());
  std::copy(start.begin(), start.end(), m_BestPosition.begin());
  this->m_CurrentIteration = 0;
  m_NumberOfEvaluations = 0;
  m_StepAccepted = false;
  m_StepLength = 0.0;
  m_Damping = m_InitialDamping;
  m_StopRequested = false;
  m_MetricIsAtBestPosition = true;
  m_OwnsPosition = true;
  m_StopCondition = StopConditionEnum::Running;
  try
  {
    this->m_CurrentMetricValue = this->m_Metric->GetValue();
    m_TrialValue = this->m_CurrentMetricValue;
    this->InvokeEvent(StartEvent());
    m_StopCondition = this->Iterate(residuals);
    this->MoveMetricToBestPosition();
    this->InvokeEvent(EndEvent());
  }
  catch (...)
  {
    m_StopCondition = StopConditionEnum::Exception;
    m_OwnsPosition = false;
    try
    {
      this->MoveMetricToBestPosition();
    }
    catch (...) // The first exception says more.
    {}
    throw;
  }
  m_OwnsPosition = false;
}

auto
LevenbergMarquardtOptimizerv4::Iterate(const LeastSquaresMetric & residuals) -> StopConditionEnum
{
  m_StopLimit = 0.0;
  bool linearize = true;
  while (true)
  {
    if (m_StopRequested)
    {
      return StopConditionEnum::StoppedByObserver;
    }
    if (this->m_CurrentIteration >= this->m_NumberOfIterations)
    {
      m_StopLimit = static_cast<double>(this->m_NumberOfIterations);
      return StopConditionEnum::MaximumNumberOfIterations;
    }
    if (m_NumberOfEvaluations >= m_MaximumNumberOfEvaluations)
    {
      m_StopLimit = static_cast<double>(m_MaximumNumberOfEvaluations);
      return StopConditionEnum::MaximumNumberOfEvaluations;
    }
    if (!std::isfinite(this->m_CurrentMetricValue))
    {
      return StopConditionEnum::NotFinite;
    }
    if ((linearize && !this->Linearize(residuals)) || !this->ComputeTrialPosition())
    {
      return StopConditionEnum::NotFinite;
    }
    this->MoveMetricToTrialPosition();
    ++m_NumberOfEvaluations;
    m_TrialValue = this->m_Metric->GetValue();
    m_StepLength = residuals.GetStepLength(m_BestPosition, m_TrialPosition);
    const double before = this->m_CurrentMetricValue;
    m_StepAccepted = std::isfinite(m_TrialValue) && m_TrialValue < before;
    if (m_StepAccepted)
    {
      std::copy(m_TrialPosition.begin(), m_TrialPosition.end(), m_BestPosition.begin());
      m_MetricIsAtBestPosition = true;
      this->m_CurrentMetricValue = m_TrialValue;
      m_Damping = m_Damping > 1e-4 ? 0.1 * m_Damping : 0.0;
      ++this->m_CurrentIteration;
    }
    linearize = m_StepAccepted;
    this->InvokeEvent(IterationEvent());
    if (m_StopRequested)
    {
      return StopConditionEnum::StoppedByObserver;
    }
    if (m_StepLength < m_StepTolerance)
    {
      m_StopLimit = m_StepTolerance;
      return StopConditionEnum::StepTolerance;
    }
    if (!m_StepAccepted)
    {
      m_Damping = std::max(10.0 * m_Damping, 1e-2);
    }
    else if (m_ValueTolerance > 0.0 && before - m_TrialValue < m_ValueTolerance * std::abs(before))
    {
      m_StopLimit = m_ValueTolerance;
      return StopConditionEnum::ValueTolerance;
    }
  }
}

bool
LevenbergMarquardtOptimizerv4::Linearize(const LeastSquaresMetric & residuals)
{
  residuals.GetResiduals(m_Equations->residuals, &m_Equations->jacobian);
  const std::size_t count = m_BestPosition.GetSize();
  if (m_Equations->jacobian.rows() != m_Equations->residuals.size() || m_Equations->jacobian.cols() != count)
  {
    itkExceptionMacro("GetResiduals() of " << this->m_Metric->GetNameOfClass() << " gave "
                                           << m_Equations->residuals.size() << " residuals and a Jacobian of "
                                           << m_Equations->jacobian.rows() << " x " << m_Equations->jacobian.cols()
                                           << "; it must have a row a residual and " << count
                                           << " columns, one a parameter.");
  }
  m_MaximumSteps = residuals.GetMaximumSteps();
  if (m_MaximumSteps.GetSize() != 0 && m_MaximumSteps.GetSize() != count)
  {
    itkExceptionMacro("GetMaximumSteps() of " << this->m_Metric->GetNameOfClass() << " gave "
                                              << m_MaximumSteps.GetSize() << " limits; it must be none, or " << count
                                              << ", one a parameter.");
  }
  return m_Equations->normal.Set(
    m_Equations->residuals.data_block(), m_Equations->jacobian.data_block(), m_Equations->residuals.size(), count);
}

bool
LevenbergMarquardtOptimizerv4::ComputeTrialPosition()
{
  const unsigned int count = m_BestPosition.GetSize();
  m_Equations->step.resize(count);
  const double * const step = m_Equations->step.data();
  if (!m_Equations->normal.Solve(m_Damping, m_Equations->step.data()))
  {
    return false;
  }
  // A common factor, so that the direction stays.
  double factor = 1.0;
  for (unsigned int k = 0; k < m_MaximumSteps.GetSize(); ++k)
  {
    if (m_MaximumSteps[k] > 0.0)
    {
      factor = std::min(factor, m_MaximumSteps[k] / std::max(std::abs(step[k]), 1e-300));
    }
  }
  for (unsigned int k = 0; k < count; ++k)
  {
    m_TrialPosition[k] = m_BestPosition[k] + factor * step[k];
  }
  return true;
}

void
LevenbergMarquardtOptimizerv4::MoveMetricToTrialPosition()
{
  // Before the call, which may throw half-way.
  m_MetricIsAtBestPosition = false;
  this->m_Metric->SetParameters(m_TrialPosition);
}

void
LevenbergMarquardtOptimizerv4::MoveMetricToBestPosition()
{
  // A metric that is there already may have kept what it computed there.
  if (!m_MetricIsAtBestPosition)
  {
    this->m_Metric->SetParameters(m_BestPosition);
    m_MetricIsAtBestPosition = true;
  }
}

void
LevenbergMarquardtOptimizerv4::StopOptimization()
{
  m_StopRequested = true;
}

bool
LevenbergMarquardtOptimizerv4::ReportIteration(const IterationType & iteration)
{
  if (m_OwnsPosition)
  {
    itkExceptionMacro("ReportIteration() is for steps of clones; this object runs itself, or reports already.");
  }
  m_BestPosition = iteration.position;
  this->m_CurrentMetricValue = iteration.value;
  m_TrialValue = iteration.trialValue;
  m_StepLength = iteration.stepLength;
  m_Damping = iteration.damping;
  m_StepAccepted = iteration.accepted;
  this->m_CurrentIteration = iteration.iteration;
  m_NumberOfEvaluations = iteration.evaluations;
  m_OwnsPosition = true;
  try
  {
    this->InvokeEvent(IterationEvent());
  }
  catch (...)
  {
    m_OwnsPosition = false;
    throw;
  }
  m_OwnsPosition = false;
  const bool goOn = !m_StopRequested;
  m_StopRequested = false;
  return goOn;
}

bool
LevenbergMarquardtOptimizerv4::HasConverged() const
{
  return m_StopCondition == StopConditionEnum::StepTolerance || m_StopCondition == StopConditionEnum::ValueTolerance;
}

auto
LevenbergMarquardtOptimizerv4::GetStopConditionDescription() const -> const StopConditionReturnStringType
{
  std::ostringstream text;
  text << this->GetNameOfClass() << ": ";
  switch (m_StopCondition)
  {
    case StopConditionEnum::NotStarted:
      text << "It has not run yet.";
      break;
    case StopConditionEnum::Running:
      text << "It is running.";
      break;
    case StopConditionEnum::StepTolerance:
      text << "Converged, the last step is shorter than the tolerance (" << m_StopLimit << ").";
      break;
    case StopConditionEnum::ValueTolerance:
      text << "Converged, the last step lowered the value by less than the tolerance (" << m_StopLimit << ") of it.";
      break;
    case StopConditionEnum::MaximumNumberOfIterations:
      text << "Maximum number of iterations (" << static_cast<SizeValueType>(m_StopLimit) << ") reached.";
      break;
    case StopConditionEnum::MaximumNumberOfEvaluations:
      text << "Maximum number of evaluations (" << static_cast<SizeValueType>(m_StopLimit) << ") reached.";
      break;
    case StopConditionEnum::StoppedByObserver:
      text << "An observer stopped it.";
      break;
    case StopConditionEnum::NotFinite:
      text << "Value, residuals or Jacobian at the best position are not finite; start the metric elsewhere.";
      break;
    case StopConditionEnum::Exception:
      text << "An exception ended it.";
      break;
  }
  return text.str();
}

LightObject::Pointer
LevenbergMarquardtOptimizerv4::InternalClone() const
{
  LightObject::Pointer copy = Superclass::InternalClone();
  auto * const         optimizer = dynamic_cast<Self *>(copy.GetPointer());
  if (optimizer == nullptr)
  {
    itkExceptionMacro("Could not make another " << this->GetNameOfClass() << ".");
  }
  optimizer->m_NumberOfIterations = this->m_NumberOfIterations;
  optimizer->m_NumberOfWorkUnits = this->m_NumberOfWorkUnits;
  optimizer->m_MaximumNumberOfEvaluations = m_MaximumNumberOfEvaluations;
  optimizer->m_StepTolerance = m_StepTolerance;
  optimizer->m_ValueTolerance = m_ValueTolerance;
  optimizer->m_InitialDamping = m_InitialDamping;
  return copy;
}

void
LevenbergMarquardtOptimizerv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MaximumNumberOfEvaluations: " << m_MaximumNumberOfEvaluations << std::endl;
  os << indent << "StepTolerance: " << m_StepTolerance << std::endl;
  os << indent << "ValueTolerance: " << m_ValueTolerance << std::endl;
  os << indent << "InitialDamping: " << m_InitialDamping << std::endl;
  os << indent << "Damping: " << m_Damping << std::endl;
  os << indent << "NumberOfEvaluations: " << m_NumberOfEvaluations << std::endl;
  os << indent << "StepAccepted: " << (m_StepAccepted ? "On" : "Off") << std::endl;
  os << indent << "StepLength: " << m_StepLength << std::endl;
  os << indent << "TrialValue: " << m_TrialValue << std::endl;
  os << indent << "StopCondition: " << m_StopCondition << std::endl;
  os << indent << "StopConditionDescription: " << this->GetStopConditionDescription() << std::endl;
  os << indent << "StopRequested: " << (m_StopRequested ? "On" : "Off") << std::endl;
  os << indent << "OwnsPosition: " << (m_OwnsPosition ? "On" : "Off") << std::endl;
  os << indent << "MetricIsAtBestPosition: " << (m_MetricIsAtBestPosition ? "On" : "Off") << std::endl;
  os << indent << "BestPosition: " << m_BestPosition << std::endl;
  os << indent << "TrialPosition: " << m_TrialPosition << std::endl;
  os << indent << "MaximumSteps: " << m_MaximumSteps << std::endl;
}
} // namespace itk
