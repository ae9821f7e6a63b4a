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

using itk::Contains;
using itk::DentalContourFileReader;
using Landmarks2D = itk::DentalLandmarkFileReader<2>;
using FormatEnum = itk::AnnotationFileFormatEnum;

namespace
{
DentalContourFileReader::Pointer
Reader(const std::string & name, const std::string & text)
{
  const auto reader = DentalContourFileReader::New();
  reader->SetFileName(itk::WriteTestFile(name, text));
  return reader;
}

/** The warnings in one text. */
std::string
Warnings(const itk::AnnotationFileReaderBase * reader)
{
  std::string text;
  for (const std::string & warning : reader->GetWarnings())
  {
    text += warning + '\n';
  }
  return text;
}

/** A triangle that every format of these tests has: (10.5, 20.5), (30.5, 20.5), (30.5, 60.5) from the picture's corner.
 */
void
ExpectTriangle(const DentalContourFileReader * reader, FormatEnum format)
{
  EXPECT_EQ(reader->GetReadFileFormat(), format);
  EXPECT_EQ(reader->GetReadImageSize()[0], 100u);
  EXPECT_EQ(reader->GetReadImageSize()[1], 200u);
  const auto upper = reader->GetOutput(itk::ToothCode::JawEnum::Upper)->GetPolylines();
  ASSERT_EQ(upper.size(), 1u);
  EXPECT_EQ(upper[0].code.GetName(), "UR1");
  EXPECT_TRUE(upper[0].closed);
  ASSERT_EQ(upper[0].points.size(), 3u);
  // Half a pixel less, as (0, 0) is the centre of the first one.
  EXPECT_NEAR(upper[0].points[0][0], 10.0, 1e-9);
  EXPECT_NEAR(upper[0].points[0][1], 20.0, 1e-9);
  EXPECT_NEAR(upper[0].points[2][1], 60.0, 1e-9);
}

const char * const Cvat = R"(<?xml version="1.0" encoding="utf-8"?>
<annotations>
  <version>1.1</version>
  <meta><task><name>cephs</name></task></meta>
  <image id="0" name="other.png" width="10" height="10"><polygon label="UR1" points="1,1;2,2;1,2"/></image>
  <image id="1" name="folder/Ceph.png" width="100" height="200">
    <polygon label="Tooth" points="10.50,20.50;30.50,20.50;30.50,60.50" occluded="0" z_order="0">
      <attribute name="fdi"> 11 </attribute>
    </polygon>
    <polyline label="Calibration_30mm" points="5.0,10.0;5.0,70.0;5.0,130.0" occluded="0"/>
    <polyline label="soft tissue" points="1,1;2,2"/>
    <points label="U1_tip" points="30.50,60.50"/>
    <box label="UR1" xtl="1" ytl="1" xbr="2" ybr="2"/>
  </image>
</annotations>)";

const char * const Coco = R"({"images": [{"id": 7, "width": 100, "height": 200, "file_name": "ceph.png"}],
 "categories": [{"id": 1, "name": "11"}, {"id": 2, "name": "points", "keypoints": ["U1_tip", "L1_tip"]},
                {"id": 3, "name": "soft tissue"}],
 "annotations": [
  {"id": 1, "image_id": 7, "category_id": 1, "segmentation": [[10.5, 20.5, 30.5, 20.5, 30.5, 60.5]], "iscrowd": 0},
  {"id": 2, "image_id": 7, "category_id": 2, "keypoints": [30.5, 60.5, 2, 0, 0, 0], "num_keypoints": 1},
  {"id": 4, "image_id": 7, "category_id": 3, "segmentation": [[1, 1, 2, 2, 1, 2]]},
  {"id": 5, "image_id": 8, "category_id": 1, "segmentation": [[1, 1, 2, 2, 1, 2]]}]})";

const char * const Via =
  R"({"_via_settings": {}, "_via_img_metadata": {"ceph.png1234": {"filename": "ceph.png", "size": 1234,
 "regions": [
  {"shape_attributes": {"name": "polygon", "all_points_x": [10.5, 30.5, 30.5], "all_points_y": [20.5, 20.5, 60.5]},
   "region_attributes": {"kind": "crown", "tooth": "#11"}},
  {"shape_attributes": {"name": "point", "cx": 30.5, "cy": 60.5}, "region_attributes": {"name": "U1_tip"}},
  {"shape_attributes": {"name": "circle", "cx": 3, "cy": 6, "r": 1}, "region_attributes": {"name": "U1_tip"}}],
 "file_attributes": {}}}})";

const char * const ViaTable =
  R"(filename,file_size,file_attributes,region_count,region_id,region_shape_attributes,region_attributes
other.png,99,"{}",0,0,"{}","{}"
ceph.png,1234,"{}",3,0,"{""name"":""polygon"",""all_points_x"":[10.5,30.5,30.5],""all_points_y"":[20.5,20.5,60.5]}","{""kind"":""crown"",""tooth"":""#11""}"
ceph.png,1234,"{}",3,1,"{""name"":""point"",""cx"":30.5,""cy"":60.5}","{""name"":""U1_tip""}"
ceph.png,1234,"{}",3,2,"{""name"":""circle"",""cx"":3,""cy"":6,""r"":1}","{""name"":""U1_tip""}"
)";

const char * const LabelStudio = R"([{"id": 1, "data": {"image": "/data/upload/1/1a2b3c4d-ceph.png"}, "annotations": [
 {"id": 1, "was_cancelled": true, "result": []},
 {"id": 2, "was_cancelled": false, "result": [
  {"original_width": 100, "original_height": 200, "image_rotation": 0, "type": "polygonlabels", "id": "a",
   "value": {"points": [[10.5, 10.25], [30.5, 10.25], [30.5, 30.25]], "closed": true, "polygonlabels": ["Tooth 11"]}},
  {"original_width": 100, "original_height": 200, "image_rotation": 0, "type": "keypointlabels", "id": "b",
   "value": {"x": 30.5, "y": 30.25, "width": 0.5, "keypointlabels": ["U1_tip"]}},
  {"type": "choices", "value": {"choices": ["good"]}}]}]}])";

const char * const Supervisely = R"({"description": "", "tags": [], "size": {"height": 200, "width": 100}, "objects": [
 {"classTitle": "UR1", "geometryType": "polygon", "tags": [],
  "points": {"exterior": [[10.5, 20.5], [30.5, 20.5], [30.5, 60.5]], "interior": []}},
 {"classTitle": "U1_tip", "geometryType": "point", "points": {"exterior": [[30.5, 60.5]], "interior": []}},
 {"classTitle": "UR2", "geometryType": "bitmap", "bitmap": {"data": "eJ", "origin": [1, 1]}}]})";
} // namespace

TEST(AnnotationTools, OneTriangleFromEveryFormat)
{
  const auto cvat = Reader("annotations.xml", Cvat);
  cvat->SetImageFileName("somewhere/ceph.PNG");
  cvat->Update();
  ExpectTriangle(cvat, FormatEnum::CVAT);
  EXPECT_TRUE(Contains(Warnings(cvat), "no teeth, left out: soft tissue"));
  EXPECT_TRUE(Contains(Warnings(cvat), "<box>"));

  const auto coco = Reader("coco.json", Coco);
  coco->Update();
  ExpectTriangle(coco, FormatEnum::COCO);
  EXPECT_TRUE(Contains(Warnings(coco), "left out: soft tissue"));

  const auto via = Reader("via.json", Via);
  via->SetImageSize({ { 100, 200 } });
  via->Update();
  ExpectTriangle(via, FormatEnum::VIA);
  EXPECT_TRUE(Contains(Warnings(via), "circle"));

  const auto viaTable = Reader("via.csv", ViaTable);
  viaTable->SetImageSize({ { 100, 200 } });
  viaTable->SetImageFileName("ceph.png");
  viaTable->Update();
  ExpectTriangle(viaTable, FormatEnum::VIA);
  EXPECT_TRUE(Contains(Warnings(viaTable), "via.csv: line 5: a region of the shape circle")) << Warnings(viaTable);

  const auto labelStudio = Reader("project.json", LabelStudio);
  labelStudio->Update();
  ExpectTriangle(labelStudio, FormatEnum::LabelStudio);

  const auto supervisely = Reader("ceph.png.json", Supervisely);
  supervisely->Update();
  ExpectTriangle(supervisely, FormatEnum::Supervisely);
  EXPECT_TRUE(Contains(Warnings(supervisely), "bitmap"));
}

TEST(AnnotationTools, PointsOfEveryFormatAreLandmarks)
{
  const std::pair<const char *, const char *> files[] = { { "a.xml", Cvat },         { "b.json", Coco },
                                                          { "c.json", Via },         { "c.csv", ViaTable },
                                                          { "d.json", LabelStudio }, { "e.json", Supervisely } };
  for (const auto & [name, text] : files)
  {
    const auto cephalometric = itk::CephalometricLandmarkFileReader::New();
    cephalometric->SetFileName(itk::WriteTestFile(name, text));
    cephalometric->SetImageFileName("ceph.png");
    cephalometric->Update();
    ASSERT_EQ(cephalometric->GetOutput()->GetNumberOfLandmarks(), 1u) << name;
    const auto * tip = cephalometric->GetOutput()->Find("U1_tip");
    ASSERT_NE(tip, nullptr) << name;
    EXPECT_NEAR(tip->point[0], 30.0, 1e-9) << name;
    EXPECT_NEAR(tip->point[1], 60.0, 1e-9) << name;
    const auto threeD = itk::DentalLandmarkFileReader<3>::New();
    threeD->SetFileName(cephalometric->GetFileName());
    EXPECT_TRUE(Contains(itk::ExpectInputError([&] { threeD->Update(); }).GetProblem(), "no 3-D landmarks")) << name;
  }
}

TEST(AnnotationTools, ALineAlongARulerTellsTheSpacingAndIsNoContour)
{
  const auto reader = Reader("annotations.xml", Cvat);
  reader->SetImageFileName("ceph.png");
  reader->Update();
  ASSERT_EQ(reader->GetCalibrations().size(), 1u);
  EXPECT_EQ(reader->GetCalibrations()[0].label, "Calibration_30mm");
  EXPECT_EQ(reader->GetCalibrations()[0].millimetres, 30.0);
  EXPECT_EQ(reader->GetCalibrations()[0].pixels, 120.0);
  EXPECT_FALSE(Contains(Warnings(reader), "Calibration"));

  for (const auto & [label, millimetres] :
       { std::pair<const char *, double>{ "calibration 5 cm", 50.0 }, { "Ruler-45.5 mm", 45.5 } })
  {
    const auto labelme = Reader("l.json",
                                std::string(R"({"imageHeight": 9, "imageWidth": 9, "shapes": [
      {"label": "11", "points": [[1, 1], [2, 2]], "shape_type": "linestrip"}, {"label": ")") +
                                  label + R"(", "points": [[1, 1], [4, 5]], "shape_type": "line"}]})");
    labelme->Update();
    ASSERT_EQ(labelme->GetCalibrations().size(), 1u) << label;
    EXPECT_EQ(labelme->GetCalibrations()[0].millimetres, millimetres);
    EXPECT_EQ(labelme->GetCalibrations()[0].pixels, 5.0);
  }
}

TEST(AnnotationTools, OfSeveralPicturesTheRadiographsIsTaken)
{
  const auto reader = Reader("annotations.xml", Cvat);
  const auto error = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_TRUE(Contains(error.GetProblem(), "2 pictures (other.png, Ceph.png)")) << error.GetProblem();
  reader->SetImageFileName("third.png");
  EXPECT_TRUE(Contains(itk::ExpectInputError([&] { reader->Update(); }).GetProblem(), "none of the radiograph's name"));
  reader->SetImageFileName("other.png");
  reader->Update();
  EXPECT_EQ(reader->GetReadImageSize()[0], 10u);
}

TEST(AnnotationTools, WhatATagSaysIsOfThePictureAndOfNoShape)
{
  const auto reader = Reader("a.xml", R"(<annotations><image name="a" width="100" height="200">
    <polyline label="tooth line" points="1,1;2,2"/>
    <tag label="quality"><attribute name="tooth">UR2</attribute></tag>
    <polyline label="tooth" points="3,3;4,4"><attribute name="code">UR1</attribute></polyline>
    <tag label="quality"><attribute name="tooth">UR3</attribute></tag></image></annotations>)");
  reader->Update();
  const auto upper = reader->GetUpperOutput()->GetPolylines();
  ASSERT_EQ(upper.size(), 1u);
  EXPECT_EQ(upper[0].code.GetName(), "UR1");
  EXPECT_TRUE(Contains(Warnings(reader), "left out: tooth line"));
}

/** A number may be a tooth's; one with a fraction is none, and one beyond all whole numbers is not converted to any. */
TEST(AnnotationTools, NumbersAreNamesWhereTheyAreWhole)
{
  const auto read = [](const std::string & number) {
    const auto reader = Reader("a.json",
                               R"({"description": "", "tags": [], "size": {"height": 200, "width": 100}, "objects": [
      {"classTitle": "UR2", "geometryType": "line", "points": {"exterior": [[1, 1], [2, 2]], "interior": []}},
      {"classTitle": "crown", "tags": [{"name": "number", "value": )" +
                                 number + R"(}], "geometryType": "line", "points": {"exterior": [[3, 3], [4, 4]]}}]})");
    reader->Update();
    return reader->GetUpperOutput()->GetPolylines();
  };
  const auto whole = read("11");
  ASSERT_EQ(whole.size(), 2u);
  EXPECT_EQ(whole[1].code.GetName(), "UR1");
  for (const char * number : { "11.7", "1e300", "-1e300", "9007199254740993" })
  {
    EXPECT_EQ(read(number).size(), 1u) << number;
  }
}

TEST(AnnotationTools, DamagedFilesAreRefusedInWords)
{
  const auto problem = [](const std::string & name, const std::string & text) {
    const auto reader = Reader(name, text);
    return itk::ExpectInputError([&] { reader->Update(); }).GetOneLine();
  };
  const std::string image = "<annotations><image name=\"a\" width=\"9\" height=\"9\">";
  EXPECT_TRUE(Contains(problem("a.xml", "<annotations><image>"), "no well-formed XML"));
  EXPECT_TRUE(Contains(problem("b.xml", "<other/>"), "root <other>"));
  EXPECT_TRUE(Contains(problem("c.xml", "<annotations><track/></annotations>"), "CVAT for images"));
  EXPECT_TRUE(Contains(problem("d.xml", "<annotations/>"), "no picture"));
  EXPECT_TRUE(
    Contains(problem("e.xml", image + "<polygon label=\"11\" points=\"1,x\"/></image></annotations>"), "1,x"));
  EXPECT_TRUE(Contains(problem("f.xml", "<annotations><image name=\"a\" width=\"-1\" height=\"9\"/></annotations>"),
                       "no number of pixels"));
  // A few lines of entities can stand for gigabytes.
  EXPECT_TRUE(Contains(problem("g.xml",
                               "<!DOCTYPE annotations [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;\">]>"
                               "<annotations>&b;</annotations>"),
                       "declares entities"));
  std::string deep = "<annotations>";
  for (int i = 0; i < 1000; ++i)
  {
    deep += "<a>";
  }
  EXPECT_TRUE(Contains(problem("h.xml", deep), "nested deeper"));
  EXPECT_TRUE(Contains(problem("i.json", R"({"images": [], "annotations": [], "categories": []})"), "no picture"));
  EXPECT_TRUE(Contains(problem("j.json", R"({"images": [{"id": 1, "width": 9, "height": 9}], "categories": [],
    "annotations": [{"image_id": 1, "category_id": 5}]})"),
                       "annotations[0].category_id"));
  // Two points and a third of one are not two points.
  EXPECT_TRUE(Contains(problem("keypoints.json", R"({"images": [{"id": 1, "width": 9, "height": 9}],
    "categories": [{"id": 5, "name": "points", "keypoints": ["U1_tip", "L1_tip"]}],
    "annotations": [{"image_id": 1, "category_id": 5, "keypoints": [1, 1, 2, 2, 2, 2, 3]}]})"),
                       "has 7 numbers"));
  EXPECT_TRUE(Contains(problem("k.json", R"([{"image": "a.png", "label": [{"original_width": 9, "original_height": 9,
    "image_rotation": 90, "points": [[1, 1]], "polygonlabels": ["11"]}]}])"),
                       "image_rotation"));
  EXPECT_TRUE(Contains(problem("l.svg", "<svg><path/></svg>"), "SVG"));
  EXPECT_TRUE(Contains(problem("m.xlsx", std::string("PK\x03\x04\0\0", 6) + "xl/workbook.xml"), "Excel"));
}

TEST(AnnotationTools, WhatIsNoToothIsLeftOutAndNamed)
{
  const auto reader = Reader("c.csv", "Soft tissue;1;2\n tooth 11 ;3;4\nMaxilla;5;6\nSella;7;8\n");
  reader->SetImageSize({ { 100, 200 } });
  reader->Update();
  EXPECT_TRUE(Contains(Warnings(reader), "no teeth, left out: Soft tissue, Sella")) << Warnings(reader);
  const auto upper = reader->GetUpperOutput()->GetPolylines();
  ASSERT_EQ(upper.size(), 2u);
  EXPECT_EQ(upper[0].code.GetName() + upper[1].code.GetName(), "UR1");

  const auto none = Reader("n.csv", "Soft tissue,1,2\nSella,7,8\n");
  none->SetImageSize({ { 100, 200 } });
  const auto error = itk::ExpectInputError([&] { none->Update(); });
  EXPECT_EQ(error.GetField(), "line 1");
  EXPECT_TRUE(Contains(error.GetProblem(), "Soft tissue, Sella")) << error.GetProblem();
  // A code that the numbering has not is a mistake, not another kind of line.
  const auto wrong = Reader("w.csv", "11,1,2\n19,7,8\n");
  wrong->SetImageSize({ { 100, 200 } });
  EXPECT_EQ(itk::ExpectInputError([&] { wrong->Update(); }).GetField(), "line 2");
}

TEST(AnnotationTools, CodesWithoutASideAreCountedAndTakeTheSideAskedFor)
{
  const char * const text = R"({"image_size": [9, 9], "contours": {"upper": [{"code": "U1", "points": [[1, 1]]}],
    "lower": [{"code": " l6 ", "points": [[1, 1]]}, {"code": "81", "points": [[2, 2]]}]}})";
  const auto         reader = Reader("c.json", text);
  reader->Update();
  EXPECT_EQ(reader->GetNumberOfSidelessCodes(), 2u);
  EXPECT_EQ(reader->GetUpperOutput()->GetPolylines().at(0).code.GetName(), "UR1");
  EXPECT_EQ(reader->GetLowerOutput()->GetPolylines().at(1).code.GetName(), "LRA");
  reader->SidelessCodesAreLeftOn();
  reader->Update();
  EXPECT_EQ(reader->GetUpperOutput()->GetPolylines().at(0).code.GetName(), "UL1");
  EXPECT_EQ(reader->GetLowerOutput()->GetPolylines().at(0).code.GetName(), "LL6");
}

TEST(AnnotationTools, TablesOfSpreadsheets)
{
  const auto read = [](const std::string & text) {
    const auto reader = Reader("t.csv", text);
    reader->SetImageSize({ { 100, 200 } });
    reader->Update();
    const auto upper = reader->GetUpperOutput()->GetPolylines();
    return upper.size() == 1 && upper[0].points.size() == 2 && upper[0].points[1][0] == 3.25 &&
               upper[0].points[1][1] == 4.0
             ? std::string()
             : "read otherwise: " + text;
  };
  EXPECT_EQ(read("UR1;1,5;2\nUR1;3,25;4\n"), "");
  EXPECT_EQ(read("UR1\t1,5\t2\nUR1\t3,25\t4\n"), "");
  EXPECT_EQ(read("UR1,\"1,5\",2\nUR1,\"3,25\",\"4\"\n"), "");
  EXPECT_EQ(read("index,x,y,label,note\n1,1.5,2,UR1,a\n2,3.25,4,UR1,\n"), "");
  EXPECT_EQ(read("Tooth;X (px);Y (px)\nUR1;1,5;2\nUR1;3,25;4\n"), "");
  EXPECT_EQ(read("Zahn;Rechtswert;Hochwert\nUR1;1,5;2\nUR1;3,25;4\n"), "");
  const auto problem = [](const std::string & text) {
    const auto reader = Reader("t.csv", text);
    reader->SetImageSize({ { 100, 200 } });
    return itk::ExpectInputError([&] { reader->Update(); }).GetOneLine();
  };
  EXPECT_TRUE(Contains(problem("x,y\n1,2\n"), "without a column of labels"));
  EXPECT_TRUE(Contains(problem("label,x_mm,y_mm\nUR1,1,2\n"), "is in mm"));
  EXPECT_TRUE(Contains(problem("UR1;1,2,3;2\n"), "is no number"));
  EXPECT_TRUE(Contains(problem("note,x,y,label\na,1\n"), "expected those of the header"));
}

TEST(AnnotationTools, TablesOfVIAAreReadAsVIAWritesThem)
{
  const std::string header =
    "filename,file_size,file_attributes,region_count,region_id,region_shape_attributes,region_attributes\n";
  const std::string line =
    R"("ceph, left.png",1,"{}",1,0,"{""name"":""polyline"",""all_points_x"":[1.5,2.5],""all_points_y"":[3.5,4.5]}",)"
    R"("{""Zahn"":""21"",""note"":""a \""quote\"""",""box"":{""x"":true}}")";
  const auto points = [](const std::string & text, FormatEnum format = FormatEnum::Automatic) {
    const auto reader = Reader("t.csv", text);
    reader->SetImageSize({ { 100, 200 } });
    reader->SetFileFormat(format);
    reader->Update();
    const auto upper = reader->GetUpperOutput()->GetPolylines();
    return upper.size() == 1 && upper[0].code.GetName() == "UL1" && !upper[0].closed && upper[0].points[1][0] == 2.0 &&
           upper[0].points[1][1] == 4.0;
  };
  EXPECT_TRUE(points(header + line));
  EXPECT_TRUE(points(header + line + "\n", FormatEnum::VIA));
  EXPECT_TRUE(points("#" + header + "\n" + line + "\r\n"));
  EXPECT_TRUE(points("\xef\xbb\xbf" + header + line));

  const auto error = [&header](const std::string & row) {
    const auto reader = Reader("t.csv", header + row);
    reader->SetImageSize({ { 100, 200 } });
    return itk::ExpectInputError([&] { reader->Update(); }).GetOneLine();
  };
  EXPECT_TRUE(Contains(error("a.png,1,\"{}\"\n"), "line 2: has 3 columns"));
  EXPECT_TRUE(Contains(error(R"(a.png,1,"{}",1,0,"{""name"":","{}")"), "line 2: a region is no JSON"));
  EXPECT_TRUE(Contains(error(R"(a.png,1,"{}",1,0,"{""name"":""polygon"",""all_points_x"":[1]}","{}")"),
                       "line 2, shape_attributes.all_points_y: missing"));
  EXPECT_TRUE(Contains(error(""), "no picture"));
  EXPECT_TRUE(Contains(error("a.png,1,\"{}\",0,0,\"{}\",\"{}\"\nb.png,1,\"{}\",0,0,\"{}\",\"{}\"\n"),
                       "2 pictures (a.png, b.png)"));
  // A table that somebody else wrote is no table of VIA, whatever he says.
  const auto other = Reader("t.csv", "label,x,y\nUR1,1,2\n");
  other->SetImageSize({ { 100, 200 } });
  other->SetFileFormat(FormatEnum::VIA);
  EXPECT_TRUE(Contains(itk::ExpectInputError([&] { other->Update(); }).GetProblem(), "JSON"));
}

namespace
{
/** Runs down the columns of a mask of 12 columns and 10 rows, as COCO has them. */
std::vector<int>
FindRuns(const std::vector<std::string> & rows)
{
  std::vector<int> runs{ 0 };
  for (std::size_t u = 0; u < rows[0].size(); ++u)
  {
    for (const std::string & row : rows)
    {
      if ((row[u] != '.') != (runs.size() % 2 == 0))
      {
        runs.push_back(0);
      }
      ++runs.back();
    }
  }
  return runs;
}

/** A COCO file of that mask. */
std::string
MaskFile(const std::string & counts, const std::string & size = "[10, 12]")
{
  return R"({"images": [{"id": 7, "width": 12, "height": 10, "file_name": "ceph.png"}],
    "categories": [{"id": 1, "name": "11"}],
    "annotations": [{"image_id": 7, "category_id": 1, "segmentation": {"size": )" +
         size + R"(, "counts": )" + counts + "}}]}";
}

std::string
AsNumbers(const std::vector<int> & runs)
{
  std::string text;
  for (const int run : runs)
  {
    text += (text.empty() ? "[" : ", ") + std::to_string(run);
  }
  return text + "]";
}

/** In COCO's own text: differences, five bits a character, the lowest first. */
std::string
AsText(const std::vector<int> & runs)
{
  std::string text = "\"";
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    int  value = i > 2 ? runs[i] - runs[i - 2] : runs[i];
    bool more = true;
    while (more)
    {
      const int bits = value & 31;
      value >>= 5;
      more = (bits & 16) != 0 ? value != -1 : value != 0;
      text += static_cast<char>('0' + bits + (more ? 32 : 0));
      text += text.back() == '\\' ? "\\" : "";
    }
  }
  return text + '"';
}

/** A NRRD of numbers as text. */
std::string
Nrrd(const std::vector<std::string> & rows, const std::string & type = "int")
{
  std::string text = "NRRD0004\ntype: " + type + "\ndimension: 2\nsizes: " + std::to_string(rows[0].size()) + ' ' +
                     std::to_string(rows.size()) + "\nencoding: ascii\n\n";
  for (const std::string & row : rows)
  {
    for (const char cell : row)
    {
      // '.' nothing, 'a' tooth 11, 'b' tooth 41, 'c' 255, 'd' 1.
      text += cell == 'a' ? "11 " : cell == 'b' ? "41 " : cell == 'c' ? "255 " : cell == 'd' ? "1 " : "0 ";
    }
    text += '\n';
  }
  return text;
}
} // namespace

TEST(LabelImages, TeethOfALabelMapBecomeClosedContours)
{
  const auto reader = Reader("labels.nrrd",
                             Nrrd({ "............",
                                    ".aaaaaa.....",
                                    ".aaaaaa.....",
                                    ".aaaaaa..cc.",
                                    ".aaaaaa..cc.",
                                    "............",
                                    ".bbbbbb...b.",
                                    ".bbbbbb.....",
                                    ".bbbbbb.....",
                                    ".bbbbbb.....",
                                    "............" }));
  reader->SetNumbering(itk::ToothCode::NumberingEnum::Universal);
  reader->Update();
  EXPECT_EQ(reader->GetReadFileFormat(), FormatEnum::LabelImage);
  EXPECT_EQ(reader->GetReadImageSize()[0], 12u);
  EXPECT_EQ(reader->GetReadImageSize()[1], 11u);
  const auto upper = reader->GetUpperOutput()->GetPolylines();
  const auto lower = reader->GetLowerOutput()->GetPolylines();
  ASSERT_EQ(upper.size(), 1u);
  // A speck that a brush left is no second tooth.
  ASSERT_EQ(lower.size(), 1u);
  EXPECT_EQ(upper[0].code.GetName(), "UR1");
  EXPECT_EQ(lower[0].code.GetName(), "LR1");
  EXPECT_TRUE(upper[0].closed);
  // Half-way between pixels: six pixels from 1 to 6 reach from 0.5 to 6.5.
  const auto bounds = std::minmax_element(
    upper[0].points.begin(), upper[0].points.end(), [](const auto & a, const auto & b) { return a[0] < b[0]; });
  EXPECT_NEAR((*bounds.first)[0], 0.5, 1e-6);
  EXPECT_NEAR((*bounds.second)[0], 6.5, 1e-6);
  EXPECT_TRUE(Contains(Warnings(reader), "no teeth, left out: 255"));
  EXPECT_TRUE(Contains(Warnings(reader), "specks are left out beside FDI 41"));

  reader->SetImageSize({ { 13, 11 } });
  const auto error = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_TRUE(Contains(error.GetProblem(), "is 12 x 11, but the image is 13 x 11")) << error.GetProblem();
}

TEST(LabelImages, NumbersThatMayBeOtherTeethAreRefusedByName)
{
  const auto problem = [](const std::string & text) {
    const auto reader = Reader("labels.nrrd", text);
    return itk::ExpectInputError([&] { reader->Update(); }).GetOneLine();
  };
  const std::string classes = problem(Nrrd({ ".....", ".aadd", ".aadd", "....." }));
  EXPECT_TRUE(Contains(classes, "no FDI tooth numbers: 1")) << classes;
  const std::string mask = problem(Nrrd({ ".....", ".ccc.", ".ccc.", "....." }));
  EXPECT_TRUE(Contains(mask, "no FDI tooth numbers: 255")) << mask;
  EXPECT_TRUE(Contains(mask, "one file a tooth or jaw: \"contours\": {")) << mask;
  EXPECT_TRUE(Contains(problem(Nrrd({ ".....", "....." })), "all its pixels are 0"));
}

TEST(LabelImages, OneMaskATooth)
{
  const std::string filled = itk::WriteTestFile("ur1.nrrd",
                                                Nrrd({ "..........",
                                                       ".cccccc...",
                                                       ".cccccc...",
                                                       ".cccccc...",
                                                       ".cccccc...",
                                                       ".cccccc...",
                                                       ".cccccc...",
                                                       "..........",
                                                       "..........",
                                                       "..........",
                                                       "..........",
                                                       "..........",
                                                       ".........." }));
  const std::string other = itk::WriteTestFile("small.nrrd", Nrrd({ "....", ".cc.", "...." }));
  const auto        reader = DentalContourFileReader::New();
  reader->SetClassFiles({ { "UR1", filled }, { "mandible", filled } });
  reader->Update();
  EXPECT_EQ(reader->GetUpperOutput()->GetPolylines().at(0).code.GetName(), "UR1");
  EXPECT_TRUE(reader->GetUpperOutput()->GetPolylines().at(0).closed);
  EXPECT_FALSE(reader->GetLowerOutput()->GetPolylines().at(0).code.IsKnown());
  reader->SetClassFiles({ { "UR1", filled }, { "UR2", other } });
  const auto error = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_EQ(error.GetInputFile(), other);
  EXPECT_EQ(error.GetField(), "size");
}

/** One reader may be used for a patient with masks and then for one with a file. */
TEST(LabelImages, OfMasksAndAFileWhatIsSaidLastIsRead)
{
  const std::string mask =
    itk::WriteTestFile("ur1.nrrd", Nrrd({ "..........", ".cc.......", "..........", ".........." }));
  const std::string file = itk::WriteTestFile(
    "c.json", R"({"image_size": [9, 9], "contours": {"upper": [{"code": "UR2", "points": [[1, 1], [2, 2]]}]}})");
  const auto reader = DentalContourFileReader::New();
  const auto read = [&reader] {
    reader->Update();
    return reader->GetUpperOutput()->GetPolylines().at(0).code.GetName();
  };
  reader->SetFileName(file);
  reader->SetClassFiles({ { "UR1", mask } });
  EXPECT_EQ(read(), "UR1");
  reader->SetFileName(file);
  EXPECT_TRUE(reader->GetClassFiles().empty());
  EXPECT_EQ(read(), "UR2");
}

TEST(LabelImages, AMaskOfCOCOIsWhatTheSameMaskIsAsAPicture)
{
  const std::vector<std::vector<std::string>> masks = {
    { "............",
      "............",
      "...ccccc....",
      "..ccccccc...",
      "..ccccccc...",
      "..ccccccc...",
      "...ccccc....",
      "....ccc.....",
      "............",
      "............" },
    // Up to the picture's edges.
    { "cccc........",
      "cccc........",
      "cccc........",
      "ccccc.......",
      "ccccc.......",
      "ccccc.......",
      "ccccc.......",
      "ccccc.......",
      "cccc........",
      "cccc........" },
  };
  for (const auto & mask : masks)
  {
    const auto picture = DentalContourFileReader::New();
    picture->SetClassFiles({ { "11", itk::WriteTestFile("mask.nrrd", Nrrd(mask)) } });
    picture->Update();
    const auto expected = picture->GetUpperOutput()->GetPolylines();
    ASSERT_EQ(expected.size(), 1u);
    for (const std::string & counts : { AsNumbers(FindRuns(mask)), AsText(FindRuns(mask)) })
    {
      // A mask is in pixels whatever the corners of polygons are counted from.
      for (const auto origin :
           { itk::AnnotationPixelOriginEnum::FormatDefault, itk::AnnotationPixelOriginEnum::Centre })
      {
        const auto coco = Reader("coco.json", MaskFile(counts));
        coco->SetPixelOrigin(origin);
        coco->Update();
        const auto polylines = coco->GetUpperOutput()->GetPolylines();
        ASSERT_EQ(polylines.size(), 1u) << counts;
        EXPECT_EQ(polylines[0].code.GetName(), "UR1");
        EXPECT_TRUE(polylines[0].closed);
        ASSERT_EQ(polylines[0].points.size(), expected[0].points.size()) << counts;
        for (std::size_t i = 0; i < expected[0].points.size(); ++i)
        {
          EXPECT_NEAR(polylines[0].points[i][0], expected[0].points[i][0], 1e-9);
          EXPECT_NEAR(polylines[0].points[i][1], expected[0].points[i][1], 1e-9);
        }
      }
    }
  }
  // What COCO's own programs write of three by three pixels in the middle of five by five.
  EXPECT_EQ(AsText({ 6, 3, 2, 3, 2, 3, 6 }), "\"6320004\"");
}

TEST(LabelImages, AMaskThatIsNotOfThePictureIsRefused)
{
  const auto error = [](const std::string & counts, const std::string & size = "[10, 12]") {
    const auto reader = Reader("coco.json", MaskFile(counts, size));
    return itk::ExpectInputError([&] { reader->Update(); }).GetOneLine();
  };
  EXPECT_TRUE(Contains(error("[60, 60]", "[12, 10]"), "annotations[0].segmentation.size: is not the picture's"));
  EXPECT_TRUE(Contains(error("[60, 61]"), "has runs of 121 pixels"));
  EXPECT_TRUE(Contains(error("[120]"), "marks no pixel"));
  EXPECT_TRUE(Contains(error("[130, -10]"), "counts[1]"));
  EXPECT_TRUE(Contains(error("\"P\""), "character 2"));
  EXPECT_TRUE(Contains(error("\"0 \""), "character 2"));
  EXPECT_TRUE(Contains(error("\"O\""), "a run of -1 pixels"));
  EXPECT_TRUE(Contains(error("\"oooooooooooooooooo0\""), "character"));
  EXPECT_TRUE(Contains(error("null"), "counts"));
}

TEST(LabelImages, DrawnLinesAreWalkedAlongTheirMiddle)
{
  // One pixel of a dark line on white; all that differs from white is the line.
  const std::vector<std::string> drawing = { "cccccccccccc", "c.cccccccccc", "cc.ccccccccc", "ccc.cccccccc",
                                             "cccc......cc", "cccccccccccc", "cccccccccccc", "cccccccccccc" };
  const auto                     reader = DentalContourFileReader::New();
  reader->SetClassFiles({ { "UR1", itk::WriteTestFile("line.nrrd", Nrrd(drawing)) } });
  reader->Update();
  const auto upper = reader->GetUpperOutput()->GetPolylines();
  ASSERT_EQ(upper.size(), 1u);
  EXPECT_FALSE(upper[0].closed);
  ASSERT_EQ(upper[0].points.size(), 9u);
  const bool   forward = upper[0].points.front()[0] < upper[0].points.back()[0];
  const auto & first = forward ? upper[0].points.front() : upper[0].points.back();
  const auto & last = forward ? upper[0].points.back() : upper[0].points.front();
  EXPECT_EQ(first[0], 1.0);
  EXPECT_EQ(first[1], 1.0);
  EXPECT_EQ(last[0], 9.0);
  EXPECT_EQ(last[1], 4.0);

  // White on black is the same, and a ring is closed.
  const std::vector<std::string> ring = { "............", "....cccc....", "...c....c...", "...c....c...",
                                          "...c....c...", "....cccc....", "............", "............" };
  reader->SetClassFiles({ { "LR6", itk::WriteTestFile("ring.nrrd", Nrrd(ring)) } });
  reader->Update();
  const auto lower = reader->GetLowerOutput()->GetPolylines();
  ASSERT_EQ(lower.size(), 1u);
  EXPECT_TRUE(lower[0].closed);
  EXPECT_EQ(lower[0].points.size(), 14u);
}
