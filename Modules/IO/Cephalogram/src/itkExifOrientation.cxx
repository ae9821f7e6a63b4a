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
#include "itkExifOrientation.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace itk
{
namespace
{
/** Segments have at most 64 KiB, and one or two stand before Exif's. */
constexpr std::size_t ExifHeadSize = std::size_t{ 1 } << 18;

/** A number of the bytes, in either order; 0 where they end before it. */
std::uint32_t
GetNumber(std::string_view bytes, std::size_t offset, std::size_t count, bool bigEndian)
{
  std::uint32_t value = 0;
  for (std::size_t i = 0; offset + count <= bytes.size() && i < count; ++i)
  {
    const auto byte = static_cast<unsigned char>(bytes[offset + (bigEndian ? count - 1 - i : i)]);
    value |= std::uint32_t{ byte } << (8 * i);
  }
  return value;
}

/** The Exif block of a JPEG; empty where there is none before the picture. */
std::string_view
FindExif(std::string_view bytes)
{
  constexpr std::string_view exif("Exif\0\0", 6);
  std::size_t                position = 2;
  while (position + 4 <= bytes.size() && bytes[position] == '\xff')
  {
    const std::uint32_t marker = GetNumber(bytes, position + 1, 1, true);
    if (marker == 0xff)
    {
      // Fill bytes before a marker.
      ++position;
      continue;
    }
    const std::uint32_t length = GetNumber(bytes, position + 2, 2, true);
    if (marker == 0xe1 && bytes.substr(position + 4, exif.size()) == exif)
    {
      return bytes.substr(position + 4 + exif.size());
    }
    // The frame or the scan: Exif stands before them. Each length counts itself.
    if ((marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) || marker == 0xda ||
        length < 2)
    {
      break;
    }
    position += 2 + length;
  }
  return std::string_view();
}

/** The same of a PNG, where it is a chunk. */
std::string_view
FindExifChunk(std::string_view bytes)
{
  for (std::size_t position = 8; position + 8 <= bytes.size();)
  {
    const std::size_t length = GetNumber(bytes, position, 4, true);
    if (bytes.substr(position + 4, 4) == "eXIf")
    {
      return bytes.substr(position + 8, length);
    }
    position += 12 + length;
  }
  return std::string_view();
}
} // namespace

unsigned int
ReadExifOrientation(std::string_view picture)
{
  // The block is a TIFF of which only the first directory counts here.
  const std::string_view block =
    picture.substr(0, 4) == "\x89PNG" ? FindExifChunk(picture) : FindExif(picture.substr(0, ExifHeadSize));
  const bool bigEndian = block.substr(0, 2) == "MM";
  if ((!bigEndian && block.substr(0, 2) != "II") || GetNumber(block, 2, 2, bigEndian) != 42)
  {
    return 1;
  }
  constexpr std::uint32_t orientationTag = 274;
  const std::size_t       directory = GetNumber(block, 4, 4, bigEndian);
  const std::uint32_t     entries = GetNumber(block, directory, 2, bigEndian);
  for (std::uint32_t i = 0; i < entries; ++i)
  {
    const std::size_t entry = directory + 2 + 12 * std::size_t{ i };
    if (GetNumber(block, entry, 2, bigEndian) == orientationTag)
    {
      // Of type SHORT the value stands in the first bytes of its field; LONG fills it.
      const std::uint32_t type = GetNumber(block, entry + 2, 2, bigEndian);
      const std::uint32_t value = type == 3   ? GetNumber(block, entry + 8, 2, bigEndian)
                                  : type == 4 ? GetNumber(block, entry + 8, 4, bigEndian)
                                              : 1;
      return value >= 1 && value <= 8 ? value : 1;
    }
  }
  return 1;
}
} // namespace itk
