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

#include "itkASCIICharacter.h"
#include "itkAnnotationRecords.h"
#include "itkAnnotationText.h"
#include "itkDentalInputError.h"
#include "itkLowerCase.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace itk
{
namespace
{
/** The name as it is written where it is one. Else, and in universal numbers, the tooth is told by all spellings that
 * tracings have, and the point without regard to case: "3_mb" of the universal numbering is "UR6_MB". */
std::string
NameLandmark(const std::string & name, ToothCode::NumberingEnum numbering)
{
  if (numbering != ToothCode::NumberingEnum::Universal && IsDentalLandmarkName(name))
  {
    return name;
  }
  const std::string spelled = SpellPointOfTooth(name, numbering);
  const std::size_t point = spelled.find('_') + 1;
  std::string       upper = spelled.substr(point);
  std::transform(upper.begin(), upper.end(), upper.begin(), ToASCIIUpperCase);
  for (const std::string & candidate : { spelled.substr(point), LowerCase(upper), upper })
  {
    if (point > 0 && IsDentalLandmarkName(spelled.substr(0, point) + candidate))
    {
      return spelled.substr(0, point) + candidate;
    }
  }
  return name;
}
} // namespace

template <unsigned int VDimension>
DentalLandmarkFileReader<VDimension>::DentalLandmarkFileReader()
{
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
DentalLandmarkFileReader<VDimension>::GenerateData()
{
  this->StartReading(FileFormatEnum::Automatic, {});
  const std::string fileName = this->GetFileName();
  AnnotationRecords records =
    ReadLandmarkRecords(fileName, this->GetFileFormat(), VDimension, this->GetImageFileName());
  this->StartReading(records.format, std::move(records.warnings));
  if (VDimension == 2)
  {
    VerifyAreNoShares(fileName, records);
  }

  const auto landmarks = LandmarkSetType::New();
  for (const AnnotationLandmark & record : records.landmarks)
  {
    const std::string name = NameLandmark(record.name, this->GetNumbering());
    try
    {
      LandmarkSetType::ParseName(name);
    }
    catch (const std::invalid_argument & error)
    {
      this->Warn(record.field, error.what() + std::string("; ignored"));
      continue;
    }
    typename LandmarkSetType::PointType point;
    for (unsigned int i = 0; i < VDimension; ++i)
    {
      point[i] = VDimension == 2 ? this->ToPixelIndex(record.point[i], i) : record.point[i];
      VerifyCoordinate(fileName, record.field, point[i]);
    }
    try
    {
      landmarks->AddLandmark(name, point);
    }
    catch (const std::invalid_argument & error)
    {
      itkDentalInputErrorMacro(fileName, record.field, error.what(), "keep one of the two");
    }
  }
  for (const auto & landmark : landmarks->GetLandmarks())
  {
    this->GetOutput()->AddLandmark(landmark.name, landmark.point);
  }
}

template class DentalLandmarkFileReader<2>;
template class DentalLandmarkFileReader<3>;
} // namespace itk
