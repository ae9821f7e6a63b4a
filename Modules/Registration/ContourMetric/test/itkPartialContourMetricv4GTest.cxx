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

#include "itkLeastSquaresMetricCostFunction.h"
#include "itkLevenbergMarquardtOptimizerv4.h"

#include "itkLBFGSBOptimizerv4.h"
#include "itkLevenbergMarquardtOptimizer.h"

#include "itkGTest.h"
#include "itkTestingMacros.h"

#include <sstream>

using namespace PartialContourTestCase;

namespace
{
MetricType::Pointer
MakeMetric(TransformType * start, double outliers = 0.2)
{
  const auto metric = MetricType::New();
  metric->SetFixedContour(MakeFixed(0.3, 0.7, 0.5, outliers));
  metric->SetMovingContour(MakeMoving());
  metric->SetMovingTransform(start);
  return metric;
}

int
ExerciseBasicObjectMethods()
{
  const auto metric = MetricType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(metric, PartialContourMetricv4, ContourToContourMetricv4);
  const auto cost = itk::LeastSquaresMetricCostFunction::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(cost, LeastSquaresMetricCostFunction, MultipleValuedCostFunction);
  return EXIT_SUCCESS;
}

ParametersType
MakePosition(double a, double b, double c, double d)
{
  ParametersType position(4);
  position[0] = a;
  position[1] = b;
  position[2] = c;
  position[3] = d;
  return position;
}
} // namespace

TEST(PartialContourMetricv4, BasicObjectMethodsAndEverySettingIsPrinted)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  const auto metric = MetricType::New();
  metric->SetScalePrior(1.02, 0.05);
  std::ostringstream text;
  metric->Print(text);
  for (const char * name : { "RobustKernel: itk::ContourMetricEnums::RobustKernel::GemanMcClure",
                             "KernelWidth: 5",
                             "Annealing: On",
                             "InitialKernelWidth: 12",
                             "FinalKernelWidth: 5",
                             "DirectionWeight: 8",
                             "ReverseWeight: 0",
                             "GateByTooth: On",
                             "CorrelatedNoise: Off",
                             "CorrelationLength: 12",
                             "Prior: scale 1.02 +- 0.05" })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}

TEST(PartialContourMetricv4, GetDerivativeIsMinusTheGradientAndResidualsMakeUpTheValue)
{
  const auto metric = MakeMetric(MakeTransform(1.03, 0.05, 305.0, 423.0));
  metric->SetReverseWeight(0.5);
  metric->SetDirectionWeight(6.0);
  metric->SetScalePrior(1.0, 0.05);
  metric->SetRotationPrior(0.0, 0.1);
  PointType at;
  at.Fill(0.0);
  PointType position;
  position[0] = 300.0;
  position[1] = 418.0;
  metric->SetTranslationPrior(at, position, 8.0);
  metric->SetKernelWidth(5.0);
  metric->Initialize();
  for (const bool correlated : { false, true })
  {
    if (correlated)
    {
      EXPECT_TRUE(metric->UpdateNoiseModel());
    }
    ParametersType             x = MakePosition(1.3, -0.7, 2.1, 0.4);
    MetricType::MeasureType    value;
    MetricType::DerivativeType derivative;
    metric->SetParameters(x);
    metric->GetValueAndDerivative(value, derivative);
    vnl_vector<double> residuals;
    vnl_matrix<double> jacobian;
    metric->GetResiduals(residuals, &jacobian);
    EXPECT_EQ(residuals.size(), metric->GetNumberOfResiduals());
    EXPECT_NEAR(residuals.squared_magnitude(), value, 1e-12 * value);
    const vnl_vector<double> gradient = 2.0 * (residuals * jacobian);
    for (unsigned int k = 0; k < 4; ++k)
    {
      ParametersType after = x;
      ParametersType before = x;
      after[k] += 1e-6;
      before[k] -= 1e-6;
      const double difference = (metric->EvaluateAt(after) - metric->EvaluateAt(before)) / 2e-6;
      EXPECT_NEAR(derivative[k], -difference, 1e-5 * std::max(1.0, std::abs(difference)));
      EXPECT_NEAR(gradient[k], -derivative[k], 1e-10 * std::max(1.0, std::abs(difference)));
    }
  }
}

TEST(PartialContourMetricv4, ResidualsGrowBeyondTheBoundsAndTheJacobianKnows)
{
  const auto metric = MakeMetric(MakeTransform(1.03, 0.05, 305.0, 423.0));
  metric->Initialize();
  metric->SetBounds(MakePosition(-2.0, -2.0, -2.0, -2.0), MakePosition(2.0, 2.0, 2.0, 2.0));
  ParametersType     inside = MakePosition(2.0, 0.5, -2.0, 0.0);
  ParametersType     outside = MakePosition(5.0, 0.5, -4.0, 0.0);
  vnl_vector<double> residuals;
  vnl_matrix<double> jacobian;
  metric->SetParameters(outside);
  metric->GetResiduals(residuals, &jacobian);
  EXPECT_NEAR(residuals.squared_magnitude(), metric->EvaluateAt(inside) + 9.0 + 4.0, 1e-9);
  MetricType::MeasureType    value;
  MetricType::DerivativeType derivative;
  metric->GetValueAndDerivative(value, derivative);
  EXPECT_NEAR(value, residuals.squared_magnitude(), 1e-9);
  EXPECT_EQ(derivative[0], -6.0);
  EXPECT_EQ(derivative[2], 4.0);
  const unsigned int last = residuals.size();
  EXPECT_EQ(jacobian(last - 4, 0), 1.0);
  EXPECT_EQ(jacobian(last - 2, 2), 1.0);
  EXPECT_EQ(jacobian(last - 3, 1), 0.0);
  for (unsigned int i = 0; i < last - 4; ++i)
  {
    EXPECT_EQ(jacobian(i, 0), 0.0);
  }
}

TEST(PartialContourMetricv4, ParameterAtItsBoundMovesInwardsOnly)
{
  const auto metric = MakeMetric(MakeTransform(1.03, 0.05, 305.0, 423.0));
  metric->Initialize();
  ParametersType             x = MakePosition(0.4, 0.5, -0.3, 0.2);
  MetricType::MeasureType    value;
  MetricType::DerivativeType derivative;
  metric->SetParameters(x);
  metric->GetValueAndDerivative(value, derivative);
  vnl_vector<double> residuals;
  vnl_matrix<double> inside;
  metric->GetResiduals(residuals, &inside);
  const unsigned int last = residuals.size();
  for (unsigned int k = 0; k < 4; ++k)
  {
    ASSERT_NE(derivative[k], 0.0);
    for (const bool outwards : { false, true })
    {
      ParametersType lower = MakePosition(-9.0, -9.0, -9.0, -9.0);
      ParametersType upper = MakePosition(9.0, 9.0, 9.0, 9.0);
      // GetDerivative() is where the value falls.
      ((derivative[k] > 0.0) == outwards ? upper : lower)[k] = x[k];
      metric->SetBounds(lower, upper);
      vnl_matrix<double> jacobian;
      metric->GetResiduals(residuals, &jacobian);
      EXPECT_EQ(residuals[last - 4 + k], 0.0);
      EXPECT_EQ(jacobian(last - 4 + k, k), outwards ? 1.0 : 0.0);
      for (unsigned int i = 0; i < last - 4; ++i)
      {
        EXPECT_EQ(jacobian(i, k), outwards ? 0.0 : inside(i, k));
      }
    }
  }
}

TEST(PartialContourMetricv4, LevelsNarrowTheKernelAndEndWithTheNoiseModel)
{
  const auto metric = MakeMetric(MakeTransform(1.05, 0.06, 308.0, 421.0));
  metric->SetInitialKernelWidth(16.0);
  metric->SetFinalKernelWidth(2.0);
  metric->CorrelatedNoiseOn();
  metric->SetNumberOfCorrelatedLevels(1);
  metric->Initialize();
  const itk::ContourSimilarity estimate = metric->GetCurrentSimilarity();
  const double                 widths[4] = { 16.0, 8.0, 4.0, 2.0 };
  for (unsigned int level = 0; level < 4; ++level)
  {
    metric->StartLevel(level, 4, estimate);
    EXPECT_NEAR(metric->GetKernelWidth(), widths[level], 1e-12);
    EXPECT_EQ(metric->HasNoiseModel(), level == 3);
  }
  metric->StartLevel(0, 1, estimate);
  EXPECT_EQ(metric->GetKernelWidth(), 2.0);
  metric->StartLevel(0, 2, estimate);
  EXPECT_EQ(metric->GetKernelWidth(), 16.0);
  EXPECT_FALSE(metric->HasNoiseModel());
  metric->AnnealingOff();
  metric->StartLevel(1, 2, estimate);
  EXPECT_EQ(metric->GetKernelWidth(), 16.0);
}

TEST(PartialContourMetricv4, AnnealingFindsWhatTheNarrowKernelAloneMisses)
{
  const auto error = [](bool anneal) {
    const auto start = MakeTransform(1.10, 0.0, 318.0, 408.0);
    const auto metric = MakeMetric(start);
    metric->SetDirectionWeight(0.0);
    metric->Initialize();
    const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
    optimizer->SetMetric(metric);
    for (const double width : { 16.0, 8.0, 4.0, 2.0 })
    {
      metric->SetKernelWidth(anneal ? width : 2.0);
      optimizer->StartOptimization();
    }
    return MeanError(start, 0.3, 0.7);
  };
  EXPECT_LT(error(true), 1.0);
  EXPECT_GT(error(false), 3.0);
}

TEST(PartialContourMetricv4, RecoversSimilarityWithFourTenthsOverlapAndAFifthOutliers)
{
  // Standard error of the fit with 0.5 px of white noise on 35 good points: about 0.25 px rms over the traced part.
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    const auto start = MakeTransform(1.09, 0.03, 314.0, 412.0);
    const auto metric = MetricType::New();
    metric->SetFixedContour(MakeFixed(0.3, 0.7, 0.5, 0.2, seed));
    metric->SetMovingContour(MakeMoving());
    metric->SetMovingTransform(start);
    // The steps of the outliers spoil the directions of their neighbours.
    metric->SetDirectionWeight(0.0);
    metric->Initialize();
    const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
    optimizer->SetMetric(metric);
    for (const double width : { 16.0, 8.0, 4.0, 2.0 })
    {
      metric->SetKernelWidth(width);
      optimizer->StartOptimization();
    }
    EXPECT_LT(MeanError(start, 0.3, 0.7), 0.6) << "seed " << seed;
    // The correlated fit holds: runs of gross errors do not pull it, though each good run is known to its drift only.
    metric->SetKernelWidth(5.0);
    ASSERT_TRUE(metric->UpdateNoiseModel());
    optimizer->StartOptimization();
    EXPECT_LT(MeanError(start, 0.3, 0.7), 0.6) << "seed " << seed << ", correlated";
    // A fifth of the tracing is elsewhere; it runs along four tenths of the silhouette.
    const auto overlap = metric->ComputeOverlap(3.0);
    EXPECT_NEAR(overlap.fixedShare, 0.8, 0.05);
    EXPECT_NEAR(overlap.movingShare, 0.4 * 0.8, 0.07);
    EXPECT_LT(overlap.rms, 0.8);
  }
}

TEST(PartialContourMetricv4, StockSolversOfBothKindsFindTheSameMinimum)
{
  const auto prepare = [](TransformType * start) {
    const auto metric = MakeMetric(start);
    metric->SetKernelWidth(6.0);
    metric->Initialize();
    return metric;
  };
  const auto byMinpack = MakeTransform(1.05, 0.06, 308.0, 421.0);
  {
    const auto metric = prepare(byMinpack);
    const auto cost = itk::LeastSquaresMetricCostFunction::New();
    EXPECT_THROW(cost->GetNumberOfValues(), itk::ExceptionObject);
    cost->SetMetric(metric);
    EXPECT_EQ(cost->GetNumberOfParameters(), 4u);
    const auto optimizer = itk::LevenbergMarquardtOptimizer::New();
    optimizer->SetUseCostFunctionGradient(true);
    optimizer->SetCostFunction(cost);
    itk::LevenbergMarquardtOptimizer::ParametersType origin(4);
    origin.Fill(0.0);
    optimizer->SetInitialPosition(origin);
    optimizer->SetNumberOfIterations(200);
    optimizer->SetValueTolerance(1e-12);
    optimizer->StartOptimization();
    ParametersType position(4);
    std::copy(optimizer->GetCurrentPosition().begin(), optimizer->GetCurrentPosition().end(), position.begin());
    metric->SetParameters(position);
  }
  const auto byLBFGSB = MakeTransform(1.05, 0.06, 308.0, 421.0);
  {
    const auto metric = prepare(byLBFGSB);
    const auto optimizer = itk::LBFGSBOptimizerv4::New();
    optimizer->SetMetric(metric);
    ParametersType origin(4);
    origin.Fill(0.0);
    itk::LBFGSBOptimizerv4::BoundSelectionType selection(4);
    selection.Fill(itk::LBFGSBOptimizerv4::UNBOUNDED);
    itk::LBFGSBOptimizerv4::BoundValueType none(4);
    none.Fill(0.0);
    optimizer->SetBoundSelection(selection);
    optimizer->SetLowerBound(none);
    optimizer->SetUpperBound(none);
    optimizer->SetInitialPosition(origin);
    optimizer->SetCostFunctionConvergenceFactor(10.0);
    optimizer->StartOptimization();
  }
  const auto byV4 = MakeTransform(1.05, 0.06, 308.0, 421.0);
  {
    const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
    optimizer->SetMetric(prepare(byV4));
    optimizer->SetValueTolerance(1e-12);
    optimizer->StartOptimization();
  }
  for (int i = 0; i <= 10; ++i)
  {
    const auto point = Cusps(0.1 * i);
    EXPECT_NEAR(byV4->TransformPoint(point).EuclideanDistanceTo(byMinpack->TransformPoint(point)), 0.0, 1e-3);
    EXPECT_NEAR(byV4->TransformPoint(point).EuclideanDistanceTo(byLBFGSB->TransformPoint(point)), 0.0, 1e-2);
  }
}

TEST(PartialContourMetricv4, PriorsPullByTheirWidth)
{
  // A straight tracing along a straight silhouette says nothing about the shift along it; the prior decides.
  const auto line = [](double from, double to) {
    std::vector<PointType> points;
    for (int i = 0; i <= 40; ++i)
    {
      PointType point;
      point[0] = from + (to - from) * i / 40.0;
      point[1] = 0.0;
      points.push_back(point);
    }
    const auto contour = ContourType::New();
    contour->AddPolyline(points);
    return contour;
  };
  const auto metric = MetricType::New();
  metric->SetFixedContour(line(50.0, 150.0));
  metric->SetMovingContour(line(0.0, 300.0));
  metric->SetMovingTransform(MakeTransform(1.02, 0.01, 2.0, 1.0));
  metric->SetScalePrior(1.1, 0.02);
  metric->SetRotationPrior(0.0, 0.1);
  PointType at;
  at.Fill(0.0);
  PointType position;
  position[0] = -20.0;
  position[1] = 0.0;
  metric->SetTranslationPrior(at, position, 3.0);
  metric->Initialize();
  const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
  optimizer->SetMetric(metric);
  optimizer->StartOptimization();
  EXPECT_NEAR(metric->GetMovingTransform()->GetScale(), 1.1, 1e-6);
  EXPECT_NEAR(metric->GetMovingTransform()->GetAngle(), 0.0, 1e-6);
  EXPECT_NEAR(metric->GetMovingTransform()->GetOffset()[0], -20.0, 1e-4);
  // All that is known about scale and shift along the line is the prior: its sigmas come back.
  const auto   covariance = metric->ComputeCovariance();
  const double scaleSigma = std::sqrt(covariance(0, 0)) / metric->GetReferenceLength();
  EXPECT_NEAR(scaleSigma, 0.02, 1e-4);
  EXPECT_LT(std::sqrt(covariance(3, 3)), 0.6);
  EXPECT_GT(MetricType::GetScaleSigma(itk::ContourMetricEnums::SpacingSource::Default),
            MetricType::GetScaleSigma(itk::ContourMetricEnums::SpacingSource::Given));
  EXPECT_THROW(metric->SetScalePrior(-1.0, 0.1), itk::ExceptionObject);
  EXPECT_THROW(metric->SetRotationPrior(0.0, 0.0), itk::ExceptionObject);
  EXPECT_THROW(metric->SetTranslationPrior(at, position, -1.0), itk::ExceptionObject);

  // Without priors the shift along the line is undetermined, and the covariance says so.
  const auto bare = MetricType::New();
  bare->SetFixedContour(line(50.0, 150.0));
  bare->SetMovingContour(line(0.0, 300.0));
  bare->Initialize();
  EXPECT_THROW(bare->ComputeCovariance(), itk::ExceptionObject);
}

TEST(PartialContourMetricv4, PredictedCovarianceIsThatOfManyTracings)
{
  // White noise of known size: the rms of the fit over 60 tracings against the prediction, each with its standard
  // error of about 10 %.
  double actual = 0.0;
  double predicted = 0.0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    const auto start = MakeTruth();
    const auto metric = MetricType::New();
    metric->SetFixedContour(MakeFixed(0.2, 0.8, 0.5, 0.0, seed));
    metric->SetMovingContour(MakeMoving());
    metric->SetMovingTransform(start);
    metric->SetRobustKernel(itk::ContourMetricEnums::RobustKernel::Squares);
    metric->SetDirectionWeight(0.0);
    metric->SetSmoothNoise(0.0);
    metric->SetWhiteNoise(0.5);
    metric->Initialize();
    const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
    optimizer->SetMetric(metric);
    optimizer->StartOptimization();
    const auto & x = metric->GetParameters();
    const auto   covariance = metric->ComputeCovariance();
    for (unsigned int k = 0; k < 4; ++k)
    {
      actual += x[k] * x[k];
      predicted += covariance(k, k);
    }
  }
  EXPECT_NEAR(std::sqrt(actual / predicted), 1.0, 0.2);
}

TEST(PartialContourMetricv4, WhereTheHandDriftsTheCorrelatedFitIsBetterAndItsErrorNearThePredicted)
{
  // Points 1.5 px apart, a drift of 1 px over 12 px, 0.25 px of white noise; 40 tracings.
  double plain = 0.0;
  double correlated = 0.0;
  double predicted = 0.0;
  double smooth = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    itk::ReproducibleRandom random(seed);
    std::vector<double>     noise[2];
    for (auto & values : noise)
    {
      for (int i = 0; i < 600; ++i)
      {
        values.push_back(random.Normal());
      }
    }
    // White noise smoothed by exp(-k^2 / 12^2) has the correlation exp(-d^2 / (2 12^2)).
    const auto drift = [&](unsigned int d, double arc) {
      const int centre = static_cast<int>(std::floor(arc)) + 50;
      double    sum = 0.0;
      double    squares = 0.0;
      for (int k = centre - 45; k <= centre + 45; ++k)
      {
        const double weight = std::exp(-(k - 50 - arc) * (k - 50 - arc) / 144.0);
        sum += weight * noise[d][static_cast<std::size_t>(k)];
        squares += weight * weight;
      }
      return sum / std::sqrt(squares);
    };
    const auto             truth = MakeTruth();
    std::vector<PointType> points;
    double                 arc = 0.0;
    PointType              last = truth->TransformPoint(Cusps(0.0));
    for (int i = 0; i < 260; ++i)
    {
      PointType point = truth->TransformPoint(Cusps(i / 259.0));
      arc += point.EuclideanDistanceTo(last);
      last = point;
      for (unsigned int d = 0; d < 2; ++d)
      {
        point[d] += drift(d, arc) + random.Normal(0.0, 0.25);
      }
      points.push_back(point);
    }
    const auto fixed = ContourType::New();
    fixed->AddPolyline(points);
    const auto start = MakeTruth();
    const auto metric = MetricType::New();
    metric->SetFixedContour(fixed);
    metric->SetMovingContour(MakeMoving());
    metric->SetMovingTransform(start);
    metric->SetDirectionWeight(0.0);
    metric->SetKernelWidth(8.0);
    metric->Initialize();
    const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
    optimizer->SetMetric(metric);
    optimizer->StartOptimization();
    for (const double x : metric->GetParameters())
    {
      plain += x * x;
    }
    ASSERT_TRUE(metric->UpdateNoiseModel());
    optimizer->StartOptimization();
    const auto covariance = metric->ComputeCovariance();
    for (unsigned int k = 0; k < 4; ++k)
    {
      correlated += metric->GetParameters()[k] * metric->GetParameters()[k];
      predicted += covariance(k, k);
    }
    smooth += metric->GetNoiseLevels().smooth / 40.0;
  }
  // At the valleys between the cusps the nearest place is not the traced one, which no linear covariance knows.
  EXPECT_GT(std::sqrt(correlated / predicted), 0.8);
  EXPECT_LT(std::sqrt(correlated / predicted), 1.5);
  EXPECT_NEAR(smooth, 1.0, 0.2);
}

TEST(PartialContourMetricv4, RefusesSettingsThatMakeNoSense)
{
  const auto check = [](void (*change)(MetricType *)) {
    const auto metric = MakeMetric(MakeTruth());
    change(metric);
    EXPECT_THROW(metric->Initialize(), itk::ExceptionObject);
  };
  check([](MetricType * m) { m->SetInitialKernelWidth(0.0); });
  check([](MetricType * m) { m->SetFinalKernelWidth(-1.0); });
  check([](MetricType * m) { m->SetWhiteNoise(0.0); });
  check([](MetricType * m) { m->SetSmoothNoise(std::nan("")); });
  check([](MetricType * m) { m->SetReverseWeight(-0.1); });
  check([](MetricType * m) { m->SetDirectionWeight(-0.1); });
  check([](MetricType * m) { m->SetTaperLength(-0.1); });
  const auto metric = MetricType::New();
  EXPECT_THROW(metric->SetKernelWidth(0.0), itk::ExceptionObject);
  EXPECT_THROW(metric->UpdateNoiseModel(), itk::ExceptionObject);
  EXPECT_THROW(metric->GetNumberOfResiduals(), itk::ExceptionObject);
}
