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
#include "itkRadiographFileFormat.h"

#include "itkDentalInputError.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace itk
{
namespace
{
using Format = RadiographFileFormatEnum;
using Bytes = std::vector<unsigned char>;

Bytes
ReadBytes(const std::string & fileName, std::size_t maximum)
{
  std::ifstream file(fileName, std::ios::binary);
  Bytes         bytes(maximum);
  file.read(reinterpret_cast<char *>(bytes.data()), static_cast<std::streamsize>(maximum));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

bool
StartsWith(const Bytes & bytes, const std::string & signature, std::size_t offset = 0)
{
  return bytes.size() >= offset + signature.size() &&
         std::memcmp(bytes.data() + offset, signature.data(), signature.size()) == 0;
}

uint32_t
BigEndian32(const Bytes & bytes, std::size_t offset)
{
  return (uint32_t{ bytes[offset] } << 24) | (uint32_t{ bytes[offset + 1] } << 16) |
         (uint32_t{ bytes[offset + 2] } << 8) | uint32_t{ bytes[offset + 3] };
}

uint32_t
LittleEndian32(const Bytes & bytes, std::size_t offset)
{
  return uint32_t{ bytes[offset] } | (uint32_t{ bytes[offset + 1] } << 8) | (uint32_t{ bytes[offset + 2] } << 16) |
         (uint32_t{ bytes[offset + 3] } << 24);
}

bool
PNGIsComplete(const Bytes & bytes)
{
  std::size_t position = 8;
  while (position + 12 <= bytes.size())
  {
    const std::size_t length = BigEndian32(bytes, position);
    if (length > bytes.size() - position - 12)
    {
      return false;
    }
    if (StartsWith(bytes, "IEND", position + 4))
    {
      return true;
    }
    position += 12 + length;
  }
  return false;
}

bool
JPEGIsComplete(const Bytes & bytes)
{
  std::size_t position = 2;
  while (position + 2 <= bytes.size())
  {
    if (bytes[position] != 0xff)
    {
      // Entropy-coded data, or bytes that a decoder skips.
      ++position;
      continue;
    }
    const unsigned char marker = bytes[position + 1];
    if (marker == 0xd9)
    {
      return true;
    }
    if (marker == 0x00 || marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8))
    {
      position += 2;
    }
    else if (marker == 0xff)
    {
      position += 1;
    }
    else
    {
      // A segment with its length; a preview's end marker inside it is not the picture's.
      if (position + 4 > bytes.size())
      {
        return false;
      }
      position += 2u + (std::size_t{ bytes[position + 2] } << 8) + bytes[position + 3];
    }
  }
  return false;
}

bool
BMPIsComplete(const Bytes & bytes)
{
  if (bytes.size() < 34)
  {
    return false;
  }
  const uint64_t offset = LittleEndian32(bytes, 10);
  const uint64_t width = LittleEndian32(bytes, 18);
  const auto     signedHeight = static_cast<int32_t>(LittleEndian32(bytes, 22));
  const uint64_t height = static_cast<uint64_t>(signedHeight < 0 ? -int64_t{ signedHeight } : int64_t{ signedHeight });
  const uint64_t bits = bytes[28] | (unsigned{ bytes[29] } << 8);
  const bool     compressed = LittleEndian32(bytes, 30) != 0;
  if (compressed)
  {
    return bytes.size() > offset;
  }
  // Both factors are below 2^38 and 2^32: divide, do not multiply.
  const uint64_t row = (width * bits + 31) / 32 * 4;
  return row == 0 || height == 0 || (bytes.size() >= offset && (bytes.size() - offset) / row >= height);
}
} // namespace

const char *
ToString(RadiographFileFormatEnum format)
{
  switch (format)
  {
    case Format::PNG:
      return "PNG";
    case Format::JPEG:
      return "JPEG";
    case Format::TIFF:
      return "TIFF";
    case Format::BMP:
      return "BMP";
    case Format::NRRD:
      return "NRRD";
    case Format::MetaImage:
      return "MetaImage";
    default:
      return "DICOM";
  }
}

RadiographFileFormatEnum
DetectRadiographFileFormat(const std::string & fileName)
{
  std::error_code status;
  if (std::filesystem::is_directory(fileName, status))
  {
    itkDentalInputErrorMacro(fileName, "", "is a directory, not an image", "name the image file in it");
  }
  if (!std::filesystem::exists(fileName, status))
  {
    itkDentalInputErrorMacro(fileName, "", "no such file", "check the path");
  }
  if (!std::ifstream(fileName, std::ios::binary))
  {
    itkDentalInputErrorMacro(
      fileName, "", std::string("cannot be opened: ") + std::strerror(errno), "check the file's permissions");
  }
  const Bytes head = ReadBytes(fileName, 4096);
  if (head.empty())
  {
    itkDentalInputErrorMacro(fileName, "", "is empty", "export the image again");
  }
  if (StartsWith(head, "\x89PNG\r\n\x1a\n"))
  {
    return Format::PNG;
  }
  if (StartsWith(head, "\xff\xd8\xff"))
  {
    return Format::JPEG;
  }
  if (StartsWith(head, std::string("II*\0", 4)) || StartsWith(head, std::string("MM\0*", 4)) ||
      StartsWith(head, std::string("II+\0", 4)) || StartsWith(head, std::string("MM\0+", 4)))
  {
    return Format::TIFF;
  }
  if (StartsWith(head, "NRRD000"))
  {
    return Format::NRRD;
  }
  if (StartsWith(head, "DICM", 128) ||
      // No preamble: the first element is of group 0002 or 0008, in little endian.
      StartsWith(head, std::string("\x02\0\0\0", 4)) || StartsWith(head, std::string("\x08\0\x05\0", 4)) ||
      StartsWith(head, std::string("\x08\0\x08\0", 4)) || StartsWith(head, std::string("\x08\0\x16\0", 4)))
  {
    return Format::DICOM;
  }
  const std::string start(head.begin(),
                          head.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(head.size(), 512)));
  if ((start.compare(0, 10, "ObjectType") == 0 || start.compare(0, 5, "NDims") == 0) &&
      start.find('=') != std::string::npos)
  {
    return Format::MetaImage;
  }
  if (StartsWith(head, "BM"))
  {
    return Format::BMP;
  }
  itkDentalInputErrorMacro(
    fileName, "", "is no image of a known format", "use PNG, JPEG, TIFF, BMP, NRRD, MetaImage or DICOM");
}

void
VerifyRadiographFileIsComplete(const std::string & fileName, RadiographFileFormatEnum format)
{
  if (format != Format::PNG && format != Format::JPEG && format != Format::BMP)
  {
    return;
  }
  std::error_code status;
  const auto      size = std::filesystem::file_size(fileName, status);
  // No radiograph is longer; its decoder decides on what follows.
  constexpr std::uintmax_t longest = std::uintmax_t{ 1 } << 30;
  const Bytes bytes = ReadBytes(fileName, static_cast<std::size_t>(status ? longest : std::min(size, longest)));
  const bool  complete = format == Format::PNG    ? PNGIsComplete(bytes)
                         : format == Format::JPEG ? JPEGIsComplete(bytes)
                                                  : BMPIsComplete(bytes);
  if (!complete)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             std::string("the ") + ToString(format) + " file is truncated at " +
                               std::to_string(bytes.size()) + " bytes",
                             "copy or export it again");
  }
}

std::string
ReadRadiographTextHeader(const std::string & fileName)
{
  const Bytes bytes = ReadBytes(fileName, 1u << 16);
  std::string header;
  for (const unsigned char byte : bytes)
  {
    // A NRRD's header ends with an empty line, a MetaImage's with the line of its data file.
    if (byte == '\n' && (header.empty() || header.back() == '\n' ||
                         header.find("elementdatafile", header.rfind('\n') + 1) != std::string::npos))
    {
      break;
    }
    if (byte != '\r')
    {
      header += byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte - 'A' + 'a') : static_cast<char>(byte);
    }
  }
  return header + '\n';
}
} // namespace itk
