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
#include "itkParameterPriorMetricv4.h"

#include "itkMessageOfCall.h"
#include "itkCurveFitMetric.h"
#include "itkLeastSquaresMetricChecker.h"
#include "itkLevenbergMarquardtOptimizerv4.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace
{
using itk::MessageOfCall;
using MetricType = itk::ParameterPriorMetricv4;
using PriorType = MetricType::PriorType;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/** Gaussian, t, and nothing known, off the middle of each. */
MetricType::Pointer
MakePrior()
{
  auto metric = MetricType::New();
  metric->SetBlock({ "pose",
                     { { "pitch", 0.13, 64.0, 0.1, true },
                       { "roll", -0.21, 64.0, 0.1, true },
                       { "tx", 3.0, 1.0, 5.0, true },
                       { "ty", 1.7, 2.0, 0.0, true } } });
  metric->SetPriors({ { 0.02, 0.06, 0.0 }, { 0.01, 0.05, 4.0 }, { 1.0, Infinity, 0.0 }, { -0.4, 0.9, 2.5 } });
  metric->Initialize();
  return metric;
}

int
ExerciseBasicObjectMethods()
{
  const auto metric = MakePrior();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(metric, ParameterPriorMetricv4, LeastSquaresMetricv4);
  ITK_TEST_SET_GET_BOOLEAN(metric, UseVariancePrecision, true);
  return EXIT_SUCCESS;
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}
} // namespace

TEST(ParameterPriorMetricv4, BasicObjectMethodsAndDefaults)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  const auto metric = MetricType::New();
  EXPECT_FALSE(metric->GetUseVariancePrecision());
  EXPECT_TRUE(metric->GetPriors().empty());
  const PriorType prior;
  EXPECT_EQ(prior.mean, 0.0);
  EXPECT_EQ(prior.sigma, 1.0);
  EXPECT_EQ(prior.degreesOfFreedom, 0.0);
  std::ostringstream text;
  MakePrior()->Print(text);
  for (const char * line : { "Block: pose", "roll: 0.01 +- 0.05, degrees of freedom 4", "pitch=0.13" })
  {
    EXPECT_TRUE(Contains(text.str(), line)) << line << " in " << text.str();
  }
}

TEST(ParameterPriorMetricv4, KeepsWhatEveryMetricPromises)
{
  const auto metric = MakePrior();
  LeastSquaresMetricChecker::Check(*metric);
}

TEST(ParameterPriorMetricv4, ValueIsMinusTwiceTheLogDensity)
{
  const auto metric = MakePrior();
  // Gaussian; t of this standard deviation with n degrees of freedom: scale^2 = s^2 (n - 2) / n.
  const auto ofT = [](double d, double sigma, double n) {
    const double scale2 = sigma * sigma * (n - 2.0) / n;
    return (n + 1.0) * std::log(1.0 + d * d / (n * scale2));
  };
  const double expected = 0.11 * 0.11 / (0.06 * 0.06) + ofT(-0.22, 0.05, 4.0) + ofT(2.1, 0.9, 2.5);
  EXPECT_NEAR(metric->GetValue(), expected, 1e-12 * expected);
  EXPECT_EQ(MetricType::GetDeviance({ 3.0, 0.5, 4.0 }, 3.0), 0.0) << "0 at the mean";
  EXPECT_EQ(MetricType::GetDeviance({ 3.0, Infinity, 4.0 }, 30.0), 0.0);
}

TEST(ParameterPriorMetricv4, PrecisionForACovarianceIsThatOfTheVariance)
{
  for (const double n : { 0.0, 2.0, 4.0, 9.0 })
  {
    const PriorType prior{ 0.3, 0.2, n };
    // At the mean: 1 / s^2 for both where it is Gaussian, and for the covariance always.
    EXPECT_NEAR(MetricType::GetPrecision(prior, 0.3, true), 25.0, 1e-10);
    EXPECT_NEAR(MetricType::GetPrecision(prior, 0.3, false), n <= 2.0 ? 25.0 : 25.0 * (n + 1.0) / (n - 2.0), 1e-10);
    for (const double value : { -0.4, 0.5, 1.9 })
    {
      // The residual's square has the derivative of the value: precision times 2 d.
      const double step = 1e-5;
      const double slope =
        (MetricType::GetDeviance(prior, value + step) - MetricType::GetDeviance(prior, value - step)) / (2.0 * step);
      EXPECT_NEAR(MetricType::GetPrecision(prior, value, false) * 2.0 * (value - 0.3), slope, 1e-6) << n;
    }
  }
  EXPECT_EQ(MetricType::GetPrecision({ 0.0, Infinity, 4.0 }, 3.0, false), 0.0);
  const auto metric = MakePrior();
  metric->UseVariancePrecisionOn();
  MetricType::VectorType residuals;
  metric->GetResiduals(residuals, nullptr);
  EXPECT_NEAR(residuals[1] * residuals[1], 2.0 / (2.0 * 0.0025 + 0.22 * 0.22) * 0.22 * 0.22, 1e-12);
}

TEST(ParameterPriorMetricv4, AnOptimizerFindsTheMeansAndLeavesAloneWhatNothingIsKnownOf)
{
  const auto metric = MakePrior();
  const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
  optimizer->SetMetric(metric);
  optimizer->StartOptimization();
  const auto values = metric->GetBlockValues("pose");
  // Steps below the tolerance of 1e-6 end it: the reweighting of the t converges linearly.
  EXPECT_NEAR(values[0], 0.02, 1e-5);
  EXPECT_NEAR(values[1], 0.01, 1e-5);
  EXPECT_EQ(values[2], 3.0);
  EXPECT_NEAR(values[3], -0.4, 1e-5);
}

TEST(ParameterPriorMetricv4, ErrorsSayWhatToCall)
{
  auto metric = MetricType::New();
  EXPECT_TRUE(Contains(MessageOfCall([&] { metric->Initialize(); }), "call SetBlock()"));
  metric->SetBlock({ "scale", { { "kappa", 0.0, 1.0, 0.0, true } } });
  EXPECT_TRUE(
    Contains(MessageOfCall([&] { metric->Initialize(); }), "The block \"scale\" has 1 parameters and 0 priors"));
  metric->SetPriors({ { 0.0, 0.0, 0.0 } });
  const std::string zero = MessageOfCall([&] { metric->Initialize(); });
  EXPECT_TRUE(Contains(zero, "The prior of \"kappa\" has the standard deviation 0")) << zero;
  EXPECT_TRUE(Contains(zero, "SetBlockFree()")) << zero;
  metric->SetPriors({ { 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0 } });
  EXPECT_TRUE(Contains(MessageOfCall([&] { metric->Initialize(); }), "it must be positive"));
  metric->SetPriors({ { 0.0, 1.0, 0.0 } });
  EXPECT_NO_THROW(metric->Initialize());
}

TEST(ParameterPriorMetricv4, AnotherBlockTakesThePlaceOfTheFirst)
{
  auto metric = MetricType::New();
  metric->SetBlock({ "one", { { "a", 1.0, 1.0, 0.0, true } } });
  EXPECT_EQ(metric->GetBlockValues("one"), std::vector<double>{ 1.0 });
  metric->SetBlock({ "two", { { "b", 2.0, 1.0, 0.0, true }, { "c", 3.0, 1.0, 0.0, true } } });
  metric->SetPriors({ { 0.0, 1.0, 0.0 }, { 0.0, 1.0, 0.0 } });
  metric->Initialize();
  EXPECT_EQ(metric->GetState().GetNumberOfParameters(), 2u);
  EXPECT_EQ(metric->GetValue(), 13.0);
}
