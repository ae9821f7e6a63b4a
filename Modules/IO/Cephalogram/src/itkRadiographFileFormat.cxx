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

#include "itkASCIICharacter.h"
#include "itkDentalInputError.h"
#include "itkDicomFileCheck.h"
#include "itkForeignFile.h"
#include "itkInputFile.h"
#include "itkJPEGFileCheck.h"
#include "itkLowerCase.h"
#include "itkNiftiPictureIO.h"
#include "itkTrimText.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <locale>
#include <map>
#include <sstream>
#include <vector>

namespace itk
{
namespace
{
using Format = RadiographFileFormatEnum;

/** A radiograph of the most pixels that are read, in colours of 16 bits, has half. */
constexpr std::size_t LongestFile = std::size_t{ 1 } << 30;
/** In which a format is told. */
constexpr std::size_t HeadSize = 4096;

/** Bytes that belong to another, as numbers from 0 to 255. */
class Bytes : public std::string_view
{
public:
  Bytes(std::string_view bytes)
    : std::string_view(bytes)
  {}
  unsigned char
  operator[](std::size_t position) const
  {
    return static_cast<unsigned char>(*(this->data() + position));
  }
};

bool
StartsWith(std::string_view bytes, const std::string & signature, std::size_t offset = 0)
{
  return bytes.size() >= offset + signature.size() &&
         std::memcmp(bytes.data() + offset, signature.data(), signature.size()) == 0;
}

uint32_t
BigEndian32(Bytes bytes, std::size_t offset)
{
  return (uint32_t{ bytes[offset] } << 24) | (uint32_t{ bytes[offset + 1] } << 16) |
         (uint32_t{ bytes[offset + 2] } << 8) | uint32_t{ bytes[offset + 3] };
}

uint32_t
LittleEndian32(Bytes bytes, std::size_t offset)
{
  return uint32_t{ bytes[offset] } | (uint32_t{ bytes[offset + 1] } << 8) | (uint32_t{ bytes[offset + 2] } << 16) |
         (uint32_t{ bytes[offset + 3] } << 24);
}

uint32_t
CyclicRedundancyCheck(Bytes bytes)
{
  static const std::array<uint32_t, 256> table = [] {
    std::array<uint32_t, 256> values{};
    for (uint32_t i = 0; i < 256; ++i)
    {
      uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit)
      {
        value = (value & 1u) != 0 ? 0xedb88320u ^ (value >> 1) : value >> 1;
      }
      values[i] = value;
    }
    return values;
  }();
  uint32_t value = 0xffffffffu;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    value = table[(value ^ bytes[i]) & 255u] ^ (value >> 8);
  }
  return value ^ 0xffffffffu;
}

/** Chunks whole, their checksums right, and a header that libpng accepts: in reading the information ITK has no answer
 * to libpng's errors, which then abort the program. */
bool
PNGIsComplete(Bytes bytes)
{
  constexpr uint32_t largest = 1000000;
  std::size_t        position = 8;
  std::size_t        colours = 0;
  bool               hasData = false;
  unsigned int       depth = 0;
  unsigned int       colourType = 0;
  std::size_t        longestData = 0;
  while (position + 12 <= bytes.size())
  {
    const std::size_t length = BigEndian32(bytes, position);
    if (length > bytes.size() - position - 12 ||
        CyclicRedundancyCheck(bytes.substr(position + 4, length + 4)) != BigEndian32(bytes, position + 8 + length))
    {
      return false;
    }
    const std::string_view type = bytes.substr(position + 4, 4);
    const bool             first = position == 8;
    if (first != (type == "IHDR"))
    {
      return false;
    }
    if (type == "IHDR")
    {
      if (length != 13)
      {
        return false;
      }
      const uint32_t width = BigEndian32(bytes, position + 8);
      const uint32_t height = BigEndian32(bytes, position + 12);
      depth = bytes[position + 16];
      colourType = bytes[position + 17];
      const bool bits = depth == 8 || (depth == 16 && colourType != 3) ||
                        ((depth == 1 || depth == 2 || depth == 4) && (colourType == 0 || colourType == 3));
      const bool types = colourType == 0 || colourType == 2 || colourType == 3 || colourType == 4 || colourType == 6;
      if (width == 0 || height == 0 || width > largest || height > largest || !bits || !types ||
          bytes[position + 18] != 0 || bytes[position + 19] != 0 || bytes[position + 20] > 1)
      {
        return false;
      }
      // Of one chunk, as libpng has it, which prints about a longer one: all pixels as they are, and what packing adds.
      const std::size_t row = std::size_t{ width } *
                                (colourType == 2   ? 3
                                 : colourType == 4 ? 2
                                 : colourType == 6 ? 4
                                                   : 1) *
                                (depth > 8 ? 2 : 1) +
                              (bytes[position + 20] == 1 ? 7 : 1);
      const std::size_t pixels = row * height;
      longestData = std::max<std::size_t>(8000000, pixels + 6 + 5 * (pixels / std::min<std::size_t>(row, 32566) + 1));
    }
    else if (type == "PLTE")
    {
      if (colours != 0 || hasData || length == 0 || length % 3 != 0 || length > 768 ||
          (colourType == 3 && length / 3 > (std::size_t{ 1 } << depth)))
      {
        return false;
      }
      colours = length / 3;
    }
    else if (type == "IDAT")
    {
      if ((colourType == 3 && colours == 0) || length > longestData)
      {
        return false;
      }
      hasData = true;
    }
    else if (type == "IEND")
    {
      return hasData;
    }
    else if (IsASCIIUpperCase(type[0]))
    {
      // No other chunk is critical.
      return false;
    }
    position += 12 + length;
  }
  return false;
}

bool
JPEGIsComplete(Bytes bytes)
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
BMPIsComplete(Bytes bytes)
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

/** Every value and every strip or tile of every directory lies in the file. BigTIFF is left to the decoder. */
bool
TIFFIsComplete(Bytes bytes)
{
  const bool bigEndian = bytes[0] == 'M';
  const auto number = [&bytes, bigEndian](uint64_t offset, unsigned int count) {
    uint64_t value = 0;
    for (unsigned int i = 0; i < count; ++i)
    {
      value |= uint64_t{ bytes[offset + (bigEndian ? count - 1 - i : i)] } << (8 * i);
    }
    return value;
  };
  if (bytes.size() < 8)
  {
    return false;
  }
  if (number(2, 2) == 43)
  {
    return true;
  }
  constexpr unsigned int sizes[] = { 0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4 };
  uint64_t               directory = number(4, 4);
  // A directory that leads back to one before is not followed for ever.
  for (unsigned int page = 0; directory != 0 && page < 1000; ++page)
  {
    if (directory + 2 > bytes.size())
    {
      return false;
    }
    const uint64_t entries = number(directory, 2);
    if (entries == 0 || directory + 2 + 12 * entries + 4 > bytes.size())
    {
      return false;
    }
    std::vector<uint64_t> offsets;
    std::vector<uint64_t> lengths;
    for (uint64_t entry = 0; entry < entries; ++entry)
    {
      const uint64_t at = directory + 2 + 12 * entry;
      const uint64_t tag = number(at, 2);
      const uint64_t type = number(at + 2, 2);
      const uint64_t count = number(at + 4, 4);
      if (type == 0 || type >= std::size(sizes))
      {
        continue;
      }
      const uint64_t length = count * sizes[type];
      const uint64_t value = length <= 4 ? at + 8 : number(at + 8, 4);
      if (value + length > bytes.size())
      {
        return false;
      }
      // Strips are 273 and 279, tiles 324 and 325.
      if ((tag == 273 || tag == 279 || tag == 324 || tag == 325) && (type == 3 || type == 4))
      {
        std::vector<uint64_t> & list = tag == 273 || tag == 324 ? offsets : lengths;
        for (uint64_t i = 0; i < count; ++i)
        {
          list.push_back(number(value + i * sizes[type], sizes[type]));
        }
      }
    }
    if (offsets.empty())
    {
      return false;
    }
    for (std::size_t i = 0; i < std::min(offsets.size(), lengths.size()); ++i)
    {
      if (offsets[i] + lengths[i] > bytes.size())
      {
        return false;
      }
    }
    directory = number(directory + 2 + 12 * entries, 4);
  }
  return true;
}

/** The bytes of the file that a header names for its pixels. A header comes from somebody else: it may name a file
 * beside it and no other one of who opens it, nor a pipe that is waited for. Throws a DentalInputError of the header's
 * field.
 */
std::string
ReadDataFile(const std::string & fileName, const std::string & field, const std::string & dataFile)
{
  const std::string remedy = "save the image with its pixels in the same file";
  const std::string name = '"' + dataFile.substr(0, 200) + '"';
  if (LowerCase(dataFile).compare(0, 4, "list") == 0 || dataFile.find('%') != std::string::npos)
  {
    itkDentalInputErrorMacro(fileName, field, "names several files", remedy);
  }
  if (dataFile.find_first_of("/\\") != std::string::npos || dataFile.find('\0') != std::string::npos)
  {
    itkDentalInputErrorMacro(fileName, field, name + " is not beside the header, in its folder", remedy);
  }
  try
  {
    InputFile file((std::filesystem::path(fileName).parent_path() / dataFile).string());
    return ReadWhole(file, "a file of pixels", LongestFile);
  }
  catch (const InputFileError & error)
  {
    itkDentalInputErrorMacro(fileName, field, name + ": " + error.what(), remedy);
  }
}

/** Finds where the pixels are, which ITK's decoder, that has a process of its own and checks all else, would open by
 * their name. */
void
VerifyNrrd(const std::string & fileName, std::string & bytes)
{
  std::string header;
  std::string dataFile;
  bool        isDetached = false;
  for (std::size_t begin = 0; begin < bytes.size();)
  {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    std::string       line = bytes.substr(begin, end - begin);
    begin = end + 1;
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    if (line.empty())
    {
      break;
    }
    const std::size_t colon = line.find(": ");
    const std::string field = LowerCase(line.substr(0, colon));
    if (colon == std::string::npos || (field != "data file" && field != "datafile"))
    {
      header += line + '\n';
      continue;
    }
    if (isDetached)
    {
      itkDentalInputErrorMacro(fileName, "data file", "is there twice", "save the image again");
    }
    isDetached = true;
    const std::size_t first = line.find_first_not_of(" \t", colon + 1);
    dataFile = first == std::string::npos ? std::string() : line.substr(first);
  }
  if (isDetached)
  {
    bytes = header + '\n' + ReadDataFile(fileName, "data file", dataFile);
  }
}

/** MetaImage's own reader prints what it misses, and returns what there is. */
void
VerifyMetaImage(const std::string & fileName, std::string & bytes)
{
  const auto fail = [&fileName](const std::string & field, const std::string & problem) {
    itkDentalInputErrorMacro(fileName, field, problem, "write the MetaImage again, binary, in one piece");
  };
  std::map<std::string, std::string> fields;
  // All lines but those that say where the pixels are.
  std::string header;
  std::size_t position = 0;
  while (position < bytes.size() && fields.count("elementdatafile") == 0)
  {
    const std::size_t end = std::min(bytes.find('\n', position), bytes.size());
    const std::string line = bytes.substr(position, end - position);
    position = std::min(end + 1, bytes.size());
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos)
    {
      fail("", "the header has a line without \"=\"");
    }
    const std::string name = LowerCase(TrimText(line.substr(0, equals)));
    fields[name] = TrimText(line.substr(equals + 1));
    if (name != "headersize" && name != "elementdatafile")
    {
      header += line + '\n';
    }
  }
  for (const char * name : { "NDims", "DimSize", "ElementType", "ElementDataFile" })
  {
    if (fields[LowerCase(name)].empty())
    {
      fail(name, "missing field");
    }
  }
  if (LowerCase(fields["binarydata"]) == "false")
  {
    fail("BinaryData", "is False: pixels written as text are not read");
  }
  const std::map<std::string, double> sizes = { { "met_char", 1 },   { "met_uchar", 1 },      { "met_short", 2 },
                                                { "met_ushort", 2 }, { "met_int", 4 },        { "met_uint", 4 },
                                                { "met_long", 4 },   { "met_ulong", 4 },      { "met_long_long", 8 },
                                                { "met_float", 4 },  { "met_ulong_long", 8 }, { "met_double", 8 } };
  const auto                          size = sizes.find(LowerCase(fields["elementtype"]));
  if (size == sizes.end())
  {
    fail("ElementType", "\"" + fields["elementtype"].substr(0, 40) + "\" is no type of a grey or RGB pixel");
  }
  const auto numbers = [&fail](const std::string & name, const std::string & text) {
    std::istringstream  is(text);
    std::vector<double> values;
    is.imbue(std::locale::classic());
    for (double value = 0.0; is >> value;)
    {
      values.push_back(value);
    }
    if (!is.eof() || values.empty())
    {
      fail(name, "\"" + text.substr(0, 40) + "\" is no list of numbers");
    }
    return values;
  };
  double                    expected = size->second;
  const std::vector<double> dimensions = numbers("DimSize", fields["dimsize"]);
  if (numbers("NDims", fields["ndims"]).front() != static_cast<double>(dimensions.size()))
  {
    fail("DimSize", "does not have NDims numbers");
  }
  for (const double dimension : dimensions)
  {
    if (!(dimension >= 1.0 && dimension < 2147483648.0))
    {
      fail("DimSize", "\"" + fields["dimsize"].substr(0, 40) + "\" is no image size");
    }
    expected *= dimension;
  }
  if (!fields["elementnumberofchannels"].empty())
  {
    expected *= numbers("ElementNumberOfChannels", fields["elementnumberofchannels"]).front();
    if (!(expected >= 1.0))
    {
      fail("ElementNumberOfChannels", "is no number of values a pixel");
    }
  }
  const bool isCompressed = LowerCase(fields["compresseddata"]) == "true";
  if (isCompressed)
  {
    // Without its own length the decompressor finds the end.
    expected =
      fields["compresseddatasize"].empty() ? 1.0 : numbers("CompressedDataSize", fields["compresseddatasize"]).front();
  }
  const double headerSize = fields["headersize"].empty() ? 0.0 : numbers("HeaderSize", fields["headersize"]).front();

  const std::string dataFile = fields["elementdatafile"];
  const bool        isLocal = LowerCase(dataFile) == "local";
  const std::string data = isLocal ? std::string() : ReadDataFile(fileName, "ElementDataFile", dataFile);
  // A header in the same file is a part of what a size counts.
  const double skipped = headerSize > 0.0 ? headerSize : isLocal ? static_cast<double>(position) : 0.0;
  const double available = static_cast<double>(isLocal ? bytes.size() : data.size()) - skipped;
  if (!(available >= expected))
  {
    std::ostringstream os;
    os.imbue(std::locale::classic());
    os.precision(17);
    os << "the pixels are truncated: " << std::max(available, 0.0) << " of " << expected << " bytes are there";
    fail("", os.str());
  }
  if (!isLocal)
  {
    // Behind a header of so many bytes, or, where it says -1, at the end.
    const bool isAtEnd = headerSize < 0.0 && !isCompressed;
    const auto begin = isAtEnd ? data.size() - static_cast<std::size_t>(expected) : static_cast<std::size_t>(skipped);
    if (isCompressed && fields["compresseddatasize"].empty())
    {
      header += "CompressedDataSize = " + std::to_string(data.size() - begin) + '\n';
    }
    bytes = header + "ElementDataFile = LOCAL\n" + data.substr(begin);
  }
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
    case Format::NIfTI:
      return "NIfTI";
    default:
      return "DICOM";
  }
}

std::string
ReadRadiographBytes(const std::string & fileName)
{
  try
  {
    InputFile file(fileName);
    return ReadWhole(file, "an image", LongestFile);
  }
  catch (const InputFileError & error)
  {
    itkDentalInputErrorMacro(fileName, "", error.what(), error.GetRemedy());
  }
}

RadiographFileFormatEnum
DetectRadiographFileFormat(const std::string & fileName)
{
  InputFile file(fileName);
  if (const auto error = DescribeProblem(file, "an image"))
  {
    itkDentalInputErrorMacro(fileName, "", error->what(), error->GetRemedy());
  }
  std::string head(std::min(file.GetSize(), HeadSize), '\0');
  head.resize(file.Read(&head[0], head.size()));
  return DetectRadiographFileFormat(fileName, head);
}

RadiographFileFormatEnum
DetectRadiographFileFormat(const std::string & fileName, std::string_view bytes)
{
  const std::string_view head = bytes.substr(0, HeadSize);
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
  const std::string_view start = head.substr(0, 512);
  if ((start.compare(0, 10, "ObjectType") == 0 || start.compare(0, 5, "NDims") == 0) &&
      start.find('=') != std::string_view::npos)
  {
    return Format::MetaImage;
  }
  if (StartsWith(head, "BM"))
  {
    return Format::BMP;
  }
  if (NiftiPictureIO::IsNifti(head))
  {
    return Format::NIfTI;
  }
  RefuseForeignFile(fileName, FilePurposeEnum::Radiograph);
  if (StartsWith(head, "\x1f\x8b"))
  {
    itkDentalInputErrorMacro(
      fileName,
      "",
      "is damaged, or not the NIfTI image that its name says: unpacked it doesn't begin as NIfTI-1 "
      "in one file",
      "copy or export it again, as NIfTI-1 (.nii, .nii.gz), NRRD or PNG");
  }
  itkDentalInputErrorMacro(
    fileName, "", "is no image of a known format", "use PNG, JPEG, TIFF, BMP, NRRD, MetaImage, NIfTI or DICOM");
}

void
KeepChunksOfPixels(std::string & bytes, bool hasTransparency)
{
  // The header, whose chunk is the first, has the bits of a value in its ninth byte and the kind of colours in its
  // tenth.
  constexpr std::size_t kind = 8 + 8 + 9;
  const unsigned int    largest = bytes.size() > kind && bytes[kind - 1] < 16 ? (1u << bytes[kind - 1]) - 1 : 65535u;
  std::size_t           kept = std::min<std::size_t>(bytes.size(), 8);
  std::size_t           colours = 0;
  bool                  hasData = false;
  bool                  hasSpacing = false;
  for (std::size_t position = kept; position + 12 <= bytes.size();)
  {
    const Bytes            view(bytes);
    const std::size_t      count = BigEndian32(view, position);
    const std::size_t      length = std::min(count + 12, bytes.size() - position);
    const std::string_view type = view.substr(position + 4, 4);
    bool                   isKept = type == "IHDR" || type == "IDAT" || type == "IEND";
    hasData = hasData || type == "IDAT";
    // What libpng finds odd it prints: a palette of no use, values beyond the largest, what is there twice or too late.
    if (type == "PLTE")
    {
      isKept = bytes[kind] == 3;
      colours = count / 3;
    }
    else if (type == "pHYs")
    {
      isKept = count == 9 && !hasSpacing && !hasData;
      hasSpacing = hasSpacing || isKept;
    }
    else if (type == "tRNS" && hasTransparency && !hasData)
    {
      const auto isInRange = [&view, position, largest](std::size_t i) {
        return (unsigned{ view[position + 8 + 2 * i] } << 8) + view[position + 9 + 2 * i] <= largest;
      };
      isKept = bytes[kind] == 0   ? count == 2 && isInRange(0)
               : bytes[kind] == 2 ? count == 6 && isInRange(0) && isInRange(1) && isInRange(2)
                                  : bytes[kind] == 3 && count > 0 && count <= colours;
      hasTransparency = !isKept;
    }
    if (isKept)
    {
      // In place and forward, so that any number of chunks is one walk.
      std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(position),
                  length,
                  bytes.begin() + static_cast<std::ptrdiff_t>(kept));
      kept += length;
    }
    position += length;
  }
  bytes.resize(kept);
}

void
VerifyRadiographFileIsComplete(const std::string &      fileName,
                               std::string &            bytes,
                               RadiographFileFormatEnum format,
                               std::size_t              maximumNumberOfPixels)
{
  if (format == Format::MetaImage)
  {
    VerifyMetaImage(fileName, bytes);
    return;
  }
  if (format == Format::NIfTI)
  {
    NiftiPictureIO::Verify(fileName, bytes);
    return;
  }
  if (format == Format::DICOM)
  {
    VerifyDicomFile(fileName, bytes);
    return;
  }
  if (format == Format::NRRD)
  {
    VerifyNrrd(fileName, bytes);
    return;
  }
  const Bytes view(bytes);
  bool        complete = true;
  switch (format)
  {
    case Format::PNG:
      complete = PNGIsComplete(view);
      break;
    case Format::JPEG:
      complete = JPEGIsComplete(view);
      break;
    case Format::TIFF:
      complete = TIFFIsComplete(view);
      break;
    default:
      complete = BMPIsComplete(view);
  }
  if (complete && format == Format::JPEG)
  {
    const std::string defect =
      FindDefectOfJPEG(reinterpret_cast<const unsigned char *>(bytes.data()), bytes.size(), maximumNumberOfPixels);
    if (!defect.empty())
    {
      itkDentalInputErrorMacro(fileName, "", "the JPEG file " + defect, "copy or export it again");
    }
  }
  if (!complete)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             std::string("the ") + ToString(format) + " file of " + std::to_string(bytes.size()) +
                               " bytes is truncated or damaged",
                             "copy or export it again");
  }
}

std::string
GetRadiographTextHeader(std::string_view bytes)
{
  constexpr std::size_t longest = std::size_t{ 1 } << 16;
  std::string           header;
  for (const char byte : LowerCase(std::string(bytes.substr(0, longest))))
  {
    // A NRRD's header ends with an empty line, a MetaImage's with the line of its data file.
    if (byte == '\n' && (header.empty() || header.back() == '\n' ||
                         header.find("elementdatafile", header.rfind('\n') + 1) != std::string::npos))
    {
      break;
    }
    if (byte != '\r')
    {
      header += byte;
    }
  }
  return header + '\n';
}
} // namespace itk
