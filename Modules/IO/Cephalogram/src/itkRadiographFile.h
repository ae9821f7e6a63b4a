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
#ifndef itkRadiographFile_h
#define itkRadiographFile_h

#include "itkMemoryFile.h"
#include "itkRadiographFileFormat.h"
#include "itkTIFFLayout.h"

#include "itkImageIOBase.h"
#include "itkSize.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** \class RadiographFile
 * \brief Not installed. A file of pixels in the grid of a radiograph: what has to be checked and known before a pixel
 * of it can be trusted, whether it is the radiograph itself or a label map or mask of it.
 *
 * The file is read once, into memory, and what is decoded are the bytes that were checked: by its name another one
 * could be opened meanwhile. Opening decodes no pixel. The picture is upright, as viewers show it: the file's
 * orientation (TIFF, Exif in a JPEG) is applied here and nowhere else. Numbers are those of the file, but for what ITK
 * makes of a TIFF in colours.
 *
 * Throws DentalInputError for what CephalogramFileReader says.
 */
class RadiographFile
{
public:
  /** What a pixel of a palette is: the colour that it shows, or its number, which is what a label is. */
  enum class PaletteEnum : std::uint8_t
  {
    Colours,
    Numbers
  };
  using RowFunctionType = std::function<void(const double *)>;

  RadiographFile(const std::string & fileName, PaletteEnum palette);

  RadiographFileFormatEnum
  GetFormat() const
  {
    return m_Format;
  }
  /** Columns and rows of the upright picture. */
  const Size<2> &
  GetSize() const
  {
    return m_Size;
  }
  /** As the file states it: 1, upright, to 8. */
  unsigned int
  GetOrientation() const
  {
    return m_Orientation;
  }
  /** Whether the file states that 0 is white. */
  bool
  IsWhiteIsZero() const
  {
    return m_TIFF && m_TIFF->isWhiteIsZero;
  }
  /** Whether its pixels are therefore a negative: of those that ITK makes colours of it is done. */
  bool
  IsNegative() const
  {
    return this->IsWhiteIsZero() && m_Components <= 2;
  }
  /** Values a pixel: 1 grey, 2 grey and opacity, 3 colour, 4 colour and opacity. */
  unsigned int
  GetNumberOfComponents() const
  {
    return m_Components;
  }
  /** Of the component type; of floating point 1. */
  double
  GetLargestValue() const;
  /** Bits of a value. */
  unsigned int
  GetDepth() const;
  /** The header of a NRRD or MetaImage as GetRadiographTextHeader() has it; "" of other formats. */
  const std::string &
  GetTextHeader() const
  {
    return m_TextHeader;
  }
  /** Whether it is the NIfTI file of an array whose directions nobody knew, which may have rows for columns. */
  bool
  IsOfPlainArray() const
  {
    return m_IsOfPlainArray;
  }
  /** For the header of formats that have one. */
  ImageIOBase *
  GetImageIO() const
  {
    return m_ImageIO;
  }

  /** The pixels as they are stored. */
  std::vector<char>
  Decode() const;
  /** Calls the function with the values of each row of the upright picture, from the top; a pixel's stand side by side.
   *
   * \param pixels What Decode() returned. */
  void
  ForEachRow(const std::vector<char> & pixels, const RowFunctionType & take) const;

private:
  void
  ReadInformation(const std::string & bytes, PaletteEnum palette);

  std::string m_FileName;
  /** What was read and checked, for decoders. */
  MemoryFile                m_Memory;
  std::string               m_TextHeader;
  RadiographFileFormatEnum  m_Format{ RadiographFileFormatEnum::PNG };
  std::optional<TIFFLayout> m_TIFF;
  ImageIOBase::Pointer      m_ImageIO;
  /** As it is stored, then upright. */
  Size<2>      m_StoredSize{ { 0, 0 } };
  Size<2>      m_Size{ { 0, 0 } };
  unsigned int m_Orientation{ 1 };
  /** Whether ITK has turned the picture already, as far as it does. */
  bool            m_IsTurnedByITK{ false };
  bool            m_IsOfPlainArray{ false };
  SizeValueType   m_Frames{ 1 };
  unsigned int    m_Components{ 1 };
  IOComponentEnum m_ComponentType{ IOComponentEnum::UNKNOWNCOMPONENTTYPE };
};
} // namespace itk

#endif
