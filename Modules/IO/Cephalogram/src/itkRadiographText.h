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
#ifndef itkRadiographText_h
#define itkRadiographText_h

#include "itkTrimText.h"

#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>

// Numbers in the text of headers and tags, read and written alike in every locale. Private to this module.
namespace itk
{
namespace RadiographText
{
inline std::string
Trim(const std::string & text)
{
  // DICOM pads with blanks and null characters.
  constexpr char blanks[] = { ' ', '\0', '\t', '\r', '\n' };
  return TrimText(text, std::string_view(blanks, sizeof(blanks)));
}

/** \return whether the whole text is one finite number. */
inline bool
ParseNumber(const std::string & text, double & value)
{
  const std::string  trimmed = Trim(text);
  const std::size_t  sign = trimmed.size() > 1 && trimmed[0] == '+' ? 1 : 0;
  const char * const end = trimmed.data() + trimmed.size();
  const auto         result = std::from_chars(trimmed.data() + sign, end, value);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(value);
}

inline std::string
ToString(double value)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os << value;
  return os.str();
}
} // namespace RadiographText
} // namespace itk

#endif
