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
#include "itkCrownRegionKernel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace itk
{
namespace
{
using PointType = TriangleSurface::PointType;

constexpr double       Pi = 3.14159265358979323846;
constexpr unsigned int Sectors = 180;
constexpr double       StationSpacing = 0.5;
constexpr double       DepthSpacing = 0.2;
constexpr double       None = -1e9;

double
Clamp(double value, double low, double high)
{
  return std::min(std::max(value, low), high);
}

/** Points that coincide get the first one's number: curvature needs the neighbours also across doubled points. */
std::vector<std::uint32_t>
WeldedIds(const TriangleSurface & surface)
{
  const std::size_t n = surface.points.size();
  std::size_t       size = 16;
  while (size < 2 * n)
  {
    size *= 2;
  }
  constexpr std::uint32_t    empty = 0xffffffffu;
  std::vector<std::uint32_t> table(size, empty);
  std::vector<std::uint32_t> ids(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const PointType & p = surface.points[i];
    std::uint64_t     hash = 0x9e3779b97f4a7c15ull;
    for (const double value : p)
    {
      // Raster of 1e-6 mm for the hash alone; equality below is exact. Adding 0 turns -0 into 0.
      hash =
        (hash ^ static_cast<std::uint64_t>(std::llround(Clamp(value, -1e9, 1e9) * 1e6) + 0)) * 0xbf58476d1ce4e5b9ull;
      hash ^= hash >> 29;
    }
    std::size_t slot = hash & (size - 1);
    while (table[slot] != empty && surface.points[table[slot]] != p)
    {
      slot = (slot + 1) & (size - 1);
    }
    if (table[slot] == empty)
    {
      table[slot] = static_cast<std::uint32_t>(i);
    }
    ids[i] = table[slot];
  }
  return ids;
}

/** Least squares of h on {1, x, y, x^2, y^2}, lengths in units of 20 mm, with weights; quadratic terms are held a
 * little so that few teeth do not bend the surface. */
struct OcclusalSurface
{
  std::array<double, 5> c{};

  static std::array<double, 5>
  Terms(double x, double y)
  {
    const double u = x / 20.0;
    const double v = y / 20.0;
    return { { 1.0, u, v, u * u, v * v } };
  }
  double
  operator()(double x, double y) const
  {
    const auto t = Terms(x, y);
    return c[0] + c[1] * t[1] + c[2] * t[2] + c[3] * t[3] + c[4] * t[4];
  }
};

struct SectorTop
{
  double x;
  double y;
  double h;
};

bool
Solve(std::array<std::array<double, 6>, 5> a, std::array<double, 5> & result)
{
  for (unsigned int i = 0; i < 5; ++i)
  {
    unsigned int pivot = i;
    for (unsigned int r = i + 1; r < 5; ++r)
    {
      if (std::abs(a[r][i]) > std::abs(a[pivot][i]))
      {
        pivot = r;
      }
    }
    if (!(std::abs(a[pivot][i]) > 1e-12))
    {
      return false;
    }
    std::swap(a[i], a[pivot]);
    for (unsigned int r = 0; r < 5; ++r)
    {
      if (r != i)
      {
        const double f = a[r][i] / a[i][i];
        for (unsigned int k = i; k < 6; ++k)
        {
          a[r][k] -= f * a[i][k];
        }
      }
    }
  }
  for (unsigned int i = 0; i < 5; ++i)
  {
    result[i] = a[i][5] / a[i][i];
  }
  return true;
}

bool
FitOcclusalSurface(const std::vector<SectorTop> & tops, OcclusalSurface & fit)
{
  if (tops.size() < 8)
  {
    return false;
  }
  std::vector<double> heights;
  for (const SectorTop & top : tops)
  {
    heights.push_back(top.h);
  }
  const auto at = heights.begin() + static_cast<std::ptrdiff_t>(0.75 * static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), at, heights.end());
  fit.c = { { *at, 0.0, 0.0, 0.0, 0.0 } };
  // Gaps, palate and retromolar tissue hang below: only what is low loses weight. The scale closes in.
  for (unsigned int iteration = 0; iteration < 24; ++iteration)
  {
    const double                         scale = std::max(1.0, 4.0 - 0.25 * iteration);
    std::array<std::array<double, 6>, 5> a{};
    for (const SectorTop & top : tops)
    {
      const double residual = top.h - fit(top.x, top.y);
      const double low = std::max(0.0, -residual - 0.5) / scale;
      const double weight = 1.0 / ((1.0 + low * low) * (1.0 + low * low));
      const auto   t = OcclusalSurface::Terms(top.x, top.y);
      for (unsigned int i = 0; i < 5; ++i)
      {
        for (unsigned int k = 0; k < 5; ++k)
        {
          a[i][k] += weight * t[i] * t[k];
        }
        a[i][5] += weight * t[i] * top.h;
      }
    }
    const double ridge = 0.01 * a[0][0];
    for (unsigned int i = 1; i < 5; ++i)
    {
      a[i][i] += (i < 3 ? 0.2 : 1.0) * ridge;
    }
    if (!Solve(a, fit.c))
    {
      return false;
    }
  }
  return true;
}

/** The middle line of the arch as stations, and where a direction from the centre meets it. */
struct Arch
{
  double                             centre[2]{};
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<double, 2>> tangents;
  std::vector<double>                radii;
  std::vector<double>                angles;
  /** Index of the station at the front. */
  double front{ 0.0 };
  /** Station by angle from -pi, steps of a quarter of a degree. */
  std::vector<double> lookup;

  static constexpr unsigned int LookupSize = 1440;

  /** Station (fractional; none: below 0) and radial distance of the middle line in the point's direction. */
  double
  Station(double x, double y, double & offset) const
  {
    const double dx = x - centre[0];
    const double dy = y - centre[1];
    const double t = Clamp((std::atan2(dy, dx) + Pi) / (2.0 * Pi) * LookupSize, 0.0, LookupSize - 1e-6);
    const auto   i = static_cast<std::size_t>(t);
    if (lookup[i] < 0.0 || lookup[i + 1] < 0.0)
    {
      return -1.0;
    }
    const double s = lookup[i] + (t - static_cast<double>(i)) * (lookup[i + 1] - lookup[i]);
    const auto   k = std::min(static_cast<std::size_t>(s), radii.size() - 2);
    const double f = s - static_cast<double>(k);
    offset = std::sqrt(dx * dx + dy * dy) - (radii[k] + f * (radii[k + 1] - radii[k]));
    return s;
  }

  void
  MakeLookup()
  {
    angles.clear();
    radii.clear();
    tangents.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const double dx = points[k][0] - centre[0];
      const double dy = points[k][1] - centre[1];
      angles.push_back(std::atan2(dy, dx));
      radii.push_back(std::sqrt(dx * dx + dy * dy));
      const auto & a = points[k < 2 ? 0 : k - 2];
      const auto & b = points[std::min(k + 2, points.size() - 1)];
      const double tx = b[0] - a[0];
      const double ty = b[1] - a[1];
      const double l = std::sqrt(tx * tx + ty * ty);
      tangents[k] = { { tx / l, ty / l } };
    }
    lookup.assign(LookupSize + 1, -1.0);
    std::size_t k = 0;
    for (unsigned int i = 0; i <= LookupSize; ++i)
    {
      const double angle = -Pi + 2.0 * Pi * i / LookupSize;
      while (k + 2 < angles.size() && angles[k + 1] < angle)
      {
        ++k;
      }
      if (angle >= angles.front() && angle <= angles.back() && angles[k + 1] > angles[k])
      {
        lookup[i] = static_cast<double>(k) + Clamp((angle - angles[k]) / (angles[k + 1] - angles[k]), 0.0, 1.0);
      }
    }
    front = 0.0;
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    {
      if (angles[i] <= 0.0)
      {
        front = static_cast<double>(i);
      }
    }
  }
};

unsigned int
SectorOf(double x, double y)
{
  return static_cast<unsigned int>(Clamp((std::atan2(y, x) + Pi) / (2.0 * Pi) * Sectors, 0.0, Sectors - 1.0));
}

/** The highest square half millimetre of each sector. */
std::vector<SectorTop>
FindTops(const std::vector<PointType> & q, const std::vector<double> & areas, double cx, double cy)
{
  double highest = None;
  for (std::size_t i = 0; i < q.size(); ++i)
  {
    if (areas[i] > 0.0)
    {
      highest = std::max(highest, q[i][2]);
    }
  }
  constexpr double          bin = 0.1;
  constexpr unsigned int    bins = 300;
  std::vector<double>       histogram(static_cast<std::size_t>(Sectors) * bins, 0.0);
  std::vector<std::int32_t> sector(q.size(), -1);
  for (std::size_t i = 0; i < q.size(); ++i)
  {
    const double below = (highest - q[i][2]) / bin;
    if (areas[i] > 0.0 && below < bins)
    {
      sector[i] = static_cast<std::int32_t>(SectorOf(q[i][0] - cx, q[i][1] - cy));
      histogram[static_cast<std::size_t>(sector[i]) * bins + static_cast<std::size_t>(below)] += areas[i];
    }
  }
  std::vector<double> top(Sectors, None);
  for (unsigned int s = 0; s < Sectors; ++s)
  {
    double sum = 0.0;
    for (unsigned int b = 0; b < bins; ++b)
    {
      sum += histogram[static_cast<std::size_t>(s) * bins + b];
      if (sum >= 0.5)
      {
        top[s] = highest - (b + 0.5) * bin;
        break;
      }
    }
  }
  std::vector<std::array<double, 3>> means(Sectors, { { 0.0, 0.0, 0.0 } });
  for (std::size_t i = 0; i < q.size(); ++i)
  {
    if (sector[i] >= 0 && top[sector[i]] > None && q[i][2] > top[sector[i]] - 0.4)
    {
      auto & mean = means[sector[i]];
      mean[0] += areas[i];
      mean[1] += areas[i] * q[i][0];
      mean[2] += areas[i] * q[i][1];
    }
  }
  std::vector<SectorTop> tops;
  for (unsigned int s = 0; s < Sectors; ++s)
  {
    if (top[s] > None && means[s][0] > 0.0)
    {
      tops.push_back({ means[s][1] / means[s][0], means[s][2] / means[s][0], top[s] });
    }
  }
  return tops;
}

/** Middle line through the crowns' tops (depth below 4 mm), by sectors about the centre. */
bool
FindArch(const std::vector<PointType> & q,
         const std::vector<double> &    areas,
         const std::vector<float> &     depth,
         Arch &                         arch)
{
  std::vector<double> area(Sectors, 0.0);
  std::vector<double> radius(Sectors, 0.0);
  std::vector<double> previous;
  for (unsigned int pass = 0; pass < 2; ++pass)
  {
    std::fill(area.begin(), area.end(), 0.0);
    std::fill(radius.begin(), radius.end(), 0.0);
    for (std::size_t i = 0; i < q.size(); ++i)
    {
      if (depth[i] < 4.0f && areas[i] > 0.0)
      {
        const double       dx = q[i][0] - arch.centre[0];
        const double       dy = q[i][1] - arch.centre[1];
        const unsigned int s = SectorOf(dx, dy);
        const double       r = std::sqrt(dx * dx + dy * dy);
        if (pass == 0 || std::abs(r - previous[s]) < 8.0)
        {
          area[s] += areas[i];
          radius[s] += areas[i] * r;
        }
      }
    }
    // From the front to both sides; 5 mm^2 in 2 degrees are a tooth.
    const int        middle = static_cast<int>(Sectors / 2);
    const int        reach = static_cast<int>(Sectors * 75 / 180);
    std::vector<int> valid;
    for (int s = middle - reach; s <= middle + reach; ++s)
    {
      if (area[s] > 5.0)
      {
        valid.push_back(s);
      }
    }
    if (valid.size() < 20)
    {
      return false;
    }
    std::vector<double> filled(Sectors, 0.0);
    for (std::size_t v = 0; v + 1 < valid.size(); ++v)
    {
      const double a = radius[valid[v]] / area[valid[v]];
      const double b = radius[valid[v + 1]] / area[valid[v + 1]];
      for (int s = valid[v]; s <= valid[v + 1]; ++s)
      {
        const double t = static_cast<double>(s - valid[v]) / (valid[v + 1] - valid[v]);
        filled[s] = a + t * (b - a);
      }
    }
    const int           first = valid.front();
    const int           last = valid.back();
    std::vector<double> smooth(Sectors, 0.0);
    for (unsigned int s = 0; s < Sectors; ++s)
    {
      const int at = std::min(std::max(static_cast<int>(s), first), last);
      double    sum = 0.0;
      double    weights = 0.0;
      for (int d = -9; d <= 9; ++d)
      {
        // A window that shrinks toward the ends, so that the line is not bent there.
        const int room = std::min({ 9, at - first, last - at });
        if (std::abs(d) <= room)
        {
          const double w = std::exp(-0.5 * d * d / 9.0);
          sum += w * filled[at + d];
          weights += w;
        }
      }
      smooth[s] = sum / weights;
    }
    previous = smooth;
    if (pass == 0)
    {
      continue;
    }
    std::vector<std::array<double, 2>> line;
    for (int s = first; s <= last; ++s)
    {
      const double angle = -Pi + 2.0 * Pi * (s + 0.5) / Sectors;
      line.push_back(
        { { arch.centre[0] + smooth[s] * std::cos(angle), arch.centre[1] + smooth[s] * std::sin(angle) } });
    }
    // Straight on behind the last teeth, as far as directions from the centre can tell it.
    const auto extend = [&](const std::array<double, 2> & end, const std::array<double, 2> & inner) {
      const double dx = end[0] - inner[0];
      const double dy = end[1] - inner[1];
      const double l = std::max(1e-6, std::sqrt(dx * dx + dy * dy));
      return std::array<double, 2>{ { end[0] + 8.0 * dx / l, end[1] + 8.0 * dy / l } };
    };
    const std::size_t span = std::min<std::size_t>(8, line.size() - 1);
    const auto        before = extend(line.front(), line[span]);
    const auto        after = extend(line.back(), line[line.size() - 1 - span]);
    line.insert(line.begin(), before);
    line.push_back(after);
    arch.points.clear();
    double next = 0.0;
    double done = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
    {
      const double dx = line[i][0] - line[i - 1][0];
      const double dy = line[i][1] - line[i - 1][1];
      const double l = std::sqrt(dx * dx + dy * dy);
      while (l > 0.0 && next <= done + l)
      {
        const double t = (next - done) / l;
        arch.points.push_back({ { line[i - 1][0] + t * dx, line[i - 1][1] + t * dy } });
        next += StationSpacing;
      }
      done += l;
    }
    if (arch.points.size() < 40)
    {
      return false;
    }
    arch.MakeLookup();
  }
  return true;
}

/** Turning angle of the surface (radians) across valleys that run along the arch, by side, station and depth. */
class ValleyChart
{
public:
  ValleyChart(std::size_t stations, std::size_t depths)
    : m_Stations(stations)
    , m_Depths(depths)
    , m_Values(2 * stations * depths, 0.0)
  {}

  double &
  At(unsigned int side, std::size_t station, std::size_t depth)
  {
    return m_Values[(side * m_Stations + station) * m_Depths + depth];
  }

  void
  Splat(unsigned int side, double station, double depth, double value)
  {
    if (!(station >= 0.0 && depth >= 0.0))
    {
      return;
    }
    const auto k = static_cast<std::size_t>(station);
    const auto j = static_cast<std::size_t>(depth);
    if (k + 1 < m_Stations && j + 1 < m_Depths)
    {
      const double a = station - static_cast<double>(k);
      const double b = depth - static_cast<double>(j);
      At(side, k, j) += (1.0 - a) * (1.0 - b) * value;
      At(side, k + 1, j) += a * (1.0 - b) * value;
      At(side, k, j + 1) += (1.0 - a) * b * value;
      At(side, k + 1, j + 1) += a * b * value;
    }
  }

  /** Mean along the arch (sd 0.6 mm), sum over what is near in depth (sd 0.5 mm). */
  void
  Smooth()
  {
    std::vector<double> line(std::max(m_Stations, m_Depths));
    const auto filter = [&](std::size_t count, std::size_t offset, std::size_t stride, double sigma, bool mean) {
      const int radius = static_cast<int>(std::ceil(3.0 * sigma));
      for (std::size_t i = 0; i < count; ++i)
      {
        double sum = 0.0;
        double weights = 0.0;
        for (int d = -radius; d <= radius; ++d)
        {
          const double w = std::exp(-0.5 * d * d / (sigma * sigma));
          const int    at = static_cast<int>(i) + d;
          weights += w;
          if (at >= 0 && at < static_cast<int>(count))
          {
            sum += w * m_Values[offset + static_cast<std::size_t>(at) * stride];
          }
        }
        line[i] = mean ? sum / weights : sum;
      }
      for (std::size_t i = 0; i < count; ++i)
      {
        m_Values[offset + i * stride] = line[i];
      }
    };
    for (unsigned int side = 0; side < 2; ++side)
    {
      for (std::size_t k = 0; k < m_Stations; ++k)
      {
        filter(m_Depths, (side * m_Stations + k) * m_Depths, 1, 0.5 / DepthSpacing, false);
      }
      for (std::size_t j = 0; j < m_Depths; ++j)
      {
        filter(m_Stations, side * m_Stations * m_Depths + j, m_Depths, 0.6 / StationSpacing, true);
      }
    }
  }

private:
  std::size_t         m_Stations;
  std::size_t         m_Depths;
  std::vector<double> m_Values;
};

/** Edges that two triangles share, found by the lower point's bucket. Calls body(triangle, other, a, b), a -> b in the
 * first triangle's order. Triangles whose flag is 0 are passed over. */
template <typename TBody>
void
ForEachSharedEdge(const std::vector<TriangleSurface::TriangleType> & triangles,
                  const std::vector<std::uint32_t> &                 ids,
                  const std::vector<std::uint8_t> &                  flags,
                  TBody &&                                           body)
{
  struct Half
  {
    std::uint32_t high;
    std::uint32_t triangle;
  };
  std::vector<std::uint32_t> begin(ids.size() + 2, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (flags[t] != 0)
    {
      for (unsigned int k = 0; k < 3; ++k)
      {
        ++begin[std::min(ids[triangles[t][k]], ids[triangles[t][(k + 1) % 3]]) + 2];
      }
    }
  }
  for (std::size_t i = 2; i < begin.size(); ++i)
  {
    begin[i] += begin[i - 1];
  }
  std::vector<Half> halves(begin.back());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (flags[t] == 0)
    {
      continue;
    }
    for (unsigned int k = 0; k < 3; ++k)
    {
      const std::uint32_t a = ids[triangles[t][k]];
      const std::uint32_t b = ids[triangles[t][(k + 1) % 3]];
      const std::uint32_t low = std::min(a, b);
      const std::uint32_t high = std::max(a, b);
      // Entries of this point so far lie in [start, end): start is the previous point's final end.
      std::uint32_t & end = begin[low + 1];
      for (std::uint32_t h = low == 0 ? 0 : begin[low]; h < end; ++h)
      {
        if (halves[h].high == high && halves[h].triangle != t)
        {
          body(static_cast<std::uint32_t>(t), halves[h].triangle, a, b);
          break;
        }
      }
      halves[end++] = { high, static_cast<std::uint32_t>(t) };
    }
  }
}

/** Tissue behind the last molar may stand as high as the teeth. A premolar or molar has a groove between its buccal and
 * lingual cusps, tissue has none: marks as gaps all stations behind the valley that follows the last grooved ones. */
void
CutDistalTissue(const TriangleSurface &           surface,
                const std::vector<std::uint8_t> & band,
                const std::vector<float> &        station,
                const std::vector<float> &        offset,
                const std::vector<float> &        depth,
                const std::vector<double> &       transverse,
                double                            front,
                std::vector<std::uint8_t> &       gap)
{
  // Shallowest depth in cells of two stations by 0.75 mm across the arch; triangles are sampled, scans may be coarse.
  constexpr double      cell = 0.75;
  constexpr std::size_t across = 24;
  constexpr double      empty = 99.0;
  const std::size_t     rows = gap.size() / 2 + 1;
  std::vector<double>   profile(rows * across, empty);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto & c = surface.triangles[t];
    if (band[t] == 0 || std::min({ depth[c[0]], depth[c[1]], depth[c[2]] }) > 5.0f)
    {
      continue;
    }
    constexpr int steps = 4;
    for (int i = 0; i <= steps; ++i)
    {
      for (int j = 0; i + j <= steps; ++j)
      {
        const double a = static_cast<double>(i) / steps;
        const double b = static_cast<double>(j) / steps;
        const double f = 1.0 - a - b;
        const double s = a * station[c[0]] + b * station[c[1]] + f * station[c[2]];
        const double r = a * offset[c[0]] + b * offset[c[1]] + f * offset[c[2]];
        const double d = a * depth[c[0]] + b * depth[c[1]] + f * depth[c[2]];
        const auto   column = static_cast<std::size_t>(Clamp(r / cell + 0.5 * across, 0.0, across - 1.0));
        double &     value = profile[static_cast<std::size_t>(s / 2.0) * across + column];
        value = std::min(value, d);
      }
    }
  }
  // How deep the groove is below the lower of the two crests beside it.
  std::vector<double> groove(rows, 0.0);
  for (std::size_t k = 0; k < rows; ++k)
  {
    const double * line = &profile[k * across];
    double         right[across];
    double         highest = empty;
    for (std::size_t j = across; j-- > 0;)
    {
      right[j] = highest;
      highest = std::min(highest, line[j]);
    }
    double left = empty;
    for (std::size_t j = 0; j < across; ++j)
    {
      const double crest = std::max(left, right[j]);
      if (line[j] < empty && crest < 4.0)
      {
        groove[k] = std::max(groove[k], std::min(line[j] - crest, 1.5));
      }
      left = std::min(left, line[j]);
    }
  }
  constexpr double posterior = 24.0;
  constexpr double deep = 0.25;
  for (const int direction : { -1, 1 })
  {
    int        last = -1;
    const auto inside = [&](int k) { return k >= 0 && k < static_cast<int>(rows); };
    for (int k = static_cast<int>(front / 2.0 + direction * posterior); inside(k); k += direction)
    {
      // Two of three neighbouring millimetres.
      int grooved = 0;
      for (int d = 0; d < 3; ++d)
      {
        const int at = k - direction * d;
        grooved += inside(at) && groove[static_cast<std::size_t>(at)] > deep ? 1 : 0;
      }
      if (grooved >= 2 && groove[static_cast<std::size_t>(k)] > deep)
      {
        last = k;
      }
    }
    if (last < 0)
    {
      continue;
    }
    // The distal ridge is 1 to 4 mm further; the tooth ends where the surface turns up again most (4 rad mm at least).
    double    best = 4.0;
    int       end = -1;
    const int count = static_cast<int>(gap.size());
    for (int d = 1; d <= 8; ++d)
    {
      const int at = 2 * last + direction * d;
      if (at >= 1 && at + 1 < count)
      {
        const double value = transverse[static_cast<std::size_t>(at - 1)] +
                             2.0 * transverse[static_cast<std::size_t>(at)] +
                             transverse[static_cast<std::size_t>(at + 1)];
        if (value > best)
        {
          best = value;
          end = at;
        }
      }
    }
    for (int k = end; end >= 0 && k >= 0 && k < count; k += direction)
    {
      gap[static_cast<std::size_t>(k)] = 1;
    }
  }
}

std::uint32_t
Root(std::vector<std::uint32_t> & parent, std::uint32_t i)
{
  while (parent[i] != i)
  {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

double
Area(const TriangleSurface & surface, std::size_t triangle)
{
  const PointType n = surface.AreaNormal(triangle);
  return std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

void
SumArea(const TriangleSurface & surface, CrownRegionResult & result)
{
  result.area = 0.0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (result.triangles[t] != 0)
    {
      result.area += Area(surface, t);
    }
  }
}
} // namespace

CrownRegionResult
ComputeCrownRegion(const TriangleSurface &                      surface,
                   bool                                         upper,
                   const std::array<std::array<double, 3>, 3> & axes,
                   const std::array<double, 3> &                origin,
                   const CrownRegionOptions &                   options)
{
  CrownRegionResult result;
  const std::size_t n = surface.points.size();
  result.points.assign(n, 0);
  result.triangles.assign(surface.triangles.size(), 0);
  const auto aborted = [&]() { return options.abort && options.abort(); };

  // x anterior, y left, height toward the opposing teeth. This mirrors the upper jaw, which curvature does not mind.
  const double           sign = upper ? -1.0 : 1.0;
  std::vector<PointType> q(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const PointType & p = surface.points[i];
    const double      d[3] = { p[0] - origin[0], p[1] - origin[1], p[2] - origin[2] };
    for (unsigned int r = 0; r < 3; ++r)
    {
      q[i][r] = axes[r][0] * d[0] + axes[r][1] * d[1] + axes[r][2] * d[2];
    }
    q[i][2] *= sign;
  }
  const std::vector<double> areas = surface.VertexAreas();

  // Occlusal surface, first about the frame's origin, then about the middle of the arch.
  Arch               arch;
  OcclusalSurface    occlusal;
  std::vector<float> depth(n, 0.0f);
  for (unsigned int pass = 0; pass < 2; ++pass)
  {
    if (aborted() || !FitOcclusalSurface(FindTops(q, areas, arch.centre[0], arch.centre[1]), occlusal))
    {
      return result;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      depth[i] = static_cast<float>(occlusal(q[i][0], q[i][1]) - q[i][2]);
    }
    if (pass == 0)
    {
      double low[2] = { 1e9, 1e9 };
      double high[2] = { None, None };
      for (const SectorTop & top : FindTops(q, areas, 0.0, 0.0))
      {
        if (occlusal(top.x, top.y) - top.h < 3.0)
        {
          low[0] = std::min(low[0], top.x);
          high[0] = std::max(high[0], top.x);
          low[1] = std::min(low[1], top.y);
          high[1] = std::max(high[1], top.y);
        }
      }
      if (high[0] - low[0] < 10.0 || high[1] - low[1] < 15.0)
      {
        return result;
      }
      arch.centre[0] = low[0] + 0.4 * (high[0] - low[0]);
      arch.centre[1] = 0.5 * (low[1] + high[1]);
    }
  }
  if (aborted() || !FindArch(q, areas, depth, arch))
  {
    return result;
  }

  const std::size_t  stations = arch.points.size();
  const double       deepest = options.maximumCrownHeight + 1.5;
  const std::size_t  depths = static_cast<std::size_t>(deepest / DepthSpacing) + 2;
  std::vector<float> station(n, -1.0f);
  std::vector<float> offset(n, 0.0f);
  for (std::size_t i = 0; i < n; ++i)
  {
    if (depth[i] < deepest)
    {
      double       radial = 0.0;
      const double s = arch.Station(q[i][0], q[i][1], radial);
      if (s >= 0.0 && std::abs(radial) < options.archHalfWidth)
      {
        station[i] = static_cast<float>(s);
        offset[i] = static_cast<float>(radial);
      }
    }
  }

  // Curvature of the band, as turning angles at edges.
  const std::vector<std::uint32_t> ids = WeldedIds(surface);
  std::vector<std::uint8_t>        band(surface.triangles.size(), 0);
  std::vector<PointType>           normals(surface.triangles.size());
  double                           facing = 0.0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto & corner = surface.triangles[t];
    if (station[corner[0]] < 0.0f || station[corner[1]] < 0.0f || station[corner[2]] < 0.0f)
    {
      continue;
    }
    const PointType & a = q[corner[0]];
    const PointType & b = q[corner[1]];
    const PointType & c = q[corner[2]];
    const double      u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const double      v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
    const PointType   m = { { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] } };
    const double      l = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    if (!(l > 1e-12))
    {
      continue;
    }
    band[t] = 1;
    normals[t] = { { m[0] / l, m[1] / l, m[2] / l } };
    if (depth[corner[0]] < 2.5f)
    {
      facing += m[2];
    }
  }
  // Tops face up: this is the winding as it is here.
  const double winding = facing < 0.0 ? -1.0 : 1.0;
  ValleyChart  chart(stations, depths);
  // Turning across valleys that run across the arch, at the height of crowns, a station.
  std::vector<double> transverse(stations + 1, 0.0);
  ForEachSharedEdge(
    surface.triangles, ids, band, [&](std::uint32_t first, std::uint32_t second, std::uint32_t from, std::uint32_t to) {
      const PointType & a = q[from];
      const PointType & b = q[to];
      const PointType & m = normals[first];
      const PointType & k = normals[second];
      const double      e[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
      const double      l = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
      const double      cosine = m[0] * k[0] + m[1] * k[1] + m[2] * k[2];
      const double      sine =
        ((m[1] * k[2] - m[2] * k[1]) * e[0] + (m[2] * k[0] - m[0] * k[2]) * e[1] + (m[0] * k[1] - m[1] * k[0]) * e[2]) /
        l;
      const double s = 0.5 * (station[from] + station[to]);
      const auto & tangent = arch.tangents[std::min(static_cast<std::size_t>(s + 0.5), stations - 1)];
      const double along = (e[0] * tangent[0] + e[1] * tangent[1]) / l;
      // Both curvatures of a dent are a valley; only the part along the arch is wanted.
      const double turning = -winding * std::atan2(sine, cosine) * l;
      const double middle = 0.5 * (static_cast<double>(depth[from]) + depth[to]);
      if (middle > 0.5 && middle < 5.0)
      {
        const double across = (e[0] * tangent[1] - e[1] * tangent[0]) / l;
        transverse[static_cast<std::size_t>(s + 0.5)] += turning * across * across;
      }
      chart.Splat(0.5f * (offset[from] + offset[to]) > 0.0f ? 1 : 0,
                  s,
                  middle / DepthSpacing,
                  turning * along * along / StationSpacing);
    });
  if (aborted())
  {
    return result;
  }
  chart.Smooth();

  // The margin of each side: the path along the arch that gathers most, near the height that is expected, without
  // leaps.
  std::vector<double> margins[2];
  constexpr int       leap = 4;
  const auto          lowest = static_cast<std::size_t>(options.minimumCrownHeight / DepthSpacing);
  const auto          highest = static_cast<std::size_t>(options.maximumCrownHeight / DepthSpacing);
  const auto          guard = static_cast<std::size_t>(1.4 / DepthSpacing);
  for (unsigned int side = 0; side < 2; ++side)
  {
    std::vector<double>      value(stations * depths, -1e18);
    std::vector<std::int8_t> step(stations * depths, 0);
    for (std::size_t k = 0; k < stations; ++k)
    {
      const double away =
        std::min(std::abs(static_cast<double>(k) - arch.front) * StationSpacing / options.posteriorDistance, 1.0);
      const double expected =
        options.anteriorCrownHeight + away * (options.posteriorCrownHeight - options.anteriorCrownHeight);
      double passed = 0.0;
      for (std::size_t j = lowest; j <= highest; ++j)
      {
        // A crown has no second valley: palate and sulcus lie behind the margin.
        if (j >= lowest + guard)
        {
          passed = std::max(passed, Clamp(chart.At(side, k, j - guard), 0.0, 1.2));
        }
        const double off = (static_cast<double>(j) * DepthSpacing - expected) / options.crownHeightScale;
        const double here =
          Clamp(chart.At(side, k, j), -0.5, 1.2) - options.priorWeight * off * off - options.passedWeight * passed;
        double best = k == 0 ? 0.0 : -1e18;
        for (int d = -leap; k > 0 && d <= leap; ++d)
        {
          const int from = static_cast<int>(j) + d;
          if (from < static_cast<int>(lowest) || from > static_cast<int>(highest))
          {
            continue;
          }
          const double candidate =
            value[(k - 1) * depths + static_cast<std::size_t>(from)] - options.smoothness * std::abs(d) * DepthSpacing;
          if (candidate > best)
          {
            best = candidate;
            step[k * depths + j] = static_cast<std::int8_t>(d);
          }
        }
        value[k * depths + j] = best + here;
      }
    }
    margins[side].assign(stations, 0.0);
    std::size_t at = lowest;
    for (std::size_t j = lowest; j <= highest; ++j)
    {
      if (value[(stations - 1) * depths + j] > value[(stations - 1) * depths + at])
      {
        at = j;
      }
    }
    for (std::size_t k = stations; k-- > 0;)
    {
      margins[side][k] = static_cast<double>(at) * DepthSpacing;
      result.meanCrownHeight += 0.5 * margins[side][k] / static_cast<double>(stations);
      result.marginAngle += 0.5 * chart.At(side, k, at) / static_cast<double>(stations);
      at = static_cast<std::size_t>(static_cast<int>(at) + step[k * depths + at]);
    }
  }

  // Stations whose highest half square millimetre is far below the occlusal surface have no tooth.
  std::vector<double> high(stations + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i)
  {
    if (station[i] >= 0.0f && depth[i] < options.gapDepth)
    {
      high[static_cast<std::size_t>(station[i] + 0.5f)] += areas[i];
    }
  }
  std::vector<std::uint8_t> gap(stations + 1, 0);
  for (std::size_t k = 0; k < gap.size(); ++k)
  {
    gap[k] = high[k] + (k > 0 ? high[k - 1] : 0.0) + (k < stations ? high[k + 1] : 0.0) < 0.5 ? 1 : 0;
  }
  // Large triangles of a base reach up to the margin: every corner of a crown's triangle is near a crown.
  std::vector<std::uint8_t> near(n, 0);
  CutDistalTissue(surface, band, station, offset, depth, transverse, arch.front, gap);
  for (std::size_t i = 0; i < n; ++i)
  {
    if (station[i] < 0.0f)
    {
      continue;
    }
    const auto k = std::min(static_cast<std::size_t>(station[i]), stations - 2);
    if (gap[static_cast<std::size_t>(station[i] + 0.5f)] != 0)
    {
      continue;
    }
    const double f = station[i] - static_cast<double>(k);
    const double buccal = Clamp(0.5 + offset[i] / 5.0, 0.0, 1.0);
    double       margin = 0.0;
    for (unsigned int side = 0; side < 2; ++side)
    {
      margin += (side == 1 ? buccal : 1.0 - buccal) * ((1.0 - f) * margins[side][k] + f * margins[side][k + 1]);
    }
    result.points[i] = depth[i] < margin - options.marginInset ? 1 : 0;
    near[i] = depth[i] < margin + 2.0 ? 1 : 0;
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto & corner = surface.triangles[t];
    const bool   close = near[corner[0]] + near[corner[1]] + near[corner[2]] == 3;
    const int    votes = result.points[corner[0]] + result.points[corner[1]] + result.points[corner[2]];
    result.triangles[t] = close && votes > 1 ? 1 : 0;
  }

  // Specks and holes go to what surrounds them.
  std::vector<std::uint32_t> parent(surface.triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  std::vector<std::uint8_t>       bordering(surface.triangles.size(), 0);
  const std::vector<std::uint8_t> all(surface.triangles.size(), 1);
  ForEachSharedEdge(
    surface.triangles, ids, all, [&](std::uint32_t first, std::uint32_t second, std::uint32_t, std::uint32_t) {
      if (result.triangles[first] == result.triangles[second])
      {
        const std::uint32_t a = Root(parent, first);
        const std::uint32_t b = Root(parent, second);
        parent[std::max(a, b)] = std::min(a, b);
      }
      else
      {
        bordering[first] = 1;
        bordering[second] = 1;
      }
    });
  std::vector<double> pieces(surface.triangles.size(), 0.0);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
  {
    const std::uint32_t root = Root(parent, t);
    pieces[root] += Area(surface, t);
    if (bordering[t] != 0)
    {
      bordering[root] = 1;
    }
  }
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
  {
    // A loose speck surrounds nothing and is surrounded by nothing: no crown.
    const std::uint32_t root = Root(parent, t);
    if (pieces[root] < options.minimumPieceArea)
    {
      result.triangles[t] = result.triangles[t] == 0 && bordering[root] != 0 ? 1 : 0;
    }
  }
  std::fill(result.points.begin(), result.points.end(), std::uint8_t{ 0 });
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (result.triangles[t] != 0)
    {
      for (const std::uint32_t id : surface.triangles[t])
      {
        result.points[id] = 1;
      }
    }
  }
  SumArea(surface, result);
  result.valid = result.area > 0.0;
  return result;
}

CrownRegionResult
CrownRegionFromLabels(const TriangleSurface & surface, const std::vector<std::uint8_t> & labels)
{
  if (labels.size() != surface.points.size())
  {
    throw std::invalid_argument("There are " + std::to_string(labels.size()) + " tooth labels for " +
                                std::to_string(surface.points.size()) + " points; give one a point.");
  }
  CrownRegionResult result;
  result.points.resize(labels.size());
  std::transform(labels.begin(), labels.end(), result.points.begin(), [](std::uint8_t label) {
    return static_cast<std::uint8_t>(label != 0 ? 1 : 0);
  });
  result.triangles.resize(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto & corner = surface.triangles[t];
    result.triangles[t] = result.points[corner[0]] + result.points[corner[1]] + result.points[corner[2]] > 1 ? 1 : 0;
  }
  SumArea(surface, result);
  result.valid = result.area > 0.0;
  return result;
}
} // namespace itk
