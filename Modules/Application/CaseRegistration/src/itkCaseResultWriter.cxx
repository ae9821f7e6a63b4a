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
#include "itkCaseResultWriter.h"

#include "itkCaseOverlay.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalInputError.h"
#include "itkDentalSCRVersion.h"
#include "itkCephalometricLandmarkSet.h"
#include "itkLandmarkErrorFilter.h"
#include "itkMemoryFile.h"
#include "itkOutputFolder.h"
#include "itkReadDentalMesh.h"
#include "itkTextFile.h"
#include "itkTransformFile.h"

#include "itkSimilarity2DTransform.h"
#include "itkVersorRigid3DTransform.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

namespace itk
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using JawEnum = ToothCode::JawEnum;
using MeshType = DentalCaseData::MeshType;

const char *
Name(JawEnum jaw)
{
  return jaw == JawEnum::Upper ? "upper" : "lower";
}

Json
MatrixToJson(const std::array<double, 12> & matrix)
{
  Json rows = Json::array();
  for (unsigned int row = 0; row < 3; ++row)
  {
    rows.push_back({ matrix[4 * row], matrix[4 * row + 1], matrix[4 * row + 2], matrix[4 * row + 3] });
  }
  return rows;
}

template <typename TValue>
Json
Provenance(const TValue & value, ValueSourceEnum source)
{
  return { { "value", value }, { "source", ToString(source) } };
}

Json
GeometryToJson(const CaseResult & result)
{
  const auto & geometry = *result.geometry;
  const auto & sources = result.data->sources;
  Json         json;
  json["source_to_midsagittal_mm"] = Provenance(geometry.GetSourceToMidsagittalDistance(), sources.sourceToMidsagittal);
  json["source_to_detector_mm"] = Provenance(geometry.GetSourceToDetectorDistance(), sources.sourceToDetector);
  json["source_side"] = Provenance(
    geometry.GetSourceSide() == CephalometricGeometry::SourceSideEnum::Right ? "right" : "left", sources.sourceSide);
  json["facing"] =
    Provenance(geometry.GetFacing() == CephalometricGeometry::FacingEnum::Right ? "right" : "left", sources.facing);
  json["pixel_spacing_mm"] =
    Provenance(Json::array({ geometry.GetPixelSpacing()[0], geometry.GetPixelSpacing()[1] }), sources.pixelSpacing);
  json["pixel_spacing_mm"]["verdict"] = result.data->spacingVerdict;
  json["pixel_spacing_mm"]["how"] = result.data->spacingProvenance;
  json["principal_point_px"] = Provenance(
    Json::array({ geometry.GetPrincipalPoint()[0], geometry.GetPrincipalPoint()[1] }), sources.principalPoint);
  return json;
}

/** What a person has set of the registration; empty where nothing. */
Json
ControlToJson(const DentalCase & description)
{
  Json json = Json::object();
  for (const ToothCode & tooth : description.excludedTeeth)
  {
    json["exclude"].push_back(tooth.GetName());
  }
  for (const auto & held : { std::make_pair("scale", description.fixScale),
                             std::make_pair("rotation", description.fixRotation),
                             std::make_pair("translation", description.fixTranslation) })
  {
    if (held.second)
    {
      json["fix"].push_back(held.first);
    }
  }
  if (description.HasStart())
  {
    json["init"] = true;
  }
  return json;
}

Json
FiguresToJson(const ContourFigures & figures)
{
  return { { "chamfer_px", figures.chamfer },
           { "hausdorff_px", figures.hausdorff },
           { "ios_to_cr_px", figures.movingToFixed },
           { "cr_to_ios_px", figures.fixedToMoving } };
}

Json
ToJson(const std::vector<RegistrationFinding> & findings)
{
  Json list = Json::array();
  for (const RegistrationFinding & finding : findings)
  {
    Json item = { { "code", finding.code }, { "severity", ToString(finding.severity) }, { "text", finding.text } };
    if (finding.value && finding.limit)
    {
      item["value"] = *finding.value;
      item["limit"] = *finding.limit;
      item["unit"] = finding.unit;
    }
    list.push_back(item);
  }
  return list;
}

Json
PoseToJson(const JawPose & pose)
{
  Json rows = Json::array();
  for (unsigned int row = 0; row < 7; ++row)
  {
    rows.push_back(std::vector<double>(pose.covariance.begin() + 7 * row, pose.covariance.begin() + 7 * (row + 1)));
  }
  return { { "mesh_to_dental_mm", MatrixToJson(pose.frame) },
           { "parameters", pose.parameters },
           { "covariance", std::move(rows) } };
}

Json
PoseSigmaToJson(const JawPose & pose)
{
  constexpr double degrees = 180.0 / 3.14159265358979323846;
  const auto       sigma = [&](unsigned int k) { return std::sqrt(pose.covariance[8 * k]); };
  return { { "pitch_deg", degrees * sigma(0) },
           { "roll_deg", degrees * sigma(1) },
           { "yaw_deg", degrees * sigma(2) },
           { "x_mm", sigma(3) },
           { "y_mm", sigma(4) },
           { "z_mm", sigma(5) },
           { "scale", sigma(6) } };
}

Json
JawToJson(const JawResult & jaw)
{
  Json json;
  json["status"] = ToString(jaw.status);
  json["reasons"] = jaw.GetReasons();
  json["findings"] = ToJson(jaw.findings);
  if (jaw.registered)
  {
    json["projection_3x4"] = MatrixToJson(jaw.projection);
    json["similarity"] = { { "scale", jaw.similarity.scale },
                           { "rotation_rad", jaw.similarity.rotation },
                           { "translation_px", jaw.similarity.translation } };
    json["mesh_to_umda_mm"] = MatrixToJson(jaw.meshToUMDA);
    json["mesh_to_cephalostat_mm"] = MatrixToJson(jaw.meshToCephalostat);
    if (jaw.pose)
    {
      json["pose"] = PoseToJson(*jaw.pose);
      json["pose_sigma"] = PoseSigmaToJson(*jaw.pose);
    }
    for (const AlignmentCandidate & candidate : jaw.candidates)
    {
      json["candidates"].push_back({ { "projection_3x4", MatrixToJson(candidate.projection) },
                                     { "score", candidate.score },
                                     { "distance_px", candidate.distance } });
    }
    if (!jaw.metrics.empty())
    {
      Json & metrics = json["metrics"] = { { "moving_contour", jaw.metrics.front().first } };
      metrics.update(FiguresToJson(jaw.metrics.front().second));
      for (std::size_t i = 1; i < jaw.metrics.size(); ++i)
      {
        json["metrics_" + jaw.metrics[i].first] = { { "moving_contour", jaw.metrics[i].first } };
        json["metrics_" + jaw.metrics[i].first].update(FiguresToJson(jaw.metrics[i].second));
      }
    }
    Json landmarks = Json::object();
    Json sigmas = Json::object();
    Json covariances = Json::object();
    for (const LandmarkPrediction & landmark : jaw.landmarks)
    {
      landmarks[landmark.name] = landmark.position;
      if (landmark.covariance)
      {
        const auto & c = *landmark.covariance;
        sigmas[landmark.name] = landmark.GetSigma();
        covariances[landmark.name] = { { c[0], c[1] }, { c[2], c[3] } };
      }
    }
    json["landmarks_px"] = landmarks;
    if (!jaw.placedBy.empty())
    {
      json["placed_by"] = jaw.placedBy;
    }
    for (const MiddlePrediction & middle : jaw.middles)
    {
      json["middles"][middle.name] = { { "position", middle.position }, { "sigma_px", middle.sigma } };
    }
    for (const UsedLandmark & landmark : jaw.usedLandmarks)
    {
      json["landmarks_used"][landmark.name] = { { "found_by", landmark.source },
                                                { "residual_px", landmark.residual },
                                                { "residual_sd", landmark.distance },
                                                { "weight", landmark.weight } };
    }
    for (const UsedOutline & outline : jaw.usedOutlines)
    {
      json["outlines_used"][outline.name] = { { "shift_px", outline.shift },
                                              { "residual_sd", outline.distance },
                                              { "weight", outline.weight },
                                              { "matched_share", outline.matchedShare },
                                              { "template", outline.isTemplate } };
    }
    if (!sigmas.empty())
    {
      json["landmark_sigma_px"] = sigmas;
      json["landmark_covariance_px2"] = covariances;
    }
    if (jaw.expectedError)
    {
      json["expected_error_px"] = *jaw.expectedError;
    }
    if (jaw.error)
    {
      Json groups = Json::object();
      for (const auto & group : jaw.error->groups)
      {
        groups[group.first] = group.second;
      }
      Json each = Json::object();
      for (const auto & landmark : jaw.error->landmarks)
      {
        each[landmark.first] = landmark.second;
      }
      json["error"] = { { "mean_px", jaw.error->mean },
                        { "rmse_px", jaw.error->rmse },
                        { "std_px", jaw.error->standardDeviation },
                        { "groups", groups },
                        { "landmarks", each } };
    }
  }
  json["arch"] = { { "width_mm", jaw.archWidth },
                   { "depth_mm", jaw.archDepth },
                   { "frame_confidence", jaw.frameConfidence } };
  for (const auto & detail : jaw.details)
  {
    json["details"][detail.first] = detail.second;
  }
  Json & seconds = json["seconds"] = Json::object();
  for (const char * stage : { "read", "axis", "projection", "contour", "registration" })
  {
    seconds[stage] = 0.0;
  }
  for (const auto & stage : jaw.seconds)
  {
    seconds[stage.first] = seconds.value(stage.first, 0.0) + stage.second;
  }
  return json;
}

MeshType::Pointer
MoveMesh(const MeshType * mesh, const std::array<double, 12> & matrix)
{
  auto moved = MeshType::New();
  moved->Graft(mesh);
  auto points = MeshType::PointsContainer::New();
  points->Reserve(mesh->GetNumberOfPoints());
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
  {
    MeshType::PointType point;
    for (unsigned int row = 0; row < 3; ++row)
    {
      double sum = matrix[4 * row + 3];
      for (unsigned int d = 0; d < 3; ++d)
      {
        sum += matrix[4 * row + d] * it.Value()[d];
      }
      point[row] = static_cast<float>(sum);
    }
    points->SetElement(it.Index(), point);
  }
  moved->SetPoints(points);
  return moved;
}

/** As ITK writes it, with a comment below the header line. */
void
WriteTransform(const TransformBaseTemplate<double> * transform, const std::string & comment, const fs::path & path)
{
  const MemoryFile memory;
  WriteTransformFile(transform, memory.GetName());
  const std::string text = memory.GetContent();
  const std::size_t end = text.find('\n');
  WriteFileAtomically(path.string(), text.substr(0, end + 1) + "# " + comment + '\n' + text.substr(end + 1));
}

void
WriteFiles(const CaseResult & result, const fs::path & folder, bool report)
{
  for (const auto & entry : result.jaws)
  {
    const JawResult & jaw = entry.second;
    const std::string name = Name(entry.first);
    if (!jaw.registered)
    {
      continue;
    }
    if (report)
    {
      WriteDentalMesh(MoveMesh(result.data->GetJaw(entry.first).mesh, jaw.meshToCephalostat).GetPointer(),
                      (folder / (name + "_ceph.stl")).string());
      WriteCaseOverlay(result, entry.first, (folder / ("overlay_" + name + ".png")).string());
    }
    WriteUMDATransform(jaw.meshToUMDA, (folder / (name + "_umda.tfm")).string());
    using SimilarityType = Similarity2DTransform<double>;
    auto                           similarity = SimilarityType::New();
    SimilarityType::ParametersType parameters(4);
    parameters[0] = jaw.similarity.scale;
    parameters[1] = jaw.similarity.rotation;
    parameters[2] = jaw.similarity.translation[0];
    parameters[3] = jaw.similarity.translation[1];
    similarity->SetParameters(parameters);
    WriteTransform(
      similarity,
      "maps the geometry's own projection q (pixels) to the radiograph's pixels; 2-D: for ITK, not for Slicer",
      folder / (name + "_similarity2d.tfm"));
  }
  // Last: where it is, everything is.
  WriteFileAtomically((folder / "result.json").string(), CaseResultToJson(result));
}

/** Names of every file that a run can leave: those of an earlier run that this one does not make are stale. */
const char * const OutputNames[] = { "upper_ceph.stl",    "lower_ceph.stl",         "upper_umda.tfm",
                                     "lower_umda.tfm",    "upper_similarity2d.tfm", "lower_similarity2d.tfm",
                                     "overlay_upper.png", "overlay_lower.png",      "result.json" };
} // namespace

namespace
{
/** What was marked, less what was registered with: a landmark of the case never scores, nor does either side's where it
 * has none. */
DentalLandmarkSet<2>::Pointer
WithoutUsed(const DentalLandmarkSet<2> & marked, const DentalCaseData & data)
{
  auto       kept = DentalLandmarkSet<2>::New();
  const bool ignoreSides = data.description.tracedSide == TracedSideEnum::Standard;
  for (const auto & landmark : marked.GetLandmarks())
  {
    const auto own =
      CephalometricLandmarkSet::ParseName(landmark.tooth.GetName() + landmark.name.substr(landmark.name.find('_')));
    bool used = false;
    if (data.cephalometricLandmarks.IsNotNull())
    {
      for (const auto & other : data.cephalometricLandmarks->GetLandmarks())
      {
        const auto & meaning = other.meaning;
        const bool   sameSide = ignoreSides || !meaning.tooth.IsKnown() || meaning.tooth == own.tooth;
        // A molar's point of which the name does not say which was registered with as its mesiobuccal cusp.
        const bool samePoint =
          meaning.feature == own.feature || (meaning.feature == CephalometricLandmarkSet::FeatureEnum::Unspecified &&
                                             own.feature == CephalometricLandmarkSet::FeatureEnum::MesiobuccalCusp);
        used = used || (meaning.jaw == own.jaw && meaning.position == own.position && sameSide && samePoint);
      }
    }
    if (!used)
    {
      kept->AddLandmark(landmark.name, landmark.point);
    }
  }
  return kept;
}
} // namespace

void
MeasureLandmarkErrors(CaseResult & result, const DentalLandmarkSet<2> * marked)
{
  using FilterType = LandmarkErrorFilter;
  for (auto & entry : result.jaws)
  {
    JawResult & jaw = entry.second;
    jaw.error.reset();
    if (!jaw.registered || marked == nullptr)
    {
      continue;
    }
    auto predicted = DentalLandmarkSet<2>::New();
    for (const LandmarkPrediction & landmark : jaw.landmarks)
    {
      const auto & unusable = result.unusableLandmarks;
      if (std::find(unusable.begin(), unusable.end(), landmark.name) != unusable.end())
      {
        continue;
      }
      DentalLandmarkSet<2>::PointType point;
      point[0] = landmark.position[0];
      point[1] = landmark.position[1];
      predicted->AddLandmark(landmark.name, point);
    }
    auto filter = FilterType::New();
    filter->SetPredictedLandmarks(predicted);
    filter->SetReferenceLandmarks(WithoutUsed(*marked, *result.data));
    filter->SetJaw(entry.first);
    filter->SetBisectSides(IsBisected(result.data->description.tracedSide));
    filter->Update();
    const auto & statistics = filter->GetStatistics();
    if (statistics.GetCount() == 0)
    {
      continue;
    }
    LandmarkFigures figures;
    figures.count = statistics.GetCount();
    figures.mean = statistics.GetMean();
    figures.rmse = statistics.GetRMSE();
    figures.standardDeviation = statistics.GetStandardDeviation();
    const std::pair<const char *, ToothCode::GroupEnum> groups[] = { { "incisors_canines",
                                                                       ToothCode::GroupEnum::IncisorsAndCanines },
                                                                     { "premolars", ToothCode::GroupEnum::Premolars },
                                                                     { "molars", ToothCode::GroupEnum::Molars } };
    for (const auto & group : groups)
    {
      if (statistics.GetCount(group.second) > 0)
      {
        figures.groups[group.first] = statistics.GetMean(group.second);
      }
    }
    for (const auto & error : filter->GetErrors())
    {
      figures.landmarks.emplace_back(error.name, error.distance);
    }
    jaw.error = figures;
  }
}

void
WriteUMDATransform(const std::array<double, 12> & matrix, const std::string & fileName)
{
  using TransformType = VersorRigid3DTransform<double>;
  auto                            transform = TransformType::New();
  TransformType::MatrixType       rotation;
  TransformType::OutputVectorType translation;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      rotation(row, column) = matrix[4 * row + column];
    }
    translation[row] = matrix[4 * row + 3];
  }
  transform->SetMatrix(rotation);
  transform->SetTranslation(translation);
  WriteTransform(transform,
                 "maps points of the scan (mm) to its UMDA frame (mm): x anterior, y patient's left, z superior",
                 fs::path(fileName));
}

std::string
FindingsToJson(const std::vector<RegistrationFinding> & findings)
{
  return ToJson(findings).dump();
}

std::string
CaseResultToJson(const CaseResult & result)
{
  Json json;
  json["schema"] = "dentalscr-result/1";
  json["software"] = DentalSCRVersion;
  json["preset"] = ToString(result.preset);
  if (!result.options.empty())
  {
    json["options"] = result.options;
  }
  const Json control = ControlToJson(result.data->description);
  if (!control.empty())
  {
    json["control"] = control;
  }
  json["status"] = ToString(result.GetStatus());
  json["inputs"] = Json::object();
  for (const CaseInputFile & input : result.inputs)
  {
    json["inputs"][input.field] = { { "path", input.path }, { "sha256", input.sha256 } };
  }
  json["skipped"] = Json::object();
  for (const auto & skipped : result.skipped)
  {
    json["skipped"][Name(skipped.first)] = skipped.second;
  }
  json["jaws"] = Json::object();
  for (const auto & entry : result.jaws)
  {
    json["jaws"][Name(entry.first)] = JawToJson(entry.second);
  }
  json["geometry"] = GeometryToJson(result);
  json["jaws_share_frame"] = result.jawsShareFrame;
  if (!result.occlusionFound.empty())
  {
    json["occlusion_found"] = result.occlusionFound;
  }
  if (result.overjet && result.overbite)
  {
    json["overjet_mm"] = *result.overjet;
    json["overbite_mm"] = *result.overbite;
  }
  json["mesh_unit"] = result.data->description.meshUnit;
  json["traced_side"] = ToString(result.data->description.tracedSide);
  json["warnings"] = result.warnings;
  json["not_checkable"] = result.notCheckable;
  json["total_seconds"] = result.totalSeconds;
  json["notice"] = "Research software, not a medical device.";
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

void
RemoveCaseResult(const std::string & folderName)
{
  std::error_code error;
  for (const char * name : OutputNames)
  {
    fs::remove(fs::u8path(folderName) / name, error);
  }
}

void
WriteCaseResult(const CaseResult & result, OutputFolder & folder, bool report)
{
  WriteFiles(result, folder.GetStagingFolder(), report);
  folder.Publish("result.json", std::vector<std::string>(std::begin(OutputNames), std::end(OutputNames)));
}

void
WriteCaseResult(const CaseResult & result, const std::string & folderName, bool report)
{
  OutputFolder folder(folderName);
  WriteCaseResult(result, folder, report);
}
} // namespace itk
