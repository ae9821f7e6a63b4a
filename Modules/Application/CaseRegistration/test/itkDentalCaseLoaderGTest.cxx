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
#include "itkDentalCaseLoader.h"

#include "itkCaseInputFile.h"
#include "itkDentalCaseFileReader.h"
#include "itkDicomTestFile.h"
#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
using itk::Contains;
using itk::TracedSideEnum;

/** A case of one scan with these fields more. */
std::shared_ptr<itk::DentalCaseData>
Load(const std::string & fields)
{
  itk::WriteTestFile("upper.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  return itk::LoadDentalCase(
    itk::ReadDentalCase(itk::WriteTestFile("case.json", R"({"upper": "upper.obj", )" + fields + "}")));
}

std::string
Refusal(const std::string & fields)
{
  return itk::ExpectInputError([&] { Load(fields); }).GetOneLine();
}

/** An ellipse of that length and a width of 20 pixels, leaning. */
std::string
MakeOutline(const std::string & code, double length, bool closed = true)
{
  std::ostringstream text;
  text << R"({"code": ")" << code << R"(", "closed": )" << (closed ? "true" : "false") << R"(, "points": [)";
  for (int i = 0; i < 24; ++i)
  {
    const double angle = i * 0.26;
    const double along = 0.5 * length * std::cos(angle);
    const double across = 10.0 * std::sin(angle);
    text << (i == 0 ? "[" : ", [") << 300.0 + 0.6 * along - 0.8 * across << ", " << 400.0 + 0.8 * along + 0.6 * across
         << "]";
  }
  return text.str() + "]}";
}

TracedSideEnum
SideOf(const std::string & outlines, const std::string & more = "")
{
  itk::WriteTestFile("contours.json", R"({"image_size": [703, 938], "contours": {"upper": [)" + outlines + R"(]}})");
  const auto data = Load(R"("contours": "contours.json")" + more);
  bool       said = false;
  for (const std::string & warning : data->warnings)
  {
    said = said || Contains(warning, "traced_side: is not given");
  }
  // Nobody is told of a side that he gave or of the ordinary one.
  EXPECT_EQ(said, more.empty() && data->description.tracedSide == TracedSideEnum::Standard);
  return data->description.tracedSide;
}

constexpr char Size[] = R"("cephalogram": {"image_size": [703, 938]}, )";
} // namespace

TEST(DentalCaseLoader, TakesLandmarksFromTheCaseItselfAndFromAFile)
{
  const auto own = Load(Size + std::string(R"("cephalometric_landmarks": {"U1_tip": [570, 643.5], "Nasion": [1, 2]})"));
  ASSERT_NE(own->cephalometricLandmarks, nullptr);
  EXPECT_EQ(own->cephalometricLandmarks->Find("U1_tip")->point[1], 643.5);
  EXPECT_EQ(own->imageSize[1], 938u);
  EXPECT_EQ(own->upper.contour, nullptr);
  ASSERT_EQ(own->warnings.size(), 1u);
  EXPECT_TRUE(Contains(own->warnings[0], "Nasion"));

  itk::WriteTestFile("points.csv", "label,x,y\n16_MB,464,613\n");
  const auto file = Load(Size + std::string(R"("cephalometric_landmarks": "points.csv")"));
  EXPECT_NE(file->cephalometricLandmarks->Find("UR6_MB"), nullptr);
}

TEST(DentalCaseLoader, LandmarksAloneMeanWhatStandardMeans)
{
  const std::string landmarks = R"("cephalometric_landmarks": {"U1_tip": [570, 643]})";
  const auto        data = Load(Size + landmarks);
  EXPECT_EQ(data->description.tracedSide, TracedSideEnum::Standard);
  EXPECT_TRUE(data->warnings.empty()) << "names without sides mean one thing: nothing was guessed";
  // Beside them names with sides are taken for the middle: that is said.
  const auto mixed =
    Load(Size + std::string(R"("cephalometric_landmarks": {"U1_tip": [570, 643], "UR6_MB": [464, 613]})"));
  EXPECT_EQ(mixed->description.tracedSide, TracedSideEnum::Standard);
  ASSERT_EQ(mixed->warnings.size(), 1u);
  EXPECT_TRUE(Contains(mixed->warnings[0], "traced_side: is not given"));
  const auto given = Load(Size + landmarks + R"(, "traced_side": "right")");
  EXPECT_EQ(given->description.tracedSide, TracedSideEnum::Right);
  EXPECT_TRUE(given->warnings.empty());
}

TEST(DentalCaseLoader, WholeIncisorsAndMolarsAloneAreAStandardTracing)
{
  const std::string molar = MakeOutline("UR6", 28.0);
  EXPECT_EQ(SideOf(MakeOutline("UR1", 60.0) + ", " + molar), TracedSideEnum::Standard);
  EXPECT_EQ(SideOf(MakeOutline("UR1", 60.0) + ", " + molar, R"(, "traced_side": "left")"), TracedSideEnum::Left);
  // A crown is no whole tooth.
  EXPECT_EQ(SideOf(MakeOutline("UR1", 30.0) + ", " + molar), TracedSideEnum::Right);
  EXPECT_EQ(SideOf(MakeOutline("UR1", 60.0, false) + ", " + molar), TracedSideEnum::Right);
  EXPECT_EQ(SideOf(MakeOutline("UR1", 60.0) + ", " + molar + ", " + MakeOutline("UR4", 50.0)), TracedSideEnum::Right);
  EXPECT_EQ(SideOf(MakeOutline("UR1", 60.0) + ", " + molar + ", " + MakeOutline("UL6", 28.0)), TracedSideEnum::Right);
  EXPECT_EQ(SideOf(molar), TracedSideEnum::Right);
  // Landmarks beside another tracing do not change what it shows.
  EXPECT_EQ(SideOf(MakeOutline("UR4", 50.0), R"(, "cephalometric_landmarks": {"U1_tip": [1, 2]})"),
            TracedSideEnum::Right);
}

TEST(DentalCaseLoader, LandmarksFarOutsideTheImageAreNamed)
{
  const auto landmarks = [](const std::string & point) {
    return Size + std::string(R"("cephalometric_landmarks": {"U1_tip": )") + point + "}";
  };
  const std::string line = Refusal(landmarks("[800, 600]"));
  for (const char * word : { "case.json", "cephalometric_landmarks.U1_tip", "far outside", "mm", "copy" })
  {
    EXPECT_TRUE(Contains(line, word)) << word << " in " << line;
  }
  EXPECT_TRUE(Contains(Refusal(landmarks("[10, -120]")), "U1_tip"));
  // Less than a tenth is a detector's slip.
  EXPECT_EQ(Load(landmarks("[760, -80]"))->cephalometricLandmarks->GetNumberOfLandmarks(), 1u);
  itk::WriteTestFile("points.json", R"({"Is": [5700, 6430]})");
  EXPECT_TRUE(Contains(Refusal(Size + std::string(R"("cephalometric_landmarks": "points.json")")), "points.json: Is"));
}

TEST(DentalCaseLoader, TheImagesSizeIsNeededAndMayStandInTheCase)
{
  EXPECT_TRUE(Contains(Refusal(R"("cephalometric_landmarks": {"U1_tip": [570, 643]})"), "cephalogram.image_size"));
  EXPECT_TRUE(
    Contains(Refusal(R"("cephalogram": {"image_size": [703]}, "cephalometric_landmarks": {"U1_tip": [570, 643]})"),
             "cephalogram.image_size"));
  // A tracing that says nothing of it, and one that contradicts.
  const std::string outline = R"("contours": {"upper": [)" + MakeOutline("UR4", 50.0) + "]}}";
  itk::WriteTestFile("contours.json", "{" + outline);
  EXPECT_EQ(Load(Size + std::string(R"("contours": "contours.json")"))->imageSize[0], 703u);
  itk::WriteTestFile("contours.json", R"({"image_size": [700, 900], )" + outline);
  EXPECT_TRUE(Contains(Refusal(Size + std::string(R"("contours": "contours.json")")), "700 x 900"));
}

TEST(DentalCaseLoader, ACaseFileThatIsAnotherOneThanWhatWasReadIsNoticed)
{
  const std::string fields = R"({"upper": "upper.obj", "cephalogram": {"image_size": [703, 938]}, )"
                             R"("cephalometric_landmarks": {"Is": [570, 643], "Ms": [474, 613]})";
  Load(fields.substr(fields.find(',') + 1));
  const std::string file = itk::WriteTestFile("case.json", fields + "}");
  const auto        description = itk::ReadDentalCase(file);
  EXPECT_EQ(description.fileSHA256, itk::ComputeFileSHA256(file));
  EXPECT_EQ(itk::LoadDentalCase(description)->inputs.front().sha256, description.fileSHA256);
  itk::WriteTestFile("case.json", fields + R"(, "fix": ["scale"]})");
  const auto error = itk::ExpectInputError([&] { itk::LoadDentalCase(description); });
  EXPECT_TRUE(Contains(error.GetOneLine(), "was changed while the case was read")) << error.GetOneLine();
  // A case of no file has none that could change.
  EXPECT_EQ(itk::ParseDentalCase(fields + "}", "command line", itk::TestFolder()).fileSHA256, "");
}

/** A spacing in which rows and columns are exchanged, or of which one number is mistyped, is told by either number. */
TEST(DentalCaseLoader, ASpacingThatContradictsDICOMIsToldOnceInEitherDirection)
{
  itk::WriteTestFile("ceph.dcm", itk::DicomTestFile().SetImagerPixelSpacing("0.2\\0.1").GetBytes());
  const auto warnings = [](const std::string & spacing) {
    const auto  data = Load(R"("cephalogram": {"image": "ceph.dcm", "pixel_spacing_mm": )" + spacing +
                           R"(}, "traced_side": "standard", "cephalometric_landmarks": {"U1_tip": [3, 4]})");
    std::string text;
    for (const std::string & warning : data->warnings)
    {
      text += Contains(warning, "pixel_spacing_mm") ? warning + '\n' : std::string();
    }
    return text;
  };
  EXPECT_EQ(warnings("[0.1, 0.2]"), "");
  EXPECT_EQ(warnings("[0.3, 0.2]"), "pixel_spacing_mm[0]: the case says 0.3, the DICOM file 0.1; the case's is used\n");
  EXPECT_EQ(warnings("[0.1, 0.3]"), "pixel_spacing_mm[1]: the case says 0.3, the DICOM file 0.2; the case's is used\n");
  EXPECT_EQ(warnings("[0.3, 0.3]"), "pixel_spacing_mm[0]: the case says 0.3, the DICOM file 0.1; the case's is used\n");
}

/** The detector's pixels are what the file says, whatever is known of the distances; that these magnify otherwise than
 * the file's factor is said, and nothing else. */
TEST(DentalCaseLoader, TheDetectorsPixelsDoNotChangeWithTheDistances)
{
  itk::WriteTestFile("ceph.dcm",
                     itk::DicomTestFile()
                       .SetImagerPixelSpacing("0.2484\\0.2484")
                       .SetMagnificationFactor("1.2")
                       .SetSourceToDetector("1800")
                       .GetBytes());
  const auto load = [](const std::string & spacing, const std::string & geometry) {
    return Load(R"("cephalogram": {"image": "ceph.dcm")" + spacing + R"(}, "geometry": {)" + geometry +
                R"(}, "traced_side": "standard", "cephalometric_landmarks": {"U1_tip": [3, 4]})");
  };
  const auto told = [](const auto & data, const std::string & text) {
    return std::any_of(data->warnings.begin(), data->warnings.end(), [&text](const std::string & warning) {
      return Contains(warning, text);
    });
  };
  const std::string own = R"("source_to_midsagittal_mm": 1524, "source_to_detector_mm": 1674)";
  const auto        other = load("", own);
  EXPECT_EQ(other->geometry->GetPixelSpacing()[0], 0.2484);
  EXPECT_EQ(other->sources.pixelSpacing, itk::ValueSourceEnum::DICOM);
  EXPECT_TRUE(told(other, "magnify by 1.09843, and the DICOM file's EstimatedRadiographicMagnificationFactor"));
  EXPECT_TRUE(told(other, "source_to_detector_mm: the case says 1674, the DICOM file 1800"));
  EXPECT_TRUE(Contains(other->spacingProvenance, "on the detector the ImagerPixelSpacing itself"));
  // The case's spacing is the file's, in either plane: no word about it.
  EXPECT_FALSE(
    told(load(R"(, "pixel_spacing_mm": [0.2484, 0.2484], "spacing_plane": "detector")", own), "pixel_spacing_mm"));
  EXPECT_FALSE(
    told(load(R"(, "pixel_spacing_mm": [0.207, 0.207], "spacing_plane": "midsagittal")", own), "pixel_spacing_mm"));
  EXPECT_TRUE(told(load(R"(, "pixel_spacing_mm": [0.2274, 0.2274], "spacing_plane": "detector")", own),
                   "pixel_spacing_mm[0]: the case says 0.2274, the DICOM file 0.2484"));
  // Said once, of the distance or of the factor.
  const auto head = load("", R"("source_to_midsagittal_mm": 1400, "source_to_detector_mm": 1800)");
  EXPECT_TRUE(told(head, "source_to_midsagittal_mm: the case says 1400, the DICOM file 1500"));
  EXPECT_FALSE(told(head, "magnify"));
  // The file's own distances go with its factor.
  const auto same = load("", "");
  EXPECT_EQ(same->geometry->GetPixelSpacing()[1], 0.2484);
  EXPECT_EQ(same->geometry->GetSourceToMidsagittalDistance(), 1500.0);
  EXPECT_FALSE(told(same, "magnify"));
}
