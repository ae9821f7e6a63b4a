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
#ifndef itkOcclusalSurfaceFit_h
#define itkOcclusalSurfaceFit_h

#include "itkTriangleSurface.h"

#include <array>
#include <vector>

namespace itk
{
namespace CrownRegionParts
{
/** Directions about the middle of the arch. */
constexpr unsigned int Sectors = 180;

unsigned int
SectorOf(double x, double y);

/** Least squares of h on {1, x, y, x^2, y^2}, lengths in units of 20 mm, with weights; quadratic terms are held a
 * little so that few teeth do not bend the surface. */
struct OcclusalSurface
{
  std::array<double, 5> c{};

  static std::array<double, 5>
  Terms(double x, double y)
  {
    const double u = x / 20.0;
    const double v = y / 20.0;
    return { { 1.0, u, v, u * u, v * v } };
  }
  double
  operator()(double x, double y) const
  {
    const auto t = Terms(x, y);
    return c[0] + c[1] * t[1] + c[2] * t[2] + c[3] * t[3] + c[4] * t[4];
  }
};

struct SectorTop
{
  double x;
  double y;
  double h;
};

/** The highest square half millimetre of each sector. */
std::vector<SectorTop>
FindTops(const std::vector<TriangleSurface::PointType> & q, const std::vector<double> & areas, double cx, double cy);

/** False where there are too few tops. */
bool
FitOcclusalSurface(const std::vector<SectorTop> & tops, OcclusalSurface & fit);
} // namespace CrownRegionParts
} // namespace itk

#endif
