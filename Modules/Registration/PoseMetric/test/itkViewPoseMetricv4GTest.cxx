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
#include "itkViewPoseMetricv4.h"

#include "itkMessageOfCall.h"
#include "itkLeastSquaresMetricChecker.h"

#include "itkCorrelatedNoiseModel.h"
#include "itkGemanMcClureKernel.h"
#include "itkLandmarkPoseMetricv4.h"
#include "itkLeastSquaresSumMetricv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkParameterPriorMetricv4.h"
#include "itkPoseComposition.h"
#include "itkPoseStateBlocks.h"
#include "itkSilhouettePoseTestCase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
using MetricType = itk::ViewPoseMetricv4;
using TransformType = itk::CephalometricPoseTransform;
using GeometryType = itk::CephalometricGeometry;

const std::vector<double> Pose{ 0.12, -0.03, 0.05, 55.0, 1.5, -40.0 };
const std::vector<double> Move{ 0.04, 0.02, -0.03, 1.0, -1.5, 0.5 };
constexpr double          Kappa = 0.01;

TransformType::Pointer
MakeTransform(GeometryType::DirectionEnum direction)
{
  auto geometry = GeometryType::New();
  geometry->SetDirection(direction);
  geometry->SetPixelSpacing(GeometryType::PixelSpacingType(0.25));
  auto transform = TransformType::New();
  transform->SetGeometry(geometry);
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

/** Marks where pose, move and kappa put them, moved by some pixels. */
itk::DentalLandmarkSet<2>::Pointer
MakeMarks(const TransformType & original, const std::vector<double> & x, double error)
{
  auto                          transform = TransformType::New();
  TransformType::ParametersType parameters(7);
  const auto                    position = MetricType::MakeTermPosition(x);
  std::copy(position.begin(), position.end(), parameters.data_block());
  transform->SetFixedParameters(original.GetFixedParameters());
  transform->SetParameters(parameters);
  auto   marks = itk::DentalLandmarkSet<2>::New();
  double sign = 1.0;
  // Kept for the loop: a temporary set would be gone in it.
  const auto scan = MakeScanLandmarks();
  for (const auto & landmark : scan->GetLandmarks())
  {
    auto pixel = transform->TransformPoint(landmark.point);
    pixel[0] += sign * error;
    pixel[1] -= 0.6 * sign * error;
    sign = -1.3 * sign;
    marks->AddLandmark(landmark.name, pixel);
  }
  return marks;
}

itk::LandmarkPoseMetricv4::Pointer
MakeTerm(GeometryType::DirectionEnum direction, const std::vector<double> & x, double error)
{
  auto       term = itk::LandmarkPoseMetricv4::New();
  const auto transform = MakeTransform(direction);
  term->SetTransform(transform);
  term->SetMovingLandmarks(MakeScanLandmarks());
  term->SetFixedLandmarks(MakeMarks(*transform, x, error));
  return term;
}

std::vector<double>
Truth()
{
  std::vector<double> x = Pose;
  x.insert(x.end(), Move.begin(), Move.end());
  x.push_back(Kappa);
  return x;
}

MetricType::Pointer
MakeMetric(double error)
{
  auto metric = MetricType::New();
  metric->SetView("frontal");
  metric->SetTerm(MakeTerm(GeometryType::DirectionEnum::Frontal, Truth(), error));
  return metric;
}

std::string
MessageOfInitialize(MetricType * metric)
{
  return itk::MessageOfCall([&] { metric->Initialize(); });
}
} // namespace

TEST(ViewPoseMetricv4, ReadsTheBodyTheMoveAndTheScaleOfItsView)
{
  const auto metric = MakeMetric(0.0);
  const auto blocks = metric->GetState().GetBlocks();
  ASSERT_EQ(blocks.size(), 3u);
  EXPECT_EQ(blocks[0].name, "pose");
  EXPECT_EQ(blocks[1].name, "frontal move");
  EXPECT_EQ(blocks[2].name, "frontal scale");
  metric->SetValues(Truth());
  metric->Initialize();
  EXPECT_NEAR(metric->GetValue(), 0.0, 1e-18);
  auto away = Truth();
  away[6] += 0.01;
  metric->SetValues(away);
  EXPECT_GT(metric->GetValue(), 1.0);
}

TEST(ViewPoseMetricv4, DerivativesMatchDifferences)
{
  for (const bool robust : { false, true })
  {
    const auto metric = MakeMetric(3.0);
    if (robust)
    {
      metric->SetRobustKernel(itk::GemanMcClureKernel::New());
    }
    metric->SetValues(Truth());
    metric->Initialize();
    LeastSquaresMetricChecker::Settings settings;
    settings.gradientTolerance = robust ? 1e-5 : settings.gradientTolerance;
    LeastSquaresMetricChecker::Check(*metric, settings);
  }
}

TEST(ViewPoseMetricv4, ASilhouetteOfAnotherViewKeepsEveryPromise)
{
  using Source = itk::DentalPhantomCaseSource;
  const SilhouettePoseTestCase phantom(71, Source::CohortEnum::Typical, Source::TracedSideEnum::Right);
  auto                         metric = MetricType::New();
  metric->SetView("second");
  const auto term = phantom.MakeMetric(0);
  metric->SetTerm(term);
  // The same film once more, the head moved: where the body's pose and the move cancel, the values are the term's own.
  const auto                            own = phantom.MakeMetric(0);
  const itk::PoseParameters             pose = phantom.MakeTransform(0)->GetPoseParameters();
  const std::vector<double>             position(pose.begin(), pose.end());
  itk::LeastSquaresMetricv4::VectorType expected, residuals;
  own->SetNoiseModel(itk::CorrelatedNoiseModel::New());
  metric->SetNoiseModel(itk::CorrelatedNoiseModel::New());
  own->SetValues(position);
  own->Initialize();
  std::vector<double> x(position.begin(), position.begin() + 6);
  x.resize(12, 0.0);
  x.push_back(position[6]);
  metric->SetValues(x);
  metric->Initialize();
  own->ComputeResiduals(position, expected, nullptr);
  metric->ComputeResiduals(x, residuals, nullptr);
  ASSERT_EQ(residuals.size(), expected.size());
  for (unsigned int i = 0; i < residuals.size(); ++i)
  {
    ASSERT_NEAR(residuals[i], expected[i], 1e-9);
  }
  EXPECT_EQ(metric->GetNumberOfResiduals(), own->GetNumberOfResiduals());
  std::vector<itk::ResidualNoiseBlock> blocks;
  metric->AppendNoiseBlocks(x, blocks);
  ASSERT_FALSE(blocks.empty());
  EXPECT_EQ(blocks[0].jacobian.size(), blocks[0].count * x.size());
  itk::ContourNoiseLevels levels;
  EXPECT_TRUE(metric->GetNoiseLevels(levels));
  metric->SetNoiseLevels({ 0.8, 0.4 });
  term->GetNoiseLevels(levels);
  EXPECT_EQ(levels.smooth, 0.8);

  x[6] = 0.01;
  x[10] = 0.4;
  metric->SetValues(x);
  LeastSquaresMetricChecker::Settings settings;
  // As of the term itself (SilhouettePoseMetricv4Promises).
  settings.heldTolerance = 2e-5;
  settings.residualsHaveTheGradient = false;
  settings.gradientTolerance = 1e-5;
  LeastSquaresMetricChecker::Check(*metric, settings);
}

TEST(ViewPoseMetricv4, TwoViewsTellWhatOneCannot)
{
  auto lateral = MakeTerm(
    GeometryType::DirectionEnum::Lateral,
    [] {
      std::vector<double> x = Pose;
      x.resize(13, 0.0);
      return x;
    }(),
    0.0);
  auto frontal = MakeMetric(0.0);
  auto sum = itk::LeastSquaresSumMetricv4::New();
  sum->AddMetric(lateral);
  sum->AddMetric(frontal);
  // The move is known but for the truth that it has here.
  sum->SetBlockValues("frontal move", Move);
  sum->SetBlockFree("frontal move", false);
  sum->SetBlockValues("pose", { 0.05, 0.0, 0.0, 50.0, -3.0, -45.0 });
  sum->Initialize();
  auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
  optimizer->SetMetric(sum);
  optimizer->SetNumberOfIterations(60);
  optimizer->StartOptimization();
  const auto found = sum->GetBlockValues("pose");
  for (unsigned int k = 0; k < 6; ++k)
  {
    EXPECT_NEAR(found[k], Pose[k], k < 3 ? 1e-5 : 1e-3) << k;
  }
  EXPECT_NEAR(sum->GetBlockValues("frontal scale")[0], Kappa, 1e-5);
  EXPECT_NEAR(sum->GetBlockValues("scale")[0], 0.0, 1e-5);
}

TEST(ViewPoseMetricv4, AClonesTermIsItsOwn)
{
  const auto metric = MakeMetric(3.0);
  metric->SetValues(Truth());
  metric->Initialize();
  const auto value = metric->GetValue();
  const auto object = metric->Clone();
  auto *     clone = dynamic_cast<MetricType *>(object.GetPointer());
  ASSERT_NE(clone, nullptr);
  EXPECT_NE(clone->GetTerm(), metric->GetTerm());
  EXPECT_STREQ(clone->GetView(), "frontal");
  EXPECT_EQ(clone->GetValue(), value);
}

TEST(ViewPoseMetricv4, TakesNoPartInTheStartAndKnowsWhatItsTermKnows)
{
  const auto metric = MakeMetric(2.0);
  EXPECT_EQ(metric->GetJoins(), itk::ViewPoseMetricv4::JoinsEnum::Candidates);
  EXPECT_EQ(metric->Clone()->GetJoins(), itk::ViewPoseMetricv4::JoinsEnum::Candidates);
  metric->Initialize();
  const double known = metric->ComputeKnownDeviance(Truth(), true);
  EXPECT_GT(known, 0.0);
  EXPECT_EQ(known, metric->GetTerm()->ComputeKnownDeviance(MetricType::MakeTermPosition(Truth()), true));
}

TEST(ViewPoseMetricv4, SaysWhatIsMissing)
{
  auto metric = MetricType::New();
  metric->SetView("frontal");
  EXPECT_NE(MessageOfInitialize(metric).find("SetTerm()"), std::string::npos);
  auto nameless = MetricType::New();
  nameless->SetTerm(MakeTerm(GeometryType::DirectionEnum::Frontal, Truth(), 0.0));
  EXPECT_NE(MessageOfInitialize(nameless).find("SetView()"), std::string::npos);
}
