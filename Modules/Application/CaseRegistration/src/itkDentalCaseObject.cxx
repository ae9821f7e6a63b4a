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
#include "itkDentalCaseObject.h"

#include <utility>

namespace itk
{
void
DentalCaseObject::Set(DataPointer data)
{
  if (m_Data != data)
  {
    m_Data = std::move(data);
    this->Modified();
  }
}

void
DentalCaseObject::Initialize()
{
  Superclass::Initialize();
  m_Data.reset();
}

void
DentalCaseObject::Graft(const DataObject * data)
{
  const auto * other = dynamic_cast<const Self *>(data);
  if (other == nullptr)
  {
    itkExceptionMacro("Graft() takes a DentalCaseObject.");
  }
  Superclass::Graft(data);
  this->Set(other->m_Data);
}

void
DentalCaseObject::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Data: " << (m_Data ? m_Data->description.fileName : "(none)") << std::endl;
}
} // namespace itk
