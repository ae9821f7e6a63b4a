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
#ifndef itkContourDistanceIndexDetail_h
#define itkContourDistanceIndexDetail_h

#include "itkContourDistanceIndex.h"

#include <algorithm>
#include <cstdint>
#include <limits>

// What the parts of ContourDistanceIndex share: search, cells and field of approximate distances. Private to this
// module.
namespace itk
{
namespace ContourDistanceIndexDetail
{
/** Of the nested squares around the contour each is so many times as wide as the one before. */
constexpr double DomainGrowth = 3.0;

/** The first target of a cell whose list was not made yet. */
constexpr std::uint32_t Unfilled = std::numeric_limits<std::uint32_t>::max();

inline double
Square(double value)
{
  return value * value;
}

inline std::uint32_t
CellNumber(double place, std::uint32_t side)
{
  return place > 0.0 ? std::min(static_cast<std::uint32_t>(place), side - 1) : 0u;
}
} // namespace ContourDistanceIndexDetail

inline void
ContourDistanceIndex::TestTarget(std::uint32_t target, double x, double y, NearestType & nearest) const
{
  using ContourDistanceIndexDetail::Square;
  if (m_IsSegments)
  {
    const SegmentType & segment = m_Segments[target];
    const double along = ((x - segment.x) * segment.dx + (y - segment.y) * segment.dy) * segment.inverseSquaredLength;
    const double t = along < 0.0 ? 0.0 : (along > 1.0 ? 1.0 : along);
    const double footX = segment.x + t * segment.dx;
    const double footY = segment.y + t * segment.dy;
    const double squaredDistance = Square(x - footX) + Square(y - footY);
    if (squaredDistance < nearest.squaredDistance)
    {
      nearest = { squaredDistance, footX, footY, target };
    }
  }
  else
  {
    const double squaredDistance = Square(x - m_X[target]) + Square(y - m_Y[target]);
    if (squaredDistance < nearest.squaredDistance)
    {
      nearest = { squaredDistance, m_X[target], m_Y[target], target };
    }
  }
}
} // namespace itk

#endif
