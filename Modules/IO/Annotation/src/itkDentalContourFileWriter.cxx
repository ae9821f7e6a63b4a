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
#include "itkDentalContourFileWriter.h"

#include "itkJsonNumber.h"
#include "itkRequireJsonName.h"
#include "itkTextFile.h"

#include <algorithm>
#include <sstream>

namespace itk
{
namespace
{
std::string
CodeText(ToothCode code, ToothCode::NumberingEnum numbering)
{
  if (!code.IsKnown())
  {
    return std::string();
  }
  switch (numbering)
  {
    case ToothCode::NumberingEnum::FDI:
      return std::to_string(code.GetFDI());
    case ToothCode::NumberingEnum::Universal:
      return code.GetUniversalName();
    default:
      return code.GetName();
  }
}

/** One number where all are alike; null for a point whose error is not known, nothing where none is. */
void
AppendSigmas(std::ostream & os, const std::vector<double> & sigmas)
{
  if (std::count(sigmas.begin(), sigmas.end(), 0.0) == static_cast<std::ptrdiff_t>(sigmas.size()))
  {
    return;
  }
  os << ", \"sigma_px\": ";
  if (std::count(sigmas.begin(), sigmas.end(), sigmas.front()) == static_cast<std::ptrdiff_t>(sigmas.size()))
  {
    os << JsonNumber(sigmas.front());
    return;
  }
  for (std::size_t i = 0; i < sigmas.size(); ++i)
  {
    os << (i == 0 ? "[" : ", ");
    if (sigmas[i] == 0.0)
    {
      os << "null";
    }
    else
    {
      os << JsonNumber(sigmas[i]);
    }
  }
  os << ']';
}

/** Runs of points of one tooth: a file has one code a polyline. Of a closed one that goes over several teeth the runs
 * are open; those on both sides of its first point are one. */
DentalContour::PolylinesType
SplitByTooth(const DentalContour::PolylineType & polyline)
{
  const std::size_t count = polyline.points.size();
  std::size_t       start = 0;
  while (start < count && polyline.GetTooth(start) == polyline.GetTooth(0))
  {
    ++start;
  }
  if (start == count)
  {
    return { polyline };
  }
  DentalContour::PolylinesType runs;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t k = polyline.closed ? (start + i) % count : i;
    if (runs.empty() || runs.back().code != polyline.GetTooth(k))
    {
      runs.emplace_back();
    }
    AppendPoint(polyline, k, runs.back());
  }
  return runs;
}

void
AppendPolyline(std::ostream & os, const DentalContour::PolylineType & polyline, ToothCode::NumberingEnum numbering)
{
  os << "      {\"code\": "
     << JsonString(CodeText(polyline.points.empty() ? polyline.code : polyline.GetTooth(0), numbering));
  if (polyline.closed)
  {
    os << ", \"closed\": true";
  }
  os << ", \"points\": [";
  for (std::size_t i = 0; i < polyline.points.size(); ++i)
  {
    os << (i == 0 ? "[" : ", [") << JsonNumber(polyline.points[i][0]) << ", " << JsonNumber(polyline.points[i][1])
       << ']';
  }
  os << ']';
  if (!polyline.weights.empty())
  {
    os << ", \"weights\": [";
    for (std::size_t i = 0; i < polyline.weights.size(); ++i)
    {
      os << (i == 0 ? "" : ", ") << JsonNumber(polyline.weights[i]);
    }
    os << ']';
  }
  if (polyline.outline != DentalContour::OutlineEnum::Unspecified)
  {
    os << ", \"outline\": \"" << polyline.outline << '"';
  }
  if (polyline.drafted)
  {
    os << ", \"drafted\": true";
  }
  AppendSigmas(os, polyline.sigmas);
  os << '}';
}

void
AppendJaw(std::ostream & os, const char * jaw, const DentalContour & contour, ToothCode::NumberingEnum numbering)
{
  os << "    " << JsonString(jaw) << ": [";
  const char * separator = "\n";
  for (const DentalContour::PolylineType & polyline : contour.GetPolylines())
  {
    for (const DentalContour::PolylineType & run : SplitByTooth(polyline))
    {
      os << separator;
      AppendPolyline(os, run, numbering);
      separator = ",\n";
    }
  }
  os << "\n    ]";
}
} // namespace

DentalContourFileWriter::DentalContourFileWriter()
{
  m_ImageSize.Fill(0);
}

void
DentalContourFileWriter::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_FileName.empty())
  {
    itkExceptionMacro("No file to write. Call SetFileName() first.");
  }
  RequireJsonName(m_FileName, "contours");
  if (this->GetUpper() == nullptr && this->GetLower() == nullptr)
  {
    itkExceptionMacro("Nothing to write. Call SetUpper() or SetLower() first.");
  }
  if (m_ImageSize[0] == 0 || m_ImageSize[1] == 0)
  {
    itkExceptionMacro("ImageSize is " << m_ImageSize << ". Call SetImageSize() with the radiograph's size.");
  }
}

void
DentalContourFileWriter::Write()
{
  this->VerifyPreconditions();
  for (const char * name : { "Upper", "Lower" })
  {
    if (DataObject * const input = this->GetInput(name))
    {
      input->Update();
    }
  }
  this->InvokeEvent(StartEvent());
  this->GenerateData();
  this->UpdateProgress(1.0f);
  this->InvokeEvent(EndEvent());
}

void
DentalContourFileWriter::GenerateData()
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "{\n  \"image_size\": [" << m_ImageSize[0] << ", " << m_ImageSize[1] << "],\n";
  if (m_Numbering != NumberingEnum::Quadrant)
  {
    text << "  \"numbering\": \"" << m_Numbering << "\",\n";
  }
  text << "  \"contours\": {\n";
  const DentalContour * const upper = this->GetUpper();
  const DentalContour * const lower = this->GetLower();
  if (upper != nullptr)
  {
    AppendJaw(text, "upper", *upper, m_Numbering);
  }
  if (lower != nullptr)
  {
    text << (upper == nullptr ? "" : ",\n");
    AppendJaw(text, "lower", *lower, m_Numbering);
  }
  text << "\n  }\n}\n";
  WriteFileAtomically(m_FileName, text.str());
}

void
DentalContourFileWriter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << std::endl;
  os << indent << "ImageSize: " << m_ImageSize << std::endl;
  os << indent << "Numbering: " << m_Numbering << std::endl;
}
} // namespace itk
