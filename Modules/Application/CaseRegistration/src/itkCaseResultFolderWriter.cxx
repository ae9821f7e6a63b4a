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
#include "itkCaseResultFolderWriter.h"

#include "itkCaseResultWriter.h"
#include "itkOutputFolder.h"

#include <utility>

namespace itk
{
CaseResultFolderWriter::CaseResultFolderWriter()
{
  this->SetNumberOfRequiredInputs(1);
}

CaseResultFolderWriter::~CaseResultFolderWriter() = default;

void
CaseResultFolderWriter::ClaimFolder()
{
  m_Folder = nullptr;
  m_Folder = std::make_unique<OutputFolder>(m_FolderName);
}

void
CaseResultFolderWriter::SetInput(const InputType * input)
{
  this->ProcessObject::SetNthInput(0, const_cast<InputType *>(input));
}

const CaseResultFolderWriter::InputType *
CaseResultFolderWriter::GetInput() const
{
  return itkDynamicCastInDebugMode<const InputType *>(this->GetPrimaryInput());
}

void
CaseResultFolderWriter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("There is no result: call SetInput() with the output of a CaseRegistration.");
  }
  Superclass::VerifyPreconditions();
}

void
CaseResultFolderWriter::Update()
{
  this->VerifyPreconditions();
  const_cast<InputType *>(this->GetInput())->Update();
  this->InvokeEvent(StartEvent());
  this->GenerateData();
  this->UpdateProgress(1.0F);
  this->InvokeEvent(EndEvent());
}

void
CaseResultFolderWriter::GenerateData()
{
  if (m_Folder == nullptr || m_Folder->GetName() != m_FolderName)
  {
    this->ClaimFolder();
  }
  const std::unique_ptr<OutputFolder> folder = std::move(m_Folder);
  CaseOutputOptions                   options;
  options.report = m_WriteReport;
  options.page = m_WritePage;
  options.anonymous = m_Anonymous;
  options.between = [this]() {
    this->InvokeEvent(ProgressEvent());
    if (this->GetAbortGenerateData())
    {
      throw ProcessAborted(__FILE__, __LINE__);
    }
  };
  if (m_CommandLine.empty())
  {
    WriteCaseResult(this->GetInput()->Get(), *folder, options);
    return;
  }
  CaseResult result = this->GetInput()->Get();
  result.commandLine = m_CommandLine;
  WriteCaseResult(result, *folder, options);
}

void
CaseResultFolderWriter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FolderName: " << m_FolderName << std::endl;
  os << indent << "Folder: " << (m_Folder == nullptr ? "none" : "owned") << std::endl;
  os << indent << "WriteReport: " << (m_WriteReport ? "On" : "Off") << std::endl;
  os << indent << "WritePage: " << (m_WritePage ? "On" : "Off") << std::endl;
  os << indent << "Anonymous: " << (m_Anonymous ? "On" : "Off") << std::endl;
  os << indent << "CommandLine: " << m_CommandLine.size() << " words" << std::endl;
}
} // namespace itk
