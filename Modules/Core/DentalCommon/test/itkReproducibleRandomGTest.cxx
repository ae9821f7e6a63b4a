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
#include "itkReproducibleRandom.h"

#include <gtest/gtest.h>

TEST(ReproducibleRandom, SameSeedSameNumbersOtherStreamOtherNumbers)
{
  itk::ReproducibleRandom a(7);
  itk::ReproducibleRandom b(7);
  itk::ReproducibleRandom c(7, 1);
  int                     equal = 0;
  for (int i = 0; i < 100; ++i)
  {
    const double x = a.Normal();
    EXPECT_EQ(x, b.Normal());
    equal += x == c.Normal() ? 1 : 0;
  }
  EXPECT_EQ(equal, 0);
}

TEST(ReproducibleRandom, NormalHasTheMomentsOfANormal)
{
  itk::ReproducibleRandom random(1);
  const int               count = 200000;
  double                  sum = 0.0;
  double                  squares = 0.0;
  double                  fourth = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double x = random.Normal();
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  // Five standard errors of each moment.
  EXPECT_NEAR(sum / count, 0.0, 5.0 * 0.0023);
  EXPECT_NEAR(squares / count, 1.0, 5.0 * 0.0032);
  EXPECT_NEAR(fourth / count, 3.0, 5.0 * 0.022);
}

TEST(ReproducibleRandom, IntegerStaysInRangeAndReachesItsEnds)
{
  itk::ReproducibleRandom random(3);
  int                     counts[5] = {};
  for (int i = 0; i < 5000; ++i)
  {
    const std::uint32_t value = random.Integer(5);
    ASSERT_LT(value, 5u);
    ++counts[value];
  }
  for (const int count : counts)
  {
    EXPECT_NEAR(count, 1000, 150);
  }
}
