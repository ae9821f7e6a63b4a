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
#include "itkDentalContourFileWriter.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <sstream>

using itk::DentalContour;
using itk::DentalContourFileReader;
using itk::DentalContourFileWriter;
using JawEnum = itk::ToothCode::JawEnum;
using NumberingEnum = itk::ToothCode::NumberingEnum;

namespace
{
/** Six points inside a 100 x 200 image. */
const std::string SixPoints = "[[10, 20], [11, 20.5], [12, 21], [13, 21.5], [14, 22], [15, 22.5]]";

std::string
ContoursText(const std::string & upper, const std::string & lower, const std::string & more = "")
{
  return "{\"image_size\": [100, 200]" + more + ", \"contours\": {\"upper\": [" + upper + "], \"lower\": [" + lower +
         "]}}";
}

DentalContourFileReader::Pointer
MakeReader(const std::string & text)
{
  const auto reader = DentalContourFileReader::New();
  reader->SetFileName(itk::WriteTestFile("contours.json", text));
  return reader;
}

itk::DentalInputError
ReadError(const std::string & text)
{
  const auto reader = MakeReader(text);
  const auto error = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_EQ(error.GetInputFile(), reader->GetFileName());
  EXPECT_EQ(reader->GetUpperOutput()->GetNumberOfPoints(), 0u) << "half a result is left";
  EXPECT_EQ(reader->GetLowerOutput()->GetNumberOfPoints(), 0u) << "half a result is left";
  return error;
}

std::string
UpperTooth(const std::string & code, const std::string & points = SixPoints, const std::string & more = "")
{
  return "{\"code\": " + code + ", \"points\": " + points + more + "}";
}
} // namespace

TEST(DentalContourFileReader, ReadsBothJaws)
{
  const auto reader =
    MakeReader(ContoursText(UpperTooth("\"UR1\"") + ", {\"code\": \"UR2\", \"points\": []}", UpperTooth("\"LR6\"")));
  reader->Update();
  EXPECT_TRUE(reader->GetWarnings().empty());
  const auto upper = reader->GetUpperOutput()->GetPolylines();
  ASSERT_EQ(upper.size(), 1u);
  EXPECT_EQ(upper[0].code.GetName(), "UR1");
  EXPECT_FALSE(upper[0].closed);
  ASSERT_EQ(upper[0].points.size(), 6u);
  EXPECT_EQ(upper[0].points[1][0], 11.0);
  EXPECT_EQ(upper[0].points[1][1], 20.5);
  EXPECT_EQ(reader->GetLowerOutput()->GetPolylines().at(0).code.GetName(), "LR6");
  EXPECT_EQ(reader->GetReadImageSize()[0], 100u);
  EXPECT_EQ(reader->GetReadImageSize()[1], 200u);
  EXPECT_THROW(reader->GetOutput(JawEnum::Unknown), itk::ExceptionObject);
}

TEST(DentalContourFileReader, ReadsOnceUntilSomethingChanges)
{
  const auto   reader = MakeReader(ContoursText(UpperTooth("\"UR1\""), ""));
  unsigned int runs = 0;
  reader->AddObserver(itk::StartEvent(), [&runs](const itk::EventObject &) { ++runs; });
  reader->Update();
  reader->Update();
  reader->GetUpperOutput()->Update();
  reader->GetLowerOutput()->Update();
  EXPECT_EQ(runs, 1u);
  reader->SetFileName(itk::WriteTestFile("other.json", ContoursText("", UpperTooth("\"LR1\""))));
  reader->Update();
  EXPECT_EQ(runs, 2u);
  EXPECT_EQ(reader->GetUpperOutput()->GetNumberOfPoints(), 0u);
  EXPECT_EQ(reader->GetLowerOutput()->GetNumberOfPoints(), 6u);
}

TEST(DentalContourFileReader, CodesFollowTheNumbering)
{
  struct Example
  {
    const char *  more;
    NumberingEnum given;
    const char *  code;
    const char *  tooth;
  };
  for (const Example & example :
       { Example{ "", NumberingEnum::Quadrant, "\"ul3\"", "UL3" },
         Example{ "", NumberingEnum::Quadrant, "\"11\"", "UR1" },
         Example{ "", NumberingEnum::Quadrant, "11", "UR1" },
         Example{ ", \"numbering\": \"UR\"", NumberingEnum::Quadrant, "\"11\"", "UR1" },
         Example{ ", \"numbering\": \"FDI\"", NumberingEnum::Quadrant, "\"26\"", "UL6" },
         Example{ ", \"numbering\": \"FDI\"", NumberingEnum::FDI, "\"26\"", "UL6" },
         Example{ ", \"numbering\": \"universal\"", NumberingEnum::Quadrant, "\"3\"", "UR6" },
         Example{ ", \"numbering\": \"universal\"", NumberingEnum::Universal, "\"11\"", "UL3" },
         Example{ "", NumberingEnum::Universal, "3", "UR6" },
         Example{ "", NumberingEnum::FDI, "\"11\"", "UR1" } })
  {
    const auto reader = MakeReader(ContoursText(UpperTooth(example.code), "", example.more));
    reader->SetNumbering(example.given);
    reader->Update();
    EXPECT_EQ(reader->GetUpperOutput()->GetPolylines().at(0).code.GetName(), example.tooth)
      << example.code << example.more;
  }
}

TEST(DentalContourFileReader, CodeThatTheNumberingHasNotIsNamed)
{
  const std::string good = UpperTooth("\"UR1\"") + ", ";
  EXPECT_EQ(ReadError(ContoursText(good + good + good + UpperTooth("\"19\""), "")).GetField(),
            "contours.upper[3].code");
  EXPECT_EQ(ReadError(ContoursText("", UpperTooth("\"LR9\""))).GetField(), "contours.lower[0].code");
  // Without a numbering "3" is no universal number.
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"3\""), "")).GetField(), "contours.upper[0].code");
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"33\""), "", ", \"numbering\": \"universal\"")).GetField(),
            "contours.upper[0].code");
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("[]"), "")).GetField(), "contours.upper[0].code");
  EXPECT_EQ(ReadError(ContoursText("", "", ", \"numbering\": \"palmer\"")).GetField(), "numbering");
}

TEST(DentalContourFileReader, ContradictingNumberingsAreAnError)
{
  for (const auto & [stated, given] : { std::make_pair("universal", NumberingEnum::FDI),
                                        std::make_pair("FDI", NumberingEnum::Universal),
                                        std::make_pair("UR", NumberingEnum::Universal) })
  {
    const auto reader =
      MakeReader(ContoursText(UpperTooth("\"11\""), "", std::string(", \"numbering\": \"") + stated + '"'));
    reader->SetNumbering(given);
    EXPECT_EQ(itk::ExpectInputError([&] { reader->Update(); }).GetField(), "numbering");
  }
}

TEST(DentalContourFileReader, SwappedJawsAreFound)
{
  const auto error = ReadError(ContoursText(UpperTooth("\"LR1\""), UpperTooth("\"UR1\"")));
  EXPECT_EQ(error.GetField(), "contours.upper[0].code");
  EXPECT_TRUE(itk::Contains(error.GetRemedy(), "swapped"));
  EXPECT_EQ(ReadError(ContoursText("", UpperTooth("\"UR1\""))).GetField(), "contours.lower[0].code");
}

TEST(DentalContourFileReader, ContoursWithoutCodesAndClosedOnesAreLegal)
{
  const auto reader = MakeReader(ContoursText(
    UpperTooth("\"\"") + ", {\"points\": [[1, 2], [3, 4], [1, 2]]}, " +
      UpperTooth("null", "[[1, 1], [9, 1], [9, 9], [1, 1]]", ", \"closed\": true, \"weights\": [1, 0.5, 0, 1]"),
    ""));
  reader->Update();
  EXPECT_TRUE(reader->GetWarnings().empty());
  const auto polylines = reader->GetUpperOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 3u);
  for (const auto & polyline : polylines)
  {
    EXPECT_FALSE(polyline.code.IsKnown());
  }
  // An open line may end where it begins.
  EXPECT_FALSE(polylines[1].closed);
  EXPECT_EQ(polylines[1].points.size(), 3u);
  // The first point is not repeated, whether the file did so or not.
  EXPECT_TRUE(polylines[2].closed);
  EXPECT_EQ(polylines[2].points.size(), 3u);
  EXPECT_EQ(polylines[2].weights, (std::vector<double>{ 1.0, 0.5, 0.0 }));
}

TEST(DentalContourFileReader, WrongPointsAndWeightsAreNamed)
{
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"UR1\"", "[[1, 2], [1, 2, 3]]"), "")).GetField(),
            "contours.upper[0].points[1]");
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"UR1\"", "[[1, 2], [1, \"2\"]]"), "")).GetField(),
            "contours.upper[0].points[1][1]");
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"UR1\"", "[[1, null]]"), "")).GetField(),
            "contours.upper[0].points[0][1]");
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"UR1\"", "[1, 2]"), "")).GetField(), "contours.upper[0].points[0]");
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"UR1\"", "{}"), "")).GetField(), "contours.upper[0].points");
  EXPECT_TRUE(
    itk::Contains(ReadError(ContoursText(UpperTooth("\"UR1\"", "[[1, NaN]]"), "")).GetField(), "line 1, column "));
  EXPECT_TRUE(
    itk::Contains(ReadError(ContoursText(UpperTooth("\"UR1\"", "[[1, 1e400]]"), "")).GetField(), "line 1, column "));
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"UR1\"", "[[1, 2]]", ", \"weights\": [1, 1]"), "")).GetField(),
            "contours.upper[0].weights");
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"UR1\"", "[[1, 2], [3, 4]]", ", \"weights\": [1, -1]"), "")).GetField(),
            "contours.upper[0].weights[1]");
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"UR1\"", "[[1, 2], [3, 4]]", ", \"closed\": true"), "")).GetField(),
            "contours.upper[0]");
  EXPECT_EQ(ReadError(ContoursText(UpperTooth("\"UR1\"", "[]", ", \"closed\": 1"), "")).GetField(),
            "contours.upper[0].closed");
  EXPECT_EQ(ReadError(ContoursText("{\"code\": \"UR1\"}", "")).GetField(), "contours.upper[0].points");
}

TEST(DentalContourFileReader, WrongStructureIsNamed)
{
  EXPECT_EQ(ReadError("{\"image_size\": [100, 200]}").GetField(), "contours");
  EXPECT_EQ(ReadError("{\"image_size\": [100, 200], \"contours\": []}").GetField(), "contours");
  EXPECT_EQ(ReadError("{\"image_size\": [100, 200], \"contours\": {\"upper\": {}}}").GetField(), "contours.upper");
  EXPECT_EQ(ReadError("{\"image_size\": [100], \"contours\": {}}").GetField(), "image_size");
  EXPECT_EQ(ReadError("{\"image_size\": [100, 0], \"contours\": {}}").GetField(), "image_size[1]");
  EXPECT_EQ(ReadError("{\"image_size\": [100.5, 10], \"contours\": {}}").GetField(), "image_size[0]");
  EXPECT_EQ(ReadError("[1, 2]").GetField(), "");
  EXPECT_EQ(ReadError("{\"image_size\": [100, 200],\n \"contours\": {\"upper\": [}}").GetField(), "line 2, column 25");
}

TEST(DentalContourFileReader, UnknownFieldsAreWarnings)
{
  const auto reader =
    MakeReader(ContoursText(UpperTooth("\"UR1\"", SixPoints, ", \"colour\": 3"), "", ", \"author\": \"me\""));
  reader->Update();
  ASSERT_EQ(reader->GetWarnings().size(), 2u);
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[0], ": author: "));
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[1], ": contours.upper[0].colour: "));
  // Not added to those of the run before.
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetWarnings().size(), 2u);
}

TEST(DentalContourFileReader, ImageSizeComesFromTheImageOrTheFile)
{
  const std::string without = "{\"contours\": {\"upper\": [" + UpperTooth("\"UR1\"") + "]}}";
  EXPECT_EQ(ReadError(without).GetField(), "image_size");
  const auto reader = MakeReader(without);
  reader->SetImageSize({ { 64, 32 } });
  reader->Update();
  EXPECT_EQ(reader->GetReadImageSize()[1], 32u);

  const auto contradicting = MakeReader(ContoursText(UpperTooth("\"UR1\""), ""));
  contradicting->SetImageSize({ { 200, 100 } });
  const auto error = itk::ExpectInputError([&] { contradicting->Update(); });
  EXPECT_EQ(error.GetField(), "image_size");
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "100 x 200") && itk::Contains(error.GetProblem(), "200 x 100"));
  contradicting->SetImageSize({ { 100, 200 } });
  EXPECT_NO_THROW(contradicting->Update());
}

TEST(DentalContourFileReader, PointsOutsideTheImageAreWarnedOfOrRefused)
{
  const auto points = [](unsigned int inside, unsigned int outside) {
    std::string text;
    for (unsigned int i = 0; i < inside + outside; ++i)
    {
      // The image ends at 99.5.
      text += (i == 0 ? "[" : ", [") + std::string(i < inside ? "99.4" : "99.6") + ", " + std::to_string(i) + "]";
    }
    return '[' + text + ']';
  };
  const auto within = MakeReader(ContoursText(UpperTooth("\"UR1\"", points(20, 0)), ""));
  within->Update();
  EXPECT_EQ(within->GetNumberOfPointsOutside(), 0u);
  EXPECT_TRUE(within->GetWarnings().empty());

  const auto tenth = MakeReader(ContoursText(UpperTooth("\"UR1\"", points(18, 2)), ""));
  tenth->Update();
  EXPECT_EQ(tenth->GetNumberOfPointsOutside(), 2u);
  ASSERT_EQ(tenth->GetWarnings().size(), 1u);
  EXPECT_TRUE(itk::Contains(tenth->GetWarnings()[0], "2 of 20 points"));

  const auto error = ReadError(ContoursText(UpperTooth("\"UR1\"", points(17, 3)), ""));
  EXPECT_EQ(error.GetField(), "contours.upper[0]");
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "3 of 20 points"));
}

TEST(DentalContourFileReader, FewPointsAreReportedAndReadAllTheSame)
{
  const auto reader =
    MakeReader(ContoursText(UpperTooth("\"UR1\"", "[[1, 2], [2, 2], [3, 2], [4, 2]]"), UpperTooth("\"LR1\"", "[]")));
  reader->Update();
  EXPECT_EQ(reader->GetUpperOutput()->GetNumberOfPoints(), 4u);
  EXPECT_LT(reader->GetUpperOutput()->GetNumberOfPoints(), DentalContourFileReader::MinimumNumberOfPoints + 0);
  ASSERT_EQ(reader->GetWarnings().size(), 1u);
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[0], "contours.upper"));

  const auto nothing = MakeReader(ContoursText("", ""));
  nothing->Update();
  ASSERT_EQ(nothing->GetWarnings().size(), 1u);
}

TEST(DentalContourFileReader, ARepeatedToothIsAWarning)
{
  const auto reader = MakeReader(ContoursText(UpperTooth("\"UR1\"") + ", " + UpperTooth("\"11\""), ""));
  reader->Update();
  ASSERT_EQ(reader->GetWarnings().size(), 1u);
  EXPECT_TRUE(itk::Contains(reader->GetWarnings()[0], "contours.upper[1].code"));
}

TEST(DentalContourFileReader, MissingFileNameSaysWhatToCall)
{
  const auto reader = DentalContourFileReader::New();
  try
  {
    reader->Update();
    FAIL();
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_TRUE(itk::Contains(error.GetDescription(), "SetFileName()"));
  }
}

TEST(DentalContourFileReader, ReadsTheSharedCases)
{
  const std::string cases = std::string(DENTALSCR_SHARED_DIR) + "/cases";
  if (!std::filesystem::exists(cases))
  {
    GTEST_SKIP() << "no folder " << cases;
  }
  for (const char * name : { "casts", "phantom-ideal-1", "phantom-mean-6" })
  {
    const auto reader = DentalContourFileReader::New();
    reader->SetFileName(cases + '/' + name + "/contours.json");
    reader->SetImageSize({ { 703, 938 } });
    reader->Update();
    EXPECT_TRUE(reader->GetWarnings().empty()) << name;
    EXPECT_EQ(reader->GetUpperOutput()->GetNumberOfPoints(), 79u) << name;
    EXPECT_EQ(reader->GetLowerOutput()->GetNumberOfPoints(), 75u) << name;
  }
}

TEST(DentalContourFileWriter, ReadsBackToTheSameBits)
{
  const auto                  upper = DentalContour::New();
  DentalContour::PolylineType polyline;
  for (unsigned int i = 0; i < 7; ++i)
  {
    DentalContour::PointType point;
    point[0] = 10.0 + i / 3.0;
    point[1] = 20.0 + 0.1 * i;
    polyline.points.push_back(point);
    polyline.weights.push_back(1.0 / (1 + i));
  }
  polyline.code = itk::ToothCode(16);
  upper->AddPolyline(polyline);
  polyline.weights.clear();
  polyline.closed = true;
  polyline.code = itk::ToothCode();
  upper->AddPolyline(polyline);
  for (const NumberingEnum numbering : { NumberingEnum::Quadrant, NumberingEnum::FDI, NumberingEnum::Universal })
  {
    const auto writer = DentalContourFileWriter::New();
    writer->SetFileName(itk::TestFolder() + "/contours.json");
    writer->SetUpper(upper);
    writer->SetImageSize({ { 100, 200 } });
    writer->SetNumbering(numbering);
    writer->Update();
    const auto reader = DentalContourFileReader::New();
    reader->SetFileName(writer->GetFileName());
    reader->Update();
    EXPECT_EQ(reader->GetReadNumbering(), numbering);
    EXPECT_EQ(reader->GetReadImageSize(), writer->GetImageSize());
    const auto expected = upper->GetPolylines();
    const auto actual = reader->GetUpperOutput()->GetPolylines();
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i)
    {
      EXPECT_EQ(actual[i].code, expected[i].code);
      EXPECT_EQ(actual[i].closed, expected[i].closed);
      EXPECT_EQ(actual[i].points, expected[i].points);
      EXPECT_EQ(actual[i].weights, expected[i].weights);
    }
    EXPECT_EQ(reader->GetLowerOutput()->GetNumberOfPoints(), 0u);
  }
}

TEST(DentalContourFileWriter, ALineOverSeveralTeethIsWrittenAToothEach)
{
  const auto                       upper = itk::DentalContour::New();
  itk::DentalContour::PolylineType line;
  for (int i = 0; i < 5; ++i)
  {
    itk::DentalContour::PointType point;
    point[0] = 10.0 * i;
    point[1] = 5.0;
    line.points.push_back(point);
    line.weights.push_back(0.1 * (i + 1));
  }
  line.teeth = { itk::ToothCode(11), itk::ToothCode(11), itk::ToothCode(12), itk::ToothCode(12), itk::ToothCode(11) };
  line.code = line.teeth.front();
  upper->AddPolyline(line);
  line.closed = true;
  upper->AddPolyline(line);
  const std::string file = itk::TestFolder() + "/teeth.json";
  const auto        writer = itk::DentalContourFileWriter::New();
  writer->SetFileName(file);
  writer->SetUpper(upper);
  writer->SetImageSize({ { 100, 100 } });
  writer->Update();
  const auto reader = itk::DentalContourFileReader::New();
  reader->SetFileName(file);
  reader->Update();
  const auto polylines = reader->GetUpperOutput()->GetPolylines();
  // Of the closed one the two ends that are of one tooth are one run; points by themselves come after the lines.
  const std::vector<std::vector<double>> expected = { { 0, 10 }, { 20, 30 }, { 20, 30 }, { 40, 0, 10 }, { 40 } };
  const std::vector<int>                 codes = { 11, 12, 12, 11, 11 };
  ASSERT_EQ(polylines.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_EQ(polylines[i].code, itk::ToothCode(codes[i])) << i;
    EXPECT_FALSE(polylines[i].closed) << i;
    ASSERT_EQ(polylines[i].points.size(), expected[i].size()) << i;
    for (std::size_t k = 0; k < expected[i].size(); ++k)
    {
      EXPECT_EQ(polylines[i].points[k][0], expected[i][k]) << i;
      EXPECT_DOUBLE_EQ(polylines[i].weights[k], 0.01 * expected[i][k] + 0.1) << i;
    }
  }
}

TEST(DentalContourFileWriter, SaysWhatIsMissing)
{
  const auto writer = DentalContourFileWriter::New();
  const auto expect = [&writer](const char * call) {
    try
    {
      writer->Update();
      FAIL() << call;
    }
    catch (const itk::ExceptionObject & error)
    {
      EXPECT_TRUE(itk::Contains(error.GetDescription(), call)) << error.GetDescription();
    }
  };
  expect("SetFileName()");
  writer->SetFileName(itk::TestFolder() + "/none/contours.json");
  expect("SetUpper()");
  writer->SetLower(DentalContour::New());
  expect("SetImageSize()");
  writer->SetImageSize({ { 10, 10 } });
  EXPECT_EQ(itk::ExpectInputError([&] { writer->Update(); }).GetInputFile(), writer->GetFileName());
}

TEST(DentalContourFileReader, PrintsItself)
{
  std::ostringstream os;
  const auto         reader = MakeReader("{}");
  reader->Print(os);
  DentalContourFileWriter::New()->Print(os);
  EXPECT_TRUE(itk::Contains(os.str(), "contours.json") && itk::Contains(os.str(), "NumberOfPointsOutside"));
}

TEST(DentalContourFileReader, OutlineAndSigmaAreReadAndWritten)
{
  const auto reader = MakeReader(R"({"image_size": [100, 100], "contours": {"upper": [
    {"code": "UR1", "closed": true, "outline": "tooth", "sigma_px": 2.5, "points": [[1, 1], [9, 1], [9, 9], [1, 1]]},
    {"code": "UR2", "outline": "labial", "sigma_px": [0.5, 1.5], "points": [[1, 1], [9, 1]]},
    {"code": "UR3", "drafted": true, "points": [[3, 3], [4, 4]]},
    {"code": "UR4", "drafted": false, "sigma_px": [0.5, null, 2], "points": [[3, 3], [4, 4], [5, 5]]}]}})");
  reader->Update();
  EXPECT_TRUE(reader->GetWarnings().empty());
  const auto polylines = reader->GetUpperOutput()->GetPolylines();
  using OutlineEnum = itk::DentalContour::OutlineEnum;
  ASSERT_EQ(polylines.size(), 4u);
  EXPECT_EQ(polylines[0].outline, OutlineEnum::Tooth);
  EXPECT_EQ(polylines[0].sigmas, std::vector<double>({ 2.5, 2.5, 2.5 }));
  EXPECT_EQ(polylines[1].outline, OutlineEnum::Labial);
  EXPECT_EQ(polylines[1].sigmas, std::vector<double>({ 0.5, 1.5 }));
  EXPECT_EQ(polylines[2].outline, OutlineEnum::Unspecified);
  EXPECT_EQ(polylines[2].sigmas, std::vector<double>({ 0.0, 0.0 }));
  // Of one point the error is not known, which says nothing of the others'.
  EXPECT_EQ(polylines[3].sigmas, std::vector<double>({ 0.5, 0.0, 2.0 }));

  const auto writer = itk::DentalContourFileWriter::New();
  writer->SetUpper(reader->GetUpperOutput());
  writer->SetImageSize({ { 100, 100 } });
  writer->SetFileName(itk::TestFolder() + "/written.json");
  writer->Write();
  const auto again = DentalContourFileReader::New();
  again->SetFileName(itk::TestFolder() + "/written.json");
  again->Update();
  const auto written = again->GetUpperOutput()->GetPolylines();
  ASSERT_EQ(written.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(written[i].sigmas, polylines[i].sigmas);
    EXPECT_EQ(written[i].outline, polylines[i].outline);
    EXPECT_EQ(polylines[i].drafted, i == 2);
    EXPECT_EQ(written[i].drafted, i == 2);
  }
}

TEST(DentalContourFileReader, OutlineAndSigmaThatAreNoneAreRefusedByField)
{
  const auto field = [](const std::string & members) {
    const auto reader =
      MakeReader(R"({"image_size": [9, 9], "contours": {"upper": [{"code": "UR1", "points": [[1, 1], [2, 2]], )" +
                 members + "}]}}");
    return itk::ExpectInputError([&] { reader->Update(); }).GetField();
  };
  EXPECT_EQ(field(R"("outline": "root")"), "contours.upper[0].outline");
  EXPECT_EQ(field(R"("sigma_px": 0)"), "contours.upper[0].sigma_px");
  EXPECT_EQ(field(R"("sigma_px": -1)"), "contours.upper[0].sigma_px");
  EXPECT_EQ(field(R"("sigma_px": [1])"), "contours.upper[0].sigma_px");
  EXPECT_EQ(field(R"("sigma_px": [1, 0])"), "contours.upper[0].sigma_px[1]");
  EXPECT_EQ(field(R"("sigma_px": [1, "x"])"), "contours.upper[0].sigma_px[1]");
  EXPECT_EQ(field(R"("sigma_px": null)"), "contours.upper[0].sigma_px");
  EXPECT_EQ(field(R"("drafted": 1)"), "contours.upper[0].drafted");
}
