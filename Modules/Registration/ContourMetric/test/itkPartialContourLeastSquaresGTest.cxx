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
#include "itkPartialContourTestCase.h"

#include "itkContourChamferMetricv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"

#include "itkGTest.h"
#include "itkTestingMacros.h"

#include <thread>

using namespace PartialContourTestCase;

namespace
{
using OptimizerType = itk::LevenbergMarquardtOptimizerv4;

MetricType::Pointer
MakeMetric(TransformType * start)
{
  const auto metric = MetricType::New();
  metric->SetFixedContour(MakeFixed(0.2, 0.8, 0.3, 0.0));
  metric->SetMovingContour(MakeMoving());
  metric->SetMovingTransform(start);
  metric->SetKernelWidth(10.0);
  metric->Initialize();
  return metric;
}

TransformType::Pointer
MakeStart()
{
  return MakeTransform(1.04, 0.05, 313.0, 416.0);
}

int
ExerciseBasicObjectMethods()
{
  const auto optimizer = OptimizerType::New();
  optimizer->SetMetric(MakeMetric(MakeStart()));
  ITK_EXERCISE_BASIC_OBJECT_METHODS(optimizer, LevenbergMarquardtOptimizerv4, ObjectToObjectOptimizerBaseTemplate);
  return EXIT_SUCCESS;
}
} // namespace

TEST(LevenbergMarquardtOptimizerv4, BasicObjectMethods)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
}

TEST(LevenbergMarquardtOptimizerv4, ConvergesInAFewIterationsAndReportsThem)
{
  const auto start = MakeStart();
  const auto metric = MakeMetric(start);
  const auto optimizer = OptimizerType::New();
  optimizer->SetMetric(metric);
  unsigned int        iterations = 0;
  unsigned int        starts = 0;
  unsigned int        ends = 0;
  std::vector<double> values;
  optimizer->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    ++iterations;
    EXPECT_EQ(optimizer->GetCurrentIteration(), iterations);
    values.push_back(optimizer->GetCurrentMetricValue());
    EXPECT_NEAR(metric->EvaluateAt(optimizer->GetCurrentPosition()), values.back(), 1e-12);
  });
  optimizer->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++starts; });
  optimizer->AddObserver(itk::EndEvent(), [&](const itk::EventObject &) { ++ends; });
  optimizer->StartOptimization();
  EXPECT_EQ(starts, 1u);
  EXPECT_EQ(ends, 1u);
  EXPECT_GE(iterations, 3u);
  EXPECT_LE(iterations, 25u);
  EXPECT_GE(optimizer->GetNumberOfEvaluations(), iterations);
  EXPECT_TRUE(std::is_sorted(values.rbegin(), values.rend()));
  EXPECT_LT(MeanError(start, 0.2, 0.8), 0.3);
  EXPECT_EQ(optimizer->GetCurrentMetricValue(), metric->GetValue());
  EXPECT_NE(optimizer->GetStopConditionDescription().find("LevenbergMarquardtOptimizerv4: "), std::string::npos);
  EXPECT_NE(optimizer->GetStopConditionDescription().find("tolerance"), std::string::npos)
    << optimizer->GetStopConditionDescription();
}

TEST(LevenbergMarquardtOptimizerv4, StopsAtTheMaximumNumberOfIterationsAtTheBestPosition)
{
  for (const itk::SizeValueType maximum : { 0, 1, 2 })
  {
    const auto metric = MakeMetric(MakeStart());
    const auto optimizer = OptimizerType::New();
    optimizer->SetMetric(metric);
    optimizer->SetNumberOfIterations(maximum);
    const double before = metric->GetValue();
    optimizer->StartOptimization();
    EXPECT_EQ(optimizer->GetCurrentIteration(), maximum);
    EXPECT_EQ(optimizer->GetCurrentMetricValue() < before, maximum > 0);
    EXPECT_EQ(metric->GetValue(), metric->GetBestValue());
    EXPECT_NE(optimizer->GetStopConditionDescription().find("Maximum number of iterations"), std::string::npos);
  }
}

TEST(LevenbergMarquardtOptimizerv4, StaysWithinTheMetricsBounds)
{
  const auto     metric = MakeMetric(MakeStart());
  ParametersType lower(4);
  ParametersType upper(4);
  lower.Fill(-1.0);
  upper.Fill(1.0);
  metric->SetBounds(lower, upper);
  const auto optimizer = OptimizerType::New();
  optimizer->SetMetric(metric);
  optimizer->StartOptimization();
  // The minimum lies some 4 px away; the least-squares penalty may leave a little of the excess.
  for (unsigned int k = 0; k < 4; ++k)
  {
    EXPECT_LT(std::abs(metric->GetBestParameters()[k]), 1.01);
  }
}

TEST(LevenbergMarquardtOptimizerv4, PassesOnWhatAnObserverThrows)
{
  const auto optimizer = OptimizerType::New();
  optimizer->SetMetric(MakeMetric(MakeStart()));
  const auto tag =
    optimizer->AddObserver(itk::IterationEvent(), [](const itk::EventObject &) { itkGenericExceptionMacro("enough"); });
  EXPECT_THROW(optimizer->StartOptimization(), itk::ExceptionObject);
  EXPECT_EQ(optimizer->GetCurrentIteration(), 1u);
  optimizer->RemoveObserver(tag);
  EXPECT_NO_THROW(optimizer->StartOptimization());
}

TEST(LevenbergMarquardtOptimizerv4, SaysWhichMetricsItTakes)
{
  const auto optimizer = OptimizerType::New();
  EXPECT_THROW(optimizer->StartOptimization(), itk::ExceptionObject);
  const auto chamfer = itk::ContourChamferMetricv4::New();
  chamfer->SetFixedContour(MakeFixed(0.2, 0.8, 0.0, 0.0));
  chamfer->SetMovingContour(MakeMoving());
  chamfer->Initialize();
  optimizer->SetMetric(chamfer);
  EXPECT_THROW(optimizer->StartOptimization(), itk::ExceptionObject);
}

TEST(LevenbergMarquardtOptimizerv4, RunsInSeveralThreadsWithTheSameBits)
{
  const auto run = [](ParametersType & result) {
    const auto start = MakeStart();
    const auto optimizer = OptimizerType::New();
    optimizer->SetMetric(MakeMetric(start));
    optimizer->StartOptimization();
    result = start->GetParameters();
  };
  ParametersType expected;
  run(expected);
  std::vector<ParametersType> results(4);
  std::vector<std::thread>    threads;
  for (auto & result : results)
  {
    threads.emplace_back([&run, &result] { run(result); });
  }
  for (auto & thread : threads)
  {
    thread.join();
  }
  for (const auto & result : results)
  {
    EXPECT_EQ(result, expected);
  }
}
