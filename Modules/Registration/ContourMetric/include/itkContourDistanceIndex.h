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
#ifndef itkContourDistanceIndex_h
#define itkContourDistanceIndex_h

#include "ContourMetricExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
/** \class ContourDistanceIndex
 * \brief Exact nearest point of a planar contour.
 *
 * The targets are points, or segments and lone points. The search looks a query up in a grid whose cells list every
 * target that is nearest somewhere in the cell, so that a query costs a look-up and a few distances, near the contour
 * and far from it alike (k-d trees collapse far away). Cells are filled when first touched, each from the list of the
 * block around it; grids three times as wide take over where the one before ends. Up to a dozen targets are compared
 * one by one. The result is that of the comparison with every target but for the last bit of the distance.
 *
 * Queries fill cells: one object serves one thread at a time. Copies are independent. Free of ITK.
 *
 * \ingroup ContourMetric
 */
class ContourMetric_EXPORT ContourDistanceIndex
{
public:
  enum class SearchEnum : std::uint8_t
  {
    Automatic,
    BruteForce,
    Grid
  };

  /** The nearest point of the contour: its place, and the point or segment that it lies on (lone points are numbered
   * after the segments). Of equally near targets any one. */
  struct NearestType
  {
    double        squaredDistance; /**< Square pixels. */
    double        x;               /**< The nearest place, first axis. */
    double        y;               /**< The nearest place, second axis. */
    std::uint32_t target;          /**< The segment or lone point that it lies on. */
  };

  /** Targets are the points x0 y0 x1 y1 ... of count points. No count limits; count = 0 leaves nothing to find. */
  void
  SetPoints(const double * xy, std::size_t count);

  /** Targets are the segments, two point numbers each, and the points that no segment uses. */
  void
  SetSegments(const double * xy, std::size_t count, const std::uint32_t * segments, std::size_t numberOfSegments);

  /** How to search; Automatic takes the grid where it pays. */
  void
  SetSearch(SearchEnum search)
  {
    m_Search = search;
  }
  /** Segments and lone points. */
  std::size_t
  GetNumberOfTargets() const
  {
    return m_IsSegments ? m_Segments.size() : m_X.size();
  }

  /** The nearest point of the contour to (x, y), which must be finite; there must be a target. */
  NearestType
  FindNearest(double x, double y) const;

  /** The nearest points x0 y0 x1 y1 ... to many places x0 y0 x1 y1 ..., as by FindNearest() but faster. */
  void
  FindNearestPoints(const double * places, std::size_t count, double * nearest) const;

  /** The distance at the centre of a cell around (x, y): off by at most 3 % of the contour's width near it (more far
   * away, in proportion), for ranking many candidates at a nanosecond or two a query. */
  double
  FindApproximateDistance(double x, double y) const;
  /** The same of many places x0 y0 x1 y1 ... */
  void
  FindApproximateDistances(const double * places, std::size_t count, double * distances) const;

private:
  struct SegmentType
  {
    double x;
    double y;
    double dx;
    double dy;
    double inverseSquaredLength;
  };
  struct CellType
  {
    std::uint32_t first{ 0 };
    std::uint32_t count{ 0 };
  };
  struct BoxType
  {
    double x0;
    double y0;
    double x1;
    double y1;
  };
  /** Two targets of a cell of the finest grid, copied so that a query finds them in one place. An odd one stands twice.
   */
  struct PointPair
  {
    double x[2];
    double y[2];
  };
  struct SegmentPair
  {
    double x[2];
    double y[2];
    double dx[2];
    double dy[2];
    double inverseSquaredLength[2];
  };
  /** One square of the plane and its nested grids; the last is the finest, whose cells count pairs. */
  struct DomainType
  {
    BoxType                              box;
    double                               cellsPerUnit{ 0.0 };
    std::array<std::vector<CellType>, 3> cells;
    /** Distances at the centres of a coarse grid; negative where not yet filled. */
    std::vector<float> field;
  };

  void
  Reset();
  void
  PlaceDomains(const double * xy, std::size_t count);
  NearestType
  FindByBruteForce(double x, double y) const;
  void
  TestTarget(std::uint32_t target, double x, double y, NearestType & nearest) const;
  DomainType *
  FindDomain(double x, double y) const;
  double
  LowerBound(std::uint32_t target, const BoxType & box) const;
  double
  UpperBound(std::uint32_t target, const BoxType & box) const;
  CellType
  GetCell(DomainType & domain, unsigned int level, std::uint32_t ix, std::uint32_t iy) const;
  void
  SelectTargets(DomainType & domain, unsigned int level, std::uint32_t ix, std::uint32_t iy) const;
  CellType
  FillFinestCell(DomainType & domain, std::uint32_t ix, std::uint32_t iy) const;
  static void
  FindFeet(const PointPair & pair, double x, double y, double footX[2], double footY[2]);
  static void
  FindFeet(const SegmentPair & pair, double x, double y, double footX[2], double footY[2]);
  template <typename TPair>
  void
  FindNearestPointsByPairs(const std::vector<TPair> & pairs,
                           const double *             places,
                           std::size_t                count,
                           double *                   nearest) const;
  void
  FillField(DomainType & domain, std::uint32_t bx, std::uint32_t by) const;
  void
  KeepPossiblyNearest(const BoxType & box, const std::uint32_t * from, std::size_t count) const;
  double
  FindUpperBound(const BoxType & box, const std::uint32_t * from, std::size_t count) const;
  void
  DropDominated(const BoxType & box) const;

  SearchEnum               m_Search{ SearchEnum::Automatic };
  bool                     m_IsSegments{ false };
  std::vector<double>      m_X;
  std::vector<double>      m_Y;
  std::vector<SegmentType> m_Segments;
  double                   m_CenterX{ 0.0 };
  double                   m_CenterY{ 0.0 };
  double                   m_HalfWidth{ 0.0 };
  bool                     m_HasGrid{ false };
  /** Cells a side of a domain's nested grids, coarse to fine. */
  std::array<std::uint32_t, 3> m_Grid{};

  mutable std::vector<DomainType>    m_Domains;
  mutable std::vector<std::uint32_t> m_Lists;
  /** Of the finest cells: the targets, two a pair, and the pairs of whichever kind. */
  mutable std::vector<std::uint32_t> m_PairTargets;
  mutable std::vector<PointPair>     m_PointPairs;
  mutable std::vector<SegmentPair>   m_SegmentPairs;
  mutable std::vector<std::uint32_t> m_Kept;
  mutable std::vector<NearestType>   m_Ranked;
  mutable std::vector<double>        m_Bounds;
};
} // namespace itk

#endif
