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

// Which targets a cell of the grids lists: those that are nearest somewhere in it.
namespace itk
{
using namespace ContourDistanceIndexDetail;

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
} // namespace itk
