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
#ifndef itkOverlayLayout_h
#define itkOverlayLayout_h

#include "itkOverlayScene.h"
#include "RegistrationReportExport.h"

#include <array>

namespace itk
{
/** \struct OverlayLayout
 * \brief Where the painter put the parts of an overlay: output pixel = scale * (index - first) + offset.
 *
 * \ingroup RegistrationReport
 */
struct RegistrationReport_EXPORT OverlayLayout
{
  /** The radiograph's part of the picture: x, y, width, height. */
  std::array<double, 4> view{ 0.0, 0.0, 0.0, 0.0 };
  std::array<double, 2> first{ 0.0, 0.0 };
  std::array<double, 2> scale{ 1.0, 1.0 };
  std::array<double, 2> offset{ 0.0, 0.0 };

  /** Continuous pixel index of the radiograph to continuous pixel index of the picture. */
  OverlayScene::PointType
  ToPicture(const OverlayScene::PointType & index) const;
};

/** \return where a picture of this size shows what of the scene. Throws std::invalid_argument for a size below 320 x
 * 240 or above 16384. */
RegistrationReport_EXPORT OverlayLayout
LayOutOverlay(const OverlayScene & scene, int width, int height);
} // namespace itk

#endif
