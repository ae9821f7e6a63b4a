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
#include "itkGingivalMargin.h"

#include "itkArchLine.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace itk
{
namespace CrownRegionParts
{
GingivalMargin
TraceGingivalMargin(const ValleyChart & chart, unsigned int side, double front, const CrownRegionOptions & options)
{
  const std::size_t stations = chart.GetStations();
  const std::size_t depths = chart.GetDepths();
  constexpr int     leap = 4;
  const auto        lowest = static_cast<std::size_t>(options.minimumCrownHeight / DepthSpacing);
  const auto        highest = static_cast<std::size_t>(options.maximumCrownHeight / DepthSpacing);
  const auto        guard = static_cast<std::size_t>(1.4 / DepthSpacing);

  std::vector<double>      value(stations * depths, -1e18);
  std::vector<std::int8_t> step(stations * depths, 0);
  for (std::size_t k = 0; k < stations; ++k)
  {
    const double away =
      std::min(std::abs(static_cast<double>(k) - front) * StationSpacing / options.posteriorDistance, 1.0);
    const double expected =
      options.anteriorCrownHeight + away * (options.posteriorCrownHeight - options.anteriorCrownHeight);
    double passed = 0.0;
    for (std::size_t j = lowest; j <= highest; ++j)
    {
      // A crown has no second valley: palate and sulcus lie behind the margin.
      if (j >= lowest + guard)
      {
        passed = std::max(passed, std::clamp(chart.At(side, k, j - guard), 0.0, 1.2));
      }
      const double off = (static_cast<double>(j) * DepthSpacing - expected) / options.crownHeightScale;
      const double here =
        std::clamp(chart.At(side, k, j), -0.5, 1.2) - options.priorWeight * off * off - options.passedWeight * passed;
      double best = k == 0 ? 0.0 : -1e18;
      for (int d = -leap; k > 0 && d <= leap; ++d)
      {
        const int from = static_cast<int>(j) + d;
        if (from < static_cast<int>(lowest) || from > static_cast<int>(highest))
        {
          continue;
        }
        const double candidate =
          value[(k - 1) * depths + static_cast<std::size_t>(from)] - options.smoothness * std::abs(d) * DepthSpacing;
        if (candidate > best)
        {
          best = candidate;
          step[k * depths + j] = static_cast<std::int8_t>(d);
        }
      }
      value[k * depths + j] = best + here;
    }
  }

  GingivalMargin margin;
  margin.depth.assign(stations, 0.0);
  margin.angle.assign(stations, 0.0);
  std::size_t at = lowest;
  for (std::size_t j = lowest; j <= highest; ++j)
  {
    if (value[(stations - 1) * depths + j] > value[(stations - 1) * depths + at])
    {
      at = j;
    }
  }
  for (std::size_t k = stations; k-- > 0;)
  {
    margin.depth[k] = static_cast<double>(at) * DepthSpacing;
    margin.angle[k] = chart.At(side, k, at);
    at = static_cast<std::size_t>(static_cast<int>(at) + step[k * depths + at]);
  }
  return margin;
}
} // namespace CrownRegionParts
} // namespace itk
