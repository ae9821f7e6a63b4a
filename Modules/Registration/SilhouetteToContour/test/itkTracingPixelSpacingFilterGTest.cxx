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
#include "itkTracingPixelSpacingFilter.h"

#include <gtest/gtest.h>

#include <string>

namespace
{
using FilterType = itk::TracingPixelSpacingFilter;
using GeometryType = FilterType::GeometryType;
using MeshType = FilterType::MeshType;
using ContourType = FilterType::ContourType;
using JawEnum = FilterType::JawEnum;

/** Two points on the midline plane, so many mm apart. */
MeshType::Pointer
MakeMesh(double length)
{
  auto mesh = MeshType::New();
  for (unsigned int i = 0; i < 2; ++i)
  {
    MeshType::PointType point;
    point.Fill(0.0F);
    point[0] = static_cast<float>((i == 0 ? -0.5 : 0.5) * length);
    mesh->SetPoint(i, point);
  }
  return mesh;
}

ContourType::Pointer
MakeContour(double width)
{
  std::vector<ContourType::PointType> points(2);
  points[0][0] = 300.0;
  points[1][0] = 300.0 + width;
  points[0][1] = points[1][1] = 200.0;
  auto contour = ContourType::New();
  contour->AddPolyline(points);
  return contour;
}

FilterType::FrameType::Pointer
MakeFrame()
{
  auto frame = FilterType::FrameType::New();
  frame->Set(itk::VersorRigid3DTransform<double>::New());
  return frame;
}

GeometryType::Pointer
MakeGeometry()
{
  auto geometry = GeometryType::New();
  geometry->SetSourceToMidsagittalDistance(1000.0);
  geometry->SetSourceToDetectorDistance(1200.0);
  return geometry;
}

double
SpacingOf(FilterType * filter)
{
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPixelSpacing()[0], filter->GetOutput()->GetPixelSpacing()[1]);
  return filter->GetOutput()->GetPixelSpacing()[0];
}
} // namespace

TEST(TracingPixelSpacingFilter, IsTheMagnifiedLengthOverTheTracingsWidth)
{
  auto filter = FilterType::New();
  filter->SetGeometry(MakeGeometry());
  filter->SetJaw(JawEnum::Upper, MakeMesh(50.0), MakeContour(240.0), MakeFrame());
  // 50 mm, 1.2 times magnified, on 240 pixels.
  EXPECT_NEAR(SpacingOf(filter), 0.25, 1e-9);
  EXPECT_EQ(filter->GetOutput()->GetSourceToDetectorDistance(), 1200.0);
  filter->SetJaw(JawEnum::Lower, MakeMesh(50.0), MakeContour(480.0), MakeFrame());
  EXPECT_NEAR(SpacingOf(filter), 0.5 * (0.25 + 0.125), 1e-9) << "one image: the mean of the jaws";
}

TEST(TracingPixelSpacingFilter, LeavesOutWhatIsIncomplete)
{
  auto filter = FilterType::New();
  filter->SetGeometry(MakeGeometry());
  filter->SetDefaultPixelSpacing(0.4);
  EXPECT_EQ(SpacingOf(filter), 0.4) << "nothing to measure";
  filter->SetJaw(JawEnum::Lower, MakeMesh(50.0), MakeContour(240.0), FilterType::FrameType::New());
  EXPECT_EQ(SpacingOf(filter), 0.4) << "no arch was found";
  filter->SetJaw(JawEnum::Lower, MakeMesh(50.0), MakeContour(0.0), MakeFrame());
  EXPECT_EQ(SpacingOf(filter), 0.4) << "a tracing without width";
  filter->SetJaw(JawEnum::Lower, MakeMesh(50.0), MakeContour(240.0), MakeFrame());
  EXPECT_NEAR(SpacingOf(filter), 0.25, 1e-9) << "the other jaw does not count";
}

TEST(TracingPixelSpacingFilter, SaysWhatIsMissing)
{
  auto filter = FilterType::New();
  try
  {
    filter->Update();
    FAIL();
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("SetGeometry()"), std::string::npos);
  }
  filter->SetGeometry(MakeGeometry());
  filter->SetDefaultPixelSpacing(0.0);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}
