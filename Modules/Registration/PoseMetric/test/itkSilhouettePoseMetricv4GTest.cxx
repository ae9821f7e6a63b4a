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
#include "itkSilhouettePoseMetricv4.h"

#include "itkMessageOfCall.h"
#include "itkLeastSquaresMetricChecker.h"
#include "itkSilhouettePoseTestCase.h"

#include "itkContourNoiseModel.h"
#include "itkCorrelatedNoiseModel.h"
#include "itkGemanMcClureKernel.h"
#include "itkPoseStateBlocks.h"
#include "itkSquaresKernel.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>
#include <thread>
#include <tuple>
#include <vector>

namespace
{
using itk::MessageOfCall;
using MetricType = itk::SilhouettePoseMetricv4;
using SideEnum = itk::TracedSideEnum;
using Source = SilhouettePoseTestCase::Source;
using HoldEnum = MetricType::HoldEnum;

const SilhouettePoseTestCase &
Case(Source::TracedSideEnum side)
{
  static const SilhouettePoseTestCase right(71, Source::CohortEnum::Typical, Source::TracedSideEnum::Right);
  static const SilhouettePoseTestCase left(72, Source::CohortEnum::Typical, Source::TracedSideEnum::Left);
  static const SilhouettePoseTestCase mean(73, Source::CohortEnum::Typical, Source::TracedSideEnum::Mean);
  static const SilhouettePoseTestCase both(74, Source::CohortEnum::Typical, Source::TracedSideEnum::Both);
  switch (side)
  {
    case Source::TracedSideEnum::Left:
      return left;
    case Source::TracedSideEnum::Mean:
      return mean;
    case Source::TracedSideEnum::Both:
      return both;
    default:
      return right;
  }
}

/** The tracing with weights of its own, none alike. */
itk::DentalContour::Pointer
Weighted(const itk::DentalContour * tracing)
{
  auto         weighted = itk::DentalContour::New();
  unsigned int k = 0;
  for (auto polyline : tracing->GetPolylines())
  {
    for (std::size_t i = 0; i < polyline.points.size(); ++i)
    {
      polyline.weights.push_back(0.3 + 0.7 * (k++ % 11) / 10.0);
    }
    weighted->AddPolyline(polyline);
  }
  return weighted;
}

/** A jaw's term off the truth, so that no derivative is near 0. */
MetricType::Pointer
MakeMetric(Source::TracedSideEnum side = Source::TracedSideEnum::Right, unsigned int jaw = 0)
{
  const auto metric = Case(side).MakeMetric(jaw);
  metric->SetTracedSide(static_cast<SideEnum>(side));
  metric->SetFixedContour(Weighted(Case(side).contours[jaw]));
  auto pose = metric->GetBlockValues("pose");
  pose[0] += 0.01;
  pose[1] -= 0.02;
  pose[2] += 0.015;
  pose[3] += 0.3;
  pose[4] -= 0.8;
  pose[5] += 0.4;
  metric->SetBlockValues("pose", pose);
  metric->SetBlockValues("scale", { 0.004 });
  metric->Initialize();
  return metric;
}

int
ExerciseBasicObjectMethods()
{
  const auto metric = MakeMetric();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(metric, SilhouettePoseMetricv4, PoseMetricv4);
  ITK_TEST_SET_GET_BOOLEAN(metric, UseSideSelection, false);
  ITK_TEST_SET_GET_BOOLEAN(metric, UseFacingFilter, false);
  ITK_TEST_SET_GET_BOOLEAN(metric, UseOrientation, false);
  return EXIT_SUCCESS;
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(SilhouettePoseMetricv4, BasicObjectMethodsAndDefaults)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  const auto metric = MetricType::New();
  EXPECT_EQ(metric->GetJaw(), MetricType::JawEnum::Upper);
  EXPECT_EQ(metric->GetTracedSide(), SideEnum::Right);
  EXPECT_TRUE(metric->GetUseSideSelection());
  EXPECT_EQ(metric->GetMidlineMargin(), -0.5);
  EXPECT_TRUE(metric->GetUseFacingFilter());
  EXPECT_TRUE(metric->GetUseOrientation());
  EXPECT_EQ(metric->GetOrientationWeight(), 8.0);
  EXPECT_EQ(metric->GetMaximumTracingPoints(), 200u);
  EXPECT_TRUE(metric->GetExcludedTeeth().empty());
  EXPECT_STREQ(metric->GetPoseBlock(), "pose");
  EXPECT_STREQ(metric->GetScaleBlock(), "scale");
  EXPECT_EQ(metric->GetKernelWidth(), 3.0);
  EXPECT_STREQ(metric->GetRobustKernel()->GetNameOfClass(), "GemanMcClureKernel");
  const auto * noise = dynamic_cast<const itk::CorrelatedNoiseModel *>(metric->GetNoiseModel());
  ASSERT_NE(noise, nullptr);
  EXPECT_EQ(noise->GetCorrelationLength(), 14.0);
  itk::ContourNoiseLevels levels;
  EXPECT_TRUE(metric->GetNoiseLevels(levels));
  EXPECT_EQ(levels.smooth, 1.3);
  EXPECT_EQ(levels.white, 0.6);
  // The defaults of the method's settings are the metric's.
  const itk::PoseSilhouetteSettings settings;
  EXPECT_EQ(settings.midlineMargin, metric->GetMidlineMargin());
  EXPECT_EQ(settings.orientationWeight, metric->GetOrientationWeight());
  EXPECT_EQ(settings.maximumTracingPoints, metric->GetMaximumTracingPoints());
  std::ostringstream text;
  metric->Print(text);
  for (const char * name : { "MidlineMargin: -0.5", "KernelWidth: 3", "NoiseLevels: 1.3 0.6", "PoseBlock: pose" })
  {
    EXPECT_TRUE(Contains(text.str(), name)) << name;
  }
}

TEST(SilhouettePoseMetricv4, BlocksAreInMillimetresForAnOptimizer)
{
  EXPECT_EQ(itk::PoseStateBlocks::Arm, 64.0);
  const auto metric = MakeMetric();
  const auto pose = metric->GetBlockValues("pose");
  const auto parameters = metric->GetParameters();
  ASSERT_EQ(parameters.Size(), 7u);
  const double scales[7] = { 64.0, 64.0, 64.0, 1.0, 1.0, 1.0, 64.0 };
  const double steps[7] = { 6.4, 4.48, 4.48, 6.0, 6.0, 6.0, 1.92 };
  for (unsigned int k = 0; k < 7; ++k)
  {
    EXPECT_EQ(parameters[k], scales[k] * (k < 6 ? pose[k] : metric->GetBlockValues("scale")[0]));
    EXPECT_NEAR(metric->GetMaximumSteps()[k], steps[k], 1e-12);
  }
  EXPECT_EQ(metric->GetState().GetBlocks()[0].parameters[4].name, "ty");
}

TEST(SilhouettePoseMetricv4, BeginsWhereItsTransformIs)
{
  const auto metric = Case(Source::TracedSideEnum::Right).MakeMetric(0);
  const auto parameters = metric->GetTransform()->GetPoseParameters();
  for (unsigned int k = 0; k < 6; ++k)
  {
    EXPECT_EQ(metric->GetBlockValues("pose")[k], parameters[k]);
  }
  EXPECT_EQ(metric->GetBlockValues("scale")[0], parameters[6]);
}

/** Side, whether robust, whether correlated, jaw. */
class SilhouettePoseMetricv4Promises
  : public ::testing::TestWithParam<std::tuple<Source::TracedSideEnum, bool, bool, unsigned int>>
{};

TEST_P(SilhouettePoseMetricv4Promises, AreThoseOfEveryMetric)
{
  const auto [side, robust, correlated, jaw] = GetParam();
  const auto metric = MakeMetric(side, jaw);
  if (!robust)
  {
    metric->SetRobustKernel(itk::SquaresKernel::New());
  }
  if (!correlated)
  {
    auto white = itk::CorrelatedNoiseModel::New();
    white->SetCorrelationLength(0.0);
    metric->SetNoiseModel(white);
  }
  metric->SetNoiseLevels({ 0.9, 0.7 });
  metric->SetKernelWidth(3.5);
  metric->Initialize();
  LeastSquaresMetricChecker::Settings settings;
  // A contour is made on a grid of 2^-18 px: one that is moved there instead has residuals that differ by 4e-6 px, of
  // some 1 px.
  settings.heldTolerance = 2e-5;
  // Weights in a full covariance are no majoriser; the criterion is what a step is judged by.
  settings.residualsHaveTheGradient = false;
  // The gate of the facing and the width of the kernel bend the criterion more than any coordinate: with steps of
  // 1e-3 mm the third derivative leaves some 1e-6.
  settings.gradientTolerance = 1e-5;
  LeastSquaresMetricChecker::Check(*metric, settings);
}

INSTANTIATE_TEST_SUITE_P(Sides,
                         SilhouettePoseMetricv4Promises,
                         ::testing::Combine(::testing::Values(Source::TracedSideEnum::Right,
                                                              Source::TracedSideEnum::Left,
                                                              Source::TracedSideEnum::Mean,
                                                              Source::TracedSideEnum::Both),
                                            ::testing::Bool(),
                                            ::testing::Bool(),
                                            ::testing::Values(0u, 1u)));

TEST(SilhouettePoseMetricv4, ValueIsTheDocumentedCriterion)
{
  const auto metric = MakeMetric();
  metric->SetNoiseLevels({ 0.9, 0.7 });
  metric->SetKernelWidth(3.5);
  const auto          x = metric->GetState().GetValues();
  const auto &        tracing = metric->GetKernel().GetStrands()[0].tracing;
  itk::PoseParameters pose{ {} };
  std::copy(x.begin(), x.end(), pose.begin());
  const auto          lin = metric->GetKernel().Linearize(0, pose, metric->GetContours(x)[0], false);
  const std::size_t   n = tracing.Size();
  std::vector<double> correlation(n * n), weights(n), covariance(n * n), residuals = lin.residual;
  itk::ContourNoiseModel::ComputeCorrelation(
    tracing.arc.data(), lin.nu.data(), lin.nv.data(), n, 14.0, correlation.data());
  double charges = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double root = 3.5 * 3.5 / (3.5 * 3.5 + lin.squaredDistance[i]);
    const double weight = lin.facing[i] * root * root;
    weights[i] = tracing.weight[i] * weight;
    charges += tracing.weight[i] * (1.0 - std::sqrt(weight)) * (1.0 - std::sqrt(weight));
  }
  itk::ContourNoiseModel::ComputeCovariance(correlation.data(), weights.data(), n, { 0.9, 0.7 }, covariance.data());
  ASSERT_TRUE(itk::ContourNoiseModel::Factor(covariance.data(), n));
  itk::ContourNoiseModel::Whiten(covariance.data(), n, residuals.data(), 1);
  double expected = 3.5 * 3.5 / (0.7 * 0.7) * charges;
  for (const double r : residuals)
  {
    expected += r * r;
  }
  EXPECT_NEAR(metric->GetValue(), expected, 1e-9 * expected);
}

TEST(SilhouettePoseMetricv4, WithWhiteNoiseTheResidualsMajoriseTheCriterion)
{
  // Independent points that all face the same way as the contour and lie beside it: the weight of Black and Rangarajan
  // makes twice J'r the gradient.
  const auto metric = MakeMetric();
  auto       white = itk::CorrelatedNoiseModel::New();
  white->SetCorrelationLength(0.0);
  metric->SetNoiseModel(white);
  metric->SetNoiseLevels({ 0.0, 0.7 });
  metric->UseOrientationOff();
  metric->Initialize();
  MetricType::VectorType residuals;
  MetricType::MatrixType jacobian;
  metric->GetResiduals(residuals, &jacobian);
  const auto gradient = LeastSquaresMetricChecker::GradientOf(*metric);
  const auto ofResiduals = 2.0 * (residuals * jacobian);
  // A few points lie beyond an end of the contour, where the distance along it counts as well.
  EXPECT_LT((ofResiduals - gradient).magnitude(), 0.1 * gradient.magnitude());
  EXPECT_GT(gradient.magnitude(), 1.0);
}

TEST(SilhouettePoseMetricv4, IsSmallerAtTheTruthThanBesideIt)
{
  for (const unsigned int jaw : { 0u, 1u })
  {
    const auto metric = Case(Source::TracedSideEnum::Right).MakeMetric(jaw);
    metric->Initialize();
    const double least = metric->GetValue();
    const auto   truth = metric->GetParameters();
    for (unsigned int k = 0; k < 7; ++k)
    {
      for (const double step : { -3.0, 3.0 })
      {
        auto beside = truth;
        // Where the tracing says little, the noise may say more: roll, yaw and depth move the outline least.
        beside[k] += k == 1 || k == 2 || k == 4 ? 8.0 * step : step;
        EXPECT_GT(LeastSquaresMetricChecker::ValueAt(*metric, beside), least) << "parameter " << k;
      }
    }
  }
}

TEST(SilhouettePoseMetricv4, StepLengthIsHowFarTheContourMoves)
{
  const auto metric = MakeMetric();
  auto       to = metric->GetParameters();
  // A millimetre in front of a detector a tenth further: 1674/1524 of it, of 0.25 mm.
  to[5] += 1.0;
  const double magnification = metric->GetTransform()->GetPoseGeometry().sourceToDetector /
                               metric->GetTransform()->GetPoseGeometry().sourceToMidsagittal;
  EXPECT_NEAR(metric->GetStepLength(metric->GetParameters(), to), 4.0 * magnification, 0.1);
}

TEST(SilhouettePoseMetricv4, CorrelationOfTheNoiseStaysUntilItIsUpdated)
{
  const auto   metric = MakeMetric();
  const auto   start = metric->GetParameters();
  const double value = metric->GetValue();
  auto         elsewhere = start;
  elsewhere[0] += 8.0;
  const double before = LeastSquaresMetricChecker::ValueAt(*metric, elsewhere);
  // Going there and back changes nothing; normals taken elsewhere do.
  EXPECT_EQ(LeastSquaresMetricChecker::ValueAt(*metric, start), value);
  LeastSquaresMetricChecker::MoveTo(*metric, elsewhere);
  metric->UpdateNoiseCorrelation(metric->GetState().GetValues());
  EXPECT_NE(metric->GetValue(), before);
  LeastSquaresMetricChecker::MoveTo(*metric, start);
  metric->UpdateNoiseCorrelation(metric->GetState().GetValues());
  EXPECT_EQ(metric->GetValue(), value);
}

TEST(SilhouettePoseMetricv4, SettingsOfTheNoiseModelAreHeededWhenTheyChange)
{
  const auto metric = MakeMetric();
  auto       model = itk::CorrelatedNoiseModel::New();
  metric->SetNoiseModel(model);
  const double fourteen = metric->GetValue();
  model->SetCorrelationLength(30.0);
  const double thirty = metric->GetValue();
  EXPECT_NE(thirty, fourteen);
  auto other = itk::CorrelatedNoiseModel::New();
  other->SetCorrelationLength(30.0);
  metric->SetNoiseModel(other);
  EXPECT_EQ(metric->GetValue(), thirty);
}

TEST(SilhouettePoseMetricv4, EveryInputAndSettingChangesWhatItShould)
{
  const auto value = [](const std::function<void(MetricType &)> & change) {
    const auto metric = MakeMetric();
    metric->GetValue();
    change(*metric);
    metric->Initialize();
    return metric->GetValue();
  };
  const double plain = value([](MetricType &) {});
  EXPECT_EQ(plain, value([](MetricType &) {}));
  EXPECT_NE(plain, value([](MetricType & m) { m.SetJaw(MetricType::JawEnum::Lower); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.SetTracedSide(SideEnum::Left); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.UseSideSelectionOff(); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.SetMidlineMargin(-15.0); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.UseFacingFilterOff(); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.UseOrientationOff(); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.SetOrientationWeight(30.0); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.SetMaximumTracingPoints(20); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.SetExcludedTeeth({ 16 }); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.SetKernelWidth(9.0); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.SetRobustKernel(itk::SquaresKernel::New()); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.SetNoiseLevels({ 0.2, 2.0 }); }));
  EXPECT_NE(plain, value([](MetricType & m) { m.SetFixedContour(Case(Source::TracedSideEnum::Left).contours[0]); }));
  EXPECT_NE(plain, value([](MetricType & m) {
              m.SetMovingSurface(
                std::make_shared<const itk::TriangleSurface>(Case(Source::TracedSideEnum::Right).surfaces[1]));
            }));
  // Of another's noise nothing is taken.
  const auto other = itk::CorrelatedNoiseModel::New();
  EXPECT_EQ(plain, value([&](MetricType & m) { m.SetNoiseLevels({ 0.2, 2.0 }, other); }));
  EXPECT_FALSE([&] {
    itk::ContourNoiseLevels levels;
    return MakeMetric()->GetNoiseLevels(levels, other);
  }());
}

TEST(SilhouettePoseMetricv4, NamesOfItsBlocksMayBeSetInAnyOrder)
{
  const auto renamed = [](bool late) {
    const auto metric = MetricType::New();
    if (!late)
    {
      metric->SetPoseBlock("lower");
      metric->SetScaleBlock("view");
    }
    const auto made = Case(Source::TracedSideEnum::Right).MakeMetric(1);
    metric->SetTransform(made->GetTransform());
    metric->SetMovingSurface(made->GetMovingSurface());
    metric->SetFixedContour(made->GetFixedContour());
    metric->SetJaw(MetricType::JawEnum::Lower);
    if (late)
    {
      metric->SetPoseBlock("lower");
      metric->SetScaleBlock("view");
    }
    metric->Initialize();
    return metric;
  };
  const auto made = Case(Source::TracedSideEnum::Right).MakeMetric(1);
  made->Initialize();
  for (const bool late : { false, true })
  {
    const auto metric = renamed(late);
    EXPECT_EQ(metric->GetNumberOfParameters(), 7u) << late;
    EXPECT_EQ(metric->GetBlockValues("lower"), made->GetBlockValues("pose")) << late;
    EXPECT_FALSE(metric->GetState().HasBlock("pose")) << late;
    EXPECT_EQ(metric->GetValue(), made->GetValue()) << late;
  }
}

TEST(SilhouettePoseMetricv4, ClonesThatHoldMayRunInThreads)
{
  const auto metric = MakeMetric(Source::TracedSideEnum::Both);
  metric->Hold(HoldEnum::Matches);
  // Each with a kernel width of its own: what is held is shared, what follows from settings is not.
  std::vector<MetricType::Pointer>    clones;
  std::vector<MetricType::VectorType> expected(4), found(4);
  for (unsigned int i = 0; i < 4; ++i)
  {
    clones.push_back(metric->Clone());
    clones.back()->SetKernelWidth(2.0 + i);
    const MetricType::Pointer alone = MakeMetric(Source::TracedSideEnum::Both);
    alone->Hold(HoldEnum::Matches);
    alone->SetKernelWidth(2.0 + i);
    alone->GetResiduals(expected[i], nullptr);
  }
  std::vector<std::thread> threads;
  for (unsigned int i = 0; i < 4; ++i)
  {
    threads.emplace_back([&, i]() {
      for (unsigned int round = 0; round < 20; ++round)
      {
        clones[i]->GetResiduals(found[i], nullptr);
      }
    });
  }
  for (std::thread & thread : threads)
  {
    thread.join();
  }
  for (unsigned int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(found[i], expected[i]) << i;
  }
}

TEST(SilhouettePoseMetricv4, EstimatesTheNoiseThatATracingHas)
{
  // Drawn with 1.2 px of drift and 0.5 px of white noise; one jaw of 80 points knows them to some 30 %.
  const auto metric = Case(Source::TracedSideEnum::Right).MakeMetric(0);
  metric->Initialize();
  metric->EstimateNoise();
  itk::ContourNoiseLevels levels;
  metric->GetNoiseLevels(levels);
  EXPECT_GT(levels.smooth, 0.6);
  EXPECT_LT(levels.smooth, 2.4);
  EXPECT_GT(levels.white, 0.25);
  EXPECT_LT(levels.white, 1.0);
}

TEST(SilhouettePoseMetricv4, FitIsJudgedByAFixedWidth)
{
  const auto metric = MakeMetric(Source::TracedSideEnum::Both);
  const auto x = metric->GetState().GetValues();
  const auto statistics = metric->ComputeFitStatistics(x);
  ASSERT_EQ(statistics.size(), 2u) << "a strand a side";
  itk::RegistrationFit fit;
  metric->AddFit(x, fit);
  EXPECT_EQ(fit.numberOfPoints, statistics[0].numberOfPoints + statistics[1].numberOfPoints);
  EXPECT_NEAR(fit.GetMeanCost(),
              (statistics[0].cost * statistics[0].numberOfPoints + statistics[1].cost * statistics[1].numberOfPoints) /
                fit.numberOfPoints,
              1e-12);
  EXPECT_EQ(fit.numberOfCodedStrands, 2u);
  metric->SetKernelWidth(20.0);
  metric->SetNoiseLevels({ 5.0, 5.0 });
  itk::RegistrationFit other;
  metric->AddFit(x, other);
  EXPECT_EQ(other.cost, fit.cost);
}

TEST(SilhouettePoseMetricv4, ErrorsSayWhatToCall)
{
  auto       metric = MetricType::New();
  const auto initialize = [&] { return MessageOfCall([&] { metric->Initialize(); }); };
  EXPECT_TRUE(Contains(initialize(), "No transform: call SetTransform()"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { metric->GetKernel(); }), "call Initialize() or Prepare()"));
  const auto made = Case(Source::TracedSideEnum::Right).MakeMetric(0);
  metric->SetTransform(made->GetTransform());
  EXPECT_TRUE(Contains(initialize(), "No scan: call SetMovingMesh() or SetMovingSurface()"));
  metric->SetMovingSurface(made->GetMovingSurface());
  EXPECT_TRUE(Contains(initialize(), "No tracing: call SetFixedContour()"));
  const auto short4 = itk::DentalContour::New();
  auto       polyline = made->GetFixedContour()->GetPolylines()[0];
  polyline.points.resize(4);
  short4->AddPolyline(polyline);
  metric->SetFixedContour(short4);
  const std::string few = initialize();
  EXPECT_TRUE(Contains(few, "The tracing of the upper jaw cannot be matched: the tracing has 4 different points"))
    << few;
  // Preparing says so without an exception.
  metric->Prepare();
  EXPECT_TRUE(Contains(metric->GetFailure(), "at least 5 are needed"));
  metric->SetFixedContour(made->GetFixedContour());
  metric->SetMovingSurface(std::make_shared<const itk::TriangleSurface>());
  EXPECT_TRUE(Contains(initialize(), "there is no surface"));
  metric->SetMovingSurface(made->GetMovingSurface());
  metric->SetBlockFree("pose", false);
  metric->SetBlockFree("scale", false);
  EXPECT_TRUE(Contains(initialize(), "All parameters are held"));
  metric->SetBlockFree("pose", true);
  EXPECT_EQ(initialize(), "");
  EXPECT_TRUE(Contains(MessageOfCall([&] { metric->SetKernelWidth(0.0); }), "The kernel width 0 px must be positive"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { metric->SetRobustKernel(nullptr); }), "SquaresKernel is least squares"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { metric->SetNoiseModel(nullptr); }), "length 0 is independent noise"));
  metric->SetNoiseLevels({ 1.0, 0.0 });
  metric->SetRobustKernel(itk::SquaresKernel::New());
  auto constant = itk::CorrelatedNoiseModel::New();
  constant->SetCorrelationLength(1e6);
  metric->SetNoiseModel(constant);
  EXPECT_TRUE(Contains(MessageOfCall([&] { metric->GetValue(); }), "is not positive definite"));
}
