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
#include "itkMakeTriangleSurface.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkSilhouetteContourFilter.h"
#include "itkSilhouetteToContourRegistrationMethod.h"
#include "itkSurfaceDRRImageSource.h"

#include "itkCommand.h"
#include "itkTimeProbe.h"

#include <cmath>
#include <sstream>

namespace itk
{
namespace
{
using MeshType = DentalCaseData::MeshType;
using ImageType = DentalCaseData::ImageType;
using MethodType = SilhouetteToContourRegistrationMethod;

/** Wide enough to close the gaps between the vertices, no wider: the border moves outward with it. mm in the detector
 * plane. */
double
ChooseSplatWidth(const MeshType * mesh, const CephalometricGeometry * geometry)
{
  const TriangleSurface surface = MakeTriangleSurface(mesh);
  const double          area = surface.Area();
  const double magnification = geometry->GetSourceToDetectorDistance() / geometry->GetSourceToMidsagittalDistance();
  const double distance = magnification * std::sqrt(area / static_cast<double>(surface.points.size()));
  // A pixel is the finest that the image can show.
  return std::max(0.5 * (geometry->GetPixelSpacing()[0] + geometry->GetPixelSpacing()[1]), 0.7 * distance);
}

void
ReportBoundsHit(const MethodType * method, JawResult & result)
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
        result.AddReason(CaseStatusEnum::Suspect, reason.str());
      }
    }
  }
}
} // namespace

CephalometricGeometry::Pointer
MakeCentredGeometry(const CephalometricGeometry * geometry, const DentalJawFrame & frame)
{
  auto centred = CephalometricGeometry::New();
  centred->CopyParameters(geometry);
  CephalometricGeometry::PixelIndexType origin;
  origin.Fill(0.0);
  centred->SetPrincipalPoint(origin);
  CephalometricGeometry::RotationType rotation;
  CephalometricGeometry::VectorType   translation;
  for (unsigned int row = 0; row < 3; ++row)
  {
    translation[row] = 0.0;
    for (unsigned int column = 0; column < 3; ++column)
    {
      rotation(row, column) = frame.axes[row][column];
      translation[row] -= frame.axes[row][column] * frame.origin[column];
    }
  }
  centred->SetPose(rotation, translation);
  return centred;
}

DentalContour::Pointer
MakeWholeSilhouette(const MeshType *               mesh,
                    CephalometricGeometry *        geometry,
                    const CaseSimilaritySettings & settings,
                    JawResult &                    result)
{
  TimeProbe projectionProbe;
  TimeProbe contourProbe;
  auto      resample = ContourResampleFilter::New();
  resample->SetNumberOfPoints(settings.numberOfContourPoints);
  if (settings.useSurfaceDRR)
  {
    projectionProbe.Start();
    using SourceType = SurfaceDRRImageSource<MeshType, ImageType>;
    auto source = SourceType::New();
    source->SetInput(mesh);
    source->SetGeometry(geometry);
    source->SetSigma(ChooseSplatWidth(mesh, geometry));
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
    source->SetGeometry(geometry);
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

std::array<double, 12>
PlaceInCephalostat(const std::array<double, 12> & meshToFrame,
                   const SimilarityParameters &   similarity,
                   const CephalometricGeometry *  geometry)
{
  const double f = geometry->GetFacingSign();
  const double c = std::cos(similarity.rotation);
  const double s = f * std::sin(similarity.rotation);
  // The scale is a factor on the magnification, as the pose registration's is: a pixel is so many mm fewer or more.
  const double m =
    similarity.scale * geometry->GetSourceToDetectorDistance() / geometry->GetSourceToMidsagittalDistance();
  const double shift[3] = {
    f * (similarity.translation[0] - geometry->GetPrincipalPoint()[0]) * geometry->GetPixelSpacing()[0] / m,
    0.0,
    -(similarity.translation[1] - geometry->GetPrincipalPoint()[1]) * geometry->GetPixelSpacing()[1] / m
  };
  const double           rotation[3][3] = { { c, 0.0, s }, { 0.0, 1.0, 0.0 }, { -s, 0.0, c } };
  std::array<double, 12> placed{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 4; ++column)
    {
      double sum = column == 3 ? shift[row] : 0.0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        sum += rotation[row][d] * meshToFrame[4 * d + column];
      }
      placed[4 * row + column] = sum;
    }
  }
  return placed;
}

std::array<double, 12>
MeshToFrame(const DentalJawFrame & frame)
{
  std::array<double, 12> matrix{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      matrix[4 * row + column] = frame.axes[row][column];
      matrix[4 * row + 3] -= frame.axes[row][column] * frame.origin[column];
    }
  }
  return matrix;
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
  const auto & m = result.projection;
  for (const auto & landmark : data.landmarks3D->GetLandmarks())
  {
    if (landmark.tooth.GetJaw() != jaw)
    {
      continue;
    }
    double sums[3];
    for (unsigned int row = 0; row < 3; ++row)
    {
      sums[row] = m[4 * row] * landmark.point[0] + m[4 * row + 1] * landmark.point[1] +
                  m[4 * row + 2] * landmark.point[2] + m[4 * row + 3];
    }
    LandmarkPrediction prediction;
    prediction.name = landmark.name;
    prediction.position = { { sums[0] / sums[2], sums[1] / sums[2] } };
    result.landmarks.push_back(prediction);
  }
}

double
EstimatePixelSpacing(const DentalCaseData & data, ToothCode::JawEnum jaw, const DentalJawFrame & frame)
{
  // Unit spacing makes the projection come out in mm of the detector plane.
  auto geometry = CephalometricGeometry::New();
  geometry->CopyParameters(data.geometry);
  geometry->SetPixelSpacing(CephalometricGeometry::PixelSpacingType(1.0));
  const auto   centred = MakeCentredGeometry(geometry, frame);
  const auto   projection = centred->GetProjection();
  double       low = NumericTraits<double>::max();
  double       high = NumericTraits<double>::NonpositiveMin();
  const auto * points = data.GetJaw(jaw).mesh->GetPoints();
  for (auto it = points->Begin(); it != points->End(); ++it)
  {
    const double point[3] = { it.Value()[0], it.Value()[1], it.Value()[2] };
    double       u = 0.0;
    double       v = 0.0;
    projection.Project(point, u, v);
    low = std::min(low, u);
    high = std::max(high, u);
  }
  const auto * box = data.GetJaw(jaw).contour->GetBoundingBox();
  const double width = box->GetMaximum()[0] - box->GetMinimum()[0];
  return width > 0.0 ? (high - low) / width : 0.25;
}

void
RegisterJawBySimilarity(const DentalCaseData &         data,
                        ToothCode::JawEnum             jaw,
                        const DentalJawFrame &         frame,
                        const CephalometricGeometry *  geometry,
                        const CaseSimilaritySettings & settings,
                        JawResult &                    result)
{
  const auto      centred = MakeCentredGeometry(geometry, frame);
  DentalContour * tracing = data.GetJaw(jaw).contour;
  const auto      silhouette = MakeWholeSilhouette(data.GetJaw(jaw).mesh, centred, settings, result);

  TimeProbe probe;
  probe.Start();
  auto method = MethodType::New();
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
    auto                                      transform = MethodType::TransformType::New();
    MethodType::TransformType::ParametersType parameters(4);
    parameters[0] = initial->second.scale;
    parameters[1] = initial->second.rotation;
    parameters[2] = initial->second.translation[0];
    parameters[3] = initial->second.translation[1];
    transform->SetParameters(parameters);
    method->SetInitialTransform(transform);
  }
  if (settings.caller != nullptr)
  {
    method->AddObserver(IterationEvent(), [&](const EventObject &) {
      if (settings.caller->GetAbortGenerateData())
      {
        method->AbortGenerateDataOn();
      }
    });
  }
  method->Update();
  probe.Stop();
  result.seconds.emplace_back("registration", probe.GetTotal());

  SetSimilarityOfJaw(data, jaw, frame, geometry, centred, silhouette, method->GetTransform(), result);
  ReportBoundsHit(method, result);
}

void
SetSimilarityOfJaw(const DentalCaseData &                data,
                   ToothCode::JawEnum                    jaw,
                   const DentalJawFrame &                frame,
                   const CephalometricGeometry *         geometry,
                   const CephalometricGeometry *         centred,
                   DentalContour *                       silhouette,
                   const Similarity2DTransform<double> * transform,
                   JawResult &                           result)
{
  const auto parameters = transform->GetParameters();
  result.similarity = { parameters[0], parameters[1], { { parameters[2], parameters[3] } } };
  result.registered = true;

  // Similarity x projection x unit, as one matrix.
  const double c = result.similarity.scale * std::cos(result.similarity.rotation);
  const double s = result.similarity.scale * std::sin(result.similarity.rotation);
  const double rows[3][3] = { { c, -s, result.similarity.translation[0] },
                              { s, c, result.similarity.translation[1] },
                              { 0.0, 0.0, 1.0 } };
  const auto   projection = centred->GetProjectionMatrix();
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 4; ++column)
    {
      double sum = 0.0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        sum += rows[row][d] * projection(d, column);
      }
      result.projection[4 * row + column] = column < 3 ? sum * data.description.millimetresPerUnit : sum;
    }
  }
  result.meshToUMDA = MeshToFrame(frame);
  result.meshToCephalostat = PlaceInCephalostat(result.meshToUMDA, result.similarity, geometry);

  auto distances = ContourDistanceFilter::New();
  distances->SetFixedContour(data.GetJaw(jaw).contour);
  distances->SetMovingContour(silhouette);
  distances->SetTransform(transform);
  distances->Update();
  result.metrics.emplace_back("whole", ToContourFigures(distances));

  auto aligned = DentalContour::New();
  for (auto polyline : silhouette->GetPolylines())
  {
    for (auto & point : polyline.points)
    {
      point = transform->TransformPoint(point);
    }
    aligned->AddPolyline(polyline);
  }
  result.contours.emplace_back("whole", aligned);
}
} // namespace itk
