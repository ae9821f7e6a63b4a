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
#include "itkContourChamferKernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{
using KernelType = itk::ContourChamferKernel;
using DirectionEnum = KernelType::DirectionEnum;
using DistanceEnum = KernelType::DistanceEnum;

itk::ContourArrays
MakeArrays(const std::vector<double> & points, bool polyline)
{
  itk::ContourArrays arrays;
  arrays.points = points;
  for (std::uint32_t i = 0; polyline && i + 1 < points.size() / 2; ++i)
  {
    arrays.segments.push_back(i);
    arrays.segments.push_back(i + 1);
  }
  return arrays;
}

itk::ContourArrays
MakeWave(std::size_t count, double from, double to)
{
  std::vector<double> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double a = from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
    points.push_back(100.0 * std::cos(a) + 5.0 * std::sin(6.0 * a));
    points.push_back(40.0 * std::sin(a) + 7.0 * std::cos(4.0 * a));
  }
  return MakeArrays(points, true);
}

/** The definition, point to point or point to segment, with nothing clever. */
double
MeanByDefinition(const itk::ContourArrays & from, const itk::ContourArrays & to, bool segments)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < from.GetNumberOfPoints(); ++i)
  {
    const double x = from.points[2 * i];
    const double y = from.points[2 * i + 1];
    double       least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j + 1 < to.GetNumberOfPoints() + (segments ? 0 : 1); ++j)
    {
      double footX = to.points[2 * j];
      double footY = to.points[2 * j + 1];
      if (segments)
      {
        const double dx = to.points[2 * j + 2] - footX;
        const double dy = to.points[2 * j + 3] - footY;
        const double t = std::min(1.0, std::max(0.0, ((x - footX) * dx + (y - footY) * dy) / (dx * dx + dy * dy)));
        footX += t * dx;
        footY += t * dy;
      }
      least = std::min(least, std::hypot(x - footX, y - footY));
    }
    sum += least;
  }
  return sum / static_cast<double>(from.GetNumberOfPoints());
}

itk::ContourArrays
Map(itk::ContourArrays arrays, const itk::ContourSimilarity & similarity)
{
  const double c = similarity.scale * std::cos(similarity.angle);
  const double s = similarity.scale * std::sin(similarity.angle);
  for (std::size_t i = 0; i < arrays.GetNumberOfPoints(); ++i)
  {
    const double x = arrays.points[2 * i];
    const double y = arrays.points[2 * i + 1];
    arrays.points[2 * i] = c * x - s * y + similarity.tx;
    arrays.points[2 * i + 1] = s * x + c * y + similarity.ty;
  }
  return arrays;
}

const itk::ContourSimilarity Poses[] = { { 1.1, 0.2, 3.0, -2.0 },
                                         { 0.8, -0.4, 25.0, 10.0 },
                                         { 1.0, 0.0, 200.0, 200.0 } };
} // namespace

TEST(ContourChamferKernel, MeansAreThoseOfHand)
{
  const itk::ContourArrays fixed = MakeArrays({ 0, 0, 10, 0 }, true);
  const itk::ContourArrays moving = MakeArrays({ 0, 3, 5, 4, 10, 0 }, true);
  KernelType               kernel;
  kernel.Initialize(fixed, moving, DistanceEnum::PointToPoint);
  // (0,3) -> 3; (5,4) -> sqrt(41); (10,0) -> 0. Back: (0,0) -> 3, (10,0) -> 0.
  EXPECT_DOUBLE_EQ(kernel.Evaluate({}, DirectionEnum::MovingToFixed), (3.0 + std::sqrt(41.0)) / 3.0);
  EXPECT_DOUBLE_EQ(kernel.Evaluate({}, DirectionEnum::FixedToMoving), 1.5);
  EXPECT_DOUBLE_EQ(kernel.Evaluate({}), (3.0 + std::sqrt(41.0)) / 3.0 + 1.5);
  // Truncated at 4: 3, 4, 0.
  EXPECT_DOUBLE_EQ(kernel.Evaluate({}, DirectionEnum::MovingToFixed, nullptr, 4.0), 7.0 / 3.0);
  kernel.Initialize(fixed, moving, DistanceEnum::PointToSegment);
  // (5,4) -> 4 now; (0,0) to the line from (0,3) to (5,4): (0,3) is nearest.
  EXPECT_DOUBLE_EQ(kernel.Evaluate({}, DirectionEnum::MovingToFixed), 7.0 / 3.0);
  EXPECT_DOUBLE_EQ(kernel.Evaluate({}, DirectionEnum::FixedToMoving), 1.5);
}

TEST(ContourChamferKernel, ValueIsThatOfTheDefinition)
{
  const itk::ContourArrays fixed = MakeWave(79, 0.1, 2.9);
  const itk::ContourArrays moving = MakeWave(441, 0.0, 6.2);
  for (const bool segments : { false, true })
  {
    KernelType kernel;
    kernel.Initialize(fixed, moving, segments ? DistanceEnum::PointToSegment : DistanceEnum::PointToPoint);
    for (const auto & pose : Poses)
    {
      const itk::ContourArrays moved = Map(moving, pose);
      const double             there = MeanByDefinition(moved, fixed, segments);
      const double             back = MeanByDefinition(fixed, moved, segments);
      EXPECT_NEAR(kernel.Evaluate(pose, DirectionEnum::MovingToFixed), there, 1e-12 * there);
      EXPECT_NEAR(kernel.Evaluate(pose, DirectionEnum::FixedToMoving), back, 1e-12 * back);
      EXPECT_NEAR(kernel.Evaluate(pose), there + back, 1e-12 * (there + back));
    }
  }
}

TEST(ContourChamferKernel, GradientIsThatOfTheValue)
{
  const itk::ContourArrays fixed = MakeWave(79, 0.1, 2.9);
  const itk::ContourArrays moving = MakeWave(441, 0.0, 6.2);
  for (const DistanceEnum distance : { DistanceEnum::PointToPoint, DistanceEnum::PointToSegment })
  {
    for (const DirectionEnum direction :
         { DirectionEnum::Symmetric, DirectionEnum::MovingToFixed, DirectionEnum::FixedToMoving })
    {
      for (const double truncation : { std::numeric_limits<double>::infinity(), 12.0 })
      {
        KernelType kernel;
        kernel.Initialize(fixed, moving, distance);
        for (const auto & pose : Poses)
        {
          KernelType::GradientType gradient;
          kernel.Evaluate(pose, direction, &gradient, truncation);
          // The value is piecewise smooth: a step so small that hardly a nearest point changes, and a tolerance for
          // those that do (they change the slope, not the value).
          const double step[4] = { 1e-8, 1e-8, 1e-6, 1e-6 };
          for (int k = 0; k < 4; ++k)
          {
            itk::ContourSimilarity low = pose;
            itk::ContourSimilarity high = pose;
            double * const         lowParts[4] = { &low.scale, &low.angle, &low.tx, &low.ty };
            double * const         highParts[4] = { &high.scale, &high.angle, &high.tx, &high.ty };
            *lowParts[k] -= step[k];
            *highParts[k] += step[k];
            const double difference = (kernel.Evaluate(high, direction, nullptr, truncation) -
                                       kernel.Evaluate(low, direction, nullptr, truncation)) /
                                      (2.0 * step[k]);
            EXPECT_NEAR(gradient[k], difference, 1e-5 * (1.0 + std::abs(difference))) << "parameter " << k;
          }
        }
      }
    }
  }
}

TEST(ContourChamferKernel, PerfectFitHasValueAndGradientZero)
{
  const itk::ContourArrays contour = MakeWave(100, 0.0, 3.0);
  KernelType               kernel;
  kernel.Initialize(contour, contour);
  KernelType::GradientType gradient;
  EXPECT_EQ(kernel.Evaluate({}, DirectionEnum::Symmetric, &gradient), 0.0);
  for (const double derivative : gradient)
  {
    EXPECT_EQ(derivative, 0.0);
  }
}

TEST(ContourChamferKernel, WeightsWeighAndZeroIgnores)
{
  itk::ContourArrays fixed = MakeArrays({ 0, 0, 10, 0, 20, 0 }, true);
  itk::ContourArrays moving = MakeArrays({ 0, 1, 10, 2 }, true);
  moving.weights = { 1.0, 0.5 };
  KernelType kernel;
  kernel.Initialize(fixed, moving);
  EXPECT_DOUBLE_EQ(kernel.Evaluate({}, DirectionEnum::MovingToFixed), (1.0 + 0.5 * 2.0) / 1.5);
  // Without its middle point, the fixed contour has no segment left.
  fixed.weights = { 1.0, 0.0, 1.0 };
  kernel.Initialize(fixed, moving, DistanceEnum::PointToSegment);
  const std::vector<double> distances = kernel.GetMovingToFixedDistances({});
  ASSERT_EQ(distances.size(), 2u);
  EXPECT_DOUBLE_EQ(distances[0], 1.0);
  EXPECT_DOUBLE_EQ(distances[1], std::sqrt(104.0));
  const std::vector<double> back = kernel.GetFixedToMovingDistances({});
  ASSERT_EQ(back.size(), 3u);
  EXPECT_TRUE(std::isnan(back[1]));
  EXPECT_FALSE(std::isnan(back[2]));
}

TEST(ContourChamferKernel, ApproximateValueRanksPoses)
{
  const itk::ContourArrays fixed = MakeWave(79, 0.1, 2.9);
  const itk::ContourArrays moving = MakeWave(441, 0.0, 6.2);
  KernelType               kernel;
  kernel.Initialize(fixed, moving);
  for (double tx = -60.0; tx <= 60.0; tx += 7.0)
  {
    const itk::ContourSimilarity pose{ 1.05, 0.1, tx, 0.5 * tx };
    const double                 exact = kernel.Evaluate(pose);
    const double                 approximate =
      kernel.EvaluateApproximately(pose, DirectionEnum::Symmetric, std::numeric_limits<double>::infinity(), 48);
    // Two means, each off by no more than half a cell's diagonal (2.3 px for 205 px in 64 cells; three times as much
    // outside); in the mean far less.
    EXPECT_NEAR(approximate, exact, 3.0) << tx;
  }
}

TEST(ContourChamferKernel, RefusesWhatHasNoDistance)
{
  const itk::ContourArrays good = MakeArrays({ 0, 0, 10, 0 }, true);
  itk::ContourArrays       ignored = good;
  ignored.weights = { 0.0, 0.0 };
  KernelType kernel;
  EXPECT_THROW(kernel.Initialize(good, itk::ContourArrays()), std::invalid_argument);
  EXPECT_THROW(kernel.Initialize(ignored, good), std::invalid_argument);
  EXPECT_THROW(kernel.Initialize(good, MakeArrays({ 0, std::nan("") }, false)), std::invalid_argument);
}
