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
#include "itkSceneDetector.h"

#include "itkCephalometricGeometry.h"

#include "gtest/gtest.h"

#include <stdexcept>

namespace
{
using GeometryType = itk::CephalometricGeometry;

GeometryType::Pointer
MakeGeometry(GeometryType::SourceSideEnum side, GeometryType::FacingEnum facing)
{
  auto geometry = GeometryType::New();
  geometry->SetSourceSide(side);
  geometry->SetFacing(facing);
  GeometryType::PixelSpacingType spacing;
  spacing[0] = 0.24;
  spacing[1] = 0.26;
  geometry->SetPixelSpacing(spacing);
  GeometryType::PixelIndexType principal;
  principal[0] = 180.5;
  principal[1] = 407.25;
  geometry->SetPrincipalPoint(principal);
  return geometry;
}

itk::SceneDetector::PointType
MakePoint(double x, double y, double z)
{
  itk::SceneDetector::PointType point;
  point[0] = x;
  point[1] = y;
  point[2] = z;
  return point;
}
} // namespace

TEST(SceneDetector, IsWhereTheGeometryOfEverySideAndFacingPutsSourceAndPixels)
{
  for (const auto side : { GeometryType::SourceSideEnum::Right, GeometryType::SourceSideEnum::Left })
  {
    for (const auto facing : { GeometryType::FacingEnum::Right, GeometryType::FacingEnum::Left })
    {
      const auto               geometry = MakeGeometry(side, facing);
      const itk::SceneDetector detector(geometry->GetProjection().matrix, geometry->GetSourceToDetectorDistance());
      const auto               source = geometry->GetSourcePosition();
      const auto               central = detector.GetCentralPoint();
      for (unsigned int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(detector.GetSource()[d], source[d], 1e-9);
      }
      // The detector is behind the midsagittal plane, seen from the source, and the central ray is the y axis.
      EXPECT_NEAR(central[0], 0.0, 1e-9);
      EXPECT_NEAR(central[1], geometry->GetSourceSign() * 150.0, 1e-9);
      EXPECT_NEAR(central[2], 0.0, 1e-9);
      EXPECT_NEAR(detector.GetCentralPixel()[0], 180.5, 1e-9);
      EXPECT_NEAR(detector.GetCentralPixel()[1], 407.25, 1e-9);
      const auto point = MakePoint(63.0, -21.0, -44.0);
      const auto pixel = geometry->ProjectPoint(point);
      EXPECT_NEAR(detector.GetPixel(point)[0], pixel[0], 1e-9);
      EXPECT_NEAR(detector.GetPixel(point)[1], pixel[1], 1e-9);
      // Source, point and pixel are on one line.
      const auto onDetector = detector.GetPoint(pixel[0], pixel[1]);
      EXPECT_NEAR(onDetector[1], geometry->GetSourceSign() * 150.0, 1e-9);
      const auto cross = itk::CrossProduct(onDetector - detector.GetSource(), point - detector.GetSource());
      EXPECT_NEAR(cross.GetNorm() / 1674.0, 0.0, 1e-9);
    }
  }
}

TEST(SceneDetector, TakesAFrontalProjectionAsItIs)
{
  // depth = S + x with the source behind the patient: Documentation/Scene.md.
  constexpr double             spacing = 0.25;
  constexpr double             distance = 1674.0;
  constexpr double             toCoronal = 1524.0;
  const std::array<double, 12> projection{ { 200.0,
                                             distance / spacing,
                                             0.0,
                                             200.0 * toCoronal,
                                             300.0,
                                             0.0,
                                             -distance / spacing,
                                             300.0 * toCoronal,
                                             1.0,
                                             0.0,
                                             0.0,
                                             toCoronal } };
  const itk::SceneDetector     detector(projection, distance);
  const auto                   corner = detector.GetPoint(200.0 + 40.0, 300.0 - 80.0);
  EXPECT_NEAR(detector.GetSource()[0], -toCoronal, 1e-9);
  EXPECT_NEAR(detector.GetSource()[1], 0.0, 1e-9);
  EXPECT_NEAR(corner[0], distance - toCoronal, 1e-9);
  EXPECT_NEAR(corner[1], 40.0 * spacing, 1e-9);
  EXPECT_NEAR(corner[2], 80.0 * spacing, 1e-9);
}

TEST(SceneDetector, DoesNotMindTheSignAndSizeOfAHomogeneousMatrix)
{
  const auto geometry = MakeGeometry(GeometryType::SourceSideEnum::Left, GeometryType::FacingEnum::Right);
  const auto matrix = geometry->GetProjection().matrix;
  auto       other = matrix;
  for (double & element : other)
  {
    element *= -37.0;
  }
  const itk::SceneDetector one(matrix, 1674.0);
  const itk::SceneDetector two(other, 1674.0);
  for (unsigned int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(one.GetPoint(3.0, 700.0)[d], two.GetPoint(3.0, 700.0)[d], 1e-9);
    EXPECT_NEAR(one.GetAxis()[d], two.GetAxis()[d], 1e-12);
  }
}

TEST(SceneDetector, RefusesWhatIsNoProjection)
{
  const auto matrix =
    MakeGeometry(GeometryType::SourceSideEnum::Left, GeometryType::FacingEnum::Right)->GetProjection().matrix;
  EXPECT_THROW(itk::SceneDetector(matrix, 0.0), std::invalid_argument);
  EXPECT_THROW(itk::SceneDetector(matrix, -1.0), std::invalid_argument);
  EXPECT_THROW(itk::SceneDetector(std::array<double, 12>{}, 1674.0), std::invalid_argument);
  // A parallel projection has no source.
  const std::array<double, 12> parallel{ { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1 } };
  EXPECT_THROW(itk::SceneDetector(parallel, 1674.0), std::invalid_argument);
}
