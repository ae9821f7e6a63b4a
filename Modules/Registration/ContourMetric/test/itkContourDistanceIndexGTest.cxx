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
#include "itkContourDistanceIndex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace
{
using IndexType = itk::ContourDistanceIndex;

/** A wavy closed curve about (300, 200), 250 pixels wide. */
std::vector<double>
MakeCurve(std::size_t count)
{
  std::vector<double> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double a = 2.0 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(count);
    points.push_back(300.0 + 120.0 * std::cos(a) + 4.0 * std::sin(9.0 * a));
    points.push_back(200.0 + 45.0 * std::sin(a) + 9.0 * std::cos(3.0 * a));
  }
  return points;
}

std::vector<std::uint32_t>
MakeClosedSegments(std::size_t count)
{
  std::vector<std::uint32_t> segments;
  for (std::size_t i = 0; i < count; ++i)
  {
    segments.push_back(static_cast<std::uint32_t>(i));
    segments.push_back(static_cast<std::uint32_t>((i + 1) % count));
  }
  return segments;
}

/** Queries near, around and far from the curve, and on its points. */
std::vector<double>
MakeQueries(const std::vector<double> & curve)
{
  std::vector<double> queries;
  std::uint64_t       state = 88172645463325252ull;
  const auto          uniform = [&state]() {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<double>(state >> 11) / 9007199254740992.0;
  };
  for (const double range : { 2.0, 30.0, 300.0, 3000.0, 1e5, 1e9 })
  {
    for (int i = 0; i < 400; ++i)
    {
      const std::size_t at = static_cast<std::size_t>(uniform() * (curve.size() / 2)) * 2;
      queries.push_back(curve[at] + range * (uniform() - 0.5));
      queries.push_back(curve[at + 1] + range * (uniform() - 0.5));
    }
  }
  queries.insert(queries.end(), curve.begin(), curve.end());
  return queries;
}

void
ExpectSameAsBruteForce(IndexType & index, const std::vector<double> & queries)
{
  IndexType reference(index);
  reference.SetSearch(IndexType::SearchEnum::BruteForce);
  index.SetSearch(IndexType::SearchEnum::Grid);
  std::vector<double> nearestPoints(queries.size());
  IndexType(index).FindNearestPoints(queries.data(), queries.size() / 2, nearestPoints.data());
  for (std::size_t i = 0; i < queries.size(); i += 2)
  {
    const double x = queries[i];
    const double y = queries[i + 1];
    const auto   found = index.FindNearest(x, y);
    const auto   expected = reference.FindNearest(x, y);
    // The promise is 1e-12 relative.
    ASSERT_NEAR(std::sqrt(found.squaredDistance),
                std::sqrt(expected.squaredDistance),
                1e-12 * std::sqrt(expected.squaredDistance))
      << "query " << x << ", " << y;
    ASSERT_NEAR(std::hypot(nearestPoints[i] - x, nearestPoints[i + 1] - y),
                std::sqrt(expected.squaredDistance),
                1e-12 * std::sqrt(expected.squaredDistance));
    // The foot is as far as it says.
    ASSERT_NEAR(
      std::hypot(found.x - x, found.y - y), std::sqrt(found.squaredDistance), 1e-14 * std::sqrt(found.squaredDistance));
  }
}
} // namespace

TEST(ContourDistanceIndex, GridEqualsBruteForceForPoints)
{
  for (const std::size_t count : { 13u, 79u, 441u, 3000u, 9000u })
  {
    const std::vector<double> curve = MakeCurve(count);
    IndexType                 index;
    index.SetPoints(curve.data(), count);
    EXPECT_EQ(index.GetNumberOfTargets(), count);
    ExpectSameAsBruteForce(index, MakeQueries(curve));
  }
}

TEST(ContourDistanceIndex, GridEqualsBruteForceForSegments)
{
  for (const std::size_t count : { 13u, 79u, 441u, 3000u, 9000u })
  {
    const std::vector<double> curve = MakeCurve(count);
    const auto                segments = MakeClosedSegments(count);
    IndexType                 index;
    index.SetSegments(curve.data(), count, segments.data(), count);
    ExpectSameAsBruteForce(index, MakeQueries(curve));
  }
}

TEST(ContourDistanceIndex, GridEqualsBruteForceForScatteredPointsAndLongSegments)
{
  // No curve at all: crossing segments from anywhere to anywhere, repeated points, and lone points between them.
  std::vector<double>        points;
  std::vector<std::uint32_t> segments;
  const std::vector<double>  curve = MakeCurve(97);
  for (std::uint32_t i = 0; i < 97; ++i)
  {
    const std::uint32_t j = (i * 37) % 97;
    points.push_back(curve[2 * j]);
    points.push_back(curve[2 * j + 1]);
    if (i % 3 != 0)
    {
      segments.push_back(i - 1);
      segments.push_back(i);
    }
  }
  for (int repeat = 0; repeat < 20; ++repeat)
  {
    points.push_back(310.0);
    points.push_back(190.0);
  }
  IndexType index;
  index.SetSegments(points.data(), points.size() / 2, segments.data(), segments.size() / 2);
  ExpectSameAsBruteForce(index, MakeQueries(points));
  index.SetPoints(points.data(), points.size() / 2);
  ExpectSameAsBruteForce(index, MakeQueries(points));
}

TEST(ContourDistanceIndex, SegmentDistancesAreThoseOfHand)
{
  // An angle (0,0)-(4,0)-(4,3), a point of no length at (10,0) and a lone point at (0,10).
  const double        points[] = { 0, 0, 4, 0, 4, 3, 10, 0, 10, 0, 0, 10 };
  const std::uint32_t segments[] = { 0, 1, 1, 2, 3, 4 };
  IndexType           index;
  index.SetSegments(points, 6, segments, 3);
  ASSERT_EQ(index.GetNumberOfTargets(), 4u);
  const auto expect = [&index](double x, double y, double distance, double footX, double footY, std::uint32_t target) {
    const auto nearest = index.FindNearest(x, y);
    EXPECT_DOUBLE_EQ(std::sqrt(nearest.squaredDistance), distance);
    EXPECT_DOUBLE_EQ(nearest.x, footX);
    EXPECT_DOUBLE_EQ(nearest.y, footY);
    EXPECT_EQ(nearest.target, target);
  };
  expect(1, 0.5, 0.5, 1, 0, 0);
  expect(-3, -4, 5, 0, 0, 0);
  expect(3.5, 2, 0.5, 4, 2, 1);
  expect(13, 4, 5, 10, 0, 2);
  expect(1, 10, 1, 0, 10, 3);
}

TEST(ContourDistanceIndex, PointsInOnePlaceAndFarFromTheOriginAreFound)
{
  std::vector<double> points;
  for (int i = 0; i < 50; ++i)
  {
    points.push_back(7.0);
    points.push_back(-3.0);
  }
  IndexType index;
  index.SetPoints(points.data(), 50);
  EXPECT_DOUBLE_EQ(index.FindNearest(10.0, 1.0).squaredDistance, 25.0);

  // A contour of a pixel's width a million pixels away still has its grid.
  std::vector<double> curve = MakeCurve(79);
  for (double & x : curve)
  {
    x = 1e6 + x / 250.0;
  }
  index.SetPoints(curve.data(), 79);
  ExpectSameAsBruteForce(index, MakeQueries(curve));
}

TEST(ContourDistanceIndex, ApproximateDistanceIsWithinItsBound)
{
  const std::vector<double> curve = MakeCurve(441);
  const auto                segments = MakeClosedSegments(441);
  IndexType                 index;
  index.SetSegments(curve.data(), 441, segments.data(), 441);
  double largest = 0.0;
  for (double x = 160.0; x < 440.0; x += 1.7)
  {
    for (double y = 130.0; y < 270.0; y += 1.3)
    {
      const double exact = std::sqrt(index.FindNearest(x, y).squaredDistance);
      const double error = std::abs(index.FindApproximateDistance(x, y) - exact);
      largest = std::max(largest, error);
    }
  }
  // 250 px wide, 64 cells: half a cell's diagonal is 2.9 px. Outside of the square the cells are three times as wide.
  EXPECT_LT(largest, 3.0 * 2.9);
  EXPECT_GT(largest, 0.5);
  EXPECT_NEAR(
    index.FindApproximateDistance(300.0, 200.0), std::sqrt(index.FindNearest(300.0, 200.0).squaredDistance), 2.9);
}

TEST(ContourDistanceIndex, ApproximateDistancesOfManyAreThoseOfCellCentres)
{
  // Also the finest of grids, whose coarsest cells cover fewer places of the field.
  for (const std::size_t count : { 79u, 441u, 9000u })
  {
    const std::vector<double> curve = MakeCurve(count);
    const auto                segments = MakeClosedSegments(count);
    double                    low[2] = { curve[0], curve[1] };
    double                    high[2] = { curve[0], curve[1] };
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      low[i % 2] = std::min(low[i % 2], curve[i]);
      high[i % 2] = std::max(high[i % 2], curve[i]);
    }
    const double width = std::max(high[0] - low[0], high[1] - low[1]);
    for (const bool isSegments : { false, true })
    {
      IndexType index;
      isSegments ? index.SetSegments(curve.data(), count, segments.data(), count)
                 : index.SetPoints(curve.data(), count);
      IndexType one(index);
      IndexType reference(index);
      reference.SetSearch(IndexType::SearchEnum::BruteForce);
      std::vector<double> places;
      for (double x = 300.0 - 3.0 * width; x < 300.0 + 3.0 * width; x += 0.031 * width)
      {
        for (double y = 200.0 - 3.0 * width; y < 200.0 + 3.0 * width; y += 0.029 * width)
        {
          places.push_back(x);
          places.push_back(y);
        }
      }
      // The first time most of the field is not yet filled, the second time all of it is.
      for (int repeat = 0; repeat < 2; ++repeat)
      {
        std::vector<double> distances(places.size() / 2, -1.0);
        index.FindApproximateDistances(places.data(), distances.size(), distances.data());
        for (std::size_t i = 0; i < distances.size(); ++i)
        {
          const double x = places[2 * i];
          const double y = places[2 * i + 1];
          ASSERT_EQ(distances[i], one.FindApproximateDistance(x, y));
          // Half the diagonal of a cell: 64 cells a side of a square of 1.02 widths, then of 3.06, then of 9.18.
          const double away = std::max(std::abs(x - 0.5 * (low[0] + high[0])), std::abs(y - 0.5 * (low[1] + high[1])));
          const double square = 1.02 * width * (away < 0.5099 * width ? 1.0 : away < 1.5299 * width ? 3.0 : 9.0);
          const double exact = std::sqrt(reference.FindNearest(x, y).squaredDistance);
          ASSERT_NEAR(distances[i], exact, square / 64.0 * std::sqrt(0.5) + 1e-6 * exact) << x << ", " << y;
        }
      }
    }
  }
}

TEST(ContourDistanceIndex, QueriesInAnyOrderGiveTheSameBits)
{
  const std::vector<double> curve = MakeCurve(441);
  const std::vector<double> queries = MakeQueries(curve);
  IndexType                 forward;
  forward.SetPoints(curve.data(), 441);
  IndexType           backward(forward);
  std::vector<double> distances;
  for (std::size_t i = 0; i < queries.size(); i += 2)
  {
    distances.push_back(forward.FindNearest(queries[i], queries[i + 1]).squaredDistance);
  }
  for (std::size_t i = queries.size(); i > 0; i -= 2)
  {
    ASSERT_EQ(backward.FindNearest(queries[i - 2], queries[i - 1]).squaredDistance, distances[i / 2 - 1]);
  }
}
