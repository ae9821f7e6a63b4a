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

#include "itkExperimentTable.h"

#include <algorithm>

namespace itk
{
namespace
{
constexpr const char * VerdictNames[] = { "ok", "suspect", "failed" };
/** mm, the classes' upper ends. */
constexpr double GoodWithin = 0.5;
constexpr double UsableWithin = 2.0;

ExperimentTable
Fill(std::vector<std::string>                                                          header,
     const std::vector<std::pair<std::string, ExperimentConfusionTable::CountsType>> & parts)
{
  const bool one = parts.size() == 1 && parts.front().first.empty();
  if (!one)
  {
    header.insert(header.begin(), "input");
  }
  ExperimentTable table(header);
  for (const auto & part : parts)
  {
    for (unsigned int verdict = 0; verdict < ExperimentConfusionTable::NumberOfVerdicts; ++verdict)
    {
      std::vector<std::string> cells = { VerdictNames[verdict] };
      if (!one)
      {
        cells.insert(cells.begin(), part.first);
      }
      for (const std::size_t count : part.second[verdict])
      {
        cells.push_back(std::to_string(count));
      }
      table.AddRow(cells);
    }
  }
  return table;
}
} // namespace

void
ExperimentConfusionTable::Add(const std::string & input, const ExperimentRecord & record, const std::string & method)
{
  auto part = std::find_if(m_Parts.begin(), m_Parts.end(), [&](const auto & each) { return each.first == input; });
  if (part == m_Parts.end())
  {
    part = m_Parts.insert(m_Parts.end(), { input, CountsType{} });
  }
  for (const char * jaw : { "upper", "lower" })
  {
    const auto * entry = record.Find(method, jaw);
    if (entry == nullptr)
    {
      continue;
    }
    const auto         mean = entry->GetMean(true);
    const unsigned int actual = !mean                   ? NotKnown
                                : *mean <= GoodWithin   ? Good
                                : *mean <= UsableWithin ? Usable
                                                        : Unusable;
    for (unsigned int verdict = 0; verdict < NumberOfVerdicts; ++verdict)
    {
      part->second[verdict][actual] += entry->status == VerdictNames[verdict] ? 1 : 0;
    }
  }
}

auto
ExperimentConfusionTable::GetCounts(const std::string & input) const -> CountsType
{
  const auto part =
    std::find_if(m_Parts.begin(), m_Parts.end(), [&](const auto & each) { return each.first == input; });
  return part == m_Parts.end() ? CountsType{} : part->second;
}

std::string
ExperimentConfusionTable::ToMarkdown() const
{
  return Fill({ "verdict", "up to 0.5 mm", "0.5 to 2 mm", "above 2 mm", "no error known" }, m_Parts).ToMarkdown();
}

std::string
ExperimentConfusionTable::ToCSV() const
{
  return Fill({ "verdict", "up_to_0_5mm", "up_to_2mm", "above_2mm", "no_error_known" }, m_Parts).ToCSV();
}

const char *
ExperimentConfusionTable::GetExplanation()
{
  return "Jaws by verdict and by their actual mean error. An \"ok\" above 2 mm is the worst outcome.";
}
} // namespace itk
