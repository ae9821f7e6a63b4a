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

#include "itkDentalInputError.h"
#include "itkInputFile.h"
#include "itkNiftiPictureIO.h"
#include "itkRadiographFile.h"
#include "itkRadiographText.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace itk
{
namespace
{
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
ComputeLuminance(const double * value, unsigned int components)
{
  return components >= 3 ? 0.2126 * value[0] + 0.7152 * value[1] + 0.0722 * value[2] : value[0];
}

/** Throws where a pixel is no label. */
std::uint16_t
TakeLabel(const std::string & fileName, const double * value, unsigned int components)
{
  if (components >= 3 && (value[0] != value[1] || value[0] != value[2]))
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
  return static_cast<std::uint16_t>(value[0]);
}

/** Numbers parted by a character; nothing where one of them is none. */
std::vector<double>
SplitNumbers(const std::string & text, char separator)
{
  std::vector<double> numbers;
  std::istringstream  stream(text);
  for (std::string word; std::getline(stream, word, separator);)
  {
    double number = 0.0;
    if (RadiographText::ParseNumber(word, number))
    {
      numbers.push_back(number);
    }
    else if (!RadiographText::Trim(word).empty())
    {
      return {};
    }
  }
  return numbers;
}

/** Whether it is a whole number that an index of a picture may be. */
bool
IsIndex(double number)
{
  return std::abs(number) < 1e6 && number == std::trunc(number);
}

/** What 3D Slicer writes into the header of a segmentation, "segment0_name:=ur1". */
void
ReadSegmentation(const std::string & header, LabelImageNotes & notes)
{
  std::map<std::string, std::string> names;
  std::map<std::string, std::string> labels;
  std::istringstream                 lines(header);
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t end = line.find(":=");
    if (end == std::string::npos || line.compare(0, 7, "segment") != 0)
    {
      continue;
    }
    const std::string key = line.substr(0, end);
    const std::string value = RadiographText::Trim(line.substr(end + 2));
    const std::size_t underscore = key.find('_');
    const std::string number = key.substr(0, underscore);
    const std::string field = underscore == std::string::npos ? std::string() : key.substr(underscore + 1);
    if (key == "segmentation_referenceimageextentoffset")
    {
      const std::vector<double> offset = SplitNumbers(value, ' ');
      if (offset.size() == 3 && IsIndex(offset[0]) && IsIndex(offset[1]))
      {
        notes.offset = { { static_cast<int>(offset[0]), static_cast<int>(offset[1]) } };
        notes.isPart = offset[0] != 0 || offset[1] != 0;
      }
    }
    else if (key == "segmentation_conversionparameters")
    {
      // "reference image geometry|" and a matrix of 16 numbers, then first and last index along each axis.
      const std::string word = "reference image geometry|";
      const std::size_t begin = value.find(word);
      if (begin != std::string::npos)
      {
        const std::size_t         first = begin + word.size();
        const std::vector<double> numbers = SplitNumbers(value.substr(first, value.find('|', first) - first), ';');
        const auto                isSize = [&numbers](std::size_t at) {
          return numbers[at] == 0.0 && numbers[at + 1] >= 0.0 && numbers[at + 1] < 1e6;
        };
        if (numbers.size() >= 22 && isSize(16) && isSize(18))
        {
          notes.pictureSize = { { static_cast<std::size_t>(numbers[17]) + 1,
                                  static_cast<std::size_t>(numbers[19]) + 1 } };
        }
      }
    }
    else if (field == "name")
    {
      names[number] = value;
    }
    else if (field == "labelvalue")
    {
      labels[number] = value;
    }
  }
  for (const auto & [number, label] : labels)
  {
    const std::vector<double> values = SplitNumbers(label, ' ');
    const auto                name = names.find(number);
    if (values.size() == 1 && IsIndex(values[0]) && values[0] > 0.0 && values[0] <= 65535.0 && name != names.end())
    {
      notes.segments[static_cast<std::uint16_t>(values[0])] = name->second;
    }
  }
}
} // namespace

Image<std::uint16_t, 2>::Pointer
ReadLabelImage(const std::string & fileName)
{
  LabelImageNotes notes;
  return ReadLabelImage(fileName, notes);
}

Image<std::uint16_t, 2>::Pointer
ReadLabelImage(const std::string & fileName, LabelImageNotes & notes)
{
  if (DetectRadiographFileFormat(fileName) == RadiographFileFormatEnum::JPEG)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "is a JPEG picture, which does not keep the numbers of labels",
                             "save the label map as PNG or TIFF");
  }
  const RadiographFile    file(fileName, RadiographFile::PaletteEnum::Numbers);
  const std::vector<char> pixels = file.Decode();
  const unsigned int      components = file.GetNumberOfComponents();
  const auto              image = MakeImage<Image<std::uint16_t, 2>>(file.GetSize());
  notes = LabelImageNotes();
  notes.isOfPlainArray = file.IsOfPlainArray();
  ReadSegmentation(file.GetTextHeader(), notes);
  if (notes.pictureSize[0] > 0)
  {
    notes.isPart =
      notes.isPart || notes.pictureSize[0] != file.GetSize()[0] || notes.pictureSize[1] != file.GetSize()[1];
  }
  std::uint16_t * label = image->GetBufferPointer();
  file.ForEachRow(pixels, [&](const double * values) {
    for (SizeValueType u = 0; u < file.GetSize()[0]; ++u)
    {
      *label++ = TakeLabel(fileName, values + u * components, components);
    }
  });
  return image;
}

Image<std::uint8_t, 2>::Pointer
ReadMaskImage(const std::string & fileName)
{
  const RadiographFile file(fileName, RadiographFile::PaletteEnum::Numbers);
  const unsigned int   components = file.GetNumberOfComponents();
  std::vector<float>   luminances;
  luminances.reserve(file.GetSize()[0] * file.GetSize()[1]);
  bool finite = true;
  file.ForEachRow(file.Decode(), [&](const double * values) {
    for (SizeValueType u = 0; u < file.GetSize()[0]; ++u)
    {
      luminances.push_back(static_cast<float>(ComputeLuminance(values + u * components, components)));
      finite = finite && std::isfinite(luminances.back());
    }
  });
  if (!finite)
  {
    itkDentalInputErrorMacro(fileName, "", "has pixels that are not finite (NaN or Inf)", "export it again");
  }
  const auto [low, high] = std::minmax_element(luminances.begin(), luminances.end());
  if (!(*high > *low))
  {
    itkDentalInputErrorMacro(fileName, "", "has nothing drawn: all its pixels are alike", "name the mask of a tooth");
  }
  // Smoothed edges and thin lines have tones between: half way is where a pixel is half covered.
  const double level = 0.5 * (static_cast<double>(*low) + static_cast<double>(*high));
  const auto   isBright = [level](float value) { return value > level; };
  const auto   bright = static_cast<std::size_t>(std::count_if(luminances.begin(), luminances.end(), isBright));
  const bool   drawnIsBright = 2 * bright <= luminances.size();
  const auto   image = MakeImage<Image<std::uint8_t, 2>>(file.GetSize());
  std::transform(luminances.begin(), luminances.end(), image->GetBufferPointer(), [&](float value) {
    return static_cast<std::uint8_t>(isBright(value) == drawnIsBright ? 1 : 0);
  });
  return image;
}

std::vector<double>
ComputeLabelBorderWeights(const Image<std::uint16_t, 2> *            labels,
                          const std::vector<std::array<double, 2>> & points,
                          bool                                       isUpper)
{
  const auto                  size = labels->GetLargestPossibleRegion().GetSize();
  const std::uint16_t * const pixels = labels->GetBufferPointer();
  const auto                  width = static_cast<long>(size[0]);
  const auto                  height = static_cast<long>(size[1]);
  std::vector<double>         weights(points.size(), 1.0);
  bool                        isShared = false;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    // An outline runs half-way between pixels: those beside it are within a pixel and a half.
    const long column = std::lround(points[i][0]);
    const long row = std::lround(points[i][1]);
    for (long y = std::max(row - 1, 0l); y <= std::min(row + 1, height - 1); ++y)
    {
      for (long x = std::max(column - 1, 0l); x <= std::min(column + 1, width - 1); ++x)
      {
        // FDI: the quadrants 1, 2, 5 and 6 are of the upper jaw.
        const unsigned int quadrant = pixels[y * width + x] / 10u;
        if (quadrant != 0 && (quadrant % 4 == 1 || quadrant % 4 == 2) != isUpper)
        {
          weights[i] = 0.0;
          isShared = true;
        }
      }
    }
  }
  if (!isShared)
  {
    weights.clear();
  }
  return weights;
}

bool
IsImageOfPlainArray(const std::string & fileName)
{
  try
  {
    // Its header is 348 bytes, also where it is compressed.
    const std::string head = ReadFileHead(fileName, 4096);
    return NiftiPictureIO::IsNifti(head) && NiftiPictureIO::IsOfPlainArray(head);
  }
  catch (const DentalInputError &)
  {
    return false;
  }
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
