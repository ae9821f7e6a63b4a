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
// What SilhouettePoseMetricv4 can do beside the default: the tooth gate, the reverse direction, and an outline in place
// of a scan.
#include "itkSilhouettePoseMetricv4.h"

#include "itkMessageOfCall.h"
#include "itkLeastSquaresMetricChecker.h"
#include "itkSilhouettePoseTestCase.h"

#include "itkCorrelatedNoiseModel.h"
#include "itkGemanMcClureKernel.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkReproducibleRandom.h"
#include "itkSquaresKernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace
{
using itk::MessageOfCall;
using MetricType = itk::SilhouettePoseMetricv4;
using Kernel = itk::PoseSilhouetteKernel;
using JawEnum = itk::ToothCode::JawEnum;
using Source = SilhouettePoseTestCase::Source;
using ContourType = itk::DentalContour;
using PointType = ContourType::PointType;

const SilhouettePoseTestCase &
Case(Source::TracedSideEnum side)
{
  static const SilhouettePoseTestCase right(81, Source::CohortEnum::Typical, Source::TracedSideEnum::Right);
  static const SilhouettePoseTestCase mean(83, Source::CohortEnum::Typical, Source::TracedSideEnum::Mean);
  static const SilhouettePoseTestCase both(84, Source::CohortEnum::Typical, Source::TracedSideEnum::Both);
  return side == Source::TracedSideEnum::Mean ? mean : side == Source::TracedSideEnum::Both ? both : right;
}

/** Off the truth, so that no derivative is near 0. */
MetricType::Pointer
MakeMetric(Source::TracedSideEnum side, unsigned int jaw)
{
  const auto metric = Case(side).MakeMetric(jaw);
  metric->SetTracedSide(static_cast<itk::TracedSideEnum>(side));
  auto         pose = metric->GetBlockValues("pose");
  const double away[6] = { 0.01, -0.02, 0.015, 0.3, -0.8, 0.4 };
  for (unsigned int k = 0; k < 6; ++k)
  {
    pose[k] += away[k];
  }
  metric->SetBlockValues("pose", pose);
  metric->SetBlockValues("scale", { 0.004 });
  metric->SetNoiseLevels({ 0.9, 0.7 });
  metric->SetKernelWidth(3.5);
  return metric;
}

/** 1500 mm to the midsagittal plane, 1650 mm to the detector, pixels of 0.25 mm, principal point at (400, 300). */
itk::CephalometricPoseTransform::Pointer
MakeTransform()
{
  itk::PoseGeometry geometry;
  geometry.sourceToMidsagittal = 1500.0;
  geometry.sourceToDetector = 1650.0;
  geometry.pixelSpacing = { { 0.25, 0.25 } };
  geometry.principalPoint = { { 400.0, 300.0 } };
  auto transform = itk::CephalometricPoseTransform::New();
  transform->SetPoseGeometry(geometry);
  return transform;
}

PointType
MakePoint(double x, double y)
{
  PointType point;
  point[0] = x;
  point[1] = y;
  return point;
}

/** Points one pixel apart along y = const. */
ContourType::PolylineType
MakeLine(int from, int to, double y, unsigned int tooth = 0)
{
  ContourType::PolylineType polyline;
  for (int x = from; x <= to; ++x)
  {
    polyline.points.push_back(MakePoint(x, y));
  }
  polyline.code = itk::ToothCode(static_cast<std::uint8_t>(tooth));
  return polyline;
}

MetricType::Pointer
MakePlanarMetric(const ContourType * moving, const ContourType * fixed)
{
  const auto metric = MetricType::New();
  metric->SetTransform(MakeTransform());
  metric->SetMovingContour(moving);
  metric->SetFixedContour(fixed);
  metric->SetBlockFree("pose", { true, false, false, true, false, true });
  return metric;
}

/** A silhouette like a row of cusps, pixels. */
PointType
Cusps(double part)
{
  return MakePoint(560.0 - 320.0 * part,
                   300.0 + 45.0 * std::cos(2.8 * part) + 9.0 * std::abs(std::sin(7.0 * M_PI * part)) + 20.0 * part);
}

/** Scaled by `scale` and turned by `angle` about the principal point, and shifted. */
PointType
Place(const PointType & p, double scale, double angle, double tx, double ty)
{
  const double x = p[0] - 400.0;
  const double y = p[1] - 300.0;
  return MakePoint(400.0 + scale * (std::cos(angle) * x - std::sin(angle) * y) + tx,
                   300.0 + scale * (std::sin(angle) * x + std::cos(angle) * y) + ty);
}

} // namespace

/** Side, jaw, whether robust. */
class SilhouettePoseOptions : public ::testing::TestWithParam<std::tuple<Source::TracedSideEnum, unsigned int, bool>>
{};

TEST_P(SilhouettePoseOptions, KeepThePromisesOfEveryMetric)
{
  const auto [side, jaw, robust] = GetParam();
  const auto metric = MakeMetric(side, jaw);
  metric->GateByToothOn();
  metric->SetReverseWeight(0.7);
  if (!robust)
  {
    metric->SetRobustKernel(itk::SquaresKernel::New());
  }
  metric->Initialize();
  // As of the forward direction alone, see itkSilhouettePoseMetricv4GTest.cxx.
  LeastSquaresMetricChecker::Settings settings;
  settings.heldTolerance = 2e-5;
  settings.residualsHaveTheGradient = false;
  settings.gradientTolerance = 1e-5;
  LeastSquaresMetricChecker::Check(*metric, settings);
}

INSTANTIATE_TEST_SUITE_P(Sides,
                         SilhouettePoseOptions,
                         ::testing::Combine(::testing::Values(Source::TracedSideEnum::Right,
                                                              Source::TracedSideEnum::Mean,
                                                              Source::TracedSideEnum::Both),
                                            ::testing::Values(0u, 1u),
                                            ::testing::Bool()));

TEST(SilhouettePoseOptions, DefaultsLeaveThemOut)
{
  const auto metric = MetricType::New();
  EXPECT_FALSE(metric->GetGateByTooth());
  EXPECT_EQ(metric->GetToothRange(), 1u);
  EXPECT_EQ(metric->GetReverseWeight(), 0.0);
  EXPECT_EQ(metric->GetTaperLength(), 6.0);
  EXPECT_EQ(metric->GetGapLength(), 8.0);
  const itk::PoseSilhouetteSettings settings;
  EXPECT_EQ(settings.gateByTooth, metric->GetGateByTooth());
  EXPECT_EQ(settings.toothRange, metric->GetToothRange());
  EXPECT_EQ(settings.reverseWeight, metric->GetReverseWeight());
  EXPECT_EQ(settings.taperLength, metric->GetTaperLength());
  EXPECT_EQ(settings.gapLength, metric->GetGapLength());
}

TEST(SilhouettePoseOptions, ReverseDirectionIsTheDocumentedSumByBruteForce)
{
  const auto metric = MakeMetric(Source::TracedSideEnum::Right, 1);
  metric->Initialize();
  const double forward = metric->GetValue();
  metric->SetReverseWeight(0.6);
  metric->Initialize();
  const double value = metric->GetValue();
  const auto   x = metric->GetState().GetValues();
  // A copy: the engine is made anew below.
  const auto   contour = metric->GetContours(x)[0];
  const auto   t = metric->GetKernel().GetStrands()[0].tracing;
  const double sigma2 = 0.9 * 0.9 + 0.7 * 0.7;
  // Where the tracing has ends: at gaps of 8 px and more.
  std::vector<std::array<double, 2>> stretches;
  for (std::size_t i = 0; i < t.Size(); ++i)
  {
    const bool starts = std::find(t.runs.begin(), t.runs.end(), i) != t.runs.end();
    if (i == 0 || (starts && t.arc[i] - t.arc[i - 1] >= 8.0))
    {
      stretches.push_back({ { t.arc[i], t.arc[i] } });
    }
    stretches.back()[1] = t.arc[i];
  }
  const auto kernel = itk::GemanMcClureKernel::New();
  // The smoothed direction is not public: the nearest place is found by position alone, and compared where the normals
  // agree so well that the direction cannot have decided otherwise.
  metric->UseOrientationOff();
  metric->Initialize();
  const double plain = metric->GetValue();
  metric->SetReverseWeight(0.0);
  metric->Initialize();
  const double      plainForward = metric->GetValue();
  double            expected = 0.0;
  const std::size_t n = t.Size();
  for (std::size_t k = 0; k < n; ++k)
  {
    const std::size_t j = (2 * k + 1) * contour.Size() / (2 * n);
    double            best = std::numeric_limits<double>::infinity();
    double            term = 0.0;
    for (std::size_t i = 0; i + 1 < n; ++i)
    {
      const auto * const stretch = [&]() -> const std::array<double, 2> * {
        for (const auto & s : stretches)
        {
          if (t.arc[i] >= s[0] && t.arc[i + 1] <= s[1])
          {
            return &s;
          }
        }
        return nullptr;
      }();
      const double eu = t.u[i + 1] - t.u[i];
      const double ev = t.v[i + 1] - t.v[i];
      const double length = std::hypot(eu, ev);
      if (stretch == nullptr || length == 0.0)
      {
        continue;
      }
      const double part = ((contour.u[j] - t.u[i]) * eu + (contour.v[j] - t.v[i]) * ev) / (length * length);
      const double within = std::min(1.0, std::max(0.0, part));
      const double distance = std::hypot(contour.u[j] - t.u[i] - within * eu, contour.v[j] - t.v[i] - within * ev);
      if (distance >= best)
      {
        continue;
      }
      best = distance;
      // Of the line: beside a corner the foot of the perpendicular may lie past the segment's end.
      const double du = contour.u[j] - t.u[i] - part * eu;
      const double dv = contour.v[j] - t.v[i] - part * ev;
      double       nu = t.nu[i] + t.nu[i + 1];
      double       nv = t.nv[i] + t.nv[i + 1];
      const double size = std::hypot(nu, nv);
      nu /= size;
      nv /= size;
      const double r = nu * du + nv * dv;
      const double beyond = std::max(0.0, std::abs(nu * dv - nv * du) - 1.0);
      const double place = t.arc[i] + part * length;
      const double reach = std::min(6.0, 0.5 * ((*stretch)[1] - (*stretch)[0]));
      const double toEnd = std::min(place - (*stretch)[0], (*stretch)[1] - place);
      const double s = std::min(1.0, std::max(0.0, toEnd / reach));
      const double weight = kernel->GetWeight(r * r + beyond * beyond, 3.5);
      term = s * s * (3.0 - 2.0 * s) * (weight * r * r + 3.5 * 3.5 * kernel->GetCharge(weight));
    }
    expected += 0.6 * term / sigma2;
  }
  EXPECT_GT(expected, 1.0);
  EXPECT_NEAR(plain - plainForward, expected, 1e-9 * expected);
  // With directions it is of the same size, and it is more than nothing.
  EXPECT_GT(value, forward);
}

TEST(SilhouettePoseOptions, ReverseDirectionCountsOnlyBesideTheTracing)
{
  // The outline reaches 50 px beyond the tracing on either side, 2 px below it.
  const auto outline = ContourType::New();
  outline->AddPolyline(MakeLine(300, 500, 302.0));
  const auto tracing = ContourType::New();
  tracing->AddPolyline(MakeLine(350, 450, 300.0));
  const auto metric = MakePlanarMetric(outline, tracing);
  metric->SetReverseWeight(1.0);
  metric->SetRobustKernel(itk::SquaresKernel::New());
  metric->Initialize();
  const auto          x = metric->GetState().GetValues();
  itk::PoseParameters pose{ {} };
  std::copy(x.begin(), x.end(), pose.begin());
  const auto & contour = metric->GetContours(x)[0];
  const auto   lin = metric->GetKernel().LinearizeReverse(0, pose, contour);
  const auto   n = lin.residual.size();
  ASSERT_EQ(n, 101u);
  for (std::size_t k = 0; k < n; ++k)
  {
    const double u = contour.u[(2 * k + 1) * contour.Size() / (2 * n)];
    if (std::abs(u) > 50.0)
    {
      EXPECT_EQ(lin.taper[k], 0.0) << u;
      continue;
    }
    const double part = std::min(1.0, (50.0 - std::abs(u)) / 6.0);
    EXPECT_NEAR(lin.taper[k], part * part * (3.0 - 2.0 * part), 1e-12) << u;
    EXPECT_NEAR(std::abs(lin.residual[k]), 2.0, 1e-9);
  }
  // A tracing that begins and ends within a short gap is one; within a long one two.
  const auto gap = ContourType::New();
  gap->AddPolyline(MakeLine(350, 396, 300.0));
  gap->AddPolyline(MakeLine(403, 450, 300.0));
  metric->SetFixedContour(gap);
  const auto taperInTheGap = [&] {
    metric->Initialize();
    const auto & made = metric->GetContours(x)[0];
    const auto   at = metric->GetKernel().LinearizeReverse(0, pose, made);
    double       sum = 0.0;
    for (std::size_t k = 0; k < at.taper.size(); ++k)
    {
      const double u = made.u[(2 * k + 1) * made.Size() / (2 * at.taper.size())];
      sum += std::abs(u + 0.5) < 3.0 ? at.taper[k] : 0.0;
    }
    return sum;
  };
  EXPECT_GT(taperInTheGap(), 1.0);
  metric->SetGapLength(7.0);
  EXPECT_EQ(taperInTheGap(), 0.0);
}

TEST(SilhouettePoseOptions, ToothIsMatchedWithItselfOrItsNeighbour)
{
  // The tracing of a first premolar lies on the outline of the first molar, 10 px from its own.
  const auto outline = ContourType::New();
  outline->AddPolyline(MakeLine(350, 450, 310.0, 14));
  outline->AddPolyline(MakeLine(350, 450, 300.0, 16));
  const auto tracing = ContourType::New();
  tracing->AddPolyline(MakeLine(360, 440, 300.0, 24));
  const auto metric = MakePlanarMetric(outline, tracing);
  const auto distance = [&] {
    metric->Initialize();
    const auto          x = metric->GetState().GetValues();
    itk::PoseParameters pose{ {} };
    std::copy(x.begin(), x.end(), pose.begin());
    const auto lin = metric->GetKernel().Linearize(0, pose, metric->GetContours(x)[0], false);
    return std::abs(lin.residual[40]);
  };
  EXPECT_NEAR(distance(), 0.0, 1e-9);
  metric->GateByToothOn();
  // The patient's sides are not told apart.
  EXPECT_NEAR(distance(), 10.0, 1e-9);
  metric->SetToothRange(2);
  EXPECT_NEAR(distance(), 0.0, 1e-9);
  // Nothing that it may lie on: no weight, and no pull.
  metric->SetToothRange(0);
  auto       lone = MakeLine(360, 440, 300.0, 17);
  const auto molar = ContourType::New();
  molar->AddPolyline(lone);
  metric->SetFixedContour(molar);
  metric->SetBlockFree("pose", { true, false, false, true, false, true });
  metric->Initialize();
  itk::PoseParameters pose{ {} };
  const auto          x = metric->GetState().GetValues();
  const auto          lin = metric->GetKernel().Linearize(0, pose, metric->GetContours(x)[0], true);
  EXPECT_EQ(lin.facing[40], 0.0);
  EXPECT_EQ(lin.match[40], Kernel::NoMatch);
  MetricType::DerivativeType derivative;
  metric->GetDerivative(derivative);
  for (const double d : derivative)
  {
    EXPECT_EQ(d, 0.0);
  }
}

TEST(SilhouettePoseOptions, TeethOfAScanAreToldByTheirPlaceAlongTheArch)
{
  const auto & phantom = Case(Source::TracedSideEnum::Right);
  const auto   metric = phantom.MakeMetric(0);
  metric->GateByToothOn();
  metric->SetToothRange(0);
  metric->Initialize();
  const auto          x = metric->GetState().GetValues();
  itk::PoseParameters pose{ {} };
  std::copy(x.begin(), x.end(), pose.begin());
  const auto &        contour = metric->GetContours(x)[0];
  const auto &        tracing = metric->GetKernel().GetStrands()[0].tracing;
  const auto          lin = metric->GetKernel().Linearize(0, pose, contour, false);
  const itk::PoseArch arch(phantom.surfaces[0], JawEnum::Upper);
  unsigned int        matched = 0;
  for (std::size_t i = 0; i < tracing.Size(); ++i)
  {
    if (lin.match[i] != Kernel::NoMatch)
    {
      const auto & rim = contour.rim[lin.match[i]];
      EXPECT_EQ(itk::PoseArch::ExpectedPosition(arch.Arc(rim[0], rim[1]), JawEnum::Upper), tracing.tooth[i] % 10);
      ++matched;
    }
  }
  EXPECT_GT(matched, tracing.Size() / 2);
  // Boundaries by the widths of ExpectedArc(): the upper central incisor ends at 8.5 mm, the lower one at 5.3 mm.
  EXPECT_EQ(itk::PoseArch::ExpectedPosition(-8.4, JawEnum::Upper), 1);
  EXPECT_EQ(itk::PoseArch::ExpectedPosition(8.6, JawEnum::Upper), 2);
  EXPECT_EQ(itk::PoseArch::ExpectedPosition(5.4, JawEnum::Lower), 2);
  EXPECT_EQ(itk::PoseArch::ExpectedPosition(80.0, JawEnum::Lower), 8);
  for (std::uint8_t tooth = 11; tooth <= 17; ++tooth)
  {
    EXPECT_EQ(itk::PoseArch::ExpectedPosition(itk::PoseArch::ExpectedArc(tooth), JawEnum::Upper), tooth % 10);
    EXPECT_EQ(itk::PoseArch::ExpectedPosition(-itk::PoseArch::ExpectedArc(tooth + 20), JawEnum::Lower), tooth % 10);
  }
}

TEST(SilhouettePoseOptions, OutlineInPlaceOfAScanMovesByASimilarity)
{
  const auto outline = ContourType::New();
  outline->AddPolyline(MakeLine(350, 450, 310.0));
  const auto metric = MakePlanarMetric(outline, outline);
  metric->Initialize();
  const double scale = 1.04;
  const double angle = 0.05;
  // Pixels of 0.25 mm at a magnification of 1.1.
  const double millimetres = 0.25 * 1500.0 / 1650.0;
  auto         pose = metric->GetBlockValues("pose");
  for (const double sign : { 1.0, -1.0 })
  {
    pose[0] = sign * angle;
    pose[3] = 12.0 * millimetres / scale;
    pose[5] = -7.0 * millimetres / scale;
    metric->SetBlockValues("pose", pose);
    metric->SetBlockValues("scale", { std::log(scale) });
    const auto & contour = metric->GetContours(metric->GetState().GetValues())[0];
    ASSERT_EQ(contour.Size(), 201u);
    const double turned = std::atan2(contour.v[200] - contour.v[0], contour.u[200] - contour.u[0]);
    EXPECT_NEAR(std::abs(turned), angle, 1e-9);
    for (const std::size_t i : { 0u, 57u, 200u })
    {
      const PointType expected = Place(MakePoint(350.0 + 0.5 * i, 310.0), scale, turned, 12.0, 7.0);
      EXPECT_NEAR(contour.u[i] + 400.0, expected[0], 1e-7);
      EXPECT_NEAR(contour.v[i] + 300.0, expected[1], 1e-7);
    }
  }
}

TEST(SilhouettePoseOptions, RecoversASimilarityWithFourTenthsOverlapAndAFifthOutliers)
{
  const auto                outline = ContourType::New();
  ContourType::PolylineType whole;
  for (int i = 0; i < 250; ++i)
  {
    whole.points.push_back(Cusps(i / 249.0));
  }
  outline->AddPolyline(whole);
  const double truth[4] = { 1.03, 0.04, 9.0, -6.0 };
  const auto   place = [&](double part) { return Place(Cusps(part), truth[0], truth[1], truth[2], truth[3]); };
  for (const std::uint64_t seed : { 5u, 6u, 7u })
  {
    // Eight of 44 points, in two runs of four, lie 12 to 25 px too low.
    itk::ReproducibleRandom   random(seed);
    ContourType::PolylineType drawn;
    for (int i = 0; i < 44; ++i)
    {
      PointType point = place(0.3 + 0.4 * i / 43.0);
      point[0] += random.Normal(0.0, 0.5);
      point[1] += random.Normal(0.0, 0.5) + (i / 4 % 5 == 2 ? random.Uniform(12.0, 25.0) : 0.0);
      drawn.points.push_back(point);
    }
    const auto tracing = ContourType::New();
    tracing->AddPolyline(drawn);
    for (const double reverseWeight : { 0.0, 0.5, -1.0 })
    {
      // The last: what the outliers do where nothing holds them back.
      const bool robust = reverseWeight >= 0.0;
      const auto metric = MakePlanarMetric(outline, tracing);
      metric->SetReverseWeight(std::max(0.0, reverseWeight));
      metric->SetNoiseLevels({ 0.0, 0.5 });
      if (!robust)
      {
        metric->SetRobustKernel(itk::SquaresKernel::New());
      }
      const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
      optimizer->SetMetric(metric);
      for (const double width : { 20.0, 12.0, 8.0, 5.0, 3.0 })
      {
        metric->SetKernelWidth(width);
        metric->Initialize();
        optimizer->StartOptimization();
      }
      const auto   contour = metric->GetContours(metric->GetState().GetValues())[0];
      double       squares = 0.0;
      unsigned int count = 0;
      // The part that was drawn, by arc length of the outline: where its samples lie, and where they should.
      metric->SetValues({ 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 });
      const auto before = metric->GetContours(metric->GetState().GetValues())[0];
      for (std::size_t i = 0; i < before.Size(); ++i)
      {
        const double part = (560.0 - 400.0 - before.u[i]) / 320.0;
        if (part > 0.3 && part < 0.7)
        {
          const PointType expected =
            Place(MakePoint(before.u[i] + 400.0, before.v[i] + 300.0), truth[0], truth[1], truth[2], truth[3]);
          squares += std::pow(contour.u[i] + 400.0 - expected[0], 2) + std::pow(contour.v[i] + 300.0 - expected[1], 2);
          ++count;
        }
      }
      ASSERT_GT(count, 100u);
      // 36 good points of 0.5 px, which tell nothing along the outline, determine four parameters to some 0.4 px.
      if (robust)
      {
        EXPECT_LT(std::sqrt(squares / count), 0.8) << "seed " << seed << ", reverse weight " << reverseWeight;
      }
      else
      {
        EXPECT_GT(std::sqrt(squares / count), 2.0) << "seed " << seed;
      }
    }
  }
}

TEST(SilhouettePoseOptions, ClosedOutlineKeepsItsOcclusalPart)
{
  ContourType::PolylineType circle;
  for (int i = 0; i < 720; ++i)
  {
    circle.points.push_back(
      MakePoint(400.0 + 30.0 * std::cos(i * M_PI / 360.0), 300.0 + 30.0 * std::sin(i * M_PI / 360.0)));
  }
  circle.closed = true;
  const auto outline = ContourType::New();
  outline->AddPolyline(circle);
  const auto metric = MakePlanarMetric(outline, outline);
  metric->Initialize();
  const auto half = metric->GetContours(metric->GetState().GetValues())[0];
  EXPECT_EQ(half.runs.size(), 1u);
  EXPECT_GT(half.Size(), 150u);
  EXPECT_LT(half.Size(), 260u);
  for (std::size_t i = 0; i < half.Size(); ++i)
  {
    EXPECT_GT(half.nu[i] * half.u[i] + half.nv[i] * half.v[i], 29.0);
    EXPECT_TRUE(half.v[i] > 5.0 || half.u[i] > 5.0);
  }
  metric->UseFacingFilterOff();
  metric->Initialize();
  EXPECT_NEAR(metric->GetContours(metric->GetState().GetValues())[0].Size(), 2.0 * M_PI * 30.0 / 0.5, 2.0);
}

TEST(SilhouettePoseOptions, ErrorsSayWhatToDo)
{
  const auto outline = ContourType::New();
  outline->AddPolyline(MakeLine(350, 450, 310.0));
  const auto metric = MakePlanarMetric(outline, outline);
  EXPECT_NE(MessageOfCall([&] { metric->SetReverseWeight(-0.1); }).find("-0.1"), std::string::npos);
  EXPECT_NE(MessageOfCall([&] { metric->SetReverseWeight(std::numeric_limits<double>::quiet_NaN()); }).find("nan"),
            std::string::npos);
  metric->SetMovingSurface(
    std::make_shared<const itk::TriangleSurface>(Case(Source::TracedSideEnum::Right).surfaces[0]));
  EXPECT_NE(MessageOfCall([&] { metric->Initialize(); }).find("SetMovingContour(nullptr)"), std::string::npos);
  metric->SetMovingSurface(nullptr);
  metric->SetMovingContour(nullptr);
  EXPECT_NE(MessageOfCall([&] { metric->Initialize(); }).find("SetMovingMesh()"), std::string::npos);
  const auto point = ContourType::New();
  point->AddPolyline(MakeLine(350, 350, 310.0));
  metric->SetMovingContour(point);
  EXPECT_NE(MessageOfCall([&] { metric->Initialize(); }).find("fewer than 2"), std::string::npos);
}
