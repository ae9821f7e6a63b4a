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
#include "itkIsoContourTracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace itk
{
namespace
{
/** Where a line from an outer sample to an inner one, a step away, has the level. */
std::array<double, 2>
Cross(const std::array<double, 2> & outer, const std::array<double, 2> & step, double level, double low, double high)
{
  const double share = (level - low) / (high - low);
  return { { outer[0] + share * step[0], outer[1] + share * step[1] } };
}
} // namespace

IsoContourTracer::IsoContourTracer(std::size_t width, double level)
  : m_Width(width)
  , m_Level(level)
  , m_Previous(width + 2, -std::numeric_limits<double>::infinity())
  , m_Current(m_Previous)
{}

void
IsoContourTracer::AddRow(const double * values)
{
  std::copy(values, values + m_Width, m_Current.begin() + 1);
  this->AddPaddedRow();
}

void
IsoContourTracer::AddPaddedRow()
{
  // m_Previous is padded row m_Row, m_Current the one after it. Edges are numbered 2 * (sample) to the right and
  // 2 * (sample) + 1 to the next row.
  const std::uint64_t columns = m_Width + 2;
  const double        v = static_cast<double>(m_Row) - 1.0;
  bool                in[4];
  in[1] = m_Previous[0] > m_Level;
  in[2] = m_Current[0] > m_Level;
  for (std::uint64_t i = 0; i + 1 < columns; ++i)
  {
    // Corners counter-clockwise in (u, v).
    in[0] = in[1];
    in[3] = in[2];
    in[1] = m_Previous[i + 1] > m_Level;
    in[2] = m_Current[i + 1] > m_Level;
    const int inside = static_cast<int>(in[0]) + in[1] + in[2] + in[3];
    if (inside == 0 || inside == 4)
    {
      continue;
    }
    const double        value[4] = { m_Previous[i], m_Previous[i + 1], m_Current[i + 1], m_Current[i] };
    const std::uint64_t sample = m_Row * columns + i;
    const std::uint64_t edge[4] = { 2 * sample, 2 * (sample + 1) + 1, 2 * (sample + columns), 2 * sample + 1 };
    const double        u = static_cast<double>(i) - 1.0;
    // With the object to the left a piece of contour begins where the way around the square leaves the object and ends
    // where it enters it: at the next entry where the object is connected through the square, else at the one before.
    const bool connected = 0.25 * (value[0] + value[1] + value[2] + value[3]) > m_Level;
    for (unsigned int k = 0; k < 4; ++k)
    {
      const unsigned int n = (k + 1) % 4;
      if (!in[k] || in[n])
      {
        continue;
      }
      unsigned int end = k;
      do
      {
        end = (end + (connected ? 1 : 3)) % 4;
      } while (in[end] || !in[(end + 1) % 4]);
      // From the outer corner to the inner one, so that both squares at an edge compute the same bits. A square with a
      // sample of the frame has two corners of the frame side by side, hence no saddle that the padding could decide.
      const double                cornerU[4] = { 0.0, 1.0, 1.0, 0.0 };
      const double                cornerV[4] = { 0.0, 0.0, 1.0, 1.0 };
      const std::array<double, 2> outer{ { u + cornerU[n], v + cornerV[n] } };
      const std::array<double, 2> step{ { cornerU[k] - cornerU[n], cornerV[k] - cornerV[n] } };
      if (std::isinf(value[n]))
      {
        m_FrameCrossings.push_back({ m_Segments.size(), outer, step, value[k] });
      }
      m_Segments.push_back({ edge[k], edge[end], Cross(outer, step, m_Level, value[n], value[k]) });
    }
  }
  ++m_Row;
  m_Previous.swap(m_Current);
}

auto
IsoContourTracer::Finish(double padding) -> std::vector<LoopType>
{
  if (!(padding <= m_Level))
  {
    throw std::invalid_argument("The padding of an iso-contour must not be above its level.");
  }
  std::fill(m_Current.begin(), m_Current.end(), -std::numeric_limits<double>::infinity());
  this->AddPaddedRow();
  for (const FrameCrossing & crossing : m_FrameCrossings)
  {
    m_Segments[crossing.segment].point = Cross(crossing.frame, crossing.step, m_Level, padding, crossing.value);
  }
  m_FrameCrossings.clear();

  std::sort(m_Segments.begin(), m_Segments.end(), [](const Segment & a, const Segment & b) { return a.from < b.from; });
  std::vector<bool>                        used(m_Segments.size(), false);
  std::vector<std::pair<double, LoopType>> outer;
  for (std::size_t first = 0; first < m_Segments.size(); ++first)
  {
    if (used[first])
    {
      continue;
    }
    LoopType    loop;
    std::size_t at = first;
    do
    {
      used[at] = true;
      // Values equal to the level make several crossings of one sample.
      if (loop.empty() || loop.back() != m_Segments[at].point)
      {
        loop.push_back(m_Segments[at].point);
      }
      const std::uint64_t to = m_Segments[at].to;
      at = static_cast<std::size_t>(
        std::lower_bound(m_Segments.begin(),
                         m_Segments.end(),
                         to,
                         [](const Segment & segment, std::uint64_t edge) { return segment.from < edge; }) -
        m_Segments.begin());
    } while (at != first);
    while (loop.size() > 1 && loop.back() == loop.front())
    {
      loop.pop_back();
    }
    const double area = ComputeLoopArea(loop);
    if (loop.size() >= 3 && area > 0.0)
    {
      outer.emplace_back(area, std::move(loop));
    }
  }
  m_Segments.clear();
  std::stable_sort(outer.begin(), outer.end(), [](const auto & a, const auto & b) { return a.first > b.first; });
  std::vector<LoopType> loops;
  for (auto & entry : outer)
  {
    const bool inside = std::any_of(
      loops.begin(), loops.end(), [&entry](const LoopType & larger) { return IsInsideLoop(larger, entry.second[0]); });
    if (!inside)
    {
      loops.push_back(std::move(entry.second));
    }
  }
  return loops;
}

double
ComputeLoopArea(const IsoContourTracer::LoopType & loop)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const auto & p = loop[i];
    const auto & q = loop[i + 1 < loop.size() ? i + 1 : 0];
    twice += (p[0] - loop[0][0]) * (q[1] - loop[0][1]) - (p[1] - loop[0][1]) * (q[0] - loop[0][0]);
  }
  return 0.5 * twice;
}

std::vector<IsoContourTracer::LoopType>
TraceMask(const std::vector<double> & mask, std::size_t width, double sigma)
{
  // Half a level does not reach farther outside of the mask than this.
  const auto          margin = static_cast<std::size_t>(std::ceil(3.0 * sigma));
  const std::size_t   height = width == 0 ? 0 : mask.size() / width;
  const std::size_t   paddedWidth = width + 2 * margin;
  const std::size_t   paddedHeight = height + 2 * margin;
  std::vector<double> kernel(margin + 1);
  double              sum = 0.0;
  for (std::size_t i = 0; i <= margin; ++i)
  {
    const double t = sigma > 0.0 ? static_cast<double>(i) / sigma : 0.0;
    kernel[i] = std::exp(-0.5 * t * t);
    sum += i == 0 ? kernel[i] : 2.0 * kernel[i];
  }
  // Along the rows, then along the columns, each sample spread over its neighbours.
  std::vector<double> along(height * paddedWidth, 0.0);
  for (std::size_t y = 0; y < height; ++y)
  {
    for (std::size_t x = 0; x < width; ++x)
    {
      const double value = mask[y * width + x] / sum;
      for (std::size_t i = 0; value != 0.0 && i <= 2 * margin; ++i)
      {
        along[y * paddedWidth + x + i] += value * kernel[i < margin ? margin - i : i - margin];
      }
    }
  }
  IsoContourTracer    tracer(paddedWidth, 0.5);
  std::vector<double> row(paddedWidth);
  for (std::size_t y = 0; y < paddedHeight; ++y)
  {
    std::fill(row.begin(), row.end(), 0.0);
    for (std::size_t k = y < 2 * margin ? 0 : y - 2 * margin; k < std::min(height, y + 1); ++k)
    {
      const std::size_t i = y - k;
      const double      weight = kernel[i < margin ? margin - i : i - margin] / sum;
      for (std::size_t x = 0; x < paddedWidth; ++x)
      {
        row[x] += weight * along[k * paddedWidth + x];
      }
    }
    tracer.AddRow(row.data());
  }
  auto loops = tracer.Finish(0.0);
  for (auto & loop : loops)
  {
    for (auto & point : loop)
    {
      point[0] -= static_cast<double>(margin);
      point[1] -= static_cast<double>(margin);
    }
  }
  return loops;
}

bool
IsInsideLoop(const IsoContourTracer::LoopType & loop, const std::array<double, 2> & point)
{
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const auto & p = loop[i];
    const auto & q = loop[i + 1 < loop.size() ? i + 1 : 0];
    if ((p[1] > point[1]) != (q[1] > point[1]) && point[0] < p[0] + (point[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0]))
    {
      inside = !inside;
    }
  }
  return inside;
}
} // namespace itk
