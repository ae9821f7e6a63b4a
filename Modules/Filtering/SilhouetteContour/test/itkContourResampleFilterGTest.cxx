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
#include "itkContourResampleFilter.h"
#include "itkContourResampling.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{
using ContourType = itk::DentalContour;
using FilterType = itk::ContourResampleFilter;

ContourType::PointType
P(double u, double v)
{
  ContourType::PointType point;
  point[0] = u;
  point[1] = v;
  return point;
}

ContourType::Pointer
MakeSquare()
{
  const auto contour = ContourType::New();
  contour->AddPolyline({ P(1, 2), P(11, 2), P(11, 12), P(1, 12) }, itk::ToothCode(16), true);
  return contour;
}

int
ExerciseBasics()
{
  const auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, ContourResampleFilter, MeshToMeshFilter);
  return EXIT_SUCCESS;
}
} // namespace

TEST(ContourResampleFilter, IsAnItkObject)
{
  EXPECT_EQ(ExerciseBasics(), EXIT_SUCCESS);
}

TEST(ContourResampleFilter, IsExactOnASquare)
{
  const auto filter = FilterType::New();
  filter->SetInput(MakeSquare());
  filter->SetNumberOfPoints(40);
  filter->Update();
  const auto polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_TRUE(polylines[0].closed);
  EXPECT_EQ(polylines[0].code, itk::ToothCode(16));
  ASSERT_EQ(polylines[0].points.size(), 40u);
  for (unsigned int i = 0; i < 40; ++i)
  {
    const double side = i % 10;
    const auto   expected = i < 10   ? P(1 + side, 2)
                            : i < 20 ? P(11, 2 + side)
                            : i < 30 ? P(11 - side, 12)
                                     : P(1, 12 - side);
    EXPECT_NEAR(polylines[0].points[i].EuclideanDistanceTo(expected), 0.0, 1e-12) << i;
  }
  const auto time = filter->GetOutput()->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetMTime(), time) << "executed again without a reason";
  // 40 px at about 3 px: 13 intervals.
  filter->SetNumberOfPoints(0);
  filter->SetSpacing(3.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 13u);
}

TEST(ContourResampleFilter, KeepsEndsCodesAndWeightsOfOpenPolylines)
{
  const auto                contour = ContourType::New();
  ContourType::PolylineType polyline;
  polyline.code = itk::ToothCode(11);
  polyline.points = { P(0, 0), P(3, 0), P(3, 7) };
  polyline.weights = { 1.0, 0.4, 0.4 };
  contour->AddPolyline(polyline);
  contour->AddPolyline({ P(50, 50), P(80, 50) }, itk::ToothCode(12));
  contour->AddPolyline({ P(9, 9) }, itk::ToothCode(13));
  contour->AddPolyline({ P(7, 7), P(7, 7) }, itk::ToothCode(14));
  const auto filter = FilterType::New();
  filter->SetInput(contour);
  filter->SetNumberOfPoints(42);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 42u);
  const auto polylines = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 4u);
  EXPECT_EQ(polylines[0].points.size(), 10u);
  EXPECT_EQ(polylines[1].points.size(), 30u);
  EXPECT_EQ(polylines[0].points.front(), P(0, 0));
  EXPECT_EQ(polylines[0].points.back(), P(3, 7));
  EXPECT_EQ(polylines[1].points.back(), P(80, 50));
  EXPECT_EQ(polylines[0].code, itk::ToothCode(11));
  // 10 px in 9 intervals: the second point is 10/9 px along the first 3 px.
  EXPECT_NEAR(polylines[0].weights[1], 1.0 - 0.6 * (10.0 / 9.0) / 3.0, 1e-12);
  EXPECT_NEAR(polylines[0].weights[5], 0.4, 1e-12);
  EXPECT_EQ(polylines[1].weights[3], 1.0);
}

/** Between 0, which stands for unknown, and 2 px there is no 0.02 px, which would weigh most of all. */
TEST(ContourResampleFilter, BesideAPointOfUnknownErrorErrorsAreUnknown)
{
  const auto                contour = ContourType::New();
  ContourType::PolylineType polyline;
  polyline.points = { P(0, 0), P(10, 0), P(20, 0), P(30, 0) };
  polyline.sigmas = { 0.0, 2.0, 4.0, 4.0 };
  contour->AddPolyline(polyline);
  const auto filter = FilterType::New();
  filter->SetInput(contour);
  filter->SetNumberOfPoints(13);
  filter->Update();
  const auto sigmas = filter->GetOutput()->GetPolylines().at(0).sigmas;
  ASSERT_EQ(sigmas.size(), 13u);
  for (const std::size_t i : { 0, 1, 2, 3 })
  {
    EXPECT_EQ(sigmas[i], 0.0) << i;
  }
  EXPECT_NEAR(sigmas[5], 2.5, 1e-9);
  EXPECT_NEAR(sigmas[6], 3.0, 1e-9);
  EXPECT_NEAR(sigmas[12], 4.0, 1e-9);
}

TEST(ContourResampleFilter, TakesWhatTheNearerPointOfASilhouetteKnows)
{
  ContourType::PolylineType line;
  line.points = { P(0, 0), P(10, 0) };
  const double normals[2][2] = { { 0.0, -1.0 }, { 0.6, -0.8 } };
  const double rims[2][3] = { { 1, 2, 3 }, { 40, 50, 60 } };
  for (unsigned int i = 0; i < 2; ++i)
  {
    line.normals.emplace_back(normals[i]);
    line.rimPoints.emplace_back(rims[i]);
    line.teeth.emplace_back(11 + i);
  }
  const auto contour = ContourType::New();
  contour->AddPolyline(line);
  const auto filter = FilterType::New();
  filter->SetInput(contour);
  filter->SetNumberOfPoints(6);
  filter->Update();
  const auto resampled = filter->GetOutput()->GetPolylines()[0];
  ASSERT_EQ(resampled.points.size(), 6u);
  for (unsigned int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(resampled.rimPoints[i], line.rimPoints[i < 3 ? 0 : 1]) << i;
    EXPECT_EQ(resampled.normals[i], line.normals[i < 3 ? 0 : 1]) << i;
    EXPECT_EQ(resampled.teeth[i], line.teeth[i < 3 ? 0 : 1]) << i;
  }
}

TEST(ContourResampleFilter, SaysWhatIsMissing)
{
  const auto filter = FilterType::New();
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetInput(MakeSquare());
  filter->SetNumberOfPoints(2);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetNumberOfPoints(0);
  filter->SetSpacing(0.0);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetInput(ContourType::New());
  filter->SetSpacing(1.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0u);
}

TEST(ContourResampling, SharesOutAllPointsByLength)
{
  const std::vector<double> lengths{ 100.0, 1.0, 50.0, 33.3, 0.0 };
  for (std::size_t total = 9; total < 300; ++total)
  {
    const auto counts = itk::DistributeContourPoints(lengths, { 2, 2, 2, 2, 1 }, total);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{ 0 }), total);
    EXPECT_EQ(counts[4], 1u);
    EXPECT_GE(counts[1], 2u);
    EXPECT_GE(counts[0], counts[2]);
  }
  EXPECT_THROW(itk::DistributeContourPoints(lengths, { 2, 2, 2, 2, 1 }, 8), std::invalid_argument);
}
