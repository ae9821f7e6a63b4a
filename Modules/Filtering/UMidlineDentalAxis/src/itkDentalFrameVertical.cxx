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
#include "itkDentalFrameVertical.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace itk
{
namespace DentalFrameKernel
{
namespace
{
/** A direction across the unit vector that turns with the data. */
Vector3
FarthestAcross(const Samples & samples, const Vector3 & axis)
{
  Vector3 best{ 0.0, 0.0, 0.0 };
  double  farthest = -1.0;
  for (const Vector3 & p : samples.points)
  {
    const Vector3 d = p - samples.centroid;
    const Vector3 across = d - Dot(d, axis) * axis;
    if (Dot(across, across) > farthest)
    {
      farthest = Dot(across, across);
      best = across;
    }
  }
  return Unit(best);
}

/** mm below the plate from which on a sector has no crowns: more than the curve of Spee and a short tooth together. */
constexpr double BelowPlate = 4.0;

/** The plane on which most sectors' tops lie, few above it: what a plate laid on the teeth does. All well spread
 * triples of sectors are tried. Heights of the tops over the plane of the sectors, along the occlusal direction. */
std::vector<double>
HeightsOverPlate(const std::vector<Vector3> & tops, const Vector3 & occlusal, const Vector3 & centre)
{
  constexpr double    limit = 3.0; // mm: farther tops count alike
  const std::size_t   size = tops.size();
  std::vector<double> best(size, 0.0);
  double              bestCost = std::numeric_limits<double>::infinity();
  std::vector<double> heights(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    for (std::size_t j = i + 1; j < size; ++j)
    {
      for (std::size_t k = j + 1; k < size; ++k)
      {
        const Vector3 normal = Cross(tops[j] - tops[i], tops[k] - tops[i]);
        const double  along = Dot(normal, occlusal);
        // Triples of less than 300 mm^2, and planes steeper than 35 degrees, say nothing about the occlusal plane.
        if (std::abs(along) < 0.82 * Norm(normal) || Norm(normal) < 600.0)
        {
          continue;
        }
        double cost = 0.0;
        for (std::size_t n = 0; n < size && cost < bestCost; ++n)
        {
          heights[n] = Dot(tops[n] - tops[i], normal) / along;
          // A sector that would be left out costs as much as one that reaches through the plate: else a plate that
          // leans on the incisors and one side is preferred where lower incisors stand high, as in a deep bite.
          cost += heights[n] > 0.0           ? 1.5 * std::min(heights[n], limit)
                  : heights[n] < -BelowPlate ? 1.5 * limit
                                             : std::min(-heights[n], limit);
        }
        if (cost < bestCost)
        {
          bestCost = cost;
          best = heights;
        }
      }
    }
  }
  if (!std::isfinite(bestCost))
  {
    for (std::size_t n = 0; n < size; ++n)
    {
      best[n] = Dot(tops[n] - centre, occlusal);
    }
    const double middle = Quantile(best, 0.5);
    for (double & height : best)
    {
      height -= middle;
    }
  }
  return best;
}
} // namespace

std::vector<std::uint32_t>
CrownBand(const Samples & samples, const Vector3 & occlusal, const Vector3 & centre, double band)
{
  constexpr int                            sectors = 36;
  const Vector3                            e1 = FarthestAcross(samples, occlusal);
  const Vector3                            e2 = Cross(occlusal, e1);
  std::vector<double>                      heights(samples.points.size());
  std::vector<int>                         sector(samples.points.size());
  std::array<std::vector<double>, sectors> bySector;
  for (std::size_t i = 0; i < samples.points.size(); ++i)
  {
    const Vector3 d = samples.points[i] - centre;
    heights[i] = Dot(d, occlusal);
    const double turn = std::atan2(Dot(d, e2), Dot(d, e1)) / (2.0 * Pi) + 0.5;
    sector[i] = std::min(sectors - 1, static_cast<int>(turn * sectors));
    bySector[sector[i]].push_back(heights[i]);
  }
  std::array<double, sectors>  envelope{};
  std::array<Vector3, sectors> top{};
  std::array<int, sectors>     topCount{};
  for (int s = 0; s < sectors; ++s)
  {
    envelope[s] = bySector[s].size() < 5 ? -std::numeric_limits<double>::infinity() : Quantile(bySector[s], 0.98);
  }
  for (std::size_t i = 0; i < samples.points.size(); ++i)
  {
    if (heights[i] >= envelope[sector[i]] && std::isfinite(envelope[sector[i]]))
    {
      top[sector[i]] = top[sector[i]] + samples.points[i];
      ++topCount[sector[i]];
    }
  }
  std::vector<Vector3> tops;
  std::vector<int>     owner;
  for (int s = 0; s < sectors; ++s)
  {
    if (topCount[s] > 0)
    {
      tops.push_back((1.0 / topCount[s]) * top[s]);
      owner.push_back(s);
    }
  }
  const std::vector<double>   overPlate = HeightsOverPlate(tops, occlusal, centre);
  std::array<double, sectors> threshold;
  threshold.fill(std::numeric_limits<double>::infinity());
  for (std::size_t n = 0; n < tops.size(); ++n)
  {
    if (overPlate[n] > -BelowPlate)
    {
      threshold[owner[n]] = envelope[owner[n]] - band;
    }
  }
  std::vector<std::uint32_t> crowns;
  for (std::size_t i = 0; i < samples.points.size(); ++i)
  {
    if (heights[i] > threshold[sector[i]])
    {
      crowns.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return crowns;
}

namespace
{
/** Weighted PCA, repeated with Tukey's weights of the distance to the plane: sectors without teeth drop out. */
void
RobustPlane(const Samples &                    samples,
            const std::vector<std::uint32_t> & crowns,
            const Vector3 &                    start,
            Vertical &                         vertical)
{
  std::vector<double> weights(crowns.size(), 1.0);
  std::vector<double> residuals(crowns.size());
  Vector3             direction = start;
  for (unsigned int round = 0; round < 12; ++round)
  {
    Vector3 mean{ 0.0, 0.0, 0.0 };
    double  sum = 0.0;
    for (std::size_t i = 0; i < crowns.size(); ++i)
    {
      mean = mean + weights[i] * samples.points[crowns[i]];
      sum += weights[i];
    }
    if (sum <= 0.0)
    {
      break;
    }
    mean = (1.0 / sum) * mean;
    Matrix3 covariance{};
    for (std::size_t i = 0; i < crowns.size(); ++i)
    {
      const Vector3 d = samples.points[crowns[i]] - mean;
      for (unsigned int r = 0; r < 3; ++r)
      {
        for (unsigned int c = 0; c < 3; ++c)
        {
          covariance[r][c] += weights[i] * d[r] * d[c] / sum;
        }
      }
    }
    Vector3 values;
    Matrix3 vectors;
    SymmetricEigen(covariance, values, vectors);
    const Vector3 before = direction;
    direction = Dot(vectors[0], start) < 0.0 ? -1.0 * vectors[0] : vectors[0];
    vertical.direction = direction;
    vertical.centre = mean;
    vertical.thickness = std::sqrt(std::max(0.0, values[0]));
    for (std::size_t i = 0; i < crowns.size(); ++i)
    {
      residuals[i] = std::abs(Dot(samples.points[crowns[i]] - mean, direction));
    }
    const double scale = std::clamp(1.4826 * Quantile(residuals, 0.5), 0.8, 3.0);
    std::size_t  inliers = 0;
    for (std::size_t i = 0; i < crowns.size(); ++i)
    {
      const double ratio = residuals[i] / (4.685 * scale);
      weights[i] = ratio < 1.0 ? (1.0 - ratio * ratio) * (1.0 - ratio * ratio) : 0.0;
      inliers += ratio < 0.7 ? 1 : 0;
    }
    vertical.inlierShare = static_cast<double>(inliers) / static_cast<double>(std::max<std::size_t>(1, crowns.size()));
    if (round > 2 && Norm(Cross(before, direction)) < 1e-9)
    {
      break;
    }
  }
  vertical.crowns.clear();
  for (std::size_t i = 0; i < crowns.size(); ++i)
  {
    if (weights[i] > 0.25)
    {
      vertical.crowns.push_back(crowns[i]);
    }
  }
}

/** The paper's Z: crown candidates -> PCA, repeated until the occlusal direction stays. */
Vertical
RefineVertical(const Samples & samples, const Vector3 & seed, const DentalFrameOptions & options)
{
  Vertical vertical;
  vertical.direction = seed;
  const double wanted = options.crownFraction * static_cast<double>(samples.points.size());
  for (unsigned int iteration = 0; iteration < std::max(1u, options.maximumIterations); ++iteration)
  {
    const Vector3              occlusal = vertical.direction;
    std::vector<std::uint32_t> crowns = CrownBand(samples, occlusal, samples.centroid, options.crownBandHeight);
    if (crowns.size() < 20)
    {
      break;
    }
    const auto count =
      static_cast<std::ptrdiff_t>(std::clamp(wanted, 20.0, std::max(20.0, 0.7 * static_cast<double>(crowns.size()))));
    if (count < static_cast<std::ptrdiff_t>(crowns.size()))
    {
      std::nth_element(crowns.begin(), crowns.begin() + count, crowns.end(), [&](std::uint32_t a, std::uint32_t b) {
        const double da = Dot(samples.normals[a], occlusal);
        const double db = Dot(samples.normals[b], occlusal);
        return da > db || (da == db && a < b);
      });
      crowns.resize(static_cast<std::size_t>(count));
      std::sort(crowns.begin(), crowns.end());
    }
    RobustPlane(samples, crowns, occlusal, vertical);
    if (Norm(Cross(vertical.direction, occlusal)) < 1e-4)
    {
      break;
    }
  }
  return vertical;
}

/** How much a direction looks like the occlusal one: crowns are rough, and an open shell's normals point that way. */
double
OcclusalScore(const Samples & samples, const Vertical & vertical, const Vector3 & contact, double contactWeight)
{
  double roughness = 0.0;
  for (const std::uint32_t i : vertical.crowns)
  {
    roughness += samples.roughness[i];
  }
  roughness /= static_cast<double>(std::max<std::size_t>(1, vertical.crowns.size()));
  return roughness / std::max(1e-9, samples.meanRoughness) + 10.0 * Dot(samples.netNormal, vertical.direction) +
         contactWeight * Dot(contact, vertical.direction);
}
} // namespace

Vertical
ChooseVertical(const Samples &            samples,
               const Vector3 &            contact,
               double                     contactWeight,
               const DentalFrameOptions & options,
               double &                   margin)
{
  std::vector<Vector3> seeds;
  Vector3              rough{ 0.0, 0.0, 0.0 };
  double               sum = 0.0;
  Matrix3              covariance{};
  for (std::size_t i = 0; i < samples.points.size(); ++i)
  {
    const Vector3 d = samples.points[i] - samples.centroid;
    rough = rough + samples.roughness[i] * d;
    sum += samples.roughness[i];
    for (unsigned int r = 0; r < 3; ++r)
    {
      for (unsigned int c = 0; c < 3; ++c)
      {
        covariance[r][c] += d[r] * d[c];
      }
    }
  }
  Vector3 values;
  Matrix3 vectors;
  SymmetricEigen(covariance, values, vectors);
  if (Norm(samples.netNormal) > 0.2)
  {
    // An open shell: nothing else can have a better score.
    seeds.push_back(Unit(samples.netNormal));
    seeds.push_back(Dot(vectors[0], samples.netNormal) < 0.0 ? -1.0 * vectors[0] : vectors[0]);
  }
  else
  {
    seeds.push_back(vectors[0]);
    seeds.push_back(-1.0 * vectors[0]);
    for (unsigned int e = 1; e < 3; ++e)
    {
      seeds.push_back(vectors[e]);
      seeds.push_back(-1.0 * vectors[e]);
    }
    seeds.push_back(Unit(rough));
  }
  if (contactWeight > 0.0)
  {
    seeds.push_back(contact);
  }
  std::vector<Vertical> found;
  std::size_t           best = 0;
  for (const Vector3 & seed : seeds)
  {
    if (Norm(seed) < 0.5)
    {
      continue;
    }
    Vertical vertical = RefineVertical(samples, seed, options);
    vertical.score = OcclusalScore(samples, vertical, contact, contactWeight);
    found.push_back(std::move(vertical));
    if (found.back().score > found[best].score)
    {
      best = found.size() - 1;
    }
  }
  if (found.empty())
  {
    margin = 0.0;
    return Vertical();
  }
  margin = 4.0;
  for (const Vertical & other : found)
  {
    if (Dot(other.direction, found[best].direction) < 0.5)
    {
      margin = std::min(margin, found[best].score - other.score);
    }
  }
  return found[best];
}
} // namespace DentalFrameKernel
} // namespace itk
