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
#include "itkDentalPhantomOcclusion.h"

#include "itkDentalPhantomMath.h"
#include "itkDentalPhantomMesher.h"

#include <algorithm>
#include <cmath>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
using PointType = DentalPhantomDentition::PointType;
constexpr unsigned int NumberOfTeeth = DentalPhantomDentition::NumberOfTeeth;
} // namespace

void
SettleDentalPhantom(DentalPhantomDentition &            dentition,
                    unsigned int                        threads,
                    std::array<double, NumberOfTeeth> & settlement)
{
  // At a resolution of its own, so that the occlusion does not depend on that of the meshes.
  constexpr std::uint32_t       resolution = 28000;
  const DentalPhantomMesher     mesher(dentition);
  const DentalPhantomJawSurface upper = mesher.MakeJaw(0, resolution, false, threads, {});
  // Lower envelope of the upper jaw at the nodes of a raster.
  constexpr double    step = 0.2;
  constexpr double    x0 = -30.0;
  constexpr double    y0 = -60.0;
  constexpr int       nx = 650;
  constexpr int       ny = 600;
  std::vector<double> envelope(static_cast<std::size_t>(nx) * ny, 1e9);
  for (const auto & triangle : upper.surface.triangles)
  {
    const PointType & a = upper.surface.points[triangle[0]];
    const PointType & b = upper.surface.points[triangle[1]];
    const PointType & c = upper.surface.points[triangle[2]];
    const double      det = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    if (std::abs(det) < 1e-12)
    {
      continue;
    }
    const int i0 = std::max(0, static_cast<int>(std::ceil((std::min({ a[0], b[0], c[0] }) - x0) / step)));
    const int i1 = std::min(nx - 1, static_cast<int>(std::floor((std::max({ a[0], b[0], c[0] }) - x0) / step)));
    const int j0 = std::max(0, static_cast<int>(std::ceil((std::min({ a[1], b[1], c[1] }) - y0) / step)));
    const int j1 = std::min(ny - 1, static_cast<int>(std::floor((std::max({ a[1], b[1], c[1] }) - y0) / step)));
    for (int j = j0; j <= j1; ++j)
    {
      for (int i = i0; i <= i1; ++i)
      {
        const double x = x0 + i * step - a[0];
        const double y = y0 + j * step - a[1];
        const double u = (x * (c[1] - a[1]) - (c[0] - a[0]) * y) / det;
        const double v = ((b[0] - a[0]) * y - x * (b[1] - a[1])) / det;
        if (u >= -1e-9 && v >= -1e-9 && u + v <= 1.0 + 1e-9)
        {
          double & value = envelope[static_cast<std::size_t>(j) * nx + i];
          value = std::min(value, a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]));
        }
      }
    }
  }
  const DentalPhantomJawSurface     lower = mesher.MakeJaw(1, resolution, false, threads, {});
  std::array<double, NumberOfTeeth> clearance;
  clearance.fill(1e9);
  for (std::size_t n = 0; n < lower.labels.size(); ++n)
  {
    if (lower.labels[n] == 0)
    {
      continue;
    }
    const PointType & p = lower.surface.points[n];
    const int         i = static_cast<int>(std::floor((p[0] - x0) / step));
    const int         j = static_cast<int>(std::floor((p[1] - y0) / step));
    if (i < 0 || j < 0 || i + 1 >= nx || j + 1 >= ny)
    {
      continue;
    }
    const std::size_t  id = static_cast<std::size_t>(j) * nx + i;
    const double       top = std::min({ envelope[id], envelope[id + 1], envelope[id + nx], envelope[id + nx + 1] });
    const unsigned int tooth = DentalPhantomJaw::GetIndex(lower.labels[n] / 10 == 3, lower.labels[n] % 10 - 1u);
    clearance[tooth] = std::min(clearance[tooth], top - p[2]);
  }
  for (unsigned int i = 0; i < NumberOfTeeth; ++i)
  {
    // Back teeth erupt until they touch; front teeth keep their overbite unless they would meet.
    const unsigned int k = DentalPhantomJaw::GetPosition(i);
    const double       highest = k < 2 ? 0.0 : k == 2 ? 0.3 : 1.2;
    const double       reach = dentition.GetBody(1, i).settles ? highest : 0.0;
    const double       shift = std::min(clearance[i] - 0.04, reach);
    settlement[i] = dentition.GetBody(1, i).present ? Quantise(shift) : 0.0;
    dentition.Move(1, i, settlement[i]);
  }
}
} // namespace itk
