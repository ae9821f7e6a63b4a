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
#include "itkContourTransformFilter.h"
#include "itkMessageOfCall.h"

#include "itkSimilarity2DTransform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
using FilterType = itk::ContourTransformFilter;
using ContourType = itk::DentalContour;
using TransformType = itk::Similarity2DTransform<double>;

ContourType::PointType
MakePoint(double u, double v)
{
  ContourType::PointType point;
  point[0] = u;
  point[1] = v;
  return point;
}

ContourType::Pointer
MakeContour()
{
  auto                      contour = ContourType::New();
  ContourType::PolylineType open;
  open.points = { MakePoint(1.0, 0.0), MakePoint(2.0, 0.0), MakePoint(2.0, 3.0) };
  open.weights = { 1.0, 0.5, 0.0 };
  open.code = itk::ToothCode(16);
  contour->AddPolyline(open);
  ContourType::PolylineType closed;
  closed.points = { MakePoint(0.0, 0.0), MakePoint(4.0, 0.0), MakePoint(0.0, 4.0) };
  closed.closed = true;
  contour->AddPolyline(closed);
  return contour;
}

/** Twice as large, a quarter turn from u to v, and 10 px along u. */
TransformType::Pointer
MakeTransform()
{
  auto                          transform = TransformType::New();
  TransformType::ParametersType parameters(4);
  parameters[0] = 2.0;
  parameters[1] = std::asin(1.0);
  parameters[2] = 10.0;
  parameters[3] = 0.0;
  transform->SetParameters(parameters);
  return transform;
}
} // namespace

TEST(ContourTransformFilter, MovesThePointsAndKeepsTheRest)
{
  auto filter = FilterType::New();
  filter->SetInput(MakeContour());
  filter->SetTransform(MakeTransform());
  filter->Update();
  const auto before = filter->GetInput()->GetPolylines();
  const auto after = filter->GetOutput()->GetPolylines();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t l = 0; l < after.size(); ++l)
  {
    EXPECT_EQ(after[l].closed, before[l].closed);
    EXPECT_EQ(after[l].code, before[l].code);
    EXPECT_EQ(after[l].weights, before[l].weights);
    ASSERT_EQ(after[l].points.size(), before[l].points.size());
    for (std::size_t i = 0; i < after[l].points.size(); ++i)
    {
      EXPECT_NEAR(after[l].points[i][0], 10.0 - 2.0 * before[l].points[i][1], 1e-12);
      EXPECT_NEAR(after[l].points[i][1], 2.0 * before[l].points[i][0], 1e-12);
    }
  }
}

TEST(ContourTransformFilter, RunsOnceAndAgainWhenTheTransformChanges)
{
  auto transform = MakeTransform();
  auto filter = FilterType::New();
  filter->SetInput(MakeContour());
  filter->SetTransform(transform);
  unsigned int executions = 0;
  filter->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++executions; });
  filter->Update();
  filter->Update();
  EXPECT_EQ(executions, 1U);
  // (SetScale() of Similarity2DTransform does not call Modified() in ITK 5.2.)
  auto parameters = transform->GetParameters();
  parameters[0] = 3.0;
  transform->SetParameters(parameters);
  filter->Update();
  EXPECT_EQ(executions, 2U);
}

TEST(ContourTransformFilter, SaysWhatIsMissing)
{
  const auto message = [](FilterType * filter) { return itk::MessageOfCall([&] { filter->Update(); }); };
  auto       filter = FilterType::New();
  EXPECT_NE(message(filter).find("SetInput()"), std::string::npos);
  filter->SetInput(MakeContour());
  EXPECT_NE(message(filter).find("SetTransform()"), std::string::npos);
}

TEST(ContourTransformFilter, TurnsNormalsAndLeavesRimPointsOnTheSurface)
{
  ContourType::PolylineType line;
  line.points = { MakePoint(1.0, 0.0), MakePoint(2.0, 0.0) };
  const double normal[2] = { 0.6, -0.8 };
  const double none[2] = { 0.0, 0.0 };
  const double rims[2][3] = { { 1, 2, 3 }, { 4, 5, 6 } };
  line.normals = { ContourType::NormalType(normal), ContourType::NormalType(none) };
  line.rimPoints = { ContourType::RimPointType(rims[0]), ContourType::RimPointType(rims[1]) };
  line.teeth = { itk::ToothCode(11), itk::ToothCode(12) };
  auto contour = ContourType::New();
  contour->AddPolyline(line);
  auto filter = FilterType::New();
  filter->SetInput(contour);
  filter->SetTransform(MakeTransform());
  filter->Update();
  const auto moved = filter->GetOutput()->GetPolylines()[0];
  ASSERT_EQ(moved.normals.size(), 2u);
  // A quarter turn from u to v, of unit length whatever the scale.
  EXPECT_NEAR(moved.normals[0][0], 0.8, 1e-12);
  EXPECT_NEAR(moved.normals[0][1], 0.6, 1e-12);
  EXPECT_EQ(moved.normals[1], line.normals[1]) << "unknown stays unknown";
  EXPECT_EQ(moved.rimPoints, line.rimPoints);
  EXPECT_EQ(moved.teeth, line.teeth);
}
