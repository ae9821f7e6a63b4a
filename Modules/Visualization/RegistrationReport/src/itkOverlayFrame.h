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
#ifndef itkOverlayFrame_h
#define itkOverlayFrame_h

#include "itkOverlayGeometry.h"

#include <cmath>

// How the picture is parted: layout and painter must divide it alike, so both ask here. Private to this module.
namespace itk
{
namespace OverlayDrawing
{
/** The parts of a picture: title on top, the radiograph's view left, the panel with text right, and the size of the
 * font that fits it. */
struct Frame
{
  Box    header;
  Box    view;
  Box    panel;
  double font;
};

/** Throws std::invalid_argument for a size below 320 x 240 or above 16384. */
Frame
MakeFrame(int width, int height);

/** Whether lengths on the detector can be said in millimetres. */
inline bool
KnowsSpacing(const OverlayScene & scene)
{
  return scene.pixelSpacing[0] > 0.0 && scene.pixelSpacing[1] > 0.0 && std::isfinite(scene.pixelSpacing[0]) &&
         std::isfinite(scene.pixelSpacing[1]);
}
} // namespace OverlayDrawing
} // namespace itk

#endif
