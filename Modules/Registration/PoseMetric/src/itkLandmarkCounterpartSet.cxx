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
#include "itkLandmarkCounterpartSet.h"

#include <algorithm>
#include <stdexcept>

namespace itk
{
void
LandmarkCounterpartSet::Add(const CounterpartType & counterpart)
{
  if (this->Find(counterpart.name) != nullptr)
  {
    throw std::invalid_argument("there is a counterpart of \"" + counterpart.name + "\" already");
  }
  if (counterpart.points.empty() || counterpart.points.size() > 2)
  {
    throw std::invalid_argument("the counterpart of \"" + counterpart.name + "\" has " +
                                std::to_string(counterpart.points.size()) + " points; it is one, or one of each side");
  }
  m_Counterparts.push_back(counterpart);
  this->Modified();
}

auto
LandmarkCounterpartSet::Find(const std::string & name) const -> const CounterpartType *
{
  const auto found = std::find_if(
    m_Counterparts.begin(), m_Counterparts.end(), [&](const auto & counterpart) { return counterpart.name == name; });
  return found == m_Counterparts.end() ? nullptr : &*found;
}

void
LandmarkCounterpartSet::Initialize()
{
  Superclass::Initialize();
  m_Counterparts.clear();
}

void
LandmarkCounterpartSet::Graft(const DataObject * data)
{
  const auto * other = dynamic_cast<const Self *>(data);
  if (other == nullptr)
  {
    itkExceptionMacro("Graft() needs a LandmarkCounterpartSet.");
  }
  m_Counterparts = other->m_Counterparts;
  this->Modified();
}

void
LandmarkCounterpartSet::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  for (const CounterpartType & counterpart : m_Counterparts)
  {
    os << indent << counterpart.name << " (" << counterpart.source << "):";
    for (const PointType & point : counterpart.points)
    {
      os << ' ' << point;
    }
    os << (counterpart.rule == RuleEnum::Foremost ? ", foremost" : "") << ", sigma " << counterpart.sigmaAlong << " x "
       << counterpart.sigmaAcross << " mm" << std::endl;
  }
}
} // namespace itk
