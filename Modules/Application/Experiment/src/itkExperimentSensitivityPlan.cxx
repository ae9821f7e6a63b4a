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
#include "itkExperimentRecordPlan.h"
#include "itkExperimentFigures.h"
#include "itkExperimentTable.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace itk
{
namespace
{
struct Condition
{
  const char *        factor;
  std::string         level;
  ExperimentVariation variation;
};

/** What a cohort is spoilt with; the first is the cohort as it is. */
std::vector<Condition>
MakeConditions()
{
  std::vector<Condition> conditions = { { "", "as drawn", {} } };
  const auto add = [&](const char * factor, const std::string & level, const ExperimentVariation & variation) {
    conditions.push_back({ factor, level, variation });
  };
  for (const double noise : { 1.0, 2.0, 4.0 })
  {
    ExperimentVariation variation;
    variation.extraNoise = noise;
    add("tracing noise, px", "+" + ExperimentTable::Number(noise, 0), variation);
  }
  for (const double part : { 0.2, 0.4, 0.6 })
  {
    ExperimentVariation variation;
    variation.dropOut = part;
    add("drop-out", ExperimentTable::Number(100.0 * part, 0) + " %", variation);
  }
  for (const double percent : { -10.0, -5.0, 5.0, 10.0 })
  {
    ExperimentVariation variation;
    variation.sourceDistanceFactor = 1.0 + 0.01 * percent;
    add("wrong source distance", ExperimentTable::Number(percent, 0) + " %", variation);
  }
  for (const double percent : { -3.0, -1.5, 1.5, 3.0 })
  {
    ExperimentVariation variation;
    variation.spacingFactor = 1.0 + 0.01 * percent;
    add("wrong pixel spacing", ExperimentTable::Number(percent, 1) + " %", variation);
  }
  for (const double degrees : { -5.0, -2.5, 2.5, 5.0 })
  {
    ExperimentVariation variation;
    variation.yawDegrees = degrees;
    add("yaw of the head, degrees", ExperimentTable::Number(degrees, 1), variation);
  }
  for (const double degrees : { -5.0, -2.5, 2.5, 5.0 })
  {
    ExperimentVariation variation;
    variation.rollDegrees = degrees;
    add("roll of the head, degrees", ExperimentTable::Number(degrees, 1), variation);
  }
  const std::pair<const char *, std::vector<unsigned int>> missing[] = {
    { "left 6", { 26, 36 } }, { "right 4", { 14, 44 } }, { "right 6", { 16, 46 } }, { "both 7", { 17, 27, 37, 47 } }
  };
  for (const auto & teeth : missing)
  {
    ExperimentVariation variation;
    variation.missingTeeth = teeth.second;
    add("missing teeth", teeth.first, variation);
  }
  for (const double amount : { 3.0, 6.0, 10.0 })
  {
    ExperimentVariation variation;
    variation.distalTrim = amount;
    add("scan trimmed distally, mm", ExperimentTable::Number(amount, 0), variation);
  }
  return conditions;
}

class SensitivityPlan : public ExperimentRecordPlan
{
public:
  using ExperimentRecordPlan::ExperimentRecordPlan;

  void
  FillRecord(std::size_t i, ExperimentRecord & record, const ExperimentMonitor & monitor) const override
  {
    std::size_t done = 0;
    for (std::size_t k = 0; k < m_Conditions.size() && record.failure.empty(); ++k)
    {
      record.failure = Try([&]() {
        const ExperimentCase experimentCase =
          this->GetCohort().Make(i, NeedsRadiograph(this->GetMethods()), monitor.GetAbort(), m_Conditions[k].variation);
        ExperimentRunner runner(experimentCase);
        runner.SetAbort(monitor.GetAbort());
        for (const ExperimentMethod & method : this->GetMethods())
        {
          monitor.Advance(static_cast<double>(done++) /
                          static_cast<double>(m_Conditions.size() * this->GetMethods().size()));
          record.Add(KeyOf(method.name, k), runner.Run(method));
        }
      });
      if (!record.failure.empty())
      {
        record.failure = std::string(m_Conditions[k].factor) + ' ' + m_Conditions[k].level + ": " + record.failure;
      }
    }
  }

  std::map<std::string, std::string>
  MakeFiles() const override
  {
    ExperimentTable    csv({ "factor",
                             "level",
                             "method",
                             "mean_px",
                             "upper_mean_px",
                             "lower_mean_px",
                             "jaws",
                             "above_2mm",
                             "not_registered",
                             "verdict_failed" });
    std::ostringstream text;
    text
      << "# Sensitivity\n\n"
      << this->GetCohort().Describe()
      << ", spoilt one factor at a time. Mean landmark error in px over both jaws; in brackets the jaws above 2 mm or "
         "not registered, where there are any. Where a tooth is missing its landmarks are, too.\n"
      << DescribeFailures(this->GetRecords());
    std::string              factor;
    std::vector<std::string> header = { "" };
    for (const ExperimentMethod & method : this->GetMethods())
    {
      header.push_back(method.title);
    }
    auto       markdown = ExperimentTable(header);
    const auto flush = [&]() {
      if (!factor.empty())
      {
        text << "\n## " << factor << "\n\n" << markdown.ToMarkdown();
      }
      markdown = ExperimentTable(header);
    };
    const auto addRow = [&](const std::string & name, std::size_t k) {
      std::vector<std::string> cells = { m_Conditions[k].level };
      for (const ExperimentMethod & method : this->GetMethods())
      {
        const std::string       id = KeyOf(method.name, k);
        const ExperimentFigures upper = PoolExperiment(this->GetRecords(), id, "upper");
        const ExperimentFigures lower = PoolExperiment(this->GetRecords(), id, "lower");
        const auto              landmarks = static_cast<double>(upper.landmarks + lower.landmarks);
        const double            sum = (upper.landmarks > 0 ? upper.mean * static_cast<double>(upper.landmarks) : 0.0) +
                           (lower.landmarks > 0 ? lower.mean * static_cast<double>(lower.landmarks) : 0.0);
        const std::size_t lost = upper.above2mm + lower.above2mm + upper.notRegistered + lower.notRegistered;
        csv.AddRow({ name,
                     m_Conditions[k].level,
                     method.name,
                     ExperimentTable::Number(sum / landmarks, 6),
                     ExperimentTable::Number(upper.mean, 6),
                     ExperimentTable::Number(lower.mean, 6),
                     std::to_string(upper.cases + lower.cases),
                     std::to_string(upper.above2mm + lower.above2mm),
                     std::to_string(upper.notRegistered + lower.notRegistered),
                     std::to_string(upper.failed + lower.failed) });
        cells.push_back(ExperimentTable::Number(sum / landmarks, 2) +
                        (lost > 0 ? " (" + std::to_string(lost) + ")" : ""));
      }
      markdown.AddRow(cells);
    };
    for (std::size_t k = 1; k < m_Conditions.size(); ++k)
    {
      if (factor != m_Conditions[k].factor)
      {
        flush();
        factor = m_Conditions[k].factor;
        addRow(factor, 0);
      }
      addRow(factor, k);
    }
    flush();
    return { { "sensitivity.csv", csv.ToCSV() }, { "sensitivity.md", text.str() } };
  }

private:
  static std::string
  KeyOf(const std::string & method, std::size_t condition)
  {
    return method + '@' + std::to_string(condition);
  }

  std::vector<Condition> m_Conditions{ MakeConditions() };
};
} // namespace

std::unique_ptr<ExperimentPlan>
MakeSensitivityPlan(const ExperimentCohort & cohort, const std::vector<ExperimentMethod> & methods)
{
  return std::make_unique<SensitivityPlan>(cohort, methods);
}
} // namespace itk
