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
#include "itkCephalometricLandmarkSet.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace
{
using SetType = itk::CephalometricLandmarkSet;

std::string
Canonical(const std::string & name)
{
  const SetType::MeaningType meaning = SetType::ParseName(name);
  return meaning.position == 0 ? std::string("none") : SetType::MakeName(meaning);
}

std::string
ErrorOf(SetType * set, const std::string & name, double u, double sigma = 0.0)
{
  SetType::PointType point;
  point[0] = u;
  point[1] = 2.0;
  try
  {
    set->AddLandmark(name, point, sigma);
  }
  catch (const std::invalid_argument & error)
  {
    return error.what();
  }
  return {};
}
} // namespace

TEST(CephalometricLandmarkSet, KnowsTheNamesThatPointsHave)
{
  for (const char * name : { "U1",
                             "U1_tip",
                             "u1_TIP",
                             "U1T",
                             "UIT",
                             "UIE",
                             "Is",
                             "I",
                             "upper incisor tip",
                             "l12",
                             "U1 Incisal Edge",
                             "u1-incisal-tip",
                             "U1IncisalEdge" })
  {
    EXPECT_EQ(Canonical(name), "U1_tip") << name;
  }
  for (const char * name : { "L1", "L1_tip", "L1T", "LIT", "LIE", "Ii", "l11", " L1-tip " })
  {
    EXPECT_EQ(Canonical(name), "L1_tip") << name;
  }
  for (const char * name : { "U1A", "UIA", "U1_root", "U1_apex" })
  {
    EXPECT_EQ(Canonical(name), "U1_apex") << name;
  }
  EXPECT_EQ(Canonical("LIA"), "L1_apex");
  // Three points of a molar, and one of which the name does not say which.
  EXPECT_EQ(Canonical("Ms"), "U6_mesial");
  EXPECT_EQ(Canonical("Mi"), "L6_mesial");
  EXPECT_EQ(Canonical("U6_MB"), "U6_MB");
  EXPECT_EQ(Canonical("LMT"), "L6_MB");
  EXPECT_EQ(Canonical("U6_occlusal"), "U6_occlusal");
  EXPECT_EQ(Canonical("U6"), "U6");
  EXPECT_EQ(Canonical("UPM"), "U5_cusp");
  for (const char * name : { "U3", "U3_tip", "U3_cusp" })
  {
    EXPECT_EQ(Canonical(name), "U3_cusp") << name;
  }
  EXPECT_EQ(Canonical("UR6_MB"), "UR6_MB");
  EXPECT_EQ(Canonical("ll1_tip"), "LL1_tip");
  EXPECT_EQ(Canonical("UL4_B"), "UL4_cusp");
}

TEST(CephalometricLandmarkSet, KnowsNoOthers)
{
  for (const char * name :
       { "", "S", "N", "Me", "U", "U0", "U9_tip", "U6_tip", "U1_MB", "U1_", "Us", "lip", "LL", "upper", "U1_tipp" })
  {
    EXPECT_EQ(Canonical(name), "none") << name;
  }
}

TEST(CephalometricLandmarkSet, KeepsWhatItIsGivenAndSaysWhatItCannotTake)
{
  const auto         set = SetType::New();
  SetType::PointType point;
  point[0] = 3.0;
  point[1] = 4.0;
  set->AddLandmark("Is", point, 1.5, 0.7);
  ASSERT_NE(set->Find("U1_tip"), nullptr);
  EXPECT_EQ(set->Find("U1_tip")->name, "Is");
  EXPECT_EQ(set->Find("U1_tip")->sigma, 1.5);
  EXPECT_EQ(set->Find("U1_tip")->confidence, 0.7);
  EXPECT_EQ(set->Find("U6_MB"), nullptr);
  EXPECT_NE(ErrorOf(set, "Sella", 1.0).find("\"Sella\" is no dental landmark"), std::string::npos);
  EXPECT_NE(ErrorOf(set, "Is", 1.0).find("twice"), std::string::npos);
  EXPECT_NE(ErrorOf(set, "UIT", 1.0).find("same point as \"Is\""), std::string::npos);
  EXPECT_NE(ErrorOf(set, "Ii", std::numeric_limits<double>::quiet_NaN()).find("finite"), std::string::npos);
  EXPECT_NE(ErrorOf(set, "Ii", 1.0, -1.0).find("sigma"), std::string::npos);
  EXPECT_EQ(set->GetNumberOfLandmarks(), 1u);
  const auto other = SetType::New();
  other->Graft(set);
  EXPECT_EQ(other->GetNumberOfLandmarks(), 1u);
  other->Initialize();
  EXPECT_EQ(other->GetNumberOfLandmarks(), 0u);
}
