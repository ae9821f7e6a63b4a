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
#include "itkReadLabelImage.h"

#include "itkCephalogramFileReader.h"
#include "itkDentalInputError.h"
#include "itkIntegerTIFF.h"
#include "itkRadiographFileFormat.h"
#include "itkRadiographImageIO.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace itk
{
namespace
{
/** Pixels as the file has them: interleaved components, and a palette's indices for its colours. */
struct Pixels
{
  Size<2>             size{ { 0, 0 } };
  unsigned int        components{ 1 };
  std::vector<double> values;
};

template <typename TComponent>
void
Copy(const std::vector<char> & buffer, std::vector<double> & values)
{
  const auto * source = reinterpret_cast<const TComponent *>(buffer.data());
  std::transform(
    source, source + values.size(), values.begin(), [](TComponent value) { return static_cast<double>(value); });
}

void
Copy(IOComponentEnum type, const std::vector<char> & buffer, std::vector<double> & values)
{
  switch (type)
  {
    case IOComponentEnum::UCHAR:
      return Copy<unsigned char>(buffer, values);
    case IOComponentEnum::CHAR:
      return Copy<signed char>(buffer, values);
    case IOComponentEnum::USHORT:
      return Copy<unsigned short>(buffer, values);
    case IOComponentEnum::SHORT:
      return Copy<short>(buffer, values);
    case IOComponentEnum::UINT:
      return Copy<unsigned int>(buffer, values);
    case IOComponentEnum::INT:
      return Copy<int>(buffer, values);
    case IOComponentEnum::ULONG:
      return Copy<unsigned long>(buffer, values);
    case IOComponentEnum::LONG:
      return Copy<long>(buffer, values);
    case IOComponentEnum::ULONGLONG:
      return Copy<unsigned long long>(buffer, values);
    case IOComponentEnum::LONGLONG:
      return Copy<long long>(buffer, values);
    case IOComponentEnum::FLOAT:
      return Copy<float>(buffer, values);
    case IOComponentEnum::DOUBLE:
      return Copy<double>(buffer, values);
    default:
      throw std::invalid_argument("unknown pixel type");
  }
}

Pixels
ReadPixels(const std::string & fileName)
{
  constexpr auto                 maximum = CephalogramFileReader::MaximumNumberOfPixels;
  constexpr auto                 maximumSide = CephalogramFileReader::MaximumWidthAndHeight;
  const RadiographFileFormatEnum format = DetectRadiographFileFormat(fileName);
  VerifyRadiographFileIsComplete(fileName, format, maximum);
  const ImageIOBase::Pointer io = MakeRadiographImageIO(format);
  io->SetFileName(fileName);
  io->SetExpandRGBPalette(false);
  CallRadiographImageIO(fileName, ToString(format), [&io] { io->ReadImageInformation(); });
  Pixels        pixels;
  ImageIORegion region(io->GetNumberOfDimensions());
  for (unsigned int i = 0; i < io->GetNumberOfDimensions(); ++i)
  {
    region.SetIndex(i, 0);
    region.SetSize(i, io->GetDimensions(i));
    if (i < 2)
    {
      pixels.size[i] = io->GetDimensions(i);
    }
    else if (io->GetDimensions(i) != 1)
    {
      itkDentalInputErrorMacro(fileName,
                               "",
                               "has " + std::to_string(io->GetDimensions(i)) + " frames, pages or slices",
                               "export the labels of the one radiograph");
    }
  }
  if (pixels.size[0] == 0 || pixels.size[1] == 0 || pixels.size[0] > maximumSide || pixels.size[1] > maximumSide ||
      pixels.size[0] > maximum / pixels.size[1])
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "is an image of " + std::to_string(pixels.size[0]) + " x " +
                               std::to_string(pixels.size[1]) + " pixels, which no cephalogram has",
                             "export it again");
  }
  CallRadiographImageIO(fileName, ToString(format), [&] {
    if (IsIntegerTIFF(fileName))
    {
      pixels.values = ReadIntegerTIFF(fileName, pixels.size[0], pixels.size[1]);
      return;
    }
    io->SetIORegion(region);
    std::vector<char> buffer(static_cast<std::size_t>(io->GetImageSizeInBytes()), 0);
    io->Read(buffer.data());
    pixels.components = io->GetNumberOfComponents();
    pixels.values.resize(pixels.size[0] * pixels.size[1] * pixels.components);
    if (buffer.size() < pixels.values.size() * io->GetComponentSize())
    {
      throw std::invalid_argument("its pixels are not whole");
    }
    Copy(io->GetComponentType(), buffer, pixels.values);
  });
  return pixels;
}

template <typename TImage>
typename TImage::Pointer
MakeImage(const Size<2> & size)
{
  auto image = TImage::New();
  image->SetRegions(typename TImage::RegionType(size));
  image->Allocate(true);
  return image;
}

/** A pixel's brightness; an alpha beside it does not count. */
double
ComputeLuminance(const Pixels & pixels, std::size_t i)
{
  const double * value = pixels.values.data() + i * pixels.components;
  return pixels.components >= 3 ? 0.2126 * value[0] + 0.7152 * value[1] + 0.0722 * value[2] : value[0];
}
} // namespace

Image<std::uint16_t, 2>::Pointer
ReadLabelImage(const std::string & fileName)
{
  if (DetectRadiographFileFormat(fileName) == RadiographFileFormatEnum::JPEG)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "is a JPEG picture, which does not keep the numbers of labels",
                             "save the label map as PNG or TIFF");
  }
  const Pixels pixels = ReadPixels(fileName);
  const auto   image = MakeImage<Image<std::uint16_t, 2>>(pixels.size);
  for (std::size_t i = 0; i < pixels.size[0] * pixels.size[1]; ++i)
  {
    const double * value = pixels.values.data() + i * pixels.components;
    if (pixels.components >= 3 && (value[0] != value[1] || value[0] != value[2]))
    {
      itkDentalInputErrorMacro(
        fileName,
        "",
        "is a picture in colours, which are no tooth numbers",
        "save the labels as grey or palette image, or name one mask a tooth: \"contours\": {\"UR1\": \"mask.png\"}");
    }
    if (!(value[0] >= 0.0 && value[0] <= 65535.0 && value[0] == std::floor(value[0])))
    {
      std::ostringstream problem;
      problem << "has a pixel of value " << value[0] << ", which is no label";
      itkDentalInputErrorMacro(fileName, "", problem.str(), "labels are whole numbers, 0 where there is no tooth");
    }
    image->GetBufferPointer()[i] = static_cast<std::uint16_t>(value[0]);
  }
  return image;
}

Image<std::uint8_t, 2>::Pointer
ReadMaskImage(const std::string & fileName)
{
  const Pixels      pixels = ReadPixels(fileName);
  const std::size_t count = pixels.size[0] * pixels.size[1];
  double            low = ComputeLuminance(pixels, 0);
  double            high = low;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double value = ComputeLuminance(pixels, i);
    if (!std::isfinite(value))
    {
      itkDentalInputErrorMacro(fileName, "", "has pixels that are not finite (NaN or Inf)", "export it again");
    }
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!(high > low))
  {
    itkDentalInputErrorMacro(fileName, "", "has nothing drawn: all its pixels are alike", "name the mask of a tooth");
  }
  // Smoothed edges and thin lines have tones between: half way is where a pixel is half covered.
  const double level = 0.5 * (low + high);
  std::size_t  bright = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    bright += ComputeLuminance(pixels, i) > level ? 1 : 0;
  }
  const bool drawnIsBright = 2 * bright <= count;
  const auto image = MakeImage<Image<std::uint8_t, 2>>(pixels.size);
  for (std::size_t i = 0; i < count; ++i)
  {
    image->GetBufferPointer()[i] = (ComputeLuminance(pixels, i) > level) == drawnIsBright ? 1 : 0;
  }
  return image;
}

bool
IsImageFile(const std::string & fileName)
{
  try
  {
    DetectRadiographFileFormat(fileName);
    return true;
  }
  catch (const DentalInputError &)
  {
    return false;
  }
}
} // namespace itk
