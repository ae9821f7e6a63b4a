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
#include "itkRegistrationIterationCommand.h"

#include "itkContourChamferMetricv4.h"
#include "itkSilhouetteToContourRegistrationMethod.h"
#include "itkSyntheticContours.h"

#include "itkLBFGSBOptimizerv4.h"

#include "itkGTest.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace
{
// What RegistrationCommon's tests of it cannot show: that this registration tells all of it.
using namespace SyntheticContours;
using CommandType = itk::RegistrationIterationCommand;
using KindEnum = CommandType::KindEnum;
using MethodType = itk::SilhouetteToContourRegistrationMethod;

MethodType::Pointer
MakeMethod()
{
  const auto method = MethodType::New();
  method->SetFixedContour(MakeTracing(MakeTransform(1.1, 0.1, 410.0, 490.0)));
  method->SetMovingContour(MakeSilhouette());
  return method;
}
} // namespace

TEST(RegistrationIterationCommand, RecordsLevelsIterationsAndStopReasons)
{
  const auto method = MakeMethod();
  const auto command = CommandType::New();
  command->Observe(method);
  method->Update();
  const auto & records = command->GetRecords();
  ASSERT_GT(records.size(), 5u);
  EXPECT_EQ(records.front().kind, KindEnum::Start);
  EXPECT_EQ(records[1].kind, KindEnum::Level);
  EXPECT_EQ(records[1].level, 0u);
  EXPECT_EQ(records[2].kind, KindEnum::Iteration);
  EXPECT_EQ(records[2].iteration, 1u);
  EXPECT_EQ(records[2].parameters.GetSize(), 4u);
  EXPECT_EQ(records.back().kind, KindEnum::End);
  EXPECT_EQ(records.back().value, method->GetMetricValue());
  EXPECT_EQ(records.back().parameters, method->GetTransform()->GetParameters());
  EXPECT_FALSE(records.back().stopReason.empty());
  std::size_t iterations = 0;
  std::size_t levels = 0;
  for (const auto & record : records)
  {
    iterations += static_cast<std::size_t>(record.kind == KindEnum::Iteration);
    levels += static_cast<std::size_t>(record.kind == KindEnum::Level);
  }
  EXPECT_EQ(levels, 3u);
  std::size_t expected = 0;
  for (const auto & result : method->GetLevelResults())
  {
    expected += result.numberOfIterations;
  }
  EXPECT_EQ(iterations, expected);
}

TEST(RegistrationIterationCommand, StartsAnewWithEveryRun)
{
  const auto method = MakeMethod();
  const auto command = CommandType::New();
  command->Observe(method);
  method->Update();
  const std::size_t count = command->GetRecords().size();
  method->Modified();
  method->Update();
  EXPECT_EQ(command->GetRecords().size(), count);
}

TEST(RegistrationIterationCommand, WritesOnlyToTheStreamItIsGiven)
{
  const auto         method = MakeMethod();
  const auto         command = CommandType::New();
  std::ostringstream text;
  command->Observe(method);
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  method->Update();
  EXPECT_TRUE(::testing::internal::GetCapturedStdout().empty());
  EXPECT_TRUE(::testing::internal::GetCapturedStderr().empty());
  command->SetStream(&text);
  method->Modified();
  method->Update();
  EXPECT_EQ(text.str().substr(0, 6), "start\n");
  EXPECT_NE(text.str().find("level 0 iteration 1 value "), std::string::npos);
  EXPECT_NE(text.str().find("\nend level 2"), std::string::npos);
  const std::string written = text.str();
  EXPECT_EQ(std::count(written.begin(), written.end(), '\n'),
            static_cast<std::ptrdiff_t>(command->GetRecords().size()));
  text.str("");
  command->SetWriteEvery(10);
  method->Modified();
  method->Update();
  EXPECT_LT(text.str().size(), written.size());
  EXPECT_THROW(command->SetWriteEvery(0), itk::ExceptionObject);
  EXPECT_THROW(command->Observe(nullptr), itk::ExceptionObject);
}

TEST(RegistrationIterationCommand, CountsIterationsOfABareOptimizerNotEvaluations)
{
  const auto metric = itk::ContourChamferMetricv4::New();
  metric->SetFixedContour(MakeTracing(MakeTransform(1.1, 0.1, 410.0, 490.0)));
  metric->SetMovingContour(MakeSilhouette());
  metric->SetMovingTransform(MakeTransform(1.05, 0.05, 405.0, 495.0));
  metric->Initialize();
  const auto                                 optimizer = itk::LBFGSBOptimizerv4::New();
  itk::LBFGSBOptimizerv4::BoundSelectionType selection(4);
  selection.Fill(itk::LBFGSBOptimizerv4::UNBOUNDED);
  optimizer->SetBoundSelection(selection);
  optimizer->SetNumberOfIterations(5);
  optimizer->SetMetric(metric);
  const auto command = CommandType::New();
  command->Observe(optimizer);
  optimizer->StartOptimization();
  std::size_t iterations = 0;
  for (const auto & record : command->GetRecords())
  {
    iterations += static_cast<std::size_t>(record.kind == KindEnum::Iteration);
  }
  EXPECT_EQ(iterations, 5u);
  EXPECT_EQ(command->GetRecords().back().kind, KindEnum::End);
  EXPECT_FALSE(command->GetRecords().back().stopReason.empty());
}

TEST(RegistrationIterationCommand, WritesARowForEachIterationWithItsCandidateAndStep)
{
  const auto method = MakeMethod();
  const auto command = CommandType::New();
  command->Observe(method);
  method->Update();
  std::ostringstream text;
  command->WriteTable(text);
  std::istringstream table(text.str());
  std::string        line;
  std::getline(table, line);
  EXPECT_EQ(line, "level,candidate,iteration,value,step_length,accepted,p0,p1,p2,p3");
  std::size_t  rows = 0;
  unsigned int candidates = 0;
  for (const auto & record : command->GetRecords())
  {
    if (record.kind != KindEnum::Iteration)
    {
      continue;
    }
    ++rows;
    candidates = std::max(candidates, record.candidate);
    EXPECT_TRUE(record.accepted);
    EXPECT_GT(record.stepLength, 0.0);
    ASSERT_TRUE(std::getline(table, line));
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 9);
    EXPECT_EQ(line.substr(0, 2), std::to_string(record.level) + ",");
  }
  EXPECT_GT(rows, 5u);
  // The coarse level has several starts.
  EXPECT_GT(candidates, 0u);
  EXPECT_FALSE(std::getline(table, line));
}
