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
#include "itkReproducibleRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
struct Link
{
  std::uint32_t a;
  std::uint32_t b;
  std::int64_t  capacity;
};

std::int64_t
Cost(const std::vector<std::int64_t> & first,
     const std::vector<std::int64_t> & second,
     const std::vector<Link> &         links,
     const std::vector<std::uint8_t> & sides)
{
  std::int64_t cost = 0;
  for (std::size_t u = 0; u < sides.size(); ++u)
  {
    cost += sides[u] != 0 ? second[u] : first[u];
  }
  for (const Link & link : links)
  {
    cost += sides[link.a] != sides[link.b] ? link.capacity : 0;
  }
  return cost;
}

TEST(MinimumCut, CostsAsLittleAsTheBestOfAllSplits)
{
  itk::ReproducibleRandom random(3);
  for (unsigned int trial = 0; trial < 200; ++trial)
  {
    const std::size_t         nodes = 2 + random.Integer(8);
    std::vector<std::int64_t> first(nodes);
    std::vector<std::int64_t> second(nodes);
    std::vector<Link>         links;
    for (std::size_t u = 0; u < nodes; ++u)
    {
      first[u] = static_cast<std::int64_t>(random.Integer(20));
      second[u] = static_cast<std::int64_t>(random.Integer(20));
      for (std::uint32_t v = 0; v < u; ++v)
      {
        if (random.Uniform() < 0.5)
        {
          links.push_back({ static_cast<std::uint32_t>(u), v, static_cast<std::int64_t>(random.Integer(15)) });
        }
      }
    }
    itk::CrownRegionParts::MinimumCut cut(nodes);
    for (std::uint32_t u = 0; u < nodes; ++u)
    {
      cut.AddTies(u, first[u], second[u]);
    }
    for (const Link & link : links)
    {
      cut.AddEdge(link.a, link.b, link.capacity);
    }
    std::int64_t best = std::numeric_limits<std::int64_t>::max();
    for (std::uint32_t split = 0; split < (1u << nodes); ++split)
    {
      std::vector<std::uint8_t> sides(nodes);
      for (std::size_t u = 0; u < nodes; ++u)
      {
        sides[u] = split >> u & 1u;
      }
      best = std::min(best, Cost(first, second, links, sides));
    }
    EXPECT_EQ(Cost(first, second, links, cut.Solve()), best) << "trial " << trial;
  }
}

TEST(MinimumCut, CutsALongStripAtItsWeakestLink)
{
  // As long as a path can be: no recursion may run deep.
  constexpr std::uint32_t           nodes = 200000;
  itk::CrownRegionParts::MinimumCut cut(nodes);
  cut.AddTies(0, 1000, 0);
  cut.AddTies(nodes - 1, 0, 1000);
  for (std::uint32_t u = 1; u < nodes; ++u)
  {
    cut.AddEdge(u - 1, u, u == 123456 ? 3 : 7);
  }
  const auto sides = cut.Solve();
  EXPECT_EQ(std::count(sides.begin(), sides.end(), std::uint8_t{ 1 }), 123456);
  EXPECT_EQ(sides[123455], 1);
  EXPECT_EQ(sides[123456], 0);
}

TEST(MinimumCut, OfNothingIsNothing)
{
  EXPECT_TRUE(itk::CrownRegionParts::MinimumCut(0).Solve().empty());
  EXPECT_EQ(itk::CrownRegionParts::MinimumCut(2).Solve(), (std::vector<std::uint8_t>{ 0, 0 }));
}
} // namespace
