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
#include "itkDentalCaseFileReader.h"

#include "itkDentalInputError.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace
{
namespace fs = std::filesystem;

class DentalCaseFileReader : public ::testing::Test
{
protected:
  void
  SetUp() override
  {
    m_Folder = fs::path(DENTALSCR_TEST_OUTPUT_DIR) /
               (std::string("case-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(m_Folder);
    for (const char * name : { "upper.stl", "contours.json", "ceph.png" })
    {
      std::ofstream(m_Folder / name) << "x";
    }
  }
  void
  TearDown() override
  {
    fs::remove_all(m_Folder);
  }

  itk::DentalCase
  Read(const std::string & text)
  {
    std::ofstream(m_Folder / "case.json") << text;
    return itk::ReadDentalCase((m_Folder / "case.json").string());
  }

  /** The error's one line, "" where there is none. */
  std::string
  Refusal(const std::string & text)
  {
    try
    {
      this->Read(text);
      return {};
    }
    catch (const itk::DentalInputError & error)
    {
      return error.GetOneLine();
    }
  }

  fs::path m_Folder;
};
} // namespace

TEST_F(DentalCaseFileReader, LeavesUnknownWhatIsNotSaid)
{
  const auto dentalCase = this->Read(R"({"upper": "upper.stl", "contours": "contours.json"})");
  EXPECT_TRUE(dentalCase.lowerFile.empty());
  EXPECT_FALSE(dentalCase.pixelSpacing);
  EXPECT_FALSE(dentalCase.principalPoint);
  EXPECT_FALSE(dentalCase.facing);
  EXPECT_EQ(dentalCase.tracedSide, itk::TracedSideEnum::Right);
  EXPECT_EQ(dentalCase.occlusion, itk::OcclusionEnum::Check);
  EXPECT_EQ(dentalCase.millimetresPerUnit, 1.0);
  EXPECT_TRUE(dentalCase.warnings.empty());
  EXPECT_TRUE(fs::exists(dentalCase.upperFile));
}

TEST_F(DentalCaseFileReader, ReadsEveryField)
{
  const auto dentalCase = this->Read(R"({
    "upper": "upper.stl", "contours": "contours.json", "mesh_unit": "m", "occlusion": true, "traced_side": "mean",
    "numbering": "FDI",
    "cephalogram": {"image": "ceph.png", "pixel_spacing_mm": [0.1, 0.2], "spacing_plane": "midsagittal", "facing": "left"},
    "geometry": {"source_to_midsagittal_mm": 1500, "source_to_detector_mm": 1650, "source_side": "left",
                 "principal_point_px": [170, 420.5]},
    "exclude": ["18", "UR7"], "fix": ["scale", "rotation"],
    "init": {"upper": {"similarity": {"scale": 1.1, "rotation_rad": 0.1, "translation_px": [5, 6]}},
             "pose": [[1, 0, 0, 70], [0, 1, 0, 0], [0, 0, 1, -50]]}})");
  EXPECT_EQ(dentalCase.millimetresPerUnit, 1000.0);
  EXPECT_EQ(dentalCase.occlusion, itk::OcclusionEnum::Yes);
  EXPECT_EQ(dentalCase.tracedSide, itk::TracedSideEnum::Mean);
  EXPECT_EQ(dentalCase.numbering, itk::ToothCode::NumberingEnum::FDI);
  EXPECT_TRUE(dentalCase.spacingAtMidsagittalPlane);
  EXPECT_EQ((*dentalCase.pixelSpacing)[1], 0.2);
  EXPECT_EQ(dentalCase.facing, itk::CephalometricGeometry::FacingEnum::Left);
  EXPECT_EQ(dentalCase.sourceSide, itk::CephalometricGeometry::SourceSideEnum::Left);
  EXPECT_EQ(dentalCase.sourceToDetector, 1650.0);
  EXPECT_EQ((*dentalCase.principalPoint)[1], 420.5);
  ASSERT_EQ(dentalCase.excludedTeeth.size(), 2u);
  EXPECT_EQ(dentalCase.excludedTeeth[0].GetName(), "UR8");
  EXPECT_TRUE(dentalCase.fixScale && dentalCase.fixRotation && !dentalCase.fixTranslation);
  EXPECT_EQ(dentalCase.initialSimilarity.at(itk::ToothCode::JawEnum::Upper).translation[1], 6.0);
  EXPECT_EQ(dentalCase.initialSimilarity.count(itk::ToothCode::JawEnum::Lower), 0u);
  EXPECT_EQ((*dentalCase.initialPose)[3], 70.0);
  EXPECT_TRUE(dentalCase.warnings.empty());
}

TEST_F(DentalCaseFileReader, ReadsHowToFindCrowns)
{
  std::ofstream(m_Folder / "upper.json") << "{}";
  const auto dentalCase = this->Read(
    R"({"upper": "upper.stl", "contours": "contours.json", "upper_labels": "upper.json", "crowns": "labels"})");
  EXPECT_TRUE(fs::exists(dentalCase.upperLabelsFile));
  EXPECT_TRUE(dentalCase.lowerLabelsFile.empty());
  EXPECT_EQ(dentalCase.crowns, itk::CrownsEnum::Labels);
  EXPECT_EQ(this->Read(R"({"upper": "upper.stl", "contours": "contours.json"})").crowns, itk::CrownsEnum::Off);
  EXPECT_NE(this->Refusal(R"({"upper": "upper.stl", "contours": "contours.json", "crowns": "yes"})").find("crowns"),
            std::string::npos);
  EXPECT_NE(this->Refusal(R"({"upper": "upper.stl", "contours": "contours.json", "lower_labels": "upper.json"})")
              .find("lower_labels"),
            std::string::npos);
}

TEST_F(DentalCaseFileReader, ReadsLandmarksToRegisterWithInPlaceOfContours)
{
  std::ofstream(m_Folder / "ceph.json") << "{}";
  const auto file = this->Read(R"({"upper": "upper.stl", "cephalometric_landmarks": "ceph.json",
                                   "cephalogram": {"image_size": [703, 938]}, "traced_side": "standard"})");
  EXPECT_TRUE(fs::exists(file.cephalometricLandmarksFile));
  EXPECT_EQ(file.cephalometricLandmarks, nullptr);
  EXPECT_TRUE(file.contoursFile.empty());
  EXPECT_EQ((*file.imageSize)[1], 938u);
  EXPECT_EQ(file.tracedSide, itk::TracedSideEnum::Standard);
  EXPECT_TRUE(file.tracedSideIsGiven);
  EXPECT_TRUE(file.warnings.empty());
  const auto own = this->Read(
    R"({"upper": "upper.stl", "contours": "contours.json", "cephalometric_landmarks": {"3_MB": [1, 2]}, "numbering": "universal"})");
  EXPECT_TRUE(own.cephalometricLandmarksFile.empty());
  ASSERT_NE(own.cephalometricLandmarks, nullptr);
  EXPECT_NE(own.cephalometricLandmarks->Find("UR6_MB"), nullptr);
  EXPECT_FALSE(own.tracedSideIsGiven);
}

TEST_F(DentalCaseFileReader, WarnsOfWhatItDoesNotKnow)
{
  const auto dentalCase =
    this->Read(R"({"upper": "upper.stl", "contours": "contours.json", "uper": 1, "geometry": {"sid": 3}})");
  ASSERT_EQ(dentalCase.warnings.size(), 2u);
  EXPECT_NE(dentalCase.warnings[0].find("uper"), std::string::npos);
  EXPECT_NE(dentalCase.warnings[1].find("geometry.sid"), std::string::npos);
}

TEST_F(DentalCaseFileReader, NamesTheFieldThatIsWrong)
{
  const std::pair<const char *, const char *> cases[] = {
    { R"({"contours": "contours.json"})", "upper" },
    { R"({"upper": "upper.stl"})", "contours" },
    { R"({"upper": "upper.stl"})", "cephalometric_landmarks" },
    { R"({"upper": "upper.stl", "cephalometric_landmarks": "none.json"})", "none.json" },
    { R"({"upper": "upper.stl", "cephalometric_landmarks": [1, 2]})", "cephalometric_landmarks" },
    { R"({"upper": "upper.stl", "cephalometric_landmarks": {"U1_tip": [1]}})", "cephalometric_landmarks.U1_tip" },
    { R"({"upper": "upper.stl", "cephalometric_landmarks": {"Sella": [1, 2]}})", "no dental landmark" },
    { R"({"upper": "upper.stl", "contours": "contours.json", "cephalogram": {"image_size": [0, 5]}})",
      "cephalogram.image_size[0]" },
    { R"({"upper": "none.stl", "contours": "contours.json"})", "none.stl" },
    { R"({"upper": "", "contours": "contours.json"})", "upper" },
    { R"({"upper": "upper.stl", "contours": "contours.json", "mesh_unit": "foot"})", "mesh_unit" },
    { R"({"upper": "upper.stl", "contours": "contours.json", "cephalogram": {"pixel_spacing_mm": [100, 0.1]}})",
      "cephalogram.pixel_spacing_mm" },
    { R"({"upper": "upper.stl", "contours": "contours.json", "geometry": {"source_to_detector_mm": "far"}})",
      "geometry.source_to_detector_mm" },
    { R"({"upper": "upper.stl", "contours": "contours.json", "init": {"pose": [[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0]]}})",
      "init.pose" },
    { R"([1, 2])", "case.json" },
  };
  for (const auto & entry : cases)
  {
    const std::string refusal = this->Refusal(entry.first);
    EXPECT_NE(refusal.find(entry.second), std::string::npos) << entry.first << " -> " << refusal;
  }
}
