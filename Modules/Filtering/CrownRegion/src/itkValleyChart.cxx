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
#include "itkValleyChart.h"

#include "itkArchLine.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace CrownRegionParts
{
void
ValleyChart::Smooth()
{
  std::vector<double> line(std::max(m_Stations, m_Depths));
  const auto          filter = [&](std::size_t count, std::size_t offset, std::size_t stride, double sigma, bool mean) {
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    for (std::size_t i = 0; i < count; ++i)
    {
      double sum = 0.0;
      double weights = 0.0;
      for (int d = -radius; d <= radius; ++d)
      {
        const double w = std::exp(-0.5 * d * d / (sigma * sigma));
        const int    at = static_cast<int>(i) + d;
        weights += w;
        if (at >= 0 && at < static_cast<int>(count))
        {
          sum += w * m_Values[offset + static_cast<std::size_t>(at) * stride];
        }
      }
      line[i] = mean ? sum / weights : sum;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      m_Values[offset + i * stride] = line[i];
    }
  };
  for (unsigned int side = 0; side < 2; ++side)
  {
    for (std::size_t k = 0; k < m_Stations; ++k)
    {
      filter(m_Depths, (side * m_Stations + k) * m_Depths, 1, 0.5 / DepthSpacing, false);
    }
    for (std::size_t j = 0; j < m_Depths; ++j)
    {
      filter(m_Stations, side * m_Stations * m_Depths + j, m_Depths, 0.6 / StationSpacing, true);
    }
  }
}
} // namespace CrownRegionParts
} // namespace itk
