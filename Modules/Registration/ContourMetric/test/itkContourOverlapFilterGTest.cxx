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

#include "itkPartialContourTestCase.h"

#include "itkGTest.h"
#include "itkTestingMacros.h"

#include <sstream>

using namespace PartialContourTestCase;

namespace
{
using FilterType = itk::ContourOverlapFilter;

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
  EXPECT_EQ(filter->GetWhiteNoise(), 0.0);
}

TEST(ContourOverlapFilter, TellsTheNoiseOfATracingAndItsShareUnderTheTransform)
{
  const auto filter = FilterType::New();
  filter->SetFixedContour(MakeFixed(0.2, 0.8, 0.5, 0.2));
  filter->SetMovingContour(MakeMoving());
  filter->SetTransform(MakeTruth());
  filter->Update();
  EXPECT_NEAR(filter->GetFixedShare(), 0.8, 0.03);
  EXPECT_NEAR(filter->GetMovingShare(), 0.6 * 0.8, 0.08);
  // White noise of 0.5 px along the normal, told by 50 points within a tenth or so; no drift, but the points beside the
  // outliers' steps have wrong normals.
  EXPECT_NEAR(filter->GetWhiteNoise(), 0.5, 0.12);
  EXPECT_LT(filter->GetSmoothNoise(), 0.8);
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("MovingShare: 0."), std::string::npos);
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
