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
#include "itkSurfaceMeshFile.h"
#include "itkMeshFileBytes.h"

#include "itkMutate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
constexpr int MutantsPerFile = 15000;

const std::vector<std::string> Words = { "nan",
                                         "inf",
                                         "-1",
                                         "0",
                                         "1e999",
                                         "-1e-999",
                                         "4294967295",
                                         "4294967296",
                                         "18446744073709551615",
                                         "99999999999999999999999",
                                         "1,5",
                                         "\n",
                                         " ",
                                         "#",
                                         "\\\n",
                                         "f",
                                         "vertex",
                                         "endsolid",
                                         "3",
                                         "OFF",
                                         "end_header\n",
                                         "element face 9\n",
                                         "property list uint uint q\n",
                                         "/",
                                         "//",
                                         "\xff",
                                         "\xEF\xBB\xBF",
                                         // Numbers of a binary file: the largest ones, infinity and no number at all.
                                         std::string(4, '\0'),
                                         std::string("\x01\x00\x00\x00", 4),
                                         "\xff\xff\xff\x7f",
                                         std::string("\x00\x00\x00\x80", 4),
                                         "\xff\xff\xff\xff",
                                         std::string("\x00\x00\xc0\x7f", 4),
                                         std::string("\x00\x00\x80\x7f", 4) };

/** Either a good mesh or our own exception: anything else fails, a crash or a hang included. */
void
ExpectSoundOrRefused(const std::string & whole, const char * name, std::uint64_t seed)
{
  itk::ReproducibleRandom random(seed);
  int                     refused = 0;
  for (int mutant = 0; mutant < MutantsPerFile; ++mutant)
  {
    // A buffer of the exact size, so that memory checkers see a byte read too far.
    const std::string       mutated = itk::Mutate(whole, Words, { whole }, random);
    const std::vector<char> bytes(mutated.begin(), mutated.end());
    try
    {
      const itk::SurfaceMeshFile surface = itk::ParseSurfaceMesh(bytes.data(), bytes.size(), name);
      ASSERT_FALSE(surface.triangles.empty());
      ASSERT_LE(surface.triangles.size(), bytes.size());
      ASSERT_LE(surface.GetNumberOfPoints(), bytes.size());
      for (const auto & triangle : surface.triangles)
      {
        ASSERT_LT(std::max({ triangle[0], triangle[1], triangle[2] }), surface.GetNumberOfPoints());
        ASSERT_TRUE(triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]);
      }
      for (const auto & point : surface.floatPoints)
      {
        ASSERT_TRUE(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]));
      }
      for (const auto & point : surface.doublePoints)
      {
        ASSERT_TRUE(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]));
      }
    }
    catch (const itk::SurfaceMeshFileError & error)
    {
      ++refused;
      ASSERT_FALSE(error.problem.empty());
      ASSERT_FALSE(error.remedy.empty());
    }
  }
  // Else the mutations do nothing.
  EXPECT_GT(refused, MutantsPerFile / 4) << name;
}
} // namespace

TEST(SurfaceMeshFileMutation, BinarySTL)
{
  ExpectSoundOrRefused(mesh_file_bytes::BinarySTL(mesh_file_bytes::TetrahedronFacets(), "solid"), "a.stl", 1);
}

TEST(SurfaceMeshFileMutation, AsciiSTL)
{
  ExpectSoundOrRefused(mesh_file_bytes::TetrahedronAsciiSTL(), "a.stl", 2);
}

TEST(SurfaceMeshFileMutation, OBJ)
{
  ExpectSoundOrRefused(mesh_file_bytes::TetrahedronOBJ(), "a.obj", 3);
}

TEST(SurfaceMeshFileMutation, OFF)
{
  ExpectSoundOrRefused(mesh_file_bytes::TetrahedronOFF(), "a.off", 4);
}

TEST(SurfaceMeshFileMutation, PLY)
{
  ExpectSoundOrRefused(mesh_file_bytes::TetrahedronPLY(), "a.ply", 5);
  ExpectSoundOrRefused(mesh_file_bytes::TetrahedronBinaryPLY(false), "a.ply", 6);
  ExpectSoundOrRefused(mesh_file_bytes::TetrahedronBinaryPLY(true), "a.ply", 7);
}
