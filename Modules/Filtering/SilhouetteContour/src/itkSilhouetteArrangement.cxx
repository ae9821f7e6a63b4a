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
#include "itkSilhouetteArrangement.h"

#include "itkMacro.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
using namespace SilhouetteGrid;

namespace
{
constexpr std::uint32_t None = 0xffffffffu;

/** Edges of a surface meet their neighbours and cross few others, so that each has some four of what is counted here.
 * Of a file that says it is a scan and has 200,000 edges that cross all over it would be gigabytes. */
void
VerifyNumberOfMeetings(std::size_t meetings, std::size_t segments)
{
  if (meetings > 1000000 + 16 * segments)
  {
    itkGenericExceptionMacro(
      "the edges of its outline cross each other all over, which no surface of teeth does: repair "
      "the mesh, or export the scan again");
  }
}

bool
Less(const GridPoint & a, const GridPoint & b)
{
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

Fraction
MakeFraction(std::int64_t num, std::int64_t den)
{
  return den < 0 ? Fraction{ -num, -den } : Fraction{ num, den };
}

/** How far direction d is turned counter-clockwise from b: 0 up to a half turn, 1 half a turn, 2 more, 3 a full turn.
 */
int
TurnClass(const GridPoint & b, const GridPoint & d)
{
  const std::int64_t cross = Cross(b, d);
  if (cross != 0)
  {
    return cross > 0 ? 0 : 2;
  }
  return Dot(b, d) < 0 ? 1 : 3;
}
} // namespace

SilhouetteArrangement::SilhouetteArrangement(std::vector<Segment> segments)
  : m_Segments(std::move(segments))
  , m_Spans(m_Segments.size(), Span{ None, 0 })
  , m_Stamps(m_Segments.size(), 0)
{
  m_Events.reserve(4 * m_Segments.size());
  this->BuildCells();
}

void
SilhouetteArrangement::BuildCells()
{
  const std::size_t count = m_Segments.size();
  if (count == 0)
  {
    return;
  }
  std::int32_t lowX = m_Segments[0].px;
  std::int32_t lowY = m_Segments[0].py;
  std::int32_t highX = lowX;
  std::int32_t highY = lowY;
  for (const Segment & segment : m_Segments)
  {
    lowX = std::min(lowX, std::min(segment.px, segment.qx));
    lowY = std::min(lowY, std::min(segment.py, segment.qy));
    highX = std::max(highX, std::max(segment.px, segment.qx));
    highY = std::max(highY, std::max(segment.py, segment.qy));
  }
  m_Low = { lowX, lowY };
  const auto          width = static_cast<std::uint64_t>(highX - lowX);
  const auto          height = static_cast<std::uint64_t>(highY - lowY);
  const std::uint64_t limit = 2 * count + 16;
  m_Shift = 0;
  while (((width >> m_Shift) + 1) * ((height >> m_Shift) + 1) > limit)
  {
    ++m_Shift;
  }
  m_Columns = static_cast<std::size_t>(width >> m_Shift) + 1;
  const std::size_t cells = m_Columns * (static_cast<std::size_t>(height >> m_Shift) + 1);
  m_CellStarts.assign(cells + 1, 0);
  struct Entry
  {
    std::uint32_t cell;
    std::uint32_t segment;
  };
  std::vector<Entry> entries;
  entries.reserve(4 * count);
  for (std::uint32_t s = 0; s < count; ++s)
  {
    this->ForEachCell(m_Segments[s], [&](std::size_t cell) {
      ++m_CellStarts[cell];
      entries.push_back({ static_cast<std::uint32_t>(cell), s });
    });
    VerifyNumberOfMeetings(entries.size(), count);
  }
  std::uint32_t sum = 0;
  for (std::uint32_t & start : m_CellStarts)
  {
    sum += start;
    start = sum;
  }
  // From behind: the starts end as they should be.
  m_CellSegments.resize(entries.size());
  for (std::size_t i = entries.size(); i-- > 0;)
  {
    m_CellSegments[--m_CellStarts[entries[i].cell]] = entries[i].segment;
  }
}

/** Calls visit for every cell that a segment passes through, perhaps for a neighbour as well. */
template <typename TVisit>
inline void
SilhouetteArrangement::ForEachCell(const Segment & segment, TVisit && visit) const
{
  const GridPoint    a = segment.P() - m_Low;
  const GridPoint    b = segment.Q() - m_Low;
  const std::int64_t x0 = std::min(a.x, b.x);
  const std::int64_t x1 = std::max(a.x, b.x);
  const std::int64_t j0 = std::min(a.y, b.y) >> m_Shift;
  const std::int64_t j1 = std::max(a.y, b.y) >> m_Shift;
  std::int64_t       i0 = x0 >> m_Shift;
  std::int64_t       i1 = x1 >> m_Shift;
  const auto         visitRow = [&](std::int64_t j) {
    for (std::int64_t i = i0; i <= i1; ++i)
    {
      visit(static_cast<std::size_t>(j) * m_Columns + static_cast<std::size_t>(i));
    }
  };
  if ((i1 - i0 + 1) * (j1 - j0 + 1) <= 4 || i0 == i1 || j0 == j1)
  {
    for (std::int64_t j = j0; j <= j1; ++j)
    {
      visitRow(j);
    }
    return;
  }
  const double slope = static_cast<double>(b.x - a.x) / static_cast<double>(b.y - a.y);
  for (std::int64_t j = j0; j <= j1; ++j)
  {
    const double atLow = static_cast<double>(a.x) + slope * static_cast<double>((j << m_Shift) - a.y);
    const double atHigh = static_cast<double>(a.x) + slope * static_cast<double>(((j + 1) << m_Shift) - a.y);
    // One unit of slack covers the rounding.
    const double lowX = std::min(atLow, atHigh) - 1.0;
    const double highX = std::max(atLow, atHigh) + 1.0;
    i0 = (lowX <= static_cast<double>(x0) ? x0 : static_cast<std::int64_t>(lowX)) >> m_Shift;
    i1 = (highX >= static_cast<double>(x1) ? x1 : static_cast<std::int64_t>(highX)) >> m_Shift;
    visitRow(j);
  }
}

auto
SilhouetteArrangement::WalkOuterBoundaries(std::size_t components, const std::uint32_t * componentOfPoint)
  -> std::vector<std::vector<Stretch>>
{
  const auto componentOf = [componentOfPoint](std::uint32_t point) {
    return componentOfPoint == nullptr ? 0u : componentOfPoint[point];
  };
  std::vector<std::vector<Stretch>> loops;
  // The smallest point of each component lies on the outer boundary of what the component is connected with.
  std::vector<std::uint32_t> first(components, None);
  const auto                 lowEnd = [this](std::uint32_t s) {
    const Segment & segment = m_Segments[s];
    return Less(segment.P(), segment.Q()) ? segment.P() : segment.Q();
  };
  for (std::uint32_t s = 0; s < m_Segments.size(); ++s)
  {
    std::uint32_t & best = first[componentOf(m_Segments[s].a)];
    if (best == None || Less(lowEnd(s), lowEnd(best)))
    {
      best = s;
    }
  }
  std::vector<std::uint32_t> starts;
  for (const std::uint32_t s : first)
  {
    if (s != None)
    {
      starts.push_back(s);
    }
  }
  // A loop that contains a component begins before it.
  std::stable_sort(
    starts.begin(), starts.end(), [&lowEnd](std::uint32_t a, std::uint32_t b) { return Less(lowEnd(a), lowEnd(b)); });
  std::vector<bool>         touched(components, false);
  std::vector<LoopLocation> locations;
  for (const std::uint32_t start : starts)
  {
    if (touched[componentOf(m_Segments[start].a)])
    {
      continue;
    }
    const GridPoint point = lowEnd(start);
    bool            inside = false;
    for (std::size_t l = 0; l < loops.size() && !inside; ++l)
    {
      inside = this->IsInside(point, loops[l], locations[l]);
    }
    if (inside)
    {
      continue;
    }
    std::vector<std::uint32_t> met;
    loops.push_back(this->Walk(start, components > 1 ? &met : nullptr));
    if (components > 1)
    {
      for (const std::uint32_t s : met)
      {
        touched[componentOf(m_Segments[s].a)] = true;
      }
      locations.push_back(this->Locate(loops.back()));
    }
  }
  return loops;
}

/** Everything that touches segment s, in the order along it; its own ends included. */
auto
SilhouetteArrangement::EventsOf(std::uint32_t s) -> Span
{
  if (m_Spans[s].begin != None)
  {
    return m_Spans[s];
  }
  const auto      begin = static_cast<std::uint32_t>(m_Events.size());
  const Segment & a = m_Segments[s];
  const GridPoint d = a.Q() - a.P();
  m_Events.push_back({ 0.0, { 0, 1 }, { 0, 1 }, s });
  m_Events.push_back({ 1.0, { 1, 1 }, { 1, 1 }, s });
  ++m_Stamp;
  m_Stamps[s] = m_Stamp;
  const std::int32_t lowX = std::min(a.px, a.qx);
  const std::int32_t highX = std::max(a.px, a.qx);
  const std::int32_t lowY = std::min(a.py, a.qy);
  const std::int32_t highY = std::max(a.py, a.qy);
  // Without a branch: which of them have overlapping boxes is hard to predict.
  std::size_t near = 0;
  this->ForEachCell(a, [&](std::size_t cell) {
    const std::uint32_t first = m_CellStarts[cell];
    const std::uint32_t last = m_CellStarts[cell + 1];
    if (m_Near.size() < near + (last - first))
    {
      m_Near.resize(2 * (near + (last - first)));
    }
    for (std::uint32_t k = first; k < last; ++k)
    {
      const std::uint32_t r = m_CellSegments[k];
      const Segment &     b = m_Segments[r];
      m_Near[near] = r;
      near += static_cast<std::size_t>(static_cast<unsigned int>(m_Stamps[r] != m_Stamp) &
                                       static_cast<unsigned int>(std::max(b.px, b.qx) >= lowX) &
                                       static_cast<unsigned int>(std::min(b.px, b.qx) <= highX) &
                                       static_cast<unsigned int>(std::max(b.py, b.qy) >= lowY) &
                                       static_cast<unsigned int>(std::min(b.py, b.qy) <= highY));
      m_Stamps[r] = m_Stamp;
    }
  });
  for (std::size_t k = 0; k < near; ++k)
  {
    const std::uint32_t r = m_Near[k];
    const Segment &     b = m_Segments[r];
    const std::int64_t  side0 = Cross(d, b.P() - a.P());
    const std::int64_t  side1 = Cross(d, b.Q() - a.P());
    if ((side0 > 0 && side1 > 0) || (side0 < 0 && side1 < 0))
    {
      continue;
    }
    const GridPoint e = b.Q() - b.P();
    if (side0 == 0 && side1 == 0)
    {
      this->AddOverlap(a, b, d, e, r);
      continue;
    }
    const std::int64_t side2 = Cross(e, a.P() - b.P());
    const std::int64_t side3 = Cross(e, a.Q() - b.P());
    if ((side2 > 0 && side3 > 0) || (side2 < 0 && side3 < 0))
    {
      continue;
    }
    const Fraction here = MakeFraction(side2, side2 - side3);
    m_Events.push_back({ here.Value(), here, MakeFraction(side0, side0 - side1), r });
  }
  VerifyNumberOfMeetings(m_Events.size(), m_Segments.size());
  std::sort(m_Events.begin() + begin, m_Events.end(), [](const Event & x, const Event & y) {
    // The values are good to 1e-15.
    if (std::abs(x.t - y.t) > 1e-13)
    {
      return x.t < y.t;
    }
    const int order = Compare(x.here, y.here);
    return order != 0 ? order < 0 : x.other < y.other;
  });
  m_Spans[s] = { begin, static_cast<std::uint32_t>(m_Events.size() - begin) };
  return m_Spans[s];
}

/** Collinear segments: the ends of what they share. */
void
SilhouetteArrangement::AddOverlap(
  const Segment & a, const Segment & b, const GridPoint & d, const GridPoint & e, std::uint32_t r)
{
  const std::int64_t lengthA = Dot(d, d);
  const std::int64_t lengthB = Dot(e, e);
  const auto         addIfShared = [&](const GridPoint & point) {
    const std::int64_t onA = Dot(point - a.P(), d);
    const std::int64_t onB = Dot(point - b.P(), e);
    if (onA >= 0 && onA <= lengthA && onB >= 0 && onB <= lengthB)
    {
      const Fraction here{ onA, lengthA };
      m_Events.push_back({ here.Value(), here, { onB, lengthB }, r });
    }
  };
  addIfShared(b.P());
  addIfShared(b.Q());
  addIfShared(a.P());
  addIfShared(a.Q());
}

bool
SilhouetteArrangement::IsAt(const Segment & segment, const Fraction & t, const GridPoint & point) const
{
  const GridPoint d = segment.Q() - segment.P();
  const GridPoint w = point - segment.P();
  return CompareSignedProducts(w.x, t.den, t.num, d.x) == 0 && CompareSignedProducts(w.y, t.den, t.num, d.y) == 0;
}

/** Walks around the unbounded face, which lies to the right, from the smallest end of the start segment, which must
 * be on it. */
auto
SilhouetteArrangement::Walk(std::uint32_t start, std::vector<std::uint32_t> * met) -> std::vector<Stretch>
{
  std::vector<Stretch> loop;
  const bool           startsAtP = Less(m_Segments[start].P(), m_Segments[start].Q());
  const GridPoint      origin = startsAtP ? m_Segments[start].P() : m_Segments[start].Q();
  // Arrival: as if from the left, where nothing is.
  std::uint32_t s = start;
  GridPoint     back{ -1, 0 };
  Span          span = this->EventsOf(s);
  std::uint32_t first = startsAtP ? 0 : span.count - 1;
  std::uint32_t last = first;
  GridPoint     initial{ 0, 0 };
  bool          forward = true;
  while (true)
  {
    // The events [first, last] of s are at the point reached: grow the group.
    const Event * const events = m_Events.data() + span.begin;
    while (first > 0 && Compare(events[first - 1].here, events[first].here) == 0)
    {
      --first;
    }
    while (last + 1 < span.count && Compare(events[last + 1].here, events[last].here) == 0)
    {
      ++last;
    }
    const Fraction here = events[first].here;

    std::uint32_t nextSegment = None;
    bool          nextForward = true;
    Fraction      nextFrom{ 0, 1 };
    GridPoint     nextDirection{ 0, 0 };
    int           nextClass = 4;
    const auto    consider = [&](std::uint32_t r, const Fraction & t) {
      const GridPoint d = m_Segments[r].Q() - m_Segments[r].P();
      for (const bool ahead : { true, false })
      {
        if (ahead ? t.num == t.den : t.num == 0)
        {
          continue;
        }
        const GridPoint direction = ahead ? d : GridPoint{ -d.x, -d.y };
        const int       turn = TurnClass(back, direction);
        if (turn < nextClass || (turn == nextClass && Cross(direction, nextDirection) > 0))
        {
          nextSegment = r;
          nextForward = ahead;
          nextFrom = t;
          nextDirection = direction;
          nextClass = turn;
        }
      }
    };
    consider(s, here);
    for (std::uint32_t k = first; k <= last; ++k)
    {
      if (events[k].other != s)
      {
        consider(events[k].other, events[k].there);
        if (met != nullptr)
        {
          met->push_back(events[k].other);
        }
      }
    }
    if (met != nullptr)
    {
      met->push_back(s);
    }

    if (!loop.empty() && Cross(nextDirection, initial) == 0 && Dot(nextDirection, initial) > 0 &&
        this->IsAt(m_Segments[s], here, origin))
    {
      loop.back().to = here;
      return loop;
    }
    if (loop.empty())
    {
      initial = nextDirection;
    }
    const bool straightOn = !loop.empty() && nextSegment == s && nextForward == forward;
    if (!straightOn)
    {
      if (!loop.empty())
      {
        loop.back().to = here;
      }
      loop.push_back({ nextSegment, nextFrom, nextFrom });
    }
    // To the next event on the chosen segment.
    if (nextSegment != s)
    {
      s = nextSegment;
      span = this->EventsOf(s);
      const Event * const begin = m_Events.data() + span.begin;
      const double        value = nextFrom.Value();
      const Event * const at =
        std::lower_bound(begin, begin + span.count, value, [&nextFrom](const Event & event, double t) {
          return std::abs(event.t - t) > 1e-13 ? event.t < t : Compare(event.here, nextFrom) < 0;
        });
      first = static_cast<std::uint32_t>(at - begin);
      last = first;
      while (last + 1 < span.count && Compare(begin[last + 1].here, nextFrom) == 0)
      {
        ++last;
      }
    }
    forward = nextForward;
    back = { -nextDirection.x, -nextDirection.y };
    first = last = forward ? last + 1 : first - 1;
  }
}

auto
SilhouetteArrangement::Locate(const std::vector<Stretch> & loop) const -> LoopLocation
{
  LoopLocation location;
  location.low[0] = location.low[1] = std::numeric_limits<double>::max();
  location.high[0] = location.high[1] = std::numeric_limits<double>::lowest();
  for (const Stretch & stretch : loop)
  {
    const Segment & segment = m_Segments[stretch.segment];
    const double    t = stretch.from.Value();
    const double    x = static_cast<double>(segment.px) + t * static_cast<double>(segment.qx - segment.px);
    const double    y = static_cast<double>(segment.py) + t * static_cast<double>(segment.qy - segment.py);
    location.y.push_back(y);
    location.low[0] = std::min(location.low[0], x - 1.0);
    location.low[1] = std::min(location.low[1], y - 1.0);
    location.high[0] = std::max(location.high[0], x + 1.0);
    location.high[1] = std::max(location.high[1], y + 1.0);
  }
  return location;
}

/** Whether a corner of the loop is above the height, exactly. */
bool
SilhouetteArrangement::IsAbove(const Stretch & stretch, double approximate, std::int64_t height) const
{
  if (std::abs(approximate - static_cast<double>(height)) > 0.01)
  {
    return approximate > static_cast<double>(height);
  }
  const Segment & segment = m_Segments[stretch.segment];
  // p.y + num / den dy > height
  return CompareSignedProducts(stretch.from.num, segment.qy - segment.py, height - segment.py, stretch.from.den) > 0;
}

/** Whether a point that is not on the loop is inside it. */
bool
SilhouetteArrangement::IsInside(const GridPoint &            point,
                                const std::vector<Stretch> & loop,
                                const LoopLocation &         location) const
{
  const auto x = static_cast<double>(point.x);
  const auto y = static_cast<double>(point.y);
  if (x < location.low[0] || x > location.high[0] || y < location.low[1] || y > location.high[1])
  {
    return false;
  }
  bool inside = false;
  bool above = this->IsAbove(loop.back(), location.y.back(), point.y);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const bool        wasAbove = above;
    const std::size_t previous = i == 0 ? loop.size() - 1 : i - 1;
    above = this->IsAbove(loop[i], location.y[i], point.y);
    if (above != wasAbove)
    {
      const Segment & segment = m_Segments[loop[previous].segment];
      const bool      upward = segment.qy > segment.py;
      const auto      side = Orientation(segment.P(), segment.Q(), point);
      if (upward ? side > 0 : side < 0)
      {
        inside = !inside;
      }
    }
  }
  return inside;
}
} // namespace itk
