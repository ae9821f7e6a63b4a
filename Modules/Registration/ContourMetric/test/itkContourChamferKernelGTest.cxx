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

/** Weights from 0.2 to 2, in no order, none like its neighbours'. */
void
AddWeights(itk::ContourArrays & arrays, std::size_t stride)
{
  for (std::size_t i = 0; i < arrays.GetNumberOfPoints(); ++i)
  {
    arrays.weights.push_back(0.2 + 0.1 * static_cast<double>(i * stride % 19));
  }
}

/** Weighted mean over the points of one contour of min(d, truncation) to the nearest point of the other, and its
 * derivatives by scale, angle, tx, ty with the nearest point held; both in the fixed frame. */
struct WeightedMean
{
  double                   value{ 0.0 };
  KernelType::GradientType gradient{ { 0.0, 0.0, 0.0, 0.0 } };

  WeightedMean(const itk::ContourArrays &     fixed,
               const itk::ContourArrays &     moving,
               const itk::ContourSimilarity & pose,
               bool                           overMoving,
               double                         truncation)
  {
    const itk::ContourArrays   moved = Map(moving, pose);
    const itk::ContourArrays & from = overMoving ? moved : fixed;
    const itk::ContourArrays & to = overMoving ? fixed : moved;
    double                     sumOfWeights = 0.0;
    for (std::size_t i = 0; i < from.GetNumberOfPoints(); ++i)
    {
      std::size_t nearest = 0;
      double      least = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < to.GetNumberOfPoints(); ++j)
      {
        const double d =
          std::hypot(from.points[2 * i] - to.points[2 * j], from.points[2 * i + 1] - to.points[2 * j + 1]);
        if (d < least)
        {
          least = d;
          nearest = j;
        }
      }
      sumOfWeights += from.weights[i];
      value += from.weights[i] * std::min(least, truncation);
      if (least >= truncation)
      {
        continue;
      }
      const std::size_t f = overMoving ? nearest : i;
      const std::size_t m = overMoving ? i : nearest;
      const double      nx = (moved.points[2 * m] - fixed.points[2 * f]) / least;
      const double      ny = (moved.points[2 * m + 1] - fixed.points[2 * f + 1]) / least;
      const double      x = moving.points[2 * m];
      const double      y = moving.points[2 * m + 1];
      const double      c = std::cos(pose.angle);
      const double      s = std::sin(pose.angle);
      gradient[0] += from.weights[i] * (nx * (c * x - s * y) + ny * (s * x + c * y));
      gradient[1] += from.weights[i] * pose.scale * (nx * (-s * x - c * y) + ny * (c * x - s * y));
      gradient[2] += from.weights[i] * nx;
      gradient[3] += from.weights[i] * ny;
    }
    value /= sumOfWeights;
    for (double & derivative : gradient)
    {
      derivative /= sumOfWeights;
    }
  }
};

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

TEST(ContourChamferKernel, UnequalWeightsOfBothContoursWeighValueAndGradient)
{
  itk::ContourArrays fixed = MakeWave(79, 0.1, 2.9);
  itk::ContourArrays moving = MakeWave(441, 0.0, 6.2);
  AddWeights(fixed, 7);
  AddWeights(moving, 11);
  KernelType kernel;
  kernel.Initialize(fixed, moving);
  for (const double truncation : { std::numeric_limits<double>::infinity(), 12.0 })
  {
    for (const auto & pose : Poses)
    {
      const WeightedMean       there(fixed, moving, pose, true, truncation);
      const WeightedMean       back(fixed, moving, pose, false, truncation);
      KernelType::GradientType gradients[3];
      const double values[3] = { kernel.Evaluate(pose, DirectionEnum::MovingToFixed, &gradients[0], truncation),
                                 kernel.Evaluate(pose, DirectionEnum::FixedToMoving, &gradients[1], truncation),
                                 kernel.Evaluate(pose, DirectionEnum::Symmetric, &gradients[2], truncation) };
      // Sums of some hundred terms in double: rounding alone, also where the terms of a derivative nearly cancel.
      EXPECT_NEAR(values[0], there.value, 1e-12 * there.value);
      EXPECT_NEAR(values[1], back.value, 1e-12 * back.value);
      EXPECT_NEAR(values[2], there.value + back.value, 1e-12 * (there.value + back.value));
      for (unsigned int k = 0; k < 4; ++k)
      {
        const double unit = k < 2 ? 100.0 : 1.0;
        EXPECT_NEAR(gradients[0][k], there.gradient[k], 1e-12 * unit) << "parameter " << k;
        EXPECT_NEAR(gradients[1][k], back.gradient[k], 1e-12 * unit) << "parameter " << k;
        EXPECT_NEAR(gradients[2][k], there.gradient[k] + back.gradient[k], 2e-12 * unit) << "parameter " << k;
      }
    }
  }
}

TEST(ContourChamferKernel, ApproximateValueWeighsPointsAsTheExactOneDoes)
{
  // Half of the points of either contour are 40 px off and weigh a tenth: without weights either mean is twice as far
  // away as the error of the field.
  std::vector<double> line;
  std::vector<double> zigzag;
  for (int i = 0; i < 40; ++i)
  {
    line.push_back(5.0 * i);
    line.push_back(i % 2 == 0 ? 0.0 : -40.0);
    zigzag.push_back(5.0 * i);
    zigzag.push_back(i % 2 == 0 ? 2.0 : 60.0);
  }
  itk::ContourArrays fixed = MakeArrays(line, false);
  itk::ContourArrays moving = MakeArrays(zigzag, false);
  for (int i = 0; i < 40; ++i)
  {
    fixed.weights.push_back(i % 2 == 0 ? 1.0 : 0.1);
    moving.weights.push_back(i % 2 == 0 ? 1.0 : 0.1);
  }
  KernelType kernel;
  kernel.Initialize(fixed, moving);
  for (const DirectionEnum direction : { DirectionEnum::MovingToFixed, DirectionEnum::FixedToMoving })
  {
    const bool   there = direction == DirectionEnum::MovingToFixed;
    const double exact = WeightedMean(fixed, moving, {}, there, std::numeric_limits<double>::infinity()).value;
    // 3 % of the contours' width of 195 px, as ContourDistanceIndex says of its field.
    EXPECT_NEAR(
      kernel.EvaluateApproximately({}, direction, std::numeric_limits<double>::infinity(), 1000), exact, 0.03 * 195.0);
  }
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
