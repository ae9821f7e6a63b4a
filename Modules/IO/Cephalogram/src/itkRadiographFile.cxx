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
#include "itkRadiographFile.h"

#include "itkCephalogramFileReader.h"
#include "itkDentalInputError.h"
#include "itkExifOrientation.h"
#include "itkNiftiPictureIO.h"
#include "itkPictureSizeCheck.h"
#include "itkRadiographImageIO.h"
#include "itkTIFFLayoutEntry.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace itk
{
namespace
{
using Format = RadiographFileFormatEnum;

/** From 5 on rows are columns. */
bool
IsTransposed(unsigned int orientation)
{
  return orientation >= 5;
}

/** What is left to be done of a TIFF's orientation when ITK has read it: libtiff mirrors rows and columns, and never
 * exchanges them. */
unsigned int
GetOrientationBehindITK(unsigned int orientation)
{
  constexpr unsigned int left[] = { 1, 1, 1, 1, 5, 7, 5, 7 };
  return left[orientation - 1];
}

/** Where the pixels of an upright row stand among those of the file. */
struct StoredRow
{
  std::ptrdiff_t first{ 0 };
  std::ptrdiff_t step{ 1 };
  std::size_t    count{ 0 };
};

StoredRow
FindRow(const Size<2> & stored, unsigned int orientation, std::size_t v)
{
  // By the place of the file's first row and column: 1 top left, 2 top right, 3 bottom right, 4 bottom left, and
  // transposed 5 left top, 6 right top, 7 right bottom, 8 left bottom.
  const bool        transposed = IsTransposed(orientation);
  const bool        fromRight = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
  const bool        fromBottom = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
  const std::size_t columns = transposed ? stored[1] : stored[0];
  const std::size_t rows = transposed ? stored[0] : stored[1];
  const std::size_t down = fromBottom ? rows - 1 - v : v;
  const std::size_t across = fromRight ? columns - 1 : 0;
  const auto        step = static_cast<std::ptrdiff_t>(transposed ? stored[0] : 1);
  StoredRow         row;
  row.first = static_cast<std::ptrdiff_t>(transposed ? across * stored[0] + down : down * stored[0] + across);
  row.step = fromRight ? -step : step;
  row.count = columns;
  return row;
}

template <typename TComponent>
void
CopyRow(const char * pixels, const StoredRow & row, unsigned int components, double * values)
{
  const auto *         source = reinterpret_cast<const TComponent *>(pixels) + row.first * components;
  const std::ptrdiff_t step = row.step * components;
  for (std::size_t i = 0; i < row.count; ++i, source += step, values += components)
  {
    std::transform(source, source + components, values, [](TComponent value) { return static_cast<double>(value); });
  }
}

struct ComponentTraits
{
  /** Null for what is no number. */
  void (*copy)(const char *, const StoredRow &, unsigned int, double *){ nullptr };
  double       largest{ 1.0 };
  unsigned int bits{ 0 };
};

template <typename TComponent>
ComponentTraits
MakeTraits()
{
  return { CopyRow<TComponent>,
           std::is_floating_point<TComponent>::value ? 1.0
                                                     : static_cast<double>(std::numeric_limits<TComponent>::max()),
           8 * sizeof(TComponent) };
}

ComponentTraits
GetTraits(IOComponentEnum type)
{
  switch (type)
  {
    case IOComponentEnum::UCHAR:
      return MakeTraits<unsigned char>();
    case IOComponentEnum::CHAR:
      return MakeTraits<signed char>();
    case IOComponentEnum::USHORT:
      return MakeTraits<unsigned short>();
    case IOComponentEnum::SHORT:
      return MakeTraits<short>();
    case IOComponentEnum::UINT:
      return MakeTraits<unsigned int>();
    case IOComponentEnum::INT:
      return MakeTraits<int>();
    case IOComponentEnum::ULONG:
      return MakeTraits<unsigned long>();
    case IOComponentEnum::LONG:
      return MakeTraits<long>();
    case IOComponentEnum::ULONGLONG:
      return MakeTraits<unsigned long long>();
    case IOComponentEnum::LONGLONG:
      return MakeTraits<long long>();
    case IOComponentEnum::FLOAT:
      return MakeTraits<float>();
    case IOComponentEnum::DOUBLE:
      return MakeTraits<double>();
    default:
      return ComponentTraits();
  }
}
} // namespace

RadiographFile::RadiographFile(const std::string & fileName, PaletteEnum palette)
  : m_FileName(fileName)
{
  {
    std::string bytes = ReadRadiographBytes(fileName);
    m_Format = DetectRadiographFileFormat(fileName, bytes);
    VerifyRadiographFileIsComplete(fileName, bytes, m_Format, CephalogramFileReader::MaximumNumberOfPixels);
    if (m_Format == Format::JPEG || m_Format == Format::PNG)
    {
      m_Orientation = ReadExifOrientation(bytes);
    }
    if (m_Format == Format::PNG)
    {
      KeepChunksOfPixels(bytes, palette == PaletteEnum::Colours);
    }
    if (bytes.size() > MemoryFile::GetLargestSize())
    {
      itkDentalInputErrorMacro(fileName,
                               "",
                               "cannot be read: it is longer than a file of this process may be, in memory, too",
                               "raise the limit on the size of files (ulimit -f)");
    }
    CallRadiographImageIO(fileName, ToString(m_Format), [&] {
      m_Memory.SetContent(bytes);
      this->ReadInformation(bytes, palette);
    });
  }
  VerifyPictureSize(m_FileName, m_StoredSize, m_Frames, SizeValueType{ m_Components } * this->GetDepth() / 8);
  if (m_Components > 1 && m_TextHeader.find("\nsegment0_") != std::string::npos)
  {
    itkDentalInputErrorMacro(fileName,
                             "Segment0_Layer",
                             "has segments that overlap, in " + std::to_string(m_Components) + " layers",
                             "export them from 3D Slicer as one label map, or one file a segment: \"contours\": "
                             "{\"UR1\": \"ur1.nrrd\"}");
  }
  const bool mayHaveAlphaAlone = m_Format == Format::PNG || m_Format == Format::TIFF;
  if (m_Components != 1 && m_Components != 3 && m_Components != 4 && !(m_Components == 2 && mayHaveAlphaAlone))
  {
    itkDentalInputErrorMacro(
      fileName, "", "has " + std::to_string(m_Components) + " values a pixel", "export it in grey or in RGB");
  }
  m_Size = m_StoredSize;
  if (IsTransposed(m_Orientation))
  {
    std::swap(m_Size[0], m_Size[1]);
  }
}

void
RadiographFile::ReadInformation(const std::string & bytes, PaletteEnum palette)
{
  if (m_Format == Format::NRRD || m_Format == Format::MetaImage)
  {
    m_TextHeader = GetRadiographTextHeader(bytes);
  }
  m_IsOfPlainArray = m_Format == Format::NIfTI && NiftiPictureIO::IsOfPlainArray(bytes);
  m_ImageIO = MakeRadiographImageIO(m_Format, m_Memory);
  m_ImageIO->SetExpandRGBPalette(palette == PaletteEnum::Colours);
  m_ImageIO->ReadImageInformation();
  if (m_Format == Format::TIFF)
  {
    m_TIFF = FindTIFFLayout(m_ImageIO->GetMetaDataDictionary());
    m_Orientation = m_TIFF ? m_TIFF->orientation : 1;
    m_IsTurnedByITK = !m_TIFF || !m_TIFF->IsReadAsNumbers(palette == PaletteEnum::Colours);
    if (m_TIFF && m_TIFF->IsOfMoreBits())
    {
      // numpy's whole numbers, where nobody says otherwise.
      itkDentalInputErrorMacro(m_FileName,
                               "BitsPerSample",
                               "is " + std::to_string(m_TIFF->bits) + ", and whole numbers of up to 32 bits are read",
                               "save it with 8, 16 or 32 bits (numpy: astype(\"uint16\"))");
    }
    if (m_TIFF && m_TIFF->IsOfUnreadValues())
    {
      itkDentalInputErrorMacro(m_FileName,
                               "",
                               "is grey with " + std::to_string(m_TIFF->samples) +
                                 " values a pixel of a kind that is not read",
                               "export it in grey alone");
    }
  }
  for (unsigned int i = 0; i < m_ImageIO->GetNumberOfDimensions(); ++i)
  {
    const SizeValueType count = m_ImageIO->GetDimensions(i);
    if (i < 2)
    {
      m_StoredSize[i] = count;
    }
    else if (count > 1)
    {
      m_Frames = count;
    }
  }
  m_Components = m_ImageIO->GetNumberOfComponents();
  m_ComponentType = m_ImageIO->GetComponentType();
}

double
RadiographFile::GetLargestValue() const
{
  return GetTraits(m_ComponentType).largest;
}

unsigned int
RadiographFile::GetDepth() const
{
  return GetTraits(m_ComponentType).bits;
}

std::vector<char>
RadiographFile::Decode() const
{
  std::vector<char> pixels;
  CallRadiographImageIO(m_FileName, ToString(m_Format), [&] {
    if (GetTraits(m_ComponentType).copy == nullptr)
    {
      throw std::invalid_argument("unknown pixel type");
    }
    const unsigned int dimensions = m_ImageIO->GetNumberOfDimensions();
    ImageIORegion      region(dimensions);
    for (unsigned int i = 0; i < dimensions; ++i)
    {
      region.SetIndex(i, 0);
      region.SetSize(i, m_ImageIO->GetDimensions(i));
    }
    m_ImageIO->SetIORegion(region);
    // Zeros, so that a reader that leaves a part out leaves no memory of others.
    pixels.assign(static_cast<std::size_t>(m_ImageIO->GetImageSizeInBytes()), 0);
    m_ImageIO->Read(pixels.data());
    if (pixels.size() < m_StoredSize[0] * m_StoredSize[1] * m_Components * m_ImageIO->GetComponentSize())
    {
      throw std::invalid_argument("its pixels are not whole");
    }
  });
  return pixels;
}

void
RadiographFile::ForEachRow(const std::vector<char> & pixels, const RowFunctionType & take) const
{
  const auto          copy = GetTraits(m_ComponentType).copy;
  const unsigned int  orientation = m_IsTurnedByITK ? GetOrientationBehindITK(m_Orientation) : m_Orientation;
  std::vector<double> row(m_Size[0] * m_Components);
  for (std::size_t v = 0; v < m_Size[1]; ++v)
  {
    copy(pixels.data(), FindRow(m_StoredSize, orientation, v), m_Components, row.data());
    take(row.data());
  }
}
} // namespace itk
