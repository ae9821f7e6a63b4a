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
#include "itkExperimentConfusionTable.h"
#include "itkExperimentCoverageTable.h"
#include "itkExperimentFigures.h"
#include "itkExperimentStatistics.h"
#include "itkExperimentTable.h"
#include "itkExperimentTables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{
using GroupEnum = itk::ToothCode::GroupEnum;

/** A case whose upper jaw has errors of 4 and 12 px (1 and 3 mm), or is not registered. */
itk::ExperimentRecord
MakeRecord(const std::string & id, bool registered, double factor = 1.0)
{
  itk::ExperimentRecord record;
  record.id = id;
  record.marked["upper"] = 2;
  itk::ExperimentRecord::JawType jaw;
  jaw.registered = registered;
  jaw.status = registered ? "ok" : "failed";
  if (registered)
  {
    jaw.landmarks = { { "UR1_tip", GroupEnum::IncisorsAndCanines, 4.0 * factor, 1.0 * factor, 3.0 },
                      { "UR6_MB", GroupEnum::Molars, 12.0 * factor, 3.0 * factor, 3.0 } };
    jaw.whole = { 2.0, 8.0, 3.0, 1.0 };
  }
  else
  {
    jaw.reasons = { "no, \"really\"" };
  }
  record.methods["robust"]["upper"] = jaw;
  return record;
}
} // namespace

TEST(ExperimentStatistics, SignFlipTestCountsEveryCombination)
{
  // Of the 8 sums of +-1 +-2 +-3 two are as far from 0 as 6.
  EXPECT_DOUBLE_EQ(itk::SignFlipTest({ 1.0, 2.0, 3.0 }, 100, 1), 0.25);
  EXPECT_DOUBLE_EQ(itk::SignFlipTest({ 1.0, -1.0 }, 100, 1), 1.0);
  EXPECT_DOUBLE_EQ(itk::SignFlipTest({}, 100, 1), 1.0);
  // 20 equal signs: 2^-19 in truth, at most the observed one among 1000 seeded flips.
  EXPECT_DOUBLE_EQ(itk::SignFlipTest(std::vector<double>(20, 1.0), 999, 1), 0.001);
}

TEST(ExperimentStatistics, HolmAdjustsInTheGivenOrder)
{
  const auto adjusted = itk::AdjustByHolm({ 0.01, 0.04, 0.03 });
  EXPECT_NEAR(adjusted[0], 0.03, 1e-12);
  EXPECT_NEAR(adjusted[1], 0.06, 1e-12);
  EXPECT_NEAR(adjusted[2], 0.06, 1e-12);
}

TEST(ExperimentStatistics, BootstrapIntervalHoldsTheMeanAndShrinksWithCases)
{
  std::vector<std::vector<double>> few;
  std::vector<std::vector<double>> many;
  for (int i = 0; i < 400; ++i)
  {
    const std::vector<double> errors = { 1.0 + 0.01 * (i % 100), 1.5 };
    many.push_back(errors);
    if (i < 400 && i % 20 == 0)
    {
      few.push_back(errors);
    }
  }
  const auto wide = itk::BootstrapMeanInterval(few, 0.95, 1000, 3);
  const auto narrow = itk::BootstrapMeanInterval(many, 0.95, 1000, 3);
  EXPECT_LT(narrow.first, 1.4975);
  EXPECT_GT(narrow.second, 1.4975);
  EXPECT_LT(narrow.second - narrow.first, 0.5 * (wide.second - wide.first));
  EXPECT_EQ(itk::BootstrapMeanInterval(few, 0.95, 1000, 3), wide);
  EXPECT_TRUE(std::isnan(itk::BootstrapMeanInterval({}, 0.95, 100, 1).first));
}

TEST(ExperimentTables, PoolsLandmarksAndCountsWhatIsMissing)
{
  const auto figures = itk::PoolExperiment(
    { MakeRecord("a", true), MakeRecord("b", true, 0.5), MakeRecord("c", false) }, "robust", "upper");
  EXPECT_EQ(figures.cases, 3u);
  EXPECT_EQ(figures.notRegistered, 1u);
  EXPECT_EQ(figures.failed, 1u);
  EXPECT_EQ(figures.landmarks, 4u);
  // 4, 12, 2, 6 px.
  EXPECT_DOUBLE_EQ(figures.mean, 6.0);
  EXPECT_NEAR(figures.rmse, std::sqrt(50.0), 1e-12);
  EXPECT_NEAR(figures.standardDeviation, std::sqrt(14.0), 1e-12);
  EXPECT_DOUBLE_EQ(figures.groups[0], 3.0);
  EXPECT_TRUE(std::isnan(figures.groups[1]));
  EXPECT_DOUBLE_EQ(figures.groups[2], 9.0);
  EXPECT_DOUBLE_EQ(figures.worstCase, 8.0);
  EXPECT_DOUBLE_EQ(figures.contour.hausdorff, 8.0);
  // 1, 3, 0.5, 1.5 mm and two that nobody found.
  EXPECT_DOUBLE_EQ(figures.successRates[0], 3.0 / 6.0);
  EXPECT_DOUBLE_EQ(figures.successRates[2], 4.0 / 6.0);
}

TEST(ExperimentTables, PaperFiguresStandBesideOursAndSayWhereTheyAreFrom)
{
  auto record = MakeRecord("a", true);
  record.methods["paper"] = record.methods["robust"];
  const auto files = itk::MakeExperimentTables(
    { record, MakeRecord("c", false) }, itk::SelectExperimentMethods({ "paper", "robust" }), { "two cases", 1 });
  const std::string & text = files.at("tables.md");
  EXPECT_NE(text.find("8.000 / 17.546"), std::string::npos);
  EXPECT_NE(text.find("2.000 / 8.397"), std::string::npos);
  EXPECT_NE(text.find("other, private data"), std::string::npos);
  // The failure is listed with its reason, in CSV as a quoted cell.
  EXPECT_NE(text.find("| c | upper | DentalSCR robust | not registered | no, \"really\" |"), std::string::npos);
  EXPECT_NE(files.at("failures.csv").find("\"no, \"\"really\"\"\""), std::string::npos);
  // 4 / 3 and 12 / 3 sigma: one of two within 2.448.
  EXPECT_NE(files.at("coverage.csv").find("all,all,1,2,0.500000"), std::string::npos);
}

TEST(ExperimentTables, RecordSurvivesItsFile)
{
  const auto record = MakeRecord("a", true);
  const auto text = record.ToJson("key");
  EXPECT_EQ(itk::ExperimentRecord::FromJson(text, "key").ToJson("key"), text);
  EXPECT_THROW(itk::ExperimentRecord::FromJson(text, "another"), std::exception);
  EXPECT_THROW(itk::ExperimentRecord::FromJson("{}", "key"), std::exception);
}

TEST(ExperimentTables, RowsFitTheirHeader)
{
  itk::ExperimentTable table({ "a", "b" });
  EXPECT_THROW(table.AddRow({ "1" }), std::logic_error);
  table.AddRow({ "1,5", "x|y" });
  EXPECT_EQ(table.ToCSV(), "a,b\n\"1,5\",x|y\n");
  EXPECT_EQ(table.ToMarkdown(), "| a | b |\n|---|---:|\n| 1,5 | x\\|y |\n");
  EXPECT_EQ(itk::ExperimentTable::Number(std::nan(""), 2), "");
}

TEST(ExperimentTables, CoverageIsCountedByJawGroupAndCohort)
{
  itk::ExperimentCoverageTable table;
  EXPECT_TRUE(table.IsEmpty());
  // 4 and 12 px at a sigma of 3 px; half of that in the other cohort.
  table.Add(MakeRecord("a", true), "robust", "wide");
  table.Add(MakeRecord("b", true, 0.5), "robust", "narrow");
  table.Add(MakeRecord("c", false), "robust", "narrow");
  const auto csv = table.ToCSV();
  EXPECT_NE(csv.find("all,all,2,4,0.750000,3.000000"), std::string::npos) << csv;
  EXPECT_NE(csv.find("tooth group,molars,2,2,0.500000"), std::string::npos) << csv;
  EXPECT_NE(csv.find("cohort,wide,1,2,0.500000"), std::string::npos) << csv;
  EXPECT_NE(csv.find("cohort,narrow,1,2,1.000000"), std::string::npos) << csv;
  EXPECT_EQ(csv.find("lower"), std::string::npos);
  // rms an axis of 4 and 12 px: sqrt((16 + 144) / 2 / 2).
  EXPECT_NE(csv.find("cohort,wide,1,2,0.500000,3.000000,6.324555,0.474342"), std::string::npos) << csv;
  EXPECT_NE(table.ToCalibrationCSV().find("all,all,0.50,0.250000"), std::string::npos);
  EXPECT_NE(table.ToCalibrationCSV().find("all,all,0.95,0.750000"), std::string::npos);
}

TEST(ExperimentTables, ConfusionCountsJawsByVerdictAndError)
{
  itk::ExperimentConfusionTable table;
  // Means of 2, 0.4 mm, and none.
  table.Add("good", MakeRecord("a", true), "robust");
  table.Add("good", MakeRecord("b", true, 0.2), "robust");
  table.Add("bad", MakeRecord("c", false), "robust");
  EXPECT_EQ(table.GetCounts("good")[0][0], 1u);
  EXPECT_EQ(table.GetCounts("good")[0][1], 1u);
  EXPECT_EQ(table.GetCounts("bad")[2][3], 1u);
  EXPECT_EQ(table.GetCounts("absent")[0][0], 0u);
  EXPECT_NE(table.ToCSV().find("good,ok,1,1,0,0\n"), std::string::npos);
}

TEST(ExperimentTables, AJawWithoutLandmarksIsListed)
{
  auto record = MakeRecord("a", true);
  auto bare = record.methods["robust"]["upper"];
  bare.landmarks.clear();
  record.methods["robust"]["lower"] = bare;
  const auto files =
    itk::MakeExperimentTables({ record }, itk::SelectExperimentMethods({ "robust" }), { "one case", 1 });
  EXPECT_NE(files.at("failures.csv").find("a,lower,,no error known"), std::string::npos);
  EXPECT_EQ(files.at("failures.csv").find("a,upper"), std::string::npos);
}
