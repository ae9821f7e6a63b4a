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
#include "itkExperimentRecordPlan.h"
#include "itkExperimentStratum.h"
#include "itkExperimentTable.h"

#include <sstream>

namespace itk
{
namespace
{
constexpr const char * CoverageMethod = "robust";

class CoveragePlan : public ExperimentRecordPlan
{
public:
  using ExperimentRecordPlan::ExperimentRecordPlan;

  void
  FillRecord(std::size_t i, ExperimentRecord & record, const ExperimentMonitor & monitor) const override
  {
    RunStratum(GetExperimentStratum(i), record, monitor);
  }

  std::map<std::string, std::string>
  MakeFiles() const override
  {
    ExperimentCoverageTable  coverage;
    ExperimentConfusionTable confusion;
    for (std::size_t i = 0; i < this->GetRecords().size(); ++i)
    {
      coverage.Add(this->GetRecords()[i], CoverageMethod, GetExperimentStratum(i).name);
      confusion.Add("", this->GetRecords()[i], CoverageMethod);
    }
    ExperimentTable accuracy(
      { "Cohort", "cases", "upper mean / worst px", "lower mean / worst px", "ok of the jaws within 0.5 mm" });
    ExperimentTable csv({ "cohort",
                          "jaw",
                          "cases",
                          "not_registered",
                          "landmarks",
                          "mean_px",
                          "incisors_canines_px",
                          "premolars_px",
                          "molars_px",
                          "worst_case_px" });
    for (const ExperimentStratum & stratum : GetExperimentStrata())
    {
      const std::vector<ExperimentRecord> records = this->RecordsOf(stratum);
      if (records.empty())
      {
        continue;
      }
      ExperimentConfusionTable own;
      for (const ExperimentRecord & record : records)
      {
        own.Add("", record, CoverageMethod);
      }
      const auto               counts = own.GetCounts("");
      std::size_t              good = 0;
      std::vector<std::string> cells = { stratum.name, std::to_string(records.size()) };
      for (const auto & verdict : counts)
      {
        good += verdict[ExperimentConfusionTable::Good];
      }
      for (const char * jaw : { "upper", "lower" })
      {
        const ExperimentFigures f = PoolExperiment(records, CoverageMethod, jaw);
        cells.push_back(ExperimentTable::Number(f.mean, 2) + " / " + ExperimentTable::Number(f.worstCase, 2));
        csv.AddRow({ stratum.name,
                     jaw,
                     std::to_string(f.cases),
                     std::to_string(f.notRegistered),
                     std::to_string(f.landmarks),
                     ExperimentTable::Number(f.mean, 6),
                     ExperimentTable::Number(f.groups[0], 6),
                     ExperimentTable::Number(f.groups[1], 6),
                     ExperimentTable::Number(f.groups[2], 6),
                     ExperimentTable::Number(f.worstCase, 6) });
      }
      cells.push_back(std::to_string(counts[ExperimentConfusionTable::Ok][ExperimentConfusionTable::Good]) + " of " +
                      std::to_string(good));
      accuracy.AddRow(cells);
    }
    std::ostringstream text;
    text
      << "# Accuracy, coverage and verdict of preset robust\n\n"
      << this->GetCohort().Describe()
      << ", of several kinds in turn. Typical where nothing else is said. Errors in pixels of the radiograph (0.24 to "
         "0.26 mm), mean over the landmarks / worst case (mean over one jaw).\n"
      << DescribeFailures(this->GetRecords()) << '\n'
      << accuracy.ToMarkdown() << "\n## Coverage of the 95 % regions\n\n"
      << ExperimentCoverageTable::GetExplanation() << "\n\n"
      << coverage.ToMarkdown() << "\n## Verdict\n\n"
      << ExperimentConfusionTable::GetExplanation() << "\n\n"
      << confusion.ToMarkdown();
    return { { "coverage.md", text.str() },
             { "cohorts.csv", csv.ToCSV() },
             { "coverage.csv", coverage.ToCSV() },
             { "calibration.csv", coverage.ToCalibrationCSV() },
             { "verdict.csv", confusion.ToCSV() } };
  }

private:
  std::vector<ExperimentRecord>
  RecordsOf(const ExperimentStratum & stratum) const
  {
    std::vector<ExperimentRecord> records;
    for (std::size_t i = 0; i < this->GetRecords().size(); ++i)
    {
      if (&GetExperimentStratum(i) == &stratum)
      {
        records.push_back(this->GetRecords()[i]);
      }
    }
    return records;
  }
};
} // namespace

std::unique_ptr<ExperimentPlan>
MakeCoveragePlan(const ExperimentCohort & cohort)
{
  return std::make_unique<CoveragePlan>(cohort, SelectExperimentMethods({ CoverageMethod }));
}
} // namespace itk
