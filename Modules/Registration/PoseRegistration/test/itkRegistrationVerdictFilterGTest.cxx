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
#include "itkRegistrationVerdictFilter.h"

#include "itkMessageOfCall.h"
#include "itkPoseSolutionTestCase.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using itk::MessageOfCall;
using namespace PoseSolutionTestCase;
using FilterType = itk::RegistrationVerdictFilter;
using StatusEnum = itk::RegistrationVerdict::StatusEnum;

FilterType::Pointer
Judge(const itk::PoseRegistrationResult & result)
{
  auto filter = FilterType::New();
  filter->SetSolution(MakeSolution(result));
  filter->Update();
  return filter;
}

int
ExerciseBasicObjectMethods()
{
  const auto filter = Judge(MakeResult());
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, RegistrationVerdictFilter, ProcessObject);
  return EXIT_SUCCESS;
}
} // namespace

TEST(RegistrationVerdictFilter, BasicObjectMethods)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
}

TEST(RegistrationVerdictFilter, SaysWhatTheRulesSayOfEachJaw)
{
  auto result = MakeResult();
  result.jaws[1].fit.cost = 0.45;
  const auto filter = Judge(result);
  const auto expected = itk::RegistrationVerdict::Evaluate(result);
  EXPECT_EQ(filter->GetVerdict(JawEnum::Upper), expected[0]);
  EXPECT_EQ(filter->GetVerdict(JawEnum::Lower), expected[1]);
  EXPECT_EQ(filter->GetVerdict(JawEnum::Upper).status, StatusEnum::Ok);
  EXPECT_EQ(filter->GetVerdict(JawEnum::Lower).status, StatusEnum::Suspect);
  EXPECT_EQ(filter->GetNotCheckable(),
            itk::RegistrationVerdict::GetNotCheckable(result, itk::PoseRegistrationOptions()));
}

TEST(RegistrationVerdictFilter, AJawWithoutInputIsNoReasonToWorry)
{
  auto result = MakeResult();
  result.jaws.erase(result.jaws.begin());
  result.groups.erase(result.groups.begin());
  result.groups[0].jaws = { 0 };
  result.groupOfJaw = { 0 };
  result.jaws[0].registered = false;
  result.jaws[0].failure = "nothing to match";
  const auto filter = Judge(result);
  EXPECT_EQ(filter->GetVerdict(JawEnum::Upper), FilterType::JawVerdictType());
  EXPECT_EQ(filter->GetVerdict(JawEnum::Lower).status, StatusEnum::Failed);
}

TEST(RegistrationVerdictFilter, ThresholdsAreSettingsAndRunItAgain)
{
  const auto filter = Judge(MakeResult());
  EXPECT_EQ(filter->GetThresholds().suspectCost, 0.36);
  const auto time = filter->GetVerdictOutput(JawEnum::Upper)->GetUpdateMTime();
  filter->Update();
  EXPECT_EQ(filter->GetVerdictOutput(JawEnum::Upper)->GetUpdateMTime(), time) << "nothing changed, nothing runs";
  auto thresholds = filter->GetThresholds();
  thresholds.suspectCost = 0.05;
  filter->SetThresholds(thresholds);
  filter->Update();
  EXPECT_EQ(filter->GetVerdict(JawEnum::Upper).status, StatusEnum::Suspect);
}

TEST(RegistrationVerdictFilter, VerdictsThatDifferInAWordAreNotEqual)
{
  FilterType::JawVerdictType one;
  one.status = StatusEnum::Suspect;
  one.findings = { { StatusEnum::Suspect, "poor-fit", "a sentence", 3.1, 2.7, "px" } };
  auto other = one;
  EXPECT_EQ(one, other);
  other.findings[0].text = "another";
  EXPECT_NE(one, other);
  other = one;
  other.status = StatusEnum::Failed;
  EXPECT_NE(one, other);
}

TEST(RegistrationVerdictFilter, WithoutASolutionItSaysSo)
{
  const auto filter = FilterType::New();
  EXPECT_TRUE(Contains(MessageOfCall([&] { filter->Update(); }), "Solution"));
}
