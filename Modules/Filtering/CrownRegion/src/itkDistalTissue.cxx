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
#include "itkDistalTissue.h"

#include "itkArchLine.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace CrownRegionParts
{
void
CutDistalTissue(const TriangleSurface &           surface,
                const std::vector<std::uint8_t> & band,
                const std::vector<float> &        station,
                const std::vector<float> &        offset,
                const std::vector<float> &        depth,
                const std::vector<double> &       transverse,
                double                            front,
                std::vector<std::uint8_t> &       gap)
{
  // Shallowest depth in cells of two stations by 0.75 mm across the arch; triangles are sampled, scans may be coarse.
  constexpr double      cell = 0.75;
  constexpr std::size_t across = 24;
  constexpr double      empty = 99.0;
  const std::size_t     rows = gap.size() / 2 + 1;
  std::vector<double>   profile(rows * across, empty);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto & c = surface.triangles[t];
    if (band[t] == 0 || std::min({ depth[c[0]], depth[c[1]], depth[c[2]] }) > 5.0f)
    {
      continue;
    }
    constexpr int steps = 4;
    for (int i = 0; i <= steps; ++i)
    {
      for (int j = 0; i + j <= steps; ++j)
      {
        const double a = static_cast<double>(i) / steps;
        const double b = static_cast<double>(j) / steps;
        const double f = 1.0 - a - b;
        const double s = a * station[c[0]] + b * station[c[1]] + f * station[c[2]];
        const double r = a * offset[c[0]] + b * offset[c[1]] + f * offset[c[2]];
        const double d = a * depth[c[0]] + b * depth[c[1]] + f * depth[c[2]];
        const auto   column = static_cast<std::size_t>(std::clamp(r / cell + 0.5 * across, 0.0, across - 1.0));
        double &     value = profile[static_cast<std::size_t>(s / 2.0) * across + column];
        value = std::min(value, d);
      }
    }
  }
  // How deep the groove is below the line from crest to crest; a tooth may lean, so the line may slope.
  constexpr double    steepest = 0.5;
  constexpr double    shallow = 3.0;
  std::vector<double> groove(rows, 0.0);
  for (std::size_t k = 0; k < rows; ++k)
  {
    const double * line = &profile[k * across];
    for (std::size_t i = 0; i < across; ++i)
    {
      for (std::size_t j = i + 2; line[i] < shallow && j < across; ++j)
      {
        const double slope = (line[j] - line[i]) / static_cast<double>(j - i);
        if (!(line[j] < shallow) || std::abs(slope) > steepest * cell)
        {
          continue;
        }
        // Hidden crests are no line of sight.
        double deepest = 0.0;
        bool   seen = true;
        for (std::size_t m = i + 1; seen && m < j; ++m)
        {
          const double below = line[m] - line[i] - slope * static_cast<double>(m - i);
          seen = below > -1e-6;
          deepest = line[m] < empty ? std::max(deepest, below) : deepest;
        }
        if (seen)
        {
          groove[k] = std::max(groove[k], std::min(deepest, 1.5));
        }
      }
    }
  }
  constexpr double posterior = 24.0;
  constexpr double deep = 0.3;
  for (const int direction : { -1, 1 })
  {
    int        last = -1;
    const auto inside = [&](int k) { return k >= 0 && k < static_cast<int>(rows); };
    for (int k = static_cast<int>(front / 2.0 + direction * posterior); inside(k); k += direction)
    {
      // Two of three neighbouring millimetres.
      int grooved = 0;
      for (int d = 0; d < 3; ++d)
      {
        const int at = k - direction * d;
        grooved += inside(at) && groove[static_cast<std::size_t>(at)] > deep ? 1 : 0;
      }
      if (grooved >= 2 && groove[static_cast<std::size_t>(k)] > deep)
      {
        last = k;
      }
    }
    if (last < 0)
    {
      continue;
    }
    // The distal ridge is 1 to 4 mm further; the tooth ends where the surface turns up again most: by 4 rad mm at
    // least, or by however little where more follows than a ridge can be.
    int       end = -1;
    const int count = static_cast<int>(gap.size());
    int       length = 0;
    while (2 * last + direction * length >= 0 && 2 * last + direction * length < count &&
           gap[static_cast<std::size_t>(2 * last + direction * length)] == 0)
    {
      ++length;
    }
    double best = length * StationSpacing > 7.0 ? -1e9 : 4.0;
    for (int d = 1; d <= 8; ++d)
    {
      const int at = 2 * last + direction * d;
      if (at >= 1 && at + 1 < count)
      {
        const double value = transverse[static_cast<std::size_t>(at - 1)] +
                             2.0 * transverse[static_cast<std::size_t>(at)] +
                             transverse[static_cast<std::size_t>(at + 1)];
        if (value > best)
        {
          best = value;
          end = at;
        }
      }
    }
    // What lies behind a gap without a groove is the ridge that rises again.
    if (end < 0)
    {
      end = 2 * last + direction * length;
    }
    for (int k = end; k >= 0 && k < count; k += direction)
    {
      gap[static_cast<std::size_t>(k)] = 1;
    }
  }
}
} // namespace CrownRegionParts
} // namespace itk
