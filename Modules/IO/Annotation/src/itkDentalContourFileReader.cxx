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
#include "itkDentalContourFileReader.h"

#include "itkAnnotationRecords.h"
#include "itkDentalInputError.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using NumberingEnum = ToothCode::NumberingEnum;

std::string
ToString(const Size<2> & size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]);
}

/** The numbering of the file where it states one, else the case's. */
NumberingEnum
CombineNumberings(const std::string & fileName, const AnnotationRecords & records, NumberingEnum given)
{
  if (!records.numbering)
  {
    return given;
  }
  NumberingEnum stated = NumberingEnum::Quadrant;
  try
  {
    stated = ToothCode::NumberingFromString(*records.numbering);
  }
  catch (const std::invalid_argument & error)
  {
    itkDentalInputErrorMacro(fileName, records.numberingField, error.what(), "use one of these");
  }
  // "UR" is the default and reads digits as FDI: it contradicts nothing but a universal that the case states.
  const bool oneIsUniversal = (stated == NumberingEnum::Universal) != (given == NumberingEnum::Universal);
  if (oneIsUniversal && given != NumberingEnum::Quadrant)
  {
    itkDentalInputErrorMacro(fileName,
                             records.numberingField,
                             "is \"" + *records.numbering + "\", which contradicts the numbering of the case",
                             "make the two agree");
  }
  return stated;
}

/** Takes a curve's tooth and jaw from its label and from where it stood. */
JawEnum
InterpretLabel(const std::string &        fileName,
               const AnnotationPolyline & polyline,
               NumberingEnum              numbering,
               ToothCode &                code)
{
  JawEnum jaw = polyline.jaw == "upper" ? JawEnum::Upper : polyline.jaw == "lower" ? JawEnum::Lower : JawEnum::Unknown;
  if (jaw == JawEnum::Unknown && (polyline.label == "upper" || polyline.label == "lower"))
  {
    code = ToothCode();
    return polyline.label == "upper" ? JawEnum::Upper : JawEnum::Lower;
  }
  try
  {
    code = ToothCode::FromString(polyline.label, numbering);
  }
  catch (const std::invalid_argument & error)
  {
    itkDentalInputErrorMacro(fileName, polyline.codeField, error.what(), "correct the code or the numbering");
  }
  if (jaw == JawEnum::Unknown)
  {
    jaw = code.GetJaw();
    if (jaw == JawEnum::Unknown)
    {
      itkDentalInputErrorMacro(fileName,
                               polyline.codeField,
                               "the contour has no label, so its jaw is unknown",
                               "label it with a tooth code, \"upper\" or \"lower\"");
    }
  }
  else if (code.IsKnown() && code.GetJaw() != jaw)
  {
    itkDentalInputErrorMacro(fileName,
                             polyline.codeField,
                             "\"" + polyline.label + "\" (" + code.GetName() + ") is no tooth of the " + polyline.jaw +
                               " jaw",
                             "check for swapped jaws, or correct the code or the numbering");
  }
  return jaw;
}
} // namespace

DentalContourFileReader::DentalContourFileReader()
{
  m_ImageSize.Fill(0);
  m_ReadImageSize.Fill(0);
  this->SetNumberOfRequiredOutputs(2);
  for (DataObjectPointerArraySizeType i = 0; i < 2; ++i)
  {
    this->SetNthOutput(i, this->MakeOutput(i));
  }
}

DataObject::Pointer
DentalContourFileReader::MakeOutput(DataObjectPointerArraySizeType)
{
  return DentalContour::New().GetPointer();
}

DentalContour *
DentalContourFileReader::GetOutput(JawEnum jaw)
{
  return const_cast<DentalContour *>(const_cast<const Self *>(this)->GetOutput(jaw));
}

const DentalContour *
DentalContourFileReader::GetOutput(JawEnum jaw) const
{
  if (jaw == JawEnum::Unknown)
  {
    itkExceptionMacro("GetOutput() needs Upper or Lower.");
  }
  return dynamic_cast<const DentalContour *>(this->Superclass::GetOutput(jaw == JawEnum::Upper ? 0 : 1));
}

void
DentalContourFileReader::GenerateData()
{
  this->StartReading(FileFormatEnum::Automatic, {});
  m_NumberOfPointsOutside = 0;
  const std::string fileName = this->GetFileName();
  AnnotationRecords records = ReadContourRecords(fileName, this->GetFileFormat());
  m_ReadNumbering = CombineNumberings(fileName, records, this->GetNumbering());
  this->StartReading(records.format, std::move(records.warnings));

  ImageSizeType stated{ { 0, 0 } };
  if (records.imageSize)
  {
    stated = { { (*records.imageSize)[0], (*records.imageSize)[1] } };
  }
  const bool sizeIsGiven = m_ImageSize[0] > 0 && m_ImageSize[1] > 0;
  if (sizeIsGiven && records.imageSize && m_ImageSize != stated)
  {
    itkDentalInputErrorMacro(fileName,
                             records.imageSizeField,
                             "is " + ToString(stated) + ", but the image is " + ToString(m_ImageSize),
                             "trace on this image or name the right one");
  }
  if (!sizeIsGiven && !records.imageSize)
  {
    itkDentalInputErrorMacro(
      fileName, "image_size", "missing field", "add \"image_size\": [width, height], or give the image");
  }
  m_ReadImageSize = sizeIsGiven ? m_ImageSize : stated;

  SizeValueType       pointCount = 0;
  std::string         firstOutside;
  std::set<ToothCode> seen;
  // The outputs stay empty until all is known to be right.
  std::vector<std::pair<JawEnum, DentalContour::PolylineType>> polylines;
  for (const AnnotationPolyline & record : records.polylines)
  {
    DentalContour::PolylineType polyline;
    const JawEnum               jaw = InterpretLabel(fileName, record, m_ReadNumbering, polyline.code);
    polyline.closed = record.closed;
    polyline.weights = record.weights;
    polyline.points.reserve(record.points.size());
    for (const std::array<double, 3> & position : record.points)
    {
      DentalContour::PointType point;
      bool                     outside = false;
      for (unsigned int i = 0; i < 2; ++i)
      {
        point[i] = this->ToPixelIndex(position[i], i);
        outside = outside || !(point[i] >= -0.5 && point[i] <= static_cast<double>(m_ReadImageSize[i]) - 0.5);
      }
      if (outside && m_NumberOfPointsOutside++ == 0)
      {
        firstOutside = record.field;
      }
      polyline.points.push_back(point);
    }
    pointCount += polyline.points.size();
    // Tools differ in whether a closed contour repeats its first point; ours does not.
    if (polyline.closed && polyline.points.size() > 1 && polyline.points.front() == polyline.points.back())
    {
      polyline.points.pop_back();
      if (!polyline.weights.empty())
      {
        polyline.weights.pop_back();
      }
    }
    if (polyline.closed && !polyline.points.empty() && polyline.points.size() < 3)
    {
      itkDentalInputErrorMacro(fileName,
                               record.field,
                               "is closed but has " + std::to_string(polyline.points.size()) + " different points",
                               "give it at least 3 points, or leave it open");
    }
    if (polyline.code.IsKnown() && !polyline.points.empty() && !seen.insert(polyline.code).second)
    {
      this->Warn(record.codeField, "tooth " + polyline.code.GetName() + " is there more than once");
    }
    polylines.emplace_back(jaw, std::move(polyline));
  }

  if (m_NumberOfPointsOutside > 0)
  {
    const std::string text = std::to_string(m_NumberOfPointsOutside) + " of " + std::to_string(pointCount) +
                             " points lie outside the image of " + ToString(m_ReadImageSize) + " pixels";
    if (static_cast<double>(m_NumberOfPointsOutside) > MaximumFractionOutside * static_cast<double>(pointCount))
    {
      itkDentalInputErrorMacro(
        fileName, firstOutside, text, "check that the tracing was made on this image, in pixels");
    }
    this->Warn(firstOutside, text);
  }
  for (const auto & [jaw, polyline] : polylines)
  {
    this->GetOutput(jaw)->AddPolyline(polyline);
  }
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    DentalContour * const contour = this->GetOutput(jaw);
    const SizeValueType   count = contour->GetNumberOfPoints();
    if (count > 0 && count < MinimumNumberOfPoints)
    {
      this->Warn(jaw == JawEnum::Upper ? "contours.upper" : "contours.lower",
                 "has only " + std::to_string(count) + " points, too few to register (" +
                   std::to_string(MinimumNumberOfPoints) + " are needed)");
    }
    // Or the next Update() reads again.
    contour->SetBufferedRegion(0);
  }
  if (pointCount == 0)
  {
    this->Warn("contours", "neither jaw has a point");
  }
}

void
DentalContourFileReader::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "ImageSize: " << m_ImageSize << std::endl;
  os << indent << "ReadImageSize: " << m_ReadImageSize << std::endl;
  os << indent << "ReadNumbering: " << m_ReadNumbering << std::endl;
  os << indent << "NumberOfPointsOutside: " << m_NumberOfPointsOutside << std::endl;
}
} // namespace itk
