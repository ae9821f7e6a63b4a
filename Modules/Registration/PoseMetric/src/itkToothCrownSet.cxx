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
#include "itkToothCrownSet.h"

#include <algorithm>
#include <stdexcept>

namespace itk
{
void
ToothCrownSet::Add(const CrownType & crown)
{
  if (!crown.tooth.IsKnown())
  {
    throw std::invalid_argument("a crown is of a tooth: its code is not known");
  }
  if (this->Find(crown.tooth) != nullptr)
  {
    throw std::invalid_argument("there is a crown of " + crown.tooth.GetName() + " already");
  }
  if (crown.surface == nullptr || crown.surface->triangles.empty())
  {
    throw std::invalid_argument("the crown of " + crown.tooth.GetName() + " has no triangle");
  }
  m_Crowns.push_back(crown);
  this->Modified();
}

auto
ToothCrownSet::Find(const ToothCode & tooth) const -> const CrownType *
{
  const auto found =
    std::find_if(m_Crowns.begin(), m_Crowns.end(), [&](const auto & crown) { return crown.tooth == tooth; });
  return found == m_Crowns.end() ? nullptr : &*found;
}

void
ToothCrownSet::Initialize()
{
  Superclass::Initialize();
  m_Crowns.clear();
}

void
ToothCrownSet::Graft(const DataObject * data)
{
  const auto * other = dynamic_cast<const Self *>(data);
  if (other == nullptr)
  {
    itkExceptionMacro("Graft() needs a ToothCrownSet.");
  }
  m_Crowns = other->m_Crowns;
  this->Modified();
}

void
ToothCrownSet::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  for (const CrownType & crown : m_Crowns)
  {
    os << indent << crown.tooth.GetName() << " (" << crown.source << "): " << crown.surface->triangles.size()
       << " triangles, sigma along the arch " << crown.sigmaAlong << " mm" << std::endl;
  }
}
} // namespace itk
