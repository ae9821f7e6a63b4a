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
#include "itkToothOutline.h"

#include "itkContourResampling.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** Points to either side whose chord is a point's tangent: 5 px. */
constexpr std::size_t OutlineTangentReach = 2;
/** Points of a closed line that it is a line with. */
constexpr std::size_t FewestClosed = 8;
} // namespace

auto
ToothOutline::Resample(const std::vector<PointType> & drawn, bool closed) -> std::vector<PointType>
{
  const auto             steps = static_cast<std::size_t>(std::lround(ComputePolylineLength(drawn, closed) / Spacing));
  const auto             count = closed ? std::max(FewestClosed, steps) : steps + 1;
  std::vector<PointType> points;
  for (const ContourPosition & place : ResamplePolyline(drawn, closed, count))
  {
    const PointType & a = drawn[place.segment];
    const PointType & b = drawn[(place.segment + 1) % drawn.size()];
    points.push_back({ { a[0] + place.share * (b[0] - a[0]), a[1] + place.share * (b[1] - a[1]) } });
  }
  return points;
}

auto
ToothOutline::ComputeNormal(const std::vector<PointType> & points, std::size_t i, bool closed) -> PointType
{
  const std::size_t n = points.size();
  const PointType & a = points[closed ? (i + n - OutlineTangentReach) % n : i - std::min(i, OutlineTangentReach)];
  const PointType & b = points[closed ? (i + OutlineTangentReach) % n : std::min(n - 1, i + OutlineTangentReach)];
  const double      chord = std::max(1e-9, std::hypot(b[0] - a[0], b[1] - a[1]));
  return { { (b[1] - a[1]) / chord, -(b[0] - a[0]) / chord } };
}

void
ToothOutline::AddPoint(const PointType & point, const PointType & normal, double lingual)
{
  m_Arc.push_back(
    m_Points.empty() ? 0.0 : m_Arc.back() + std::hypot(point[0] - m_Points.back()[0], point[1] - m_Points.back()[1]));
  m_Points.push_back(point);
  m_Normals.push_back(normal);
  m_Lingual.push_back(lingual);
}
} // namespace itk
