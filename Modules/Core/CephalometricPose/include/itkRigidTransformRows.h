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
#ifndef itkRigidTransformRows_h
#define itkRigidTransformRows_h

#include "itkPoseTypes.h"

#include "itkMatrixOffsetTransformBase.h"
#include "itkVersorRigid3DTransform.h"

#include <array>

// A rigid transform q = R p + t as files and results have it, [R | t] row by row, and as everything else has it: what
// leads from one to the other stands here and nowhere else.
namespace itk
{
/** Row-major 3x4. */
using RigidTransformRows = std::array<double, 12>;

/** From a matrix that is read as rotation(row, column), and a vector. */
template <typename TMatrix, typename TVector>
RigidTransformRows
MakeRigidTransformRows(const TMatrix & rotation, const TVector & translation)
{
  RigidTransformRows rows{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      rows[4 * row + column] = rotation(row, column);
    }
    rows[4 * row + 3] = translation[row];
  }
  return rows;
}

/** The other way about. */
template <typename TMatrix, typename TVector>
void
SplitRigidTransformRows(const RigidTransformRows & rows, TMatrix & rotation, TVector & translation)
{
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      rotation(row, column) = rows[4 * row + column];
    }
    translation[row] = rows[4 * row + 3];
  }
}

/** The same of a row-major 3x3 in one array, as kernels have it. */
inline RigidTransformRows
MakeRigidTransformRows(const std::array<double, 9> & rotation, const std::array<double, 3> & translation)
{
  return MakeRigidTransformRows([&](unsigned int row, unsigned int column) { return rotation[3 * row + column]; },
                                translation);
}

inline void
SplitRigidTransformRows(const RigidTransformRows & rows,
                        std::array<double, 9> &    rotation,
                        std::array<double, 3> &    translation)
{
  const auto element = [&](unsigned int row, unsigned int column) -> double & { return rotation[3 * row + column]; };
  SplitRigidTransformRows(rows, element, translation);
}

inline RigidTransformRows
ToRows(const MatrixOffsetTransformBase<double, 3, 3> & transform)
{
  return MakeRigidTransformRows(transform.GetMatrix(), transform.GetOffset());
}

/** Throws where the rotation is off by more than the tolerance (ITK's own is 1e-10). */
inline VersorRigid3DTransform<double>::Pointer
ToRigidTransform(const RigidTransformRows & rows, double tolerance)
{
  VersorRigid3DTransform<double>::MatrixType rotation;
  VersorRigid3DTransform<double>::OffsetType offset;
  SplitRigidTransformRows(rows, rotation, offset);
  auto transform = VersorRigid3DTransform<double>::New();
  transform->SetMatrix(rotation, tolerance);
  transform->SetOffset(offset);
  return transform;
}

/** Mesh to dental frame: q = R (p - o), t = -R o. */
inline RigidTransformRows
ToRows(const PoseFrame & frame)
{
  std::array<double, 3> translation{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      translation[row] -= frame.rotation[3 * row + column] * frame.origin[column];
    }
  }
  return MakeRigidTransformRows(frame.rotation, translation);
}

/** The other way about: o = -R' t. */
inline PoseFrame
ToPoseFrame(const RigidTransformRows & rows)
{
  PoseFrame             frame;
  std::array<double, 3> translation;
  SplitRigidTransformRows(rows, frame.rotation, translation);
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      frame.origin[column] -= frame.rotation[3 * row + column] * translation[row];
    }
  }
  return frame;
}

/** The frame of a rigid transform from the mesh to it, as UMidlineDentalAxisFilter gives one. */
inline PoseFrame
ToPoseFrame(const MatrixOffsetTransformBase<double, 3, 3> & transform)
{
  return ToPoseFrame(ToRows(transform));
}
} // namespace itk

#endif
