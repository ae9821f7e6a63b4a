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
#include "itkMidsagittalPlaneEstimator.h"

#include "itkDentalFrameMath.h"
#include "itkFlatKdTree.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace itk
{
namespace
{
using namespace DentalFrameMath;

using Point6 = std::array<double, 6>;

struct Plane
{
  Vector3 normal;
  double  offset{ 0.0 };
  double  residual{ std::numeric_limits<double>::infinity() };
};

/** Every stride-th sample of each jaw with its tree, and the last matches as guesses for the next query. */
struct Level
{
  struct Jaw
  {
    std::vector<Point6>                points;
    FlatKdTree<6>                      tree;
    mutable std::vector<std::uint32_t> guess;
  };
  std::vector<Jaw> jaws;
  std::size_t      count{ 0 };
};

Level
MakeLevel(const std::vector<OrientedPointSet> & jaws, double normalWeight, unsigned int samples)
{
  std::size_t total = 0;
  for (const OrientedPointSet & jaw : jaws)
  {
    total += jaw.points.size();
  }
  Level level;
  for (const OrientedPointSet & jaw : jaws)
  {
    Level::Jaw        own;
    const std::size_t size = jaw.points.size();
    const std::size_t keep = total <= samples ? size : (size * samples + total - 1) / total;
    own.points.reserve(keep);
    for (std::size_t k = 0; k < keep; ++k)
    {
      const std::size_t i = k * size / keep;
      const Vector3 &   p = jaw.points[i];
      const Vector3 &   n = jaw.normals[i];
      own.points.push_back({ p[0], p[1], p[2], normalWeight * n[0], normalWeight * n[1], normalWeight * n[2] });
    }
    own.tree = FlatKdTree<6>(own.points);
    own.guess.assign(own.points.size(), FlatKdTree<6>::None);
    level.count += own.points.size();
    level.jaws.push_back(std::move(own));
  }
  return level;
}

struct Pair
{
  double        squared;
  std::uint32_t jaw;
  std::uint32_t point;
  std::uint32_t match;
};

/** Nearest neighbours of all mirrored samples. */
void
Match(const Level & level, const Plane & plane, std::vector<Pair> & pairs)
{
  pairs.clear();
  pairs.reserve(level.count);
  const Vector3 & y = plane.normal;
  for (std::uint32_t j = 0; j < level.jaws.size(); ++j)
  {
    const Level::Jaw & jaw = level.jaws[j];
    for (std::uint32_t i = 0; i < jaw.points.size(); ++i)
    {
      const Point6 & s = jaw.points[i];
      const double   a = 2.0 * (s[0] * y[0] + s[1] * y[1] + s[2] * y[2] - plane.offset);
      const double   b = 2.0 * (s[3] * y[0] + s[4] * y[1] + s[5] * y[2]);
      const Point6   m{ s[0] - a * y[0], s[1] - a * y[1], s[2] - a * y[2],
                      s[3] - b * y[0], s[4] - b * y[1], s[5] - b * y[2] };
      Pair           pair{ std::numeric_limits<double>::infinity(), j, i, 0 };
      pair.match = jaw.tree.Nearest(m, pair.squared, jaw.guess[i]);
      jaw.guess[i] = pair.match;
      pairs.push_back(pair);
    }
  }
}

double
TruncatedMean(const std::vector<Pair> & pairs, double truncation)
{
  double sum = 0.0;
  for (const Pair & pair : pairs)
  {
    sum += std::min(std::sqrt(pair.squared), truncation);
  }
  return pairs.empty() ? truncation : sum / static_cast<double>(pairs.size());
}

/** One closed-form update on the closest pairs; the residual is that of the plane it started from. Returns the angle by
 * which the normal turned, degrees, plus the shift of the plane at its centre, mm. */
double
Update(const Level & level, Plane & plane, const MidsagittalPlaneOptions & options, std::vector<Pair> & pairs)
{
  Match(level, plane, pairs);
  plane.residual = TruncatedMean(pairs, options.truncationDistance);
  std::vector<double> squared;
  squared.reserve(pairs.size());
  for (const Pair & pair : pairs)
  {
    squared.push_back(pair.squared);
  }
  const auto kept = std::min(squared.size() - 1,
                             static_cast<std::size_t>(options.trimmedFraction * static_cast<double>(squared.size())));
  std::nth_element(squared.begin(), squared.begin() + static_cast<std::ptrdiff_t>(kept), squared.end());
  const double limit = squared[kept];

  Vector3     meanP{ 0.0, 0.0, 0.0 };
  Vector3     meanQ{ 0.0, 0.0, 0.0 };
  std::size_t count = 0;
  for (const Pair & pair : pairs)
  {
    if (pair.squared <= limit)
    {
      const Point6 & p = level.jaws[pair.jaw].points[pair.point];
      const Point6 & q = level.jaws[pair.jaw].points[pair.match];
      meanP = meanP + Vector3{ p[0], p[1], p[2] };
      meanQ = meanQ + Vector3{ q[0], q[1], q[2] };
      ++count;
    }
  }
  meanP = (1.0 / static_cast<double>(count)) * meanP;
  meanQ = (1.0 / static_cast<double>(count)) * meanQ;
  // The mirror image of a symmetric set: y is the eigenvector of the smallest eigenvalue of H + H'. Normals mirror by
  // the same linear map, so they enter H without their mean.
  Matrix3 h{};
  for (const Pair & pair : pairs)
  {
    if (pair.squared <= limit)
    {
      const Point6 & p = level.jaws[pair.jaw].points[pair.point];
      const Point6 & q = level.jaws[pair.jaw].points[pair.match];
      for (unsigned int r = 0; r < 3; ++r)
      {
        for (unsigned int c = 0; c < 3; ++c)
        {
          h[r][c] += (p[r] - meanP[r]) * (q[c] - meanQ[c]) + p[r + 3] * q[c + 3];
        }
      }
    }
  }
  for (unsigned int r = 0; r < 3; ++r)
  {
    for (unsigned int c = r; c < 3; ++c)
    {
      h[r][c] = h[c][r] = h[r][c] + h[c][r];
    }
  }
  Vector3 values;
  Matrix3 vectors;
  SymmetricEigen(h, values, vectors);
  Vector3 normal = vectors[0];
  if (Dot(normal, plane.normal) < 0.0)
  {
    normal = -1.0 * normal;
  }
  const Vector3 centre = 0.5 * (meanP + meanQ);
  const double  turn = std::asin(std::min(1.0, Norm(Cross(normal, plane.normal)))) / Degree;
  const double  shift = std::abs(Dot(centre, plane.normal) - plane.offset);
  plane.normal = normal;
  plane.offset = Dot(normal, centre);
  return turn + shift;
}

void
Iterate(const Level &                   level,
        Plane &                         plane,
        const MidsagittalPlaneOptions & options,
        unsigned int                    iterations,
        double                          tolerance,
        std::vector<Pair> &             pairs)
{
  for (unsigned int i = 0; i < iterations; ++i)
  {
    if (Update(level, plane, options, pairs) < tolerance)
    {
      break;
    }
  }
  Match(level, plane, pairs);
  plane.residual = TruncatedMean(pairs, options.truncationDistance);
}

double
AngleBetween(const Plane & a, const Plane & b)
{
  return std::asin(std::min(1.0, Norm(Cross(a.normal, b.normal)))) / Degree;
}

double
ShiftBetween(const Plane & a, const Plane & b, const Vector3 & centre)
{
  const double sign = Dot(a.normal, b.normal) < 0.0 ? -1.0 : 1.0;
  return std::abs((Dot(a.normal, centre) - a.offset) - sign * (Dot(b.normal, centre) - b.offset));
}
} // namespace

MidsagittalPlaneResult
EstimateMidsagittalPlane(const std::vector<OrientedPointSet> & jaws,
                         const std::array<double, 3> &         vertical,
                         const std::array<double, 3> &         lateral,
                         const MidsagittalPlaneOptions &       options)
{
  MidsagittalPlaneResult result;
  std::size_t            total = 0;
  Vector3                centre{ 0.0, 0.0, 0.0 };
  for (const OrientedPointSet & jaw : jaws)
  {
    total += jaw.points.size();
    for (const Vector3 & p : jaw.points)
    {
      centre = centre + p;
    }
  }
  if (total < 50)
  {
    return result;
  }
  centre = (1.0 / static_cast<double>(total)) * centre;

  const Vector3 z = Unit(vertical);
  Vector3       reference = UnitRejection(lateral, z);
  const bool    known = Norm(reference) > 0.5;
  if (!known)
  {
    // The direction of the farthest sample: it turns with the data, so the answer does not depend on the input's frame.
    double farthest = -1.0;
    for (const OrientedPointSet & jaw : jaws)
    {
      for (const Vector3 & p : jaw.points)
      {
        const Vector3 across = (p - centre) - Dot(p - centre, z) * z;
        if (Dot(across, across) > farthest)
        {
          farthest = Dot(across, across);
          reference = Unit(across);
        }
      }
    }
  }

  std::vector<Pair> pairs;
  const Level       coarse = MakeLevel(jaws, options.normalWeight, std::max(50u, options.searchSamples / 2));
  const Level       search = MakeLevel(jaws, options.normalWeight, options.searchSamples);
  const Level       ranking =
    MakeLevel(jaws, options.normalWeight, std::min(3 * options.searchSamples, options.finalSamples));
  const Level fine = MakeLevel(jaws, options.normalWeight, options.finalSamples);

  // Starts about z: a plane's normal covers half a turn. Few updates of few samples, then the best go on.
  std::vector<Plane> candidates;
  const auto side = static_cast<int>(std::floor(std::min(90.0, known ? options.startRange : 90.0) / options.startStep));
  for (int start = -side; start <= side; ++start)
  {
    if (start == side && side * options.startStep >= 90.0)
    {
      break; // the plane of the first start, turned by 180 degrees
    }
    Plane plane;
    plane.normal = Rotate(reference, z, start * options.startStep * Degree);
    plane.offset = Dot(plane.normal, centre);
    Iterate(coarse, plane, options, 5, 0.3, pairs);
    candidates.push_back(plane);
  }
  const auto byResidual = [](const Plane & a, const Plane & b) { return a.residual < b.residual; };
  const auto keepDistinct = [&](std::vector<Plane> & planes, double angle, double shift, std::size_t most) {
    // A flat arch also mirrors well up and down: planes that leaned over by more than 30 degrees go last.
    for (Plane & plane : planes)
    {
      if (std::abs(Dot(plane.normal, z)) > 0.5)
      {
        plane.residual = options.truncationDistance;
      }
    }
    std::stable_sort(planes.begin(), planes.end(), byResidual);
    std::vector<Plane> distinct;
    for (const Plane & plane : planes)
    {
      const bool repeated = std::any_of(distinct.begin(), distinct.end(), [&](const Plane & other) {
        return AngleBetween(plane, other) < angle && ShiftBetween(plane, other, centre) < shift;
      });
      if (!repeated && distinct.size() < most)
      {
        distinct.push_back(plane);
      }
    }
    planes = distinct;
  };
  keepDistinct(candidates, 2.0, 1.0, 4);
  for (Plane & plane : candidates)
  {
    Iterate(search, plane, options, 12, 0.05, pairs);
  }
  keepDistinct(candidates, 0.5, 0.3, 4);

  // Where restarts find a better plane, they start again from that.
  for (unsigned int round = 0; options.restarts && round < 3; ++round)
  {
    const Plane                 winner = candidates.front();
    const double                winnerShift = winner.offset - Dot(winner.normal, centre);
    const std::array<double, 9> yaws{ { -12.0, -8.0, -5.0, -2.5, 0.0, 2.5, 5.0, 8.0, 12.0 } };
    const std::array<double, 3> offsets{ { -1.5, 0.0, 1.5 } };
    std::vector<Plane>          restarted;
    for (const double yaw : yaws)
    {
      for (const double offset : offsets)
      {
        if (yaw == 0.0 && offset == 0.0)
        {
          continue;
        }
        Plane plane;
        plane.normal = Rotate(winner.normal, z, yaw * Degree);
        plane.offset = Dot(plane.normal, centre) + winnerShift + offset;
        // Most fall back to the winner within a few updates: those need no more.
        Iterate(coarse, plane, options, 3, 0.1, pairs);
        if (AngleBetween(plane, winner) > 0.8 || ShiftBetween(plane, winner, centre) > 0.5)
        {
          Iterate(coarse, plane, options, 7, 0.1, pairs);
          restarted.push_back(plane);
        }
      }
    }
    keepDistinct(restarted, 0.7, 0.4, 4);
    for (Plane & plane : restarted)
    {
      Iterate(search, plane, options, 12, 0.05, pairs);
    }
    candidates.insert(candidates.end(), restarted.begin(), restarted.end());
    keepDistinct(candidates, 0.5, 0.3, 4);
    if (AngleBetween(candidates.front(), winner) < 1.0 && ShiftBetween(candidates.front(), winner, centre) < 0.5)
    {
      break;
    }
  }

  // Rank the leaders on denser samples, and finish the best of them.
  if (candidates.size() > 4)
  {
    candidates.resize(4);
  }
  std::vector<double> ranks;
  for (Plane & plane : candidates)
  {
    Iterate(ranking, plane, options, 5, 0.05, pairs);
    ranks.push_back(TruncatedMean(pairs, options.rankingDistance));
  }
  const auto   leader = std::min_element(ranks.begin(), ranks.end()) - ranks.begin();
  const double bestRank = ranks[static_cast<std::size_t>(leader)];
  const auto   isApart = [&](const Plane & a, const Plane & b) {
    return AngleBetween(a, b) > 2.0 || ShiftBetween(a, b, centre) > 1.0;
  };
  // Of minima beside the leader, which differ by how single cusps happen to match, the one of the smoother criterion.
  Plane best = candidates[static_cast<std::size_t>(leader)];
  for (const Plane & plane : candidates)
  {
    best =
      plane.residual < best.residual && !isApart(plane, candidates[static_cast<std::size_t>(leader)]) ? plane : best;
  }
  Iterate(fine, best, options, 15, 0.01, pairs);

  result.margin = options.truncationDistance - best.residual;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (isApart(candidates[i], best))
    {
      result.margin = std::min(result.margin, std::max(0.0, ranks[i] - bestRank));
    }
  }
  std::size_t inliers = 0;
  for (const Pair & pair : pairs)
  {
    inliers += pair.squared < options.truncationDistance * options.truncationDistance ? 1 : 0;
  }
  result.inlierFraction = static_cast<double>(inliers) / static_cast<double>(pairs.size());
  result.residual = best.residual;
  if (known && Dot(best.normal, reference) < 0.0)
  {
    best.normal = -1.0 * best.normal;
    best.offset = -best.offset;
  }
  result.normal = best.normal;
  result.offset = best.offset;
  result.valid = true;
  return result;
}
} // namespace itk
