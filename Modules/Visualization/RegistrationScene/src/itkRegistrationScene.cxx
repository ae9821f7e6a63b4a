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
#include "itkRegistrationScene.h"

#include <algorithm>

namespace itk
{
void
RegistrationScene::Set(PartsType parts, DetectorsType detectors)
{
  m_Parts = std::move(parts);
  m_Detectors = std::move(detectors);
  this->Modified();
}

const ScenePart *
RegistrationScene::FindPart(const std::string & name) const
{
  const auto found =
    std::find_if(m_Parts.begin(), m_Parts.end(), [&](const ScenePart & part) { return part.name == name; });
  return found == m_Parts.end() ? nullptr : &*found;
}

const SceneDetector *
RegistrationScene::FindDetector(const std::string & view) const
{
  const auto found =
    std::find_if(m_Detectors.begin(), m_Detectors.end(), [&](const auto & entry) { return entry.first == view; });
  return found == m_Detectors.end() ? nullptr : &found->second;
}

void
RegistrationScene::Initialize()
{
  Superclass::Initialize();
  m_Parts.clear();
  m_Detectors.clear();
}

void
RegistrationScene::Graft(const DataObject * data)
{
  const auto * other = dynamic_cast<const Self *>(data);
  if (other == nullptr)
  {
    itkExceptionMacro("A " << (data == nullptr ? "null pointer" : data->GetNameOfClass())
                           << " cannot be grafted: give a RegistrationScene.");
  }
  this->Set(other->m_Parts, other->m_Detectors);
}

void
RegistrationScene::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Parts:" << std::endl;
  for (const ScenePart & part : m_Parts)
  {
    os << indent.GetNextIndent() << part.name << " (" << part.kind << "): " << part.mesh->GetNumberOfPoints()
       << " points, " << part.mesh->GetNumberOfCells() << " cells" << std::endl;
  }
  os << indent << "Detectors:" << std::endl;
  for (const auto & detector : m_Detectors)
  {
    os << indent.GetNextIndent() << detector.first << ": source " << detector.second.GetSource() << std::endl;
  }
}

std::ostream &
operator<<(std::ostream & os, ScenePartEnum kind)
{
  switch (kind)
  {
    case ScenePartEnum::Scan:
      return os << "scan";
    case ScenePartEnum::Axis:
      return os << "axis";
    case ScenePartEnum::Plane:
      return os << "plane";
    case ScenePartEnum::Source:
      return os << "source";
    case ScenePartEnum::CentralRay:
      return os << "central ray";
    case ScenePartEnum::Rays:
      return os << "rays";
    case ScenePartEnum::Detector:
      return os << "detector";
    case ScenePartEnum::Tracing:
      return os << "tracing";
    default:
      return os << "silhouette";
  }
}
} // namespace itk
