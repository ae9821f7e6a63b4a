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
#include "itkReportPicture.h"

#include "itkJsonMember.h"
#include "itkReportText.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;

/** Standard deviations of a circle that holds 95 % of a two-dimensional normal error. */
constexpr double NinetyFivePercent = 2.4477;
/** mm of the scan between two points of its outline that are no neighbours. */
constexpr double GapOfOutline = 2.0;
/** mm on the detector. */
constexpr double LandmarkRadius = 0.6;
constexpr double CrossArm = 0.9;
constexpr double LetterHeight = 1.3;
/** Free border around what is drawn, as a share of its extent. */
constexpr double Border = 0.18;

std::string
Number(double value)
{
  return FormatForPage(value, 2);
}

std::string
Attribute(const std::string & name, const std::string & value)
{
  return ' ' + name + "=\"" + EscapeForPage(value) + '"';
}

/** The points of an SVG path; empty where a point is no number. */
template <typename TPoints>
std::string
Path(const TPoints & points, bool closed)
{
  std::string d;
  for (const auto & point : points)
  {
    d += (d.empty() ? "M" : "L") + Number(point.first) + ' ' + Number(point.second);
  }
  return d + (closed ? "Z" : "");
}

std::vector<std::pair<double, double>>
PointsOf(const Json & polyline)
{
  std::vector<std::pair<double, double>> points;
  for (const Json & point : polyline.at("points"))
  {
    points.emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
  }
  return points;
}

std::string
PathElement(const std::string & style, const std::string & d)
{
  return d.empty() ? std::string() : "<path class=\"" + style + "\" d=\"" + d + "\"/>";
}

std::string
ImageElement(const std::string & style, const RadiographForPage & image)
{
  return "<image class=\"" + style + "\" x=\"-0.5\" y=\"-0.5\" width=\"" + std::to_string(image.width) +
         "\" height=\"" + std::to_string(image.height) + "\" preserveAspectRatio=\"none\" href=\"" + image.uri + "\"/>";
}

std::string
StageLabel(const std::string & stage)
{
  return stage == "start"        ? "search: first guess"
         : stage == "candidates" ? "first refinement begins"
         : stage == "refinement" ? "last refinement begins"
                                 : stage + " begins";
}
} // namespace

void
ReportPicture::Include(const PointType & point)
{
  const double p[2] = { point.first, point.second };
  for (int d = 0; d < 2; ++d)
  {
    m_Low[d] = m_Empty ? p[d] : std::min(m_Low[d], p[d]);
    m_High[d] = m_Empty ? p[d] : std::max(m_High[d], p[d]);
  }
  m_Empty = false;
}

void
ReportPicture::AddLayer(const std::string & key, const std::string & label, bool shown, const std::string & content)
{
  if (content.empty())
  {
    return;
  }
  m_Layers.push_back({ key, label, shown });
  m_Groups += "<g class=\"layer\"" + Attribute("data-layer", key) + (shown ? "" : " hidden") + '>' + content + "</g>\n";
}

std::string
ReportPicture::DrawTracing(const std::string & jaw, const Json & drawing)
{
  std::string content;
  for (const Json & polyline : JsonMember(drawing, "tracing"))
  {
    const auto points = PointsOf(polyline);
    for (const auto & point : points)
    {
      this->Include(point);
    }
    const std::string tooth = polyline.value("tooth", "");
    content += "<path class=\"tracing\"" + Attribute("data-tooth", tooth) + Attribute("data-jaw", jaw) + " d=\"" +
               Path(points, polyline.value("closed", false)) + "\"><title>" +
               EscapeForPage(tooth.empty() ? "tracing" : tooth) + "</title></path>";
  }
  return content;
}

std::string
ReportPicture::DrawContour(const std::string & jaw, const Json & polylines, const char * style)
{
  std::string content;
  for (const Json & polyline : polylines)
  {
    content += "<path class=\"" + std::string(style) + "\"" + Attribute("data-jaw", jaw) + " d=\"" +
               Path(PointsOf(polyline), polyline.value("closed", false)) + "\"/>";
  }
  return content;
}

std::string
ReportPicture::DrawOutline(const Json & points, const Json & projection) const
{
  double p[12];
  for (unsigned int i = 0; i < 12; ++i)
  {
    p[i] = projection.at(i / 4).at(i % 4).get<double>();
  }
  std::string            content;
  std::vector<PointType> stretch;
  double                 last[3] = { 0, 0, 0 };
  const auto             flush = [&]() {
    content += stretch.size() > 1 ? Path(stretch, false) : std::string();
    stretch.clear();
  };
  for (const Json & point : points)
  {
    const double x[3] = { point.at(0).get<double>(), point.at(1).get<double>(), point.at(2).get<double>() };
    double       q[3];
    for (unsigned int row = 0; row < 3; ++row)
    {
      q[row] = p[4 * row] * x[0] + p[4 * row + 1] * x[1] + p[4 * row + 2] * x[2] + p[4 * row + 3];
    }
    if (std::hypot(x[0] - last[0], x[1] - last[1], x[2] - last[2]) > GapOfOutline)
    {
      flush();
    }
    stretch.emplace_back(q[0] / q[2], q[1] / q[2]);
    std::copy(x, x + 3, last);
  }
  flush();
  return content;
}

std::string
ReportPicture::DrawMoved(const Json & polylines, const Json & from, const Json & to) const
{
  const auto read = [](const Json & similarity, double values[4]) {
    values[0] = similarity.at("scale").get<double>();
    values[1] = similarity.at("rotation_rad").get<double>();
    values[2] = similarity.at("translation_px").at(0).get<double>();
    values[3] = similarity.at("translation_px").at(1).get<double>();
  };
  double a[4];
  double b[4];
  read(from, a);
  read(to, b);
  std::string content;
  for (const Json & polyline : polylines)
  {
    auto points = PointsOf(polyline);
    for (auto & point : points)
    {
      // Back through the one, forth through the other.
      const double u = (point.first - a[2]) / a[0];
      const double v = (point.second - a[3]) / a[0];
      const double turn = b[1] - a[1];
      point = { b[0] * (std::cos(turn) * u - std::sin(turn) * v) + b[2],
                b[0] * (std::sin(turn) * u + std::cos(turn) * v) + b[3] };
    }
    content += Path(points, polyline.value("closed", false));
  }
  return content;
}

std::string
ReportPicture::DrawRegions(const Json & jaw) const
{
  std::string  content;
  const Json & covariances = JsonMember(jaw, "landmark_covariance_px2");
  const Json & places = JsonMember(jaw, "landmarks_px");
  for (const auto & entry : covariances.items())
  {
    if (!places.contains(entry.key()))
    {
      continue;
    }
    const double a = entry.value().at(0).at(0).get<double>();
    const double b = entry.value().at(0).at(1).get<double>();
    const double c = entry.value().at(1).at(1).get<double>();
    // Axes of the ellipse: the eigenvectors of a symmetric 2x2 matrix.
    const double middle = 0.5 * (a + c);
    const double root = std::hypot(0.5 * (a - c), b);
    const double angle = 0.5 * std::atan2(2.0 * b, a - c) * 180.0 / 3.14159265358979323846;
    const double first = NinetyFivePercent * std::sqrt(std::max(0.0, middle + root));
    const double second = NinetyFivePercent * std::sqrt(std::max(0.0, middle - root));
    const Json & place = places.at(entry.key());
    const auto   u = Number(place.at(0).get<double>());
    const auto   v = Number(place.at(1).get<double>());
    content += "<ellipse class=\"region\" cx=\"" + u + "\" cy=\"" + v + "\" rx=\"" + Number(first) + "\" ry=\"" +
               Number(second) + "\" transform=\"rotate(" + FormatForPage(angle, 1) + ' ' + u + ' ' + v + ")\"><title>" +
               EscapeForPage(entry.key()) + ": 95 % region</title></ellipse>";
  }
  return content;
}

void
ReportPicture::DrawLandmarks(const Json & jaw, std::string & predicted, std::string & errors, std::string & names)
{
  for (const auto & entry : JsonMember(jaw, "landmarks_px").items())
  {
    const PointType point{ entry.value().at(0).get<double>(), entry.value().at(1).get<double>() };
    this->Include(point);
    predicted += "<circle class=\"predicted\" cx=\"" + Number(point.first) + "\" cy=\"" + Number(point.second) +
                 "\" r=\"" + Number(LandmarkRadius * m_Unit) + "\"><title>" + EscapeForPage(entry.key()) +
                 "</title></circle>";
    names += "<text x=\"" + Number(point.first + LandmarkRadius * m_Unit * 1.5) + "\" y=\"" + Number(point.second) +
             "\" font-size=\"" + Number(LetterHeight * m_Unit) + "\">" + EscapeForPage(entry.key()) + "</text>";
  }
  const Json & error = JsonMember(jaw, "error");
  for (const auto & entry : JsonMember(error, "places_px").items())
  {
    const Json & marked = entry.value().at("marked");
    const Json & placed = entry.value().at("predicted");
    const double u = marked.at(0).get<double>();
    const double v = marked.at(1).get<double>();
    const double arm = CrossArm * m_Unit;
    this->Include({ u, v });
    errors += "<path class=\"arrow\" marker-end=\"url(#head)\" d=\"M" + Number(placed.at(0).get<double>()) + ' ' +
              Number(placed.at(1).get<double>()) + 'L' + Number(u) + ' ' + Number(v) + "\"><title>" +
              EscapeForPage(entry.key()) + ": predicted to marked, " +
              FormatForPage(error.at("landmarks").value(entry.key(), 0.0), 2) + " px</title></path>";
    errors += "<path class=\"marked\" d=\"M" + Number(u - arm) + ' ' + Number(v) + 'H' + Number(u + arm) + 'M' +
              Number(u) + ' ' + Number(v - arm) + 'V' + Number(v + arm) + "\"/>";
  }
}

std::string
ReportPicture::DrawUsed(const Json & jaw, const Json & drawing) const
{
  std::string  content;
  const Json & used = JsonMember(jaw, "landmarks_used");
  const Json & marks = JsonMember(drawing, "landmarks_used_px");
  for (const auto & entry : used.items())
  {
    if (!marks.contains(entry.key()))
    {
      continue;
    }
    const double u = marks.at(entry.key()).at(0).get<double>();
    const double v = marks.at(entry.key()).at(1).get<double>();
    const Json & residual = entry.value().at("residual_px");
    const double arm = CrossArm * m_Unit;
    content += "<path class=\"used\" d=\"M" + Number(u - arm) + ' ' + Number(v - arm) + 'L' + Number(u + arm) + ' ' +
               Number(v + arm) + 'M' + Number(u - arm) + ' ' + Number(v + arm) + 'L' + Number(u + arm) + ' ' +
               Number(v - arm) + 'M' + Number(u) + ' ' + Number(v) + 'L' + Number(u - residual.at(0).get<double>()) +
               ' ' + Number(v - residual.at(1).get<double>()) + "\"><title>" + EscapeForPage(entry.key()) +
               ": registered with</title></path>";
  }
  return content;
}

ReportPicture::ReportPicture(const Json &              result,
                             const Json &              view,
                             const RadiographForPage & radiograph,
                             const RadiographForPage & drr)
{
  const Json & spacingOf = JsonMember(result.at("geometry").at("pixel_spacing_mm"), "value");
  const double spacing[2] = { spacingOf.size() == 2 ? spacingOf[0].get<double>() : 0.25,
                              spacingOf.size() == 2 ? spacingOf[1].get<double>() : 0.25 };
  m_Unit = 1.0 / spacing[0];

  std::map<std::string, std::string> stages;
  std::vector<std::string>           order;
  std::map<std::size_t, std::string> others;
  std::string                        whole, matched, tracing, regions, predicted, errors, names, used;
  bool                               anyMatched = false;
  bool                               anyOfWhole = false;
  for (const auto & entry : JsonMember(view, "jaws").items())
  {
    const std::string & name = entry.key();
    const Json &        drawing = entry.value();
    const Json &        jaw = JsonMember(result.at("jaws"), name);
    const Json &        contours = JsonMember(drawing, "contours");
    const Json &        outline = JsonMember(drawing, "outline_3d");
    tracing += this->DrawTracing(name, drawing);
    const bool hasMatched = contours.contains("matched");
    anyMatched = anyMatched || hasMatched;
    // Of outlines of whole teeth their crowns alone are matched, and outline_3d is the silhouette's.
    anyOfWhole = anyOfWhole || (hasMatched && !jaw.contains("metrics_matched"));
    whole += this->DrawContour(name, JsonMember(contours, "whole"), "whole");
    matched += this->DrawContour(name, JsonMember(contours, hasMatched ? "matched" : "whole"), "matched after");
    regions += this->DrawRegions(jaw);
    this->DrawLandmarks(jaw, predicted, errors, names);
    used += this->DrawUsed(jaw, drawing);
    for (const Json & stage : JsonMember(jaw, "stages"))
    {
      const std::string key = stage.at("stage").get<std::string>();
      if (stages.count(key) == 0)
      {
        order.push_back(key);
      }
      stages[key] +=
        PathElement("stage",
                    stage.contains("projection_3x4")
                      ? this->DrawOutline(outline, stage.at("projection_3x4"))
                      : this->DrawMoved(JsonMember(contours, "whole"), jaw.at("similarity"), stage.at("similarity")));
    }
    const Json & candidates = JsonMember(jaw, "candidates");
    for (std::size_t i = 1; i < candidates.size(); ++i)
    {
      others[i] += PathElement("candidate", this->DrawOutline(outline, candidates[i].at("projection_3x4")));
    }
  }
  for (const std::string & key : order)
  {
    if (!stages[key].empty())
    {
      m_Stages.emplace_back("stage-" + key, StageLabel(key));
      this->AddLayer("stage-" + key, StageLabel(key), false, stages[key]);
    }
  }
  for (const auto & other : others)
  {
    this->AddLayer("candidate-" + std::to_string(other.first + 1),
                   "candidate " + std::to_string(other.first + 1),
                   false,
                   other.second);
  }
  if (anyMatched)
  {
    this->AddLayer("whole", "whole silhouette", false, whole);
  }
  this->AddLayer("tracing", "tracing", true, tracing);
  this->AddLayer("matched", anyMatched ? "matched silhouette" : "whole silhouette", true, matched);
  this->AddLayer("used", "landmarks registered with", true, used);
  this->AddLayer("regions", "95 % regions", true, regions);
  this->AddLayer("landmarks", "predicted landmarks", true, predicted);
  this->AddLayer("errors", "marked landmarks, errors", true, errors);
  this->AddLayer("names", "names", false, names);
  if (!drr.uri.empty())
  {
    m_Layers.push_back({ "drr", "the scan as a radiograph", false });
  }

  const Json & sizeOf = JsonMember(view, "image_size");
  const double size[2] = { sizeOf.size() == 2 ? sizeOf[0].get<double>() : 0.0,
                           sizeOf.size() == 2 ? sizeOf[1].get<double>() : 0.0 };
  if (m_Empty)
  {
    this->Include({ 0.0, 0.0 });
    this->Include({ std::max(1.0, size[0]), std::max(1.0, size[1]) });
  }
  // Pixels that are not square are shown in their true proportions.
  const double stretch = spacing[1] / spacing[0];
  const double width = m_High[0] - m_Low[0];
  const double height = (m_High[1] - m_Low[1]) * stretch;
  const double border = Border * std::max({ width, height, m_Unit });
  const auto   box = Number(m_Low[0] - border) + ' ' + Number(m_Low[1] * stretch - border) + ' ' +
                   Number(width + 2 * border) + ' ' + Number(height + 2 * border);
  const auto all = Number(-0.5) + ' ' + Number(-0.5 * stretch) + ' ' + Number(std::max(1.0, size[0])) + ' ' +
                   Number(std::max(1.0, size[1]) * stretch);
  const double headSize = 0.7 * m_Unit;
  m_SVG =
    "<svg class=\"picture\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" preserveAspectRatio=\"xMidYMid "
    "meet\"" +
    (anyOfWhole ? std::string(" data-after=\"whole\"") : std::string()) + " viewBox=\"" + box + "\" data-home=\"" +
    box + "\" data-all=\"" + all +
    "\" aria-label=\"The radiograph with tracing, outline of the scan and landmarks\">\n<defs><marker id=\"head\" "
    "viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerUnits=\"userSpaceOnUse\" markerWidth=\"" +
    Number(headSize) + "\" markerHeight=\"" + Number(headSize) +
    "\" orient=\"auto\"><path class=\"arrowhead\" d=\"M0 0L10 5L0 10z\"/></marker></defs>\n" +
    "<g transform=\"scale(1 " + FormatForPage(stretch, 6) + ")\">\n";
  if (!radiograph.uri.empty())
  {
    m_SVG += ImageElement("radiograph", radiograph) + '\n';
  }
  else
  {
    m_SVG += "<rect class=\"blank\" x=\"-0.5\" y=\"-0.5\" width=\"" + Number(std::max(1.0, size[0])) + "\" height=\"" +
             Number(std::max(1.0, size[1])) + "\"/>\n";
  }
  if (!drr.uri.empty())
  {
    // Not of the drawing: its opacity is its own.
    m_SVG += "<g class=\"layer\" data-layer=\"drr\" hidden>" + ImageElement("drr", drr) + "</g>\n";
  }
  m_SVG += "<g class=\"drawing\">" + m_Groups + "</g></g></svg>";
}
} // namespace itk
