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

#include "RegistrationReportExport.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace itk
{
/** \struct OverlayScene
 * \brief What an overlay shows, as plain data. Free of ITK headers.
 *
 * Coordinates are continuous pixel indices of the radiograph (0 = centre of the first pixel). Points that are not
 * finite are left out, whatever lies outside of the view is clipped.
 *
 * \ingroup RegistrationReport
 */
struct OverlayScene
{
  using PointType = std::array<double, 2>;
  /** One polyline. */
  struct StrokeType
  {
    std::vector<PointType> points;
    bool                   closed{ false };
  };
  enum class RoleEnum : std::uint8_t
  {
    /** The tracing on the radiograph: blue. */
    Fixed,
    /** The aligned contour of the scan: orange. */
    Moving,
    /** Any other contour of the scan: thin and pale. */
    Secondary
  };
  /** Polylines of one role, with their name in the legend. */
  struct ContourType
  {
    RoleEnum                role{ RoleEnum::Fixed };
    std::string             label;
    std::vector<StrokeType> strokes;
  };
  /** Where a landmark is predicted and where it was marked; either may be unknown. */
  struct LandmarkType
  {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    std::string name;
    PointType   predicted{ unknown, unknown };
    PointType   reference{ unknown, unknown };
    /** Standard deviation an axis, pixels; 0: not known. */
    double sigma{ 0.0 };
  };

  /** Row-major radiograph; empty: a dark canvas. */
  std::vector<std::uint8_t> grey;
  int                       width{ 0 };
  int                       height{ 0 };
  /** mm a pixel in the detector plane; 0: unknown, no millimetre is then printed. */
  std::array<double, 2> pixelSpacing{ 0.0, 0.0 };

  std::vector<ContourType>  contours;
  std::vector<LandmarkType> landmarks;

  std::string title;
  /** "ok", "suspect" or "failed" are coloured; empty: no badge. */
  std::string              status;
  std::vector<std::string> lines;

  /** The part of the radiograph to show: first and last pixel index of u, then of v; all 0: around tracing and
   * landmarks. */
  std::array<double, 4> view{ 0.0, 0.0, 0.0, 0.0 };
  /** Free border around tracing and landmarks, as a part of their larger extent. */
  double margin{ 0.2 };
};

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

/** Colours of an overlay (Okabe, Ito 2008: told apart with any colour vision), red, green, blue. */
namespace OverlayColour
{
constexpr std::array<std::uint8_t, 3> Tracing{ 86, 180, 233 };
constexpr std::array<std::uint8_t, 3> Silhouette{ 230, 159, 0 };
constexpr std::array<std::uint8_t, 3> Secondary{ 204, 190, 170 };
constexpr std::array<std::uint8_t, 3> Error{ 240, 228, 66 };
constexpr std::array<std::uint8_t, 3> Background{ 24, 26, 30 };
} // namespace OverlayColour

/** \return where a picture of this size shows what of the scene. Throws std::invalid_argument for a size below 320 x
 * 240 or above 16384. */
RegistrationReport_EXPORT OverlayLayout
LayOutOverlay(const OverlayScene & scene, int width, int height);

/** Paints the scene: title and badge on top, the radiograph with the overlay left, on the right text, legend, table of
 * errors and a small picture of the whole radiograph. Anti-aliased; needs no screen; the same bits for the same scene
 * and fonts (DejaVu Sans). Throws std::invalid_argument as LayOutOverlay() does, or where the radiograph's array does
 * not fit its size, std::runtime_error where the drawing library fails.
 * \return row-major red, green, blue. */
RegistrationReport_EXPORT std::vector<std::uint8_t>
                          PaintOverlay(const OverlayScene & scene, int width, int height);
} // namespace itk

#endif
