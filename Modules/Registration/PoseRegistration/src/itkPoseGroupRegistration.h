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

#include "itkPoseEstimator.h"

#include <vector>

namespace itk
{
/** Registers one group of jaws that share a pose: global start, refinement of the candidates, choice. */
class PoseGroupRegistration
{
public:
  PoseGroupRegistration(const PoseGeometry &          geometry,
                        const PoseRegistrationOptions & options,
                        std::vector<PoseStrand>       strands)
    : m_Options(options)
    , m_Estimator(geometry, options, std::move(strands))
  {}

  /** \return false on abort. */
  bool
  Run(PoseGroupResult & group);

  const PoseEstimator &
  GetEstimator() const
  {
    return m_Estimator;
  }

private:
  std::vector<PoseState>
  StartsAt(double yaw, unsigned int & evaluations) const;

  std::vector<PoseState>
  Distinct(const std::vector<PoseState> & states, double distance, std::size_t maximum) const;

  bool
  Aborted(double progress) const
  {
    return m_Options.progress && m_Options.progress(progress);
  }

  PoseRegistrationOptions    m_Options;
  PoseEstimator            m_Estimator;
  std::vector<PoseContour> m_Reference;
  PoseParameters           m_ReferencePose{ {} };
};
} // namespace itk

#endif
