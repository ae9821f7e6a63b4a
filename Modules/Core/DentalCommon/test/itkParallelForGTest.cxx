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
#include "itkParallelFor.h"

#include <gtest/gtest.h>

#include <stdexcept>

TEST(ParallelFor, VisitsEachIndexOnce)
{
  for (const unsigned int threads : { 0u, 1u, 2u, 7u })
  {
    std::vector<int> visits(1000, 0);
    itk::ParallelFor(visits.size(), threads, [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(1000, 1)) << threads << " threads";
  }
}

TEST(ParallelFor, RethrowsTheBodysException)
{
  for (const unsigned int threads : { 1u, 4u })
  {
    const auto body = [](std::size_t i) {
      if (i == 17)
      {
        throw std::runtime_error("seventeen");
      }
    };
    EXPECT_THROW(itk::ParallelFor(100, threads, body), std::runtime_error) << threads << " threads";
  }
}
