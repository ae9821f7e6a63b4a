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
#ifndef itkContourNoiseModel_h
#define itkContourNoiseModel_h

#include "RegistrationCommonExport.h"

#include <cstddef>
#include <vector>

namespace itk
{
/** Standard deviations of a tracing's smooth drift and of its white part, px. */
struct ContourNoiseLevels
{
  double smooth{ 1.3 }; /**< Of the drift along the line. */
  double white{ 0.6 };  /**< Of each point's own error. */
};

/** \class ContourNoiseModel
 * \brief Noise of a tracing: the hand drifts smoothly along it, and each point has an error of its own.
 *
 * The residuals r of the points, taken along the normals n at arc lengths s, have the covariance
 *
 *   K = smooth^2 G + white^2 W^-1,   G_ij = exp(-(s_i - s_j)^2 / (2 length^2)) (n_i . n_j),   W = diag(weights)
 *
 * and Estimate() finds the two levels by restricted maximum likelihood. Free of ITK; flat arrays. Strands of different
 * blocks are independent.
 *
 * Source: Patterson and Thompson, Biometrika 1971 (REML).
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT ContourNoiseModel
{
public:
  /** Count residuals of one strand, linear in the parameters near the estimate; nothing is owned. */
  struct BlockType
  {
    std::size_t count{ 0 }; /**< Residuals of the strand. */
    /** G, count x count. */
    const double * correlation{ nullptr };
    const double * weights{ nullptr };
    const double * residuals{ nullptr };
    /** Count x number of parameters, column by column. */
    const double * jacobian{ nullptr };
  };

  /** G into count x count doubles; the unit matrix where the length is 0. */
  static void
  ComputeCorrelation(
    const double * arc, const double * nu, const double * nv, std::size_t count, double length, double * correlation);

  /** K of a block into count x count doubles. Weights are taken as at least 1e-6. */
  static void
  ComputeCovariance(const double *             correlation,
                    const double *             weights,
                    std::size_t                count,
                    const ContourNoiseLevels & levels,
                    double *                   covariance);

  /** The two levels with the linearised parameters integrated out under their prior. Log-normal priors on the levels
   * around 1.5 and 0.7 px, 0.8 wide in the logarithm.
   * \param precision  prior precision of the parameters, one each (0: free).
   * \param offset  parameters minus prior mean, one each.
   * \param deviance  if not null: minus twice the restricted log likelihood at the estimate (noise priors left out). */
  static ContourNoiseLevels
  Estimate(const std::vector<BlockType> & blocks,
           const double *                 precision,
           const double *                 offset,
           std::size_t                    numberOfParameters,
           const ContourNoiseLevels &     start,
           double *                       deviance = nullptr);

  /** The same where what else is known of the parameters (priors, residuals of known noise) is a quadratic form near
   * the estimate: value + 2 gradient' step + step' information step.
   * \param information  numberOfParameters^2.
   * \param gradient  one each. */
  static ContourNoiseLevels
  Estimate(const std::vector<BlockType> & blocks,
           const double *                 information,
           const double *                 gradient,
           double                         value,
           std::size_t                    numberOfParameters,
           const ContourNoiseLevels &     start,
           double *                       deviance = nullptr);

  /** Cholesky factor L of a covariance K = L L', count x count, in its place (lower triangle, column by column). False
   * where K is not positive definite. */
  static bool
  Factor(double * covariance, std::size_t count);

  /** L^-1 times columns (count rows each, one behind the other), in their place: residuals and Jacobian with this
   * covariance become independent with variance 1. */
  static void
  Whiten(const double * factor, std::size_t count, double * columns, std::size_t numberOfColumns);

  /** L'^-1 times columns, in their place: after Whiten() that is K^-1 times the columns. */
  static void
  WhitenTransposed(const double * factor, std::size_t count, double * columns, std::size_t numberOfColumns);
};
} // namespace itk

#endif
