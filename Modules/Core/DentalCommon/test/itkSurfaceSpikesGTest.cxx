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
#include "itkSurfaceSpikes.h"

#include "itkSurfaceParts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using SurfaceType = itk::TriangleSurface;

/** A dome over 41 x 41 points, 0.5 mm apart. */
SurfaceType
MakeDome()
{
  constexpr std::uint32_t side = 41;
  SurfaceType             surface;
  for (std::uint32_t v = 0; v < side; ++v)
  {
    for (std::uint32_t u = 0; u < side; ++u)
    {
      const double x = 0.5 * u - 10.0;
      const double y = 0.5 * v - 10.0;
      surface.points.push_back({ { x, y, 5.0 - 0.02 * (x * x + y * y) } });
    }
  }
  for (std::uint32_t v = 0; v + 1 < side; ++v)
  {
    for (std::uint32_t u = 0; u + 1 < side; ++u)
    {
      const std::uint32_t i = v * side + u;
      surface.triangles.push_back({ { i, i + 1, i + side + 1 } });
      surface.triangles.push_back({ { i, i + side + 1, i + side } });
    }
  }
  return surface;
}

/** As STL has it: each triangle with points of its own. */
SurfaceType
MakeSoup(const SurfaceType & surface)
{
  SurfaceType soup;
  for (const auto & triangle : surface.triangles)
  {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t corner : triangle)
    {
      soup.points.push_back(surface.points[corner]);
    }
    soup.triangles.push_back({ { first, first + 1, first + 2 } });
  }
  return soup;
}

std::vector<itk::SurfaceSpike>
Find(const SurfaceType & surface)
{
  return itk::FindSurfaceSpikes(surface, itk::SurfaceParts::Weld(surface), 5.0);
}
} // namespace

TEST(SurfaceSpikes, AreNoneOfAScanAsItIs)
{
  EXPECT_TRUE(Find(MakeDome()).empty());
  EXPECT_TRUE(Find(MakeSoup(MakeDome())).empty());
  EXPECT_TRUE(Find(SurfaceType()).empty());
}

TEST(SurfaceSpikes, AreOnePointThatIsElsewhere)
{
  SurfaceType surface = MakeDome();
  surface.points[20 * 41 + 20][2] += 30.0;
  const auto spikes = Find(surface);
  ASSERT_EQ(spikes.size(), 1u);
  EXPECT_EQ(spikes[0].point, 20u * 41u + 20u);
  EXPECT_NEAR(spikes[0].length, 30.0, 0.05);
  // In all triangles of a file without indices, at the edge and in a corner.
  EXPECT_EQ(Find(MakeSoup(surface)).size(), 1u);
  for (const std::uint32_t point : { 20u, 0u })
  {
    SurfaceType edge = MakeDome();
    edge.points[point][0] -= 20.0;
    EXPECT_EQ(Find(edge).size(), 1u) << point;
  }
}

TEST(SurfaceSpikes, AreOneCornerOfOneTriangle)
{
  SurfaceType soup = MakeSoup(MakeDome());
  soup.points[3 * 1000 + 1][1] = -soup.points[3 * 1000 + 1][1] + 40.0;
  ASSERT_EQ(Find(soup).size(), 1u);
  EXPECT_EQ(Find(soup)[0].point, 3u * 1000u + 1u);
}

TEST(SurfaceSpikes, BeginAtTheLengthThatIsGiven)
{
  SurfaceType surface = MakeDome();
  surface.points[20 * 41 + 20][2] += 10.0;
  const auto welded = itk::SurfaceParts::Weld(surface);
  EXPECT_EQ(itk::FindSurfaceSpikes(surface, welded, 9.9).size(), 1u);
  EXPECT_TRUE(itk::FindSurfaceSpikes(surface, welded, 10.2).empty());
}

TEST(SurfaceSpikes, AreNoWallsOfABaseNoFansAndNoCoarseTriangles)
{
  // A cone whose apex is connected with a ring half as wide as it is high, or as wide: a hole that was closed.
  for (const double radius : { 5.0, 10.0 })
  {
    SurfaceType fan;
    fan.points.push_back({ { 0.0, 0.0, 20.0 } });
    constexpr std::uint32_t count = 60;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const double angle = 2.0 * 3.14159265358979 * i / count;
      fan.points.push_back({ { radius * std::cos(angle), radius * std::sin(angle), 0.0 } });
      fan.triangles.push_back({ { 0, 1 + i, 1 + (i + 1) % count } });
    }
    EXPECT_TRUE(Find(fan).empty()) << radius;
  }
  // A wall of 15 mm with corners every 0.3 mm.
  SurfaceType wall;
  for (std::uint32_t i = 0; i < 100; ++i)
  {
    wall.points.push_back({ { 0.3 * i, 0.0, 0.0 } });
    wall.points.push_back({ { 0.3 * i, 0.0, 15.0 } });
  }
  for (std::uint32_t i = 0; i + 3 < 200; i += 2)
  {
    wall.triangles.push_back({ { i, i + 1, i + 2 } });
    wall.triangles.push_back({ { i + 1, i + 3, i + 2 } });
  }
  EXPECT_TRUE(Find(wall).empty());
  // A tetrahedron of 30 mm.
  SurfaceType coarse;
  coarse.points = { { { 0.0, 0.0, 0.0 } }, { { 30.0, 0.0, 0.0 } }, { { 0.0, 30.0, 0.0 } }, { { 0.0, 0.0, 30.0 } } };
  coarse.triangles = { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 0, 3, 2 } }, { { 1, 2, 3 } } };
  EXPECT_TRUE(Find(coarse).empty());
}
