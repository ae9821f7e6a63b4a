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
#ifndef itkMinimumCut_h
#define itkMinimumCut_h

#include "CrownRegionExport.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
namespace CrownRegionParts
{
/** \class MinimumCut
 * \brief Splits a graph into two sides so that the capacities of the edges between them, and of the nodes' ties to the
 * side that they are not on, are least in sum (Dinic's algorithm, whole numbers, hence exact and deterministic).
 *
 * \ingroup CrownRegion
 */
class CrownRegion_EXPORT MinimumCut
{
public:
  explicit MinimumCut(std::size_t nodes); /**< None is tied. */

  /** Both are added to what is there. */
  void
  AddTies(std::uint32_t node, std::int64_t toFirst, std::int64_t toSecond);
  /** Cutting the two apart costs the capacity, whichever of them is on which side. */
  void
  AddEdge(std::uint32_t a, std::uint32_t b, std::int64_t capacity);

  /** Call once. \return 1 for nodes on the first side; where both are as good, the second. */
  std::vector<std::uint8_t>
  Solve();

private:
  struct Edge
  {
    std::uint32_t a;
    std::uint32_t b;
    std::int64_t  capacity;
  };
  struct Arc
  {
    std::uint32_t to;
    std::uint32_t reverse;
    std::int64_t  capacity;
  };

  void
  MakeArcs();
  bool
  FindLevels();
  void
  SaturateLevels();

  std::vector<std::int64_t>  m_First;
  std::vector<std::int64_t>  m_Second;
  std::vector<Edge>          m_Edges;
  std::vector<Arc>           m_Arcs;
  std::vector<std::uint32_t> m_Begin;
  std::vector<std::uint32_t> m_Next;
  std::vector<std::int32_t>  m_Level;
  std::vector<std::uint32_t> m_Queue;
};
} // namespace CrownRegionParts
} // namespace itk

#endif
