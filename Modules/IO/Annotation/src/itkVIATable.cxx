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
#include "itkVIATable.h"

#include "itkAppendWarning.h"
#include "itkAnnotationText.h"
#include "itkDentalInputError.h"
#include "itkForeignAnnotationRecords.h"
#include "itkInputFile.h"
#include "itkJsonDocument.h"
#include "itkTextFile.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace itk
{
namespace
{
constexpr const char * ShapeColumn = "region_shape_attributes";
constexpr const char * AttributesColumn = "region_attributes";

struct Columns
{
  char        separator{ ',' };
  std::size_t file{ 0 };
  std::size_t shape{ 0 };
  std::size_t attributes{ 0 };
};

/** The columns of the header; none where the line is not VIA's. */
std::optional<Columns>
ReadHeader(std::string line)
{
  // A byte order mark, and the sign of VIA 1.
  line.erase(0, std::min(line.find_first_not_of("\xef\xbb\xbf#"), line.size()));
  Columns columns;
  for (const char separator : { ';', '\t' })
  {
    // Of a spreadsheet that has written the table anew.
    columns.separator = line.find(separator) != std::string::npos ? separator : columns.separator;
  }
  const std::vector<std::string> cells = Split(line, columns.separator);
  const auto                     find = [&cells](const char * name, std::size_t & column) {
    const auto place = std::find(cells.begin(), cells.end(), name);
    column = static_cast<std::size_t>(place - cells.begin());
    return place != cells.end();
  };
  const bool all =
    find("filename", columns.file) && find(ShapeColumn, columns.shape) && find(AttributesColumn, columns.attributes);
  return all ? std::optional<Columns>(columns) : std::nullopt;
}

struct Row
{
  std::string field;
  std::string image;
  /** JSON of the region as VIA's JSON has it. */
  std::string region;
};

/** Quotes inside a cell in quotes are doubled. */
std::string
WithSingleQuotes(std::string cell)
{
  for (std::size_t place = cell.find("\"\""); place != std::string::npos; place = cell.find("\"\"", place + 1))
  {
    cell.erase(place, 1);
  }
  return cell;
}

std::vector<Row>
ReadRows(const std::string & fileName)
{
  const std::string      text = ReadTextFile(fileName, "a CSV file");
  std::optional<Columns> columns;
  std::vector<Row>       rows;
  std::size_t            lineNumber = 0;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    const std::string field = "line " + std::to_string(++lineNumber);
    begin = end + 1;
    if (Trim(line).empty())
    {
      continue;
    }
    if (!columns)
    {
      columns = ReadHeader(line);
      if (!columns)
      {
        itkDentalInputErrorMacro(
          fileName, field, "is no header of VIA's CSV", "export the annotations from VIA again, as CSV or JSON");
      }
      continue;
    }
    const std::vector<std::string> cells = Split(line, columns->separator);
    const std::size_t              last = std::max({ columns->file, columns->shape, columns->attributes });
    if (cells.size() <= last)
    {
      itkDentalInputErrorMacro(fileName,
                               field,
                               "has " + std::to_string(cells.size()) + " columns, and the header has " +
                                 std::to_string(last + 1),
                               "export the annotations from VIA again");
    }
    const std::string shape = WithSingleQuotes(cells[columns->shape]);
    const std::string attributes = WithSingleQuotes(cells[columns->attributes]);
    rows.push_back({ field,
                     cells[columns->file],
                     // A picture without a region has a line all the same.
                     shape == "{}" ? std::string()
                                   : R"({"shape_attributes": )" + shape + R"(, "region_attributes": )" +
                                       (attributes.empty() ? "{}" : attributes) + '}' });
  }
  return rows;
}

void
ReadRegion(const std::string & fileName, const Row & row, AnnotationRecords & records)
{
  const std::size_t polylines = records.polylines.size();
  const std::size_t landmarks = records.landmarks.size();
  try
  {
    const JsonDocument document = JsonDocument::Parse(row.region, fileName);
    ReadVIARegion(document.GetRoot(), records);
    for (const std::string & warning : document.GetWarnings())
    {
      AppendWarning(records.warnings, fileName, row.field + warning.substr(fileName.size()));
    }
  }
  catch (const DentalInputError & error)
  {
    // A place in the text of the region is none in the file.
    const bool isSyntax = error.GetField().compare(0, 5, "line ") == 0;
    itkDentalInputErrorMacro(fileName,
                             row.field + (isSyntax || error.GetField().empty() ? "" : ", " + error.GetField()),
                             (isSyntax ? "a region is no JSON: " : "") + error.GetProblem(),
                             isSyntax ? "export the annotations from VIA again" : error.GetRemedy());
  }
  for (std::size_t i = polylines; i < records.polylines.size(); ++i)
  {
    records.polylines[i].field = row.field;
    records.polylines[i].codeField = row.field;
  }
  for (std::size_t i = landmarks; i < records.landmarks.size(); ++i)
  {
    records.landmarks[i].field = row.field;
  }
}
} // namespace

bool
IsVIATable(const std::string & fileName)
{
  const std::string head = ReadFileHead(fileName, 512);
  return ReadHeader(head.substr(0, head.find('\n'))).has_value();
}

AnnotationRecords
ReadVIATable(const std::string & fileName, const std::string & imageName)
{
  const std::vector<Row>   rows = ReadRows(fileName);
  std::vector<std::string> names;
  for (const Row & row : rows)
  {
    if (std::find(names.begin(), names.end(), row.image) == names.end())
    {
      names.push_back(row.image);
    }
  }
  AnnotationRecords records;
  records.format = AnnotationFileFormatEnum::VIA;
  const std::string & name = names[ChooseImage(fileName, "filename", names, imageName)];
  for (const Row & row : rows)
  {
    if (row.image == name && !row.region.empty())
    {
      ReadRegion(fileName, row, records);
    }
  }
  return records;
}
} // namespace itk
