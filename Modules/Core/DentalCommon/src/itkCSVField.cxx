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
#include "itkCSVField.h"

#include <charconv>

namespace itk
{
namespace
{
bool
IsNumber(const std::string & text)
{
  double     value = 0.0;
  const auto begin = text.data() + (text[0] == '+' ? 1 : 0);
  const auto end = text.data() + text.size();
  const auto parsed = std::from_chars(begin, end, value);
  return parsed.ec == std::errc() && parsed.ptr == end;
}
} // namespace

std::string
ToCSVField(const std::string & text)
{
  const bool isFormula =
    text.size() > 1 && std::string("=+-@\t\r").find(text[0]) != std::string::npos && !IsNumber(text);
  std::string field = isFormula ? '\'' + text : text;
  if (field.find_first_of(",\"\n\r") == std::string::npos)
  {
    return field;
  }
  std::string quoted = "\"";
  for (const char character : field)
  {
    quoted += character;
    quoted += character == '"' ? "\"" : "";
  }
  return quoted + '"';
}
} // namespace itk
