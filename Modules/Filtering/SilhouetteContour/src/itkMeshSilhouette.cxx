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
#include "itkMeshSilhouette.h"

#include "itkContourResampling.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
constexpr std::uint32_t None = 0xffffffffu;

/** Edges a block, blocks a cluster. */
constexpr std::size_t BlockSize = 8;
constexpr std::size_t ClusterBlocks = 4;
constexpr std::size_t ClusterSize = BlockSize * ClusterBlocks;

/** Planes are kept in 16 bits. */
constexpr double PlaneUnit = 32767.0;

/** Coordinates have this many bits: differences then have 29, cross products 59, and products of two of those fit in
 * 128. */
constexpr int GridBits = 28;

/** Faces with a larger ratio of perimeter to area (1/mm) are always tested exactly. */
constexpr double NeedleRatio = 2000.0;

/** Asks for memory that will be read soon. */
void
Prefetch(const void * begin, std::size_t size)
{
#ifdef __GNUC__
  for (std::size_t offset = 0; offset < size; offset += 64)
  {
    __builtin_prefetch(static_cast<const char *>(begin) + offset);
  }
#else
  (void)begin;
  (void)size;
#endif
}

/** -1, 0, 1 as a b is less than, equal to, more than c d. */
int
CompareProducts(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d)
{
#ifdef __SIZEOF_INT128__
  __extension__ using Wide = unsigned __int128;
  const Wide left = static_cast<Wide>(a) * b;
  const Wide right = static_cast<Wide>(c) * d;
  return left < right ? -1 : (left > right ? 1 : 0);
#else
  const auto multiply = [](std::uint64_t x, std::uint64_t y) {
    const std::uint64_t xl = x & 0xffffffffu, xh = x >> 32, yl = y & 0xffffffffu, yh = y >> 32;
    const std::uint64_t ll = xl * yl, lh = xl * yh, hl = xh * yl;
    const std::uint64_t middle = (ll >> 32) + (lh & 0xffffffffu) + (hl & 0xffffffffu);
    return std::pair<std::uint64_t, std::uint64_t>(xh * yh + (lh >> 32) + (hl >> 32) + (middle >> 32),
                                                   (middle << 32) | (ll & 0xffffffffu));
  };
  const auto left = multiply(a, b);
  const auto right = multiply(c, d);
  return left < right ? -1 : (right < left ? 1 : 0);
#endif
}

/** The same for signed numbers. */
int
CompareSignedProducts(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d)
{
  const auto magnitude = [](std::int64_t x) { return static_cast<std::uint64_t>(x < 0 ? -x : x); };
  const auto sign = [](std::int64_t x) { return x < 0 ? -1 : (x > 0 ? 1 : 0); };
  const int  left = sign(a) * sign(b);
  const int  right = sign(c) * sign(d);
  if (left != right)
  {
    return left < right ? -1 : 1;
  }
  return left == 0 ? 0 : left * CompareProducts(magnitude(a), magnitude(b), magnitude(c), magnitude(d));
}

/** num / den in [0, 1], den > 0. */
struct Fraction
{
  std::int64_t num;
  std::int64_t den;

  double
  Value() const
  {
    return static_cast<double>(num) / static_cast<double>(den);
  }
};

int
Compare(const Fraction & a, const Fraction & b)
{
  return CompareProducts(static_cast<std::uint64_t>(a.num),
                         static_cast<std::uint64_t>(b.den),
                         static_cast<std::uint64_t>(b.num),
                         static_cast<std::uint64_t>(a.den));
}

struct GridPoint
{
  std::int64_t x;
  std::int64_t y;
};

GridPoint
operator-(const GridPoint & a, const GridPoint & b)
{
  return { a.x - b.x, a.y - b.y };
}

bool
operator==(const GridPoint & a, const GridPoint & b)
{
  return a.x == b.x && a.y == b.y;
}

std::int64_t
Cross(const GridPoint & a, const GridPoint & b)
{
  return a.x * b.y - a.y * b.x;
}

std::int64_t
Dot(const GridPoint & a, const GridPoint & b)
{
  return a.x * b.x + a.y * b.y;
}

std::int64_t
Orientation(const GridPoint & a, const GridPoint & b, const GridPoint & c)
{
  return Cross(b - a, c - a);
}

/** A projected edge. */
struct Segment
{
  std::int32_t  px;
  std::int32_t  py;
  std::int32_t  qx;
  std::int32_t  qy;
  std::uint32_t a;
  std::uint32_t b;

  GridPoint
  P() const
  {
    return { px, py };
  }
  GridPoint
  Q() const
  {
    return { qx, qy };
  }
};

/** Where another segment touches one: its position on both. */
struct Event
{
  double        t;
  Fraction      here;
  Fraction      there;
  std::uint32_t other;
};

/** A stretch of the boundary: segment from one position to another. */
struct Stretch
{
  std::uint32_t segment;
  Fraction      from;
  Fraction      to;
};

/** The planar arrangement of the candidate edges, of which only what the walk touches is computed. */
class Arrangement
{
public:
  explicit Arrangement(std::vector<Segment> segments)
    : m_Segments(std::move(segments))
    , m_Spans(m_Segments.size(), Span{ None, 0 })
    , m_Stamps(m_Segments.size(), 0)
  {
    m_Events.reserve(4 * m_Segments.size());
    this->BuildGrid();
  }

  /** The outer boundaries of the connected parts; componentOf names the part of the mesh that a point belongs to. */
  template <typename TComponent>
  std::vector<std::vector<Stretch>>
  WalkOuterBoundaries(std::size_t components, const TComponent & componentOf)
  {
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

  const Segment &
  GetSegment(std::uint32_t s) const
  {
    return m_Segments[s];
  }

private:
  struct Span
  {
    std::uint32_t begin;
    std::uint32_t count;
  };
  /** Heights of a loop's corners and its box, for the test of what lies inside. */
  struct LoopLocation
  {
    std::vector<double> y;
    double              low[2];
    double              high[2];
  };

  static bool
  Less(const GridPoint & a, const GridPoint & b)
  {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  }

  void
  BuildGrid()
  {
    const std::size_t count = m_Segments.size();
    if (count == 0)
    {
      return;
    }
    GridPoint low = m_Segments[0].P();
    GridPoint high = low;
    for (const Segment & segment : m_Segments)
    {
      low.x = std::min<std::int64_t>(low.x, std::min(segment.px, segment.qx));
      low.y = std::min<std::int64_t>(low.y, std::min(segment.py, segment.qy));
      high.x = std::max<std::int64_t>(high.x, std::max(segment.px, segment.qx));
      high.y = std::max<std::int64_t>(high.y, std::max(segment.py, segment.qy));
    }
    m_Low = low;
    const auto          width = static_cast<std::uint64_t>(high.x - low.x);
    const auto          height = static_cast<std::uint64_t>(high.y - low.y);
    const std::uint64_t limit = 2 * count + 16;
    m_Shift = 0;
    while (((width >> m_Shift) + 1) * ((height >> m_Shift) + 1) > limit)
    {
      ++m_Shift;
    }
    m_Columns = static_cast<std::size_t>(width >> m_Shift) + 1;
    const std::size_t cells = m_Columns * (static_cast<std::size_t>(height >> m_Shift) + 1);
    m_CellStarts.assign(cells + 1, 0);
    for (const Segment & segment : m_Segments)
    {
      this->ForEachCell(segment, [this](std::size_t cell) { ++m_CellStarts[cell + 1]; });
    }
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      m_CellStarts[cell + 1] += m_CellStarts[cell];
    }
    m_CellSegments.resize(m_CellStarts[cells]);
    std::vector<std::uint32_t> fill(m_CellStarts.begin(), m_CellStarts.end() - 1);
    for (std::uint32_t s = 0; s < count; ++s)
    {
      this->ForEachCell(m_Segments[s], [&](std::size_t cell) { m_CellSegments[fill[cell]++] = s; });
    }
  }

  /** Calls visit for every cell that a segment passes through, perhaps for a neighbour as well. */
  template <typename TVisit>
  void
  ForEachCell(const Segment & segment, TVisit && visit) const
  {
    const GridPoint    a = segment.P() - m_Low;
    const GridPoint    b = segment.Q() - m_Low;
    const std::int64_t x0 = std::min(a.x, b.x);
    const std::int64_t x1 = std::max(a.x, b.x);
    const std::int64_t j0 = std::min(a.y, b.y) >> m_Shift;
    const std::int64_t j1 = std::max(a.y, b.y) >> m_Shift;
    std::int64_t       i0 = x0 >> m_Shift;
    std::int64_t       i1 = x1 >> m_Shift;
    const bool         rectangle = i0 == i1 || j0 == j1;
    const double       slope = rectangle ? 0.0 : static_cast<double>(b.x - a.x) / static_cast<double>(b.y - a.y);
    for (std::int64_t j = j0; j <= j1; ++j)
    {
      if (!rectangle)
      {
        const double atLow = static_cast<double>(a.x) + slope * static_cast<double>((j << m_Shift) - a.y);
        const double atHigh = static_cast<double>(a.x) + slope * static_cast<double>(((j + 1) << m_Shift) - a.y);
        // One unit of slack covers the rounding.
        const double lowX = std::min(atLow, atHigh) - 1.0;
        const double highX = std::max(atLow, atHigh) + 1.0;
        i0 = (lowX <= static_cast<double>(x0) ? x0 : static_cast<std::int64_t>(lowX)) >> m_Shift;
        i1 = (highX >= static_cast<double>(x1) ? x1 : static_cast<std::int64_t>(highX)) >> m_Shift;
      }
      for (std::int64_t i = i0; i <= i1; ++i)
      {
        visit(static_cast<std::size_t>(j) * m_Columns + static_cast<std::size_t>(i));
      }
    }
  }

  static Fraction
  MakeFraction(std::int64_t num, std::int64_t den)
  {
    return den < 0 ? Fraction{ -num, -den } : Fraction{ num, den };
  }

  /** Everything that touches segment s, in the order along it; its own ends included. */
  Span
  EventsOf(std::uint32_t s)
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
    this->ForEachCell(a, [&](std::size_t cell) {
      for (std::uint32_t k = m_CellStarts[cell]; k < m_CellStarts[cell + 1]; ++k)
      {
        const std::uint32_t r = m_CellSegments[k];
        if (m_Stamps[r] == m_Stamp)
        {
          continue;
        }
        m_Stamps[r] = m_Stamp;
        const Segment & b = m_Segments[r];
        if (std::max(b.px, b.qx) < lowX || std::min(b.px, b.qx) > highX || std::max(b.py, b.qy) < lowY ||
            std::min(b.py, b.qy) > highY)
        {
          continue;
        }
        const std::int64_t side0 = Cross(d, b.P() - a.P());
        const std::int64_t side1 = Cross(d, b.Q() - a.P());
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
    });
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
  AddOverlap(const Segment & a, const Segment & b, const GridPoint & d, const GridPoint & e, std::uint32_t r)
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

  /** How far direction d is turned counter-clockwise from b: 0 up to a half turn, 1 half a turn, 2 more, 3 a full turn.
   */
  static int
  TurnClass(const GridPoint & b, const GridPoint & d)
  {
    const std::int64_t cross = Cross(b, d);
    if (cross != 0)
    {
      return cross > 0 ? 0 : 2;
    }
    return Dot(b, d) < 0 ? 1 : 3;
  }

  bool
  IsAt(const Segment & segment, const Fraction & t, const GridPoint & point) const
  {
    const GridPoint d = segment.Q() - segment.P();
    const GridPoint w = point - segment.P();
    return CompareSignedProducts(w.x, t.den, t.num, d.x) == 0 && CompareSignedProducts(w.y, t.den, t.num, d.y) == 0;
  }

  /** Walks around the unbounded face, which lies to the right, from the smallest end of the start segment, which must
   * be on it. */
  std::vector<Stretch>
  Walk(std::uint32_t start, std::vector<std::uint32_t> * met)
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

  LoopLocation
  Locate(const std::vector<Stretch> & loop) const
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
  IsAbove(const Stretch & stretch, double approximate, std::int64_t height) const
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
  IsInside(const GridPoint & point, const std::vector<Stretch> & loop, const LoopLocation & location) const
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

  std::vector<Segment>       m_Segments;
  std::vector<Span>          m_Spans;
  std::vector<Event>         m_Events;
  std::vector<std::uint32_t> m_Stamps;
  std::uint32_t              m_Stamp{ 0 };
  GridPoint                  m_Low{ 0, 0 };
  int                        m_Shift{ 0 };
  std::size_t                m_Columns{ 0 };
  std::vector<std::uint32_t> m_CellStarts;
  std::vector<std::uint32_t> m_CellSegments;
};

using Vector3 = std::array<double, 3>;

Vector3
Subtract(const Vector3 & a, const Vector3 & b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double
Norm(const Vector3 & a)
{
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

Vector3
CrossProduct(const Vector3 & a, const Vector3 & b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double
DotProduct(const Vector3 & a, const Vector3 & b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Of a set of planes: mean normal and distance, radii around both, largest ratio and inverse area. */
constexpr std::size_t NumberOfBounds = 8;

/** What a test of planes needs of the projection, in single precision. */
struct PlaneTest
{
  float x;
  float y;
  float z;
  float distance;
  float perRatio;
  float perInverseArea;
  float slack;
};

/** By how much each set of planes has the source on one side, beyond doubt where positive. In a function of its own
 * with nothing to reload, so that it is vectorised. */
void
MeasureDecision(const PlaneTest & test, const float * const bounds[NumberOfBounds], std::size_t count, float * margins)
{
  const PlaneTest     t = test;
  const float * const nx = bounds[0];
  const float * const ny = bounds[1];
  const float * const nz = bounds[2];
  const float * const d = bounds[3];
  const float * const radiusN = bounds[4];
  const float * const radiusD = bounds[5];
  const float * const ratio = bounds[6];
  const float * const inverseArea = bounds[7];
  for (std::size_t i = 0; i < count; ++i)
  {
    const float value = std::abs(nx[i] * t.x + ny[i] * t.y + nz[i] * t.z - d[i]);
    const float bound =
      radiusN[i] * t.distance + radiusD[i] + t.perRatio * ratio[i] + t.perInverseArea * inverseArea[i] + t.slack;
    margins[i] = value - bound;
  }
}

/** Eight edges with the planes of both faces, 16 bits a number. */
struct Block
{
  std::int16_t n[2][3][BlockSize];
  std::int16_t d[2][BlockSize];
};

/** On which side the source is of each face. */
void
MeasureSides(const Block & block, const PlaneTest & test, float radius, float sides[2][BlockSize])
{
  const PlaneTest t = test;
  for (unsigned int side = 0; side < 2; ++side)
  {
    const std::int16_t(&n)[3][BlockSize] = block.n[side];
    const std::int16_t(&d)[BlockSize] = block.d[side];
    float result[BlockSize];
    for (std::size_t i = 0; i < BlockSize; ++i)
    {
      result[i] = static_cast<float>(n[0][i]) * t.x + static_cast<float>(n[1][i]) * t.y +
                  static_cast<float>(n[2][i]) * t.z - static_cast<float>(d[i]) * radius;
    }
    std::memcpy(sides[side], result, sizeof result);
  }
}

/** The point of a mesh edge that projects to a given share of the way between its projected ends. */
Vector3
PointOnEdge(const Vector3 & a, double depthA, const Vector3 & b, double depthB, double t)
{
  const double lambda = t * depthA / (t * depthA + (1.0 - t) * depthB);
  return { a[0] + lambda * (b[0] - a[0]), a[1] + lambda * (b[1] - a[1]), a[2] + lambda * (b[2] - a[2]) };
}
} // namespace

class MeshSilhouette::Implementation
{
public:
  explicit Implementation(const TriangleSurface & surface);

  /** The rounding grid of one projection. */
  struct Grid
  {
    double u0;
    double v0;
    double scale;
    double depthMax;
    /** Largest length of an image vector that a unit vector in the surface's box projects to, px/mm. */
    double magnification;
  };

  struct EdgeRecord
  {
    std::uint32_t a;
    std::uint32_t b;
  };

  Grid
  MakeGrid(const PerspectiveProjection & projection) const;

  GridPoint
  Snap(const PerspectiveProjection & projection, const Grid & grid, std::uint32_t point) const
  {
    double u = 0.0;
    double v = 0.0;
    projection.Project(points[point].data(), u, v);
    return { static_cast<std::int64_t>((u - grid.u0) * grid.scale + 0.5),
             static_cast<std::int64_t>((v - grid.v0) * grid.scale + 0.5) };
  }

  /** Whether no two faces of an edge cover both sides of its projection. */
  template <typename TIterator>
  bool
  IsCandidate(const PerspectiveProjection & projection,
              const Grid &                  grid,
              const EdgeRecord &            edge,
              TIterator                     begin,
              TIterator                     end) const
  {
    const GridPoint a = this->Snap(projection, grid, edge.a);
    const GridPoint b = this->Snap(projection, grid, edge.b);
    bool            left = false;
    bool            right = false;
    for (; begin != end; ++begin)
    {
      const std::int64_t side = Orientation(a, b, this->Snap(projection, grid, *begin));
      left = left || side > 0;
      right = right || side < 0;
    }
    return !(left && right);
  }

  std::vector<EdgeRecord>
  FindCandidates(const PerspectiveProjection & projection, const Grid & grid) const;

  std::vector<Vector3> points;
  std::size_t          edges{ 0 };
  std::size_t          boundaryEdges{ 0 };
  std::size_t          nonManifoldEdges{ 0 };
  std::size_t          components{ 0 };
  /** Component of each point; empty where there is one. */
  std::vector<std::uint32_t> componentOfPoint;

private:
  void
  BuildEdges(const std::vector<TriangleSurface::TriangleType> & triangles);
  void
  BuildComponents(const std::vector<TriangleSurface::TriangleType> & triangles);
  struct RegularEdge
  {
    EdgeRecord                   ends;
    std::array<std::uint32_t, 2> opposites;
  };
  void
  BuildClusters(const std::vector<RegularEdge> & regular);

  /** Edges with one face. */
  std::vector<EdgeRecord> m_Boundary;
  /** Edges that are always tested exactly, and the third points of their faces. */
  std::vector<EdgeRecord>    m_Special;
  std::vector<std::uint32_t> m_SpecialStarts;
  std::vector<std::uint32_t> m_SpecialOpposites;

  /** Edges of two good faces in blocks of similar faces, padded with edges from a point to itself. A face is the plane
   * n.x = d with a unit normal, relative to m_Center, taken along the edge for the first face and against it for the
   * second, so that the edge is a silhouette where the source is on different sides. n is in units of 1 / PlaneUnit, d
   * of m_Radius / PlaneUnit. */
  std::vector<RegularEdge> m_Regular;
  std::vector<Block>       m_Blocks;
  struct BlockBounds
  {
    float values[NumberOfBounds][ClusterBlocks];
  };
  std::vector<BlockBounds> m_BlockBounds;
  std::vector<float>       m_ClusterBounds[NumberOfBounds];

  Vector3 m_Low{};
  Vector3 m_High{};
  Vector3 m_Center{};
  double  m_Radius{ 0.0 };
};

MeshSilhouette::Implementation::Implementation(const TriangleSurface & surface)
  : points(surface.points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (double & x : points[i])
    {
      if (!std::isfinite(x))
      {
        std::ostringstream message;
        message << "Point " << i << " of the surface is not finite.";
        throw std::invalid_argument(message.str());
      }
      x += 0.0; // -0 to +0
    }
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (const std::uint32_t corner : surface.triangles[t])
    {
      if (corner >= points.size())
      {
        std::ostringstream message;
        message << "Triangle " << t << " of the surface names point " << corner << " of " << points.size() << ".";
        throw std::invalid_argument(message.str());
      }
    }
  }

  // Points at one position become the first of them.
  std::vector<std::uint32_t> canonical(points.size());
  {
    std::size_t capacity = 16;
    while (capacity < 2 * points.size())
    {
      capacity *= 2;
    }
    std::vector<std::uint32_t> table(capacity, None);
    for (std::uint32_t i = 0; i < points.size(); ++i)
    {
      std::uint64_t hash = 0;
      for (const double x : points[i])
      {
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof bits);
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
      }
      std::size_t slot = hash & (capacity - 1);
      while (table[slot] != None && points[table[slot]] != points[i])
      {
        slot = (slot + 1) & (capacity - 1);
      }
      if (table[slot] == None)
      {
        table[slot] = i;
      }
      canonical[i] = table[slot];
    }
  }
  std::vector<TriangleSurface::TriangleType> triangles;
  triangles.reserve(surface.triangles.size());
  m_Low.fill(std::numeric_limits<double>::max());
  m_High.fill(std::numeric_limits<double>::lowest());
  for (const TriangleSurface::TriangleType & triangle : surface.triangles)
  {
    const TriangleSurface::TriangleType t{ canonical[triangle[0]], canonical[triangle[1]], canonical[triangle[2]] };
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    {
      triangles.push_back(t);
      for (const std::uint32_t corner : t)
      {
        for (unsigned int k = 0; k < 3; ++k)
        {
          m_Low[k] = std::min(m_Low[k], points[corner][k]);
          m_High[k] = std::max(m_High[k], points[corner][k]);
        }
      }
    }
  }
  if (triangles.empty())
  {
    return;
  }
  for (unsigned int k = 0; k < 3; ++k)
  {
    m_Center[k] = 0.5 * (m_Low[k] + m_High[k]);
  }
  m_Radius = Norm(Subtract(m_High, m_Center));
  this->BuildComponents(triangles);
  this->BuildEdges(triangles);
}

void
MeshSilhouette::Implementation::BuildComponents(const std::vector<TriangleSurface::TriangleType> & triangles)
{
  std::vector<std::uint32_t> parent(points.size(), None);
  const auto                 find = [&parent](std::uint32_t i) {
    while (parent[i] != i)
    {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  };
  for (const TriangleSurface::TriangleType & triangle : triangles)
  {
    for (const std::uint32_t corner : triangle)
    {
      if (parent[corner] == None)
      {
        parent[corner] = corner;
      }
    }
    for (unsigned int k = 1; k < 3; ++k)
    {
      const std::uint32_t a = find(triangle[0]);
      const std::uint32_t b = find(triangle[k]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<std::uint32_t> number(points.size(), None);
  componentOfPoint.assign(points.size(), 0);
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    if (parent[i] != None)
    {
      const std::uint32_t root = find(i);
      if (number[root] == None)
      {
        number[root] = static_cast<std::uint32_t>(components++);
      }
      componentOfPoint[i] = number[root];
    }
  }
  if (components == 1)
  {
    componentOfPoint.clear();
    componentOfPoint.shrink_to_fit();
  }
}

void
MeshSilhouette::Implementation::BuildEdges(const std::vector<TriangleSurface::TriangleType> & triangles)
{
  // Half-edges in buckets of their smaller point.
  struct Half
  {
    std::uint32_t other;
    std::uint32_t opposite;
  };
  std::vector<std::uint32_t> starts(points.size() + 1, 0);
  for (const TriangleSurface::TriangleType & t : triangles)
  {
    for (unsigned int k = 0; k < 3; ++k)
    {
      ++starts[std::min(t[k], t[(k + 1) % 3]) + 1];
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    starts[i + 1] += starts[i];
  }
  std::vector<Half> halves(3 * triangles.size());
  {
    std::vector<std::uint32_t> fill(starts.begin(), starts.end() - 1);
    for (const TriangleSurface::TriangleType & t : triangles)
    {
      for (unsigned int k = 0; k < 3; ++k)
      {
        const std::uint32_t a = t[k];
        const std::uint32_t b = t[(k + 1) % 3];
        halves[fill[std::min(a, b)]++] = { std::max(a, b), t[(k + 2) % 3] };
      }
    }
  }
  std::vector<RegularEdge> regular;
  regular.reserve(halves.size() / 2);
  m_SpecialStarts.push_back(0);
  const auto isGood = [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vector3 ab = Subtract(points[b], points[a]);
    const Vector3 ac = Subtract(points[c], points[a]);
    return Norm(ab) + Norm(ac) < NeedleRatio * Norm(CrossProduct(ab, ac));
  };
  for (std::uint32_t a = 0; a < points.size(); ++a)
  {
    const auto begin = halves.begin() + starts[a];
    const auto end = halves.begin() + starts[a + 1];
    std::sort(begin, end, [](const Half & x, const Half & y) {
      return x.other < y.other || (x.other == y.other && x.opposite < y.opposite);
    });
    for (auto group = begin; group != end;)
    {
      auto next = group;
      while (next != end && next->other == group->other)
      {
        ++next;
      }
      const std::uint32_t b = group->other;
      const auto          faces = next - group;
      ++edges;
      if (faces == 1)
      {
        m_Boundary.push_back({ a, b });
        ++boundaryEdges;
      }
      else if (faces == 2 && isGood(a, b, group->opposite) && isGood(b, a, group[1].opposite))
      {
        regular.push_back({ { a, b }, { group->opposite, group[1].opposite } });
      }
      else
      {
        nonManifoldEdges += faces > 2 ? 1 : 0;
        m_Special.push_back({ a, b });
        for (; group != next; ++group)
        {
          m_SpecialOpposites.push_back(group->opposite);
        }
        m_SpecialStarts.push_back(static_cast<std::uint32_t>(m_SpecialOpposites.size()));
      }
      group = next;
    }
  }
  halves = std::vector<Half>();
  this->BuildClusters(regular);
}

void
MeshSilhouette::Implementation::BuildClusters(const std::vector<RegularEdge> & regular)
{
  struct Plane
  {
    Vector3 n;
    double  d;
    double  ratio;
    double  inverseArea;
  };
  const auto planeOf = [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vector3 ab = Subtract(points[b], points[a]);
    const Vector3 ac = Subtract(points[c], points[a]);
    Plane         plane;
    plane.n = CrossProduct(ab, ac);
    const double twiceArea = Norm(plane.n);
    for (double & x : plane.n)
    {
      x /= twiceArea;
    }
    plane.d = DotProduct(plane.n, Subtract(points[a], m_Center));
    plane.ratio = (Norm(ab) + Norm(ac)) / twiceArea;
    plane.inverseArea = 1.0 / twiceArea;
    return plane;
  };
  const auto planesOf = [&planeOf](const RegularEdge & edge) {
    return std::array<Plane, 2>{ planeOf(edge.ends.a, edge.ends.b, edge.opposites[0]),
                                 planeOf(edge.ends.b, edge.ends.a, edge.opposites[1]) };
  };
  // Sort along a Morton curve through the planes. The source is far away in comparison with the surface, so that
  // normals count more than distances.
  const auto spread = [](double x) {
    // 16 bits to every fourth bit.
    auto bits = static_cast<std::uint64_t>(std::min(65535.0, std::max(0.0, x * 65535.0)));
    bits = (bits | (bits << 24)) & 0x000000ff000000ffu;
    bits = (bits | (bits << 12)) & 0x000f000f000f000fu;
    bits = (bits | (bits << 6)) & 0x0303030303030303u;
    bits = (bits | (bits << 3)) & 0x1111111111111111u;
    return bits;
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(regular.size());
  for (std::uint32_t i = 0; i < regular.size(); ++i)
  {
    const std::array<Plane, 2> planes = planesOf(regular[i]);
    std::uint64_t              key = 0;
    for (unsigned int k = 0; k < 3; ++k)
    {
      key |= spread(0.5 + 0.25 * (planes[0].n[k] + planes[1].n[k])) << k;
    }
    key |= spread(0.5 + (planes[0].d + planes[1].d) / (32.0 * m_Radius)) << 3;
    order[i] = { key, i };
  }
  std::sort(order.begin(), order.end());

  // The mean plane of some, and how far the others are from it.
  using BoundsType = std::array<float, NumberOfBounds>;
  const auto boundsOf = [](const Plane * begin, const Plane * end) {
    Vector3      n{ 0.0, 0.0, 0.0 };
    double       d = 0.0;
    const double weight = 1.0 / static_cast<double>(end - begin);
    for (const Plane * plane = begin; plane != end; ++plane)
    {
      for (unsigned int k = 0; k < 3; ++k)
      {
        n[k] += weight * plane->n[k];
      }
      d += weight * plane->d;
    }
    double radiusN = 0.0;
    double radiusD = 0.0;
    double ratio = 0.0;
    double inverseArea = 0.0;
    for (const Plane * plane = begin; plane != end; ++plane)
    {
      radiusN = std::max(radiusN, Norm(Subtract(plane->n, n)));
      radiusD = std::max(radiusD, std::abs(plane->d - d));
      ratio = std::max(ratio, plane->ratio);
      inverseArea = std::max(inverseArea, plane->inverseArea);
    }
    // Rounded up.
    return BoundsType{ static_cast<float>(n[0]),
                       static_cast<float>(n[1]),
                       static_cast<float>(n[2]),
                       static_cast<float>(d),
                       static_cast<float>(1.000001 * radiusN),
                       static_cast<float>(1.000001 * radiusD),
                       static_cast<float>(1.000001 * ratio),
                       static_cast<float>(1.000001 * inverseArea) };
  };

  const std::size_t clusters = (regular.size() + ClusterSize - 1) / ClusterSize;
  m_Regular.resize(clusters * ClusterSize);
  m_Blocks.resize(clusters * ClusterBlocks);
  m_BlockBounds.resize(clusters);
  for (std::vector<float> & bound : m_ClusterBounds)
  {
    bound.resize(clusters);
  }
  for (std::size_t c = 0; c < clusters; ++c)
  {
    std::array<Plane, 2 * ClusterSize> planes;
    for (std::size_t i = 0; i < ClusterSize; ++i)
    {
      const std::size_t          at = c * ClusterSize + i;
      const RegularEdge &        edge = regular[order[std::min(at, regular.size() - 1)].second];
      const std::array<Plane, 2> pair = planesOf(edge);
      m_Regular[at] = edge;
      if (at >= regular.size())
      {
        m_Regular[at].ends.b = m_Regular[at].ends.a;
      }
      Block &           block = m_Blocks[at / BlockSize];
      const std::size_t lane = at % BlockSize;
      for (unsigned int side = 0; side < 2; ++side)
      {
        planes[2 * i + side] = pair[side];
        for (unsigned int k = 0; k < 3; ++k)
        {
          block.n[side][k][lane] = static_cast<std::int16_t>(std::lround(PlaneUnit * pair[side].n[k]));
        }
        block.d[side][lane] = static_cast<std::int16_t>(std::lround(PlaneUnit * pair[side].d / m_Radius));
      }
    }
    const BoundsType whole = boundsOf(planes.data(), planes.data() + planes.size());
    for (std::size_t k = 0; k < NumberOfBounds; ++k)
    {
      m_ClusterBounds[k][c] = whole[k];
    }
    for (std::size_t block = 0; block < ClusterBlocks; ++block)
    {
      const Plane * const first = planes.data() + 2 * BlockSize * block;
      const BoundsType    bounds = boundsOf(first, first + 2 * BlockSize);
      for (std::size_t k = 0; k < NumberOfBounds; ++k)
      {
        m_BlockBounds[c].values[k][block] = bounds[k];
      }
    }
  }
}

auto
MeshSilhouette::Implementation::MakeGrid(const PerspectiveProjection & projection) const -> Grid
{
  double     low[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::max() };
  double     high[2] = { std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest() };
  double     depthMin = std::numeric_limits<double>::max();
  double     depthMax = 0.0;
  const auto include = [&](const Vector3 & point) {
    double       u = 0.0;
    double       v = 0.0;
    const double depth = projection.Project(point.data(), u, v);
    if (!(depth > 0.0) || !std::isfinite(depth) || !std::isfinite(u) || !std::isfinite(v))
    {
      return false;
    }
    depthMin = std::min(depthMin, depth);
    depthMax = std::max(depthMax, depth);
    low[0] = std::min(low[0], u);
    low[1] = std::min(low[1], v);
    high[0] = std::max(high[0], u);
    high[1] = std::max(high[1], v);
    return true;
  };
  // The projected box contains the projected surface as long as all of it is in front of the source.
  bool inFront = true;
  for (unsigned int corner = 0; corner < 8 && inFront; ++corner)
  {
    inFront = include(
      { (corner & 1u ? m_High : m_Low)[0], (corner & 2u ? m_High : m_Low)[1], (corner & 4u ? m_High : m_Low)[2] });
  }
  Grid grid;
  if (inFront)
  {
    double squares[2];
    for (unsigned int row = 0; row < 2; ++row)
    {
      squares[row] = 0.0;
      for (const double extreme : { low[row], high[row] })
      {
        double square = 0.0;
        for (unsigned int k = 0; k < 3; ++k)
        {
          const double x = projection.matrix[4 * row + k] - extreme * projection.matrix[8 + k];
          square += x * x;
        }
        squares[row] = std::max(squares[row], square);
      }
    }
    grid.magnification = std::sqrt(squares[0] + squares[1]) / depthMin;
  }
  else
  {
    low[0] = low[1] = std::numeric_limits<double>::max();
    high[0] = high[1] = std::numeric_limits<double>::lowest();
    const auto includeOrThrow = [&](std::uint32_t point) {
      if (!include(points[point]))
      {
        std::ostringstream message;
        message << "Point " << point << " (" << points[point][0] << ", " << points[point][1] << ", " << points[point][2]
                << ") of the surface is not in front of the X-ray source. Check the mesh's unit and the pose.";
        throw std::domain_error(message.str());
      }
    };
    for (const std::vector<EdgeRecord> * list : { &m_Boundary, &m_Special })
    {
      for (const EdgeRecord & edge : *list)
      {
        includeOrThrow(edge.a);
        includeOrThrow(edge.b);
      }
    }
    for (const RegularEdge & edge : m_Regular)
    {
      includeOrThrow(edge.ends.a);
      includeOrThrow(edge.ends.b);
    }
    // No bound without the box: every edge is tested exactly.
    grid.magnification = std::numeric_limits<double>::infinity();
  }
  grid.depthMax = depthMax;
  grid.u0 = std::floor(low[0]) - 1.0;
  grid.v0 = std::floor(low[1]) - 1.0;
  const double extent = std::max(high[0] - grid.u0, high[1] - grid.v0) + 2.0;
  int          exponent = 0;
  std::frexp(extent, &exponent); // extent < 2^exponent
  grid.scale = std::ldexp(1.0, std::min(20, GridBits - exponent));
  return grid;
}

auto
MeshSilhouette::Implementation::FindCandidates(const PerspectiveProjection & projection, const Grid & grid) const
  -> std::vector<EdgeRecord>
{
  std::vector<EdgeRecord> candidates(m_Boundary);
  for (std::size_t i = 0; i < m_Special.size(); ++i)
  {
    const std::uint32_t * opposites = m_SpecialOpposites.data();
    if (this->IsCandidate(
          projection, grid, m_Special[i], opposites + m_SpecialStarts[i], opposites + m_SpecialStarts[i + 1]))
    {
      candidates.push_back(m_Special[i]);
    }
  }
  if (m_Blocks.empty())
  {
    return candidates;
  }

  // The source follows from the 3x4 matrix: M s + m = 0.
  const double * const m = projection.matrix.data();
  const Vector3        row0{ m[0], m[1], m[2] };
  const Vector3        row1{ m[4], m[5], m[6] };
  const Vector3        row2{ m[8], m[9], m[10] };
  const Vector3        c0 = CrossProduct(row1, row2);
  const Vector3        c1 = CrossProduct(row2, row0);
  const Vector3        c2 = CrossProduct(row0, row1);
  const double         determinant = DotProduct(row0, c0);
  Vector3              source;
  for (unsigned int k = 0; k < 3; ++k)
  {
    source[k] = -(m[3] * c0[k] + m[7] * c1[k] + m[11] * c2[k]) / determinant - m_Center[k];
  }
  const double distance = Norm(source);
  // Twice a projected triangle's area is det(M) 2 A n.(a - s) / (depths); rounding to the grid changes it by at most
  // 2 sqrt(2) e (sum of two sides) + 8 e^2. A face whose n.(a - s) exceeds what follows from that keeps its sign.
  const double rounding = 0.51 / grid.scale + 1e-9;
  const double factor = grid.depthMax * grid.depthMax * grid.depthMax / std::abs(determinant);
  const auto   perRatio = static_cast<float>(1.0001 * factor * 2.8285 * rounding * grid.magnification);
  const auto   perInverseArea = static_cast<float>(1.0001 * factor * 8.0 * rounding * rounding);
  // Single precision loses some 1e-7 of the distance.
  const auto      slack = static_cast<float>(2e-6 * (distance + m_Radius));
  const PlaneTest test{ static_cast<float>(source[0]),
                        static_cast<float>(source[1]),
                        static_cast<float>(source[2]),
                        static_cast<float>(1.000001 * distance),
                        perRatio,
                        perInverseArea,
                        slack };

  const std::size_t  clusters = m_BlockBounds.size();
  std::vector<float> margins(clusters);
  const float *      clusterBounds[NumberOfBounds];
  for (std::size_t k = 0; k < NumberOfBounds; ++k)
  {
    clusterBounds[k] = m_ClusterBounds[k].data();
  }
  MeasureDecision(test, clusterBounds, clusters, margins.data());
  // Sixteen bits lose half a unit of each of the four numbers.
  const auto                 blockSlack = static_cast<float>(1.0 / PlaneUnit * (distance + m_Radius));
  const auto                 unit = static_cast<float>(PlaneUnit);
  const auto                 radius = static_cast<float>(m_Radius);
  std::vector<std::uint32_t> active;
  active.reserve(clusters / 8 + 16);
  for (std::size_t c = 0; c < clusters; ++c)
  {
    // Not a number counts as undecided.
    if (!(margins[c] > 0.0f))
    {
      active.push_back(static_cast<std::uint32_t>(c));
    }
  }
  for (std::size_t n = 0; n < active.size(); ++n)
  {
    // They lie apart in memory.
    if (n + 6 < active.size())
    {
      const std::size_t ahead = active[n + 6];
      Prefetch(&m_BlockBounds[ahead], sizeof(BlockBounds));
      Prefetch(&m_Blocks[ahead * ClusterBlocks], ClusterBlocks * sizeof(Block));
      Prefetch(&m_Regular[ahead * ClusterSize], ClusterSize * sizeof(RegularEdge));
    }
    const std::size_t c = active[n];
    const auto &      values = m_BlockBounds[c].values;
    const float *     blockBounds[NumberOfBounds];
    for (std::size_t k = 0; k < NumberOfBounds; ++k)
    {
      blockBounds[k] = values[k];
    }
    float blockMargins[ClusterBlocks];
    MeasureDecision(test, blockBounds, ClusterBlocks, blockMargins);
    for (std::size_t k = 0; k < ClusterBlocks; ++k)
    {
      if (blockMargins[k] > 0.0f)
      {
        continue;
      }
      const std::size_t at = c * ClusterBlocks + k;
      const float       bound = unit * (perRatio * values[6][k] + perInverseArea * values[7][k] + slack + blockSlack);
      float             sides[2][BlockSize];
      MeasureSides(m_Blocks[at], test, radius, sides);
      for (std::size_t i = 0; i < BlockSize; ++i)
      {
        const float low = std::min(sides[0][i], sides[1][i]);
        const float high = std::max(sides[0][i], sides[1][i]);
        if (low > bound || high < -bound)
        {
          continue;
        }
        const RegularEdge & edge = m_Regular[at * BlockSize + i];
        if (edge.ends.a != edge.ends.b &&
            ((low < -bound && high > bound) ||
             this->IsCandidate(projection, grid, edge.ends, edge.opposites.begin(), edge.opposites.end())))
        {
          candidates.push_back(edge.ends);
        }
      }
    }
  }
  return candidates;
}

MeshSilhouette::MeshSilhouette(const TriangleSurface & surface)
  : m_Implementation(std::make_unique<const Implementation>(surface))
{}

MeshSilhouette::~MeshSilhouette() = default;
MeshSilhouette::MeshSilhouette(MeshSilhouette &&) noexcept = default;
MeshSilhouette &
MeshSilhouette::operator=(MeshSilhouette &&) noexcept = default;

std::size_t
MeshSilhouette::GetNumberOfEdges() const
{
  return m_Implementation->edges;
}

std::size_t
MeshSilhouette::GetNumberOfBoundaryEdges() const
{
  return m_Implementation->boundaryEdges;
}

std::size_t
MeshSilhouette::GetNumberOfNonManifoldEdges() const
{
  return m_Implementation->nonManifoldEdges;
}

std::size_t
MeshSilhouette::GetNumberOfComponents() const
{
  return m_Implementation->components;
}

auto
MeshSilhouette::ComputeSilhouetteEdges(const PerspectiveProjection & projection) const -> std::vector<EdgeType>
{
  std::vector<EdgeType> result;
  if (m_Implementation->edges == 0)
  {
    return result;
  }
  const auto candidates = m_Implementation->FindCandidates(projection, m_Implementation->MakeGrid(projection));
  result.reserve(candidates.size());
  for (const Implementation::EdgeRecord & edge : candidates)
  {
    result.emplace_back(edge.a, edge.b);
  }
  return result;
}

Silhouette
MeshSilhouette::ComputeOuterBoundary(const PerspectiveProjection & projection) const
{
  Silhouette             result;
  const Implementation & mesh = *m_Implementation;
  if (mesh.edges == 0)
  {
    return result;
  }
  const Implementation::Grid grid = mesh.MakeGrid(projection);
  const auto                 candidates = mesh.FindCandidates(projection, grid);
  std::vector<Segment>       segments;
  segments.reserve(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (i + 12 < candidates.size())
    {
      Prefetch(&mesh.points[candidates[i + 12].a], sizeof(Vector3));
      Prefetch(&mesh.points[candidates[i + 12].b], sizeof(Vector3));
    }
    const Implementation::EdgeRecord & edge = candidates[i];
    const GridPoint                    p = mesh.Snap(projection, grid, edge.a);
    const GridPoint                    q = mesh.Snap(projection, grid, edge.b);
    if (!(p == q))
    {
      segments.push_back({ static_cast<std::int32_t>(p.x),
                           static_cast<std::int32_t>(p.y),
                           static_cast<std::int32_t>(q.x),
                           static_cast<std::int32_t>(q.y),
                           edge.a,
                           edge.b });
    }
  }
  Arrangement arrangement(std::move(segments));
  const auto  stretches = arrangement.WalkOuterBoundaries(mesh.components, [&mesh](std::uint32_t point) {
    return mesh.componentOfPoint.empty() ? 0u : mesh.componentOfPoint[point];
  });

  const double cell = 1.0 / grid.scale;
  for (const std::vector<Stretch> & walked : stretches)
  {
    SilhouetteLoop loop;
    loop.points.reserve(walked.size());
    loop.rimStart.reserve(walked.size());
    loop.rimEnd.reserve(walked.size());
    loop.edges.reserve(walked.size());
    for (const Stretch & stretch : walked)
    {
      const Segment & segment = arrangement.GetSegment(stretch.segment);
      const Vector3 & a = mesh.points[segment.a];
      const Vector3 & b = mesh.points[segment.b];
      const double    depthA = projection.Depth(a.data());
      const double    depthB = projection.Depth(b.data());
      const double    from = stretch.from.Value();
      const double    to = stretch.to.Value();
      const double    x = static_cast<double>(segment.px) + from * static_cast<double>(segment.qx - segment.px);
      const double    y = static_cast<double>(segment.py) + from * static_cast<double>(segment.qy - segment.py);
      loop.points.push_back({ grid.u0 + x * cell, grid.v0 + y * cell });
      loop.rimStart.push_back(PointOnEdge(a, depthA, b, depthB, from));
      loop.rimEnd.push_back(PointOnEdge(a, depthA, b, depthB, to));
      loop.edges.push_back({ segment.a, segment.b });
    }
    result.loops.push_back(std::move(loop));
  }
  if (result.loops.size() > 1)
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t l = 0; l < result.loops.size(); ++l)
    {
      order.emplace_back(-result.loops[l].Area(), l);
    }
    std::sort(order.begin(), order.end());
    std::vector<SilhouetteLoop> sorted;
    sorted.reserve(order.size());
    for (const auto & entry : order)
    {
      sorted.push_back(std::move(result.loops[entry.second]));
    }
    result.loops = std::move(sorted);
  }
  return result;
}

std::vector<SilhouetteSample>
SampleSilhouetteLoopCorners(const SilhouetteLoop & loop)
{
  std::vector<SilhouetteSample> samples(loop.points.size());
  double                        arcLength = 0.0;
  for (std::size_t i = 0; i < loop.points.size(); ++i)
  {
    const auto &       p = loop.points[i];
    const auto &       q = loop.points[i + 1 < loop.points.size() ? i + 1 : 0];
    const double       du = q[0] - p[0];
    const double       dv = q[1] - p[1];
    const double       norm = std::hypot(du, dv);
    SilhouetteSample & sample = samples[i];
    sample.u = p[0];
    sample.v = p[1];
    // Two crossings of one edge may be the same in double precision.
    sample.normal = norm > 0.0 ? std::array<double, 2>{ dv / norm, -du / norm }
                    : i > 0    ? samples[i - 1].normal
                               : std::array<double, 2>{ 0.0, 0.0 };
    sample.rim = loop.rimStart[i];
    sample.arcLength = arcLength;
    sample.segment = static_cast<std::uint32_t>(i);
    arcLength += norm;
  }
  return samples;
}

std::vector<SilhouetteSample>
ResampleSilhouetteLoop(const SilhouetteLoop & loop, const PerspectiveProjection & projection, std::size_t count)
{
  std::vector<SilhouetteSample>      samples;
  const std::vector<ContourPosition> positions = ResamplePolyline(loop.points, true, count);
  const double                       length = ComputePolylineLength(loop.points, true);
  samples.reserve(count);
  for (std::size_t k = 0; k < positions.size(); ++k)
  {
    const std::size_t i = positions[k].segment;
    const double      t = positions[k].share;
    const auto &      p = loop.points[i];
    const auto &      q = loop.points[i + 1 < loop.points.size() ? i + 1 : 0];
    const double      du = q[0] - p[0];
    const double      dv = q[1] - p[1];
    const double      norm = std::hypot(du, dv);
    SilhouetteSample  sample;
    sample.u = p[0] + t * du;
    sample.v = p[1] + t * dv;
    sample.normal = { dv / norm, -du / norm };
    sample.rim = PointOnEdge(loop.rimStart[i],
                             projection.Depth(loop.rimStart[i].data()),
                             loop.rimEnd[i],
                             projection.Depth(loop.rimEnd[i].data()),
                             t);
    sample.arcLength = length * static_cast<double>(k) / static_cast<double>(count);
    sample.segment = static_cast<std::uint32_t>(i);
    samples.push_back(sample);
  }
  return samples;
}

std::vector<SilhouetteSample>
ResampleSilhouetteLoopBySpacing(const SilhouetteLoop & loop, const PerspectiveProjection & projection, double spacing)
{
  if (!(spacing > 0.0))
  {
    throw std::invalid_argument("The spacing of contour points must be positive.");
  }
  const double count = std::floor(ComputePolylineLength(loop.points, true) / spacing + 0.5);
  return ResampleSilhouetteLoop(loop, projection, static_cast<std::size_t>(std::max(1.0, count)));
}
} // namespace itk
