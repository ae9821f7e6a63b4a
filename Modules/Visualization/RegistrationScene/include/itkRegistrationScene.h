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
#ifndef itkRegistrationScene_h
#define itkRegistrationScene_h

#include "RegistrationSceneExport.h"
#include "itkSceneDetector.h"
#include "itkScenePart.h"

#include "itkDataObject.h"
#include "itkObjectFactory.h"

#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** \class RegistrationScene
 * \brief A registration in space: parts to show, and from where each radiograph was taken.
 *
 * The frame is the cephalostat's, mm: x anterior, y to the patient's left, z superior.
 *
 * \sa RegistrationSceneSource
 * \ingroup RegistrationScene
 */
class RegistrationScene_EXPORT RegistrationScene : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(RegistrationScene);

  using Self = RegistrationScene;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(RegistrationScene, DataObject);

  using PartsType = std::vector<ScenePart>;
  /** Name and detector of each radiograph. */
  using DetectorsType = std::vector<std::pair<std::string, SceneDetector>>;
  /** Everything that is shown, and from where: a detector each view, by its name. */
  void
  Set(PartsType parts, DetectorsType detectors);
  /** All parts, in the order in which they are drawn. */
  const PartsType &
  GetParts() const
  {
    return m_Parts;
  }
  /** Null where there is no part of that name. */
  const ScenePart *
  FindPart(const std::string & name) const;
  /** Where the source and the pixels of each radiograph are. */
  const DetectorsType &
  GetDetectors() const
  {
    return m_Detectors;
  }
  /** Null where there is no view of that name. */
  const SceneDetector *
  FindDetector(const std::string & view) const;

  void
  Initialize() override;
  void
  Graft(const DataObject * data) override;

protected:
  RegistrationScene() = default;
  ~RegistrationScene() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  PartsType     m_Parts;
  DetectorsType m_Detectors;
};

/** "scan", "axis", "plane", "source", "central ray", "rays", "detector", "tracing", "silhouette". */
RegistrationScene_EXPORT std::ostream &
                         operator<<(std::ostream & os, ScenePartEnum kind);
} // namespace itk

#endif
