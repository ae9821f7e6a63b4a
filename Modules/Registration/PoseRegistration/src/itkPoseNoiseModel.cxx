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
#include "itkPoseNoiseModel.h"

#include "itkContourNoiseModel.h"

namespace itk
{
void
PoseNoiseBlock::SetCorrelation(const PoseTracing & tracing,
                               const double *      nu,
                               const double *      nv,
                               double              correlationLength)
{
  const auto n = static_cast<Eigen::Index>(tracing.Size());
  correlation.resize(n, n);
  ContourNoiseModel::ComputeCorrelation(
    tracing.arc.data(), nu, nv, tracing.Size(), correlationLength, correlation.data());
}

Eigen::MatrixXd
PoseNoiseBlock::Covariance(const PoseNoise & noise) const
{
  Eigen::MatrixXd k(correlation.rows(), correlation.cols());
  ContourNoiseModel::ComputeCovariance(correlation.data(),
                                       weight.data(),
                                       static_cast<std::size_t>(correlation.rows()),
                                       { noise.smooth, noise.white },
                                       k.data());
  return k;
}

PoseNoise
EstimatePoseNoise(const std::vector<PoseNoiseBlock> & blocks,
                  const Eigen::VectorXd &             precision,
                  const Eigen::VectorXd &             offset,
                  const PoseNoise &                   start,
                  double *                            deviance)
{
  std::vector<ContourNoiseModel::BlockType> views;
  views.reserve(blocks.size());
  for (const PoseNoiseBlock & block : blocks)
  {
    views.push_back({ static_cast<std::size_t>(block.weight.size()),
                      block.correlation.data(),
                      block.weight.data(),
                      block.residual.data(),
                      block.jacobian.data() });
  }
  const ContourNoiseLevels levels = ContourNoiseModel::Estimate(views,
                                                                precision.data(),
                                                                offset.data(),
                                                                static_cast<std::size_t>(precision.size()),
                                                                { start.smooth, start.white },
                                                                deviance);
  return { levels.smooth, levels.white };
}
} // namespace itk
