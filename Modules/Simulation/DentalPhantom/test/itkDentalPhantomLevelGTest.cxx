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
#include "itkDentalPhantomLevel.h"
#include "itkMessageOfCall.h"

#include "itkDentalInputError.h"

#include <gtest/gtest.h>

#include <set>

namespace
{
using LevelType = itk::DentalPhantomLevel;

std::string
ErrorOf(const std::string & json)
{
  LevelType level;
  return itk::MessageOfCall([&] { level.ParseJson(json, "mine.json"); });
}

bool
Has(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}
} // namespace

TEST(DentalPhantomLevel, DefaultsAreTheTypicalCohort)
{
  EXPECT_EQ(LevelType(), LevelType::Named("typical"));
  EXPECT_EQ(LevelType().turnDegrees, 1.5);
  EXPECT_EQ(LevelType().correlatedNoise, 1.2);
  EXPECT_EQ(LevelType::Named("hard").lostToothProbability, 0.5);
  EXPECT_EQ(LevelType::Named("real").decimateTo, 16000u);
  // practice.md, section 1.
  const auto practice = LevelType::Named("practice");
  EXPECT_EQ(practice.toothAlong, 0.45);
  EXPECT_EQ(practice.toothAcross, 0.6);
  EXPECT_EQ(practice.toothTurnDegrees, 2.0);
  EXPECT_EQ(practice.toothScale, 0.03);
  EXPECT_EQ(practice.readerBias, 0.15);
  EXPECT_EQ(practice.grossProbability, 0.01);
  EXPECT_THROW(LevelType::Named("awful"), std::invalid_argument);
}

TEST(DentalPhantomLevel, EveryTableIsValidAndReadsBackFromItsOwnText)
{
  for (const std::string & name : LevelType::GetNames())
  {
    const LevelType level = LevelType::Named(name);
    EXPECT_NO_THROW(level.Validate()) << name;
    LevelType again;
    again.ParseJson(level.ToJson(), "text");
    EXPECT_EQ(again, level) << name;
  }
  // Whatever differs is written: change every number and switch, read it back.
  LevelType changed;
  for (const auto & entry : LevelType::GetEntries())
  {
    if (const auto number = std::get_if<double LevelType::*>(&entry.field))
    {
      changed.** number = entry.low + 0.37 * (entry.high - entry.low);
    }
    else if (const auto flag = std::get_if<bool LevelType::*>(&entry.field))
    {
      changed.** flag = !(changed.**flag);
    }
    else if (const auto count = std::get_if<unsigned int LevelType::*>(&entry.field))
    {
      changed.** count = static_cast<unsigned int>(entry.low) + 7;
    }
    else
    {
      changed.*std::get<std::string LevelType::*>(entry.field) = entry.words.back();
    }
  }
  LevelType again;
  again.ParseJson(changed.ToJson(), "text");
  EXPECT_EQ(again, changed);
  EXPECT_NE(again, LevelType());
}

TEST(DentalPhantomLevel, EveryParameterHasANameOfItsOwnAndWords)
{
  std::set<std::string> names;
  for (const auto & entry : LevelType::GetEntries())
  {
    EXPECT_TRUE(names.insert(std::string(entry.section) + "." + entry.key).second) << entry.key;
    EXPECT_GT(std::string(entry.description).size(), 7u) << entry.key;
  }
  EXPECT_GT(names.size(), 60u);
}

TEST(DentalPhantomLevel, AFileOverridesItsLevel)
{
  LevelType level;
  level.ParseJson("{\"level\": \"real\", \"traits\": {\"open_bite_probability\": 1}}", "mine.json");
  EXPECT_EQ(level.openBiteProbability, 1.0);
  EXPECT_EQ(level.decimateTo, 16000u);
  EXPECT_EQ(level.name, "real");
}

TEST(DentalPhantomLevel, ErrorsNameFileFieldAndRemedy)
{
  std::string error = ErrorOf("{\"traits\": {\"open_bite\": 1}}");
  EXPECT_TRUE(Has(error, "mine.json") && Has(error, "traits.open_bite") && Has(error, "open_bite_probability"))
    << error;
  error = ErrorOf("{\"teeth\": {}}");
  EXPECT_TRUE(Has(error, "teeth") && Has(error, "landmarks, frontal")) << error;
  error = ErrorOf("{\"traits\": {\"wear_probability\": 1.5}}");
  EXPECT_TRUE(Has(error, "traits.wear_probability") && Has(error, "1.5") && Has(error, "from 0 to 1")) << error;
  error = ErrorOf("{\"traits\": {\"wear_probability\": \"often\"}}");
  EXPECT_TRUE(Has(error, "traits.wear_probability") && Has(error, "number")) << error;
  error = ErrorOf("{\"scan\": {\"frame\": \"upside-down\"}}");
  EXPECT_TRUE(Has(error, "scan.frame") && Has(error, "upside-down") && Has(error, "centred")) << error;
  error = ErrorOf("{\"scan\": {\"triangles\": 10}}");
  EXPECT_TRUE(Has(error, "scan.triangles")) << error;
  error = ErrorOf("{\"level\": \"awful\"}");
  EXPECT_TRUE(Has(error, "awful") && Has(error, "practice")) << error;
  LevelType level;
  level.wearDepth = 9.0;
  EXPECT_THROW(level.Validate(), std::invalid_argument);
  level = LevelType();
  level.name = "mine";
  EXPECT_THROW(level.Validate(), std::invalid_argument);
}
