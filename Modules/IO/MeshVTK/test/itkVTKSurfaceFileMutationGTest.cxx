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
#include "itkReproducibleRandom.h"
#include "itkTestFile.h"
#include "itkVTKSurfaceFile.h"
#include "itkVTKTestFiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{
/** One to three of the ways in which files break: bits, cut ends, lost and doubled stretches, wild numbers. */
std::string
Mutate(std::string bytes, itk::ReproducibleRandom & random)
{
  static const char * const words[] = { "nan", "-1",     "0",        "1e999",      "4294967296", "99999999999",
                                        "\n",  " ",      "POINTS 9", "POLYGONS 2", "</Points>",  "<DataArray",
                                        "\"",  "FIELD ", "\xff",     "METADATA\n", "int",        "3" };
  for (std::uint64_t step = 1 + random.Integer(3); step > 0 && !bytes.empty(); --step)
  {
    const std::size_t at = random.Integer(static_cast<std::uint32_t>(bytes.size()));
    const std::size_t length =
      random.Integer(static_cast<std::uint32_t>(std::min<std::size_t>(bytes.size() - at, 40)) + 1);
    const char * word = words[random.Integer(std::size(words))];
    switch (random.Integer(6))
    {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.Integer(8)));
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 4:
        bytes.insert(at, word);
        break;
      default:
        bytes.replace(at, std::min<std::size_t>(std::string(word).size(), bytes.size() - at), word);
    }
  }
  return bytes;
}

TEST(VTKSurfaceFileMutants, AreReadWholeOrRefused)
{
  // More with DENTALSCR_VTK_MUTANTS, for a quiet hour.
  const char * const      more = std::getenv("DENTALSCR_VTK_MUTANTS");
  const int               mutants = more != nullptr ? std::atoi(more) : 500;
  itk::ReproducibleRandom random(17);
  for (const auto & kind : VTKTestFiles::Kinds)
  {
    const std::string   extension = kind.xml ? ".vtp" : ".vtk";
    vtkNew<vtkPolyData> data;
    VTKTestFiles::Fill<vtkIntArray>(data, "triangles", "Universal_ID");
    const std::string whole = itk::TestFolder() + "/whole" + extension;
    VTKTestFiles::Write(data, kind, whole);
    const std::string bytes = itk::ReadTestFile(whole);
    for (int m = 0; m < mutants; ++m)
    {
      const std::string file = itk::WriteTestFile("mutant" + extension, Mutate(bytes, random));
      try
      {
        const auto surface = itk::ReadVTKSurfaceFile(file);
        for (const auto & triangle : surface.triangles)
        {
          for (const std::uint32_t id : triangle)
          {
            ASSERT_LT(id, surface.points.size());
          }
        }
        for (const auto & point : surface.points)
        {
          ASSERT_TRUE(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]));
        }
        ASSERT_FALSE(surface.triangles.empty());
        ASSERT_TRUE(surface.labels.empty() || surface.labels.size() == surface.points.size());
      }
      catch (const itk::DentalInputError & error)
      {
        ASSERT_EQ(error.GetInputFile(), file);
        ASSERT_FALSE(error.GetProblem().empty());
      }
    }
  }
}
} // namespace
