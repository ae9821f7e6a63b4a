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
#include "itkContourOverlapFilter.h"

#include "itkGTest.h"
#include "itkTestingMacros.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace
{
using FilterType = itk::ContourOverlapFilter;
using ContourType = itk::DentalContour;
using PointType = ContourType::PointType;

int
ExerciseBasicObjectMethods()
{
  const auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, ContourOverlapFilter, ProcessObject);
  return EXIT_SUCCESS;
}

ContourType::Pointer
MakeLine(double from, double to, double y)
{
  std::vector<PointType> points;
  for (int i = 0; i <= 100; ++i)
  {
    PointType point;
    point[0] = from + (to - from) * 0.01 * i;
    point[1] = y;
    points.push_back(point);
  }
  const auto contour = ContourType::New();
  contour->AddPolyline(points);
  return contour;
}
} // namespace

TEST(ContourOverlapFilter, SharesAndDistancesAreThoseOfHand)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  // The tracing reaches a quarter of its length beyond the outline, the outline 150 px beyond the tracing.
  const auto filter = FilterType::New();
  filter->SetFixedContour(MakeLine(0.0, 100.0, 2.0));
  filter->SetMovingContour(MakeLine(25.0, 250.0, 0.0));
  filter->Update();
  // The points at 25 .. 100 px.
  EXPECT_NEAR(filter->GetFixedShare(), 76.0 / 101.0, 1e-12);
  EXPECT_NEAR(filter->GetMovingShare(), 75.0 / 225.0, 0.01);
  EXPECT_NEAR(filter->GetRootMeanSquare(), 2.0, 1e-12);
  EXPECT_NEAR(filter->GetLargestDistance(), 2.0, 1e-12);
  EXPECT_EQ(filter->GetFixedShareOutput()->Get(), filter->GetFixedShare());
  ASSERT_EQ(filter->GetFixedDistances().size(), 101u);
  EXPECT_NEAR(filter->GetFixedDistances()[0], std::hypot(25.0, 2.0), 1e-12);
  ASSERT_EQ(filter->GetMovingDistances().size(), 101u);
  EXPECT_NEAR(filter->GetMovingDistances()[10], 2.0, 1e-12);
  EXPECT_TRUE(std::isnan(filter->GetMovingDistances()[60]));
  filter->SetMaximumDistance(1.0);
  filter->Update();
  EXPECT_EQ(filter->GetFixedShare(), 0.0);
  EXPECT_EQ(filter->GetMovingShare(), 0.0);
  EXPECT_EQ(filter->GetRootMeanSquare(), 0.0);
}

TEST(ContourOverlapFilter, SharesAndDistancesAreThoseUnderTheTransform)
{
  // The outline is turned by 0.3 rad, scaled by 1.25 and shifted before it lies 3 px beside the tracing.
  const auto transform = FilterType::TransformType::New();
  transform->SetScale(1.25);
  transform->SetAngle(0.3);
  FilterType::TransformType::OutputVectorType shift;
  shift[0] = 40.0;
  shift[1] = -20.0;
  transform->SetTranslation(shift);
  const auto inverse = FilterType::TransformType::New();
  ASSERT_TRUE(transform->GetInverse(inverse));
  const auto outline = ContourType::New();
  const auto straight = MakeLine(0.0, 200.0, 3.0);
  auto       polyline = straight->GetPolylines().front();
  for (PointType & point : polyline.points)
  {
    point = inverse->TransformPoint(point);
  }
  outline->AddPolyline(polyline);
  const auto filter = FilterType::New();
  filter->SetFixedContour(MakeLine(50.0, 150.0, 0.0));
  filter->SetMovingContour(outline);
  filter->SetTransform(transform);
  filter->Update();
  EXPECT_EQ(filter->GetFixedShare(), 1.0);
  EXPECT_NEAR(filter->GetRootMeanSquare(), 3.0, 1e-9);
  // 49 of the outline's points, 2 px apart, lie beside the tracing and not beside its ends.
  EXPECT_NEAR(filter->GetMovingShare(), 49.0 * 2.0 / 200.0, 1e-9);
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("MovingShare: 0."), std::string::npos);
}

TEST(ContourOverlapFilter, AGapOfTheTracingIsAnEndWhereItIsWide)
{
  // Two stretches of tracing, 6 px apart; 3 of the outline's points, 2 px apart, lie beside the gap or its ends.
  const auto tracing = ContourType::New();
  tracing->AddPolyline(MakeLine(0.0, 100.0, 0.0)->GetPolylines().front());
  tracing->AddPolyline(MakeLine(106.0, 200.0, 0.0)->GetPolylines().front());
  const auto filter = FilterType::New();
  filter->SetFixedContour(tracing);
  filter->SetMovingContour(MakeLine(0.0, 200.0, 1.0));
  const auto censored = [&] {
    std::size_t count = 0;
    for (const double distance : filter->GetMovingDistances())
    {
      count += std::isnan(distance) ? 1 : 0;
    }
    return count;
  };
  filter->Update();
  EXPECT_EQ(filter->GetGapLength(), 8.0);
  // The outermost two alone.
  EXPECT_EQ(censored(), 2u);
  filter->SetGapLength(5.0);
  filter->Update();
  // 100, 102, 104 and 106 px as well.
  EXPECT_EQ(censored(), 6u);
}

TEST(ContourOverlapFilter, AClosedTracingHasNoEndAndPointsOfWeightZeroAreNotThere)
{
  ContourType::PolylineType square;
  for (const auto & corner :
       { std::pair(0.0, 0.0), std::pair(100.0, 0.0), std::pair(100.0, 100.0), std::pair(0.0, 100.0) })
  {
    PointType point;
    point[0] = corner.first;
    point[1] = corner.second;
    square.points.push_back(point);
  }
  square.closed = true;
  const auto closed = ContourType::New();
  closed->AddPolyline(square);
  const auto filter = FilterType::New();
  filter->SetFixedContour(closed);
  filter->SetMovingContour(MakeLine(0.0, 100.0, -2.0));
  filter->Update();
  EXPECT_EQ(filter->GetMovingShare(), 1.0);
  // Without its first corner the square is an open line of three: nothing is drawn above it any longer.
  square.weights = { 0.0, 1.0, 1.0, 1.0 };
  const auto open = ContourType::New();
  open->AddPolyline(square);
  filter->SetFixedContour(open);
  filter->Update();
  EXPECT_TRUE(std::isnan(filter->GetFixedDistances()[0]));
  EXPECT_EQ(filter->GetMovingShare(), 0.0);
}

TEST(ContourOverlapFilter, SaysWhatIsMissing)
{
  const auto filter = FilterType::New();
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetFixedContour(MakeLine(0.0, 100.0, 0.0));
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetMovingContour(ContourType::New());
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetMovingContour(MakeLine(0.0, 100.0, 0.0));
  filter->SetMaximumDistance(0.0);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetMaximumDistance(3.0);
  EXPECT_NO_THROW(filter->Update());
  EXPECT_EQ(filter->GetFixedShare(), 1.0);
}
