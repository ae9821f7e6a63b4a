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
#ifndef itkScenePart_h
#define itkScenePart_h

#include "itkImage.h"
#include "itkMesh.h"

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace itk
{
/** What a part of a scene is, of whichever jaw and view. */
enum class ScenePartEnum : uint8_t
{
  Scan,
  /** One axis of the frame of a dental arch: x anterior, y to the patient's left, z superior. */
  Axis,
  /** A plane of that frame. */
  Plane,
  Source,
  CentralRay,
  /** From the source through landmarks of a scan to the detector. */
  Rays,
  Detector,
  Tracing,
  Silhouette
};

/** \struct ScenePart
 * \brief A named piece of a scene with its look: triangles or lines in the frame of the scene, mm.
 *
 * Kept as an itk::Mesh, so that whoever shows it, with VTK or with anything else, needs no other type.
 *
 * \ingroup RegistrationScene
 */
struct ScenePart
{
  using MeshType = Mesh<float, 3>;
  using PictureType = Image<unsigned char, 2>;

  /** Unique in its scene: "upper scan", "lateral detector", "lateral upper tracing". */
  std::string   name;
  ScenePartEnum kind{ ScenePartEnum::Scan };
  /** Triangle or line cells. Where its points belong to teeth their data are FDI numbers, 0 for none. */
  MeshType::Pointer mesh;
  /** Red, green, blue, 0 to 1. */
  std::array<double, 3> color{ { 1.0, 1.0, 1.0 } };
  /** 0 to 1. */
  double opacity{ 1.0 };
  /** Pixels of the screen; of lines alone. */
  double lineWidth{ 1.0 };
  /** Of the detector, where there is a radiograph: the picture on it, and for each point of the mesh the place in the
   * picture, from (0, 0) at its upper left corner to (1, 1) at its lower right. */
  PictureType::Pointer              picture;
  std::vector<std::array<float, 2>> pictureCoordinates;
  /** Whether its points have tooth labels. */
  bool
  HasTeeth() const
  {
    return mesh->GetPointData() != nullptr && mesh->GetPointData()->Size() > 0;
  }
};
} // namespace itk

#endif
