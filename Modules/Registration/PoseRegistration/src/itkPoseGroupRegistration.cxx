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
#include "itkPoseGroupRegistration.h"

#include "itkFindSilhouettes.h"
#include "itkLandmarkPoseStart.h"
#include "itkPoseCovariance.h"
#include "itkPosePlace.h"

#include "itkCorrelatedNoiseModel.h"
#include "itkGemanMcClureKernel.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkSquaresKernel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace itk
{
namespace
{
using PosePlace::ToPose;
using PosePlace::WithPose;

/** A drawing is precise where its jitter is estimated below so many times the error of the outline itself: 0.3 px,
 * where hands have 0.4 and more, and contours that a program made next to none. Drift that the last kernel does not
 * span is no drift. */
constexpr double PreciseFactor = 2.0;

ResidualNoiseModel::ConstPointer
MakeNoiseModel(double correlationLength)
{
  auto model = CorrelatedNoiseModel::New();
  model->SetCorrelationLength(correlationLength);
  return model.GetPointer();
}
} // namespace

PoseGroupRegistration::PoseGroupRegistration(const PoseRegistrationOptions &            options,
                                             bool                                       pixelSpacingKnown,
                                             MetricType *                               metric,
                                             const PartsType &                          parts,
                                             OptimizerType *                            optimizer,
                                             const PoseStart *                          start,
                                             PoseIterationMonitor &                     monitor,
                                             const std::function<void(PoseStageEnum)> & stages,
                                             unsigned int                               group,
                                             bool                                       hypothesis)
  : m_Options(options)
  , m_PixelSpacingKnown(pixelSpacingKnown)
  , m_Metric(metric)
  , m_Optimizer(optimizer)
  , m_Start(start)
  , m_Monitor(monitor)
  , m_Stages(stages)
  , m_Hypothesis(hypothesis)
  , m_Priors(options, pixelSpacingKnown)
  , m_CovarianceNoise(parts.covarianceNoiseModel.IsNotNull()
                        ? parts.covarianceNoiseModel
                        : MakeNoiseModel(options.useCorrelatedNoise ? options.covarianceCorrelationLength : 0.0))
  , m_CorrelatedNoise(parts.noiseModel.IsNotNull()
                        ? parts.noiseModel
                        : MakeNoiseModel(options.useCorrelatedNoise ? options.correlationLength : 0.0))
  , m_Refinement(options, m_Priors, m_CorrelatedNoise, optimizer, monitor, group, hypothesis)
  , m_Posterior(options, m_Priors, metric, m_Refinement, m_CovarianceNoise, monitor)
{
  if (parts.robustKernel.IsNotNull())
  {
    m_Metric->SetRobustKernel(parts.robustKernel);
  }
  else if (m_Options.useRobustKernel)
  {
    m_Metric->SetRobustKernel(GemanMcClureKernel::New());
  }
  else
  {
    m_Metric->SetRobustKernel(SquaresKernel::New());
  }
  m_Metric->SetNoiseModel(m_CorrelatedNoise);
  // Prepared once for all clones.
  m_Metric->Initialize();
}

PoseGroupRegistration::MetricType::Pointer
PoseGroupRegistration::CloneAt(const PositionType & x, JoinsEnum stage) const
{
  MetricType::Pointer clone = this->CloneForStage(stage);
  clone->SetValues(x);
  return clone;
}

PoseGroupRegistration::MetricType::Pointer
PoseGroupRegistration::CloneForStage(JoinsEnum stage) const
{
  // The blocks of a view stay, and so does their order: its priors read them as well.
  MetricType::Pointer clone = m_Metric->Clone();
  for (SizeValueType t = clone->GetNumberOfMetrics(); t-- > 0;)
  {
    if (clone->GetMetric(t)->GetJoins() > stage)
    {
      clone->RemoveMetric(clone->GetMetric(t));
    }
  }
  return clone;
}

RefinedCandidate
PoseGroupRegistration::MakeCandidate(const PositionType & x) const
{
  RefinedCandidate candidate;
  candidate.x = x;
  candidate.noise = { m_Options.initialSmoothSigma, m_Options.initialWhiteSigma };
  return candidate;
}

std::vector<RefinedCandidate>
PoseGroupRegistration::SelectDistinct(const MetricType &                    metric,
                                      const std::vector<RefinedCandidate> & sorted,
                                      double                                distance,
                                      std::size_t                           maximum) const
{
  std::vector<RefinedCandidate> distinct;
  for (const RefinedCandidate & candidate : sorted)
  {
    const bool near = std::any_of(distinct.begin(), distinct.end(), [&](const RefinedCandidate & other) {
      return PosePlace::Distance(metric, candidate.x, other.x) < distance;
    });
    if (!near && distinct.size() < maximum)
    {
      distinct.push_back(candidate);
    }
  }
  return distinct;
}

std::vector<RefinedCandidate>
PoseGroupRegistration::StartsAt(double yaw, unsigned int index, unsigned int & evaluations) const
{
  // The view direction is that of the tracing: two rounds settle the perspective.
  PoseParameters pose{ {} };
  pose[PoseYaw] = yaw;
  MetricType::Pointer metric = this->CloneForStage(JoinsEnum::Start);
  for (int round = 0; round < 2; ++round)
  {
    metric->Hold(MetricType::HoldEnum::Nothing);
    metric->SetValues(WithPose(*metric, metric->GetState().GetValues(), pose));
    metric->Hold(MetricType::HoldEnum::Contours);
    ++evaluations;
    double                target[2] = { 0, 0 };
    std::size_t           points = 0;
    std::array<double, 3> centre{ { 0, 0, 0 } };
    std::size_t           samples = 0;
    PoseGeometry          geometry;
    for (const FoundSilhouette & found : FindSilhouettesOfStart(*metric))
    {
      geometry = found.metric->GetKernel().GetSettings().geometry;
      for (const auto & strand : found.metric->GetKernel().GetStrands())
      {
        for (int k = 0; k < 2; ++k)
        {
          target[k] += strand.tracing.centroid[k] * static_cast<double>(strand.tracing.Size());
        }
        points += strand.tracing.Size();
      }
      for (const PoseContour & contour : found.metric->GetContours(found.position))
      {
        for (const auto & rim : contour.rim)
        {
          for (int k = 0; k < 3; ++k)
          {
            centre[k] += rim[k];
          }
        }
        samples += contour.Size();
      }
    }
    if (samples == 0 || points == 0)
    {
      break;
    }
    for (double & t : target)
    {
      t /= static_cast<double>(points);
    }
    for (double & x : centre)
    {
      x /= static_cast<double>(samples);
    }
    if (round == 0)
    {
      PoseModel(geometry, pose).SolveTranslation(centre.data(), target, pose[PoseTx], pose[PoseTz]);
    }
  }
  PoseStart::RequestType request;
  request.pose = pose;
  // Two more than are kept: refined, some of them fall together.
  request.maximumNumberOfStarts = m_Options.startsPerYaw + 2;
  request.holdRotation = m_Options.fixRotation;
  if (!m_PixelSpacingKnown && !m_Options.fixScale)
  {
    request.searchScale = true;
    // One place may be found at two scales.
    request.maximumNumberOfStarts *= 2;
  }
  RefinementSchedule schedule;
  schedule.widths = m_Options.startKernelWidths;
  schedule.maximumEvaluations = m_Options.startEvaluations;
  schedule.tolerance = m_Options.startTolerance;
  schedule.similarityOnly = true;
  schedule.correlated = false;
  schedule.estimateNoise = false;
  schedule.stage = PoseStageEnum::Start;
  std::vector<PoseStart::StartType> starts = m_Start->Search(*metric, request);
  const auto                        byLandmarks = LandmarkPoseStart::New()->Search(*metric, request);
  starts.insert(starts.end(), byLandmarks.begin(), byLandmarks.end());
  const auto maximumNumberOfCandidates = request.maximumNumberOfStarts + static_cast<unsigned int>(byLandmarks.size());
  std::vector<RefinedCandidate> candidates;
  for (const auto & start : starts)
  {
    if (m_Monitor.IsAborted())
    {
      return {};
    }
    candidates.push_back(this->MakeCandidate(WithPose(*metric, metric->GetState().GetValues(), start.parameters)));
    const auto number = static_cast<unsigned int>(candidates.size() - 1);
    m_Refinement.Run(*metric, schedule, index * maximumNumberOfCandidates + number, candidates.back());
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const RefinedCandidate & a, const RefinedCandidate & b) {
    return a.score < b.score;
  });
  return this->SelectDistinct(*metric, candidates, m_Options.startDistance, m_Options.startsPerYaw);
}

bool
PoseGroupRegistration::Run(PoseGroupResult & group)
{
  const auto byScore = [](const RefinedCandidate & a, const RefinedCandidate & b) { return a.score < b.score; };
  // One that is not ours runs on the one object that it is.
  const bool cloneable = dynamic_cast<const LevenbergMarquardtOptimizerv4 *>(m_Optimizer.GetPointer()) != nullptr;
  const unsigned int threads = cloneable ? m_Options.numberOfThreads : 1;
  m_Stages(PoseStageEnum::Start);
  if (m_Monitor.IsAborted())
  {
    return false;
  }
  const PositionType            origin = m_Metric->GetState().GetValues();
  std::vector<RefinedCandidate> given;
  if (m_Options.useInitialPose)
  {
    given.push_back(this->MakeCandidate(WithPose(*m_Metric, origin, m_Options.initialPose)));
  }
  // The criterion has many minima within a pixel or two, and which of them a start by itself leads to depends on where
  // it was. A search finds the ways into its place that it finds without a start, so that the answer does not tell how
  // one came there. What is held is the start's, of which a search knows nothing.
  std::vector<RefinedCandidate> pool;
  const bool                    isHeld = m_Options.fixScale || m_Options.fixRotation || m_Options.fixTranslation;
  if (given.empty() || !(isHeld || m_Hypothesis))
  {
    std::vector<double> yaws{ 0.0 };
    if (!IsBisected(m_Options.tracedSide) && m_Options.useFullPose && !m_Options.fixRotation &&
        !m_Options.yawStarts.empty())
    {
      yaws = m_Options.yawStarts;
    }
    std::vector<std::vector<RefinedCandidate>> found(yaws.size());
    std::vector<unsigned int>                  evaluations(yaws.size(), 0);
    m_Monitor.ForEach(yaws.size(), threads, [&](std::size_t y) {
      found[y] = this->StartsAt(yaws[y], static_cast<unsigned int>(y), evaluations[y]);
    });
    for (std::size_t y = 0; y < yaws.size(); ++y)
    {
      pool.insert(pool.end(), found[y].begin(), found[y].end());
      group.evaluations += evaluations[y];
    }
  }
  m_Stages(PoseStageEnum::Candidates);
  if (m_Monitor.IsAborted())
  {
    return false;
  }
  if (pool.empty() && given.empty())
  {
    return true;
  }
  std::stable_sort(pool.begin(), pool.end(), byScore);
  const MetricType::Pointer reference = this->CloneAt(pool.empty() ? given.front().x : pool.front().x);
  reference->Hold(MetricType::HoldEnum::Contours);
  const auto refineThese = [&](std::vector<RefinedCandidate> & these,
                               const RefinementSchedule &      schedule,
                               JoinsEnum                       stage,
                               std::size_t                     firstIndex) {
    m_Monitor.ForEach(these.size(), threads, [&](std::size_t i) {
      const MetricType::Pointer metric = this->CloneAt(these[i].x, stage);
      if (!m_Options.regenerateOutline)
      {
        metric->Hold(MetricType::HoldEnum::Contours);
      }
      m_Refinement.Run(*metric, schedule, static_cast<unsigned int>(firstIndex + i), these[i]);
    });
    for (const RefinedCandidate & candidate : these)
    {
      group.evaluations += candidate.evaluations;
    }
    std::stable_sort(these.begin(), these.end(), byScore);
    return !m_Monitor.IsAborted();
  };
  const auto refineAll = [&](const RefinementSchedule & schedule, JoinsEnum stage) {
    return refineThese(pool, schedule, stage, 0);
  };

  // A few steps of each, then the best ones to the end.
  RefinementSchedule coarse;
  coarse.widths = m_Options.coarseKernelWidths;
  coarse.maximumEvaluations = m_Options.coarseEvaluations;
  coarse.tolerance = m_Options.coarseTolerance;
  coarse.estimateNoise = false;
  coarse.stage = PoseStageEnum::Candidates;
  if (!refineAll(coarse, JoinsEnum::Candidates) || !refineThese(given, coarse, JoinsEnum::Candidates, pool.size()))
  {
    return false;
  }
  if (pool.empty())
  {
    pool.swap(given);
  }
  // The best of each of some places, and a second way into the best place: four of one place would hide the others.
  std::vector<RefinedCandidate> kept =
    this->SelectDistinct(*reference, pool, m_Options.placeDistance, m_Options.maximumPlaces);
  for (const RefinedCandidate & candidate : this->SelectDistinct(*reference, pool, m_Options.secondWayDistance, 2))
  {
    const bool there =
      std::any_of(kept.begin(), kept.end(), [&](const RefinedCandidate & other) { return other.x == candidate.x; });
    if (!there)
    {
      kept.push_back(candidate);
    }
  }
  pool = std::move(kept);
  std::stable_sort(pool.begin(), pool.end(), byScore);
  const double limit = pool.front().score + m_Options.scoreMargin;
  pool.erase(std::remove_if(
               pool.begin(), pool.end(), [&](const RefinedCandidate & candidate) { return candidate.score > limit; }),
             pool.end());
  m_Stages(PoseStageEnum::Refinement);
  if (m_Monitor.IsAborted())
  {
    return false;
  }
  RefinementSchedule fine;
  fine.widths = { m_Options.fineKernelWidth };
  fine.maximumEvaluations = m_Options.maximumEvaluations;
  fine.tolerance = m_Options.fineTolerance;
  const auto finish = [&](std::vector<RefinedCandidate> & these) {
    RefinementSchedule schedule = fine;
    if (!refineThese(these, schedule, JoinsEnum::Refinement, 0))
    {
      return false;
    }
    // Where a drawing is precise the whitened criterion has minima a fraction of a pixel beside the answer: a smooth
    // misfit, which it takes for drift of the hand, costs it little against the outline's own small steps. A second
    // way leads there by the plain criterion, and ends by the whitened one with the noise as it is there.
    std::vector<RefinedCandidate> second;
    std::copy_if(these.begin(), these.end(), std::back_inserter(second), [&](const RefinedCandidate & candidate) {
      return m_Options.estimateNoise && candidate.noise.white < PreciseFactor * m_Options.modelSigma &&
             candidate.noise.smooth < m_Options.fineKernelWidth;
    });
    const bool precise = !second.empty();
    if (precise)
    {
      for (RefinedCandidate & candidate : second)
      {
        candidate.noise = { m_Options.initialSmoothSigma, m_Options.initialWhiteSigma };
      }
      RefinementSchedule plain = schedule;
      plain.correlated = false;
      schedule.isNear = true;
      if (!refineThese(second, plain, JoinsEnum::Refinement, these.size()) ||
          !refineThese(second, schedule, JoinsEnum::Refinement, these.size()))
      {
        return false;
      }
      these.insert(these.end(), second.begin(), second.end());
    }
    // Of those that went to the end, each at its own estimate of the noise: hard noise blurs the fixed width's score,
    // and a wrong place that a wide prior allows explains a tracing with levels that no hand has. Where the noise is
    // little, the few points that are no part of it are told by a kernel of its width.
    m_Monitor.ForEach(these.size(), threads, [&](std::size_t i) {
      const double fit = PoseSilhouetteKernel::FitWidth;
      these[i].deviance =
        m_Posterior.ComputeDeviance(these[i], precise ? std::min(fit, m_Refinement.GetOwnWidth(these[i].noise)) : fit);
    });
    std::stable_sort(these.begin(), these.end(), [](const RefinedCandidate & a, const RefinedCandidate & b) {
      return a.deviance < b.deviance;
    });
    if (precise)
    {
      // Both ways to one place are one candidate.
      these = this->SelectDistinct(*reference, these, CandidatePosterior::SameMinimum, these.size());
    }
    return true;
  };
  if (!finish(pool) || !finish(given))
  {
    return false;
  }
  if (!given.empty())
  {
    // Only now: of two candidates that end in one place one may have begun in another.
    const PositionType place = given.front().x;
    const auto         isElsewhere = [&](const RefinedCandidate & candidate) {
      return PosePlace::Distance(*reference, place, candidate.x) > m_Options.placeDistance;
    };
    pool.erase(std::remove_if(pool.begin(), pool.end(), isElsewhere), pool.end());
    if (pool.empty())
    {
      pool = std::move(given);
    }
  }
  m_Stages(PoseStageEnum::Uncertainty);
  if (m_Monitor.IsAborted())
  {
    return false;
  }

  const RefinedCandidate & best = pool.front();
  m_Solution = best.x;
  group.parameters = ToPose(*m_Metric, best.x);
  group.state = best.x;
  for (const auto & block : m_Metric->GetState().GetBlocks())
  {
    group.blocks[block.name] = m_Metric->GetState().GetOffset(block.name);
  }
  group.score = best.score;
  group.converged = best.converged;
  group.stopCondition = best.stopCondition;
  group.smoothSigma = best.noise.smooth;
  group.whiteSigma = best.noise.white;
  for (const RefinedCandidate & other : pool)
  {
    PoseCandidate candidate;
    candidate.parameters = ToPose(*m_Metric, other.x);
    candidate.score = other.score;
    candidate.cost = other.cost;
    candidate.codeTerm = other.codeTerm;
    candidate.deviance = other.deviance;
    candidate.distance = PosePlace::Distance(*reference, best.x, other.x);
    group.candidates.push_back(candidate);
    if (candidate.distance > m_Options.placeDistance)
    {
      group.margin = std::min(group.margin, -std::expm1(-0.5 * (candidate.deviance - best.deviance)));
    }
  }
  // Of a question that is asked of a wrong input nobody asks how sure it is.
  if (!m_Hypothesis)
  {
    const vnl_matrix<double> covariance = m_Posterior.ComputeCovariance(*reference, pool);
    group.stateCovariance.assign(covariance.begin(), covariance.end());
    group.covariance = PickPoseCovariance(covariance, m_Metric->GetState());
  }
  m_Refinement.Settle(*m_Metric, best);
  const auto sigmas = m_Priors.GetFitSigmas(false);
  for (unsigned int k = 0; k < 7; ++k)
  {
    if (sigmas[k] > 0.0 && !std::isinf(sigmas[k]))
    {
      group.priorTension[k] = std::abs(group.parameters[k]) / sigmas[k];
    }
  }
  return true;
}

} // namespace itk
