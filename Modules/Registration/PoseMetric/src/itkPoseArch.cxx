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
#include "itkPoseArch.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** Sectors of the circle about the arch's middle: 7.5 degrees, at a radius of 25 to 35 mm half a tooth, so that a
 * sector holds a crown and not a contact alone. */
constexpr int Sectors = 48;
/** Points of a surface, and of a sector, below which there is no height to find among them. */
constexpr std::size_t MinimumPoints = 100;
constexpr std::size_t MinimumPointsOfSector = 10;
/** The middle lies this share of the depth from the back: inside the horseshoe, whose ends are at 0 and whose front is
 * at 1. */
constexpr double MiddleFromBack = 0.35;
/** Percentile of a sector's heights that is its top: the highest point may be a spike of the scan. */
constexpr std::size_t TopPercentile = 99;
/** The mark of a sector without a top, higher than any, mm. */
constexpr double NoTop = 1e30;
/** Sectors with a top, and points of the curve, below which it is no arch: that is a third, and a sixth, of the 24 that
 * face forward. */
constexpr std::size_t MinimumSectors = 8;
constexpr std::size_t MinimumCurvePoints = 4;
/** mm below the upper quartile of the tops that a crown's top may lie, by wear or by the curve of the occlusal plane:
 * about the height of a crown. What is lower is palate, tongue side or base. */
constexpr double LowestCrown = 8.0;
/** mm below its top that are averaged for a sector's place: the upper half of a crown. */
constexpr double CrownPart = 4.0;

/** Textbook mesio-distal widths, mm, of the first seven teeth of a quadrant. */
constexpr double UpperWidths[7] = { 8.5, 6.6, 7.6, 7.0, 6.7, 10.3, 9.7 };
constexpr double LowerWidths[7] = { 5.3, 5.9, 6.9, 7.0, 7.1, 11.2, 10.6 };
} // namespace

PoseArch::PoseArch(const TriangleSurface & surface, ToothCode::JawEnum jaw)
{
  const std::size_t n = surface.points.size();
  if (n < MinimumPoints)
  {
    return;
  }
  const double occlusal = jaw == ToothCode::JawEnum::Upper ? -1.0 : 1.0;
  // About the middle of the ground plan, which lies inside the horseshoe whatever the density of the points.
  double low[2] = { surface.points[0][0], surface.points[0][1] };
  double high[2] = { low[0], low[1] };
  for (const auto & p : surface.points)
  {
    for (int k = 0; k < 2; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  const double                     cx = low[0] + MiddleFromBack * (high[0] - low[0]);
  const double                     cy = 0.0;
  std::vector<std::vector<double>> heights(Sectors);
  std::vector<int>                 sector(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto & p = surface.points[i];
    // 0 points backward: the cut of the circle lies in the open end.
    const double angle = std::atan2(p[1] - cy, p[0] - cx) / (2.0 * M_PI) + 0.5;
    sector[i] = std::min(Sectors - 1, std::max(0, static_cast<int>(angle * Sectors)));
    heights[sector[i]].push_back(occlusal * p[2]);
  }
  std::array<double, Sectors> top{};
  for (int k = 0; k < Sectors; ++k)
  {
    auto & h = heights[k];
    if (h.size() < MinimumPointsOfSector)
    {
      top[k] = NoTop;
      continue;
    }
    const std::size_t q = (h.size() - 1) * TopPercentile / 100;
    std::nth_element(h.begin(), h.begin() + q, h.end());
    top[k] = h[q];
  }
  // The highest sectors are crowns; one far below them is palate, tongue side or base.
  std::vector<double> tops;
  for (double t : top)
  {
    if (t < NoTop)
    {
      tops.push_back(t);
    }
  }
  if (tops.size() < MinimumSectors)
  {
    return;
  }
  std::nth_element(tops.begin(), tops.begin() + tops.size() * 3 / 4, tops.end());
  const double                               level = tops[tops.size() * 3 / 4] - LowestCrown;
  std::array<std::array<double, 2>, Sectors> sum{};
  std::array<double, Sectors>                count{};
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto & p = surface.points[i];
    const double t = top[sector[i]];
    if (t < NoTop && t > level && occlusal * p[2] > t - CrownPart)
    {
      sum[sector[i]][0] += p[0];
      sum[sector[i]][1] += p[1];
      count[sector[i]] += 1.0;
    }
  }
  for (int k = 0; k < Sectors; ++k)
  {
    if (count[k] >= static_cast<double>(MinimumPointsOfSector))
    {
      m_Curve.push_back({ { sum[k][0] / count[k], sum[k][1] / count[k] } });
    }
  }
  // Two passes of smoothing take out which teeth happen to fill a sector.
  for (int pass = 0; pass < 2; ++pass)
  {
    const auto copy = m_Curve;
    for (std::size_t i = 1; i + 1 < copy.size(); ++i)
    {
      for (int k = 0; k < 2; ++k)
      {
        m_Curve[i][k] = 0.25 * copy[i - 1][k] + 0.5 * copy[i][k] + 0.25 * copy[i + 1][k];
      }
    }
  }
  if (m_Curve.size() < MinimumCurvePoints)
  {
    m_Curve.clear();
    return;
  }
  m_Arc.assign(m_Curve.size(), 0.0);
  for (std::size_t i = 1; i < m_Curve.size(); ++i)
  {
    m_Arc[i] = m_Arc[i - 1] + std::hypot(m_Curve[i][0] - m_Curve[i - 1][0], m_Curve[i][1] - m_Curve[i - 1][1]);
  }
  // Zero at the midline: the crossing of y = 0 that is farthest forward.
  double zero = 0.5 * m_Arc.back();
  double front = -1e30;
  for (std::size_t i = 1; i < m_Curve.size(); ++i)
  {
    const double a = m_Curve[i - 1][1];
    const double b = m_Curve[i][1];
    if ((a <= 0.0) != (b <= 0.0) && m_Curve[i][0] > front)
    {
      front = m_Curve[i][0];
      zero = m_Arc[i - 1] + (m_Arc[i] - m_Arc[i - 1]) * (a / (a - b));
    }
  }
  for (double & arc : m_Arc)
  {
    arc -= zero;
  }
}

double
PoseArch::Arc(double x, double y) const
{
  return this->Locate(x, y)[0];
}

double
PoseArch::Offset(double x, double y) const
{
  return this->Locate(x, y)[1];
}

std::array<double, 2>
PoseArch::Locate(double x, double y) const
{
  double best = 1e300;
  double arc = 0.0;
  double offset = 0.0;
  for (std::size_t i = 1; i < m_Curve.size(); ++i)
  {
    const double ax = m_Curve[i - 1][0], ay = m_Curve[i - 1][1];
    const double bx = m_Curve[i][0] - ax, by = m_Curve[i][1] - ay;
    const double length2 = bx * bx + by * by;
    double       t = length2 > 0.0 ? ((x - ax) * bx + (y - ay) * by) / length2 : 0.0;
    // The ends run on straight, so that a point behind the last sector is not pulled back.
    t = i == 1 ? std::min(t, 1.0) : i + 1 == m_Curve.size() ? std::max(t, 0.0) : std::min(1.0, std::max(0.0, t));
    const double d = std::hypot(x - ax - t * bx, y - ay - t * by);
    if (d < best)
    {
      best = d;
      arc = m_Arc[i - 1] + t * (m_Arc[i] - m_Arc[i - 1]);
      // The curve goes from the right over the front to the left: outside is to its right.
      offset = std::copysign(d, by * (x - ax) - bx * (y - ay));
    }
  }
  return { { arc, offset } };
}

double
PoseArch::Width() const
{
  double low = 0.0, high = 0.0;
  for (const auto & p : m_Curve)
  {
    low = std::min(low, p[1]);
    high = std::max(high, p[1]);
  }
  return high - low;
}

double
PoseArch::ExpectedArc(std::uint8_t tooth)
{
  const int position = tooth % 10;
  const int quadrant = tooth / 10;
  if (quadrant < 1 || quadrant > 4 || position < 1 || position > 7)
  {
    return 0.0;
  }
  const double * widths = quadrant <= 2 ? UpperWidths : LowerWidths;
  double         arc = 0.0;
  for (int k = 0; k + 1 < position; ++k)
  {
    arc += widths[k];
  }
  return arc + 0.5 * widths[position - 1];
}

double
PoseArch::ExpectedWidth(std::uint8_t tooth)
{
  const int position = tooth % 10;
  const int quadrant = tooth / 10;
  if (quadrant < 1 || quadrant > 4 || position < 1 || position > 7)
  {
    return 0.0;
  }
  return (quadrant <= 2 ? UpperWidths : LowerWidths)[position - 1];
}

std::uint8_t
PoseArch::ExpectedPosition(double arc, ToothCode::JawEnum jaw)
{
  const double * widths = jaw == ToothCode::JawEnum::Upper ? UpperWidths : LowerWidths;
  double         end = 0.0;
  for (std::uint8_t position = 1; position <= 7; ++position)
  {
    end += widths[position - 1];
    if (std::abs(arc) < end)
    {
      return position;
    }
  }
  return 8;
}
} // namespace itk
