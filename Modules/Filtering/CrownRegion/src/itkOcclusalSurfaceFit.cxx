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
#include "itkOcclusalSurfaceFit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace itk
{
namespace CrownRegionParts
{
namespace
{
using PointType = TriangleSurface::PointType;

constexpr double HalfTurn = 3.14159265358979323846;
constexpr double None = -1e9;

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
} // namespace

unsigned int
SectorOf(double x, double y)
{
  return static_cast<unsigned int>(
    std::clamp((std::atan2(y, x) + HalfTurn) / (2.0 * HalfTurn) * Sectors, 0.0, Sectors - 1.0));
}

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

namespace
{
/** The plane with most tops in a layer about it and few above it: the teeth, wherever palate, gaps and distal tissue
 * hang, and however many directions they fill. */
std::array<double, 5>
FindOcclusalPlane(const std::vector<SectorTop> & tops)
{
  double lowest = 1e9;
  double highest = -1e9;
  for (const SectorTop & top : tops)
  {
    lowest = std::min(lowest, top.h);
    highest = std::max(highest, top.h);
  }
  constexpr double      bin = 0.25;
  constexpr double      slope = 6.0;
  constexpr double      room = 20.0;
  std::array<double, 5> best{ { highest, 0.0, 0.0, 0.0, 0.0 } };
  double                bestScore = -1e9;
  const auto            bins = static_cast<std::size_t>((highest - lowest + 2.0 * room) / bin) + 16;
  std::vector<int>      count(bins);
  for (double b = -slope; b <= slope; b += 0.5)
  {
    for (double c = -0.5 * slope; c <= 0.5 * slope; c += 0.5)
    {
      std::fill(count.begin(), count.end(), 0);
      for (const SectorTop & top : tops)
      {
        const auto   t = OcclusalSurface::Terms(top.x, top.y);
        const double residual = top.h - b * t[1] - c * t[2] - lowest + room;
        ++count[static_cast<std::size_t>(std::clamp(residual / bin, 0.0, static_cast<double>(bins - 1)))];
      }
      // The layer is 1.5 mm below to 1 mm above the plane; what is higher speaks against it.
      int above = 0;
      for (std::size_t k = bins; k-- > 10;)
      {
        int inside = 0;
        for (std::size_t i = 0; i < 10; ++i)
        {
          inside += count[k - i];
        }
        const double score = inside - 2.0 * above - 0.2 * (b * b + c * c);
        if (score > bestScore)
        {
          bestScore = score;
          best = { { lowest - room + bin * (static_cast<double>(k) - 3.0), b, c, 0.0, 0.0 } };
        }
        above += count[k];
      }
    }
  }
  return best;
}
} // namespace

bool
FitOcclusalSurface(const std::vector<SectorTop> & tops, OcclusalSurface & fit)
{
  if (tops.size() < 8)
  {
    return false;
  }
  fit.c = FindOcclusalPlane(tops);
  // Gaps, palate and retromolar tissue hang below: only what is low loses weight. The scale closes in.
  for (unsigned int iteration = 0; iteration < 24; ++iteration)
  {
    const double                         scale = std::max(1.0, 2.0 - 0.1 * iteration);
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
} // namespace CrownRegionParts
} // namespace itk
