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
#include "itkToothOutlinePoseMetricv4.h"

#include "itkCephalometricPoseTransform.h"
#include "itkFrontalToothOutline.h"
#include "itkLeastSquaresMetricChecker.h"
#include "itkLeastSquaresSumMetricv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkMeshSilhouette.h"
#include "itkPoseModel.h"
#include "itkWholeToothOutline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

// Teeth are upright ellipsoids, whose lower third is the crown: the outline of a whole tooth is that of the ellipsoid,
// so that crown and outline agree exactly where both are, and the answer is known.

namespace
{
using MetricType = itk::ToothOutlinePoseMetricv4;
using TransformType = itk::CephalometricPoseTransform;
using JawEnum = itk::ToothCode::JawEnum;

const double Truth[7] = { 0.08, 0.0, 0.0, 55.0, 0.0, -40.0, 0.0 };

struct Tooth
{
  std::uint8_t fdi;
  double       centre[3];
  double       radii[3];
};
/** An upper jaw: the left incisor stands 1 mm further forward, the left molar 2 mm further back. */
const Tooth Teeth[4] = { { 11, { 24.0, -4.0, 8.0 }, { 3.5, 4.0, 11.5 } },
                         { 21, { 25.0, 4.0, 8.0 }, { 3.5, 4.0, 11.5 } },
                         { 16, { -14.0, -24.0, 8.0 }, { 5.0, 5.5, 10.5 } },
                         { 26, { -16.0, 24.0, 8.0 }, { 5.0, 5.5, 10.5 } } };

/** Points with z below the share of the height are kept. */
itk::TriangleSurface
MakeEllipsoid(const Tooth & tooth, double keptShare)
{
  constexpr unsigned int rows = 48;
  constexpr unsigned int columns = 64;
  itk::TriangleSurface   surface;
  for (unsigned int i = 0; i <= rows; ++i)
  {
    const double polar = M_PI * i / rows;
    for (unsigned int j = 0; j < columns; ++j)
    {
      const double azimuth = 2.0 * M_PI * j / columns;
      surface.points.push_back({ { tooth.centre[0] + tooth.radii[0] * std::sin(polar) * std::cos(azimuth),
                                   tooth.centre[1] + tooth.radii[1] * std::sin(polar) * std::sin(azimuth),
                                   tooth.centre[2] - tooth.radii[2] * std::cos(polar) } });
    }
  }
  for (unsigned int i = 0; i < rows; ++i)
  {
    if (1.0 - std::cos(M_PI * (i + 1) / rows) > 2.0 * keptShare)
    {
      break;
    }
    for (unsigned int j = 0; j < columns; ++j)
    {
      const unsigned int next = (j + 1) % columns;
      surface.triangles.push_back({ { i * columns + j, i * columns + next, (i + 1) * columns + j } });
      surface.triangles.push_back({ { i * columns + next, (i + 1) * columns + next, (i + 1) * columns + j } });
    }
  }
  return surface;
}

/** Cut out of the scan with so much of error along the arch, mm. */
itk::ToothCrownSet::Pointer
MakeCrowns(double sigmaAlong = 0.0)
{
  auto crowns = itk::ToothCrownSet::New();
  for (const Tooth & tooth : Teeth)
  {
    crowns->Add({ itk::ToothCode(tooth.fdi),
                  std::make_shared<const itk::TriangleSurface>(MakeEllipsoid(tooth, 0.5)),
                  sigmaAlong,
                  0.0,
                  "made" });
  }
  return crowns;
}

TransformType::Pointer
MakeTransform(const double * parameters)
{
  auto geometry = itk::CephalometricGeometry::New();
  geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(0.2));
  auto transform = TransformType::New();
  transform->SetGeometry(geometry);
  TransformType::ParametersType values(7);
  std::copy_n(parameters, 7, values.begin());
  transform->SetParameters(values);
  return transform;
}

using PointsType = std::vector<itk::DentalContour::PointType>;

/** The outline of the whole of a tooth, at the truth. */
PointsType
MakeOutline(const Tooth & tooth)
{
  itk::PoseParameters pose{ {} };
  std::copy_n(Truth, 7, pose.begin());
  const auto                geometry = MakeTransform(Truth)->GetPoseGeometry();
  const itk::PoseModel      model(geometry, pose);
  const itk::MeshSilhouette silhouette(MakeEllipsoid(tooth, 1.0));
  const auto                boundary = silhouette.ComputeOuterBoundary(model.GetProjection());
  PointsType                points;
  for (const auto & sample : itk::ResampleSilhouetteLoop(boundary.loops.at(0), model.GetProjection(), 90))
  {
    const auto pixel = itk::PoseModel::ToPixel(geometry, { { sample.u, sample.v } });
    points.emplace_back(pixel.data());
  }
  return points;
}

/** Of the foremost incisor, and the middle of both molars' outlines, which are alike. */
PointsType
MakeDrawing(bool molar)
{
  if (!molar)
  {
    return MakeOutline(Teeth[1]);
  }
  PointsType       right = MakeOutline(Teeth[2]);
  const PointsType left = MakeOutline(Teeth[3]);
  double           shift[2] = { 0.0, 0.0 };
  for (unsigned int d = 0; d < 2; ++d)
  {
    for (std::size_t i = 0; i < right.size(); ++i)
    {
      shift[d] += 0.5 * (left[i][d] - right[i][d]) / static_cast<double>(right.size());
    }
  }
  for (auto & p : right)
  {
    p[0] += shift[0];
    p[1] += shift[1];
  }
  return right;
}

PointsType
Moved(PointsType points, double u, double v)
{
  for (auto & p : points)
  {
    p[0] += u;
    p[1] += v;
  }
  return points;
}

itk::DentalContour::Pointer
MakeTracing(const PointsType & incisor, const PointsType & molar, std::uint8_t molarCode = 16)
{
  auto tracing = itk::DentalContour::New();
  tracing->AddPolyline(incisor, itk::ToothCode(11), true);
  tracing->AddPolyline(molar, itk::ToothCode(molarCode), true);
  return tracing;
}

MetricType::Pointer
MakeMetric(const itk::DentalContour * tracing, const double * start = Truth)
{
  auto metric = MetricType::New();
  metric->SetTransform(MakeTransform(start));
  metric->SetCrowns(MakeCrowns());
  metric->SetFixedContour(tracing);
  return metric;
}

/** Pitch, tx and tz, or what else of the pose is free; the scale, which two teeth do not tell, is known. */
std::vector<double>
Register(MetricType * metric, const std::vector<bool> & isFree = { true, false, false, true, false, true })
{
  auto sum = itk::LeastSquaresSumMetricv4::New();
  sum->AddMetric(metric, itk::LeastSquaresSumMetricv4::SettingsEnum::Own);
  sum->Initialize();
  sum->SetBlockFree("pose", isFree);
  sum->SetBlockFree("scale", false);
  for (int round = 0; round < 6; ++round)
  {
    sum->UpdateNoiseCorrelation(sum->GetState().GetValues());
    auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
    optimizer->SetMetric(sum);
    optimizer->StartOptimization();
  }
  return sum->GetState().GetValues();
}

/** px of 0.25 mm between the images of a point midway at two positions. */
double
DistanceAt(const double x, const std::vector<double> & position)
{
  const auto          geometry = MakeTransform(Truth)->GetPoseGeometry();
  itk::PoseParameters truth{ {} };
  itk::PoseParameters found{ {} };
  std::copy_n(Truth, 7, truth.begin());
  std::copy_n(position.begin(), 7, found.begin());
  const double p[3] = { x, 0.0, -2.0 };
  double       a[2], b[2];
  itk::PoseModel(geometry, truth).Project(p, a);
  itk::PoseModel(geometry, found).Project(p, b);
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

std::string
MessageOfInitialize(MetricType * metric)
{
  try
  {
    metric->Initialize();
  }
  catch (const itk::ExceptionObject & error)
  {
    return error.GetDescription();
  }
  return "";
}
} // namespace

TEST(ToothOutlinePoseMetricv4, OutlinesBringTheScanToTheirPlace)
{
  const auto   tracing = MakeTracing(MakeDrawing(false), MakeDrawing(true));
  const double start[7] = { 0.10, 0.0, 0.0, 56.5, 0.0, -41.0, 0.0 };
  const auto   position = Register(MakeMetric(tracing, start));
  // A seventh of a millimetre: outlines of 90 points cut corners by a tenth of a pixel, and two
  // molars at two depths are not quite alike.
  EXPECT_LT(DistanceAt(24.0, position), 0.6);
  EXPECT_LT(DistanceAt(-15.0, position), 0.6);
}

TEST(ToothOutlinePoseMetricv4, TheForemostIncisorIsMeantAndTheSideOfACodeIsNot)
{
  const auto metric = MakeMetric(MakeTracing(MakeDrawing(false), MakeDrawing(true)));
  metric->Initialize();
  const auto position = metric->GetState().GetValues();
  const auto residuals = metric->ComputeOutlineResiduals(position);
  ASSERT_EQ(residuals.size(), 2u);
  EXPECT_EQ(residuals[0].name, "U1");
  EXPECT_EQ(residuals[1].name, "U6");
  for (const auto & residual : residuals)
  {
    // The right incisor, whose code it has, would be 5 px away.
    EXPECT_LT(std::hypot(residual.shift[0], residual.shift[1]), 0.7) << residual.name;
    EXPECT_FALSE(residual.isTemplate) << residual.name;
    EXPECT_GT(residual.weight, 0.99) << residual.name;
    EXPECT_GT(residual.matchedShare, 0.9) << residual.name;
  }
  const auto other = MakeMetric(MakeTracing(MakeDrawing(false), MakeDrawing(true), 26));
  other->Initialize();
  EXPECT_EQ(metric->ComputeValue(position), other->ComputeValue(position));
}

TEST(ToothOutlinePoseMetricv4, DerivativesAreThoseOfTheResiduals)
{
  // Off the truth by some pixels, and outlines that a hand has moved each its own way.
  const double start[7] = { 0.09, 0.01, -0.01, 55.6, 0.5, -40.4, 0.005 };
  const auto   metric =
    MakeMetric(MakeTracing(Moved(MakeDrawing(false), 3.0, -2.0), Moved(MakeDrawing(true), -2.0, 1.0)), start);
  metric->Initialize();
  LeastSquaresMetricChecker::Check(*metric);
}

TEST(ToothOutlinePoseMetricv4, StepsEndWhereNoneIsLeftToTake)
{
  // Hands that have turned and scaled both teeth as well as moved them: points are matched beside the normals of their
  // samples, and slide along the edges as the pose moves. Where a point by itself counts as if its match did not, a
  // registration ends a fifth of a standard deviation beside where its steps lead.
  const auto redrawn = [](const PointsType & points, double turn, double scale, double u, double v) {
    itk::DentalContour::PointType centre;
    centre.Fill(0.0);
    for (const auto & p : points)
    {
      centre[0] += p[0] / static_cast<double>(points.size());
      centre[1] += p[1] / static_cast<double>(points.size());
    }
    PointsType drawn = points;
    for (auto & p : drawn)
    {
      const double a = p[0] - centre[0];
      const double b = p[1] - centre[1];
      p[0] = centre[0] + u + scale * (std::cos(turn) * a - std::sin(turn) * b);
      p[1] = centre[1] + v + scale * (std::sin(turn) * a + std::cos(turn) * b);
    }
    return drawn;
  };
  double largest = 0.0;
  for (const double sign : { -1.0, 1.0 })
  {
    const auto metric = MakeMetric(MakeTracing(redrawn(MakeDrawing(false), 0.06 * sign, 1.05, 3.0, -4.0 * sign),
                                               redrawn(MakeDrawing(true), -0.05 * sign, 0.96, -3.0 * sign, 4.0)));
    const auto x = Register(metric);
    metric->UpdateNoiseCorrelation(x);
    MetricType::VectorType residuals;
    MetricType::MatrixType jacobian;
    metric->ComputeResiduals(x, residuals, &jacobian);
    // Pitch, tx and tz: the step that the residuals ask for, in standard deviations of the parameter.
    for (const unsigned int a : { 0u, 3u, 5u })
    {
      double slope = 0.0;
      double size = 0.0;
      for (unsigned int i = 0; i < residuals.size(); ++i)
      {
        slope += residuals[i] * jacobian(i, a);
        size += jacobian(i, a) * jacobian(i, a);
      }
      largest = std::max(largest, std::abs(slope) / std::sqrt(size));
    }
  }
  EXPECT_LT(largest, 0.05);
}

TEST(ToothOutlinePoseMetricv4, PointsOfAToothAreNotAsManyMeasurements)
{
  const auto metric = MakeMetric(MakeTracing(MakeDrawing(false), MakeDrawing(true)));
  metric->Initialize();
  MetricType::VectorType residuals;
  MetricType::MatrixType jacobian;
  metric->ComputeResiduals(metric->GetState().GetValues(), residuals, &jacobian);
  EXPECT_GT(residuals.size(), 40u);
  double information[2] = { 0.0, 0.0 };
  for (unsigned int i = 0; i < residuals.size(); ++i)
  {
    information[0] += jacobian(i, 3) * jacobian(i, 3);
    information[1] += jacobian(i, 5) * jacobian(i, 5);
  }
  // Two teeth, each known to its own shift at best: a millimetre at the teeth is 1.1 on the detector.
  const auto & errors = metric->GetErrors();
  const double magnification = 1674.0 / 1524.0;
  EXPECT_LT(information[0], 2.0 * std::pow(magnification / errors.along, 2));
  EXPECT_LT(information[1], 2.0 * std::pow(magnification / errors.across, 2));
  // Turn and size take some of it, as the crown is not at the tooth's middle; more than a third is left.
  EXPECT_GT(information[0], 0.7 * std::pow(magnification / errors.along, 2));
  EXPECT_GT(information[1], 0.7 * std::pow(magnification / errors.across, 2));
}

TEST(ToothOutlinePoseMetricv4, AToothThatIsMarkedAsWellCountsLess)
{
  const auto traced = MakeTracing(Moved(MakeDrawing(false), 6.0, 4.0), MakeDrawing(true));
  const auto alone = MakeMetric(traced);
  const auto marked = MakeMetric(traced);
  marked->SetMarkedTeeth({ itk::ToothCode(21) });
  alone->Initialize();
  marked->Initialize();
  const auto x = alone->GetState().GetValues();
  // Of the residuals alone: wider errors cost both the same charge or more.
  const auto squares = [&x](const MetricType & metric) {
    MetricType::VectorType residuals;
    metric.ComputeResiduals(x, residuals, nullptr);
    return residuals.squared_magnitude();
  };
  const double ratio = squares(*marked) / squares(*alone);
  EXPECT_LT(ratio, 1.0);
  EXPECT_GT(ratio, 1.0 / (1.0 + MetricType::SharedErrorShare) - 0.01);
}

TEST(ToothOutlinePoseMetricv4, AMarkSharesTheHandsErrorAlone)
{
  // Where the crown was cut is no error of the hand: with 4 mm of that along the arch a mark takes next to nothing of
  // what the outline says along it, and as much as ever across.
  const auto information = [](double sigmaAlong, bool isMarked, unsigned int parameter) {
    const auto metric = MakeMetric(MakeTracing(MakeDrawing(false), MakeDrawing(true)));
    metric->SetCrowns(MakeCrowns(sigmaAlong));
    if (isMarked)
    {
      metric->SetMarkedTeeth({ itk::ToothCode(21), itk::ToothCode(26) });
    }
    metric->Initialize();
    MetricType::VectorType residuals;
    MetricType::MatrixType jacobian;
    metric->ComputeResiduals(metric->GetState().GetValues(), residuals, &jacobian);
    return jacobian.get_column(parameter).squared_magnitude();
  };
  constexpr unsigned int along = 3, across = 5;
  const double           share = MetricType::SharedErrorShare;
  EXPECT_GT(information(4.0, true, along) / information(4.0, false, along), 0.99);
  EXPECT_LT(information(0.0, true, along) / information(0.0, false, along), 0.9);
  for (const double sigmaAlong : { 0.0, 4.0 })
  {
    const double ratio = information(sigmaAlong, true, across) / information(sigmaAlong, false, across);
    EXPECT_LT(ratio, 0.9);
    // No more than all of the hand's part, which is what is left of an error of 0.70 mm without a quarter of a one.
    const double hand = 1.0 - std::pow(0.25 / MetricType::ErrorsType{}.across, 2);
    EXPECT_GT(ratio, 1.0 / (1.0 + share * hand) - 0.001);
  }
}

TEST(ToothOutlinePoseMetricv4, AGrossErrorOfOneOutlineIsToldAndBounded)
{
  // 6 mm on the detector: a neighbour's outline. The scale is known and the pitch held, so that one tooth suffices.
  const auto metric = MakeMetric(MakeTracing(MakeDrawing(false), Moved(MakeDrawing(true), 30.0, 0.0)));
  metric->Initialize();
  const auto residuals = metric->ComputeOutlineResiduals(metric->GetState().GetValues());
  EXPECT_GT(residuals[1].distance, 4.0);
  EXPECT_LT(residuals[1].weight, 0.25);
  EXPECT_GT(residuals[0].weight, 0.99);
  // As far as can be told: errors of hands are small, and a part of it is taken for a turn.
  EXPECT_NEAR(residuals[1].shift[0], 30.0, 9.0);
}

TEST(ToothOutlinePoseMetricv4, WhatAPositionLetsGoIsChargedFor)
{
  // The scan further and further forward, matches and weights each its own: the teeth are let go, and by their squared
  // residuals alone the position that is 24 mm off would be better than the one that is 2 mm off.
  const auto metric = MakeMetric(MakeTracing(MakeDrawing(false), MakeDrawing(true)));
  metric->Initialize();
  std::vector<double> values, squares, deviances;
  for (const double shift : { 0.0, 2.0, 4.0, 8.0, 16.0, 24.0 })
  {
    std::vector<double> x(Truth, Truth + 7);
    x[3] += shift;
    metric->UpdateNoiseCorrelation(x);
    MetricType::VectorType residuals;
    metric->ComputeResiduals(x, residuals, nullptr);
    values.push_back(metric->ComputeValue(x));
    squares.push_back(residuals.squared_magnitude());
    deviances.push_back(metric->ComputeKnownDeviance(x, true));
  }
  EXPECT_LT(squares.back(), squares[1]) << "the claims need teeth that are let go";
  EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
  EXPECT_TRUE(std::is_sorted(deviances.begin(), deviances.end()));
  // A tooth at its place, but for corners that are cut; and two that are let go, at 16 each.
  EXPECT_LT(deviances.front(), 2.0);
  EXPECT_GT(deviances.back(), 28.0);
  EXPECT_LE(deviances.back(), 32.0);
}

TEST(ToothOutlinePoseMetricv4, AnOutlineIsOneMeasurementAmongPositions)
{
  // A line that is more ragged than the metric knows hands to draw, by 3 px of 0.25 mm from point to point.
  const auto ragged = [](PointsType outline) {
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      outline[i][1] += i % 2 == 0 ? 4.0 : -4.0;
    }
    return outline;
  };
  const auto smooth = MakeMetric(MakeTracing(MakeDrawing(false), MakeDrawing(true)));
  const auto rough = MakeMetric(MakeTracing(ragged(MakeDrawing(false)), ragged(MakeDrawing(true))));
  smooth->Initialize();
  rough->Initialize();
  const auto   x = smooth->GetState().GetValues();
  const double added = rough->ComputeKnownDeviance(x, true) - smooth->ComputeKnownDeviance(x, true);
  EXPECT_LT(added, 16.0) << "less than what one tooth costs that is let go";
  EXPECT_GT(rough->ComputeValue(x) - smooth->ComputeValue(x), 4.0 * added);
}

TEST(ToothOutlinePoseMetricv4, AStockTemplateIsToldAndDoesNotPullTheTip)
{
  // Another's teeth, placed by their occlusal ends: a quarter larger, and leaning by five degrees.
  const auto asTemplate = [](PointsType outline) {
    const auto tip =
      *std::max_element(outline.begin(), outline.end(), [](const auto & a, const auto & b) { return a[1] < b[1]; });
    for (auto & p : outline)
    {
      const double u = 1.25 * (p[0] - tip[0]);
      const double v = 1.25 * (p[1] - tip[1]);
      p[0] = tip[0] + std::cos(0.087) * u - std::sin(0.087) * v;
      p[1] = tip[1] + std::sin(0.087) * u + std::cos(0.087) * v;
    }
    return outline;
  };
  const auto metric = MakeMetric(MakeTracing(asTemplate(MakeDrawing(false)), asTemplate(MakeDrawing(true))));
  metric->Initialize();
  const auto residuals = metric->ComputeOutlineResiduals(metric->GetState().GetValues());
  EXPECT_TRUE(residuals[0].isTemplate);
  EXPECT_TRUE(residuals[1].isTemplate);
  // A hand's own error is 0.6 mm, 3 px of 0.2 mm; about the outline's centroid, 60 px away, the tip would move by 15.
  EXPECT_LT(std::hypot(residuals[0].shift[0], residuals[0].shift[1]), 3.0);
}

TEST(ToothOutlinePoseMetricv4, WhatIsKnownOfTheDrawingIsNotAskedOfIt)
{
  using DrawingEnum = itk::ToothOutlinePoseMetricv4::DrawingEnum;
  const auto metric = MakeMetric(MakeTracing(MakeDrawing(false), MakeDrawing(true)));
  metric->Initialize();
  const auto x = metric->GetState().GetValues();
  EXPECT_EQ(metric->GetDrawing(), DrawingEnum::Unknown);
  const double value = metric->ComputeValue(x);
  // Exact outlines are a hand's.
  EXPECT_FALSE(metric->ComputeOutlineResiduals(x)[0].isTemplate);
  metric->SetDrawing(DrawingEnum::ByHand);
  EXPECT_DOUBLE_EQ(metric->ComputeValue(x), value);
  metric->SetDrawing(DrawingEnum::ByTemplate);
  for (const auto & residual : metric->ComputeOutlineResiduals(x))
  {
    EXPECT_TRUE(residual.isTemplate) << residual.name;
  }
  // What templates may be off by more is charged for.
  EXPECT_GT(metric->ComputeValue(x), value);
  const itk::ToothOutlinePoseMetricv4::Pointer clone = metric->Clone();
  EXPECT_EQ(clone->GetDrawing(), DrawingEnum::ByTemplate);
}

TEST(ToothOutlinePoseMetricv4, SaysWhichOutlinesAreNotUsedAndWhy)
{
  const PointsType incisor = MakeDrawing(false);
  auto             tracing = itk::DentalContour::New();
  tracing->AddPolyline(incisor, itk::ToothCode(11), true);
  tracing->AddPolyline(Moved(incisor, 2.0, 0.0), itk::ToothCode(21), true);
  tracing->AddPolyline(Moved(incisor, 4.0, 0.0), itk::ToothCode(), true);
  tracing->AddPolyline(Moved(incisor, 6.0, 0.0), itk::ToothCode(14), true);
  PointsType open(incisor.begin(), incisor.begin() + 45);
  tracing->AddPolyline(open, itk::ToothCode(12), false);
  PointsType root = incisor;
  for (auto & p : root)
  {
    p[0] = incisor[0][0] + 0.4 * (p[0] - incisor[0][0]);
    p[1] = incisor[0][1] + 0.4 * (p[1] - incisor[0][1]);
  }
  tracing->AddPolyline(root, itk::ToothCode(13), true);
  PointsType circle;
  for (unsigned int i = 0; i < 40; ++i)
  {
    const double place[2] = { 300.0 + 30.0 * std::cos(M_PI * i / 20.0), 300.0 + 30.0 * std::sin(M_PI * i / 20.0) };
    circle.emplace_back(place);
  }
  tracing->AddPolyline(circle, itk::ToothCode(16), true);
  const auto metric = MakeMetric(tracing);
  metric->Initialize();
  EXPECT_EQ(metric->GetOutlinedTeeth(), std::vector<itk::ToothCode>{ itk::ToothCode(11) });
  std::string all;
  for (const auto & unused : metric->GetUnused())
  {
    all += unused.name + ": " + unused.reason + "\n";
  }
  EXPECT_NE(all.find("U1: there is an outline of this tooth already"), std::string::npos) << all;
  EXPECT_NE(all.find("without a code: nothing says"), std::string::npos) << all;
  EXPECT_NE(all.find("U4: its crown was not found"), std::string::npos) << all;
  EXPECT_NE(all.find("U2: it is not closed"), std::string::npos) << all;
  EXPECT_NE(all.find("U3: it is 9 mm long"), std::string::npos) << all;
  EXPECT_NE(all.find("U6: it is about as wide as it is long"), std::string::npos) << all;
}

TEST(ToothOutlinePoseMetricv4, ASigmaOfTheFileIsTheHandsErrorOfTheWholeTooth)
{
  const auto value = [](double sigma) {
    auto tracing = itk::DentalContour::New();
    for (const bool molar : { false, true })
    {
      itk::DentalContour::PolylineType outline;
      outline.code = itk::ToothCode(molar ? 16 : 11);
      outline.closed = true;
      outline.points = molar ? MakeDrawing(true) : Moved(MakeDrawing(false), 4.0, 3.0);
      outline.sigmas.assign(sigma > 0.0 ? outline.points.size() : 0, sigma);
      tracing->AddPolyline(outline);
    }
    const auto metric = MakeMetric(tracing);
    metric->Initialize();
    return metric->ComputeValue(metric->GetState().GetValues());
  };
  // Default errors are of a hand of 0.56 mm, which is 2.26 px of 0.25 mm.
  const double usual = value(0.0);
  const double spacing = MakeTransform(Truth)->GetPoseGeometry().pixelSpacing[0];
  EXPECT_NEAR(value(0.5639 / spacing), usual, 0.005 * usual);
  EXPECT_LT(value(2.0 * 0.5639 / spacing), 0.8 * usual);
  EXPECT_GT(value(0.5 * 0.5639 / spacing), 1.2 * usual);
}

TEST(ToothOutlinePoseMetricv4, WhatTheFileSaysOfAnOutlineGoesBeforeItsShape)
{
  const auto use = [](const PointsType & points, std::uint8_t tooth, itk::DentalContour::OutlineEnum kind) {
    itk::DentalContour::PolylineType outline;
    outline.code = itk::ToothCode(tooth);
    outline.closed = true;
    outline.points = points;
    outline.outline = kind;
    auto tracing = itk::DentalContour::New();
    tracing->AddPolyline(outline);
    const auto metric = MakeMetric(tracing);
    return MessageOfInitialize(metric);
  };
  using OutlineEnum = itk::DentalContour::OutlineEnum;
  EXPECT_EQ(use(MakeDrawing(false), 11, OutlineEnum::Unspecified), "");
  EXPECT_EQ(use(MakeDrawing(false), 11, OutlineEnum::Tooth), "");
  EXPECT_NE(use(MakeDrawing(false), 11, OutlineEnum::Crown).find("of a crown without its root"), std::string::npos);
  EXPECT_NE(use(MakeDrawing(false), 11, OutlineEnum::Labial).find("of a labial side alone"), std::string::npos);
  PointsType circle;
  for (unsigned int i = 0; i < 40; ++i)
  {
    const double place[2] = { 300.0 + 30.0 * std::cos(M_PI * i / 20.0), 300.0 + 30.0 * std::sin(M_PI * i / 20.0) };
    circle.emplace_back(place);
  }
  EXPECT_NE(use(circle, 16, OutlineEnum::Unspecified).find("about as wide as it is long"), std::string::npos);
  EXPECT_EQ(use(circle, 16, OutlineEnum::Tooth).find("about as wide as it is long"), std::string::npos);
}

namespace
{
TransformType::Pointer
MakeFrontalTransform(const double * parameters)
{
  auto geometry = itk::CephalometricGeometry::New();
  geometry->SetDirection(itk::CephalometricGeometry::DirectionEnum::Frontal);
  geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(0.2));
  auto transform = TransformType::New();
  transform->SetGeometry(geometry);
  TransformType::ParametersType values(7);
  std::copy_n(parameters, 7, values.begin());
  transform->SetParameters(values);
  return transform;
}

/** As drawn from the front, at the truth: of incisors the part that looks occlusally, of molars that which looks to
 * their side, or the closed crown. */
itk::DentalContour::Pointer
MakeFrontalTracing(bool closed)
{
  itk::PoseParameters pose{ {} };
  std::copy_n(Truth, 7, pose.begin());
  const auto           geometry = MakeFrontalTransform(Truth)->GetPoseGeometry();
  const itk::PoseModel model(geometry, pose);
  auto                 tracing = itk::DentalContour::New();
  for (const Tooth & tooth : Teeth)
  {
    const itk::MeshSilhouette silhouette(MakeEllipsoid(tooth, 0.5));
    const auto                boundary = silhouette.ComputeOuterBoundary(model.GetProjection());
    PointsType                points;
    const bool                isMolar = tooth.fdi % 10 == 6;
    for (const auto & sample : itk::ResampleSilhouetteLoop(boundary.loops.at(0), model.GetProjection(), 120))
    {
      const double to = isMolar ? (tooth.fdi == 26 ? sample.normal[0] : -sample.normal[0]) : sample.normal[1];
      if (closed || to > 0.5)
      {
        const auto pixel = itk::PoseModel::ToPixel(geometry, { { sample.u, sample.v } });
        points.emplace_back(pixel.data());
      }
    }
    // The loop may begin within the part.
    const auto gap = [&points](std::size_t i) {
      return points[i].EuclideanDistanceTo(points[(i + 1) % points.size()]);
    };
    std::size_t widest = points.size() - 1;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      widest = gap(i) > gap(widest) ? i : widest;
    }
    std::rotate(
      points.begin(), points.begin() + static_cast<std::ptrdiff_t>((widest + 1) % points.size()), points.end());
    tracing->AddPolyline(points, itk::ToothCode(tooth.fdi), closed);
  }
  return tracing;
}

MetricType::Pointer
MakeFrontalMetric(const itk::DentalContour * tracing, const double * start = Truth)
{
  auto metric = MakeMetric(tracing);
  metric->SetTransform(MakeFrontalTransform(start));
  return metric;
}
} // namespace

TEST(ToothOutlinePoseMetricv4, FromTheFrontEachToothLiesOnTheCrownOfItsCode)
{
  for (const bool closed : { false, true })
  {
    const auto metric = MakeFrontalMetric(MakeFrontalTracing(closed));
    metric->Initialize();
    ASSERT_EQ(metric->GetUnused().size(), 0u);
    ASSERT_EQ(metric->GetOutlinedTeeth().size(), 4u);
    const auto at = metric->ComputeOutlineResiduals(metric->GetState().GetValues());
    EXPECT_EQ(at.front().name, "UR1");
    EXPECT_EQ(at.back().name, "UL6");
    for (const auto & residual : at)
    {
      EXPECT_LT(residual.distance, 0.1) << residual.name << closed;
      EXPECT_GT(residual.matchedShare, 0.95) << residual.name << closed;
    }
    // Two degrees of roll and a shift of 2 mm are found again.
    const double start[7] = { Truth[0], 0.035, 0.0, Truth[3], 2.0, Truth[5] - 1.0, 0.0 };
    const auto   x =
      Register(MakeFrontalMetric(MakeFrontalTracing(closed), start), { false, true, false, false, true, true });
    EXPECT_NEAR(x[1], Truth[1], 0.003) << closed;
    EXPECT_NEAR(x[4], Truth[4], 0.05) << closed;
    EXPECT_NEAR(x[5], Truth[5], 0.05) << closed;
  }
}

TEST(ToothOutlinePoseMetricv4, FromTheFrontDerivativesAreThoseOfDifferences)
{
  const double start[7] = { 0.09, 0.02, -0.02, 55.5, 0.6, -40.4, 0.01 };
  const auto   metric = MakeFrontalMetric(MakeFrontalTracing(false), start);
  metric->Initialize();
  LeastSquaresMetricChecker::Check(*metric);
}

TEST(ToothOutlinePoseMetricv4, FromTheFrontOnlyTheCrownOfTheCodeCounts)
{
  // Codes of the other side: each lies where its fellow is, 8 mm and 48 mm away, and is let go.
  auto exchanged = itk::DentalContour::New();
  for (const auto & polyline : MakeFrontalTracing(false)->GetPolylines())
  {
    exchanged->AddPolyline(polyline.points, polyline.code.GetContralateral());
  }
  const auto metric = MakeFrontalMetric(exchanged);
  metric->Initialize();
  for (const auto & residual : metric->ComputeOutlineResiduals(metric->GetState().GetValues()))
  {
    EXPECT_TRUE(residual.distance > 4.0 || residual.matchedShare < 0.3)
      << residual.name << ' ' << residual.distance << ' ' << residual.matchedShare;
  }
  // What cannot be used is named with its side.
  auto few = itk::DentalContour::New();
  few->AddPolyline(MakeFrontalTracing(false)->GetPolylines().front());
  auto whole = MakeFrontalTracing(true)->GetPolylines().back();
  whole.outline = itk::DentalContour::OutlineEnum::Tooth;
  few->AddPolyline(whole);
  const double places[2][2] = { { 100.0, 100.0 }, { 102.0, 100.0 } };
  few->AddPolyline({ itk::DentalContour::PointType(places[0]), itk::DentalContour::PointType(places[1]) },
                   itk::ToothCode(16));
  few->AddPolyline(MakeFrontalTracing(false)->GetPolylines().at(1).points, itk::ToothCode(22));
  const auto some = MakeFrontalMetric(few);
  some->Initialize();
  ASSERT_EQ(some->GetUnused().size(), 3u);
  EXPECT_EQ(some->GetUnused()[0].name, "UL6");
  EXPECT_NE(some->GetUnused()[0].reason.find("with its root"), std::string::npos);
  EXPECT_EQ(some->GetUnused()[1].name, "UR6");
  EXPECT_NE(some->GetUnused()[1].reason.find("2 px of 0.25 mm long"), std::string::npos);
  EXPECT_EQ(some->GetUnused()[2].name, "UL2");
  EXPECT_NE(some->GetUnused()[2].reason.find("not found on the scan"), std::string::npos);
}

TEST(FrontalToothOutline, NormalsLookAwayFromTheTooth)
{
  const auto geometry = MakeFrontalTransform(Truth)->GetPoseGeometry();
  for (const bool closed : { false, true })
  {
    for (auto polyline : MakeFrontalTracing(closed)->GetPolylines())
    {
      for (const bool reversed : { false, true })
      {
        if (reversed)
        {
          std::reverse(polyline.points.begin(), polyline.points.end());
        }
        const itk::FrontalToothOutline outline(geometry, polyline, JawEnum::Upper);
        ASSERT_TRUE(outline.GetFailure().empty()) << outline.GetFailure();
        ASSERT_GT(outline.GetPoints().size(), 4u);
        double sum[2] = { 0.0, 0.0 };
        for (const auto & normal : outline.GetNormals())
        {
          EXPECT_NEAR(std::hypot(normal[0], normal[1]), 1.0, 1e-9);
          EXPECT_GT(normal[1], -0.51);
          sum[0] += normal[0];
          sum[1] += normal[1];
        }
        const double outward = polyline.code.GetFDI() == 26 ? sum[0] : -sum[0];
        EXPECT_GT(polyline.code.GetPosition() == 6 && !closed ? outward : sum[1], 0.0);
        for (std::size_t i = 1; i < outline.GetArc().size(); ++i)
        {
          // One run, without the jump over the neck.
          EXPECT_LT(outline.GetArc()[i] - outline.GetArc()[i - 1], 1.1 * itk::FrontalToothOutline::Spacing);
        }
      }
    }
  }
}

TEST(ToothOutlinePoseMetricv4, MissingInputsNameTheCallToMake)
{
  const auto tracing = MakeTracing(MakeDrawing(false), MakeDrawing(true));
  auto       metric = MakeMetric(tracing);
  metric->SetCrowns(nullptr);
  EXPECT_NE(MessageOfInitialize(metric).find("SetCrowns()"), std::string::npos);
  metric = MakeMetric(nullptr);
  EXPECT_NE(MessageOfInitialize(metric).find("SetFixedContour()"), std::string::npos);
  metric = MakeMetric(tracing);
  metric->SetExcludedTeeth({ 11, 16 });
  EXPECT_NE(MessageOfInitialize(metric).find("U1: its tooth is excluded"), std::string::npos);
  MetricType::ErrorsType errors;
  errors.turn = 0.0;
  EXPECT_THROW(metric->SetErrors(errors), itk::ExceptionObject);
}

TEST(ToothOutlinePoseMetricv4, ACrownWithoutItsRootIsNoWholeTooth)
{
  // The occlusal part of an outline, closed along the neck.
  const auto cut = [](const PointsType & outline, double share) {
    const auto   byHeight = [](const auto & a, const auto & b) { return a[1] < b[1]; };
    const auto   ends = std::minmax_element(outline.begin(), outline.end(), byHeight);
    const double neck = (*ends.second)[1] - share * ((*ends.second)[1] - (*ends.first)[1]);
    PointsType   crown;
    std::copy_if(
      outline.begin(), outline.end(), std::back_inserter(crown), [&](const auto & p) { return p[1] > neck; });
    return crown;
  };
  const auto reasons = [](const PointsType & incisor, const PointsType & molar) {
    const auto metric = MakeMetric(MakeTracing(incisor, molar));
    metric->Prepare();
    std::string all;
    for (const auto & unused : metric->GetUnused())
    {
      all += unused.name + ": " + unused.reason + "\n";
    }
    return all;
  };
  EXPECT_EQ(reasons(MakeDrawing(false), MakeDrawing(true)), "");
  const std::string crowns = reasons(cut(MakeDrawing(false), 0.42), cut(MakeDrawing(true), 0.38));
  EXPECT_NE(crowns.find("U1: it is too wide for its length: is it a crown"), std::string::npos) << crowns;
  EXPECT_NE(crowns.find("U6: its long axis lies along the arch: is it a crown"), std::string::npos) << crowns;
}

TEST(WholeToothOutline, PointsWithoutWeightAreNoBorder)
{
  // As of a label map, where a tooth of the other jaw covers the front of the crown.
  const auto                       geometry = MakeTransform(Truth)->GetPoseGeometry();
  itk::DentalContour::PolylineType polyline = MakeTracing(MakeDrawing(false), MakeDrawing(true))->GetPolylines()[1];
  constexpr double                 scanned = 40.0;
  const itk::WholeToothOutline     whole(geometry, polyline, JawEnum::Upper, scanned);
  ASSERT_EQ(whole.GetFailure(), "");
  const auto & middle = whole.GetCentroid();
  for (const auto & p : polyline.points)
  {
    const auto at = itk::PoseModel::ToWorkingPlane(geometry, { { p[0], p[1] } });
    polyline.weights.push_back(at[0] > middle[0] ? 0.0 : 1.0);
  }
  const itk::WholeToothOutline half(geometry, polyline, JawEnum::Upper, scanned);
  ASSERT_EQ(half.GetFailure(), "");
  std::size_t behind = 0;
  for (const auto & p : whole.GetPoints())
  {
    behind += p[0] < middle[0] - 5.0 ? 1 : 0;
  }
  EXPECT_GE(half.GetPoints().size(), behind);
  EXPECT_LT(half.GetPoints().size(), whole.GetPoints().size());
  for (const auto & p : half.GetPoints())
  {
    EXPECT_LT(p[0], middle[0] + 5.0);
  }
  // The tooth is as long as before: what is left out is still drawn.
  EXPECT_DOUBLE_EQ(half.GetCentroid()[0], whole.GetCentroid()[0]);
  polyline.weights.assign(polyline.points.size(), 0.0);
  const itk::WholeToothOutline none(geometry, polyline, JawEnum::Upper, scanned);
  EXPECT_NE(none.GetFailure().find("next to nothing of its crown's border is its own"), std::string::npos);
}
