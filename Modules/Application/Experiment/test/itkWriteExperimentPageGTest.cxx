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
#include "itkWriteExperimentPage.h"

#include "itkDentalInputError.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace
{
namespace fs = std::filesystem;

/** The folder of an experiment that is complete. */
class WriteExperimentPage : public testing::Test
{
protected:
  void
  SetUp() override
  {
    m_Folder = fs::path(DENTALSCR_TEST_OUTPUT_DIR) / "experiment-page" /
               testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(m_Folder);
    fs::create_directories(m_Folder / "plots");
    this->Write("experiment.json",
                R"({"schema": "dentalscr-experiment/1", "study": "tables", "from": "", "level": "typical", )"
                R"("seed": 18446744073709551615, "methods": ["paper"]})");
    this->Write("cases.csv", "case,seed\r\na,1\r\n");
  }

  void
  Write(const char * name, const std::string & text) const
  {
    std::ofstream(m_Folder / name, std::ios::binary) << text;
  }

  std::string
  MakePage() const
  {
    itk::WriteExperimentPage(m_Folder.string());
    std::ifstream      file(m_Folder / "index.html", std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  std::string
  MessageOf() const
  {
    try
    {
      itk::WriteExperimentPage(m_Folder.string());
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

TEST_F(WriteExperimentPage, TheSeedIsTheOneThatWasAskedFor)
{
  // More digits than a double has.
  EXPECT_NE(this->MakePage().find(R"(["first seed","18446744073709551615"])"), std::string::npos);
  this->Write("experiment.json", R"({"study": "tables", "from": "", "level": "typical", "seed": -1.5, "methods": []})");
  EXPECT_NE(this->MessageOf().find("experiment.json: seed: "), std::string::npos) << this->MessageOf();
}

TEST_F(WriteExperimentPage, ATableOfAnySizeIsLinkedIfNotShown)
{
  const std::string shown = this->MakePage();
  EXPECT_NE(shown.find(R"("rows":[["a","1"]])"), std::string::npos);
  // A hole on the disk, and more than a page, or the reader of small files, takes.
  fs::resize_file(m_Folder / "cases.csv", 40u << 20);
  const std::string page = this->MakePage();
  EXPECT_LT(page.size(), shown.size() + 100);
  EXPECT_NE(page.find(R"("file":"cases.csv")"), std::string::npos);
  EXPECT_NE(page.find(R"("rows":null)"), std::string::npos);
}

TEST_F(WriteExperimentPage, APictureThatCannotBeReadIsAnErrorThatNamesIt)
{
  this->Write("plots/landmark_errors.png", "\x89PNG");
  EXPECT_NE(this->MakePage().find("data:image/png;base64,iVBORw=="), std::string::npos);
  this->Write("figure_worst_lower.png", "");
  EXPECT_NE(this->MessageOf().find("figure_worst_lower.png: "), std::string::npos) << this->MessageOf();
}
