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
#ifndef itkPoseGroupRegistration_h
#define itkPoseGroupRegistration_h

#include "itkPoseIterationMonitor.h"
#include "itkPosePriors.h"
#include "itkPoseRegistrationTypes.h"
#include "itkPoseStart.h"

#include "itkLeastSquaresSumMetricv4.h"
#include "itkObjectToObjectOptimizerBase.h"
#include "itkResidualNoiseModel.h"
#include "itkRobustKernel.h"

#include "vnl/vnl_matrix.h"

#include <functional>
#include <string>
#include <vector>

namespace itk
{
/** Registers one group of jaws that share a pose: global start, refinement of the candidates, choice, covariance. Works
 * on clones of a metric and an optimizer, a candidate each. */
class PoseGroupRegistration
{
public:
  using MetricType = LeastSquaresSumMetricv4;
  using OptimizerType = ObjectToObjectOptimizerBaseTemplate<double>;
  using PositionType = MetricType::PositionType;

  /** What a user has put in place of the options' kernel and noise models; null: those of the options. */
  struct PartsType
  {
    RobustKernel::ConstPointer       robustKernel;
    ResidualNoiseModel::ConstPointer noiseModel;
    ResidualNoiseModel::ConstPointer covarianceNoiseModel;
  };

  /** \param metric  the sum with its priors, initialized, where the search begins.
   *  \param stages  called in the calling thread where a stage begins. */
  PoseGroupRegistration(const PoseRegistrationOptions &            options,
                        bool                                       pixelSpacingKnown,
                        MetricType *                               metric,
                        const PartsType &                          parts,
                        OptimizerType *                            optimizer,
                        const PoseStart *                          start,
                        PoseIterationMonitor &                     monitor,
                        const std::function<void(PoseStageEnum)> & stages,
                        unsigned int                               group,
                        bool                                       hypothesis);

  /** Fills in all but jaws and hypotheses. \return false on abort. */
  bool
  Run(PoseGroupResult & group);

  /** The metric at the solution, in all its free parameters; valid after Run(). */
  MetricType *
  GetMetric() const
  {
    return m_Metric;
  }
  const PositionType &
  GetSolution() const
  {
    return m_Solution;
  }

  /** Minus twice the log likelihood of the evidence at a solution of the metric that found it, for the comparison of
   * models: a point that fits nowhere counts against a model, it does not drop out. */
  static double
  ComputeDeviance(const MetricType & metric, const PositionType & solution);

  /** The robust criterion at a solution with the noise of another metric, so that two that are about the same drawings
   * can be compared: what fits nowhere costs what the kernel charges. */
  static double
  ComputeCriterion(const MetricType & metric, const PositionType & solution, const MetricType & noise);

private:
  /** A pose on its way. */
  struct CandidateType
  {
    PositionType       x;
    ContourNoiseLevels noise;
    unsigned int       evaluations{ 0 };
    bool               converged{ false };
    std::string        stopCondition;
    double             cost{ 1.0 };
    double             codeTerm{ 0.0 };
    double             score{ 1.0 };
    double             deviance{ 0.0 };
  };
  /** How a candidate is refined. */
  struct ScheduleType
  {
    std::vector<double> widths;
    unsigned int        maximumEvaluations{ 14 };
    double              tolerance{ 0.005 };
    bool                similarityOnly{ false };
    bool                correlated{ true };
    bool                estimateNoise{ true };
    /** Near the end already: the noise is estimated before the first step, and no width comes before its own. */
    bool          isNear{ false };
    PoseStageEnum stage{ PoseStageEnum::Refinement };
  };

  std::vector<CandidateType>
  StartsAt(double yaw, unsigned int index, unsigned int & evaluations) const;
  void
  Refine(MetricType & metric, const ScheduleType & schedule, unsigned int index, CandidateType & candidate) const;
  void
  Score(const MetricType & metric, CandidateType & candidate) const;
  /** The best ones that lie further than a distance from each other. */
  std::vector<CandidateType>
  SelectDistinct(const MetricType &                 metric,
                 const std::vector<CandidateType> & sorted,
                 double                             distance,
                 std::size_t                        maximum) const;
  double
  Distance(const MetricType & metric, const PositionType & from, const PositionType & to) const;
  /** Puts a metric where a candidate ended, with its noise. */
  void
  Settle(MetricType & metric, const CandidateType & candidate) const;
  /** The kernel's width that is of the noise. */
  double
  GetOwnWidth(const ContourNoiseLevels & noise) const;
  /** Minus twice the logarithm of what a minimum weighs: its posterior, with the mass about it.
   * \param width  of the kernel that tells which points are no part of the evidence. */
  double
  ComputePosterior(const CandidateType & candidate, double width) const;
  /** Of the minima together, each by its weight. */
  vnl_matrix<double>
  ComputeCovariance(const MetricType & reference, const std::vector<CandidateType> & pool) const;
  using JoinsEnum = LeastSquaresMetricv4::JoinsEnum;
  /** Without the terms that join later. */
  MetricType::Pointer
  CloneForStage(JoinsEnum stage) const;
  MetricType::Pointer
  CloneAt(const PositionType & x, JoinsEnum stage = JoinsEnum::Refinement) const;
  CandidateType
  MakeCandidate(const PositionType & x) const;

  PoseRegistrationOptions            m_Options;
  bool                               m_PixelSpacingKnown;
  MetricType::Pointer                m_Metric;
  OptimizerType::Pointer             m_Optimizer;
  PoseStart::ConstPointer            m_Start;
  PoseIterationMonitor &             m_Monitor;
  std::function<void(PoseStageEnum)> m_Stages;
  unsigned int                       m_Group;
  bool                               m_Hypothesis;
  PosePriors                         m_Priors;
  ResidualNoiseModel::ConstPointer   m_CovarianceNoise;
  ResidualNoiseModel::ConstPointer   m_CorrelatedNoise;
  ResidualNoiseModel::ConstPointer   m_WhiteNoise;
  PositionType                       m_Solution;
};
} // namespace itk

#endif
