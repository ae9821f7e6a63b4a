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
#include "itkCaseResultObject.h"

namespace itk
{
void
CaseResultObject::Set(const CaseResult & result)
{
  m_Result = result;
  this->Modified();
}

void
CaseResultObject::Initialize()
{
  Superclass::Initialize();
  m_Result = CaseResult();
}

void
CaseResultObject::Graft(const DataObject * data)
{
  const auto * other = dynamic_cast<const Self *>(data);
  if (other == nullptr)
  {
    itkExceptionMacro("Graft() takes a CaseResultObject.");
  }
  Superclass::Graft(data);
  this->Set(other->m_Result);
}

void
CaseResultObject::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Status: " << ToString(m_Result.GetStatus()) << std::endl;
  os << indent << "Preset: " << ToString(m_Result.preset) << std::endl;
  os << indent << "Jaws: " << m_Result.jaws.size() << ", skipped " << m_Result.skipped.size() << std::endl;
}
} // namespace itk
