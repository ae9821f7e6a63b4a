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
#include "itkDentalCaseReader.h"

#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"

namespace itk
{
DentalCaseReader::DentalCaseReader()
{
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

DentalCaseReader::DataObjectPointer
DentalCaseReader::MakeOutput(DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

DentalCaseReader::OutputType *
DentalCaseReader::GetOutput()
{
  return itkDynamicCastInDebugMode<OutputType *>(this->ProcessObject::GetOutput(0));
}

void
DentalCaseReader::SetDescription(const DentalCase & description)
{
  m_Description = description;
  this->Modified();
}

void
DentalCaseReader::ClearDescription()
{
  m_Description.reset();
  this->Modified();
}

void
DentalCaseReader::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_FileName.empty() && !m_Description)
  {
    itkExceptionMacro("There is no case: call SetFileName() with a case file, or SetDescription().");
  }
}

void
DentalCaseReader::GenerateData()
{
  this->GetOutput()->Set(LoadDentalCase(m_Description ? *m_Description : ReadDentalCase(m_FileName)));
}

void
DentalCaseReader::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << std::endl;
  os << indent << "Description: " << (m_Description ? "given" : "(none)") << std::endl;
}
} // namespace itk
