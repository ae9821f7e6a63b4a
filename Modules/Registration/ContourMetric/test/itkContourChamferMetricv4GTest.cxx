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
#include "itkContourChamferMetricv4.h"

#include "itkAmoebaOptimizerv4.h"
#include "itkGradientDescentOptimizerv4.h"
#include "itkLBFGSBOptimizerv4.h"
#include "itkMultiStartOptimizerv4.h"

#include "itkGTest.h"

#include <cmath>
#include <sstream>

namespace
{
using MetricType = itk::ContourChamferMetricv4;
using ContourType = itk::DentalContour;
using TransformType = MetricType::TransformType;
using ParametersType = MetricType::ParametersType;

ContourType::PointType
Curve(double a)
{
  ContourType::PointType point;
  point[0] = 100.0 * std::cos(a) + 5.0 * std::sin(6.0 * a) + 150.0;
  point[1] = 40.0 * std::sin(a) + 7.0 * std::cos(4.0 * a) - 80.0;
  return point;
}

ContourType::Pointer
MakeMoving()
{
  std::vector<ContourType::PointType> points;
  for (int i = 0; i < 200; ++i)
  {
    points.push_back(Curve(0.01 * 3.14159265358979 * i));
  }
  const auto contour = ContourType::New();
  contour->AddPolyline(points, itk::ToothCode(), true);
  return contour;
}

TransformType::Pointer
MakeTransform(double scale, double angle, double tx, double ty)
{
  const auto     transform = TransformType::New();
  ParametersType parameters(4);
  parameters[0] = scale;
  parameters[1] = angle;
  parameters[2] = tx;
  parameters[3] = ty;
  transform->SetParameters(parameters);
  return transform;
}

/** The moving contour as the transform maps it: a fixed contour with a known answer. */
ContourType::Pointer
MakeFixed(const TransformType * transform)
{
  std::vector<ContourType::PointType> points;
  for (int i = 0; i < 200; ++i)
  {
    points.push_back(transform->TransformPoint(Curve(0.01 * 3.14159265358979 * i)));
  }
  const auto contour = ContourType::New();
  contour->AddPolyline(points, itk::ToothCode(), true);
  return contour;
}

MetricType::Pointer
MakeMetric(TransformType * start)
{
  const auto truth = MakeTransform(1.1, 0.1, 300.0, 400.0);
  const auto metric = MetricType::New();
  metric->SetFixedContour(MakeFixed(truth));
  metric->SetMovingContour(MakeMoving());
  metric->SetMovingTransform(start);
  metric->Initialize();
  return metric;
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

/** Largest distance of the contour's points from where they belong. */
double
LargestError(const TransformType * transform)
{
  const auto truth = MakeTransform(1.1, 0.1, 300.0, 400.0);
  double     largest = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    const auto point = Curve(0.01 * 3.14159265358979 * i);
    largest = std::max(largest, transform->TransformPoint(point).EuclideanDistanceTo(truth->TransformPoint(point)));
  }
  return largest;
}
} // namespace

TEST(ContourChamferMetricv4, DerivativeIsMinusTheGradient)
{
  const auto metric = MakeMetric(MakeTransform(1.0, 0.0, 310.0, 410.0));
  for (const auto distance : { MetricType::DistanceEnum::PointToPoint, MetricType::DistanceEnum::PointToSegment })
  {
    metric->SetDistance(distance);
    metric->Initialize();
    for (ParametersType position :
         { MakePosition(0, 0, 0, 0), MakePosition(5, -7, 11, 3), MakePosition(-3, 9, 100, 90) })
    {
      metric->SetParameters(position);
      double                     value = 0.0;
      MetricType::DerivativeType derivative;
      metric->GetValueAndDerivative(value, derivative);
      EXPECT_DOUBLE_EQ(metric->GetValue(), value);
      EXPECT_DOUBLE_EQ(metric->EvaluateAt(position), value);
      ASSERT_EQ(derivative.GetSize(), 4u);
      MetricType::DerivativeType alone;
      metric->GetDerivative(alone);
      for (unsigned int k = 0; k < 4; ++k)
      {
        EXPECT_DOUBLE_EQ(alone[k], derivative[k]);
        ParametersType low(position);
        ParametersType high(position);
        low[k] -= 1e-6;
        high[k] += 1e-6;
        // One unit is about a pixel; the value is piecewise smooth, few nearest points change within the step.
        const double difference = (metric->EvaluateAt(high) - metric->EvaluateAt(low)) / 2e-6;
        EXPECT_NEAR(derivative[k], -difference, 1e-5) << "parameter " << k;
      }
    }
  }
}

TEST(ContourChamferMetricv4, ParametersMoveThePointsByPixels)
{
  const auto transform = MakeTransform(0.9, 0.3, 310.0, 410.0);
  const auto metric = MakeMetric(transform);
  const auto moving = MakeMoving();
  const auto before = MakeTransform(0.9, 0.3, 310.0, 410.0);
  for (unsigned int k = 0; k < 4; ++k)
  {
    ParametersType position = MakePosition(0, 0, 0, 0);
    position[k] = 1.0;
    metric->SetParameters(position);
    double meanSquare = 0.0;
    for (unsigned int i = 0; i < moving->GetNumberOfPoints(); ++i)
    {
      const auto point = moving->GetPoint(i);
      meanSquare += transform->TransformPoint(point).SquaredEuclideanDistanceTo(before->TransformPoint(point)) /
                    moving->GetNumberOfPoints();
    }
    // Exactly 1 to first order in 1/100, the unit over the contour's radius.
    EXPECT_NEAR(std::sqrt(meanSquare), 1.0, 0.01) << "parameter " << k;
  }
}

TEST(ContourChamferMetricv4, MapsBetweenTransformAndOptimizer)
{
  const auto                    transform = MakeTransform(0.9, 0.3, 310.0, 410.0);
  TransformType::InputPointType center;
  center[0] = 40.0;
  center[1] = -20.0;
  // The same map about another centre.
  const auto offset = transform->GetOffset();
  transform->SetCenter(center);
  transform->SetOffset(offset);
  const auto     metric = MakeMetric(transform);
  ParametersType position = MakePosition(4.0, -6.0, 10.0, 20.0);
  metric->SetParameters(position);
  const itk::ContourSimilarity similarity = metric->GetSimilarity(position);
  const ParametersType         back = metric->GetOptimizerParameters(similarity);
  for (unsigned int k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(back[k], position[k], 1e-10);
  }
  // The transform is the similarity whatever its centre; the pivot's image moved by the last two parameters.
  EXPECT_EQ(transform->GetCenter(), center);
  EXPECT_NEAR(transform->GetScale(), similarity.scale, 1e-14);
  EXPECT_NEAR(transform->GetOffset()[0], similarity.tx, 1e-10);
  EXPECT_NEAR(transform->GetOffset()[1], similarity.ty, 1e-10);
  const auto before = MakeTransform(0.9, 0.3, 310.0, 410.0)->TransformPoint(metric->GetPivot());
  const auto after = transform->TransformPoint(metric->GetPivot());
  EXPECT_NEAR(after[0] - before[0], 10.0, 1e-10);
  EXPECT_NEAR(after[1] - before[1], 20.0, 1e-10);
}

TEST(ContourChamferMetricv4, BoundsHoldEveryOptimizer)
{
  const auto metric = MakeMetric(MakeTransform(1.0, 0.0, 300.0, 400.0));
  metric->SetBounds(MakePosition(-5, -5, -5, 0), MakePosition(5, 5, 5, 0));
  // Beyond: the value at the border plus ten times the excess.
  EXPECT_DOUBLE_EQ(metric->EvaluateAt(MakePosition(0, 0, 7, 0)), metric->EvaluateAt(MakePosition(0, 0, 5, 0)) + 20.0);
  ParametersType outside = MakePosition(0, 0, 7, 1);
  metric->SetParameters(outside);
  MetricType::DerivativeType derivative;
  metric->GetDerivative(derivative);
  EXPECT_EQ(derivative[2], -10.0);
  EXPECT_EQ(derivative[3], -10.0);
  EXPECT_NEAR(metric->GetOptimizerParameters(metric->GetCurrentSimilarity())[2], 5.0, 1e-10);
  // Updates stop at the border.
  MetricType::DerivativeType update(4);
  update.Fill(100.0);
  metric->UpdateTransformParameters(update, 2.0);
  EXPECT_EQ(metric->GetParameters()[0], 5.0);
  EXPECT_EQ(metric->GetParameters()[3], 0.0);
  EXPECT_THROW(metric->SetBounds(MakePosition(1, 0, 0, 0), MakePosition(0, 0, 0, 0)), itk::ExceptionObject);
}

TEST(ContourChamferMetricv4, StockOptimizersFindTheAnswer)
{
  const auto transform = MakeTransform(1.05, 0.06, 304.0, 404.0);
  const auto metric = MakeMetric(transform);
  metric->SetDistance(MetricType::DistanceEnum::PointToSegment);
  metric->Initialize();
  ASSERT_GT(LargestError(transform), 5.0);

  const auto                                 lbfgsb = itk::LBFGSBOptimizerv4::New();
  itk::LBFGSBOptimizerv4::BoundSelectionType selection(4);
  selection.Fill(itk::LBFGSBOptimizerv4::UNBOUNDED);
  lbfgsb->SetBoundSelection(selection);
  lbfgsb->SetMetric(metric);
  lbfgsb->StartOptimization();
  EXPECT_LT(LargestError(transform), 0.01);

  ParametersType start = MakePosition(0, 0, 0, 0);
  metric->SetParameters(start);
  ASSERT_GT(LargestError(transform), 5.0);
  const auto amoeba = itk::AmoebaOptimizerv4::New();
  amoeba->SetInitialSimplexDelta(MakePosition(2, 2, 2, 2));
  amoeba->SetMetric(metric);
  amoeba->StartOptimization();
  EXPECT_LT(LargestError(transform), 0.05);

  // Plus the derivative goes downhill: the sign that v4 expects.
  metric->SetParameters(start);
  const double initialValue = metric->GetValue();
  const auto   descent = itk::GradientDescentOptimizerv4::New();
  descent->SetLearningRate(0.5);
  descent->SetNumberOfIterations(60);
  descent->SetMetric(metric);
  descent->StartOptimization();
  EXPECT_LT(metric->GetValue(), 0.5 * initialValue);

  const auto                                     multiStart = itk::MultiStartOptimizerv4::New();
  itk::MultiStartOptimizerv4::ParametersListType starts{ MakePosition(0, 0, 40, 0), start, MakePosition(0, 0, 0, 40) };
  multiStart->SetParametersList(starts);
  multiStart->SetMetric(metric);
  multiStart->StartOptimization();
  EXPECT_EQ(multiStart->GetBestParametersIndex(), 1u);
}

TEST(ContourChamferMetricv4, RemembersTheBestPosition)
{
  const auto     metric = MakeMetric(MakeTransform(1.0, 0.0, 300.0, 400.0));
  ParametersType positions[] = { MakePosition(0, 0, 20, 0),
                                 metric->GetOptimizerParameters({ 1.1, 0.1, 301.0, 400.0 }),
                                 MakePosition(0, 0, 0, 30) };
  double         values[3];
  for (int i = 0; i < 3; ++i)
  {
    metric->SetParameters(positions[i]);
    values[i] = metric->GetValue();
  }
  ASSERT_LT(values[1], values[0]);
  ASSERT_LT(values[1], values[2]);
  EXPECT_EQ(metric->GetBestValue(), values[1]);
  EXPECT_EQ(metric->GetBestParameters(), positions[1]);
  EXPECT_EQ(metric->GetNumberOfEvaluations(), 3u);
  EXPECT_EQ(metric->GetCurrentValue(), values[2]);
}

TEST(ContourChamferMetricv4, OneSidedDirectionsSumToTheSymmetricValue)
{
  const auto metric = MakeMetric(MakeTransform(1.0, 0.0, 310.0, 395.0));
  const auto sum = metric->GetValue();
  metric->SetDirection(MetricType::DirectionEnum::MovingToFixed);
  const auto there = metric->GetValue();
  metric->SetDirection(MetricType::DirectionEnum::FixedToMoving);
  EXPECT_DOUBLE_EQ(there + metric->GetValue(), sum);
  metric->SetTruncation(1.0);
  EXPECT_LE(metric->GetValue(), 1.0);
}

TEST(ContourChamferMetricv4, SaysWhatIsWrong)
{
  const auto metric = MetricType::New();
  EXPECT_THROW(metric->GetValue(), itk::ExceptionObject);
  EXPECT_THROW(metric->Initialize(), itk::ExceptionObject);
  metric->SetFixedContour(MakeMoving());
  EXPECT_THROW(metric->Initialize(), itk::ExceptionObject);
  metric->SetMovingContour(ContourType::New());
  try
  {
    metric->Initialize();
    FAIL();
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("SetMovingContour()"), std::string::npos);
  }
  metric->SetMovingContour(MakeMoving());
  metric->Initialize();
  EXPECT_THROW(metric->SetTruncation(0.0), itk::ExceptionObject);
  ParametersType bad = MakePosition(0, std::nan(""), 0, 0);
  EXPECT_THROW(metric->SetParameters(bad), itk::ExceptionObject);
  ParametersType tooFew(3);
  tooFew.Fill(0.0);
  EXPECT_THROW(metric->SetParameters(tooFew), itk::ExceptionObject);
  metric->SetMovingTransform(MakeTransform(0.0, 0.0, 0.0, 0.0));
  EXPECT_THROW(metric->Initialize(), itk::ExceptionObject);
}

TEST(ContourChamferMetricv4, SinglePointHasAValue)
{
  const auto                          metric = MetricType::New();
  const auto                          fixed = ContourType::New();
  const auto                          moving = ContourType::New();
  std::vector<ContourType::PointType> point(1);
  fixed->AddPolyline(point);
  point[0][0] = 3.0;
  point[0][1] = 4.0;
  moving->AddPolyline(point);
  metric->SetFixedContour(fixed);
  metric->SetMovingContour(moving);
  metric->Initialize();
  EXPECT_DOUBLE_EQ(metric->GetValue(), 10.0);
  std::ostringstream text;
  metric->Print(text);
  EXPECT_NE(text.str().find("ReferenceLength: 1"), std::string::npos);
}
