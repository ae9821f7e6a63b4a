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
#include "itkCandidateRefinement.h"

#include "itkPosePlace.h"
#include "itkPoseStateBlocks.h"

#include "itkCommand.h"
#include "itkCorrelatedNoiseModel.h"
#include "itkLBFGS2Optimizerv4.h"
#include "itkLBFGSBOptimizerv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"

#include <cmath>
#include <typeinfo>
#include <utility>

namespace itk
{
namespace
{
/** How far from the solution a refinement is taken to be at first (LeastSquaresMetricv4::SetReach()), standard
 * deviations, and what is left of it after each step that is tried: by the sixth it is within what kernels allow
 * anyway, and a drawing that contradicts all else, as one of another patient or scale does, is let go. */
constexpr double FirstReach = 10.0;
constexpr double ReachNarrowsBy = 0.85;

/** What optimizers keep of a run before, whose parameters may have been fewer: scales, of which millimetres need none,
 * and the bounds and the start of LBFGSB. Its bounds are a radian, a factor e and 64 mm away: its line search tries far
 * places, and an outline that is magnified without a limit has samples without a limit. */
void
PrepareToRun(ObjectToObjectOptimizerBaseTemplate<double> & optimizer, const LeastSquaresMetricv4 & metric)
{
  const auto count = metric.GetNumberOfParameters();
  // LBFGS2 has no scales, and warns on the standard output where it is given some.
  if (dynamic_cast<LBFGS2Optimizerv4 *>(&optimizer) == nullptr)
  {
    ObjectToObjectOptimizerBaseTemplate<double>::ScalesType scales(count);
    scales.Fill(1.0);
    optimizer.SetScales(scales);
  }
  if (auto * lbfgsb = dynamic_cast<LBFGSBOptimizerv4 *>(&optimizer))
  {
    const LeastSquaresMetricv4::ParametersType start = metric.GetParameters();
    LBFGSBOptimizerv4::BoundSelectionType      selection(count);
    selection.Fill(LBFGSBOptimizerv4::BOTHBOUNDED);
    LBFGSBOptimizerv4::BoundValueType lower(count);
    LBFGSBOptimizerv4::BoundValueType upper(count);
    for (unsigned int i = 0; i < count; ++i)
    {
      lower[i] = start[i] - PoseStateBlocks::Arm;
      upper[i] = start[i] + PoseStateBlocks::Arm;
    }
    lbfgsb->SetBoundSelection(selection);
    lbfgsb->SetLowerBound(lower);
    lbfgsb->SetUpperBound(upper);
    lbfgsb->SetInitialPosition(start);
  }
}

/** Takes a metric's callback away again: the optimizer that is the user's keeps the metric. */
struct EvaluationGuard
{
  ITK_DISALLOW_COPY_AND_MOVE(EvaluationGuard);
  EvaluationGuard(LeastSquaresMetricv4 & guarded, LeastSquaresMetricv4::EvaluationCallbackType callback)
    : metric(guarded)
  {
    metric.SetEvaluationCallback(std::move(callback));
  }
  ~EvaluationGuard() { metric.SetEvaluationCallback(nullptr); }

  LeastSquaresMetricv4 & metric;
};

/** Takes an observer away again. */
struct ObserverGuard
{
  ITK_DISALLOW_COPY_AND_MOVE(ObserverGuard);
  ObserverGuard(Object * observed, unsigned long tagOfObserver)
    : object(observed)
    , tag(tagOfObserver)
  {}
  ~ObserverGuard() { object->RemoveObserver(tag); }

  Object *      object;
  unsigned long tag;
};

ResidualNoiseModel::ConstPointer
MakeWhiteNoise()
{
  auto model = CorrelatedNoiseModel::New();
  model->SetCorrelationLength(0.0);
  return model.GetPointer();
}
} // namespace

CandidateRefinement::CandidateRefinement(const PoseRegistrationOptions &          options,
                                         const PosePriors &                       priors,
                                         const ResidualNoiseModel::ConstPointer & correlatedNoise,
                                         OptimizerType *                          optimizer,
                                         PoseIterationMonitor &                   monitor,
                                         unsigned int                             group,
                                         bool                                     hypothesis)
  : m_Options(options)
  , m_Priors(priors)
  , m_CorrelatedNoise(correlatedNoise)
  , m_WhiteNoise(MakeWhiteNoise())
  , m_Optimizer(optimizer)
  , m_Monitor(monitor)
  , m_Group(group)
  , m_Hypothesis(hypothesis)
{}

void
CandidateRefinement::Score(const MetricType & metric, RefinedCandidate & candidate) const
{
  RegistrationFit fit;
  metric.AddFit(candidate.x, fit);
  candidate.cost = fit.GetMeanCost();
  candidate.codeTerm = fit.GetMeanCodeOffset();
  candidate.score = candidate.cost + m_Options.codeWeight * candidate.codeTerm;
}

void
CandidateRefinement::Run(MetricType &               metric,
                         const RefinementSchedule & schedule,
                         unsigned int               index,
                         RefinedCandidate &         candidate) const
{
  const auto * prototype = dynamic_cast<const LevenbergMarquardtOptimizerv4 *>(m_Optimizer.GetPointer());
  metric.SetValues(candidate.x);
  // One that is not ours has the same parameters in every run: what a user sets of it is of so many.
  PosePriors::SetFree(metric, m_Priors.GetFitSigmas(schedule.similarityOnly && prototype != nullptr));
  metric.SetNoiseModel(schedule.correlated ? m_CorrelatedNoise : m_WhiteNoise);
  metric.SetNoiseLevels(candidate.noise);
  candidate.evaluations = 1;
  candidate.converged = false;
  if (metric.GetState().GetNumberOfFreeParameters() == 0)
  {
    this->Score(metric, candidate);
    return;
  }
  metric.Initialize();

  // A clone has no observers: this one's steps go to the monitor, which knows what thread observers are called in.
  LevenbergMarquardtOptimizerv4::Pointer own;
  if (prototype != nullptr)
  {
    own = prototype->Clone();
  }
  OptimizerType * optimizer =
    own.IsNotNull() ? static_cast<OptimizerType *>(own.GetPointer()) : m_Optimizer.GetPointer();
  optimizer->SetMetric(&metric);
  PoseRegistrationIteration report;
  report.group = m_Group;
  report.stage = schedule.stage;
  report.candidate = index;
  report.hypothesis = m_Hypothesis;
  // The optimizer runs once a step, kernel and noise following between: steps are counted over all of its runs.
  unsigned int stepsAccepted = 0;
  unsigned int stepsTried = 0;
  // Of the run of another's optimizer: the best that it has evaluated, and how often it has evaluated.
  MetricType::ParametersType best;
  double                     bestValue = NumericTraits<double>::max();
  unsigned int               evaluations = 0;
  const auto                 post = [&](const EventObject & event) {
    report.step = own.IsNotNull() ? own->GetLastIteration() : LeastSquaresIteration();
    if (own.IsNotNull())
    {
      ++stepsTried;
      stepsAccepted += report.step.accepted ? 1 : 0;
      report.step.iteration = stepsAccepted;
      report.step.evaluations = stepsTried;
    }
    if (own.IsNull())
    {
      // Optimizers send subclasses of IterationEvent for mere evaluations: these are no steps that were taken.
      report.step.accepted = typeid(event) == typeid(IterationEvent);
      const double value = report.step.accepted ? optimizer->GetCurrentMetricValue() : metric.GetCurrentValue();
      if (report.step.accepted || value < bestValue)
      {
        bestValue = value;
        best = metric.GetParameters();
      }
      report.step.position = best;
      report.step.value = bestValue;
      report.step.trialValue = value;
      report.step.iteration = optimizer->GetCurrentIteration();
      report.step.evaluations = evaluations;
    }
    report.pose = PosePlace::ToPose(metric, metric.GetState().Expand(report.step.position));
    metric.GetNoiseLevels(report.noise);
    m_Monitor.Post(report);
    if (own.IsNotNull() && m_Monitor.IsAborted())
    {
      own->StopOptimization();
    }
  };
  auto command = FunctionCommand::New();
  command->SetCallback(post);
  // Also where an observer throws: an optimizer that is the user's lives on.
  const ObserverGuard observer{ optimizer, optimizer->AddObserver(IterationEvent(), command) };

  const bool   estimate = schedule.estimateNoise && m_Options.estimateNoise;
  const auto   widths = static_cast<unsigned int>(schedule.isNear ? 0 : schedule.widths.size());
  double       damping = 0.0;
  double       reach = FirstReach;
  unsigned int accepted = 0;
  while (!m_Monitor.IsAborted())
  {
    const bool annealed = accepted >= widths;
    double     width = annealed ? schedule.widths.back() : schedule.widths[accepted];
    if (annealed && estimate)
    {
      ContourNoiseLevels levels = candidate.noise;
      metric.GetNoiseLevels(levels);
      width = this->GetOwnWidth(levels);
    }
    metric.SetKernelWidth(width);
    metric.SetReach(reach);
    reach *= ReachNarrowsBy;
    metric.UpdateNoiseCorrelation(metric.GetState().GetValues());
    report.kernelWidth = width;
    // Every second step once the kernel is narrow: the levels settle much faster than the pose.
    if (estimate && annealed && (accepted - widths) % 2 == 0)
    {
      metric.EstimateNoise();
    }
    bool moved = false;
    if (own.IsNull())
    {
      // An optimizer that knows neither our damping nor our step length: it ends by its own rules, once a width.
      PrepareToRun(*optimizer, metric);
      best = metric.GetParameters();
      bestValue = NumericTraits<double>::max();
      const EvaluationGuard guard{ metric, [&]() {
                                    ++evaluations;
                                    if (m_Monitor.IsAborted())
                                    {
                                      throw ProcessAborted(__FILE__, __LINE__);
                                    }
                                  } };
      try
      {
        optimizer->StartOptimization();
      }
      catch (const ExceptionObject &)
      {
        // Some optimizers rethrow what they catch as its base class: whether it was the abort, the monitor knows.
        if (m_Monitor.IsAborted())
        {
          break;
        }
        throw;
      }
      candidate.evaluations = evaluations;
      // The metric stands where it was evaluated last.
      OptimizerType::ParametersType end = optimizer->GetCurrentPosition();
      metric.SetParameters(end);
      ++accepted;
      candidate.converged = accepted > widths;
      if (candidate.converged)
      {
        break;
      }
      continue;
    }
    own->SetInitialDamping(damping);
    own->SetNumberOfIterations(1);
    own->SetValueTolerance(0.0);
    own->SetStepTolerance(schedule.tolerance);
    own->SetMaximumNumberOfEvaluations(schedule.maximumEvaluations - candidate.evaluations);
    own->StartOptimization();
    damping = own->GetDamping();
    candidate.evaluations += static_cast<unsigned int>(own->GetNumberOfEvaluations());
    moved = own->GetCurrentIteration() > 0;
    if (moved || own->HasConverged())
    {
      candidate.converged = own->HasConverged();
    }
    accepted += moved ? 1 : 0;
    if (!moved && !(candidate.converged && !annealed))
    {
      break;
    }
    if (!moved)
    {
      // Nothing to gain at this width: go on to the narrower one.
      ++accepted;
      candidate.converged = false;
    }
    if ((candidate.converged && accepted > widths) || candidate.evaluations >= schedule.maximumEvaluations)
    {
      break;
    }
  }
  metric.SetReach(0.0);
  candidate.stopCondition = optimizer->GetStopConditionDescription();
  candidate.x = metric.GetState().GetValues();
  metric.GetNoiseLevels(candidate.noise);
  this->Score(metric, candidate);
}

void
CandidateRefinement::Settle(MetricType & metric, const RefinedCandidate & candidate) const
{
  metric.SetValues(candidate.x);
  PosePriors::SetFree(metric, m_Priors.GetFitSigmas(false));
  metric.SetNoiseModel(m_CorrelatedNoise);
  metric.SetNoiseLevels(candidate.noise);
}

double
CandidateRefinement::GetOwnWidth(const ContourNoiseLevels & noise) const
{
  return m_Options.adaptiveKernelFactor * std::hypot(noise.smooth, noise.white);
}
} // namespace itk
