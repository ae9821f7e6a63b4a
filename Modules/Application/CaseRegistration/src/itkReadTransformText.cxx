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
#include "itkReadTransformText.h"

#include "itkDentalInputError.h"
#include "itkTextFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <locale>
#include <sstream>
#include <vector>

namespace itk
{
namespace
{
struct Kind
{
  const char * name;
  std::size_t  parameters;
  std::size_t  fixedParameters;
};
constexpr Kind Kinds[] = { { "Similarity2DTransform", 4, 2 },
                           { "VersorRigid3DTransform", 6, 3 },
                           { "CephalometricPoseTransform", 7, 8 } };

/** How many numbers a text is; throws for what is none. */
std::size_t
CountNumbers(const std::string & fileName, const std::string & field, const std::string & text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::size_t count = 0;
  for (std::string word; stream >> word; ++count)
  {
    std::istringstream number(word);
    number.imbue(std::locale::classic());
    double value = 0.0;
    if (!(number >> value) || !number.eof() || !std::isfinite(value))
    {
      itkDentalInputErrorMacro(
        fileName, field, "\"" + word.substr(0, 40) + "\" is no finite number", "write the transform again");
    }
  }
  return count;
}
} // namespace

std::string
ReadTransformText(const std::string & fileName)
{
  constexpr std::size_t longest = std::size_t{ 1 } << 16;
  const std::string     text = ReadTextFile(fileName, "transform", longest);
  const auto            fail = [&fileName](const std::string & problem) {
    itkDentalInputErrorMacro(fileName,
                             "",
                             problem,
                             "name a file that ITK, 3D Slicer or WriteTransform() has written (.tfm, .txt), of a "
                                        "Similarity2DTransform, VersorRigid3DTransform or CephalometricPoseTransform");
  };
  std::istringstream       stream(text);
  std::vector<std::string> values;
  for (std::string line; std::getline(stream, line);)
  {
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    if (line.find_first_not_of(" \t") == std::string::npos || line[0] == '#')
    {
      continue;
    }
    // In this order, which ITK's writer has and its reader relies on.
    constexpr const char * fields[] = { "Transform: ", "Parameters:", "FixedParameters:" };
    if (values.size() == std::size(fields))
    {
      fail("holds more than one transform");
    }
    const std::string field = fields[values.size()];
    if (line.compare(0, field.size(), field) != 0)
    {
      fail("is no transform: there is no line \"" + field + "\" where it should be");
    }
    values.push_back(line.substr(field.size()));
  }
  if (values.size() != 3)
  {
    fail("is no whole transform");
  }
  // Behind the name the type of its numbers and its dimensions.
  const auto isOdd = [](unsigned char letter) { return letter != '_' && std::isalnum(letter) == 0; };
  if (std::any_of(values[0].begin(), values[0].end(), isOdd))
  {
    fail("holds a \"" + values[0].substr(0, 60) + "\"");
  }
  const std::string name = values[0].substr(0, values[0].find('_'));
  for (const Kind & kind : Kinds)
  {
    if (name == kind.name)
    {
      if (CountNumbers(fileName, "Parameters", values[1]) != kind.parameters ||
          CountNumbers(fileName, "FixedParameters", values[2]) != kind.fixedParameters)
      {
        fail("a " + name + " has " + std::to_string(kind.parameters) + " parameters and " +
             std::to_string(kind.fixedParameters) + " fixed ones, and here are others");
      }
      // Written anew: that its last line has no end is one more thing that ITK's reader doesn't survive.
      return "#Insight Transform File V1.0\n#Transform 0\nTransform: " + values[0] + "\nParameters:" + values[1] +
             "\nFixedParameters:" + values[2] + '\n';
    }
  }
  fail("holds a " + name.substr(0, 60));
  return text;
}
} // namespace itk
