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
#include "itkBatchSummary.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace
{
/** Two cases: one of two jaws, and one without a result that says what no page and no spreadsheet may run. */
std::vector<itk::BatchRecord>
MakeRecords()
{
  itk::BatchRecord good;
  good.one.id = "north_p1";
  good.one.columns = { { "age", "12" } };
  good.status = "suspect";
  good.seconds = 1.25;
  itk::BatchRecord::JawType upper;
  upper.jaw = "upper";
  upper.status = "ok";
  upper.matched = 0.5;
  upper.expectedError = 1.75;
  itk::BatchRecord::JawType lower;
  lower.jaw = "lower";
  lower.status = "suspect";
  lower.findings = { "few-points", "poor-fit" };
  lower.message = "says \"x\", twice";
  good.jaws = { upper, lower };
  itk::BatchRecord bad;
  bad.one.id = "=cmd|x";
  bad.message = "</script><!--<script>alert(1)</script>";
  return { good, bad };
}
} // namespace

TEST(BatchSummary, TableHasARowACaseAndJawAndRunsNothing)
{
  EXPECT_EQ(itk::BatchSummary(MakeRecords()).ToCSV(),
            "case,jaw,status,findings,matched_px,expected_error_px,seconds,message,age\r\n"
            "north_p1,upper,ok,,0.5,1.75,1.25,,12\r\n"
            "north_p1,lower,suspect,few-points poor-fit,,,1.25,\"says \"\"x\"\", twice\",12\r\n"
            "'=cmd|x,,unusable,,,,0.0,</script><!--<script>alert(1)</script>,\r\n");
}

TEST(BatchSummary, WhatIsNotKnownIsNull)
{
  const auto json = nlohmann::json::parse(itk::BatchSummary(MakeRecords()).ToJson());
  EXPECT_EQ(json["schema"], "dentalscr-batch/1");
  EXPECT_EQ(json["cases"], 2);
  ASSERT_EQ(json["rows"].size(), 3u);
  EXPECT_TRUE(json["rows"][1]["matched_px"].is_null());
  EXPECT_EQ(json["rows"][1]["findings"], (std::vector<std::string>{ "few-points", "poor-fit" }));
  EXPECT_EQ(json["rows"][2]["case"], "=cmd|x");
  EXPECT_EQ(json["rows"][0]["columns"]["age"], "12");
}

TEST(BatchSummary, NothingInThePageEndsTheScriptThatHoldsIt)
{
  const itk::BatchSummary summary(MakeRecords());
  const std::string       page = summary.ToPage();
  const std::string       begin = "<script type=\"application/json\" id=\"data\">";
  const auto              from = page.find(begin) + begin.size();
  ASSERT_GT(from, begin.size());
  const std::string data = page.substr(from, page.find('<', from) - from);
  EXPECT_EQ(page.compare(from + data.size(), 9, "</script>"), 0);
  auto onPage = nlohmann::json::parse(data);
  for (auto & row : onPage["rows"])
  {
    // The page alone knows which case has one of its own.
    EXPECT_EQ(row["page"], false);
    row.erase("page");
  }
  EXPECT_EQ(onPage, nlohmann::json::parse(summary.ToJson()));
}

TEST(BatchSummary, FilesAreWrittenAndAPageIfItIsWanted)
{
  const std::string       folder = itk::TestFolder();
  const itk::BatchSummary summary(MakeRecords());
  summary.Write(folder, false);
  EXPECT_FALSE(std::filesystem::exists(folder + "/index.html"));
  summary.Write(folder, true);
  EXPECT_EQ(itk::ReadTestFile(folder + "/summary.csv"), summary.ToCSV());
  EXPECT_EQ(itk::ReadTestFile(folder + "/summary.json"), summary.ToJson());
  EXPECT_EQ(itk::ReadTestFile(folder + "/index.html"), summary.ToPage());
}
