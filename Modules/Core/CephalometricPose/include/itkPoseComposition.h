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
#ifndef itkPoseComposition_h
#define itkPoseComposition_h

#include "CephalometricPoseExport.h"
#include "itkPoseTypes.h"

#include <array>

namespace itk
{
/** \class PoseComposition
 * \brief The pose of a body in a view for which the head was moved: first the body's pose, then the head's.
 *
 *   c = R(move) (R(pose) p + t(pose)) + t(move)
 *
 * Both are pitch, roll, yaw (rad), tx, ty, tz (mm), as in PoseParameters. What comes out is again such a pose, and its
 * derivatives by those of both. Near a roll of 90 degrees, where pitch and yaw turn about one axis, there are none; no
 * head comes there.
 *
 * \ingroup CephalometricPose
 */
class CephalometricPose_EXPORT PoseComposition
{
public:
  using SixType = std::array<double, 6>;
  /** Both as three angles (rad) and three shifts (mm). */
  PoseComposition(const SixType & pose, const SixType & move);
  /** The body's pose, as it was given. */
  const SixType &
  GetPose() const
  {
    return m_Pose;
  }

  /** d pose / d (the body's pose, the move): 6 x 12, row-major. */
  const std::array<double, 72> &
  GetJacobian() const
  {
    return m_Jacobian;
  }

private:
  SixType                m_Pose;
  std::array<double, 72> m_Jacobian;
};
} // namespace itk

#endif
