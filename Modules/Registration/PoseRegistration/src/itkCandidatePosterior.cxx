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
#include "itkCandidatePosterior.h"

#include "itkPoseCovariance.h"
#include "itkPosePlace.h"
#include "itkPoseSilhouetteKernel.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** How much of the evidence's logarithm counts among minima. Points of a tracing are matched with the nearest point of
 * the outline, and where the pose is wrong with that of another cusp: the likelihood is too sure of itself. Where it
 * told two minima of 198 phantom jaws apart by 4 to 8, the other one was nearer to the truth in 42 %, by 8 to 16 in
 * 29 %, by 16 to 32 in 6 %: odds of a fifth. The priors and the known landmarks count by so much more that, with their
 * part of the evidence, it is what the same jaws had them count, three fifths (Documentation/RobustStudies.md). */
constexpr double EvidenceShare = 0.2;
constexpr double KnownShare = 0.4;

/** Of a point, in comparisons of models: so small that a point which fits somewhat counts as before, so large that one
 * which fits nowhere costs 3 log 10. */
constexpr double SmallestWeight = 1e-3;
} // namespace

CandidatePosterior::CandidatePosterior(const PoseRegistrationOptions &          options,
                                       const PosePriors &                       priors,
                                       const MetricType *                       metric,
                                       const CandidateRefinement &              refinement,
                                       const ResidualNoiseModel::ConstPointer & covarianceNoise,
                                       PoseIterationMonitor &                   monitor)
  : m_Options(options)
  , m_Priors(priors)
  , m_Metric(metric)
  , m_Refinement(refinement)
  , m_CovarianceNoise(covarianceNoise)
  , m_Monitor(monitor)
{}

CandidatePosterior::MetricType::Pointer
CandidatePosterior::SettledAt(const RefinedCandidate & candidate) const
{
  MetricType::Pointer metric = m_Metric->Clone();
  m_Refinement.Settle(*metric, candidate);
  return metric;
}

double
CandidatePosterior::ComputeDeviance(const RefinedCandidate & candidate, double width) const
{
  const MetricType::Pointer metric = this->SettledAt(candidate);
  metric->Hold(MetricType::HoldEnum::Nothing);
  metric->SetKernelWidth(width);
  // Marginal over the pose, by Laplace: the data at the minimum, and how much room there is about it.
  const double evidence = metric->EstimateNoise(SmallestWeight);
  // What has no noise to estimate, the priors and landmarks, by its own criterion: the evidence has its squares, and
  // neither the tails of a prior nor what a landmark is charged that was let go.
  const double known = metric->ComputeKnownDeviance(candidate.x, true);
  // Without a tracing the evidence has nothing whose noise is to be estimated, and is 0. What is known is then what
  // landmarks say, and outlines as so many landmarks: a likelihood that is not too sure.
  const double       places = m_Options.codeWeight > 0.0 ? candidate.codeTerm / m_Options.codeSigma : 0.0;
  ContourNoiseLevels levels;
  const double       share = metric->GetNoiseLevels(levels) ? KnownShare : 1.0;
  return EvidenceShare * evidence + share * known + places * places;
}
vnl_matrix<double>
CandidatePosterior::ComputeCovariance(const MetricType & reference, const std::vector<RefinedCandidate> & pool) const
{
  // Minima of a share below this change no standard deviation of a landmark that the verdict would let pass.
  constexpr double smallestShare = 0.01;

  const RefinedCandidate &              best = pool.front();
  std::vector<const RefinedCandidate *> minima;
  std::vector<double>                   shares;
  double                                sum = 0.0;
  for (const RefinedCandidate & candidate : pool)
  {
    const double share = std::exp(-0.5 * (candidate.deviance - best.deviance));
    const bool   same = std::any_of(minima.begin(), minima.end(), [&](const RefinedCandidate * other) {
      return PosePlace::Distance(reference, candidate.x, other->x) < SameMinimum;
    });
    if (minima.empty() || (share > smallestShare && !same))
    {
      minima.push_back(&candidate);
      shares.push_back(share);
      sum += share;
    }
  }
  // A mixture of the minima, about the best one, which is what is reported.
  const auto                      all = static_cast<unsigned int>(best.x.size());
  vnl_matrix<double>              covariance(all, all, 0.0);
  std::vector<vnl_matrix<double>> own(minima.size());
  m_Monitor.ForEach(minima.size(), m_Options.numberOfThreads, [&](std::size_t i) {
    const MetricType::Pointer metric = this->SettledAt(*minima[i]);
    own[i] = ComputeStateCovariance(*metric, m_Options, m_Priors, m_CovarianceNoise);
  });
  for (std::size_t i = 0; i < minima.size(); ++i)
  {
    const PositionType & place = minima[i]->x;
    for (unsigned int a = 0; a < all; ++a)
    {
      for (unsigned int b = 0; b < all; ++b)
      {
        covariance(a, b) += shares[i] / sum * (own[i](a, b) + (place[a] - best.x[a]) * (place[b] - best.x[b]));
      }
    }
  }
  return covariance;
}

double
CandidatePosterior::ComputeEvidence(const MetricType & metric, const PositionType & solution)
{
  const MetricType::Pointer clone = metric.Clone();
  clone->SetValues(solution);
  clone->Hold(MetricType::HoldEnum::Nothing);
  clone->SetKernelWidth(PoseSilhouetteKernel::FitWidth);
  return clone->EstimateNoise(SmallestWeight);
}

double
CandidatePosterior::ComputeCriterion(const MetricType & metric, const PositionType & solution, const MetricType & noise)
{
  const MetricType::Pointer clone = metric.Clone();
  clone->SetValues(solution);
  clone->Hold(MetricType::HoldEnum::Nothing);
  clone->SetKernelWidth(PoseSilhouetteKernel::FitWidth);
  ContourNoiseLevels levels;
  if (noise.GetNoiseLevels(levels))
  {
    clone->SetNoiseLevels(levels);
  }
  return clone->ComputeValue(solution);
}
} // namespace itk
