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
#include "itkLeastSquaresMetricv4.h"

#include "itkMessageOfCall.h"
#include "itkCurveFitMetric.h"
#include "itkLeastSquaresMetricChecker.h"
#include "itkLevenbergMarquardtOptimizerv4.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{
using itk::MessageOfCall;
int
ExerciseBasicObjectMethods()
{
  const auto metric = CurveFitMetric::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(metric, CurveFitMetric, LeastSquaresMetricv4);
  return EXIT_SUCCESS;
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

/** A metric that declares nothing. */
class EmptyMetric : public CurveFitMetric
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(EmptyMetric);
  using Self = EmptyMetric;
  using Superclass = CurveFitMetric;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);
  itkTypeMacro(EmptyMetric, CurveFitMetric);
  BlocksType
  DeclareBlocks() const override
  {
    return {};
  }

protected:
  EmptyMetric() = default;
  ~EmptyMetric() override = default;
};
} // namespace

TEST(LeastSquaresMetricv4, BasicObjectMethodsAndStateIsPrinted)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  std::ostringstream text;
  CurveFitMetric::New()->Print(text);
  EXPECT_TRUE(Contains(text.str(), "Parameters:"));
}

TEST(LeastSquaresMetricv4, AUsersMetricOfTwoMethodsKeepsWhatEveryMetricPromises)
{
  const auto metric = CurveFitMetric::New();
  metric->Initialize();
  LeastSquaresMetricChecker::Settings settings;
  // Its own derivatives are differences with a step of 1e-5, which leave 1e-16 over that of the residuals' size.
  settings.jacobianTolerance = settings.gradientTolerance = 1e-6;
  LeastSquaresMetricChecker::Check(*metric, settings);
}

TEST(LeastSquaresMetricv4, JacobianByDifferencesIsThatOfTheFormula)
{
  const auto metric = CurveFitMetric::New();
  metric->Initialize();
  itk::LeastSquaresMetricv4::VectorType residuals;
  itk::LeastSquaresMetricv4::MatrixType jacobian;
  metric->ComputeResiduals({ 2.3, 0.2 }, residuals, &jacobian);
  for (unsigned int i = 0; i < 5; ++i)
  {
    EXPECT_NEAR(jacobian(i, 0), std::exp(0.2 * i) / 0.5, 1e-8);
    EXPECT_NEAR(jacobian(i, 1), 2.3 * i * std::exp(0.2 * i) / 0.5, 1e-8);
  }
  // What the optimizer sees: eight of it are one.
  metric->GetResiduals(residuals, &jacobian);
  EXPECT_NEAR(jacobian(3, 1), 2.3 * 3.0 * std::exp(0.6) / 0.5 / 8.0, 1e-8);
  EXPECT_NEAR(metric->GetParameters()[1], 1.6, 1e-15);
  EXPECT_EQ(metric->GetMaximumSteps()[1], 2.0);
}

TEST(LeastSquaresMetricv4, DefaultsAreAPlainSumOfSquaresWithoutKernelNoiseOrMatches)
{
  const auto metric = CurveFitMetric::New();
  metric->Initialize();
  const double                          value = metric->GetValue();
  itk::LeastSquaresMetricv4::VectorType residuals;
  metric->GetResiduals(residuals, nullptr);
  EXPECT_EQ(value, residuals.squared_magnitude());
  itk::ContourNoiseLevels levels;
  EXPECT_FALSE(metric->GetNoiseLevels(levels));
  metric->SetKernelWidth(0.1);
  metric->SetNoiseLevels({ 9.0, 9.0 });
  metric->UpdateNoiseCorrelation(metric->GetState().GetValues());
  metric->Hold(itk::LeastSquaresMetricv4::HoldEnum::Matches);
  EXPECT_EQ(metric->GetValue(), value);
  EXPECT_EQ(metric->EstimateNoise(), 0.0) << "nothing to estimate";
  // A step length without matches is the norm of the step.
  auto to = metric->GetParameters();
  to[0] += 3.0;
  to[1] += 4.0;
  EXPECT_NEAR(metric->GetStepLength(metric->GetParameters(), to), 5.0, 1e-14);
  itk::RegistrationFit fit;
  metric->AddFit(metric->GetState().GetValues(), fit);
  EXPECT_EQ(fit.numberOfPoints, 0u);
  EXPECT_EQ(fit.GetMeanCost(), 1.0) << "no evidence fits nothing";
  EXPECT_EQ(fit.GetMeanCodeOffset(), 0.0);
}

TEST(LeastSquaresMetricv4, InformationOfKnownNoiseIsThatOfTheResiduals)
{
  const auto metric = CurveFitMetric::New();
  metric->Initialize();
  itk::LeastSquaresMetricv4::VectorType residuals;
  itk::LeastSquaresMetricv4::MatrixType jacobian;
  const std::vector<double>             x = metric->GetState().GetValues();
  metric->ComputeResiduals(x, residuals, &jacobian);
  // It is added to what is there.
  itk::LeastSquaresMetricv4::MatrixType information(2, 2, 1.0);
  itk::LeastSquaresMetricv4::VectorType gradient(2, 2.0);
  double                                value = 3.0;
  metric->AddFixedInformation(x, information, gradient, value);
  const auto expected = jacobian.transpose() * jacobian;
  const auto expectedGradient = jacobian.transpose() * residuals;
  EXPECT_NEAR(value, 3.0 + residuals.squared_magnitude(), 1e-12 * value);
  for (unsigned int a = 0; a < 2; ++a)
  {
    EXPECT_NEAR(gradient[a], 2.0 + expectedGradient[a], 1e-12 * std::abs(gradient[a]));
    for (unsigned int b = 0; b < 2; ++b)
    {
      EXPECT_NEAR(information(a, b), 1.0 + expected(a, b), 1e-12 * information(a, b));
    }
  }
}

TEST(LeastSquaresMetricv4, LevenbergMarquardtFitsTheCurve)
{
  const auto metric = CurveFitMetric::New();
  metric->ordinates = { 2.0, 2.0 * std::exp(0.3), 2.0 * std::exp(0.6), 2.0 * std::exp(0.9), 2.0 * std::exp(1.2) };
  metric->Initialize();
  const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
  optimizer->SetMetric(metric);
  optimizer->StartOptimization();
  EXPECT_NEAR(metric->GetBlockValues("curve")[0], 2.0, 1e-6);
  EXPECT_NEAR(metric->GetBlockValues("curve")[1], 0.3, 1e-6);
  // One held: the other goes as far as it can.
  metric->SetBlockValues("curve", { 2.2, 0.1 });
  metric->SetBlockFree("curve", { false, true });
  optimizer->StartOptimization();
  EXPECT_EQ(metric->GetBlockValues("curve")[0], 2.2);
  EXPECT_LT(metric->GetBlockValues("curve")[1], 0.3);
  EXPECT_GT(metric->GetBlockValues("curve")[1], 0.2);
}

TEST(LeastSquaresMetricv4, InitializeKeepsValuesAndMasks)
{
  const auto metric = CurveFitMetric::New();
  metric->SetBlockValues("curve", { 5.0, 0.4 });
  metric->SetBlockFree("curve", { true, false });
  metric->Initialize();
  EXPECT_EQ(metric->GetBlockValues("curve"), (std::vector<double>{ 5.0, 0.4 }));
  EXPECT_EQ(metric->GetNumberOfParameters(), 1u);
  EXPECT_EQ(metric->GetParameters()[0], 5.0);
  metric->SetValues({ 6.0, 0.5 });
  EXPECT_EQ(metric->GetParameters()[0], 6.0);
}

TEST(LeastSquaresMetricv4, ChangesOfValuesAndMasksAreSeenInTheTime)
{
  const auto metric = CurveFitMetric::New();
  metric->Initialize();
  auto       time = metric->GetMTime();
  const auto isLater = [&]() {
    const bool later = metric->GetMTime() > time;
    time = metric->GetMTime();
    return later;
  };
  metric->GetValue();
  EXPECT_FALSE(isLater());
  metric->SetBlockValues("curve", { 5.0, 0.4 });
  EXPECT_TRUE(isLater());
  metric->SetBlockFree("curve", { true, false });
  EXPECT_TRUE(isLater());
  metric->SetValues({ 6.0, 0.5 });
  EXPECT_TRUE(isLater());
}

TEST(LeastSquaresMetricv4, ErrorsSayWhatIsMissing)
{
  const auto empty = EmptyMetric::New();
  EXPECT_TRUE(Contains(MessageOfCall([&] { empty->Initialize(); }),
                       "DeclareBlocks() (blocks() of a metric in Python) must name at least one block"));
  double                                    value = 0.0;
  itk::LeastSquaresMetricv4::DerivativeType derivative;
  vnl_vector<double>                        residuals;
  for (const std::string & message : { MessageOfCall([&] { empty->GetValue(); }),
                                       MessageOfCall([&] { empty->GetDerivative(derivative); }),
                                       MessageOfCall([&] { empty->GetValueAndDerivative(value, derivative); }),
                                       MessageOfCall([&] { empty->GetResiduals(residuals, nullptr); }) })
  {
    EXPECT_TRUE(Contains(message, "call Initialize()")) << message;
  }
  const auto metric = CurveFitMetric::New();
  metric->SetBlockFree("curve", false);
  const std::string held = MessageOfCall([&] { metric->Initialize(); });
  EXPECT_TRUE(Contains(held, "All parameters are held")) << held;
  EXPECT_TRUE(Contains(held, "SetBlockFree()")) << held;
  EXPECT_TRUE(Contains(held, "curve: a=2.3 (held) b=0.2 (held)")) << held;
  EXPECT_TRUE(Contains(MessageOfCall([&] {
                         metric->SetBlockValues("cure", { 1.0, 2.0 });
                       }),
                       "There is no block \"cure\" in the state; there are \"curve\"."));
  metric->SetBlockFree("curve", true);
  metric->Initialize();
  itk::LeastSquaresMetricv4::ParametersType three(3);
  EXPECT_TRUE(Contains(MessageOfCall([&] { metric->SetParameters(three); }), "2 free parameters, not 3"));
  EXPECT_TRUE(
    Contains(MessageOfCall([&] { metric->UpdateTransformParameters(three, 1.0); }), "3 parameters for 2 free ones"));
}

TEST(LeastSquaresMetricv4, AnEvaluationIsAnnouncedOnceAndMayBeRefused)
{
  const auto metric = CurveFitMetric::New();
  metric->Initialize();
  unsigned int announced = 0;
  metric->SetEvaluationCallback([&]() { ++announced; });
  double                                    value = 0.0;
  itk::LeastSquaresMetricv4::DerivativeType derivative;
  metric->GetValue();
  EXPECT_EQ(announced, 1u);
  metric->GetDerivative(derivative);
  EXPECT_EQ(announced, 2u);
  metric->GetValueAndDerivative(value, derivative);
  EXPECT_EQ(announced, 3u);
  itk::LeastSquaresMetricv4::VectorType residuals;
  metric->GetResiduals(residuals, nullptr);
  EXPECT_EQ(announced, 4u);
  // Those of the metric's own making are not announced.
  metric->ComputeValue(metric->GetState().GetValues());
  metric->Clone()->GetValue();
  EXPECT_EQ(announced, 4u);
  metric->SetEvaluationCallback([]() { throw itk::ProcessAborted(__FILE__, __LINE__); });
  EXPECT_THROW(metric->GetValue(), itk::ProcessAborted);
  metric->SetEvaluationCallback(nullptr);
  EXPECT_EQ(metric->GetValue(), value);
}
