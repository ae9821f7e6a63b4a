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
#include "itkMakeUTF8.h"

#include <cstddef>
#include <cstdint>

namespace itk
{
namespace
{
/** Bytes of the character that begins there; 0 where none does. Longer spellings than needed, halves of a UTF-16 pair
 * and what is beyond the last character are none. */
std::size_t
CharacterLength(const std::string & text, std::size_t at)
{
  const auto byte = [&text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
  };
  const unsigned char lead = byte(at);
  const std::size_t   length = lead < 0x80   ? 1
                               : lead < 0xc2 ? 0
                               : lead < 0xe0 ? 2
                               : lead < 0xf0 ? 3
                               : lead < 0xf5 ? 4
                                             : 0;
  std::uint32_t       code = length == 2 ? lead & 0x1fu : length == 3 ? lead & 0x0fu : lead & 0x07u;
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(at + i) & 0xc0u) != 0x80u)
    {
      return 0;
    }
    code = (code << 6) | (byte(at + i) & 0x3fu);
  }
  const bool isNone = (length == 3 && (code < 0x800 || (code >= 0xd800 && code < 0xe000))) ||
                      (length == 4 && (code < 0x10000 || code > 0x10ffff));
  return isNone ? 0 : length;
}
} // namespace

std::string
MakeUTF8(const std::string & text)
{
  std::string made;
  made.reserve(text.size());
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = CharacterLength(text, at);
    if (length > 0)
    {
      made.append(text, at, length);
      at += length;
      continue;
    }
    const auto byte = static_cast<unsigned char>(text[at++]);
    made += static_cast<char>(0xc0u | (byte >> 6));
    made += static_cast<char>(0x80u | (byte & 0x3fu));
  }
  return made;
}
} // namespace itk
