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

#include "itkReproducibleRandom.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr int MutantsPerFile = 15000;

/** One to four of the ways in which files break: bits, cut ends, lost and doubled stretches, wild numbers. */
std::string
Mutate(std::string bytes, itk::ReproducibleRandom & random)
{
  static const char * const  words[] = { "nan",
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
                                         "\xEF\xBB\xBF" };
  static const std::uint32_t fields[] = { 0u, 1u, 0x7fffffffu, 0x80000000u, 0xffffffffu, 0x7fc00000u, 0x7f800000u };
  const std::uint32_t        steps = 1 + random.Integer(4);
  for (std::uint32_t step = 0; step < steps && !bytes.empty(); ++step)
  {
    const std::size_t at = random.Integer(static_cast<std::uint32_t>(bytes.size()));
    const std::size_t length =
      random.Integer(static_cast<std::uint32_t>(std::min<std::size_t>(bytes.size() - at, 60)) + 1);
    switch (random.Integer(8))
    {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.Integer(8)));
        break;
      case 1:
        bytes[at] = static_cast<char>(random.Integer(256));
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.erase(at, length);
        break;
      case 4:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 5:
        bytes.insert(at, words[random.Integer(std::size(words))]);
        break;
      case 6:
        bytes.replace(at, random.Integer(4), words[random.Integer(std::size(words))]);
        break;
      default:
        if (bytes.size() >= at + 4)
        {
          std::memcpy(&bytes[at], &fields[random.Integer(std::size(fields))], 4);
        }
    }
  }
  return bytes;
}

/** Either a good mesh or our own exception: anything else fails, a crash or a hang included. */
void
ExpectSoundOrRefused(const std::string & whole, const char * name, std::uint64_t seed)
{
  itk::ReproducibleRandom random(seed);
  int                     refused = 0;
  for (int mutant = 0; mutant < MutantsPerFile; ++mutant)
  {
    // A buffer of the exact size, so that memory checkers see a byte read too far.
    const std::string       mutated = Mutate(whole, random);
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
