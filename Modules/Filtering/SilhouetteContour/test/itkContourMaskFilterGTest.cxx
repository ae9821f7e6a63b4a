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
#include "itkContourMaskFilter.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using MaskType = itk::Image<unsigned char, 2>;
using FilterType = itk::ContourMaskFilter<MaskType>;
using PolylineType = itk::DentalContour::PolylineType;

/** 0 left of a column, 1 from there on. */
MaskType::Pointer
MakeMask(int firstColumn)
{
  auto                 mask = MaskType::New();
  MaskType::RegionType region;
  region.SetSize(0, 20);
  region.SetSize(1, 20);
  mask->SetRegions(region);
  mask->Allocate(true);
  // Not to be taken into account.
  mask->SetSpacing(MaskType::SpacingType(0.25));
  for (int x = firstColumn; x < 20; ++x)
  {
    for (int y = 0; y < 20; ++y)
    {
      mask->SetPixel({ { x, y } }, 1);
    }
  }
  return mask;
}

/** A square from (4, 4) to (12, 12), a point a pixel, starting in the middle of its right side. */
PolylineType
MakeSquare()
{
  PolylineType square;
  square.closed = true;
  square.code = itk::ToothCode(11);
  const auto add = [&](double x, double y) {
    square.points.push_back(itk::DentalContour::PointType(std::array<double, 2>{ { x, y } }.data()));
    square.weights.push_back(x / 20.0);
  };
  for (int y = 8; y < 12; ++y)
  {
    add(12, y);
  }
  for (int x = 12; x > 4; --x)
  {
    add(x, 12);
  }
  for (int y = 12; y > 4; --y)
  {
    add(4, y);
  }
  for (int x = 4; x < 12; ++x)
  {
    add(x, 4);
  }
  for (int y = 4; y < 8; ++y)
  {
    add(12, y);
  }
  return square;
}

int
ExerciseBasics()
{
  const auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, ContourMaskFilter, MeshToMeshFilter);
  return EXIT_SUCCESS;
}
} // namespace

TEST(ContourMaskFilter, IsAnItkObject)
{
  EXPECT_EQ(ExerciseBasics(), EXIT_SUCCESS);
}

TEST(ContourMaskFilter, OpensAClosedPolylineWithoutCuttingAtItsStart)
{
  auto contour = itk::DentalContour::New();
  contour->AddPolyline(MakeSquare());
  auto filter = FilterType::New();
  filter->SetInput(contour);
  filter->SetMaskImage(MakeMask(10));
  filter->Update();
  const auto polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_FALSE(polylines[0].closed);
  EXPECT_EQ(polylines[0].code, itk::ToothCode(11));
  // Three columns of the upper and of the lower side, seven rows between.
  ASSERT_EQ(polylines[0].points.size(), 13u);
  EXPECT_EQ(polylines[0].points.front()[0], 10.0);
  EXPECT_EQ(polylines[0].points.front()[1], 4.0);
  EXPECT_EQ(polylines[0].points.back()[1], 12.0);
  ASSERT_EQ(polylines[0].weights.size(), 13u);
  EXPECT_EQ(polylines[0].weights[0], 0.5);
}

TEST(ContourMaskFilter, LeavesAPolylineThatIsKeptAsAWholeClosed)
{
  auto contour = itk::DentalContour::New();
  contour->AddPolyline(MakeSquare());
  auto filter = FilterType::New();
  filter->SetInput(contour);
  filter->SetMaskImage(MakeMask(0));
  filter->Update();
  const auto polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_TRUE(polylines[0].closed);
  EXPECT_EQ(polylines[0].points.size(), MakeSquare().points.size());
}

TEST(ContourMaskFilter, CutsAnOpenPolylineAndDropsShortStretchesAndWhatIsOutside)
{
  auto         contour = itk::DentalContour::New();
  PolylineType line;
  // Two columns inside the mask, out to the left, in again, out of the image.
  for (const double x : { 11.0, 10.0, 9.4, 8.0, 9.6, 12.0, 19.4, 19.6, 30.0 })
  {
    line.points.push_back(itk::DentalContour::PointType(std::array<double, 2>{ { x, 3.0 } }.data()));
  }
  contour->AddPolyline(line);
  auto filter = FilterType::New();
  filter->SetInput(contour);
  filter->SetMaskImage(MakeMask(10));
  filter->Update();
  auto polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 2u);
  EXPECT_EQ(polylines[0].points.size(), 2u);
  EXPECT_EQ(polylines[1].points.size(), 3u);
  filter->SetMinimumNumberOfPoints(3);
  filter->Update();
  polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_EQ(polylines[0].points[0][0], 9.6);
}

TEST(ContourMaskFilter, KeepsWhatASilhouettesPointsKnow)
{
  auto square = MakeSquare();
  for (std::size_t i = 0; i < square.points.size(); ++i)
  {
    const double angle = 0.1 * static_cast<double>(i);
    const double normal[2] = { std::cos(angle), std::sin(angle) };
    const double rim[3] = { square.points[i][0], 7.0, square.points[i][1] };
    square.normals.emplace_back(normal);
    square.rimPoints.emplace_back(rim);
    square.teeth.emplace_back(i % 2 == 0 ? 11u : 12u);
  }
  const auto contour = itk::DentalContour::New();
  contour->AddPolyline(square);
  const auto filter = FilterType::New();
  filter->SetInput(contour);
  filter->SetMaskImage(MakeMask(8));
  filter->Update();
  const auto kept = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(kept.size(), 1u);
  ASSERT_EQ(kept[0].rimPoints.size(), kept[0].points.size());
  ASSERT_EQ(kept[0].teeth.size(), kept[0].points.size());
  for (std::size_t i = 0; i < kept[0].points.size(); ++i)
  {
    EXPECT_EQ(kept[0].rimPoints[i][0], kept[0].points[i][0]);
    EXPECT_EQ(kept[0].rimPoints[i][2], kept[0].points[i][1]);
    const auto at = std::find(square.points.begin(), square.points.end(), kept[0].points[i]) - square.points.begin();
    EXPECT_EQ(kept[0].normals[i], square.normals[static_cast<std::size_t>(at)]);
    EXPECT_EQ(kept[0].teeth[i], square.teeth[static_cast<std::size_t>(at)]);
  }
}

TEST(ContourMaskFilter, EachPolylineKeepsItsTooth)
{
  const auto contour = itk::DentalContour::New();
  auto       second = MakeSquare();
  second.code = itk::ToothCode(12);
  contour->AddPolyline(MakeSquare());
  contour->AddPolyline(second);
  const auto filter = FilterType::New();
  filter->SetInput(contour);
  filter->SetMaskImage(MakeMask(10));
  filter->Update();
  const auto kept = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].code, itk::ToothCode(11));
  EXPECT_EQ(kept[1].code, itk::ToothCode(12));
  EXPECT_TRUE(kept[0].teeth.empty() && kept[1].teeth.empty());
}

TEST(ContourMaskFilter, SaysWhatIsMissing)
{
  auto filter = FilterType::New();
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetInput(itk::DentalContour::New());
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}
