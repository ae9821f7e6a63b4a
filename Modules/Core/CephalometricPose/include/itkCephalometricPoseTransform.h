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
#ifndef itkCephalometricPoseTransform_h
#define itkCephalometricPoseTransform_h

#include "CephalometricPoseExport.h"
#include "itkCephalometricGeometry.h"
#include "itkPoseModel.h"

#include "itkTransform.h"
#include "itkVersorRigid3DTransform.h"

#include <array>

namespace itk
{
/** \class CephalometricPoseTransform
 * \brief Maps a point of the dental frame to the radiograph under the seven parameters of a pose.
 *
 * The input is a point of the dental frame in mm (x anterior, y to the patient's left, z superior). The output is the
 * continuous pixel index of the radiograph: (0, 0) is the centre of the first pixel, u runs to the right and v down.
 *
 *   c = Ry(pitch) Rx(roll) Rz(yaw) p + t
 *   m = exp(kappa) D / (S + k c_y)
 *   u = pp_u + f m c_x / sp_u,   v = pp_v - m c_z / sp_v
 *
 * or, of a frontal radiograph, with c_x and c_y exchanged. c is the point in the cephalostat frame of
 * CephalometricGeometry. Documentation/Geometry.md has a drawing and derives
 * the projection; kappa is zero for a radiograph whose distances and pixel spacing are right.
 *
 * The parameters, in the order of PoseParameterIndex, are pitch, roll and yaw in rad, tx, ty and tz in mm, and kappa,
 * the natural logarithm of the factor on the magnification. The fixed parameters, in the order of FixedParameterIndex,
 * are the distances S and D in mm, the signs k of the source's side and f of the facing, the pixel spacing sp in mm in
 * the detector plane, the principal point pp in pixels, and the direction of the rays. SetGeometry() fills them.
 *
 * The pixel spacing has no default: before SetGeometry() or SetFixedParameters() it is zero, and every method that
 * projects throws a sentence that says so. A point that does not lie in front of the X-ray source throws as well.
 *
 * The transform is not linear and has no inverse: a pixel belongs to a whole ray
 * (CephalometricGeometry::BackProject()). Vectors map only at a point, to first order. Covariant vectors and tensors
 * throw: a gradient of the radiograph goes the other way, with the transpose of the position Jacobian J, and a
 * covariance C becomes J C J^T.
 *
 * ITK's TransformFileWriter and TransformFileReader handle it (Insight legacy .txt and .tfm) once the program has
 * called TransformFactory<CephalometricPoseTransform>::RegisterTransform().
 *
 * Any number of threads may transform points at the same time, but none while parameters are set.
 *
 * \test itkCephalometricPoseTransformGTest.cxx
 * \ingroup CephalometricPose
 */
class CephalometricPose_EXPORT CephalometricPoseTransform : public Transform<double, 3, 2>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CephalometricPoseTransform);

  using Self = CephalometricPoseTransform;
  using Superclass = Transform<double, 3, 2>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CephalometricPoseTransform, Transform);
  /** Three angles, three shifts and kappa, the logarithm of the scale; fixed ones are the radiograph's geometry. */
  static constexpr unsigned int NumberOfParameters = 7;
  static constexpr unsigned int NumberOfFixedParameters = 9;
  /** Those of files from before there were frontal radiographs: all but the direction, which is lateral. They are taken
   * too. */
  static constexpr unsigned int NumberOfLateralFixedParameters = NumberOfFixedParameters - 1;

  /** The order of the parameters: PosePitch, PoseRoll, PoseYaw, PoseTx, PoseTy, PoseTz, PoseKappa. */
  using ParameterIndex = PoseParameterIndex;

  /** The order of the fixed parameters. */
  enum FixedParameterIndex : unsigned int
  {
    SourceToMidsagittal = 0,
    SourceToDetector,
    SourceSign,
    FacingSign,
    PixelSpacingU,
    PixelSpacingV,
    PrincipalPointU,
    PrincipalPointV,
    /** 0 of a lateral radiograph, 1 of a frontal one. */
    Direction
  };

  using RotationType = Matrix<double, 3, 3>;
  using TranslationType = Vector<double, 3>;
  using RigidTransformType = VersorRigid3DTransform<double>;

  /** Sets the seven parameters. It throws unless there are seven finite ones and exp(kappa) is a positive finite
   * number. The modification time changes only where a value does. */
  void
  SetParameters(const ParametersType & parameters) override;

  /** Sets the nine fixed parameters; eight, as in older files, are those of a lateral radiograph. It throws, and
   * changes nothing, unless there are so many, 0 < S < D, the signs are +1 or -1, the direction is 0 or 1, the spacings
   * are positive and all of them are finite. The modification time changes only where a value does. */
  void
  SetFixedParameters(const FixedParametersType & fixedParameters) override;

  /** As SetParameters(), which checks the number of values that the superclass would copy unseen. */
  void
  CopyInParameters(const ParametersValueType * const begin, const ParametersValueType * const end) override;

  /** As SetFixedParameters(), which checks the number of values that the superclass would copy unseen. */
  void
  CopyInFixedParameters(const FixedParametersValueType * const begin,
                        const FixedParametersValueType * const end) override;

  /** Adds factor times update (7 values) to the parameters, with the checks of SetParameters(). */
  void
  UpdateTransformParameters(const DerivativeType & update, ParametersValueType factor = 1.0) override;

  /** Sets all seven parameters to zero: the dental frame is the cephalostat frame, with the nominal magnification. The
   * fixed parameters stay. */
  void
  SetIdentity();

  /** Fills the fixed parameters from a geometry. The geometry's pose is not taken, because the parameters of this
   * transform are the pose. Throws without a geometry, and where the geometry is not complete: its pixel spacing has to
   * be set with SetPixelSpacing(). The geometry is copied and not watched: call again after a change. */
  void
  SetGeometry(const CephalometricGeometry * geometry);

  /** The fixed parameters as the kernels take them. Getting throws before they are set. */
  void
  SetPoseGeometry(const PoseGeometry & geometry);
  const PoseGeometry &
  GetPoseGeometry() const;

  /** The parameters as the kernels take them. */
  const PoseParameters &
  GetPoseParameters() const
  {
    return m_Model.GetParameters();
  }

  /** Writes the distances, sides, principal point and pose of this transform to a geometry, and its pixel spacing
   * divided by GetScaleFactor(), so that placed->ProjectPoint(p) is TransformPoint(p). Throws without a geometry to
   * write to, and before the fixed parameters are set. */
  void
  CopyToGeometry(CephalometricGeometry * placed) const;

  /** Sets the parameters from c = rotation * p + translation (mm) and kappa. The roll is in [-90, 90] degrees, pitch
   * and yaw in (-180, 180]. At a roll of +90 or -90 degrees (within 1e-12 rad) pitch and yaw turn about the same axis:
   * the yaw is set to zero and the pitch does the turning. Throws unless the rotation is orthonormal (1e-6) with
   * determinant +1 and all values are finite. */
  void
  SetParametersFromRotation(const RotationType & rotation, const TranslationType & translation, double kappa);

  /** A new transform from the dental frame to the cephalostat frame (mm), with its centre at the origin. */
  RigidTransformType::Pointer
  GetRigidTransform() const;

  /** exp(kappa): the factor on the magnification of the geometry, 1 where the geometry is right. */
  double
  GetScaleFactor() const;

  /** A point of the dental frame (mm) to the continuous pixel index. Throws before the fixed parameters are set, and
   * where the point does not lie in front of the source. */
  OutputPointType
  TransformPoint(const InputPointType & point) const override;

  /** d(u, v) / d(parameters) at a point of the dental frame: 2x7, pixels a rad, a mm and a unit of kappa. Throws as
   * TransformPoint(). */
  void
  ComputeJacobianWithRespectToParameters(const InputPointType & point, JacobianType & jacobian) const override;

  /** d(u, v) / d(point) at a point of the dental frame: 2x3, pixels a mm. Throws as TransformPoint(). */
  void
  ComputeJacobianWithRespectToPosition(const InputPointType & point, JacobianPositionType & jacobian) const override;
  using Superclass::ComputeJacobianWithRespectToPosition;

  /** Neither linear nor of any other category that ITK knows. */
  TransformCategoryEnum
  GetTransformCategory() const override
  {
    return TransformCategoryEnum::UnknownTransformCategory;
  }
  bool
  IsLinear() const override
  {
    return false;
  }

  /** Without a point these throw, because a perspective projection maps a vector differently at each point. With a
   * point the superclass multiplies by the position Jacobian: mm in, pixels out. */
  using Superclass::TransformVector;
  OutputVectorType
  TransformVector(const InputVectorType & vector) const override;
  OutputVnlVectorType
  TransformVector(const InputVnlVectorType & vector) const override;
  OutputVectorPixelType
  TransformVector(const InputVectorPixelType & vector) const override;

  /** These throw, because gradients go from the radiograph to the dental frame and not the other way. */
  OutputCovariantVectorType
  TransformCovariantVector(const InputCovariantVectorType & vector) const override;
  OutputCovariantVectorType
  TransformCovariantVector(const InputCovariantVectorType & vector, const InputPointType & point) const override;
  OutputVectorPixelType
  TransformCovariantVector(const InputVectorPixelType & vector) const override;
  OutputVectorPixelType
  TransformCovariantVector(const InputVectorPixelType & vector, const InputPointType & point) const override;

  /** These throw, because a tensor of three dimensions has no image of its kind in two. */
  OutputDiffusionTensor3DType
  TransformDiffusionTensor3D(const InputDiffusionTensor3DType & tensor) const override;
  OutputDiffusionTensor3DType
  TransformDiffusionTensor3D(const InputDiffusionTensor3DType & tensor, const InputPointType & point) const override;
  OutputVectorPixelType
  TransformDiffusionTensor3D(const InputVectorPixelType & tensor) const override;
  OutputVectorPixelType
  TransformDiffusionTensor3D(const InputVectorPixelType & tensor, const InputPointType & point) const override;
  OutputSymmetricSecondRankTensorType
  TransformSymmetricSecondRankTensor(const InputSymmetricSecondRankTensorType & tensor) const override;
  OutputSymmetricSecondRankTensorType
  TransformSymmetricSecondRankTensor(const InputSymmetricSecondRankTensorType & tensor,
                                     const InputPointType &                     point) const override;
  OutputVectorPixelType
  TransformSymmetricSecondRankTensor(const InputVectorPixelType & tensor) const override;
  OutputVectorPixelType
  TransformSymmetricSecondRankTensor(const InputVectorPixelType & tensor, const InputPointType & point) const override;

protected:
  CephalometricPoseTransform();
  ~CephalometricPoseTransform() override = default;

  /** Copies parameters and fixed parameters, also where the latter are not set yet. */
  LightObject::Pointer
  InternalClone() const override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** Throws unless the fixed parameters are set. */
  void
  VerifyGeometry() const;
  [[noreturn]] void
  ThrowNotInFront(const InputPointType & point) const;
  [[noreturn]] void
  ThrowCovariantVector() const;
  [[noreturn]] void
  ThrowTensor() const;
  /** d(u, v) / d(working plane), the scale of PoseModel::ToPixel(). */
  std::array<double, 2>
  GetPixelsPerWorkingPixel() const;

  /** The fixed parameters; pixelSpacingKnown is false until they are set. */
  PoseGeometry m_Geometry;
  /** The projection under the current parameters and fixed parameters. */
  PoseModel m_Model;
};
} // namespace itk

#endif
