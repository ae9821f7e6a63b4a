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
#include "itkDentalFrameObject.h"

namespace itk
{
void
DentalFrameObject::Set(const DentalFrameResult & frames)
{
  m_Frames = frames;
  this->Modified();
}

void
DentalFrameObject::Initialize()
{
  Superclass::Initialize();
  m_Frames = DentalFrameResult();
}

void
DentalFrameObject::Graft(const DataObject * data)
{
  const auto * other = dynamic_cast<const Self *>(data);
  if (other == nullptr)
  {
    itkExceptionMacro("Graft() takes a DentalFrameObject.");
  }
  Superclass::Graft(data);
  this->Set(other->m_Frames);
}

void
DentalFrameObject::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Upper: " << (m_Frames.upper.valid ? "valid" : "(none)") << std::endl;
  os << indent << "Lower: " << (m_Frames.lower.valid ? "valid" : "(none)") << std::endl;
  os << indent << "JawsShareFrame: " << (m_Frames.jawsShareFrame ? "On" : "Off") << std::endl;
}
} // namespace itk
