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
#ifndef itkPoseNoiseModel_h
#define itkPoseNoiseModel_h

// Private: Eigen must not be seen by files that include ITK headers.
#include "itkPoseEstimator.h"

#include <Eigen/Dense>

#include <vector>

namespace itk
{
/** The covariance of one strand's residuals: smooth^2 G + white^2 W^-1. */
struct PoseNoiseBlock
{
  /** rho(s_i - s_j) n_i.n_j */
  Eigen::MatrixXd correlation;
  Eigen::VectorXd weight;
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;

  /** With correlationLength 0 the noise is white and both variances add. */
  void
  SetCorrelation(const PoseTracing & tracing, const double * nu, const double * nv, double correlationLength);
  Eigen::MatrixXd
  Covariance(const PoseNoise & noise) const;
};

/** Restricted maximum likelihood of the two noise levels with the linearised parameters integrated out under their
 * prior. Log-normal priors on the levels around 1.5 and 0.7 px, 0.8 wide in the logarithm.
 * \param precision  prior precision of the parameters (0: free).
 * \param offset  parameters minus prior mean.
 * \param deviance  if not null: minus twice the restricted log likelihood at the estimate (noise priors left out). */
PoseNoise
EstimatePoseNoise(const std::vector<PoseNoiseBlock> & blocks,
                  const Eigen::VectorXd &             precision,
                  const Eigen::VectorXd &             offset,
                  const PoseNoise &                   start,
                  double *                            deviance = nullptr);
} // namespace itk

#endif
