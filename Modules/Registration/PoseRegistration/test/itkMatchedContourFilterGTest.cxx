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
#include "itkMatchedContourFilter.h"

#include "itkMessageOfCall.h"
#include "itkPoseSolutionTestCase.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using itk::MessageOfCall;
using namespace PoseSolutionTestCase;
using FilterType = itk::MatchedContourFilter;
using ContourType = FilterType::ContourType;

/** A stretch of a line along u, a point each 2 px. */
std::vector<ContourType::PointType>
Stretch(double from, double to, double v)
{
  std::vector<ContourType::PointType> points;
  for (double u = from; u <= to; u += 2.0)
  {
    ContourType::PointType point;
    point[0] = u;
    point[1] = v;
    points.push_back(point);
  }
  return points;
}

FilterType::Pointer
Match(const std::vector<std::vector<ContourType::PointType>> & moving,
      const std::vector<std::vector<ContourType::PointType>> & fixed)
{
  auto       filter = FilterType::New();
  const auto make = [](const auto & stretches) {
    auto contour = ContourType::New();
    for (const auto & stretch : stretches)
    {
      contour->AddPolyline(stretch);
    }
    return contour;
  };
  filter->SetMovingContour(make(moving));
  filter->SetFixedContour(make(fixed));
  return filter;
}

int
ExerciseBasicObjectMethods()
{
  const auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, MatchedContourFilter, ProcessObject);
  return EXIT_SUCCESS;
}
} // namespace

TEST(MatchedContourFilter, BasicObjectMethodsAndDefaults)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  EXPECT_EQ(FilterType::New()->GetMaximumDistance(), 10.0);
  EXPECT_EQ(FilterType::New()->GetMaximumGap(), 12.0);
}

TEST(MatchedContourFilter, KeepsWhatHasATracingBesideItInPieces)
{
  // Traced from 20 to 40 and from 100 to 120, 3 px above.
  const auto filter = Match({ Stretch(0.0, 200.0, 50.0) }, { Stretch(20.0, 40.0, 47.0), Stretch(100.0, 120.0, 47.0) });
  filter->Update();
  const auto pieces = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(pieces.size(), 2u);
  // Within 10 px of an end: hypot(9.5, 3) is less, hypot(10, 3) is not.
  EXPECT_EQ(pieces[0].points.front()[0], 12.0);
  EXPECT_EQ(pieces[0].points.back()[0], 48.0);
  EXPECT_EQ(pieces[1].points.front()[0], 92.0);
  EXPECT_EQ(pieces[1].points.back()[0], 128.0);
  for (const auto & piece : pieces)
  {
    EXPECT_FALSE(piece.closed);
    for (const auto & point : piece.points)
    {
      EXPECT_EQ(point[1], 50.0) << "the moving contour's points, not the tracing's";
    }
  }
  filter->SetMaximumDistance(4.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPolylines()[0].points.front()[0], 18.0);
  EXPECT_EQ(filter->GetOutput()->GetPolylines().size(), 2u) << "not appended to what was there";
}

TEST(MatchedContourFilter, AGapOfTheMovingContourEndsAPiece)
{
  auto moving = Stretch(0.0, 40.0, 50.0);
  for (const auto & point : Stretch(51.0, 60.0, 50.0))
  {
    moving.push_back(point);
  }
  for (const auto & point : Stretch(80.0, 100.0, 50.0))
  {
    moving.push_back(point);
  }
  const auto filter = Match({ moving }, { Stretch(0.0, 100.0, 50.0) });
  filter->Update();
  // 11 px are bridged, 21 are not.
  ASSERT_EQ(filter->GetOutput()->GetPolylines().size(), 2u);
  EXPECT_EQ(filter->GetOutput()->GetPolylines()[1].points.front()[0], 80.0);
  filter->SetMaximumGap(5.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPolylines().size(), 3u);
}

TEST(MatchedContourFilter, NothingBesideIsAnEmptyContour)
{
  const auto filter = Match({ Stretch(0.0, 40.0, 50.0) }, { Stretch(0.0, 40.0, 90.0) });
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0u);
  for (const auto & empty : { Match({}, {}), Match({ Stretch(0.0, 40.0, 50.0) }, {}) })
  {
    empty->Update();
    EXPECT_EQ(empty->GetOutput()->GetNumberOfPoints(), 0u);
  }
}

TEST(MatchedContourFilter, WithoutAContourItSaysWhich)
{
  auto filter = FilterType::New();
  filter->SetMovingContour(ContourType::New());
  EXPECT_TRUE(Contains(MessageOfCall([&] { filter->Update(); }), "FixedContour"));
}

TEST(MatchedContourFilter, KeepsWhatThePointsOfTheMovingContourKnow)
{
  ContourType::PolylineType moving;
  moving.points = Stretch(0.0, 40.0, 3.0);
  for (std::size_t i = 0; i < moving.points.size(); ++i)
  {
    const double normal[2] = { 0.0, -1.0 };
    const double rim[3] = { moving.points[i][0], 10.0, -5.0 };
    moving.normals.emplace_back(normal);
    moving.rimPoints.emplace_back(rim);
  }
  auto contour = ContourType::New();
  contour->AddPolyline(moving);
  // Another one within the gap, which knows nothing: it joins the piece, unknown.
  contour->AddPolyline(Stretch(42.0, 44.0, 3.0));
  auto fixed = ContourType::New();
  fixed->AddPolyline(Stretch(20.0, 60.0, 0.0));
  auto filter = FilterType::New();
  filter->SetMovingContour(contour);
  filter->SetFixedContour(fixed);
  filter->Update();
  const auto matched = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(matched.size(), 1u);
  ASSERT_EQ(matched[0].rimPoints.size(), matched[0].points.size());
  ASSERT_GT(matched[0].points.size(), 4u);
  for (std::size_t i = 0; i + 2 < matched[0].points.size(); ++i)
  {
    EXPECT_EQ(matched[0].rimPoints[i][0], matched[0].points[i][0]);
    EXPECT_EQ(matched[0].normals[i], moving.normals[0]);
  }
  EXPECT_TRUE(std::isnan(matched[0].rimPoints.back()[0]));
}

TEST(MatchedContourFilter, PolylinesOfOneToothEachKeepIt)
{
  auto contour = ContourType::New();
  contour->AddPolyline(Stretch(0.0, 20.0, 3.0), itk::ToothCode(11));
  // Within the gap, so that it joins the piece; and one that begins a piece.
  contour->AddPolyline(Stretch(22.0, 40.0, 3.0), itk::ToothCode(12));
  ContourType::PolylineType weighted;
  weighted.points = Stretch(80.0, 100.0, 3.0);
  weighted.code = itk::ToothCode(13);
  weighted.weights.assign(weighted.points.size(), 0.5);
  contour->AddPolyline(weighted);
  auto fixed = ContourType::New();
  fixed->AddPolyline(Stretch(0.0, 100.0, 0.0));
  auto filter = FilterType::New();
  filter->SetMovingContour(contour);
  filter->SetFixedContour(fixed);
  filter->Update();
  const auto pieces = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].code, itk::ToothCode(11));
  ASSERT_EQ(pieces[0].teeth.size(), pieces[0].points.size());
  for (std::size_t i = 0; i < pieces[0].points.size(); ++i)
  {
    EXPECT_EQ(pieces[0].teeth[i], itk::ToothCode(pieces[0].points[i][0] < 21.0 ? 11u : 12u)) << i;
  }
  EXPECT_EQ(pieces[1].code, itk::ToothCode(13));
  EXPECT_TRUE(pieces[1].teeth.empty());
  EXPECT_EQ(pieces[1].weights, weighted.weights);
}
