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
#include "itkAnnotationText.h"

#include "itkCephalometricLandmarkSet.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkSet.h"
#include "itkInputFile.h"
#include "itkTrimText.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace itk
{
bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string
Trim(const std::string & text)
{
  std::string trimmed = TrimText(text);
  if (trimmed.size() >= 2 && trimmed.front() == '"' && trimmed.back() == '"')
  {
    trimmed = trimmed.substr(1, trimmed.size() - 2);
  }
  return trimmed;
}

std::vector<std::string>
Split(const std::string & line, char separator)
{
  std::vector<std::string> cells;
  for (std::size_t begin = 0;;)
  {
    std::size_t end = line.find(separator, begin);
    // A quoted cell ends with a quote before a separator or the end of the line.
    const std::size_t first = line.find_first_not_of(" \t", begin);
    if (separator != '\t' && first != std::string::npos && line[first] == '"')
    {
      std::size_t quote = line.find('"', first + 1);
      while (quote != std::string::npos && quote + 1 < line.size() && line[quote + 1] == '"')
      {
        quote = line.find('"', quote + 2);
      }
      if (quote != std::string::npos)
      {
        end = line.find(separator, quote);
      }
    }
    cells.push_back(Trim(line.substr(begin, end == std::string::npos ? end : end - begin)));
    if (end == std::string::npos)
    {
      return cells;
    }
    begin = end + 1;
  }
}

bool
ParseNumber(const std::string & text, double & value)
{
  const char * const end = text.data() + text.size();
  const auto         result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(value);
}

bool
ParseTableNumber(const std::string & text, double & value)
{
  if (ParseNumber(text, value))
  {
    return true;
  }
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find('.') != std::string::npos)
  {
    return false;
  }
  std::string point = text;
  point[comma] = '.';
  return ParseNumber(point, value);
}

void
RequireJsonBeginning(const std::string & fileName)
{
  const std::string head = ReadFileHead(fileName, 512);
  const std::size_t first = head.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  if (first == std::string::npos || head[first] == '{' || head[first] == '[')
  {
    return;
  }
  const std::size_t end = std::min(head.find_first_of("\r\n", first), first + 30);
  const std::string begin = head.substr(first, end - first);
  const bool        isText =
    std::all_of(begin.begin(), begin.end(), [](char letter) { return letter >= ' ' && letter <= '~'; });
  itkDentalInputErrorMacro(
    fileName,
    "",
    "is in no form that is known, " +
      (isText ? "and no JSON: it begins with \"" + begin + "\"" : std::string("nor is it text")),
    "export JSON (labelme, COCO, VIA, Label Studio, Supervisely, 3D Slicer) or CVAT XML, or write a "
    "table .csv with label,x,y (Documentation/OtherFiles.md)");
}

std::string
ListNames(const std::vector<std::string> & names)
{
  constexpr std::size_t limit = 8;
  std::string           text;
  for (std::size_t i = 0; i < std::min(names.size(), limit); ++i)
  {
    text += (i == 0 ? "" : ", ") + names[i].substr(0, 40);
  }
  return names.size() > limit ? text + " and " + std::to_string(names.size() - limit) + " more" : text;
}

bool
NamesToothOrJaw(const std::string & label)
{
  return ToothCode::IsWrittenAsCode(label) || ToothCode::FromSidelessString(label).IsKnown() ||
         ToothCode::JawFromString(label) != ToothCode::JawEnum::Unknown;
}

bool
IsDentalLandmarkName(const std::string & name)
{
  try
  {
    return DentalLandmarkSet<2>::ParseName(name).IsKnown();
  }
  catch (const std::invalid_argument &)
  {
    return false;
  }
}

std::string
SpellPointOfTooth(const std::string & name, ToothCode::NumberingEnum numbering)
{
  constexpr const char * separators = " \t_-";
  const std::string      text = TrimText(name);
  // From behind: a tooth may be written with a separator itself, "tooth 16".
  for (std::size_t end = text.find_last_of(separators); end != std::string::npos && end > 0;
       end = text.find_last_of(separators, end - 1))
  {
    const std::string point = TrimText(text.substr(end), separators);
    try
    {
      const ToothCode code = ToothCode::FromString(TrimText(text.substr(0, end), separators), numbering);
      if (code.IsKnown() && !point.empty())
      {
        return code.GetName() + '_' + point;
      }
    }
    catch (const std::invalid_argument &)
    {
      // No tooth so far: the next separator may be the one before the point.
      continue;
    }
  }
  return name;
}

bool
NamesPointOfTooth(const std::string & name)
{
  // The numbers of both numberings are tried: which one is the file's is not known here.
  const auto isPoint = [&name](ToothCode::NumberingEnum numbering) {
    const std::string spelled = SpellPointOfTooth(name, numbering);
    return IsDentalLandmarkName(spelled) || CephalometricLandmarkSet::ParseName(spelled).position > 0;
  };
  return isPoint(ToothCode::NumberingEnum::Quadrant) || isPoint(ToothCode::NumberingEnum::Universal);
}

std::string
ChooseLabel(const std::vector<std::string> & labels)
{
  const auto tooth = std::find_if(labels.begin(), labels.end(), NamesToothOrJaw);
  return tooth != labels.end() ? *tooth : labels.empty() ? std::string() : labels.front();
}

std::string
ChoosePointLabel(const std::vector<std::string> & labels)
{
  const auto point = std::find_if(labels.begin(), labels.end(), NamesPointOfTooth);
  return point != labels.end() ? *point : ChooseLabel(labels);
}
} // namespace itk
