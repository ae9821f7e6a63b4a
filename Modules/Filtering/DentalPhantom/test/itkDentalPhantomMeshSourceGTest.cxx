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
