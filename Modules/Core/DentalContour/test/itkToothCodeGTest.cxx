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
#include "itkToothCode.h"

#include <gtest/gtest.h>

#include <stdexcept>

using itk::ToothCode;

TEST(ToothCode, EveryToothSurvivesEveryNumbering)
{
  for (unsigned int universal = 1; universal <= 32; ++universal)
  {
    const auto code = ToothCode::FromString(std::to_string(universal), ToothCode::NumberingEnum::Universal);
    EXPECT_EQ(code.GetUniversal(), universal);
    EXPECT_EQ(ToothCode::FromString(code.GetName()), code);
    EXPECT_EQ(ToothCode::FromString(std::to_string(code.GetFDI()), ToothCode::NumberingEnum::FDI), code);
    EXPECT_EQ(code.GetContralateral().GetContralateral(), code);
    EXPECT_EQ(code.GetOpposing().GetOpposing(), code);
    EXPECT_EQ(code.GetOpposing().IsRight(), code.IsRight());
    EXPECT_EQ(code.GetOpposing().GetJaw(), itk::OtherJaw(code.GetJaw()));
    EXPECT_EQ(code.GetOpposing().GetPosition(), code.GetPosition());
    EXPECT_NE(code.IsRight(), code.IsLeft());
  }
}

TEST(ToothCode, KnownTeeth)
{
  EXPECT_EQ(ToothCode::FromString("1", ToothCode::NumberingEnum::Universal).GetName(), "UR8");
  EXPECT_EQ(ToothCode::FromString("16", ToothCode::NumberingEnum::Universal).GetName(), "UL8");
  EXPECT_EQ(ToothCode::FromString("17", ToothCode::NumberingEnum::Universal).GetName(), "LL8");
  EXPECT_EQ(ToothCode::FromString("32", ToothCode::NumberingEnum::Universal).GetName(), "LR8");
  EXPECT_EQ(ToothCode::FromString("46").GetName(), "LR6");
  EXPECT_EQ(ToothCode::FromString("ur1").GetFDI(), 11);
  EXPECT_EQ(ToothCode::FromString("LR6").GetJaw(), ToothCode::JawEnum::Lower);
  EXPECT_EQ(ToothCode::FromString("UL3").GetGroup(), ToothCode::GroupEnum::IncisorsAndCanines);
  EXPECT_EQ(ToothCode::FromString("UL4").GetGroup(), ToothCode::GroupEnum::Premolars);
  EXPECT_EQ(ToothCode::FromString("UL6").GetGroup(), ToothCode::GroupEnum::Molars);
  EXPECT_FALSE(ToothCode::FromString("").IsKnown());
}

TEST(ToothCode, RefusesWhatIsNoTooth)
{
  for (const char * text : { "19", "56", "91",  "UR0",   "UR9", "URF", "XX1",   "3",         "A", "0",     "111", "-1",
                             "UR", "U1", "UR-", "UR--1", "1.9", "1,1", "tooth", "tooth one", "#", "upper", " " })
  {
    EXPECT_THROW(ToothCode::FromString(text), std::invalid_argument) << text;
  }
  EXPECT_THROW(ToothCode::FromString("33", ToothCode::NumberingEnum::Universal), std::invalid_argument);
  EXPECT_THROW(ToothCode::FromString("U", ToothCode::NumberingEnum::Universal), std::invalid_argument);
  EXPECT_THROW(ToothCode(56), std::invalid_argument);
  EXPECT_THROW(ToothCode(256 + 11), std::invalid_argument);
  EXPECT_THROW(ToothCode::NumberingFromString("fdi "), std::invalid_argument);
}

TEST(ToothCode, PrimaryTeethSurviveEveryNumbering)
{
  const auto universal = ToothCode::NumberingEnum::Universal;
  for (const unsigned int quadrant : { 5u, 6u, 7u, 8u })
  {
    for (unsigned int position = 1; position <= 5; ++position)
    {
      const ToothCode code(10 * quadrant + position);
      EXPECT_TRUE(code.IsPrimary());
      EXPECT_EQ(code.GetQuadrant(), quadrant - 4);
      EXPECT_EQ(code.GetPosition(), position);
      EXPECT_EQ(code.GetUniversal(), 0u);
      EXPECT_EQ(ToothCode::FromString(code.GetName()), code);
      EXPECT_EQ(ToothCode::FromString(code.GetUniversalName(), universal), code);
      EXPECT_EQ(ToothCode::FromString(std::to_string(code.GetFDI())), code);
      EXPECT_NE(code.IsRight(), code.IsLeft());
      EXPECT_EQ(code.GetContralateral().GetContralateral(), code);
      EXPECT_TRUE(code.GetContralateral().IsPrimary());
      EXPECT_TRUE(code.GetOpposing().IsPrimary());
      EXPECT_EQ(code.GetOpposing().GetOpposing(), code);
      EXPECT_NE(code, ToothCode(10 * (quadrant - 4) + position));
    }
  }
  // The corners of the universal letters, as every chart has them.
  EXPECT_EQ(ToothCode::FromString("A", universal).GetName(), "URE");
  EXPECT_EQ(ToothCode::FromString("j", universal).GetFDI(), 65u);
  EXPECT_EQ(ToothCode::FromString("K", universal).GetFDI(), 75u);
  EXPECT_EQ(ToothCode::FromString("T", universal).GetName(), "LRE");
  EXPECT_EQ(ToothCode(74).GetJaw(), ToothCode::JawEnum::Lower);
  EXPECT_EQ(ToothCode(74).GetGroup(), ToothCode::GroupEnum::Molars);
  EXPECT_EQ(ToothCode(53).GetGroup(), ToothCode::GroupEnum::IncisorsAndCanines);
  EXPECT_EQ(ToothCode(16).GetUniversalName(), "3");
  EXPECT_FALSE(ToothCode(16).IsPrimary());
}

TEST(ToothCode, SpellingsThatPeopleUse)
{
  for (const char * text : { " UR1 ",
                             "ur1\r\n",
                             "UR-1",
                             "UR_1",
                             "ur 1",
                             "tooth 11",
                             "Tooth11",
                             "tooth_11",
                             "TOOTH UR1",
                             "1.1",
                             "tooth 1.1",
                             "#11",
                             "# 11",
                             "tooth #11",
                             "FDI 11",
                             "fdi_11" })
  {
    EXPECT_EQ(ToothCode::FromString(text).GetFDI(), 11u) << text;
    EXPECT_TRUE(ToothCode::IsWrittenAsCode(text)) << text;
  }
  // A numbering that says what digits are does not change what only FDI can mean.
  EXPECT_EQ(ToothCode::FromString("#8", ToothCode::NumberingEnum::Universal).GetFDI(), 11u);
  EXPECT_EQ(ToothCode::FromString("1.1", ToothCode::NumberingEnum::Universal).GetFDI(), 11u);
  EXPECT_EQ(ToothCode::FromString("FDI 21", ToothCode::NumberingEnum::Universal).GetFDI(), 21u);
  for (const char * text : { "19", "UR9", "3", "99", "tooth 99" })
  {
    EXPECT_TRUE(ToothCode::IsWrittenAsCode(text)) << text;
  }
  for (const char * text : { "soft tissue", "Calibration_30mm", "upper", "lips", "ulna", "" })
  {
    EXPECT_FALSE(ToothCode::IsWrittenAsCode(text)) << text;
  }
}

TEST(ToothCode, CodesWithoutASideAndJawsByWholeWords)
{
  EXPECT_EQ(ToothCode::FromSidelessString("U1").GetFDI(), 11u);
  EXPECT_EQ(ToothCode::FromSidelessString(" l6 ").GetFDI(), 46u);
  EXPECT_EQ(ToothCode::FromSidelessString("tooth U6").GetFDI(), 16u);
  for (const char * text : { "UR1", "11", "U9", "U", "", "U1 tip" })
  {
    EXPECT_FALSE(ToothCode::FromSidelessString(text).IsKnown()) << text;
  }
  for (const char * text : { "upper", "Upper", " maxilla ", "Upper_Jaw", "MAXILLARY arch" })
  {
    EXPECT_EQ(ToothCode::JawFromString(text), ToothCode::JawEnum::Upper) << text;
  }
  for (const char * text : { "lower", "Mandible", "lower-jaw", "mandibular" })
  {
    EXPECT_EQ(ToothCode::JawFromString(text), ToothCode::JawEnum::Lower) << text;
  }
  for (const char * text : { "", "u", "l", "uppercut", "11", "upper lip" })
  {
    EXPECT_EQ(ToothCode::JawFromString(text), ToothCode::JawEnum::Unknown) << text;
  }
}

TEST(ToothCode, AJawHasATextThatIsReadBackAndAnOpponent)
{
  using JawEnum = ToothCode::JawEnum;
  EXPECT_STREQ(ToString(JawEnum::Upper), "upper");
  EXPECT_STREQ(ToString(JawEnum::Lower), "lower");
  EXPECT_STREQ(ToString(JawEnum::Unknown), "unknown");
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    EXPECT_EQ(ToothCode::JawFromString(ToString(jaw)), jaw);
    EXPECT_EQ(ToothCode::JawFromString(ToCapitalizedString(jaw)), jaw);
    EXPECT_NE(OtherJaw(jaw), jaw);
    EXPECT_EQ(OtherJaw(OtherJaw(jaw)), jaw);
  }
  EXPECT_STREQ(ToCapitalizedString(JawEnum::Lower), "Lower");
  EXPECT_EQ(OtherJaw(JawEnum::Unknown), JawEnum::Unknown);
}
