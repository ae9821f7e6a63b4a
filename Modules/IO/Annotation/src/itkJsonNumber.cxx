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
#include "itkJsonNumber.h"

#include "itkShortNumber.h"
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace itk
{
std::string
JsonNumber(double value)
{
  if (!std::isfinite(value))
  {
    throw std::invalid_argument("JSON has no number for " + ShortNumber(value));
  }
  char       buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, result.ptr);
}

std::string
JsonString(const std::string & text)
{
  constexpr char digits[] = "0123456789abcdef";
  std::string    quoted = "\"";
  for (const char character : text)
  {
    if (character == '"' || character == '\\')
    {
      quoted += '\\';
      quoted += character;
    }
    else if (static_cast<unsigned char>(character) < 0x20)
    {
      quoted += "\\u00";
      quoted += digits[static_cast<unsigned char>(character) >> 4];
      quoted += digits[character & 15];
    }
    else
    {
      quoted += character;
    }
  }
  return quoted + '"';
}
} // namespace itk
