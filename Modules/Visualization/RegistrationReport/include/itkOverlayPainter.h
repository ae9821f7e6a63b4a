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
#ifndef itkOverlayPainter_h
#define itkOverlayPainter_h

#include "itkOverlayLayout.h"
#include "itkOverlayScene.h"
#include "RegistrationReportExport.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** Colours of an overlay (Okabe, Ito 2008: told apart with any colour vision), red, green, blue. */
namespace OverlayColour
{
constexpr std::array<std::uint8_t, 3> Tracing{ 86, 180, 233 };    /**< Sky blue: what was drawn. */
constexpr std::array<std::uint8_t, 3> Silhouette{ 230, 159, 0 };  /**< Orange: the scan's. */
constexpr std::array<std::uint8_t, 3> Secondary{ 204, 190, 170 }; /**< Grey: other roles. */
constexpr std::array<std::uint8_t, 3> Error{ 240, 228, 66 };      /**< Yellow: an error. */
constexpr std::array<std::uint8_t, 3> Background{ 24, 26, 30 };   /**< Where no picture is. */
} // namespace OverlayColour

/** Paints the scene: title and badge on top, the radiograph with the overlay left, on the right text, legend, table of
 * errors and a small picture of the whole radiograph. Anti-aliased; needs no screen; the same bits for the same scene
 * and fonts (DejaVu Sans). Throws std::invalid_argument as LayOutOverlay() does, or where the radiograph's array does
 * not fit its size, std::runtime_error where the drawing library fails.
 * \return row-major red, green, blue. */
RegistrationReport_EXPORT std::vector<std::uint8_t>
                          PaintOverlay(const OverlayScene & scene, int width, int height);
} // namespace itk

#endif
