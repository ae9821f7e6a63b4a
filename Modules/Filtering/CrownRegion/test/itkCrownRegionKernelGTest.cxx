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
#include "itkCrownRegionKernel.h"
#include "itkCrownRegionTestSupport.h"
#include "itkDentalFrameEstimator.h"
#include "itkReadDentalMesh.h"
#include "itkMakeTriangleSurface.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace
{
using CrownRegionTest::Case;
using CrownRegionTest::Find;
using CrownRegionTest::IoU;
using CrownRegionTest::Kind;
using CrownRegionTest::MakeCase;
using Axes = std::array<std::array<double, 3>, 3>;

const Axes Identity = { { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };

class CrownRegionOfPhantoms : public ::testing::TestWithParam<Kind>
{};

TEST_P(CrownRegionOfPhantoms, OverlapsTheLabelledCrownsByFiveSixths)
{
  // 0.85 is the figure; seeds of the study, not of its held-out part.
  for (std::uint64_t seed = 101; seed <= 103; ++seed)
  {
    const Case phantom = MakeCase(seed, GetParam(), 12000);
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      const auto found = Find(phantom, jaw);
      ASSERT_TRUE(found.valid);
      EXPECT_GE(IoU(phantom, jaw, found), 0.85) << "seed " << seed << " jaw " << jaw;
      EXPECT_GT(found.marginAngle, 0.2);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Kinds,
                         CrownRegionOfPhantoms,
                         ::testing::Values(Kind::Regular, Kind::Stone, Kind::Irregular, Kind::Wide));

// Documentation/CrownRegion.md has more of them, by CrownRegionStudy; fewer here for time.
TEST(CrownRegionKernel, OverlapsTheCrownsOfPhantomsThatItWasNotMadeOn)
{
  for (const Kind kind : { Kind::Regular, Kind::Stone, Kind::Irregular })
  {
    for (std::uint64_t seed = 9001; seed < 9005; ++seed)
    {
      const Case phantom = MakeCase(seed, kind, 15000);
      for (unsigned int jaw = 0; jaw < 2; ++jaw)
      {
        EXPECT_GE(IoU(phantom, jaw, Find(phantom, jaw)), 0.85)
          << "seed " << seed << " jaw " << jaw << " kind " << static_cast<int>(kind);
      }
    }
  }
}

TEST(CrownRegionKernel, IsNotDrawnDownByThePalateBehindTheTeeth)
{
  // Shallow palates and long distal ends fill a third of all directions with tops that are none.
  for (const std::uint64_t seed : { 2, 9, 33 })
  {
    const Case phantom = MakeCase(seed, Kind::Wide, 0);
    EXPECT_GE(IoU(phantom, 0, Find(phantom, 0)), 0.85) << "seed " << seed;
  }
}

TEST(CrownRegionKernel, DoesNotDependOnTheMeshFrame)
{
  const Case phantom = MakeCase(104, Kind::Regular, 12000);
  const auto here = Find(phantom, 0);
  // A rotation by a cyclic exchange of axes and a shift: rounding only.
  itk::TriangleSurface moved = phantom.jaws[0].surface;
  for (auto & p : moved.points)
  {
    p = { { p[1] + 100.0, p[2] - 50.0, p[0] + 7.0 } };
  }
  const auto & frame = phantom.frame.upper;
  Axes         axes = frame.axes;
  for (auto & row : axes)
  {
    row = { { row[1], row[2], row[0] } };
  }
  const auto there =
    itk::ComputeCrownRegion(moved,
                            itk::ToothCode::JawEnum::Upper,
                            axes,
                            { { frame.origin[1] + 100.0, frame.origin[2] - 50.0, frame.origin[0] + 7.0 } });
  const auto overlap = CrownRegionTest::Compare(moved, here.triangles, there.triangles);
  // Single vertices at the margin may change sides by rounding.
  EXPECT_GT(overlap.IoU(), 0.999);
}

TEST(CrownRegionKernel, ToleratesInwardWindingAndDoubledPoints)
{
  const Case           phantom = MakeCase(105, Kind::Regular, 12000);
  const auto           here = Find(phantom, 1);
  itk::TriangleSurface soup;
  for (const auto & triangle : phantom.jaws[1].surface.triangles)
  {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t id : { triangle[0], triangle[2], triangle[1] })
    {
      soup.points.push_back(phantom.jaws[1].surface.points[id]);
    }
    soup.triangles.push_back({ { first, first + 1, first + 2 } });
  }
  const auto & frame = phantom.frame.lower;
  const auto   there = itk::ComputeCrownRegion(soup, itk::ToothCode::JawEnum::Lower, frame.axes, frame.origin);
  // Area counts are summed in another order, so a threshold may fall otherwise at single triangles.
  EXPECT_GT(CrownRegionTest::Compare(soup, here.triangles, there.triangles).IoU(), 0.99);
}

TEST(CrownRegionKernel, GivesTheSameBitsAgain)
{
  const Case phantom = MakeCase(106, Kind::Stone, 12000);
  EXPECT_EQ(Find(phantom, 0).triangles, Find(phantom, 0).triangles);
}

TEST(CrownRegionKernel, FindsNothingWhereThereIsNoArch)
{
  itk::TriangleSurface flat;
  for (unsigned int i = 0; i < 3; ++i)
  {
    flat.points.push_back({ { i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0, 0.0 } });
  }
  flat.triangles.push_back({ { 0, 1, 2 } });
  const auto found = itk::ComputeCrownRegion(flat, itk::ToothCode::JawEnum::Upper, Identity, { { 0, 0, 0 } });
  EXPECT_FALSE(found.valid);
  EXPECT_EQ(found.points, std::vector<std::uint8_t>(3, 0));
  EXPECT_EQ(found.triangles, std::vector<std::uint8_t>(1, 0));
  EXPECT_FALSE(itk::ComputeCrownRegion({}, itk::ToothCode::JawEnum::Upper, Identity, { { 0, 0, 0 } }).valid);
}

TEST(CrownRegionKernel, StopsWhenAborted)
{
  const Case              phantom = MakeCase(101, Kind::Regular, 12000);
  itk::CrownRegionOptions options;
  options.abort = []() { return true; };
  const auto & frame = phantom.frame.upper;
  EXPECT_FALSE(
    itk::ComputeCrownRegion(phantom.jaws[0].surface, itk::ToothCode::JawEnum::Upper, frame.axes, frame.origin, options)
      .valid);
}

TEST(CrownRegionKernel, TakesTrianglesWithTwoLabelledCorners)
{
  itk::TriangleSurface surface;
  surface.points = { { { 0, 0, 0 } }, { { 2, 0, 0 } }, { { 0, 2, 0 } }, { { 2, 2, 0 } } };
  surface.triangles = { { { 0, 1, 2 } }, { { 1, 3, 2 } } };
  const auto found = itk::CrownRegionFromLabels(surface, { 11, 12, 0, 0 });
  EXPECT_EQ(found.triangles, (std::vector<std::uint8_t>{ 1, 0 }));
  EXPECT_EQ(found.points, (std::vector<std::uint8_t>{ 1, 1, 0, 0 }));
  EXPECT_DOUBLE_EQ(found.area, 2.0);
  EXPECT_THROW(itk::CrownRegionFromLabels(surface, { 11 }), std::invalid_argument);
}

TEST(CrownRegionKernel, LeavesTheBaseOfScannedCastsOut)
{
  const std::string                   folder = std::string(DENTALSCR_SHARED_DIR) + "/cases/casts/";
  std::array<itk::TriangleSurface, 2> jaws;
  if (!std::ifstream(folder + "upper.obj") || !std::ifstream(folder + "lower.obj"))
  {
    GTEST_SKIP() << "The scanned casts are not there: " << folder;
  }
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    const auto mesh = itk::ReadDentalMesh<itk::Mesh<double, 3>>(folder + (jaw == 0 ? "upper.obj" : "lower.obj"));
    jaws[jaw] = itk::MakeTriangleSurface(mesh.GetPointer());
    for (auto & p : jaws[jaw].points)
    {
      p = { { 1e3 * p[0], 1e3 * p[1], 1e3 * p[2] } };
    }
  }
  itk::DentalFrameOptions options;
  options.refineMidline = true;
  const auto frames = itk::EstimateDentalFrame(&jaws[0], &jaws[1], options);
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    const auto & frame = jaw == 0 ? frames.upper : frames.lower;
    const auto   found = itk::ComputeCrownRegion(
      jaws[jaw], jaw == 0 ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower, frame.axes, frame.origin);
    ASSERT_TRUE(found.valid);
    // 14 teeth have 1700 to 2700 mm^2 of visible crown on the phantoms.
    EXPECT_GT(found.area, 1500.0);
    EXPECT_LT(found.area, 2500.0);
    double lowest = 1e9;
    double highest = -1e9;
    double lowestCrown = 1e9;
    for (std::size_t i = 0; i < found.points.size(); ++i)
    {
      double height = 0.0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        height += (jaw == 0 ? -1.0 : 1.0) * frame.axes[2][d] * (jaws[jaw].points[i][d] - frame.origin[d]);
      }
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
      if (found.points[i] != 0)
      {
        lowestCrown = std::min(lowestCrown, height);
      }
    }
    // The base is the lower half at least; crowns and curve of Spee take less than 16 mm from the top.
    EXPECT_GT(lowestCrown, 0.5 * (lowest + highest)) << "jaw " << jaw;
    EXPECT_GT(lowestCrown, highest - 16.0) << "jaw " << jaw;
  }
}
} // namespace
