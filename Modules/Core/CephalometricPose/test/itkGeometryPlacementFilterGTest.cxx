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
#include "itkGeometryPlacementFilter.h"
#include "itkMessageOfCall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
using FilterType = itk::GeometryPlacementFilter;
using GeometryType = FilterType::GeometryType;
using TransformType = itk::VersorRigid3DTransform<double>;

GeometryType::Pointer
MakeGeometry()
{
  auto                           geometry = GeometryType::New();
  GeometryType::PixelIndexType   principal;
  GeometryType::PixelSpacingType spacing;
  principal[0] = 900.0;
  principal[1] = 700.0;
  spacing[0] = 0.125;
  spacing[1] = 0.25;
  geometry->SetPrincipalPoint(principal);
  geometry->SetPixelSpacing(spacing);
  geometry->SetFacing(GeometryType::FacingEnum::Left);
  return geometry;
}

FilterType::FrameType::Pointer
MakeFrame()
{
  auto                            transform = TransformType::New();
  TransformType::AxisType         axis;
  TransformType::OutputVectorType offset;
  axis[0] = 0.0;
  axis[1] = 0.0;
  axis[2] = 1.0;
  offset[0] = 5.0;
  offset[1] = -2.0;
  offset[2] = 3.0;
  transform->SetRotation(axis, std::asin(1.0));
  transform->SetOffset(offset);
  auto frame = FilterType::FrameType::New();
  frame->Set(transform);
  return frame;
}
} // namespace

TEST(GeometryPlacementFilter, ProjectsThroughTheFrameAsTheFormulaSays)
{
  auto filter = FilterType::New();
  filter->SetGeometry(MakeGeometry());
  filter->SetFrame(MakeFrame());
  filter->Update();
  // A quarter turn about z takes (10, 20, 30) to (-20, 10, 30), the offset to (-15, 8, 33).
  GeometryType::PointType point;
  point[0] = 10.0;
  point[1] = 20.0;
  point[2] = 30.0;
  const auto   pixel = filter->GetOutput()->ProjectPoint(point);
  const double m = 1674.0 / (1524.0 + 8.0);
  EXPECT_NEAR(pixel[0], 900.0 - m * -15.0 / 0.125, 1e-9);
  EXPECT_NEAR(pixel[1], 700.0 - m * 33.0 / 0.25, 1e-9);
}

TEST(GeometryPlacementFilter, ACentralRayThroughTheOriginIsRelativeToTheFrame)
{
  auto geometry = MakeGeometry();
  auto filter = FilterType::New();
  filter->SetGeometry(geometry);
  filter->SetFrame(MakeFrame());
  filter->CentralRayThroughOriginOn();
  filter->Update();
  // The mesh's point that the frame takes to its origin.
  const auto origin = filter->GetFrame()->Get()->GetInverseTransform()->TransformPoint(GeometryType::PointType());
  const auto pixel = filter->GetOutput()->ProjectPoint(origin);
  EXPECT_NEAR(pixel[0], 0.0, 1e-9);
  EXPECT_NEAR(pixel[1], 0.0, 1e-9);
  EXPECT_EQ(geometry->GetPrincipalPoint()[0], 900.0) << "the input is another's";
}

TEST(GeometryPlacementFilter, FollowsItsInputsAndRunsNotTwice)
{
  auto geometry = MakeGeometry();
  auto filter = FilterType::New();
  filter->SetGeometry(geometry);
  filter->SetFrame(MakeFrame());
  unsigned int executions = 0;
  filter->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++executions; });
  filter->Update();
  filter->Update();
  EXPECT_EQ(executions, 1U);
  geometry->SetSourceToDetectorDistance(1700.0);
  filter->Update();
  EXPECT_EQ(executions, 2U);
  EXPECT_EQ(filter->GetOutput()->GetSourceToDetectorDistance(), 1700.0);
}

TEST(GeometryPlacementFilter, SaysWhatIsMissing)
{
  const auto message = [](FilterType * filter) { return itk::MessageOfCall([&] { filter->Update(); }); };
  auto       filter = FilterType::New();
  EXPECT_NE(message(filter).find("SetGeometry()"), std::string::npos);
  filter->SetGeometry(MakeGeometry());
  EXPECT_NE(message(filter).find("SetFrame()"), std::string::npos);
  filter->SetFrame(FilterType::FrameType::New());
  EXPECT_NE(message(filter).find("empty"), std::string::npos);
}
