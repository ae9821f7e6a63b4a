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
#include "itkExperimentFigures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
constexpr double SuccessLimits[] = { 2.0, 2.5, 3.0, 4.0 };
constexpr double NotUsableFigure = 2.0;
constexpr double NoFigure = std::numeric_limits<double>::quiet_NaN();
} // namespace

ExperimentFigures
PoolExperiment(const std::vector<ExperimentRecord> & records, const std::string & method, const std::string & jaw)
{
  ExperimentFigures figures;
  double            sum = 0.0;
  double            squares = 0.0;
  double            groupSums[3] = { 0.0, 0.0, 0.0 };
  std::size_t       groupCounts[3] = { 0, 0, 0 };
  std::size_t       missed = 0;
  std::size_t       successes[4] = { 0, 0, 0, 0 };
  std::size_t       registered = 0;
  for (const ExperimentRecord & record : records)
  {
    const ExperimentRecord::JawType * entry = record.Find(method, jaw);
    if (entry == nullptr)
    {
      continue;
    }
    ++figures.cases;
    figures.failed += entry->status == "failed" ? 1 : 0;
    if (!entry->registered)
    {
      ++figures.notRegistered;
      const auto marked = record.marked.find(jaw);
      missed += marked == record.marked.end() ? 0 : marked->second;
      continue;
    }
    ++registered;
    figures.contour.chamfer += entry->whole.chamfer;
    figures.contour.hausdorff += entry->whole.hausdorff;
    figures.contour.movingToFixed += entry->whole.movingToFixed;
    figures.contour.fixedToMoving += entry->whole.fixedToMoving;
    if (const auto mean = entry->GetMean(true))
    {
      figures.above2mm += *mean > NotUsableFigure ? 1 : 0;
      figures.worstCase = std::max(figures.worstCase, *entry->GetMean(false));
    }
    for (const auto & landmark : entry->landmarks)
    {
      ++figures.landmarks;
      sum += landmark.pixels;
      squares += landmark.pixels * landmark.pixels;
      if (landmark.group != ToothCode::GroupEnum::Unknown)
      {
        groupSums[static_cast<unsigned int>(landmark.group)] += landmark.pixels;
        ++groupCounts[static_cast<unsigned int>(landmark.group)];
      }
      for (unsigned int i = 0; i < 4; ++i)
      {
        successes[i] += landmark.millimetres <= SuccessLimits[i] ? 1 : 0;
      }
    }
  }
  const auto ratio = [](double numerator, std::size_t denominator) {
    return denominator > 0 ? numerator / static_cast<double>(denominator) : NoFigure;
  };
  figures.mean = ratio(sum, figures.landmarks);
  figures.rmse = std::sqrt(ratio(squares, figures.landmarks));
  // The population's: RMSE^2 = mean^2 + std^2.
  figures.standardDeviation = figures.landmarks > 0
                                ? std::sqrt(std::max(0.0, figures.rmse * figures.rmse - figures.mean * figures.mean))
                                : NoFigure;
  if (figures.landmarks == 0)
  {
    figures.worstCase = NoFigure;
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    figures.groups[i] = ratio(groupSums[i], groupCounts[i]);
  }
  for (unsigned int i = 0; i < 4; ++i)
  {
    figures.successRates[i] = ratio(static_cast<double>(successes[i]), figures.landmarks + missed);
  }
  figures.contour.chamfer = ratio(figures.contour.chamfer, registered);
  figures.contour.hausdorff = ratio(figures.contour.hausdorff, registered);
  figures.contour.movingToFixed = ratio(figures.contour.movingToFixed, registered);
  figures.contour.fixedToMoving = ratio(figures.contour.fixedToMoving, registered);
  return figures;
}
} // namespace itk
