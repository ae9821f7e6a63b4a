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
#include "itkCaseSimilarityRegistration.h"

#include "itkContourDistanceFilter.h"
#include "itkContourResampleFilter.h"
#include "itkContourTransformFilter.h"
#include "itkGeometryPlacementFilter.h"
#include "itkLandmarkMatrixProjectionFilter.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkRegistrationCourseRecorder.h"
#include "itkRigidTransformRows.h"
#include "itkSilhouetteContourFilter.h"
#include "itkSilhouetteToContourRegistrationMethod.h"
#include "itkSimilarityPlacementFilter.h"
#include "itkSurfaceDRRImageSource.h"
#include "itkSurfaceSplatWidthCalculator.h"

#include "itkCommand.h"
#include "itkTimeProbe.h"

#include <cmath>
#include <sstream>
#include <typeinfo>

namespace itk
{
namespace
{
using MeshType = DentalCaseData::MeshType;
using ImageType = DentalCaseData::ImageType;
using SimilarityMethodType = SilhouetteToContourRegistrationMethod;

Similarity2DTransform<double>::Pointer
MakeSimilarity(const SimilarityParameters & similarity)
{
  auto                                          transform = Similarity2DTransform<double>::New();
  Similarity2DTransform<double>::ParametersType parameters(4);
  parameters[0] = similarity.scale;
  parameters[1] = similarity.rotation;
  parameters[2] = similarity.translation[0];
  parameters[3] = similarity.translation[1];
  transform->SetParameters(parameters);
  return transform;
}

void
ReportBoundsHit(const SimilarityMethodType * method, JawResult & result)
{
  const auto & levels = method->GetLevelResults();
  if (levels.empty())
  {
    return;
  }
  static const char * const names[] = { "scale", "rotation", "horizontal shift", "vertical shift" };
  for (std::size_t level = 0; level < levels.size(); ++level)
  {
    for (unsigned int parameter = 0; parameter < 4; ++parameter)
    {
      if (levels[level].boundsHit[parameter] != 0)
      {
        std::ostringstream reason;
        reason << "the " << names[parameter] << " ran into the bound of level " << level + 1;
        result.AddFinding(RegistrationStatusEnum::Suspect, "bound-reached", reason.str());
      }
    }
  }
}
/** What the method did level by level, and where the jaw was when each began. */
void
KeepCourse(const SimilarityMethodType *       method,
           const RegistrationCourseRecorder & recorder,
           ToothCode::JawEnum                 jaw,
           JawResult &                        result)
{
  const auto &                        levels = method->GetLevelResults();
  std::map<unsigned int, std::string> names;
  for (std::size_t level = 0; level < levels.size(); ++level)
  {
    names[static_cast<unsigned int>(level)] = "level " + std::to_string(level + 1);
    result.stages.push_back({ names[static_cast<unsigned int>(level)], {}, levels[level].initialParameters });
  }
  const auto parameters = method->GetTransform()->GetParameters();
  // Radians and scales beside pixels: an outline is some hundred pixels long.
  const auto distance = [](const std::vector<double> & a, const std::vector<double> & b) {
    constexpr double pixelsOfOutline = 100.0;
    return std::hypot(std::hypot(pixelsOfOutline * (a[0] - b[0]), pixelsOfOutline * (a[1] - b[1])),
                      std::hypot(a[2] - b[2], a[3] - b[3]));
  };
  result.course = recorder.Finish(0, { jaw }, names, { parameters.begin(), parameters.end() }, distance);
  for (RegistrationStageCourse & stage : result.course)
  {
    for (std::size_t level = 0; level < levels.size(); ++level)
    {
      if (stage.name == names[static_cast<unsigned int>(level)])
      {
        stage.stopCondition = levels[level].stopConditionDescription;
      }
    }
  }
}
} // namespace

DentalContour::Pointer
MakeWholeSilhouette(const MeshType *               mesh,
                    const CaseFrameType *          frame,
                    const CephalometricGeometry *  geometry,
                    const CaseSimilaritySettings & settings,
                    JawResult &                    result)
{
  auto placement = GeometryPlacementFilter::New();
  placement->SetGeometry(geometry);
  placement->SetFrame(frame);
  placement->CentralRayThroughOriginOn();
  placement->Update();
  CephalometricGeometry * centred = placement->GetOutput();
  TimeProbe               projectionProbe;
  TimeProbe               contourProbe;
  auto                    resample = ContourResampleFilter::New();
  resample->SetNumberOfPoints(settings.numberOfContourPoints);
  if (settings.useSurfaceDRR)
  {
    projectionProbe.Start();
    auto width = SurfaceSplatWidthCalculator::New();
    width->SetMesh(mesh);
    width->SetGeometry(centred);
    width->Update();
    using SourceType = SurfaceDRRImageSource<MeshType, ImageType>;
    auto source = SourceType::New();
    source->SetInput(mesh);
    source->SetGeometry(centred);
    source->SetSigma(width->GetSigma());
    // Four widths of the splats: the iso-contour must not touch the image's border.
    source->SetSizeToCoverMeshes(4.0 * source->GetSigma());
    source->Update();
    projectionProbe.Stop();

    contourProbe.Start();
    using FilterType = SilhouetteContourFilter<ImageType>;
    auto filter = FilterType::New();
    filter->SetInput(source->GetOutput());
    // Inside the silhouette the ray crosses at least one shell, outside none: half a shell is the border. A fraction of
    // the maximum would follow the dense, grazing parts instead.
    filter->SetLevel(FilterType::LevelEnum::Absolute);
    filter->SetLevelValue(0.5 * source->GetDensity());
    resample->SetInput(filter->GetOutput());
    resample->Update();
    contourProbe.Stop();
  }
  else
  {
    contourProbe.Start();
    auto source = MeshSilhouetteContourSource<MeshType>::New();
    source->SetInput(mesh);
    source->SetGeometry(centred);
    resample->SetInput(source->GetOutput());
    resample->Update();
    contourProbe.Stop();
  }
  result.seconds.emplace_back("projection", projectionProbe.GetTotal());
  result.seconds.emplace_back("contour", contourProbe.GetTotal());
  DentalContour::Pointer silhouette = resample->GetOutput();
  silhouette->DisconnectPipeline();
  return silhouette;
}

VersorRigid3DTransform<double>::ConstPointer
PlaceInCephalostat(const CaseFrameType *         frame,
                   const SimilarityParameters &  similarity,
                   const CephalometricGeometry * geometry)
{
  auto placement = SimilarityPlacementFilter::New();
  placement->SetSimilarity(MakeSimilarity(similarity));
  placement->SetFrame(frame);
  placement->SetGeometry(geometry);
  placement->Update();
  return placement->GetTransform();
}

ContourFigures
ToContourFigures(const ContourDistanceFilter * distances)
{
  return { distances->GetChamfer(),
           distances->GetHausdorff(),
           distances->GetMovingToFixedMean(),
           distances->GetFixedToMovingMean() };
}

void
PredictLandmarks(const DentalCaseData & data, ToothCode::JawEnum jaw, JawResult & result)
{
  if (data.landmarks3D.IsNull())
  {
    return;
  }
  LandmarkMatrixProjectionFilter::ProjectionMatrixType matrix;
  for (unsigned int i = 0; i < 12; ++i)
  {
    matrix(i / 4, i % 4) = result.projection[i];
  }
  auto projection = LandmarkMatrixProjectionFilter::New();
  projection->SetLandmarks(data.landmarks3D);
  projection->SetProjectionMatrix(matrix);
  projection->SetJaw(jaw);
  projection->Update();
  for (const auto & landmark : projection->GetOutput()->GetLandmarks())
  {
    LandmarkPrediction prediction;
    prediction.name = landmark.name;
    prediction.position = { { landmark.point[0], landmark.point[1] } };
    result.landmarks.push_back(prediction);
  }
}

void
RegisterJawBySimilarity(const DentalCaseData &         data,
                        ToothCode::JawEnum             jaw,
                        const CaseFrameType *          frame,
                        const CephalometricGeometry *  geometry,
                        const CaseSimilaritySettings & settings,
                        JawResult &                    result)
{
  DentalContour * tracing = data.GetJaw(jaw).contour;
  const auto      silhouette = MakeWholeSilhouette(data.GetJaw(jaw).mesh, frame, geometry, settings, result);

  TimeProbe probe;
  probe.Start();
  auto method = SimilarityMethodType::New();
  method->SetFixedContour(tracing);
  method->SetMovingContour(silhouette);
  method->SetPixelSpacing(0.5 * (geometry->GetPixelSpacing()[0] + geometry->GetPixelSpacing()[1]));
  switch (settings.preset)
  {
    case CasePresetEnum::BoundingBox:
      method->SetPresetToBoundingBox();
      break;
    case CasePresetEnum::SingleStage:
      method->SetPresetToSingleStage();
      break;
    default:
      method->SetPresetToPaper();
      break;
  }
  method->SetFixScale(data.description.fixScale);
  method->SetFixRotation(data.description.fixRotation);
  method->SetFixTranslation(data.description.fixTranslation);
  const auto initial = data.description.initialSimilarity.find(jaw);
  if (initial != data.description.initialSimilarity.end())
  {
    method->SetInitialTransform(MakeSimilarity(initial->second));
  }
  RegistrationCourseRecorder recorder;
  auto                       steps = FunctionCommand::New();
  steps->SetCallback([&](const EventObject & event) {
    // The exact type: optimizers send subclasses for mere evaluations.
    if (typeid(event) == typeid(IterationEvent))
    {
      const auto position = method->GetOptimizerPosition();
      recorder.Add(0,
                   method->GetCurrentLevel(),
                   method->GetCurrentCandidate(),
                   { method->GetMetricValue(), method->GetStepAccepted(), 0.0, 0.0 },
                   { position.begin(), position.end() });
    }
  });
  const auto tag = method->AddObserver(IterationEvent(), steps);
  if (settings.run)
  {
    settings.run(method);
  }
  else
  {
    method->Update();
  }
  method->RemoveObserver(tag);
  probe.Stop();
  KeepCourse(method, recorder, jaw, result);
  result.seconds.emplace_back("registration", probe.GetTotal());

  SetSimilarityOfJaw(data, jaw, frame, geometry, silhouette, method->GetTransform(), result);
  ReportBoundsHit(method, result);
}

void
SetSimilarityOfJaw(const DentalCaseData &                data,
                   ToothCode::JawEnum                    jaw,
                   const CaseFrameType *                 frame,
                   const CephalometricGeometry *         geometry,
                   DentalContour *                       silhouette,
                   const Similarity2DTransform<double> * transform,
                   JawResult &                           result)
{
  const auto parameters = transform->GetParameters();
  result.similarity = { parameters[0], parameters[1], { { parameters[2], parameters[3] } } };
  result.registered = true;

  auto placement = SimilarityPlacementFilter::New();
  placement->SetSimilarity(transform);
  placement->SetFrame(frame);
  placement->SetGeometry(geometry);
  placement->SetMillimetresPerUnit(data.description.millimetresPerUnit);
  placement->Update();
  for (unsigned int i = 0; i < 12; ++i)
  {
    result.projection[i] = placement->GetProjectionMatrix()(i / 4, i % 4);
  }
  result.meshToUMDA = ToRows(*frame->Get());
  result.meshToCephalostat = ToRows(*placement->GetTransform());

  auto distances = ContourDistanceFilter::New();
  distances->SetFixedContour(data.GetJaw(jaw).contour);
  distances->SetMovingContour(silhouette);
  distances->SetTransform(transform);
  distances->Update();
  result.metrics.emplace_back("whole", ToContourFigures(distances));

  auto aligned = ContourTransformFilter::New();
  aligned->SetInput(silhouette);
  aligned->SetTransform(transform);
  aligned->Update();
  DentalContour::Pointer contour = aligned->GetOutput();
  contour->DisconnectPipeline();
  result.contours.emplace_back("whole", contour);
}
} // namespace itk
