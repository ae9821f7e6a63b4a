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
#include "itkPoseModel.h"

#include <cmath>

namespace itk
{
namespace
{
using Matrix9 = std::array<double, 9>;

Matrix9
Multiply(const Matrix9 & a, const Matrix9 & b)
{
  Matrix9 c{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      c[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
  }
  return c;
}

void
Apply(const Matrix9 & a, const double p[3], double q[3])
{
  for (int i = 0; i < 3; ++i)
  {
    q[i] = a[3 * i] * p[0] + a[3 * i + 1] * p[1] + a[3 * i + 2] * p[2];
  }
}
} // namespace

PoseModel::PoseModel(const PoseGeometry & geometry, const PoseParameters & parameters)
  : m_Geometry(geometry)
  , m_Parameters(parameters)
  , m_Focal(std::exp(parameters[PoseKappa]) * geometry.sourceToDetector / PoseWorkingPixel)
{
  const double  cp = std::cos(parameters[PosePitch]), sp = std::sin(parameters[PosePitch]);
  const double  cr = std::cos(parameters[PoseRoll]), sr = std::sin(parameters[PoseRoll]);
  const double  cy = std::cos(parameters[PoseYaw]), sy = std::sin(parameters[PoseYaw]);
  const Matrix9 ry{ { cp, 0, sp, 0, 1, 0, -sp, 0, cp } };
  const Matrix9 rx{ { 1, 0, 0, 0, cr, -sr, 0, sr, cr } };
  const Matrix9 rz{ { cy, -sy, 0, sy, cy, 0, 0, 0, 1 } };
  const Matrix9 dry{ { -sp, 0, cp, 0, 0, 0, -cp, 0, -sp } };
  const Matrix9 drx{ { 0, 0, 0, 0, -sr, -cr, 0, cr, -sr } };
  const Matrix9 drz{ { -sy, -cy, 0, cy, -sy, 0, 0, 0, 0 } };
  m_Rotation = Multiply(ry, Multiply(rx, rz));
  m_RotationDerivatives = {
    { Multiply(dry, Multiply(rx, rz)), Multiply(ry, Multiply(drx, rz)), Multiply(ry, Multiply(rx, drz)) }
  };
}

bool
PoseModel::Project(const double p[3], double w[2]) const
{
  const unsigned int film = m_Geometry.GetFilmAxis();
  const unsigned int ray = m_Geometry.GetDepthAxis();
  double             c[3];
  Apply(m_Rotation, p, c);
  const double depth = m_Geometry.sourceToMidsagittal + m_Geometry.sourceSign * (c[ray] + m_Parameters[PoseTx + ray]);
  const double m = m_Focal / depth;
  w[0] = m * (c[film] + m_Parameters[PoseTx + film]);
  w[1] = -m * (c[2] + m_Parameters[PoseTz]);
  return depth > 0.0;
}

bool
PoseModel::ProjectWithJacobian(const double p[3], double w[2], double jacobian[14]) const
{
  const unsigned int film = m_Geometry.GetFilmAxis();
  const unsigned int ray = m_Geometry.GetDepthAxis();
  double             c[3];
  Apply(m_Rotation, p, c);
  c[0] += m_Parameters[PoseTx];
  c[1] += m_Parameters[PoseTy];
  c[2] += m_Parameters[PoseTz];
  const double k = m_Geometry.sourceSign;
  const double depth = m_Geometry.sourceToMidsagittal + k * c[ray];
  const double m = m_Focal / depth;
  w[0] = m * c[film];
  w[1] = -m * c[2];
  // d w / d depth axis
  const double ud = -k * w[0] / depth;
  const double vd = -k * w[1] / depth;
  for (int i = 0; i < 3; ++i)
  {
    double d[3];
    Apply(m_RotationDerivatives[i], p, d);
    jacobian[i] = m * d[film] + ud * d[ray];
    jacobian[7 + i] = -m * d[2] + vd * d[ray];
  }
  jacobian[PoseTx + film] = m;
  jacobian[7 + PoseTx + film] = 0.0;
  jacobian[PoseTx + ray] = ud;
  jacobian[7 + PoseTx + ray] = vd;
  jacobian[PoseTz] = 0.0;
  jacobian[7 + PoseTz] = -m;
  jacobian[PoseKappa] = w[0];
  jacobian[7 + PoseKappa] = w[1];
  return depth > 0.0;
}

std::array<double, 3>
PoseModel::FindAngles(const std::array<double, 9> & rotation)
{
  // R = Ry Rx Rz: the second row is (cos roll sin yaw, cos roll cos yaw, -sin roll), the last column
  // (sin pitch cos roll, -sin roll, cos pitch cos roll).
  const auto & r = rotation;
  const bool   gimbal = std::hypot(r[2], r[8]) < 1e-12;
  const double pitch = gimbal ? std::atan2(-r[6], r[0]) : std::atan2(r[2], r[8]);
  // The rest from Ry(-pitch) R = Rx Rz, so that they make up for the rounding of a pitch that is hardly determined.
  const double c = std::cos(pitch);
  const double s = std::sin(pitch);
  return { { pitch,
             std::atan2(-r[5], s * r[2] + c * r[8]),
             gimbal ? 0.0 : std::atan2(s * r[7] - c * r[1], c * r[0] - s * r[6]) } };
}

std::array<double, 4>
PoseModel::PropagateCovariance(const double jacobian[14], const std::array<double, 49> & covariance)
{
  std::array<double, 4> result{};
  for (unsigned int a = 0; a < 2; ++a)
  {
    for (unsigned int b = 0; b < 2; ++b)
    {
      for (unsigned int i = 0; i < 7; ++i)
      {
        for (unsigned int k = 0; k < 7; ++k)
        {
          result[2 * a + b] += jacobian[7 * a + i] * covariance[7 * i + k] * jacobian[7 * b + k];
        }
      }
    }
  }
  return result;
}

PerspectiveProjection
PoseModel::GetProjection() const
{
  PerspectiveProjection projection;
  const unsigned int    film = m_Geometry.GetFilmAxis();
  const unsigned int    ray = m_Geometry.GetDepthAxis();
  const double          k = m_Geometry.sourceSign;
  // Divided by S, so that the third row is 1 at the plane through the ear rods.
  const double f = m_Focal / m_Geometry.sourceToMidsagittal;
  const double g = k / m_Geometry.sourceToMidsagittal;
  auto &       a = projection.matrix;
  for (unsigned int j = 0; j < 3; ++j)
  {
    a[j] = f * m_Rotation[3 * film + j];
    a[4 + j] = -f * m_Rotation[6 + j];
    a[8 + j] = g * m_Rotation[3 * ray + j];
  }
  a[3] = f * m_Parameters[PoseTx + film];
  a[7] = -f * m_Parameters[PoseTz];
  a[11] = 1.0 + g * m_Parameters[PoseTx + ray];
  double s[3] = { -m_Parameters[PoseTx], -m_Parameters[PoseTy], -m_Parameters[PoseTz] };
  s[ray] = -k * m_Geometry.sourceToMidsagittal - m_Parameters[PoseTx + ray];
  for (int i = 0; i < 3; ++i)
  {
    projection.source[i] = m_Rotation[i] * s[0] + m_Rotation[3 + i] * s[1] + m_Rotation[6 + i] * s[2];
  }
  return projection;
}

void
PoseModel::SolveTranslation(const double p[3], const double w[2], double & along, double & tz) const
{
  const unsigned int film = m_Geometry.GetFilmAxis();
  const unsigned int ray = m_Geometry.GetDepthAxis();
  double             c[3];
  Apply(m_Rotation, p, c);
  const double m =
    m_Focal / (m_Geometry.sourceToMidsagittal + m_Geometry.sourceSign * (c[ray] + m_Parameters[PoseTx + ray]));
  along = w[0] / m - c[film];
  tz = -w[1] / m - c[2];
}

PoseParameters
PoseModel::ConvertPose(const PoseGeometry &   from,
                       const PoseParameters & parameters,
                       const PoseGeometry &   to,
                       const double           p[3])
{
  if (from.pixelSpacing == to.pixelSpacing && from.principalPoint == to.principalPoint &&
      from.sourceToMidsagittal == to.sourceToMidsagittal && from.sourceToDetector == to.sourceToDetector)
  {
    return parameters;
  }
  const auto pixelsPerMillimetre = [](const PoseGeometry & geometry) {
    return geometry.sourceToDetector / geometry.sourceToMidsagittal /
           std::sqrt(geometry.pixelSpacing[0] * geometry.pixelSpacing[1]);
  };
  PoseParameters converted = parameters;
  converted[PoseKappa] += std::log(pixelsPerMillimetre(from) / pixelsPerMillimetre(to));
  double place[2];
  if (!PoseModel(from, parameters).Project(p, place))
  {
    return converted;
  }
  const auto   film = ToWorkingPlane(to, ToPixel(from, { { place[0], place[1] } }));
  const double target[2] = { film[0], film[1] };
  PoseModel(to, converted)
    .SolveTranslation(p, target, converted[to.GetFilmAxis() == 0 ? PoseTx : PoseTy], converted[PoseTz]);
  return converted;
}

std::array<double, 2>
PoseModel::ToWorkingPlane(const PoseGeometry & geometry, const std::array<double, 2> & pixel)
{
  return { { (pixel[0] - geometry.principalPoint[0]) * geometry.facingSign * geometry.pixelSpacing[0] /
               PoseWorkingPixel,
             (pixel[1] - geometry.principalPoint[1]) * geometry.pixelSpacing[1] / PoseWorkingPixel } };
}

std::array<double, 2>
PoseModel::ToPixel(const PoseGeometry & geometry, const std::array<double, 2> & w)
{
  return { { geometry.principalPoint[0] + w[0] * PoseWorkingPixel * geometry.facingSign / geometry.pixelSpacing[0],
             geometry.principalPoint[1] + w[1] * PoseWorkingPixel / geometry.pixelSpacing[1] } };
}

std::array<double, 2>
PoseModel::ToPixelNormal(const PoseGeometry & geometry, const std::array<double, 2> & normal)
{
  // A normal goes by the inverse of what points go by, so that it stays one where pixels are no squares.
  const double u = normal[0] * geometry.facingSign * geometry.pixelSpacing[0];
  const double v = normal[1] * geometry.pixelSpacing[1];
  const double length = std::hypot(u, v);
  return { { u / length, v / length } };
}

std::array<double, 12>
PoseModel::GetPixelProjection(const PoseFrame & frame) const
{
  const auto             a = this->GetProjection().matrix;
  std::array<double, 12> p{};
  const double           su = PoseWorkingPixel * m_Geometry.facingSign / m_Geometry.pixelSpacing[0];
  const double           sv = PoseWorkingPixel / m_Geometry.pixelSpacing[1];
  for (int j = 0; j < 4; ++j)
  {
    p[j] = su * a[j] + m_Geometry.principalPoint[0] * a[8 + j];
    p[4 + j] = sv * a[4 + j] + m_Geometry.principalPoint[1] * a[8 + j];
    p[8 + j] = a[8 + j];
  }
  // p (A (x - o)) = (p A) x - p A o
  std::array<double, 12> q{};
  for (int i = 0; i < 3; ++i)
  {
    double shift = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      q[4 * i + j] =
        p[4 * i] * frame.rotation[j] + p[4 * i + 1] * frame.rotation[3 + j] + p[4 * i + 2] * frame.rotation[6 + j];
      shift += q[4 * i + j] * frame.origin[j];
    }
    q[4 * i + 3] = p[4 * i + 3] - shift;
  }
  return q;
}
} // namespace itk
