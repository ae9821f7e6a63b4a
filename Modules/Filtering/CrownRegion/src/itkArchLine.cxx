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
#include "itkArchLine.h"

#include "itkOcclusalSurfaceFit.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace CrownRegionParts
{
namespace
{
using PointType = TriangleSurface::PointType;

constexpr double Pi = 3.14159265358979323846;
} // namespace

double
Arch::Station(double x, double y, double & offset) const
{
  const double dx = x - centre[0];
  const double dy = y - centre[1];
  const double t = std::clamp((std::atan2(dy, dx) + Pi) / (2.0 * Pi) * LookupSize, 0.0, LookupSize - 1e-6);
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
Arch::MakeLookup()
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
      lookup[i] = static_cast<double>(k) + std::clamp((angle - angles[k]) / (angles[k + 1] - angles[k]), 0.0, 1.0);
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
} // namespace CrownRegionParts
} // namespace itk
