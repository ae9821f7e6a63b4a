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
#include "itkReadVTKMesh.h"
#include "itkMemoryFile.h"
#include "itkTestFile.h"
#include "itkVTKTestFiles.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace
{
using itk::Contains;
using itk::ExpectInputError;
using itk::WriteTestFile;

class VTKSurfaceFileOfEachKind : public ::testing::TestWithParam<VTKTestFiles::Kind>
{};

TEST_P(VTKSurfaceFileOfEachKind, GivesPointsFacesAndLabels)
{
  const std::string name = itk::TestFolder() + (GetParam().xml ? "/scan.VTP" : "/scan.vtk");
  for (const char * faces : { "triangles", "quad", "strip" })
  {
    for (const char * label : { "Universal_ID", "UniversalID", "PredictedID" })
    {
      vtkNew<vtkPolyData> data;
      std::string(label) == "PredictedID"   ? VTKTestFiles::Fill<vtkFloatArray>(data, faces, label)
      : std::string(label) == "UniversalID" ? VTKTestFiles::Fill<vtkIdTypeArray>(data, faces, label)
                                            : VTKTestFiles::Fill<vtkIntArray>(data, faces, label);
      VTKTestFiles::Write(data, GetParam(), name);
      const auto surface = itk::ReadVTKSurfaceFile(name);
      ASSERT_EQ(surface.points.size(), 4u);
      EXPECT_EQ(surface.points[3], (std::array<double, 3>{ { 0.0, 1.0, -0.125 } }));
      ASSERT_EQ(surface.triangles.size(), 2u);
      EXPECT_EQ(surface.numberOfDegenerateFaces, 0u);
      // Both faces of the square look the same way, whatever they were written as.
      for (const auto & t : surface.triangles)
      {
        const auto & a = surface.points[t[0]];
        const auto & b = surface.points[t[1]];
        const auto & c = surface.points[t[2]];
        EXPECT_DOUBLE_EQ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 1.0);
      }
      EXPECT_EQ(surface.labelName, label);
      EXPECT_EQ(surface.labels, (std::vector<double>{ 8, 9, 33, 0 }));
    }
  }
}

TEST_P(VTKSurfaceFileOfEachKind, HasNoLabelsWhereThereAreNone)
{
  const std::string   name = itk::TestFolder() + (GetParam().xml ? "/scan.vtp" : "/scan.vtk");
  vtkNew<vtkPolyData> data;
  VTKTestFiles::Fill<vtkUnsignedCharArray>(data, "triangles", nullptr);
  VTKTestFiles::Write(data, GetParam(), name);
  const auto surface = itk::ReadVTKSurfaceFile(name);
  EXPECT_EQ(surface.labelName, "");
  EXPECT_TRUE(surface.labels.empty());
}

TEST_P(VTKSurfaceFileOfEachKind, IsAnErrorWhereItIsCutShort)
{
  const std::string   name = itk::TestFolder() + (GetParam().xml ? "/scan.vtp" : "/scan.vtk");
  vtkNew<vtkPolyData> data;
  VTKTestFiles::Fill<vtkIntArray>(data, "triangles", "Universal_ID");
  VTKTestFiles::Write(data, GetParam(), name);
  const std::string bytes = itk::ReadTestFile(name);
  for (const double part : { 0.0, 0.1, 0.3, 0.5, 0.7 })
  {
    const std::string cut = bytes.substr(0, static_cast<std::size_t>(part * static_cast<double>(bytes.size())));
    const std::string file = WriteTestFile(GetParam().xml ? "cut.vtp" : "cut.vtk", cut);
    try
    {
      // What remains whole may be read: a legacy file's attributes are optional.
      const auto surface = itk::ReadVTKSurfaceFile(file);
      EXPECT_EQ(surface.points.size(), 4u);
      EXPECT_EQ(surface.triangles.size(), 2u);
      EXPECT_TRUE(surface.labels.empty()) << part;
    }
    catch (const itk::DentalInputError & error)
    {
      EXPECT_EQ(error.GetInputFile(), file);
      EXPECT_FALSE(error.GetRemedy().empty());
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Kinds, VTKSurfaceFileOfEachKind, ::testing::ValuesIn(VTKTestFiles::Kinds));

constexpr const char * Scan = "# vtk DataFile Version 3.0\nscan\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                              "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n";

TEST(VTKSurfaceFile, ReadsScalarsOfOldFiles)
{
  const auto file = WriteTestFile(
    "old.vtk", std::string(Scan) + "POINT_DATA 3\nSCALARS Universal_ID int 1\nLOOKUP_TABLE default\n33 30 31\n");
  const auto surface = itk::ReadVTKSurfaceFile(file);
  EXPECT_EQ(surface.labels, (std::vector<double>{ 33, 30, 31 }));
}

TEST(VTKSurfaceFile, SaysThatLabelsAreOfCells)
{
  const auto file = WriteTestFile(
    "cells.vtk", std::string(Scan) + "CELL_DATA 1\nSCALARS Universal_ID int 1\nLOOKUP_TABLE default\n30\n");
  const auto surface = itk::ReadVTKSurfaceFile(file);
  EXPECT_TRUE(surface.labelsOfCells);
  EXPECT_TRUE(surface.labels.empty());
}

TEST(VTKSurfaceFile, NamesFileAndRemedyForWhatIsWrong)
{
  const auto lineOf = [](const std::string & name, const std::string & content) {
    const auto file = WriteTestFile(name, content);
    return ExpectInputError([&]() { itk::ReadVTKSurfaceFile(file); }).GetOneLine();
  };
  const auto replaced = [](const std::string & from, const std::string & to) {
    std::string text = Scan;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_TRUE(Contains(lineOf("empty.vtk", ""), "empty"));
  EXPECT_TRUE(Contains(lineOf("other.vtk", "solid scan\n"), "neither"));
  EXPECT_TRUE(Contains(lineOf("grid.vtk", replaced("POLYDATA", "STRUCTURED_POINTS")), "POLYDATA"));
  EXPECT_TRUE(
    Contains(lineOf("index.vtk", replaced("3 0 1 2", "3 0 1 9")), "polygon 1: names a point that is not there"));
  EXPECT_TRUE(Contains(lineOf("negative.vtk", replaced("3 0 1 2", "3 0 1 -2")), "polygon 1: names a point"));
  EXPECT_TRUE(Contains(lineOf("corners.vtk", replaced("POLYGONS 1 4\n3 0 1 2", "POLYGONS 1 3\n2 0 1")), "2 corners"));
  EXPECT_TRUE(Contains(lineOf("huge.vtk", replaced("POINTS 3", "POINTS 99999999999")), "POINTS: promises"));
  EXPECT_TRUE(Contains(lineOf("less.vtk", replaced("POINTS 3", "POINTS -3")), "POINTS: has no count"));
  EXPECT_TRUE(Contains(lineOf("faces.vtk", replaced("POLYGONS 1 4\n3 0 1 2", "")), "no triangles"));
  EXPECT_TRUE(Contains(lineOf("twice.vtk", replaced("3 0 1 2", "3 0 1 1")), "name a point twice"));
  EXPECT_TRUE(Contains(lineOf("word.vtk", replaced("1 0 0", "1 x 0")), "no number"));
  EXPECT_TRUE(Contains(lineOf("nan.vtk", replaced("1 0 0", "1 nan 0")), "not finite"));
  EXPECT_TRUE(Contains(lineOf("point.vtk", replaced("1 0 0", "1.5e 0 0")), "no number"));
  EXPECT_TRUE(Contains(
    lineOf("short.vtk", std::string(Scan) + "POINT_DATA 2\nSCALARS Universal_ID int 1\nLOOKUP_TABLE default\n30 31\n"),
    "Universal_ID: has 2 values for 3 points"));
  EXPECT_TRUE(Contains(lineOf("broken.vtp", "<VTKFile type=\"PolyData\"><PolyData>"), "XML"));
  EXPECT_TRUE(
    Contains(lineOf("image.vtp", "<?xml version=\"1.0\"?><VTKFile type=\"ImageData\"></VTKFile>"), "PolyData"));
  EXPECT_TRUE(
    Contains(ExpectInputError([]() { itk::ReadVTKSurfaceFile("nowhere.vtk"); }).GetOneLine(), "no such file"));
  EXPECT_TRUE(Contains(ExpectInputError([]() { itk::ReadVTKSurfaceFile(itk::TestFolder()); }).GetOneLine(),
                       "this is a directory"));
}

std::string
XMLFile(const std::string & pieces, const std::string & appended = {})
{
  return "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" header_type=\"UInt32\"><PolyData>" + pieces +
         "</PolyData>" + appended + "</VTKFile>";
}

TEST(VTKSurfaceFile, TakesNoMoreMemoryThanItsBytesWhateverTheyAreWrittenAs)
{
  // A hundred pieces that all read the same appended megabyte.
  constexpr std::uint32_t points = 87381;
  const std::uint32_t     length = 12 * points;
  std::string             data = "_";
  data.append(reinterpret_cast<const char *>(&length), sizeof(length));
  data.append(length, '\0');
  const std::string piece =
    "<Piece NumberOfPoints=\"" + std::to_string(points) +
    "\"><Points><DataArray type=\"Float32\" format=\"appended\" offset=\"0\"/></Points></Piece>";
  for (const bool shared : { false, true })
  {
    std::string pieces;
    for (int i = 0; i < (shared ? 100 : 1); ++i)
    {
      pieces += piece;
    }
    const auto file =
      WriteTestFile("raw.vtp", XMLFile(pieces, "<AppendedData encoding=\"raw\">" + data + "</AppendedData>"));
    const auto problem = ExpectInputError([&]() { itk::ReadVTKSurfaceFile(file); }).GetOneLine();
    EXPECT_TRUE(Contains(problem, shared ? "name more bytes than the file has" : "has no triangles")) << problem;
  }
}

/** The problem of a file that is too large to be written to the disk for a test. */
std::string
ProblemOf(const char * extension, const std::string & content)
{
  const itk::MemoryFile file(extension);
  std::ofstream(file.GetName(), std::ios::binary) << content;
  return ExpectInputError([&]() { itk::ReadVTKSurfaceFile(file.GetName()); }).GetOneLine();
}

TEST(VTKSurfaceFile, HasABoundOfItsNumbersWhateverTheyAreWrittenAs)
{
  // Eight bytes of memory for each number: these files are 64, 8 and 4 times as small.
  constexpr std::size_t points = (std::size_t{ 1 } << 26) / 3 + 1;
  constexpr std::size_t numbers = 3 * points;
  const std::string     count = std::to_string(points);
  std::string           problem = ProblemOf(".vtk",
                                  "# vtk DataFile Version 3.0\nscan\nBINARY\nDATASET POLYDATA\nPOINTS " + count +
                                    " bit\n" + std::string(numbers / 8 + 1, '\0'));
  EXPECT_TRUE(Contains(problem, "POINTS: and what stands before it take more than 512 MiB as numbers")) << problem;

  const auto  length = static_cast<std::uint32_t>(numbers);
  std::string data = "_";
  data.append(reinterpret_cast<const char *>(&length), sizeof(length));
  data.append(length, '\0');
  const std::string pointsBegin = "<Piece NumberOfPoints=\"" + count + "\"><Points>";
  const std::string pointsEnd = "</Points></Piece>";
  problem = ProblemOf(".vtp",
                      XMLFile(pointsBegin + "<DataArray type=\"UInt8\" format=\"appended\" offset=\"0\"/>" + pointsEnd,
                              "<AppendedData encoding=\"raw\">" + data + "</AppendedData>"));
  EXPECT_TRUE(Contains(problem, "512 MiB as numbers")) << problem;

  std::string text(2 * numbers, '1');
  for (std::size_t i = 1; i < text.size(); i += 2)
  {
    text[i] = ' ';
  }
  problem = ProblemOf(
    ".vtp", XMLFile(pointsBegin + "<DataArray type=\"Float32\" format=\"ascii\">" + text + "</DataArray>" + pointsEnd));
  EXPECT_TRUE(Contains(problem, "512 MiB as numbers")) << problem;
}

TEST(VTKSurfaceFile, IsToldByItsExtension)
{
  EXPECT_TRUE(itk::IsVTKSurfaceFileName("a/upper.vtk"));
  EXPECT_TRUE(itk::IsVTKSurfaceFileName("UPPER.VTP"));
  EXPECT_FALSE(itk::IsVTKSurfaceFileName("upper.vtk.stl"));
  EXPECT_FALSE(itk::IsVTKSurfaceFileName("vtk"));
}

TEST(ReadVTKMesh, IsAMeshOfTriangles)
{
  const auto file = WriteTestFile("scan.vtk", Scan);
  const auto mesh = itk::ReadVTKMesh<itk::Mesh<float, 3>>(file);
  ASSERT_EQ(mesh->GetNumberOfPoints(), 3u);
  ASSERT_EQ(mesh->GetNumberOfCells(), 1u);
  itk::Mesh<float, 3>::CellAutoPointer cell;
  ASSERT_TRUE(mesh->GetCell(0, cell));
  EXPECT_EQ(cell->GetPointIds()[2], 2u);
  EXPECT_EQ(mesh->GetPoint(1)[0], 1.0f);
}
} // namespace
