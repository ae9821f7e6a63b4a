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
#include "itkPoseComposition.h"

#include "itkPoseModel.h"

#include "itkMatrix.h"
#include "itkVector.h"

#include <cmath>

namespace itk
{
namespace
{
using Matrix3 = Matrix<double, 3, 3>;
using Vector3 = Vector<double, 3>;

Matrix3
MakeRotation(const PoseComposition::SixType & pose)
{
  const PoseModel model(PoseGeometry(), { { pose[PosePitch], pose[PoseRoll], pose[PoseYaw], 0.0, 0.0, 0.0, 0.0 } });
  Matrix3         rotation;
  for (unsigned int i = 0; i < 9; ++i)
  {
    rotation(i / 3, i % 3) = model.GetRotation()[i];
  }
  return rotation;
}

/** What a change of pitch, roll and yaw turns by, about the fixed axes: its columns are the axes that they turn about,
 * of which the later rotations have carried the earlier ones along. */
Matrix3
MakeTurningAxes(const PoseComposition::SixType & pose)
{
  const double cp = std::cos(pose[PosePitch]), sp = std::sin(pose[PosePitch]);
  const double cr = std::cos(pose[PoseRoll]), sr = std::sin(pose[PoseRoll]);
  Matrix3      axes;
  // y; Ry x; Ry Rx z.
  axes(0, 0) = 0.0;
  axes(1, 0) = 1.0;
  axes(2, 0) = 0.0;
  axes(0, 1) = cp;
  axes(1, 1) = 0.0;
  axes(2, 1) = -sp;
  axes(0, 2) = sp * cr;
  axes(1, 2) = -sr;
  axes(2, 2) = cp * cr;
  return axes;
}
} // namespace

PoseComposition::PoseComposition(const SixType & pose, const SixType & move)
  : m_Jacobian{}
{
  const Matrix3 own = MakeRotation(pose);
  const Matrix3 head = MakeRotation(move);
  const Matrix3 rotation = head * own;
  Vector3       shift;
  for (unsigned int d = 0; d < 3; ++d)
  {
    shift[d] = pose[PoseTx + d];
  }
  const Vector3 carried = head * shift;

  std::array<double, 9> rows{};
  for (unsigned int i = 0; i < 9; ++i)
  {
    rows[i] = rotation(i / 3, i % 3);
  }
  const auto angles = PoseModel::FindAngles(rows);
  m_Pose[PosePitch] = angles[0];
  m_Pose[PoseRoll] = angles[1];
  m_Pose[PoseYaw] = angles[2];
  for (unsigned int d = 0; d < 3; ++d)
  {
    m_Pose[PoseTx + d] = carried[d] + move[PoseTx + d];
  }

  // The head turns by its own change and by what it carries of the body's: axes(pose') d angles' = axes(move) d move
  // + R(move) axes(pose) d pose.
  const Matrix3 moveAxes = MakeTurningAxes(move);
  const Matrix3 toAngles(MakeTurningAxes(m_Pose).GetInverse());
  const Matrix3 byMove = toAngles * moveAxes;
  const Matrix3 byPose = toAngles * head * MakeTurningAxes(pose);
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int k = 0; k < 3; ++k)
    {
      m_Jacobian[12 * i + k] = byPose(i, k);
      m_Jacobian[12 * i + 6 + k] = byMove(i, k);
      m_Jacobian[12 * (3 + i) + 3 + k] = head(i, k);
      m_Jacobian[12 * (3 + i) + 9 + k] = i == k ? 1.0 : 0.0;
    }
  }
  // A turn of the head about an axis w takes what it carries along by w x carried.
  for (unsigned int k = 0; k < 3; ++k)
  {
    const Vector3 axis(std::array<double, 3>{ { moveAxes(0, k), moveAxes(1, k), moveAxes(2, k) } }.data());
    const Vector3 motion = CrossProduct(axis, carried);
    for (unsigned int i = 0; i < 3; ++i)
    {
      m_Jacobian[12 * (3 + i) + 6 + k] = motion[i];
    }
  }
}
} // namespace itk
