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
#include "itkToothOutlineComparison.h"

#include "itkReproducibleRandom.h"

#include "itkGTest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using ComparisonType = itk::ToothOutlineComparison;
using LineType = ComparisonType::LineType;

constexpr double Pi = 3.14159265358979323846;

/** A tooth, mm: a root that narrows, a crown whose labial side is flatter than its palatal one. */
LineType
MakeTooth(double length, double width, double bulge, std::size_t count = 80)
{
  LineType line;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double a = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(count);
    const double t = 0.5 * (1.0 - std::cos(a));
    const double half = 0.5 * width * std::sin(a) * (1.0 - 0.5 * t) * (a > Pi ? 1.0 + bulge * std::cos(3.0 * a) : 1.0);
    line.push_back({ { half, length * t } });
  }
  return line;
}

/** Scaled, turned (rad), moved. */
LineType
Move(const LineType & line, double scale, double angle, double x, double y, bool reflected = false)
{
  LineType moved;
  for (const auto & p : line)
  {
    const double a = reflected ? -p[0] : p[0];
    moved.push_back({ { x + scale * (std::cos(angle) * a - std::sin(angle) * p[1]),
                        y + scale * (std::sin(angle) * a + std::cos(angle) * p[1]) } });
  }
  return moved;
}

/** As a hand draws it: beside the line by a slow drift, mm. */
LineType
Draw(const LineType & line, double drift, std::uint64_t seed)
{
  itk::ReproducibleRandom random(seed, 1);
  LineType                drawn = line;
  for (int wave = 2; wave < 10; ++wave)
  {
    const double phase[2] = { 2.0 * Pi * random.Uniform(), 2.0 * Pi * random.Uniform() };
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      const double a = 2.0 * Pi * wave * static_cast<double>(i) / static_cast<double>(line.size());
      for (unsigned int d = 0; d < 2; ++d)
      {
        // Eight waves of equal power.
        drawn[i][d] += 0.5 * drift * std::cos(a + phase[d]);
      }
    }
  }
  return drawn;
}
} // namespace

TEST(ToothOutlineComparison, OneOutlineIsItselfWhereverItLies)
{
  const LineType tooth = MakeTooth(23.0, 7.0, 0.2);
  const double   same = 1e-3;
  EXPECT_LT(ComparisonType::ComputeDistance(tooth, tooth), 1e-9);
  EXPECT_LT(ComparisonType::ComputeDistance(tooth, Move(tooth, 1.0, 0.3, 40.0, -7.0)), same);
  EXPECT_LT(ComparisonType::ComputeDistance(tooth, Move(tooth, 0.9, -2.8, 400.0, 700.0)), same);
  EXPECT_LT(ComparisonType::ComputeDistance(tooth, Move(tooth, 1.1, 0.5, 1.0, 2.0, true)), same);
  // In the units of the second, whatever those of the first are.
  EXPECT_LT(ComparisonType::ComputeDistance(Move(tooth, 10.0, 1.0, 0.0, 0.0), tooth), same);
  LineType other = tooth;
  std::rotate(other.begin(), other.begin() + 33, other.end());
  EXPECT_LT(ComparisonType::ComputeDistance(tooth, other), 1e-2);
  std::reverse(other.begin(), other.end());
  EXPECT_LT(ComparisonType::ComputeDistance(tooth, other), 1e-2);
  EXPECT_LT(ComparisonType::ComputeDistance(tooth, MakeTooth(23.0, 7.0, 0.2, 203)), 0.03);
}

TEST(ToothOutlineComparison, RoundedPixelsAreNoHand)
{
  const LineType tooth = MakeTooth(23.0, 7.0, 0.2);
  const auto     rounded = [](LineType line, double pixel) {
    for (auto & p : line)
    {
      p = { { pixel * std::nearbyint(p[0] / pixel), pixel * std::nearbyint(p[1] / pixel) } };
    }
    return line;
  };
  EXPECT_LT(ComparisonType::ComputeDistance(rounded(tooth, 0.1), rounded(Move(tooth, 1.03, 0.2, 31.3, 4.1), 0.1)),
            ComparisonType::LargestDistance);
}

TEST(ToothOutlineComparison, WhatHandsDrewIsNotOneOutline)
{
  const LineType tooth = MakeTooth(23.0, 7.0, 0.2);
  for (std::uint64_t seed = 1; seed < 12; seed += 2)
  {
    // The same tooth, drawn twice by a careful hand: 0.1 mm.
    EXPECT_GT(ComparisonType::ComputeDistance(Draw(tooth, 0.1, seed), Draw(tooth, 0.1, seed + 1)),
              ComparisonType::LargestDistance);
  }
  EXPECT_GT(ComparisonType::ComputeDistance(tooth, MakeTooth(20.0, 7.0, 0.2)), ComparisonType::LargestDistance);
  EXPECT_GT(ComparisonType::ComputeDistance(tooth, MakeTooth(23.0, 7.0, -0.1)), ComparisonType::LargestDistance);
}

TEST(ToothOutlineComparison, WhatIsNoLineIsFarFromAll)
{
  const LineType tooth = MakeTooth(23.0, 7.0, 0.2);
  LineType       broken = tooth;
  broken[7][1] = std::numeric_limits<double>::quiet_NaN();
  const LineType flat(20, { { 1.0, 1.0 } });
  for (const LineType & line :
       { LineType{}, LineType{ { { 0.0, 0.0 } }, { { 1.0, 1.0 } }, { { 0.0, 1.0 } } }, flat, broken })
  {
    EXPECT_TRUE(std::isinf(ComparisonType::ComputeDistance(line, tooth)));
    EXPECT_TRUE(std::isinf(ComparisonType::ComputeDistance(tooth, line)));
    EXPECT_TRUE(ComparisonType::FindTemplates({ { "U1", line }, { "L1", tooth } }, {}).empty());
  }
}

TEST(ToothOutlineComparison, TemplatesAreNamedWithWhatTheyAre)
{
  const LineType                                 tooth = MakeTooth(23.0, 7.0, 0.2);
  const std::vector<ComparisonType::OutlineType> tracing{ { "U1", Move(tooth, 1.0, 0.4, 3.0, 4.0) },
                                                          { "U6", MakeTooth(20.0, 10.0, 0.4) },
                                                          { "L1", Move(tooth, 0.8, 2.9, 3.0, 14.0, true) } };
  const auto                                     found = ComparisonType::FindTemplates(tracing, {});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].name, "U1");
  EXPECT_EQ(found[0].of, "L1");
  EXPECT_LT(found[0].distance, 1e-3);
  EXPECT_EQ(found[1].name, "L1");
  EXPECT_EQ(found[1].of, "U1");
  // The nearest one is named; stock outlines are in whatever unit.
  const std::vector<ComparisonType::OutlineType> stock{ { "LR6 of the stock", MakeTooth(21.0, 11.0, 0.1) },
                                                        { "UR6 of the stock",
                                                          Move(MakeTooth(20.0, 10.0, 0.4), 37.0, 0.0, 500.0, 500.0) } };
  const auto                                     more = ComparisonType::FindTemplates(tracing, stock);
  ASSERT_EQ(more.size(), 3u);
  EXPECT_EQ(more[1].name, "U6");
  EXPECT_EQ(more[1].of, "UR6 of the stock");
  EXPECT_TRUE(ComparisonType::FindTemplates({ tracing[0], tracing[1] }, {}).empty());
  EXPECT_TRUE(ComparisonType::FindTemplates({}, stock).empty());
}
