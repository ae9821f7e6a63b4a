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
#ifndef itkContourStrand_h
#define itkContourStrand_h

#include "itkContourChamferKernel.h"

#include <cstdint>
#include <vector>

namespace itk
{
/** \class ContourStrand
 * \brief Points of a contour in the order in which its segments join them; one point where no segment does.
 *
 * A closed strand does not repeat its first point. Free of ITK.
 *
 * \ingroup ContourMetric
 */
struct ContourMetric_EXPORT ContourStrand
{
  std::vector<std::uint32_t> ids;
  bool                       closed{ false };

  /** The strands of a contour: points of weight 0 left out, cut where more than two segments meet. Open strands come in
   * the order of their first points, then the closed ones. */
  static std::vector<ContourStrand>
  FindAll(const ContourArrays & contour);

  /** Arc length of every point of the strand from its first point. */
  std::vector<double>
  GetArcLengths(const ContourArrays & contour) const;

  /** Segments of the strand, the closing one included. */
  std::size_t
  GetNumberOfSegments() const
  {
    return closed ? ids.size() : ids.size() - 1;
  }

  /** Unit direction (x, y) of every segment of the strand: the sum of the segments around it along the strand, weighted
   * by a Gaussian of this sigma; the segment's own where that is 0. (0, 0) where the sum vanishes. */
  std::vector<double>
  GetSegmentDirections(const ContourArrays & contour, double sigma) const;
};
} // namespace itk

#endif
