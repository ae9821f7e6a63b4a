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
#include "itkBatchParts.h"

#include "itkBatchSummary.h"
#include "itkTestFile.h"

#include <gtest/gtest.h>

namespace
{
namespace fs = std::filesystem;

std::vector<itk::BatchCase>
MakeCases(const std::vector<std::string> & names)
{
  std::vector<itk::BatchCase> cases;
  for (const std::string & name : names)
  {
    itk::BatchCase one;
    one.id = name;
    one.columns = { { "ward", "of " + name } };
    cases.push_back(one);
  }
  return cases;
}

itk::BatchRecord
MakeRecord(const std::string & name, const std::string & status)
{
  itk::BatchRecord record;
  record.one = MakeCases({ name }).front();
  record.status = status;
  record.seconds = 1.5;
  if (status == "unusable")
  {
    record.message = "upper.stl: is no scan";
    return record;
  }
  itk::BatchRecord::JawType upper;
  upper.jaw = "upper";
  upper.status = status;
  upper.findings = { "poor-fit" };
  upper.expectedError = 2.5;
  upper.message = "=fits badly";
  itk::BatchRecord::JawType lower;
  lower.jaw = "lower";
  lower.status = "skipped";
  lower.message = "no tracing";
  record.jaws = { upper, lower };
  return record;
}

/** What a batch leaves, less its cases; without a summary it was killed before its first one. */
void
MakePart(const std::string & name, const std::vector<itk::BatchRecord> & records, bool isComplete = true)
{
  const std::string folder = itk::TestFolder() + "/parts/" + name;
  fs::create_directories(folder + "/.batch");
  if (!records.empty())
  {
    itk::BatchSummary(records, isComplete).Write(folder, false);
  }
}

itk::BatchParts
MakeParts()
{
  return { itk::TestFolder() + "/parts", itk::TestFolder() };
}
} // namespace

TEST(BatchParts, PutRowsInTheOrderOfTheCasesAndSayWhereResultsLie)
{
  // By name the later part comes first.
  MakePart("2", { MakeRecord("a", "ok"), MakeRecord("b", "unusable") });
  MakePart("1", { MakeRecord("c", "suspect"), MakeRecord("d", "failed") });
  fs::create_directories(itk::TestFolder() + "/parts/notes");
  const auto cases = MakeCases({ "a", "b", "c", "d" });
  auto       parts = MakeParts();
  const auto records = parts.Collect(cases);
  EXPECT_TRUE(parts.GetUnfinished().empty());
  EXPECT_EQ(parts.GetNumberOfMissingCases(), 0u);
  EXPECT_EQ(parts.GetNumberOfOtherCases(), 0u);
  ASSERT_EQ(records.size(), 4u);
  const char * const status[] = { "ok", "unusable", "suspect", "failed" };
  const char * const folder[] = { "parts/2/a", "parts/2/b", "parts/1/c", "parts/1/d" };
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(records[i].one.id, cases[i].id);
    EXPECT_EQ(records[i].status, status[i]);
    EXPECT_EQ(records[i].folder, folder[i]);
    EXPECT_EQ(records[i].seconds, 1.5);
  }
  EXPECT_EQ(records[1].message, "upper.stl: is no scan");
  EXPECT_EQ(records[2].jaws.size(), 2u);
  EXPECT_EQ(records[2].jaws[0].findings, std::vector<std::string>{ "poor-fit" });
  EXPECT_EQ(records[2].jaws[0].expectedError, 2.5);
  EXPECT_FALSE(records[2].jaws[0].matched);
  // One batch over all of them has the same table, less the column that says where.
  EXPECT_EQ(itk::BatchSummary({ records[0] }).ToCSV(),
            "case,jaw,status,findings,matched_px,expected_error_px,seconds,message,folder,ward\r\n"
            "a,upper,ok,poor-fit,,2.5,1.5,'=fits badly,parts/2/a,of a\r\n"
            "a,lower,skipped,,,,1.5,no tracing,parts/2/a,of a\r\n");
}

TEST(BatchParts, NothingIsMissingInSilence)
{
  MakePart("1", { MakeRecord("a", "ok") });
  MakePart("2", { MakeRecord("b", "ok") }, false);
  MakePart("3", {});
  auto       parts = MakeParts();
  const auto records = parts.Collect(MakeCases({ "b", "c", "d" }));
  EXPECT_EQ(parts.GetUnfinished(), (std::vector<std::string>{ "2", "3" }));
  EXPECT_EQ(parts.GetNumberOfMissingCases(), 2u);
  EXPECT_EQ(parts.GetNumberOfOtherCases(), 1u);
  ASSERT_EQ(records.size(), 3u);
  EXPECT_EQ(records[0].status, "ok");
  for (const std::size_t i : { 1u, 2u })
  {
    EXPECT_EQ(records[i].status, "unusable");
    EXPECT_PRED2(itk::Contains, records[i].message, "no part of the cohort");
    EXPECT_EQ(records[i].one.columns.front().second, "of " + records[i].one.id);
  }
}

TEST(BatchParts, WhatCannotBePutTogetherIsNamed)
{
  fs::create_directories(itk::TestFolder() + "/parts/empty");
  EXPECT_PRED2(itk::Contains,
               itk::ExpectInputError([] { MakeParts().Collect(MakeCases({ "a" })); }).GetProblem(),
               "holds no batch");
  MakePart("1", { MakeRecord("a", "ok") });
  MakePart("2", { MakeRecord("a", "ok") });
  const auto twice = itk::ExpectInputError([] { MakeParts().Collect(MakeCases({ "a" })); });
  EXPECT_PRED2(itk::Contains, twice.GetOneLine(), "a case of two parts: parts/1/a and parts/2/a");
  itk::WriteTestFile("parts/2/summary.json", R"({"schema": "dentalscr-batch/1", "rows": [{"case": "b"}]})");
  EXPECT_PRED2(itk::Contains,
               itk::ExpectInputError([] { MakeParts().Collect(MakeCases({ "a" })); }).GetOneLine(),
               "parts/2/summary.json");
  itk::WriteTestFile("parts/2/summary.json", R"({"schema": "dentalscr-result/1"})");
  EXPECT_PRED2(itk::Contains,
               itk::ExpectInputError([] { MakeParts().Collect(MakeCases({ "a" })); }).GetOneLine(),
               "is not \"dentalscr-batch/1\"");
}

TEST(BatchParts, ACaseWhoseJawsWereAllSkippedHasFailedAsInItsResult)
{
  auto record = MakeRecord("a", "skipped");
  record.status = "failed";
  MakePart("1", { record });
  auto parts = MakeParts();
  EXPECT_EQ(parts.Collect(MakeCases({ "a" })).front().status, "failed");
}
