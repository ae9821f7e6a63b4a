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
#include "itkContourStrand.h"

#include <algorithm>
#include <cmath>

namespace itk
{
std::vector<ContourStrand>
ContourStrand::FindAll(const ContourArrays & contour)
{
  const std::size_t                       count = contour.GetNumberOfPoints();
  std::vector<std::vector<std::uint32_t>> links(count);
  const auto counts = [&](std::uint32_t i) { return contour.weights.empty() || contour.weights[i] > 0.0; };
  std::vector<std::uint32_t> segments;
  for (std::size_t k = 0; k + 1 < contour.segments.size(); k += 2)
  {
    const std::uint32_t a = contour.segments[k];
    const std::uint32_t b = contour.segments[k + 1];
    if (a != b && counts(a) && counts(b))
    {
      const auto number = static_cast<std::uint32_t>(segments.size() / 2);
      links[a].push_back(number);
      links[b].push_back(number);
      segments.push_back(a);
      segments.push_back(b);
    }
  }
  std::vector<char>          used(segments.size() / 2, 0);
  std::vector<ContourStrand> strands;
  const auto                 walk = [&](std::uint32_t start, std::uint32_t first) {
    ContourStrand strand;
    strand.ids.push_back(start);
    std::uint32_t point = start;
    std::uint32_t segment = first;
    while (true)
    {
      used[segment] = 1;
      point = segments[2 * segment] == point ? segments[2 * segment + 1] : segments[2 * segment];
      if (point == start)
      {
        strand.closed = true;
        break;
      }
      strand.ids.push_back(point);
      if (links[point].size() != 2)
      {
        break;
      }
      segment = links[point][0] == segment ? links[point][1] : links[point][0];
      if (used[segment] != 0)
      {
        break;
      }
    }
    strands.push_back(std::move(strand));
  };
  for (std::uint32_t i = 0; i < count; ++i)
  {
    if (!counts(i))
    {
      continue;
    }
    if (links[i].empty())
    {
      ContourStrand strand;
      strand.ids.push_back(i);
      strands.push_back(strand);
    }
    else if (links[i].size() != 2)
    {
      for (const std::uint32_t segment : links[i])
      {
        if (used[segment] == 0)
        {
          walk(i, segment);
        }
      }
    }
  }
  for (std::uint32_t segment = 0; segment < used.size(); ++segment)
  {
    if (used[segment] == 0)
    {
      walk(segments[2 * segment], segment);
    }
  }
  return strands;
}

std::vector<double>
ContourStrand::GetArcLengths(const ContourArrays & contour) const
{
  std::vector<double> arc(ids.size(), 0.0);
  for (std::size_t i = 1; i < ids.size(); ++i)
  {
    const double * a = &contour.points[2 * ids[i - 1]];
    const double * b = &contour.points[2 * ids[i]];
    arc[i] = arc[i - 1] + std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return arc;
}

std::vector<double>
ContourStrand::GetSegmentDirections(const ContourArrays & contour, double sigma) const
{
  const std::size_t   count = this->GetNumberOfSegments();
  std::vector<double> dx(count);
  std::vector<double> dy(count);
  std::vector<double> middle(count);
  double              length = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double * a = &contour.points[2 * ids[i]];
    const double * b = &contour.points[2 * ids[(i + 1) % ids.size()]];
    dx[i] = b[0] - a[0];
    dy[i] = b[1] - a[1];
    const double size = std::hypot(dx[i], dy[i]);
    middle[i] = length + 0.5 * size;
    length += size;
  }
  std::vector<double> directions(2 * count, 0.0);
  for (std::size_t i = 0; i < count; ++i)
  {
    double sx = dx[i];
    double sy = dy[i];
    // Both ways along the strand, until the weight is negligible.
    for (int way = -1; sigma > 0.0 && way <= 1; way += 2)
    {
      for (std::size_t step = 1; step < count; ++step)
      {
        const auto j = static_cast<std::ptrdiff_t>(i) + way * static_cast<std::ptrdiff_t>(step);
        if (!closed && (j < 0 || j >= static_cast<std::ptrdiff_t>(count)))
        {
          break;
        }
        const auto   n = static_cast<std::ptrdiff_t>(count);
        const auto   k = static_cast<std::size_t>((j % n + n) % n);
        const double turns = j < 0 ? -1.0 : (j >= n ? 1.0 : 0.0);
        const double d = (middle[k] + turns * length - middle[i]) / sigma;
        if (std::abs(d) > 3.0)
        {
          break;
        }
        const double weight = std::exp(-0.5 * d * d);
        sx += weight * dx[k];
        sy += weight * dy[k];
      }
    }
    const double size = std::hypot(sx, sy);
    if (size > 0.0)
    {
      directions[2 * i] = sx / size;
      directions[2 * i + 1] = sy / size;
    }
  }
  return directions;
}
} // namespace itk
