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
#include "itkDentalPhantomTracer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using TracerType = itk::DentalPhantomTracer;
using PixelType = TracerType::PixelType;

constexpr double Pi = 3.141592653589793;

/** Two round "crowns", an upper central incisor in front of a lateral one, and the same for the lower jaw. */
struct Balls
{
  itk::TriangleSurface      surface;
  std::vector<std::uint8_t> labels;

  void
  Add(double x, double z, double radius, std::uint8_t fdi)
  {
    constexpr unsigned int n = 160;
    const auto             base = static_cast<std::uint32_t>(surface.points.size());
    for (unsigned int i = 0; i <= n; ++i)
    {
      for (unsigned int j = 0; j < 2 * n; ++j)
      {
        const double a = Pi * i / n;
        const double b = Pi * j / n;
        surface.points.push_back(
          { { x + radius * std::sin(a) * std::cos(b), radius * std::cos(a), z + radius * std::sin(a) * std::sin(b) } });
        labels.push_back(fdi);
      }
    }
    for (unsigned int i = 0; i < n; ++i)
    {
      for (unsigned int j = 0; j < 2 * n; ++j)
      {
        const std::uint32_t p = base + i * 2 * n + j;
        const std::uint32_t q = base + i * 2 * n + (j + 1) % (2 * n);
        surface.triangles.push_back({ { p, q, q + 2 * n } });
        surface.triangles.push_back({ { p, q + 2 * n, p + 2 * n } });
      }
    }
  }
};

/** Parallel: 10 px a mm. */
itk::PerspectiveProjection
Parallel(int facing)
{
  itk::PerspectiveProjection projection;
  projection.matrix = { { 10.0 * facing, 0, 0, 300, 0, 0, -10, 300, 0, 0, 0, 1 } };
  projection.source = { { 0, -1e9, 0 } };
  return projection;
}

TracerType::Polyline
Straight(std::uint8_t fdi, double begin, double end, std::size_t count)
{
  TracerType::Polyline line;
  line.fdi = fdi;
  for (std::size_t i = 0; i < count; ++i)
  {
    line.points.push_back({ { begin + (end - begin) * i / (count - 1.0), 100.0 } });
  }
  return line;
}
} // namespace

TEST(DentalPhantomTracer, FollowsTheUnionOfRoundCrownsInBothJawsAndFacings)
{
  for (const unsigned int jaw : { 0u, 1u })
  {
    for (const int facing : { 1, -1 })
    {
      Balls              balls;
      const unsigned int quadrant = jaw == 0 ? 1 : 4;
      balls.Add(20.0, 0.0, 4.0, static_cast<std::uint8_t>(10 * quadrant + 1));
      balls.Add(14.0, 0.0, 3.0, static_cast<std::uint8_t>(10 * quadrant + 2));
      const auto lines =
        TracerType::TraceSide(balls.surface, balls.labels, {}, Parallel(facing), jaw, quadrant, facing, 0.1);
      ASSERT_EQ(lines.size(), 2u);
      const double occlusal = jaw == 0 ? 1.0 : -1.0;
      const double centres[2] = { 300.0 + 200.0 * facing, 300.0 + 140.0 * facing };
      const double radii[2] = { 40.0, 30.0 };
      for (unsigned int k = 0; k < 2; ++k)
      {
        EXPECT_EQ(lines[k].fdi, 10 * quadrant + k + 1);
        for (const PixelType & p : lines[k].points)
        {
          // On its own circle (the polygon's sagitta is 0.008 px, a tenth of a pixel of raster at the steep ends) ...
          EXPECT_NEAR(std::hypot(p[0] - centres[k], p[1] - 300.0), radii[k], 0.15);
          // ... and not inside the other.
          EXPECT_GT(std::hypot(p[0] - centres[1 - k], p[1] - 300.0), radii[1 - k] - 0.2);
        }
      }
      // The incisor begins on its labial side, above the middle, and runs over its edge; its neighbour is cut where the
      // circles meet (x = 16.42 of 20 and 14).
      EXPECT_GT(facing * (lines[0].points.front()[0] - centres[0]), 0.0);
      EXPECT_LT(occlusal * (lines[0].points.front()[1] - 300.0), -30.0);
      EXPECT_NEAR(lines[0].points[lines[0].corner][1], 300.0 + occlusal * 40.0, 0.1);
      const double meeting = 300.0 + facing * 10.0 * (14.0 + (9.0 - 16.0 + 36.0) / 12.0);
      EXPECT_NEAR(lines[1].points.front()[0], meeting, 0.2);
    }
  }
}

TEST(DentalPhantomTracer, LeavesOutWhatIsNotToBeDrawn)
{
  Balls balls;
  balls.Add(20.0, 0.0, 4.0, 11);
  balls.Add(14.0, 0.0, 3.0, 12);
  std::vector<bool> use;
  for (std::size_t i = 0; i < balls.labels.size(); ++i)
  {
    use.push_back(balls.labels[i] == 12);
  }
  const auto lines = TracerType::TraceSide(balls.surface, balls.labels, use, Parallel(1), 0, 1, 1, 0.1);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].fdi, 12);
  EXPECT_TRUE(TracerType::TraceSide(balls.surface, balls.labels, {}, Parallel(1), 0, 2, 1, 0.1).empty());
}

TEST(DentalPhantomTracer, ResamplingGivesEveryLineItsShare)
{
  const auto lines =
    TracerType::Resample({ Straight(11, 0, 100, 11), Straight(12, 110, 150, 5), Straight(13, 160, 161, 2) }, 79);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].points.size() + lines[1].points.size() + lines[2].points.size(), 79u);
  EXPECT_GE(lines[2].points.size(), 2u);
  EXPECT_EQ(lines[0].points.front(), (PixelType{ { 0.0, 100.0 } }));
  EXPECT_EQ(lines[0].points.back(), (PixelType{ { 100.0, 100.0 } }));
  const double step = 100.0 / (lines[0].points.size() - 1.0);
  for (std::size_t i = 0; i < lines[0].points.size(); ++i)
  {
    EXPECT_NEAR(lines[0].points[i][0], i * step, 1e-9);
  }
}

TEST(DentalPhantomTracer, BisectionIsTheMiddleOfTheTeethThatBothSidesHave)
{
  auto right = Straight(13, 100, 200, 21);
  auto left = Straight(23, 90, 186, 31);
  for (auto & p : left.points)
  {
    p[1] += 7.0;
  }
  const auto lines = TracerType::Bisect({ right, Straight(14, 0, 50, 5) }, { left });
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].fdi, 13);
  EXPECT_NEAR(lines[0].points.front()[0], 95.0, 1e-9);
  EXPECT_NEAR(lines[0].points.back()[0], 193.0, 1e-9);
  for (const PixelType & p : lines[0].points)
  {
    EXPECT_NEAR(p[1], 103.5, 1e-9);
  }
}

// Over many seeds: variance of a coordinate, and the drift's autocorrelation exp(-s^2 / 2 l^2) at several lags.
TEST(DentalPhantomTracer, NoiseHasTheStatedStrengthAndCorrelation)
{
  TracerType::Noise noise;
  noise.correlated = 1.2;
  noise.white = 0.5;
  noise.correlationLength = 15.0;
  constexpr int         seeds = 3000;
  constexpr std::size_t count = 41;
  double                square = 0.0;
  double                product[3] = { 0.0, 0.0, 0.0 };
  const std::size_t     lags[3] = { 1, 3, 9 };
  for (int seed = 0; seed < seeds; ++seed)
  {
    // 200 px, a point each 5 px, in two lines: the drift goes on over the gap.
    std::vector<TracerType::Polyline> lines{ Straight(11, 0, 100, 21), Straight(12, 105, 200, 20) };
    TracerType::AddNoise(lines, noise, seed, 1);
    std::vector<double> error;
    for (const auto & line : lines)
    {
      for (const auto & p : line.points)
      {
        error.push_back(p[1] - 100.0);
        EXPECT_EQ(p[1], std::nearbyint(p[1] * 1e3) / 1e3);
      }
    }
    for (std::size_t i = 0; i + 9 < count; ++i)
    {
      square += error[i] * error[i] / (seeds * (count - 9.0));
      for (unsigned int k = 0; k < 3; ++k)
      {
        product[k] += error[i] * error[i + lags[k]] / (seeds * (count - 9.0));
      }
    }
  }
  // About 3000 x 6 independent stretches: 1 % of the variance, four times that allowed.
  EXPECT_NEAR(square, 1.44 + 0.25, 0.06);
  for (unsigned int k = 0; k < 3; ++k)
  {
    const double s = 5.0 * lags[k];
    EXPECT_NEAR(product[k], 1.44 * std::exp(-s * s / (2.0 * 225.0)), 0.06) << s;
  }
}

TEST(DentalPhantomTracer, ToothBiasMovesEachToothAsAWhole)
{
  TracerType::Noise noise;
  noise.toothShift = 2.0;
  std::vector<TracerType::Polyline> lines{ Straight(11, 0, 50, 11), Straight(12, 60, 90, 7) };
  const auto                        before = lines;
  TracerType::AddNoise(lines, noise, 5, 1);
  for (std::size_t k = 0; k < 2; ++k)
  {
    for (std::size_t i = 0; i < lines[k].points.size(); ++i)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        EXPECT_NEAR(
          lines[k].points[i][d] - before[k].points[i][d], lines[k].points[0][d] - before[k].points[0][d], 2e-3);
      }
    }
  }
  EXPECT_GT(std::abs(lines[0].points[0][1] - before[0].points[0][1] - lines[1].points[0][1] + before[1].points[0][1]),
            0.01);
}
