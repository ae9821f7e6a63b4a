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
#include "itkTracedToothRow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using PointType = itk::DentalContour::PointType;
using PolylinesType = itk::DentalContour::PolylinesType;

/** The line of a tooth of the upper right quadrant between two places along a row that runs in a direction: a sagging
 * curve, which is longer than it is deep. */
itk::DentalContour::PolylineType
LineOf(std::uint8_t fdi, double low, double high, double angle = 0.0, unsigned int points = 21)
{
  itk::DentalContour::PolylineType line;
  line.code = itk::ToothCode(fdi);
  for (unsigned int i = 0; i < points; ++i)
  {
    const double share = i / (points - 1.0);
    const double along = low + share * (high - low);
    const double across = 4.0 * share * (1.0 - share);
    PointType    point;
    point[0] = std::cos(angle) * along - std::sin(angle) * across;
    point[1] = std::sin(angle) * along + std::cos(angle) * across;
    line.points.push_back(point);
  }
  return line;
}
} // namespace

TEST(TracedToothRow, KnowsHowFarEachToothReachesAlongTheRow)
{
  // Level, and tilted as a patient's head tilts it.
  for (const double angle : { 0.0, 0.3, -0.5 })
  {
    const itk::TracedToothRow row(PolylinesType{ LineOf(14, 0.0, 28.0, angle),
                                                 LineOf(15, 28.0, 56.0, angle),
                                                 LineOf(16, 56.0, 96.0, angle),
                                                 LineOf(17, 96.0, 136.0, angle) });
    const auto *              molar = row.Find(itk::ToothCode(16));
    ASSERT_NE(molar, nullptr);
    EXPECT_EQ(molar->points, 21u);
    EXPECT_NEAR(molar->GetExtent(), 40.0, 0.3);
    EXPECT_NEAR(molar->GetMiddle(), row.ToRow(std::cos(angle) * 76.0, std::sin(angle) * 76.0), 0.3);
    EXPECT_EQ(row.FindPosition(6), molar);
    EXPECT_EQ(row.Find(itk::ToothCode(26)), nullptr);
    EXPECT_EQ(row.FindPosition(8), nullptr);
    // The mesiobuccal cusp stands toward the front.
    const double cusp = row.GetPlace(*molar, -itk::TracedToothRow::CuspShare);
    EXPECT_NEAR(cusp, row.ToRow(std::cos(angle) * 66.4, std::sin(angle) * 66.4), 0.4);
  }
}

TEST(TracedToothRow, KnowsTheFrontWhicheverWayThePatientFaces)
{
  // The back at the higher end of the row, and at the lower one.
  const itk::TracedToothRow right(PolylinesType{ LineOf(15, 0.0, 30.0), LineOf(16, 30.0, 70.0) });
  const itk::TracedToothRow left(PolylinesType{ LineOf(15, 70.0, 100.0), LineOf(16, 30.0, 70.0) });
  const auto *              ofRight = right.Find(itk::ToothCode(16));
  const auto *              ofLeft = left.Find(itk::ToothCode(16));
  ASSERT_TRUE(ofRight != nullptr && ofLeft != nullptr);
  EXPECT_NEAR(right.GetPlace(*ofRight, -0.25), 40.0, 0.3);
  EXPECT_NEAR(left.GetPlace(*ofLeft, -0.25), 60.0, 0.3);
  // One tooth does not tell where the front is: its middle, whatever the share.
  const itk::TracedToothRow one(PolylinesType{ LineOf(16, 30.0, 70.0) });
  EXPECT_NEAR(one.GetPlace(*one.Find(itk::ToothCode(16)), -0.25), 50.0, 0.3);
}

TEST(TracedToothRow, LooksForAToothWithoutALineInTheGap)
{
  const PolylinesType       wide{ LineOf(14, 0.0, 30.0), LineOf(16, 60.0, 100.0) };
  const itk::TracedToothRow row(wide);
  const auto                gap = row.FindWithin(itk::ToothCode(15));
  ASSERT_TRUE(gap);
  EXPECT_NEAR(gap->low, 30.0, 0.3);
  EXPECT_NEAR(gap->high, 60.0, 0.3);
  EXPECT_EQ(row.Find(itk::ToothCode(15)), nullptr);
  // Of a tooth that was drawn it is the line.
  ASSERT_TRUE(row.FindWithin(itk::ToothCode(16)));
  EXPECT_NEAR(row.FindWithin(itk::ToothCode(16))->low, 60.0, 0.3);
  // One neighbour alone tells nothing, and neither does a gap that was closed.
  EXPECT_FALSE(row.FindWithin(itk::ToothCode(17)));
  EXPECT_FALSE(row.FindWithin(itk::ToothCode(13)));
  EXPECT_FALSE(
    itk::TracedToothRow(PolylinesType{ LineOf(14, 0.0, 30.0), LineOf(16, 40.0, 80.0) }).FindWithin(itk::ToothCode(15)));
}

TEST(TracedToothRow, TakesNoToothFromWhatDoesNotShowIt)
{
  // Both sides' sixth teeth are no single one; a few points say where a tooth is and not how far it reaches; points of
  // weight 0 count for nothing.
  const itk::TracedToothRow both(
    PolylinesType{ LineOf(15, 0.0, 30.0), LineOf(16, 30.0, 70.0), LineOf(26, 34.0, 74.0) });
  EXPECT_NE(both.Find(itk::ToothCode(16)), nullptr);
  EXPECT_NE(both.Find(itk::ToothCode(26)), nullptr);
  EXPECT_EQ(both.FindPosition(6), nullptr);
  EXPECT_NE(both.FindPosition(5), nullptr);

  const auto                few = static_cast<unsigned int>(itk::TracedToothRow::FewestPoints) - 1;
  const itk::TracedToothRow sparse(PolylinesType{ LineOf(15, 0.0, 30.0), LineOf(16, 30.0, 70.0, 0.0, few) });
  EXPECT_EQ(sparse.Find(itk::ToothCode(16)), nullptr);
  EXPECT_EQ(sparse.FindPosition(6), nullptr);

  auto half = LineOf(16, 30.0, 70.0);
  half.weights.assign(half.points.size(), 1.0);
  std::fill(half.weights.begin() + 11, half.weights.end(), 0.0);
  const itk::TracedToothRow weighted(PolylinesType{ LineOf(15, 0.0, 30.0), half });
  ASSERT_NE(weighted.Find(itk::ToothCode(16)), nullptr);
  EXPECT_NEAR(weighted.Find(itk::ToothCode(16))->GetExtent(), 20.0, 0.3);
  EXPECT_EQ(weighted.Find(itk::ToothCode(16))->points, 11u);
}
