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
#include "itkAppendWarning.h"
#include "itkDentalInputError.h"
#include "itkForeignAnnotationRecords.h"
#include "itkLowerCase.h"
#include "itkMakeUTF8.h"
#include "itkTextFile.h"
#include "itkTrimText.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
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
  /** Of the picture's name, as a table of many films has. */
  std::optional<std::size_t> picture;
  /** Of width and height beside a place: a box's, or the picture's. */
  std::optional<std::size_t> box[2];
  /** Of the depth where two coordinates are wanted. */
  std::optional<std::size_t> depth;
  /** Named by a header: further columns are nobody's business. */
  bool named{ false };
};

bool
IsOneOf(const std::string & text, std::initializer_list<const char *> words)
{
  return std::any_of(words.begin(), words.end(), [&](const char * word) { return text == word; });
}

/** Whether a header's cell names a column of labels, "landmark_name" as well as "Landmark". */
bool
IsWordForLabels(const std::string & cell)
{
  std::string word = cell;
  for (const char * const end : { "_name", " name", "name", "_code", " code", "_label", " label" })
  {
    // But of a file's name, or of a patient's.
    const std::size_t length = std::string(end).size();
    if (word.size() > length && EndsWith(word, end))
    {
      word.resize(word.size() - length);
      break;
    }
  }
  return IsOneOf(word, { "label", "name", "code", "tooth", "landmark", "point", "symbol", "class", "title" });
}

/** Whether a column has numbers, all of them of FDI: what counts lines, and what was measured, has others. */
bool
HasNumbersOfTeeth(std::size_t column, const std::vector<std::vector<std::string>> & lines)
{
  return std::all_of(lines.begin(), lines.end(), [column](const std::vector<std::string> & cells) {
    double value = 0.0;
    if (column >= cells.size() || cells[column].empty())
    {
      return true;
    }
    try
    {
      return ParseNumber(cells[column], value) && ToothCode::FromString(cells[column]).IsKnown();
    }
    catch (const std::invalid_argument &)
    {
      return false;
    }
  });
}

/** Which of several columns holds the labels: of those in which a line names a tooth, a jaw or a landmark the one that
 * does so in most lines, words before numbers. Nothing where there is none. */
std::optional<std::size_t>
FindColumnOfNames(const std::vector<std::size_t> & candidates, const std::vector<std::vector<std::string>> & lines)
{
  std::optional<std::size_t> found;
  for (const bool isNumber : { false, true })
  {
    std::ptrdiff_t most = 0;
    for (const std::size_t column : candidates)
    {
      if (isNumber && !HasNumbersOfTeeth(column, lines))
      {
        continue;
      }
      const std::ptrdiff_t names =
        std::count_if(lines.begin(), lines.end(), [&](const std::vector<std::string> & cells) {
          double value = 0.0;
          return column < cells.size() && ParseTableNumber(cells[column], value) == isNumber &&
                 (NamesToothOrJaw(cells[column]) || NamesPointOfTooth(cells[column]));
        });
      if (names > most)
      {
        most = names;
        found = column;
      }
    }
    if (found)
    {
      break;
    }
  }
  return found;
}

/** The words of a header's cell: "Y (px)" is y and px, "pos_x" pos and x. */
std::vector<std::string>
SplitWords(const std::string & cell)
{
  std::vector<std::string> words;
  std::istringstream       stream(LowerCase(cell));
  for (std::string word; std::getline(stream, word, ' ');)
  {
    std::size_t begin = 0;
    while (begin < word.size())
    {
      const std::size_t end = std::min(word.find_first_of("_-.()[]:/", begin), word.size());
      if (end > begin)
      {
        words.push_back(word.substr(begin, end - begin));
      }
      begin = end + 1;
    }
  }
  return words;
}

/** The ways to call the axes. What stands for an axis in one of them may be another thing beside a complete other one:
 * a row's number, a landmark's visibility. */
enum class AxisNames
{
  XY,
  UV,
  ColumnRow
};
constexpr std::size_t NumberOfAxisNames = 3;

/** What a column of coordinates is called after. */
struct AxisColumn
{
  AxisNames names{ AxisNames::XY };
  int       axis{ -1 };
  bool      millimetres{ false };
  bool      saysPixels{ false };
  /** A word that is neither a unit of pixels nor one of places, "error" or "%". */
  std::string unknown;
};

/** What a header's cell says of an axis; an axis of -1 where it says nothing. */
AxisColumn
ReadAxis(const std::string & cell)
{
  AxisColumn column;
  for (const std::string & word : SplitWords(cell))
  {
    const int xy = IsOneOf(word, { "x", "cx", "xcoord" })   ? 0
                   : IsOneOf(word, { "y", "cy", "ycoord" }) ? 1
                   : IsOneOf(word, { "z", "cz", "zcoord" }) ? 2
                                                            : -1;
    const int uv = word == "u" ? 0 : word == "v" ? 1 : -1;
    const int columnRow = IsOneOf(word, { "column", "col" }) ? 0 : word == "row" ? 1 : -1;
    const int axis = std::max({ xy, uv, columnRow });
    if (axis >= 0 && column.axis < 0)
    {
      column.axis = axis;
      column.names = xy >= 0 ? AxisNames::XY : uv >= 0 ? AxisNames::UV : AxisNames::ColumnRow;
    }
    else if (word == "mm")
    {
      column.millimetres = true;
    }
    else if (IsOneOf(word, { "px", "pixel", "pixels" }))
    {
      column.saysPixels = true;
    }
    else if (!IsOneOf(word,
                      { "coord",
                        "coords",
                        "coordinate",
                        "koordinate",
                        "pos",
                        "position",
                        "location",
                        "center",
                        "centre",
                        "point",
                        "landmark",
                        "value",
                        "axis" }))
    {
      column.unknown = word;
    }
  }
  return column;
}

/** Finds the columns of coordinates, each axis once and all in one way to call them; false where there are none. Throws
 * where more than one would do: which one is meant is known to nobody. */
bool
FindAxes(const std::string &              fileName,
         const std::string &              field,
         const std::vector<std::string> & cells,
         unsigned int                     dimension,
         std::optional<std::size_t> (&axes)[3])
{
  std::optional<std::size_t> chosen;
  std::string                secondOfTwo;
  std::optional<std::size_t> millimetres;
  for (std::size_t names = 0; names < NumberOfAxisNames; ++names)
  {
    std::optional<std::size_t> found[3];
    bool                       said[3] = { false, false, false };
    std::string                again;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      const AxisColumn column = ReadAxis(cells[i]);
      if (column.axis < 0 || !column.unknown.empty() || static_cast<std::size_t>(column.names) != names)
      {
        continue;
      }
      if (dimension == 2 && column.millimetres)
      {
        millimetres = millimetres ? millimetres : i;
        continue;
      }
      // Of "x" and "x_px" the one that says so.
      const bool says = dimension == 2 ? column.saysPixels : column.millimetres;
      if (!found[column.axis] || (says && !said[column.axis]))
      {
        found[column.axis] = i;
        said[column.axis] = says;
      }
      else if (says == said[column.axis])
      {
        again = cells[i];
      }
    }
    if (!found[0] || !found[1] || (dimension == 3 && !found[2]))
    {
      continue;
    }
    if (chosen || !again.empty())
    {
      secondOfTwo = again.empty() ? cells[*found[0]] : again;
      break;
    }
    chosen = names;
    std::copy(found, found + 3, axes);
  }
  if (!secondOfTwo.empty())
  {
    itkDentalInputErrorMacro(fileName,
                             field,
                             "has more than one column of an axis, \"" + secondOfTwo.substr(0, 40) +
                               "\" beside another",
                             "keep the coordinates in pixels alone");
  }
  if (!chosen && millimetres)
  {
    itkDentalInputErrorMacro(fileName,
                             field,
                             "the column \"" + cells[*millimetres].substr(0, 40) + "\" is in mm",
                             "convert the coordinates to pixels");
  }
  return chosen.has_value();
}

/** Whether a header's cell names a column of pictures, or of patients with a picture each. */
bool
IsWordForPictures(const std::string & cell)
{
  const std::vector<std::string> words = SplitWords(cell);
  return !words.empty() &&
         IsOneOf(words.front(),
                 { "image",
                   "imagename",
                   "img",
                   "file",
                   "filename",
                   "picture",
                   "radiograph",
                   "film",
                   "case",
                   "patient",
                   "patientid",
                   "subject" }) &&
         (words.size() == 1 || IsOneOf(words[1], { "name", "id", "path", "file", "filename", "no", "number" }));
}

/** Takes the columns from a header; false where the line is none.
 *
 * \param lines What follows it. */
bool
ReadHeader(const std::string &                           fileName,
           const std::string &                           field,
           const std::vector<std::string> &              cells,
           unsigned int                                  dimension,
           const std::vector<std::vector<std::string>> & lines,
           TableColumns &                                columns)
{
  std::vector<std::size_t>   labels;
  std::optional<std::size_t> axes[3];
  std::optional<std::size_t> unit;
  if (!FindAxes(fileName, field, cells, dimension, axes))
  {
    return false;
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const std::string cell = LowerCase(cells[i]);
    if (i == axes[0] || i == axes[1] || i == axes[2])
    {
      continue;
    }
    if (IsWordForPictures(cell) && !columns.picture)
    {
      columns.picture = i;
    }
    else if (IsWordForLabels(cell))
    {
      labels.push_back(i);
    }
    else if (IsOneOf(cell, { "unit", "units" }))
    {
      unit = i;
    }
    else if (IsOneOf(cell, { "width", "w" }))
    {
      columns.box[0] = i;
    }
    else if (IsOneOf(cell, { "height", "h" }))
    {
      columns.box[1] = i;
    }
  }
  columns.depth = dimension == 2 ? axes[2] : std::nullopt;
  std::optional<std::size_t> label = FindColumnOfNames(labels, lines);
  if (!label && !labels.empty())
  {
    label = labels.front();
  }
  if (!label)
  {
    // In whatever language it is: a single column that is neither a coordinate nor a unit can only be the labels', and
    // of several the one that names teeth or landmarks.
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      if (i != axes[0] && i != axes[1] && i != axes[2] && i != unit && i != columns.picture)
      {
        others.push_back(i);
      }
    }
    label = others.size() == 1 && !columns.picture ? others.front() : FindColumnOfNames(others, lines);
    if (!label)
    {
      itkDentalInputErrorMacro(fileName, field, "is a header without a column of labels", "name that column \"label\"");
    }
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
        ReadHeader(fileName,
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

/** Throws where a header that was not understood says that its columns are no label and coordinates in their order. */
void
VerifyHeaderIsNoOther(const std::string &              fileName,
                      const std::string &              field,
                      const std::vector<std::string> & cells,
                      const TableColumns &             columns,
                      unsigned int                     dimension)
{
  for (unsigned int i = 0; i < dimension; ++i)
  {
    const std::string &            cell = cells[columns.first[i]];
    const AxisColumn               column = ReadAxis(cell);
    const std::vector<std::string> words = SplitWords(cell);
    const bool                     hasUnit = std::any_of(words.begin(), words.end(), [](const std::string & word) {
      return IsOneOf(word, { "cm", "inch", "in", "%", "percent", "norm", "normalized", "relative", "mm" });
    });
    const bool                     isOfOther =
      IsOneOf(LowerCase(cell),
              { "dx", "dy", "xerror", "yerror", "r", "rho", "theta", "angle", "distance", "radius", "i", "j" });
    const bool isOtherAxis =
      (column.axis >= 0 && column.axis != static_cast<int>(i)) ||
      std::any_of(words.begin(), words.end(), [i](const std::string & word) {
        return IsOneOf(word, { "vertical", "height" }) ? i != 1 : IsOneOf(word, { "horizontal", "width" }) && i != 0;
      });
    if (isOtherAxis || isOfOther || (dimension == 2 && hasUnit) || (column.axis >= 0 && !column.unknown.empty()))
    {
      itkDentalInputErrorMacro(fileName,
                               field,
                               "the column \"" + cell.substr(0, 40) + "\" is not known to be the coordinate \"" +
                                 "xyz"[i] + "\"" + (dimension == 2 ? " in pixels" : ""),
                               std::string("convert it where it is another thing, and call it \"") + "xyz"[i] + '"');
    }
  }
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
    if (first && ReadHeader(fileName, field, cells, dimension, SplitLines(text, begin, separator, dimension), columns))
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
      VerifyHeaderIsNoOther(fileName, field, cells, columns, dimension);
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
