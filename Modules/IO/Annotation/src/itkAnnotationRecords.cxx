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
#include "itkAnnotationRecords.h"

#include "itkAnnotationText.h"
#include "itkDentalInputError.h"
#include "itkJsonDocument.h"
#include "itkTextFile.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace itk
{
std::ostream &
operator<<(std::ostream & os, AnnotationFileFormatEnum format)
{
  switch (format)
  {
    case AnnotationFileFormatEnum::Automatic:
      return os << "Automatic";
    case AnnotationFileFormatEnum::DentalSCR:
      return os << "DentalSCR";
    case AnnotationFileFormatEnum::SlicerMarkups:
      return os << "SlicerMarkups";
    case AnnotationFileFormatEnum::Labelme:
      return os << "Labelme";
    case AnnotationFileFormatEnum::CSV:
      return os << "CSV";
    case AnnotationFileFormatEnum::Aariz:
      return os << "Aariz";
    case AnnotationFileFormatEnum::LandmarkDetector:
      return os << "LandmarkDetector";
    case AnnotationFileFormatEnum::CLDetection:
      return os << "CLDetection";
    default:
      return os << "ISBI2015";
  }
}

std::ostream &
operator<<(std::ostream & os, AnnotationPixelOriginEnum origin)
{
  switch (origin)
  {
    case AnnotationPixelOriginEnum::FormatDefault:
      return os << "FormatDefault";
    case AnnotationPixelOriginEnum::Centre:
      return os << "Centre";
    default:
      return os << "Corner";
  }
}

namespace
{
using Format = AnnotationFileFormatEnum;

/** A pixel count of either direction; no radiograph has a tenth of it. */
constexpr int64_t MaximumImageSize = 1000000;

Format
FormatFromName(const std::string & fileName)
{
  const std::string lower = LowerCase(fileName);
  return EndsWith(lower, ".csv") || EndsWith(lower, ".tsv") || EndsWith(lower, ".txt") ? Format::CSV
                                                                                       : Format::Automatic;
}

/** Formats of which neither contours nor landmarks of named teeth are made. */
void
RefuseCephalometricFormat(const std::string & fileName, Format format)
{
  if (format > Format::CSV)
  {
    std::ostringstream problem;
    problem << "format " << format << " has only the landmarks of a cephalometric analysis";
    itkDentalInputErrorMacro(
      fileName, "", problem.str(), "read it as cephalometric landmarks (\"cephalometric_landmarks\" of a case)");
  }
}

Format
FormatFromContent(const JsonNode & root)
{
  if (root.IsObject() && root.Find("markups"))
  {
    return Format::SlicerMarkups;
  }
  return root.IsObject() && root.Find("shapes") ? Format::Labelme : Format::DentalSCR;
}

// ---- the toolkit's own ------------------------------------------------------------------------------------------

/** A code may be written as a number: 11 is "11". */
std::string
ReadCode(const JsonNode & node)
{
  if (node.IsNumber())
  {
    return std::to_string(node.AsInteger(0, 99));
  }
  return node.IsNull() ? std::string() : node.AsString();
}

AnnotationPolyline
ReadPolyline(const JsonNode & node, const std::string & jaw)
{
  AnnotationPolyline polyline;
  polyline.field = node.GetPath();
  polyline.codeField = node.GetPath() + ".code";
  polyline.jaw = jaw;
  node.WarnAboutUnknownFields({ "code", "points", "closed", "weights" });
  if (const auto code = node.Find("code"))
  {
    polyline.label = ReadCode(*code);
  }
  if (const auto closed = node.Find("closed"))
  {
    polyline.closed = closed->AsBoolean();
  }
  const JsonNode    points = node.Get("points");
  const std::size_t count = points.GetSize();
  polyline.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::vector<double> point = points.At(i).AsNumbers(2, "[u, v]");
    polyline.points.push_back({ { point[0], point[1], 0.0 } });
  }
  if (const auto weights = node.Find("weights"))
  {
    polyline.weights = weights->AsNumbers(count, "(one a point)");
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!(polyline.weights[i] >= 0.0 && polyline.weights[i] <= 1.0))
      {
        weights->At(i).Fail("is " + std::to_string(polyline.weights[i]) + ", not in [0, 1]",
                            "use 1 for a certain point and 0 for one to be ignored");
      }
    }
  }
  return polyline;
}

void
ReadOwnContours(const JsonNode & root, AnnotationRecords & records)
{
  root.WarnAboutUnknownFields({ "image_size", "contours", "numbering" });
  if (const auto size = root.Find("image_size"))
  {
    size->AsNumbers(2, "[width, height]");
    records.imageSizeField = size->GetPath();
    records.imageSize = { static_cast<std::size_t>(size->At(0).AsInteger(1, MaximumImageSize)),
                          static_cast<std::size_t>(size->At(1).AsInteger(1, MaximumImageSize)) };
  }
  if (const auto numbering = root.Find("numbering"))
  {
    records.numbering = numbering->AsString();
    records.numberingField = numbering->GetPath();
  }
  const JsonNode contours = root.Get("contours");
  contours.WarnAboutUnknownFields({ "upper", "lower" });
  for (const char * jaw : { "upper", "lower" })
  {
    if (const auto polylines = contours.Find(jaw))
    {
      for (std::size_t i = 0; i < polylines->GetSize(); ++i)
      {
        records.polylines.push_back(ReadPolyline(polylines->At(i), jaw));
      }
    }
  }
}

void
ReadOwnLandmarks(const JsonNode & root, AnnotationRecords & records, unsigned int dimension)
{
  for (const auto & [name, node] : root.GetMembers())
  {
    AnnotationLandmark landmark{ node.GetPath(), name, {} };
    // Anything may stand beside the landmarks, such as a comment: the reader warns about names that are none.
    if (node.IsArray() || node.IsNumber())
    {
      const std::vector<double> point = node.AsNumbers(dimension, dimension == 2 ? "[u, v]" : "[x, y, z]");
      std::copy(point.begin(), point.end(), landmark.point.begin());
      records.landmarks.push_back(landmark);
    }
    else
    {
      node.Warn("is no landmark, ignored");
    }
  }
}

// ---- 3D Slicer ----------------------------------------------------------------------------------------------------

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
    polyline.label = name ? name->AsString() : std::string();
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

// ---- labelme ------------------------------------------------------------------------------------------------------

void
ReadLabelme(const JsonNode & root, AnnotationRecords & records, bool landmarks)
{
  const auto width = root.Find("imageWidth");
  const auto height = root.Find("imageHeight");
  if (width && height && !width->IsNull() && !height->IsNull())
  {
    records.imageSizeField = width->GetPath();
    records.imageSize = { static_cast<std::size_t>(width->AsInteger(1, MaximumImageSize)),
                          static_cast<std::size_t>(height->AsInteger(1, MaximumImageSize)) };
  }
  const JsonNode shapes = root.Get("shapes");
  for (std::size_t i = 0; i < shapes.GetSize(); ++i)
  {
    const JsonNode    shape = shapes.At(i);
    const JsonNode    label = shape.Get("label");
    const auto        typeNode = shape.Find("shape_type");
    const std::string type = typeNode ? typeNode->AsString() : "polygon";
    const JsonNode    points = shape.Get("points");
    if (landmarks)
    {
      if (type == "point" && points.GetSize() > 0)
      {
        const std::vector<double> point = points.At(0).AsNumbers(2, "[x, y]");
        records.landmarks.push_back({ label.GetPath(), label.AsString(), { { point[0], point[1], 0.0 } } });
      }
      continue;
    }
    if (type != "polygon" && type != "linestrip" && type != "line")
    {
      shape.Warn("a shape of type " + type + " is no contour, ignored");
      continue;
    }
    AnnotationPolyline polyline;
    polyline.field = shape.GetPath();
    polyline.codeField = label.GetPath();
    polyline.label = label.AsString();
    polyline.closed = type == "polygon";
    for (std::size_t j = 0; j < points.GetSize(); ++j)
    {
      const std::vector<double> point = points.At(j).AsNumbers(2, "[x, y]");
      polyline.points.push_back({ { point[0], point[1], 0.0 } });
    }
    records.polylines.push_back(std::move(polyline));
  }
}

// ---- CSV ----------------------------------------------------------------------------------------------------------

struct CSVRow
{
  std::string           field;
  std::string           label;
  std::array<double, 3> point;
};

std::vector<CSVRow>
ReadCSV(const std::string & fileName, unsigned int dimension)
{
  std::string text = ReadTextFile(fileName, "CSV");
  if (text.compare(0, 3, "\xef\xbb\xbf") == 0)
  {
    text.erase(0, 3);
  }
  const std::string   form = dimension == 2 ? "label,x,y" : "label,x,y,z";
  const std::string   unit = dimension == 2 ? "px" : "mm";
  std::vector<CSVRow> rows;
  char                separator = 0;
  std::size_t         lineNumber = 0;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++lineNumber;
    const std::string trimmed = Trim(line);
    if (trimmed.empty() || trimmed[0] == '#')
    {
      continue;
    }
    const std::string field = "line " + std::to_string(lineNumber);
    const bool        first = separator == 0;
    if (first)
    {
      separator = ',';
      for (const char candidate : { ';', '\t' })
      {
        if (line.find(candidate) != std::string::npos)
        {
          separator = candidate;
        }
      }
    }
    const std::vector<std::string> cells = Split(line, separator);
    if (first && cells.size() >= 3 && LowerCase(cells[0]) == "label" && LowerCase(cells[1]) == "x")
    {
      continue;
    }
    if (cells.size() != dimension + 1 && cells.size() != dimension + 2)
    {
      itkDentalInputErrorMacro(fileName,
                               field,
                               "has " + std::to_string(cells.size()) + " columns, expected " + form +
                                 " and perhaps a unit",
                               "correct the line");
    }
    CSVRow row{ field, cells[0], {} };
    for (unsigned int i = 0; i < dimension; ++i)
    {
      if (!ParseNumber(cells[i + 1], row.point[i]))
      {
        itkDentalInputErrorMacro(
          fileName, field, "\"" + cells[i + 1].substr(0, 40) + "\" is no number", "use numbers with a decimal point");
      }
    }
    if (cells.size() == dimension + 2 && cells.back() != unit && !cells.back().empty())
    {
      itkDentalInputErrorMacro(fileName,
                               field,
                               "the unit \"" + cells.back().substr(0, 40) + "\" is not \"" + unit + "\"",
                               "convert the coordinates");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}
} // namespace

AnnotationRecords
ReadContourRecords(const std::string & fileName, AnnotationFileFormatEnum format)
{
  RefuseCephalometricFormat(fileName, format);
  AnnotationRecords records;
  records.format = format == Format::Automatic ? FormatFromName(fileName) : format;
  if (records.format == Format::CSV)
  {
    for (CSVRow & row : ReadCSV(fileName, 2))
    {
      if (records.polylines.empty() || records.polylines.back().label != row.label)
      {
        records.polylines.emplace_back();
        records.polylines.back().field = row.field;
        records.polylines.back().codeField = row.field;
        records.polylines.back().label = row.label;
      }
      records.polylines.back().points.push_back(row.point);
    }
    return records;
  }
  const JsonDocument document = JsonDocument::ReadFile(fileName);
  const JsonNode     root = document.GetRoot();
  if (records.format == Format::Automatic)
  {
    records.format = FormatFromContent(root);
  }
  switch (records.format)
  {
    case Format::SlicerMarkups:
      ReadSlicerContours(root, records);
      break;
    case Format::Labelme:
      ReadLabelme(root, records, false);
      break;
    default:
      ReadOwnContours(root, records);
  }
  records.warnings = document.GetWarnings();
  return records;
}

AnnotationRecords
ReadLandmarkRecords(const std::string & fileName, AnnotationFileFormatEnum format, unsigned int dimension)
{
  RefuseCephalometricFormat(fileName, format);
  if (format == Format::Automatic)
  {
    format = FormatFromName(fileName);
  }
  if (format == Format::CSV)
  {
    AnnotationRecords records;
    records.format = format;
    for (CSVRow & row : ReadCSV(fileName, dimension))
    {
      records.landmarks.push_back({ row.field, row.label, row.point });
    }
    return records;
  }
  const JsonDocument document = JsonDocument::ReadFile(fileName);
  AnnotationRecords  records = ReadLandmarkRecords(document.GetRoot(), format, dimension);
  records.warnings = document.GetWarnings();
  return records;
}

AnnotationRecords
ReadLandmarkRecords(const JsonNode & root, AnnotationFileFormatEnum format, unsigned int dimension)
{
  AnnotationRecords records;
  records.format = format == Format::Automatic ? FormatFromContent(root) : format;
  switch (records.format)
  {
    case Format::SlicerMarkups:
      ReadSlicerLandmarks(root, records);
      break;
    case Format::Labelme:
      if (dimension != 2)
      {
        itkDentalInputErrorMacro(
          root.GetFileName(), "shapes", "a labelme file has no 3-D landmarks", "name the right file");
      }
      ReadLabelme(root, records, true);
      break;
    default:
      ReadOwnLandmarks(root, records, dimension);
  }
  return records;
}
} // namespace itk
