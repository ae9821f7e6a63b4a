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
#ifndef itkArchLine_h
#define itkArchLine_h

#include "itkTriangleSurface.h"

#include <array>
#include <vector>

namespace itk
{
namespace CrownRegionParts
{
/** Between stations along the arch, mm. */
constexpr double StationSpacing = 0.5;

/** The middle line of the arch as stations, and where a direction from the centre meets it. */
struct Arch
{
  double                             centre[2]{};
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<double, 2>> tangents;
  std::vector<double>                radii;
  std::vector<double>                angles;
  /** Index of the station at the front. */
  double front{ 0.0 };
  /** Station by angle from -pi, steps of a quarter of a degree. */
  std::vector<double> lookup;

  static constexpr unsigned int LookupSize = 1440;

  /** Station (fractional; none: below 0) and radial distance of the middle line in the point's direction. */
  double
  Station(double x, double y, double & offset) const;

  /** Tangents, angles, radii and the lookup, from the points and the centre. */
  void
  MakeLookup();
};

/** Middle line through the crowns' tops (depth below 4 mm), by sectors about the centre. */
bool
FindArch(const std::vector<TriangleSurface::PointType> & q,
         const std::vector<double> &                     areas,
         const std::vector<float> &                      depth,
         Arch &                                          arch);
} // namespace CrownRegionParts
} // namespace itk

#endif
