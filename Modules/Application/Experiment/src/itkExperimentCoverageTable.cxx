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
#include "itkExperimentCoverageTable.h"

#include "itkExperimentTable.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
constexpr const char * JawsOfCoverage[] = { "upper", "lower" };
/** Radius of the 95 % region in sigmas. */
constexpr double Radius95 = 2.448;
/** Where the strata of jaws and tooth groups begin. */
constexpr std::size_t FirstJaw = 1;
constexpr std::size_t FirstGroup = 3;
} // namespace

ExperimentCoverageTable::ExperimentCoverageTable()
{
  const std::pair<const char *, const char *> strata[] = { { "all", "all" },
                                                           { "jaw", "upper" },
                                                           { "jaw", "lower" },
                                                           { "tooth group", "incisors and canines" },
                                                           { "tooth group", "premolars" },
                                                           { "tooth group", "molars" } };
  for (const auto & stratum : strata)
  {
    m_Strata.emplace_back();
    m_Strata.back().by = stratum.first;
    m_Strata.back().name = stratum.second;
  }
}

double
ExperimentCoverageTable::StratumType::GetShareWithin(double radius) const
{
  const auto inside = std::count_if(ratios.begin(), ratios.end(), [radius](double ratio) { return ratio <= radius; });
  return static_cast<double>(inside) / static_cast<double>(ratios.size());
}

void
ExperimentCoverageTable::Add(const ExperimentRecord & record, const std::string & method, const std::string & cohort)
{
  std::size_t cohortStratum = m_Strata.size();
  if (!cohort.empty())
  {
    const auto found = std::find_if(m_Strata.begin(), m_Strata.end(), [&](const StratumType & stratum) {
      return stratum.by == "cohort" && stratum.name == cohort;
    });
    cohortStratum = static_cast<std::size_t>(found - m_Strata.begin());
    if (found == m_Strata.end())
    {
      m_Strata.emplace_back();
      m_Strata.back().by = "cohort";
      m_Strata.back().name = cohort;
    }
  }
  for (std::size_t jaw = 0; jaw < 2; ++jaw)
  {
    const auto * entry = record.Find(method, JawsOfCoverage[jaw]);
    if (entry == nullptr || !entry->registered)
    {
      continue;
    }
    for (const auto & landmark : entry->landmarks)
    {
      if (!landmark.sigma || !(*landmark.sigma > 0.0) || landmark.group == ToothCode::GroupEnum::Unknown)
      {
        continue;
      }
      std::vector<std::size_t> strata = { 0, FirstJaw + jaw, FirstGroup + static_cast<std::size_t>(landmark.group) };
      if (cohortStratum < m_Strata.size())
      {
        strata.push_back(cohortStratum);
      }
      for (const std::size_t stratum : strata)
      {
        m_Strata[stratum].cases.insert(record.id);
        m_Strata[stratum].ratios.push_back(landmark.pixels / *landmark.sigma);
        m_Strata[stratum].sumOfSigmas += *landmark.sigma;
        m_Strata[stratum].sumOfSquares += landmark.pixels * landmark.pixels;
      }
    }
  }
}

std::string
ExperimentCoverageTable::ToMarkdown() const
{
  ExperimentTable table({ "Landmarks", "cases", "number", "coverage", "sigma / rms" });
  for (const StratumType & stratum : m_Strata)
  {
    if (!stratum.ratios.empty())
    {
      const auto   count = static_cast<double>(stratum.ratios.size());
      const double rms = std::sqrt(0.5 * stratum.sumOfSquares / count);
      table.AddRow({ stratum.name,
                     std::to_string(stratum.cases.size()),
                     std::to_string(stratum.ratios.size()),
                     ExperimentTable::Number(100.0 * stratum.GetShareWithin(Radius95), 1) + " %",
                     ExperimentTable::Number(stratum.sumOfSigmas / count / rms, 2) });
    }
  }
  return table.ToMarkdown();
}

std::string
ExperimentCoverageTable::ToCSV() const
{
  ExperimentTable table(
    { "by", "stratum", "cases", "landmarks", "coverage_95", "mean_sigma_px", "rms_axis_px", "sigma_over_rms" });
  for (const StratumType & stratum : m_Strata)
  {
    if (!stratum.ratios.empty())
    {
      const auto   count = static_cast<double>(stratum.ratios.size());
      const double sigma = stratum.sumOfSigmas / count;
      const double rms = std::sqrt(0.5 * stratum.sumOfSquares / count);
      table.AddRow({ stratum.by,
                     stratum.name,
                     std::to_string(stratum.cases.size()),
                     std::to_string(stratum.ratios.size()),
                     ExperimentTable::Number(stratum.GetShareWithin(Radius95), 6),
                     ExperimentTable::Number(sigma, 6),
                     ExperimentTable::Number(rms, 6),
                     ExperimentTable::Number(sigma / rms, 6) });
    }
  }
  return table.ToCSV();
}

std::string
ExperimentCoverageTable::ToCalibrationCSV() const
{
  ExperimentTable table({ "by", "stratum", "nominal", "observed" });
  for (const StratumType & stratum : m_Strata)
  {
    for (int percent = 5; percent < 100 && !stratum.ratios.empty(); percent += 5)
    {
      const double nominal = 0.01 * percent;
      table.AddRow({ stratum.by,
                     stratum.name,
                     ExperimentTable::Number(nominal, 2),
                     ExperimentTable::Number(stratum.GetShareWithin(std::sqrt(-2.0 * std::log(1.0 - nominal))), 6) });
    }
  }
  return table.ToCSV();
}

const char *
ExperimentCoverageTable::GetExplanation()
{
  return "Share of the marked landmarks within 2.448 sigma of the predicted one, and mean sigma over the actual root "
         "mean square error an axis (1 is right, below 1 is too sure).";
}
} // namespace itk
