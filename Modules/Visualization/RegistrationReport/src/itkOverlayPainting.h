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
#ifndef itkOverlayPainting_h
#define itkOverlayPainting_h

#include "itkOverlayFrame.h"
#include "itkOverlayLayout.h"

#include <cstdint>
#include <vector>

// What PaintOverlay() does of the drawing itself, in a library of its own: cairo brings seventeen libraries, of windows
// and fonts for the most part, and half of the program's verbs draw nothing. Private to this module.
extern "C" __attribute__((visibility("default"))) void
DentalSCRPaintOverlay(const itk::OverlayScene &          scene,
                      const itk::OverlayLayout &         layout,
                      const itk::OverlayDrawing::Frame & frame,
                      int                                width,
                      int                                height,
                      std::vector<std::uint8_t> &        pixels);

#endif
