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
#ifndef itkFlatKdTree_h
#define itkFlatKdTree_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace itk
{
/** \class FlatKdTree
 * \brief Nearest neighbours among a few thousand points: a balanced k-d tree in flat arrays. Free of ITK headers.
 *
 * The points are copied in tree order, so that a query runs through contiguous memory. Of several nearest points the
 * first in tree order wins; the order depends on the points alone. A node is left out by the box of its points in two
 * and three dimensions, by the splitting plane alone in more, where a box costs more than it spares.
 *
 * \ingroup UMidlineDentalAxis
 */
template <unsigned int VDimension>
class FlatKdTree
{
public:
  using PointType = std::array<double, VDimension>;
  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max(); /**< No point. */
  /** Builds the tree; points are copied. Their indices are those of the given order. */
  FlatKdTree() = default;
  explicit FlatKdTree(const std::vector<PointType> & points)
  {
    m_Index.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      m_Index[i] = static_cast<std::uint32_t>(i);
    }
    if (!points.empty())
    {
      m_Nodes.reserve(2 * points.size() / LeafSize + 2);
      this->Build(points, 0, static_cast<std::uint32_t>(points.size()));
    }
    m_Points.reserve(points.size());
    for (const std::uint32_t index : m_Index)
    {
      m_Points.push_back(points[index]);
    }
    m_Position.resize(points.size());
    for (std::uint32_t k = 0; k < m_Index.size(); ++k)
    {
      m_Position[m_Index[k]] = k;
    }
  }
  /** Number of points. */
  std::size_t
  Size() const
  {
    return m_Points.size();
  }

  /** Nearest point nearer than the square root of the given bound; None where there is none. The bound becomes the
   * squared distance. A guess, for instance the answer for a query near by, makes the search quicker and does not
   * change the distance. */
  std::uint32_t
  Nearest(const PointType & query, double & squaredBound, std::uint32_t guess = None) const
  {
    std::uint32_t best = None;
    if (guess != None)
    {
      const std::uint32_t k = m_Position[guess];
      const double        d = SquaredDistance(query, m_Points[k]);
      if (d < squaredBound)
      {
        squaredBound = d;
        best = k;
      }
    }
    if (!m_Nodes.empty())
    {
      this->Search(0, query, squaredBound, best);
    }
    return best == None ? None : m_Index[best];
  }

  /** Calls visit(index, squaredDistance) for every point nearer than the radius, in tree order. */
  template <typename TVisitor>
  void
  Within(const PointType & query, double radius, TVisitor && visit) const
  {
    if (m_Nodes.empty())
    {
      return;
    }
    const double bound = radius * radius;
    // Halving 2^32 points gives a depth of 32; both children of a node may wait.
    std::array<std::uint32_t, 72> stack;
    std::size_t                   depth = 0;
    stack[depth++] = 0;
    while (depth > 0)
    {
      const Node & node = m_Nodes[stack[--depth]];
      if (node.right == 0)
      {
        for (std::uint32_t k = node.begin; k < node.end; ++k)
        {
          const double d = SquaredDistance(query, m_Points[k]);
          if (d < bound)
          {
            visit(m_Index[k], d);
          }
        }
        continue;
      }
      if (query[node.axis] + radius >= node.split)
      {
        stack[depth++] = node.right;
      }
      if (query[node.axis] - radius <= node.split)
      {
        stack[depth++] = node.left;
      }
    }
  }

private:
  static constexpr std::uint32_t LeafSize = 10;
  static constexpr unsigned int  FirstFew = VDimension < 3 ? VDimension : 3;

  struct Node
  {
    PointType     low;
    PointType     high;
    double        split{ 0.0 };
    std::uint32_t begin{ 0 };
    std::uint32_t end{ 0 };
    std::uint32_t left{ 0 };
    /** 0: a leaf (the root is nobody's child). */
    std::uint32_t right{ 0 };
    unsigned int  axis{ 0 };
  };

  static double
  SquaredDistance(const PointType & a, const PointType & b)
  {
    double sum = 0.0;
    for (unsigned int d = 0; d < VDimension; ++d)
    {
      sum += (a[d] - b[d]) * (a[d] - b[d]);
    }
    return sum;
  }

  /** No more than SquaredDistance() of any point in the box, to the last bit: rounding is monotonic, and the operations
   * are the same in the same order. */
  static double
  SquaredDistanceToBox(const PointType & query, const PointType & low, const PointType & high)
  {
    double sum = 0.0;
    for (unsigned int d = 0; d < VDimension; ++d)
    {
      const double outside = std::max(std::max(low[d] - query[d], query[d] - high[d]), 0.0);
      sum += outside * outside;
    }
    return sum;
  }

  static bool
  MayHave(const Node & node, const PointType & query, double bound)
  {
    return VDimension > 3 || SquaredDistanceToBox(query, node.low, node.high) < bound;
  }

  std::uint32_t
  Build(const std::vector<PointType> & points, std::uint32_t begin, std::uint32_t end)
  {
    const auto position = static_cast<std::uint32_t>(m_Nodes.size());
    m_Nodes.emplace_back();
    Node node;
    node.begin = begin;
    node.end = end;
    PointType & low = node.low;
    PointType & high = node.high;
    low = points[m_Index[begin]];
    high = low;
    for (std::uint32_t k = begin; k < end; ++k)
    {
      for (unsigned int d = 0; d < VDimension; ++d)
      {
        low[d] = std::min(low[d], points[m_Index[k]][d]);
        high[d] = std::max(high[d], points[m_Index[k]][d]);
      }
    }
    if (end - begin > LeafSize)
    {
      for (unsigned int d = 1; d < VDimension; ++d)
      {
        if (high[d] - low[d] > high[node.axis] - low[node.axis])
        {
          node.axis = d;
        }
      }
      const unsigned int  axis = node.axis;
      const std::uint32_t middle = begin + (end - begin) / 2;
      // By index among equals: the order is then the points' alone, not the library's.
      std::nth_element(m_Index.begin() + begin,
                       m_Index.begin() + middle,
                       m_Index.begin() + end,
                       [&points, axis](std::uint32_t a, std::uint32_t b) {
                         return points[a][axis] < points[b][axis] || (points[a][axis] == points[b][axis] && a < b);
                       });
      node.split = points[m_Index[middle]][axis];
      node.left = this->Build(points, begin, middle);
      node.right = this->Build(points, middle, end);
    }
    m_Nodes[position] = node;
    return position;
  }

  void
  Search(std::uint32_t position, const PointType & query, double & bound, std::uint32_t & best) const
  {
    const Node & node = m_Nodes[position];
    if (node.right == 0)
    {
      for (std::uint32_t k = node.begin; k < node.end; ++k)
      {
        // Most are too far away by their first coordinates.
        double sum = 0.0;
        for (unsigned int d = 0; d < FirstFew; ++d)
        {
          sum += (query[d] - m_Points[k][d]) * (query[d] - m_Points[k][d]);
        }
        if (sum < bound)
        {
          for (unsigned int d = FirstFew; d < VDimension; ++d)
          {
            sum += (query[d] - m_Points[k][d]) * (query[d] - m_Points[k][d]);
          }
          if (sum < bound)
          {
            bound = sum;
            best = k;
          }
        }
      }
      return;
    }
    const double        difference = query[node.axis] - node.split;
    const std::uint32_t nearer = difference < 0.0 ? node.left : node.right;
    const std::uint32_t farther = difference < 0.0 ? node.right : node.left;
    this->Search(nearer, query, bound, best);
    if (difference * difference < bound && this->MayHave(m_Nodes[farther], query, bound))
    {
      this->Search(farther, query, bound, best);
    }
  }

  std::vector<PointType>     m_Points;
  std::vector<std::uint32_t> m_Index;
  std::vector<std::uint32_t> m_Position;
  std::vector<Node>          m_Nodes;
};
} // namespace itk

#endif
