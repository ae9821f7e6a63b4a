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
#ifndef itkDisjointSets_h
#define itkDisjointSets_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace itk
{
/** \class DisjointSets
 * \brief Numbers from 0 on that are joined into sets, each known by its smallest number (union-find).
 *
 * For the connected parts of a surface: what shares an edge or a corner is joined. Paths are halved as they are walked,
 * and the smaller number becomes the root: chains stay short where neighbours have numbers close to each other, and a
 * set's name does not depend on the order in which it was joined.
 *
 * \ingroup DentalCommon
 */
class DisjointSets
{
public:
  /** So many sets of one number each. */
  explicit DisjointSets(std::size_t size)
    : m_Parent(size)
  {
    std::iota(m_Parent.begin(), m_Parent.end(), std::uint32_t{ 0 });
  }

  /** The smallest number of the set that a number is in. */
  std::uint32_t
  Find(std::uint32_t i)
  {
    while (m_Parent[i] != i)
    {
      m_Parent[i] = m_Parent[m_Parent[i]];
      i = m_Parent[i];
    }
    return i;
  }

  /** Makes one set of those that two numbers are in. \return its smallest number. */
  std::uint32_t
  Join(std::uint32_t i, std::uint32_t j)
  {
    const std::uint32_t a = this->Find(i);
    const std::uint32_t b = this->Find(j);
    m_Parent[std::max(a, b)] = std::min(a, b);
    return std::min(a, b);
  }

private:
  std::vector<std::uint32_t> m_Parent;
};
} // namespace itk

#endif
