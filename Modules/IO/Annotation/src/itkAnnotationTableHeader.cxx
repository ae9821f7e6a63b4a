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
#include "itkAnnotationTableHeader.h"

#include "itkAnnotationText.h"
#include "itkDentalInputError.h"
#include "itkLowerCase.h"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>

namespace itk
{
namespace
{
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
} // namespace

bool
ReadAnnotationTableHeader(const std::string &                           fileName,
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

void
VerifyTableHeaderIsNoOther(const std::string &              fileName,
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
} // namespace itk
