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
#ifndef itkCephalometricGeometry_h
#define itkCephalometricGeometry_h

#include "CephalometricGeometryExport.h"
#include "itkCephalometricDirection.h"
#include "itkPerspectiveProjection.h"

#include "itkContinuousIndex.h"
#include "itkDataObject.h"
#include "itkMatrix.h"
#include "itkPoint.h"
#include "itkVector.h"

namespace itk
{
/** \class CephalometricGeometry
 * \brief Where source, detector and pixels of a cephalogram are, and where the object is in it.
 *
 * Cephalostat frame, mm: origin where the central ray meets the midsagittal plane, x anterior, y to the patient's left,
 * z superior. With D the source-to-detector and S the source-to-midsagittal distance, a point (x, y, z) of that frame
 * is projected to the continuous pixel index (0 = centre of the first pixel, u to the right, v down)
 *
 *   m = D / (S + k y),   u = pp_u + f m x / sp_u,   v = pp_v - m z / sp_v
 *
 * with k = +1 where the source is on the patient's right, -1 on the left; f = +1 where the patient faces right in the
 * image, -1 left. Neither changes the other. Pixel spacing is in mm in the detector plane.
 *
 * That is a lateral cephalogram, the default. In a frontal one (SetDirection()) the rays run along x, and S is the
 * distance to the midcoronal plane, through the ear rods:
 *
 *   m = D / (S + k x),   u = pp_u + f m y / sp_u,   v = pp_v - m z / sp_v
 *
 * with k = +1 where the source is behind the patient (postero-anterior, the usual way), -1 in front; f = +1 where the
 * patient's left is on the image's right, as one faces the patient, -1 otherwise.
 *
 * The pose maps the object's frame (mesh or UMDA) to the cephalostat frame: c = R p + t; it is the identity unless set.
 * The pixel spacing has no default: an unknown spacing is never 1.0, and projecting without one is an error.
 *
 * Documentation/Geometry.md has a drawing and derives the formulas.
 *
 * \ingroup CephalometricGeometry
 */
class CephalometricGeometry_EXPORT CephalometricGeometry : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CephalometricGeometry);

  using Self = CephalometricGeometry;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CephalometricGeometry, DataObject);

  /** The side of the patient on which the X-ray source stands. */
  enum class SourceSideEnum : uint8_t
  {
    Right,
    Left
  };
  /** Where the patient's face points in the image. */
  enum class FacingEnum : uint8_t
  {
    Right,
    Left
  };

  using DirectionEnum = CephalometricDirectionEnum;
  /** Where the X-ray source of a frontal cephalogram stands. */
  enum class FrontalSourceEnum : uint8_t
  {
    Behind,
    InFront
  };
  /** Where the patient's left is in a frontal cephalogram. */
  enum class PatientLeftEnum : uint8_t
  {
    Right,
    Left
  };

  using PointType = Point<double, 3>;
  using VectorType = Vector<double, 3>;
  using PixelIndexType = ContinuousIndex<double, 2>;
  using PixelSpacingType = Vector<double, 2>;
  using RotationType = Matrix<double, 3, 3>;
  using ProjectionMatrixType = Matrix<double, 3, 4>;
  using PointJacobianType = Matrix<double, 2, 3>;
  using PoseJacobianType = Matrix<double, 2, 6>;

  /** The back-projected ray of a pixel: from the source, unit direction toward the detector. */
  struct RayType
  {
    PointType  origin;    /**< The source, mm, cephalostat frame. */
    VectorType direction; /**< Of length 1, toward the pixel. */
  };

  /** Lateral by default. What is said of sides holds in its own direction and is kept, unused, in the other. */
  itkSetEnumMacro(Direction, DirectionEnum);
  itkGetEnumMacro(Direction, DirectionEnum);

  /** mm, > 0 and smaller than the source-to-detector distance. Default 1524 (60 inches). In a frontal cephalogram to
   * the midcoronal plane. */
  itkSetMacro(SourceToMidsagittalDistance, double);
  itkGetConstMacro(SourceToMidsagittalDistance, double);

  /** mm. Default 1674. */
  itkSetMacro(SourceToDetectorDistance, double);
  itkGetConstMacro(SourceToDetectorDistance, double);

  /** Lateral: default Right. */
  itkSetEnumMacro(SourceSide, SourceSideEnum);
  itkGetEnumMacro(SourceSide, SourceSideEnum);

  /** Lateral: default Right. */
  itkSetEnumMacro(Facing, FacingEnum);
  itkGetEnumMacro(Facing, FacingEnum);

  /** Frontal: default Behind. */
  itkSetEnumMacro(FrontalSource, FrontalSourceEnum);
  itkGetEnumMacro(FrontalSource, FrontalSourceEnum);

  /** Frontal: default Right, as one faces the patient. */
  itkSetEnumMacro(PatientLeft, PatientLeftEnum);
  itkGetEnumMacro(PatientLeft, PatientLeftEnum);

  /** Continuous pixel index where the central ray meets the detector: on a cephalostat the ear-rod ring. Default (0,
   * 0). */
  itkSetMacro(PrincipalPoint, PixelIndexType);
  itkGetConstReferenceMacro(PrincipalPoint, PixelIndexType);

  /** mm a pixel (u, v) in the detector plane; both > 0. Not set by default. */
  itkSetMacro(PixelSpacing, PixelSpacingType);
  itkGetConstReferenceMacro(PixelSpacing, PixelSpacingType);
  bool
  HasPixelSpacing() const;

  /** Pose of the object: c = rotation * p + translation. Throws unless the rotation is orthonormal (1e-6) with
   * determinant +1. */
  void
  SetPose(const RotationType & rotation, const VectorType & translation);
  void
  SetPoseToIdentity();
  itkGetConstReferenceMacro(PoseRotation, RotationType);
  itkGetConstReferenceMacro(PoseTranslation, VectorType);

  /** k of the projection: +1 with the source on the right (frontal: behind), -1 on the left (in front). */
  double
  GetSourceSign() const;
  /** f of the projection: +1 facing right (frontal: the patient's left on the right), -1 left. */
  double
  GetFacingSign() const;
  /** The axis of the cephalostat frame along the film: 0, x, of a lateral cephalogram, 1, y, of a frontal one. The
   * other of the two runs along the central ray. */
  unsigned int
  GetFilmAxis() const;

  /** Object frame to cephalostat frame. */
  PointType
  TransformToCephalostat(const PointType & point) const;

  /** Magnification D / (S + k y), frontal D / (S + k x), of a point of the object frame. */
  double
  GetMagnification(const PointType & point) const;

  /** Object frame (mm) to continuous pixel index. Throws without a pixel spacing, or where the point is not in front of
   * the source. */
  PixelIndexType
  ProjectPoint(const PointType & point) const;

  /** d(u, v) / d(point), pixels a mm, at a point of the object frame. */
  PointJacobianType
  ComputePointJacobian(const PointType & point) const;

  /** d(u, v) / d(pose) at a point of the object frame: three rotations (rad) about the cephalostat's x, y, z axes
   * through the cephalostat's origin, applied after the pose, then three translations (mm). */
  PoseJacobianType
  ComputePoseJacobian(const PointType & point) const;

  /** The ray of a continuous pixel index, in the object frame. */
  RayType
  BackProject(const PixelIndexType & index) const;

  /** The X-ray source in the object frame. */
  PointType
  GetSourcePosition() const;

  /** Object frame (mm) to homogeneous pixel index, pose included. The third row is scaled to be 1 at the midsagittal
   * (frontal: midcoronal) plane. */
  ProjectionMatrixType
  GetProjectionMatrix() const;

  /** The same for kernels. */
  PerspectiveProjection
  GetProjection() const;

  /** Throws an exception that names the value and the remedy unless the geometry can project. */
  void
  VerifyComplete() const;

  /** Copies every parameter of another geometry; the pipeline connection of this one stays. */
  void
  CopyParameters(const Self * other);

  void
  Graft(const DataObject * data) override;

protected:
  CephalometricGeometry();
  ~CephalometricGeometry() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  DirectionEnum     m_Direction{ DirectionEnum::Lateral };
  double            m_SourceToMidsagittalDistance{ 1524.0 };
  double            m_SourceToDetectorDistance{ 1674.0 };
  SourceSideEnum    m_SourceSide{ SourceSideEnum::Right };
  FacingEnum        m_Facing{ FacingEnum::Right };
  FrontalSourceEnum m_FrontalSource{ FrontalSourceEnum::Behind };
  PatientLeftEnum   m_PatientLeft{ PatientLeftEnum::Right };
  PixelIndexType    m_PrincipalPoint;
  PixelSpacingType  m_PixelSpacing;
  RotationType      m_PoseRotation;
  VectorType        m_PoseTranslation;
};

CephalometricGeometry_EXPORT std::ostream &
                             operator<<(std::ostream & os, CephalometricGeometry::SourceSideEnum side);
CephalometricGeometry_EXPORT std::ostream &
                             operator<<(std::ostream & os, CephalometricGeometry::FacingEnum facing);
CephalometricGeometry_EXPORT std::ostream &
                             operator<<(std::ostream & os, CephalometricGeometry::DirectionEnum direction);
CephalometricGeometry_EXPORT std::ostream &
                             operator<<(std::ostream & os, CephalometricGeometry::FrontalSourceEnum source);
CephalometricGeometry_EXPORT std::ostream &
                             operator<<(std::ostream & os, CephalometricGeometry::PatientLeftEnum side);
} // namespace itk

#endif
