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
#include "itkContourDistanceFilter.h"

#include "itkGTest.h"

#include <cmath>
#include <sstream>

namespace
{
using FilterType = itk::ContourDistanceFilter;
using ContourType = itk::DentalContour;

ContourType::Pointer
MakeContour(const std::vector<std::array<double, 2>> & points, const std::vector<double> & weights = {})
{
  ContourType::PolylineType polyline;
  for (const auto & xy : points)
  {
    ContourType::PointType point;
    point[0] = xy[0];
    point[1] = xy[1];
    polyline.points.push_back(point);
  }
  polyline.weights = weights;
  const auto contour = ContourType::New();
  contour->AddPolyline(polyline);
  return contour;
}
} // namespace

TEST(ContourDistanceFilter, FiguresAreThoseOfHand)
{
  const auto filter = FilterType::New();
  filter->SetFixedContour(MakeContour({ { 0, 0 }, { 10, 0 } }));
  filter->SetMovingContour(MakeContour({ { 0, 3 }, { 5, 4 }, { 10, 0 } }));
  filter->Update();
  const double there = (3.0 + std::sqrt(41.0)) / 3.0;
  EXPECT_DOUBLE_EQ(filter->GetMovingToFixedMean(), there);
  EXPECT_DOUBLE_EQ(filter->GetFixedToMovingMean(), 1.5);
  EXPECT_DOUBLE_EQ(filter->GetChamfer(), 0.5 * (there + 1.5));
  EXPECT_DOUBLE_EQ(filter->GetMovingToFixedHausdorff(), std::sqrt(41.0));
  EXPECT_DOUBLE_EQ(filter->GetFixedToMovingHausdorff(), 3.0);
  EXPECT_DOUBLE_EQ(filter->GetHausdorff(), std::sqrt(41.0));
  ASSERT_EQ(filter->GetMovingToFixedDistances().size(), 3u);
  EXPECT_DOUBLE_EQ(filter->GetMovingToFixedDistances()[0], 3.0);
  ASSERT_EQ(filter->GetFixedToMovingDistances().size(), 2u);
  EXPECT_DOUBLE_EQ(filter->GetFixedToMovingDistances()[1], 0.0);
  EXPECT_DOUBLE_EQ(filter->GetChamferOutput()->Get(), filter->GetChamfer());

  filter->SetDistance(FilterType::DistanceEnum::PointToSegment);
  filter->Update();
  EXPECT_DOUBLE_EQ(filter->GetMovingToFixedMean(), 7.0 / 3.0);
  EXPECT_DOUBLE_EQ(filter->GetHausdorff(), 4.0);
}

TEST(ContourDistanceFilter, TransformMovesTheMovingContour)
{
  const auto transform = FilterType::TransformType::New();
  // Twice the size, a quarter turn, then a shift: (1, 0) -> (0, 2) -> (5, 7), about a centre that is not 0.
  FilterType::TransformType::InputPointType center;
  center[0] = 1.0;
  center[1] = 1.0;
  transform->SetCenter(center);
  transform->SetScale(2.0);
  transform->SetAngle(std::acos(0.0));
  FilterType::TransformType::OutputVectorType offset;
  offset[0] = 5.0;
  offset[1] = 5.0;
  transform->SetOffset(offset);
  const auto filter = FilterType::New();
  filter->SetFixedContour(MakeContour({ { 5, 7 }, { 5, 9 } }));
  filter->SetMovingContour(MakeContour({ { 1, 0 }, { 2, 0 } }));
  filter->SetTransform(transform);
  filter->Update();
  EXPECT_NEAR(filter->GetHausdorff(), 0.0, 1e-14);
  // A change of the transform runs the filter again.
  transform->SetAngle(0.0);
  filter->Update();
  EXPECT_GT(filter->GetHausdorff(), 1.0);
}

TEST(ContourDistanceFilter, WeightsWeighTheMeansAndZeroIgnores)
{
  const auto filter = FilterType::New();
  filter->SetFixedContour(MakeContour({ { 0, 0 }, { 10, 0 } }));
  filter->SetMovingContour(MakeContour({ { 0, 1 }, { 10, 2 }, { 100, 0 } }, { 1.0, 0.5, 0.0 }));
  filter->Update();
  EXPECT_DOUBLE_EQ(filter->GetMovingToFixedMean(), (1.0 + 0.5 * 2.0) / 1.5);
  EXPECT_DOUBLE_EQ(filter->GetHausdorff(), 2.0);
  EXPECT_TRUE(std::isnan(filter->GetMovingToFixedDistances()[2]));
}

TEST(ContourDistanceFilter, TeethOfTheFixedContourAreSummedUpByHand)
{
  const auto fixed = ContourType::New();
  const auto add =
    [&](const std::vector<std::array<double, 2>> & points, unsigned int fdi, const std::vector<double> & weights) {
      ContourType::PolylineType polyline = MakeContour(points)->GetPolylines().front();
      polyline.code = fdi == 0 ? itk::ToothCode() : itk::ToothCode(fdi);
      polyline.weights = weights;
      fixed->AddPolyline(polyline);
    };
  // Above a line along v = 0, so that the distance is v: 3 and 4 of UR2, 2 of no tooth, then 5 more of UR2. A point of
  // weight 0 is none, one of weight 0.5 is a whole one here.
  add({ { 1, 3 }, { 2, 4 } }, 12, { 1.0, 0.5 });
  add({ { 3, 2 }, { 4, 9 } }, 0, { 1.0, 0.0 });
  add({ { 5, 5 }, { 6, 9 } }, 12, { 1.0, 0.0 });
  add({ { 7, 9 } }, 13, { 0.0 });
  const auto filter = FilterType::New();
  filter->SetFixedContour(fixed);
  filter->SetMovingContour(MakeContour({ { 0, 0 }, { 10, 0 } }));
  filter->SetDistance(FilterType::DistanceEnum::PointToSegment);
  filter->Update();
  const auto & teeth = filter->GetFixedToMovingDistancesByTooth();
  ASSERT_EQ(teeth.size(), 2u) << "UR3 has no point that counts";
  EXPECT_EQ(teeth[0].tooth, itk::ToothCode(12));
  EXPECT_EQ(teeth[0].numberOfPoints, 3u);
  EXPECT_DOUBLE_EQ(teeth[0].mean, 4.0);
  EXPECT_DOUBLE_EQ(teeth[0].rms, std::sqrt(50.0 / 3.0));
  EXPECT_DOUBLE_EQ(teeth[0].maximum, 5.0);
  EXPECT_FALSE(teeth[1].tooth.IsKnown());
  EXPECT_EQ(teeth[1].numberOfPoints, 1u);
  EXPECT_DOUBLE_EQ(teeth[1].mean, 2.0);
  EXPECT_DOUBLE_EQ(teeth[1].rms, 2.0);
}

/** A point of little weight is as far away as any other: weights are of means alone. */
TEST(ContourDistanceFilter, TheLargestDistanceIsOfAnyPointThatCounts)
{
  const auto filter = FilterType::New();
  filter->SetFixedContour(MakeContour({ { 0, 0 }, { 10, 0 } }));
  filter->SetMovingContour(MakeContour({ { 0, 1 }, { 10, 6 } }, { 1.0, 0.125 }));
  filter->Update();
  EXPECT_DOUBLE_EQ(filter->GetMovingToFixedHausdorff(), 6.0);
  EXPECT_DOUBLE_EQ(filter->GetHausdorff(), 6.0);
}

TEST(ContourDistanceFilter, SaysWhatIsMissing)
{
  const auto filter = FilterType::New();
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetFixedContour(MakeContour({ { 0, 0 } }));
  try
  {
    filter->Update();
    FAIL();
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("SetMovingContour()"), std::string::npos);
  }
  filter->SetMovingContour(ContourType::New());
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetMovingContour(MakeContour({ { 3, 4 } }));
  filter->Update();
  EXPECT_DOUBLE_EQ(filter->GetChamfer(), 5.0);
}

TEST(ContourDistanceFilter, RunsOnlyWhenSomethingChanged)
{
  const auto filter = FilterType::New();
  filter->SetFixedContour(MakeContour({ { 0, 0 }, { 10, 0 } }));
  filter->SetMovingContour(MakeContour({ { 0, 3 }, { 5, 4 } }));
  int runs = 0;
  filter->AddObserver(itk::StartEvent(), [&runs](const itk::EventObject &) { ++runs; });
  filter->Update();
  filter->Update();
  EXPECT_EQ(runs, 1);
  filter->SetDistance(FilterType::DistanceEnum::PointToSegment);
  filter->Update();
  EXPECT_EQ(runs, 2);
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("Hausdorff"), std::string::npos);
}
