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
#include "itkCaseResultToJson.h"

#include "itkCaseResultDocument.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalSCRVersion.h"

#include "itkMath.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;
using JawEnum = ToothCode::JawEnum;

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

/** Of the first radiograph or of a view. */
Json
GeometryToJson(const CaseResult & result)
{
  using GeometryType = CephalometricGeometry;
  const auto & geometry = *result.geometry;
  const auto & sources = result.data->sources;
  const bool   isLateral = geometry.GetDirection() == GeometryType::DirectionEnum::Lateral;
  Json         json;
  json[isLateral ? "source_to_midsagittal_mm" : "source_to_midcoronal_mm"] =
    Provenance(geometry.GetSourceToMidsagittalDistance(), sources.sourceToMidsagittal);
  json["source_to_detector_mm"] = Provenance(geometry.GetSourceToDetectorDistance(), sources.sourceToDetector);
  if (isLateral)
  {
    json["source_side"] = Provenance(geometry.GetSourceSide() == GeometryType::SourceSideEnum::Right ? "right" : "left",
                                     sources.sourceSide);
    json["facing"] =
      Provenance(geometry.GetFacing() == GeometryType::FacingEnum::Right ? "right" : "left", sources.facing);
  }
  else
  {
    json["source"] = Provenance(
      geometry.GetFrontalSource() == GeometryType::FrontalSourceEnum::Behind ? "behind" : "front", sources.sourceSide);
    json["patient_left"] =
      Provenance(geometry.GetPatientLeft() == GeometryType::PatientLeftEnum::Right ? "right" : "left", sources.facing);
  }
  json["pixel_spacing_mm"] =
    Provenance(Json::array({ geometry.GetPixelSpacing()[0], geometry.GetPixelSpacing()[1] }), sources.pixelSpacing);
  std::ostringstream verdict;
  verdict << result.data->spacingVerdict;
  json["pixel_spacing_mm"]["verdict"] = verdict.str();
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

/** Whether the case lies in no file, as one of options, and files and fields are all that it is. */
bool
IsMadeOfFilesAlone(const DentalCase & description)
{
  const bool hasScan = !description.upperFile.empty() || !description.lowerFile.empty();
  const bool hasObjects = description.cephalometricLandmarksFile.empty() && description.cephalometricLandmarks;
  return description.fileSHA256.empty() && hasScan && !hasObjects && description.views.empty();
}

/** What was given of such a case, but its files and what "control" has: with them another run is the same. */
Json
CaseFieldsToJson(const DentalCase & description)
{
  using GeometryType = CephalometricGeometry;
  Json       json = Json::object();
  const auto setPair = [](Json & parent, const char * name, const auto & pair) {
    if (pair)
    {
      parent[name] = *pair;
    }
  };
  json["mesh_unit"] = description.meshUnit;
  json["occlusion"] = ToString(description.occlusion);
  json["crowns"] = ToString(description.crowns);
  if (description.tracedSideIsGiven)
  {
    json["traced_side"] = ToString(description.tracedSide);
  }
  if (description.numbering)
  {
    std::ostringstream numbering;
    numbering << *description.numbering;
    json["numbering"] = numbering.str();
  }
  setPair(json, "markups_spacing_mm", description.markupsSpacing);
  Json cephalogram = Json::object();
  setPair(cephalogram, "image_size", description.imageSize);
  setPair(cephalogram, "pixel_spacing_mm", description.pixelSpacing);
  if (description.spacingPlaneIsGiven)
  {
    cephalogram["spacing_plane"] = description.spacingAtMidsagittalPlane ? "midsagittal" : "detector";
  }
  if (description.facing)
  {
    cephalogram["facing"] = *description.facing == GeometryType::FacingEnum::Right ? "right" : "left";
  }
  Json geometry = Json::object();
  setPair(geometry, "source_to_midsagittal_mm", description.sourceToMidsagittal);
  setPair(geometry, "source_to_detector_mm", description.sourceToDetector);
  if (description.sourceSide)
  {
    geometry["source_side"] = *description.sourceSide == GeometryType::SourceSideEnum::Right ? "right" : "left";
  }
  setPair(geometry, "principal_point_px", description.principalPoint);
  json["cephalogram"] = cephalogram;
  json["geometry"] = geometry;
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

/** What was tried in each stage, summed up; the single steps are in report.json. */
Json
CourseToJson(const std::vector<RegistrationStageCourse> & course)
{
  Json list = Json::array();
  for (const RegistrationStageCourse & stage : course)
  {
    std::size_t tried = 0;
    std::size_t accepted = 0;
    Json        item = { { "stage", stage.name }, { "candidates", stage.candidates.size() } };
    for (const ToothCode::JawEnum jaw : stage.jaws)
    {
      item["jaws"].push_back(ToString(jaw));
    }
    for (const RegistrationCandidateCourse & candidate : stage.candidates)
    {
      tried += candidate.steps.size();
      for (const RegistrationStep & step : candidate.steps)
      {
        accepted += step.accepted ? 1 : 0;
      }
      if (candidate.chosen)
      {
        item["chosen"] = candidate.candidate;
        item["value"] = candidate.steps.back().value;
      }
    }
    item["steps"] = tried;
    item["accepted"] = accepted;
    if (!stage.stopCondition.empty())
    {
      item["stop"] = stage.stopCondition;
    }
    list.push_back(item);
  }
  return list;
}

Json
StagesToJson(const std::vector<RegistrationStagePlacement> & stages)
{
  Json list = Json::array();
  for (const RegistrationStagePlacement & stage : stages)
  {
    Json item = { { "stage", stage.name } };
    if (stage.projection)
    {
      item["projection_3x4"] = MatrixToJson(*stage.projection);
    }
    if (stage.similarity)
    {
      const auto & p = *stage.similarity;
      item["similarity"] = { { "scale", p[0] }, { "rotation_rad", p[1] }, { "translation_px", { p[2], p[3] } } };
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
MoveToJson(const std::array<double, 6> & move)
{
  constexpr double degrees = 180.0 / Math::pi;
  return { { "pitch_deg", degrees * move[0] },
           { "roll_deg", degrees * move[1] },
           { "yaw_deg", degrees * move[2] },
           { "x_mm", move[3] },
           { "y_mm", move[4] },
           { "z_mm", move[5] } };
}

Json
PoseSigmaToJson(const JawPose & pose)
{
  std::array<double, 6> sigmas{};
  for (unsigned int k = 0; k < 6; ++k)
  {
    sigmas[k] = std::sqrt(pose.covariance[8 * k]);
  }
  Json json = MoveToJson(sigmas);
  json["scale"] = std::sqrt(pose.covariance[48]);
  return json;
}

void
AddMetrics(const JawResult & jaw, Json & json)
{
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
}

/** Predicted ones with their sigma, and those that were registered with. */
void
AddLandmarks(const JawResult & jaw, Json & json)
{
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
  if (!sigmas.empty())
  {
    json["landmark_sigma_px"] = sigmas;
    json["landmark_covariance_px2"] = covariances;
  }
  for (const UsedLandmark & landmark : jaw.usedLandmarks)
  {
    json["landmarks_used"][landmark.name] = { { "found_by", landmark.source },
                                              { "residual_px", landmark.residual },
                                              { "residual_sd", landmark.distance },
                                              { "weight", landmark.weight } };
  }
}

void
AddOutlines(const JawResult & jaw, Json & json)
{
  for (const UsedOutline & outline : jaw.usedOutlines)
  {
    json["outlines_used"][outline.name] = {
      { "shift_px", outline.shift }, { "shift_sd", outline.shiftDistance },     { "residual_sd", outline.distance },
      { "weight", outline.weight },  { "matched_share", outline.matchedShare }, { "template", outline.isTemplate }
    };
    if (!outline.templateOf.empty())
    {
      json["outlines_used"][outline.name]["template_of"] = outline.templateOf;
      json["outlines_used"][outline.name]["template_distance_mm"] = outline.templateDistance;
    }
  }
}

void
AddErrors(const JawResult & jaw, Json & json)
{
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
    for (const auto & source : jaw.error->sources)
    {
      json["error"]["found_by"][source.first] = source.second;
    }
    for (std::size_t i = 0; i < jaw.error->marked.size(); ++i)
    {
      json["error"]["places_px"][jaw.error->landmarks[i].first] = { { "marked", jaw.error->marked[i] },
                                                                    { "predicted", jaw.error->predicted[i] } };
    }
  }
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
    for (const ParameterPrior & prior : jaw.priors)
    {
      json["priors"][prior.name] = {
        { "value", prior.value }, { "mean", 0.0 }, { "sigma", prior.sigma }, { "tension_sd", prior.tension }
      };
    }
    if (!jaw.course.empty())
    {
      json["course"] = CourseToJson(jaw.course);
    }
    if (!jaw.stages.empty())
    {
      json["stages"] = StagesToJson(jaw.stages);
    }
    for (const ToothResidual & tooth : jaw.residuals)
    {
      json["residuals_px"].push_back({ { "tooth", tooth.code },
                                       { "points", tooth.count },
                                       { "mean", tooth.mean },
                                       { "rms", tooth.rms },
                                       { "max", tooth.maximum } });
    }
    AddMetrics(jaw, json);
    AddLandmarks(jaw, json);
    if (!jaw.placedBy.empty())
    {
      json["placed_by"] = jaw.placedBy;
    }
    for (const MiddlePrediction & middle : jaw.middles)
    {
      json["middles"][middle.name] = { { "position", middle.position },
                                       { "sigma_px", middle.sigma },
                                       { "found_by", middle.source } };
    }
    AddOutlines(jaw, json);
    AddErrors(jaw, json);
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

Json
ViewToJson(const CaseViewResult & view)
{
  const bool isLateral = view.result->geometry->GetDirection() == CephalometricGeometry::DirectionEnum::Lateral;
  Json       json = { { "direction", isLateral ? "lateral" : "frontal" },
                      { "status", ToString(view.status) },
                      { "findings", ToJson(view.findings) },
                      { "same_head_position", view.sameHeadPosition },
                      { "geometry", GeometryToJson(*view.result) } };
  json["jaws"] = Json::object();
  for (const auto & entry : view.result->jaws)
  {
    const JawResult & jaw = entry.second;
    Json              own;
    own["projection_3x4"] = MatrixToJson(jaw.projection);
    own["mesh_to_cephalostat_mm"] = MatrixToJson(jaw.meshToCephalostat);
    own["pose"] = PoseToJson(*jaw.pose);
    own["scale_factor"] = view.scaleFactors.at(entry.first);
    own["head_moved"] = MoveToJson(view.moves.at(entry.first));
    own["head_moved_sigma"] = MoveToJson(view.moveSigmas.at(entry.first));
    AddMetrics(jaw, own);
    AddLandmarks(jaw, own);
    AddOutlines(jaw, own);
    AddErrors(jaw, own);
    json["jaws"][ToString(entry.first)] = own;
  }
  return json;
}
} // namespace

std::string
FindingsToJson(const std::vector<RegistrationFinding> & findings)
{
  return ToJson(findings).dump();
}

std::string
CaseResultToJson(const CaseResult & result)
{
  Json json;
  json["schema"] = CaseResultDocument::Schema;
  json["software"] = DentalSCRVersion;
  json["preset"] = ToString(result.preset);
  if (result.anonymous)
  {
    json["anonymous"] = true;
  }
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
    // Without a path where nobody is to know it.
    if (!input.path.empty())
    {
      json["inputs"][input.field]["path"] = input.path;
    }
    json["inputs"][input.field]["sha256"] = input.sha256;
  }
  if (IsMadeOfFilesAlone(result.data->description))
  {
    json["case_fields"] = CaseFieldsToJson(result.data->description);
  }
  json["skipped"] = Json::object();
  for (const auto & skipped : result.skipped)
  {
    json["skipped"][ToString(skipped.first)] = skipped.second;
  }
  json["jaws"] = Json::object();
  for (const auto & entry : result.jaws)
  {
    json["jaws"][ToString(entry.first)] = JawToJson(entry.second);
  }
  for (const CaseViewResult & view : result.views)
  {
    json["views"][view.name] = ViewToJson(view);
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
} // namespace itk
