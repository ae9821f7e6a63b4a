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
#include "itkAnnotationText.h"
#include "itkDentalInputError.h"
#include "itkLabelImageRecords.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
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

/** What may have become of the picture that a tracing of another size was drawn on. */
std::string
DescribeRemedy(const Size<2> & drawn, const Size<2> & image)
{
  if (drawn[0] == image[1] && drawn[1] == image[0])
  {
    return "the picture was turned by 90 degrees before or after it was drawn on: turn it back, or trace on it as it "
           "is";
  }
  const double ratio = static_cast<double>(drawn[0]) / static_cast<double>(image[0]);
  const double other = static_cast<double>(drawn[1]) / static_cast<double>(image[1]);
  // Half a pixel is rounded away in each direction.
  const double tolerance = 0.5 / static_cast<double>(std::min(image[0], image[1])) + 1e-3;
  if (std::abs(ratio - other) <= tolerance)
  {
    std::ostringstream factor;
    factor.precision(3);
    factor << ratio;
    return "it was drawn on a copy " + factor.str() +
           " times as large: name that copy (and its pixel spacing), or divide points and image_size by " +
           factor.str();
  }
  return "trace on this image or name the right one";
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

/** What a label means. */
struct MeaningType
{
  JawEnum   jaw{ JawEnum::Unknown };
  ToothCode code;
  bool      sideless{ false };
  /** Neither a tooth nor a jaw: a soft-tissue line, for one. */
  bool isOther{ false };
};

/** Takes a curve's tooth and jaw from its label and from where it stood. */
MeaningType
InterpretLabel(const std::string &        fileName,
               const AnnotationPolyline & polyline,
               NumberingEnum              numbering,
               bool                       sidelessIsLeft)
{
  MeaningType   meaning;
  const JawEnum stated = polyline.jaw == "upper"   ? JawEnum::Upper
                         : polyline.jaw == "lower" ? JawEnum::Lower
                                                   : JawEnum::Unknown;
  const JawEnum word = ToothCode::JawFromString(polyline.label);
  meaning.jaw = stated;
  if (word != JawEnum::Unknown && (stated == JawEnum::Unknown || stated == word))
  {
    meaning.jaw = word;
    return meaning;
  }
  meaning.code = ToothCode::FromSidelessString(polyline.label);
  meaning.sideless = meaning.code.IsKnown();
  if (meaning.sideless && sidelessIsLeft)
  {
    meaning.code = meaning.code.GetContralateral();
  }
  if (!meaning.sideless)
  {
    try
    {
      meaning.code = ToothCode::FromString(polyline.label, numbering);
    }
    catch (const std::invalid_argument & error)
    {
      // What was meant as a code is a mistake, or the numbering is another one.
      if (word != JawEnum::Unknown || ToothCode::IsWrittenAsCode(polyline.label))
      {
        itkDentalInputErrorMacro(fileName, polyline.codeField, error.what(), "correct the code or the numbering");
      }
      meaning.isOther = true;
      return meaning;
    }
  }
  if (meaning.jaw == JawEnum::Unknown)
  {
    meaning.jaw = meaning.code.GetJaw();
    if (meaning.jaw == JawEnum::Unknown)
    {
      itkDentalInputErrorMacro(fileName,
                               polyline.codeField,
                               "the contour has no label, so its jaw is unknown",
                               "label it with a tooth code, \"upper\" or \"lower\"");
    }
  }
  else if (meaning.code.IsKnown() && meaning.code.GetJaw() != meaning.jaw)
  {
    itkDentalInputErrorMacro(fileName,
                             polyline.codeField,
                             "\"" + polyline.label + "\" (" + meaning.code.GetName() + ") is no tooth of the " +
                               polyline.jaw + " jaw",
                             "check for swapped jaws, or correct the code or the numbering");
  }
  return meaning;
}

/** Without what is repeated or what a point of it says. */
void
DropLastPoint(DentalContour::PolylineType & polyline)
{
  polyline.points.pop_back();
  for (std::vector<double> * values : { &polyline.weights, &polyline.sigmas })
  {
    if (!values->empty())
    {
      values->pop_back();
    }
  }
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
DentalContourFileReader::SetFileName(const char * fileName)
{
  Superclass::SetFileName(fileName);
  this->SetClassFiles({});
}

void
DentalContourFileReader::SetClassFiles(const ClassFilesType & files)
{
  if (m_ClassFiles != files)
  {
    m_ClassFiles = files;
    this->Modified();
  }
}

void
DentalContourFileReader::VerifyPreconditions() ITKv5_CONST
{
  if (m_ClassFiles.empty())
  {
    Superclass::VerifyPreconditions();
  }
}

void
DentalContourFileReader::GenerateData()
{
  this->StartReading(FileFormatEnum::Automatic, {});
  m_NumberOfPointsOutside = 0;
  m_NumberOfSidelessCodes = 0;
  m_Calibrations.clear();
  const std::string fileName = m_ClassFiles.empty() ? this->GetFileName() : m_ClassFiles.front().second;
  AnnotationRecords records =
    m_ClassFiles.empty()
      ? ReadContourRecords(
          fileName, this->GetFileFormat(), this->GetImageFileName(), { { m_ImageSize[0], m_ImageSize[1] } })
      : ReadClassRecords(m_ClassFiles, this->GetImageFileName(), { { m_ImageSize[0], m_ImageSize[1] } });
  m_ReadNumbering = CombineNumberings(fileName, records, this->GetNumbering());
  this->StartReading(records.format, std::move(records.warnings));

  for (const AnnotationCalibration & calibration : records.calibrations)
  {
    m_Calibrations.push_back(
      { calibration.label, calibration.millimetres, std::hypot(calibration.pixels[0], calibration.pixels[1]) });
  }

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
                             DescribeRemedy(stated, m_ImageSize));
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
  std::vector<std::string>                                     others;
  std::string                                                  firstOther;
  for (const AnnotationPolyline & record : records.polylines)
  {
    const MeaningType meaning = InterpretLabel(fileName, record, m_ReadNumbering, m_SidelessCodesAreLeft);
    if (meaning.isOther)
    {
      firstOther = others.empty() ? record.codeField : firstOther;
      others.push_back(record.label);
      continue;
    }
    const JawEnum               jaw = meaning.jaw;
    DentalContour::PolylineType polyline;
    polyline.code = meaning.code;
    m_NumberOfSidelessCodes += meaning.sideless && !record.points.empty() ? 1 : 0;
    polyline.closed = record.closed;
    polyline.weights = record.weights;
    polyline.sigmas = record.sigmas;
    polyline.outline = record.outline;
    polyline.drafted = record.drafted;
    polyline.points.reserve(record.points.size());
    for (const std::array<double, 3> & position : record.points)
    {
      DentalContour::PointType point;
      bool                     outside = false;
      for (unsigned int i = 0; i < 2; ++i)
      {
        point[i] = record.isPixelIndex ? position[i] : this->ToPixelIndex(position[i], i);
        VerifyCoordinate(fileName, record.field, point[i]);
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
      DropLastPoint(polyline);
    }
    if (polyline.closed && !polyline.points.empty() && polyline.points.size() < 3)
    {
      if (records.format != FileFormatEnum::DentalSCR)
      {
        // A slip of the mouse, which editors keep as a polygon; in our own format somebody has written it.
        this->Warn(record.field,
                   "is closed but has " + std::to_string(polyline.points.size()) +
                     " different points, which is no outline: left out");
        pointCount -= record.points.size();
        continue;
      }
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

  if (records.format != FileFormatEnum::DentalSCR && records.polylines.empty())
  {
    // In our own format empty contours say "not traced"; of another program's file it is no tracing then, and what it
    // holds instead was warned of.
    const auto &      warnings = this->GetWarnings();
    const std::string prefix = fileName + ": ";
    const std::string first = warnings.empty() ? std::string() : warnings.front();
    itkDentalInputErrorMacro(
      fileName,
      "contours",
      "has no outline" +
        (first.empty()
           ? std::string(": nothing is drawn in it but points, or nothing at all")
           : " (" + (first.compare(0, prefix.size(), prefix) == 0 ? first.substr(prefix.size()) : first) + ")"),
      "draw or export polygons or lines, or save masks as pictures, one a tooth");
  }
  if (!others.empty() && polylines.empty())
  {
    itkDentalInputErrorMacro(fileName,
                             firstOther,
                             "\"" + others.front().substr(0, 40) + "\" is no tooth" +
                               (others.size() > 1 ? ", and nothing else in the file is: " + ListNames(others) : ""),
                             "label contours with tooth codes (UR1, 11, U6), \"upper\" or \"lower\"");
  }
  if (!others.empty())
  {
    this->Warn("contours", "no teeth, left out: " + ListNames(others));
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
  os << indent << "ClassFiles: " << m_ClassFiles.size() << std::endl;
  os << indent << "SidelessCodesAreLeft: " << (m_SidelessCodesAreLeft ? "On" : "Off") << std::endl;
  os << indent << "NumberOfSidelessCodes: " << m_NumberOfSidelessCodes << std::endl;
  os << indent << "Calibrations: " << m_Calibrations.size() << std::endl;
  os << indent << "NumberOfPointsOutside: " << m_NumberOfPointsOutside << std::endl;
}
} // namespace itk
