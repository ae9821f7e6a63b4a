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
#include "itkOverlayFrame.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace itk
{
namespace OverlayDrawing
{
Frame
MakeFrame(int width, int height)
{
  if (width < 320 || height < 240 || width > 16384 || height > 16384)
  {
    throw std::invalid_argument("An overlay of " + std::to_string(width) + " x " + std::to_string(height) +
                                " pixels is asked for; give at least 320 x 240 and at most 16384 x 16384.");
  }
  Frame        frame;
  const double panel = std::clamp(std::round(0.27 * width), 150.0, 380.0);
  frame.font = std::clamp(std::round(0.5 * (panel / 24.0 + height / 60.0)), 9.0, 15.0);
  const double header = std::round(3.4 * frame.font);
  frame.header = { 0.0, 0.0, static_cast<double>(width), header };
  frame.view = { 0.0, header, width - panel, height - header };
  frame.panel = { width - panel, header, panel, height - header };
  return frame;
}
} // namespace OverlayDrawing
} // namespace itk
