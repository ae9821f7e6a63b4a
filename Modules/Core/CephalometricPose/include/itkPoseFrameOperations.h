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
#ifndef itkPoseFrameOperations_h
#define itkPoseFrameOperations_h

#include "itkPoseTypes.h"

#include "itkMatrixOffsetTransformBase.h"

#include <array>

// Points and motions between a mesh and its dental frame, p_dental = rotation (p_mesh - origin), mm. A frame is made of
// a transform by itkRigidTransformRows.h.
namespace itk
{
/** A point of the mesh in the dental frame. */
inline std::array<double, 3>
ToDentalFrame(const PoseFrame & frame, const std::array<double, 3> & mesh)
{
  const auto &                r = frame.rotation;
  const std::array<double, 3> d{ { mesh[0] - frame.origin[0], mesh[1] - frame.origin[1], mesh[2] - frame.origin[2] } };
  std::array<double, 3>       q;
  for (unsigned int k = 0; k < 3; ++k)
  {
    q[k] = r[3 * k] * d[0] + r[3 * k + 1] * d[1] + r[3 * k + 2] * d[2];
  }
  return q;
}

/** A point of the dental frame in the mesh. */
inline std::array<double, 3>
ToMeshFrame(const PoseFrame & frame, const std::array<double, 3> & dental)
{
  std::array<double, 3> q = frame.origin;
  for (unsigned int a = 0; a < 3; ++a)
  {
    for (unsigned int b = 0; b < 3; ++b)
    {
      q[a] += frame.rotation[3 * b + a] * dental[b];
    }
  }
  return q;
}

/** A rigid motion R p + t of points of the dental frame, as one of points of the mesh. */
inline void
ToMeshMotion(const PoseFrame &             frame,
             const std::array<double, 9> & dentalRotation,
             const std::array<double, 3> & dentalTranslation,
             std::array<double, 9> &       meshRotation,
             std::array<double, 3> &       meshTranslation)
{
  const auto & r = dentalRotation;
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      meshRotation[3 * i + j] =
        r[3 * i] * frame.rotation[j] + r[3 * i + 1] * frame.rotation[3 + j] + r[3 * i + 2] * frame.rotation[6 + j];
    }
    meshTranslation[i] = dentalTranslation[i] - meshRotation[3 * i] * frame.origin[0] -
                         meshRotation[3 * i + 1] * frame.origin[1] - meshRotation[3 * i + 2] * frame.origin[2];
  }
}

/** The other way about, of a transform of points of the mesh. */
inline void
ToDentalMotion(const PoseFrame &                               frame,
               const MatrixOffsetTransformBase<double, 3, 3> & ofMesh,
               std::array<double, 9> &                         dentalRotation,
               std::array<double, 3> &                         dentalTranslation)
{
  const auto & matrix = ofMesh.GetMatrix();
  for (unsigned int row = 0; row < 3; ++row)
  {
    dentalTranslation[row] = ofMesh.GetOffset()[row];
    for (unsigned int column = 0; column < 3; ++column)
    {
      dentalRotation[3 * row + column] = 0.0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        dentalRotation[3 * row + column] += matrix(row, d) * frame.rotation[3 * column + d];
      }
      dentalTranslation[row] += matrix(row, column) * frame.origin[column];
    }
  }
}
} // namespace itk

#endif
