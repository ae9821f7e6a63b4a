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
#include "itkGemanMcClureKernel.h"
#include "itkSquaresKernel.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
int
ExerciseBasicObjectMethods()
{
  const auto gemanMcClure = itk::GemanMcClureKernel::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(gemanMcClure, GemanMcClureKernel, RobustKernel);
  const auto squares = itk::SquaresKernel::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(squares, SquaresKernel, RobustKernel);
  return EXIT_SUCCESS;
}

std::vector<itk::RobustKernel::ConstPointer>
Kernels()
{
  return { itk::GemanMcClureKernel::New().GetPointer(), itk::SquaresKernel::New().GetPointer() };
}

/** What a residual of this squared distance costs with a weight. */
double
Cost(const itk::RobustKernel & kernel, double weight, double squaredDistance, double width)
{
  return weight * squaredDistance + width * width * kernel.GetCharge(weight);
}
} // namespace

TEST(RobustKernel, BasicObjectMethods)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
}

TEST(RobustKernel, WeightIsWhereWeightedSquareAndChargeAreSmallest)
{
  for (const auto & kernel : Kernels())
  {
    for (const double width : { 0.7, 3.0 })
    {
      for (const double distance : { 0.0, 0.4, 2.5, 9.0 })
      {
        const double d2 = distance * distance;
        const double weight = kernel->GetWeight(d2, width);
        ASSERT_GT(weight, 0.0);
        ASSERT_LE(weight, 1.0);
        // SquaresKernel charges for nothing, since it lets nothing go: its weight is 1 whatever would be smaller.
        if (dynamic_cast<const itk::SquaresKernel *>(kernel.GetPointer()) != nullptr)
        {
          EXPECT_EQ(weight, 1.0);
          EXPECT_EQ(kernel->GetCharge(0.3), 0.0);
          continue;
        }
        const double least = Cost(*kernel, weight, d2, width);
        for (double other = 1e-4; other <= 1.0; other *= 1.07)
        {
          EXPECT_GE(Cost(*kernel, other, d2, width), least - 1e-12 * (1.0 + least)) << distance << ", " << other;
        }
        // Geman and McClure's criterion, c^2 d^2 / (c^2 + d^2).
        EXPECT_NEAR(least, width * width * d2 / (width * width + d2), 1e-12 * (1.0 + least));
      }
    }
    EXPECT_EQ(kernel->GetWeight(0.0, 2.0), 1.0);
    EXPECT_EQ(kernel->GetCharge(1.0), 0.0);
  }
}

TEST(RobustKernel, WeightFallsToNothingFarAway)
{
  const auto kernel = itk::GemanMcClureKernel::New();
  EXPECT_EQ(kernel->GetWeight(9.0, 3.0), 0.25) << "at one width";
  EXPECT_LT(kernel->GetWeight(1e6, 3.0), 1e-9);
  EXPECT_EQ(kernel->GetCharge(0.0), 1.0) << "what is let go costs the squared width";
  EXPECT_TRUE(std::isfinite(kernel->GetChargeDerivative(0.0)));
}

TEST(RobustKernel, DerivativesAreThoseOfTheFunctions)
{
  constexpr double step = 1e-6;
  for (const auto & kernel : Kernels())
  {
    for (const double width : { 0.7, 3.0 })
    {
      for (const double d2 : { 0.1, 2.0, 30.0 })
      {
        const double slope = (kernel->GetWeight(d2 + step, width) - kernel->GetWeight(d2 - step, width)) / (2.0 * step);
        // Differences of second order, and rounding of 1e-16 over the step.
        EXPECT_NEAR(kernel->GetWeightDerivative(d2, width), slope, 1e-9) << kernel->GetNameOfClass();
      }
    }
    for (const double weight : { 0.05, 0.4, 0.97 })
    {
      const double slope = (kernel->GetCharge(weight + step) - kernel->GetCharge(weight - step)) / (2.0 * step);
      EXPECT_NEAR(kernel->GetChargeDerivative(weight), slope, 1e-8) << kernel->GetNameOfClass();
    }
  }
}
