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
#include "itkExperimentStatistics.h"

#include "itkReproducibleRandom.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace itk
{
namespace
{
/** Linear between the order statistics (Hyndman, Fan type 7). */
double
Quantile(const std::vector<double> & sorted, double p)
{
  const double      place = p * static_cast<double>(sorted.size() - 1);
  const auto        low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (place - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}
} // namespace

std::pair<double, double>
BootstrapMeanInterval(const std::vector<std::vector<double>> & cases,
                      double                                   confidence,
                      unsigned int                             resamples,
                      std::uint64_t                            seed)
{
  std::vector<std::pair<double, double>> sums;
  for (const auto & errors : cases)
  {
    if (!errors.empty())
    {
      sums.emplace_back(std::accumulate(errors.begin(), errors.end(), 0.0), static_cast<double>(errors.size()));
    }
  }
  if (sums.empty())
  {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return { none, none };
  }
  ReproducibleRandom  random(seed, 71);
  std::vector<double> means;
  for (unsigned int i = 0; i < resamples; ++i)
  {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t k = 0; k < sums.size(); ++k)
    {
      const auto & drawn = sums[random.Integer(static_cast<std::uint32_t>(sums.size()))];
      sum += drawn.first;
      count += drawn.second;
    }
    means.push_back(sum / count);
  }
  std::sort(means.begin(), means.end());
  return { Quantile(means, 0.5 * (1.0 - confidence)), Quantile(means, 0.5 * (1.0 + confidence)) };
}

double
SignFlipTest(const std::vector<double> & differences, unsigned int flips, std::uint64_t seed)
{
  const std::size_t n = differences.size();
  if (n == 0)
  {
    return 1.0;
  }
  const double observed = std::abs(std::accumulate(differences.begin(), differences.end(), 0.0));
  double       magnitude = 0.0;
  for (const double difference : differences)
  {
    magnitude += std::abs(difference);
  }
  // What rounding makes of equal sums.
  const double tolerance = 1e-12 * magnitude;
  if (n <= 14)
  {
    const std::uint32_t combinations = 1u << n;
    std::uint32_t       asExtreme = 0;
    for (std::uint32_t signs = 0; signs < combinations; ++signs)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < n; ++i)
      {
        sum += (signs >> i & 1u) != 0 ? -differences[i] : differences[i];
      }
      asExtreme += std::abs(sum) >= observed - tolerance ? 1 : 0;
    }
    return static_cast<double>(asExtreme) / combinations;
  }
  ReproducibleRandom random(seed, 72);
  unsigned int       asExtreme = 1;
  for (unsigned int flip = 0; flip < flips; ++flip)
  {
    double        sum = 0.0;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      if (i % 64 == 0)
      {
        bits = random.NextBits();
      }
      sum += (bits >> (i % 64) & 1u) != 0 ? -differences[i] : differences[i];
    }
    asExtreme += std::abs(sum) >= observed - tolerance ? 1 : 0;
  }
  return static_cast<double>(asExtreme) / (flips + 1.0);
}

std::vector<double>
AdjustByHolm(const std::vector<double> & pValues)
{
  std::vector<std::size_t> order(pValues.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return pValues[a] < pValues[b]; });
  std::vector<double> adjusted(pValues.size());
  double              last = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank)
  {
    last = std::max(last, std::min(1.0, static_cast<double>(order.size() - rank) * pValues[order[rank]]));
    adjusted[order[rank]] = last;
  }
  return adjusted;
}
} // namespace itk
