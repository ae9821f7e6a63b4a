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
// First include the header file to be tested.
#include "itkLeastSquaresFunctionMetricv4.h"

#include "itkMessageOfCall.h"
#include "itkCurveFitMetric.h"
#include "itkLeastSquaresMetricChecker.h"
#include "itkLeastSquaresSumMetricv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

// Residuals of a user's own, given by a function alone.
namespace
{
using MetricType = itk::LeastSquaresFunctionMetricv4;

/** The metric that CurveFitMetric is as a class. */
MetricType::Pointer
MakeCurveFit()
{
  auto metric = MetricType::New();
  metric->SetBlocks({ { "curve", { { "a", 2.3, 1.0, 0.0, true }, { "b", 0.2, 8.0, 0.25, true } } } });
  metric->SetFunction([](const std::vector<double> & x) {
    const std::vector<double> ordinates{ 2.1, 2.6, 3.6, 4.7, 6.2 };
    std::vector<double>       residuals;
    for (std::size_t i = 0; i < ordinates.size(); ++i)
    {
      residuals.push_back((x[0] * std::exp(x[1] * static_cast<double>(i)) - ordinates[i]) / 0.5);
    }
    return residuals;
  });
  return metric;
}

int
ExerciseBasicObjectMethods()
{
  const auto metric = MetricType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(metric, LeastSquaresFunctionMetricv4, LeastSquaresMetricv4);
  return EXIT_SUCCESS;
}

std::string
MessageOf(MetricType * metric)
{
  return itk::MessageOfCall([&] {
    metric->Initialize();
    metric->GetValue();
  });
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}
} // namespace

TEST(LeastSquaresFunctionMetricv4, BasicObjectMethods)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
}

TEST(LeastSquaresFunctionMetricv4, KeepsWhatEveryTermPromises)
{
  const auto metric = MakeCurveFit();
  EXPECT_EQ(metric->GetNumberOfResiduals(), 5u) << "also before it is initialized";
  metric->Initialize();
  LeastSquaresMetricChecker::Check(*metric);
}

TEST(LeastSquaresFunctionMetricv4, GivesTheMinimumOfTheSameMetricAsAClass)
{
  std::vector<std::vector<double>> minima;
  for (itk::LeastSquaresMetricv4::Pointer metric : { itk::LeastSquaresMetricv4::Pointer(MakeCurveFit()),
                                                     itk::LeastSquaresMetricv4::Pointer(CurveFitMetric::New()) })
  {
    // A clone: candidates of a registration work on nothing else.
    const auto                               object = metric->Clone();
    const itk::LeastSquaresMetricv4::Pointer clone = dynamic_cast<itk::LeastSquaresMetricv4 *>(object.GetPointer());
    clone->Initialize();
    auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
    optimizer->SetMetric(clone);
    optimizer->StartOptimization();
    minima.push_back(clone->GetState().GetValues());
  }
  EXPECT_EQ(minima[0], minima[1]) << "the same residuals, the same differences: the same bits";
  EXPECT_NEAR(minima[0][1], 0.28, 0.03) << "the points grow so by a step, which the start of 0.2 does not";
}

TEST(LeastSquaresFunctionMetricv4, ATermThatChangesIsSeenByWhatHoldsIt)
{
  const auto metric = MakeCurveFit();
  const auto sum = itk::LeastSquaresSumMetricv4::New();
  sum->AddMetric(metric);
  const auto before = metric->GetMTime();
  metric->SetFunction([](const std::vector<double> & x) { return std::vector<double>{ x[0] - 1.0, x[1], x[0] }; });
  EXPECT_GT(metric->GetMTime(), before);
  sum->Initialize();
  EXPECT_EQ(sum->GetNumberOfResiduals(), 3u);
  EXPECT_NEAR(sum->GetValue(), 1.3 * 1.3 + 0.2 * 0.2 + 2.3 * 2.3, 1e-12);
}

TEST(LeastSquaresFunctionMetricv4, WhatIsMissingOrCannotBeSaysWhatToCall)
{
  const auto metric = MetricType::New();
  EXPECT_TRUE(Contains(MessageOf(metric), "call SetBlocks()"));
  metric->SetBlocks({ { "line", { { "a", 1.0, 1.0, 0.0, true } } } });
  EXPECT_TRUE(Contains(MessageOf(metric), "call SetFunction()"));
  metric->SetFunction([](const std::vector<double> &) { return std::vector<double>(); });
  EXPECT_TRUE(Contains(MessageOf(metric), "returned no residuals"));
  metric->SetFunction([](const std::vector<double> & x) { return std::vector<double>{ 0.0, x[0] / 0.0 }; });
  EXPECT_TRUE(Contains(MessageOf(metric), "Residual 1 of the function of SetFunction() is inf"));
  metric->SetFunction([](const std::vector<double> & x) { return std::vector<double>(x[0] > 2.0 ? 2 : 1, 0.5); });
  EXPECT_EQ(MessageOf(metric), "");
  metric->SetBlockValues("line", { 3.0 });
  std::string message;
  try
  {
    metric->GetValue();
  }
  catch (const itk::ExceptionObject & error)
  {
    message = error.GetDescription();
  }
  EXPECT_TRUE(Contains(message, "returned 2 residuals, and 1 before"));
  EXPECT_EQ(MessageOf(metric), "") << "initialized anew it may have another number";
  EXPECT_EQ(metric->GetNumberOfResiduals(), 2u);
  std::ostringstream text;
  metric->Print(text);
  EXPECT_TRUE(Contains(text.str(), "Blocks: line")) << text.str();
}
