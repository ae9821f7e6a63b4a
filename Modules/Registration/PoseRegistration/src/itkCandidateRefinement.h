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
#ifndef itkCandidateRefinement_h
#define itkCandidateRefinement_h

#include "itkPoseIterationMonitor.h"
#include "itkPosePriors.h"
#include "itkPoseRegistrationTypes.h"
#include "itkRefinedCandidate.h"
#include "itkRefinementSchedule.h"

#include "itkLeastSquaresSumMetricv4.h"
#include "itkObjectToObjectOptimizerBase.h"
#include "itkResidualNoiseModel.h"

namespace itk
{
/** \class CandidateRefinement
 * \brief Takes one candidate to a minimum: an optimizer's steps, and between them the kernel's width, the noise's
 * levels and what is matched, which the metric holds while the optimizer runs.
 *
 * Our own optimizer runs once a step, on a clone; any other v4 optimizer runs to its own end once a width, on the one
 * object that it is. Each step is told to the monitor.
 * \ingroup PoseRegistration
 */
class CandidateRefinement
{
public:
  using MetricType = LeastSquaresSumMetricv4;
  using OptimizerType = ObjectToObjectOptimizerBaseTemplate<double>;

  /** \param correlatedNoise  the model where the schedule wants one; independent noise otherwise.
   *  \param group, hypothesis  what the monitor is told that the steps are of. */
  CandidateRefinement(const PoseRegistrationOptions &          options,
                      const PosePriors &                       priors,
                      const ResidualNoiseModel::ConstPointer & correlatedNoise,
                      OptimizerType *                          optimizer,
                      PoseIterationMonitor &                   monitor,
                      unsigned int                             group,
                      bool                                     hypothesis);

  /** From the candidate's place to a minimum, in place.
   * \param index  the candidate's number among those of its stage, for the monitor. */
  void
  Run(MetricType & metric, const RefinementSchedule & schedule, unsigned int index, RefinedCandidate & candidate) const;

  /** Puts a metric where a candidate ended, with its noise and all that the priors leave free. */
  void
  Settle(MetricType & metric, const RefinedCandidate & candidate) const;

  /** The kernel's width that is of the noise, px. */
  double
  GetOwnWidth(const ContourNoiseLevels & noise) const;

private:
  void
  Score(const MetricType & metric, RefinedCandidate & candidate) const;

  PoseRegistrationOptions          m_Options;
  PosePriors                       m_Priors;
  ResidualNoiseModel::ConstPointer m_CorrelatedNoise;
  ResidualNoiseModel::ConstPointer m_WhiteNoise;
  OptimizerType::Pointer           m_Optimizer;
  PoseIterationMonitor &           m_Monitor;
  unsigned int                     m_Group;
  bool                             m_Hypothesis;
};
} // namespace itk

#endif
