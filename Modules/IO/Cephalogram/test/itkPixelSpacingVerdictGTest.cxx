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
#include "itkPixelSpacingVerdict.h"

#include <gtest/gtest.h>

#include <sstream>

using Verdict = itk::PixelSpacingVerdictEnum;
using Plane = itk::SpacingPlaneEnum;

namespace
{
using Pair = std::array<double, 2>;

itk::PixelSpacingDecision
Decide(std::optional<Pair>   imager,
       std::optional<Pair>   pixel,
       std::optional<double> factor = std::nullopt,
       const std::string &   type = {},
       const std::string &   description = {})
{
  return itk::DecidePixelSpacing({ imager, pixel, factor, type, description });
}
} // namespace

TEST(PixelSpacingVerdict, OnlyPixelSpacingIsUnknown)
{
  EXPECT_EQ(Decide(std::nullopt, Pair{ 0.1, 0.1 }).verdict, Verdict::Unknown);
  // Nor does a factor or a calibration say what it would be about.
  const auto decision = Decide(std::nullopt, Pair{ 0.1, 0.1 }, 1.1, "FIDUCIAL", "ruler");
  EXPECT_EQ(decision.verdict, Verdict::Unknown);
  EXPECT_EQ(decision.plane, Plane::Unknown);
  EXPECT_FALSE(decision.spacing);
  EXPECT_NE(decision.reason.find("(0028,0030)"), std::string::npos);
}

TEST(PixelSpacingVerdict, NothingIsUnknown)
{
  const auto decision = Decide(std::nullopt, std::nullopt, 1.1);
  EXPECT_EQ(decision.verdict, Verdict::Unknown);
  EXPECT_FALSE(decision.spacing);
}

TEST(PixelSpacingVerdict, OnlyImagerPixelSpacingIsTheDetectorsInImageAxes)
{
  const auto decision = Decide(Pair{ 0.1, 0.2 }, std::nullopt);
  EXPECT_EQ(decision.verdict, Verdict::Detector);
  EXPECT_EQ(decision.plane, Plane::Detector);
  // The file has row\column, that is the distance down first; the image has u first.
  EXPECT_EQ(decision.spacing.value(), (Pair{ 0.2, 0.1 }));
}

TEST(PixelSpacingVerdict, AFactorDivides)
{
  const auto decision = Decide(Pair{ 0.11, 0.22 }, std::nullopt, 1.1);
  EXPECT_EQ(decision.verdict, Verdict::EstimatedMagnification);
  EXPECT_EQ(decision.plane, Plane::Midsagittal);
  EXPECT_DOUBLE_EQ(decision.spacing.value()[0], 0.2);
  EXPECT_DOUBLE_EQ(decision.spacing.value()[1], 0.1);
  EXPECT_NE(decision.reason.find("(0018,1114) 1.1"), std::string::npos);
}

TEST(PixelSpacingVerdict, BothEqualIsTheDetectors)
{
  for (const double digits : { 0.1389, 0.13889 })
  {
    const auto decision = Decide(Pair{ 0.13889, 0.13889 }, Pair{ digits, digits }, 1.1, "GEOMETRY");
    EXPECT_EQ(decision.verdict, Verdict::Detector) << digits;
    EXPECT_EQ(decision.spacing.value(), (Pair{ 0.13889, 0.13889 }));
  }
}

TEST(PixelSpacingVerdict, DifferentWithAStatementIsCalibrated)
{
  for (const auto & [type, description] :
       { std::make_pair("FIDUCIAL", ""), std::make_pair("", "ear rods"), std::make_pair("GEOMETRY", "x") })
  {
    const auto decision = Decide(Pair{ 0.1, 0.2 }, Pair{ 0.09, 0.18 }, 1.11, type, description);
    EXPECT_EQ(decision.verdict, Verdict::Calibrated);
    EXPECT_EQ(decision.plane, Plane::Midsagittal);
    EXPECT_EQ(decision.spacing.value(), (Pair{ 0.18, 0.09 }));
  }
}

TEST(PixelSpacingVerdict, DifferentWithoutAStatementIsUnknown)
{
  const auto decision = Decide(Pair{ 0.1, 0.1 }, Pair{ 0.09, 0.09 }, 1.11);
  EXPECT_EQ(decision.verdict, Verdict::Unknown);
  EXPECT_FALSE(decision.spacing);
  // One axis that differs is enough.
  EXPECT_EQ(Decide(Pair{ 0.1, 0.1 }, Pair{ 0.1, 0.11 }).verdict, Verdict::Unknown);
  EXPECT_EQ(Decide(Pair{ 0.1, 0.1 }, Pair{ 0.11, 0.1 }).verdict, Verdict::Unknown);
}

TEST(PixelSpacingVerdict, PrintsWords)
{
  std::ostringstream os;
  os << Verdict::EstimatedMagnification << ' ' << Verdict::Unknown << ' ' << Plane::Midsagittal;
  EXPECT_EQ(os.str(), "EstimatedMagnification Unknown midsagittal");
}
