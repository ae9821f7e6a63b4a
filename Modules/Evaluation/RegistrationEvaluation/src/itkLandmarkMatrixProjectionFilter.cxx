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

#include "itkPerspectiveProjection.h"

#include <cmath>

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
  PerspectiveProjection        projection;
  for (unsigned int k = 0; k < 12; ++k)
  {
    projection.matrix[k] = m(k / 4, k % 4);
  }
  OutputType * output = this->GetOutput();
  output->Initialize();
  for (const auto & landmark : this->GetLandmarks()->GetLandmarks())
  {
    if (m_Jaw != JawEnum::Unknown && landmark.tooth.GetJaw() != m_Jaw)
    {
      continue;
    }
    OutputType::PointType place;
    projection.Project(landmark.point.GetDataPointer(), place[0], place[1]);
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
    {
      itkExceptionMacro("The matrix projects landmark " << landmark.name << " to " << place
                                                        << ": it is none of a registration of this scan, see "
                                                           "SetProjectionMatrix().");
    }
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
