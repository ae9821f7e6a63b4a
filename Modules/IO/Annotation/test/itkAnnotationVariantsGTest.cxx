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
// Files of programs and scripts in the forms that people have them in, beside those that a format's own page shows.
#include "itkCephalometricLandmarkFileReader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalLandmarkFileReader.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <utility>

using itk::CephalometricLandmarkFileReader;
using itk::Contains;
using itk::DentalContourFileReader;
using Landmarks2D = itk::DentalLandmarkFileReader<2>;
using Landmarks3D = itk::DentalLandmarkFileReader<3>;
using FormatEnum = itk::AnnotationFileFormatEnum;

namespace
{
template <typename TReader>
typename TReader::Pointer
MakeReader(const std::string & name, const std::string & text)
{
  const auto reader = TReader::New();
  reader->SetFileName(itk::WriteTestFile(name, text));
  return reader;
}

/** Reads two landmarks of an analysis: U1_tip at (10, 20), L6_MB at (30, 40). */
void
ExpectTwo(const std::string & name, const std::string & text, double shift = 0.0)
{
  SCOPED_TRACE(text);
  const auto reader = MakeReader<CephalometricLandmarkFileReader>(name, text);
  reader->Update();
  const auto * const tip = reader->GetOutput()->Find("U1_tip");
  const auto * const cusp = reader->GetOutput()->Find("L6_MB");
  ASSERT_NE(tip, nullptr);
  ASSERT_NE(cusp, nullptr);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 2u);
  EXPECT_DOUBLE_EQ(tip->point[0], 10.0 + shift);
  EXPECT_DOUBLE_EQ(tip->point[1], 20.0 + shift);
  EXPECT_DOUBLE_EQ(cusp->point[0], 30.0 + shift);
  EXPECT_DOUBLE_EQ(cusp->point[1], 40.0 + shift);
}

itk::DentalInputError
LandmarkError(const std::string & name, const std::string & text)
{
  const auto reader = MakeReader<CephalometricLandmarkFileReader>(name, text);
  return itk::ExpectInputError([&] { reader->Update(); });
}

DentalContourFileReader::Pointer
Contours(const std::string & name, const std::string & text)
{
  const auto reader = MakeReader<DentalContourFileReader>(name, text);
  reader->SetImageSize({ { 100, 200 } });
  return reader;
}

itk::DentalInputError
ContourError(const std::string & name, const std::string & text)
{
  const auto reader = Contours(name, text);
  return itk::ExpectInputError([&] { reader->Update(); });
}

const DentalContourFileReader *
Updated(const DentalContourFileReader::Pointer & reader)
{
  reader->Update();
  return reader;
}

std::string
Curve(const std::string & type, const std::string & name, const std::string & stem)
{
  return R"({"markups": [{"type": ")" + type + "\"," + (name.empty() ? "" : "\"name\": \"" + name + "\",") +
         R"("labelFormat": "%N-%d", "controlPoints": [{"label": ")" + stem +
         R"(-1", "position": [4, 5, 0]}, {"label": ")" + stem + R"(-2", "position": [6, 8, 0]}, {"label": ")" + stem +
         R"(-3", "position": [9, 9, 0]}]}]})";
}

std::string
CvatPicture(const std::string & shapes)
{
  return R"(<annotations><version>1.1</version><image id="0" name="ceph.png" width="100" height="200">)" + shapes +
         "</image></annotations>";
}
} // namespace

TEST(LandmarkJSON, PlacesByNameInWhateverForm)
{
  ExpectTwo("a.json", R"({"U1_tip": {"x": 10, "y": 20}, "L6_MB": {"x": 30, "y": 40}})");
  ExpectTwo("a.json", R"({"U1_tip": {"u": 10, "v": 20}, "L6_MB": [30, 40]})");
  ExpectTwo("a.json", R"({"U1_tip": {"position": {"x": 10, "y": 20}}, "L6_MB": {"coordinates": [30, 40]}})");
  ExpectTwo("a.json",
            R"({"image": "c.png", "landmarks": {"U1 Incisal Edge": [10, 20], "L6_MB": [30, 40], "S": [1, 2]}})");
  ExpectTwo("a.json", R"({"unit": "px", "landmarks": {"UIT": {"x": 10, "y": 20}, "LMT": {"x": 30, "y": 40}}})");
  ExpectTwo("a.json",
            R"({"landmarks": {"1": {"name": "UIT", "x": 10, "y": 20}, "2": {"name": "LMT", "x": 30, "y": 40}}})");
}

TEST(LandmarkJSON, ListsOfAnyProgram)
{
  ExpectTwo("a.json", R"([{"name": "U1_tip", "x": 10, "y": 20}, {"name": "L6_MB", "x": 30, "y": 40}])");
  ExpectTwo("a.json", R"([["U1_tip", 10, 20], ["L6_MB", 30, 40], ["S", 1, 2]])");
  ExpectTwo("a.json",
            R"({"points": [{"label": "U1_tip", "x": 10, "y": 20, "id": 1}, {"label": "LMT", "x": 30, "y": 40}]})");
  ExpectTwo("a.json", R"({"keypoints": [{"name": "U1_tip", "position": [10, 20], "score": 1},
                                        {"name": "L6_MB", "position": [30, 40]}]})");
  ExpectTwo("a.json", R"({"landmarks": [{"symbol": "UIT", "position": {"x": 10, "y": 20}},
                                        {"symbol": "LMT", "position": {"x": 30, "y": 40}}]})");
  // The number of a sixth landmark is no molar where the entry has a name, and a name where it has none.
  ExpectTwo("a.json", R"([{"id": "L6", "name": "Orbitale", "x": 1, "y": 2}, {"id": "U1_tip", "x": 10, "y": 20},
                          {"id": "L6_MB", "x": 30, "y": 40}])");
}

TEST(LandmarkJSON, WhatIsMissingOrInAnotherUnitIsNamed)
{
  EXPECT_EQ(LandmarkError("a.json", R"([{"name": "U1_tip", "x": 1}])").GetField(), "[0].y");
  EXPECT_EQ(LandmarkError("a.json", R"([{"x": 1, "y": 2}])").GetField(), "[0].name");
  EXPECT_EQ(LandmarkError("a.json", R"({"units": "mm", "landmarks": {"U1_tip": [1, 2]}})").GetField(), "units");
  EXPECT_EQ(LandmarkError("a.json", R"({"normalized": true, "U1_tip": [1, 2]})").GetField(), "normalized");
  EXPECT_TRUE(Contains(LandmarkError("a.json", "[[1, 2], [3, 4]]").GetOneLine(), "is no JSON object"));
  const auto reader = MakeReader<CephalometricLandmarkFileReader>(
    "a.json", R"({"landmarks": {"U1_tip": {"x": null, "y": null}, "L1_tip": [1, 2]}})");
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 1u);
  EXPECT_TRUE(Contains(reader->GetWarnings().at(0), "landmarks.U1_tip: is not marked"));
}

TEST(LandmarkJSON, WhatIsNoPointOfThePictureIsNotReadAsOne)
{
  // Not there, whatever place it has.
  ExpectTwo("a.json",
            R"([{"name": "U1_tip", "x": 10, "y": 20, "visible": true}, {"name": "L6_MB", "x": 30, "y": 40, "z": 0},
                {"name": "L1_tip", "x": 0, "y": 0, "visible": 0}, {"name": "U6_MB", "x": 0, "y": 0, "missing": true}])");
  // The picture's size beside a place is no box.
  ExpectTwo(
    "a.json",
    R"([{"name": "U1_tip", "x": 10, "y": 20, "width": 703, "height": 938}, {"name": "L6_MB", "x": 30, "y": 40}])");
  const std::pair<const char *, const char *> files[] = {
    { R"([{"name": "U1_tip", "x": 100, "y": 20, "width": 40, "height": 50}])", "[0].width: is the size of a box" },
    { R"([{"name": "U1_tip", "x": 1, "y": 2, "z": 3}])", "[0].z: is a third coordinate" },
    { R"([{"name": "U1_tip", "x": 1, "y": 2, "u": 10, "v": 20}])", "[0].u: is another coordinate than \"x\"" },
    { R"({"metadata": {"unit": "mm"}, "landmarks": {"U1_tip": [10, 20]}})", "metadata.unit: is \"mm\"" },
  };
  for (const auto & [text, problem] : files)
  {
    const auto error = LandmarkError("a.json", text).GetOneLine();
    EXPECT_TRUE(Contains(error, problem)) << error;
  }
}

TEST(LandmarkJSON, OfScansAndForMeasuring)
{
  const auto scan = MakeReader<Landmarks3D>(
    "a.json",
    R"({"points": [{"name": "UR1_tip", "x": 1, "y": 2, "z": 3}, {"label": "16 MB", "position": [4, 5, 6]}]})");
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfLandmarks(), 2u);
  EXPECT_EQ(scan->GetOutput()->Find("UR1_tip")->point[2], 3.0);
  EXPECT_EQ(scan->GetOutput()->Find("UR6_MB")->point[1], 5.0);
  const auto marked = MakeReader<Landmarks2D>("a.json", R"({"landmarks": {"UR1_tip": {"x": 1, "y": 2}}, "by": "me"})");
  marked->Update();
  ASSERT_EQ(marked->GetOutput()->GetNumberOfLandmarks(), 1u);
  EXPECT_EQ(marked->GetOutput()->Find("UR1_tip")->point[1], 2.0);
  const auto error = itk::ExpectInputError(
    [] { MakeReader<Landmarks3D>("a.json", R"([{"name": "UR1_tip", "x": 1, "y": 2}])")->Update(); });
  EXPECT_EQ(error.GetField(), "[0].z");
}

TEST(LandmarkJSON, SharesOfThePictureAreNoPixels)
{
  const auto error = LandmarkError("a.json", R"({"U1_tip": [0.81, 0.63], "L1_tip": [0.8, 0.62]})");
  EXPECT_TRUE(Contains(error.GetOneLine(), "shares of the picture's size"));
  EXPECT_TRUE(Contains(error.GetOneLine(), "multiply x by"));
  EXPECT_TRUE(Contains(ContourError("a.csv", "UR1,0.1,0.2\nUR1,0.3,0.25\nUR1,0.3,0.4\n").GetOneLine(), "shares"));
  // A single place in the first pixel is one, and places at nought are another fault.
  const auto single = MakeReader<Landmarks2D>("a.json", R"({"UR1_tip": [0.5, 0.5]})");
  single->Update();
  EXPECT_EQ(single->GetOutput()->GetNumberOfLandmarks(), 1u);
  const auto zeros = MakeReader<Landmarks2D>("a.json", R"({"UR1_tip": [0, 0], "UR2_tip": [0, 0]})");
  zeros->Update();
  EXPECT_EQ(zeros->GetOutput()->GetNumberOfLandmarks(), 2u);
}

TEST(AnnotationJSON, ProgramsThatAreNotReadAreNamed)
{
  const auto expect = [](const std::string & text, const std::string & program) {
    SCOPED_TRACE(program);
    EXPECT_TRUE(Contains(LandmarkError("a.json", text).GetOneLine(), program));
    EXPECT_TRUE(Contains(ContourError("a.json", text).GetOneLine(), program));
    EXPECT_TRUE(Contains(ContourError("a.json", text).GetOneLine(), "export COCO"));
  };
  expect(R"({"type": "FeatureCollection", "features": []})", "GeoJSON, as QuPath writes it");
  expect(R"([{"type": "Feature", "geometry": {}}])", "GeoJSON");
  expect(R"({"info": {}, "categories": {}, "items": []})", "Datumaro");
  expect(R"({"version": "2.0", "item": {}, "annotations": []})", "V7 Darwin");
  expect(R"([{"data_row": {}, "projects": {}}])", "Labelbox");
  expect(R"({"label_hash": "a", "data_units": {}})", "Encord");
}

TEST(AnnotationTable, ColumnsAreFoundByWhatStandsInThem)
{
  ExpectTwo("a.csv", "id,landmark_name,x_px,y_px,time\n0,U1_tip,10,20,12:00\n1,L6_MB,30,40,12:01\n");
  ExpectTwo("a.csv", ",name,x,y\n0,U1_tip,10,20\n1,L6_MB,30,40\n");
  ExpectTwo("a.csv",
            "Messpunkt;Beschreibung;X;Y\r\nU1_tip;Zahn;10,0;20,0\r\nL6_MB;H\xf6"
            "cker;30,0;40,0\r\n");
  ExpectTwo("a.csv", "file_name,landmark,row,col\nceph.png,U1_tip,20,10\nceph.png,L6_MB,40,30\n");
  ExpectTwo("a.csv", "name,landmark,x,y\nceph.png,U1_tip,10,20\nceph.png,L6_MB,30,40\n");
  // What counts lines, and what was measured, is no tooth, though a number of a tooth is.
  EXPECT_TRUE(Contains(LandmarkError("a.csv", "n,Area,x,y\n1,0,10,20\n2,0,30,40\n").GetOneLine(), "column of labels"));
  const auto teeth = Contours("a.csv", "Zahn;Nr;x;y\n11;1;1;2\n11;2;3;4\n12;3;5;6\n");
  EXPECT_EQ(Updated(teeth)->GetOutput(itk::ToothCode::JawEnum::Upper)->GetPolylines().at(1).code.GetName(), "UR2");
}

TEST(AnnotationTable, TitlesEmptyRowsBlanksAndRowsOfMakeSense)
{
  const std::string titled =
    "Patient: Test, A\r\nDate: 2024-01-02\r\n\r\nLandmark\tX\tY\r\nU1_tip\t10\t20\r\nLMT\t30\t40\r\n";
  ExpectTwo("a.txt", titled);
  const auto reader = MakeReader<CephalometricLandmarkFileReader>("a.txt", titled);
  reader->Update();
  EXPECT_TRUE(Contains(reader->GetWarnings().at(0), "line 1: taken for a title"));
  ExpectTwo("a.txt", "U1_tip 10 20\nL6_MB   30 40\n");
  ExpectTwo("a.txt", "U1 Incisal Edge 10.0 20.0\nL6_MB 30 40\n");
  ExpectTwo("a.csv", "label;x;y;;\nU1_tip;10;20;;\nL6_MB;30;40;;\n;;;;\n;;;;\n");
  ExpectTwo("a.csv", "U1_tip,10,20,,\nL6_MB,30,40,,\n");
  ExpectTwo("a.csv", "U1_tip,10,20,ceph.png,703,938\nL6_MB,30,40,ceph.png,703,938\n");
  EXPECT_EQ(LandmarkError("a.csv", "U1_tip,10,20,30,40,50\n").GetField(), "line 1");
}

TEST(AnnotationTable, AColumnOfAnotherThingIsNoCoordinate)
{
  // A line's number and a visibility beside x and y; axes in any order and spelling; of two columns the one in pixels.
  ExpectTwo("a.csv", "row,label,x,y\n0,U1_tip,10,20\n1,L6_MB,30,40\n");
  ExpectTwo("a.csv", "label,v,x,y\nU1_tip,2,10,20\nL6_MB,2,30,40\n");
  ExpectTwo("a.csv", "label,pos_y,pos_x\nU1_tip,20,10\nL6_MB,40,30\n");
  ExpectTwo("a.csv", "label,cy,cx\nU1_tip,20,10\nL6_MB,40,30\n");
  ExpectTwo("a.csv", "label,x,y,x_px,y_px\nU1_tip,1,2,10,20\nL6_MB,3,4,30,40\n");
  ExpectTwo("a.csv", "label,x_mm,y_mm,x_px,y_px\nU1_tip,1,2,10,20\nL6_MB,3,4,30,40\n");
  ExpectTwo("a.csv", "label,x,y,x_error,y_error\nU1_tip,10,20,1,2\nL6_MB,30,40,3,4\n");
  ExpectTwo("a.csv", "label,x,y,z\nU1_tip,10,20,0\nL6_MB,30,40,0\n");
  ExpectTwo("a.csv", "label,x,y,width,height\nU1_tip,10,20,703,938\nL6_MB,30,40,703,938\n");

  const std::pair<const char *, const char *> tables[] = {
    { "label,x,y,u,v\nU1_tip,1,2,10,20\n", "line 1: has more than one column of an axis, \"u\"" },
    { "label,x,y,x,y\nU1_tip,1,2,10,20\n", "more than one column of an axis" },
    { "label,x_mm,y_mm\nU1_tip,1,2\n", "the column \"x_mm\" is in mm" },
    { "label,x (%),y (%)\nU1_tip,55,60\n", "the column \"x (%)\" is not known to be the coordinate \"x\" in pixels" },
    { "label,x (cm),y (cm)\nU1_tip,5,6\n", "the column \"x (cm)\"" },
    { "label,x_error,y_error\nU1_tip,5,6\n", "the column \"x_error\"" },
    { "label,vertical,horizontal\nU1_tip,5,6\n", "the column \"vertical\"" },
    { "label,r,theta\nU1_tip,5,6\n", "the column \"r\"" },
    { "label,x,y,z\nU1_tip,5,6,7\n", "line 2: has a third coordinate" },
    { "label,x,y,width,height\nU1_tip,500,600,40,50\n", "line 2: has a width and a height: a box" },
  };
  for (const auto & [text, problem] : tables)
  {
    const auto error = LandmarkError("a.csv", text).GetOneLine();
    EXPECT_TRUE(Contains(error, problem)) << error;
  }
  // What is in a language of its own is read in the order of the columns, and said.
  const auto other = MakeReader<CephalometricLandmarkFileReader>("a.csv", "Punkt,Breite,Hoehe\nU1_tip,5,6\n");
  other->Update();
  EXPECT_TRUE(Contains(other->GetWarnings().at(0), "taken for a header, as it has no numbers; columns are read as"));
}

TEST(AnnotationTable, OfManyFilmsTheRadiographsOwnLinesAreRead)
{
  const std::string films = "image,label,x,y\nb.png,U1_tip,50,60\na.png,U1_tip,10,20\na.png,L6_MB,30,40\n";
  const auto        reader = MakeReader<CephalometricLandmarkFileReader>("t.csv", films);
  reader->SetImageFileName("folder/A.png");
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLandmarks(), 2u);
  EXPECT_DOUBLE_EQ(reader->GetOutput()->Find("U1_tip")->point[0], 10.0);
  // As a spreadsheet has it: a name in the first of its lines alone.
  ExpectTwo("t.csv", "patient,label,x,y\nMiller,U1_tip,10,20\n,L6_MB,30,40\n");
  // Points of two films are never put together.
  for (const char * const text : { "image,label,x,y\nb.png,U1_tip,50,60\na.png,L6_MB,30,40\n",
                                   "patient_id;label;x;y\nb;U1_tip;50;60\na;L6_MB;30;40\n",
                                   "U1_tip,50,60,b.png,703,938\nL6_MB,30,40,a.png,703,938\n" })
  {
    const auto error = LandmarkError("t.csv", text).GetOneLine();
    EXPECT_TRUE(Contains(error, "has 2 pictures (b")) << error;
  }
  std::string outlines = "image,label,x,y\n";
  for (const char * const picture : { "b.png", "a.png" })
  {
    for (const char * const point : { "10,10", "30,10", "40,30", "30,60", "10,60" })
    {
      outlines += std::string(picture) + ",UR1," + (picture[0] == 'b' ? "2" : "") + point + '\n';
    }
  }
  EXPECT_TRUE(Contains(ContourError("t.csv", outlines).GetOneLine(), "has 2 pictures"));
  const auto contours = Contours("t.csv", outlines);
  contours->SetImageFileName("a.png");
  const auto polylines = Updated(contours)->GetOutput(itk::ToothCode::JawEnum::Upper)->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_EQ(polylines[0].points.size(), 5u);
  EXPECT_DOUBLE_EQ(polylines[0].points[0][0], 10.0);
}

TEST(AnnotationTable, LettersOfWesternEuropeAreReadAsSpreadsheetsSaveThem)
{
  const auto reader = MakeReader<CephalometricLandmarkFileReader>("a.csv",
                                                                  "Punkt;X;Y\r\nH\xf6"
                                                                  "cker;1,5;2,5\r\nU1_tip;10,0;20,0\r\n");
  reader->Update();
  EXPECT_TRUE(Contains(reader->GetWarnings().at(0),
                       "left out: H\xc3\xb6"
                       "cker"));
  EXPECT_TRUE(Contains(ContourError("a.csv", "Z\xe4hne;1;2\n").GetOneLine(), "Z\xc3\xa4hne"));
}

TEST(AnnotationTable, ATableOfAnotherFormSaysWhatToWrite)
{
  const auto remedy = [](const std::string & text) { return LandmarkError("a.csv", text).GetRemedy(); };
  EXPECT_TRUE(Contains(remedy("image,id,kp,annotator,annotation_id\na.png,1,[],1,3\n"), "export JSON"));
  EXPECT_TRUE(Contains(remedy("file,U1_tip_x,U1_tip_y,L6_x,L6_y\na.png,1,2,3,4\n"), "a line a landmark, label,x,y"));
  EXPECT_TRUE(Contains(remedy("a,b,c,d,e,f\n1,2,3,4,5,6\n"), "name the columns in the first line"));
  EXPECT_EQ(remedy("U1_tip,1,2\nL6_MB,3\n"), "correct the line");
}

TEST(SlicerMarkups, CurvesWithoutANameAreCalledAsTheirPoints)
{
  const auto upper = [](const DentalContourFileReader::Pointer & reader) {
    return Updated(reader)->GetOutput(itk::ToothCode::JawEnum::Upper)->GetPolylines();
  };
  EXPECT_EQ(upper(Contours("C.mrk.json", Curve("Curve", "", "UR1"))).at(0).code.GetName(), "UR1");
  // Slicer saves a curve in a file of the curve's name.
  EXPECT_EQ(upper(Contours("UR2.mrk.json", Curve("Curve", "", "C"))).at(0).code.GetName(), "UR2");
  EXPECT_EQ(upper(Contours("UR2.mrk.json", Curve("Curve", "UR3", "C"))).at(0).code.GetName(), "UR3");
  EXPECT_TRUE(Contains(ContourError("C.mrk.json", Curve("Curve", "", "C")).GetOneLine(), "is no tooth"));
}

TEST(ClassFiles, DrawingsOfOneToothEach)
{
  const std::string first = itk::WriteTestFile("one.mrk.json", Curve("Curve", "", "C"));
  const std::string second = itk::WriteTestFile("two.mrk.json", Curve("ClosedCurve", "", "C_1"));
  const auto        reader = DentalContourFileReader::New();
  reader->SetImageSize({ { 100, 200 } });
  DentalContourFileReader::VectorType spacing;
  spacing.Fill(0.5);
  reader->SetMarkupsSpacing(spacing);
  reader->SetClassFiles({ { "UR1", first }, { "LR6", second } });
  reader->Update();
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::SlicerMarkups);
  const auto upper = reader->GetUpperOutput()->GetPolylines();
  EXPECT_EQ(upper.at(0).code.GetName(), "UR1");
  EXPECT_EQ(upper.at(0).points.at(0)[0], 8.0);
  EXPECT_TRUE(reader->GetLowerOutput()->GetPolylines().at(0).closed);

  const std::string other = itk::WriteTestFile("other.mrk.json", Curve("Curve", "UR2", "C"));
  reader->SetClassFiles({ { "UR1", other } });
  const auto tooth = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_TRUE(Contains(tooth.GetOneLine(), "is \"UR2\", and the case names the file for \"UR1\""));
  reader->SetClassFiles({ { "12", other } });
  reader->Update();
  EXPECT_EQ(reader->GetUpperOutput()->GetPolylines().at(0).code.GetName(), "UR2");

  const std::string table = itk::WriteTestFile("t.csv", "UR2,1,2\nUR2,3,4\n");
  reader->SetClassFiles({ { "UR1", first }, { "UR2", table } });
  const auto mixed = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_EQ(mixed.GetField(), "contours.UR2");
  EXPECT_TRUE(Contains(mixed.GetOneLine(), "format CSV, and a file before it of SlicerMarkups"));
}

TEST(CVAT, PointsOfSkeletonsAndNamesInAttributes)
{
  ExpectTwo("a.xml",
            CvatPicture(R"(<skeleton label="ceph"><points label="U1_tip" outside="0" points="10,20"/>
              <points label="L6_MB" points="30,40"><attribute name="sure">yes</attribute></points>
              <points label="U6_MB" outside="1" points="1,2"/></skeleton>)"),
            -0.5);
  ExpectTwo("a.xml",
            CvatPicture(R"(<points label="landmark" points="10,20"><attribute name="name">U1_tip</attribute></points>
              <points label="landmark" points="30,40"><attribute name="name">L6_MB</attribute></points>)"),
            -0.5);
}

TEST(CVAT, AMaskIsItsOutline)
{
  // Six by eight pixels of which all but the corners are painted, at (20, 30).
  const std::string mask =
    R"(<mask label="UR1" rle="1, 4, 1, 36, 1, 4, 1" left="20" top="30" width="6" height="8"></mask>)";
  const auto reader = Contours("a.xml", CvatPicture(mask));
  const auto polylines = Updated(reader)->GetOutput(itk::ToothCode::JawEnum::Upper)->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_TRUE(polylines[0].closed);
  double low[2] = { 1e9, 1e9 };
  double high[2] = { -1e9, -1e9 };
  for (const auto & point : polylines[0].points)
  {
    for (unsigned int i = 0; i < 2; ++i)
    {
      low[i] = std::min(low[i], point[i]);
      high[i] = std::max(high[i], point[i]);
    }
  }
  // Half-way between the pixels, whose centres are whole numbers.
  EXPECT_DOUBLE_EQ(low[0], 19.5);
  EXPECT_DOUBLE_EQ(high[0], 25.5);
  EXPECT_DOUBLE_EQ(low[1], 29.5);
  EXPECT_DOUBLE_EQ(high[1], 37.5);
  const auto problem = [](const std::string & attributes) {
    return ContourError("a.xml", CvatPicture("<mask label=\"UR1\" " + attributes + "></mask>")).GetOneLine();
  };
  EXPECT_TRUE(
    Contains(problem(R"(rle="1, 2" left="0" top="0" width="2" height="2")"), "runs of 3 pixels, and its box 4"));
  EXPECT_TRUE(Contains(problem(R"(rle="1, 9" left="0" top="0" width="2" height="2")"), "more pixels than its box"));
  EXPECT_TRUE(Contains(problem(R"(rle="4" left="0" top="0" width="2" height="2")"), "marks no pixel"));
  EXPECT_TRUE(Contains(problem(R"(rle="0, 4" left="99" top="0" width="2" height="2")"), "does not lie in the picture"));
  EXPECT_TRUE(Contains(problem(R"(rle="0, a" left="0" top="0" width="2" height="2")"), "\"a\" is no number of pixels"));
}

TEST(VIA, ShapesOfVersion3)
{
  const auto text = [](const std::string & metadata) {
    return R"({"project": {"pname": "c"}, "config": {}, "attribute": {"1": {"aname": "tooth", "type": 1, "options": {}},
      "2": {"aname": "point", "type": 4, "options": {"0": "L6_MB", "1": "U1_tip"}}},
      "file": {"1": {"fid": "1", "fname": "ceph.png", "type": 2}}, "metadata": {)" +
           metadata + R"(}, "view": {"1": {"fid_list": ["1"]}, "2": {"fid_list": ["2"]}}})";
  };
  const auto reader =
    Contours("a.json", text(R"("1_a": {"vid": "1", "z": [], "xy": [7, 1, 2, 3, 2, 3, 6], "av": {"1": "UR1"}},
                      "1_b": {"vid": "1", "z": [], "xy": [6, 1, 2, 3, 2], "av": {"1": "46"}},
                      "1_c": {"vid": "1", "z": [], "xy": [2, 1, 2, 3, 4], "av": {"1": "UR3"}},
                      "2_d": {"vid": "2", "z": [], "xy": [6, 1, 2, 3, 2], "av": {"1": "UR2"}})"));
  reader->Update();
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::VIA);
  const auto upper = reader->GetUpperOutput()->GetPolylines();
  ASSERT_EQ(upper.size(), 1u);
  EXPECT_TRUE(upper[0].closed);
  EXPECT_DOUBLE_EQ(upper[0].points.at(2)[1], 5.5);
  EXPECT_FALSE(reader->GetLowerOutput()->GetPolylines().at(0).closed);
  EXPECT_TRUE(Contains(reader->GetWarnings().at(0), "shape 2 is no contour"));
  ExpectTwo("a.json",
            text(R"("1_a": {"vid": "1", "xy": [1, 10, 20], "av": {"2": "1"}},
                    "1_b": {"vid": "1", "xy": [1, 30, 40], "av": {"2": "0"}})"),
            -0.5);
}

TEST(Supervisely, JointsOfAGraphAreLandmarks)
{
  ExpectTwo("a.json",
            R"({"size": {"width": 100, "height": 200}, "objects": [{"geometryType": "graph", "classTitle": "ceph",
      "nodes": {"U1_tip": {"loc": [10, 20]}, "L6_MB": {"loc": [30, 40]}}}]})",
            -0.5);
}

namespace
{
/** A segmentation as 3D Slicer saves it: label 1 fills columns 2 to 7 and rows 3 to 9 of 12 x 14 pixels, label 2 the
 * same columns from row 11 on. */
std::string
Segmentation(const std::string & header)
{
  std::string text = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 12 14 1\nencoding: raw\n" + header + "\n";
  for (int y = 0; y < 14; ++y)
  {
    for (int x = 0; x < 12; ++x)
    {
      const bool inside = x >= 2 && x <= 7;
      text += inside && y >= 3 && y <= 9 ? '\1' : inside && y >= 11 && y <= 12 ? '\2' : '\0';
    }
  }
  return text;
}

std::string
Segment(int number, const std::string & name)
{
  const std::string key = "Segment" + std::to_string(number);
  return key + "_ID:=s\n" + key + "_Name:=" + name + "\n" + key + "_LabelValue:=" + std::to_string(number + 1) + "\n";
}
} // namespace

TEST(LabelImages, SegmentsOf3DSlicerAreCalledAsTheirNamesSay)
{
  const std::string name = "Segmentation.seg.nrrd";
  const auto        whole = Contours(name, Segmentation(Segment(0, "UR1") + Segment(1, "Bone")));
  whole->SetImageSize({ { 12, 14 } });
  const auto polylines = Updated(whole)->GetOutput(itk::ToothCode::JawEnum::Upper)->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_EQ(polylines[0].code.GetName(), "UR1");
  EXPECT_TRUE(Contains(whole->GetWarnings().at(0), "segments: no teeth, left out: bone"));

  // A jaw, and a tooth without a side.
  const auto jaw = Contours(name, Segmentation(Segment(0, "Maxilla") + Segment(1, "L6")));
  jaw->SetImageSize({ { 12, 14 } });
  Updated(jaw);
  EXPECT_FALSE(jaw->GetUpperOutput()->GetPolylines().at(0).code.IsKnown());
  EXPECT_EQ(jaw->GetNumberOfSidelessCodes(), 1u);

  // The part of the radiograph that has something in it.
  const std::string part = "Segmentation_ReferenceImageExtentOffset:=50 60 0\n" + Segment(0, "11");
  const auto        cropped = Contours(name, Segmentation(part));
  const auto        moved = Updated(cropped)->GetOutput(itk::ToothCode::JawEnum::Upper)->GetPolylines();
  ASSERT_EQ(moved.size(), 1u);
  double left = 1e9;
  double top = 1e9;
  for (const auto & point : moved[0].points)
  {
    left = std::min(left, point[0]);
    top = std::min(top, point[1]);
  }
  EXPECT_DOUBLE_EQ(left, 51.5);
  EXPECT_DOUBLE_EQ(top, 62.5);

  // It may say how large the radiograph is: another one is an error.
  const std::string geometry = "Segmentation_ConversionParameters:=Smoothing factor|0.5|x&Reference image "
                               "geometry|-1;0;0;0;0;-1;0;0;0;0;1;0;0;0;0;1;0;99;0;199;0;0;|y\n";
  EXPECT_EQ(Updated(Contours(name, Segmentation(geometry + part)))->GetReadImageSize()[1], 200u);
  const auto other = Contours(name, Segmentation(geometry + part));
  other->SetImageSize({ { 50, 100 } });
  const auto error = itk::ExpectInputError([&] { other->Update(); });
  EXPECT_TRUE(Contains(error.GetOneLine(), "is 100 x 200, but the image is 50 x 100"));

  // Two segments that overlap have a layer each.
  const auto layers = ContourError(name,
                                   "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 3\nkinds: list domain domain\n"
                                   "encoding: raw\n" +
                                     Segment(0, "UR1") + Segment(1, "UR2") + "\n" + std::string(12, '\1'));
  EXPECT_TRUE(Contains(layers.GetOneLine(), "segments that overlap, in 2 layers")) << layers.GetOneLine();

  // Names that Slicer made up say nothing: numbers are teeth then, or an error.
  EXPECT_TRUE(
    Contains(ContourError(name, Segmentation(Segment(0, "Segment_1"))).GetOneLine(), "no FDI tooth numbers: 1, 2"));
}

TEST(AnnotationTools, AFileWithoutAnOutlineIsNoTracing)
{
  const auto points = ContourError("a.json",
                                   R"({"imageWidth": 100, "imageHeight": 200, "shapes": [
      {"label": "UR1", "points": [[1, 2], [3, 4]], "shape_type": "mask"}]})");
  EXPECT_EQ(points.GetField(), "contours");
  EXPECT_TRUE(Contains(points.GetOneLine(), "has no outline (shapes[0]: a shape of type mask is no contour"));
  EXPECT_TRUE(Contains(points.GetOneLine(), "export polygons"));
}
