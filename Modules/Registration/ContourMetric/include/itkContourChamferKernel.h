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
#ifndef itkContourChamferKernel_h
#define itkContourChamferKernel_h

#include "itkContourDistanceIndex.h"
#include "itkContourMetricEnums.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace itk
{
/** A contour as flat arrays: x0 y0 x1 y1 ...; two point numbers a segment; weights one a point or none (all 1).
 * Points of weight 0 are ignored, and so are the segments that end in them. */
struct ContourArrays
{
  std::vector<double>        points;   /**< x0 y0 x1 y1 ..., pixels. */
  std::vector<std::uint32_t> segments; /**< Indices of two points each. */
  std::vector<double>        weights;  /**< One a point; empty: all 1. */
  /** Number of points, half that of the numbers. */
  std::size_t
  GetNumberOfPoints() const
  {
    return points.size() / 2;
  }
};

/** p = scale * R(angle) * q + (tx, ty), angle in radians from the first axis towards the second. */
struct ContourSimilarity
{
  double scale{ 1.0 }; /**< Factor, positive. */
  double angle{ 0.0 }; /**< Radians. */
  double tx{ 0.0 };    /**< Shift along the first axis, pixels. */
  double ty{ 0.0 };    /**< Shift along the second axis, pixels. */
};

/** \class ContourChamferKernel
 * \brief Mean distances between a fixed contour and a moving one under a similarity, with their gradient.
 *
 * The directed mean from A to B is the weighted mean over A's points of min(d, truncation), d the distance in the fixed
 * frame to the nearest point of B. Moving points are mapped forward; for the other direction fixed points are mapped by
 * the inverse similarity, so that neither search structure ever moves. The gradient is that of the value (the nearest
 * point held, which is exact where it is unique); it is 0 for a distance of 0 and beyond the truncation.
 *
 * Lengths are those of the fixed contour (pixels). One object serves one thread at a time. Free of ITK.
 *
 * \ingroup ContourMetric
 */
class ContourMetric_EXPORT ContourChamferKernel
{
public:
  using DirectionEnum = ContourMetricEnums::Direction;
  using DistanceEnum = ContourMetricEnums::Distance;
  using SearchEnum = ContourDistanceIndex::SearchEnum;
  using GradientType = std::array<double, 4>;

  /** Throws std::invalid_argument where either contour has no point of positive weight, or a point is not finite. */
  void
  Initialize(const ContourArrays & fixed,
             const ContourArrays & moving,
             DistanceEnum          distance = DistanceEnum::PointToPoint,
             SearchEnum            search = SearchEnum::Automatic);

  /** Symmetric: the sum of both directed means, else one of them. With a gradient, its derivatives by scale, angle, tx
   * and ty. The scale must be positive, everything finite. */
  double
  Evaluate(const ContourSimilarity & similarity,
           DirectionEnum             direction = DirectionEnum::Symmetric,
           GradientType *            gradient = nullptr,
           double                    truncation = std::numeric_limits<double>::infinity()) const;

  /** About the same value for ranking many candidates: from a field of distances (see
   * ContourDistanceIndex::FindApproximateDistance) at up to numberOfPoints evenly spaced points of each contour. */
  double
  EvaluateApproximately(const ContourSimilarity & similarity,
                        DirectionEnum             direction,
                        double                    truncation,
                        std::size_t               numberOfPoints) const;

  /** Distances of all points, in their order; NaN for ignored ones. */
  std::vector<double>
  GetMovingToFixedDistances(const ContourSimilarity & similarity) const;
  std::vector<double>
  GetFixedToMovingDistances(const ContourSimilarity & similarity) const;

private:
  /** Some points of a side, and room for where they are moved to and how far that is from the other. */
  struct SampleType
  {
    std::vector<double>         points;
    std::vector<double>         weights;
    mutable std::vector<double> places;
    mutable std::vector<double> distances;
  };

  /** The points that count, and what is searched for the other contour's points. */
  struct SideType
  {
    std::vector<double>        points;
    std::vector<double>        weights;
    std::vector<std::uint32_t> ids;
    std::size_t                numberOfPoints{ 0 };
    ContourDistanceIndex       index;
    mutable SampleType         sample;
  };

  static void
  InitializeSide(SideType & side, const ContourArrays & contour, DistanceEnum distance, SearchEnum search);

  static const SampleType &
  TakeSample(const SideType & side, std::size_t numberOfPoints);
  static double
  MeanOfSample(const SampleType & sample, const ContourDistanceIndex & index, double scale, double truncation);

  SideType m_Fixed;
  SideType m_Moving;
};
} // namespace itk

#endif
