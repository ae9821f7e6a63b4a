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
#include "itkCaseLandmarkErrorFilter.h"

#include "itkDentalCaseLoader.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkMeasureLandmarkErrors.h"

#include <filesystem>
#include <memory>
#include <string>

namespace itk
{
CaseLandmarkErrorFilter::CaseLandmarkErrorFilter()
{
  this->SetNumberOfRequiredInputs(1);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

CaseLandmarkErrorFilter::DataObjectPointer
CaseLandmarkErrorFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

void
CaseLandmarkErrorFilter::SetInput(const InputType * input)
{
  this->ProcessObject::SetNthInput(0, const_cast<InputType *>(input));
}

const CaseLandmarkErrorFilter::InputType *
CaseLandmarkErrorFilter::GetInput() const
{
  return itkDynamicCastInDebugMode<const InputType *>(this->GetPrimaryInput());
}

CaseLandmarkErrorFilter::OutputType *
CaseLandmarkErrorFilter::GetOutput()
{
  return itkDynamicCastInDebugMode<OutputType *>(this->ProcessObject::GetOutput(0));
}

void
CaseLandmarkErrorFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("There is no result: call SetInput() with the output of a CaseRegistration.");
  }
  Superclass::VerifyPreconditions();
}

void
CaseLandmarkErrorFilter::GenerateData()
{
  CaseResult result = this->GetInput()->Get();
  // Of the first radiograph, or of a view: nothing before this has opened the file.
  const auto measure = [&result](const std::string & field, CaseResult & own) {
    const DentalCase & description = own.data->description;
    auto               reader = DentalLandmarkFileReader<2>::New();
    reader->SetFileName(description.landmarks2DFile);
    if (description.numbering)
    {
      reader->SetNumbering(*description.numbering);
    }
    PrepareReader(description, *own.data, *reader);
    reader->Update();
    result.inputs.push_back(
      MakeCaseInputFile(field,
                        description.landmarks2DFile,
                        std::filesystem::path(result.data->description.fileName).parent_path().string()));
    result.warnings.insert(result.warnings.end(), reader->GetWarnings().begin(), reader->GetWarnings().end());
    const auto known = static_cast<std::ptrdiff_t>(own.warnings.size());
    MeasureLandmarkErrors(own, reader->GetOutput());
    if (&own != &result)
    {
      // A view's result is shown as part of the case's, whose warnings are read.
      result.warnings.insert(result.warnings.end(), own.warnings.begin() + known, own.warnings.end());
    }
    own.markedLandmarks = reader->GetOutput();
  };
  if (result.data && !result.data->description.landmarks2DFile.empty())
  {
    measure("landmarks_2d", result);
  }
  for (CaseViewResult & view : result.views)
  {
    if (!view.result->data->description.landmarks2DFile.empty())
    {
      // Its own: what it came from goes on without errors.
      view.result = std::make_shared<CaseResult>(*view.result);
      measure("views." + view.name + ".landmarks_2d", *view.result);
    }
  }
  this->GetOutput()->Set(result);
}
} // namespace itk
