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
#include "itkLandmarkErrorFilter.h"

#include "itkMessageOfCall.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using itk::MessageOfCall;
using FilterType = itk::LandmarkErrorFilter;
using SetType = FilterType::LandmarkSetType;
using GroupEnum = itk::ToothCode::GroupEnum;
using JawEnum = itk::ToothCode::JawEnum;

struct NamedPoint
{
  const char * name;
  double       u;
  double       v;
};

SetType::Pointer
MakeSet(const std::vector<NamedPoint> & points)
{
  const auto set = SetType::New();
  for (const NamedPoint & named : points)
  {
    SetType::PointType point;
    point[0] = named.u;
    point[1] = named.v;
    set->AddLandmark(named.name, point);
  }
  return set;
}

FilterType::Pointer
MakeFilter(const std::vector<NamedPoint> & predicted, const std::vector<NamedPoint> & reference)
{
  const auto filter = FilterType::New();
  filter->SetPredictedLandmarks(MakeSet(predicted));
  filter->SetReferenceLandmarks(MakeSet(reference));
  return filter;
}

int
ExerciseBasicMethods()
{
  const auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, LandmarkErrorFilter, ProcessObject);
  return EXIT_SUCCESS;
}

const std::vector<NamedPoint> Reference = { { "UR1_tip", 100, 100 }, { "UR3_cusp", 80, 100 }, { "UR4_B", 60, 100 },
                                            { "UR6_MB", 40, 100 },   { "LR1_tip", 100, 120 }, { "LR7_MB", 20, 120 } };
// Off by (3, 4), (0, 1), (0, -2), (6, 8); (0, 7), (24, 7).
const std::vector<NamedPoint> Predicted = { { "LR7_MB", 44, 127 },   { "UR6_MB", 46, 108 },   { "UR4_B", 60, 98 },
                                            { "UR3_cusp", 80, 101 }, { "UR1_tip", 103, 104 }, { "LR1_tip", 100, 127 } };
} // namespace

TEST(LandmarkErrorFilter, BasicMethods)
{
  EXPECT_EQ(ExerciseBasicMethods(), EXIT_SUCCESS);
}

TEST(LandmarkErrorFilter, MeasuresEachJaw)
{
  const auto filter = MakeFilter(Predicted, Reference);
  filter->SetJaw(JawEnum::Upper);
  filter->Update();
  // 5, 1, 2, 10: mean 4.5, mean square 130/4.
  EXPECT_EQ(filter->GetStatistics().GetCount(), 4u);
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetMean(), 4.5);
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetRMSE(), std::sqrt(32.5));
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetStandardDeviation(), std::sqrt(32.5 - 20.25));
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetMean(GroupEnum::IncisorsAndCanines), 3.0);
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetMean(GroupEnum::Premolars), 2.0);
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetMean(GroupEnum::Molars), 10.0);
  EXPECT_TRUE(filter->GetUnpairedLandmarks().empty());
  filter->SetJaw(JawEnum::Lower);
  filter->Update();
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetMean(), 16.0);
  EXPECT_EQ(filter->GetStatistics().GetCount(GroupEnum::Premolars), 0u);
  filter->SetJaw(JawEnum::Unknown);
  filter->Update();
  EXPECT_EQ(filter->GetStatistics().GetCount(), 6u);
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetMean(), 50.0 / 6.0);
}

TEST(LandmarkErrorFilter, ListsErrorsInTheOrderOfTheReference)
{
  const auto filter = MakeFilter(Predicted, Reference);
  filter->Update();
  ASSERT_EQ(filter->GetErrors().size(), Reference.size());
  const double distances[] = { 5, 1, 2, 10, 7, 25 };
  for (std::size_t i = 0; i < Reference.size(); ++i)
  {
    EXPECT_EQ(filter->GetErrors()[i].name, Reference[i].name);
    EXPECT_EQ(filter->GetErrors()[i].tooth.GetName(), std::string(Reference[i].name, 3));
    EXPECT_DOUBLE_EQ(filter->GetErrors()[i].distance, distances[i]);
    EXPECT_FALSE(filter->GetErrors()[i].millimetres.has_value());
    EXPECT_EQ(filter->GetErrors()[i].reference[0], Reference[i].u);
  }
}

TEST(LandmarkErrorFilter, MillimetresUseTheSpacingOfEachAxis)
{
  const auto              filter = MakeFilter({ { "UR1_tip", 6, 4 } }, { { "UR1_tip", 0, 0 } });
  FilterType::SpacingType spacing;
  spacing[0] = 0.5;
  spacing[1] = 1.0;
  filter->SetPixelSpacing(spacing);
  filter->Update();
  EXPECT_DOUBLE_EQ(filter->GetErrors()[0].distance, std::sqrt(52.0));
  EXPECT_DOUBLE_EQ(*filter->GetErrors()[0].millimetres, 5.0);
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetMeanInMillimetres(), 5.0);
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetSuccessDetectionRate(4.0), 0.0);
  spacing[0] = 0.0;
  filter->SetPixelSpacing(spacing);
  EXPECT_NE(MessageOfCall([&]() { filter->Update(); }).find("SetPixelSpacing"), std::string::npos);
}

TEST(LandmarkErrorFilter, LandmarksOfOneSetAreListedAndNotCounted)
{
  const auto filter = MakeFilter({ { "UR1_tip", 1, 0 }, { "UR2_tip", 0, 0 }, { "LR2_tip", 0, 0 } },
                                 { { "UR1_tip", 0, 0 }, { "UR6_DB", 0, 0 } });
  filter->SetJaw(JawEnum::Upper);
  filter->Update();
  EXPECT_EQ(filter->GetStatistics().GetCount(), 1u);
  EXPECT_EQ(filter->GetUnpairedLandmarks(), (std::vector<std::string>{ "UR6_DB", "UR2_tip" }));
}

TEST(LandmarkErrorFilter, NothingInCommonIsACountOfZero)
{
  const auto filter = MakeFilter({ { "UR1_tip", 1, 0 } }, { { "LR1_tip", 0, 0 } });
  filter->Update();
  EXPECT_EQ(filter->GetStatistics().GetCount(), 0u);
  EXPECT_THROW(filter->GetStatistics().GetMean(), itk::ExceptionObject);
}

TEST(LandmarkErrorFilter, NamesOfAnotherNumberingAreTheSameLandmark)
{
  const auto filter = MakeFilter({ { "16_MB", 3, 4 } }, { { "UR6_MB", 0, 0 } });
  filter->Update();
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetMean(), 5.0);
  const auto twice = MakeFilter({ { "16_MB", 3, 4 }, { "UR6_MB", 3, 4 } }, { { "UR6_MB", 0, 0 } });
  EXPECT_NE(MessageOfCall([&]() { twice->Update(); }).find("16_MB and UR6_MB are the same one"), std::string::npos);
}

TEST(LandmarkErrorFilter, BisectedSidesMeasureTheMiddle)
{
  // The sides are off by (10, 3) and (-10, 5): the middle by (0, 4). The molar lacks its left one.
  const std::vector<NamedPoint> reference = {
    { "UL4_B", 50, 100 }, { "UR4_B", 60, 100 }, { "UR6_MB", 30, 100 }, { "UR1_tip", 0, 0 }, { "UL1_tip", 2, 0 }
  };
  const std::vector<NamedPoint> predicted = {
    { "UR4_B", 70, 103 }, { "UL4_B", 40, 105 }, { "UR6_MB", 31, 100 }, { "UR1_tip", 0, 1 }, { "UL1_tip", 2, 1 }
  };
  const auto filter = MakeFilter(predicted, reference);
  filter->BisectSidesOn();
  filter->Update();
  ASSERT_EQ(filter->GetErrors().size(), 2u);
  EXPECT_EQ(filter->GetErrors()[0].name, "UR4_B+UL4_B");
  EXPECT_EQ(filter->GetErrors()[0].tooth.GetName(), "UR4");
  EXPECT_DOUBLE_EQ(filter->GetErrors()[0].distance, 4.0);
  EXPECT_DOUBLE_EQ(filter->GetErrors()[1].distance, 1.0);
  EXPECT_DOUBLE_EQ(filter->GetStatistics().GetMean(), 2.5);
  EXPECT_EQ(filter->GetStatistics().GetCount(GroupEnum::Molars), 0u);
  EXPECT_EQ(filter->GetUnpairedLandmarks(), (std::vector<std::string>{ "UR6_MB" }));
  filter->BisectSidesOff();
  filter->Update();
  EXPECT_EQ(filter->GetErrors().size(), 5u);
}

TEST(LandmarkErrorFilter, RerunsOnlyWhenSomethingChanged)
{
  const auto filter = MakeFilter(Predicted, Reference);
  int        runs = 0;
  filter->AddObserver(itk::StartEvent(), [&runs](const itk::EventObject &) { ++runs; });
  filter->Update();
  const auto first = filter->GetStatistics();
  filter->Update();
  EXPECT_EQ(runs, 1);
  filter->SetJaw(JawEnum::Upper);
  filter->Update();
  EXPECT_EQ(runs, 2);
  filter->SetJaw(JawEnum::Unknown);
  filter->Update();
  EXPECT_EQ(filter->GetStatistics(), first);
}

TEST(LandmarkErrorFilter, SaysWhatIsMissingOrNotFinite)
{
  const auto filter = FilterType::New();
  EXPECT_NE(MessageOfCall([&]() { filter->Update(); }).find("SetPredictedLandmarks()"), std::string::npos);
  filter->SetPredictedLandmarks(MakeSet(Predicted));
  EXPECT_NE(MessageOfCall([&]() { filter->Update(); }).find("SetReferenceLandmarks()"), std::string::npos);
  filter->SetReferenceLandmarks(MakeSet({ { "UR4_B", std::numeric_limits<double>::quiet_NaN(), 0 } }));
  EXPECT_NE(MessageOfCall([&]() { filter->Update(); }).find("reference landmark UR4_B"), std::string::npos);
}
