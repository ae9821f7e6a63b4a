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
#ifndef itkPoseStateBlocks_h
#define itkPoseStateBlocks_h

#include "PoseMetricExport.h"
#include "itkPoseTypes.h"
#include "itkRegistrationState.h"

#include <string>

namespace itk
{
/** \class PoseStateBlocks
 * \brief The blocks of a registration's state that metrics of a pose read.
 *
 * A pose is of a body (both jaws in occlusion, or one jaw), the scale of a view. Units: rad and mm. An optimizer sees
 * millimetres: angles and the log scale are multiplied by an arm of 64 mm, some distance of a tooth from the origin.
 * The longest steps are what the linearisation of a silhouette was seen to hold for.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseStateBlocks
{
public:
  /** mm an angle or a log scale is multiplied by; a power of two, so that scaling there and back changes no bit. */
  static constexpr double Arm = 64.0;

  /** pitch, roll, yaw (rad), tx, ty, tz (mm). */
  static RegistrationState::BlockType
  MakePose(const std::string & name = "pose");

  /** kappa: the log of the factor on the geometry's magnification. */
  static RegistrationState::BlockType
  MakeScale(const std::string & name = "scale");

  /** The names of the blocks of a further view: how the head was moved for it, and its scale. */
  static std::string
  MakeMoveName(const std::string & view);
  static std::string
  MakeScaleName(const std::string & view);
};
} // namespace itk

#endif
