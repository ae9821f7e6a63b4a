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
#include "itkCephalometricLandmarkFileReader.h"

#include "itkAnnotationText.h"
#include "itkCephalometricLandmarkRecords.h"
#include "itkDentalInputError.h"

#include <stdexcept>
#include <utility>

namespace itk
{
CephalometricLandmarkFileReader::CephalometricLandmarkFileReader()
{
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

DataObject::Pointer
CephalometricLandmarkFileReader::MakeOutput(ProcessObject::DataObjectPointerArraySizeType)
{
  return CephalometricLandmarkSet::New().GetPointer();
}

CephalometricLandmarkSet *
CephalometricLandmarkFileReader::GetOutput()
{
  return dynamic_cast<CephalometricLandmarkSet *>(this->GetPrimaryOutput());
}

const CephalometricLandmarkSet *
CephalometricLandmarkFileReader::GetOutput() const
{
  return dynamic_cast<const CephalometricLandmarkSet *>(this->GetPrimaryOutput());
}

void
CephalometricLandmarkFileReader::SetJsonNode(const JsonNode & node)
{
  m_JsonNode = node;
  this->SetFileName(node.GetFileName());
  this->Modified();
}

std::string
CephalometricLandmarkFileReader::NameFromNumber(const std::string & name) const
{
  // A name that is known already is no other spelling of something else.
  return CephalometricLandmarkSet::ParseName(name).position > 0 ? name : SpellPointOfTooth(name, this->GetNumbering());
}

void
CephalometricLandmarkFileReader::GenerateData()
{
  this->StartReading(FileFormatEnum::Automatic, {});
  const std::string fileName = this->GetFileName();
  const std::string where = m_JsonNode ? m_JsonNode->GetPath() : std::string();
  const auto        isDental = [this](const std::string & name) {
    return CephalometricLandmarkSet::ParseName(this->NameFromNumber(name)).position > 0;
  };
  const std::string imageName = this->GetImageFileName();
  AnnotationRecords records =
    m_JsonNode ? ReadCephalometricLandmarkRecords(*m_JsonNode, this->GetFileFormat(), isDental, imageName)
               : ReadCephalometricLandmarkRecords(fileName, this->GetFileFormat(), isDental, imageName);
  this->StartReading(records.format, std::move(records.warnings));
  VerifyAreNoShares(fileName, records);

  const auto landmarks = CephalometricLandmarkSet::New();
  for (const AnnotationLandmark & record : records.landmarks)
  {
    CephalometricLandmarkSet::PointType point;
    for (unsigned int i = 0; i < 2; ++i)
    {
      point[i] = this->ToPixelIndex(record.point[i], i);
      VerifyCoordinate(this->GetFileName(), record.field, point[i]);
    }
    try
    {
      landmarks->AddLandmark(this->NameFromNumber(record.name), point, record.sigma, record.confidence);
    }
    catch (const std::invalid_argument & error)
    {
      itkDentalInputErrorMacro(fileName, record.field, error.what(), "keep one of the two");
    }
  }
  if (landmarks->GetNumberOfLandmarks() == 0)
  {
    itkDentalInputErrorMacro(fileName,
                             where,
                             "has no dental landmark" + (records.leftOut.empty()
                                                           ? std::string()
                                                           : " (there are " + ListNames(records.leftOut) + ")"),
                             "mark incisal edges and first molars: U1_tip, L1_tip, U6_MB, L6_MB (or Is, Ii, Ms, Mi; "
                             "Documentation/FileFormats.md)");
  }
  if (!records.leftOut.empty())
  {
    this->Warn(where.empty() ? "landmarks" : where, "no dental landmarks, left out: " + ListNames(records.leftOut));
  }
  for (const auto & landmark : landmarks->GetLandmarks())
  {
    this->GetOutput()->AddLandmark(landmark.name, landmark.point, landmark.sigma, landmark.confidence);
  }
}

void
CephalometricLandmarkFileReader::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "JsonNode: " << (m_JsonNode ? m_JsonNode->GetPath() : "none") << std::endl;
}
} // namespace itk
