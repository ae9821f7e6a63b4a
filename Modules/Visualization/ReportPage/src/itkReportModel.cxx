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
#include "itkReportModel.h"

#include "itkFindingAdvice.h"
#include "itkJsonMember.h"
#include "itkReportText.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr double Degrees = 180.0 / 3.14159265358979323846;

std::string
JawTitle(const std::string & jaw)
{
  return jaw == "upper" ? "Upper jaw" : jaw == "lower" ? "Lower jaw" : jaw;
}

/** A number of so many digits; "" where it is missing or null. */
std::string
Figure(const Json & json, const std::string & key, int digits, double factor = 1.0)
{
  return json.contains(key) && json.at(key).is_number() ? FormatForPage(factor * json.at(key).get<double>(), digits)
                                                        : std::string();
}

/** One word for a person who has ten seconds, and what it means. */
std::string
VerdictSentence(const std::string & status)
{
  return status == "ok"        ? "The scan lies where the teeth were drawn, and nothing speaks against it."
         : status == "suspect" ? "Look at the findings and at the picture before you use it."
         : status == "failed"  ? "Not to be used. The findings say why, and what to do."
                               : "";
}

std::string
StatusSign(const std::string & status)
{
  return status == "ok" ? "✓" : status == "suspect" ? "?" : "✕";
}

/** mm on the detector in a pixel; 0 where nobody knows. */
double
MillimetresPerPixel(const Json & result)
{
  const Json & spacing = JsonMember(result.at("geometry").at("pixel_spacing_mm"), "value");
  return spacing.size() == 2 && spacing[0].is_number() && spacing[1].is_number()
           ? 0.5 * (spacing[0].get<double>() + spacing[1].get<double>())
           : 0.0;
}

/** "1.4 px = 0.34 mm". */
std::string
Length(const Json & json, const std::string & key, double millimetres, int digits = 1)
{
  const std::string pixels = Figure(json, key, digits);
  if (pixels.empty())
  {
    return "";
  }
  return pixels + " px" +
         (millimetres > 0.0 ? " = " + FormatForPage(json.at(key).get<double>() * millimetres, 2) + " mm" : "");
}

Json
MakeFindings(const Json & jaw)
{
  Json list = Json::array();
  for (const Json & finding : JsonMember(jaw, "findings"))
  {
    const std::string code = finding.value("code", "");
    Json              item = { { "code", code },
                               { "severity", finding.value("severity", "") },
                               { "text", finding.value("text", "") },
                               { "advice", GetFindingAdvice(code) } };
    item["has_advice"] = !item["advice"].get<std::string>().empty();
    if (finding.contains("value") && finding.contains("limit"))
    {
      const std::string unit = finding.value("unit", "");
      const std::string suffix = unit.empty() ? "" : ' ' + unit;
      item["limit"] = FormatForPage(finding["value"].get<double>(), 2) + suffix + ", limit " +
                      FormatForPage(finding["limit"].get<double>(), 2) + suffix;
      item["has_limit"] = true;
    }
    list.push_back(item);
  }
  return list;
}

Json
MakeJaw(const std::string & name, const Json & jaw, double millimetres)
{
  const std::string status = jaw.value("status", "");
  Json              model = { { "key", name },
                              { "name", JawTitle(name) },
                              { "status", status },
                              { "sign", StatusSign(status) },
                              { "findings", MakeFindings(jaw) },
                              { "figures", Json::array() } };
  model["has_findings"] = !model["findings"].empty();
  const auto figure = [&](const char * label, const std::string & value, const char * hint) {
    if (!value.empty())
    {
      model["figures"].push_back({ { "label", label }, { "value", value }, { "hint", hint } });
    }
  };
  figure("fit",
         Length(JsonMember(jaw, "metrics_matched"), "chamfer_px", millimetres),
         "mean distance of the drawing from the outline that it was matched with");
  if (!jaw.contains("metrics_matched"))
  {
    figure("distance",
           Length(JsonMember(jaw, "metrics"), "chamfer_px", millimetres),
           "mean distance between the drawing and the whole silhouette");
  }
  figure("expected error",
         Length(jaw, "expected_error_px", millimetres),
         "mean distance that a landmark is expected to be off by");
  figure("measured error",
         Length(JsonMember(jaw, "error"), "mean_px", millimetres),
         "mean distance of the predicted landmarks from those that were marked");
  if (jaw.contains("placed_by"))
  {
    model["figures"].push_back({ { "label", "placed by" },
                                 { "value", jaw["placed_by"].get<std::string>() + " jaw" },
                                 { "hint", "nothing was drawn of this jaw" } });
  }
  return model;
}

Json
MakeTeeth(const std::string & name, const Json & jaw, double millimetres)
{
  Json list = Json::array();
  for (const Json & tooth : JsonMember(jaw, "residuals_px"))
  {
    const std::string code = tooth.value("tooth", "");
    list.push_back({ { "jaw", name },
                     { "tooth", code },
                     { "label", code.empty() ? "without a code" : code },
                     { "points", std::to_string(tooth.value("points", 0)) },
                     { "mean", Figure(tooth, "mean", 2) },
                     { "rms", Figure(tooth, "rms", 2) },
                     { "max", Figure(tooth, "max", 2) },
                     { "mm", millimetres > 0.0 ? Figure(tooth, "mean", 2, millimetres) : std::string() } });
  }
  return list;
}

/** Landmarks and outlines of whole teeth that were registered with, and how they are explained. */
Json
MakeUsed(const std::string & name, const Json & jaw)
{
  Json       list = Json::array();
  const auto add = [&](const std::string & what, const Json & used, const char * vector, const std::string & how) {
    const Json & residual = JsonMember(used, vector);
    const double away = residual.size() == 2 ? std::hypot(residual[0].get<double>(), residual[1].get<double>()) : 0.0;
    list.push_back({ { "jaw", JawTitle(name) },
                     { "name", what },
                     { "how", how },
                     { "away", FormatForPage(away, 2) },
                     { "sd", Figure(used, "residual_sd", 2) },
                     { "weight", Figure(used, "weight", 2) } });
  };
  for (const auto & used : JsonMember(jaw, "landmarks_used").items())
  {
    add(used.key(), used.value(), "residual_px", "landmark, by " + used.value().value("found_by", ""));
  }
  for (const auto & used : JsonMember(jaw, "outlines_used").items())
  {
    add(used.key(),
        used.value(),
        "shift_px",
        used.value().value("template", false) ? "outline, tip and axis alone" : "outline of the whole tooth");
  }
  return list;
}

Json
MakeCourse(const std::string & name, const Json & jaw)
{
  Json list = Json::array();
  for (const Json & stage : JsonMember(jaw, "course"))
  {
    const Json & jaws = stage.value("jaws", Json::array({ name }));
    list.push_back({ { "jaws", jaws.size() > 1 ? "both jaws" : JawTitle(name) },
                     { "stage", stage.value("stage", "") },
                     { "candidates", std::to_string(stage.value("candidates", 0)) },
                     { "steps", std::to_string(stage.value("steps", 0)) },
                     { "accepted", std::to_string(stage.value("accepted", 0)) },
                     { "value", Figure(stage, "value", 3) },
                     { "stop", stage.value("stop", "") } });
  }
  return list;
}

Json
MakeCandidates(const std::string & name, const Json & jaw)
{
  Json         list = Json::array();
  const Json & candidates = JsonMember(jaw, "candidates");
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    list.push_back({ { "jaw", JawTitle(name) },
                     { "number", std::to_string(i + 1) },
                     { "layer", "candidate-" + std::to_string(i + 1) },
                     { "score", Figure(candidates[i], "score", 4) },
                     { "distance", Figure(candidates[i], "distance_px", 1) },
                     { "is_other", i > 0 } });
  }
  return list;
}

/** Status and findings of each further view, and how the head was moved for it. */
Json
MakeFurtherViews(const Json & result)
{
  const std::pair<const char *, const char *> parameters[] = { { "pitch_deg", "pitch, °" }, { "roll_deg", "roll, °" },
                                                               { "yaw_deg", "yaw, °" },     { "x_mm", "forward, mm" },
                                                               { "y_mm", "left, mm" },      { "z_mm", "up, mm" } };
  Json                                        list = Json::array();
  for (const auto & entry : JsonMember(result, "views").items())
  {
    const Json &      view = entry.value();
    const std::string status = view.value("status", "");
    Json              item = { { "name", entry.key() },         { "status", status },
                               { "sign", StatusSign(status) },  { "findings", MakeFindings(view) },
                               { "parameters", Json::array() }, { "rows", Json::array() } };
    item["has_findings"] = !item["findings"].empty();
    for (const auto & parameter : parameters)
    {
      item["parameters"].push_back({ { "label", parameter.second } });
    }
    for (const auto & jaw : JsonMember(view, "jaws").items())
    {
      Json row = { { "jaw", JawTitle(jaw.key()) },
                   { "scale", Figure(jaw.value(), "scale_factor", 4) },
                   { "moves", Json::array() } };
      for (const auto & parameter : parameters)
      {
        row["moves"].push_back({ { "value",
                                   Figure(JsonMember(jaw.value(), "head_moved"), parameter.first, 2) + " ± " +
                                     Figure(JsonMember(jaw.value(), "head_moved_sigma"), parameter.first, 2) } });
      }
      item["rows"].push_back(row);
    }
    list.push_back(item);
  }
  return list;
}

/** A row a parameter: value, sigma, prior, and how far it is from the prior's mean. */
Json
MakePose(const std::string & name, const Json & jaw)
{
  Json         rows = Json::array();
  const Json & sigmas = JsonMember(jaw, "pose_sigma");
  const Json & priors = JsonMember(jaw, "priors");
  const Json & pose = JsonMember(jaw, "pose");
  const Json & parameters = JsonMember(pose, "parameters");
  struct Parameter
  {
    const char * key;
    const char * label;
    double       factor;
    const char * unit;
  };
  const Parameter table[] = { { "pitch_deg", "pitch", Degrees, "°" },      { "roll_deg", "roll", Degrees, "°" },
                              { "yaw_deg", "yaw", Degrees, "°" },          { "x_mm", "shift forward", 1.0, " mm" },
                              { "y_mm", "shift to the left", 1.0, " mm" }, { "z_mm", "shift up", 1.0, " mm" },
                              { "scale", "scale (log)", 1.0, "" } };
  for (std::size_t k = 0; k < 7 && parameters.size() == 7; ++k)
  {
    const Parameter & p = table[k];
    const int         digits = k == 6 ? 4 : 2;
    const Json &      prior = JsonMember(priors, p.key);
    const double      tension = prior.value("tension_sd", 0.0);
    rows.push_back({ { "label", p.label },
                     { "value", FormatForPage(p.factor * parameters[k].get<double>(), digits) + p.unit },
                     { "sigma", Figure(sigmas, p.key, digits) },
                     { "prior", prior.empty() ? "free or held" : "0 ± " + Figure(prior, "sigma", digits) + p.unit },
                     { "has_pull", !prior.empty() },
                     { "pull", FormatForPage(tension, 2) },
                     { "pull_percent", FormatForPage(std::min(100.0, 100.0 * tension / 3.0), 0) } });
  }
  const Json & similarity = JsonMember(jaw, "similarity");
  const Json & details = JsonMember(jaw, "details");
  Json         figures = Json::array();
  const auto   add = [&](const char * label, const std::string & value) {
    if (!value.empty())
    {
      figures.push_back({ { "label", label }, { "value", value } });
    }
  };
  add("similarity: scale", Figure(similarity, "scale", 4));
  add("similarity: turn", similarity.empty() ? "" : Figure(similarity, "rotation_rad", 2, Degrees) + "°");
  add("scale factor", Figure(details, "scale_factor", 4));
  add("lead over the next candidate", Figure(details, "ambiguity_margin", 2));
  add("share of the tracing that was matched", Figure(details, "overlap", 2));
  const Json & arch = JsonMember(jaw, "arch");
  add("arch width, mm", Figure(arch, "width_mm", 1));
  add("arch depth, mm", Figure(arch, "depth_mm", 1));
  add("confidence in the dental axis", Figure(arch, "frame_confidence", 2));
  return { { "name", JawTitle(name) }, { "rows", rows }, { "has_rows", !rows.empty() }, { "figures", figures } };
}

Json
MakeLandmarks(const std::string & name, const Json & jaw, double millimetres)
{
  Json         list = Json::array();
  const Json & sigmas = JsonMember(jaw, "landmark_sigma_px");
  const Json & errors = JsonMember(JsonMember(jaw, "error"), "landmarks");
  for (const auto & landmark : JsonMember(jaw, "landmarks_px").items())
  {
    const std::string & key = landmark.key();
    list.push_back({ { "jaw", JawTitle(name) },
                     { "name", key },
                     { "u", FormatForPage(landmark.value().at(0).get<double>(), 1) },
                     { "v", FormatForPage(landmark.value().at(1).get<double>(), 1) },
                     { "sigma", Figure(sigmas, key, 2) },
                     { "sigma_mm", millimetres > 0.0 ? Figure(sigmas, key, 2, millimetres) : std::string() },
                     { "error", Figure(errors, key, 2) },
                     { "error_mm", millimetres > 0.0 ? Figure(errors, key, 2, millimetres) : std::string() } });
  }
  // Errors of middles have the names of both sides: "UR6_MB+UL6_MB".
  const auto nameOfError = [](const std::string & middle) {
    return middle.substr(0, 1) + 'R' + middle.substr(1) + '+' + middle.substr(0, 1) + 'L' + middle.substr(1);
  };
  for (const auto & middle : JsonMember(jaw, "middles").items())
  {
    const Json &      place = middle.value().at("position");
    const std::string foundBy = middle.value().value("found_by", "");
    list.push_back(
      { { "jaw", JawTitle(name) },
        { "name",
          middle.key() + " (middle of both sides" +
            (foundBy.empty() || foundBy == "landmarks_3d" ? "" : ", found by " + foundBy) + ")" },
        { "u", FormatForPage(place.at(0).get<double>(), 1) },
        { "v", FormatForPage(place.at(1).get<double>(), 1) },
        { "sigma", Figure(middle.value(), "sigma_px", 2) },
        { "sigma_mm", Figure(middle.value(), "sigma_px", 2, millimetres) },
        { "error", Figure(errors, nameOfError(middle.key()), 2) },
        { "error_mm",
          millimetres > 0.0 ? Figure(errors, nameOfError(middle.key()), 2, millimetres) : std::string() } });
  }
  for (const auto & error : errors.items())
  {
    // Of the middle of two sides that has none yet: a row of its own.
    const Json & middles = JsonMember(jaw, "middles");
    const bool   isMiddle = std::any_of(middles.items().begin(), middles.items().end(), [&](const auto & middle) {
      return nameOfError(middle.key()) == error.key();
    });
    if (!isMiddle && !JsonMember(jaw, "landmarks_px").contains(error.key()))
    {
      list.push_back({ { "jaw", JawTitle(name) },
                       { "name", error.key() },
                       { "u", "" },
                       { "v", "" },
                       { "sigma", "" },
                       { "sigma_mm", "" },
                       { "error", Figure(errors, error.key(), 2) },
                       { "error_mm", millimetres > 0.0 ? Figure(errors, error.key(), 2, millimetres) : "" } });
    }
  }
  return list;
}

/** Numbers, words and lists of them as one line. */
std::string
ToLine(const Json & value)
{
  if (value.is_string())
  {
    return value.get<std::string>();
  }
  if (value.is_array())
  {
    std::string line;
    for (const Json & item : value)
    {
      line += (line.empty() ? "" : ", ") + ToLine(item);
    }
    return line;
  }
  if (value.is_number_float())
  {
    std::string text = FormatForPage(value.get<double>(), 4);
    text.erase(text.find_last_not_of('0') + 1);
    return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
  }
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json
MakeProvenance(const Json & result)
{
  Json list = Json::array();
  for (const auto & entry : result.at("geometry").items())
  {
    const Json & item = entry.value();
    std::string  label = entry.key();
    std::replace(label.begin(), label.end(), '_', ' ');
    list.push_back({ { "label", label },
                     { "value", item.contains("value") ? ToLine(item.at("value")) : std::string() },
                     { "source", item.value("source", "") },
                     { "how", item.value("how", "") } });
  }
  return list;
}

void
Append(Json & list, const Json & more)
{
  list.insert(list.end(), more.begin(), more.end());
}
} // namespace

Json
MakeReportModel(const Json & result, const Json & details)
{
  const double      millimetres = MillimetresPerPixel(result);
  const std::string status = result.at("status").get<std::string>();
  Json              model = { { "status", status },
                              { "sign", StatusSign(status) },
                              { "verdict", VerdictSentence(status) },
                              { "software", result.value("software", "") },
                              { "preset", result.value("preset", "") },
                              { "notice", result.value("notice", "") },
                              { "anonymous", result.value("anonymous", false) },
                              { "mesh_unit", result.value("mesh_unit", "") },
                              { "traced_side", result.value("traced_side", "") },
                              { "total_seconds", Figure(result, "total_seconds", 2) } };
  for (const char * list :
       { "jaws", "teeth", "used", "course", "candidates", "pose", "landmarks", "inputs", "seconds" })
  {
    model[list] = Json::array();
  }
  for (const auto & entry : result.at("jaws").items())
  {
    const std::string & name = entry.key();
    const Json &        jaw = entry.value();
    model["jaws"].push_back(MakeJaw(name, jaw, millimetres));
    Append(model["teeth"], MakeTeeth(name, jaw, millimetres));
    Append(model["used"], MakeUsed(name, jaw));
    Append(model["course"], MakeCourse(name, jaw));
    Append(model["candidates"], MakeCandidates(name, jaw));
    Append(model["landmarks"], MakeLandmarks(name, jaw, millimetres));
    if (jaw.contains("projection_3x4"))
    {
      model["pose"].push_back(MakePose(name, jaw));
    }
    for (const auto & stage : JsonMember(jaw, "seconds").items())
    {
      model["seconds"].push_back({ { "jaw", JawTitle(name) },
                                   { "stage", stage.key() },
                                   { "value", FormatForPage(stage.value().get<double>(), 3) } });
    }
  }
  model["skipped"] = Json::array();
  for (const auto & skipped : JsonMember(result, "skipped").items())
  {
    model["skipped"].push_back({ { "name", JawTitle(skipped.key()) }, { "reason", ToLine(skipped.value()) } });
  }
  for (const auto & input : JsonMember(result, "inputs").items())
  {
    model["inputs"].push_back({ { "field", input.key() },
                                { "path", input.value().value("path", "") },
                                { "sha256", input.value().value("sha256", "") } });
  }
  const auto lines = [&](const char * from) {
    Json list = Json::array();
    for (const Json & line : JsonMember(result, from))
    {
      list.push_back({ { "text", ToLine(line) } });
    }
    return list;
  };
  model["warnings"] = lines("warnings");
  model["not_checkable"] = lines("not_checkable");
  model["options"] = lines("options");
  for (const auto & held : JsonMember(result, "control").items())
  {
    model["options"].push_back({ { "text", held.key() + ": " + ToLine(held.value()) } });
  }
  std::string command;
  for (const Json & word : JsonMember(details.is_object() ? details : result, "command_line"))
  {
    command += (command.empty() ? "" : " ") + ToLine(word);
  }
  model["command_line"] = command;
  model["provenance"] = MakeProvenance(result);
  model["has_details"] = !details.is_null();
  for (const char * list : { "teeth",
                             "used",
                             "course",
                             "candidates",
                             "pose",
                             "landmarks",
                             "inputs",
                             "warnings",
                             "not_checkable",
                             "options",
                             "skipped",
                             "seconds" })
  {
    model[std::string("has_") + list] = !model[list].empty();
  }
  model["has_command_line"] = !command.empty();
  model["further"] = MakeFurtherViews(result);
  model["has_further"] = !model["further"].empty();
  return model;
}
} // namespace itk
