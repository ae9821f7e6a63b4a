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
#include "itkCephalogramView.h"

#include <algorithm>

namespace itk
{
ModifiedTimeType
CephalogramView::GetMTime() const
{
  ModifiedTimeType time = Superclass::GetMTime();
  for (const Object * part : { static_cast<const Object *>(m_Geometry.GetPointer()),
                               static_cast<const Object *>(m_UpperContour.GetPointer()),
                               static_cast<const Object *>(m_LowerContour.GetPointer()),
                               static_cast<const Object *>(m_CephalometricLandmarks.GetPointer()),
                               static_cast<const Object *>(m_LandmarkCounterparts.GetPointer()) })
  {
    time = part == nullptr ? time : std::max(time, part->GetMTime());
  }
  return time;
}

void
CephalogramView::Verify() const
{
  if (m_Name.empty())
  {
    itkExceptionMacro("The view has no name: call SetName().");
  }
  if (m_Geometry.IsNull())
  {
    itkExceptionMacro("The view \"" << m_Name << "\" has no geometry: call SetGeometry().");
  }
  m_Geometry->VerifyComplete();
  if (!(m_PrincipalPointSigma >= 0.0))
  {
    itkExceptionMacro("The principal point of the view \"" << m_Name << "\" is known to " << m_PrincipalPointSigma
                                                           << " px: give SetPrincipalPointSigma() 0 or more.");
  }
  const bool hasLandmarks = m_CephalometricLandmarks.IsNotNull() && m_LandmarkCounterparts.IsNotNull();
  if (m_UpperContour.IsNull() && m_LowerContour.IsNull() && !hasLandmarks)
  {
    itkExceptionMacro("Nothing was drawn on the view \""
                      << m_Name
                      << "\": call SetUpperContour() or SetLowerContour(), or SetCephalometricLandmarks() and "
                         "SetLandmarkCounterparts().");
  }
}

void
CephalogramView::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << m_Name << std::endl;
  itkPrintSelfObjectMacro(Geometry);
  itkPrintSelfObjectMacro(UpperContour);
  itkPrintSelfObjectMacro(LowerContour);
  itkPrintSelfObjectMacro(CephalometricLandmarks);
  itkPrintSelfObjectMacro(LandmarkCounterparts);
  os << indent << "SameHeadPosition: " << (m_SameHeadPosition ? "On" : "Off") << std::endl;
  os << indent << "PrincipalPointSigma: " << m_PrincipalPointSigma << std::endl;
  os << indent << "SpacingSource: " << static_cast<int>(m_SpacingSource) << std::endl;
}
} // namespace itk
