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
#ifndef itkPoseEstimator_h
#define itkPoseEstimator_h

#include "PoseRegistrationExport.h"
#include "itkPoseArch.h"
#include "itkPoseContourModel.h"
#include "itkPoseRegistrationTypes.h"
#include "itkPoseTracing.h"

#include <vector>

namespace itk
{
/** \struct PoseStrand
 * \brief A strand of tracing and the contour models that it may lie on.
 * \ingroup PoseRegistration
 */
struct PoseStrand
{
  PoseTracing                           tracing;
  std::vector<const PoseContourModel *> models;
  const PoseArch *                      arch{ nullptr };
  bool                                  upper{ true };
  std::size_t                           jaw{ 0 };
};

/** \struct PoseNoise
 * \brief Standard deviations of the tracing's smooth drift and of its white part, px.
 * \ingroup PoseRegistration
 */
struct PoseNoise
{
  double smooth{ 1.3 };
  double white{ 0.6 };
};

/** \struct PoseState
 * \brief A pose on its way.
 * \ingroup PoseRegistration
 */
struct PoseState
{
  PoseParameters parameters{ {} };
  PoseNoise      noise;
  unsigned int   evaluations{ 0 };
  bool           converged{ false };
  /** Fixed-width cost, code term (mm) and what candidates are ranked by. */
  double cost{ 1.0 };
  double codeTerm{ 0.0 };
  double score{ 1.0 };
};

/** \struct PoseSchedule
 * \brief How PoseEstimator::Refine() goes about it.
 * \ingroup PoseRegistration
 */
struct PoseSchedule
{
  /** Kernel widths (px) of the first steps; the last one goes on, or the adaptive width where noise is estimated. */
  std::vector<double> widths{ 6.0, 4.5, 3.0 };
  unsigned int        maximumEvaluations{ 14 };
  bool                similarityOnly{ false };
  bool                correlated{ true };
  bool                estimateNoise{ true };
  /** Stop where a step moves the contour by less (rms, px). */
  double tolerance{ 0.005 };
};

/** \class PoseEstimator
 * \brief Levenberg-Marquardt on the residuals of a tracing against its moving contour, generalised least squares with
 * priors (roll and yaw: t, the others Gaussian). Documentation/Robust.md has the formulas.
 *
 * Residual of tracing point x with the oriented nearest contour point q and its normal n: r = n.(x - q(theta)).
 * Cov(r_i, r_j) = s_c^2 exp(-(s_i - s_j)^2 / 2 l^2) n_i.n_j + delta_ij s_w^2 / w_i along one strand, w the robust
 * weight. A step is taken only where the criterion falls at the contour made anew.
 *
 * Const methods may be called from several threads.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PoseEstimator
{
public:
  PoseEstimator(const PoseGeometry & geometry, const PoseRegistrationOptions & options, std::vector<PoseStrand> strands);

  const std::vector<PoseStrand> &
  GetStrands() const
  {
    return m_Strands;
  }
  const PoseGeometry &
  GetGeometry() const
  {
    return m_Geometry;
  }

  /** The moving contour of each strand. */
  std::vector<PoseContour>
  ComputeContours(const PoseParameters & parameters) const;

  /** Refines with the contours made anew at each evaluation. */
  PoseState
  Refine(const PoseState & start, const PoseSchedule & schedule) const;

  /** Refines with given contours (made at contourPose) that only move. */
  PoseState
  RefineFrozen(const PoseState &                start,
               const PoseSchedule &             schedule,
               const std::vector<PoseContour> & contours,
               const PoseParameters &           contourPose) const;

  /** Fills cost, codeTerm and score. */
  void
  Score(PoseState & state, const std::vector<PoseContour> & contours) const;

  /** Statistics of one strand at a pose, kernel width 4 px. */
  PoseFitStatistics
  ComputeStatistics(std::size_t strand, const PoseContour & contour) const;

  /** Share of a strand's contour that has a tracing point within 4 px. */
  double
  ComputeOverlap(std::size_t strand, const PoseContour & contour) const;

  /** 7x7, row-major: inverse of information and priors with the longer correlation length, inflation included. The
   * noise is estimated anew. Parameters that were fixed have no variance. */
  std::array<double, 49>
  ComputeCovariance(const PoseState & state, PoseNoise & noise) const;

  /** Sigma an axis that a covariance predicts, px: rms over a strand's matched points, and the largest on its contour.
   */
  std::array<double, 2>
  PredictedSigma(std::size_t                      strand,
                 const PoseParameters &           parameters,
                 const std::vector<PoseContour> & contours,
                 const std::array<double, 49> &   covariance) const;

  /** Minus twice the log likelihood (restricted) of the tracing at a pose, for the comparison of models. */
  double
  ComputeDeviance(const PoseState & state) const;

  /** Rms distance of contour samples under two poses, px. */
  double
  ContourDistance(const std::vector<PoseContour> & contours,
                  const PoseParameters &           contourPose,
                  const PoseParameters &           other) const;

  /** The same for the covariance: rotations that were not estimated are uncertain all the same. */
  std::array<double, 7>
  GetCovarianceSigmas() const;

  /** How far what the user holds may be off; 0 for all else. */
  std::array<double, 7>
  GetHeldSigmas() const;

  /** Which parameters may move, and the prior's standard deviation of each: 0 fixed, infinity free. */
  std::array<double, 7>
  GetPriorSigmas(bool similarityOnly) const;

  /** Residuals, their derivatives and weights, stacked over the strands; public for tests of the derivatives. */
  struct Linearization
  {
    std::vector<double> residual;
    /** What the robust weight is of: |r|, or the full distance beside the contour. */
    std::vector<double> distance;
    std::vector<double> nu;
    std::vector<double> nv;
    /** 7 a point. */
    std::vector<double> jacobian;
    std::vector<double> facing;
    /** Index of the contour sample, in the strand's contour. */
    std::vector<std::size_t> match;
  };
  Linearization
  Linearize(const PoseParameters & parameters, const std::vector<PoseContour> & contours, bool withJacobian) const;

private:
  class Solver;

  PoseState
  Run(const PoseState &                start,
      const PoseSchedule &             schedule,
      const std::vector<PoseContour> * frozen,
      const PoseParameters &           frozenPose) const;

  PoseGeometry            m_Geometry;
  PoseRegistrationOptions   m_Options;
  std::vector<PoseStrand> m_Strands;
  std::size_t             m_Count{ 0 };
};
} // namespace itk

#endif
