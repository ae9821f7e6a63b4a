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
#include "itkCasePoseDescription.h"

#include "itkContourDistanceFilter.h"
#include "itkGroupByReason.h"
#include "itkJoinNames.h"
#include "itkLandmarkCounterpartFilter.h"
#include "itkLandmarkProjectionFilter.h"
#include "itkMatchedContourFilter.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkParallelFor.h"
#include "itkPixelSpacingVerdict.h"
#include "itkRigidTransformRows.h"

#include "itkCaseSimilarityRegistration.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;

/** mm on the detector within which the moving contour counts as matched, and what is a gap of it. */
constexpr double MatchedWithin = 2.5;
constexpr double MatchedGap = 3.0;
} // namespace

CaseAxisType::DecoratedTransformType *
FrameOf(CaseAxisType * axis, JawEnum jaw)
{
  return jaw == JawEnum::Upper ? axis->GetUpperTransformOutput() : axis->GetLowerTransformOutput();
}

std::array<double, 12>
ToRows(const PoseSolution::ProjectionMatrixType & projection)
{
  std::array<double, 12> rows;
  for (unsigned int i = 0; i < 12; ++i)
  {
    rows[i] = projection(i / 4, i % 4);
  }
  return rows;
}

void
Measure(DentalContour * tracing, DentalContour * contour, const char * name, JawResult & result)
{
  auto distances = ContourDistanceFilter::New();
  distances->SetFixedContour(tracing);
  distances->SetMovingContour(contour);
  distances->Update();
  result.metrics.emplace_back(name, ToContourFigures(distances));
  result.contours.emplace_back(name, contour);
}

ScalePrior::SpacingSource
SpacingSourceOf(const DentalRadiographData & radiograph)
{
  const PixelSpacingVerdictEnum verdict = radiograph.spacingVerdict;
  switch (radiograph.sources.pixelSpacing)
  {
    case ValueSourceEnum::Default:
    case ValueSourceEnum::Estimated:
      return ScalePrior::SpacingSource::Default;
    case ValueSourceEnum::DICOM:
      // What a file's estimated or corrected magnification hides is not the detector's pixel: it may be off by what the
      // maker assumed.
      return verdict == PixelSpacingVerdictEnum::Detector ? ScalePrior::SpacingSource::Given
                                                          : ScalePrior::SpacingSource::Dicom;
    default:
      // A ruler that somebody traced is as sure of its plane as a calibration in DICOM.
      return verdict == PixelSpacingVerdictEnum::Calibrated ? ScalePrior::SpacingSource::Dicom
                                                            : ScalePrior::SpacingSource::Given;
  }
}

void
DescribePlacedJaw(const PoseSolution &           solution,
                  JawEnum                        jaw,
                  double                         millimetresPerUnit,
                  const LandmarkCounterpartSet * counterparts,
                  JawResult &                    result)
{
  const PoseJawResult &   own = solution.GetJaw(jaw);
  const PoseGroupResult & group = solution.GetGroup(jaw);
  result.registered = true;
  result.projection = ToRows(solution.GetProjectionMatrix(jaw, millimetresPerUnit));
  result.meshToCephalostat = ToRows(*solution.MakeRigidTransform(jaw));
  result.pose = { ToRows(own.frame), group.parameters, group.covariance };
  for (const PoseLandmarkFit & landmark : own.landmarks)
  {
    result.usedLandmarks.push_back({ landmark.name,
                                     counterparts->Find(landmark.name)->source,
                                     landmark.residual,
                                     landmark.distance,
                                     landmark.weight });
  }
  for (const PoseOutlineFit & outline : own.outlines)
  {
    result.usedOutlines.push_back({ outline.name,
                                    outline.shift,
                                    outline.shiftDistance,
                                    outline.distance,
                                    outline.weight,
                                    outline.matchedShare,
                                    outline.isTemplate,
                                    outline.templateOf,
                                    outline.templateDistance });
  }
}

std::array<DentalContour::Pointer, 2>
MakeWholeSilhouettes(const DentalCaseData &              data,
                     const PoseSolution &                solution,
                     const std::array<unsigned int, 2> & numberOfPoints,
                     unsigned int                        numberOfThreads)
{
  using MeshType = DentalCaseData::MeshType;
  // Each thread has a data object of its own that nobody makes: what fills the other's output is not updated again
  // under its hands.
  std::array<MeshType::Pointer, 2>              meshes;
  std::array<CephalometricGeometry::Pointer, 2> geometries;
  std::array<DentalContour::Pointer, 2>         silhouettes;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (solution.IsRegistered(jaw))
    {
      const std::size_t i = jaw == JawEnum::Upper ? 0 : 1;
      meshes[i] = MeshType::New();
      meshes[i]->Graft(data.GetJaw(jaw).mesh);
      geometries[i] = CephalometricGeometry::New();
      solution.CopyToGeometry(jaw, geometries[i]);
    }
  }
  ParallelFor(2, numberOfThreads, [&](std::size_t i) {
    if (meshes[i].IsNull())
    {
      return;
    }
    auto silhouette = MeshSilhouetteContourSource<MeshType>::New();
    silhouette->SetInput(meshes[i]);
    silhouette->SetGeometry(geometries[i]);
    silhouette->LargestPartOnlyOn();
    silhouette->SetNumberOfPoints(numberOfPoints[i]);
    silhouette->Update();
    silhouettes[i] = silhouette->GetOutput();
    silhouettes[i]->DisconnectPipeline();
  });
  return silhouettes;
}

std::vector<std::array<double, 3>>
CollectRimPoints(const DentalContour & contour)
{
  std::vector<std::array<double, 3>> points;
  for (DentalContour::PointIdentifier id = 0; contour.HasRimPoints() && id < contour.GetNumberOfPoints(); ++id)
  {
    const auto rim = contour.GetRimPoint(id);
    points.push_back({ { rim[0], rim[1], rim[2] } });
  }
  return points;
}

void
DescribeWithoutDistances(const PoseSolution & solution, JawEnum jaw, DentalContour * whole, JawResult & result)
{
  result.contours.emplace_back("whole", whole);
  auto crowns = DentalContour::New();
  for (const PoseOutlineFit & outline : solution.GetJaw(jaw).outlines)
  {
    DentalContour::PolylineType line;
    for (const auto & pixel : outline.crown)
    {
      line.points.emplace_back(pixel.data());
    }
    crowns->AddPolyline(line);
  }
  if (crowns->GetNumberOfPoints() > 0)
  {
    result.contours.emplace_back("matched", crowns);
  }
}

void
MeasureMatched(DentalContour * tracing, const PoseSolution & solution, JawEnum jaw, JawResult & result)
{
  const auto & spacing = solution.GetResult().geometry.pixelSpacing;
  const double pixel = 0.5 * (spacing[0] + spacing[1]);
  auto         matched = MatchedContourFilter::New();
  matched->SetFixedContour(tracing);
  matched->SetMovingContour(solution.MakeMovingContour(jaw));
  matched->SetMaximumDistance(MatchedWithin / pixel);
  matched->SetMaximumGap(MatchedGap / pixel);
  matched->Update();
  result.outline = CollectRimPoints(*matched->GetOutput());
  if (matched->GetOutput()->GetNumberOfPoints() > 0)
  {
    DentalContour::Pointer contour = matched->GetOutput();
    contour->DisconnectPipeline();
    Measure(tracing, contour, "matched", result);
  }
}

void
MeasureTeeth(DentalContour * tracing, DentalContour * contour, JawResult & jaw)
{
  auto distances = ContourDistanceFilter::New();
  distances->SetFixedContour(tracing);
  distances->SetMovingContour(contour);
  distances->SetDistance(ContourDistanceFilter::DistanceEnum::PointToSegment);
  distances->Update();
  jaw.tracingDistances = distances->GetFixedToMovingDistances();
  for (const auto & tooth : distances->GetFixedToMovingDistancesByTooth())
  {
    jaw.residuals.push_back({ tooth.tooth.GetName(), tooth.numberOfPoints, tooth.mean, tooth.rms, tooth.maximum });
  }
}

namespace
{
bool
HasLandmarks(const DentalCaseData & data, JawEnum jaw)
{
  if (data.landmarks3D.IsNull())
  {
    return false;
  }
  const auto & all = data.landmarks3D->GetLandmarks();
  return std::any_of(all.begin(), all.end(), [jaw](const auto & landmark) { return landmark.tooth.GetJaw() == jaw; });
}

/** The filter that finds points of a case on its scans. */
LandmarkCounterpartFilter::Pointer
MakeCounterpartFilter(const DentalCaseData &           data,
                      CaseAxisType *                   axis,
                      const std::vector<std::string> & unusableLandmarks)
{
  auto filter = LandmarkCounterpartFilter::New();
  if (data.landmarks3D.IsNotNull())
  {
    filter->SetScanLandmarks(data.landmarks3D);
    filter->SetUnusableLandmarks(unusableLandmarks);
    filter->SetMillimetresPerUnit(data.description.millimetresPerUnit);
  }
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (data.GetJaw(jaw).mesh.IsNull())
    {
      continue;
    }
    filter->SetLabels(jaw, data.GetJaw(jaw).labels);
    if (jaw == JawEnum::Upper)
    {
      filter->SetUpperMesh(data.upper.mesh);
      filter->SetUpperFrame(FrameOf(axis, jaw));
    }
    else
    {
      filter->SetLowerMesh(data.lower.mesh);
      filter->SetLowerFrame(FrameOf(axis, jaw));
    }
  }
  filter->SetExcludedTeeth(data.description.excludedTeeth);
  return filter;
}

/** Points whose middles a person asks for, found on the scans: the incisal edge and the mesiobuccal cusp of the first
 * molar, and whatever was marked. Of a jaw with landmarks these are told where the drawing is of middles. Null where
 * there is nothing to look for. */
LandmarkCounterpartSet::Pointer
FindMiddlePoints(const DentalCaseData &           data,
                 const PoseSolution *             solution,
                 CaseAxisType *                   axis,
                 const std::vector<std::string> & unusableLandmarks)
{
  using MeaningType = CephalometricLandmarkSet::MeaningType;
  using FeatureEnum = CephalometricLandmarkSet::FeatureEnum;
  const bool bisected = IsBisected(data.description.tracedSide);
  auto       wanted = CephalometricLandmarkSet::New();
  const auto want = [&](MeaningType meaning) {
    if (!solution->IsRegistered(meaning.jaw) || (HasLandmarks(data, meaning.jaw) && !bisected))
    {
      return;
    }
    // The place does not matter: it is the point of the tooth that is looked for, of both sides.
    meaning.tooth = ToothCode();
    const std::string name = CephalometricLandmarkSet::MakeName(meaning);
    if (wanted->Find(name) == nullptr)
    {
      wanted->AddLandmark(name, CephalometricLandmarkSet::PointType());
    }
  };
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    want({ jaw, 1, ToothCode(), FeatureEnum::Tip });
    want({ jaw, 6, ToothCode(), FeatureEnum::MesiobuccalCusp });
  }
  if (data.cephalometricLandmarks.IsNotNull())
  {
    for (const auto & landmark : data.cephalometricLandmarks->GetLandmarks())
    {
      if (landmark.meaning.feature != FeatureEnum::Apex)
      {
        want(landmark.meaning);
      }
    }
  }
  if (wanted->GetNumberOfLandmarks() == 0)
  {
    return nullptr;
  }
  const auto filter = MakeCounterpartFilter(data, axis, unusableLandmarks);
  filter->SetCephalometricLandmarks(wanted);
  filter->IgnoreSidesOn();
  // Whole teeth of a cephalometric analysis were compared with crowns that stand at the textbook's places: they place
  // the jaw and not the tooth.
  if (data.description.tracedSide != TracedSideEnum::Standard)
  {
    filter->SetSolution(solution);
    filter->SetUpperTracing(data.upper.contour);
    filter->SetLowerTracing(data.lower.contour);
    filter->SetBisected(bisected);
  }
  filter->Update();
  LandmarkCounterpartSet::Pointer found = filter->GetOutput();
  found->DisconnectPipeline();
  return found;
}
} // namespace

void
ProjectLandmarks(const DentalCaseData & data, const PoseSolution * solution, CaseAxisType * axis, CaseResult & result)
{
  const auto found = axis != nullptr ? FindMiddlePoints(data, solution, axis, result.unusableLandmarks)
                                     : LandmarkCounterpartSet::Pointer();
  if (data.landmarks3D.IsNull() && found.IsNull())
  {
    return;
  }
  auto projection = LandmarkProjectionFilter::New();
  projection->SetSolution(solution);
  projection->SetLandmarks(data.landmarks3D);
  projection->SetCounterparts(found);
  projection->SetMillimetresPerUnit(data.description.millimetresPerUnit);
  projection->SetBisected(IsBisected(data.description.tracedSide));
  projection->Update();
  const auto toRows = [](const LandmarkProjectionFilter::CovarianceType & covariance) {
    return std::array<double, 4>{ { covariance(0, 0), covariance(0, 1), covariance(1, 0), covariance(1, 1) } };
  };
  for (auto & entry : result.jaws)
  {
    JawResult & jaw = entry.second;
    if (!solution->IsRegistered(entry.first))
    {
      continue;
    }
    for (const auto & place : projection->GetOutput()->GetLandmarks())
    {
      if (place.tooth.GetJaw() != entry.first)
      {
        continue;
      }
      LandmarkPrediction landmark;
      landmark.name = place.name;
      landmark.position = { { place.point[0], place.point[1] } };
      landmark.covariance = toRows(projection->GetCovariance(place.name));
      if (projection->GetBisected() && projection->HasMiddleCovariance(place.name))
      {
        landmark.middleCovariance = toRows(projection->GetMiddleCovariance(place.name));
      }
      jaw.landmarks.push_back(landmark);
    }
    if (projection->HasExpectedError(entry.first))
    {
      jaw.expectedError = projection->GetExpectedError(entry.first);
    }
  }
  for (const auto & middle : projection->GetMiddles())
  {
    if (projection->GetBisected() || !HasLandmarks(data, middle.jaw))
    {
      result.jaws[middle.jaw].middles.push_back({ middle.name,
                                                  { { middle.point[0], middle.point[1] } },
                                                  LandmarkProjectionFilter::ToSigma(middle.covariance),
                                                  middle.source });
    }
  }
}

void
LeaveOutBoundlessError(const std::array<unsigned int, 2> & imageSize, JawResult & jaw)
{
  const auto largest = static_cast<double>(std::max(imageSize[0], imageSize[1]));
  if (jaw.expectedError && largest > 0.0 && *jaw.expectedError > largest)
  {
    jaw.expectedError.reset();
  }
}

LandmarkCounterpartSet::Pointer
FindCaseCounterparts(const DentalCaseData &               data,
                     const CephalometricLandmarkSet *     landmarks,
                     CephalometricGeometry::DirectionEnum direction,
                     bool                                 ignoreSides,
                     CaseAxisType *                       axis,
                     const std::string &                  prefix,
                     CaseResult &                         result)
{
  const auto filter = MakeCounterpartFilter(data, axis, result.unusableLandmarks);
  filter->SetCephalometricLandmarks(landmarks);
  filter->SetDirection(direction);
  filter->SetIgnoreSides(ignoreSides);
  filter->Update();
  for (const auto & entry : GroupByReason(filter->GetUnused()))
  {
    const bool several = entry.second.size() > 1;
    result.warnings.push_back(prefix + (several ? "landmarks " : "landmark ") + JoinNames(entry.second) +
                              (several ? " are" : " is") + " not used: " + entry.first);
  }
  LandmarkCounterpartSet::Pointer counterparts = filter->GetOutput();
  counterparts->DisconnectPipeline();
  return counterparts;
}
} // namespace itk
