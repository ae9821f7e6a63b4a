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
#ifndef itkContourMetricEnums_h
#define itkContourMetricEnums_h

#include "ContourMetricExport.h"

#include <cstdint>
#include <iosfwd>

namespace itk
{
/** \class ContourMetricEnums
 * \brief Which way distances between two contours are taken, and to what.
 * \ingroup ContourMetric
 */
class ContourMetricEnums
{
public:
  /** Symmetric: sum of both directed means. MovingToFixed: IOS -> CR. FixedToMoving: CR -> IOS. */
  enum class Direction : std::uint8_t
  {
    Symmetric,
    MovingToFixed,
    FixedToMoving
  };

  /** PointToPoint: to the nearest vertex (the paper). PointToSegment: to the nearest point of any line cell; a vertex
   * without a cell stands for itself. */
  enum class Distance : std::uint8_t
  {
    PointToPoint,
    PointToSegment
  };
};

extern ContourMetric_EXPORT std::ostream &
                            operator<<(std::ostream & os, ContourMetricEnums::Direction value);
extern ContourMetric_EXPORT std::ostream &
                            operator<<(std::ostream & os, ContourMetricEnums::Distance value);
} // namespace itk

#endif
