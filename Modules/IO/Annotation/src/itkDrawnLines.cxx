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
#include "itkDrawnLines.h"

#include "itkBinaryThinningImageFilter.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

namespace itk
{
namespace
{
/** Pixels to a border beyond which something is filled, not drawn: the widest pen is four pixels. */
constexpr unsigned int PenRadius = 2;
/** A path with a free end that is shorter is what thinning leaves of a line's width. */
constexpr std::size_t ShortestStump = 4;

using Neighbour = std::array<int, 2>;
/** Those beside a pixel before those across its corners. */
constexpr std::array<Neighbour, 8> Neighbours{ { { { 1, 0 } },
                                                 { { 0, 1 } },
                                                 { { -1, 0 } },
                                                 { { 0, -1 } },
                                                 { { 1, 1 } },
                                                 { { -1, 1 } },
                                                 { { -1, -1 } },
                                                 { { 1, -1 } } } };

/** The pixels of thinned lines as a graph: two are joined where they touch and no third one joins them on a way that
 * turns a corner. */
class PixelGraph
{
public:
  explicit PixelGraph(const DrawnLines::ImageType * image)
    : m_Width(static_cast<int>(image->GetLargestPossibleRegion().GetSize(0)))
    , m_Height(static_cast<int>(image->GetLargestPossibleRegion().GetSize(1)))
    , m_Pixels(image->GetBufferPointer(),
               image->GetBufferPointer() + image->GetLargestPossibleRegion().GetNumberOfPixels())
  {}

  bool
  Has(int x, int y) const
  {
    return x >= 0 && y >= 0 && x < m_Width && y < m_Height && m_Pixels[this->ToIndex(x, y)] != 0;
  }

  std::vector<std::size_t>
  GetJoined(std::size_t pixel) const
  {
    const int                x = static_cast<int>(pixel % static_cast<std::size_t>(m_Width));
    const int                y = static_cast<int>(pixel / static_cast<std::size_t>(m_Width));
    std::vector<std::size_t> joined;
    for (const Neighbour & step : Neighbours)
    {
      const bool across = step[0] != 0 && step[1] != 0;
      if (this->Has(x + step[0], y + step[1]) && !(across && (this->Has(x + step[0], y) || this->Has(x, y + step[1]))))
      {
        joined.push_back(this->ToIndex(x + step[0], y + step[1]));
      }
    }
    return joined;
  }

  DentalContour::PointType
  GetPoint(std::size_t pixel) const
  {
    DentalContour::PointType point;
    point[0] = static_cast<double>(pixel % static_cast<std::size_t>(m_Width));
    point[1] = static_cast<double>(pixel / static_cast<std::size_t>(m_Width));
    return point;
  }

  std::size_t
  GetNumberOfPixels() const
  {
    return m_Pixels.size();
  }
  bool
  Has(std::size_t pixel) const
  {
    return m_Pixels[pixel] != 0;
  }

private:
  std::size_t
  ToIndex(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_Width) + static_cast<std::size_t>(x);
  }

  int                       m_Width;
  int                       m_Height;
  std::vector<std::uint8_t> m_Pixels;
};
} // namespace

bool
DrawnLines::AreDrawn(const ImageType * image)
{
  const auto                size = image->GetLargestPossibleRegion().GetSize();
  std::vector<std::uint8_t> pixels(image->GetBufferPointer(), image->GetBufferPointer() + size[0] * size[1]);
  const auto                at = [&](const std::vector<std::uint8_t> & from, std::size_t x, std::size_t y) {
    return x < size[0] && y < size[1] && from[y * size[0] + x] != 0;
  };
  for (unsigned int round = 0; round < PenRadius; ++round)
  {
    const std::vector<std::uint8_t> before = pixels;
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        // Beyond the border is nothing: x - 1 of the first column wraps round to a column that is not there.
        const bool inside =
          at(before, x - 1, y) && at(before, x + 1, y) && at(before, x, y - 1) && at(before, x, y + 1);
        pixels[y * size[0] + x] = inside ? before[y * size[0] + x] : 0;
      }
    }
  }
  return std::all_of(pixels.begin(), pixels.end(), [](std::uint8_t pixel) { return pixel == 0; });
}

DentalContour::PolylinesType
DrawnLines::Trace(const ImageType * image)
{
  auto thinning = BinaryThinningImageFilter<ImageType, ImageType>::New();
  thinning->SetInput(image);
  thinning->Update();
  const PixelGraph graph(thinning->GetOutput());

  DentalContour::PolylinesType                  lines;
  std::set<std::pair<std::size_t, std::size_t>> walked;
  const auto                                    walk = [&](std::size_t from, std::size_t to) {
    DentalContour::PolylineType line;
    line.points = { graph.GetPoint(from), graph.GetPoint(to) };
    walked.insert({ from, to });
    walked.insert({ to, from });
    const std::size_t start = from;
    bool              free = graph.GetJoined(from).size() == 1;
    for (;;)
    {
      const std::vector<std::size_t> joined = graph.GetJoined(to);
      if (joined.size() != 2 || to == start)
      {
        free = free || joined.size() == 1;
        break;
      }
      const std::size_t next = joined[0] == from ? joined[1] : joined[0];
      from = to;
      to = next;
      walked.insert({ from, to });
      walked.insert({ to, from });
      line.points.push_back(graph.GetPoint(to));
    }
    line.closed = to == start && line.points.size() > 3;
    if (line.closed)
    {
      line.points.pop_back();
    }
    // A short line by itself was drawn; a short one at a junction is a stump.
    const bool alone = graph.GetJoined(start).size() <= 1 && graph.GetJoined(to).size() <= 1;
    if (line.closed || alone || !free || line.points.size() >= ShortestStump)
    {
      lines.push_back(std::move(line));
    }
  };
  // From ends and junctions first; what is left then are rings.
  for (const bool rings : { false, true })
  {
    for (std::size_t pixel = 0; pixel < graph.GetNumberOfPixels(); ++pixel)
    {
      if (!graph.Has(pixel))
      {
        continue;
      }
      const std::vector<std::size_t> joined = graph.GetJoined(pixel);
      if (joined.empty() && !rings)
      {
        DentalContour::PolylineType point;
        point.points = { graph.GetPoint(pixel) };
        lines.push_back(point);
      }
      for (const std::size_t next : joined)
      {
        if ((rings || joined.size() != 2) && walked.count({ pixel, next }) == 0)
        {
          walk(pixel, next);
        }
      }
    }
  }
  return lines;
}
} // namespace itk
