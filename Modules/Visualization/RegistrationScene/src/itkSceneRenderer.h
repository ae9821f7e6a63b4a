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
#ifndef itkSceneRenderer_h
#define itkSceneRenderer_h

#include "itkRegistrationScene.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** Solid things have shades; what is drawn, and a radiograph, is as bright as it is from wherever one looks. */
bool
IsLit(ScenePartEnum kind);

/** \class SceneRenderer
 * \brief VTK's renderer with an actor for each part of a scene, and cameras.
 * \ingroup RegistrationScene */
class SceneRenderer
{
public:
  SceneRenderer(const RegistrationScene & scene, bool legend);

  vtkRenderer *
  GetRenderer() const
  {
    return m_Renderer;
  }

  static std::vector<std::string>
  GetCameras(const RegistrationScene & scene);

  /** Throws an ExceptionObject that lists the cameras where there is none of that name. `aspect` is the window's width
   * by its height. */
  void
  SetCamera(const std::string & name, double aspect);

  /** Shows what is hidden, and hides what is shown, of the parts of that kind. */
  void
  Toggle(ScenePartEnum kind);

private:
  void
  AddLegend();
  void
  LookFrom(std::array<double, 3> direction, const std::array<double, 3> & up, double aspect, bool withSources = false);
  void
  LookFromSource(const std::string & view, double aspect, bool onlyTeeth);

  RegistrationScene::ConstPointer                                  m_Scene;
  vtkSmartPointer<vtkRenderer>                                     m_Renderer;
  std::vector<std::pair<ScenePartEnum, vtkSmartPointer<vtkActor>>> m_Actors;
};
} // namespace itk

#endif
