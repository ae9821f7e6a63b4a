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
#include "itkCephalometricPoseTransform.h"

#include "itkPoseModel.h"

#include "itkPoseGeometryConversion.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
const char * const parameterNames[CephalometricPoseTransform::NumberOfParameters] = { "pitch", "roll", "yaw",  "tx",
                                                                                      "ty",    "tz",   "kappa" };

/** Before the geometry is set: the nominal distances, but no pixel spacing, because an unknown one is never assumed. */
PoseGeometry
GeometryWithoutSpacing()
{
  PoseGeometry geometry;
  geometry.pixelSpacing = { { 0.0, 0.0 } };
  geometry.pixelSpacingKnown = false;
  geometry.principalPointKnown = false;
  return geometry;
}
} // namespace

CephalometricPoseTransform::CephalometricPoseTransform()
  : Superclass(NumberOfParameters)
  , m_Geometry(GeometryWithoutSpacing())
  , m_Model(m_Geometry, PoseParameters{})
{
  m_Parameters.Fill(0.0);
  m_FixedParameters.SetSize(NumberOfFixedParameters);
  m_FixedParameters.Fill(0.0);
  m_FixedParameters[SourceToMidsagittal] = m_Geometry.sourceToMidsagittal;
  m_FixedParameters[SourceToDetector] = m_Geometry.sourceToDetector;
  m_FixedParameters[SourceSign] = m_Geometry.sourceSign;
  m_FixedParameters[FacingSign] = m_Geometry.facingSign;
}

LightObject::Pointer
CephalometricPoseTransform::InternalClone() const
{
  // The superclass would set the fixed parameters of a transform without a geometry, which are refused.
  LightObject::Pointer object = this->CreateAnother();
  auto *               clone = dynamic_cast<Self *>(object.GetPointer());
  if (clone == nullptr)
  {
    itkExceptionMacro("An object factory made a " << object->GetNameOfClass() << " in place of the clone of a "
                                                  << this->GetNameOfClass() << ". Unregister that factory.");
  }
  if (m_Geometry.pixelSpacingKnown)
  {
    clone->SetFixedParameters(m_FixedParameters);
  }
  clone->SetParameters(m_Parameters);
  return object;
}

void
CephalometricPoseTransform::SetParameters(const ParametersType & parameters)
{
  if (parameters.Size() != NumberOfParameters)
  {
    itkExceptionMacro("Got " << parameters.Size() << " parameters where " << NumberOfParameters
                             << " are needed: pitch, roll and yaw in rad, tx, ty and tz in mm, and kappa.");
  }
  PoseParameters values;
  for (unsigned int i = 0; i < NumberOfParameters; ++i)
  {
    values[i] = parameters[i];
    if (!std::isfinite(values[i]))
    {
      itkExceptionMacro("The parameter " << parameterNames[i] << " is " << values[i]
                                         << ". Give finite values; an optimizer that gets here needs smaller steps.");
    }
  }
  const double scale = std::exp(values[PoseKappa]);
  if (!(scale > 0.0) || !std::isfinite(scale))
  {
    itkExceptionMacro("The parameter kappa = " << values[PoseKappa] << " makes the factor on the magnification "
                                               << scale
                                               << ". Give its natural logarithm: 0 for 1, 0.01 for one percent more.");
  }
  if (values != m_Model.GetParameters())
  {
    m_Model = PoseModel(m_Geometry, values);
    m_Parameters = parameters;
    this->Modified();
  }
}

void
CephalometricPoseTransform::SetFixedParameters(const FixedParametersType & fixedParameters)
{
  if (fixedParameters.Size() == NumberOfLateralFixedParameters)
  {
    FixedParametersType all(NumberOfFixedParameters);
    std::copy_n(fixedParameters.data_block(), NumberOfLateralFixedParameters, all.data_block());
    all[Direction] = 0.0;
    this->SetFixedParameters(all);
    return;
  }
  if (fixedParameters.Size() != NumberOfFixedParameters)
  {
    itkExceptionMacro(
      "Got " << fixedParameters.Size() << " fixed parameters where " << NumberOfFixedParameters
             << " are needed: the distances from the source to the midsagittal plane and to the "
                "detector (mm), source sign, facing sign, pixel spacing u and v (mm), principal point u "
                "and v (pixels), direction (0 lateral, 1 frontal). SetGeometry() fills them.");
  }
  if (fixedParameters[Direction] != 0.0 && fixedParameters[Direction] != 1.0)
  {
    itkExceptionMacro("The direction is " << fixedParameters[Direction]
                                          << ". Give 0 for a lateral radiograph, 1 for a frontal one.");
  }
  PoseGeometry geometry;
  geometry.direction =
    fixedParameters[Direction] == 0.0 ? CephalometricDirectionEnum::Lateral : CephalometricDirectionEnum::Frontal;
  geometry.sourceToMidsagittal = fixedParameters[SourceToMidsagittal];
  geometry.sourceToDetector = fixedParameters[SourceToDetector];
  geometry.sourceSign = fixedParameters[SourceSign];
  geometry.facingSign = fixedParameters[FacingSign];
  geometry.pixelSpacing = { { fixedParameters[PixelSpacingU], fixedParameters[PixelSpacingV] } };
  geometry.principalPoint = { { fixedParameters[PrincipalPointU], fixedParameters[PrincipalPointV] } };
  if (!(geometry.sourceToMidsagittal > 0.0) || !(geometry.sourceToDetector > geometry.sourceToMidsagittal) ||
      !std::isfinite(geometry.sourceToDetector))
  {
    itkExceptionMacro("The source-to-midsagittal distance "
                      << geometry.sourceToMidsagittal
                      << " mm must be positive and smaller than the source-to-detector distance "
                      << geometry.sourceToDetector << " mm. Give both in mm and in this order.");
  }
  if (std::abs(geometry.sourceSign) != 1.0)
  {
    itkExceptionMacro("The source sign is " << geometry.sourceSign
                                            << ". Give +1 for a source on the patient's right, -1 on the left.");
  }
  if (std::abs(geometry.facingSign) != 1.0)
  {
    itkExceptionMacro("The facing sign is "
                      << geometry.facingSign
                      << ". Give +1 for a patient who faces right in the image, -1 for one who faces left.");
  }
  for (const double spacing : geometry.pixelSpacing)
  {
    if (!(spacing > 0.0) || !std::isfinite(spacing))
    {
      itkExceptionMacro("The pixel spacing is "
                        << geometry.pixelSpacing[0] << " x " << geometry.pixelSpacing[1]
                        << " mm. Give the mm a pixel in the detector plane, both > 0: an unknown spacing has to be "
                           "estimated, never assumed.");
    }
  }
  for (const double coordinate : geometry.principalPoint)
  {
    if (!std::isfinite(coordinate))
    {
      itkExceptionMacro("The principal point is ("
                        << geometry.principalPoint[0] << ", " << geometry.principalPoint[1]
                        << "). Give the pixel where the central ray meets the detector: the ear-rod ring.");
    }
  }
  // Without a geometry the spacing is zero, so that the first valid one always differs.
  if (fixedParameters != m_FixedParameters)
  {
    m_Geometry = geometry;
    m_Model = PoseModel(m_Geometry, m_Model.GetParameters());
    m_FixedParameters = fixedParameters;
    this->Modified();
  }
}

void
CephalometricPoseTransform::CopyInParameters(const ParametersValueType * const begin,
                                             const ParametersValueType * const end)
{
  ParametersType parameters(static_cast<SizeValueType>(end - begin));
  std::copy(begin, end, parameters.data_block());
  this->SetParameters(parameters);
}

void
CephalometricPoseTransform::CopyInFixedParameters(const FixedParametersValueType * const begin,
                                                  const FixedParametersValueType * const end)
{
  FixedParametersType fixedParameters(static_cast<SizeValueType>(end - begin));
  std::copy(begin, end, fixedParameters.data_block());
  this->SetFixedParameters(fixedParameters);
}

void
CephalometricPoseTransform::UpdateTransformParameters(const DerivativeType & update, ParametersValueType factor)
{
  if (update.Size() != NumberOfParameters)
  {
    itkExceptionMacro("Got an update of " << update.Size() << " values where " << NumberOfParameters
                                          << " are needed, one a parameter.");
  }
  // The superclass adds in place: values that are refused would stay, and the modification time change without need.
  ParametersType parameters = m_Parameters;
  for (unsigned int i = 0; i < NumberOfParameters; ++i)
  {
    parameters[i] += factor * update[i];
  }
  this->SetParameters(parameters);
}

void
CephalometricPoseTransform::SetIdentity()
{
  ParametersType parameters(NumberOfParameters);
  parameters.Fill(0.0);
  this->SetParameters(parameters);
}

void
CephalometricPoseTransform::SetGeometry(const CephalometricGeometry * geometry)
{
  if (geometry == nullptr)
  {
    itkExceptionMacro("SetGeometry() needs a CephalometricGeometry, not a null pointer.");
  }
  geometry->VerifyComplete();
  this->SetPoseGeometry(ToPoseGeometry(*geometry));
}

void
CephalometricPoseTransform::SetPoseGeometry(const PoseGeometry & geometry)
{
  FixedParametersType fixedParameters(NumberOfFixedParameters);
  fixedParameters[SourceToMidsagittal] = geometry.sourceToMidsagittal;
  fixedParameters[SourceToDetector] = geometry.sourceToDetector;
  fixedParameters[SourceSign] = geometry.sourceSign;
  fixedParameters[FacingSign] = geometry.facingSign;
  fixedParameters[PixelSpacingU] = geometry.pixelSpacing[0];
  fixedParameters[PixelSpacingV] = geometry.pixelSpacing[1];
  fixedParameters[PrincipalPointU] = geometry.principalPoint[0];
  fixedParameters[PrincipalPointV] = geometry.principalPoint[1];
  fixedParameters[Direction] = geometry.direction == CephalometricDirectionEnum::Lateral ? 0.0 : 1.0;
  this->SetFixedParameters(fixedParameters);
}

void
CephalometricPoseTransform::VerifyGeometry() const
{
  if (!m_Geometry.pixelSpacingKnown)
  {
    itkExceptionMacro(
      "The imaging geometry is not set: call SetGeometry() with a CephalometricGeometry that has a pixel "
      "spacing, or SetFixedParameters().");
  }
}

const PoseGeometry &
CephalometricPoseTransform::GetPoseGeometry() const
{
  this->VerifyGeometry();
  return m_Geometry;
}

void
CephalometricPoseTransform::CopyToGeometry(CephalometricGeometry * placed) const
{
  if (placed == nullptr)
  {
    itkExceptionMacro("CopyToGeometry() needs a CephalometricGeometry to write to, not a null pointer.");
  }
  this->VerifyGeometry();
  itk::CopyToGeometry(m_Geometry, this->GetScaleFactor(), *placed);
  RotationType    rotation;
  TranslationType translation;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      rotation(row, column) = m_Model.GetRotation()[3 * row + column];
    }
    translation[row] = m_Parameters[PoseTx + row];
  }
  placed->SetPose(rotation, translation);
}

void
CephalometricPoseTransform::SetParametersFromRotation(const RotationType &    rotation,
                                                      const TranslationType & translation,
                                                      double                  kappa)
{
  // The geometry knows what a rigid pose is, and says what is wrong with one that is not.
  CephalometricGeometry::New()->SetPose(rotation, translation);

  std::array<double, 9> rows{};
  for (unsigned int i = 0; i < 9; ++i)
  {
    rows[i] = rotation(i / 3, i % 3);
  }
  const auto     angles = PoseModel::FindAngles(rows);
  ParametersType parameters(NumberOfParameters);
  parameters[PosePitch] = angles[0];
  parameters[PoseRoll] = angles[1];
  parameters[PoseYaw] = angles[2];
  for (unsigned int d = 0; d < 3; ++d)
  {
    parameters[PoseTx + d] = translation[d];
  }
  parameters[PoseKappa] = kappa;
  this->SetParameters(parameters);
}

auto
CephalometricPoseTransform::GetRigidTransform() const -> RigidTransformType::Pointer
{
  // By half angles, because ITK's versor of a matrix loses half of its digits near half a turn.
  RigidTransformType::VersorType pitch, roll, yaw, rotation;
  pitch.SetRotationAroundY(m_Parameters[PosePitch]);
  roll.SetRotationAroundX(m_Parameters[PoseRoll]);
  yaw.SetRotationAroundZ(m_Parameters[PoseYaw]);
  const RigidTransformType::VersorType product = pitch * roll * yaw;
  // This setter makes w positive, without which the parameters of the rigid transform would mean another rotation.
  rotation.Set(product.GetX(), product.GetY(), product.GetZ(), product.GetW());

  TranslationType translation;
  for (unsigned int d = 0; d < 3; ++d)
  {
    translation[d] = m_Parameters[PoseTx + d];
  }
  auto rigid = RigidTransformType::New();
  rigid->SetRotation(rotation);
  rigid->SetTranslation(translation);
  return rigid;
}

double
CephalometricPoseTransform::GetScaleFactor() const
{
  return std::exp(m_Parameters[PoseKappa]);
}

void
CephalometricPoseTransform::ThrowNotInFront(const InputPointType & point) const
{
  const double depth = m_Geometry.sourceToMidsagittal * m_Model.GetProjection().Depth(point.GetDataPointer());
  itkExceptionMacro("The point " << point << " does not lie in front of the X-ray source: its depth from there is "
                                 << depth << " mm. Check the mesh's unit (mm), the pose and the source's side.");
}

auto
CephalometricPoseTransform::TransformPoint(const InputPointType & point) const -> OutputPointType
{
  this->VerifyGeometry();
  double w[2];
  if (!m_Model.Project(point.GetDataPointer(), w))
  {
    this->ThrowNotInFront(point);
  }
  const std::array<double, 2> pixel = PoseModel::ToPixel(m_Geometry, { { w[0], w[1] } });
  OutputPointType             output;
  output[0] = pixel[0];
  output[1] = pixel[1];
  return output;
}

std::array<double, 2>
CephalometricPoseTransform::GetPixelsPerWorkingPixel() const
{
  return { { PoseWorkingPixel * m_Geometry.facingSign / m_Geometry.pixelSpacing[0],
             PoseWorkingPixel / m_Geometry.pixelSpacing[1] } };
}

void
CephalometricPoseTransform::ComputeJacobianWithRespectToParameters(const InputPointType & point,
                                                                   JacobianType &         jacobian) const
{
  this->VerifyGeometry();
  double w[2], working[2 * NumberOfParameters];
  if (!m_Model.ProjectWithJacobian(point.GetDataPointer(), w, working))
  {
    this->ThrowNotInFront(point);
  }
  const std::array<double, 2> scale = this->GetPixelsPerWorkingPixel();
  jacobian.SetSize(2, NumberOfParameters);
  for (unsigned int row = 0; row < 2; ++row)
  {
    for (unsigned int column = 0; column < NumberOfParameters; ++column)
    {
      jacobian(row, column) = scale[row] * working[NumberOfParameters * row + column];
    }
  }
}

void
CephalometricPoseTransform::ComputeJacobianWithRespectToPosition(const InputPointType & point,
                                                                 JacobianPositionType & jacobian) const
{
  this->VerifyGeometry();
  double w[2], working[2 * NumberOfParameters];
  if (!m_Model.ProjectWithJacobian(point.GetDataPointer(), w, working))
  {
    this->ThrowNotInFront(point);
  }
  // c = R p + t: the derivative by the translation, times R.
  const std::array<double, 2>   scale = this->GetPixelsPerWorkingPixel();
  const std::array<double, 9> & rotation = m_Model.GetRotation();
  for (unsigned int row = 0; row < 2; ++row)
  {
    const double * byTranslation = working + NumberOfParameters * row + PoseTx;
    for (unsigned int column = 0; column < 3; ++column)
    {
      jacobian(row, column) =
        scale[row] * (byTranslation[0] * rotation[column] + byTranslation[1] * rotation[3 + column] +
                      byTranslation[2] * rotation[6 + column]);
    }
  }
}

auto
CephalometricPoseTransform::TransformVector(const InputVectorType &) const -> OutputVectorType
{
  itkExceptionMacro("A perspective projection maps a vector differently at each point: call TransformVector(vector, "
                    "point).");
}

auto
CephalometricPoseTransform::TransformVector(const InputVnlVectorType &) const -> OutputVnlVectorType
{
  itkExceptionMacro("A perspective projection maps a vector differently at each point: call TransformVector(vector, "
                    "point).");
}

auto
CephalometricPoseTransform::TransformVector(const InputVectorPixelType &) const -> OutputVectorPixelType
{
  itkExceptionMacro("A perspective projection maps a vector differently at each point: call TransformVector(vector, "
                    "point).");
}

void
CephalometricPoseTransform::ThrowCovariantVector() const
{
  itkExceptionMacro(
    "A gradient of three dimensions has no image on the radiograph. A gradient of the radiograph goes to "
    "the dental frame by the transpose of ComputeJacobianWithRespectToPosition().");
}

auto
CephalometricPoseTransform::TransformCovariantVector(const InputCovariantVectorType &) const
  -> OutputCovariantVectorType
{
  this->ThrowCovariantVector();
}

auto
CephalometricPoseTransform::TransformCovariantVector(const InputCovariantVectorType &, const InputPointType &) const
  -> OutputCovariantVectorType
{
  this->ThrowCovariantVector();
}

auto
CephalometricPoseTransform::TransformCovariantVector(const InputVectorPixelType &) const -> OutputVectorPixelType
{
  this->ThrowCovariantVector();
}

auto
CephalometricPoseTransform::TransformCovariantVector(const InputVectorPixelType &, const InputPointType &) const
  -> OutputVectorPixelType
{
  this->ThrowCovariantVector();
}

void
CephalometricPoseTransform::ThrowTensor() const
{
  itkExceptionMacro("A tensor of three dimensions has no image of its kind on the radiograph. A covariance C becomes "
                    "J C J^T with J of ComputeJacobianWithRespectToPosition().");
}

auto
CephalometricPoseTransform::TransformDiffusionTensor3D(const InputDiffusionTensor3DType &) const
  -> OutputDiffusionTensor3DType
{
  this->ThrowTensor();
}

auto
CephalometricPoseTransform::TransformDiffusionTensor3D(const InputDiffusionTensor3DType &, const InputPointType &) const
  -> OutputDiffusionTensor3DType
{
  this->ThrowTensor();
}

auto
CephalometricPoseTransform::TransformDiffusionTensor3D(const InputVectorPixelType &) const -> OutputVectorPixelType
{
  this->ThrowTensor();
}

auto
CephalometricPoseTransform::TransformDiffusionTensor3D(const InputVectorPixelType &, const InputPointType &) const
  -> OutputVectorPixelType
{
  this->ThrowTensor();
}

auto
CephalometricPoseTransform::TransformSymmetricSecondRankTensor(const InputSymmetricSecondRankTensorType &) const
  -> OutputSymmetricSecondRankTensorType
{
  this->ThrowTensor();
}

auto
CephalometricPoseTransform::TransformSymmetricSecondRankTensor(const InputSymmetricSecondRankTensorType &,
                                                               const InputPointType &) const
  -> OutputSymmetricSecondRankTensorType
{
  this->ThrowTensor();
}

auto
CephalometricPoseTransform::TransformSymmetricSecondRankTensor(const InputVectorPixelType &) const
  -> OutputVectorPixelType
{
  this->ThrowTensor();
}

auto
CephalometricPoseTransform::TransformSymmetricSecondRankTensor(const InputVectorPixelType &,
                                                               const InputPointType &) const -> OutputVectorPixelType
{
  this->ThrowTensor();
}

void
CephalometricPoseTransform::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Parameters: " << m_Parameters << std::endl;
  os << indent << "ScaleFactor: " << this->GetScaleFactor() << std::endl;
  os << indent << "Rotation:";
  for (const double element : m_Model.GetRotation())
  {
    os << ' ' << element;
  }
  os << std::endl;
  os << indent << "Direction: " << m_Geometry.direction << std::endl;
  os << indent << "SourceToMidsagittal: " << m_Geometry.sourceToMidsagittal << std::endl;
  os << indent << "SourceToDetector: " << m_Geometry.sourceToDetector << std::endl;
  os << indent << "SourceSign: " << m_Geometry.sourceSign << std::endl;
  os << indent << "FacingSign: " << m_Geometry.facingSign << std::endl;
  os << indent << "PixelSpacing: ";
  if (m_Geometry.pixelSpacingKnown)
  {
    os << m_Geometry.pixelSpacing[0] << ' ' << m_Geometry.pixelSpacing[1] << std::endl;
  }
  else
  {
    os << "not set" << std::endl;
  }
  os << indent << "PrincipalPoint: " << m_Geometry.principalPoint[0] << ' ' << m_Geometry.principalPoint[1]
     << std::endl;
}
} // namespace itk
