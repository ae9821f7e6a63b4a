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
#include "itkDentalLandmarkFileReader.h"
#include "itkDentalLandmarkFileWriter.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

using Reader2D = itk::DentalLandmarkFileReader<2>;
using Reader3D = itk::DentalLandmarkFileReader<3>;

namespace
{
template <typename TReader>
typename TReader::Pointer
MakeReader(const std::string & text)
{
  const auto reader = TReader::New();
  reader->SetFileName(itk::WriteTestFile("landmarks.json", text));
  return reader;
}
} // namespace

TEST(DentalLandmarkFileReader, ReadsBothDimensions)
{
  const auto threeD = MakeReader<Reader3D>(R"({"UR6_MB": [1, 2.5, -3], "LR1_tip": [0, 0, 0]})");
  threeD->Update();
  ASSERT_EQ(threeD->GetOutput()->GetNumberOfLandmarks(), 2u);
  EXPECT_EQ(threeD->GetOutput()->GetLandmarks()[0].name, "UR6_MB");
  EXPECT_EQ(threeD->GetOutput()->GetLandmarks()[0].tooth.GetFDI(), 16);
  EXPECT_EQ(threeD->GetOutput()->Find("UR6_MB")->point[2], -3.0);
  const auto twoD = MakeReader<Reader2D>(R"({"UR6_MB": [1, 2.5]})");
  twoD->Update();
  EXPECT_EQ(twoD->GetOutput()->Find("UR6_MB")->point[1], 2.5);
  EXPECT_TRUE(twoD->GetWarnings().empty());
}

TEST(DentalLandmarkFileReader, ReadsOnceUntilSomethingChanges)
{
  const auto   reader = MakeReader<Reader2D>(R"({"UR6_MB": [1, 2.5]})");
  unsigned int runs = 0;
  reader->AddObserver(itk::StartEvent(), [&runs](const itk::EventObject &) { ++runs; });
  reader->Update();
  reader->Update();
  EXPECT_EQ(runs, 1u);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(runs, 2u);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 1u);
}

TEST(DentalLandmarkFileReader, WrongPointsAreNamed)
{
  const auto field = [](const std::string & text) {
    const auto reader = MakeReader<Reader3D>(text);
    const auto error = itk::ExpectInputError([&] { reader->Update(); });
    EXPECT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 0u);
    return error.GetField();
  };
  EXPECT_EQ(field(R"({"UR1_tip": [1, 2, 3], "UR6_MB": [1, 2]})"), "UR6_MB");
  EXPECT_EQ(field(R"({"UR6_MB": [1, 2, "3"]})"), "UR6_MB[2]");
  EXPECT_EQ(field(R"({"UR6_MB": 1})"), "UR6_MB");
  EXPECT_EQ(field(R"({"UR6_MB": [1, 2, 3], "UR6_MB": [1, 2, 3]})"), "UR6_MB");
  EXPECT_EQ(field("[]"), "");
  EXPECT_EQ(field("{\n\"UR6_MB\": [1, 2, NaN]}"), "line 2, column 18");
}

TEST(DentalLandmarkFileReader, WhatHasNoLandmarksNameIsLeftOutWithAWarning)
{
  const auto reader = MakeReader<Reader2D>(R"({"Sella": [1, 2], "comment": "by me", "UR1_tip": [3, 4]})");
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 1u);
  ASSERT_EQ(reader->GetWarnings().size(), 2u);
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[0] + reader->GetWarnings()[1], ": Sella: "));
}

TEST(DentalLandmarkFileReader, UniversalNumbersAreRenamedAndFDIKept)
{
  const auto reader = MakeReader<Reader2D>(R"({"11_tip": [1, 2], "3_MB": [3, 4]})");
  reader->SetNumbering(itk::ToothCode::NumberingEnum::Universal);
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 2u);
  EXPECT_NE(reader->GetOutput()->Find("UL3_tip"), nullptr);
  EXPECT_NE(reader->GetOutput()->Find("UR6_MB"), nullptr);
  const auto fdi = MakeReader<Reader2D>(R"({"11_tip": [1, 2]})");
  fdi->Update();
  ASSERT_NE(fdi->GetOutput()->Find("11_tip"), nullptr);
  EXPECT_EQ(fdi->GetOutput()->Find("11_tip")->tooth.GetName(), "UR1");
}

TEST(DentalLandmarkFileReader, ReadsTheSharedCases)
{
  const std::string cases = std::string(DENTALSCR_SHARED_DIR) + "/cases";
  if (!std::filesystem::exists(cases))
  {
    GTEST_SKIP() << "no folder " << cases;
  }
  for (const auto & entry : std::filesystem::directory_iterator(cases))
  {
    if (entry.is_directory())
    {
      const auto twoD = Reader2D::New();
      twoD->SetFileName((entry.path() / "landmarks2d.json").string());
      twoD->Update();
      const auto threeD = Reader3D::New();
      threeD->SetFileName((entry.path() / "landmarks3d.json").string());
      threeD->Update();
      EXPECT_TRUE(twoD->GetWarnings().empty() && threeD->GetWarnings().empty()) << entry.path();
      EXPECT_GT(twoD->GetOutput()->GetNumberOfLandmarks(), 10u) << entry.path();
      for (const auto & landmark : twoD->GetOutput()->GetLandmarks())
      {
        EXPECT_NE(threeD->GetOutput()->Find(landmark.name), nullptr) << entry.path() << landmark.name;
      }
    }
  }
}

TEST(DentalLandmarkFileWriter, ReadsBackToTheSameBits)
{
  const auto                           landmarks = itk::DentalLandmarkSet<3>::New();
  itk::DentalLandmarkSet<3>::PointType point;
  point[0] = 1.0 / 3.0;
  point[1] = -1e-17;
  point[2] = 12345.6789;
  landmarks->AddLandmark("UR6_MB", point);
  landmarks->AddLandmark("11_tip", point);
  const auto writer = itk::DentalLandmarkFileWriter<3>::New();
  writer->SetFileName(itk::TestFolder() + "/landmarks3d.json");
  writer->SetInput(landmarks);
  writer->Update();
  const auto reader = Reader3D::New();
  reader->SetFileName(writer->GetFileName());
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_EQ(reader->GetOutput()->GetLandmarks()[i].name, landmarks->GetLandmarks()[i].name);
    EXPECT_EQ(reader->GetOutput()->GetLandmarks()[i].point, point);
  }
}

TEST(DentalLandmarkFileWriter, SaysWhatIsMissing)
{
  const auto writer = itk::DentalLandmarkFileWriter<2>::New();
  EXPECT_THROW(writer->Update(), itk::ExceptionObject);
  writer->SetFileName(itk::TestFolder());
  EXPECT_THROW(writer->Update(), itk::ExceptionObject);
  writer->SetInput(itk::DentalLandmarkSet<2>::New());
  EXPECT_EQ(itk::ExpectInputError([&] { writer->Update(); }).GetInputFile(), itk::TestFolder());
}
