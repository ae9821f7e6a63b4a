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
#include "itkSilhouetteToContourRegistrationMethod.h"

#include "itkContourChamferMetricv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkPartialContourMetricv4.h"
#include "itkSyntheticContours.h"

#include "itkAmoebaOptimizerv4.h"
#include "itkLBFGSBOptimizerv4.h"

#include "itkGTest.h"

#include <thread>

/** PartialContourMetricv4 in the registration method: an open outline against a tracing of a part of it. */
namespace
{
using namespace SyntheticContours;
using MethodType = itk::SilhouetteToContourRegistrationMethod;
using MetricType = itk::PartialContourMetricv4;
using OptimizerType = MethodType::OptimizerType;

constexpr double From = 0.05;
constexpr double To = 0.45;

/** The outline without its last tenth. */
ContourType::Pointer
MakeOpenSilhouette()
{
  std::vector<PointType> points;
  for (int i = 0; i <= 260; ++i)
  {
    points.push_back(Outline(0.9 * i / 260.0));
  }
  const auto contour = ContourType::New();
  contour->AddPolyline(points);
  return contour;
}

/** Four tenths of the outline, 0.4 px of noise, runs of four points 12 to 25 px off: a fifth of all. */
ContourType::Pointer
MakeTracingWithOutliers(const TransformType * transform, itk::ReproducibleRandom & random)
{
  std::vector<PointType> points;
  double                 lift = 0.0;
  for (int i = 0; i < 80; ++i)
  {
    PointType point = transform->TransformPoint(Outline(From + (To - From) * i / 79.0));
    if (i % 4 == 0)
    {
      lift = (i / 4) % 5 == 2 ? random.Uniform(12.0, 25.0) : 0.0;
    }
    point[0] += random.Normal(0.0, 0.4);
    point[1] += random.Normal(0.0, 0.4) + lift;
    points.push_back(point);
  }
  const auto contour = ContourType::New();
  contour->AddPolyline(points);
  return contour;
}

TransformType::Pointer
MakeTruth(itk::ReproducibleRandom & random)
{
  return MakeTransform(
    std::exp(random.Normal(0.0, 0.03)), random.Normal(0.0, 0.06), random.Uniform(340.0, 460.0), 500.0);
}

double
TracedError(const TransformType * a, const TransformType * b)
{
  double sum = 0.0;
  for (int i = 0; i <= 50; ++i)
  {
    const PointType point = Outline(From + (To - From) * i / 50.0);
    sum += a->TransformPoint(point).SquaredEuclideanDistanceTo(b->TransformPoint(point)) / 51.0;
  }
  return std::sqrt(sum);
}

MetricType::Pointer
MakeMetric()
{
  const auto metric = MetricType::New();
  metric->SetScalePrior(1.0, MetricType::GetScaleSigma(itk::ContourMetricEnums::SpacingSource::Dicom));
  // The outliers' steps spoil the directions of their neighbours.
  metric->SetDirectionWeight(0.0);
  return metric;
}

MethodType::Pointer
MakeMethod(const ContourType * fixed, const TransformType * truth, itk::ReproducibleRandom & random)
{
  const auto method = MethodType::New();
  method->SetFixedContour(fixed);
  method->SetMovingContour(MakeOpenSilhouette());
  method->SetInitialTransform(MakeTransform(1.0,
                                            0.0,
                                            truth->GetOffset()[0] + random.Uniform(-25.0, 25.0),
                                            truth->GetOffset()[1] + random.Uniform(-25.0, 25.0)));
  method->SetNumberOfLevels(4);
  method->SetMetric(MakeMetric());
  return method;
}
} // namespace

TEST(PartialContourRegistration, StockOptimizersAndLeastSquaresRecoverAPartlyOverlappingOpenContour)
{
  // Standard error of the similarity over the traced part with 64 good points of 0.4 px: below 0.2 px.
  const std::vector<OptimizerType::Pointer> optimizers{ itk::LBFGSBOptimizerv4::New().GetPointer(),
                                                        itk::AmoebaOptimizerv4::New().GetPointer(),
                                                        itk::LevenbergMarquardtOptimizerv4::New().GetPointer() };
  for (const auto & optimizer : optimizers)
  {
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
    {
      itk::ReproducibleRandom random(seed);
      const auto              truth = MakeTruth(random);
      const auto              method = MakeMethod(MakeTracingWithOutliers(truth, random), truth, random);
      method->SetOptimizer(optimizer);
      method->Update();
      EXPECT_LT(TracedError(method->GetTransform(), truth), 0.5) << optimizer->GetNameOfClass() << ", seed " << seed;
      ASSERT_EQ(method->GetLevelResults().size(), 4u);
      for (const auto & result : method->GetLevelResults())
      {
        EXPECT_LE(result.finalValue, result.initialValue);
        EXPECT_NE(result.stopConditionDescription.find(optimizer->GetNameOfClass()), std::string::npos);
      }
    }
  }
}

TEST(PartialContourRegistration, PapersSymmetricMetricMissesTheSameCases)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    itk::ReproducibleRandom random(seed);
    const auto              truth = MakeTruth(random);
    const auto              method = MakeMethod(MakeTracingWithOutliers(truth, random), truth, random);
    method->SetMetric(nullptr);
    method->Update();
    EXPECT_GT(TracedError(method->GetTransform(), truth), 2.0) << "seed " << seed;
  }
}

TEST(PartialContourRegistration, EveryOptionTogetherRegistersAndARerunRepeats)
{
  itk::ReproducibleRandom random(3);
  const auto              truth = MakeTruth(random);
  const auto              method = MakeMethod(MakeTracingWithOutliers(truth, random), truth, random);
  const auto              metric = MakeMetric();
  metric->SetDirectionWeight(6.0);
  metric->SetReverseWeight(0.3);
  metric->CorrelatedNoiseOn();
  metric->SetRobustKernel(itk::ContourMetricEnums::RobustKernel::GemanMcClure);
  method->SetMetric(metric);
  method->SetOptimizer(itk::LevenbergMarquardtOptimizerv4::New());
  method->Update();
  EXPECT_LT(TracedError(method->GetTransform(), truth), 1.0);
  EXPECT_TRUE(metric->HasNoiseModel());
  // White noise of 0.4 px and no drift.
  EXPECT_NEAR(metric->GetNoiseLevels().white, 0.4, 0.15);
  EXPECT_NEAR(metric->ComputeOverlap(2.0).fixedShare, 0.8, 0.05);
  const auto first = method->GetTransform()->GetParameters();
  method->Update();
  EXPECT_EQ(method->GetTransform()->GetParameters(), first);
  method->Modified();
  method->Update();
  EXPECT_EQ(method->GetTransform()->GetParameters(), first);
}

TEST(PartialContourRegistration, ObserverMayDriveTheKernelWidth)
{
  itk::ReproducibleRandom random(4);
  const auto              truth = MakeTruth(random);
  const auto              method = MakeMethod(MakeTracingWithOutliers(truth, random), truth, random);
  const auto              metric = MakeMetric();
  metric->AnnealingOff();
  method->SetMetric(metric);
  method->SetOptimizer(itk::LevenbergMarquardtOptimizerv4::New());
  const double        widths[4] = { 20.0, 10.0, 5.0, 2.5 };
  std::vector<double> seen;
  method->AddObserver(itk::MultiResolutionIterationEvent(), [&](const itk::EventObject &) {
    metric->SetKernelWidth(widths[method->GetCurrentLevel()]);
    seen.push_back(metric->GetKernelWidth());
  });
  method->Update();
  EXPECT_EQ(seen, std::vector<double>(widths, widths + 4));
  EXPECT_LT(TracedError(method->GetTransform(), truth), 0.5);
}

TEST(PartialContourRegistration, AbortInsideTheLeastSquaresSolverStopsPromptly)
{
  itk::ReproducibleRandom random(5);
  const auto              truth = MakeTruth(random);
  const auto              method = MakeMethod(MakeTracingWithOutliers(truth, random), truth, random);
  method->SetOptimizer(itk::LevenbergMarquardtOptimizerv4::New());
  unsigned int iterations = 0;
  method->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    if (++iterations == 2)
    {
      method->AbortGenerateDataOn();
    }
  });
  EXPECT_THROW(method->Update(), itk::ProcessAborted);
  EXPECT_EQ(iterations, 2u);
}

TEST(PartialContourRegistration, MethodsInThreadsGiveTheSameBits)
{
  const auto run = [](MethodType::ParametersType & result) {
    itk::ReproducibleRandom random(6);
    const auto              truth = MakeTruth(random);
    const auto              method = MakeMethod(MakeTracingWithOutliers(truth, random), truth, random);
    dynamic_cast<MetricType *>(method->GetModifiableMetric())->CorrelatedNoiseOn();
    method->SetOptimizer(itk::LevenbergMarquardtOptimizerv4::New());
    method->Update();
    result = method->GetTransform()->GetParameters();
  };
  MethodType::ParametersType expected;
  run(expected);
  std::vector<MethodType::ParametersType> results(4);
  std::vector<std::thread>                threads;
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
