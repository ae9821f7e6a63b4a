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
#ifndef itkTrimText_h
#define itkTrimText_h

#include <string>
#include <string_view>

namespace itk
{
/** Text without the given characters at its ends; without argument those are blanks, tabulators and line ends.
 *
 * \ingroup DentalCommon */
inline std::string
TrimText(std::string_view text, std::string_view characters = " \t\r\n")
{
  const std::size_t first = text.find_first_not_of(characters);
  return first == std::string_view::npos
           ? std::string()
           : std::string(text.substr(first, text.find_last_not_of(characters) - first + 1));
}
} // namespace itk

#endif
