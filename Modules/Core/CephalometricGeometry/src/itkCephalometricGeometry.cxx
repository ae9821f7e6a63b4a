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
#include "itkCephalometricGeometry.h"

#include "itkMath.h"

#include <cmath>

namespace itk
{
std::ostream &
operator<<(std::ostream & os, CephalometricGeometry::SourceSideEnum side)
{
  return os << (side == CephalometricGeometry::SourceSideEnum::Right ? "Right" : "Left");
}

std::ostream &
operator<<(std::ostream & os, CephalometricGeometry::FacingEnum facing)
{
  return os << (facing == CephalometricGeometry::FacingEnum::Right ? "Right" : "Left");
}

std::ostream &
operator<<(std::ostream & os, CephalometricGeometry::DirectionEnum direction)
{
  return os << (direction == CephalometricGeometry::DirectionEnum::Lateral ? "Lateral" : "Frontal");
}

std::ostream &
operator<<(std::ostream & os, CephalometricGeometry::FrontalSourceEnum source)
{
  return os << (source == CephalometricGeometry::FrontalSourceEnum::Behind ? "Behind" : "InFront");
}

std::ostream &
operator<<(std::ostream & os, CephalometricGeometry::PatientLeftEnum side)
{
  return os << (side == CephalometricGeometry::PatientLeftEnum::Right ? "Right" : "Left");
}

CephalometricGeometry::CephalometricGeometry()
{
  m_PrincipalPoint.Fill(0.0);
  m_PixelSpacing.Fill(0.0);
  m_PoseRotation.SetIdentity();
  m_PoseTranslation.Fill(0.0);
}

bool
CephalometricGeometry::HasPixelSpacing() const
{
  return m_PixelSpacing[0] > 0.0 && m_PixelSpacing[1] > 0.0;
}

void
CephalometricGeometry::SetPose(const RotationType & rotation, const VectorType & translation)
{
  const RotationType product = RotationType(rotation.GetTranspose()) * rotation;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      if (!(std::abs(product(row, column) - (row == column ? 1.0 : 0.0)) < 1e-6))
      {
        itkExceptionMacro("The pose's rotation is not orthonormal:\n"
                          << rotation << "Give a rigid pose; scale belongs to the mesh unit or the spacing.");
      }
    }
  }
  if (vnl_determinant(rotation.GetVnlMatrix()) < 0.0)
  {
    itkExceptionMacro("The pose mirrors the object. Facing belongs in SetFacing(), not in the pose.");
  }
  for (const double component : translation)
  {
    if (!std::isfinite(component))
    {
      itkExceptionMacro("The pose's translation " << translation << " is not finite.");
    }
  }
  if (m_PoseRotation != rotation || m_PoseTranslation != translation)
  {
    m_PoseRotation = rotation;
    m_PoseTranslation = translation;
    this->Modified();
  }
}

void
CephalometricGeometry::SetPoseToIdentity()
{
  RotationType identity;
  identity.SetIdentity();
  this->SetPose(identity, VectorType(0.0));
}

double
CephalometricGeometry::GetSourceSign() const
{
  const bool isPositive = m_Direction == DirectionEnum::Lateral ? m_SourceSide == SourceSideEnum::Right
                                                                : m_FrontalSource == FrontalSourceEnum::Behind;
  return isPositive ? 1.0 : -1.0;
}

double
CephalometricGeometry::GetFacingSign() const
{
  const bool isPositive =
    m_Direction == DirectionEnum::Lateral ? m_Facing == FacingEnum::Right : m_PatientLeft == PatientLeftEnum::Right;
  return isPositive ? 1.0 : -1.0;
}

unsigned int
CephalometricGeometry::GetFilmAxis() const
{
  return m_Direction == DirectionEnum::Lateral ? 0 : 1;
}

void
CephalometricGeometry::VerifyComplete() const
{
  if (!this->HasPixelSpacing())
  {
    itkExceptionMacro("The pixel spacing is "
                      << m_PixelSpacing
                      << ": call SetPixelSpacing() with mm a pixel in the detector plane, both > 0. "
                         "An unknown spacing has to be estimated, never assumed.");
  }
  if (!(m_SourceToMidsagittalDistance > 0.0) || !(m_SourceToDetectorDistance > m_SourceToMidsagittalDistance) ||
      !std::isfinite(m_SourceToDetectorDistance))
  {
    itkExceptionMacro("The source-to-midsagittal distance "
                      << m_SourceToMidsagittalDistance
                      << " mm must be positive and smaller than the source-to-detector "
                         "distance "
                      << m_SourceToDetectorDistance << " mm.");
  }
}

auto
CephalometricGeometry::TransformToCephalostat(const PointType & point) const -> PointType
{
  return m_PoseRotation * point + m_PoseTranslation;
}

double
CephalometricGeometry::GetMagnification(const PointType & point) const
{
  const PointType c = this->TransformToCephalostat(point);
  const double    depth = m_SourceToMidsagittalDistance + this->GetSourceSign() * c[1 - this->GetFilmAxis()];
  if (!(depth > 0.0))
  {
    itkExceptionMacro("The point " << point << " lies " << -depth
                                   << " mm behind the X-ray source. Check the mesh's unit and the pose.");
  }
  return m_SourceToDetectorDistance / depth;
}

auto
CephalometricGeometry::ProjectPoint(const PointType & point) const -> PixelIndexType
{
  if (!this->HasPixelSpacing())
  {
    this->VerifyComplete();
  }
  const double    m = this->GetMagnification(point);
  const PointType c = this->TransformToCephalostat(point);
  PixelIndexType  index;
  index[0] = m_PrincipalPoint[0] + this->GetFacingSign() * m * c[this->GetFilmAxis()] / m_PixelSpacing[0];
  index[1] = m_PrincipalPoint[1] - m * c[2] / m_PixelSpacing[1];
  return index;
}

namespace
{
/** d(u, v) / d(cephalostat point). */
CephalometricGeometry::PointJacobianType
CephalostatJacobian(const CephalometricGeometry & geometry, const CephalometricGeometry::PointType & c, double m)
{
  const double       k = geometry.GetSourceSign();
  const double       f = geometry.GetFacingSign();
  const auto &       spacing = geometry.GetPixelSpacing();
  const unsigned int film = geometry.GetFilmAxis();
  const unsigned int ray = 1 - film;
  // dm/d(depth) = -k m^2 / D
  const double                             dm = -k * m * m / geometry.GetSourceToDetectorDistance();
  CephalometricGeometry::PointJacobianType jacobian;
  jacobian(0, film) = f * m / spacing[0];
  jacobian(0, ray) = f * dm * c[film] / spacing[0];
  jacobian(0, 2) = 0.0;
  jacobian(1, film) = 0.0;
  jacobian(1, ray) = -dm * c[2] / spacing[1];
  jacobian(1, 2) = -m / spacing[1];
  return jacobian;
}
} // namespace

auto
CephalometricGeometry::ComputePointJacobian(const PointType & point) const -> PointJacobianType
{
  this->VerifyComplete();
  const PointJacobianType jacobian =
    CephalostatJacobian(*this, this->TransformToCephalostat(point), this->GetMagnification(point));
  return PointJacobianType((jacobian.GetVnlMatrix() * m_PoseRotation.GetVnlMatrix()));
}

auto
CephalometricGeometry::ComputePoseJacobian(const PointType & point) const -> PoseJacobianType
{
  this->VerifyComplete();
  const PointType         c = this->TransformToCephalostat(point);
  const PointJacobianType jacobian = CephalostatJacobian(*this, c, this->GetMagnification(point));
  PoseJacobianType        result;
  // A small rotation w moves c by w x c.
  const double cross[3][3] = { { 0.0, -c[2], c[1] }, { c[2], 0.0, -c[0] }, { -c[1], c[0], 0.0 } };
  for (unsigned int row = 0; row < 2; ++row)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      double sum = 0.0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        sum += jacobian(row, d) * cross[axis][d];
      }
      result(row, axis) = sum;
      result(row, 3 + axis) = jacobian(row, axis);
    }
  }
  return result;
}

auto
CephalometricGeometry::GetSourcePosition() const -> PointType
{
  VectorType source(0.0);
  source[1 - this->GetFilmAxis()] = -this->GetSourceSign() * m_SourceToMidsagittalDistance;
  const VectorType inObject = RotationType(m_PoseRotation.GetTranspose()) * (source - m_PoseTranslation);
  PointType        position;
  for (unsigned int d = 0; d < 3; ++d)
  {
    position[d] = inObject[d];
  }
  return position;
}

auto
CephalometricGeometry::BackProject(const PixelIndexType & index) const -> RayType
{
  this->VerifyComplete();
  VectorType         direction;
  const unsigned int film = this->GetFilmAxis();
  direction[film] = this->GetFacingSign() * (index[0] - m_PrincipalPoint[0]) * m_PixelSpacing[0];
  direction[1 - film] = this->GetSourceSign() * m_SourceToDetectorDistance;
  direction[2] = -(index[1] - m_PrincipalPoint[1]) * m_PixelSpacing[1];
  direction.Normalize();
  RayType ray;
  ray.origin = this->GetSourcePosition();
  ray.direction = RotationType(m_PoseRotation.GetTranspose()) * direction;
  return ray;
}

auto
CephalometricGeometry::GetProjectionMatrix() const -> ProjectionMatrixType
{
  this->VerifyComplete();
  const double k = this->GetSourceSign();
  const double f = this->GetFacingSign();
  const double S = m_SourceToMidsagittalDistance;
  const double D = m_SourceToDetectorDistance;
  // Rows over cephalostat coordinates (x, y, z, 1), divided by S so that the last row is 1 where the depth is S.
  const unsigned int film = this->GetFilmAxis();
  double             depth[4] = { 0.0, 0.0, 0.0, 1.0 };
  depth[1 - film] = k / S;
  double rows[3][4] = {};
  for (unsigned int d = 0; d < 4; ++d)
  {
    rows[0][d] = m_PrincipalPoint[0] * depth[d];
    rows[1][d] = m_PrincipalPoint[1] * depth[d];
    rows[2][d] = depth[d];
  }
  rows[0][film] += f * D / (S * m_PixelSpacing[0]);
  rows[1][2] -= D / (S * m_PixelSpacing[1]);
  ProjectionMatrixType matrix;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      double sum = 0.0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        sum += rows[row][d] * m_PoseRotation(d, column);
      }
      matrix(row, column) = sum;
    }
    double last = rows[row][3];
    for (unsigned int d = 0; d < 3; ++d)
    {
      last += rows[row][d] * m_PoseTranslation[d];
    }
    matrix(row, 3) = last;
  }
  return matrix;
}

PerspectiveProjection
CephalometricGeometry::GetProjection() const
{
  const ProjectionMatrixType matrix = this->GetProjectionMatrix();
  const PointType            source = this->GetSourcePosition();
  PerspectiveProjection      projection;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 4; ++column)
    {
      projection.matrix[4 * row + column] = matrix(row, column);
    }
    projection.source[row] = source[row];
  }
  return projection;
}

void
CephalometricGeometry::CopyParameters(const Self * other)
{
  if (other == nullptr)
  {
    itkExceptionMacro("CopyParameters() needs a geometry, not a null pointer.");
  }
  this->SetDirection(other->m_Direction);
  this->SetFrontalSource(other->m_FrontalSource);
  this->SetPatientLeft(other->m_PatientLeft);
  this->SetSourceToMidsagittalDistance(other->m_SourceToMidsagittalDistance);
  this->SetSourceToDetectorDistance(other->m_SourceToDetectorDistance);
  this->SetSourceSide(other->m_SourceSide);
  this->SetFacing(other->m_Facing);
  this->SetPrincipalPoint(other->m_PrincipalPoint);
  this->SetPixelSpacing(other->m_PixelSpacing);
  this->SetPose(other->m_PoseRotation, other->m_PoseTranslation);
}

void
CephalometricGeometry::Graft(const DataObject * data)
{
  const auto * geometry = dynamic_cast<const Self *>(data);
  if (geometry == nullptr)
  {
    itkExceptionMacro("Graft() needs a CephalometricGeometry.");
  }
  this->CopyParameters(geometry);
}

void
CephalometricGeometry::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Direction: " << m_Direction << std::endl;
  os << indent << "SourceToMidsagittalDistance: " << m_SourceToMidsagittalDistance << std::endl;
  os << indent << "SourceToDetectorDistance: " << m_SourceToDetectorDistance << std::endl;
  os << indent << "SourceSide: " << m_SourceSide << std::endl;
  os << indent << "Facing: " << m_Facing << std::endl;
  os << indent << "FrontalSource: " << m_FrontalSource << std::endl;
  os << indent << "PatientLeft: " << m_PatientLeft << std::endl;
  os << indent << "PrincipalPoint: " << m_PrincipalPoint << std::endl;
  os << indent << "PixelSpacing: " << m_PixelSpacing << std::endl;
  os << indent << "PoseRotation: " << std::endl << m_PoseRotation;
  os << indent << "PoseTranslation: " << m_PoseTranslation << std::endl;
}
} // namespace itk
