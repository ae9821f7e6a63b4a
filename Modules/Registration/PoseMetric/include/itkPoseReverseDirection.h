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
#ifndef itkPoseReverseDirection_h
#define itkPoseReverseDirection_h

#include "PoseMetricExport.h"
#include "itkPoseContour.h"
#include "itkPoseModel.h"
#include "itkPoseTracing.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace itk
{
/** \class PoseReverseDirection
 * \brief Residuals from the moving contour to a strand of tracing, censored where nothing was drawn.
 *
 * As many samples as the strand has points are spread evenly over the contour. Each is matched with a segment of the
 * tracing, by position and direction as the forward direction is, and its residual is the distance along the segment's
 * normal. A weight, the taper, is 0 where the nearest place is an end of the tracing, since the outline goes on where
 * nobody drew, and rises to 1 within the taper length of it, so that the criterion has no step. Free of ITK headers.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseReverseDirection
{
public:
  /** What it counts, and how its matches are made. */
  struct Settings
  {
    /** What it counts beside the forward direction. */
    double weight{ 0.0 };
    /** px */
    double taperLength{ 6.0 };
    /** Polylines with a shorter gap between them are one, px. */
    double gapLength{ 8.0 };
    /** px that a unit normal counts in matching; 0: position alone. */
    double       orientationWeight{ 8.0 };
    bool         gateByTooth{ false };
    unsigned int toothRange{ 1 };
  };

  /** One value a sample, or 7 where derivatives by the pose are. */
  struct Linearization
  {
    std::vector<double> residual; /**< Along the normal of the matched segment, px. */
    /** What the robust kernel sees, as in PoseSilhouetteKernel::Linearization. */
    std::vector<double> squaredDistance;
    /** 1 where contour and tracing face the same way, 0 where they do not. */
    std::vector<double> facing;
    std::vector<double> taper;
    /** Segment; NoMatch where none may be matched. */
    std::vector<std::size_t> match;
    std::vector<double>      jacobian;
    std::vector<double>      distanceJacobian;
    std::vector<double>      taperJacobian;
  };
  static constexpr std::size_t NoMatch = std::numeric_limits<std::size_t>::max(); /**< No segment may be. */

  /** No direction at all. */
  PoseReverseDirection() = default;
  PoseReverseDirection(const PoseTracing & tracing, const Settings & settings);

  /** Weight of each sample: those of a strand count as much as its points, times Settings::weight. */
  double
  GetWeight() const
  {
    return m_Weight;
  }

  /** \param tracing  that it was made of.
   *  \param held  a linearisation whose segments and facing are kept, or null. */
  Linearization
  Linearize(const PoseTracing &   tracing,
            const PoseModel &     model,
            const PoseContour &   contour,
            const Linearization * held) const;

private:
  /** A stretch of tracing between two points that follow each other. */
  struct Segment
  {
    std::size_t from;
    /** Unit normal, of the smoothed ones of its ends. */
    double nu;
    double nv;
    /** Arc lengths where what it belongs to begins and ends: its polylines, those with short gaps strung together. */
    double begin;
    double end;
    /** Bits of the tooth positions that it may be matched with. */
    std::uint32_t allowed;
  };

  void
  Match(const PoseTracing & tracing, const PoseContour & contour, Linearization & lin) const;

  Settings             m_Settings;
  double               m_Weight{ 0.0 };
  std::vector<Segment> m_Segments;
};
} // namespace itk

#endif
