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

#include "itkCephalometricPoseTransform.h"
#include "itkDentalInputError.h"
#include "itkTextFile.h"

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
  /** Of the points that go in and come out. */
  const char * dimensions;
  std::size_t  parameters;
  std::size_t  fixedParameters;
  /** Of files of earlier versions, which the transform still takes. */
  std::size_t earlierFixedParameters;
};
constexpr Kind Kinds[] = { { "Similarity2DTransform", "_2_2", 4, 2, 2 },
                           { "VersorRigid3DTransform", "_3_3", 6, 3, 3 },
                           { "CephalometricPoseTransform",
                             "_3_2",
                             CephalometricPoseTransform::NumberOfParameters,
                             CephalometricPoseTransform::NumberOfFixedParameters,
                             CephalometricPoseTransform::NumberOfLateralFixedParameters } };

/** So many numbers, one blank before each; throws for what is none, and for others than so many. */
std::string
TakeNumbers(const std::string & fileName,
            const std::string & field,
            const std::string & text,
            std::size_t         expected,
            std::size_t         alsoExpected)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::string numbers;
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
    numbers += ' ' + word;
  }
  if (count != expected && count != alsoExpected)
  {
    itkDentalInputErrorMacro(fileName,
                             field,
                             "has " + std::to_string(count) + " numbers, and such a transform " +
                               std::to_string(expected),
                             "write the transform again");
  }
  return numbers;
}
} // namespace

std::string
ReadTransformText(const std::string & fileName)
{
  constexpr std::size_t longest = std::size_t{ 1 } << 16;
  const std::string     text = ReadTextFile(fileName, "a transform file", longest);
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
  for (const Kind & kind : Kinds)
  {
    const std::string type = std::string(kind.name) + "_double" + kind.dimensions;
    if (values[0] == type || values[0] == std::string(kind.name) + "_float" + kind.dimensions)
    {
      const std::string parameters = TakeNumbers(fileName, "Parameters", values[1], kind.parameters, kind.parameters);
      const std::string fixed =
        TakeNumbers(fileName, "FixedParameters", values[2], kind.fixedParameters, kind.earlierFixedParameters);
      // Written anew: a last line without an end is one more thing that ITK's reader doesn't survive.
      return "#Insight Transform File V1.0\n#Transform 0\nTransform: " + type + "\nParameters:" + parameters +
             "\nFixedParameters:" + fixed + '\n';
    }
  }
  fail("holds a " + values[0].substr(0, 60));
  return text;
}
} // namespace itk
