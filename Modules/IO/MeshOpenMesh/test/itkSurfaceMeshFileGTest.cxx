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

#include <gtest/gtest.h>

#include <locale>
#include <set>

namespace
{
using itk::MeshFileFormatEnum;
using itk::SurfaceMeshFile;

SurfaceMeshFile
Parse(const std::string & bytes, const std::string & name = "scan")
{
  return itk::ParseSurfaceMesh(bytes.data(), bytes.size(), name);
}

std::string
MessageOf(const std::string & bytes, const std::string & name)
{
  try
  {
    Parse(bytes, name);
  }
  catch (const itk::SurfaceMeshFileError & error)
  {
    EXPECT_FALSE(error.remedy.empty());
    return error.what();
  }
  return "nothing thrown";
}

/** The facets as sets of corner coordinates, whatever the numbering. */
std::multiset<std::array<std::array<double, 3>, 3>>
Corners(const SurfaceMeshFile & surface)
{
  std::multiset<std::array<std::array<double, 3>, 3>> corners;
  for (const auto & triangle : surface.triangles)
  {
    std::array<std::array<double, 3>, 3> facet;
    for (std::size_t c = 0; c < 3; ++c)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        facet[c][d] = surface.floatPoints.empty() ? surface.doublePoints.at(triangle[c])[d]
                                                  : static_cast<double>(surface.floatPoints.at(triangle[c])[d]);
      }
    }
    corners.insert(facet);
  }
  return corners;
}

std::string
Replaced(std::string text, const std::string & what, const std::string & by)
{
  const std::size_t position = text.find(what);
  EXPECT_NE(position, std::string::npos) << what;
  return text.replace(position, what.size(), by);
}

std::string
WithWindowsLines(const std::string & text)
{
  std::string result;
  for (const char character : text)
  {
    result += character == '\n' ? std::string("\r\n") : std::string(1, character);
  }
  return result;
}

/** A decimal comma and points between thousands. */
struct CommaPunctuation : public std::numpunct<char>
{
  char
  do_decimal_point() const override
  {
    return ',';
  }
  char
  do_thousands_sep() const override
  {
    return '.';
  }
  std::string
  do_grouping() const override
  {
    return "\3";
  }
};
} // namespace

TEST(SurfaceMeshFile, EveryFormatHoldsTheSameTetrahedron)
{
  const auto expected = Corners(Parse(mesh_file_bytes::BinarySTL(mesh_file_bytes::TetrahedronFacets())));
  ASSERT_EQ(expected.size(), 4u);
  const std::pair<std::string, MeshFileFormatEnum> files[] = {
    { mesh_file_bytes::TetrahedronAsciiSTL(), MeshFileFormatEnum::AsciiSTL },
    { mesh_file_bytes::TetrahedronOBJ(), MeshFileFormatEnum::OBJ },
    { mesh_file_bytes::TetrahedronOFF(), MeshFileFormatEnum::OFF },
    { mesh_file_bytes::TetrahedronPLY(), MeshFileFormatEnum::PLY },
    { mesh_file_bytes::TetrahedronBinaryPLY(false), MeshFileFormatEnum::PLY },
    { mesh_file_bytes::TetrahedronBinaryPLY(true), MeshFileFormatEnum::PLY }
  };
  for (const auto & file : files)
  {
    const SurfaceMeshFile surface = Parse(file.first);
    EXPECT_EQ(surface.format, file.second);
    EXPECT_EQ(surface.GetNumberOfPoints(), 4u) << file.second;
    EXPECT_EQ(surface.numberOfFacesInFile, 4u) << file.second;
    EXPECT_EQ(surface.numberOfDegenerateFaces, 0u) << file.second;
    EXPECT_EQ(Corners(surface), expected) << file.second;
  }
  for (const std::string & text : { mesh_file_bytes::TetrahedronAsciiSTL(),
                                    mesh_file_bytes::TetrahedronOBJ(),
                                    mesh_file_bytes::TetrahedronOFF(),
                                    mesh_file_bytes::TetrahedronPLY() })
  {
    EXPECT_EQ(Corners(Parse(WithWindowsLines(text))), expected);
    EXPECT_EQ(Corners(Parse(text.substr(0, text.size() - 1))), expected) << "without a last line's end";
  }
}

TEST(SurfaceMeshFile, TheProgramsLocaleDoesNotMatter)
{
  const auto        expected = Corners(Parse(mesh_file_bytes::BinarySTL(mesh_file_bytes::TetrahedronFacets())));
  const std::string texts[] = { mesh_file_bytes::TetrahedronAsciiSTL(),
                                mesh_file_bytes::TetrahedronOBJ(),
                                mesh_file_bytes::TetrahedronOFF(),
                                mesh_file_bytes::TetrahedronPLY() };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
  for (const std::string & text : texts)
  {
    EXPECT_EQ(Corners(Parse(text)), expected);
  }
  std::locale::global(before);
}

TEST(SurfaceMeshFile, IndexedFormatsKeepPointsTheirOrderAndDuplicates)
{
  const SurfaceMeshFile surface = Parse("v 5 0 0\nv 1 0 0\nv 1 0 0\nv 0 1 0\nf 4 2 1\nf 4 3 1\n");
  ASSERT_EQ(surface.doublePoints.size(), 4u);
  EXPECT_EQ(surface.doublePoints[0][0], 5.0);
  EXPECT_EQ(surface.doublePoints[1], surface.doublePoints[2]);
  EXPECT_EQ(surface.triangles[0], (SurfaceMeshFile::TriangleType{ 3, 1, 0 }));
  EXPECT_EQ(surface.triangles[1], (SurfaceMeshFile::TriangleType{ 3, 2, 0 }));
}

TEST(SurfaceMeshFile, KeepsFacesThatAreNotManifold)
{
  // Three faces on one edge, one of them twice, and one turned over.
  const SurfaceMeshFile surface =
    Parse("OFF\n5 5 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 1 4\n3 0 1 4\n3 1 0 4\n");
  EXPECT_EQ(surface.triangles.size(), 5u);
}

TEST(SurfaceMeshFile, SplitsPolygonsIntoFansAndDropsWhatNamesAPointTwice)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 0.5 0\n";
  const auto        quad = Parse(points + "f 1 2 3 4\n");
  EXPECT_EQ(quad.numberOfFacesInFile, 1u);
  EXPECT_EQ(quad.triangles,
            (std::vector<SurfaceMeshFile::TriangleType>{ SurfaceMeshFile::TriangleType{ 0, 1, 2 },
                                                         SurfaceMeshFile::TriangleType{ 0, 2, 3 } }));
  EXPECT_EQ(Parse(points + "f 1 2 3 4 5\n").triangles.size(), 3u);
  const auto repeated = Parse(points + "f 1 2 3\nf 1 1 2\nf 1 2 2 3\n");
  EXPECT_EQ(repeated.triangles.size(), 2u);
  EXPECT_EQ(repeated.numberOfDegenerateFaces, 2u);
}

TEST(SurfaceMeshFile, ReadsObjAsProgramsWriteIt)
{
  // A byte order mark, a continued line, colours after the coordinates, a face before its points, vendor records.
  const auto surface =
    Parse("\xEF\xBB\xBFv +1.5e0 -0 .5 0.1 0.2 0.3\nf 1 2 \\\n 3\nv 0 1 0\nlod 3\nv 0 0 1 1.0\nl 1 2\n");
  EXPECT_EQ(surface.triangles.size(), 1u);
  EXPECT_EQ(surface.doublePoints[0], (std::array<double, 3>{ 1.5, 0.0, 0.5 }));
}

TEST(SurfaceMeshFile, ReadsOffWithCommentsColoursAndCountsBesideTheWord)
{
  const auto surface =
    Parse("# a\nCOFF 3 1 # counts\n\n0 0 0 255 0 0 255 # red\n1 0 0 1 1 1 1\n\n0 1 0 0 0 0 0\n# faces\n"
          "3 0 1 2 0.5 0.5 0.5\n# end\n");
  EXPECT_EQ(surface.triangles.size(), 1u);
}

TEST(SurfaceMeshFile, ReadsSeveralAsciiSolidsAndNormalsThatAreNoNumbers)
{
  std::string text = mesh_file_bytes::TetrahedronAsciiSTL();
  text += Replaced(text, "normal 0 0 0", "NORMAL nan -nan(ind) 1.#IND");
  EXPECT_EQ(Parse(text).triangles.size(), 8u);
  EXPECT_EQ(Parse(text).GetNumberOfPoints(), 4u);
}

TEST(SurfaceMeshFile, TinyNumbersAreZeroNotErrors)
{
  EXPECT_EQ(Parse("v 1e-999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").doublePoints[0][0], 0.0);
}

TEST(SurfaceMeshFile, SaysWhatIsWrongAndWhere)
{
  const std::string asciiSTL = mesh_file_bytes::TetrahedronAsciiSTL();
  const std::string off = mesh_file_bytes::TetrahedronOFF();
  const std::string obj = mesh_file_bytes::TetrahedronOBJ();
  const std::string ply = mesh_file_bytes::TetrahedronPLY();
  const std::string binaryPLY = mesh_file_bytes::TetrahedronBinaryPLY(false);
  const struct
  {
    std::string  bytes;
    const char * name;
    const char * message;
  } rows[] = {
    { "", "a.stl", "the file is empty (0 bytes)" },
    { "hello world", "a.txt", "neither its content nor its extension is of a known mesh format" },
    { std::string(100, '\1'), "a", "neither its content nor its extension is of a known mesh format" },
    { std::string(83, '\1'), "a.stl", "has 83 bytes; a binary STL has at least 84" },
    { asciiSTL.substr(0, 200), "a.stl", "is expected: it is truncated" },
    { asciiSTL.substr(0, asciiSTL.size() - 21), "a.stl", "the file ends before \"endsolid\": it is truncated" },
    { "solid x\nendsolid x\n", "a.stl", "has no triangles" },
    { "solid x\n", "a.stl", "line 2: the file ends before \"endsolid\"" },
    { Replaced(asciiSTL, "2.25", "nan "), "a.stl", "line 5: a coordinate is not a number" },
    { Replaced(asciiSTL, "2.25", "1e39"),
      "a.stl",
      "line 5: a coordinate \"1e390000\" is infinite in single precision" },
    { Replaced(asciiSTL, "2.25", "2,25"), "a.stl", "line 5: \"2,250000\" is no number for a coordinate" },
    { Replaced(asciiSTL, "endloop", "vertex "), "a.stl", "line 7: \"vertex\" where \"endloop\" is expected" },
    { asciiSTL + "trailing", "a.stl", "\"trailing\" after the end of the solid" },
    { "# only a comment\n", "a.obj", "has no triangles" },
    { "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj", "has no triangles" },
    { Replaced(obj, "f 1 3 2", "f 1 3 5"), "a.obj", "line 13: a face names point 5, the file has 4" },
    { Replaced(obj, "f 1 3 2", "f 1 3 0"), "a.obj", "line 13: a face names point 0 of 4" },
    { Replaced(obj, "f 1 3 2", "f 1 3 -5"), "a.obj", "line 13: a face names point -5 of 4" },
    { Replaced(obj, "f 1 3 2", "f 1 3 99999999999"), "a.obj", "line 13: a face names point 99999999999 of 4" },
    { Replaced(obj, "f 1 3 2", "f 1 3 99999999999999999999"), "a.obj", "is no whole number for a point's index" },
    { Replaced(obj, "f 1 3 2", "f 1 3"), "a.obj", "line 13: a face has 2 corners" },
    { Replaced(obj, "f 1 3 2", "f 1 3 2/x"), "a.obj", "line 13: \"2/x\" is no corner of a face" },
    { Replaced(obj, "v 1.5 0 0", "v 1.5 0"), "a.obj", "line 5: lacks a coordinate" },
    { Replaced(obj, "v 1.5 0 0", "v 1.5 inf 0"), "a.obj", "line 5: a coordinate \"inf\" is infinite" },
    { Replaced(obj, "v 1.5 0 0", "\x01\x02 1.5"), "a.obj", "line 5: \"??\" is no OBJ record" },
    { "v 0 0 0\nv 1 0 0\nf 1 1 2\n", "a.obj", "all of its 1 faces name a point twice" },
    { "PK\x03\x04" + ply, "a.ply", "does not begin with \"ply\"" },
    { Replaced(ply, "ply", "plx"), "a.ply", "does not begin with \"ply\"" },
    { Replaced(off, "4 4 6", "4 5 6"), "a.off", "the file ends before face 5 of 5" },
    { Replaced(off, "4 4 6", "4 3 6"), "a.off", "line 10: there is more after the 4 points and 3 faces" },
    { Replaced(off, "4 4 6", "5 4 6"), "a.off", "the file ends before face 4 of 4" },
    { Replaced(off, "4 4 6", "4 0 6").substr(0, 41), "a.off", "has no triangles" },
    { Replaced(off, "4 4 6", "4 -4 6"), "a.off", "promises 4 points and -4 faces" },
    { Replaced(off, "4 4 6", "4000000000000 4 6"),
      "a.off",
      "line 2: the header promises 4000000000000 points and 4 faces, more than" },
    { Replaced(off, "3 1 2 3", "3 1 2 4"), "a.off", "line 10: a face names point 4 of 4" },
    { Replaced(off, "3 1 2 3", "9 1 2 3"), "a.off", "line 10: lacks a point's index" },
    { Replaced(off, "3 1 2 3", "2 1 2"), "a.off", "line 10: a face has 2 corners" },
    { Replaced(off, "OFF", "OFF BINARY"), "a.off", "line 1: binary OFF is not supported" },
    { Replaced(off, "OFF", "4OFF"), "a.off", "line 1: \"4OFF\" has points that are not three-dimensional" },
    { "OFF\n", "a.off", "lacks the number of points" },
    { "ply\n", "a.ply", "the file ends before \"end_header\"" },
    { Replaced(ply, "vertex 4", "vertex 5"), "a.ply", "line 15: a face has 1 corners" },
    { Replaced(ply, "vertex 4", "vertex 3"), "a.ply", "line 14: a face has 0 corners" },
    { Replaced(ply, "face 4", "face 5"), "a.ply", "the file is truncated" },
    { Replaced(ply, "face 4", "face 3"), "a.ply", "line 18: there is more than the header promises" },
    { Replaced(ply, "face 4", "face 0").substr(0, ply.size() - 32), "a.ply", "has no triangles" },
    { Replaced(ply, "vertex 4", "vertex 4000000000"), "a.ply", "header: promises 4000000000 records of \"vertex\"" },
    { Replaced(ply, "vertex 4", "vertex -1"), "a.ply", "line 4: the count -1 is negative" },
    { Replaced(ply, "3 1 2 3", "3 1 2 4"), "a.ply", "line 18: a face names point 4 of 4" },
    { Replaced(ply, "3 1 2 3", "3 1 2 -1"), "a.ply", "line 18: a face names point -1 of 4" },
    { Replaced(ply, "3 1 2 3", "1 1"), "a.ply", "line 18: a face has 1 corners" },
    { Replaced(ply, "property float z", "property float w"), "a.ply", "element vertex: has no property \"z\"" },
    { Replaced(ply, "float z", "quad z"), "a.ply", "line 7: \"quad\" is no PLY type" },
    { Replaced(ply, "vertex_indices", "corner_indices"), "a.ply", "element face: has no list of integers" },
    { Replaced(ply, "element face", "element tristrips"), "a.ply", "header: there is no element \"face\"" },
    { Replaced(ply, "ascii", "binary"), "a.ply", "line 2: \"binary\" is no PLY format" },
    { Replaced(ply, "1.5", "NaN"), "a.ply", "line 12: a coordinate is not a number" },
    { binaryPLY.substr(0, binaryPLY.size() - 1), "a.ply", "face 4: the file is truncated" },
    { binaryPLY + '\0', "a.ply", "has 1 bytes more than the header promises" }
  };
  for (const auto & row : rows)
  {
    const std::string message = MessageOf(row.bytes, row.name);
    EXPECT_NE(message.find(row.message), std::string::npos) << message << "\nlacks: " << row.message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(SurfaceMeshFile, BinaryPlyNamesTheVertexThatIsNotFinite)
{
  std::string bytes = mesh_file_bytes::TetrahedronBinaryPLY(false);
  // z of the third vertex; 8 + 1 + 4 + 2 + 2 + 4 bytes each after the camera's 13.
  const std::size_t position = bytes.find("end_header\n") + 11 + 13 + 2 * 21;
  bytes.replace(position, 8, std::string("\0\0\0\0\0\0\xf8\x7f", 8));
  EXPECT_EQ(MessageOf(bytes, "a.ply"), "vertex 3: a coordinate is not a number");
}
