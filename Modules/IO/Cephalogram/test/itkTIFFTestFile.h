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
#ifndef itkTIFFTestFile_h
#define itkTIFFTestFile_h

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace itk
{
/** A TIFF in little endian without compression, written byte by byte: ITK's writer knows no orientation, tiles, zero
 * for white or whole numbers of 32 bits. */
struct TIFFTestFile
{
  unsigned int width{ 3 };
  unsigned int height{ 2 };
  unsigned int bits{ 8 };
  unsigned int samples{ 1 };
  /** 1 unsigned, 2 signed, 3 floating point. */
  unsigned int sampleFormat{ 1 };
  /** 0 white is zero, 1 black is zero, 2 colours, 3 a palette, whose colours are made up. */
  unsigned int photometric{ 1 };
  unsigned int orientation{ 1 };
  /** Of the same pixels. */
  unsigned int pages{ 1 };
  /** One tile that is larger than the picture, in place of one strip. */
  bool tiled{ false };
  /** Offsets of 64 bits. */
  bool big{ false };

  static void
  Append(std::string & bytes, std::uint64_t value, unsigned int count)
  {
    for (unsigned int i = 0; i < count; ++i)
    {
      bytes += static_cast<char>((value >> (8 * i)) & 255u);
    }
  }

  /** The file; value(u, v) gives the bits of all samples of the file's pixel (u, v). */
  template <typename TFunction>
  std::string
  Make(const TFunction & value) const
  {
    const unsigned int columns = tiled ? (width + 15) / 16 * 16 : width;
    const unsigned int rows = tiled ? (height + 15) / 16 * 16 : height;
    std::string        pixels;
    for (unsigned int v = 0; v < rows; ++v)
    {
      for (unsigned int u = 0; u < columns; ++u)
      {
        const std::uint64_t sample = u < width && v < height ? static_cast<std::uint64_t>(value(u, v)) : 0u;
        for (unsigned int i = 0; i < samples; ++i)
        {
          Append(pixels, sample, bits / 8);
        }
      }
    }
    const unsigned int  wide = big ? 8 : 4;
    const std::uint64_t start = big ? 16 : 8;
    std::string         colours;
    for (unsigned int i = 0; photometric == 3 && i < 3u << bits; ++i)
    {
      Append(colours, 257 * (i % 200), 2);
    }
    std::vector<std::array<std::uint64_t, 4>> tags = { { 256, 3, 1, width },       { 257, 3, 1, height },
                                                       { 258, 3, 1, bits },        { 259, 3, 1, 1 },
                                                       { 262, 3, 1, photometric }, { 274, 3, 1, orientation },
                                                       { 277, 3, 1, samples } };
    if (tiled)
    {
      tags.insert(tags.end(),
                  { { 322, 3, 1, columns }, { 323, 3, 1, rows }, { 324, 4, 1, start }, { 325, 4, 1, pixels.size() } });
    }
    else
    {
      tags.insert(tags.begin() + 6, { 273, 4, 1, start });
      tags.insert(tags.end(), { { 278, 3, 1, rows }, { 279, 4, 1, pixels.size() } });
    }
    if (photometric == 3)
    {
      tags.insert(tiled ? tags.begin() + 7 : tags.end(), { 320, 3, colours.size() / 2, start + pixels.size() });
    }
    if (samples == 2 || samples == 4)
    {
      tags.push_back({ 338, 3, 1, 2 });
    }
    tags.push_back({ 339, 3, 1, sampleFormat });

    std::string file = big ? std::string("II+\0\x08\0\0\0", 8) : std::string("II*\0", 4);
    Append(file, start + pixels.size() + colours.size(), wide);
    file += pixels + colours;
    for (unsigned int page = 1; page <= pages; ++page)
    {
      Append(file, tags.size(), big ? 8 : 2);
      for (const auto & tag : tags)
      {
        Append(file, tag[0], 2);
        Append(file, tag[1], 2);
        Append(file, tag[2], wide);
        Append(file, tag[3], wide);
      }
      Append(file, page == pages ? 0 : file.size() + wide, wide);
    }
    return file;
  }
};
} // namespace itk

#endif
