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
#include "itkOverlayPainter.h"

#include "itkOverlayPainting.h"

#ifdef DENTALSCR_PAINTING_LIBRARY
#  include "itkLoadLibraryFunction.h"
#endif

#include <stdexcept>
#include <string>

namespace itk
{
std::vector<std::uint8_t>
PaintOverlay(const OverlayScene & scene, int width, int height)
{
  const OverlayLayout         layout = LayOutOverlay(scene, width, height);
  const OverlayDrawing::Frame frame = OverlayDrawing::MakeFrame(width, height);
  const bool                  picture = !scene.grey.empty();
  if (scene.width < 0 || scene.height < 0 || scene.width > 32767 || scene.height > 32767 ||
      (picture && scene.grey.size() != static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height)))
  {
    throw std::invalid_argument("The radiograph has " + std::to_string(scene.grey.size()) +
                                " pixels, which do not fit " + std::to_string(scene.width) + " x " +
                                std::to_string(scene.height) + " (at most 32767 a side).");
  }
#ifdef DENTALSCR_PAINTING_LIBRARY
  static const auto paint =
    LoadLibraryFunction<decltype(&DentalSCRPaintOverlay)>(DENTALSCR_PAINTING_LIBRARY,
                                                          "DentalSCRPaintOverlay",
                                                          "Overlays cannot be drawn",
                                                          DENTALSCR_PAINTING_LIBRARY " and cairo");
#else
  constexpr auto paint = DentalSCRPaintOverlay;
#endif
  std::vector<std::uint8_t> pixels;
  paint(scene, layout, frame, width, height, pixels);
  return pixels;
}
} // namespace itk
