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
#include "itkSlicerMarkups.h"

#include "itkAnnotationText.h"
#include "itkJsonDocument.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
namespace
{
/** +1 where the positions are LPS, -1 where x and y have to change sign. */
double
ReadCoordinateSystem(const JsonNode & markup)
{
  if (const auto units = markup.Find("coordinateUnits"))
  {
    const std::string unit = units->IsArray() && units->GetSize() > 0 ? units->At(0).AsString() : units->AsString();
    if (unit != "mm")
    {
      units->Fail("is \"" + unit + "\", expected \"mm\"", "save the markups with millimetres");
    }
  }
  const auto system = markup.Find("coordinateSystem");
  if (!system)
  {
    return 1.0;
  }
  // The first files of Slicer had numbers.
  const std::string name = system->IsNumber() ? (system->AsInteger(0, 1) == 0 ? "RAS" : "LPS") : system->AsString();
  if (name != "LPS" && name != "RAS")
  {
    system->Fail("is \"" + name + "\", expected \"LPS\" or \"RAS\"", "save the markups in one of them");
  }
  return name == "LPS" ? 1.0 : -1.0;
}

/** What the control points are called without their numbers: Slicer writes no name of a curve, but names its points
 * after it, "UR1-1", "UR1-2". "" where they are not alike. */
std::string
NameFromControlPoints(const JsonNode & markup)
{
  std::string name;
  const auto  points = markup.Find("controlPoints");
  for (std::size_t i = 0; points && i < points->GetSize(); ++i)
  {
    const auto  label = points->At(i).Find("label");
    std::string text = label && label->IsString() ? label->AsString() : std::string();
    const auto  end = text.find_last_not_of("0123456789");
    // Only behind Slicer's hyphen: "UR1" itself ends with a number.
    if (end != std::string::npos && end > 0 && end + 1 < text.size() && text[end] == '-')
    {
      text.resize(end);
    }
    if (i > 0 && text != name)
    {
      return std::string();
    }
    name = text;
  }
  return name;
}

/** The beginning of the file's name, which is that of the node that Slicer saved in it, where it is a tooth or a jaw.
 */
std::string
NameFromFile(const JsonNode & root)
{
  const std::string path = root.GetFileName();
  const std::size_t slash = path.find_last_of("/\\");
  const std::string name = path.substr(slash == std::string::npos ? 0 : slash + 1);
  const std::string stem = name.substr(0, name.find('.'));
  return NamesToothOrJaw(stem) ? stem : std::string();
}

template <typename TFunction>
void
ForEachControlPoint(const JsonNode & markup, const TFunction & function)
{
  const double sign = ReadCoordinateSystem(markup);
  const auto   points = markup.Find("controlPoints");
  for (std::size_t i = 0; points && i < points->GetSize(); ++i)
  {
    const JsonNode point = points->At(i);
    const auto     status = point.Find("positionStatus");
    if (status && status->AsString() != "defined")
    {
      continue;
    }
    const std::vector<double> position = point.Get("position").AsNumbers(3, "[x, y, z]");
    function(point, std::array<double, 3>{ { sign * position[0], sign * position[1], position[2] } });
  }
}
} // namespace

void
ReadSlicerContours(const JsonNode & root, AnnotationRecords & records)
{
  const JsonNode markups = root.Get("markups");
  for (std::size_t i = 0; i < markups.GetSize(); ++i)
  {
    const JsonNode      markup = markups.At(i);
    const std::string & type = markup.Get("type").AsString();
    if (type != "Curve" && type != "ClosedCurve" && type != "Line")
    {
      markup.Warn("a markup of type " + type + " is no contour, ignored");
      continue;
    }
    AnnotationPolyline polyline;
    polyline.field = markup.GetPath();
    polyline.closed = type == "ClosedCurve";
    const auto name = markup.Find("name");
    polyline.codeField = markup.GetPath() + ".name";
    polyline.label = name ? name->AsString() : NameFromControlPoints(markup);
    if (!NamesToothOrJaw(polyline.label) && markups.GetSize() == 1)
    {
      const std::string fromFile = NameFromFile(root);
      polyline.label = fromFile.empty() ? polyline.label : fromFile;
    }
    ForEachControlPoint(markup, [&](const JsonNode & point, const std::array<double, 3> & position) {
      // A radiograph lies in one plane; half a pixel off it is no longer rounding.
      constexpr double tolerance = 0.05;
      if (!polyline.points.empty() && std::abs(position[2] - polyline.points.front()[2]) > tolerance)
      {
        point.Fail("does not lie in the plane of the contour's first point", "trace on the radiograph's slice");
      }
      polyline.points.push_back(position);
    });
    records.polylines.push_back(std::move(polyline));
  }
}

void
ReadSlicerLandmarks(const JsonNode & root, AnnotationRecords & records)
{
  const JsonNode markups = root.Get("markups");
  for (std::size_t i = 0; i < markups.GetSize(); ++i)
  {
    const JsonNode markup = markups.At(i);
    if (markup.Get("type").AsString() == "Fiducial")
    {
      ForEachControlPoint(markup, [&](const JsonNode & point, const std::array<double, 3> & position) {
        const JsonNode label = point.Get("label");
        records.landmarks.push_back({ label.GetPath(), label.AsString(), position });
      });
    }
  }
}
} // namespace itk
