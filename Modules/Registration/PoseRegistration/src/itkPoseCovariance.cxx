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
#include "itkPoseCovariance.h"

#include "itkCorrelatedNoiseModel.h"

#include "vnl/algo/vnl_cholesky.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace itk
{
vnl_matrix<double>
ComputeStateCovariance(const LeastSquaresSumMetricv4 & original,
                       const PoseRegistrationOptions & options,
                       const PosePriors &              priors,
                       const ResidualNoiseModel *      noiseModel)
{
  PosePriors::SigmasType       sigmas = priors.GetCovarianceSigmas();
  const PosePriors::SigmasType heldSigmas = priors.GetHeldSigmas();
  for (unsigned int k = 0; k < 7; ++k)
  {
    sigmas[k] = heldSigmas[k] > 0.0 ? std::numeric_limits<double>::infinity() : sigmas[k];
  }
  const LeastSquaresSumMetricv4::Pointer metric = original.Clone();
  const auto                             all = static_cast<unsigned int>(metric->GetState().GetNumberOfParameters());
  vnl_matrix<double>                     covariance(all, all, 0.0);
  metric->Hold(LeastSquaresMetricv4::HoldEnum::Nothing);
  PosePriors::SetFree(*metric, sigmas);
  priors.SetPriors(*metric, sigmas, true);
  auto ownModel = CorrelatedNoiseModel::New();
  ownModel->SetCorrelationLength(options.useCorrelatedNoise ? options.covarianceCorrelationLength : 0.0);
  ContourNoiseLevels levels;
  const bool         hasNoise = metric->GetNoiseLevels(levels);
  metric->SetNoiseModel(noiseModel != nullptr ? noiseModel : ownModel.GetPointer());
  if (metric->GetState().GetNumberOfFreeParameters() == 0)
  {
    return covariance;
  }
  metric->Initialize();
  // By the normals of where the covariance is of, wherever the metric was evaluated before.
  metric->UpdateNoiseCorrelation(metric->GetState().GetValues());
  if (hasNoise)
  {
    metric->SetKernelWidth(
      std::max(options.fineKernelWidth, options.adaptiveKernelFactor * std::hypot(levels.smooth, levels.white)));
    if (options.estimateNoise)
    {
      metric->EstimateNoise();
      metric->GetNoiseLevels(levels);
    }
    const double absorbed =
      std::min(options.absorbedNoiseLimit, 1.0 + options.absorbedNoise * levels.smooth * levels.smooth);
    levels.smooth *= absorbed;
    levels.white *= absorbed;
    // What outline and frame get wrong stays where the tracing is perfect.
    levels.smooth = std::hypot(levels.smooth, options.modelSigma);
    metric->SetNoiseLevels(levels);
  }

  // Information in natural units, of the free parameters.
  LeastSquaresMetricv4::VectorType residuals;
  LeastSquaresMetricv4::MatrixType jacobian;
  metric->ComputeResiduals(metric->GetState().GetValues(), residuals, &jacobian);
  const RegistrationState & state = metric->GetState();
  const auto &              free = state.GetFreeIndices();
  const std::size_t         pose = state.GetOffset("pose");
  const std::size_t         scale = state.GetOffset("scale");
  // Which of the seven a parameter of the state is; 7: none, a block of a user's own.
  const auto parameterOf = [&](std::size_t index) -> unsigned int {
    return index == scale ? static_cast<unsigned int>(PoseKappa)
                          : (index >= pose && index < pose + 6 ? static_cast<unsigned int>(index - pose) : 7U);
  };
  std::vector<unsigned int> estimated;
  std::vector<unsigned int> held;
  for (const std::size_t index : free)
  {
    const unsigned int k = parameterOf(index);
    (k < 7 && heldSigmas[k] > 0.0 ? held : estimated).push_back(static_cast<unsigned int>(index));
  }
  const auto information = [&](unsigned int a, unsigned int b) {
    double sum = 0.0;
    for (unsigned int i = 0; i < jacobian.rows(); ++i)
    {
      sum += jacobian(i, a) * jacobian(i, b);
    }
    return sum;
  };
  const auto         p = static_cast<unsigned int>(estimated.size());
  vnl_matrix<double> inverse(p, p, 0.0);
  if (p > 0)
  {
    vnl_matrix<double> own(p, p);
    for (unsigned int a = 0; a < p; ++a)
    {
      for (unsigned int b = 0; b < p; ++b)
      {
        // Not singular, where nothing at all is observed.
        own(a, b) = information(estimated[a], estimated[b]) + (a == b ? 1e-9 : 0.0);
      }
    }
    inverse = vnl_cholesky(own, vnl_cholesky::quiet).inverse();
  }
  // The estimated ones, and what they do for a unit of each held one.
  const double inflation = options.covarianceInflation * options.covarianceInflation;
  const auto   add = [&](unsigned int a, unsigned int b, double value) { covariance(a, b) += value; };
  for (unsigned int a = 0; a < p; ++a)
  {
    for (unsigned int b = 0; b < p; ++b)
    {
      add(estimated[a], estimated[b], inflation * 0.5 * (inverse(a, b) + inverse(b, a)));
    }
  }
  for (const unsigned int h : held)
  {
    const double        sigma = heldSigmas[parameterOf(h)];
    std::vector<double> spread(p, 0.0);
    for (unsigned int b = 0; b < p; ++b)
    {
      const double coupling = information(estimated[b], h);
      for (unsigned int a = 0; a < p; ++a)
      {
        spread[a] -= inverse(a, b) * coupling;
      }
    }
    add(h, h, sigma * sigma);
    for (unsigned int a = 0; a < p; ++a)
    {
      add(estimated[a], h, sigma * sigma * spread[a]);
      add(h, estimated[a], sigma * sigma * spread[a]);
      for (unsigned int b = 0; b < p; ++b)
      {
        add(estimated[a], estimated[b], sigma * sigma * spread[a] * spread[b]);
      }
    }
  }
  return covariance;
}

vnl_matrix<double>
PickCovariance(const vnl_matrix<double> & covariance, const std::vector<std::size_t> & places)
{
  const auto         count = static_cast<unsigned int>(places.size());
  vnl_matrix<double> picked(count, count);
  for (unsigned int a = 0; a < count; ++a)
  {
    for (unsigned int b = 0; b < count; ++b)
    {
      picked(a, b) = covariance(static_cast<unsigned int>(places[a]), static_cast<unsigned int>(places[b]));
    }
  }
  return picked;
}

std::array<double, 49>
PickPoseCovariance(const vnl_matrix<double> & covariance, const RegistrationState & state)
{
  std::vector<std::size_t> places;
  for (unsigned int k = 0; k < 7; ++k)
  {
    places.push_back(k == PoseKappa ? state.GetOffset("scale") : state.GetOffset("pose") + k);
  }
  const vnl_matrix<double> picked = PickCovariance(covariance, places);
  std::array<double, 49>   rows{};
  std::copy(picked.begin(), picked.end(), rows.begin());
  return rows;
}

std::array<double, 49>
ComputePoseCovariance(const LeastSquaresSumMetricv4 & metric,
                      const PoseRegistrationOptions & options,
                      const PosePriors &              priors,
                      const ResidualNoiseModel *      noiseModel)
{
  return PickPoseCovariance(ComputeStateCovariance(metric, options, priors, noiseModel), metric.GetState());
}
} // namespace itk
