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
#include "itkLabelImageRecords.h"

#include "itkAnnotationText.h"
#include "itkDentalInputError.h"
#include "itkDrawnLines.h"
#include "itkLowerCase.h"
#include "itkReadLabelImage.h"
#include "itkSilhouetteContourFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace itk
{
namespace
{
using LabelImageType = Image<std::uint16_t, 2>;
using MaskImageType = Image<std::uint8_t, 2>;

/** Share of a tooth's largest part below which another one is a speck that a brush left. */
constexpr double SpeckShare = 0.05;
/** Above the largest FDI number: a class that is no tooth (bone, 255), while a smaller number may be a tooth that is
 * counted in another way. */
constexpr unsigned int LargestFDI = 85;

std::array<std::size_t, 2>
GetSize(const ImageBase<2> & image)
{
  const auto size = image.GetLargestPossibleRegion().GetSize();
  return { { size[0], size[1] } };
}

/** Columns as rows. */
template <typename TImage>
typename TImage::Pointer
Transpose(const TImage * image)
{
  const auto                      size = image->GetLargestPossibleRegion().GetSize();
  const typename TImage::SizeType turned{ { size[1], size[0] } };
  const auto                      transposed = TImage::New();
  transposed->SetRegions(typename TImage::RegionType(turned));
  transposed->Allocate(true);
  for (SizeValueType y = 0; y < size[1]; ++y)
  {
    for (SizeValueType x = 0; x < size[0]; ++x)
    {
      transposed->GetBufferPointer()[x * size[1] + y] = image->GetBufferPointer()[y * size[0] + x];
    }
  }
  return transposed;
}

/** Of an array whose directions nobody knew: as [row, column] where only so it has the radiograph's size. Says what was
 * taken. */
template <typename TImage>
typename TImage::Pointer
OrientPlainArray(const std::string &                fileName,
                 const typename TImage::Pointer &   image,
                 const std::array<std::size_t, 2> & imageSize,
                 AnnotationRecords &                records)
{
  const auto size = GetSize(*image);
  const bool isTransposed = size[0] != size[1] && size[0] == imageSize[1] && size[1] == imageSize[0];
  records.warnings.push_back(fileName +
                             ": srow_x, srow_y: say nothing of how the picture lies (the affine of numpy.eye(4)); " +
                             (isTransposed ? "taken for an array [row, column], as only so it has the radiograph's size"
                                           : "taken for an array [column, row] from the picture's upper left corner"));
  return isTransposed ? Transpose<TImage>(image) : image;
}

/** Twice the area that a closed polyline encloses. */
double
ComputeArea(const DentalContour::PolylineType & polyline)
{
  double            area = 0.0;
  const std::size_t count = polyline.points.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto & a = polyline.points[i];
    const auto & b = polyline.points[(i + 1) % count];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return std::abs(area);
}

template <typename TImage>
DentalContour::PolylinesType
TraceOutlines(const TImage * image, typename SilhouetteContourFilter<TImage>::ContentEnum content)
{
  auto filter = SilhouetteContourFilter<TImage>::New();
  filter->SetInput(image);
  filter->SetContent(content);
  // Specks are left out below, where they can be counted; two large parts are two contours.
  filter->SetLargestPartOnly(false);
  filter->Update();
  return filter->GetOutput()->GetPolylines();
}

void
AppendPolyline(const std::string &                           field,
               const std::string &                           label,
               bool                                          closed,
               const std::vector<DentalContour::PointType> & points,
               AnnotationRecords &                           records)
{
  AnnotationPolyline polyline;
  polyline.field = field;
  polyline.codeField = field;
  polyline.label = label;
  polyline.closed = closed;
  for (const auto & point : points)
  {
    polyline.points.push_back({ { point[0], point[1], 0.0 } });
  }
  records.polylines.push_back(std::move(polyline));
}

/** Outlines of one thing without the specks beside it; adds its label to those that have some. */
void
AppendOutlines(const std::string &                  label,
               const DentalContour::PolylinesType & outlines,
               std::vector<std::string> &           speckled,
               AnnotationRecords &                  records)
{
  double largest = 0.0;
  for (const auto & outline : outlines)
  {
    largest = std::max(largest, ComputeArea(outline));
  }
  std::size_t specks = 0;
  for (const auto & outline : outlines)
  {
    if (ComputeArea(outline) < SpeckShare * largest)
    {
      ++specks;
      continue;
    }
    AppendPolyline("label " + label, label, true, outline.points, records);
  }
  if (specks > 0)
  {
    speckled.push_back(label);
  }
}

void
WarnOfSpecks(const std::string & fileName, const std::vector<std::string> & speckled, AnnotationRecords & records)
{
  if (!speckled.empty())
  {
    records.warnings.push_back(fileName + ": labels: specks are left out beside " + ListNames(speckled));
  }
}

/** Throws where a label may be a tooth that is counted otherwise, or where none is one; others are left out. */
void
TakeTeethAlone(const std::string & fileName, LabelImageType * image, AnnotationRecords & records)
{
  std::uint16_t * const pixels = image->GetBufferPointer();
  const std::size_t     count = image->GetLargestPossibleRegion().GetNumberOfPixels();
  std::vector<bool>     seen(std::size_t{ std::numeric_limits<std::uint16_t>::max() } + 1, false);
  for (std::size_t i = 0; i < count; ++i)
  {
    seen[pixels[i]] = true;
  }
  std::vector<std::string> others;
  std::size_t              teeth = 0;
  std::vector<bool>        foreign(seen.size(), false);
  bool                     doubtful = false;
  for (unsigned int value = 1; value < seen.size(); ++value)
  {
    if (!seen[value])
    {
      continue;
    }
    try
    {
      ToothCode code(value);
      ++teeth;
    }
    catch (const std::invalid_argument &)
    {
      others.push_back(std::to_string(value));
      foreign[value] = true;
      doubtful = doubtful || value <= LargestFDI;
    }
  }
  if (teeth == 0 && others.empty())
  {
    itkDentalInputErrorMacro(fileName, "", "has no label: all its pixels are 0", "name the label map of the teeth");
  }
  if (teeth == 0 || doubtful)
  {
    // Two tones are a mask or drawn lines, of which nothing says what they show.
    const std::string line =
      teeth + others.size() <= 2
        ? R"(save masks or drawn lines as one file a tooth or jaw: "contours": {"upper": "upper.png", "UR1": "ur1.png"})"
        : R"(map the labels to FDI numbers, or save one mask a tooth: "contours": {"UR1": "ur1.png"})";
    itkDentalInputErrorMacro(fileName, "", "has labels that are no FDI tooth numbers: " + ListNames(others), line);
  }
  if (!others.empty())
  {
    records.warnings.push_back(fileName + ": labels: no teeth, left out: " + ListNames(others));
    std::replace_if(
      pixels, pixels + count, [&](std::uint16_t value) { return foreign[value]; }, std::uint16_t{ 0 });
  }
}
/** Whether both are teeth, without regard to the spelling, and not the same one. */
bool
AreOtherTeeth(const std::string & left, const std::string & right)
{
  try
  {
    return ToothCode::JawFromString(left) == ToothCode::JawEnum::Unknown &&
           ToothCode::JawFromString(right) == ToothCode::JawEnum::Unknown &&
           !ToothCode::FromSidelessString(left).IsKnown() && !ToothCode::FromSidelessString(right).IsKnown() &&
           ToothCode::FromString(left) != ToothCode::FromString(right);
  }
  catch (const std::invalid_argument &)
  {
    // A number of the universal numbering: what it means is known where the labels are read.
    return LowerCase(left) != LowerCase(right);
  }
}

/** What a program drew of one tooth or jaw, as 3D Slicer saves each curve in a file of its own. */
void
AppendDrawing(const std::string & label,
              const std::string & fileName,
              const std::string & imageName,
              AnnotationRecords & records)
{
  AnnotationRecords drawn = ReadContourRecords(fileName, AnnotationFileFormatEnum::Automatic, imageName);
  // What a format counts from is one for all that was read.
  if (records.format != AnnotationFileFormatEnum::LabelImage && records.format != drawn.format)
  {
    std::ostringstream problem;
    problem << "is of format " << drawn.format << ", and a file before it of " << records.format;
    itkDentalInputErrorMacro(
      fileName, "contours." + label, problem.str(), "save the drawings of all teeth with one program");
  }
  records.format = drawn.format;
  if (drawn.imageSize)
  {
    if (records.imageSize && *records.imageSize != *drawn.imageSize)
    {
      itkDentalInputErrorMacro(fileName,
                               drawn.imageSizeField,
                               "is another size than that of a file before it",
                               "draw all teeth on the same radiograph");
    }
    records.imageSize = drawn.imageSize;
    records.imageSizeField = drawn.imageSizeField;
  }
  for (AnnotationPolyline & polyline : drawn.polylines)
  {
    // What the file itself says may contradict; a name that is no tooth's does not.
    const bool namesTooth = NamesToothOrJaw(polyline.label);
    if (namesTooth && AreOtherTeeth(polyline.label, label))
    {
      itkDentalInputErrorMacro(fileName,
                               polyline.codeField,
                               "is \"" + polyline.label + "\", and the case names the file for \"" + label + '"',
                               "name it for its own tooth, or draw each tooth in a file of its own");
    }
    polyline.label = namesTooth ? polyline.label : label;
    polyline.codeField = "contours." + label;
    records.polylines.push_back(std::move(polyline));
  }
  for (std::string & warning : drawn.warnings)
  {
    records.warnings.push_back(std::move(warning));
  }
  records.calibrations.insert(records.calibrations.end(), drawn.calibrations.begin(), drawn.calibrations.end());
}

/** Of a segmentation of 3D Slicer: numbers its segments by the teeth that they are called after, and returns what each
 * tooth was called. A segment that is a jaw, or a tooth in another numbering, becomes an outline at once. */
std::map<ToothCode, std::string>
TakeSegments(const std::string &     fileName,
             LabelImageType *        image,
             const LabelImageNotes & notes,
             AnnotationRecords &     records)
{
  std::map<ToothCode, std::string>     names;
  std::vector<std::uint16_t>           numbers(std::size_t{ std::numeric_limits<std::uint16_t>::max() } + 1, 0);
  std::vector<std::string>             others;
  std::map<std::uint16_t, std::string> wholes;
  const std::size_t                    count = image->GetLargestPossibleRegion().GetNumberOfPixels();
  const std::uint16_t * const          pixels = image->GetBufferPointer();
  for (const auto & [label, name] : notes.segments)
  {
    ToothCode code = ToothCode::FromSidelessString(name);
    try
    {
      code = code.IsKnown() ? code : ToothCode::FromString(name);
    }
    catch (const std::invalid_argument &)
    {
      code = ToothCode();
    }
    if (code.IsKnown())
    {
      numbers[label] = static_cast<std::uint16_t>(code.GetFDI());
      names[code] = name;
    }
    else if (NamesToothOrJaw(name))
    {
      wholes[label] = name;
    }
    else
    {
      others.push_back(name);
    }
  }
  for (const auto & [label, name] : wholes)
  {
    const auto mask = MaskImageType::New();
    mask->SetRegions(image->GetLargestPossibleRegion());
    mask->Allocate(true);
    std::transform(pixels, pixels + count, mask->GetBufferPointer(), [label = label](std::uint16_t value) {
      return static_cast<std::uint8_t>(value == label ? 1 : 0);
    });
    if (std::any_of(pixels, pixels + count, [label = label](std::uint16_t value) { return value == label; }))
    {
      AppendMaskOutlines(mask, { { 0.0, 0.0 } }, "segment " + name, name, records);
    }
  }
  std::transform(
    pixels, pixels + count, image->GetBufferPointer(), [&numbers](std::uint16_t value) { return numbers[value]; });
  if (!others.empty())
  {
    records.warnings.push_back(fileName + ": segments: no teeth, left out: " + ListNames(others));
  }
  return names;
}
} // namespace

AnnotationRecords
ReadLabelImageRecords(const std::string & fileName, const std::array<std::size_t, 2> & imageSize)
{
  AnnotationRecords       records;
  LabelImageNotes         notes;
  LabelImageType::Pointer image = ReadLabelImage(fileName, notes);
  records.format = AnnotationFileFormatEnum::LabelImage;
  if (notes.isOfPlainArray)
  {
    image = OrientPlainArray<LabelImageType>(fileName, image, imageSize, records);
  }
  if (notes.isPart)
  {
    if (notes.pictureSize[0] > 0)
    {
      records.imageSize = notes.pictureSize;
      records.imageSizeField = "Segmentation_ConversionParameters";
    }
  }
  else
  {
    records.imageSize = GetSize(*image);
    records.imageSizeField = "size";
  }
  std::map<ToothCode, std::string> names;
  if (std::any_of(notes.segments.begin(), notes.segments.end(), [](const auto & segment) {
        return NamesToothOrJaw(segment.second);
      }))
  {
    names = TakeSegments(fileName, image, notes, records);
  }
  else
  {
    TakeTeethAlone(fileName, image, records);
  }
  std::map<ToothCode, DentalContour::PolylinesType> outlines;
  const std::uint16_t * const                       pixels = image->GetBufferPointer();
  // Of segments that are jaws nothing is left in it.
  if (std::any_of(pixels, pixels + image->GetLargestPossibleRegion().GetNumberOfPixels(), [](std::uint16_t value) {
        return value != 0;
      }))
  {
    for (const auto & outline :
         TraceOutlines<LabelImageType>(image, SilhouetteContourFilterEnums::Content::ToothLabels))
    {
      outlines[outline.code].push_back(outline);
    }
  }
  std::vector<std::string> speckled;
  for (const auto & [code, parts] : outlines)
  {
    // A label is an FDI number, whatever the numbering of codes.
    const std::size_t first = records.polylines.size();
    const auto        name = names.find(code);
    AppendOutlines(
      name == names.end() ? "FDI " + std::to_string(code.GetFDI()) : name->second, parts, speckled, records);
    for (std::size_t i = first; i < records.polylines.size(); ++i)
    {
      std::vector<std::array<double, 2>> points;
      for (const auto & point : records.polylines[i].points)
      {
        points.push_back({ { point[0], point[1] } });
      }
      records.polylines[i].weights =
        ComputeLabelBorderWeights(image, points, code.GetJaw() == ToothCode::JawEnum::Upper);
    }
  }
  for (AnnotationPolyline & polyline : records.polylines)
  {
    for (auto & point : polyline.points)
    {
      point[0] += notes.offset[0];
      point[1] += notes.offset[1];
    }
  }
  WarnOfSpecks(fileName, speckled, records);
  return records;
}

AnnotationRecords
ReadClassRecords(const std::vector<std::pair<std::string, std::string>> & files,
                 const std::string &                                      imageName,
                 const std::array<std::size_t, 2> &                       imageSize)
{
  AnnotationRecords records;
  records.format = AnnotationFileFormatEnum::LabelImage;
  for (const auto & [label, fileName] : files)
  {
    if (AnnotationFormatFromFile(fileName) != AnnotationFileFormatEnum::LabelImage)
    {
      AppendDrawing(label, fileName, imageName, records);
      continue;
    }
    MaskImageType::Pointer image = ReadMaskImage(fileName);
    if (IsImageOfPlainArray(fileName))
    {
      image = OrientPlainArray<MaskImageType>(fileName, image, imageSize, records);
    }
    if (records.imageSize && *records.imageSize != GetSize(*image))
    {
      itkDentalInputErrorMacro(fileName,
                               "size",
                               "is " + std::to_string(GetSize(*image)[0]) + " x " + std::to_string(GetSize(*image)[1]) +
                                 ", but \"" + files.front().second + "\" is " +
                                 std::to_string((*records.imageSize)[0]) + " x " +
                                 std::to_string((*records.imageSize)[1]),
                               "save all masks in the radiograph's pixel grid");
    }
    records.imageSize = GetSize(*image);
    records.imageSizeField = "size";
    if (DrawnLines::AreDrawn(image))
    {
      for (const auto & line : DrawnLines::Trace(image))
      {
        AppendPolyline("contours." + label, label, line.closed, line.points, records);
        records.polylines.back().isPixelIndex = true;
      }
    }
    else
    {
      const std::size_t        first = records.polylines.size();
      std::vector<std::string> speckled;
      AppendOutlines(label,
                     TraceOutlines<MaskImageType>(image, SilhouetteContourFilterEnums::Content::MergedLabels),
                     speckled,
                     records);
      WarnOfSpecks(fileName, speckled, records);
      for (std::size_t i = first; i < records.polylines.size(); ++i)
      {
        records.polylines[i].codeField = "contours." + label;
        records.polylines[i].isPixelIndex = true;
      }
    }
  }
  return records;
}

bool
AppendMaskOutlines(const Image<std::uint8_t, 2> * mask,
                   const std::array<double, 2> &  offset,
                   const std::string &            field,
                   const std::string &            label,
                   AnnotationRecords &            records)
{
  const std::size_t        first = records.polylines.size();
  std::vector<std::string> speckled;
  AppendOutlines(
    label, TraceOutlines<MaskImageType>(mask, SilhouetteContourFilterEnums::Content::MergedLabels), speckled, records);
  for (std::size_t i = first; i < records.polylines.size(); ++i)
  {
    AnnotationPolyline & polyline = records.polylines[i];
    polyline.field = field;
    polyline.codeField = field;
    polyline.isPixelIndex = true;
    for (auto & point : polyline.points)
    {
      point[0] += offset[0];
      point[1] += offset[1];
    }
  }
  return !speckled.empty();
}
} // namespace itk
