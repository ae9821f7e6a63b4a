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
#ifndef itkTIFFLayout_h
#define itkTIFFLayout_h

#include <cstddef>
#include <optional>
#include <string>

namespace itk
{
/** Not installed. What the first directory of a TIFF says of its pixels; BigTIFF too. */
struct TIFFLayout
{
  std::size_t width{ 0 };
  std::size_t height{ 0 };
  /** Directories that are neither a reduced copy nor a mask of another one. */
  unsigned int pages{ 1 };
  unsigned int bits{ 1 };
  unsigned int samples{ 1 };
  /** Whether the samples of a pixel stand side by side; else each has a plane of its own. */
  bool isInterleaved{ true };
  bool isInteger{ true };
  bool isSigned{ false };
  bool isPalette{ false };
  bool isWhiteIsZero{ false };
  /** Neither is one of colours, which have to be computed. */
  bool isGrey{ false };
  /** How to turn the picture to see it upright: 1, as it is, to 8. */
  unsigned int orientation{ 1 };

  /** Whether a pixel is a whole number of 8, 16 or 32 bits, of up to 16 perhaps with its opacity: what
   * ReadTIFFNumbers() reads. ITK 5.2 makes 8 bits of 16 where such a picture has tiles or is turned, noughts of 32, and
   * takes opacities for pixels.
   */
  bool
  HasNumbers() const
  {
    const bool isOne = samples == 1 && (isGrey || isPalette);
    const bool hasOpacity = samples == 2 && isGrey && isInterleaved && bits <= 16;
    return (isOne || hasOpacity) && isInteger && (bits == 8 || bits == 16 || bits == 32);
  }

  /** Whether ReadTIFFNumbers() reads it, and not ITK, which makes colours of it. \param expandsPalette  the number of a
   * palette's colour is not wanted, but the colour */
  bool
  IsReadAsNumbers(bool expandsPalette) const
  {
    return this->HasNumbers() && (isGrey || !expandsPalette);
  }

  /** Whether a whole number has more bits than any here reads: ITK 5.2 opens no such file. */
  bool
  IsOfMoreBits() const
  {
    return isInteger && bits > 32;
  }

  /** Whether it is grey with values a pixel that nothing here reads: ITK takes those of one pixel for those of several.
   */
  bool
  IsOfUnreadValues() const
  {
    return isGrey && samples > 1 && !this->HasNumbers();
  }
};

/** \struct TIFFReader
 * \brief What is wanted of libtiff, in a library of its own: it brings seven libraries of codecs, and few radiographs
 * are TIFF files, so that the decoder loads it for one alone. */
struct TIFFReader
{
  /** None where libtiff cannot open the file. */
  std::optional<TIFFLayout> (*readLayout)(const std::string & fileName);
  /** The numbers of such a file as it has them, row by row, those of a pixel side by side; there has to be room for all
   * of them. Throws an ExceptionObject where the file is not whole or has become another one. */
  void (*readNumbers)(const std::string & fileName, const TIFFLayout & layout, char * values);
};

/** Loads libtiff on the first call, for as long as the process lasts. Throws an ExceptionObject where it cannot. */
const TIFFReader &
LoadTIFFReader();
} // namespace itk

extern "C" __attribute__((visibility("default"))) const itk::TIFFReader *
DentalSCRGetTIFFReader();

#endif
