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
#include "itkMutate.h"
#include "itkTestFile.h"
#include "itkVTKSurfaceFile.h"
#include "itkVTKTestFiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
const std::vector<std::string> Words = { "nan", "-1",     "0",        "1e999",      "4294967296", "99999999999",
                                         "\n",  " ",      "POINTS 9", "POLYGONS 2", "</Points>",  "<DataArray",
                                         "\"",  "FIELD ", "\xff",     "METADATA\n", "int",        "3" };

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
      const std::string file = itk::WriteTestFile("mutant" + extension, itk::Mutate(bytes, Words, { bytes }, random));
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
