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

#include "itkLBFGSBOptimizerv4.h"

#include "itkGTest.h"

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
} // namespace

TEST(PartialContourLeastSquares, ConvergesInAFewIterationsAndReportsThem)
{
  const auto start = MakeStart();
  const auto metric = MakeMetric(start);
  const auto optimizer = OptimizerType::New();
  optimizer->SetMetric(metric);
  unsigned int        iterations = 0;
  unsigned int        evaluations = 0;
  unsigned int        starts = 0;
  unsigned int        ends = 0;
  std::vector<double> values;
  optimizer->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    ++evaluations;
    iterations += optimizer->GetStepAccepted() ? 1 : 0;
    EXPECT_EQ(optimizer->GetNumberOfEvaluations(), evaluations);
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
  EXPECT_GE(evaluations, iterations);
  EXPECT_TRUE(std::is_sorted(values.rbegin(), values.rend()));
  EXPECT_LT(MeanError(start, 0.2, 0.8), 0.3);
  EXPECT_EQ(optimizer->GetCurrentMetricValue(), metric->GetValue());
  EXPECT_NE(optimizer->GetStopConditionDescription().find("LevenbergMarquardtOptimizerv4: "), std::string::npos);
  EXPECT_NE(optimizer->GetStopConditionDescription().find("tolerance"), std::string::npos)
    << optimizer->GetStopConditionDescription();
}

TEST(PartialContourLeastSquares, StopsAtTheMaximumNumberOfIterationsAtTheBestPosition)
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

TEST(PartialContourLeastSquares, FindsTheMinimumWithinTheBoundsThatABoundedOptimizerFinds)
{
  // The minimum without bounds lies at about (1.9, 2.1, -3.6, 4.4).
  const double bounds[][4] = { { 1.0, 1.0, 1.0, 1.0 },
                               { 2.0, 2.0, 2.0, 2.0 },
                               { 1.0, 9.0, 9.0, 9.0 },
                               { 0.0, 0.0, 2.0, 2.0 },
                               { 0.0, 0.0, 9.0, 4.0 } };
  for (const auto & bound : bounds)
  {
    ParametersType lower(4);
    ParametersType upper(4);
    for (unsigned int k = 0; k < 4; ++k)
    {
      lower[k] = -bound[k];
      upper[k] = bound[k];
    }
    const auto metric = MakeMetric(MakeStart());
    metric->SetBounds(lower, upper);
    const auto optimizer = OptimizerType::New();
    optimizer->SetMetric(metric);
    optimizer->StartOptimization();
    EXPECT_TRUE(optimizer->HasConverged()) << optimizer->GetStopConditionDescription();
    for (unsigned int k = 0; k < 4; ++k)
    {
      EXPECT_LT(std::abs(metric->GetBestParameters()[k]), bound[k] + 1e-6);
    }

    const auto peer = MakeMetric(MakeStart());
    peer->SetBounds(lower, upper);
    const auto                                 bounded = itk::LBFGSBOptimizerv4::New();
    itk::LBFGSBOptimizerv4::BoundSelectionType selection(4);
    selection.Fill(itk::LBFGSBOptimizerv4::BOTHBOUNDED);
    ParametersType origin(4);
    origin.Fill(0.0);
    bounded->SetMetric(peer);
    bounded->SetBoundSelection(selection);
    bounded->SetLowerBound(lower);
    bounded->SetUpperBound(upper);
    bounded->SetInitialPosition(origin);
    bounded->SetCostFunctionConvergenceFactor(10.0);
    bounded->StartOptimization();
    // Both stop in a flat valley, a little apart.
    EXPECT_NEAR(metric->GetValue(), peer->GetBestValue(), 1e-3 * peer->GetBestValue());
  }
}

TEST(PartialContourLeastSquares, SaysWhichMetricsItTakes)
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

TEST(PartialContourLeastSquares, RunsInSeveralThreadsWithTheSameBits)
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
