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
#include "itkMeshFileFormat.h"

#include "itkASCIICharacter.h"
#include "itkLowerCase.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace itk
{
namespace
{
constexpr std::size_t BinarySTLHeaderSize = 84;

/** First word after blanks, comment lines and a byte order mark. */
std::string_view
FirstWord(std::string_view text)
{
  if (text.substr(0, 3) == "\xEF\xBB\xBF")
  {
    text.remove_prefix(3);
  }
  while (!text.empty())
  {
    if (IsASCIIBlank(text.front()))
    {
      text.remove_prefix(1);
    }
    else if (text.front() == '#')
    {
      const std::size_t end = text.find('\n');
      text.remove_prefix(end == std::string_view::npos ? text.size() : end);
    }
    else
    {
      break;
    }
  }
  return text.substr(0, std::find_if(text.begin(), text.end(), IsASCIIBlank) - text.begin());
}

bool
IsText(std::string_view text)
{
  return text.find('\0') == std::string_view::npos;
}
} // namespace

std::ostream &
operator<<(std::ostream & os, MeshFileFormatEnum format)
{
  switch (format)
  {
    case MeshFileFormatEnum::BinarySTL:
      return os << "binary STL";
    case MeshFileFormatEnum::AsciiSTL:
      return os << "ASCII STL";
    case MeshFileFormatEnum::PLY:
      return os << "PLY";
    case MeshFileFormatEnum::OBJ:
      return os << "OBJ";
    case MeshFileFormatEnum::OFF:
      return os << "OFF";
    default:
      return os << "unknown";
  }
}

MeshFileFormatEnum
MeshFileFormatFromName(const std::string & fileName)
{
  const std::size_t dot = fileName.find_last_of("./\\");
  if (dot == std::string::npos || fileName[dot] != '.')
  {
    return MeshFileFormatEnum::Unknown;
  }
  const std::string extension = LowerCase(fileName.substr(dot + 1));
  return extension == "stl"   ? MeshFileFormatEnum::BinarySTL
         : extension == "ply" ? MeshFileFormatEnum::PLY
         : extension == "obj" ? MeshFileFormatEnum::OBJ
         : extension == "off" ? MeshFileFormatEnum::OFF
                              : MeshFileFormatEnum::Unknown;
}

MeshFileFormatEnum
DetectMeshFileFormat(const char * bytes, std::size_t size, const std::string & fileName)
{
  const MeshFileFormatEnum named = MeshFileFormatFromName(fileName);
  if (size >= BinarySTLHeaderSize)
  {
    unsigned char count[4];
    std::memcpy(count, bytes + 80, 4);
    const std::uint64_t facets = count[0] | count[1] << 8 | count[2] << 16 | static_cast<std::uint64_t>(count[3]) << 24;
    if (size == BinarySTLHeaderSize + 50 * facets && (facets > 0 || named == MeshFileFormatEnum::BinarySTL))
    {
      return MeshFileFormatEnum::BinarySTL;
    }
  }
  const std::string_view head(bytes, std::min(size, MeshFileFormatHeadSize));
  const std::string_view word = FirstWord(head);
  if (word == "ply")
  {
    return MeshFileFormatEnum::PLY;
  }
  // [ST][C][N]OFF
  if (word.size() <= 7 && word.size() >= 3 && word.substr(word.size() - 3) == "OFF" &&
      word.find_first_not_of("STCNOF4n") == std::string_view::npos)
  {
    return MeshFileFormatEnum::OFF;
  }
  // A header of a broken binary file may start with "solid" too; the bytes after it are no text.
  if ((word == "solid" || word == "SOLID" || word == "Solid") && IsText(head.substr(0, 512)))
  {
    return MeshFileFormatEnum::AsciiSTL;
  }
  if (named == MeshFileFormatEnum::Unknown && IsText(head.substr(0, 512)))
  {
    for (const char * keyword : { "v", "vn", "vt", "mtllib", "usemtl", "o", "g" })
    {
      if (word == keyword)
      {
        return MeshFileFormatEnum::OBJ;
      }
    }
  }
  return named;
}
} // namespace itk
