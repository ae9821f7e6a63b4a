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
#include "itkDentalPhantomTestCase.h"

#include "itkMakeTriangleSurface.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

using namespace DentalPhantomTestCase;

namespace
{
itk::TriangleSurface
Surface(CaseType * source, unsigned int jaw)
{
  return itk::MakeTriangleSurface<CaseType::MeshType>(source->GetMesh(jaw));
}

/** Sizes of the connected parts in triangles, largest first. */
std::vector<std::size_t>
Parts(const itk::TriangleSurface & surface)
{
  std::vector<std::size_t> parent(surface.points.size());
  std::iota(parent.begin(), parent.end(), std::size_t{ 0 });
  const auto root = [&parent](std::size_t i) {
    while (parent[i] != i)
    {
      i = parent[i] = parent[parent[i]];
    }
    return i;
  };
  for (const auto & t : surface.triangles)
  {
    parent[root(t[0])] = root(t[1]);
    parent[root(t[1])] = root(t[2]);
  }
  std::map<std::size_t, std::size_t> counts;
  for (const auto & t : surface.triangles)
  {
    ++counts[root(t[0])];
  }
  std::vector<std::size_t> sizes;
  for (const auto & count : counts)
  {
    sizes.push_back(count.second);
  }
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

/** Border loops and edges that more than two triangles (or two of the same direction) share. */
std::pair<std::size_t, std::size_t>
Borders(const itk::TriangleSurface & surface)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto & t : surface.triangles)
  {
    for (unsigned int k = 0; k < 3; ++k)
    {
      ++edges[{ t[k], t[(k + 1) % 3] }];
    }
  }
  std::size_t border = 0;
  std::size_t bad = 0;
  for (const auto & edge : edges)
  {
    border += edges.count({ edge.first.second, edge.first.first }) == 0;
    bad += edge.second > 1;
  }
  return { border, bad };
}

std::string
Scan(const std::string & fields)
{
  return "{\"scan\": {" + fields + "}}";
}
} // namespace

TEST(DentalPhantomScanDefects, DecimationReachesItsNumberAndKeepsLandmarksAndLabels)
{
  const auto source = Make(4, Scan("\"decimate_to\": 8000"), 30000);
  for (const unsigned int jaw : { 0u, 1u })
  {
    const auto surface = Surface(source, jaw);
    EXPECT_NEAR(static_cast<double>(surface.triangles.size()), 8000.0, 2.0);
    EXPECT_EQ(Teeth(source, jaw).size(), 14u);
    EXPECT_EQ(Borders(surface).second, 0u);
    for (const auto & landmark : source->GetLandmarks3D(jaw)->GetLandmarks())
    {
      double nearest = 1e9;
      for (const auto & p : surface.points)
      {
        nearest =
          std::min(nearest, std::hypot(p[0] - landmark.point[0], p[1] - landmark.point[1], p[2] - landmark.point[2]));
      }
      // Float coordinates.
      EXPECT_LT(nearest, 1e-4) << landmark.name;
    }
  }
}

TEST(DentalPhantomScanDefects, FlapsHangOnTheBorderCrumbsAndSpecksAreLoose)
{
  const auto plain = Make(5, "{}", 10000);
  const auto flapped = Make(5, Scan("\"flap_probability\": 1"), 10000);
  for (const unsigned int jaw : { 0u, 1u })
  {
    ASSERT_NE(Find(flapped, "flap"), nullptr);
    const auto surface = Surface(flapped, jaw);
    // One piece, still a manifold, larger by the flaps.
    EXPECT_EQ(Parts(surface).size(), 1u);
    EXPECT_EQ(Borders(surface).second, 0u);
    EXPECT_GT(surface.Area(), Surface(plain, jaw).Area() + 40.0);
  }
  const auto loose = Make(5, Scan("\"crumb_probability\": 1, \"mean_specks\": 6"), 10000);
  const auto crumbs = static_cast<std::size_t>(Find(loose, "crumb")->amount);
  const auto specks = Find(loose, "speck") == nullptr ? 0u : static_cast<std::size_t>(Find(loose, "speck")->amount);
  for (const unsigned int jaw : { 0u, 1u })
  {
    const auto parts = Parts(Surface(loose, jaw));
    ASSERT_EQ(parts.size(), 1 + crumbs + specks);
    // A speck is a few triangles, a crumb a patch.
    EXPECT_EQ(std::count_if(parts.begin() + 1, parts.end(), [](std::size_t n) { return n < 10; }), specks);
    // The jaw itself is as it was.
    EXPECT_EQ(parts[0], Surface(plain, jaw).triangles.size());
  }
}

TEST(DentalPhantomScanDefects, GingivaIsAsHighAsItsFactorSays)
{
  const auto plain = Make(6, "{}", 10000);
  const auto same = Make(6, Scan("\"gingiva_least\": 1, \"gingiva_most\": 1"), 10000);
  const auto trimmed = Make(6, Scan("\"gingiva_least\": 0.2, \"gingiva_most\": 0.2"), 10000);
  EXPECT_EQ(Find(plain, "gingiva"), nullptr);
  ASSERT_NE(Find(trimmed, "gingiva"), nullptr);
  // 4 to 9 mm by 0.2, and 1 mm at least.
  EXPECT_GE(Find(trimmed, "gingiva")->amount, 1.0);
  EXPECT_LE(Find(trimmed, "gingiva")->amount, 1.8);
  for (const unsigned int jaw : { 0u, 1u })
  {
    EXPECT_EQ(Surface(plain, jaw).points, Surface(same, jaw).points);
    const auto & before = plain->GetParameters().jaws[jaw];
    const auto & after = trimmed->GetParameters().jaws[jaw];
    EXPECT_EQ(after.buccalFlange, std::max(1.0, 0.2 * before.buccalFlange));
    EXPECT_EQ(after.lingualFlange, std::max(1.0, 0.2 * before.lingualFlange));
    // The scan itself: its extent away from the occlusal plane shrinks by what was taken off buccally, but for the
    // trimming's slope and wave; teeth and landmarks are where they were.
    const auto reach = [jaw](CaseType * source) {
      double z = 0.0;
      for (const auto & p : Surface(source, jaw).points)
      {
        z = std::max(z, jaw == 0 ? p[2] : -p[2]);
      }
      return z;
    };
    if (!before.palate)
    {
      const double taken = std::max(before.buccalFlange, before.lingualFlange) - after.buccalFlange;
      EXPECT_NEAR(reach(plain) - reach(trimmed), taken, 1.5);
    }
    EXPECT_EQ(Teeth(plain, jaw), Teeth(trimmed, jaw));
  }
  const auto mixed = Make(7, Scan("\"gingiva_least\": 0.2, \"gingiva_most\": 1.5"), 6000);
  // Each jaw draws its own.
  const auto drawn = itk::DentalPhantomParameters::Draw(7);
  const auto factor = [&](unsigned int jaw) {
    return mixed->GetParameters().jaws[jaw].buccalFlange / drawn.jaws[jaw].buccalFlange;
  };
  EXPECT_NE(factor(0), factor(1));
}

TEST(DentalPhantomScanDefects, HolesOpenTheSurfaceButNotAtALandmark)
{
  const auto plain = Make(6, "{}", 20000);
  const auto source = Make(6, Scan("\"mean_holes\": 20, \"hole_radius_mm\": 2"), 20000);
  ASSERT_NE(Find(source, "hole"), nullptr);
  for (const unsigned int jaw : { 0u, 1u })
  {
    const auto surface = Surface(source, jaw);
    EXPECT_GT(Borders(surface).first, Borders(Surface(plain, jaw)).first + 30);
    EXPECT_LT(surface.Area(), Surface(plain, jaw).Area() - 10.0);
    std::vector<bool> used(surface.points.size(), false);
    for (const auto & t : surface.triangles)
    {
      used[t[0]] = used[t[1]] = used[t[2]] = true;
    }
    EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool b) { return b; }));
    EXPECT_EQ(source->GetLandmarks3D(jaw)->GetNumberOfLandmarks(), plain->GetLandmarks3D(jaw)->GetNumberOfLandmarks());
  }
}

TEST(DentalPhantomScanDefects, CentredFramesHoldBothOcclusalSidesAlikeAndUprightOnesOpposite)
{
  std::set<unsigned int> axes;
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5, 6 })
  {
    for (const std::string frame : { "centred", "upright" })
    {
      const auto source = Make(seed, Scan("\"frame\": \"" + frame + "\""), 5000);
      double     normals[2][3] = {};
      for (const unsigned int jaw : { 0u, 1u })
      {
        const auto surface = Surface(source, jaw);
        double     centre[3] = {};
        for (const auto & p : surface.points)
        {
          for (unsigned int d = 0; d < 3; ++d)
          {
            centre[d] += p[d] / static_cast<double>(surface.points.size());
          }
        }
        for (unsigned int d = 0; d < 3; ++d)
        {
          // The raster of 1e-4 mm and float coordinates.
          EXPECT_NEAR(centre[d], 0.0, 1e-3) << seed;
        }
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        {
          for (unsigned int d = 0; d < 3; ++d)
          {
            normals[jaw][d] += surface.AreaNormal(t)[d];
          }
        }
        // The rotation is proper: the mesh is not mirrored.
        const auto m = source->GetParameters().ComputeFrame(jaw).rotation;
        EXPECT_NEAR(m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                      m[2] * (m[3] * m[7] - m[4] * m[6]),
                    1.0,
                    1e-9);
      }
      // The lower jaw's occlusal side (its net normal) is +y or +z.
      const unsigned int axis = normals[1][1] > normals[1][2] ? 1 : 2;
      axes.insert(axis);
      EXPECT_GT(normals[1][axis], 0.0) << seed;
      EXPECT_EQ(normals[0][axis] > 0.0, frame == "centred") << seed;
    }
  }
  EXPECT_EQ(axes.size(), 2u);
}

TEST(DentalPhantomScanDefects, SameBitsForAnyNumberOfWorkUnitsWithEverythingOn)
{
  LevelType level = LevelType::Named("real");
  level.flapProbability = level.crumbProbability = level.bracketProbability = level.thirdMolarProbability = 1.0;
  level.numberOfTriangles = 20000;
  level.decimateTo = 8000;
  std::array<CaseType::Pointer, 2> sources;
  for (const unsigned int k : { 0u, 1u })
  {
    sources[k] = CaseType::New();
    sources[k]->SetLevel(level);
    sources[k]->SetSeed(9);
    sources[k]->SetMakeRadiograph(false);
    sources[k]->SetNumberOfWorkUnits(k == 0 ? 1 : 5);
    sources[k]->Update();
  }
  for (const unsigned int jaw : { 0u, 1u })
  {
    EXPECT_EQ(Surface(sources[0], jaw).points, Surface(sources[1], jaw).points);
    EXPECT_EQ(Surface(sources[0], jaw).triangles, Surface(sources[1], jaw).triangles);
  }
}
