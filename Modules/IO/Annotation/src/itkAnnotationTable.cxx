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
#include "itkAnnotationTableHeader.h"
#include "itkAnnotationText.h"
#include "itkAppendWarning.h"
#include "itkDentalInputError.h"
#include "itkForeignAnnotationRecords.h"
#include "itkLowerCase.h"
#include "itkMakeUTF8.h"
#include "itkTextFile.h"
#include "itkTrimText.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <utility>

namespace itk
{
namespace
{

/** What parts the cells of a line where no line before has said it. */
char
FindSeparator(const std::string & line)
{
  for (const char candidate : { '\t', ';', ',' })
  {
    if (line.find(candidate) != std::string::npos)
    {
      return candidate;
    }
  }
  return TrimText(line).find(' ') != std::string::npos ? ' ' : ',';
}

/** A cell takes thirty bytes, empty or not: of 32 MiB of commas it would be a gigabyte. */
void
VerifyNumberOfColumns(const std::string & fileName, const std::string & text)
{
  constexpr std::ptrdiff_t most = 100000;
  std::size_t              number = 0;
  for (auto begin = text.begin(); begin != text.end();)
  {
    const auto end = std::find(begin, text.end(), '\n');
    ++number;
    for (const char separator : { '\t', ';', ',', ' ' })
    {
      if (const auto parts = std::count(begin, end, separator); parts >= most)
      {
        itkDentalInputErrorMacro(fileName,
                                 "line " + std::to_string(number),
                                 "has " + std::to_string(parts + 1) + " columns, more than the " +
                                   std::to_string(most) + " that are read",
                                 "leave those of the label and its coordinates");
      }
    }
    begin = end == text.end() ? end : std::next(end);
  }
}

/** The cells of a line. Where blanks part them a label may have some as well, "U1 tip 569.6 643.5": what stands before
 * the coordinates is one cell. */
std::vector<std::string>
SplitLine(const std::string & line, char separator, unsigned int dimension)
{
  if (separator != ' ')
  {
    return Split(line, separator);
  }
  std::vector<std::string> words;
  std::istringstream       stream(line);
  for (std::string word; stream >> word;)
  {
    words.push_back(Trim(word));
  }
  double     number = 0.0;
  const bool isRow =
    words.size() > dimension + 1 &&
    std::all_of(words.end() - dimension, words.end(), [&](auto & word) { return ParseTableNumber(word, number); });
  if (isRow && !ParseTableNumber(words.front(), number))
  {
    std::string label;
    std::for_each(words.begin(), words.end() - dimension, [&](const std::string & word) {
      label += (label.empty() ? "" : " ") + word;
    });
    words.erase(words.begin(), words.end() - dimension);
    words.insert(words.begin(), label);
  }
  return words;
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

/** What to do with a table whose first line is neither a row nor a header. */
std::string
DescribeTable(const std::vector<std::string> & cells, const std::string & form)
{
  const auto has = [&cells](const char * name) {
    return std::any_of(
      cells.begin(), cells.end(), [name](const std::string & cell) { return LowerCase(cell) == name; });
  };
  if (has("annotation_id") && has("annotator"))
  {
    return "Label Studio's CSV has shapes as text in its cells: export JSON";
  }
  const auto pairs = std::count_if(cells.begin(), cells.end(), [](const std::string & cell) {
    const std::string name = LowerCase(cell);
    return EndsWith(name, "_x") || EndsWith(name, ".x") || EndsWith(name, "_y") || EndsWith(name, ".y");
  });
  return pairs >= 2 ? "write a line a landmark, " + form + ", not a column"
                    : "write lines " + form + ", or name the columns in the first line";
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
/** The lines from a place on, with what is no blank line. */
std::vector<std::vector<std::string>>
SplitLines(const std::string & text, std::size_t begin, char separator, unsigned int dimension)
{
  std::vector<std::vector<std::string>> lines;
  // So many tell which column is which.
  constexpr std::size_t most = 1000;
  constexpr std::size_t mostCells = 1000000;
  std::size_t           cells = 0;
  while (begin < text.size() && lines.size() < most && cells < mostCells)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(SplitLine(text.substr(begin, end - begin), separator, dimension));
    cells += lines.back().size();
    begin = end + 1;
  }
  return lines;
}

/** The number of the line that is a header, where lines with other numbers of cells and no row stand before it, as
 * programs write the patient and the date; 0 where there is none. */
std::size_t
FindHeaderLine(const std::string & fileName, const std::string & text, unsigned int dimension)
{
  constexpr std::size_t most = 40;
  std::size_t           number = 0;
  bool                  hasTitle = false;
  for (std::size_t begin = 0; begin < text.size() && number < most;)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    const char                     separator = FindSeparator(line);
    const std::vector<std::string> cells = SplitLine(line, separator, dimension);
    if (IsRowOfTooth(cells, TableColumns(), dimension))
    {
      return 0;
    }
    // What the lines below are is asked where the header is read: here a word for labels, or any cell, will do.
    TableColumns columns;
    const bool   hasAxes = std::any_of(cells.begin(), cells.end(), [](const std::string & cell) {
      const std::string word = LowerCase(cell).substr(0, 1);
      return word == "x" || word == "u" || word == "c";
    });
    if (hasTitle && hasAxes && cells.size() > dimension &&
        ReadAnnotationTableHeader(fileName,
                                  "line " + std::to_string(number),
                                  cells,
                                  dimension,
                                  SplitLines(text, begin, separator, dimension),
                                  columns))
    {
      return number;
    }
    hasTitle = hasTitle || !Trim(line).empty();
  }
  return 0;
}

/** The pictures of a table's rows: a table of many films has points of each. */
class TablePictures
{
public:
  void
  Add(const std::string & picture, std::size_t row)
  {
    // A spreadsheet has what is the same in many lines in the first of them alone.
    const std::string & name = picture.empty() && !m_Names.empty() ? m_Names[m_OfRows.back()] : picture;
    const auto [entry, isNew] = m_Numbers.try_emplace(name, m_Names.size());
    if (isNew)
    {
      m_Names.push_back(name);
    }
    m_OfRows.resize(row, entry->second);
    m_OfRows.push_back(entry->second);
  }

  /** Keeps the rows of the radiograph; throws where there are several pictures and none is it. */
  void
  Choose(const std::string & fileName, const std::string & imageName, std::vector<AnnotationTableRow> & rows) const
  {
    if (m_Names.size() < 2)
    {
      return;
    }
    const std::size_t               chosen = ChooseImage(fileName, "", m_Names, imageName);
    std::vector<AnnotationTableRow> kept;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      if (i >= m_OfRows.size() || m_OfRows[i] == chosen)
      {
        kept.push_back(std::move(rows[i]));
      }
    }
    rows = std::move(kept);
  }

private:
  std::map<std::string, std::size_t> m_Numbers;
  std::vector<std::string>           m_Names;
  std::vector<std::size_t>           m_OfRows;
};

/** Width and height beside a place. Of boxes a place is the corner, which no landmark has. */
class TableBoxes
{
public:
  void
  Add(const TableColumns & columns, const std::vector<std::string> & cells, const AnnotationTableRow & row)
  {
    for (unsigned int i = 0; i < 2; ++i)
    {
      double size = 0.0;
      if (columns.box[0] && columns.box[1] && *columns.box[i] < cells.size() &&
          ParseTableNumber(cells[*columns.box[i]], size) && row.point[i] > size && m_Field.empty())
      {
        // The picture's size would hold the place.
        m_Field = row.field;
      }
    }
  }

  void
  Verify(const std::string & fileName) const
  {
    if (!m_Field.empty())
    {
      itkDentalInputErrorMacro(fileName,
                               m_Field,
                               "has a width and a height: a box, of which x and y are a corner",
                               "write the middle of each box, and leave width and height out");
    }
  }

private:
  std::string m_Field;
};

/** A row of makesense.ai, which has no header: label, x, y, the picture's name, its width and height. */
bool
IsRowOfMakeSense(const std::vector<std::string> & cells)
{
  double number = 0.0;
  return cells.size() == 6 && !ParseTableNumber(cells[0], number) && ParseTableNumber(cells[1], number) &&
         ParseTableNumber(cells[2], number) && cells[3].find('.') != std::string::npos &&
         !ParseTableNumber(cells[3], number) && ParseNumber(cells[4], number) && number >= 1.0 &&
         ParseNumber(cells[5], number) && number >= 1.0;
}
} // namespace

std::vector<AnnotationTableRow>
ReadAnnotationTable(const std::string &        fileName,
                    unsigned int               dimension,
                    const std::string &        imageName,
                    std::vector<std::string> & warnings)
{
  std::string text = MakeUTF8(ReadTextFile(fileName, "a CSV file"));
  if (text.compare(0, 3, "\xef\xbb\xbf") == 0)
  {
    text.erase(0, 3);
  }
  VerifyNumberOfColumns(fileName, text);
  const std::string               form = dimension == 2 ? "label,x,y" : "label,x,y,z";
  const std::string               unit = dimension == 2 ? "px" : "mm";
  std::vector<AnnotationTableRow> rows;
  TableColumns                    columns;
  char                            separator = 0;
  char                            givenSeparator = 0;
  std::size_t                     lineNumber = 0;
  std::string                     firstWithNumberSign;
  bool                            allWithNumberSign = true;
  const std::size_t               headerLine = FindHeaderLine(fileName, text, dimension);
  TablePictures                   pictures;
  TableBoxes                      boxes;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++lineNumber;
    const std::string trimmed = Trim(line);
    // A spreadsheet writes its empty rows with all their separators.
    if (trimmed.find_first_not_of(" \t\r;,") == std::string::npos)
    {
      continue;
    }
    if (lineNumber < headerLine)
    {
      // Excel's own word is no title.
      if (LowerCase(trimmed.substr(0, 4)) != "sep=" && !BeginsWithNumberSign(line))
      {
        AppendWarning(
          warnings, fileName, "line " + std::to_string(lineNumber) + ": taken for a title, as a header follows");
      }
      continue;
    }
    const char mark = separator != 0 ? separator : givenSeparator != 0 ? givenSeparator : FindSeparator(line);
    const bool hasNumberSign = BeginsWithNumberSign(line);
    if (hasNumberSign && !IsRowOfTooth(SplitLine(line, mark, dimension), columns, dimension))
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
    const std::vector<std::string> cells = SplitLine(line, separator, dimension);
    if (first && ReadAnnotationTableHeader(
                   fileName, field, cells, dimension, SplitLines(text, begin, separator, dimension), columns))
    {
      continue;
    }
    if (first && dimension == 2 && IsRowOfMakeSense(cells))
    {
      columns.named = true;
      columns.picture = 3;
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
    // A spreadsheet ends each row with the separators of its widest one.
    std::size_t width = cells.size();
    while (width > dimension + 1 && cells[width - 1].empty())
    {
      --width;
    }
    if (columns.named ? cells.size() <= last : width != dimension + 1 && width != dimension + 2)
    {
      itkDentalInputErrorMacro(fileName,
                               field,
                               "has " + std::to_string(cells.size()) + " columns, expected " +
                                 (columns.named ? "those of the header" : form + " and perhaps a unit"),
                               first ? DescribeTable(cells, form) : "correct the line");
    }
    AnnotationTableRow row{ field, cells[columns.label], {} };
    unsigned int       numbers = 0;
    for (unsigned int i = 0; i < dimension; ++i)
    {
      numbers += ParseTableNumber(cells[columns.first[i]], row.point[i]) ? 1 : 0;
    }
    if (first && numbers == 0 && !NamesToothOrJaw(row.label))
    {
      VerifyTableHeaderIsNoOther(fileName, field, cells, columns, dimension);
      warnings.push_back(fileName + ": " + field + ": taken for a header, as it has no numbers; columns are read as " +
                         form);
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
    if (columns.depth && *columns.depth < cells.size())
    {
      double depth = 0.0;
      if (ParseTableNumber(cells[*columns.depth], depth) && depth != 0.0)
      {
        itkDentalInputErrorMacro(fileName,
                                 field,
                                 "has a third coordinate, and points of a radiograph have two",
                                 "name the landmarks of a scan as \"landmarks_3d\", or delete that column");
      }
    }
    if (columns.picture && *columns.picture < cells.size())
    {
      pictures.Add(cells[*columns.picture], rows.size());
    }
    boxes.Add(columns, cells, row);
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
  boxes.Verify(fileName);
  pictures.Choose(fileName, imageName, rows);
  return rows;
}
} // namespace itk
