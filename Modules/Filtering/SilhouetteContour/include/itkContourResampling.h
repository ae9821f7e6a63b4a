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
#ifndef itkContourResampling_h
#define itkContourResampling_h

#include "SilhouetteContourExport.h"

#include <array>
#include <cstddef>
#include <vector>

namespace itk
{
/** A place on a polyline: on the segment that begins at a point, at a share of its length. */
struct ContourPosition
{
  std::size_t segment; /**< Index of the point at which the segment begins. */
  double      share;   /**< 0 at its begin, 1 at its end. */
};

/** Length of a polyline, or of a polygon where closed. */
SilhouetteContour_EXPORT double
ComputePolylineLength(const std::vector<std::array<double, 2>> & points, bool closed);

/** The given number of places at equal distances along a polyline. Open: first and last point included (one place: the
 * middle). Closed: beginning at the first point, which is not repeated. Empty for a line of no length. */
SilhouetteContour_EXPORT std::vector<ContourPosition>
ResamplePolyline(const std::vector<std::array<double, 2>> & points, bool closed, std::size_t count);

/** Shares out a number of points to polylines by their lengths: each gets its minimum, the rest goes by largest
 * remainder of the proportional share. Throws std::invalid_argument where the total is less than the minima. */
SilhouetteContour_EXPORT std::vector<std::size_t>
                         DistributeContourPoints(const std::vector<double> &      lengths,
                                                 const std::vector<std::size_t> & minima,
                                                 std::size_t                      total);
} // namespace itk

#endif
