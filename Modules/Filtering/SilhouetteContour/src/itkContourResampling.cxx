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
#include "itkContourResampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
/** Length up to the end of each segment. */
std::vector<double>
SegmentEnds(const std::vector<std::array<double, 2>> & points, bool closed)
{
  std::vector<double> ends;
  const std::size_t   segments = points.empty() ? 0 : points.size() - (closed ? 0 : 1);
  double              length = 0.0;
  for (std::size_t i = 0; i < segments; ++i)
  {
    const auto & p = points[i];
    const auto & q = points[i + 1 < points.size() ? i + 1 : 0];
    length += std::hypot(q[0] - p[0], q[1] - p[1]);
    ends.push_back(length);
  }
  return ends;
}
} // namespace

double
ComputePolylineLength(const std::vector<std::array<double, 2>> & points, bool closed)
{
  const std::vector<double> ends = SegmentEnds(points, closed);
  return ends.empty() ? 0.0 : ends.back();
}

std::vector<ContourPosition>
ResamplePolyline(const std::vector<std::array<double, 2>> & points, bool closed, std::size_t count)
{
  std::vector<ContourPosition> positions;
  const std::vector<double>    ends = SegmentEnds(points, closed);
  if (ends.empty() || !(ends.back() > 0.0))
  {
    return positions;
  }
  const double length = ends.back();
  std::size_t  i = 0;
  for (std::size_t k = 0; k < count; ++k)
  {
    double at = 0.5 * length;
    if (closed)
    {
      at = length * static_cast<double>(k) / static_cast<double>(count);
    }
    else if (count > 1)
    {
      at = k + 1 == count ? length : length * static_cast<double>(k) / static_cast<double>(count - 1);
    }
    // A corner belongs to the segment that begins there.
    while (i + 1 < ends.size() && ends[i] <= at)
    {
      ++i;
    }
    const double begin = i == 0 ? 0.0 : ends[i - 1];
    const double size = ends[i] - begin;
    positions.push_back({ i, size > 0.0 ? std::min(1.0, std::max(0.0, (at - begin) / size)) : 1.0 });
  }
  return positions;
}

std::vector<std::size_t>
DistributeContourPoints(const std::vector<double> & lengths, const std::vector<std::size_t> & minima, std::size_t total)
{
  std::vector<std::size_t> counts(minima);
  const std::size_t        least = std::accumulate(minima.begin(), minima.end(), std::size_t{ 0 });
  if (total < least)
  {
    std::ostringstream message;
    message << total << " points are too few for " << lengths.size() << " contours, which need " << least << ".";
    throw std::invalid_argument(message.str());
  }
  const double length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  if (!(length > 0.0))
  {
    return counts;
  }
  // What a contour has above its minimum goes to the others: fix those whose share is below the minimum first.
  std::vector<bool> fixed(lengths.size(), false);
  double            freeLength = length;
  std::size_t       freePoints = total;
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::size_t i = 0; i < lengths.size(); ++i)
    {
      if (!fixed[i] && lengths[i] * static_cast<double>(freePoints) <= static_cast<double>(minima[i]) * freeLength)
      {
        fixed[i] = true;
        freeLength -= lengths[i];
        freePoints -= minima[i];
        changed = true;
      }
    }
  }
  std::vector<std::pair<double, std::size_t>> remainders;
  std::size_t                                 left = freePoints;
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    if (!fixed[i])
    {
      const double share = lengths[i] * static_cast<double>(freePoints) / freeLength;
      counts[i] = std::max(minima[i], static_cast<std::size_t>(share));
      remainders.emplace_back(static_cast<double>(counts[i]) - share, i);
      left -= std::min(left, counts[i]);
    }
  }
  std::sort(remainders.begin(), remainders.end());
  for (std::size_t k = 0; left > 0 && !remainders.empty(); --left, k = (k + 1) % remainders.size())
  {
    ++counts[remainders[k].second];
  }
  return counts;
}
} // namespace itk
