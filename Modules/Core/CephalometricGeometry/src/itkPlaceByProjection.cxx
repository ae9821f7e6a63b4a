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
#include "itkPlaceByProjection.h"

#include "vnl/algo/vnl_determinant.h"

#include <cmath>

namespace itk
{
void
PlaceByProjection(const std::array<double, 12> & matrix, CephalometricGeometry * geometry)
{
  using VectorType = CephalometricGeometry::VectorType;
  VectorType   rows[3];
  double       last[3];
  const double norm = std::hypot(matrix[8], matrix[9], matrix[10]);
  // A homogeneous matrix has any sign and size: its depth is to be in mm, and positive at the object's origin.
  const double factor = (matrix[11] < 0.0 ? -1.0 : 1.0) / norm;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      rows[row][d] = factor * matrix[4 * row + d];
    }
    last[row] = factor * matrix[4 * row + 3];
  }
  // The rows are K times those of a rotation: K upper triangular, with focal lengths in pixels and the principal point.
  const VectorType &                    depth = rows[2];
  CephalometricGeometry::PixelIndexType principal;
  principal[0] = rows[0] * depth;
  principal[1] = rows[1] * depth;
  const VectorType down = rows[1] - depth * principal[1];
  const double     downLength = down.GetNorm();
  VectorType       right = rows[0] - depth * principal[0];
  const double     skew = (right * down) / (downLength * downLength);
  right -= down * skew;
  const double rightLength = right.GetNorm();
  if (!std::isfinite(rightLength * downLength * last[0] * last[1]) || !(last[2] > 0.0) || !(rightLength > 0.0))
  {
    itkGenericExceptionMacro(
      "The matrix is no projection: it has no source in front of which the object's origin lies.");
  }
  CephalometricGeometry::PixelSpacingType spacing;
  spacing[0] = geometry->GetSourceToDetectorDistance() / rightLength;
  spacing[1] = geometry->GetSourceToDetectorDistance() / downLength;
  // The rotation's rows: along the film, along the ray, and up.
  const unsigned int                  film = geometry->GetFilmAxis();
  CephalometricGeometry::RotationType rotation;
  for (unsigned int d = 0; d < 3; ++d)
  {
    rotation(film, d) = right[d] / rightLength;
    rotation(1 - film, d) = geometry->GetSourceSign() * depth[d];
    rotation(2, d) = -down[d] / downLength;
  }
  const bool isMirrored = vnl_determinant(rotation.GetVnlMatrix()) < 0.0;
  if (isMirrored)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      rotation(film, d) = -rotation(film, d);
    }
  }
  const double downLast = last[1] - principal[1] * last[2];
  const double rightLast = last[0] - principal[0] * last[2] - skew * downLast;
  VectorType   translation;
  translation[film] = (isMirrored ? -1.0 : 1.0) * rightLast / rightLength;
  translation[1 - film] = geometry->GetSourceSign() * (last[2] - geometry->GetSourceToMidsagittalDistance());
  translation[2] = -downLast / downLength;
  if (geometry->GetDirection() == CephalometricGeometry::DirectionEnum::Lateral)
  {
    geometry->SetFacing(isMirrored ? CephalometricGeometry::FacingEnum::Left
                                   : CephalometricGeometry::FacingEnum::Right);
  }
  else
  {
    geometry->SetPatientLeft(isMirrored ? CephalometricGeometry::PatientLeftEnum::Left
                                        : CephalometricGeometry::PatientLeftEnum::Right);
  }
  geometry->SetPixelSpacing(spacing);
  geometry->SetPrincipalPoint(principal);
  geometry->SetPose(rotation, translation);
}
} // namespace itk
