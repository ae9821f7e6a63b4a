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
  for (const char * text : { "19", "51", "UR0", "UR9", "XX1", "3", "0", "111", "-1", "UR", " UR1" })
  {
    EXPECT_THROW(ToothCode::FromString(text), std::invalid_argument) << text;
  }
  EXPECT_THROW(ToothCode::FromString("33", ToothCode::NumberingEnum::Universal), std::invalid_argument);
  EXPECT_THROW(ToothCode(55), std::invalid_argument);
  EXPECT_THROW(ToothCode(256 + 11), std::invalid_argument);
  EXPECT_THROW(ToothCode::NumberingFromString("fdi "), std::invalid_argument);
}
