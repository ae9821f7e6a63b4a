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
#include "itkMinimumCut.h"

#include <algorithm>

namespace itk
{
namespace CrownRegionParts
{
MinimumCut::MinimumCut(std::size_t nodes)
  : m_First(nodes, 0)
  , m_Second(nodes, 0)
{}

void
MinimumCut::AddTies(std::uint32_t node, std::int64_t toFirst, std::int64_t toSecond)
{
  m_First[node] += toFirst;
  m_Second[node] += toSecond;
}

void
MinimumCut::AddEdge(std::uint32_t a, std::uint32_t b, std::int64_t capacity)
{
  m_Edges.push_back({ a, b, capacity });
}

void
MinimumCut::MakeArcs()
{
  m_Begin.assign(m_First.size() + 1, 0);
  for (const Edge & edge : m_Edges)
  {
    ++m_Begin[edge.a + 1];
    ++m_Begin[edge.b + 1];
  }
  for (std::size_t i = 1; i < m_Begin.size(); ++i)
  {
    m_Begin[i] += m_Begin[i - 1];
  }
  m_Arcs.resize(2 * m_Edges.size());
  m_Next.assign(m_Begin.begin(), m_Begin.end() - 1);
  for (const Edge & edge : m_Edges)
  {
    const std::uint32_t there = m_Next[edge.a]++;
    const std::uint32_t back = m_Next[edge.b]++;
    m_Arcs[there] = { edge.b, back, edge.capacity };
    m_Arcs[back] = { edge.a, there, edge.capacity };
  }
}

bool
MinimumCut::FindLevels()
{
  m_Level.assign(m_First.size(), -1);
  m_Queue.clear();
  for (std::uint32_t u = 0; u < m_First.size(); ++u)
  {
    if (m_First[u] > 0)
    {
      m_Level[u] = 0;
      m_Queue.push_back(u);
    }
  }
  bool reached = false;
  for (std::size_t head = 0; head < m_Queue.size(); ++head)
  {
    const std::uint32_t u = m_Queue[head];
    reached = reached || m_Second[u] > 0;
    for (std::uint32_t i = m_Begin[u]; i < m_Begin[u + 1]; ++i)
    {
      const Arc & arc = m_Arcs[i];
      if (arc.capacity > 0 && m_Level[arc.to] < 0)
      {
        m_Level[arc.to] = m_Level[u] + 1;
        m_Queue.push_back(arc.to);
      }
    }
  }
  return reached;
}

void
MinimumCut::SaturateLevels()
{
  m_Next.assign(m_Begin.begin(), m_Begin.end() - 1);
  std::vector<std::uint32_t> path;
  for (std::uint32_t start = 0; start < m_First.size(); ++start)
  {
    std::uint32_t u = start;
    path.clear();
    while (m_First[start] > 0)
    {
      if (m_Second[u] > 0)
      {
        std::int64_t flow = std::min(m_First[start], m_Second[u]);
        for (const std::uint32_t i : path)
        {
          flow = std::min(flow, m_Arcs[i].capacity);
        }
        m_First[start] -= flow;
        m_Second[u] -= flow;
        std::size_t full = path.size();
        for (std::size_t k = path.size(); k-- > 0;)
        {
          Arc & arc = m_Arcs[path[k]];
          arc.capacity -= flow;
          m_Arcs[arc.reverse].capacity += flow;
          full = arc.capacity == 0 ? k : full;
        }
        // Back to where the first arc is full.
        if (full < path.size())
        {
          u = m_Arcs[m_Arcs[path[full]].reverse].to;
          path.resize(full);
        }
        continue;
      }
      bool advanced = false;
      for (std::uint32_t & i = m_Next[u]; i < m_Begin[u + 1]; ++i)
      {
        const Arc & arc = m_Arcs[i];
        if (arc.capacity > 0 && m_Level[arc.to] == m_Level[u] + 1)
        {
          path.push_back(i);
          u = arc.to;
          advanced = true;
          break;
        }
      }
      if (!advanced)
      {
        if (path.empty())
        {
          break;
        }
        m_Level[u] = -1;
        u = m_Arcs[m_Arcs[path.back()].reverse].to;
        path.pop_back();
      }
    }
  }
}

std::vector<std::uint8_t>
MinimumCut::Solve()
{
  for (std::size_t u = 0; u < m_First.size(); ++u)
  {
    const std::int64_t through = std::min(m_First[u], m_Second[u]);
    m_First[u] -= through;
    m_Second[u] -= through;
  }
  this->MakeArcs();
  while (this->FindLevels())
  {
    this->SaturateLevels();
  }
  std::vector<std::uint8_t> sides(m_First.size());
  std::transform(m_Level.begin(), m_Level.end(), sides.begin(), [](std::int32_t level) {
    return static_cast<std::uint8_t>(level >= 0 ? 1 : 0);
  });
  return sides;
}
} // namespace CrownRegionParts
} // namespace itk
