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
#include "itkSurfaceParts.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace
{
using PointType = itk::TriangleSurface::PointType;

/** A square of two triangles in a plane of constant z, as STL writes it: no point is shared. */
void
AddSquare(itk::TriangleSurface & surface, const PointType & corner, double side, bool up)
{
  const PointType a = corner;
  const PointType b{ corner[0] + side, corner[1], corner[2] };
  const PointType c{ corner[0] + side, corner[1] + side, corner[2] };
  const PointType d{ corner[0], corner[1] + side, corner[2] };
  for (const auto & triangle : { std::array<PointType, 3>{ a, b, c }, std::array<PointType, 3>{ a, c, d } })
  {
    const auto first = static_cast<std::uint32_t>(surface.points.size());
    surface.points.insert(surface.points.end(), triangle.begin(), triangle.end());
    surface.triangles.push_back(up ? std::array<std::uint32_t, 3>{ first, first + 1, first + 2 }
                                   : std::array<std::uint32_t, 3>{ first, first + 2, first + 1 });
  }
}
} // namespace

TEST(SurfaceParts, JoinsTrianglesWhosePointsLieAtTheSamePlace)
{
  itk::TriangleSurface surface;
  AddSquare(surface, { 0.0, 0.0, 0.0 }, 2.0, true);
  AddSquare(surface, { 0.0, 0.0, 5.0 }, 3.0, false);
  const itk::SurfaceParts parts(surface);
  ASSERT_EQ(parts.GetParts().size(), 2u);
  EXPECT_EQ(parts.GetPartOfTriangle(), (std::vector<std::uint32_t>{ 0, 0, 1, 1 }));
  EXPECT_DOUBLE_EQ(parts.GetParts()[0].area, 4.0);
  EXPECT_DOUBLE_EQ(parts.GetParts()[1].area, 9.0);
  EXPECT_DOUBLE_EQ(parts.GetArea(), 13.0);
  EXPECT_DOUBLE_EQ(parts.GetParts()[0].normal[2], 4.0);
  EXPECT_DOUBLE_EQ(parts.GetParts()[1].normal[2], -9.0);
  EXPECT_EQ(parts.GetWeldedPoints()[3], 0u);
  EXPECT_EQ(itk::SurfaceParts::Weld(surface), parts.GetWeldedPoints());
}

/** A speck and a point that no triangle has are far away and are not the scan; neither is a triangle without area. */
TEST(SurfaceParts, ExtentLeavesOutSpecksAndPointsThatNobodyHas)
{
  itk::TriangleSurface surface;
  AddSquare(surface, { 1.0, 2.0, 0.0 }, 10.0, true);
  const auto extent = [&](const PointType & direction) {
    return itk::SurfaceParts(surface).ComputeExtent(surface, direction);
  };
  const auto clean = extent({ 1.0, 0.0, 0.0 });
  EXPECT_EQ(clean, std::make_pair(1.0, 11.0));
  surface.points.push_back({ 1e6, 0.0, 0.0 });
  AddSquare(surface, { 300.0, 0.0, 0.0 }, 1.0, true);
  const auto last = static_cast<std::uint32_t>(surface.points.size() - 1);
  surface.triangles.push_back({ last, last, last });
  EXPECT_EQ(extent({ 1.0, 0.0, 0.0 }), clean);
  const itk::SurfaceParts parts(surface);
  EXPECT_FALSE(parts.IsKept(2));
  EXPECT_EQ(parts.GetPartOfTriangle().back(), itk::SurfaceParts::NoPart);
  // 1.5 % of the area is the limit: 1 of 101 mm^2 is a speck, 4 of 104 are a part.
  AddSquare(surface, { 200.0, 0.0, 0.0 }, 2.0, true);
  EXPECT_EQ(extent({ 1.0, 0.0, 0.0 }), std::make_pair(1.0, 202.0));
}

TEST(SurfaceParts, OfNothingAreNone)
{
  const itk::TriangleSurface empty;
  const itk::SurfaceParts    parts(empty);
  EXPECT_TRUE(parts.GetParts().empty());
  EXPECT_EQ(parts.ComputeExtent(empty, { 1.0, 0.0, 0.0 }), std::make_pair(0.0, 0.0));
}
