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
#ifndef itkValleyChart_h
#define itkValleyChart_h

#include <cstddef>
#include <vector>

namespace itk
{
namespace CrownRegionParts
{
/** Between rows of the chart, mm. */
constexpr double DepthSpacing = 0.2;

/** Turning angle of the surface (radians) across valleys that run along the arch, by side, station and depth. */
class ValleyChart
{
public:
  ValleyChart(std::size_t stations, std::size_t depths)
    : m_Stations(stations)
    , m_Depths(depths)
    , m_Values(2 * stations * depths, 0.0)
  {}

  std::size_t
  GetStations() const
  {
    return m_Stations;
  }
  std::size_t
  GetDepths() const
  {
    return m_Depths;
  }

  double &
  At(unsigned int side, std::size_t station, std::size_t depth)
  {
    return m_Values[(side * m_Stations + station) * m_Depths + depth];
  }
  double
  At(unsigned int side, std::size_t station, std::size_t depth) const
  {
    return m_Values[(side * m_Stations + station) * m_Depths + depth];
  }

  void
  Splat(unsigned int side, double station, double depth, double value)
  {
    if (!(station >= 0.0 && depth >= 0.0))
    {
      return;
    }
    const auto k = static_cast<std::size_t>(station);
    const auto j = static_cast<std::size_t>(depth);
    if (k + 1 < m_Stations && j + 1 < m_Depths)
    {
      const double a = station - static_cast<double>(k);
      const double b = depth - static_cast<double>(j);
      At(side, k, j) += (1.0 - a) * (1.0 - b) * value;
      At(side, k + 1, j) += a * (1.0 - b) * value;
      At(side, k, j + 1) += (1.0 - a) * b * value;
      At(side, k + 1, j + 1) += a * b * value;
    }
  }

  /** Mean along the arch (sd 0.6 mm), sum over what is near in depth (sd 0.5 mm). */
  void
  Smooth();

private:
  std::size_t         m_Stations;
  std::size_t         m_Depths;
  std::vector<double> m_Values;
};
} // namespace CrownRegionParts
} // namespace itk

#endif
