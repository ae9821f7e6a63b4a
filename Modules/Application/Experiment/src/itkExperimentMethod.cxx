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
#include "itkExperimentMethod.h"
#include "itkExperimentMonitor.h"

#include "itkDescribePlainly.h"
#include "itkCaseRegistration.h"
#include "itkMeasureLandmarkErrors.h"
#include "itkCaseSimilarityRegistration.h"
#include "itkGeometryPlacementFilter.h"
#include "itkIntensityRegistrationMethod.h"
#include "itkMakeDentalFrameTransform.h"
#include "itkSurfaceDRRImageSource.h"
#include "itkTracingPixelSpacingFilter.h"

#include "itkTimeProbe.h"

namespace itk
{
namespace
{
using KindEnum = ExperimentMethod::KindEnum;
using ChainEnum = ExperimentMethod::ChainEnum;
using JawEnum = ToothCode::JawEnum;
using TransformType = ExperimentRunner::TransformType;
constexpr JawEnum BothJaws[] = { JawEnum::Upper, JawEnum::Lower };
/** Far enough that rays are parallel to a part in 10^5 across an arch. */
constexpr double ParallelDistance = 1e7;

const DentalJawFrame &
FrameOf(const DentalFrameResult & frames, JawEnum jaw)
{
  return frames.GetJaw(jaw);
}

CaseFrameType::Pointer
MakeFrame(const std::array<std::array<double, 3>, 3> & axes, const std::array<double, 3> & origin)
{
  auto frame = CaseFrameType::New();
  // As far as a file's axes are orthogonal.
  frame->Set(MakeDentalFrameTransform(axes, origin, 1e-6));
  return frame;
}

double
MeanSpacing(const CephalometricGeometry * geometry)
{
  return 0.5 * (geometry->GetPixelSpacing()[0] + geometry->GetPixelSpacing()[1]);
}

/** Runs a method whose inputs are set but for the start. */
TransformType::Pointer
Finish(ContourRegistrationMethodBase * method,
       const DentalContour *           tracing,
       const DentalContour *           silhouette,
       const TransformType *           start,
       const std::function<bool()> &   abort)
{
  method->SetFixedContour(tracing);
  method->SetMovingContour(silhouette);
  method->SetNumberOfWorkUnits(1);
  if (start != nullptr)
  {
    method->SetInitialTransform(start);
  }
  if (abort)
  {
    method->AddObserver(IterationEvent(), [&](const EventObject &) {
      if (abort())
      {
        method->AbortGenerateDataOn();
      }
    });
  }
  method->Update();
  auto transform = TransformType::New();
  transform->SetParameters(method->GetTransform()->GetParameters());
  return transform;
}
} // namespace

ExperimentRunner::ExperimentRunner(const ExperimentCase & experimentCase)
  : m_Case(experimentCase)
{}

bool
ExperimentRunner::HasJaw(JawEnum jaw) const
{
  const auto & input = m_Case.data->GetJaw(jaw);
  return input.mesh.IsNotNull() && input.contour.IsNotNull() && input.contour->GetNumberOfPoints() > 0;
}

auto
ExperimentRunner::Prepare(JawEnum jaw, ChainEnum chain) -> PreparedType &
{
  const auto key = std::make_pair(jaw, chain);
  const auto found = m_Prepared.find(key);
  if (found != m_Prepared.end())
  {
    return found->second;
  }
  PreparedType           prepared;
  const DentalJawFrame & own = FrameOf(m_Case.frames, jaw);
  if (!own.valid)
  {
    itkGenericExceptionMacro("the scan has no recognisable dental arch");
  }
  prepared.frame = chain == ChainEnum::FileAxes
                     ? MakeFrame(m_Case.fileAxes[jaw == JawEnum::Upper ? 0 : 1], own.centroid)
                     : MakeFrame(own.axes, own.origin);
  prepared.geometry = CephalometricGeometry::New();
  prepared.geometry->CopyParameters(m_Case.data->geometry);
  if (!prepared.geometry->HasPixelSpacing())
  {
    // One for both jaws, as CaseRegistration does.
    auto spacing = TracingPixelSpacingFilter::New();
    spacing->SetGeometry(m_Case.data->geometry);
    for (const JawEnum each : BothJaws)
    {
      const DentalJawFrame & frame = FrameOf(m_Case.frames, each);
      if (this->HasJaw(each) && frame.valid)
      {
        const auto & input = m_Case.data->GetJaw(each);
        spacing->SetJaw(each, input.mesh, input.contour, MakeFrame(frame.axes, frame.origin));
      }
    }
    spacing->Update();
    prepared.geometry->SetPixelSpacing(spacing->GetOutput()->GetPixelSpacing());
  }
  if (chain == ChainEnum::ParallelProjection)
  {
    const double magnification =
      prepared.geometry->GetSourceToDetectorDistance() / prepared.geometry->GetSourceToMidsagittalDistance();
    prepared.geometry->SetSourceToMidsagittalDistance(ParallelDistance);
    prepared.geometry->SetSourceToDetectorDistance(ParallelDistance * magnification);
  }
  auto placement = GeometryPlacementFilter::New();
  placement->SetGeometry(prepared.geometry);
  placement->SetFrame(prepared.frame);
  placement->CentralRayThroughOriginOn();
  placement->Update();
  prepared.centred = placement->GetOutput();
  prepared.centred->DisconnectPipeline();
  CaseSimilaritySettings settings;
  settings.numberOfContourPoints = jaw == JawEnum::Upper ? 441 : 439;
  prepared.silhouette =
    MakeWholeSilhouette(m_Case.data->GetJaw(jaw).mesh, prepared.frame, prepared.geometry, settings, prepared.result);
  return m_Prepared.emplace(key, std::move(prepared)).first->second;
}

auto
ExperimentRunner::Register(const ExperimentMethod & method,
                           JawEnum                  jaw,
                           PreparedType &           prepared,
                           const TransformType *    start) -> TransformType::Pointer
{
  const DentalContour * tracing = m_Case.data->GetJaw(jaw).contour;
  const DentalContour * silhouette = prepared.silhouette;
  if (!method.make)
  {
    itkGenericExceptionMacro("the method \"" << method.name << "\" has no registration of one jaw by a similarity");
  }
  const auto registration = method.make(method, MeanSpacing(prepared.geometry));
  if (method.kind == KindEnum::Intensity)
  {
    if (m_Case.data->image.IsNull())
    {
      itkGenericExceptionMacro("there is no radiograph to compare with");
    }
    if (prepared.radiograph.IsNull())
    {
      using SourceType = SurfaceDRRImageSource<DentalCaseData::MeshType, ImageType>;
      auto source = SourceType::New();
      source->SetInput(m_Case.data->GetJaw(jaw).mesh);
      source->SetGeometry(prepared.centred);
      source->SetSigma(0.5);
      source->SetOutputMode(SourceType::OutputEnum::InvertedIntensity);
      // Room for the region of interest around it.
      source->SetCoverMargin(25.0);
      source->SetNumberOfWorkUnits(1);
      source->Update();
      prepared.radiograph = source->GetOutput();
      prepared.radiograph->DisconnectPipeline();
    }
    auto * const intensity = dynamic_cast<IntensityRegistrationMethod *>(registration.GetPointer());
    if (intensity == nullptr)
    {
      itkGenericExceptionMacro("the method \"" << method.name
                                               << "\" is of kind Intensity, but its registration takes no "
                                                  "images: make an IntensityRegistrationMethod");
    }
    intensity->SetFixedImage(m_Case.data->image);
    intensity->SetMovingImage(prepared.radiograph);
  }
  return Finish(registration, tracing, silhouette, start, m_Abort);
}

JawResult
ExperimentRunner::RunJaw(const ExperimentMethod & method, JawEnum jaw, const TransformType * start)
{
  JawResult result;
  try
  {
    PreparedType & prepared = this->Prepare(jaw, method.chain);
    TimeProbe      probe;
    probe.Start();
    const auto transform = this->Register(method, jaw, prepared, start);
    probe.Stop();
    result.seconds.emplace_back("registration", probe.GetTotal());
    SetSimilarityOfJaw(*m_Case.data, jaw, prepared.frame, prepared.geometry, prepared.silhouette, transform, result);
    PredictLandmarks(*m_Case.data, jaw, result);
    result.AddFinding(
      RegistrationStatusEnum::Suspect, "unchecked-method", "this method does not check its own accuracy");
  }
  catch (const ProcessAborted &)
  {
    throw;
  }
  catch (const ExceptionObject & error)
  {
    result.registered = false;
    result.AddFinding(RegistrationStatusEnum::Failed, "not-registered", DescribePlainly(error));
  }
  return result;
}

CaseResult
ExperimentRunner::Run(const ExperimentMethod & method)
{
  CaseResult result;
  if (method.kind == KindEnum::Pose)
  {
    auto registration = CaseRegistration::New();
    registration->SetPreset(CasePresetEnum::Robust);
    for (const std::string & option : method.options)
    {
      registration->SetOption(option);
    }
    registration->SetPoseMethodCallback(method.exchange);
    registration->SetNumberOfWorkUnits(1);
    registration->SetData(m_Case.data);
    AbortWhere(m_Abort, registration);
    registration->Update();
    result = registration->GetResult();
  }
  else
  {
    result.preset = method.preset;
    result.data = m_Case.data;
    result.geometry = CephalometricGeometry::New();
    result.geometry->CopyParameters(m_Case.data->geometry);
    for (const JawEnum jaw : BothJaws)
    {
      if (this->HasJaw(jaw))
      {
        result.jaws[jaw] = this->RunJaw(method, jaw);
        const auto prepared = m_Prepared.find({ jaw, method.chain });
        if (!result.geometry->HasPixelSpacing() && prepared != m_Prepared.end())
        {
          result.geometry->SetPixelSpacing(prepared->second.geometry->GetPixelSpacing());
        }
      }
      else
      {
        result.skipped[jaw] = "no scan or no tracing";
      }
    }
  }
  MeasureLandmarkErrors(result, m_Case.marked);
  result.markedLandmarks = m_Case.marked;
  return result;
}

double
ExperimentRunner::GetMeanPixelSpacing(JawEnum jaw)
{
  return MeanSpacing(this->Prepare(jaw, ChainEnum::Paper).geometry);
}

std::vector<std::pair<std::array<double, 2>, std::array<double, 2>>>
ExperimentRunner::GetLandmarkPairs(JawEnum jaw, ChainEnum chain)
{
  const PreparedType &                                                 prepared = this->Prepare(jaw, chain);
  std::vector<std::pair<std::array<double, 2>, std::array<double, 2>>> pairs;
  if (m_Case.data->landmarks3D.IsNull())
  {
    return pairs;
  }
  for (const auto & landmark : m_Case.marked->GetLandmarks())
  {
    const auto * scanned = m_Case.data->landmarks3D->Find(landmark.name);
    if (landmark.tooth.GetJaw() == jaw && scanned != nullptr)
    {
      CephalometricGeometry::PointType point;
      for (unsigned int d = 0; d < 3; ++d)
      {
        point[d] = scanned->point[d] * m_Case.data->description.millimetresPerUnit;
      }
      const auto q = prepared.centred->ProjectPoint(point);
      pairs.push_back({ { { q[0], q[1] } }, { { landmark.point[0], landmark.point[1] } } });
    }
  }
  return pairs;
}
} // namespace itk
