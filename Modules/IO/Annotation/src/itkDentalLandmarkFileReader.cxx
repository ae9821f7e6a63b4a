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
#include "itkDentalLandmarkFileReader.h"

#include "itkAnnotationRecords.h"
#include "itkDentalInputError.h"

#include <stdexcept>

namespace itk
{
namespace
{
/** "3_MB" of the universal numbering to "UR6_MB"; a name that is none stays as it is. */
std::string
NameFromUniversal(const std::string & name)
{
  const std::size_t underscore = name.find('_');
  if (underscore == std::string::npos)
  {
    return name;
  }
  try
  {
    const auto code = ToothCode::FromString(name.substr(0, underscore), ToothCode::NumberingEnum::Universal);
    return code.IsKnown() ? code.GetName() + name.substr(underscore) : name;
  }
  catch (const std::invalid_argument &)
  {
    return name;
  }
}
} // namespace

template <unsigned int VDimension>
DentalLandmarkFileReader<VDimension>::DentalLandmarkFileReader()
{
  m_MarkupsSpacing.Fill(1.0);
  m_MarkupsOrigin.Fill(0.0);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, LandmarkSetType::New());
}

template <unsigned int VDimension>
DataObject::Pointer
DentalLandmarkFileReader<VDimension>::MakeOutput(ProcessObject::DataObjectPointerArraySizeType)
{
  return LandmarkSetType::New().GetPointer();
}

template <unsigned int VDimension>
auto
DentalLandmarkFileReader<VDimension>::GetOutput() -> LandmarkSetType *
{
  return dynamic_cast<LandmarkSetType *>(this->GetPrimaryOutput());
}

template <unsigned int VDimension>
auto
DentalLandmarkFileReader<VDimension>::GetOutput() const -> const LandmarkSetType *
{
  return dynamic_cast<const LandmarkSetType *>(this->GetPrimaryOutput());
}

template <unsigned int VDimension>
void
DentalLandmarkFileReader<VDimension>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_FileName.empty())
  {
    itkExceptionMacro("No file to read. Call SetFileName() first.");
  }
  for (unsigned int i = 0; i < 2; ++i)
  {
    if (!(m_MarkupsSpacing[i] > 0.0))
    {
      itkExceptionMacro("MarkupsSpacing is " << m_MarkupsSpacing << "; give SetMarkupsSpacing() mm above 0.");
    }
  }
}

template <unsigned int VDimension>
void
DentalLandmarkFileReader<VDimension>::GenerateData()
{
  m_Warnings.clear();
  AnnotationRecords records = ReadLandmarkRecords(m_FileName, m_FileFormat, VDimension);
  m_ReadFileFormat = records.format;
  m_Warnings = std::move(records.warnings);

  const bool foreign = VDimension == 2 && m_ReadFileFormat != FileFormatEnum::DentalSCR;
  const bool fromCorner =
    foreign && (m_PixelOrigin == PixelOriginEnum::Corner ||
                (m_PixelOrigin == PixelOriginEnum::FormatDefault && m_ReadFileFormat == FileFormatEnum::Labelme));
  const double shift = fromCorner ? -0.5 : 0.0;
  const bool   inMillimetres = VDimension == 2 && m_ReadFileFormat == FileFormatEnum::SlicerMarkups;

  const auto landmarks = LandmarkSetType::New();
  for (const AnnotationLandmark & record : records.landmarks)
  {
    const std::string name = m_Numbering == NumberingEnum::Universal ? NameFromUniversal(record.name) : record.name;
    try
    {
      LandmarkSetType::ParseName(name);
    }
    catch (const std::invalid_argument & error)
    {
      m_Warnings.push_back(m_FileName + ": " + record.field + ": " + error.what() + "; ignored");
      continue;
    }
    typename LandmarkSetType::PointType point;
    for (unsigned int i = 0; i < VDimension; ++i)
    {
      point[i] = record.point[i];
      if (VDimension == 2)
      {
        point[i] = (inMillimetres ? (point[i] - m_MarkupsOrigin[i]) / m_MarkupsSpacing[i] : point[i]) + shift;
      }
    }
    try
    {
      landmarks->AddLandmark(name, point);
    }
    catch (const std::invalid_argument & error)
    {
      itkDentalInputErrorMacro(m_FileName, record.field, error.what(), "keep one of the two");
    }
  }
  for (const auto & landmark : landmarks->GetLandmarks())
  {
    this->GetOutput()->AddLandmark(landmark.name, landmark.point);
  }
}

template <unsigned int VDimension>
void
DentalLandmarkFileReader<VDimension>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << std::endl;
  os << indent << "FileFormat: " << m_FileFormat << std::endl;
  os << indent << "Numbering: " << m_Numbering << std::endl;
  os << indent << "PixelOrigin: " << m_PixelOrigin << std::endl;
  os << indent << "MarkupsSpacing: " << m_MarkupsSpacing << std::endl;
  os << indent << "MarkupsOrigin: " << m_MarkupsOrigin << std::endl;
  os << indent << "ReadFileFormat: " << m_ReadFileFormat << std::endl;
  os << indent << "Warnings: " << m_Warnings.size() << std::endl;
}

template class DentalLandmarkFileReader<2>;
template class DentalLandmarkFileReader<3>;
} // namespace itk
