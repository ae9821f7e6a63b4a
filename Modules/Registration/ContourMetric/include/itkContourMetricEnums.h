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
#include "itkScalePrior.h"

#include <cstdint>
#include <iosfwd>

namespace itk
{
/** \class ContourMetricEnums
 * \brief Which way distances between two contours are taken, to what, and how large ones count.
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

  /** How a distance d counts, with the width c: Squares d^2; Huber d^2 up to c, then 2 c d - c^2; GemanMcClure
   * c^2 d^2 / (c^2 + d^2), at most c^2. */
  enum class RobustKernel : std::uint8_t
  {
    Squares,
    Huber,
    GemanMcClure
  };

  /** Where the pixel spacing of the radiograph comes from: said by the user, read from a DICOM file, assumed, or
   * estimated by the registration. */
  using SpacingSource = ScalePrior::SpacingSource;
};

extern ContourMetric_EXPORT std::ostream &
                            operator<<(std::ostream & os, ContourMetricEnums::Direction value);
extern ContourMetric_EXPORT std::ostream &
                            operator<<(std::ostream & os, ContourMetricEnums::Distance value);
extern ContourMetric_EXPORT std::ostream &
                            operator<<(std::ostream & os, ContourMetricEnums::RobustKernel value);
extern ContourMetric_EXPORT std::ostream &
                            operator<<(std::ostream & os, ContourMetricEnums::SpacingSource value);
} // namespace itk

#endif
