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

#include "itkCandidatePosterior.h"
#include "itkCandidateRefinement.h"
#include "itkPoseIterationMonitor.h"
#include "itkPosePriors.h"
#include "itkPoseRegistrationTypes.h"
#include "itkPoseStart.h"

#include "itkLeastSquaresSumMetricv4.h"
#include "itkObjectToObjectOptimizerBase.h"
#include "itkResidualNoiseModel.h"
#include "itkRobustKernel.h"

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
  ITK_DISALLOW_COPY_AND_MOVE(PoseGroupRegistration);

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

private:
  std::vector<RefinedCandidate>
  StartsAt(double yaw, unsigned int index, unsigned int & evaluations) const;
  /** The best ones that lie further than a distance from each other. */
  std::vector<RefinedCandidate>
  SelectDistinct(const MetricType &                    metric,
                 const std::vector<RefinedCandidate> & sorted,
                 double                                distance,
                 std::size_t                           maximum) const;
  using JoinsEnum = LeastSquaresMetricv4::JoinsEnum;
  /** Without the terms that join later. */
  MetricType::Pointer
  CloneForStage(JoinsEnum stage) const;
  MetricType::Pointer
  CloneAt(const PositionType & x, JoinsEnum stage = JoinsEnum::Refinement) const;
  RefinedCandidate
  MakeCandidate(const PositionType & x) const;

  PoseRegistrationOptions            m_Options;
  bool                               m_PixelSpacingKnown;
  MetricType::Pointer                m_Metric;
  OptimizerType::Pointer             m_Optimizer;
  PoseStart::ConstPointer            m_Start;
  PoseIterationMonitor &             m_Monitor;
  std::function<void(PoseStageEnum)> m_Stages;
  bool                               m_Hypothesis;
  PosePriors                         m_Priors;
  ResidualNoiseModel::ConstPointer   m_CovarianceNoise;
  ResidualNoiseModel::ConstPointer   m_CorrelatedNoise;
  CandidateRefinement                m_Refinement;
  CandidatePosterior                 m_Posterior;
  PositionType                       m_Solution;
};
} // namespace itk

#endif
