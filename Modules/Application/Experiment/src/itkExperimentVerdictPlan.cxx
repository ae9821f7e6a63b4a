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
#include "itkASCIICharacter.h"
#include "itkExperimentRecordPlan.h"
#include "itkExperimentStratum.h"
#include "itkExperimentTable.h"

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>

namespace itk
{
namespace
{
using MistakeEnum = ExperimentMistakeEnums::Mistake;
using CohortEnum = DentalPhantomCaseSource::CohortEnum;
constexpr const char * VerdictMethod = "robust";
constexpr const char * GoodCases = "good cases";
constexpr const char * WrongInputs = "wrong inputs";

/** Every other case is a hard one. */
CohortEnum
LevelOf(std::size_t i)
{
  return i % 2 == 0 ? CohortEnum::Typical : CohortEnum::Hard;
}

/** What a reason says before its particulars, without numbers, so that the same ones can be counted. */
std::string
WithoutNumbers(const std::string & wholeReason)
{
  const std::string reason = wholeReason.substr(0, wholeReason.find_first_of(":;"));
  std::string       text;
  bool              inNumber = false;
  for (std::size_t i = 0; i < reason.size(); ++i)
  {
    const bool digit = IsASCIIDigit(reason[i]);
    const bool point = inNumber && reason[i] == '.' && i + 1 < reason.size() && IsASCIIDigit(reason[i + 1]);
    if (digit || point)
    {
      text += inNumber ? "" : "#";
      inNumber = true;
    }
    else
    {
      inNumber = false;
      text += reason[i];
    }
  }
  return text;
}

class VerdictPlan : public ExperimentRecordPlan
{
public:
  using ExperimentRecordPlan::ExperimentRecordPlan;

  void
  FillRecord(std::size_t i, ExperimentRecord & record, const ExperimentMonitor & monitor) const override
  {
    std::size_t done = 1;
    RunStratum(GetExperimentStratum(i), record, monitor);
    for (const MistakeEnum mistake : GetExperimentMistakes())
    {
      monitor.Advance(static_cast<double>(done++) / static_cast<double>(1 + GetExperimentMistakes().size()));
      ExperimentVariation variation;
      variation.mistake = mistake;
      const ExperimentCase experimentCase =
        MakePhantomExperimentCase(record.seed, LevelOf(i), false, variation, monitor.GetAbort());
      ExperimentRunner runner(experimentCase);
      runner.SetAbort(monitor.GetAbort());
      record.Add(Describe(mistake), runner.Run(*FindExperimentMethod(VerdictMethod)));
    }
  }

  std::map<std::string, std::string>
  MakeFiles() const override
  {
    ExperimentTable          csv({ "input",
                                   "level",
                                   "jaws",
                                   "ok",
                                   "suspect",
                                   "failed",
                                   "ok_above_2mm",
                                   "largest_mm_when_ok",
                                   "most_frequent_reasons" });
    ExperimentTable          markdown({ "What is wrong",
                                        "jaws",
                                        "ok",
                                        "suspect",
                                        "failed",
                                        "ok above 2 mm",
                                        "worst ok, mm",
                                        "most frequent reasons (# a number)" });
    ExperimentConfusionTable confusion;
    for (const ExperimentRecord & record : this->GetRecords())
    {
      confusion.Add(GoodCases, record, VerdictMethod);
    }
    const auto addRows = [&](const std::string & name, const std::string & key, bool byLevel) {
      const RowType all = this->Count(key, nullptr);
      markdown.AddRow({ name,
                        std::to_string(all.jaws),
                        std::to_string(all.verdicts[0]),
                        std::to_string(all.verdicts[1]),
                        std::to_string(all.verdicts[2]),
                        std::to_string(all.okAbove),
                        ExperimentTable::Number(all.worstOk, 2),
                        all.reason });
      const CohortEnum levels[] = { CohortEnum::Typical, CohortEnum::Hard };
      for (const CohortEnum & level : levels)
      {
        const RowType row = this->Count(key, byLevel ? &level : nullptr);
        csv.AddRow({ name,
                     byLevel ? NameOf(level) : "all",
                     std::to_string(row.jaws),
                     std::to_string(row.verdicts[0]),
                     std::to_string(row.verdicts[1]),
                     std::to_string(row.verdicts[2]),
                     std::to_string(row.okAbove),
                     ExperimentTable::Number(row.worstOk, 6),
                     row.reason });
        if (!byLevel)
        {
          break;
        }
      }
    };
    addRows("nothing: cases of every kind", VerdictMethod, false);
    for (const MistakeEnum mistake : GetExperimentMistakes())
    {
      addRows(Describe(mistake), Describe(mistake), true);
      // Alike dentitions can't be told apart: that one stands alone.
      for (const ExperimentRecord & record : this->GetRecords())
      {
        confusion.Add(
          mistake == MistakeEnum::OtherPatient ? Describe(mistake) : WrongInputs, record, Describe(mistake));
      }
    }

    const auto  good = confusion.GetCounts(GoodCases);
    std::size_t within = 0;
    for (const auto & verdict : good)
    {
      within += verdict[ExperimentConfusionTable::Good];
    }
    std::ostringstream text;
    text << "# Verdict of preset robust\n\n"
         << this->GetCohort().Describe()
         << ": each as it is (kinds of cases in turn) and with each mistake (typical and hard by turns).\n"
         << DescribeFailures(this->GetRecords()) << '\n'
         << markdown.ToMarkdown() << "\nOf the jaws of good cases within 0.5 mm, "
         << good[ExperimentConfusionTable::Ok][ExperimentConfusionTable::Good] << " of " << within << " are ok.\n\n"
         << "## Confusion\n\n"
         << ExperimentConfusionTable::GetExplanation() << "\n\n"
         << confusion.ToMarkdown();
    return { { "verdict.md", text.str() },
             { "verdict.csv", confusion.ToCSV() },
             { "verdict_inputs.csv", csv.ToCSV() } };
  }

private:
  struct RowType
  {
    std::size_t jaws{ 0 };
    std::size_t verdicts[3] = { 0, 0, 0 };
    std::size_t okAbove{ 0 };
    double      worstOk{ std::numeric_limits<double>::quiet_NaN() };
    std::string reason;
  };

  RowType
  Count(const std::string & key, const CohortEnum * level) const
  {
    RowType                            row;
    std::map<std::string, std::size_t> reasons;
    for (std::size_t i = 0; i < this->GetRecords().size(); ++i)
    {
      if (level != nullptr && *level != LevelOf(i))
      {
        continue;
      }
      for (const char * jaw : { "upper", "lower" })
      {
        const auto * entry = this->GetRecords()[i].Find(key, jaw);
        if (entry == nullptr)
        {
          continue;
        }
        ++row.jaws;
        ++row.verdicts[entry->status == "ok" ? 0 : entry->status == "suspect" ? 1 : 2];
        const auto mean = entry->GetMean(true);
        if (entry->status == "ok" && mean)
        {
          row.okAbove += *mean > 2.0 ? 1 : 0;
          row.worstOk = row.worstOk >= *mean ? row.worstOk : *mean;
        }
        for (const std::string & reason : entry->reasons)
        {
          ++reasons[WithoutNumbers(reason)];
        }
      }
    }
    // The two most frequent; that the other jaw is bad is none of its own.
    for (unsigned int rank = 0; rank < 2; ++rank)
    {
      auto best = reasons.end();
      for (auto reason = reasons.begin(); reason != reasons.end(); ++reason)
      {
        if (reason->first.find("the other jaw") != 0 && (best == reasons.end() || reason->second > best->second))
        {
          best = reason;
        }
      }
      if (best != reasons.end())
      {
        row.reason += (row.reason.empty() ? "" : "; ") + best->first;
        reasons.erase(best);
      }
    }
    return row;
  }
};
} // namespace

std::unique_ptr<ExperimentPlan>
MakeVerdictPlan(const ExperimentCohort & cohort)
{
  return std::make_unique<VerdictPlan>(cohort, SelectExperimentMethods({ VerdictMethod }));
}
} // namespace itk
