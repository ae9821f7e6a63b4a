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
#include "itkLandmarkPoseMetricv4.h"

#include "itkMessageOfCall.h"
#include "itkLeastSquaresMetricChecker.h"

#include "itkCorrelatedNoiseModel.h"
#include "itkGemanMcClureKernel.h"
#include "itkLeastSquaresSumMetricv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkParameterPriorMetricv4.h"
#include "itkPoseStateBlocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{
using MetricType = itk::LandmarkPoseMetricv4;
using TransformType = itk::CephalometricPoseTransform;

const double Truth[7] = { 0.12, -0.03, 0.05, 55.0, 1.5, -40.0, 0.01 };

TransformType::Pointer
MakeTransform(const double * parameters)
{
  auto                                         geometry = itk::CephalometricGeometry::New();
  itk::CephalometricGeometry::PixelSpacingType spacing;
  spacing[0] = 0.2;
  spacing[1] = 0.3;
  geometry->SetPixelSpacing(spacing);
  geometry->SetFacing(itk::CephalometricGeometry::FacingEnum::Left);
  auto transform = TransformType::New();
  transform->SetGeometry(geometry);
  TransformType::ParametersType values(7);
  for (unsigned int k = 0; k < 7; ++k)
  {
    values[k] = parameters[k];
  }
  transform->SetParameters(values);
  return transform;
}

itk::DentalLandmarkSet<3>::Pointer
MakeScanLandmarks()
{
  auto         landmarks = itk::DentalLandmarkSet<3>::New();
  const double places[6][3] = { { 24.0, -4.0, 1.0 },   { 18.0, -14.0, 0.0 }, { 2.0, -20.0, -1.0 },
                                { -18.0, -25.0, 2.0 }, { 24.5, 4.0, 1.0 },   { -17.0, 25.0, 1.5 } };
  const char * names[6] = { "UR1_tip", "UR3_cusp", "UR5_B", "UR6_MB", "UL1_tip", "UL6_MB" };
  for (unsigned int i = 0; i < 6; ++i)
  {
    landmarks->AddLandmark(names[i], itk::Point<double, 3>(places[i]));
  }
  return landmarks;
}

/** Where the truth puts them, moved by some pixels; one name that the scan has not. */
itk::DentalLandmarkSet<2>::Pointer
MakeMarks(double error)
{
  auto       marks = itk::DentalLandmarkSet<2>::New();
  const auto transform = MakeTransform(Truth);
  double     sign = 1.0;
  const auto scan = MakeScanLandmarks();
  for (const auto & landmark : scan->GetLandmarks())
  {
    auto pixel = transform->TransformPoint(landmark.point);
    pixel[0] += sign * error;
    pixel[1] -= 0.6 * sign * error;
    sign = -1.3 * sign;
    marks->AddLandmark(landmark.name, pixel);
  }
  marks->AddLandmark("LR1_tip", itk::Point<double, 2>(1.0));
  return marks;
}

MetricType::Pointer
MakeMetric(const double * start, double error)
{
  auto metric = MetricType::New();
  metric->SetTransform(MakeTransform(start));
  metric->SetMovingLandmarks(MakeScanLandmarks());
  metric->SetFixedLandmarks(MakeMarks(error));
  MetricType::CovarianceType covariance;
  covariance(0, 0) = 9.0;
  covariance(0, 1) = covariance(1, 0) = 2.5;
  covariance(1, 1) = 4.0;
  metric->SetCovariance("UR6_MB", covariance);
  return metric;
}

std::string
MessageOfInitialize(MetricType * metric)
{
  return itk::MessageOfCall([&] { metric->Initialize(); });
}
} // namespace

TEST(LandmarkPoseMetricv4, MatchesByNameAndWeighsByTheCovarianceOfEachMark)
{
  const auto metric = MakeMetric(Truth, 3.0);
  metric->Initialize();
  EXPECT_EQ(metric->GetMatchedNames().size(), 6u);
  EXPECT_EQ(metric->GetNumberOfResiduals(), 12u);
  // d' C^-1 d by hand: the errors are (1, -0.6) 3 px times 1, -1.3, 1.3^2, ...; UR6_MB is the fourth.
  double expected = 0.0;
  double size = 3.0;
  for (unsigned int i = 0; i < 6; ++i, size *= -1.3)
  {
    const double u = size;
    const double v = -0.6 * size;
    const double determinant = 9.0 * 4.0 - 2.5 * 2.5;
    expected += i == 3 ? (4.0 * u * u - 2.0 * 2.5 * u * v + 9.0 * v * v) / determinant : (u * u + v * v) / 16.0;
  }
  EXPECT_NEAR(metric->GetValue(), expected, 1e-9 * expected);
}

TEST(LandmarkPoseMetricv4, DerivativesMatchDifferences)
{
  double start[7];
  for (unsigned int k = 0; k < 7; ++k)
  {
    start[k] = Truth[k] + (k < 3 || k == 6 ? 0.004 : 0.4);
  }
  for (const bool robust : { false, true })
  {
    const auto metric = MakeMetric(start, 6.0);
    if (robust)
    {
      metric->SetRobustKernel(itk::GemanMcClureKernel::New());
      metric->SetKernelWidthInSigmas(2.0);
    }
    metric->Initialize();
    MetricType::DerivativeType derivative;
    MetricType::MeasureType    value;
    metric->GetValueAndDerivative(value, derivative);
    vnl_vector<double> residuals;
    vnl_matrix<double> jacobian;
    metric->GetResiduals(residuals, &jacobian);
    const MetricType::ParametersType x = metric->GetParameters();
    for (unsigned int k = 0; k < 7; ++k)
    {
      const double               step = 1e-4;
      MetricType::ParametersType a = x;
      MetricType::ParametersType b = x;
      a[k] -= step;
      b[k] += step;
      metric->SetParameters(a);
      const double before = metric->GetValue();
      metric->SetParameters(b);
      const double after = metric->GetValue();
      // A v4 metric returns minus the gradient; differences of second order leave the step squared.
      EXPECT_NEAR(-derivative[k], (after - before) / (2.0 * step), 1e-5 * (1.0 + std::abs(derivative[k]))) << k;

      auto moving = x;
      metric->SetParameters(moving);
      metric->Hold(MetricType::HoldEnum::Matches);
      vnl_vector<double> low, high;
      metric->SetParameters(a);
      metric->GetResiduals(low, nullptr);
      metric->SetParameters(b);
      metric->GetResiduals(high, nullptr);
      metric->Hold(MetricType::HoldEnum::Nothing);
      for (unsigned int i = 0; i < residuals.size(); ++i)
      {
        EXPECT_NEAR(jacobian(i, k), (high[i] - low[i]) / (2.0 * step), 1e-6) << i << ", " << k;
      }
    }
  }
}

TEST(LandmarkPoseMetricv4, WithPriorsFindsThePoseThatMadeTheMarks)
{
  const double start[7] = { 0.0, 0.0, 0.0, 45.0, 0.0, -30.0, 0.0 };
  const auto   metric = MakeMetric(start, 0.0);
  auto         prior = itk::ParameterPriorMetricv4::New();
  prior->SetBlock(itk::PoseStateBlocks::MakePose());
  std::vector<itk::ParameterPriorMetricv4::PriorType> priors(6);
  for (auto & p : priors)
  {
    p.sigma = std::numeric_limits<double>::infinity();
  }
  // Depth and scale are one unknown: ty is what the truth says.
  priors[4] = { 1.5, 0.01, 0.0 };
  prior->SetPriors(priors);
  auto sum = itk::LeastSquaresSumMetricv4::New();
  sum->AddMetric(metric);
  sum->AddMetric(prior);
  sum->Initialize();
  auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
  optimizer->SetMetric(sum);
  optimizer->StartOptimization();
  EXPECT_TRUE(optimizer->HasConverged());
  const auto pose = sum->GetBlockValues("pose");
  for (unsigned int k = 0; k < 6; ++k)
  {
    EXPECT_NEAR(pose[k], Truth[k], k < 3 ? 1e-4 : 1e-2) << k;
  }
  EXPECT_NEAR(sum->GetBlockValues("scale")[0], Truth[6], 1e-3);
}

TEST(LandmarkPoseMetricv4, ARobustKernelLetsAGrossErrorGo)
{
  const double start[7] = { 0.12, -0.03, 0.05, 55.0, 1.5, -40.0, 0.01 };
  auto         marks = MakeMarks(0.0);
  auto         wrong = itk::DentalLandmarkSet<2>::New();
  for (const auto & mark : marks->GetLandmarks())
  {
    auto point = mark.point;
    point[0] += mark.name == "UR3_cusp" ? 90.0 : 0.0;
    wrong->AddLandmark(mark.name, point);
  }
  const auto moved = [&](bool robust) {
    const auto metric = MakeMetric(start, 0.0);
    metric->SetFixedLandmarks(wrong);
    if (robust)
    {
      metric->SetRobustKernel(itk::GemanMcClureKernel::New());
    }
    // Six landmarks do not determine all seven; the shift is what an error pulls.
    metric->SetBlockFree("pose", { false, false, false, true, false, true });
    metric->SetBlockFree("scale", false);
    metric->Initialize();
    auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
    optimizer->SetMetric(metric);
    optimizer->StartOptimization();
    return std::abs(metric->GetBlockValues("pose")[3] - Truth[3]);
  };
  EXPECT_GT(moved(false), 1.0);
  EXPECT_LT(moved(true), 0.05);
}

TEST(LandmarkPoseMetricv4, SaysWhatToCall)
{
  auto metric = MetricType::New();
  EXPECT_NE(MessageOfInitialize(metric).find("SetTransform()"), std::string::npos);
  metric->SetTransform(MakeTransform(Truth));
  EXPECT_NE(MessageOfInitialize(metric).find("SetMovingLandmarks()"), std::string::npos);
  metric->SetMovingLandmarks(MakeScanLandmarks());
  EXPECT_NE(MessageOfInitialize(metric).find("SetFixedLandmarks()"), std::string::npos);
  auto others = itk::DentalLandmarkSet<2>::New();
  others->AddLandmark("LL7_DB", itk::Point<double, 2>(3.0));
  metric->SetFixedLandmarks(others);
  const std::string message = MessageOfInitialize(metric);
  EXPECT_NE(message.find("LL7_DB"), std::string::npos);
  EXPECT_NE(message.find("UR1_tip"), std::string::npos);
  metric->SetFixedLandmarks(MakeMarks(0.0));
  MetricType::CovarianceType flat;
  flat.Fill(1.0);
  metric->SetCovariance("UR1_tip", flat);
  EXPECT_NE(MessageOfInitialize(metric).find("SetCovariance()"), std::string::npos);
}

TEST(LandmarkPoseMetricv4, ACloneHasTheSameBitsAndAStateOfItsOwn)
{
  const auto metric = MakeMetric(Truth, 2.0);
  metric->Initialize();
  const MetricType::Pointer clone = metric->Clone();
  EXPECT_EQ(clone->GetValue(), metric->GetValue());
  clone->SetBlockValues("scale", { 0.1 });
  EXPECT_NE(clone->GetValue(), metric->GetValue());
  EXPECT_EQ(metric->GetBlockValues("scale")[0], Truth[6]);
}

TEST(LandmarkPoseMetricv4, AChangeOfWhatItMeasuresIsOneOfItsTimeAndTheSameAgainIsNone)
{
  auto       metric = MakeMetric(Truth, 2.0);
  const auto kernel = itk::GemanMcClureKernel::New();
  auto       scan = MakeScanLandmarks();
  auto       marks = MakeMarks(1.0);
  const auto transform = MakeTransform(Truth);
  metric->SetTransform(transform);
  metric->SetMovingLandmarks(scan);
  metric->SetFixedLandmarks(marks);
  const auto changesIts = [&](const auto & change) {
    const auto before = metric->GetMTime();
    change();
    return metric->GetMTime() > before;
  };
  EXPECT_TRUE(changesIts([&] { metric->SetRobustKernel(kernel); }));
  EXPECT_FALSE(changesIts([&] { metric->SetRobustKernel(kernel); }));
  EXPECT_TRUE(changesIts([&] { metric->SetSigma(3.0); }));
  EXPECT_FALSE(changesIts([&] { metric->SetSigma(3.0); }));
  EXPECT_TRUE(changesIts([&] { metric->SetKernelWidthInSigmas(5.0); }));
  EXPECT_FALSE(changesIts([&] { metric->SetKernelWidthInSigmas(5.0); }));
  EXPECT_FALSE(changesIts([&] { metric->SetKernelWidth(5.0); })) << "the sum's, in pixels, is not this metric's";
  // What it refers to.
  EXPECT_TRUE(changesIts([&] { kernel->Modified(); }));
  EXPECT_TRUE(changesIts([&] { scan->Modified(); }));
  EXPECT_TRUE(changesIts([&] { marks->Modified(); }));
  EXPECT_TRUE(changesIts([&] { transform->Modified(); }));
}

namespace
{
/** Counterparts of an analysis's landmarks: an incisor's two tips, a molar's two cusps, one cusp of one side. */
itk::LandmarkCounterpartSet::Pointer
MakeCounterparts()
{
  using SetType = itk::LandmarkCounterpartSet;
  auto       set = SetType::New();
  const auto scan = MakeScanLandmarks();
  const auto point = [&](const char * name) { return scan->Find(name)->point; };
  set->Add({ "U1_tip",
             itk::ToothCode::JawEnum::Upper,
             { point("UR1_tip"), point("UL1_tip") },
             SetType::RuleEnum::Foremost,
             0.0,
             0.0,
             "by hand" });
  set->Add({ "U6_MB",
             itk::ToothCode::JawEnum::Upper,
             { point("UR6_MB"), point("UL6_MB") },
             SetType::RuleEnum::Middle,
             0.0,
             0.0,
             "by hand" });
  set->Add({ "UR3_cusp",
             itk::ToothCode::JawEnum::Upper,
             { point("UR3_cusp") },
             SetType::RuleEnum::Middle,
             3.0,
             4.0,
             "by hand" });
  return set;
}

/** Where the truth puts them. */
itk::CephalometricLandmarkSet::Pointer
MakeAnalysis()
{
  const auto transform = MakeTransform(Truth);
  const auto scan = MakeScanLandmarks();
  const auto image = [&](const char * name) { return transform->TransformPoint(scan->Find(name)->point); };
  auto       marks = itk::CephalometricLandmarkSet::New();
  // Facing left: the foremost is the one of the smaller u.
  const auto right = image("UR1_tip");
  const auto left = image("UL1_tip");
  marks->AddLandmark("Is", right[0] < left[0] ? right : left);
  itk::Point<double, 2> middle;
  middle.SetToMidPoint(image("UR6_MB"), image("UL6_MB"));
  marks->AddLandmark("U6_MB", middle, 2.0);
  marks->AddLandmark("UR3_cusp", image("UR3_cusp"), 0.0, 0.4);
  marks->AddLandmark("Ii", middle);
  return marks;
}

MetricType::Pointer
MakeAnalysisMetric(const double * start)
{
  auto metric = MetricType::New();
  metric->SetTransform(MakeTransform(start));
  metric->SetCounterparts(MakeCounterparts());
  metric->SetCephalometricLandmarks(MakeAnalysis());
  return metric;
}
} // namespace

TEST(LandmarkPoseMetricv4, AnAnalysissLandmarkIsTheForemostOrTheMiddleOfTwo)
{
  const auto metric = MakeAnalysisMetric(Truth);
  metric->Initialize();
  EXPECT_EQ(metric->GetMatchedNames(), (std::vector<std::string>{ "U1_tip", "U6_MB", "UR3_cusp" }));
  EXPECT_NEAR(metric->GetValue(), 0.0, 1e-15);
  // Turned the other way the other incisor is foremost: chosen where matches are held, not in between.
  double turned[7];
  std::copy(std::begin(Truth), std::end(Truth), turned);
  turned[2] = -turned[2];
  const auto other = MakeAnalysisMetric(turned);
  other->Initialize();
  metric->SetValues(std::vector<double>(turned, turned + 7));
  EXPECT_NE(metric->GetValue(), other->GetValue());
  metric->Hold(MetricType::HoldEnum::Matches);
  metric->Hold(MetricType::HoldEnum::Nothing);
  EXPECT_EQ(metric->GetValue(), other->GetValue());
}

TEST(LandmarkPoseMetricv4, ErrorsOfAnAnalysisAreTheMarksThenTheReaders)
{
  const auto metric = MakeAnalysisMetric(Truth);
  metric->Initialize();
  double moved[7];
  std::copy(std::begin(Truth), std::end(Truth), moved);
  moved[3] += 2.0;
  const std::vector<double> x(moved, moved + 7);
  const auto                residuals = metric->ComputeLandmarkResiduals(x);
  ASSERT_EQ(residuals.size(), 3u);
  // Pixels of 0.2 x 0.3 mm, magnification 1674 / 1524.
  const double magnification = 1674.0 / 1524.0;
  const double factor = MetricType::ComputeConfidenceFactor(0.4);
  EXPECT_GT(factor, 1.0);
  EXPECT_LT(MetricType::ComputeConfidenceFactor(1.0), 1.0);
  const double sigmas[3][2] = { { MetricType::ReaderSigmaAlong / 0.2, MetricType::ReaderSigmaAcross / 0.3 },
                                { 2.0, 2.0 },
                                { std::hypot(factor * MetricType::ReaderSigmaAlong, 3.0 * magnification) / 0.2,
                                  std::hypot(factor * MetricType::ReaderSigmaAcross, 4.0 * magnification) / 0.3 } };
  for (unsigned int i = 0; i < 3; ++i)
  {
    EXPECT_GT(std::abs(residuals[i].difference[0]), 5.0);
    EXPECT_NEAR(residuals[i].distance,
                std::hypot(residuals[i].difference[0] / sigmas[i][0], residuals[i].difference[1] / sigmas[i][1]),
                1e-9)
      << residuals[i].name;
  }
}

TEST(LandmarkPoseMetricv4, DerivativesOfTwoPointsMatchDifferences)
{
  double start[7];
  for (unsigned int k = 0; k < 7; ++k)
  {
    start[k] = Truth[k] + (k < 3 || k == 6 ? 0.004 : 0.4);
  }
  const auto metric = MakeAnalysisMetric(start);
  metric->SetRobustKernel(itk::GemanMcClureKernel::New());
  metric->Initialize();
  metric->Hold(MetricType::HoldEnum::Matches);
  vnl_vector<double> residuals;
  vnl_matrix<double> jacobian;
  metric->GetResiduals(residuals, &jacobian);
  const MetricType::ParametersType x = metric->GetParameters();
  for (unsigned int k = 0; k < 7; ++k)
  {
    const double               step = 1e-4;
    MetricType::ParametersType a = x;
    MetricType::ParametersType b = x;
    a[k] -= step;
    b[k] += step;
    vnl_vector<double> low, high;
    metric->SetParameters(a);
    metric->GetResiduals(low, nullptr);
    metric->SetParameters(b);
    metric->GetResiduals(high, nullptr);
    for (unsigned int i = 0; i < residuals.size(); ++i)
    {
      EXPECT_NEAR(jacobian(i, k), (high[i] - low[i]) / (2.0 * step), 1e-6) << i << ", " << k;
    }
  }
}

/** What every least-squares metric promises, of marks with counterparts by name and of those of an analysis, whose
 * foremost incisor and middle of molars are two points each. */
TEST(LandmarkPoseMetricv4, KeepsThePromisesOfALeastSquaresMetric)
{
  double start[7];
  for (unsigned int k = 0; k < 7; ++k)
  {
    start[k] = Truth[k] + (k < 3 || k == 6 ? 0.004 : 0.4);
  }
  for (const bool robust : { false, true })
  {
    for (const auto & metric : { MakeMetric(start, 6.0), MakeAnalysisMetric(start) })
    {
      if (robust)
      {
        metric->SetRobustKernel(itk::GemanMcClureKernel::New());
        metric->SetKernelWidthInSigmas(2.0);
      }
      metric->Initialize();
      LeastSquaresMetricChecker::Settings settings;
      // A kernel of two standard deviations bends the criterion: with the differences' steps its third derivative
      // leaves some 1e-6 of the gradient.
      settings.gradientTolerance = robust ? 1e-5 : settings.gradientTolerance;
      LeastSquaresMetricChecker::Check(*metric, settings);
    }
  }
}

TEST(LandmarkPoseMetricv4, EvaluatedBeforeItIsPreparedSaysWhatToCall)
{
  const auto         metric = itk::LandmarkPoseMetricv4::New();
  vnl_vector<double> residuals;
  const auto         expectMessage = [](const std::function<void()> & call, const std::string & words) {
    try
    {
      call();
      ADD_FAILURE() << "no error";
    }
    catch (const itk::ExceptionObject & error)
    {
      EXPECT_NE(std::string(error.GetDescription()).find(words), std::string::npos) << error.GetDescription();
    }
  };
  expectMessage([&] { metric->GetValue(); }, "Initialize()");
  expectMessage([&] { metric->GetResiduals(residuals, nullptr); }, "Initialize()");
  expectMessage([&] { metric->ComputeLandmarkResiduals(metric->GetState().GetValues()); }, "SetTransform()");
  metric->SetTransform(itk::CephalometricPoseTransform::New());
  expectMessage([&] { metric->GetValue(); }, "Initialize()");
  const auto sum = itk::LeastSquaresSumMetricv4::New();
  sum->AddMetric(metric);
  expectMessage([&] { sum->GetValue(); }, "Initialize()");
  metric->SetTransform(nullptr);
  expectMessage([&] { metric->GetValue(); }, "SetTransform()");
}
