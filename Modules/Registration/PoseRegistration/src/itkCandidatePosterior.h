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
#ifndef itkCandidatePosterior_h
#define itkCandidatePosterior_h

#include "itkCandidateRefinement.h"

#include "vnl/vnl_matrix.h"

#include <vector>

namespace itk
{
/** \class CandidatePosterior
 * \brief What minima weigh against each other, and how sure one is of the answer among them.
 * \ingroup PoseRegistration
 */
class CandidatePosterior
{
public:
  using MetricType = LeastSquaresSumMetricv4;
  using PositionType = MetricType::PositionType;

  /** Two ways that ended less than this apart ended in one minimum, px: it counts once. */
  static constexpr double SameMinimum = 0.5;

  /** \param metric  cloned for each minimum, with the settings that the candidates were refined with.
   *  \param covarianceNoise  the noise that the covariance, not the estimate, takes the drawing to have. */
  CandidatePosterior(const PoseRegistrationOptions &          options,
                     const PosePriors &                       priors,
                     const MetricType *                       metric,
                     const CandidateRefinement &              refinement,
                     const ResidualNoiseModel::ConstPointer & covarianceNoise,
                     PoseIterationMonitor &                   monitor);

  /** Minus twice the logarithm of what a minimum weighs: its posterior, with the mass about it.
   * \param width  of the kernel that tells which points are no part of the evidence. */
  double
  ComputeDeviance(const RefinedCandidate & candidate, double width) const;

  /** Of the minima together, each by its weight, in all values of the state.
   * \param reference  measures how far minima are from each other.
   * \param pool       the minima, the best one first. */
  vnl_matrix<double>
  ComputeCovariance(const MetricType & reference, const std::vector<RefinedCandidate> & pool) const;

  /** Minus twice the log likelihood of the evidence at a solution of the metric that found it, for the comparison of
   * models: a point that fits nowhere counts against a model, it does not drop out. */
  static double
  ComputeEvidence(const MetricType & metric, const PositionType & solution);

  /** The robust criterion at a solution with the noise of another metric, so that two that are about the same drawings
   * can be compared: what fits nowhere costs what the kernel charges. */
  static double
  ComputeCriterion(const MetricType & metric, const PositionType & solution, const MetricType & noise);

private:
  /** A clone of the metric where a candidate ended. */
  MetricType::Pointer
  SettledAt(const RefinedCandidate & candidate) const;

  PoseRegistrationOptions          m_Options;
  PosePriors                       m_Priors;
  MetricType::ConstPointer         m_Metric;
  const CandidateRefinement &      m_Refinement;
  ResidualNoiseModel::ConstPointer m_CovarianceNoise;
  PoseIterationMonitor &           m_Monitor;
};
} // namespace itk

#endif
