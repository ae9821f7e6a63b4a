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
#ifndef itkOverlayScene_h
#define itkOverlayScene_h

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
    std::vector<PointType> points;          /**< Continuous pixel indices. */
    bool                   closed{ false }; /**< Whether the last point is joined to the first. */
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
    RoleEnum                role{ RoleEnum::Fixed }; /**< What the colour follows. */
    std::string             label;                   /**< In the legend. */
    std::vector<StrokeType> strokes;                 /**< In the order in which they are drawn. */
  };
  /** Where a landmark is predicted and where it was marked; either may be unknown. */
  struct LandmarkType
  {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN(); /**< Not a number. */

    std::string name;                          /**< As its file names it. */
    PointType   predicted{ unknown, unknown }; /**< Continuous pixel index; unknown: not predicted. */
    PointType   reference{ unknown, unknown }; /**< Continuous pixel index; unknown: not marked. */
    /** Standard deviation an axis, pixels; 0: not known. */
    double sigma{ 0.0 };
  };

  /** Row-major radiograph; empty: a dark canvas. */
  std::vector<std::uint8_t> grey;
  int                       width{ 0 };
  int                       height{ 0 };
  /** mm a pixel in the detector plane; 0: unknown, no millimetre is then printed. */
  std::array<double, 2> pixelSpacing{ 0.0, 0.0 };

  std::vector<ContourType>  contours;  /**< Drawn over the radiograph. */
  std::vector<LandmarkType> landmarks; /**< Drawn over the contours. */
  /** In the first line of the picture's words. */
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
} // namespace itk

#endif
