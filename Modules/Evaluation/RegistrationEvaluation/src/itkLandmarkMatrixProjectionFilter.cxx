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
#include "itkLandmarkMatrixProjectionFilter.h"

namespace itk
{
LandmarkMatrixProjectionFilter::LandmarkMatrixProjectionFilter()
{
  this->AddRequiredInputName("Landmarks", 0);
  this->AddRequiredInputName("ProjectionMatrix", 1);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

LandmarkMatrixProjectionFilter::DataObjectPointer
LandmarkMatrixProjectionFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

LandmarkMatrixProjectionFilter::OutputType *
LandmarkMatrixProjectionFilter::GetOutput()
{
  return itkDynamicCastInDebugMode<OutputType *>(this->ProcessObject::GetOutput(0));
}

void
LandmarkMatrixProjectionFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetLandmarks() == nullptr)
  {
    itkExceptionMacro("No landmarks: call SetLandmarks() with those of the scan.");
  }
  if (this->GetProjectionMatrixInput() == nullptr)
  {
    itkExceptionMacro("No projection: call SetProjectionMatrix() with that of a registration.");
  }
  Superclass::VerifyPreconditions();
}

void
LandmarkMatrixProjectionFilter::GenerateData()
{
  const ProjectionMatrixType & m = this->GetProjectionMatrix();
  OutputType *                 output = this->GetOutput();
  output->Initialize();
  for (const auto & landmark : this->GetLandmarks()->GetLandmarks())
  {
    if (m_Jaw != JawEnum::Unknown && landmark.tooth.GetJaw() != m_Jaw)
    {
      continue;
    }
    double sums[3];
    for (unsigned int row = 0; row < 3; ++row)
    {
      sums[row] =
        m(row, 0) * landmark.point[0] + m(row, 1) * landmark.point[1] + m(row, 2) * landmark.point[2] + m(row, 3);
    }
    OutputType::PointType place;
    place[0] = sums[0] / sums[2];
    place[1] = sums[1] / sums[2];
    output->AddLandmark(landmark.name, place);
  }
}

void
LandmarkMatrixProjectionFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Jaw: " << static_cast<int>(m_Jaw) << std::endl;
}
} // namespace itk
