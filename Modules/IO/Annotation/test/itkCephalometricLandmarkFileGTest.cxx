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
#include "itkCephalometricLandmarkFileReader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalLandmarkFileReader.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <zip.h>

#include <fstream>
#include <iterator>

namespace
{
using ReaderType = itk::CephalometricLandmarkFileReader;
using FormatEnum = itk::AnnotationFileFormatEnum;

ReaderType::Pointer
MakeReader(const std::string & name, const std::string & text)
{
  const auto reader = ReaderType::New();
  reader->SetFileName(itk::WriteTestFile(name, text));
  return reader;
}

ReaderType::Pointer
Read(const std::string & name, const std::string & text)
{
  const auto reader = MakeReader(name, text);
  reader->Update();
  return reader;
}

/** Whether the landmark is there, at that place. */
void
ExpectAt(const ReaderType * reader, const std::string & name, double u, double v)
{
  const auto * landmark = reader->GetOutput()->Find(name);
  ASSERT_NE(landmark, nullptr) << name;
  EXPECT_DOUBLE_EQ(landmark->point[0], u) << name;
  EXPECT_DOUBLE_EQ(landmark->point[1], v) << name;
}

itk::DentalInputError
ErrorOf(const std::string & name, const std::string & text)
{
  const auto reader = MakeReader(name, text);
  const auto error = itk::ExpectInputError([&] { reader->Update(); });
  // Nothing is given out of a file that is wrong in part.
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 0u);
  return error;
}

/** A file of ISBI 2015: landmark n at (100 n, 10 n), then the classes. */
std::string
MakeISBI(int landmarks = 19)
{
  std::string text;
  for (int i = 1; i <= landmarks; ++i)
  {
    text += std::to_string(100 * i) + "," + std::to_string(10 * i) + "\n";
  }
  return text + "1\n2\n1\n1\n3\n1\n4\n2\n";
}

/** A table of CL-Detection with so many radiographs: point n at (n, n + 0.5). */
std::string
MakeCLDetection(int radiographs = 1)
{
  std::string text = "file,scale";
  for (int i = 1; i <= 38; ++i)
  {
    text += ",p" + std::to_string(i) + "x,p" + std::to_string(i) + "y";
  }
  for (int k = 0; k < radiographs; ++k)
  {
    text += "\nimage.bmp,0.1";
    for (int i = 1; i <= 38; ++i)
    {
      text += "," + std::to_string(i) + "," + std::to_string(i) + ".5";
    }
  }
  return text + "\n";
}
/** An archive as WebCeph writes it: the pictures first, then the index. */
std::string
WriteWebCeph(const std::string & name, const std::string & index, const std::string & indexName = "index.json")
{
  const std::string path = itk::TestFolder() + '/' + name;
  zipFile           archive = zipOpen64(path.c_str(), APPEND_STATUS_CREATE);
  const auto        add = [&](const std::string & entry, const std::string & content) {
    EXPECT_EQ(zipOpenNewFileInZip(
                archive, entry.c_str(), nullptr, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED, Z_DEFAULT_COMPRESSION),
              ZIP_OK);
    EXPECT_EQ(zipWriteInFileInZip(archive, content.data(), static_cast<unsigned int>(content.size())), ZIP_OK);
    EXPECT_EQ(zipCloseFileInZip(archive), ZIP_OK);
  };
  std::string noise(9000, '\0');
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    noise[i] = static_cast<char>((i * 2654435761u) >> 13);
  }
  add("images/image_1", noise);
  add(indexName, index);
  EXPECT_EQ(zipClose(archive, nullptr), ZIP_OK);
  return path;
}

/** A picture of the index with its landmarks. */
std::string
WebCephPicture(const std::string & name, const std::string & type, const std::string & landmarks, bool flipped = false)
{
  return R"({"name": ")" + name + R"(", "type": )" + type + R"(, "flipX": )" + (flipped ? "true" : "false") +
         R"(, "flipY": false, "tracing": {"mode": "assisted", "scaleFactor": null, "manualLandmarks": )" + landmarks +
         R"(, "skippedSteps": {}}})";
}

std::string
WebCephIndex(const std::string & pictures)
{
  return R"({"version": 1, "refs": {"thumbs": {}, "images": {"image_1": "images/image_1"}}, "data": {)" + pictures +
         "}}";
}
} // namespace

TEST(CephalometricLandmarkFileReader, ReadsOwnFormWithAndWithoutSigma)
{
  const auto reader = Read("own.json",
                           R"({"U1_tip": [569.5, 643.25], "Ms": {"position": [464, 613], "sigma_px": 2.5},
                               "Ii": {"position": [1, 2], "confidence": 0.25}})");
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::DentalSCR);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 3u);
  ExpectAt(reader, "U1_tip", 569.5, 643.25);
  ExpectAt(reader, "U6_mesial", 464.0, 613.0);
  EXPECT_EQ(reader->GetOutput()->Find("U6_mesial")->name, "Ms");
  EXPECT_EQ(reader->GetOutput()->Find("U6_mesial")->sigma, 2.5);
  EXPECT_EQ(reader->GetOutput()->Find("U1_tip")->sigma, 0.0);
  EXPECT_LT(reader->GetOutput()->Find("U1_tip")->confidence, 0.0);
  EXPECT_EQ(reader->GetOutput()->Find("L1_tip")->confidence, 0.25);
  EXPECT_TRUE(reader->GetWarnings().empty());
}

TEST(CephalometricLandmarkFileReader, ReadsAarizByItsSymbols)
{
  const auto reader = Read("aariz.json", R"({"ceph_id": "cks2ip8fq29yq0yufc4scftj8", "landmarks": [
    {"landmark_id": "a", "title": "A-point", "symbol": "A", "value": {"x": 1421, "y": 1193}},
    {"landmark_id": "b", "title": "Upper Incisor Tip", "symbol": "UIT", "value": {"x": 1472, "y": 1459}},
    {"landmark_id": "c", "title": "Lower Molar Cusp Tip", "symbol": "LMT", "value": {"x": 1150, "y": 1467}},
    {"landmark_id": "d", "title": "Lower Incisor Tip", "symbol": "?", "value": {"x": 1450, "y": 1441}},
    {"landmark_id": "e", "title": "Upper Incisor Apex", "symbol": "UIA", "value": {"x": 1380, "y": 1222}}]})");
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::Aariz);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 4u);
  ExpectAt(reader, "U1_tip", 1472.0, 1459.0);
  ExpectAt(reader, "L6_MB", 1150.0, 1467.0);
  // Where the symbol says nothing the title may.
  ExpectAt(reader, "L1_tip", 1450.0, 1441.0);
  ExpectAt(reader, "U1_apex", 1380.0, 1222.0);
  ASSERT_EQ(reader->GetWarnings().size(), 1u);
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[0], "left out: A"));
}

TEST(CephalometricLandmarkFileReader, ReadsDetectorsWithTheirConfidence)
{
  const auto reader = Read("detector.json", R"({"image": "a.png", "landmarks": [
    {"name": "U1_tip", "x": 10.5, "y": 20, "peak": 0.68, "confidence": "high"},
    {"name": "L1_tip", "x": 11, "y": 21, "confidence": "low"},
    {"name": "U6_MB", "x": 12, "y": 22, "peak": 0.9, "confidence": 0.4},
    {"name": "L6_MB", "x": null, "y": null, "peak": 0.01},
    {"name": "U1_apex", "x": 13, "y": 23, "confidence": "medium"},
    {"name": "Sella", "x": "?", "y": 0}]})");
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::LandmarkDetector);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 4u);
  ExpectAt(reader, "U1_tip", 10.5, 20.0);
  // A number says more than a word, and "confidence" more than "peak".
  EXPECT_EQ(reader->GetOutput()->Find("U1_tip")->confidence, 0.68);
  EXPECT_EQ(reader->GetOutput()->Find("U6_MB")->confidence, 0.4);
  const double low = reader->GetOutput()->Find("L1_tip")->confidence;
  const double medium = reader->GetOutput()->Find("U1_apex")->confidence;
  EXPECT_TRUE(0.0 < low && low < medium && medium < 1.0);
  ASSERT_EQ(reader->GetWarnings().size(), 2u);
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[0], "landmarks[3]: \"L6_MB\" was not found"));
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[1], "left out: Sella"));
}

TEST(CephalometricLandmarkFileReader, ReadsISBI2015)
{
  const auto reader = Read("150.txt", MakeISBI());
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::ISBI2015);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 2u);
  ExpectAt(reader, "L1_tip", 1100.0, 110.0);
  ExpectAt(reader, "U1_tip", 1200.0, 120.0);
  EXPECT_EQ(reader->GetWarnings().size(), 1u);
}

TEST(CephalometricLandmarkFileReader, ReadsCLDetection)
{
  const auto reader = Read("train.csv", MakeCLDetection());
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::CLDetection);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 6u);
  ExpectAt(reader, "L1_tip", 11.0, 11.5);
  ExpectAt(reader, "U1_tip", 12.0, 12.5);
  ExpectAt(reader, "U1_apex", 21.0, 21.5);
  ExpectAt(reader, "L1_apex", 22.0, 22.5);
  ExpectAt(reader, "U6_mesial", 37.0, 37.5);
  ExpectAt(reader, "L6_mesial", 38.0, 38.5);
}

TEST(CephalometricLandmarkFileReader, ReadsWhatLandmarkFilesAreReadAs)
{
  const auto csv = Read("points.csv", "label,x,y\nIs,569.5,643\nNasion,1,2\n16_MB,464,613\n");
  EXPECT_EQ(csv->GetReadFileFormat(), FormatEnum::CSV);
  ASSERT_EQ(csv->GetOutput()->GetNumberOfLandmarks(), 2u);
  ExpectAt(csv, "U1_tip", 569.5, 643.0);
  ExpectAt(csv, "UR6_MB", 464.0, 613.0);

  const auto spelled =
    Read("spelled.csv", "label,x,y\n1.6_MB,464,613\ntooth 11_tip,1,2\n46 MB,3,4\n31 incisal edge,5,6\nU6 MB,7,8\n");
  EXPECT_TRUE(spelled->GetWarnings().empty());
  ExpectAt(spelled, "UR6_MB", 464.0, 613.0);
  ExpectAt(spelled, "UR1_tip", 1.0, 2.0);
  ExpectAt(spelled, "LR6_MB", 3.0, 4.0);
  ExpectAt(spelled, "LL1_tip", 5.0, 6.0);
  ExpectAt(spelled, "U6_MB", 7.0, 8.0);

  // labelme counts from the pixel's corner.
  const auto labelme = Read("labelme.json", R"({"imageWidth": 703, "imageHeight": 938, "shapes": [
    {"label": "U1_tip", "shape_type": "point", "points": [[570, 643.5]]},
    {"label": "Sella", "shape_type": "point", "points": [[70, 43.5]]}]})");
  EXPECT_EQ(labelme->GetReadFileFormat(), FormatEnum::Labelme);
  ASSERT_EQ(labelme->GetOutput()->GetNumberOfLandmarks(), 1u);
  ExpectAt(labelme, "U1_tip", 569.5, 643.0);

  // Slicer's are in mm, RAS.
  const auto slicer = MakeReader("F.mrk.json", R"({"markups": [{"type": "Fiducial", "coordinateSystem": "RAS",
    "controlPoints": [{"label": "L6_MB", "position": [-50, -60, 0]}]}]})");
  ReaderType::VectorType spacing;
  spacing.Fill(0.25);
  slicer->SetMarkupsSpacing(spacing);
  slicer->Update();
  EXPECT_EQ(slicer->GetReadFileFormat(), FormatEnum::SlicerMarkups);
  ExpectAt(slicer, "L6_MB", 200.0, 240.0);
}

TEST(CephalometricLandmarkFileReader, ReadsAnObjectOfAnotherDocument)
{
  const auto document = itk::JsonDocument::Parse(
    R"({"landmarks": {"U1_tip": [5, 6], "Nasion": [7, 8]}, "wrong": {"U1_tip": [5]}})", "case.json");
  const auto reader = ReaderType::New();
  reader->SetJsonNode(document.GetRoot().Get("landmarks"));
  reader->Update();
  ExpectAt(reader, "U1_tip", 5.0, 6.0);
  ASSERT_EQ(reader->GetWarnings().size(), 1u);
  EXPECT_EQ(reader->GetWarnings()[0], "case.json: landmarks: no dental landmarks, left out: Nasion");
  reader->SetJsonNode(document.GetRoot().Get("wrong"));
  const auto error = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_EQ(error.GetInputFile(), "case.json");
  EXPECT_EQ(error.GetField(), "wrong.U1_tip");
}

TEST(CephalometricLandmarkFileReader, NumbersOfTeethAreReadByTheNumbering)
{
  const auto reader = MakeReader("universal.json", R"({"3_MB": [1, 2]})");
  reader->SetNumbering(itk::ToothCode::NumberingEnum::Universal);
  reader->Update();
  ExpectAt(reader, "UR6_MB", 1.0, 2.0);
}

TEST(CephalometricLandmarkFileReader, WhatIsNoDentalLandmarkIsNotLookedAt)
{
  const auto reader = Read(
    "own.json", R"({"U1_tip": [1, 2], "Sella": "not seen", "N": [1, 2, 3], "patient": {"name": "x"}, "Ii": null})");
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 1u);
  ASSERT_EQ(reader->GetWarnings().size(), 2u);
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[0], "Ii: is not marked"));
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[1], "left out: Sella, N, patient"));
}

TEST(CephalometricLandmarkFileReader, ASigmaBesideADetectorsPlaceIsRead)
{
  const auto reader =
    Read("detector.json", R"({"landmarks": [{"name": "U1_tip", "x": 1, "y": 2, "peak": 0.5, "sigma_px": 3}]})");
  EXPECT_EQ(reader->GetOutput()->Find("U1_tip")->sigma, 3.0);
  EXPECT_EQ(reader->GetOutput()->Find("U1_tip")->confidence, 0.5);
}

TEST(CephalometricLandmarkFileReader, NamesTheFieldThatIsWrong)
{
  EXPECT_EQ(ErrorOf("a.json", R"({"U1_tip": [1, 2], "U6_MB": [1, 2, 3]})").GetField(), "U6_MB");
  EXPECT_EQ(ErrorOf("a.json", R"({"U1_tip": [1, "2"]})").GetField(), "U1_tip[1]");
  EXPECT_EQ(ErrorOf("a.json", R"({"U1_tip": {"sigma_px": 1}})").GetField(), "U1_tip.position");
  EXPECT_EQ(ErrorOf("a.json", R"({"U1_tip": {"position": [1, 2], "sigma_px": 0}})").GetField(), "U1_tip.sigma_px");
  EXPECT_EQ(ErrorOf("a.json", R"({"landmarks": [{"name": "U1", "x": 1, "y": 2, "sigma_px": 0}]})").GetField(),
            "landmarks[0].sigma_px");
  EXPECT_EQ(ErrorOf("a.json", R"({"landmarks": [{"name": "U1", "x": 1, "y": 2, "confidence": 68}]})").GetField(),
            "landmarks[0].confidence");
  EXPECT_EQ(ErrorOf("a.json", R"({"landmarks": [{"name": "U1", "x": 1, "y": 2, "confidence": "fair"}]})").GetField(),
            "landmarks[0].confidence");
  EXPECT_EQ(ErrorOf("a.json", R"({"landmarks": [{"name": "U1", "x": 1}]})").GetField(), "landmarks[0].y");
  EXPECT_EQ(ErrorOf("a.json", R"({"landmarks": [{"x": 1, "y": 2}]})").GetField(), "landmarks[0].name");
  EXPECT_EQ(ErrorOf("a.json", R"({"landmarks": [{"symbol": "UIT", "value": {"x": 1}}]})").GetField(),
            "landmarks[0].value.y");
  EXPECT_EQ(ErrorOf("a.csv", "U1_tip,1\n").GetField(), "line 1");
  EXPECT_TRUE(itk::Contains(ErrorOf("a.json", "[[1, 2]]").GetOneLine(), "U1_tip"));
}

TEST(CephalometricLandmarkFileReader, TwoNamesOfOnePointAreAnError)
{
  const auto error = ErrorOf("a.json", R"({"Is": [1, 2], "UIT": [1, 2]})");
  EXPECT_EQ(error.GetField(), "UIT");
  EXPECT_TRUE(itk::Contains(error.GetOneLine(), "same point as \"Is\""));
  EXPECT_TRUE(itk::Contains(error.GetOneLine(), "keep one"));
}

TEST(CephalometricLandmarkFileReader, NoDentalLandmarkAtAllIsAnErrorWithExamples)
{
  for (const char * text : { "{}", R"({"Sella": [1, 2]})", R"({"landmarks": []})" })
  {
    const std::string line = ErrorOf("a.json", text).GetOneLine();
    EXPECT_TRUE(itk::Contains(line, "no dental landmark") && itk::Contains(line, "U6_MB")) << line;
  }
  EXPECT_TRUE(itk::Contains(ErrorOf("a.json", R"({"Sella": [1, 2]})").GetOneLine(), "there are Sella"));
}

TEST(CephalometricLandmarkFileReader, FilesOfChallengesThatAreNoneSayWhatToWriteInstead)
{
  EXPECT_TRUE(itk::Contains(ErrorOf("a.txt", MakeISBI(18)).GetOneLine(), "18 lines"));
  EXPECT_TRUE(itk::Contains(ErrorOf("a.txt", MakeISBI() + "Is,4,5\n").GetOneLine(), "line 28"));
  EXPECT_TRUE(itk::Contains(ErrorOf("a.csv", MakeCLDetection(2)).GetOneLine(), "2 radiographs"));
  EXPECT_TRUE(itk::Contains(ErrorOf("a.csv", "file,scale,p1x,p1y\na.bmp,0.1,3,4\n").GetOneLine(), "label,x,y"));
}

TEST(CephalometricLandmarkFileReader, OtherReadersSayThatTheFormatIsNotTheirs)
{
  const std::string file = itk::WriteTestFile("150.txt", MakeISBI());
  const auto        contours = itk::DentalContourFileReader::New();
  contours->SetFileName(file);
  contours->SetFileFormat(FormatEnum::ISBI2015);
  EXPECT_TRUE(itk::Contains(itk::ExpectInputError([&] { contours->Update(); }).GetOneLine(), "ISBI2015"));
  const auto landmarks = itk::DentalLandmarkFileReader<2>::New();
  landmarks->SetFileName(file);
  landmarks->SetFileFormat(FormatEnum::Aariz);
  EXPECT_TRUE(itk::Contains(itk::ExpectInputError([&] { landmarks->Update(); }).GetOneLine(), "Aariz"));
}

TEST(CephalometricLandmarkFileReader, ReadsWebCephsArchive)
{
  const std::string four = R"({"U1 Incisal Edge": {"x": 570.0, "y": 643.5}, "L1 Incisal Edge": {"x": 557, "y": 622},
    "U1 Apex": {"x": 530, "y": 560}, "U6": {"x": 464, "y": 614}, "S": {"x": 1, "y": 2},
    "L6": {"x1": 1, "y1": 2, "x2": 3, "y2": 4}})";
  const auto        reader = ReaderType::New();
  reader->SetFileName(WriteWebCeph(
    "one.wceph",
    WebCephIndex(R"("a": )" + WebCephPicture("face.jpg", R"("photo_lateral")", R"({"U1": {"x": 9, "y": 9}})") +
                 R"(, "b": )" + WebCephPicture("ceph.png", "null", four, true) + R"(, "c": )" +
                 WebCephPicture("later.png", R"("ceph_lateral")", "{}"))));
  reader->Update();
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::WebCeph);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 4u);
  // Counted from the picture's corner, and not turned: flipX is how it is shown.
  ExpectAt(reader, "U1_tip", 569.5, 643.0);
  ExpectAt(reader, "L1_tip", 556.5, 621.5);
  ExpectAt(reader, "U1_apex", 529.5, 559.5);
  EXPECT_EQ(reader->GetOutput()->GetLandmarks()[3].name, "U6");
  ASSERT_EQ(reader->GetWarnings().size(), 2u);
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[0], "mirrored"));
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[1], "left out: S, L6")) << reader->GetWarnings()[1];
}

TEST(CephalometricLandmarkFileReader, OfWebCephsPicturesTakesTheRadiographs)
{
  const auto picture = [](const char * name, const char * x) {
    return WebCephPicture(name, R"("ceph_lateral")", std::string(R"({"U1": {"x": )") + x + R"(, "y": 9}})");
  };
  const std::string path = WriteWebCeph(
    "two.wceph", WebCephIndex(R"("a": )" + picture("before.png", "10") + R"(, "b": )" + picture("after.png", "20")));
  const auto reader = ReaderType::New();
  reader->SetFileName(path);
  const auto error = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_TRUE(itk::Contains(error.GetOneLine(), "before.png")) << error.GetOneLine();
  reader->SetImageFileName("/somewhere/after.png");
  reader->Update();
  ExpectAt(reader, "U1_tip", 19.5, 8.5);
}

TEST(CephalometricLandmarkFileReader, RefusesArchivesThatAreNotWebCephsInWords)
{
  const auto errorOf = [](const std::string & path) {
    const auto reader = ReaderType::New();
    reader->SetFileName(path);
    return itk::ExpectInputError([&] { reader->Update(); }).GetOneLine();
  };
  const std::string whole = WriteWebCeph("whole.wceph", WebCephIndex(R"("a": )" + WebCephPicture("a", "null", "{}")));
  EXPECT_TRUE(itk::Contains(errorOf(whole), "has no landmarks on a cephalogram")) << errorOf(whole);
  EXPECT_TRUE(itk::Contains(errorOf(WriteWebCeph("v2.wceph", R"({"version": 2, "data": {}})")), "version"));
  EXPECT_TRUE(itk::Contains(errorOf(WriteWebCeph("other.wceph", "{}")), "version"));
  EXPECT_TRUE(itk::Contains(errorOf(WriteWebCeph("other.zip", "{}", "folder/notes.txt")), "a ZIP archive"));
  // As a tracing it is named for what it is, though the index stands behind all pictures.
  const auto contours = itk::DentalContourFileReader::New();
  contours->SetFileName(whole);
  contours->SetImageSize({ { 100, 100 } });
  const std::string refusal = itk::ExpectInputError([&] { contours->Update(); }).GetOneLine();
  EXPECT_TRUE(itk::Contains(refusal, "WebCeph") && itk::Contains(refusal, "cephalometric_landmarks")) << refusal;
  // Cut anywhere it is an error in words; the directory is at its end.
  std::ifstream     file(whole, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (const std::size_t length : { bytes.size() - 1, bytes.size() - 30, bytes.size() / 2 })
  {
    errorOf(itk::WriteTestFile("cut.wceph", bytes.substr(0, length)));
  }
  std::string damaged = bytes;
  damaged[damaged.rfind("index.json") - 60] ^= 0x55;
  errorOf(itk::WriteTestFile("damaged.wceph", damaged));
}

TEST(CephalometricLandmarkFileReader, ReadsTheSharedCases)
{
  const std::string cases = std::string(DENTALSCR_SHARED_DIR) + "/cases";
  if (!std::filesystem::exists(cases))
  {
    GTEST_SKIP() << "no folder " << cases;
  }
  for (const auto & entry : std::filesystem::directory_iterator(cases))
  {
    const auto file = entry.path() / "cephalometric.json";
    if (std::filesystem::exists(file))
    {
      const auto reader = ReaderType::New();
      reader->SetFileName(file.string());
      reader->Update();
      EXPECT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 4u) << file;
      EXPECT_TRUE(reader->GetWarnings().empty()) << file;
    }
  }
}
