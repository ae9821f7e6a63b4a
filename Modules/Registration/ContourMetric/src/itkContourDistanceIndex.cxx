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
#include "itkContourDistanceIndex.h"

#include "itkVectorClones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace itk
{
namespace
{
constexpr std::size_t   BruteForceLimit = 12;
constexpr std::uint32_t NumberOfDomains = 7;
constexpr double        DomainGrowth = 3.0;
constexpr std::uint32_t Unfilled = std::numeric_limits<std::uint32_t>::max();

// Cells a side of the nested grids; each divides the next.
constexpr std::array<std::uint32_t, 3> TinyGrid{ 8, 32, 64 };
constexpr std::array<std::uint32_t, 3> SmallGrid{ 8, 32, 128 };
constexpr std::array<std::uint32_t, 3> LargeGrid{ 8, 64, 256 };
constexpr std::array<std::uint32_t, 3> HugeGrid{ 16, 128, 1024 };
constexpr std::size_t                  SmallGridFrom = 200;
constexpr std::size_t                  LargeGridFrom = 1500;
constexpr std::size_t                  HugeGridFrom = 8000;

const std::array<std::uint32_t, 3> &
ChooseGrid(std::size_t numberOfTargets)
{
  return numberOfTargets < SmallGridFrom   ? TinyGrid
         : numberOfTargets < LargeGridFrom ? SmallGrid
         : numberOfTargets < HugeGridFrom  ? LargeGrid
                                           : HugeGrid;
}

// Cells a side of the field of approximate distances: a multiple of the coarsest grid's.
constexpr std::uint32_t FieldSide = 64;

inline double
Square(double value)
{
  return value * value;
}

// Places at a time for the field of approximate distances: what a cell of the coarsest grid covers, at most.
constexpr std::uint32_t PlacesAtATime = 64;

/** Lowers the squared distances of the places to those from a segment: the same sums as for a single place. */
itkVectorClones void
LowerToSegment(const double segment[5], const double * x, const double * y, double * least)
{
  for (std::uint32_t i = 0; i < PlacesAtATime; ++i)
  {
    const double along = ((x[i] - segment[0]) * segment[2] + (y[i] - segment[1]) * segment[3]) * segment[4];
    const double positive = along < 0.0 ? 0.0 : along;
    const double t = positive > 1.0 ? 1.0 : positive;
    const double dx = x[i] - (segment[0] + t * segment[2]);
    const double dy = y[i] - (segment[1] + t * segment[3]);
    const double squaredDistance = dx * dx + dy * dy;
    least[i] = squaredDistance < least[i] ? squaredDistance : least[i];
  }
}

itkVectorClones void
LowerToPoint(double px, double py, const double * x, const double * y, double * least)
{
  for (std::uint32_t i = 0; i < PlacesAtATime; ++i)
  {
    const double dx = x[i] - px;
    const double dy = y[i] - py;
    const double squaredDistance = dx * dx + dy * dy;
    least[i] = squaredDistance < least[i] ? squaredDistance : least[i];
  }
}

inline std::uint32_t
CellNumber(double place, std::uint32_t side)
{
  return place > 0.0 ? std::min(static_cast<std::uint32_t>(place), side - 1) : 0u;
}
} // namespace

void
ContourDistanceIndex::Reset()
{
  m_X.clear();
  m_Y.clear();
  m_Segments.clear();
  m_Domains.clear();
  m_Lists.clear();
  m_PairTargets.clear();
  m_PointPairs.clear();
  m_SegmentPairs.clear();
}

void
ContourDistanceIndex::SetPoints(const double * xy, std::size_t count)
{
  this->Reset();
  m_IsSegments = false;
  m_X.resize(count);
  m_Y.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    m_X[i] = xy[2 * i];
    m_Y[i] = xy[2 * i + 1];
  }
  this->PlaceDomains(xy, count);
}

void
ContourDistanceIndex::SetSegments(const double *        xy,
                                  std::size_t           count,
                                  const std::uint32_t * segments,
                                  std::size_t           numberOfSegments)
{
  this->Reset();
  m_IsSegments = true;
  std::vector<bool> used(count, false);
  m_Segments.reserve(numberOfSegments);
  for (std::size_t i = 0; i < numberOfSegments; ++i)
  {
    const std::uint32_t from = segments[2 * i];
    const std::uint32_t to = segments[2 * i + 1];
    used[from] = true;
    used[to] = true;
    SegmentType segment{ xy[2 * from], xy[2 * from + 1], 0.0, 0.0, 0.0 };
    segment.dx = xy[2 * to] - segment.x;
    segment.dy = xy[2 * to + 1] - segment.y;
    const double squaredLength = segment.dx * segment.dx + segment.dy * segment.dy;
    segment.inverseSquaredLength = squaredLength > 0.0 ? 1.0 / squaredLength : 0.0;
    if (!std::isfinite(segment.inverseSquaredLength))
    {
      segment.inverseSquaredLength = 0.0;
    }
    m_Segments.push_back(segment);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!used[i])
    {
      m_Segments.push_back({ xy[2 * i], xy[2 * i + 1], 0.0, 0.0, 0.0 });
    }
  }
  this->PlaceDomains(xy, count);
}

void
ContourDistanceIndex::PlaceDomains(const double * xy, std::size_t count)
{
  if (count == 0)
  {
    return;
  }
  double low[2] = { xy[0], xy[1] };
  double high[2] = { xy[0], xy[1] };
  for (std::size_t i = 1; i < count; ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      low[k] = std::min(low[k], xy[2 * i + k]);
      high[k] = std::max(high[k], xy[2 * i + k]);
    }
  }
  m_CenterX = 0.5 * (low[0] + high[0]);
  m_CenterY = 0.5 * (low[1] + high[1]);
  m_HalfWidth = 0.51 * std::max(high[0] - low[0], high[1] - low[1]);
  m_Grid = ChooseGrid(this->GetNumberOfTargets());
  // Cells must be far above the rounding of the coordinates.
  const double magnitude = std::max(std::abs(m_CenterX), std::abs(m_CenterY));
  m_HasGrid = m_HalfWidth > 1e-6 * magnitude && m_HalfWidth < 1e100 && m_HalfWidth > 1e-100;
}

inline void
ContourDistanceIndex::TestTarget(std::uint32_t target, double x, double y, NearestType & nearest) const
{
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

auto
ContourDistanceIndex::FindByBruteForce(double x, double y) const -> NearestType
{
  NearestType nearest{ std::numeric_limits<double>::infinity(), x, y, 0 };
  const auto  count = static_cast<std::uint32_t>(this->GetNumberOfTargets());
  if (!m_IsSegments)
  {
    // Four lanes, so that the compiler makes vectors of it.
    constexpr std::uint32_t Lanes = 4;
    double                  best[Lanes];
    double                  at[Lanes];
    std::fill(best, best + Lanes, nearest.squaredDistance);
    std::fill(at, at + Lanes, 0.0);
    const std::uint32_t whole = count - count % Lanes;
    const double *      px = m_X.data();
    const double *      py = m_Y.data();
    for (std::uint32_t i = 0; i < whole; i += Lanes)
    {
      for (std::uint32_t k = 0; k < Lanes; ++k)
      {
        const double squaredDistance = Square(x - px[i + k]) + Square(y - py[i + k]);
        const bool   less = squaredDistance < best[k];
        best[k] = less ? squaredDistance : best[k];
        at[k] = less ? static_cast<double>(i) : at[k];
      }
    }
    for (std::uint32_t k = 0; k < Lanes && whole > 0; ++k)
    {
      const auto target = static_cast<std::uint32_t>(at[k]) + k;
      if (best[k] < nearest.squaredDistance || (best[k] == nearest.squaredDistance && target < nearest.target))
      {
        nearest = { best[k], px[target], py[target], target };
      }
    }
    for (std::uint32_t i = whole; i < count; ++i)
    {
      this->TestTarget(i, x, y, nearest);
    }
    return nearest;
  }
  for (std::uint32_t i = 0; i < count; ++i)
  {
    this->TestTarget(i, x, y, nearest);
  }
  return nearest;
}

// Squared distance from the box to the target, or less.
inline double
ContourDistanceIndex::LowerBound(std::uint32_t target, const BoxType & box) const
{
  const auto outside = [](double low, double high, double from, double to) {
    return std::max(0.0, std::max(from - high, low - to));
  };
  if (!m_IsSegments)
  {
    return Square(outside(m_X[target], m_X[target], box.x0, box.x1)) +
           Square(outside(m_Y[target], m_Y[target], box.y0, box.y1));
  }
  // A segment misses the box by its bounding box or by its normal, whichever is more.
  const SegmentType & segment = m_Segments[target];
  const double        xMin = std::min(segment.x, segment.x + segment.dx);
  const double        xMax = std::max(segment.x, segment.x + segment.dx);
  const double        yMin = std::min(segment.y, segment.y + segment.dy);
  const double        yMax = std::max(segment.y, segment.y + segment.dy);
  const double        byBox = Square(outside(xMin, xMax, box.x0, box.x1)) + Square(outside(yMin, yMax, box.y0, box.y1));
  const double        centerX = 0.5 * (box.x0 + box.x1) - segment.x;
  const double        centerY = 0.5 * (box.y0 + box.y1) - segment.y;
  const double radius = 0.5 * ((box.x1 - box.x0) * std::abs(segment.dy) + (box.y1 - box.y0) * std::abs(segment.dx));
  const double across = std::max(0.0, std::abs(centerX * segment.dy - centerY * segment.dx) - radius);
  return std::max(byBox, Square(across) * segment.inverseSquaredLength * (1.0 - 1e-9));
}

// Squared distance from the box's farthest point to the target: at a corner, since the distance is convex.
inline double
ContourDistanceIndex::UpperBound(std::uint32_t target, const BoxType & box) const
{
  if (!m_IsSegments)
  {
    return std::max(Square(box.x0 - m_X[target]), Square(box.x1 - m_X[target])) +
           std::max(Square(box.y0 - m_Y[target]), Square(box.y1 - m_Y[target]));
  }
  double largest = 0.0;
  for (const double x : { box.x0, box.x1 })
  {
    for (const double y : { box.y0, box.y1 })
    {
      NearestType corner{ std::numeric_limits<double>::infinity(), 0.0, 0.0, 0 };
      this->TestTarget(target, x, y, corner);
      largest = std::max(largest, corner.squaredDistance);
    }
  }
  return largest;
}

// Largest squared distance in the box to the target nearest to its centre. Leaves the squared distances from the centre
// in m_Bounds.
double
ContourDistanceIndex::FindUpperBound(const BoxType & box, const std::uint32_t * from, std::size_t count) const
{
  const double  centerX = 0.5 * (box.x0 + box.x1);
  const double  centerY = 0.5 * (box.y0 + box.y1);
  double        least = std::numeric_limits<double>::infinity();
  std::uint32_t nearest = 0;
  m_Bounds.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t target = from == nullptr ? static_cast<std::uint32_t>(i) : from[i];
    NearestType         center{ std::numeric_limits<double>::infinity(), 0.0, 0.0, 0 };
    this->TestTarget(target, centerX, centerY, center);
    m_Bounds[i] = center.squaredDistance;
    if (center.squaredDistance < least)
    {
      least = center.squaredDistance;
      nearest = target;
    }
  }
  return this->UpperBound(nearest, box);
}

// Fills m_Kept with those of the list that can be nearest somewhere in the box.
void
ContourDistanceIndex::KeepPossiblyNearest(const BoxType & box, const std::uint32_t * from, std::size_t count) const
{
  const double upper = this->FindUpperBound(box, from, count) * (1.0 + 1e-9);
  // No point of the box is farther than this from its centre.
  const double radius = 0.5 * std::sqrt(Square(box.x1 - box.x0) + Square(box.y1 - box.y0));
  const double limit = Square(std::sqrt(upper) + radius) * (1.0 + 1e-9);
  m_Kept.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t target = from == nullptr ? static_cast<std::uint32_t>(i) : from[i];
    if (m_Bounds[i] <= limit && this->LowerBound(target, box) <= upper)
    {
      m_Kept.push_back(target);
    }
  }
}

// For a place x and a point p, |x - y|^2 - |x - p|^2 is linear in x for every y: a target that is no nearer than p at
// all four corners of the box is nowhere nearer in it. p is the point of another target next to the box's centre.
void
ContourDistanceIndex::DropDominated(const BoxType & box) const
{
  const std::size_t count = m_Kept.size();
  if (count < 2)
  {
    return;
  }
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  const double     centerX = 0.5 * (box.x0 + box.x1);
  const double     centerY = 0.5 * (box.y0 + box.y1);
  // Those near the centre drop the others, hence first.
  m_Ranked.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    m_Ranked[i] = { Infinity, 0.0, 0.0, m_Kept[i] };
    this->TestTarget(m_Kept[i], centerX, centerY, m_Ranked[i]);
  }
  std::sort(m_Ranked.begin(), m_Ranked.end(), [](const NearestType & a, const NearestType & b) {
    return a.squaredDistance < b.squaredDistance || (a.squaredDistance == b.squaredDistance && a.target < b.target);
  });
  const double cornerX[4] = { box.x0, box.x1, box.x0, box.x1 };
  const double cornerY[4] = { box.y0, box.y0, box.y1, box.y1 };
  m_Kept.clear();
  m_Bounds.clear();
  for (const NearestType & ranked : m_Ranked)
  {
    double corner[4];
    for (int k = 0; k < 4; ++k)
    {
      NearestType nearest{ Infinity, 0.0, 0.0, 0 };
      this->TestTarget(ranked.target, cornerX[k], cornerY[k], nearest);
      corner[k] = nearest.squaredDistance;
    }
    bool dominated = false;
    for (std::size_t j = 0; j < m_Bounds.size() && !dominated; j += 4)
    {
      const double * other = &m_Bounds[j];
      dominated = other[0] <= corner[0] && other[1] <= corner[1] && other[2] <= corner[2] && other[3] <= corner[3];
    }
    if (!dominated)
    {
      m_Kept.push_back(ranked.target);
      for (int k = 0; k < 4; ++k)
      {
        m_Bounds.push_back(Square(cornerX[k] - ranked.x) + Square(cornerY[k] - ranked.y));
      }
    }
  }
}

// Fills m_Kept with the targets of a cell, from those of the cell around it.
void
ContourDistanceIndex::SelectTargets(DomainType & domain, unsigned int level, std::uint32_t ix, std::uint32_t iy) const
{
  CellType parent{ Unfilled, static_cast<std::uint32_t>(this->GetNumberOfTargets()) };
  if (level > 0)
  {
    const std::uint32_t factor = m_Grid[level] / m_Grid[level - 1];
    parent = this->GetCell(domain, level - 1, ix / factor, iy / factor);
  }
  const double width = (domain.box.x1 - domain.box.x0) / m_Grid[level];
  // A little more than the cell: a query on its border may be counted to either side.
  const double  margin = 1e-6 * width;
  const BoxType box{ domain.box.x0 + ix * width - margin,
                     domain.box.y0 + iy * width - margin,
                     domain.box.x0 + (ix + 1) * width + margin,
                     domain.box.y0 + (iy + 1) * width + margin };
  this->KeepPossiblyNearest(box, parent.first == Unfilled ? nullptr : m_Lists.data() + parent.first, parent.count);
  // The coarsest lists are long and rarely used.
  if (level > 0)
  {
    this->DropDominated(box);
  }
}

// A cell of a grid that is not the finest.
auto
ContourDistanceIndex::GetCell(DomainType & domain, unsigned int level, std::uint32_t ix, std::uint32_t iy) const
  -> CellType
{
  const std::uint32_t side = m_Grid[level];
  const std::size_t   number = static_cast<std::size_t>(iy) * side + ix;
  if (domain.cells[level].empty())
  {
    domain.cells[level].assign(static_cast<std::size_t>(side) * side, CellType{ Unfilled, 0 });
  }
  if (domain.cells[level][number].first == Unfilled)
  {
    this->SelectTargets(domain, level, ix, iy);
    domain.cells[level][number] = { static_cast<std::uint32_t>(m_Lists.size()),
                                    static_cast<std::uint32_t>(m_Kept.size()) };
    m_Lists.insert(m_Lists.end(), m_Kept.begin(), m_Kept.end());
  }
  return domain.cells[level][number];
}

auto
ContourDistanceIndex::FillFinestCell(DomainType & domain, std::uint32_t ix, std::uint32_t iy) const -> CellType
{
  const auto level = static_cast<unsigned int>(m_Grid.size() - 1);
  this->SelectTargets(domain, level, ix, iy);
  const CellType cell{ static_cast<std::uint32_t>(m_PairTargets.size() / 2),
                       static_cast<std::uint32_t>((m_Kept.size() + 1) / 2) };
  for (std::size_t i = 0; i < m_Kept.size(); i += 2)
  {
    PointPair   points{};
    SegmentPair segments{};
    for (std::size_t k = 0; k < 2; ++k)
    {
      const std::uint32_t target = m_Kept[std::min(i + k, m_Kept.size() - 1)];
      m_PairTargets.push_back(target);
      if (m_IsSegments)
      {
        const SegmentType & segment = m_Segments[target];
        segments.x[k] = segment.x;
        segments.y[k] = segment.y;
        segments.dx[k] = segment.dx;
        segments.dy[k] = segment.dy;
        segments.inverseSquaredLength[k] = segment.inverseSquaredLength;
      }
      else
      {
        points.x[k] = m_X[target];
        points.y[k] = m_Y[target];
      }
    }
    if (m_IsSegments)
    {
      m_SegmentPairs.push_back(segments);
    }
    else
    {
      m_PointPairs.push_back(points);
    }
  }
  domain.cells[level][static_cast<std::size_t>(iy) * m_Grid[level] + ix] = cell;
  return cell;
}

// The smallest domain that holds the place; none far outside.
auto
ContourDistanceIndex::FindDomain(double x, double y) const -> DomainType *
{
  const double  away = std::max(std::abs(x - m_CenterX), std::abs(y - m_CenterY));
  double        halfWidth = m_HalfWidth;
  std::uint32_t number = 0;
  while (!(away < halfWidth))
  {
    halfWidth *= DomainGrowth;
    if (++number == NumberOfDomains)
    {
      return nullptr;
    }
  }
  if (m_Domains.empty())
  {
    m_Domains.resize(NumberOfDomains);
  }
  DomainType & domain = m_Domains[number];
  if (domain.cellsPerUnit == 0.0)
  {
    domain.box = { m_CenterX - halfWidth, m_CenterY - halfWidth, m_CenterX + halfWidth, m_CenterY + halfWidth };
    domain.cellsPerUnit = m_Grid.back() / (2.0 * halfWidth);
    domain.cells.back().assign(static_cast<std::size_t>(m_Grid.back()) * m_Grid.back(), CellType{ Unfilled, 0 });
  }
  return &domain;
}

auto
ContourDistanceIndex::FindNearest(double x, double y) const -> NearestType
{
  if (!m_HasGrid || m_Search == SearchEnum::BruteForce ||
      (m_Search == SearchEnum::Automatic && this->GetNumberOfTargets() <= BruteForceLimit))
  {
    return this->FindByBruteForce(x, y);
  }
  DomainType * domain = this->FindDomain(x, y);
  if (domain == nullptr)
  {
    return this->FindByBruteForce(x, y);
  }
  const std::uint32_t ix = CellNumber((x - domain->box.x0) * domain->cellsPerUnit, m_Grid.back());
  const std::uint32_t iy = CellNumber((y - domain->box.y0) * domain->cellsPerUnit, m_Grid.back());
  CellType            cell = domain->cells.back()[static_cast<std::size_t>(iy) * m_Grid.back() + ix];
  if (cell.first == Unfilled)
  {
    cell = this->FillFinestCell(*domain, ix, iy);
  }
  NearestType nearest{ std::numeric_limits<double>::infinity(), x, y, 0 };
  for (std::uint32_t i = 2 * cell.first; i < 2 * (cell.first + cell.count); ++i)
  {
    this->TestTarget(m_PairTargets[i], x, y, nearest);
  }
  return nearest;
}

// The point of each segment that is nearest to the place.
inline void
ContourDistanceIndex::FindFeet(const SegmentPair & pair, double x, double y, double footX[2], double footY[2])
{
  for (int k = 0; k < 2; ++k)
  {
    const double along = ((x - pair.x[k]) * pair.dx[k] + (y - pair.y[k]) * pair.dy[k]) * pair.inverseSquaredLength[k];
    const double positive = along < 0.0 ? 0.0 : along;
    const double t = positive > 1.0 ? 1.0 : positive;
    footX[k] = pair.x[k] + t * pair.dx[k];
    footY[k] = pair.y[k] + t * pair.dy[k];
  }
}

inline void
ContourDistanceIndex::FindFeet(const PointPair & pair, double, double, double footX[2], double footY[2])
{
  for (int k = 0; k < 2; ++k)
  {
    footX[k] = pair.x[k];
    footY[k] = pair.y[k];
  }
}

// Most cells have one pair, hence a loop whose end is foreseen and no branch within it.
template <typename TPair>
void
ContourDistanceIndex::FindNearestPointsByPairs(const std::vector<TPair> & pairs,
                                               const double *             places,
                                               std::size_t                count,
                                               double *                   nearest) const
{
  DomainType &        inner = *this->FindDomain(m_CenterX, m_CenterY);
  const double        x0 = inner.box.x0;
  const double        y0 = inner.box.y0;
  const double        cellsPerUnit = inner.cellsPerUnit;
  const std::uint32_t side = m_Grid.back();
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = places[2 * i];
    const double y = places[2 * i + 1];
    double       fx = (x - x0) * cellsPerUnit;
    double       fy = (y - y0) * cellsPerUnit;
    DomainType * domain = &inner;
    if (!(fx >= 0.0 && fx < side && fy >= 0.0 && fy < side))
    {
      domain = this->FindDomain(x, y);
      if (domain == nullptr)
      {
        const NearestType found = this->FindByBruteForce(x, y);
        nearest[2 * i] = found.x;
        nearest[2 * i + 1] = found.y;
        continue;
      }
      fx = (x - domain->box.x0) * domain->cellsPerUnit;
      fy = (y - domain->box.y0) * domain->cellsPerUnit;
    }
    const std::uint32_t ix = CellNumber(fx, side);
    const std::uint32_t iy = CellNumber(fy, side);
    CellType            cell = domain->cells.back()[static_cast<std::size_t>(iy) * side + ix];
    if (cell.first == Unfilled)
    {
      cell = this->FillFinestCell(*domain, ix, iy);
    }
    const TPair * const pair = pairs.data() + cell.first;
    double              best = std::numeric_limits<double>::infinity();
    std::uint32_t       at = 0;
    double              footX[2];
    double              footY[2];
    for (std::uint32_t n = 0; n < cell.count; ++n)
    {
      FindFeet(pair[n], x, y, footX, footY);
      const double        first = Square(x - footX[0]) + Square(y - footY[0]);
      const double        second = Square(x - footX[1]) + Square(y - footY[1]);
      const double        nearer = second < first ? second : first;
      const std::uint32_t number = second < first ? 1u : 0u;
      if constexpr (std::is_same<TPair, PointPair>::value)
      {
        const std::uint32_t mask = nearer < best ? 0xffffffffu : 0u;
        best = nearer < best ? nearer : best;
        at = (at & ~mask) | ((2 * n + number) & mask);
      }
      else if (nearer < best)
      {
        // To find the foot once more would take longer than a branch.
        best = nearer;
        nearest[2 * i] = footX[number];
        nearest[2 * i + 1] = footY[number];
      }
    }
    if constexpr (std::is_same<TPair, PointPair>::value)
    {
      nearest[2 * i] = pair[at / 2].x[at % 2];
      nearest[2 * i + 1] = pair[at / 2].y[at % 2];
    }
  }
}

void
ContourDistanceIndex::FindNearestPoints(const double * places, std::size_t count, double * nearest) const
{
  if (!m_HasGrid || m_Search == SearchEnum::BruteForce ||
      (m_Search == SearchEnum::Automatic && this->GetNumberOfTargets() <= BruteForceLimit))
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const NearestType found = this->FindByBruteForce(places[2 * i], places[2 * i + 1]);
      nearest[2 * i] = found.x;
      nearest[2 * i + 1] = found.y;
    }
  }
  else if (m_IsSegments)
  {
    this->FindNearestPointsByPairs(m_SegmentPairs, places, count, nearest);
  }
  else
  {
    this->FindNearestPointsByPairs(m_PointPairs, places, count, nearest);
  }
}

// Fills the field where a cell of the coarsest grid covers it: every target of the cell is compared with all its places
// at a time, which is vectorised.
void
ContourDistanceIndex::FillField(DomainType & domain, std::uint32_t bx, std::uint32_t by) const
{
  const std::uint32_t side = FieldSide / m_Grid[0];
  const double        width = (domain.box.x1 - domain.box.x0) / FieldSide;
  const CellType      cell = this->GetCell(domain, 0, bx, by);
  double              x[PlacesAtATime];
  double              y[PlacesAtATime];
  double              least[PlacesAtATime];
  for (std::uint32_t i = 0; i < PlacesAtATime; ++i)
  {
    x[i] = domain.box.x0 + (bx * side + i % side + 0.5) * width;
    y[i] = domain.box.y0 + (by * side + i / side + 0.5) * width;
    least[i] = std::numeric_limits<double>::infinity();
  }
  for (std::uint32_t n = 0; n < cell.count; ++n)
  {
    const std::uint32_t target = m_Lists[cell.first + n];
    if (m_IsSegments)
    {
      const SegmentType & s = m_Segments[target];
      const double        segment[5] = { s.x, s.y, s.dx, s.dy, s.inverseSquaredLength };
      LowerToSegment(segment, x, y, least);
    }
    else
    {
      LowerToPoint(m_X[target], m_Y[target], x, y, least);
    }
  }
  for (std::uint32_t i = 0; i < side * side; ++i)
  {
    domain.field[static_cast<std::size_t>(by * side + i / side) * FieldSide + bx * side + i % side] =
      static_cast<float>(std::sqrt(least[i]));
  }
}

double
ContourDistanceIndex::FindApproximateDistance(double x, double y) const
{
  DomainType * domain = m_HasGrid ? this->FindDomain(x, y) : nullptr;
  if (domain == nullptr)
  {
    return std::sqrt(this->FindByBruteForce(x, y).squaredDistance);
  }
  if (domain->field.empty())
  {
    domain->field.assign(static_cast<std::size_t>(FieldSide) * FieldSide, -1.0f);
  }
  const double        width = (domain->box.x1 - domain->box.x0) / FieldSide;
  const std::uint32_t ix = CellNumber((x - domain->box.x0) / width, FieldSide);
  const std::uint32_t iy = CellNumber((y - domain->box.y0) / width, FieldSide);
  const float &       distance = domain->field[static_cast<std::size_t>(iy) * FieldSide + ix];
  if (distance < 0.0f)
  {
    this->FillField(*domain, ix * m_Grid[0] / FieldSide, iy * m_Grid[0] / FieldSide);
  }
  return distance;
}

void
ContourDistanceIndex::FindApproximateDistances(const double * places, std::size_t count, double * distances) const
{
  // Nearly all are in the two smallest domains.
  const DomainType * domains[2] = { nullptr, nullptr };
  if (m_HasGrid)
  {
    domains[0] = this->FindDomain(m_CenterX, m_CenterY);
    domains[1] = this->FindDomain(m_CenterX + 1.5 * m_HalfWidth, m_CenterY);
  }
  if (!m_HasGrid || domains[0]->field.empty() || domains[1]->field.empty())
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      distances[i] = this->FindApproximateDistance(places[2 * i], places[2 * i + 1]);
    }
    return;
  }
  const float * const   fields[2] = { domains[0]->field.data(), domains[1]->field.data() };
  const BoxType         inner = domains[0]->box;
  const BoxType         outer = domains[1]->box;
  const double          innerWidth = (inner.x1 - inner.x0) / FieldSide;
  const double          outerWidth = (outer.x1 - outer.x0) / FieldSide;
  const double          halfWidth = m_HalfWidth;
  const double          centerX = m_CenterX;
  const double          centerY = m_CenterY;
  constexpr double      Last = FieldSide - 1;
  constexpr std::size_t BatchSize = 64;
  std::int32_t          cells[BatchSize];
  for (std::size_t first = 0; first < count; first += BatchSize)
  {
    // The cells in a loop of their own, which is vectorised; -1 farther away.
    const std::size_t size = std::min(BatchSize, count - first);
    for (std::size_t i = 0; i < size; ++i)
    {
      const double x = places[2 * (first + i)];
      const double y = places[2 * (first + i) + 1];
      const double awayX = std::abs(x - centerX);
      const double awayY = std::abs(y - centerY);
      const double away = awayX < awayY ? awayY : awayX;
      const bool   isInner = away < halfWidth;
      const bool   isKnown = away < DomainGrowth * halfWidth;
      const double width = isInner ? innerWidth : outerWidth;
      const double fx = (x - (isInner ? inner.x0 : outer.x0)) / width;
      const double fy = (y - (isInner ? inner.y0 : outer.y0)) / width;
      const double px = std::min(Last, std::max(0.0, fx));
      const double py = std::min(Last, std::max(0.0, fy));
      const auto   cell = static_cast<std::int32_t>(py) * static_cast<std::int32_t>(FieldSide) +
                        static_cast<std::int32_t>(px) +
                        (isInner ? 0 : static_cast<std::int32_t>(FieldSide * FieldSide));
      cells[i] = isKnown ? cell : -1;
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      double distance = -1.0;
      if (cells[i] >= 0)
      {
        const auto cell = static_cast<std::uint32_t>(cells[i]);
        distance = fields[cell / (FieldSide * FieldSide)][cell % (FieldSide * FieldSide)];
      }
      distances[first + i] = distance >= 0.0
                               ? distance
                               : this->FindApproximateDistance(places[2 * (first + i)], places[2 * (first + i) + 1]);
    }
  }
}
} // namespace itk
