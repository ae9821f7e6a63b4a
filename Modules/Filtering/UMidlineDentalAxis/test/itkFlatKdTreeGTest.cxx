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
#include "itkFlatKdTree.h"
#include "itkReproducibleRandom.h"

#include <gtest/gtest.h>

#include <limits>

TEST(FlatKdTree, NearestIsThatOfBruteForceWithAnyGuess)
{
  itk::ReproducibleRandom            random(3);
  std::vector<std::array<double, 3>> points(700);
  for (auto & p : points)
  {
    p = { random.Uniform(-1, 1), random.Uniform(-1, 1), random.Normal() };
  }
  points[20] = points[10];
  const itk::FlatKdTree<3> tree(points);
  for (unsigned int trial = 0; trial < 500; ++trial)
  {
    const std::array<double, 3> query{ random.Uniform(-2, 2), random.Uniform(-2, 2), random.Uniform(-2, 2) };
    double                      expected = std::numeric_limits<double>::infinity();
    for (const auto & p : points)
    {
      const double d = (p[0] - query[0]) * (p[0] - query[0]) + (p[1] - query[1]) * (p[1] - query[1]) +
                       (p[2] - query[2]) * (p[2] - query[2]);
      expected = std::min(expected, d);
    }
    double found = std::numeric_limits<double>::infinity();
    tree.Nearest(query, found);
    EXPECT_EQ(found, expected);
    double guessed = std::numeric_limits<double>::infinity();
    tree.Nearest(query, guessed, random.Integer(700));
    EXPECT_EQ(guessed, expected);
  }
}

TEST(FlatKdTree, NearestInSixDimensionsIsThatOfBruteForce)
{
  using Point = std::array<double, 6>;
  itk::ReproducibleRandom random(5);
  const auto              draw = [&random]() {
    Point point;
    for (double & x : point)
    {
      x = random.Uniform(-1, 1);
    }
    return point;
  };
  std::vector<Point> points(500);
  for (Point & point : points)
  {
    point = draw();
    // As normals of a flat arch: most of them have one direction.
    point[5] = 2.0;
  }
  const itk::FlatKdTree<6> tree(points);
  for (unsigned int trial = 0; trial < 300; ++trial)
  {
    const Point query = draw();
    double      expected = std::numeric_limits<double>::infinity();
    for (const Point & p : points)
    {
      double squared = 0.0;
      for (unsigned int d = 0; d < 6; ++d)
      {
        squared += (query[d] - p[d]) * (query[d] - p[d]);
      }
      expected = std::min(expected, squared);
    }
    double found = std::numeric_limits<double>::infinity();
    tree.Nearest(query, found, random.Integer(500));
    EXPECT_EQ(found, expected);
  }
}

TEST(FlatKdTree, NothingIsNearerThanATightBoundAndAnEmptyTreeHasNothing)
{
  const itk::FlatKdTree<3> tree({ { { 0, 0, 0 } }, { { 3, 0, 0 } } });
  double                   bound = 0.25;
  EXPECT_EQ(tree.Nearest({ 1, 0, 0 }, bound), itk::FlatKdTree<3>::None);
  EXPECT_EQ(bound, 0.25);
  const itk::FlatKdTree<3> empty(std::vector<std::array<double, 3>>{});
  EXPECT_EQ(empty.Nearest({ 1, 0, 0 }, bound), itk::FlatKdTree<3>::None);
}

TEST(FlatKdTree, WithinVisitsThePointsOfTheBallOnce)
{
  itk::ReproducibleRandom            random(4);
  std::vector<std::array<double, 3>> points(900);
  for (auto & p : points)
  {
    p = { random.Uniform(), random.Uniform(), random.Uniform() };
  }
  const itk::FlatKdTree<3>    tree(points);
  const std::array<double, 3> query{ 0.4, 0.5, 0.6 };
  std::vector<int>            visits(points.size(), 0);
  tree.Within(query, 0.3, [&](std::uint32_t index, double) { ++visits[index]; });
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto & p = points[i];
    const double d = (p[0] - query[0]) * (p[0] - query[0]) + (p[1] - query[1]) * (p[1] - query[1]) +
                     (p[2] - query[2]) * (p[2] - query[2]);
    EXPECT_EQ(visits[i], d < 0.09 ? 1 : 0);
  }
}
