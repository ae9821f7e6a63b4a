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

#include "itkAnnotationTable.h"
#include "itkAnnotationText.h"
#include "itkCVATRecords.h"
#include "itkDentalInputError.h"
#include "itkForeignAnnotationRecords.h"
#include "itkForeignFile.h"
#include "itkInputFile.h"
#include "itkJsonDocument.h"
#include "itkLabelImageRecords.h"
#include "itkLandmarkEntries.h"
#include "itkLowerCase.h"
#include "itkReadLabelImage.h"
#include "itkSlicerMarkups.h"
#include "itkTextFile.h"
#include "itkVIATable.h"
#include "itkShortNumber.h"

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
    case AnnotationFileFormatEnum::ISBI2015:
      return os << "ISBI2015";
    case AnnotationFileFormatEnum::CVAT:
      return os << "CVAT";
    case AnnotationFileFormatEnum::COCO:
      return os << "COCO";
    case AnnotationFileFormatEnum::VIA:
      return os << "VIA";
    case AnnotationFileFormatEnum::LabelStudio:
      return os << "LabelStudio";
    case AnnotationFileFormatEnum::Supervisely:
      return os << "Supervisely";
    case AnnotationFileFormatEnum::WebCeph:
      return os << "WebCeph";
    default:
      return os << "LabelImage";
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
  if (format == Format::Aariz || format == Format::LandmarkDetector || format == Format::CLDetection ||
      format == Format::ISBI2015 || format == Format::WebCeph)
  {
    std::ostringstream problem;
    problem << "format " << format << " has only the landmarks of a cephalometric analysis";
    itkDentalInputErrorMacro(
      fileName, "", problem.str(), "read it as cephalometric landmarks (\"cephalometric_landmarks\" of a case)");
  }
}

/** "Calibration_30mm" is 30; 0 for any other label. */
double
ParseCalibration(const std::string & label)
{
  const std::string text = LowerCase(Trim(label));
  std::size_t       begin = std::string::npos;
  for (const char * word : { "calibration", "calib", "ruler", "scale bar", "scale_bar", "scale" })
  {
    if (text.compare(0, std::string(word).size(), word) == 0)
    {
      begin = text.find_first_not_of(" _-:", std::string(word).size());
      break;
    }
  }
  if (begin == std::string::npos)
  {
    return 0.0;
  }
  const std::size_t end = std::min(text.find_first_not_of("0123456789.", begin), text.size());
  const std::size_t unit = text.find_first_not_of(" _-", end);
  double            length = 0.0;
  if (unit == std::string::npos || !ParseNumber(text.substr(begin, end - begin), length))
  {
    return 0.0;
  }
  return text.substr(unit) == "mm" ? length : text.substr(unit) == "cm" ? 10.0 * length : 0.0;
}

/** Takes the lines of known length out of what was drawn: they are no teeth. A ruler is straight, so that its ends tell
 * its length. */
void
TakeCalibrations(AnnotationRecords & records)
{
  std::vector<AnnotationPolyline> contours;
  for (AnnotationPolyline & polyline : records.polylines)
  {
    const double millimetres = polyline.points.size() >= 2 ? ParseCalibration(polyline.label) : 0.0;
    if (!(millimetres > 0.0))
    {
      contours.push_back(std::move(polyline));
      continue;
    }
    AnnotationCalibration calibration{ polyline.field, polyline.label, millimetres, {} };
    for (std::size_t d = 0; d < 2; ++d)
    {
      calibration.pixels[d] = polyline.points.back()[d] - polyline.points.front()[d];
    }
    records.calibrations.push_back(std::move(calibration));
  }
  records.polylines = std::move(contours);
}

/** First character that is no blank, behind a byte order mark; 0 where there is none. */
char
FirstCharacter(const std::string & fileName)
{
  const std::string head = ReadFileHead(fileName, 512);
  const std::size_t first = head.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return first == std::string::npos ? '\0' : head[first];
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

/** One number for all points, or one a point, of which null is one that is not known. */
void
ReadSigmas(const JsonNode & node, std::size_t count, std::vector<double> & sigmas)
{
  const auto check = [](const JsonNode & value) {
    const double sigma = value.AsNumber();
    if (!(sigma > 0.0))
    {
      std::ostringstream problem;
      problem << "is " << sigma << ", no standard deviation";
      value.Fail(problem.str(), "give pixels above 0, or leave the field out");
    }
    return sigma;
  };
  if (node.IsArray())
  {
    if (node.GetSize() != count)
    {
      node.Fail("has " + std::to_string(node.GetSize()) + " values, expected " + std::to_string(count) +
                  " (one a point)",
                "give one a point, null where it is not known");
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      sigmas.push_back(node.At(i).IsNull() ? 0.0 : check(node.At(i)));
    }
  }
  else
  {
    sigmas.assign(count, check(node));
  }
}

AnnotationPolyline
ReadPolyline(const JsonNode & node, const std::string & jaw)
{
  AnnotationPolyline polyline;
  polyline.field = node.GetPath();
  polyline.codeField = node.GetPath() + ".code";
  polyline.jaw = jaw;
  node.WarnAboutUnknownFields({ "code", "points", "closed", "weights", "sigma_px", "outline", "drafted" });
  if (const auto code = node.Find("code"))
  {
    polyline.label = ReadCode(*code);
  }
  if (const auto closed = node.Find("closed"))
  {
    polyline.closed = closed->AsBoolean();
  }
  if (const auto drafted = node.Find("drafted"))
  {
    polyline.drafted = drafted->AsBoolean();
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
        weights->At(i).Fail("is " + ShortNumber(polyline.weights[i]) + ", not in [0, 1]",
                            "use 1 for a certain point and 0 for one to be ignored");
      }
    }
  }
  if (const auto sigma = node.Find("sigma_px"))
  {
    ReadSigmas(*sigma, count, polyline.sigmas);
  }
  if (const auto outline = node.Find("outline"))
  {
    try
    {
      polyline.outline = DentalContour::OutlineFromString(outline->AsString());
    }
    catch (const std::invalid_argument & error)
    {
      outline->Fail(error.what(), "write one of them, or leave the field out");
    }
  }
  return polyline;
}

void
ReadOwnContours(const JsonNode & root, AnnotationRecords & records)
{
  if (!root.IsObject() || !root.Find("contours"))
  {
    RefuseUnknownAnnotation(root);
    std::vector<std::string> names;
    if (root.IsObject() || (root.GetSize() > 0 && root.At(0).IsObject()))
    {
      for (const auto & member : root.IsObject() ? root.GetMembers() : root.At(0).GetMembers())
      {
        names.push_back(member.first);
      }
    }
    itkDentalInputErrorMacro(root.GetFileName(),
                             root.IsObject() ? "contours" : "",
                             "is JSON in no form that is known" +
                               (names.empty() ? "" : ", with the fields " + ListNames(names)),
                             "export it for labelme, COCO, VIA, Label Studio or Supervisely, or write it as "
                             "Documentation/FileFormats.md says, with \"contours\"");
  }
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
  RefuseUnknownAnnotation(root);
  for (const LandmarkEntry & entry : FindLandmarkEntries(root, dimension))
  {
    const auto        known = std::find_if(entry.names.begin(), entry.names.end(), NamesPointOfTooth);
    const std::string name = known != entry.names.end() ? *known
                             : !entry.names.empty()     ? entry.names.front()
                                                        : entry.node.Get("name").AsString();
    // Anything may stand beside the landmarks, such as a comment: the reader warns about names that are none.
    if (!IsLandmarkPlace(entry.node))
    {
      entry.node.Warn("is no landmark, ignored");
      continue;
    }
    if (const auto point = ReadLandmarkPlace(entry.node, dimension, nullptr))
    {
      records.landmarks.push_back({ entry.node.GetPath(), name, *point });
    }
    else
    {
      entry.node.Warn("\"" + name + "\" is not marked");
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
} // namespace

void
VerifyCoordinate(const std::string & fileName, const std::string & field, double coordinate)
{
  // Negated, so that what is no number is refused, too.
  if (!(std::abs(coordinate) <= static_cast<double>(MaximumImageSize)))
  {
    std::ostringstream problem;
    problem << "has a coordinate of " << coordinate << ", where no pixel of a radiograph and no point of a scan is";
    itkDentalInputErrorMacro(
      fileName, field, problem.str(), "correct it: coordinates are up to " + std::to_string(MaximumImageSize));
  }
}

void
VerifyAreNoShares(const std::string & fileName, const AnnotationRecords & records)
{
  std::size_t count = 0;
  std::size_t between = 0;
  bool        areShares = true;
  std::string field;
  const auto  look = [&](const std::string & where, const std::array<double, 3> & point) {
    field = count++ == 0 ? where : field;
    for (std::size_t i = 0; i < 2; ++i)
    {
      areShares = areShares && point[i] >= 0.0 && point[i] <= 1.0;
      between += point[i] > 0.0 && point[i] < 1.0 ? 1 : 0;
    }
  };
  for (const AnnotationLandmark & landmark : records.landmarks)
  {
    look(landmark.field, landmark.point);
  }
  for (const AnnotationPolyline & polyline : records.polylines)
  {
    for (const auto & point : polyline.points)
    {
      look(polyline.field, point);
    }
  }
  // Two points, as one may be a slip at the corner; and not where all lie at 0, which is another fault.
  if (areShares && count >= 2 && between >= count)
  {
    itkDentalInputErrorMacro(fileName,
                             field,
                             "all coordinates are from 0 to 1: shares of the picture's size, and no pixels",
                             "multiply x by the picture's width and y by its height");
  }
}

AnnotationFileFormatEnum
AnnotationFormatFromFile(const std::string & fileName)
{
  const Format named = FormatFromName(fileName);
  if (named != Format::Automatic)
  {
    return IsVIATable(fileName) ? Format::VIA : named;
  }
  const char first = FirstCharacter(fileName);
  if (first == '{' || first == '[')
  {
    return Format::Automatic;
  }
  // Of what gzip has compressed only a NIfTI image comes so far, and what is wrong with it is said by its reader.
  const bool isCompressed = first == '\x1f';
  return first == '<' ? Format::CVAT : isCompressed || IsImageFile(fileName) ? Format::LabelImage : Format::Automatic;
}

AnnotationFileFormatEnum
AnnotationFormatFromContent(const JsonNode & root)
{
  if (root.IsObject() && root.Find("markups"))
  {
    return Format::SlicerMarkups;
  }
  if (root.IsObject() && root.Find("shapes"))
  {
    return Format::Labelme;
  }
  return RecognizeForeignAnnotation(root);
}

namespace
{
AnnotationRecords
ReadAnyContourRecords(const std::string &                fileName,
                      AnnotationFileFormatEnum           format,
                      const std::string &                imageName,
                      const std::array<std::size_t, 2> & imageSize)
{
  RefuseCephalometricFormat(fileName, format);
  RefuseForeignFile(fileName, FilePurposeEnum::Tracing);
  AnnotationRecords records;
  records.format = format == Format::Automatic ? AnnotationFormatFromFile(fileName) : format;
  switch (records.format)
  {
    case Format::CSV:
      for (AnnotationTableRow & row : ReadAnnotationTable(fileName, 2, imageName, records.warnings))
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
    case Format::LabelImage:
      return ReadLabelImageRecords(fileName, imageSize);
    case Format::CVAT:
      records = ReadCVATRecords(fileName, imageName);
      TakeCalibrations(records);
      return records;
    default:
      break;
  }
  if (records.format == Format::VIA && IsVIATable(fileName))
  {
    records = ReadVIATable(fileName, imageName);
    TakeCalibrations(records);
    return records;
  }
  RequireJsonBeginning(fileName);
  const JsonDocument document = JsonDocument::ReadFile(fileName);
  const JsonNode     root = document.GetRoot();
  if (records.format == Format::Automatic)
  {
    records.format = AnnotationFormatFromContent(root);
  }
  switch (records.format)
  {
    case Format::SlicerMarkups:
      ReadSlicerContours(root, records);
      break;
    case Format::Labelme:
      ReadLabelme(root, records, false);
      break;
    case Format::COCO:
    case Format::VIA:
    case Format::LabelStudio:
    case Format::Supervisely:
      ReadForeignAnnotation(root, imageName, records);
      break;
    default:
      ReadOwnContours(root, records);
  }
  if (records.format != Format::DentalSCR && records.format != Format::SlicerMarkups)
  {
    TakeCalibrations(records);
  }
  records.warnings.insert(records.warnings.begin(), document.GetWarnings().begin(), document.GetWarnings().end());
  return records;
}
} // namespace

AnnotationRecords
ReadContourRecords(const std::string &                fileName,
                   AnnotationFileFormatEnum           format,
                   const std::string &                imageName,
                   const std::array<std::size_t, 2> & imageSize)
{
  AnnotationRecords records = ReadAnyContourRecords(fileName, format, imageName, imageSize);
  std::size_t       count = 0;
  for (const AnnotationPolyline & polyline : records.polylines)
  {
    count += polyline.points.size();
  }
  if (count > MaximumNumberOfContourPoints)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "has " + std::to_string(count) + " points, more than the " +
                               std::to_string(MaximumNumberOfContourPoints) + " that a tracing may have",
                             "thin the outlines out to a point a pixel");
  }
  VerifyAreNoShares(fileName, records);
  return records;
}

AnnotationRecords
ReadLandmarkRecords(const std::string &      fileName,
                    AnnotationFileFormatEnum format,
                    unsigned int             dimension,
                    const std::string &      imageName)
{
  RefuseCephalometricFormat(fileName, format);
  RefuseForeignFile(fileName, FilePurposeEnum::Landmarks);
  if (format == Format::Automatic)
  {
    format = AnnotationFormatFromFile(fileName);
  }
  AnnotationRecords records;
  records.format = format;
  if (format == Format::CSV)
  {
    for (AnnotationTableRow & row : ReadAnnotationTable(fileName, dimension, imageName, records.warnings))
    {
      records.landmarks.push_back({ row.field, row.label, row.point });
    }
    return records;
  }
  const bool isVIATable = format == Format::VIA && IsVIATable(fileName);
  if (format == Format::CVAT || format == Format::LabelImage || isVIATable)
  {
    if (dimension != 2 || format == Format::LabelImage)
    {
      itkDentalInputErrorMacro(fileName,
                               "",
                               dimension != 2 ? "is a file of a picture, which has no 3-D landmarks"
                                              : "is an image, which has no landmarks with names",
                               "name the right file");
    }
    return isVIATable ? ReadVIATable(fileName, imageName) : ReadCVATRecords(fileName, imageName);
  }
  RequireJsonBeginning(fileName);
  const JsonDocument document = JsonDocument::ReadFile(fileName);
  records = ReadLandmarkRecords(document.GetRoot(), format, dimension, imageName);
  records.warnings.insert(records.warnings.begin(), document.GetWarnings().begin(), document.GetWarnings().end());
  return records;
}

AnnotationRecords
ReadLandmarkRecords(const JsonNode &         root,
                    AnnotationFileFormatEnum format,
                    unsigned int             dimension,
                    const std::string &      imageName)
{
  AnnotationRecords records;
  records.format = format == Format::Automatic ? AnnotationFormatFromContent(root) : format;
  const bool foreign = records.format != Format::SlicerMarkups && records.format != Format::DentalSCR;
  if (foreign && dimension != 2)
  {
    std::ostringstream problem;
    problem << "a file of " << records.format << " has no 3-D landmarks";
    itkDentalInputErrorMacro(root.GetFileName(), "", problem.str(), "name the right file");
  }
  switch (records.format)
  {
    case Format::SlicerMarkups:
      ReadSlicerLandmarks(root, records);
      break;
    case Format::Labelme:
      ReadLabelme(root, records, true);
      break;
    case Format::COCO:
    case Format::VIA:
    case Format::LabelStudio:
    case Format::Supervisely:
      ReadForeignAnnotation(root, imageName, records);
      break;
    default:
      ReadOwnLandmarks(root, records, dimension);
  }
  return records;
}
} // namespace itk
