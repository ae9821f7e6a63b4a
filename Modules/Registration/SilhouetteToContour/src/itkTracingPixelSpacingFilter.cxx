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
#include "itkTracingPixelSpacingFilter.h"

#include "itkGeometryPlacementFilter.h"

#include <algorithm>

namespace itk
{
TracingPixelSpacingFilter::TracingPixelSpacingFilter()
{
  this->AddRequiredInputName("Geometry", 0);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

TracingPixelSpacingFilter::DataObjectPointer
TracingPixelSpacingFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return GeometryType::New().GetPointer();
}

TracingPixelSpacingFilter::GeometryType *
TracingPixelSpacingFilter::GetOutput()
{
  return itkDynamicCastInDebugMode<GeometryType *>(this->ProcessObject::GetOutput(0));
}

void
TracingPixelSpacingFilter::SetJaw(JawEnum             jaw,
                                  const MeshType *    mesh,
                                  const ContourType * contour,
                                  const FrameType *   frame)
{
  if (jaw == JawEnum::Upper)
  {
    this->SetUpperMesh(mesh);
    this->SetUpperContour(contour);
    this->SetUpperFrame(frame);
  }
  else
  {
    this->SetLowerMesh(mesh);
    this->SetLowerContour(contour);
    this->SetLowerFrame(frame);
  }
}

void
TracingPixelSpacingFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetGeometry() == nullptr)
  {
    itkExceptionMacro("No geometry: call SetGeometry() with the distances of the cephalostat.");
  }
  if (!(m_DefaultPixelSpacing > 0.0))
  {
    itkExceptionMacro("The spacing " << m_DefaultPixelSpacing
                                     << " mm is not positive: call SetDefaultPixelSpacing() with one.");
  }
  Superclass::VerifyPreconditions();
}

double
TracingPixelSpacingFilter::Measure(const MeshType * mesh, const ContourType * contour, const FrameType * frame) const
{
  const auto * box = contour->GetBoundingBox();
  const double width = box->GetMaximum()[0] - box->GetMinimum()[0];
  if (!(width > 0.0))
  {
    return m_DefaultPixelSpacing;
  }
  // Unit spacing makes the projection come out in mm of the detector plane.
  auto unit = GeometryType::New();
  unit->CopyParameters(this->GetGeometry());
  unit->SetPixelSpacing(GeometryType::PixelSpacingType(1.0));
  auto placement = GeometryPlacementFilter::New();
  placement->SetGeometry(unit);
  placement->SetFrame(frame);
  placement->CentralRayThroughOriginOn();
  placement->Update();
  const auto projection = placement->GetOutput()->GetProjection();
  double     low = NumericTraits<double>::max();
  double     high = NumericTraits<double>::NonpositiveMin();
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
  {
    const double point[3] = { it.Value()[0], it.Value()[1], it.Value()[2] };
    double       u = 0.0;
    double       v = 0.0;
    projection.Project(point, u, v);
    low = std::min(low, u);
    high = std::max(high, u);
  }
  return (high - low) / width;
}

void
TracingPixelSpacingFilter::GenerateData()
{
  double       sum = 0.0;
  unsigned int count = 0;
  const auto   add = [&](const MeshType * mesh, const ContourType * contour, const FrameType * frame) {
    if (mesh == nullptr || mesh->GetNumberOfPoints() == 0 || contour == nullptr || contour->GetNumberOfPoints() == 0 ||
        frame == nullptr || frame->Get() == nullptr)
    {
      return;
    }
    sum += this->Measure(mesh, contour, frame);
    ++count;
  };
  add(this->GetUpperMesh(), this->GetUpperContour(), this->GetUpperFrame());
  add(this->GetLowerMesh(), this->GetLowerContour(), this->GetLowerFrame());
  GeometryType * output = this->GetOutput();
  output->CopyParameters(this->GetGeometry());
  output->SetPixelSpacing(GeometryType::PixelSpacingType(count > 0 ? sum / count : m_DefaultPixelSpacing));
}

void
TracingPixelSpacingFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "DefaultPixelSpacing: " << m_DefaultPixelSpacing << std::endl;
}
} // namespace itk
