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

#include <iomanip>
#include <sstream>

namespace itk
{
namespace
{
const char *
NameOf(DentalPhantomCaseSource::CohortEnum level)
{
  return level == DentalPhantomCaseSource::CohortEnum::Ideal     ? "ideal"
         : level == DentalPhantomCaseSource::CohortEnum::Typical ? "typical"
                                                                 : "hard";
}
} // namespace

std::string
ExperimentCohort::GetId(std::size_t i) const
{
  if (!this->IsSimulated())
  {
    return files[i].second;
  }
  std::ostringstream id;
  id << NameOf(level) << '-' << std::setw(4) << std::setfill('0') << seed + i;
  return id.str();
}

ExperimentCase
ExperimentCohort::Make(std::size_t i, bool withRadiograph, const ExperimentVariation & variation) const
{
  return this->IsSimulated() ? MakePhantomExperimentCase(seed + i, level, withRadiograph, variation)
                             : LoadExperimentCase(files[i].first, files[i].second);
}

std::string
ExperimentCohort::Describe() const
{
  std::ostringstream text;
  if (this->IsSimulated())
  {
    text << count << " simulated cases, level " << NameOf(level) << ", seeds " << seed << " to " << seed + count - 1;
  }
  else
  {
    text << files.size() << " annotated cases from files";
  }
  return text.str();
}

ExperimentPlan::~ExperimentPlan() = default;

std::vector<std::string>
ExperimentPlan::DrawFigures(const std::string &, const AbortType &) const
{
  return {};
}
} // namespace itk
