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
#include "itkVectorClones.h"

#include <algorithm>
#include <cmath>
#include <limits>

// The field of approximate distances, which ranks many candidates before a few are measured exactly.
namespace itk
{
using namespace ContourDistanceIndexDetail;

namespace
{
// Cells a side of the field of approximate distances: a multiple of the coarsest grid's.
constexpr std::uint32_t FieldSide = 64;

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
} // namespace

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
