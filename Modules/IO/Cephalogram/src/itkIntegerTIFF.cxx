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
#include "itkIntegerTIFF.h"

#include "itkMacro.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>

namespace itk
{
namespace
{
/** libtiff prints; a library does not. */
class SilentTIFF
{
public:
  SilentTIFF()
    : m_Warning(TIFFSetWarningHandler(nullptr))
    , m_Error(TIFFSetErrorHandler(nullptr))
  {}
  ~SilentTIFF()
  {
    TIFFSetWarningHandler(m_Warning);
    TIFFSetErrorHandler(m_Error);
  }
  SilentTIFF(const SilentTIFF &) = delete;
  SilentTIFF &
  operator=(const SilentTIFF &) = delete;

private:
  TIFFErrorHandler m_Warning;
  TIFFErrorHandler m_Error;
};

using FilePointer = std::unique_ptr<TIFF, void (*)(TIFF *)>;

FilePointer
Open(const std::string & fileName)
{
  // Not mapped into memory: a file that shrinks meanwhile must not end the program.
  return FilePointer(TIFFOpen(fileName.c_str(), "rm"), TIFFClose);
}

struct Layout
{
  std::uint32_t width{ 0 };
  std::uint32_t height{ 0 };
  std::uint16_t bits{ 1 };
  std::uint16_t samples{ 1 };
  std::uint16_t format{ SAMPLEFORMAT_UINT };
};

Layout
ReadLayout(TIFF * file)
{
  Layout layout;
  TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &layout.width);
  TIFFGetField(file, TIFFTAG_IMAGELENGTH, &layout.height);
  TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &layout.bits);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &layout.samples);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &layout.format);
  return layout;
}

bool
IsInteger(const Layout & layout)
{
  return layout.bits == 32 && layout.samples == 1 &&
         (layout.format == SAMPLEFORMAT_UINT || layout.format == SAMPLEFORMAT_INT);
}

template <typename TValue>
double
At(const unsigned char * bytes, std::size_t i)
{
  TValue value;
  std::memcpy(&value, bytes + i * sizeof(TValue), sizeof(TValue));
  return static_cast<double>(value);
}

double
GetValue(const Layout & layout, const unsigned char * bytes, std::size_t i)
{
  return layout.format == SAMPLEFORMAT_INT ? At<std::int32_t>(bytes, i) : At<std::uint32_t>(bytes, i);
}
} // namespace

bool
IsIntegerTIFF(const std::string & fileName)
{
  char head[4] = { 0, 0, 0, 0 };
  std::ifstream(fileName, std::ios::binary).read(head, 4);
  const bool littleEndian = head[0] == 'I' && head[1] == 'I' && (head[2] == '*' || head[2] == '+');
  const bool bigEndian = head[0] == 'M' && head[1] == 'M' && (head[3] == '*' || head[3] == '+');
  if (!littleEndian && !bigEndian)
  {
    return false;
  }
  const SilentTIFF  silent;
  const FilePointer file = Open(fileName);
  return file && IsInteger(ReadLayout(file.get()));
}

std::vector<double>
ReadIntegerTIFF(const std::string & fileName, std::size_t width, std::size_t height)
{
  const SilentTIFF  silent;
  const FilePointer file = Open(fileName);
  const Layout      layout = file ? ReadLayout(file.get()) : Layout();
  if (!file || !IsInteger(layout) || layout.width != width || layout.height != height)
  {
    itkGenericExceptionMacro("no TIFF of " << width << " x " << height << " whole numbers");
  }
  std::vector<double> values(width * height);
  if (TIFFIsTiled(file.get()))
  {
    std::uint32_t tileWidth = 0, tileHeight = 0;
    TIFFGetField(file.get(), TIFFTAG_TILEWIDTH, &tileWidth);
    TIFFGetField(file.get(), TIFFTAG_TILELENGTH, &tileHeight);
    const auto tileSize = static_cast<std::size_t>(std::max<tmsize_t>(TIFFTileSize(file.get()), 0));
    // No tile is larger than the largest radiograph.
    if (tileWidth == 0 || tileHeight == 0 || tileSize > (std::size_t{ 1 } << 29) ||
        tileSize / (layout.bits / 8) / tileWidth < tileHeight)
    {
      itkGenericExceptionMacro("its tiles have no size");
    }
    std::vector<unsigned char> tile(tileSize);
    for (std::uint32_t y = 0; y < height; y += tileHeight)
    {
      for (std::uint32_t x = 0; x < width; x += tileWidth)
      {
        if (TIFFReadTile(file.get(), tile.data(), x, y, 0, 0) < 0)
        {
          itkGenericExceptionMacro("a tile cannot be read");
        }
        for (std::size_t j = 0; j < std::min<std::size_t>(tileHeight, height - y); ++j)
        {
          for (std::size_t i = 0; i < std::min<std::size_t>(tileWidth, width - x); ++i)
          {
            values[(y + j) * width + x + i] = GetValue(layout, tile.data(), j * tileWidth + i);
          }
        }
      }
    }
    return values;
  }
  if (TIFFScanlineSize(file.get()) < static_cast<tmsize_t>(width * layout.bits / 8))
  {
    itkGenericExceptionMacro("its rows have no size");
  }
  std::vector<unsigned char> row(static_cast<std::size_t>(TIFFScanlineSize(file.get())));
  for (std::size_t y = 0; y < height; ++y)
  {
    if (TIFFReadScanline(file.get(), row.data(), static_cast<std::uint32_t>(y), 0) < 0)
    {
      itkGenericExceptionMacro("row " << y << " cannot be read");
    }
    for (std::size_t x = 0; x < width; ++x)
    {
      values[y * width + x] = GetValue(layout, row.data(), x);
    }
  }
  return values;
}
} // namespace itk
