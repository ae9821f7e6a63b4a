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
#include "itkReportDetails.h"

#include "itkFirstViewName.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;

/** Hundredths of a pixel, and of a millimetre: what is drawn by it is no finer. */
double
Round(double value)
{
  constexpr double perUnit = 1000.0;
  return std::round(value * perUnit) / perUnit;
}

/** Six digits of what may have any size. */
double
RoundDigits(double value)
{
  if (value == 0.0 || !std::isfinite(value))
  {
    return value;
  }
  const double scale = std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

Json
ToJson(const DentalContour::PolylineType & polyline)
{
  Json points = Json::array();
  for (const auto & point : polyline.points)
  {
    points.push_back({ Round(point[0]), Round(point[1]) });
  }
  return { { "closed", polyline.closed }, { "points", std::move(points) } };
}

/** Each polyline with the distances of its points, which are in the order of the contour's points. */
Json
TracingToJson(const DentalContour * tracing, const std::vector<double> & distances)
{
  // By place: polylines are read back from the cells, and need not be in the order of the points.
  std::map<std::pair<double, double>, double> byPlace;
  for (DentalContour::PointIdentifier id = 0; id < tracing->GetNumberOfPoints() && id < distances.size(); ++id)
  {
    const auto point = tracing->GetPoint(id);
    byPlace[{ point[0], point[1] }] = distances[id];
  }
  Json list = Json::array();
  for (const auto & polyline : tracing->GetPolylines())
  {
    Json item = { { "tooth", polyline.code.IsKnown() ? polyline.code.GetName() : std::string() } };
    item.update(ToJson(polyline));
    for (const auto & point : polyline.points)
    {
      const auto found = byPlace.find({ point[0], point[1] });
      const bool known = found != byPlace.end() && std::isfinite(found->second);
      item["distance_px"].push_back(known ? Json(Round(found->second)) : Json());
    }
    list.push_back(item);
  }
  return list;
}

Json
StepsToJson(const RegistrationCandidateCourse & candidate)
{
  Json item = { { "candidate", candidate.candidate }, { "chosen", candidate.chosen } };
  for (const char * list : { "value", "accepted", "length_px", "width_px" })
  {
    item[list] = Json::array();
  }
  for (const RegistrationStep & step : candidate.steps)
  {
    item["value"].push_back(RoundDigits(step.value));
    item["accepted"].push_back(step.accepted ? 1 : 0);
    item["length_px"].push_back(RoundDigits(step.length));
    item["width_px"].push_back(RoundDigits(step.width));
  }
  return item;
}

Json
CourseToJson(const CaseResult & result)
{
  Json groups = Json::array();
  for (const auto & entry : result.jaws)
  {
    const auto & course = entry.second.course;
    if (course.empty())
    {
      continue;
    }
    Json group = { { "jaws", Json::array() }, { "stages", Json::array() } };
    for (const auto jaw : course.front().jaws)
    {
      group["jaws"].push_back(ToString(jaw));
    }
    for (const RegistrationStageCourse & stage : course)
    {
      Json candidates = Json::array();
      for (const RegistrationCandidateCourse & candidate : stage.candidates)
      {
        candidates.push_back(StepsToJson(candidate));
      }
      group["stages"].push_back({ { "stage", stage.name }, { "candidates", candidates } });
    }
    groups.push_back(group);
  }
  return groups;
}
/** What is drawn on a radiograph. */
Json
ViewToJson(const CaseResult & result, const std::string & name, const std::string & input)
{
  const DentalCaseData & data = *result.data;
  Json                   view = { { "name", name },
                                  { "input", input },
                                  { "image_size", { data.imageSize[0], data.imageSize[1] } },
                                  { "jaws", Json::object() } };
  for (const auto & entry : result.jaws)
  {
    const JawResult & jaw = entry.second;
    Json              drawing = Json::object();
    if (const DentalContour * tracing = data.GetJaw(entry.first).contour)
    {
      drawing["tracing"] = TracingToJson(tracing, jaw.tracingDistances);
    }
    for (const auto & contour : jaw.contours)
    {
      Json & polylines = drawing["contours"][contour.first] = Json::array();
      for (const auto & polyline : contour.second->GetPolylines())
      {
        polylines.push_back(ToJson(polyline));
      }
    }
    for (const auto & point : jaw.outline)
    {
      const double unit = data.description.millimetresPerUnit;
      drawing["outline_3d"].push_back(
        { RoundDigits(point[0] / unit), RoundDigits(point[1] / unit), RoundDigits(point[2] / unit) });
    }
    for (const UsedLandmark & used : jaw.usedLandmarks)
    {
      const auto * mark =
        data.cephalometricLandmarks.IsNotNull() ? data.cephalometricLandmarks->Find(used.name) : nullptr;
      if (mark != nullptr)
      {
        drawing["landmarks_used_px"][used.name] = { Round(mark->point[0]), Round(mark->point[1]) };
      }
    }
    view["jaws"][ToString(entry.first)] = drawing;
  }
  return view;
}
} // namespace

std::string
MakeReportDetails(const CaseResult & result)
{
  Json views = Json::array({ ViewToJson(result, FirstViewName, "cephalogram.image") });
  for (const CaseViewResult & view : result.views)
  {
    views.push_back(ViewToJson(*view.result, view.name, "views." + view.name + ".cephalogram.image"));
  }
  Json json = { { "schema", "dentalscr-report/1" }, { "views", std::move(views) }, { "course", CourseToJson(result) } };
  // Not in result.json: the same case has the same result, wherever it is written to.
  if (!result.commandLine.empty())
  {
    json["command_line"] = result.commandLine;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}
} // namespace itk
