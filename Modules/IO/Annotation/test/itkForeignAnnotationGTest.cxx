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
#include "itkDentalContourFileReader.h"
#include "itkDentalLandmarkFileReader.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

using itk::DentalContourFileReader;
using Landmarks2D = itk::DentalLandmarkFileReader<2>;
using Landmarks3D = itk::DentalLandmarkFileReader<3>;
using FormatEnum = itk::AnnotationFileFormatEnum;

namespace
{
const char * const Markups = R"({
 "@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#",
 "markups": [
  {"type": "Curve", "name": "UR1", "coordinateSystem": "RAS", "coordinateUnits": "mm", "controlPoints": [
    {"id": "1", "label": "UR1-1", "position": [-10.0, -20.0, 0.0], "positionStatus": "defined"},
    {"id": "2", "label": "UR1-2", "position": [0.0, 0.0, 0.0], "positionStatus": "preview"},
    {"id": "3", "label": "UR1-3", "position": [-11.0, -22.0, 0.0]}]},
  {"type": "ClosedCurve", "name": "LR6", "controlPoints": [
    {"position": [1, 1, 0]}, {"position": [5, 1, 0]}, {"position": [5, 5, 0]}]},
  {"type": "Fiducial", "name": "F", "coordinateSystem": "LPS", "controlPoints": [
    {"label": "UR1_tip", "position": [3, 4, 5], "positionStatus": "defined"},
    {"label": "Sella", "position": [3, 4, 5], "positionStatus": "defined"}]}]})";

const char * const Labelme = R"({"version": "5.0.1", "flags": {}, "imagePath": "ceph.png", "imageData": null,
 "imageHeight": 200, "imageWidth": 100, "shapes": [
  {"label": "UR1", "points": [[10.5, 20.5], [11.5, 21.5]], "group_id": null, "shape_type": "linestrip", "flags": {}},
  {"label": "lower", "points": [[1, 1], [9, 1], [9, 9]], "shape_type": "polygon"},
  {"label": "UR1_tip", "points": [[30.5, 40.5]], "shape_type": "point"}]})";

DentalContourFileReader::Pointer
ContourReader(const std::string & name, const std::string & text)
{
  const auto reader = DentalContourFileReader::New();
  reader->SetFileName(itk::WriteTestFile(name, text));
  reader->SetImageSize({ { 100, 200 } });
  return reader;
}
} // namespace

TEST(SlicerMarkups, CurvesBecomeContoursInPixels)
{
  const auto reader = ContourReader("ceph.mrk.json", Markups);
  reader->Update();
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::SlicerMarkups);
  const auto upper = reader->GetUpperOutput()->GetPolylines();
  ASSERT_EQ(upper.size(), 1u);
  EXPECT_EQ(upper[0].code.GetName(), "UR1");
  // RAS to LPS, and the point that was never placed is left out.
  ASSERT_EQ(upper[0].points.size(), 2u);
  EXPECT_EQ(upper[0].points[1][0], 11.0);
  EXPECT_EQ(upper[0].points[1][1], 22.0);
  EXPECT_TRUE(reader->GetLowerOutput()->GetPolylines().at(0).closed);

  DentalContourFileReader::VectorType spacing;
  spacing[0] = 0.5;
  spacing[1] = 0.25;
  DentalContourFileReader::VectorType origin;
  origin.Fill(1.0);
  reader->SetMarkupsSpacing(spacing);
  reader->SetMarkupsOrigin(origin);
  reader->Update();
  EXPECT_EQ(reader->GetUpperOutput()->GetPolylines().at(0).points[1][0], 20.0);
  EXPECT_EQ(reader->GetUpperOutput()->GetPolylines().at(0).points[1][1], 84.0);
}

TEST(SlicerMarkups, FiducialsBecomeLandmarksInLPS)
{
  const auto reader = Landmarks3D::New();
  reader->SetFileName(itk::WriteTestFile("l.mrk.json", Markups));
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 1u);
  EXPECT_EQ(reader->GetOutput()->Find("UR1_tip")->point[2], 5.0);
  EXPECT_EQ(reader->GetWarnings().size(), 1u);
}

TEST(SlicerMarkups, WhatCannotBeUsedIsNamed)
{
  const auto field = [](const std::string & markup) {
    const auto reader = ContourReader("ceph.mrk.json", "{\"markups\": [" + markup + "]}");
    return itk::ExpectInputError([&] { reader->Update(); }).GetField();
  };
  EXPECT_EQ(field(R"({"name": "UR1"})"), "markups[0].type");
  EXPECT_EQ(field(R"({"type": "Curve", "name": "C", "controlPoints": [{"position": [1, 1, 0]}]})"), "markups[0].name");
  EXPECT_EQ(field(R"({"type": "Curve", "controlPoints": [{"position": [1, 1, 0]}]})"), "markups[0].name");
  EXPECT_EQ(field(R"({"type": "Curve", "name": "UR1", "controlPoints": [{"position": [1, 1]}]})"),
            "markups[0].controlPoints[0].position");
  EXPECT_EQ(
    field(R"({"type": "Curve", "name": "UR1", "controlPoints": [{"position": [1, 1, 0]}, {"position": [1, 1, 2]}]})"),
    "markups[0].controlPoints[1]");
  EXPECT_EQ(field(R"({"type": "Curve", "name": "UR1", "coordinateSystem": "IJK", "controlPoints": []})"),
            "markups[0].coordinateSystem");
  EXPECT_EQ(field(R"({"type": "Curve", "name": "UR1", "coordinateUnits": "m", "controlPoints": []})"),
            "markups[0].coordinateUnits");
}

TEST(Labelme, ShapesBecomeContoursCountedFromPixelCentres)
{
  const auto reader = ContourReader("ceph.json", Labelme);
  reader->Update();
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::Labelme);
  const auto upper = reader->GetUpperOutput()->GetPolylines();
  ASSERT_EQ(upper.size(), 1u);
  EXPECT_EQ(upper[0].points[0][0], 10.0);
  EXPECT_EQ(upper[0].points[0][1], 20.0);
  const auto lower = reader->GetLowerOutput()->GetPolylines();
  ASSERT_EQ(lower.size(), 1u);
  EXPECT_TRUE(lower[0].closed);
  EXPECT_FALSE(lower[0].code.IsKnown());
  reader->SetPixelOrigin(itk::AnnotationPixelOriginEnum::Centre);
  reader->Update();
  EXPECT_EQ(reader->GetUpperOutput()->GetPolylines().at(0).points[0][0], 10.5);
  reader->SetImageSize({ { 101, 200 } });
  EXPECT_EQ(itk::ExpectInputError([&] { reader->Update(); }).GetField(), "imageWidth");
}

TEST(Labelme, PointsBecomeLandmarks)
{
  const auto reader = Landmarks2D::New();
  reader->SetFileName(itk::WriteTestFile("ceph.json", Labelme));
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 1u);
  EXPECT_EQ(reader->GetOutput()->Find("UR1_tip")->point[0], 30.0);
  const auto threeD = Landmarks3D::New();
  threeD->SetFileName(reader->GetFileName());
  itk::ExpectInputError([&] { threeD->Update(); });
}

TEST(AnnotationCSV, RunsOfALabelBecomeContours)
{
  for (const char * text : { "label,x,y\nUR1,1.5,2\nUR1,3,4\r\n\n# comment\n\"LR1\", 5 ,6,px\n",
                             "UR1;1.5;2\nUR1;3;4\nLR1;5;6",
                             "\xef\xbb\xbfUR1\t1.5\t2\nUR1\t3\t4\nLR1\t5\t6\n" })
  {
    const auto reader = ContourReader("ceph.csv", text);
    reader->Update();
    EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::CSV);
    const auto upper = reader->GetUpperOutput()->GetPolylines();
    ASSERT_EQ(upper.size(), 1u) << text;
    ASSERT_EQ(upper[0].points.size(), 2u);
    EXPECT_EQ(upper[0].points[0][0], 1.5);
    EXPECT_EQ(reader->GetLowerOutput()->GetNumberOfPoints(), 1u);
  }
}

TEST(AnnotationCSV, LandmarksOfBothDimensions)
{
  const auto threeD = Landmarks3D::New();
  threeD->SetFileName(itk::WriteTestFile("l.csv", "label,x,y,z\nUR1_tip,1,2,-3e-1\n"));
  threeD->Update();
  EXPECT_EQ(threeD->GetOutput()->Find("UR1_tip")->point[2], -0.3);
  const auto twoD = Landmarks2D::New();
  twoD->SetFileName(itk::WriteTestFile("l2.csv", "UR1_tip,1,2\n"));
  twoD->SetPixelOrigin(itk::AnnotationPixelOriginEnum::Corner);
  twoD->Update();
  EXPECT_EQ(twoD->GetOutput()->Find("UR1_tip")->point[0], 0.5);
  twoD->SetFileName(itk::WriteTestFile("l3.csv", "UR1_tip,1,2\nUR1_tip,1,2\n"));
  EXPECT_EQ(itk::ExpectInputError([&] { twoD->Update(); }).GetField(), "line 2");
}

TEST(AnnotationCSV, ANumberSignBeforeAToothBeginsNoComment)
{
  const std::string rows = "#11,1,2\n#11,3,4\n#46,5,6\n#46,7,8\n";
  for (const std::string & text : { "label,x,y\n" + rows,
                                    rows,
                                    "# by me, 1.5, 2\n# 2024,1,2\n#\n" + rows,
                                    std::string("\"#11\",1,2\n\"#11\",\"3\",\"4\"\n\"#46\",5,6\n #46 ,7,8\n"),
                                    std::string("\"#11\",\"1\",\"2\"\n#11,3,4\n#46,5,6\r\n#46,7,8"),
                                    std::string("sep=;\n#11;1,0;2,0\n#11;3,0;4,0\n#46;5,0;6,0\n#46;7,0;8,0\n"),
                                    std::string("#11\t1\t2\n#11\t3\t4\n#46\t5\t6\n#46\t7\t8\n"),
                                    std::string("#11;1;2\n#11;3;4\n#46;5;6\n#46;7;8\n") })
  {
    const auto reader = ContourReader("hash.csv", text);
    reader->Update();
    const auto & upper = reader->GetUpperOutput()->GetPolylines();
    const auto & lower = reader->GetLowerOutput()->GetPolylines();
    ASSERT_TRUE(upper.size() == 1u && lower.size() == 1u) << text;
    EXPECT_EQ(upper[0].code.GetName(), "UR1") << text;
    ASSERT_TRUE(upper[0].points.size() == 2u && lower[0].points.size() == 2u) << text;
    EXPECT_EQ(upper[0].points[1][1], 4.0) << text;
    EXPECT_EQ(lower[0].code.GetName(), "LR6") << text;
    // Only that a jaw has few points is to be said.
    EXPECT_EQ(reader->GetWarnings().size(), 2u) << text;
  }
  // Beside teeth without the sign it may be a line that was switched off: that is said, with the line.
  const auto mixed = ContourReader("mixed.csv", "11,1,2\n11,3,4\n#12,5,6\n#12,7,8\n");
  mixed->Update();
  EXPECT_EQ(mixed->GetUpperOutput()->GetPolylines().size(), 2u);
  EXPECT_TRUE(itk::Contains(mixed->GetWarnings().front(), "line 3: \"#12\" is read as a tooth"))
    << mixed->GetWarnings().front();
  // A slip is an error, not a comment.
  const auto slip = ContourReader("slip.csv", "#11,1,2\n#19,3,4\n");
  EXPECT_EQ(itk::ExpectInputError([&] { slip->Update(); }).GetField(), "line 2");
}

TEST(AnnotationCSV, PointsOfTeethInTheSpellingsOfTeeth)
{
  const auto reader = Landmarks2D::New();
  reader->SetFileName(
    itk::WriteTestFile("spelled.csv",
                       "name,x,y\n#11_tip,1,2\n1.6_MB,3,4\n46 MB,5,6\ntooth 36-mb,7,8\n\"#21 Tip\",9,10\nSella,1,1\n"
                       "16 fossa,2,2\n# 21 is worn,3,4\n"));
  reader->Update();
  const auto expect = [&reader](const char * tooth, double u) {
    for (const auto & landmark : reader->GetOutput()->GetLandmarks())
    {
      if (landmark.tooth.GetName() == tooth)
      {
        EXPECT_EQ(landmark.point[0], u) << tooth;
        return landmark.name;
      }
    }
    return std::string("none");
  };
  expect("UR1", 1.0);
  expect("UR6", 3.0);
  EXPECT_EQ(expect("LR6", 5.0), "LR6_MB");
  EXPECT_EQ(expect("LL6", 7.0), "LL6_MB");
  EXPECT_EQ(expect("UL1", 9.0), "UL1_tip");
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 5u);
  // Of the sign beside teeth without it, and of two names.
  ASSERT_EQ(reader->GetWarnings().size(), 3u);
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[0], "#11_tip"));
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[2], "16 fossa"));
  const auto universal = Landmarks2D::New();
  universal->SetFileName(itk::WriteTestFile("universal.csv", "#3 MB,1,2\n#8_tip,3,4\n"));
  universal->SetNumbering(itk::ToothCode::NumberingEnum::Universal);
  universal->Update();
  ASSERT_NE(universal->GetOutput()->Find("UR6_MB"), nullptr);
  EXPECT_EQ(universal->GetOutput()->Find("UR1_tip")->point[0], 3.0);
}

TEST(AnnotationCSV, WrongLinesAreNamed)
{
  for (const char * line :
       { "UR1,1", "UR1,1,x", "UR1,1,nan", "UR1,1,inf", "UR1,1,", "UR1,1,2,mm", "UR1,1,2,3,4", "UR9,1,2", ",1,2" })
  {
    const auto reader = ContourReader("ceph.csv", std::string("UR2,1,2\n") + line + '\n');
    EXPECT_EQ(itk::ExpectInputError([&] { reader->Update(); }).GetField(), "line 2") << line;
  }
}
