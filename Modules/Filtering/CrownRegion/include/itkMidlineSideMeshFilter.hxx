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
#ifndef itkMidlineSideMeshFilter_hxx
#define itkMidlineSideMeshFilter_hxx

#include "itkMidlineSideMeshFilter.h"

#include "itkMakeTriangleSurface.h"
#include "itkMidlineSide.h"
#include "itkSelectMeshTriangles.h"

#include <algorithm>
#include <cmath>

namespace itk
{
template <typename TMesh>
MidlineSideMeshFilter<TMesh>::MidlineSideMeshFilter()
{
  this->AddRequiredInputName("FrameTransform");
}

template <typename TMesh>
void
MidlineSideMeshFilter<TMesh>::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("There is no mesh. Call SetInput().");
  }
  if (this->GetFrameTransformInput() == nullptr)
  {
    itkExceptionMacro(
      "There is no frame. Call SetFrameTransformInput() with the transform of UMidlineDentalAxisFilter, "
      "or SetFrameTransform().");
  }
  Superclass::VerifyPreconditions();
  if (!std::isfinite(m_Margin))
  {
    itkExceptionMacro("Margin is " << m_Margin << " mm. Call SetMargin() with a finite number.");
  }
}

template <typename TMesh>
void
MidlineSideMeshFilter<TMesh>::GenerateData()
{
  const MeshType *      input = this->GetInput();
  const TriangleSurface surface = MakeTriangleSurface(input);
  if (surface.triangles.empty())
  {
    itkExceptionMacro("The mesh has " << surface.points.size()
                                      << " points and no triangles. Set a triangle mesh of the jaw.");
  }
  // Known only once what makes the frame has run.
  if (this->GetFrameTransform() == nullptr)
  {
    itkExceptionMacro("The frame is empty: UMidlineDentalAxisFilter had no mesh of this jaw. Connect the transform of "
                      "the same jaw with SetFrameTransformInput().");
  }
  const DentalJawFrame frame = JawFrameFromTransform(*this->GetFrameTransform());
  this->UpdateProgress(0.3f);
  m_TriangleMask =
    SelectMidlineSide(surface, frame.axes[1], frame.origin, m_Side == SideEnum::Right ? 1.0 : -1.0, m_Margin);
  if (std::find(m_TriangleMask.begin(), m_TriangleMask.end(), std::uint8_t{ 1 }) == m_TriangleMask.end())
  {
    itkExceptionMacro("No triangle lies on the side " << m_Side << " of the midline with Margin " << m_Margin
                                                      << " mm. Check SetFrameTransform() and SetMargin().");
  }
  MeshType * output = this->GetOutput();
  output->Initialize();
  // All there is: without it every Update() would execute again.
  output->SetBufferedRegion(0);
  SelectMeshTriangles(input, m_TriangleMask, output);
  this->UpdateProgress(1.0f);
}

template <typename TMesh>
void
MidlineSideMeshFilter<TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Side: " << m_Side << std::endl;
  os << indent << "Margin: " << m_Margin << std::endl;
  os << indent << "TriangleMask: " << std::count(m_TriangleMask.begin(), m_TriangleMask.end(), std::uint8_t{ 1 })
     << " of " << m_TriangleMask.size() << std::endl;
}
} // namespace itk

#endif
