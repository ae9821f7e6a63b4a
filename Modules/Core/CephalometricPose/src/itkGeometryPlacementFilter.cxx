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
#include "itkGeometryPlacementFilter.h"

namespace itk
{
GeometryPlacementFilter::GeometryPlacementFilter()
{
  this->AddRequiredInputName("Geometry", 0);
  this->AddRequiredInputName("Frame", 1);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

GeometryPlacementFilter::DataObjectPointer
GeometryPlacementFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return GeometryType::New().GetPointer();
}

GeometryPlacementFilter::GeometryType *
GeometryPlacementFilter::GetOutput()
{
  return itkDynamicCastInDebugMode<GeometryType *>(this->ProcessObject::GetOutput(0));
}

void
GeometryPlacementFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetGeometry() == nullptr)
  {
    itkExceptionMacro("No geometry: call SetGeometry() with that of the radiograph.");
  }
  if (this->GetFrame() == nullptr)
  {
    itkExceptionMacro("No frame: call SetFrame() with a rigid transform, as UMidlineDentalAxisFilter gives it.");
  }
  Superclass::VerifyPreconditions();
}

void
GeometryPlacementFilter::GenerateData()
{
  const auto * frame = this->GetFrame()->Get();
  if (frame == nullptr)
  {
    itkExceptionMacro("The frame is empty: give SetFrame() the transform of a jaw whose arch was found.");
  }
  GeometryType * output = this->GetOutput();
  output->CopyParameters(this->GetGeometry());
  if (m_CentralRayThroughOrigin)
  {
    GeometryType::PixelIndexType origin;
    origin.Fill(0.0);
    output->SetPrincipalPoint(origin);
  }
  output->SetPose(frame->GetMatrix(), frame->GetOffset());
}

void
GeometryPlacementFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "CentralRayThroughOrigin: " << (m_CentralRayThroughOrigin ? "On" : "Off") << std::endl;
}
} // namespace itk
