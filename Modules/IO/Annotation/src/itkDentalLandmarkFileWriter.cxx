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
#include "itkDentalLandmarkFileWriter.h"

#include "itkJsonNumber.h"
#include "itkRequireJsonName.h"
#include "itkTextFile.h"

namespace itk
{
template <unsigned int VDimension>
void
DentalLandmarkFileWriter<VDimension>::SetInput(const LandmarkSetType * landmarks)
{
  this->SetNthInput(0, const_cast<LandmarkSetType *>(landmarks));
}

template <unsigned int VDimension>
auto
DentalLandmarkFileWriter<VDimension>::GetInput() const -> const LandmarkSetType *
{
  return dynamic_cast<const LandmarkSetType *>(this->GetPrimaryInput());
}

template <unsigned int VDimension>
void
DentalLandmarkFileWriter<VDimension>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_FileName.empty())
  {
    itkExceptionMacro("No file to write. Call SetFileName() first.");
  }
  RequireJsonName(m_FileName, "landmarks");
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("Nothing to write. Call SetInput() first.");
  }
}

template <unsigned int VDimension>
void
DentalLandmarkFileWriter<VDimension>::Write()
{
  this->VerifyPreconditions();
  this->GetPrimaryInput()->Update();
  this->InvokeEvent(StartEvent());
  this->GenerateData();
  this->UpdateProgress(1.0f);
  this->InvokeEvent(EndEvent());
}

template <unsigned int VDimension>
void
DentalLandmarkFileWriter<VDimension>::GenerateData()
{
  std::string  text = "{";
  const char * separator = "\n";
  for (const auto & landmark : this->GetInput()->GetLandmarks())
  {
    text += separator + std::string("  ") + JsonString(landmark.name) + ": [";
    for (unsigned int i = 0; i < VDimension; ++i)
    {
      text += (i == 0 ? "" : ", ") + JsonNumber(landmark.point[i]);
    }
    text += ']';
    separator = ",\n";
  }
  WriteFileAtomically(m_FileName, text + "\n}\n");
}

template <unsigned int VDimension>
void
DentalLandmarkFileWriter<VDimension>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << std::endl;
}

template class DentalLandmarkFileWriter<2>;
template class DentalLandmarkFileWriter<3>;
} // namespace itk
