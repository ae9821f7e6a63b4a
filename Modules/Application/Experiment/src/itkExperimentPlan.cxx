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
#include "itkExperimentPlan.h"

#include "itkExperimentCaseFiles.h"

#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace itk
{
const char *
NameOf(DentalPhantomCaseSource::CohortEnum level)
{
  return DentalPhantomAcquisition::GetName(level).c_str();
}

std::string
ExperimentCohort::GetId(std::size_t i) const
{
  if (!this->IsSimulated())
  {
    return files[i].second;
  }
  std::ostringstream id;
  id << (name.empty() ? level.name : name) << '-' << std::setw(4) << std::setfill('0') << seed + i;
  return id.str();
}

std::string
ExperimentCohort::GetInputKey(std::size_t i) const
{
  return this->IsSimulated() ? std::string() : DigestExperimentCase(files[i].first);
}

ExperimentCase
ExperimentCohort::Make(std::size_t                   i,
                       bool                          withRadiograph,
                       const std::function<bool()> & isAborted,
                       const ExperimentVariation &   variation) const
{
  return this->IsSimulated() ? MakePhantomExperimentCase(seed + i, level, withRadiograph, variation, isAborted)
                             : LoadExperimentCase(files[i].first, files[i].second, isAborted);
}

std::string
ExperimentCohort::Describe() const
{
  std::ostringstream text;
  if (this->IsSimulated())
  {
    text << count << " simulated cases, " << (name.empty() ? "level " + level.name + ", " : "")
         << (level != DentalPhantomLevel::Named(level.name) ? "parameters of its own (experiment.json), " : "")
         << "seeds " << seed << " to " << seed + count - 1;
  }
  else
  {
    text << files.size() << " annotated cases from files";
  }
  return text.str();
}

ExperimentPlan::~ExperimentPlan() = default;

std::string
ExperimentPlan::Try(const std::function<void()> & work)
{
  try
  {
    work();
  }
  catch (const ProcessAborted &)
  {
    throw;
  }
  catch (const DentalInputError & error)
  {
    return error.GetOneLine();
  }
  catch (const ExceptionObject & error)
  {
    return DescribePlainly(error);
  }
  catch (const std::invalid_argument & error)
  {
    return error.what();
  }
  return {};
}

std::string
ExperimentPlan::DescribeFailures(const std::vector<ExperimentRecord> & records)
{
  std::string text;
  for (const ExperimentRecord & record : records)
  {
    if (!record.failure.empty())
    {
      text += "* " + record.id + ": " + record.failure + '\n';
    }
  }
  return text.empty() ? text : "\nCases that could not be used and are in no figure:\n\n" + text;
}

bool
ExperimentPlan::NeedsRadiograph(const std::vector<ExperimentMethod> & methods)
{
  return std::any_of(methods.begin(), methods.end(), [](const ExperimentMethod & method) {
    return method.kind == ExperimentMethod::KindEnum::Intensity;
  });
}

std::vector<std::string>
ExperimentPlan::DrawFigures(const std::string &, const AbortType &) const
{
  return {};
}
} // namespace itk
