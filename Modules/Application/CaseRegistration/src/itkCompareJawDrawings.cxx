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
#include "itkCompareJawDrawings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace itk
{
namespace
{
/** Factor between the distances of both drawings from the picture's corner from
 * which on they are of two copies: jaws lie over each other, and on the
 * smallest cuts of a radiograph an open mouth makes less of it. */
constexpr double SmallestCopyFactor = 1.5;
/** By which the factor between their sizes may differ from it: not all teeth
 * are drawn in both jaws. */
constexpr double Agreement = 1.35;
/** By which a factor may differ from that of the pixel spacing and be it all
 * the same. */
constexpr double Sameness = 1.15;

/** Middle and half diagonal of what was drawn, pixels. */
struct ExtentType
{
  std::array<double, 2> middle{ { 0.0, 0.0 } };
  double                radius{ 0.0 };
};

ExtentType
Measure(const DentalContour & contour)
{
  std::array<double, 2> low{ { std::numeric_limits<double>::max(), std::numeric_limits<double>::max() } };
  std::array<double, 2> high{ { std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest() } };
  for (const auto & polyline : contour.GetPolylines())
  {
    for (const auto & point : polyline.points)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        low[d] = std::min(low[d], point[d]);
        high[d] = std::max(high[d], point[d]);
      }
    }
  }
  ExtentType extent;
  for (unsigned int d = 0; d < 2; ++d)
  {
    extent.middle[d] = 0.5 * (low[d] + high[d]);
  }
  extent.radius = 0.5 * std::hypot(high[0] - low[0], high[1] - low[1]);
  return extent;
}
} // namespace

std::string
CompareJawDrawings(const DentalCaseData & data)
{
  const DentalContour * contours[2] = { data.upper.contour.GetPointer(), data.lower.contour.GetPointer() };
  ExtentType            extents[2];
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    if (contours[jaw] == nullptr || contours[jaw]->GetNumberOfPoints() < 2)
    {
      return std::string();
    }
    extents[jaw] = Measure(*contours[jaw]);
    if (!(extents[jaw].radius > 0.0))
    {
      return std::string();
    }
  }
  const double       distances[2] = { std::hypot(extents[0].middle[0], extents[0].middle[1]),
                                      std::hypot(extents[1].middle[0], extents[1].middle[1]) };
  const unsigned int small = distances[0] < distances[1] ? 0 : 1;
  const double       factor = distances[1 - small] / distances[small];
  const double       sizes = extents[1 - small].radius / extents[small].radius;
  const double       apart =
    std::hypot(extents[0].middle[0] - extents[1].middle[0], extents[0].middle[1] - extents[1].middle[1]);
  if (factor < SmallestCopyFactor || sizes < factor / Agreement || sizes > factor * Agreement ||
      apart < 2.0 * extents[1 - small].radius)
  {
    return std::string();
  }
  const auto   spacing = data.geometry->GetPixelSpacing();
  const double perPixel = std::sqrt(spacing[0] * spacing[1]);
  const bool   isMillimetres =
    data.HasPixelSpacing() && factor * perPixel < Sameness && factor * perPixel > 1.0 / Sameness;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  const char * const names[2] = { "upper", "lower" };
  text << "contours: what was drawn of the " << names[small] << " jaw is " << std::fixed << std::setprecision(2)
       << 1.0 / factor
       << " times as far from the picture's corner, and about as much smaller, "
          "as what was drawn of the "
       << names[1 - small] << " jaw: "
       << (isMillimetres ? "is it in mm? Give pixels"
                         : "was one of them drawn on a copy of the radiograph "
                           "of another size, or in mm? Give both in "
                           "pixels of the radiograph");
  return text.str();
}
} // namespace itk
