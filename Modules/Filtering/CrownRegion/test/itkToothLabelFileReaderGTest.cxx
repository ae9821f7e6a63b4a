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
} // namespace
