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
#include "itkDentalPhantomMeshSource.h"
#include "itkDentalPhantomModel.h"
#include "itkMakeTriangleSurface.h"

#include "itkCommand.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace
{
using MeshType = itk::Mesh<float, 3>;
using SourceType = itk::DentalPhantomMeshSource<MeshType>;
using ParametersType = itk::DentalPhantomParameters;

int
ExerciseBasics(SourceType * source)
{
  ITK_EXERCISE_BASIC_OBJECT_METHODS(source, DentalPhantomMeshSource, MeshSource);
  return EXIT_SUCCESS;
}

ParametersType
Anatomical(std::uint64_t seed, std::uint32_t triangles = 30000)
{
  ParametersType parameters = ParametersType::Draw(seed);
  parameters.frame = ParametersType::FrameEnum::Anatomical;
  parameters.numberOfTriangles = triangles;
  return parameters;
}

SourceType::Pointer
Make(const ParametersType & parameters, unsigned int workUnits = 2)
{
  auto source = SourceType::New();
  source->SetParameters(parameters);
  source->SetNumberOfWorkUnits(workUnits);
  source->Update();
  return source;
}

struct Topology
{
  std::size_t inconsistent{ 0 };
  std::size_t nonManifold{ 0 };
  std::size_t boundary{ 0 };
  std::size_t boundaryLoops{ 0 };
  int         euler{ 0 };
};

Topology
Examine(const itk::TriangleSurface & surface)
{
  // Directed edges: each must occur once; an edge whose opposite is absent is a border.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto & t : surface.triangles)
  {
    for (unsigned int k = 0; k < 3; ++k)
    {
      ++edges[{ t[k], t[(k + 1) % 3] }];
    }
  }
  Topology                               topology;
  std::map<std::uint32_t, std::uint32_t> next;
  std::size_t                            undirected = 0;
  std::set<std::uint32_t>                used;
  for (const auto & edge : edges)
  {
    used.insert(edge.first.first);
    topology.inconsistent += edge.second > 1;
    const bool hasOpposite = edges.count({ edge.first.second, edge.first.first }) > 0;
    if (!hasOpposite)
    {
      ++topology.boundary;
      topology.nonManifold += !next.insert(edge.first).second;
    }
    undirected += !hasOpposite || edge.first.first < edge.first.second;
  }
  std::set<std::uint32_t> seen;
  for (const auto & start : next)
  {
    if (seen.insert(start.first).second)
    {
      ++topology.boundaryLoops;
      for (std::uint32_t v = start.second; v != start.first; v = next.at(v))
      {
        seen.insert(v);
      }
    }
  }
  topology.euler =
    static_cast<int>(used.size()) - static_cast<int>(undirected) + static_cast<int>(surface.triangles.size());
  topology.nonManifold += surface.points.size() - used.size();
  return topology;
}
} // namespace

TEST(DentalPhantomMeshSource, HasTheBasicMethods)
{
  EXPECT_EQ(ExerciseBasics(SourceType::New()), EXIT_SUCCESS);
}

TEST(DentalPhantomMeshSource, OpenShellIsADiscWoundOutward)
{
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5, 6 })
  {
    const auto source = Make(Anatomical(seed, 12000));
    for (const unsigned int jaw : { 0, 1 })
    {
      const auto surface =
        itk::MakeTriangleSurface<MeshType>(jaw == 0 ? source->GetUpperOutput() : source->GetLowerOutput());
      const Topology topology = Examine(surface);
      EXPECT_EQ(topology.inconsistent, 0u) << seed;
      EXPECT_EQ(topology.nonManifold, 0u) << seed;
      EXPECT_EQ(topology.boundaryLoops, 1u) << seed;
      EXPECT_EQ(topology.euler, 1) << seed;
      // The net normal of an open arch points occlusally: -z above, +z below.
      double z = 0.0;
      for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      {
        z += surface.AreaNormal(t)[2];
      }
      EXPECT_GT((jaw == 0 ? -z : z) / surface.Area(), 0.2) << seed;
    }
  }
}

TEST(DentalPhantomMeshSource, StoneCastIsClosedWithOrWithoutPalate)
{
  for (const bool palate : { false, true })
  {
    ParametersType parameters = Anatomical(3, 10000);
    parameters.stoneBase = true;
    parameters.jaws[0].palate = palate;
    const auto source = Make(parameters);
    for (auto * mesh : { source->GetUpperOutput(), source->GetLowerOutput() })
    {
      const auto     surface = itk::MakeTriangleSurface<MeshType>(mesh);
      const Topology topology = Examine(surface);
      EXPECT_EQ(topology.inconsistent, 0u);
      EXPECT_EQ(topology.nonManifold, 0u);
      EXPECT_EQ(topology.boundary, 0u);
      EXPECT_EQ(topology.euler, 2);
      // Outward: the divergence theorem gives the volume of a cast, some 20 to 100 cm^3, with a positive sign.
      double volume = 0.0;
      for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      {
        const auto   n = surface.AreaNormal(t);
        const auto & p = surface.points[surface.triangles[t][0]];
        volume += (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) / 3.0;
      }
      EXPECT_GT(volume, 15e3);
      EXPECT_LT(volume, 120e3);
    }
  }
}

TEST(DentalPhantomMeshSource, HasAnatomicalSizesAndTheWantedNumberOfTriangles)
{
  for (const std::uint64_t seed : { 21, 22, 23, 24 })
  {
    const auto source = Make(Anatomical(seed, 20000));
    for (auto * mesh : { source->GetUpperOutput(), source->GetLowerOutput() })
    {
      double low[3] = { 1e9, 1e9, 1e9 };
      double high[3] = { -1e9, -1e9, -1e9 };
      for (const auto & p : mesh->GetPoints()->CastToSTLConstContainer())
      {
        for (unsigned int d = 0; d < 3; ++d)
        {
          low[d] = std::min<double>(low[d], p[d]);
          high[d] = std::max<double>(high[d], p[d]);
        }
      }
      // An arch is wider than deep; both jaws meet about z = 0.
      EXPECT_GT(high[1] - low[1], 50.0) << seed;
      EXPECT_LT(high[1] - low[1], 85.0) << seed;
      EXPECT_GT(high[0] - low[0], 35.0) << seed;
      EXPECT_LT(high[0] - low[0], 65.0) << seed;
      EXPECT_NEAR(static_cast<double>(mesh->GetNumberOfCells()), 20000.0, 2000.0) << seed;
    }
  }
}

TEST(DentalPhantomMeshSource, LandmarksAreVerticesAtTheHighestPointsOfTheirCrowns)
{
  const std::vector<std::string> names = { "1_tip", "2_tip", "3_cusp", "4_B", "5_B", "6_MB", "6_DB", "7_MB" };
  for (const std::uint64_t seed : { 5, 6 })
  {
    const auto source = Make(Anatomical(seed, 40000));
    for (const unsigned int jaw : { 0, 1 })
    {
      const MeshType * mesh = jaw == 0 ? source->GetUpperOutput() : source->GetLowerOutput();
      const auto *     landmarks = jaw == 0 ? source->GetUpperLandmarks() : source->GetLowerLandmarks();
      ASSERT_EQ(landmarks->GetNumberOfLandmarks(), 16u);
      for (const char * quadrant : { "R", "L" })
      {
        for (const std::string & name : names)
        {
          const auto * landmark = landmarks->Find((jaw == 0 ? "U" : "L") + (quadrant + name));
          ASSERT_NE(landmark, nullptr) << name;
          // The patient's left is +y.
          EXPECT_EQ(landmark->point[1] > 0.0, std::string(quadrant) == "L") << name;
          bool   isVertex = false;
          double higher = 0.0;
          for (itk::IdentifierType i = 0; i < mesh->GetNumberOfPoints(); ++i)
          {
            const auto p = mesh->GetPoint(i);
            float      label = 0.0f;
            mesh->GetPointData(i, &label);
            const double distance =
              std::sqrt(std::pow(p[0] - landmark->point[0], 2) + std::pow(p[1] - landmark->point[1], 2));
            if (static_cast<unsigned int>(label) != landmark->tooth.GetFDI())
            {
              continue;
            }
            // Float coordinates: half a unit in the last place at 100 mm.
            isVertex = isVertex || (distance < 1e-5 && std::abs(p[2] - landmark->point[2]) < 1e-5);
            if (distance < 0.8)
            {
              higher = std::max(higher, (jaw == 0 ? -1.0 : 1.0) * (p[2] - landmark->point[2]));
            }
          }
          EXPECT_TRUE(isVertex) << landmark->name;
          // A cusp's tip is the highest point; an edge may slope with its tooth's tip and rotation (tan 9 deg * 0.8),
          // and the scan's noise adds 0.04.
          EXPECT_LT(higher, name.find("tip") == std::string::npos ? 0.06 : 0.17) << landmark->name;
        }
      }
    }
  }
}

TEST(DentalPhantomMeshSource, MolarsHaveFissuresBetweenTheirCusps)
{
  const auto   source = Make(ParametersType());
  const auto * landmarks = source->GetLowerLandmarks();
  const auto   mesial = landmarks->Find("LR6_MB")->point;
  const auto   distal = landmarks->Find("LR6_DB")->point;
  double       lowest = 1e9;
  const auto * mesh = source->GetLowerOutput();
  for (itk::IdentifierType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    float label = 0.0f;
    mesh->GetPointData(i, &label);
    const auto   p = mesh->GetPoint(i);
    const double dx = p[0] - 0.5 * (mesial[0] + distal[0]);
    const double dy = p[1] - 0.5 * (mesial[1] + distal[1]);
    if (label == 46.0f && dx * dx + dy * dy < 0.25)
    {
      lowest = std::min<double>(lowest, p[2]);
    }
  }
  EXPECT_LT(lowest, std::min(mesial[2], distal[2]) - 0.3);
}

TEST(DentalPhantomMeshSource, MissingTeethLeaveNoLabelAndNoLandmark)
{
  ParametersType parameters = Anatomical(7, 12000);
  parameters.jaws[0].teeth[10].missing = true;
  const auto source = Make(parameters);
  EXPECT_EQ(source->GetUpperLandmarks()->Find("UL4_B"), nullptr);
  EXPECT_NE(source->GetUpperLandmarks()->Find("UL3_cusp"), nullptr);
  std::set<int> labels;
  for (auto it = source->GetUpperOutput()->GetPointData()->Begin();
       it != source->GetUpperOutput()->GetPointData()->End();
       ++it)
  {
    labels.insert(static_cast<int>(it.Value()));
  }
  EXPECT_EQ(labels, (std::set<int>{ 0, 11, 12, 13, 14, 15, 16, 17, 21, 22, 23, 25, 26, 27 }));
}

// Real scans touch; they do not run into each other.
TEST(DentalPhantomMeshSource, JawsTouchWithoutRunningIntoEachOther)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    const auto source = Make(Anatomical(seed, 30000));
    const auto upper = itk::MakeTriangleSurface<MeshType>(source->GetUpperOutput());
    const auto lower = itk::MakeTriangleSurface<MeshType>(source->GetLowerOutput());
    // Height of the upper jaw over each lower vertex, from the triangles above a 0.5 mm cell.
    const auto cell = [](double x) { return static_cast<int>(std::floor(2.0 * x)); };
    std::map<std::pair<int, int>, std::vector<std::size_t>> grid;
    for (std::size_t t = 0; t < upper.triangles.size(); ++t)
    {
      double low[2] = { 1e9, 1e9 };
      double high[2] = { -1e9, -1e9 };
      for (const auto id : upper.triangles[t])
      {
        for (unsigned int d = 0; d < 2; ++d)
        {
          low[d] = std::min(low[d], upper.points[id][d]);
          high[d] = std::max(high[d], upper.points[id][d]);
        }
      }
      for (int i = cell(low[0]); i <= cell(high[0]); ++i)
      {
        for (int j = cell(low[1]); j <= cell(high[1]); ++j)
        {
          grid[{ i, j }].push_back(t);
        }
      }
    }
    double                   smallest = 1e9;
    std::map<unsigned, bool> touching;
    for (std::size_t v = 0; v < lower.points.size(); ++v)
    {
      const auto & p = lower.points[v];
      float        label = 0.0f;
      source->GetLowerOutput()->GetPointData(v, &label);
      const auto found = grid.find({ cell(p[0]), cell(p[1]) });
      if (label == 0.0f || found == grid.end())
      {
        continue;
      }
      for (const std::size_t t : found->second)
      {
        const auto & a = upper.points[upper.triangles[t][0]];
        const auto & b = upper.points[upper.triangles[t][1]];
        const auto & c = upper.points[upper.triangles[t][2]];
        const double det = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        const double x = p[0] - a[0];
        const double y = p[1] - a[1];
        const double u = (x * (c[1] - a[1]) - (c[0] - a[0]) * y) / det;
        const double w = ((b[0] - a[0]) * y - x * (b[1] - a[1])) / det;
        if (u >= 0.0 && w >= 0.0 && u + w <= 1.0)
        {
          const double gap = a[2] + u * (b[2] - a[2]) + w * (c[2] - a[2]) - p[2];
          smallest = std::min(smallest, gap);
          touching[static_cast<unsigned>(label)] |= gap < 0.35;
        }
      }
    }
    // Scanner noise 0.01 and the meshes' own resolution against that of the settling.
    EXPECT_GT(smallest, -0.1) << seed;
    EXPECT_LT(smallest, 0.25) << seed;
    EXPECT_GE(std::count_if(touching.begin(), touching.end(), [](const auto & t) { return t.second; }), 6) << seed;
  }
}

TEST(DentalPhantomMeshSource, FramesAreTheStatedRigidMotions)
{
  ParametersType parameters = Anatomical(9, 6000);
  const auto     anatomical = Make(parameters);
  for (const auto frame : { ParametersType::FrameEnum::SharedScanner, ParametersType::FrameEnum::SeparateScanner })
  {
    parameters.frame = frame;
    const auto source = Make(parameters);
    for (const unsigned int jaw : { 0, 1 })
    {
      const auto rotation = source->GetFrameRotation(jaw);
      const auto translation = source->GetFrameTranslation(jaw);
      const auto a = jaw == 0 ? anatomical->GetUpperOutput() : anatomical->GetLowerOutput();
      const auto b = jaw == 0 ? source->GetUpperOutput() : source->GetLowerOutput();
      EXPECT_NEAR(rotation.GetVnlMatrix().operator()(0, 0),
                  rotation(1, 1) * rotation(2, 2) - rotation(1, 2) * rotation(2, 1),
                  1e-12);
      for (itk::IdentifierType i = 0; i < a->GetNumberOfPoints(); i += 37)
      {
        itk::Point<double, 3> p;
        p.CastFrom(a->GetPoint(i));
        const auto q = rotation * p + translation;
        // The raster of 1e-4 mm and float coordinates.
        EXPECT_LT(q.EuclideanDistanceTo(itk::Point<double, 3>(b->GetPoint(i))), 2e-4);
      }
    }
    const bool same = source->GetFrameRotation(0) == source->GetFrameRotation(1);
    EXPECT_EQ(same, frame == ParametersType::FrameEnum::SharedScanner);
  }
}

TEST(DentalPhantomMeshSource, DoubleMeshesAreTheSame)
{
  const auto parameters = Anatomical(13, 4000);
  const auto single = Make(parameters);
  auto       source = itk::DentalPhantomMeshSource<itk::Mesh<double, 3>>::New();
  source->SetParameters(parameters);
  source->Update();
  ASSERT_EQ(source->GetLowerOutput()->GetNumberOfPoints(), single->GetLowerOutput()->GetNumberOfPoints());
  for (itk::IdentifierType i = 0; i < single->GetLowerOutput()->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(source->GetLowerOutput()->GetPoint(i), single->GetLowerOutput()->GetPoint(i));
  }
}

TEST(DentalPhantomMeshSource, RefusesParametersThatNoJawHas)
{
  ParametersType parameters;
  parameters.jaws[1].teeth[3].mesiodistal = 90.0;
  auto source = SourceType::New();
  source->SetParameters(parameters);
  try
  {
    source->Update();
    FAIL() << "no exception";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("mesiodistal is 90"), std::string::npos) << error;
  }
}

TEST(DentalPhantomMeshSource, StopsWhenAborted)
{
  auto source = SourceType::New();
  auto command = itk::FunctionCommand::New();
  command->SetCallback([&source](const itk::EventObject &) { source->AbortGenerateDataOn(); });
  source->AddObserver(itk::ProgressEvent(), command);
  EXPECT_THROW(source->Update(), itk::ProcessAborted);
}

TEST(DentalPhantomParameters, DrawsEveryArchFamilyAndNeverAnInvalidJaw)
{
  std::map<ParametersType::ArchFamilyEnum, int> families;
  int                                           palates = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed)
  {
    const auto parameters = ParametersType::Draw(seed);
    EXPECT_NO_THROW(parameters.Validate()) << seed;
    ++families[parameters.archFamily];
    palates += parameters.jaws[0].palate;
  }
  ASSERT_EQ(families.size(), 3u);
  for (const auto & family : families)
  {
    // Binomial(600, 1/3): sd 11.5.
    EXPECT_NEAR(family.second, 200, 50);
  }
  EXPECT_NEAR(palates, 300, 60);
}

TEST(DentalPhantomMeshSource, SameBitsForAnyNumberOfWorkUnitsAndEveryRun)
{
  const auto one = Make(ParametersType::Draw(11), 1);
  const auto many = Make(ParametersType::Draw(11), 7);
  const auto again = Make(ParametersType::Draw(11), 7);
  for (const unsigned int jaw : { 0, 1 })
  {
    const auto output = [jaw](SourceType * source) {
      return itk::MakeTriangleSurface<MeshType>(jaw == 0 ? source->GetUpperOutput() : source->GetLowerOutput());
    };
    EXPECT_EQ(output(one).points, output(many).points);
    EXPECT_EQ(output(one).triangles, output(many).triangles);
    EXPECT_EQ(output(again).points, output(many).points);
  }
}
