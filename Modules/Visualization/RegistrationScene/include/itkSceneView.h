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
#ifndef itkSceneView_h
#define itkSceneView_h

#include "itkDentalContour.h"
#include "itkFirstViewName.h"
#include "itkToothCode.h"

#include "itkImage.h"
#include "itkPoint.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** A place on a scan and where it is seen. */
struct SceneLandmark
{
  std::string name; /**< As its file names it. */
  /** Frame of the scene, mm. */
  Point<double, 3> point;
  /** Continuous pixel index. */
  std::array<double, 2> pixel{ { 0.0, 0.0 } };
};

/** What one radiograph has of one jaw. */
struct SceneViewJaw
{
  /** Continuous pixel indices; null where nothing was drawn. */
  DentalContour::ConstPointer tracing;
  /** As SceneView::projection, where this jaw has one of its own: a similarity for each jaw, as the paper's method
   * finds them, is no pose. */
  std::optional<std::array<double, 12>> projection;
  std::vector<SceneLandmark>            landmarks;
};

/** \struct SceneView
 * \brief One radiograph of a scene. A scene has any number of them.
 *
 * Nothing here says from which side the picture was taken: the matrix does.
 *
 * \ingroup RegistrationScene
 */
struct SceneView
{
  using ImageType = Image<float, 2>;

  /** "lateral", "frontal": the first word of the names of its parts. */
  std::string name{ FirstViewName };
  /** Row-major 3x4: frame of the scene (mm) to homogeneous continuous pixel index, the scale that was found included.
   */
  std::array<double, 12> projection{};
  /** mm. */
  double sourceToDetector{ 0.0 };
  /** Null without a radiograph. */
  ImageType::ConstPointer radiograph;
  /** Width and height, pixels; {0, 0} where nobody knows: the detector is then as large as what is seen on it. */
  std::array<unsigned int, 2>                imageSize{ { 0, 0 } };
  std::map<ToothCode::JawEnum, SceneViewJaw> jaws;
};
} // namespace itk

#endif
