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
#include "itkCohortExperiment.h"

#include "itkDentalInputError.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace
{
namespace fs = std::filesystem;
using ExperimentType = itk::CohortExperiment;

class CohortExperiment : public testing::Test
{
protected:
  void
  SetUp() override
  {
    m_Folder = fs::path(DENTALSCR_TEST_OUTPUT_DIR) / "experiment" /
               testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(m_Folder);
    fs::create_directories(m_Folder);
  }

  /** Two cases by two fast methods. */
  ExperimentType::Pointer
  Make(const std::string & name, unsigned int threads = 2)
  {
    auto experiment = ExperimentType::New();
    experiment->SetNumberOfCases(2);
    experiment->SetSeed(5);
    experiment->SetMethods({ "bounding-box", "icp", "paper" });
    experiment->SetOutputDirectory((m_Folder / name).string());
    experiment->SetNumberOfWorkUnits(threads);
    experiment->DrawFiguresOff();
    return experiment;
  }

  std::map<std::string, std::string>
  Tables(const std::string & name)
  {
    std::map<std::string, std::string> files;
    for (const auto & entry : fs::directory_iterator(m_Folder / name))
    {
      if (entry.is_regular_file() && entry.path().filename() != "times.csv")
      {
        std::ifstream      file(entry.path(), std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        files[entry.path().filename().string()] = text.str();
      }
    }
    return files;
  }

  std::string
  MessageOf(ExperimentType * experiment)
  {
    try
    {
      experiment->Update();
    }
    catch (const itk::DentalInputError & error)
    {
      return error.GetOneLine();
    }
    return "no error";
  }

  fs::path m_Folder;
};
} // namespace

TEST_F(CohortExperiment, SameBitsForAnyNumberOfThreadsAndAfterResuming)
{
  this->Make("one", 1)->Update();
  const auto reference = this->Tables("one");
  EXPECT_EQ(reference.count("tables.md"), 1u);
  EXPECT_EQ(reference.count("table1_landmarks.csv"), 1u);
  EXPECT_EQ(reference.count("table2_contours.csv"), 1u);
  EXPECT_EQ(reference.count("table3_ablation.csv"), 1u);

  this->Make("four", 4)->Update();
  EXPECT_EQ(this->Tables("four"), reference);

  // One case damaged, as by a full disk: it alone is run again.
  std::ofstream(m_Folder / "four" / "cases" / "typical-0006.json") << "{\"schema\": ";
  const auto resumed = this->Make("four");
  resumed->Update();
  EXPECT_EQ(resumed->GetNumberOfResumedCases(), 1u);
  EXPECT_EQ(this->Tables("four"), reference);
}

TEST_F(CohortExperiment, InterruptedRunLeavesNoTablesAndGoesOn)
{
  const auto interrupted = this->Make("run", 1);
  interrupted->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    // When the first case is complete.
    if (interrupted->GetCurrentStage() == "1 of 2 cases")
    {
      interrupted->AbortGenerateDataOn();
    }
  });
  EXPECT_THROW(interrupted->Update(), itk::ProcessAborted);
  EXPECT_FALSE(fs::exists(m_Folder / "run" / "tables.md"));
  EXPECT_TRUE(fs::exists(m_Folder / "run" / "cases" / "typical-0005.json"));

  const auto again = this->Make("run");
  again->Update();
  EXPECT_GE(again->GetNumberOfResumedCases(), 1u);
  EXPECT_TRUE(fs::exists(m_Folder / "run" / "tables.md"));
}

TEST_F(CohortExperiment, PicturesOfFewerCasesDoNotStayBesideTablesOfMore)
{
  const auto first = this->Make("run");
  first->SetMethods({ "bounding-box", "single-stage" });
  first->SetNumberOfCases(1);
  first->DrawFiguresOn();
  first->Update();
  const fs::path folder = m_Folder / "run";
  ASSERT_TRUE(fs::exists(folder / "figure_median_upper.png"));
  // What is made of tables and figures afterwards, and what is somebody else's.
  fs::create_directory(folder / "plots");
  for (const char * name : { "index.html", "plots/landmark_errors.png", "plots/own.png", "figure_own.png" })
  {
    std::ofstream(folder / name) << "of one case";
  }
  const auto more = this->Make("run");
  more->SetMethods({ "bounding-box", "single-stage" });
  more->Update();
  for (const char * name : { "index.html", "plots/landmark_errors.png", "figure_median_upper.png" })
  {
    EXPECT_FALSE(fs::exists(folder / name)) << name;
  }
  EXPECT_TRUE(fs::exists(folder / "plots" / "own.png"));
  EXPECT_TRUE(fs::exists(folder / "figure_own.png"));
  EXPECT_TRUE(fs::exists(folder / "tables.md"));
}

TEST_F(CohortExperiment, RefusesTheFolderOfAnotherExperiment)
{
  const auto first = this->Make("run");
  first->SetMethods({ "bounding-box" });
  first->SetNumberOfCases(1);
  first->Update();

  auto other = this->Make("run");
  other->SetMethods({ "bounding-box" });
  other->SetSeed(6);
  EXPECT_NE(this->MessageOf(other).find("seed"), std::string::npos);
  other = this->Make("run");
  other->SetMethods({ "icp" });
  EXPECT_NE(this->MessageOf(other).find("methods"), std::string::npos);
  other = this->Make("run");
  other->SetMethods({ "bounding-box" });
  other->SetLevel(ExperimentType::CohortEnum::Hard);
  EXPECT_NE(this->MessageOf(other).find("level"), std::string::npos);

  // More cases are no other experiment.
  other = this->Make("run");
  other->SetMethods({ "bounding-box" });
  EXPECT_EQ(this->MessageOf(other), "no error");
  EXPECT_EQ(other->GetNumberOfResumedCases(), 1u);
}

TEST_F(CohortExperiment, SaysWhatIsWrongWithItsSettings)
{
  auto experiment = this->Make("run");
  experiment->SetNumberOfCases(0);
  EXPECT_NE(this->MessageOf(experiment).find("--cases"), std::string::npos);
  experiment = this->Make("run");
  experiment->SetMethods({ "paper", "magic" });
  EXPECT_NE(this->MessageOf(experiment).find("magic"), std::string::npos);
  experiment = this->Make("run");
  experiment->SetCaseDirectory((m_Folder / "nowhere").string());
  EXPECT_NE(this->MessageOf(experiment).find("nowhere"), std::string::npos);
  std::ofstream(m_Folder / "file") << "x";
  experiment = this->Make("file");
  EXPECT_NE(this->MessageOf(experiment).find("it is a file"), std::string::npos);
  EXPECT_FALSE(fs::exists(m_Folder / "run"));
}

TEST_F(CohortExperiment, CaptureStudyFindsTheRangeOfEachMethod)
{
  const auto experiment = this->Make("capture");
  experiment->SetNumberOfCases(1);
  experiment->SetStudy(itk::CohortExperimentEnums::Study::Capture);
  experiment->SetNumberOfStarts(10);
  experiment->SetMethods({ "bounding-box", "icp" });
  experiment->Update();
  const auto files = this->Tables("capture");
  // A line a bin under the header; the bounding box starts nowhere.
  EXPECT_EQ(std::count(files.at("capture.csv").begin(), files.at("capture.csv").end(), '\n'), 11);
  EXPECT_EQ(files.at("capture.csv").find("bounding-box"), std::string::npos);
  // Ten starts for each of two jaws, one a bin.
  EXPECT_NE(files.at("capture.csv").find("icp,0.0,2.0,2,"), std::string::npos);
  EXPECT_EQ(files.at("capture_range.csv").find("icp,20,") != std::string::npos, true);
}

TEST_F(CohortExperiment, PrintsItself)
{
  std::ostringstream text;
  this->Make("run")->Print(text);
  EXPECT_NE(text.str().find("Methods: bounding-box icp paper"), std::string::npos);
  EXPECT_NE(text.str().find("Study: tables"), std::string::npos);
}
