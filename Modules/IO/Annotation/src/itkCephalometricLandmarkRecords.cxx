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
#include "itkCephalometricLandmarkRecords.h"

#include "itkAnnotationText.h"
#include "itkCVATRecords.h"
#include "itkDentalInputError.h"
#include "itkForeignAnnotationRecords.h"
#include "itkForeignFile.h"
#include "itkJsonDocument.h"
#include "itkLandmarkEntries.h"
#include "itkLowerCase.h"
#include "itkMakeUTF8.h"
#include "itkTextFile.h"
#include "itkVIATable.h"
#include "itkWebCephRecords.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace itk
{
namespace
{
using Format = AnnotationFileFormatEnum;

/** A landmark that a challenge knows by its number only. */
struct NumberedLandmark
{
  std::size_t  number;
  const char * name;
};

/** Of ISBI 2015 (and of the Hamedan set, which took its list over): "lower incisal incision" is 11, the upper one 12.
 */
constexpr NumberedLandmark ISBILandmarks[] = { { 11, "L1_tip" }, { 12, "U1_tip" } };
constexpr std::size_t      NumberOfISBILandmarks = 19;

/** Of CL-Detection 2023, by the list in the organizers' repository cwwang1979/CL-detection2023 (README.md): the molars'
 * are mesial contact points, in the middle of double images. */
constexpr NumberedLandmark CLDetectionLandmarks[] = { { 11, "L1_tip" },  { 12, "U1_tip" },    { 21, "U1_apex" },
                                                      { 22, "L1_apex" }, { 37, "U6_mesial" }, { 38, "L6_mesial" } };
constexpr std::size_t      NumberOfCLDetectionLandmarks = 38;

/** A detector's words for how sure it is, in the middle of the third of 0 to 1 that each stands for. */
double
ConfidenceFromWord(const JsonNode & node)
{
  const std::string word = LowerCase(node.AsString());
  if (word == "high")
  {
    return 5.0 / 6.0;
  }
  if (word == "medium")
  {
    return 0.5;
  }
  if (word == "low")
  {
    return 1.0 / 6.0;
  }
  node.Fail("\"" + word + "\" is no confidence", R"(write "high", "medium", "low" or a number from 0 to 1)");
}

double
ConfidenceFromNumber(const JsonNode & node)
{
  const double value = node.AsNumber();
  if (!(value >= 0.0 && value <= 1.0))
  {
    std::ostringstream problem;
    problem << value << " is not from 0 to 1";
    node.Fail(problem.str(), "divide a percentage by 100, or leave the field out");
  }
  return value;
}

/** A number says more than a word: "peak" is taken where "confidence" is a word or not there. */
double
ReadConfidence(const JsonNode & landmark)
{
  const auto confidence = landmark.Find("confidence");
  if (confidence && confidence->IsNumber())
  {
    return ConfidenceFromNumber(*confidence);
  }
  // Checked even where the peak counts: a word that nobody knows may mean "not found".
  const double word = confidence && !confidence->IsNull() ? ConfidenceFromWord(*confidence) : -1.0;
  const auto   peak = landmark.Find("peak");
  return peak && !peak->IsNull() ? ConfidenceFromNumber(*peak) : word;
}

double
ReadSigma(const JsonNode & node)
{
  const double value = node.AsNumber();
  if (!(value > 0.0))
  {
    std::ostringstream problem;
    problem << value << " is no standard deviation";
    node.Fail(problem.str(), "give pixels above 0, or leave the field out");
  }
  return value;
}

// ---- JSON ---------------------------------------------------------------------------------------------------------

/** Landmarks by name or as a list, as this toolkit, Aariz, detectors and everybody's own scripts write them. */
void
ReadEntries(const JsonNode & root, AnnotationRecords & records, const IsDentalLandmarkType & isDental)
{
  for (const LandmarkEntry & entry : FindLandmarkEntries(root, 2))
  {
    const auto        known = std::find_if(entry.names.begin(), entry.names.end(), isDental);
    const std::string name = known != entry.names.end() ? *known
                             : !entry.names.empty()     ? entry.names.front()
                                                        : entry.node.Get("name").AsString();
    if (known == entry.names.end())
    {
      // What stands under a name is called by it.
      records.leftOut.push_back(entry.isListed ? name : entry.names.back());
      continue;
    }
    const bool isObject = entry.node.IsObject();
    const auto point =
      entry.node.IsNull() ? std::nullopt : ReadLandmarkPlace(entry.node, 2, entry.isListed ? nullptr : "position");
    if (!point)
    {
      entry.node.Warn(entry.isListed ? "\"" + name + "\" was not found" : std::string("is not marked"));
      continue;
    }
    AnnotationLandmark landmark{ entry.node.GetPath(), name, *point };
    if (isObject)
    {
      if (!entry.isListed && entry.node.Find("position"))
      {
        entry.node.WarnAboutUnknownFields({ "position", "sigma_px", "confidence", "peak" });
      }
      // Of lists no program is known to write a sigma, but who adds it by hand means it.
      if (const auto sigma = entry.node.Find("sigma_px"))
      {
        landmark.sigma = ReadSigma(*sigma);
      }
      // Aariz has one tracing by people, and whatever it may call confidence is not known.
      if (records.format != Format::Aariz)
      {
        landmark.confidence = ReadConfidence(entry.node);
      }
    }
    records.landmarks.push_back(std::move(landmark));
  }
}

Format
FormatFromContent(const JsonNode & root)
{
  const auto list = root.IsObject() ? root.Find("landmarks") : std::nullopt;
  if (!list || !list->IsArray())
  {
    return Format::Automatic;
  }
  for (std::size_t i = 0; i < list->GetSize(); ++i)
  {
    if (list->At(i).IsObject() && list->At(i).Find("value"))
    {
      return Format::Aariz;
    }
  }
  return Format::LandmarkDetector;
}

// ---- text ---------------------------------------------------------------------------------------------------------

/** A line of a table, with its number in the file. */
struct Line
{
  std::size_t              number;
  std::vector<std::string> cells;
};

std::vector<Line>
ReadLines(const std::string & fileName)
{
  std::string text = MakeUTF8(ReadTextFile(fileName, "a text file"));
  if (text.compare(0, 3, "\xef\xbb\xbf") == 0)
  {
    text.erase(0, 3);
  }
  std::vector<Line>  lines;
  std::istringstream stream(text);
  std::size_t        number = 0;
  for (std::string line; std::getline(stream, line);)
  {
    ++number;
    if (!Trim(line).empty())
    {
      lines.push_back({ number, Split(line, ',') });
    }
  }
  return lines;
}

double
ToNumber(const std::string & fileName, const std::string & field, const std::string & text)
{
  double value = 0.0;
  if (!ParseNumber(text, value))
  {
    itkDentalInputErrorMacro(
      fileName, field, "\"" + text.substr(0, 40) + "\" is no number", "use numbers with a decimal point");
  }
  return value;
}

Format
FormatFromLines(const std::vector<Line> & lines)
{
  if (lines.empty())
  {
    return Format::CSV;
  }
  const std::vector<std::string> & first = lines.front().cells;
  if (first.size() >= 4 && LowerCase(first[0]) == "file" && LowerCase(first[1]) == "scale" &&
      LowerCase(first[2]) == "p1x")
  {
    return Format::CLDetection;
  }
  double number = 0.0;
  return first.size() == 2 && ParseNumber(first[0], number) && ParseNumber(first[1], number) ? Format::ISBI2015
                                                                                             : Format::CSV;
}

void
ReadISBI(const std::string & fileName, const std::vector<Line> & lines, AnnotationRecords & records)
{
  const auto end = std::find_if(lines.begin(), lines.end(), [](const Line & line) { return line.cells.size() != 2; });
  const std::size_t count = std::distance(lines.begin(), end);
  if (count != NumberOfISBILandmarks)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "has " + std::to_string(count) + " lines x,y; a file of ISBI 2015 has " +
                               std::to_string(NumberOfISBILandmarks),
                             "write lines label,x,y, e.g. U1_tip,569.6,643.5");
  }
  for (auto line = end; line != lines.end(); ++line)
  {
    double code = 0.0;
    if (line->cells.size() != 1 || !ParseNumber(line->cells[0], code))
    {
      itkDentalInputErrorMacro(fileName,
                               "line " + std::to_string(line->number),
                               "is no class code, which is all that follows the landmarks in a file of ISBI 2015",
                               "write lines label,x,y, e.g. U1_tip,569.6,643.5");
    }
  }
  for (const NumberedLandmark & known : ISBILandmarks)
  {
    const Line &       line = lines[known.number - 1];
    const std::string  field = "line " + std::to_string(line.number);
    AnnotationLandmark landmark{ field, known.name, {} };
    for (std::size_t i = 0; i < 2; ++i)
    {
      landmark.point[i] = ToNumber(fileName, field, line.cells[i]);
    }
    records.landmarks.push_back(std::move(landmark));
  }
  records.leftOut = { "landmarks 1 to 10 and 13 to 19" };
}

void
ReadCLDetection(const std::string & fileName, const std::vector<Line> & lines, AnnotationRecords & records)
{
  constexpr std::size_t columns = 2 + 2 * NumberOfCLDetectionLandmarks;
  if (lines.size() != 2)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "has landmarks of " + std::to_string(lines.empty() ? 0 : lines.size() - 1) +
                               " radiographs",
                             "keep the header and the line of this one");
  }
  const Line &      line = lines.back();
  const std::string place = "line " + std::to_string(line.number);
  if (lines.front().cells.size() != columns || line.cells.size() != columns)
  {
    itkDentalInputErrorMacro(fileName,
                             place,
                             "has " + std::to_string(line.cells.size()) +
                               " columns; file,scale,p1x,p1y,..,p38x,p38y are " + std::to_string(columns),
                             "export all 38 points, or lines label,x,y");
  }
  for (const NumberedLandmark & known : CLDetectionLandmarks)
  {
    AnnotationLandmark landmark{ place + ", p" + std::to_string(known.number), known.name, {} };
    for (std::size_t i = 0; i < 2; ++i)
    {
      landmark.point[i] = ToNumber(fileName, landmark.field, line.cells[2 * known.number + i]);
    }
    records.landmarks.push_back(std::move(landmark));
  }
  records.leftOut = { "landmarks 1 to 10, 13 to 20 and 23 to 36" };
}

/** Takes those that are no dental landmarks out of what a reader of all landmarks has read. */
void
LeaveOutOthers(AnnotationRecords & records, const IsDentalLandmarkType & isDental)
{
  auto &     landmarks = records.landmarks;
  const auto end = std::stable_partition(
    landmarks.begin(), landmarks.end(), [&](const AnnotationLandmark & landmark) { return isDental(landmark.name); });
  for (auto landmark = end; landmark != landmarks.end(); ++landmark)
  {
    records.leftOut.push_back(landmark->name);
  }
  landmarks.erase(end, landmarks.end());
}
} // namespace

AnnotationRecords
ReadCephalometricLandmarkRecords(const std::string &          fileName,
                                 AnnotationFileFormatEnum     format,
                                 const IsDentalLandmarkType & isDental,
                                 const std::string &          imageName)
{
  if (format == Format::WebCeph || (format == Format::Automatic && IsWebCephFile(fileName)))
  {
    return ReadWebCephRecords(fileName, isDental, imageName);
  }
  RefuseForeignFile(fileName, FilePurposeEnum::Landmarks);
  const Format found = format == Format::Automatic ? AnnotationFormatFromFile(fileName) : format;
  if (found == Format::CSV || found == Format::CLDetection || found == Format::ISBI2015)
  {
    AnnotationRecords       records;
    const std::vector<Line> lines = ReadLines(fileName);
    records.format = format == Format::Automatic ? FormatFromLines(lines) : format;
    switch (records.format)
    {
      case Format::ISBI2015:
        ReadISBI(fileName, lines, records);
        break;
      case Format::CLDetection:
        ReadCLDetection(fileName, lines, records);
        break;
      default:
        records = ReadLandmarkRecords(fileName, Format::CSV, 2, imageName);
        LeaveOutOthers(records, isDental);
    }
    return records;
  }
  if (found == Format::CVAT || (found == Format::VIA && IsVIATable(fileName)))
  {
    AnnotationRecords records = ReadLandmarkRecords(fileName, found, 2, imageName);
    LeaveOutOthers(records, isDental);
    return records;
  }
  RequireJsonBeginning(fileName);
  const JsonDocument document = JsonDocument::ReadFile(fileName);
  AnnotationRecords  records = ReadCephalometricLandmarkRecords(document.GetRoot(), format, isDental, imageName);
  records.warnings.insert(records.warnings.begin(), document.GetWarnings().begin(), document.GetWarnings().end());
  return records;
}

AnnotationRecords
ReadCephalometricLandmarkRecords(const JsonNode &             root,
                                 AnnotationFileFormatEnum     format,
                                 const IsDentalLandmarkType & isDental,
                                 const std::string &          imageName)
{
  AnnotationRecords records;
  records.format = format == Format::Automatic ? FormatFromContent(root) : format;
  if (records.format == Format::Automatic && AnnotationFormatFromContent(root) != Format::DentalSCR)
  {
    records.format = AnnotationFormatFromContent(root);
  }
  const bool isForeign = records.format != Format::Aariz && records.format != Format::LandmarkDetector &&
                         records.format != Format::DentalSCR && records.format != Format::Automatic;
  if (!isForeign)
  {
    if (records.format == Format::Automatic)
    {
      RefuseUnknownAnnotation(root);
      records.format = HasListOfLandmarks(root) ? Format::LandmarkDetector : Format::DentalSCR;
    }
    ReadEntries(root, records, isDental);
    return records;
  }
  if (!root.IsObject() && records.format != Format::LabelStudio)
  {
    root.Fail("is no JSON object", R"(landmarks are {"U1_tip": [u, v], "L1_tip": [u, v]})");
  }
  records = ReadLandmarkRecords(root, records.format, 2, imageName);
  LeaveOutOthers(records, isDental);
  return records;
}
} // namespace itk
