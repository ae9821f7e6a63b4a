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
#include "itkContourDistanceIndexDetail.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace itk
{
using namespace ContourDistanceIndexDetail;

namespace
{
constexpr std::size_t   BruteForceLimit = 12;
constexpr std::uint32_t NumberOfDomains = 7;

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

} // namespace itk
