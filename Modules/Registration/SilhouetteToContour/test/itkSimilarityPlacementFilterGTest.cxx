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
#include "itkSimilarityPlacementFilter.h"
#include "itkMessageOfCall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
using FilterType = itk::SimilarityPlacementFilter;
using GeometryType = FilterType::GeometryType;
using SimilarityType = FilterType::SimilarityType;
using PointType = GeometryType::PointType;

GeometryType::Pointer
MakeGeometry(GeometryType::FacingEnum facing)
{
  auto                           geometry = GeometryType::New();
  GeometryType::PixelIndexType   principal;
  GeometryType::PixelSpacingType spacing;
  principal[0] = 900.0;
  principal[1] = 700.0;
  // Square pixels: a turn in pixels is one in the cephalostat only there.
  spacing.Fill(0.125);
  geometry->SetPrincipalPoint(principal);
  geometry->SetPixelSpacing(spacing);
  geometry->SetFacing(facing);
  return geometry;
}

FilterType::FrameType::Pointer
MakeFrame()
{
  auto                                             transform = FilterType::RigidTransformType::New();
  FilterType::RigidTransformType::AxisType         axis;
  FilterType::RigidTransformType::OutputVectorType offset;
  axis[0] = 0.6;
  axis[1] = 0.0;
  axis[2] = 0.8;
  offset[0] = 5.0;
  offset[1] = -2.0;
  offset[2] = 3.0;
  transform->SetRotation(axis, 0.3);
  transform->SetOffset(offset);
  auto frame = FilterType::FrameType::New();
  frame->Set(transform);
  return frame;
}

SimilarityType::Pointer
MakeSimilarity(double scale)
{
  auto                           similarity = SimilarityType::New();
  SimilarityType::ParametersType parameters(4);
  parameters[0] = scale;
  parameters[1] = 0.2;
  parameters[2] = 960.0;
  parameters[3] = 640.0;
  similarity->SetParameters(parameters);
  return similarity;
}

FilterType::Pointer
MakeFilter(GeometryType::FacingEnum facing, double scale)
{
  auto filter = FilterType::New();
  filter->SetGeometry(MakeGeometry(facing));
  filter->SetFrame(MakeFrame());
  filter->SetSimilarity(MakeSimilarity(scale));
  return filter;
}

/** Projection of the mesh's point in the frame, q = (f m x / sp, -m z / sp), moved by the similarity. */
std::array<double, 2>
Expected(const FilterType * filter, const PointType & point)
{
  const auto   c = filter->GetFrame()->Get()->TransformPoint(point);
  const double m = 1674.0 / (1524.0 + c[1]) / 0.125;
  const double f = filter->GetGeometry()->GetFacingSign();
  const double q[2] = { f * m * c[0], -m * c[2] };
  const auto & p = filter->GetSimilarity()->GetParameters();
  return { { p[0] * (std::cos(p[1]) * q[0] - std::sin(p[1]) * q[1]) + p[2],
             p[0] * (std::sin(p[1]) * q[0] + std::cos(p[1]) * q[1]) + p[3] } };
}

class SimilarityPlacementFilter : public ::testing::TestWithParam<GeometryType::FacingEnum>
{};
} // namespace

TEST_P(SimilarityPlacementFilter, TheMatrixIsSimilarityAfterProjection)
{
  auto filter = MakeFilter(GetParam(), 1.1);
  filter->SetMillimetresPerUnit(2.0);
  filter->Update();
  const auto & m = filter->GetProjectionMatrix();
  for (const double y : { -30.0, 0.0, 25.0 })
  {
    PointType point;
    point[0] = 12.0;
    point[1] = y;
    point[2] = -7.0;
    const auto expected = Expected(filter, point);
    double     sums[3];
    for (unsigned int row = 0; row < 3; ++row)
    {
      // The matrix takes the file's unit, here of 2 mm.
      sums[row] = 0.5 * (m(row, 0) * point[0] + m(row, 1) * point[1] + m(row, 2) * point[2]) + m(row, 3);
    }
    EXPECT_NEAR(sums[0] / sums[2], expected[0], 1e-9);
    EXPECT_NEAR(sums[1] / sums[2], expected[1], 1e-9);
  }
}

TEST_P(SimilarityPlacementFilter, ThePlaceProjectsPointsOfTheMidsagittalPlaneAsTheSimilarityDoes)
{
  auto filter = MakeFilter(GetParam(), 1.1);
  filter->Update();
  // The scale is a factor on the magnification: pixels that are so much smaller.
  auto placed = GeometryType::New();
  placed->CopyParameters(filter->GetGeometry());
  placed->SetPixelSpacing(filter->GetGeometry()->GetPixelSpacing() / 1.1);
  placed->SetPose(filter->GetTransform()->GetMatrix(), filter->GetTransform()->GetOffset());
  const auto toMesh = filter->GetFrame()->Get()->GetInverseTransform();
  for (const double x : { -20.0, 0.0, 30.0 })
  {
    PointType middle;
    middle[0] = x;
    middle[1] = 0.0;
    middle[2] = 0.5 * x + 3.0;
    const PointType point = toMesh->TransformPoint(middle);
    const auto      pixel = placed->ProjectPoint(point);
    const auto      expected = Expected(filter, point);
    EXPECT_NEAR(pixel[0], expected[0], 1e-8);
    EXPECT_NEAR(pixel[1], expected[1], 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(Facings,
                         SimilarityPlacementFilter,
                         ::testing::Values(GeometryType::FacingEnum::Right, GeometryType::FacingEnum::Left));

TEST(SimilarityPlacementFilter, RunsOnceAndAgainWhenTheGeometryChanges)
{
  auto         geometry = MakeGeometry(GeometryType::FacingEnum::Right);
  auto         filter = MakeFilter(GeometryType::FacingEnum::Right, 1.0);
  unsigned int executions = 0;
  filter->SetGeometry(geometry);
  filter->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++executions; });
  filter->Update();
  filter->Update();
  EXPECT_EQ(executions, 1U);
  const double before = filter->GetTransform()->GetOffset()[0];
  auto         principal = geometry->GetPrincipalPoint();
  principal[0] += 80.0;
  geometry->SetPrincipalPoint(principal);
  filter->Update();
  EXPECT_EQ(executions, 2U);
  // 80 pixels of 0.125 mm, on the midsagittal plane.
  EXPECT_NEAR(before - filter->GetTransform()->GetOffset()[0], 10.0 * 1524.0 / 1674.0, 1e-9);
}

TEST(SimilarityPlacementFilter, SaysWhatIsMissing)
{
  const auto message = [](FilterType * filter) { return itk::MessageOfCall([&] { filter->Update(); }); };
  auto       filter = FilterType::New();
  EXPECT_NE(message(filter).find("SetSimilarity()"), std::string::npos);
  filter->SetSimilarity(MakeSimilarity(-1.0));
  EXPECT_NE(message(filter).find("SetFrame()"), std::string::npos);
  filter->SetFrame(MakeFrame());
  EXPECT_NE(message(filter).find("SetGeometry()"), std::string::npos);
  filter->SetGeometry(GeometryType::New());
  EXPECT_NE(message(filter).find("must be positive"), std::string::npos);
  filter->SetSimilarity(MakeSimilarity(1.0));
  EXPECT_NE(message(filter).find("spacing"), std::string::npos);
}
