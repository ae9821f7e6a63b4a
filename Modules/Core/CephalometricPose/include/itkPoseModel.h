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
#ifndef itkPoseModel_h
#define itkPoseModel_h

#include "CephalometricPoseExport.h"
#include "itkPerspectiveProjection.h"
#include "itkPoseTypes.h"

namespace itk
{
/** \class PoseModel
 * \brief The projection of the dental frame onto the working plane under seven pose parameters, with its Jacobian.
 *
 *   c = Ry(pitch) Rx(roll) Rz(yaw) p + t,  m = exp(kappa) D / ((S + k c_y) 0.25),  w = (m c_x, -m c_z)
 *
 * Of a frontal radiograph c_x and c_y change places. The facing is not in here: the working plane is mirrored for a
 * patient who faces left.
 *
 * \ingroup CephalometricPose
 */
class CephalometricPose_EXPORT PoseModel
{
public:
  PoseModel(const PoseGeometry & geometry, const PoseParameters & parameters); /**< Constants once. */

  /** Dental frame to working plane; false where the point is not in front of the source. */
  bool
  Project(const double p[3], double w[2]) const;

  /** The same with d w / d parameters: 2x7, row-major. */
  bool
  ProjectWithJacobian(const double p[3], double w[2], double jacobian[14]) const;

  /** Covariance of a projected point, 2x2, row-major, by its Jacobian (2x7) and the parameters' covariance (7x7). */
  static std::array<double, 4>
  PropagateCovariance(const double jacobian[14], const std::array<double, 49> & covariance);

  /** For the kernels that take a projection: dental frame to working plane. */
  PerspectiveProjection
  GetProjection() const;

  /** Row-major. */
  const std::array<double, 9> &
  GetRotation() const
  {
    return m_Rotation;
  }
  const PoseGeometry &
  GetGeometry() const
  {
    return m_Geometry;
  }
  const PoseParameters &
  GetParameters() const
  {
    return m_Parameters;
  }

  /** Pitch, roll, yaw of a rotation (3x3, row-major): of Ry(pitch) Rx(roll) Rz(yaw), the yaw 0 where the roll is a
   * right angle and pitch and yaw turn about one axis. */
  static std::array<double, 3>
  FindAngles(const std::array<double, 9> & rotation);

  /** The translations along the film that bring a point of the dental frame to a place of the working plane: t_x (of a
   * frontal radiograph t_y) and t_z. The rest of the pose stays. */
  void
  SolveTranslation(const double p[3], const double w[2], double & along, double & tz) const;

  /** A pose that was found in one geometry as one in another, so that what is near a point of the dental frame keeps
   * its place and its size on the radiograph: the rotation stays, the factor makes up for spacing and distances, the
   * shift along the film for the principal point. In the same geometry nothing changes. Facing and direction must
   * agree. */
  static PoseParameters
  ConvertPose(const PoseGeometry & from, const PoseParameters & parameters, const PoseGeometry & to, const double p[3]);

  /** Pixel of the radiograph to working plane, and back. */
  static std::array<double, 2>
  ToWorkingPlane(const PoseGeometry & geometry, const std::array<double, 2> & pixel);
  static std::array<double, 2>
  ToPixel(const PoseGeometry & geometry, const std::array<double, 2> & w);
  /** A unit normal of the working plane as one of the radiograph, whose pixels may be no squares. */
  static std::array<double, 2>
  ToPixelNormal(const PoseGeometry & geometry, const std::array<double, 2> & normal);

  /** Mesh frame (mm) to continuous pixel index, row-major 3x4, third row 1 at the midsagittal plane. */
  std::array<double, 12>
  GetPixelProjection(const PoseFrame & frame) const;

private:
  PoseGeometry          m_Geometry;
  PoseParameters        m_Parameters;
  std::array<double, 9> m_Rotation;
  /** d R / d pitch, roll, yaw. */
  std::array<std::array<double, 9>, 3> m_RotationDerivatives;
  /** exp(kappa) D / 0.25. */
  double m_Focal;
};
} // namespace itk

#endif
