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
#include "itkTIFFLayout.h"

#include "itkMacro.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

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

/** Leaves the file at its first directory. */
unsigned int
CountPages(TIFF * file)
{
  unsigned int pages = 0;
  do
  {
    std::uint32_t type = 0;
    TIFFGetFieldDefaulted(file, TIFFTAG_SUBFILETYPE, &type);
    pages += (type & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) == 0 ? 1 : 0;
  } while (TIFFReadDirectory(file) == 1);
  TIFFSetDirectory(file, 0);
  return pages;
}

TIFFLayout
ReadLayout(TIFF * file)
{
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t bits = 1;
  std::uint16_t samples = 1;
  std::uint16_t format = SAMPLEFORMAT_UINT;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
  std::uint16_t planes = PLANARCONFIG_CONTIG;
  TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(file, TIFFTAG_IMAGELENGTH, &height);
  TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &samples);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &format);
  TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &photometric);
  TIFFGetFieldDefaulted(file, TIFFTAG_ORIENTATION, &orientation);
  TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &planes);
  TIFFLayout layout;
  layout.width = width;
  layout.height = height;
  layout.bits = bits;
  layout.samples = samples;
  layout.isInterleaved = planes == PLANARCONFIG_CONTIG;
  layout.isInteger = format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_INT;
  layout.isSigned = format == SAMPLEFORMAT_INT;
  layout.isPalette = photometric == PHOTOMETRIC_PALETTE;
  layout.isWhiteIsZero = photometric == PHOTOMETRIC_MINISWHITE;
  layout.isGrey = layout.isWhiteIsZero || photometric == PHOTOMETRIC_MINISBLACK;
  // What is no orientation is as good as none.
  layout.orientation = orientation >= 1 && orientation <= 8 ? orientation : 1;
  return layout;
}

std::optional<TIFFLayout>
ReadTIFFLayout(const std::string & fileName)
{
  const SilentTIFF  silent;
  const FilePointer file = Open(fileName);
  if (!file)
  {
    return std::nullopt;
  }
  TIFFLayout layout = ReadLayout(file.get());
  layout.pages = CountPages(file.get());
  return layout;
}

void
ReadTIFFNumbers(const std::string & fileName, const TIFFLayout & expected, char * values)
{
  const SilentTIFF  silent;
  const FilePointer file = Open(fileName);
  const TIFFLayout  layout = file ? ReadLayout(file.get()) : TIFFLayout();
  const std::size_t width = layout.width;
  const std::size_t height = layout.height;
  const std::size_t bytes = layout.bits / 8 * layout.samples;
  if (!file || !layout.HasNumbers() || width != expected.width || height != expected.height ||
      layout.bits != expected.bits || layout.samples != expected.samples)
  {
    itkGenericExceptionMacro("no TIFF of " << expected.width << " x " << expected.height << " whole numbers");
  }
  if (TIFFIsTiled(file.get()))
  {
    std::uint32_t tileWidth = 0, tileHeight = 0;
    TIFFGetField(file.get(), TIFFTAG_TILEWIDTH, &tileWidth);
    TIFFGetField(file.get(), TIFFTAG_TILELENGTH, &tileHeight);
    const auto tileSize = static_cast<std::size_t>(std::max<tmsize_t>(TIFFTileSize(file.get()), 0));
    if (tileWidth == 0 || tileHeight == 0 || tileSize / bytes / tileWidth < tileHeight)
    {
      itkGenericExceptionMacro("its tiles have no size");
    }
    // A small picture may be the corner of one tile; one of gigabytes is none of its programs'.
    if (tileSize > std::max(2 * width * height * bytes, std::size_t{ 1 } << 24))
    {
      itkGenericExceptionMacro("its tiles are far larger than the picture");
    }
    std::vector<char> tile(tileSize);
    for (std::size_t y = 0; y < height; y += tileHeight)
    {
      for (std::size_t x = 0; x < width; x += tileWidth)
      {
        if (TIFFReadTile(file.get(), tile.data(), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0) <
            0)
        {
          itkGenericExceptionMacro("a tile cannot be read");
        }
        const std::size_t columns = std::min<std::size_t>(tileWidth, width - x);
        for (std::size_t j = 0; j < std::min<std::size_t>(tileHeight, height - y); ++j)
        {
          std::copy_n(tile.data() + j * tileWidth * bytes, columns * bytes, values + ((y + j) * width + x) * bytes);
        }
      }
    }
    return;
  }
  if (TIFFScanlineSize(file.get()) < static_cast<tmsize_t>(width * bytes))
  {
    itkGenericExceptionMacro("its rows have no size");
  }
  std::vector<char> row(static_cast<std::size_t>(TIFFScanlineSize(file.get())));
  for (std::size_t y = 0; y < height; ++y)
  {
    if (TIFFReadScanline(file.get(), row.data(), static_cast<std::uint32_t>(y), 0) < 0)
    {
      itkGenericExceptionMacro("row " << y << " cannot be read");
    }
    std::copy_n(row.data(), width * bytes, values + y * width * bytes);
  }
}
} // namespace
} // namespace itk

const itk::TIFFReader *
DentalSCRGetTIFFReader()
{
  static const itk::TIFFReader reader{ itk::ReadTIFFLayout, itk::ReadTIFFNumbers };
  return &reader;
}
