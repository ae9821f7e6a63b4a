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
#include "itkAnnotationTable.h"

#include "itkASCIICharacter.h"
#include "itkAnnotationText.h"
#include "itkDentalInputError.h"
#include "itkLowerCase.h"
#include "itkTextFile.h"
#include "itkTrimText.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <utility>

namespace itk
{
namespace
{
/** Where a table has what. */
struct TableColumns
{
  std::size_t label{ 0 };
  std::size_t first[3] = { 1, 2, 3 };
  /** Where there is one; else as many columns as coordinates. */
  std::optional<std::size_t> unit;
  /** Named by a header: further columns are nobody's business. */
  bool named{ false };
};

bool
IsOneOf(const std::string & text, std::initializer_list<const char *> words)
{
  return std::any_of(words.begin(), words.end(), [&](const char * word) { return text == word; });
}

/** Takes the columns from a header; false where the line is none. */
bool
ReadHeader(const std::string &              fileName,
           const std::string &              field,
           const std::vector<std::string> & cells,
           unsigned int                     dimension,
           TableColumns &                   columns)
{
  std::optional<std::size_t> label;
  std::optional<std::size_t> axes[3];
  std::optional<std::size_t> unit;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const std::string cell = LowerCase(cells[i]);
    // Of an axis "x", "x_px", "x (px)", "x [mm]" are read; what follows is its unit.
    const std::size_t end = cell.find_first_of(" _([");
    const std::string axis = cell.substr(0, end);
    // None where nothing follows: "x (".
    const std::size_t unitBegin = end == std::string::npos ? end : cell.find_first_not_of(" _([", end);
    const std::string rest = unitBegin == std::string::npos ? std::string() : cell.substr(unitBegin);
    const bool        pixels = IsOneOf(rest, { "", "px", "px)", "px]", "pixel", "pixels" });
    const bool        millimetres = IsOneOf(rest, { "mm", "mm)", "mm]" });
    const int         number = IsOneOf(axis, { "x", "u" }) ? 0 : IsOneOf(axis, { "y", "v" }) ? 1 : axis == "z" ? 2 : -1;
    if (number >= 0 && (pixels || millimetres) && !axes[number])
    {
      if (dimension == 2 && millimetres)
      {
        itkDentalInputErrorMacro(fileName,
                                 field,
                                 "the column \"" + cells[i].substr(0, 40) + "\" is in mm",
                                 "convert the coordinates to pixels");
      }
      axes[number] = i;
    }
    else if (IsOneOf(cell, { "label", "name", "code", "tooth", "landmark", "point", "symbol", "class", "title" }) &&
             !label)
    {
      label = i;
    }
    else if (IsOneOf(cell, { "unit", "units" }))
    {
      unit = i;
    }
  }
  if (!axes[0] || !axes[1] || (dimension == 3 && !axes[2]))
  {
    return false;
  }
  if (!label)
  {
    // In whatever language it is: a single column that is neither a coordinate nor a unit can only be the labels'.
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      if (i != axes[0] && i != axes[1] && i != axes[2] && i != unit)
      {
        others.push_back(i);
      }
    }
    if (others.size() != 1)
    {
      itkDentalInputErrorMacro(fileName, field, "is a header without a column of labels", "name that column \"label\"");
    }
    label = others.front();
  }
  columns.label = *label;
  for (unsigned int d = 0; d < dimension; ++d)
  {
    columns.first[d] = *axes[d];
  }
  columns.unit = unit;
  columns.named = true;
  return true;
}

/** What parts the cells of a line where no line before has said it. */
char
FindSeparator(const std::string & line)
{
  char separator = ',';
  for (const char candidate : { ';', '\t' })
  {
    separator = line.find(candidate) != std::string::npos ? candidate : separator;
  }
  return separator;
}

/** Whether a line begins with '#', in quotes or not: a comment, or a tooth as dentists write it, "#11". */
bool
BeginsWithNumberSign(const std::string & line)
{
  const std::string text = TrimText(line);
  return text.compare(0, 1, "#") == 0 || text.compare(0, 2, "\"#") == 0;
}

/** Whether the cells are a tooth, a jaw or a point of a tooth with its coordinates, where these belong. */
bool
IsRowOfTooth(const std::vector<std::string> & cells, const TableColumns & columns, unsigned int dimension)
{
  const auto isNumber = [&cells](std::size_t column) {
    double value = 0.0;
    return column < cells.size() && ParseTableNumber(cells[column], value);
  };
  if (columns.label >= cells.size() || !std::all_of(columns.first, columns.first + dimension, isNumber))
  {
    return false;
  }
  const std::string & label = cells[columns.label];
  // No tooth has three digits: a year or a number of something else.
  return std::count_if(label.begin(), label.end(), IsASCIIDigit) <= 2 &&
         (NamesToothOrJaw(label) || NamesPointOfTooth(label));
}

/** A class number and shares of a picture's size, all parted by blanks. */
bool
IsYolo(const std::string & line)
{
  std::istringstream stream(line);
  std::size_t        count = 0;
  for (std::string word; stream >> word; ++count)
  {
    double number = 0.0;
    if (!ParseNumber(word, number) || number < 0.0 || (count > 0 && number > 1.0))
    {
      return false;
    }
  }
  return count >= 5 && count % 2 == 1;
}
} // namespace

std::vector<AnnotationTableRow>
ReadAnnotationTable(const std::string & fileName, unsigned int dimension, std::vector<std::string> & warnings)
{
  std::string text = ReadTextFile(fileName, "a CSV file");
  if (text.compare(0, 3, "\xef\xbb\xbf") == 0)
  {
    text.erase(0, 3);
  }
  const std::string               form = dimension == 2 ? "label,x,y" : "label,x,y,z";
  const std::string               unit = dimension == 2 ? "px" : "mm";
  std::vector<AnnotationTableRow> rows;
  TableColumns                    columns;
  char                            separator = 0;
  char                            givenSeparator = 0;
  std::size_t                     lineNumber = 0;
  std::string                     firstWithNumberSign;
  bool                            allWithNumberSign = true;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++lineNumber;
    const std::string trimmed = Trim(line);
    if (trimmed.empty())
    {
      continue;
    }
    const char mark = separator != 0 ? separator : givenSeparator != 0 ? givenSeparator : FindSeparator(line);
    // A cell takes thirty bytes, empty or not: of 32 MiB of commas it would be a gigabyte.
    constexpr std::ptrdiff_t mostColumns = 100000;
    if (const auto parts = std::count(line.begin(), line.end(), mark); parts >= mostColumns)
    {
      itkDentalInputErrorMacro(fileName,
                               "line " + std::to_string(lineNumber),
                               "has " + std::to_string(parts + 1) + " columns, more than the " +
                                 std::to_string(mostColumns) + " that are read",
                               "leave those of the label and its coordinates");
    }
    const bool hasNumberSign = BeginsWithNumberSign(line);
    if (hasNumberSign && !IsRowOfTooth(Split(line, mark), columns, dimension))
    {
      continue;
    }
    // Excel's own word for what parts the cells.
    if (separator == 0 && givenSeparator == 0 && LowerCase(trimmed.substr(0, 4)) == "sep=" && trimmed.size() <= 5)
    {
      givenSeparator = trimmed.size() > 4 ? trimmed[4] : '\t';
      continue;
    }
    const std::string field = "line " + std::to_string(lineNumber);
    const bool        first = separator == 0;
    if (first)
    {
      separator = mark;
    }
    const std::vector<std::string> cells = Split(line, separator);
    if (first && ReadHeader(fileName, field, cells, dimension, columns))
    {
      continue;
    }
    const std::size_t last = columns.named ? std::max({ columns.label,
                                                        columns.first[0],
                                                        columns.first[1],
                                                        dimension == 3 ? columns.first[2] : std::size_t{ 0 },
                                                        columns.unit.value_or(0) })
                                           : dimension;
    if (rows.empty() && IsYolo(line))
    {
      itkDentalInputErrorMacro(
        fileName,
        field,
        "has numbers alone, parted by blanks, as YOLO writes outlines: its classes have numbers, "
        "which are no teeth",
        "export COCO or labelme, where classes have names");
    }
    if (columns.named ? cells.size() <= last : cells.size() != dimension + 1 && cells.size() != dimension + 2)
    {
      itkDentalInputErrorMacro(fileName,
                               field,
                               "has " + std::to_string(cells.size()) + " columns, expected " +
                                 (columns.named ? "those of the header" : form + " and perhaps a unit"),
                               "correct the line");
    }
    AnnotationTableRow row{ field, cells[columns.label], {} };
    unsigned int       numbers = 0;
    for (unsigned int i = 0; i < dimension; ++i)
    {
      numbers += ParseTableNumber(cells[columns.first[i]], row.point[i]) ? 1 : 0;
    }
    if (first && numbers == 0 && !NamesToothOrJaw(row.label))
    {
      warnings.push_back(fileName + ": " + field + ": taken for a header, as it has no numbers");
      continue;
    }
    for (unsigned int i = 0; i < dimension; ++i)
    {
      const std::string & cell = cells[columns.first[i]];
      if (!ParseTableNumber(cell, row.point[i]))
      {
        itkDentalInputErrorMacro(
          fileName, field, "\"" + cell.substr(0, 40) + "\" is no number", "use numbers with a decimal point");
      }
    }
    if (!columns.unit && !columns.named && cells.size() == dimension + 2)
    {
      columns.unit = dimension + 1;
    }
    if (columns.unit && *columns.unit < cells.size())
    {
      const std::string & cell = cells[*columns.unit];
      if (LowerCase(cell) != unit && !cell.empty())
      {
        itkDentalInputErrorMacro(fileName,
                                 field,
                                 "the unit \"" + cell.substr(0, 40) + "\" is not \"" + unit + "\"",
                                 "convert the coordinates");
      }
    }
    if (hasNumberSign && firstWithNumberSign.empty())
    {
      firstWithNumberSign = field + ": \"" + row.label.substr(0, 40) + '"';
    }
    allWithNumberSign = allWithNumberSign && hasNumberSign;
    rows.push_back(std::move(row));
  }
  if (!allWithNumberSign && !firstWithNumberSign.empty())
  {
    // Of a table that writes some teeth so and others not, such a line may be one that somebody has switched off.
    warnings.push_back(fileName + ": " + firstWithNumberSign +
                       " is read as a tooth, as its coordinates follow, though other lines have no #; delete a line "
                       "that is not meant");
  }
  return rows;
}
} // namespace itk
