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

#include "itkParallelFor.h"
#include "itkPoseStartSearch.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Vector3 = std::array<double, 3>;
}

std::vector<PoseState>
PoseGroupRegistration::StartsAt(double yaw, unsigned int & evaluations) const
{
  // The view direction is that of the tracing: two rounds settle the perspective.
  PoseParameters           pose{ {} };
  std::vector<PoseContour> contours;
  pose[PoseYaw] = yaw;
  double      target[2] = { 0, 0 };
  std::size_t points = 0;
  for (const PoseStrand & strand : m_Estimator.GetStrands())
  {
    for (int k = 0; k < 2; ++k)
    {
      target[k] += strand.tracing.centroid[k] * static_cast<double>(strand.tracing.Size());
    }
    points += strand.tracing.Size();
  }
  for (double & t : target)
  {
    t /= static_cast<double>(points);
  }
  for (int round = 0; round < 2; ++round)
  {
    contours = m_Estimator.ComputeContours(pose);
    ++evaluations;
    Vector3     centre{ { 0, 0, 0 } };
    std::size_t samples = 0;
    for (const PoseContour & contour : contours)
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
    if (samples == 0)
    {
      return {};
    }
    for (double & x : centre)
    {
      x /= static_cast<double>(samples);
    }
    if (round == 0)
    {
      PoseModel(m_Estimator.GetGeometry(), pose).SolveTranslation(centre.data(), target, pose[PoseTx], pose[PoseTz]);
    }
  }
  PoseStartSearch search;
  search.maximumStarts = m_Options.startsPerYaw + 2;
  if (!m_Estimator.GetGeometry().pixelSpacingKnown && !m_Options.fixScale)
  {
    search.kappas = { 0.0, -0.35, -0.28, -0.21, -0.14, -0.07, 0.07, 0.14, 0.21, 0.28, 0.35 };
    search.maximumStarts *= 2;
  }
  if (m_Options.fixRotation)
  {
    search.rotationRange = 0.0;
  }
  PoseSchedule schedule;
  schedule.widths = { 10.0, 8.0, 6.0, 5.0, 4.0, 3.0 };
  schedule.maximumEvaluations = 13;
  schedule.similarityOnly = true;
  schedule.correlated = false;
  schedule.estimateNoise = false;
  schedule.tolerance = 0.05;
  std::vector<PoseState> states;
  for (const auto & start : search.Search(m_Estimator, contours, pose))
  {
    PoseState state;
    state.parameters = start.parameters;
    state.noise = { m_Options.initialSmoothSigma, m_Options.initialWhiteSigma };
    states.push_back(m_Estimator.RefineFrozen(state, schedule, contours, pose));
  }
  std::stable_sort(
    states.begin(), states.end(), [](const PoseState & a, const PoseState & b) { return a.score < b.score; });
  std::vector<PoseState> distinct;
  for (const PoseState & state : states)
  {
    const bool near = std::any_of(distinct.begin(), distinct.end(), [&](const PoseState & other) {
      return m_Estimator.ContourDistance(contours, state.parameters, other.parameters) < 3.0;
    });
    if (!near && distinct.size() < m_Options.startsPerYaw)
    {
      distinct.push_back(state);
    }
  }
  return distinct;
}

std::vector<PoseState>
PoseGroupRegistration::Distinct(const std::vector<PoseState> & states, double distance, std::size_t maximum) const
{
  std::vector<PoseState> distinct;
  for (const PoseState & state : states)
  {
    const bool near = std::any_of(distinct.begin(), distinct.end(), [&](const PoseState & other) {
      return m_Estimator.ContourDistance(m_Reference, state.parameters, other.parameters) < distance;
    });
    if (!near && distinct.size() < maximum)
    {
      distinct.push_back(state);
    }
  }
  return distinct;
}

bool
PoseGroupRegistration::Run(PoseGroupResult & group)
{
  const auto byScore = [](const PoseState & a, const PoseState & b) { return a.score < b.score; };
  if (this->Aborted(0.0))
  {
    return false;
  }
  std::vector<PoseState> pool;
  if (m_Options.useInitialPose)
  {
    PoseState state;
    state.parameters = m_Options.initialPose;
    state.noise = { m_Options.initialSmoothSigma, m_Options.initialWhiteSigma };
    pool.push_back(state);
  }
  else
  {
    std::vector<double> yaws{ 0.0 };
    if (m_Options.tracedSide != PoseTracedSideEnum::Mean && m_Options.useFullPose && !m_Options.fixRotation &&
        !m_Options.yawStarts.empty())
    {
      yaws = m_Options.yawStarts;
    }
    std::vector<std::vector<PoseState>> found(yaws.size());
    std::vector<unsigned int>           evaluations(yaws.size(), 0);
    ParallelFor(yaws.size(), m_Options.numberOfThreads, [&](std::size_t y) {
      found[y] = this->StartsAt(yaws[y], evaluations[y]);
    });
    for (std::size_t y = 0; y < yaws.size(); ++y)
    {
      pool.insert(pool.end(), found[y].begin(), found[y].end());
      group.evaluations += evaluations[y];
    }
  }
  if (pool.empty() || this->Aborted(0.3))
  {
    return !pool.empty() ? false : true;
  }
  std::stable_sort(pool.begin(), pool.end(), byScore);
  m_ReferencePose = pool.front().parameters;
  m_Reference = m_Estimator.ComputeContours(m_ReferencePose);

  // A few steps of each, then the best ones to the end.
  PoseSchedule coarse;
  coarse.maximumEvaluations = 6;
  coarse.estimateNoise = false;
  coarse.tolerance = 0.05;
  ParallelFor(
    pool.size(), m_Options.numberOfThreads, [&](std::size_t i) { pool[i] = m_Estimator.Refine(pool[i], coarse); });
  for (const PoseState & state : pool)
  {
    group.evaluations += state.evaluations;
  }
  std::stable_sort(pool.begin(), pool.end(), byScore);
  // The best of each of three places, and a second way into the best place: four of one place would hide the others.
  std::vector<PoseState> kept = this->Distinct(pool, 4.0, 3);
  for (const PoseState & state : this->Distinct(pool, 1.0, 2))
  {
    const bool there = std::any_of(
      kept.begin(), kept.end(), [&](const PoseState & other) { return other.parameters == state.parameters; });
    if (!there)
    {
      kept.push_back(state);
    }
  }
  pool = std::move(kept);
  std::stable_sort(pool.begin(), pool.end(), byScore);
  const double limit = pool.front().score + 0.12;
  pool.erase(std::remove_if(pool.begin(), pool.end(), [&](const PoseState & s) { return s.score > limit; }),
             pool.end());
  if (this->Aborted(0.6))
  {
    return false;
  }
  PoseSchedule fine;
  fine.widths = { 3.0 };
  fine.maximumEvaluations = m_Options.maximumEvaluations;
  ParallelFor(
    pool.size(), m_Options.numberOfThreads, [&](std::size_t i) { pool[i] = m_Estimator.Refine(pool[i], fine); });
  for (const PoseState & state : pool)
  {
    group.evaluations += state.evaluations;
  }
  std::stable_sort(pool.begin(), pool.end(), byScore);
  if (this->Aborted(0.9))
  {
    return false;
  }
  const PoseState & best = pool.front();
  group.parameters = best.parameters;
  group.score = best.score;
  group.converged = best.converged;
  group.smoothSigma = best.noise.smooth;
  group.whiteSigma = best.noise.white;
  for (const PoseState & state : pool)
  {
    PoseCandidate candidate;
    candidate.parameters = state.parameters;
    candidate.score = state.score;
    candidate.cost = state.cost;
    candidate.codeTerm = state.codeTerm;
    candidate.distance = m_Estimator.ContourDistance(m_Reference, best.parameters, state.parameters);
    group.candidates.push_back(candidate);
    if (candidate.distance > 4.0)
    {
      group.margin = std::min(group.margin, candidate.score - best.score);
    }
  }
  PoseNoise noise;
  group.covariance = m_Estimator.ComputeCovariance(best, noise);
  const auto sigmas = m_Estimator.GetPriorSigmas(false);
  for (unsigned int k = 0; k < 7; ++k)
  {
    if (sigmas[k] > 0.0 && !std::isinf(sigmas[k]))
    {
      group.priorTension[k] = std::abs(best.parameters[k]) / sigmas[k];
    }
  }
  return true;
}
} // namespace itk
