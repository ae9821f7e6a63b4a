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
#include "itkReportPageWriter.h"

#include "itkCephalometricGeometry.h"
#include "itkDentalInputError.h"

#include "itkGTest.h"
#include "itkTriangleCell.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
using Json = nlohmann::ordered_json;
using WriterType = itk::ReportPageWriter;

Json
MakeResult()
{
  return Json::parse(R"({
    "schema": "dentalscr-result/1", "software": "0.1.0", "preset": "robust", "status": "suspect", "skipped": {},
    "inputs": {"case": {"path": "case.json", "sha256": "00"}},
    "jaws": {"upper": {
      "status": "suspect", "reasons": ["odd"],
      "findings": [{"code": "poor-fit", "severity": "suspect", "text": "it lies near it", "value": 3.1, "limit": 2.7,
                    "unit": "px"}],
      "projection_3x4": [[4, 0, 0, 100], [0, 0, -4, 80], [0, 0, 0, 1]],
      "mesh_to_cephalostat_mm": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]],
      "mesh_to_umda_mm": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]],
      "similarity": {"scale": 1.0, "rotation_rad": 0.1, "translation_px": [100, 80]},
      "pose": {"parameters": [0.1, 0.02, 0.03, 1.5, 0.5, -2.5, 0.004]},
      "pose_sigma": {"pitch_deg": 0.5, "roll_deg": 1, "yaw_deg": 1, "x_mm": 0.4, "y_mm": 1.9, "z_mm": 0.3, "scale": 0.01},
      "priors": {"roll_deg": {"value": 1.146, "mean": 0.0, "sigma": 3.5, "tension_sd": 0.3274}},
      "candidates": [{"projection_3x4": [[4, 0, 0, 100], [0, 0, -4, 80], [0, 0, 0, 1]], "score": 0.1, "distance_px": 0},
                     {"projection_3x4": [[4, 0, 0, 130], [0, 0, -4, 80], [0, 0, 0, 1]], "score": 0.2,
                      "distance_px": 30}],
      "stages": [{"stage": "start", "projection_3x4": [[4, 0, 0, 90], [0, 0, -4, 80], [0, 0, 0, 1]]}],
      "course": [{"stage": "start", "candidates": 3, "jaws": ["upper"], "chosen": 0, "value": 1.25, "steps": 12,
                  "accepted": 7, "stop": "small step"}],
      "residuals_px": [{"tooth": "UR1", "points": 2, "mean": 1.25, "rms": 1.5, "max": 2.5}],
      "metrics_matched": {"chamfer_px": 1.44},
      "landmarks_px": {"UR1_tip": [101.5, 82.25]}, "landmark_sigma_px": {"UR1_tip": 0.8},
      "landmark_covariance_px2": {"UR1_tip": [[1.0, 0.5], [0.5, 1.0]]},
      "error": {"mean_px": 2.0, "landmarks": {"UR1_tip": 2.0},
                "places_px": {"UR1_tip": {"marked": [103.5, 82.25], "predicted": [101.5, 82.25]}}},
      "seconds": {"read": 0.1}}},
    "geometry": {"source_to_midsagittal_mm": {"value": 1524.0, "source": "given"},
                 "source_to_detector_mm": {"value": 1674.0, "source": "default"},
                 "source_side": {"value": "right", "source": "default"}, "facing": {"value": "right", "source": "given"},
                 "pixel_spacing_mm": {"value": [0.25, 0.25], "source": "given", "verdict": "UserGiven", "how": "said"},
                 "principal_point_px": {"value": [100, 80], "source": "given"}},
    "mesh_unit": "mm", "traced_side": "right", "warnings": [], "not_checkable": [], "total_seconds": 1.5,
    "notice": "Research software, not a medical device."})");
}

Json
MakeDetails()
{
  return Json::parse(R"({"schema": "dentalscr-report/1", "course": [],
    "views": [{"name": "lateral", "image_size": [200, 160], "jaws": {"upper": {
      "tracing": [{"tooth": "UR1", "closed": false, "points": [[100, 80], [104, 84]], "distance_px": [0.5, 2.5]}],
      "contours": {"whole": [{"closed": true, "points": [[90, 70], [110, 70], [110, 90]]}],
                   "matched": [{"closed": false, "points": [[100, 81], [104, 85]]}]},
      "outline_3d": [[0, 0, 0], [1, 0, 0], [20, 0, 0], [21, 0, 0]]}}}]})");
}

std::string
MakePage(const Json & result, const Json & details, const std::string & title = "Case")
{
  auto writer = WriterType::New();
  writer->SetResult(result.dump());
  writer->SetDetails(details.is_null() ? std::string() : details.dump());
  writer->SetTitle(title);
  return writer->MakePage();
}

/** A grid of so many points a side on a bowl, mm. */
WriterType::MeshType::Pointer
MakeBowl(unsigned int side)
{
  using MeshType = WriterType::MeshType;
  auto mesh = MeshType::New();
  auto points = MeshType::PointsContainer::New();
  points->Reserve(side * side);
  for (unsigned int row = 0; row < side; ++row)
  {
    for (unsigned int column = 0; column < side; ++column)
    {
      const float         x = 60.0F * static_cast<float>(column) / static_cast<float>(side) - 30.0F;
      const float         y = 60.0F * static_cast<float>(row) / static_cast<float>(side) - 30.0F;
      MeshType::PointType point;
      point[0] = x;
      point[1] = y;
      point[2] = 0.005F * (x * x + y * y) + std::sin(x) * std::cos(y);
      points->SetElement(row * side + column, point);
    }
  }
  mesh->SetPoints(points);
  using TriangleType = itk::TriangleCell<MeshType::CellType>;
  itk::IdentifierType id = 0;
  for (unsigned int row = 0; row + 1 < side; ++row)
  {
    for (unsigned int column = 0; column + 1 < side; ++column)
    {
      const itk::IdentifierType a = row * side + column;
      for (const auto & corners : { std::array<itk::IdentifierType, 3>{ { a, a + 1, a + side } },
                                    std::array<itk::IdentifierType, 3>{ { a + 1, a + side + 1, a + side } } })
      {
        MeshType::CellAutoPointer cell;
        cell.TakeOwnership(new TriangleType);
        cell->SetPointIds(corners.data());
        mesh->SetCell(id++, cell);
      }
    }
  }
  return mesh;
}

std::size_t
Count(const std::string & text, const std::string & what)
{
  std::size_t count = 0;
  for (std::size_t place = text.find(what); place != std::string::npos; place = text.find(what, place + what.size()))
  {
    ++count;
  }
  return count;
}

/** A result whose upper jaw is in perspective, at the origin of the cephalostat: the source is at y = -1524 mm. */
Json
MakeResultInPerspective()
{
  auto geometry = itk::CephalometricGeometry::New();
  geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(0.25));
  itk::CephalometricGeometry::PixelIndexType principal;
  principal[0] = 100.0;
  principal[1] = 80.0;
  geometry->SetPrincipalPoint(principal);
  const auto matrix = geometry->GetProjection().matrix;
  Json       result = MakeResult();
  for (unsigned int i = 0; i < 12; ++i)
  {
    result["jaws"]["upper"]["projection_3x4"][i / 4][i % 4] = matrix[i];
  }
  return result;
}

/** What the page's script reads. */
Json
DataOf(const std::string & page)
{
  const std::string begin = "<script type=\"application/json\" id=\"report-data\">";
  const std::size_t from = page.find(begin) + begin.size();
  return Json::parse(page.substr(from, page.find("</script>", from) - from));
}
} // namespace

TEST(ReportPageWriter, SaysTheVerdictTheFindingsAndWhatToDo)
{
  const std::string page = MakePage(MakeResult(), MakeDetails());
  EXPECT_NE(page.find("<title>Case: suspect</title>"), std::string::npos);
  EXPECT_NE(page.find("it lies near it"), std::string::npos);
  // From Documentation/Findings.md.
  EXPECT_NE(page.find("look at the overlay; correct or exclude a tooth"), std::string::npos);
}

TEST(ReportPageWriter, EveryTableHasItsFiguresOfTheResult)
{
  const std::string page = MakePage(MakeResult(), MakeDetails());
  for (const char * figure : { "1.4 px = 0.36 mm", // fit
                               ">1.25</td>",       // mean of the tooth, px
                               ">0.31</td>",       // the same in mm
                               ">101.5</td>",      // landmark
                               ">0.20</td>",       // its sigma, mm
                               ">2.00</td>",       // its error
                               "0.33 sd",          // pull of the prior
                               "small step",       // why it ended
                               "given",            // provenance
                               "0.2000" })         // score of the other candidate
  {
    EXPECT_NE(page.find(figure), std::string::npos) << figure;
  }
}

TEST(ReportPageWriter, DrawsEveryLayer)
{
  const std::string page = MakePage(MakeResult(), MakeDetails());
  for (const char * layer :
       { "stage-start", "candidate-2", "whole", "tracing", "matched", "regions", "landmarks", "errors", "names" })
  {
    EXPECT_EQ(Count(page, std::string("class=\"layer\" data-layer=\"") + layer + '"'), 1u) << layer;
  }
  // The stage began ten pixels to the left of the solution: (0, 0, 0) is drawn at (90, 80), and a gap is a gap.
  EXPECT_NE(page.find("<path class=\"stage\" d=\"M90.00 80.00L94.00 80.00M170.00 80.00L174.00 80.00\"/>"),
            std::string::npos);
  // Variances 1.5 and 0.5 along the diagonals: 2.4477 times their roots.
  EXPECT_NE(page.find("rx=\"3.00\" ry=\"1.73\" transform=\"rotate(45.0 101.50 82.25)\""), std::string::npos);
}

TEST(ReportPageWriter, SaysWhatElseWasRegisteredWith)
{
  Json result = MakeResult();
  result["jaws"]["upper"]["landmarks_used"]["U6_MB"] = {
    { "found_by", "tooth labels" }, { "residual_px", { 3.0, 4.0 } }, { "residual_sd", 1.5 }, { "weight", 0.25 }
  };
  result["jaws"]["upper"]["outlines_used"]["U1"] = {
    { "shift_px", { 0.0, 2.0 } }, { "residual_sd", 0.75 }, { "weight", 1.0 }, { "template", true }
  };
  const std::string page = MakePage(result, MakeDetails());
  EXPECT_NE(page.find("landmark, by tooth labels</td><td class=\"number\">5.00</td><td class=\"number\">1.50"),
            std::string::npos);
  EXPECT_NE(page.find("tip and axis alone</td><td class=\"number\">2.00"), std::string::npos);
  EXPECT_EQ(MakePage(MakeResult(), MakeDetails()).find("registered with</h2>"), std::string::npos);
}

TEST(ReportPageWriter, AsksNothingOfTheNetwork)
{
  std::string       page = MakePage(MakeResult(), MakeDetails());
  const std::size_t script = page.find("<script type=\"module\">");
  ASSERT_NE(script, std::string::npos);
  const std::string withoutScript = page.substr(0, script);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (const char * word : { " src=\"", "@import", "url(h", "<link", "<iframe" })
  {
    EXPECT_EQ(Count(withoutScript, word), 0u) << word;
  }
}

TEST(ReportPageWriter, HostileNamesStayText)
{
  const std::string hostile = "</script><script>alert(1)</script><img src=x onerror=\"alert('2')\">{{title}}&amp;";
  Json              result = MakeResult();
  Json              details = MakeDetails();
  Json &            jaw = result["jaws"]["upper"];
  result["warnings"].push_back(hostile);
  result["not_checkable"].push_back(hostile);
  result["options"].push_back(hostile);
  details["command_line"].push_back(hostile);
  result["skipped"]["lower"] = hostile;
  result["inputs"]["case"]["path"] = hostile;
  result["inputs"][hostile] = { { "path", "x" }, { "sha256", hostile } };
  result["geometry"]["facing"]["how"] = hostile;
  jaw["findings"][0]["text"] = hostile;
  jaw["findings"][0]["code"] = hostile;
  jaw["landmarks_px"][hostile] = { 1.0, 2.0 };
  jaw["landmark_covariance_px2"][hostile] = { { 1, 0 }, { 0, 1 } };
  jaw["error"]["places_px"][hostile] = { { "marked", { 1, 2 } }, { "predicted", { 2, 3 } } };
  jaw["stages"][0]["stage"] = hostile;
  jaw["course"][0]["stop"] = hostile;
  jaw["residuals_px"][0]["tooth"] = hostile;
  details["views"][0]["jaws"]["upper"]["tracing"][0]["tooth"] = hostile;
  details["views"][0]["name"] = hostile;
  const std::string page = MakePage(result, details, hostile);
  // The page's own two.
  EXPECT_EQ(Count(page, "</script>"), 2u);
  EXPECT_EQ(Count(page, "<img"), 0u);
  EXPECT_EQ(Count(page, "onerror=\""), 0u);
  EXPECT_GT(Count(page, "&lt;script&gt;"), 12u);
  // A name is no template.
  EXPECT_GT(Count(page, "{{title}}"), 12u);
  // And it arrives as it is where a script reads it.
  EXPECT_EQ(DataOf(page)["result"]["warnings"][0], hostile);
}

TEST(ReportPageWriter, BytesThatAreNotUTF8DoNotStopIt)
{
  const std::string page = MakePage(MakeResult(), MakeDetails(), "M\xfcller");
  EXPECT_NE(page.find("<h1>M\xef\xbf\xbdller</h1>"), std::string::npos);
}

TEST(ReportPageWriter, SaysWhatIsNotThere)
{
  const std::string page = MakePage(MakeResult(), Json());
  EXPECT_NE(page.find("Nothing is drawn here"), std::string::npos);
  EXPECT_EQ(Count(page, "<svg"), 0u);
  Json failed = MakeResult();
  failed["status"] = "failed";
  failed["jaws"] = { { "upper", { { "status", "failed" }, { "reasons", { "no" } }, { "findings", Json::array() } } } };
  EXPECT_NE(MakePage(failed, Json()).find("Not to be used."), std::string::npos);
}

TEST(ReportPageWriter, TheRadiographIsInThePageAndShrunk)
{
  using ImageType = WriterType::RadiographType;
  auto image = ImageType::New();
  image->SetRegions(ImageType::SizeType{ { 500, 300 } });
  image->Allocate();
  for (unsigned int i = 0; i < 500 * 300; ++i)
  {
    image->GetBufferPointer()[i] = static_cast<float>(i % 500);
  }
  auto writer = WriterType::New();
  writer->SetResult(MakeResult().dump());
  writer->SetDetails(MakeDetails().dump());
  writer->SetRadiograph(image);
  const std::string whole = writer->MakePage();
  EXPECT_NE(whole.find("width=\"500\" height=\"300\" preserveAspectRatio=\"none\" href=\"data:image/jpeg;base64,/9j/"),
            std::string::npos);
  writer->SetMaximumRadiographSide(240);
  const std::string small = writer->MakePage();
  // By three: 167 x 100 pixels, which cover 501 x 300.
  EXPECT_NE(small.find("width=\"501\" height=\"300\""), std::string::npos);
  EXPECT_LT(small.size(), whole.size());
}

TEST(ReportPageWriter, ScansAreSimplifiedAndStayWhereTheyAre)
{
  auto writer = WriterType::New();
  writer->SetResult(MakeResult().dump());
  writer->SetTrianglesPerScan(2000);
  writer->SetUpperScan(MakeBowl(200));
  const Json scan = DataOf(writer->MakePage())["scans"]["upper"];
  // Base64: four letters for three bytes; a triangle has three indices of two bytes.
  const std::size_t triangles = scan["triangles"].get<std::string>().size() * 3 / 4 / 6;
  EXPECT_GT(triangles, 1500u);
  EXPECT_LT(triangles, 2100u);
  EXPECT_NEAR(scan["origin"][0].get<double>(), -30.0, 1e-3);
  // 65 535 steps over the longest side.
  EXPECT_NEAR(scan["step"].get<double>(), 60.0 / 65535.0, 1e-4);
  EXPECT_EQ(scan["wide"], false);
}

TEST(ReportPageWriter, PlacesSourceAndDetectorWhereTheProjectionHasThem)
{
  // A scan in cm that was moved by (3, -2, 5) mm, and a magnification that was estimated.
  constexpr double scale = 1.02;
  auto             geometry = itk::CephalometricGeometry::New();
  geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(0.25 / scale));
  itk::CephalometricGeometry::PixelIndexType principal;
  principal[0] = 100.0;
  principal[1] = 80.0;
  geometry->SetPrincipalPoint(principal);
  itk::CephalometricGeometry::RotationType identity;
  identity.SetIdentity();
  const double                           moved[3] = { 3.0, -2.0, 5.0 };
  itk::CephalometricGeometry::VectorType translation;
  for (unsigned int d = 0; d < 3; ++d)
  {
    translation[d] = moved[d];
  }
  geometry->SetPose(identity, translation);
  const auto matrix = geometry->GetProjection().matrix;
  Json       result = MakeResult();
  Json &     jaw = result["jaws"]["upper"];
  result["mesh_unit"] = "cm";
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 4; ++column)
    {
      jaw["projection_3x4"][row][column] = matrix[4 * row + column] * (column < 3 ? 10.0 : 1.0);
    }
    jaw["mesh_to_cephalostat_mm"][row][3] = moved[row];
  }
  auto writer = WriterType::New();
  writer->SetResult(result.dump());
  writer->SetDetails(MakeDetails().dump());
  const std::string withoutScan = writer->MakePage();
  const Json        space = DataOf(withoutScan)["spaces"][0];
  const auto        expectAt = [](const Json & point, double x, double y, double z) {
    EXPECT_NEAR(point[0].get<double>(), x, 0.011);
    EXPECT_NEAR(point[1].get<double>(), y, 0.011);
    EXPECT_NEAR(point[2].get<double>(), z, 0.011);
  };
  expectAt(space["source"], 0.0, -1524.0, 0.0);
  expectAt(space["centre"], 0.0, 150.0, 0.0);
  // From pixel edge to pixel edge of 200 x 160, in pixels that are smaller by the scale.
  const double left = -100.5 * 0.25 / scale;
  const double right = 99.5 * 0.25 / scale;
  const double top = 80.5 * 0.25 / scale;
  const double bottom = -79.5 * 0.25 / scale;
  expectAt(space["corners"][0], left, 150.0, top);
  expectAt(space["corners"][1], right, 150.0, top);
  expectAt(space["corners"][2], right, 150.0, bottom);
  expectAt(space["corners"][3], left, 150.0, bottom);

  // What the scan would look like is a layer of its own, hidden at first; without a scan there is none.
  EXPECT_EQ(Count(withoutScan, "data-layer=\"drr\""), 0u);
  writer->SetUpperScan(MakeBowl(60));
  const std::string page = writer->MakePage();
  EXPECT_EQ(Count(page,
                  "<g class=\"layer\" data-layer=\"drr\" hidden><image class=\"drr\" x=\"-0.5\" y=\"-0.5\" "
                  "width=\"200\" height=\"160\" preserveAspectRatio=\"none\" href=\"data:image/jpeg;base64,/9j/"),
            1u);
  EXPECT_EQ(Count(page, "<input type=\"checkbox\" data-layer=\"drr\">"), 1u);
  EXPECT_EQ(Count(page, "data-action=\"drr\""), 1u);
  // Shrunk as the radiograph is: by three, 67 x 54 pixels, which cover 201 x 162.
  writer->SetMaximumRadiographSide(80);
  EXPECT_NE(writer->MakePage().find("<image class=\"drr\" x=\"-0.5\" y=\"-0.5\" width=\"201\" height=\"162\""),
            std::string::npos);
}

TEST(ReportPageWriter, AParallelProjectionHasNoPlaceInSpace)
{
  auto writer = WriterType::New();
  writer->SetResult(MakeResult().dump());
  writer->SetDetails(MakeDetails().dump());
  writer->SetUpperScan(MakeBowl(20));
  const std::string page = writer->MakePage();
  EXPECT_TRUE(DataOf(page)["spaces"][0].is_null());
  EXPECT_EQ(Count(page, "data-layer=\"drr\""), 0u);
}

TEST(ReportPageWriter, AScanThatCannotBeRenderedCostsItsLayerAlone)
{
  auto writer = WriterType::New();
  writer->SetResult(MakeResultInPerspective().dump());
  writer->SetDetails(MakeDetails().dump());
  auto scan = MakeBowl(20);
  writer->SetUpperScan(scan);
  ASSERT_EQ(Count(writer->MakePage(), "<image class=\"drr\""), 1u);
  // A vertex that is left from somewhere far behind the source.
  WriterType::MeshType::PointType point = scan->GetPoint(0);
  point[1] = -3000.0F;
  scan->SetPoint(0, point);
  const std::string page = writer->MakePage();
  EXPECT_EQ(Count(page, "data-layer=\"drr\""), 0u);
  // It is said, without ITK's words, which have an address that differs from run to run.
  EXPECT_EQ(Count(page, "since it cannot be rendered: Point 0 of mesh 0"), 1u);
  EXPECT_EQ(Count(page, "ITK ERROR"), 0u);
  EXPECT_EQ(Count(page, "class=\"layer\" data-layer=\"tracing\""), 1u);
  EXPECT_FALSE(DataOf(page)["scans"]["upper"].is_null());
}

TEST(ReportPageWriter, FlickerComparesTheSilhouetteWhereNoOutlineWasMatchedAsAWhole)
{
  EXPECT_EQ(Count(MakePage(MakeResult(), MakeDetails()), "data-after=\"whole\""), 0u);
  Json result = MakeResult();
  result["jaws"]["upper"].erase("metrics_matched");
  EXPECT_EQ(Count(MakePage(result, MakeDetails()), "data-after=\"whole\""), 1u);
}

TEST(ReportPageWriter, NothingHasNoSign)
{
  Json result = MakeResult();
  result["jaws"]["upper"]["pose"]["parameters"][4] = -0.001;
  const std::string page = MakePage(result, MakeDetails());
  EXPECT_EQ(Count(page, "<td class=\"number\">0.00 mm</td>"), 1u);
  // Not in what is shown: the data have the figure itself.
  EXPECT_EQ(Count(page, ">-0.00"), 0u);
  EXPECT_EQ(Count(page, "-2.50 mm"), 1u);
}

TEST(ReportPageWriter, EachViewHasAPipelineOfItsOwn)
{
  // Views are rendered by several threads: what one of them asks of a scan must not be written into it.
  Json result = MakeResultInPerspective();
  result["views"]["other"] = { { "jaws", result["jaws"] }, { "geometry", result["geometry"] } };
  Json details = MakeDetails();
  details["views"].push_back(details["views"][0]);
  details["views"][1]["name"] = "other";
  auto writer = WriterType::New();
  writer->SetResult(result.dump());
  writer->SetDetails(details.dump());
  const auto scan = MakeBowl(20);
  writer->SetUpperScan(scan);
  const auto before = scan->GetRequestedRegion();
  EXPECT_EQ(Count(writer->MakePage(), "<image class=\"drr\""), 2u);
  EXPECT_EQ(scan->GetRequestedRegion(), before);
}

TEST(ReportPageWriter, WhatIsNoResultIsAnErrorThatNamesIt)
{
  auto writer = WriterType::New();
  EXPECT_THROW(writer->MakePage(), itk::ExceptionObject);
  for (const char * text : { "{}", "no JSON", "{\"schema\": \"dentalscr-result/2\"}", "[]" })
  {
    writer->SetResult(text);
    EXPECT_THROW(writer->MakePage(), itk::DentalInputError) << text;
  }
  Json result = MakeResult();
  result["jaws"]["upper"]["landmarks_px"]["UR1_tip"] = "nowhere";
  writer->SetResult(result.dump());
  writer->SetDetails(MakeDetails().dump());
  EXPECT_THROW(writer->MakePage(), itk::DentalInputError);
}

TEST(ReportPageWriter, WritesTheFile)
{
  const auto file = std::filesystem::temp_directory_path() / "itkReportPageWriterGTest.html";
  auto       writer = WriterType::New();
  writer->SetResult(MakeResult().dump());
  EXPECT_THROW(writer->Update(), itk::ExceptionObject);
  writer->SetFileName(file.string());
  writer->Update();
  std::ifstream      stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_EQ(text.str(), writer->MakePage());
  std::remove(file.c_str());
  writer->Print(std::cout);
}
