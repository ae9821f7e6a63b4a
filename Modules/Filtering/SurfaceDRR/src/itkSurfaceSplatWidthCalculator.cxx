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
#include "itkSurfaceSplatWidthCalculator.h"

#include "itkMakeTriangleSurface.h"

#include <algorithm>
#include <cmath>

namespace itk
{
SurfaceSplatWidthCalculator::SurfaceSplatWidthCalculator()
{
  this->AddRequiredInputName("Mesh", 0);
  this->AddRequiredInputName("Geometry", 1);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

SurfaceSplatWidthCalculator::DataObjectPointer
SurfaceSplatWidthCalculator::MakeOutput(DataObjectPointerArraySizeType)
{
  return RealObjectType::New().GetPointer();
}

SurfaceSplatWidthCalculator::RealObjectType *
SurfaceSplatWidthCalculator::GetSigmaOutput()
{
  return itkDynamicCastInDebugMode<RealObjectType *>(this->ProcessObject::GetOutput(0));
}

double
SurfaceSplatWidthCalculator::GetSigma() const
{
  return itkDynamicCastInDebugMode<const RealObjectType *>(this->ProcessObject::GetOutput(0))->Get();
}

void
SurfaceSplatWidthCalculator::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetMesh() == nullptr)
  {
    itkExceptionMacro("No mesh: call SetMesh() with the scan.");
  }
  if (this->GetGeometry() == nullptr)
  {
    itkExceptionMacro("No geometry: call SetGeometry() with that of the radiograph.");
  }
  if (!(m_WidthFactor > 0.0))
  {
    itkExceptionMacro("The factor " << m_WidthFactor << " is not positive: call SetWidthFactor() with one.");
  }
  Superclass::VerifyPreconditions();
}

void
SurfaceSplatWidthCalculator::GenerateData()
{
  const GeometryType * geometry = this->GetGeometry();
  if (!geometry->HasPixelSpacing())
  {
    itkExceptionMacro("The geometry has no pixel spacing: call its SetPixelSpacing().");
  }
  const TriangleSurface surface = MakeTriangleSurface(this->GetMesh());
  if (surface.points.empty())
  {
    itkExceptionMacro("The mesh has no points: give SetMesh() the scan of a jaw.");
  }
  const double area = surface.Area();
  const double magnification = geometry->GetSourceToDetectorDistance() / geometry->GetSourceToMidsagittalDistance();
  const double distance = magnification * std::sqrt(area / static_cast<double>(surface.points.size()));
  const auto & spacing = geometry->GetPixelSpacing();
  this->GetSigmaOutput()->Set(std::max(0.5 * (spacing[0] + spacing[1]), m_WidthFactor * distance));
}

void
SurfaceSplatWidthCalculator::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "WidthFactor: " << m_WidthFactor << std::endl;
}
} // namespace itk
