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
#ifndef itkPoseTypes_h
#define itkPoseTypes_h

#include "itkCephalometricDirection.h"

#include <array>

namespace itk
{
/** Plain data of a pose, free of ITK headers.
 *
 * Frames: mesh (mm, as the surface is), dental (x anterior, y patient's left, z superior, origin on the midline plane),
 * cephalostat (CephalometricGeometry). Lengths "in px" are units of 0.25 mm in the detector plane, whatever the image's
 * pixel: the working plane w = ((u - pp_u) f sp_u, (v - pp_v) sp_v) / 0.25 has the patient facing right.
 *
 * Why they stay beside CephalometricGeometry and the rigid transforms of ITK: kernels speak them. A DataObject and an
 * itk::Transform are reference-counted objects behind pointers, with modification times, virtual calls and a header
 * that brings ITK's own Eigen; the kernels evaluate a pose some ten thousand times in several threads, copy what they
 * are given, and include no ITK header, since some of them use the other Eigen. Nothing else should speak them: filters
 * take geometries and transforms, and convert once, by itkPoseGeometryConversion.h, itkPoseFrameOperations.h and
 * itkRigidTransformRows.h. What else they hold is what a geometry does not know of itself: whether spacing and
 * principal point were given, or filled in by the registration.
 */

/** One unit of the working plane, mm in the detector plane. */
constexpr double PoseWorkingPixel = 0.25;

/** Dental frame of a mesh: p_dental = rotation (p_mesh - origin). Rows of the rotation (row-major) are the axes x, y,
 * z. */
struct PoseFrame
{
  std::array<double, 9> rotation{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 } }; /**< Row-major. */
  std::array<double, 3> origin{ { 0, 0, 0 } };                     /**< mm, mesh coordinates. */
};

/** Nominal imaging geometry. Of a frontal radiograph the plane through the ear rods is the midcoronal one. */
struct PoseGeometry
{
  /** From which side of the head the rays come. */
  CephalometricDirectionEnum direction{ CephalometricDirectionEnum::Lateral };
  double                     sourceToMidsagittal{ 1524.0 };
  double                     sourceToDetector{ 1674.0 };
  /** k: +1 source on the patient's right, -1 left; frontal: +1 behind, -1 in front. */
  double sourceSign{ 1.0 };
  /** f: +1 facing right in the image, -1 left; frontal: where the patient's left is. */
  double                facingSign{ 1.0 };
  std::array<double, 2> pixelSpacing{ { 0.25, 0.25 } };
  bool                  pixelSpacingKnown{ true };
  std::array<double, 2> principalPoint{ { 0.0, 0.0 } };
  bool                  principalPointKnown{ true };

  /** The axis of the cephalostat frame that runs along the film: x of a lateral radiograph, y of a frontal one. */
  unsigned int
  GetFilmAxis() const
  {
    return direction == CephalometricDirectionEnum::Lateral ? 0 : 1;
  }
  /** The axis along the central ray: y, or x. */
  unsigned int
  GetDepthAxis() const
  {
    return 1 - this->GetFilmAxis();
  }
};

/** pitch (about y), roll (about x), yaw (about z) in rad, translation x, y, z in mm, kappa = log of the scale factor
 * that multiplies the geometry's magnification. c = Ry(pitch) Rx(roll) Rz(yaw) p_dental + t. */
using PoseParameters = std::array<double, 7>;
enum PoseParameterIndex : unsigned int
{
  PosePitch = 0,
  PoseRoll,
  PoseYaw,
  PoseTx,
  PoseTy,
  PoseTz,
  PoseKappa
};
} // namespace itk

#endif
