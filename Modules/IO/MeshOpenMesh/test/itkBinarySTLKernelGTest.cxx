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
#include "itkBinarySTLKernel.h"
#include "itkMeshFileBytes.h"

#include "itkReproducibleRandom.h"
#include "itkSurfaceMeshFile.h"
#include "itkTriangleSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace
{
using mesh_file_bytes::Facet;

/** The plain way: an ordered map over the coordinates. */
itk::WeldedTriangles
NaiveWeld(const std::vector<Facet> & facets)
{
  itk::WeldedTriangles                          result;
  std::map<std::array<float, 3>, std::uint32_t> numbers;
  for (const Facet & facet : facets)
  {
    std::array<std::uint32_t, 3> triangle;
    for (std::size_t c = 0; c < 3; ++c)
    {
      // + 0 turns -0 into 0.
      const std::array<float, 3> point{ facet[c][0] + 0.0f, facet[c][1] + 0.0f, facet[c][2] + 0.0f };
      const auto                 entry = numbers.emplace(point, static_cast<std::uint32_t>(numbers.size()));
      if (entry.second)
      {
        result.points.push_back(point);
      }
      triangle[c] = entry.first->second;
    }
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
    {
      result.triangles.push_back(triangle);
    }
    else
    {
      ++result.numberOfDegenerateFacets;
    }
  }
  return result;
}

void
ExpectNaive(const std::vector<Facet> & facets)
{
  const std::string          bytes = mesh_file_bytes::BinarySTL(facets);
  const itk::WeldedTriangles welded = itk::ParseBinarySTL(bytes.data(), bytes.size());
  const itk::WeldedTriangles naive = NaiveWeld(facets);
  EXPECT_EQ(welded.points, naive.points);
  EXPECT_EQ(welded.triangles, naive.triangles);
  EXPECT_EQ(welded.numberOfDegenerateFacets, naive.numberOfDegenerateFacets);
  EXPECT_EQ(welded.numberOfFacets, facets.size());
}

std::vector<Facet>
RandomFacets(std::size_t count, std::uint32_t latticeSize, std::uint64_t seed)
{
  itk::ReproducibleRandom random(seed);
  std::vector<Facet>      facets(count);
  for (Facet & facet : facets)
  {
    for (auto & corner : facet)
    {
      for (float & coordinate : corner)
      {
        // Both signs of zero among them.
        coordinate = (static_cast<float>(random.Integer(latticeSize)) - static_cast<float>(latticeSize / 2)) * 0.1f *
                     (random.Integer(2) == 0 ? 1.0f : -1.0f);
      }
    }
  }
  return facets;
}

std::string
MessageOf(const std::string & bytes)
{
  try
  {
    itk::ParseBinarySTL(bytes.data(), bytes.size());
  }
  catch (const itk::SurfaceMeshFileError & error)
  {
    return error.what();
  }
  return "nothing thrown";
}
} // namespace

TEST(BinarySTLKernel, WeldsAsAnOrderedMapDoes)
{
  // Every number of facets around the batch size, a lattice with many duplicates, and soups in which no point is shared
  // so that the table has to grow.
  for (std::size_t count = 1; count <= 70; ++count)
  {
    const std::vector<Facet> facets = RandomFacets(count, 20, count);
    if (!NaiveWeld(facets).triangles.empty())
    {
      ExpectNaive(facets);
    }
  }
  ExpectNaive(RandomFacets(5000, 3, 1));
  ExpectNaive(RandomFacets(5000, 10, 2));
  ExpectNaive(RandomFacets(5000, 4000, 3));
  ExpectNaive(RandomFacets(30000, 1u << 24, 4));
}

TEST(BinarySTLKernel, WeldsBothZerosButNotNeighbours)
{
  const float next = std::nextafter(1.0f, 2.0f);
  ExpectNaive({ Facet{ { { 0.0f, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } },
                Facet{ { { -0.0f, -0.0f, 0 }, { next, 0, 0 }, { 0, 1, -0.0f } } } });
  const std::string bytes = mesh_file_bytes::BinarySTL({ Facet{ { { 0.0f, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } },
                                                         Facet{ { { -0.0f, 0, 0 }, { next, 0, 0 }, { 0, 1, 0 } } } });
  EXPECT_EQ(itk::ParseBinarySTL(bytes.data(), bytes.size()).points.size(), 4u);
}

TEST(BinarySTLKernel, KeepsFlatAndDoubledFacets)
{
  // Collinear corners and twice the same facet: only a repeated point drops a facet.
  const Facet flat{ { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } } };
  const Facet repeated{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } } };
  const auto  bytes = mesh_file_bytes::BinarySTL({ flat, flat, repeated });
  const auto  welded = itk::ParseBinarySTL(bytes.data(), bytes.size());
  EXPECT_EQ(welded.triangles.size(), 2u);
  EXPECT_EQ(welded.numberOfDegenerateFacets, 1u);
}

TEST(BinarySTLKernel, NamesTheSizeExpectedAndFound)
{
  const std::string whole = mesh_file_bytes::BinarySTL(mesh_file_bytes::TetrahedronFacets());
  EXPECT_EQ(MessageOf(whole.substr(0, 200)), "is truncated: 4 facets need 284 bytes, the file has 200");
  // One facet too many, or more than there is of facets: the count cannot be right.
  EXPECT_EQ(MessageOf(whole + std::string(50, 'x')), "is too long: 4 facets need 284 bytes, the file has 334");
  EXPECT_EQ(MessageOf(whole + std::string(201, 'x')), "is too long: 4 facets need 284 bytes, the file has 485");
  EXPECT_EQ(MessageOf(whole.substr(0, 84)), "is truncated: 4 facets need 284 bytes, the file has 84");
  EXPECT_EQ(MessageOf(whole.substr(0, 40)), "has 40 bytes; a binary STL has at least 84");
  EXPECT_EQ(MessageOf(mesh_file_bytes::BinarySTL({})), "has no triangles");
  std::string huge = whole;
  huge.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(MessageOf(huge), "is truncated: 4294967295 facets need 214748364834 bytes, the file has 284");
}

TEST(BinarySTLKernel, BytesBehindTheFacetsAreCountedAndNotLookedAt)
{
  const std::string whole = mesh_file_bytes::BinarySTL(mesh_file_bytes::TetrahedronFacets());
  const auto        plain = itk::ParseBinarySTL(whole.data(), whole.size());
  EXPECT_EQ(plain.numberOfTrailingBytes, 0u);
  for (const std::size_t more : { std::size_t{ 1 }, std::size_t{ 49 }, std::size_t{ 199 } })
  {
    const std::string longer = whole + std::string(more, '\xff');
    const auto        welded = itk::ParseBinarySTL(longer.data(), longer.size());
    EXPECT_EQ(welded.numberOfTrailingBytes, more);
    EXPECT_EQ(welded.points, plain.points);
    EXPECT_EQ(welded.triangles, plain.triangles);
  }
}

TEST(BinarySTLKernel, NamesTheFacetThatIsNotFinite)
{
  for (const float bad : { std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity() })
  {
    std::vector<Facet> facets = RandomFacets(100, 1000, 5);
    facets[57][2][1] = bad;
    EXPECT_EQ(MessageOf(mesh_file_bytes::BinarySTL(facets)),
              std::string("facet 58: corner 3 has a coordinate that is ") +
                (std::isnan(bad) ? "not a number" : "infinite"));
  }
}

TEST(BinarySTLKernel, RefusesAFileWhoseFacetsAllCollapse)
{
  const Facet point{ { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } } };
  EXPECT_EQ(MessageOf(mesh_file_bytes::BinarySTL({ point, point })),
            "all of its 2 facets have two corners in one point");
}

TEST(BinarySTLKernel, NormalsAndAreasAreThoseOfTheDoublePrecisionSurface)
{
  const std::string          bytes = mesh_file_bytes::BinarySTL(RandomFacets(2000, 12, 6));
  const itk::WeldedTriangles welded = itk::ParseBinarySTL(bytes.data(), bytes.size());
  const auto                 fused = itk::ComputeNormalsAndAreas(welded.points, welded.triangles);
  itk::TriangleSurface       surface;
  surface.triangles = welded.triangles;
  for (const auto & point : welded.points)
  {
    surface.points.push_back({ point[0], point[1], point[2] });
  }
  const auto normals = surface.VertexNormals();
  const auto areas = surface.VertexAreas();
  ASSERT_EQ(fused.size(), welded.points.size());
  for (std::size_t i = 0; i < fused.size(); ++i)
  {
    // Some tens of additions in single precision; the normals of a soup nearly cancel, hence the wider bound.
    EXPECT_NEAR(fused[i][3], areas[i], 1e-5 * areas[i]);
    for (std::size_t d = 0; d < 3; ++d)
    {
      EXPECT_NEAR(fused[i][d], normals[i][d], 1e-3);
    }
  }
}

TEST(BinarySTLKernel, PointWithoutAreaHasNoNormal)
{
  const auto fused =
    itk::ComputeNormalsAndAreas({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 9, 9, 9 } }, { { 0, 1, 2 } });
  for (const auto & value : fused)
  {
    EXPECT_EQ(value, (std::array<float, 4>{ 0, 0, 0, 0 }));
  }
}
