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
#include "itkToothLabelFileReader.h"
#include "itkDentalInputError.h"

#include "itkMesh.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace
{
using ReaderType = itk::ToothLabelFileReader;

ReaderType::Pointer
MakeReader(const std::string & name, const std::string & text)
{
  const std::string file = std::string(DENTALSCR_TEST_OUTPUT_DIR) + "/" + name;
  std::ofstream(file) << text;
  auto reader = ReaderType::New();
  reader->SetFileName(file);
  return reader;
}

std::string
ErrorOf(ReaderType * reader)
{
  try
  {
    reader->Update();
  }
  catch (const itk::DentalInputError & error)
  {
    return error.GetOneLine();
  }
  return {};
}

TEST(ToothLabelFileReader, ReadsTheLabelsOfTeeth3DS)
{
  auto reader =
    MakeReader("labels-teeth3ds.json",
               R"({"id_patient": "A", "jaw": "lower", "labels": [0, 36, 36, 41], "instances": [0, 1, 1, 2]})");
  reader->SetNumberOfPoints(4);
  reader->Update();
  EXPECT_EQ(reader->GetLabels(), (ReaderType::LabelContainerType{ 0, 36, 36, 41 }));
  EXPECT_EQ(reader->GetJaw(), ReaderType::JawEnum::Lower);
}

TEST(ToothLabelFileReader, TurnsUniversalNumbersIntoFDI)
{
  // 1..16 = UR8..UL8, 17..32 = LL8..LR8; 33 is gingiva.
  auto reader = MakeReader("labels-universal.json", R"({"Universal_ID": [33, 1, 8, 9, 16, 0]})");
  reader->Update();
  EXPECT_EQ(reader->GetLabels(), (ReaderType::LabelContainerType{ 0, 18, 11, 21, 28, 0 }));
  EXPECT_EQ(reader->GetJaw(), ReaderType::JawEnum::Upper);
  reader = MakeReader("labels-said-universal.json", R"({"labels": [17, 24, 25, 32]})");
  reader->SetNumbering(ReaderType::NumberingEnum::Universal);
  reader->Update();
  EXPECT_EQ(reader->GetLabels(), (ReaderType::LabelContainerType{ 38, 31, 41, 48 }));
}

TEST(ToothLabelFileReader, NamesFileAndRemedyWhereTheCountIsNotTheMeshs)
{
  auto reader = MakeReader("labels-count.json", R"({"labels": [0, 11, 12]})");
  reader->SetNumberOfPoints(4);
  const std::string error = ErrorOf(reader);
  EXPECT_NE(error.find("labels-count.json"), std::string::npos) << error;
  EXPECT_NE(error.find("3 labels, the mesh 4 points"), std::string::npos) << error;
  EXPECT_NE(error.find("STL"), std::string::npos) << error;
}

TEST(ToothLabelFileReader, RefusesWhatIsNoLabel)
{
  EXPECT_NE(ErrorOf(MakeReader("labels-bad.json", R"({"labels": [0, 19]})")).find("labels[1]"), std::string::npos);
  EXPECT_NE(ErrorOf(MakeReader("labels-bad.json", R"({"labels": [0, 11.5]})")).find("labels[1]"), std::string::npos);
  EXPECT_NE(ErrorOf(MakeReader("labels-bad.json", R"({"labels": [-1]})")).find("labels[0]"), std::string::npos);
  EXPECT_NE(ErrorOf(MakeReader("labels-bad.json", R"({"labels": []})")).find("empty"), std::string::npos);
  EXPECT_NE(ErrorOf(MakeReader("labels-bad.json", R"({"jaw": "upper"})")).find("labels"), std::string::npos);
  EXPECT_NE(ErrorOf(MakeReader("labels-bad.json", R"({"jaw": "upper", "labels": [31]})")).find("other jaw"),
            std::string::npos);
  EXPECT_NE(ErrorOf(MakeReader("labels-bad.json", R"({"jaw": "top", "labels": [11]})")).find("jaw"), std::string::npos);
}

TEST(ToothLabelFileReader, LabelsAMesh)
{
  auto reader = MakeReader("labels-mesh.json", R"({"labels": [0, 11, 12]})");
  reader->Update();
  auto mesh = itk::Mesh<float, 3>::New();
  for (unsigned int i = 0; i < 3; ++i)
  {
    mesh->SetPoint(i, itk::Mesh<float, 3>::PointType(static_cast<float>(i)));
  }
  reader->LabelMesh(mesh.GetPointer());
  EXPECT_EQ(mesh->GetPointData()->ElementAt(2), 12.0f);
  mesh->SetPoint(3, itk::Mesh<float, 3>::PointType(3.0f));
  EXPECT_THROW(reader->LabelMesh(mesh.GetPointer()), itk::DentalInputError);
}

TEST(ToothLabelFileReader, AsksForAFileName)
{
  EXPECT_THROW(ReaderType::New()->Update(), itk::ExceptionObject);
}
constexpr const char * LegacyScan = "# vtk DataFile Version 4.2\nscan\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
                                    "0 0 0 1 0 0 0 1 0 1 1 0\nPOLYGONS 2 8\n3 0 1 2\n3 1 3 2\n";

TEST(ToothLabelFileReader, ReadsUniversalNumbersOfVTKFiles)
{
  // 1..16 = UR8..UL8, 17..32 = LL8..LR8; 33 is gingiva.
  for (const char * name : { "Universal_ID", "UniversalID", "PredictedID" })
  {
    auto reader = MakeReader("labels.vtk",
                             std::string(LegacyScan) + "POINT_DATA 4\nSCALARS " + name +
                               " int 1\nLOOKUP_TABLE default\n33 8 9 0\n");
    reader->SetNumberOfPoints(4);
    reader->Update();
    EXPECT_EQ(reader->GetLabels(), (ReaderType::LabelContainerType{ 0, 11, 21, 0 })) << name;
    EXPECT_EQ(reader->GetJaw(), ReaderType::JawEnum::Upper);
  }
  auto reader =
    MakeReader("labels.vtp",
               "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">"
               "<PolyData><Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\"><PointData>"
               "<DataArray type=\"Float64\" Name=\"PredictedID\" format=\"ascii\">17 24 32</DataArray></PointData>"
               "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0"
               "</DataArray></Points><Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2"
               "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray></Polys></Piece>"
               "</PolyData></VTKFile>");
  reader->Update();
  EXPECT_EQ(reader->GetLabels(), (ReaderType::LabelContainerType{ 38, 31, 48 }));
  EXPECT_EQ(reader->GetJaw(), ReaderType::JawEnum::Lower);
}

TEST(ToothLabelFileReader, ReadsUniversalNumbersOfPLYFiles)
{
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty int ";
  const std::string tail = "\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
                           "vertex_indices\nend_header\n0 1 0 0\n1 33 0 0\n0 16 1 0\n3 0 1 2\n";
  auto              reader = MakeReader("labels.ply", head + "UniversalID" + tail);
  reader->Update();
  EXPECT_EQ(reader->GetLabels(), (ReaderType::LabelContainerType{ 18, 0, 28 }));
  EXPECT_NE(ErrorOf(MakeReader("none.ply", head + "quality" + tail)).find("no tooth labels"), std::string::npos);
}

TEST(ToothLabelFileReader, NamesWhatIsWrongWithASurface)
{
  const auto errorOf = [](const std::string & name, const std::string & rest) {
    return ErrorOf(MakeReader(name, std::string(LegacyScan) + rest));
  };
  const std::string scalars = "SCALARS Universal_ID float 1\nLOOKUP_TABLE default\n";
  EXPECT_NE(errorOf("a.vtk", "POINT_DATA 4\n" + scalars + "33 34 1 1\n").find("Universal_ID[1]: is 34"),
            std::string::npos);
  EXPECT_NE(errorOf("b.vtk", "POINT_DATA 4\n" + scalars + "1 1 1 8.5\n").find("Universal_ID[3]: is 8.5"),
            std::string::npos);
  EXPECT_NE(errorOf("c.vtk", "POINT_DATA 4\n" + scalars + "1 1 nan 1\n").find("Universal_ID[2]: is nan"),
            std::string::npos);
  EXPECT_NE(errorOf("d.vtk", "").find("no point array Universal_ID"), std::string::npos);
  EXPECT_NE(errorOf("e.vtk", "CELL_DATA 2\n" + scalars + "1 1\n").find("point data"), std::string::npos);
  EXPECT_NE(ErrorOf(MakeReader("f.stl", "solid\n")).find("has no tooth labels"), std::string::npos);
  EXPECT_NE(ErrorOf(MakeReader("g.vtp", "x")).find("g.vtp"), std::string::npos);
}
} // namespace
