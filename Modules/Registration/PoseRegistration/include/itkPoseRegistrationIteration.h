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
#ifndef itkPoseRegistrationIteration_h
#define itkPoseRegistrationIteration_h

#include "itkPoseTypes.h"

#include "itkContourNoiseModel.h"
#include "itkLeastSquaresIteration.h"

#include <cstdint>

namespace itk
{
/** What a pose registration is at. */
enum class PoseStageEnum : std::uint8_t
{
  /** Starts, refined as similarities with the contour held. */
  Start,
  /** A few steps of each candidate in all degrees of freedom. */
  Candidates,
  /** The candidates that are left, to the end. */
  Refinement,
  /** Covariance, then other hypotheses where they are tried. */
  Uncertainty
};

/** \struct PoseRegistrationIteration
 * \brief A tried step of one candidate, as observers of PoseRegistrationMethod see it.
 * \ingroup PoseRegistration
 */
struct PoseRegistrationIteration
{
  /** Jaws with a pose of their own are groups, one after the other. */
  unsigned int  group{ 0 };
  PoseStageEnum stage{ PoseStageEnum::Start };
  /** Which of the candidates of the stage, in the start one for each yaw and start; candidates are refined at the same
   * time and their steps may alternate. */
  unsigned int candidate{ 0 };
  /** A step of a hypothesis that is tried beside the result, as the other side. */
  bool hypothesis{ false };
  /** Best position so far. */
  PoseParameters pose{ {} };
  /** The step: value, whether accepted, how long (px), how many so far of this candidate in this stage. */
  LeastSquaresIteration step;
  /** Of the criterion that the value is of, px of 0.25 mm. */
  double             kernelWidth{ 0.0 };
  ContourNoiseLevels noise;
};
} // namespace itk

#endif
