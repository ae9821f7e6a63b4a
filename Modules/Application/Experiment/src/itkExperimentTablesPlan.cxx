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
#include "itkExperimentFigure.h"
#include "itkExperimentRecordPlan.h"
#include "itkExperimentTable.h"
#include "itkExperimentTables.h"

#include "itkDentalInputError.h"

#include <algorithm>
#include <filesystem>

namespace itk
{
namespace
{
class TablesPlan : public ExperimentRecordPlan
{
public:
  using ExperimentRecordPlan::ExperimentRecordPlan;

  void
  FillRecord(std::size_t i, ExperimentRecord & record, const ExperimentMonitor & monitor) const override
  {
    std::size_t          done = 0;
    const ExperimentCase experimentCase =
      this->GetCohort().Make(i, NeedsRadiograph(this->GetMethods()), monitor.GetAbort());
    for (const auto & landmark : experimentCase.marked->GetLandmarks())
    {
      ++record.marked[ToString(landmark.tooth.GetJaw())];
    }
    ExperimentRunner runner(experimentCase);
    runner.SetAbort(monitor.GetAbort());
    for (const ExperimentMethod & method : this->GetMethods())
    {
      monitor.Advance(static_cast<double>(done++) / static_cast<double>(this->GetMethods().size()));
      record.Add(method.name, runner.Run(method));
    }
  }

  std::map<std::string, std::string>
  MakeFiles() const override
  {
    if (std::all_of(this->GetRecords().begin(), this->GetRecords().end(), [](const auto & record) {
          return !record.failure.empty();
        }))
    {
      itkDentalInputErrorMacro(this->GetRecords().front().id,
                               "",
                               "and every other case is unusable: " + this->GetRecords().front().failure,
                               "see the first");
    }
    ExperimentDescription description;
    description.cohort = this->GetCohort().Describe();
    description.seed = this->GetCohort().seed;
    auto            files = MakeExperimentTables(this->GetRecords(), this->GetMethods(), description);
    ExperimentTable times({ "method", "jaws", "mean_seconds", "longest_seconds" });
    for (const ExperimentMethod & method : this->GetMethods())
    {
      double      sum = 0.0;
      double      longest = 0.0;
      std::size_t count = 0;
      for (const ExperimentRecord & record : this->GetRecords())
      {
        const auto found = record.methods.find(method.name);
        if (found != record.methods.end())
        {
          for (const auto & jaw : found->second)
          {
            sum += jaw.second.seconds;
            longest = std::max(longest, jaw.second.seconds);
            ++count;
          }
        }
      }
      times.AddRow({ method.name,
                     std::to_string(count),
                     ExperimentTable::Number(count > 0 ? sum / static_cast<double>(count) : 0.0, 4),
                     ExperimentTable::Number(longest, 4) });
    }
    files["times.csv"] = times.ToCSV();
    return files;
  }

  std::vector<std::string>
  DrawFigures(const std::string & folder, const AbortType & abort) const override
  {
    const auto has = [this](const std::string & name) {
      return std::any_of(this->GetMethods().begin(), this->GetMethods().end(), [&](const ExperimentMethod & method) {
        return method.name == name;
      });
    };
    const std::string        ours = has("robust") ? "robust" : "paper";
    std::vector<std::string> columns;
    for (const std::string & name : { ours, std::string("bounding-box"), std::string("single-stage") })
    {
      if (has(name))
      {
        columns.push_back(name);
      }
    }
    if (columns.size() < 2)
    {
      return {};
    }
    // Median and worst by the first column.
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < this->GetRecords().size(); ++i)
    {
      const auto found = this->GetRecords()[i].methods.find(columns.front());
      double     sum = 0.0;
      unsigned   count = 0;
      if (found != this->GetRecords()[i].methods.end())
      {
        for (const auto & jaw : found->second)
        {
          if (const auto mean = jaw.second.GetMean(true))
          {
            sum += *mean;
            ++count;
          }
        }
      }
      if (count > 0)
      {
        order.emplace_back(sum / count, i);
      }
    }
    if (order.empty())
    {
      return {};
    }
    std::sort(order.begin(), order.end());
    std::vector<std::pair<std::string, std::size_t>> chosen = { { "median", order[(order.size() - 1) / 2].second } };
    if (order.size() > 1)
    {
      chosen.emplace_back("worst", order.back().second);
    }
    std::vector<std::string> written;
    for (const auto & choice : chosen)
    {
      if (abort())
      {
        throw ProcessAborted(__FILE__, __LINE__);
      }
      const ExperimentCase experimentCase = this->GetCohort().Make(choice.second, true, abort);
      ExperimentRunner     runner(experimentCase);
      for (const ToothCode::JawEnum jaw : { ToothCode::JawEnum::Upper, ToothCode::JawEnum::Lower })
      {
        if (!runner.HasJaw(jaw))
        {
          continue;
        }
        const std::string name =
          "figure_" + choice.first + (jaw == ToothCode::JawEnum::Upper ? "_upper.png" : "_lower.png");
        WriteExperimentFigure(experimentCase, runner, columns, jaw, (std::filesystem::path(folder) / name).string());
        written.push_back(name);
      }
    }
    return written;
  }
};
} // namespace

std::unique_ptr<ExperimentPlan>
MakeTablesPlan(const ExperimentCohort & cohort, const std::vector<ExperimentMethod> & methods)
{
  return std::make_unique<TablesPlan>(cohort, methods);
}
} // namespace itk
