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
#include "itkDentalPhantomAcquisition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace
{
using AcquisitionType = itk::DentalPhantomAcquisition;
using CohortEnum = AcquisitionType::CohortEnum;

constexpr int    Draws = 4000;
constexpr double Degree = 0.017453292519943295;

struct Statistics
{
  double yaw{ 0.0 };
  double roll{ 0.0 };
  double pitchMean{ 0.0 };
  double pitch{ 0.0 };
  int    missing{ 0 };
  int    missingLower{ 0 };
  int    untraced[2]{ 0, 0 };
};

Statistics
Collect(CohortEnum cohort)
{
  Statistics s;
  for (int seed = 0; seed < Draws; ++seed)
  {
    const auto a = AcquisitionType::Draw(seed, cohort);
    s.yaw += a.yaw * a.yaw / Draws;
    s.roll += a.roll * a.roll / Draws;
    s.pitchMean += a.pitch / Draws;
    s.pitch += (a.pitch - 8.0 * Degree) * (a.pitch - 8.0 * Degree) / Draws;
    s.missing += a.missingPosition != 0;
    s.missingLower += a.missingPosition != 0 && a.missingJaw == 1;
    s.untraced[0] += a.untracedPosition[0] != 0;
    s.untraced[1] += a.untracedPosition[1] != 0;
  }
  s.yaw = std::sqrt(s.yaw) / Degree;
  s.roll = std::sqrt(s.roll) / Degree;
  s.pitchMean /= Degree;
  s.pitch = std::sqrt(s.pitch) / Degree;
  return s;
}
} // namespace

// The standard error of an sd over 4000 draws is 1.1 %, of a share of one half 0.8 %; four of them are allowed.
TEST(DentalPhantomAcquisition, TypicalCohortIsAsDefined)
{
  const Statistics s = Collect(CohortEnum::Typical);
  EXPECT_NEAR(s.yaw, 1.5, 0.07);
  EXPECT_NEAR(s.roll, 1.5, 0.07);
  EXPECT_NEAR(s.pitchMean, 8.0, 0.35);
  EXPECT_NEAR(s.pitch, 5.0, 0.25);
  EXPECT_EQ(s.missing, 0);
  EXPECT_EQ(s.untraced[0] + s.untraced[1], 0);
  std::map<double, int> distances;
  for (int seed = 0; seed < Draws; ++seed)
  {
    const auto a = AcquisitionType::Draw(seed, CohortEnum::Typical);
    ++distances[a.trueSourceToMidsagittal];
    const double gap = a.trueSourceToDetector - a.trueSourceToMidsagittal;
    EXPECT_TRUE(gap >= 110.0 && gap <= 190.0) << gap;
    EXPECT_EQ(a.givenSourceToMidsagittal, 1524.0);
    EXPECT_EQ(a.givenSourceToDetector, 1674.0);
    EXPECT_TRUE(a.pixelSpacing >= 0.24 && a.pixelSpacing <= 0.26);
    EXPECT_TRUE(a.correlationLength >= 10.0 && a.correlationLength <= 20.0);
    EXPECT_EQ(a.correlatedNoise, 1.2);
    EXPECT_EQ(a.whiteNoise, 0.5);
    EXPECT_EQ(a.toothRotationDegrees, 5.0);
    // Ear rods 10 to 120 mm from the teeth.
    const double away = std::hypot(a.anterior, a.down);
    EXPECT_TRUE(away > 10.0 && away < 120.0);
  }
  ASSERT_EQ(distances.size(), 3u);
  for (const double distance : { 1500.0, 1524.0, 1650.0 })
  {
    EXPECT_NEAR(distances[distance], Draws / 3.0, 120.0);
  }
}

TEST(DentalPhantomAcquisition, HardCohortIsAsDefined)
{
  const Statistics s = Collect(CohortEnum::Hard);
  EXPECT_NEAR(s.yaw, 3.0, 0.14);
  EXPECT_NEAR(s.roll, 3.0, 0.14);
  EXPECT_NEAR(s.missing, Draws / 2, 130);
  EXPECT_NEAR(s.missingLower, Draws / 4, 130);
  EXPECT_NEAR(s.untraced[0], Draws / 2, 130);
  EXPECT_NEAR(s.untraced[1], Draws / 2, 130);
  const auto a = AcquisitionType::Draw(1, CohortEnum::Hard);
  EXPECT_EQ(a.correlatedNoise, 2.2);
  EXPECT_EQ(a.whiteNoise, 1.0);
  EXPECT_EQ(a.toothRotationDegrees, 9.0);
}

TEST(DentalPhantomAcquisition, IdealCohortIsKnownAndStill)
{
  for (int seed = 0; seed < 100; ++seed)
  {
    const auto a = AcquisitionType::Draw(seed, CohortEnum::Ideal);
    EXPECT_EQ(a.yaw, 0.0);
    EXPECT_EQ(a.roll, 0.0);
    EXPECT_EQ(a.anterior, 0.0);
    EXPECT_EQ(a.down, 0.0);
    EXPECT_EQ(a.givenSourceToMidsagittal, a.trueSourceToMidsagittal);
    EXPECT_EQ(a.givenSourceToDetector, a.trueSourceToDetector);
    EXPECT_EQ(a.correlatedNoise, 0.0);
    EXPECT_EQ(a.whiteNoise, 0.0);
    EXPECT_EQ(a.missingPosition, 0u);
  }
}
