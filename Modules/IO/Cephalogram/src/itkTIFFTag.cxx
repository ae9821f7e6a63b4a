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
#include "itkTIFFTag.h"

#include <algorithm>
#include <fstream>
#include <vector>

namespace itk
{
namespace
{
using Bytes = std::vector<unsigned char>;

/** Empty where the file has fewer. */
Bytes
ReadAt(std::ifstream & file, std::uint64_t offset, std::size_t count)
{
  Bytes bytes(count, 0);
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char *>(bytes.data()), static_cast<std::streamsize>(count));
  return file ? bytes : Bytes();
}

/** Where the Exif block of a JPEG begins, as far as there is one before the picture. */
std::optional<std::uint64_t>
FindExif(std::ifstream & file)
{
  std::uint64_t position = 2;
  for (;;)
  {
    const Bytes segment = ReadAt(file, position, 10);
    if (segment.empty() || segment[0] != 0xff)
    {
      return std::nullopt;
    }
    const unsigned int marker = segment[1];
    // Fill bytes before a marker.
    if (marker == 0xff)
    {
      ++position;
      continue;
    }
    constexpr unsigned char exif[] = { 'E', 'x', 'i', 'f', 0, 0 };
    const unsigned int      length = segment[2] * 256u + segment[3];
    if (marker == 0xe1 && std::equal(std::begin(exif), std::end(exif), segment.begin() + 4))
    {
      return position + 10;
    }
    // The frame or the scan: Exif stands before them. Each length counts itself.
    if ((marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) || marker == 0xda ||
        length < 2)
    {
      return std::nullopt;
    }
    position += 2 + length;
  }
}
} // namespace

std::optional<std::uint32_t>
ReadTIFFTag(const std::string & fileName, std::uint32_t tag)
{
  std::ifstream file(fileName, std::ios::binary);
  std::uint64_t start = 0;
  Bytes         head = ReadAt(file, start, 8);
  if (head.size() == 8 && head[0] == 0xff && head[1] == 0xd8)
  {
    const auto exif = FindExif(file);
    if (!exif)
    {
      return std::nullopt;
    }
    start = *exif;
    head = ReadAt(file, start, 8);
  }
  const bool whole = head.size() == 8;
  const bool bigEndian = whole && head[0] == 'M' && head[1] == 'M' && head[3] == 42;
  if (!whole || (!bigEndian && !(head[0] == 'I' && head[1] == 'I' && head[2] == 42)))
  {
    return std::nullopt;
  }
  const auto number = [bigEndian](const Bytes & bytes, std::size_t offset, unsigned int count) {
    std::uint32_t value = 0;
    for (unsigned int i = 0; i < count; ++i)
    {
      value |= std::uint32_t{ bytes[offset + (bigEndian ? count - 1 - i : i)] } << (8 * i);
    }
    return value;
  };
  const std::uint64_t directory = start + number(head, 4, 4);
  const Bytes         count = ReadAt(file, directory, 2);
  if (count.empty())
  {
    return std::nullopt;
  }
  for (std::uint32_t i = 0; i < number(count, 0, 2); ++i)
  {
    const Bytes entry = ReadAt(file, directory + 2 + 12 * std::uint64_t{ i }, 12);
    if (entry.empty())
    {
      return std::nullopt;
    }
    if (number(entry, 0, 2) == tag)
    {
      // Of type SHORT the value stands in the first bytes of its field; LONG fills it.
      const std::uint32_t type = number(entry, 2, 2);
      return type == 3   ? std::optional<std::uint32_t>(number(entry, 8, 2))
             : type == 4 ? std::optional<std::uint32_t>(number(entry, 8, 4))
                         : std::nullopt;
    }
  }
  return std::nullopt;
}
} // namespace itk
