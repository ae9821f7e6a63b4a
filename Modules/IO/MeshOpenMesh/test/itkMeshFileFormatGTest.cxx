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
#include "itkMeshFileFormat.h"
#include "itkMeshFileBytes.h"

#include <gtest/gtest.h>

namespace
{
using itk::MeshFileFormatEnum;

MeshFileFormatEnum
Detect(const std::string & bytes, const std::string & name)
{
  return itk::DetectMeshFileFormat(bytes.data(), bytes.size(), name);
}
} // namespace

TEST(MeshFileFormat, ExtensionInAnyCaseOfTheLastPartOnly)
{
  EXPECT_EQ(itk::MeshFileFormatFromName("a/b.c/Upper.STL"), MeshFileFormatEnum::BinarySTL);
  EXPECT_EQ(itk::MeshFileFormatFromName("x.Ply"), MeshFileFormatEnum::PLY);
  EXPECT_EQ(itk::MeshFileFormatFromName("x.obj"), MeshFileFormatEnum::OBJ);
  EXPECT_EQ(itk::MeshFileFormatFromName("x.off"), MeshFileFormatEnum::OFF);
  for (const char * name : { "", "stl", "a.stl/b", "x.stl.gz", "x.vtk", "x." })
  {
    EXPECT_EQ(itk::MeshFileFormatFromName(name), MeshFileFormatEnum::Unknown) << name;
  }
}

TEST(MeshFileFormat, ContentGoesBeforeTheName)
{
  for (const char * name : { "scan", "scan.stl", "scan.obj", "scan.ply" })
  {
    EXPECT_EQ(Detect(mesh_file_bytes::BinarySTL(mesh_file_bytes::TetrahedronFacets(), "solid trap"), name),
              MeshFileFormatEnum::BinarySTL);
    EXPECT_EQ(Detect(mesh_file_bytes::TetrahedronAsciiSTL(), name), MeshFileFormatEnum::AsciiSTL);
    EXPECT_EQ(Detect(mesh_file_bytes::TetrahedronPLY(), name), MeshFileFormatEnum::PLY);
    EXPECT_EQ(Detect(mesh_file_bytes::TetrahedronBinaryPLY(true), name), MeshFileFormatEnum::PLY);
    EXPECT_EQ(Detect(mesh_file_bytes::TetrahedronOFF(), name), MeshFileFormatEnum::OFF);
    EXPECT_EQ(Detect("\xEF\xBB\xBF# comment\n COFF 3 1 0", name), MeshFileFormatEnum::OFF);
  }
  EXPECT_EQ(Detect(mesh_file_bytes::TetrahedronOBJ(), "scan"), MeshFileFormatEnum::OBJ);
}

TEST(MeshFileFormat, BrokenBinaryWithSolidInItsHeaderIsNoText)
{
  std::string bytes = mesh_file_bytes::BinarySTL(mesh_file_bytes::TetrahedronFacets(), "solid trap");
  bytes.pop_back();
  EXPECT_EQ(Detect(bytes, "scan.stl"), MeshFileFormatEnum::BinarySTL);
}

TEST(MeshFileFormat, OtherTextIsUnknown)
{
  EXPECT_EQ(Detect("# vtk DataFile Version 3.0\n", "scan.vtk"), MeshFileFormatEnum::Unknown);
  EXPECT_EQ(Detect("", "scan"), MeshFileFormatEnum::Unknown);
  EXPECT_EQ(Detect("hello", "scan.txt"), MeshFileFormatEnum::Unknown);
}
