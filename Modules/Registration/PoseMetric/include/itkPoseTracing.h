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
#ifndef itkPoseTracing_h
#define itkPoseTracing_h

#include "PoseMetricExport.h"
#include "itkDentalContour.h"
#include "itkPoseTypes.h"

namespace itk
{
/** \class PoseTracing
 * \brief The tracing of one jaw and side as one ordered strand of points with outward normals and arc length.
 *
 * Polylines are put in order front to back by tooth code (by place where a code is missing), each turned the way that
 * makes the gaps smallest; a closed one keeps the part that faces occlusally or anteriorly. Normals come from a local
 * line fit (Gaussian weight, sigma 5 px, +-15 px of arc) and point occlusally. Arc length runs on over the gaps.
 * Coordinates are those of the working plane (PoseModel::ToWorkingPlane()).
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseTracing
{
public:
  PoseTracing() = default;
  PoseTracing(const PoseGeometry &                 geometry,
              const DentalContour::PolylinesType & polylines,
              ToothCode::JawEnum                   jaw,
              unsigned int                         maximumPoints = 200); /**< More points are thinned out. */
  /** Number of points. */
  std::size_t
  Size() const
  {
    return u.size();
  }

  std::vector<double> u;  /**< Working plane, px of 0.25 mm. */
  std::vector<double> v;  /**< The same, downward. */
  std::vector<double> nu; /**< Outward normal, of length 1 with nv. */
  std::vector<double> nv; /**< Its second component. */
  /** Arc length from the front, px. */
  std::vector<double>       arc;
  std::vector<double>       weight;
  std::vector<std::uint8_t> tooth;
  /** Starts of the polylines in the arrays above. */
  std::vector<std::size_t> runs;
  /** Sum of the polylines' lengths, gaps left out. */
  double length{ 0.0 };
  double centroid[2]{ 0.0, 0.0 };
};
} // namespace itk

#endif
