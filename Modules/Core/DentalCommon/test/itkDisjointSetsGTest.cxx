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
#include "itkDisjointSets.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

TEST(DisjointSets, EachNumberIsASetOfItsOwnAtFirst)
{
  itk::DisjointSets sets(4);
  for (std::uint32_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(sets.Find(i), i);
  }
}

TEST(DisjointSets, ASetIsKnownByItsSmallestNumberWhateverTheOrder)
{
  // Two chains, 0-2-4-6-8 and 1-3-5-7-9, each joined link by link from both ends and from the middle.
  const std::vector<std::vector<std::uint32_t>> orders{ { 0, 1, 2, 3 }, { 3, 2, 1, 0 }, { 2, 0, 3, 1 } };
  for (const auto & order : orders)
  {
    itk::DisjointSets sets(10);
    for (const std::uint32_t link : order)
    {
      for (const std::uint32_t first : { 0u, 1u })
      {
        const std::uint32_t low = first + 2 * link;
        // The answer is the smallest number of what is one set now, and asking the other way round changes nothing.
        EXPECT_LE(sets.Join(low + 2, low), low);
        EXPECT_EQ(sets.Join(low, low + 2), sets.Find(low + 2));
      }
    }
    for (std::uint32_t i = 0; i < 10; ++i)
    {
      EXPECT_EQ(sets.Find(i), i % 2);
    }
  }
}

TEST(DisjointSets, ALongChainIsWalked)
{
  // So long that a search that calls itself would end the program.
  constexpr std::uint32_t count = 1000000;
  itk::DisjointSets       sets(count);
  for (std::uint32_t i = count - 1; i > 0; --i)
  {
    sets.Join(i - 1, i);
  }
  EXPECT_EQ(sets.Find(count - 1), 0u);
  EXPECT_EQ(sets.Find(count / 2), 0u);
}
