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
#ifndef itkPoseRegistrationMethod_hxx
#define itkPoseRegistrationMethod_hxx

#include "itkDentalFrameEstimator.h"
#include "itkMakeTriangleSurface.h"
#include "itkPoseRegistrationKernel.h"
#include "itkPoseRegistrationOptionTable.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
template <typename TMesh>
PoseRegistrationMethod<TMesh>::PoseRegistrationMethod()
{
  this->AddOptionalInputName("UpperMesh", 1);
  this->AddOptionalInputName("LowerMesh", 2);
  this->AddOptionalInputName("UpperContour", 3);
  this->AddOptionalInputName("LowerContour", 4);
  this->AddRequiredInputName("Geometry", 0);
  this->SetNumberOfRequiredOutputs(2 * NumberOfJaws);
  for (unsigned int i = 0; i < 2 * NumberOfJaws; ++i)
  {
    this->SetNthOutput(i, this->MakeOutput(i));
  }
}

template <typename TMesh>
typename PoseRegistrationMethod<TMesh>::DataObjectPointer
PoseRegistrationMethod<TMesh>::MakeOutput(DataObjectPointerArraySizeType index)
{
  if (index < NumberOfJaws)
  {
    return DecoratedTransformType::New().GetPointer();
  }
  return GeometryType::New().GetPointer();
}

template <typename TMesh>
void
PoseRegistrationMethod<TMesh>::SetOptions(const PoseRegistrationOptions & options)
{
  m_Options = options;
  this->Modified();
}

template <typename TMesh>
void
PoseRegistrationMethod<TMesh>::SetTracedSide(PoseTracedSideEnum side)
{
  if (m_Options.tracedSide != side)
  {
    m_Options.tracedSide = side;
    this->Modified();
  }
}

template <typename TMesh>
void
PoseRegistrationMethod<TMesh>::SetFrames(const PoseFrame & upper, const PoseFrame & lower, bool jawsShareFrame)
{
  m_GivenFrames = { { upper, lower } };
  m_GivenFramesAreShared = jawsShareFrame;
  m_UseGivenFrames = true;
  this->Modified();
}

template <typename TMesh>
void
PoseRegistrationMethod<TMesh>::EstimateFrames()
{
  if (m_UseGivenFrames)
  {
    m_UseGivenFrames = false;
    this->Modified();
  }
}

template <typename TMesh>
typename PoseRegistrationMethod<TMesh>::DecoratedTransformType *
PoseRegistrationMethod<TMesh>::GetTransformOutput(unsigned int jaw)
{
  return itkDynamicCastInDebugMode<DecoratedTransformType *>(this->ProcessObject::GetOutput(jaw));
}

template <typename TMesh>
const typename PoseRegistrationMethod<TMesh>::TransformType *
PoseRegistrationMethod<TMesh>::GetTransform(unsigned int jaw)
{
  return this->GetTransformOutput(jaw)->Get();
}

template <typename TMesh>
typename PoseRegistrationMethod<TMesh>::GeometryType *
PoseRegistrationMethod<TMesh>::GetGeometryOutput(unsigned int jaw)
{
  return itkDynamicCastInDebugMode<GeometryType *>(this->ProcessObject::GetOutput(NumberOfJaws + jaw));
}

template <typename TMesh>
int
PoseRegistrationMethod<TMesh>::GetResultIndex(unsigned int jaw) const
{
  return m_ResultIndex.at(jaw);
}

template <typename TMesh>
const RegistrationVerdict::JawVerdict &
PoseRegistrationMethod<TMesh>::GetVerdict(unsigned int jaw) const
{
  return m_Verdicts.at(jaw);
}

template <typename TMesh>
typename PoseRegistrationMethod<TMesh>::LandmarkCovarianceType
PoseRegistrationMethod<TMesh>::ComputeLandmarkCovariance(unsigned int jaw, const LandmarkPointType & point) const
{
  const int index = m_ResultIndex.at(jaw);
  if (index < 0 || !m_Result.jaws[index].registered)
  {
    itkExceptionMacro("Jaw " << jaw << " was not registered: call Update() and look at GetVerdict().");
  }
  PoseJawInput input;
  input.frame = m_UsedFrames[jaw];
  const auto flat =
    PoseRegistrationKernel::LandmarkCovariance(m_Result, input, index, { { point[0], point[1], point[2] } });
  LandmarkCovarianceType covariance;
  for (unsigned int i = 0; i < 4; ++i)
  {
    covariance(i / 2, i % 2) = flat[i];
  }
  return covariance;
}

template <typename TMesh>
void
PoseRegistrationMethod<TMesh>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  const bool upper = this->GetUpperMesh() != nullptr && this->GetUpperContour() != nullptr;
  const bool lower = this->GetLowerMesh() != nullptr && this->GetLowerContour() != nullptr;
  if (!upper && !lower)
  {
    itkExceptionMacro("No jaw has both a mesh and a contour: call SetUpperMesh() and SetUpperContour(), "
                      "SetLowerMesh() and SetLowerContour(), or both pairs.");
  }
}

template <typename TMesh>
void
PoseRegistrationMethod<TMesh>::GenerateData()
{
  const GeometryType *                      nominal = this->GetGeometry();
  const std::array<const MeshType *, 2>     meshes{ { this->GetUpperMesh(), this->GetLowerMesh() } };
  const std::array<const ContourType *, 2>  contours{ { this->GetUpperContour(), this->GetLowerContour() } };
  std::array<TriangleSurface, NumberOfJaws> surfaces;
  const std::array<bool, NumberOfJaws>      present{ { meshes[0] != nullptr && contours[0] != nullptr,
                                                       meshes[1] != nullptr && contours[1] != nullptr } };
  for (unsigned int jaw = 0; jaw < NumberOfJaws; ++jaw)
  {
    m_ResultIndex[jaw] = -1;
    m_Verdicts[jaw] = RegistrationVerdict::JawVerdict();
    this->GetTransformOutput(jaw)->Set(nullptr);
    this->GetGeometryOutput(jaw)->CopyParameters(nominal);
    // The other jaw's surface serves the frame even without a contour.
    if (meshes[jaw] != nullptr)
    {
      surfaces[jaw] = MakeTriangleSurface(meshes[jaw]);
    }
  }
  m_UsedFrames = m_GivenFrames;
  m_JawsShareFrame = m_GivenFramesAreShared;
  if (!m_UseGivenFrames)
  {
    DentalFrameOptions frameOptions;
    frameOptions.refineMidline = true;
    frameOptions.abort = [this]() { return this->GetAbortGenerateData(); };
    const DentalFrameResult frames = EstimateDentalFrame(
      meshes[0] != nullptr ? &surfaces[0] : nullptr, meshes[1] != nullptr ? &surfaces[1] : nullptr, frameOptions);
    m_JawsShareFrame = frames.jawsShareFrame && frames.joint.valid;
    for (unsigned int jaw = 0; jaw < NumberOfJaws; ++jaw)
    {
      const DentalJawFrame & own = jaw == 0 ? frames.upper : frames.lower;
      const DentalJawFrame & frame = m_JawsShareFrame ? frames.joint : own;
      if (present[jaw] && !frame.valid && !this->GetAbortGenerateData())
      {
        itkExceptionMacro("No dental arch was found in the " << (jaw == 0 ? "upper" : "lower")
                                                             << " mesh. Set its frame with SetFrames().");
      }
      for (unsigned int row = 0; row < 3; ++row)
      {
        std::copy(frame.axes[row].begin(), frame.axes[row].end(), m_UsedFrames[jaw].rotation.begin() + 3 * row);
      }
      m_UsedFrames[jaw].origin = frame.origin;
    }
  }

  std::vector<PoseJawInput> inputs;
  for (unsigned int jaw = 0; jaw < NumberOfJaws; ++jaw)
  {
    if (!present[jaw])
    {
      continue;
    }
    PoseJawInput input;
    input.surface = &surfaces[jaw];
    input.frame = m_UsedFrames[jaw];
    input.upper = jaw == 0;
    for (const auto & polyline : contours[jaw]->GetPolylines())
    {
      PosePolyline converted;
      converted.tooth = polyline.code.GetFDI();
      converted.closed = polyline.closed;
      converted.weights = polyline.weights;
      for (const auto & point : polyline.points)
      {
        converted.points.push_back({ { point[0], point[1] } });
      }
      input.tracing.push_back(std::move(converted));
    }
    m_ResultIndex[jaw] = static_cast<int>(inputs.size());
    inputs.push_back(std::move(input));
  }

  PoseGeometry geometry;
  geometry.sourceToMidsagittal = nominal->GetSourceToMidsagittalDistance();
  geometry.sourceToDetector = nominal->GetSourceToDetectorDistance();
  geometry.sourceSign = nominal->GetSourceSign();
  geometry.facingSign = nominal->GetFacingSign();
  geometry.pixelSpacingKnown = nominal->HasPixelSpacing();
  geometry.principalPointKnown = m_PrincipalPointKnown;
  for (unsigned int d = 0; d < 2; ++d)
  {
    if (geometry.pixelSpacingKnown)
    {
      geometry.pixelSpacing[d] = nominal->GetPixelSpacing()[d];
    }
    geometry.principalPoint[d] = nominal->GetPrincipalPoint()[d];
  }

  PoseRegistrationOptions options = m_Options;
  options.useJointPose = m_Options.useJointPose && m_JawsShareFrame;
  options.numberOfThreads = this->GetNumberOfWorkUnits();
  options.progress = [this](double progress) {
    m_CurrentLevel = progress < 0.25 ? 0 : progress < 0.5 ? 1 : progress < 0.8 ? 2 : 3;
    this->InvokeEvent(MultiResolutionIterationEvent());
    this->InvokeEvent(IterationEvent());
    this->UpdateProgress(static_cast<float>(progress));
    return this->GetAbortGenerateData();
  };
  try
  {
    m_Result = PoseRegistrationKernel::Run(inputs, geometry, options);
  }
  catch (const std::invalid_argument & error)
  {
    itkExceptionMacro("The geometry cannot be used: " << error.what() << ". Correct it with SetGeometry().");
  }
  if (m_Result.aborted || this->GetAbortGenerateData())
  {
    this->ResetPipeline();
    ProcessAborted aborted(__FILE__, __LINE__);
    aborted.SetLocation(ITK_LOCATION);
    aborted.SetDescription("The registration was aborted.");
    throw aborted;
  }

  const auto verdicts = RegistrationVerdict::Evaluate(m_Result);
  for (unsigned int jaw = 0; jaw < NumberOfJaws; ++jaw)
  {
    const int index = m_ResultIndex[jaw];
    if (index < 0)
    {
      continue;
    }
    m_Verdicts[jaw] = verdicts[index];
    const PoseJawResult & result = m_Result.jaws[index];
    if (!result.registered)
    {
      continue;
    }
    GeometryType::RotationType rotation;
    GeometryType::VectorType   translation;
    for (unsigned int row = 0; row < 3; ++row)
    {
      translation[row] = result.translation[row];
      for (unsigned int column = 0; column < 3; ++column)
      {
        rotation(row, column) = result.rotation[3 * row + column];
      }
    }
    auto transform = TransformType::New();
    transform->SetMatrix(rotation, 1e-6);
    transform->SetOffset(translation);
    this->GetTransformOutput(jaw)->Set(transform);

    GeometryType * placed = this->GetGeometryOutput(jaw);
    const double   shrink = std::exp(-m_Result.groups[m_Result.groupOfJaw[index]].parameters[PoseKappa]);
    GeometryType::PixelSpacingType spacing;
    GeometryType::PixelIndexType   principal;
    for (unsigned int d = 0; d < 2; ++d)
    {
      spacing[d] = m_Result.geometry.pixelSpacing[d] * shrink;
      principal[d] = m_Result.geometry.principalPoint[d];
    }
    placed->SetPixelSpacing(spacing);
    placed->SetPrincipalPoint(principal);
    placed->SetPose(rotation, translation);
  }
  this->UpdateProgress(1.0f);
}

template <typename TMesh>
void
PoseRegistrationMethod<TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "TracedSide: " << static_cast<int>(m_Options.tracedSide) << std::endl;
  for (const auto & entry : PoseRegistrationOptionTable::GetEntries())
  {
    os << indent << entry.name << ": " << PoseRegistrationOptionTable::Get(m_Options, entry.name) << std::endl;
  }
  os << indent << "FixScale: " << m_Options.fixScale << std::endl;
  os << indent << "FixRotation: " << m_Options.fixRotation << std::endl;
  os << indent << "FixTranslation: " << m_Options.fixTranslation << std::endl;
  os << indent << "UseInitialPose: " << m_Options.useInitialPose << std::endl;
  os << indent << "InitialPose:";
  for (const double parameter : m_Options.initialPose)
  {
    os << ' ' << parameter;
  }
  os << std::endl;
  os << indent << "ExcludedTeeth:";
  for (const unsigned int tooth : m_Options.excludedTeeth)
  {
    os << ' ' << tooth;
  }
  os << std::endl;
  os << indent << "PrincipalPointKnown: " << m_PrincipalPointKnown << std::endl;
  os << indent << "UseGivenFrames: " << m_UseGivenFrames << std::endl;
  os << indent << "GivenFramesAreShared: " << m_GivenFramesAreShared << std::endl;
  os << indent << "JawsShareFrame: " << m_JawsShareFrame << std::endl;
  os << indent << "CurrentLevel: " << m_CurrentLevel << std::endl;
  for (unsigned int jaw = 0; jaw < NumberOfJaws; ++jaw)
  {
    os << indent << (jaw == 0 ? "Upper" : "Lower") << " ResultIndex: " << m_ResultIndex[jaw]
       << ", status: " << static_cast<int>(m_Verdicts[jaw].status) << ", reasons: " << m_Verdicts[jaw].reasons.size()
       << ", frame origin: " << m_UsedFrames[jaw].origin[0] << ' ' << m_UsedFrames[jaw].origin[1] << ' '
       << m_UsedFrames[jaw].origin[2] << std::endl;
  }
}
} // namespace itk

#endif
