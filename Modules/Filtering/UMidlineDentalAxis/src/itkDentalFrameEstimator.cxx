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
#include "itkDentalFrameEstimator.h"

#include "itkDentalFrameMath.h"
#include "itkFlatKdTree.h"
#include "itkParallelFor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <mutex>

namespace itk
{
namespace
{
/** An arch of fewer triangles has no crowns: the coarsest scan in use has some thousand. The samples are drawn from the
 * area and would be as many of a single triangle, on whose flat face a U can be found as well as anywhere. */
constexpr std::size_t MinimumTriangles = 100;
/** Specks and degenerate triangles give none. */
constexpr std::size_t MinimumSamples = 100;

using namespace DentalFrameMath;

constexpr std::size_t ArchTerms = 5;

/** Uniform samples of a jaw's surface, and what the choice of the occlusal side needs. */
struct Samples
{
  std::vector<Vector3> points;
  std::vector<Vector3> normals;
  /** 1 - |mean normal within 2 mm|: 0 on a flat base, large on cusps and fissures. */
  std::vector<double> roughness;
  Vector3             centroid{ 0.0, 0.0, 0.0 };
  Vector3             netNormal{ 0.0, 0.0, 0.0 };
  double              area{ 0.0 };
  double              meanRoughness{ 0.0 };
};

/** The occlusal direction with the crown candidates that gave it. */
struct Vertical
{
  Vector3                    direction{ 0.0, 0.0, 0.0 };
  Vector3                    centre{ 0.0, 0.0, 0.0 };
  double                     thickness{ 0.0 };
  double                     inlierShare{ 0.0 };
  std::vector<std::uint32_t> crowns;
  double                     score{ 0.0 };
};

/** The U: r(phi) = sum a_k cos(k phi) about a centre, phi counted from the anterior direction. */
struct Arch
{
  Vector3                       anterior{ 0.0, 0.0, 0.0 };
  Vector3                       lateral{ 0.0, 0.0, 0.0 };
  Vector3                       centre{ 0.0, 0.0, 0.0 };
  std::array<double, ArchTerms> terms{};
  double                        radius{ 0.0 };
  /** mm: robust spread of the crowns about the U. */
  double spread{ 0.0 };
  /** How clear it is where the front is: 0 for a closed ring, 1 or more for a U. */
  double                 resultant{ 0.0 };
  MidsagittalPlaneResult mirror;
  /** Angle that the crowns reach on the side where they reach less. */
  double reach{ 0.0 };
  bool   valid{ false };
};

double
ArchRadius(const std::array<double, ArchTerms> & terms, double phi)
{
  double radius = 0.0;
  for (std::size_t k = 0; k < ArchTerms; ++k)
  {
    radius += terms[k] * std::cos(static_cast<double>(k) * phi);
  }
  return radius;
}

double
Quantile(std::vector<double> values, double fraction)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto k = std::min(values.size() - 1, static_cast<std::size_t>(fraction * static_cast<double>(values.size())));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values.end());
  return values[k];
}

std::uint32_t
Find(std::vector<std::uint32_t> & parent, std::uint32_t i)
{
  while (parent[i] != i)
  {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

/** Welds repeated points, drops specks, and takes systematic samples by area in the order of the triangles: the same
 * samples in whatever frame the mesh is. */
Samples
TakeSamples(const TriangleSurface & surface, unsigned int count)
{
  // Open addressing: of repeated points the first stands for all.
  const std::size_t          size = surface.points.size();
  std::vector<std::uint32_t> first(size);
  {
    constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
    std::size_t             slots = 64;
    while (slots < 2 * size)
    {
      slots *= 2;
    }
    std::vector<std::uint32_t> table(slots, empty);
    for (std::uint32_t i = 0; i < size; ++i)
    {
      std::uint64_t hash = 0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double  value = surface.points[i][d] + 0.0; // -0 and 0 are one place
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof(value));
        hash = (hash ^ bits) * 0x9E3779B97F4A7C15ull;
        hash ^= hash >> 32;
      }
      std::size_t slot = hash & (slots - 1);
      while (table[slot] != empty && surface.points[table[slot]] != surface.points[i])
      {
        slot = (slot + 1) & (slots - 1);
      }
      if (table[slot] == empty)
      {
        table[slot] = i;
      }
      first[i] = table[slot];
    }
  }

  const std::size_t          triangles = surface.triangles.size();
  std::vector<double>        areas(triangles, 0.0);
  std::vector<Vector3>       faces(triangles);
  std::vector<Vector3>       normals(size, Vector3{ 0.0, 0.0, 0.0 });
  std::vector<std::uint32_t> parent(size);
  for (std::uint32_t i = 0; i < size; ++i)
  {
    parent[i] = i;
  }
  for (std::size_t t = 0; t < triangles; ++t)
  {
    const Vector3 normal = surface.AreaNormal(t);
    const double  area = Norm(normal);
    if (!std::isfinite(area) || area <= 0.0)
    {
      continue;
    }
    areas[t] = area;
    faces[t] = normal;
    const auto & corners = surface.triangles[t];
    for (const std::uint32_t corner : corners)
    {
      normals[first[corner]] = normals[first[corner]] + normal;
      parent[Find(parent, first[corner])] = Find(parent, first[corners[0]]);
    }
  }
  // Specks: parts of less than 1.5 % of the surface. A single tooth without gingiva has more.
  std::vector<double> partArea(size, 0.0);
  double              total = 0.0;
  for (std::size_t t = 0; t < triangles; ++t)
  {
    if (areas[t] > 0.0)
    {
      partArea[Find(parent, first[surface.triangles[t][0]])] += areas[t];
      total += areas[t];
    }
  }

  Samples      samples;
  const double speck = 0.015 * total;
  double       kept = 0.0;
  for (std::size_t t = 0; t < triangles; ++t)
  {
    if (areas[t] > 0.0 && partArea[Find(parent, first[surface.triangles[t][0]])] < speck)
    {
      areas[t] = 0.0;
    }
    kept += areas[t];
  }
  if (kept <= 0.0 || count == 0)
  {
    return samples;
  }
  samples.area = kept;
  samples.points.reserve(count);
  samples.normals.reserve(count);
  double        cumulated = 0.0;
  std::uint32_t k = 0;
  for (std::size_t t = 0; t < triangles; ++t)
  {
    if (areas[t] <= 0.0)
    {
      continue;
    }
    cumulated += areas[t];
    const Vector3 & a = surface.points[surface.triangles[t][0]];
    const Vector3 & b = surface.points[surface.triangles[t][1]];
    const Vector3 & c = surface.points[surface.triangles[t][2]];
    samples.centroid = samples.centroid + (areas[t] / (3.0 * kept)) * (a + b + c);
    samples.netNormal = samples.netNormal + (1.0 / kept) * faces[t];
    for (; k < count && (k + 0.5) * kept / count < cumulated; ++k)
    {
      // Spread within the triangle by an additive recurrence (Roberts 2018): coarse meshes have many samples a
      // triangle.
      double u = std::fmod(0.5 + 0.7548776662466927 * (k + 1.0), 1.0);
      double v = std::fmod(0.5 + 0.5698402909980532 * (k + 1.0), 1.0);
      if (u + v > 1.0)
      {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      const double w = 1.0 - u - v;
      samples.points.push_back(w * a + u * b + v * c);
      const Vector3 smooth = w * Unit(normals[first[surface.triangles[t][0]]]) +
                             u * Unit(normals[first[surface.triangles[t][1]]]) +
                             v * Unit(normals[first[surface.triangles[t][2]]]);
      samples.normals.push_back(Norm(smooth) > 0.1 ? Unit(smooth) : Unit(faces[t]));
    }
  }

  const FlatKdTree<3> tree(samples.points);
  samples.roughness.reserve(samples.points.size());
  for (const Vector3 & p : samples.points)
  {
    Vector3     sum{ 0.0, 0.0, 0.0 };
    std::size_t neighbours = 0;
    tree.Within(p, 2.0, [&](std::uint32_t index, double) {
      sum = sum + samples.normals[index];
      ++neighbours;
    });
    samples.roughness.push_back(1.0 - Norm(sum) / static_cast<double>(std::max<std::size_t>(1, neighbours)));
    samples.meanRoughness += samples.roughness.back() / static_cast<double>(samples.points.size());
  }
  return samples;
}

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
          cost += heights[n] > 0.0 ? 1.5 * std::min(heights[n], limit) : std::min(-heights[n], limit);
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

/** Which samples lie within the band below the local occlusal envelope: the 98th percentile of the heights in polar
 * sectors about the centre. Sectors whose envelope lies far below the plate on the teeth have none: a palate's end, a
 * cast's heel, a gap. */
std::vector<std::uint32_t>
CrownBand(const Samples & samples, const Vector3 & occlusal, const Vector3 & centre, double band)
{
  constexpr int       sectors = 36;
  constexpr double    belowPlate = 4.0; // mm: more than the curve of Spee and a short tooth together
  const Vector3       e1 = FarthestAcross(samples, occlusal);
  const Vector3       e2 = Cross(occlusal, e1);
  std::vector<double> heights(samples.points.size());
  std::vector<int>    sector(samples.points.size());
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
    if (overPlate[n] > -belowPlate)
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

/** Centre of the circle that fits points of the plane best (Kasa 1976): a gap in the ring does not move it. */
std::array<double, 3>
FitCircle(const std::vector<std::array<double, 2>> & points)
{
  std::array<double, 2> mean{ 0.0, 0.0 };
  for (const auto & p : points)
  {
    mean[0] += p[0] / static_cast<double>(points.size());
    mean[1] += p[1] / static_cast<double>(points.size());
  }
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
  double uq = 0.0;
  double vq = 0.0;
  double q = 0.0;
  for (const auto & p : points)
  {
    const double u = p[0] - mean[0];
    const double v = p[1] - mean[1];
    uu += u * u;
    uv += u * v;
    vv += v * v;
    uq += u * (u * u + v * v);
    vq += v * (u * u + v * v);
    q += u * u + v * v;
  }
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 1e-12 * uu * vv))
  {
    return { mean[0], mean[1], 0.0 };
  }
  const double cu = 0.5 * (uq * vv - vq * uv) / determinant;
  const double cv = 0.5 * (vq * uu - uq * uv) / determinant;
  return { mean[0] + cu, mean[1] + cv, std::sqrt(cu * cu + cv * cv + q / static_cast<double>(points.size())) };
}

/** Solves the symmetric positive system in place by Cholesky's method; false where it is singular. */
bool
SolveSymmetric(std::array<std::array<double, ArchTerms>, ArchTerms> a, std::array<double, ArchTerms> & b)
{
  for (std::size_t i = 0; i < ArchTerms; ++i)
  {
    for (std::size_t j = 0; j <= i; ++j)
    {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k)
      {
        sum -= a[i][k] * a[j][k];
      }
      if (i == j)
      {
        if (!(sum > 0.0))
        {
          return false;
        }
        a[i][i] = std::sqrt(sum);
      }
      else
      {
        a[i][j] = sum / a[j][j];
      }
    }
  }
  for (std::size_t i = 0; i < ArchTerms; ++i)
  {
    for (std::size_t k = 0; k < i; ++k)
    {
      b[i] -= a[i][k] * b[k];
    }
    b[i] /= a[i][i];
  }
  for (std::size_t i = ArchTerms; i-- > 0;)
  {
    for (std::size_t k = i + 1; k < ArchTerms; ++k)
    {
      b[i] -= a[k][i] * b[k];
    }
    b[i] /= a[i][i];
  }
  return true;
}

/** Fits r(phi) = sum a_k cos(k phi) to points about the U's centre, first coordinate along its axis; far points count
 * less and less. */
std::array<double, ArchTerms>
FitEvenCurve(const std::vector<std::array<double, 2>> & points, double radius)
{
  constexpr double                           scale = 4.0; // mm, half a molar's width
  std::array<double, ArchTerms>              terms{};
  std::vector<double>                        r(points.size());
  std::vector<std::array<double, ArchTerms>> basis(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    r[i] = std::hypot(points[i][0], points[i][1]);
    const double cosine = r[i] > 0.0 ? points[i][0] / r[i] : 1.0;
    basis[i][0] = 1.0;
    basis[i][1] = cosine;
    for (std::size_t k = 2; k < ArchTerms; ++k)
    {
      basis[i][k] = 2.0 * cosine * basis[i][k - 1] - basis[i][k - 2];
    }
  }
  terms[0] = radius;
  for (unsigned int round = 0; round < 6; ++round)
  {
    std::array<std::array<double, ArchTerms>, ArchTerms> a{};
    std::array<double, ArchTerms>                        b{};
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      double residual = r[i];
      for (std::size_t k = 0; k < ArchTerms; ++k)
      {
        residual -= terms[k] * basis[i][k];
      }
      const double ratio = residual * residual / (scale * scale);
      // The first round has only the circle: all points count.
      const double weight = round == 0 ? 1.0 : 1.0 / ((1.0 + ratio) * (1.0 + ratio));
      for (std::size_t p = 0; p < ArchTerms; ++p)
      {
        b[p] += weight * basis[i][p] * r[i];
        for (std::size_t q = 0; q <= p; ++q)
        {
          a[p][q] += weight * basis[i][p] * basis[i][q];
        }
      }
    }
    // High terms are kept small: where teeth are missing they would swing.
    for (std::size_t p = 0; p < ArchTerms; ++p)
    {
      a[p][p] += 6e-5 * static_cast<double>(points.size() * p * p * p * p) + 1e-9;
    }
    if (!SolveSymmetric(a, b))
    {
      break;
    }
    terms = b;
  }
  return terms;
}

/** The paper's X: baseline between left and right molars, across which is the anterior direction. Which points of the
 * left and the right crowns belong together is what their mirror symmetry says: uneven trimming or a missing molar then
 * turns nothing. The U is the even curve about that axis. The front is where the crowns say, or such
 * that the lateral axis goes with the one given. */
Arch
FitArch(const Samples &                samples,
        const Vertical &               vertical,
        bool                           upper,
        const MidsagittalPlaneResult & mirror,
        const Vector3 *                givenLateral = nullptr)
{
  Arch          arch;
  const Vector3 superior = upper ? -1.0 * vertical.direction : vertical.direction;
  if (vertical.crowns.size() < 30 || !mirror.valid)
  {
    return arch;
  }
  Vector3 lateral = UnitRejection(mirror.normal, superior);
  Vector3 anterior = Cross(lateral, superior);

  std::vector<std::array<double, 2>> points;
  double                             mean = 0.0;
  for (const std::uint32_t i : vertical.crowns)
  {
    const Vector3 d = samples.points[i] - vertical.centre;
    points.push_back({ Dot(d, anterior), Dot(d, lateral) });
    mean += points.back()[0] / static_cast<double>(vertical.crowns.size());
  }
  // The foot of the crowns' centre on the plane, along the lateral axis.
  const double shift =
    (mirror.offset - Dot(mirror.normal, vertical.centre)) / std::max(0.5, Dot(mirror.normal, lateral));
  const auto circle = FitCircle(points);
  arch.radius = circle[2];

  // Front: the ring about the circle's centre is open at the back, and near the axis there are crowns in front only.
  double              resultant = 0.0;
  std::vector<double> middle;
  for (const auto & p : points)
  {
    const double x = p[0] - circle[0];
    resultant += x / std::max(1e-9, std::hypot(x, p[1] - shift)) / static_cast<double>(points.size());
    if (std::abs(p[1] - shift) < 6.0)
    {
      middle.push_back(p[0] - mean);
    }
  }
  double front = resultant / 0.2;
  if (middle.size() >= 8)
  {
    front += std::clamp(Quantile(middle, 0.5) / 6.0, -2.0, 2.0);
  }
  const double sign = (givenLateral != nullptr ? Dot(lateral, *givenLateral) : front) < 0.0 ? -1.0 : 1.0;
  anterior = sign * anterior;
  lateral = sign * lateral;
  arch.resultant = std::abs(front) / 3.0;
  arch.anterior = anterior;
  arch.lateral = lateral;
  arch.centre = vertical.centre + (sign * circle[0]) * anterior + (sign * shift) * lateral;
  arch.mirror = mirror;
  for (auto & p : points)
  {
    p = { sign * (p[0] - circle[0]), sign * (p[1] - shift) };
  }
  arch.terms = FitEvenCurve(points, arch.radius);

  std::vector<double> left;
  std::vector<double> right;
  std::vector<double> residuals;
  for (const auto & p : points)
  {
    const double phi = std::atan2(p[1], p[0]);
    const double residual = std::abs(std::hypot(p[0], p[1]) - ArchRadius(arch.terms, phi));
    residuals.push_back(residual);
    if (residual < 6.0)
    {
      (p[1] > 0.0 ? left : right).push_back(std::abs(phi));
    }
  }
  arch.spread = 1.4826 * Quantile(residuals, 0.5);
  if (left.size() < 5 || right.size() < 5)
  {
    return arch;
  }
  arch.reach = std::min(Quantile(left, 0.95), Quantile(right, 0.95));
  arch.valid = true;
  return arch;
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

/** Tries the directions that may be occlusal and keeps the best. The margin is its score less that of the best
 * direction more than 60 degrees away. */
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

/** Vertical and U of one jaw, on the way to its frame. */
struct Jaw
{
  const TriangleSurface * surface{ nullptr };
  bool                    upper{ true };
  bool                    valid{ false };
  /** The normals had to be turned: the mesh is wound inward. */
  bool     turned{ false };
  Samples  samples;
  Vertical vertical;
  Arch     arch;
  double   margin{ 0.0 };

  Vector3
  Superior() const
  {
    return upper ? -1.0 * vertical.direction : vertical.direction;
  }
};

/** The crowns with whole height, as the mirror plane wants them. */
OrientedPointSet
MirrorSet(const Jaw & jaw, const DentalFrameOptions & options)
{
  OrientedPointSet set;
  for (const std::uint32_t i :
       CrownBand(jaw.samples, jaw.vertical.direction, jaw.samples.centroid, options.mirrorBandHeight))
  {
    set.points.push_back(jaw.samples.points[i]);
    set.normals.push_back(jaw.samples.normals[i]);
  }
  return set;
}

MidsagittalPlaneResult
CoarseMirror(const std::vector<OrientedPointSet> & sets, const Vector3 & vertical, const DentalFrameOptions & options)
{
  return EstimateMidsagittalPlane(sets, vertical, Vector3{ 0.0, 0.0, 0.0 }, options.midline);
}

/** Takes over the mirror plane. The crowns are as high on the left as on the right: their plane loses its roll, which
 * missing teeth had given it. */
void
SetMirror(Jaw & jaw, const MidsagittalPlaneResult & mirror)
{
  if (mirror.valid && std::abs(Dot(mirror.normal, jaw.vertical.direction)) < 0.17)
  {
    jaw.vertical.direction = UnitRejection(jaw.vertical.direction, mirror.normal);
  }
  jaw.arch = FitArch(jaw.samples, jaw.vertical, jaw.upper, mirror);
}

void
TurnSamples(Jaw & jaw)
{
  jaw.turned = !jaw.turned;
  jaw.samples.netNormal = -1.0 * jaw.samples.netNormal;
  for (Vector3 & normal : jaw.samples.normals)
  {
    normal = -1.0 * normal;
  }
}

void
FindArch(Jaw & jaw, const DentalFrameOptions & options)
{
  SetMirror(jaw, CoarseMirror({ MirrorSet(jaw, options) }, jaw.Superior(), options));
  jaw.valid = jaw.arch.valid;
}

struct Contact
{
  Vector3             direction{ 0.0, 0.0, 0.0 };
  double              distance{ 0.0 };
  std::vector<double> upperDistances;
  std::vector<double> lowerDistances;
};

/** The contact band: samples of each jaw near the other. Its flattest direction is vertical whatever base, palate and
 * trimming the meshes have. */
Contact
FindContact(const Samples & upper, const Samples & lower)
{
  Contact    contact;
  const auto measure = [](const Samples & from, const Samples & to) {
    const FlatKdTree<3> tree(to.points);
    std::vector<double> distances;
    distances.reserve(from.points.size());
    std::uint32_t guess = FlatKdTree<3>::None;
    for (const Vector3 & p : from.points)
    {
      double squared = std::numeric_limits<double>::infinity();
      guess = tree.Nearest(p, squared, guess);
      distances.push_back(std::sqrt(squared));
    }
    return distances;
  };
  contact.upperDistances = measure(upper, lower);
  contact.lowerDistances = measure(lower, upper);
  std::vector<double> all = contact.upperDistances;
  all.insert(all.end(), contact.lowerDistances.begin(), contact.lowerDistances.end());
  contact.distance = Quantile(all, 0.12);
  const double limit = std::max(1.0, contact.distance);
  Vector3      mean{ 0.0, 0.0, 0.0 };
  double       count = 0.0;
  const auto   visit = [&](auto && body) {
    for (std::size_t i = 0; i < upper.points.size(); ++i)
    {
      if (contact.upperDistances[i] <= limit)
      {
        body(upper.points[i]);
      }
    }
    for (std::size_t i = 0; i < lower.points.size(); ++i)
    {
      if (contact.lowerDistances[i] <= limit)
      {
        body(lower.points[i]);
      }
    }
  };
  visit([&](const Vector3 & p) {
    mean = mean + p;
    count += 1.0;
  });
  mean = (1.0 / std::max(1.0, count)) * mean;
  Matrix3 covariance{};
  visit([&](const Vector3 & p) {
    const Vector3 d = p - mean;
    for (unsigned int r = 0; r < 3; ++r)
    {
      for (unsigned int c = 0; c < 3; ++c)
      {
        covariance[r][c] += d[r] * d[c];
      }
    }
  });
  Vector3 values;
  Matrix3 vectors;
  SymmetricEigen(covariance, values, vectors);
  contact.direction = Dot(vectors[0], upper.centroid - lower.centroid) < 0.0 ? -1.0 * vectors[0] : vectors[0];
  return contact;
}

double
AngleBetween(const Vector3 & a, const Vector3 & b)
{
  return std::atan2(Norm(Cross(a, b)), Dot(a, b)) / Degree;
}

/** Fills in what the jaws' verticals say about occlusion. The limits are wide: an open bite of 6 mm or casts set apart
 * pass, meshes in frames of their own do not. */
bool
VerticalsFit(const Jaw & upper, const Jaw & lower, const Contact & contact, DentalFrameResult & result)
{
  const Vector3 z = Unit(upper.Superior() + lower.Superior());
  result.contactDistance = contact.distance;
  result.verticalSeparation = Dot(upper.samples.centroid - lower.samples.centroid, z);
  result.verticalDisagreement = AngleBetween(upper.Superior(), lower.Superior());
  std::vector<double> crowns;
  for (const std::uint32_t i : upper.vertical.crowns)
  {
    crowns.push_back(contact.upperDistances[i]);
  }
  for (const std::uint32_t i : lower.vertical.crowns)
  {
    crowns.push_back(contact.lowerDistances[i]);
  }
  result.crownDistance = Quantile(crowns, 0.12);
  result.crownPlaneGap = Dot(upper.vertical.centre - lower.vertical.centre, z);
  return result.crownDistance < 8.0 && result.verticalSeparation > 1.0 && result.verticalDisagreement < 25.0 &&
         result.crownPlaneGap > -8.0 && result.crownPlaneGap < 14.0;
}

/** The whole test: one arch over the other as well. */
bool
TestOcclusion(const Jaw & upper, const Jaw & lower, const Contact & contact, DentalFrameResult & result)
{
  const bool    verticalsFit = VerticalsFit(upper, lower, contact, result);
  const Vector3 z = Unit(upper.Superior() + lower.Superior());
  const Vector3 between = upper.arch.centre - lower.arch.centre;
  result.anteriorDisagreement = AngleBetween(upper.arch.anterior, lower.arch.anterior);
  result.archCentreDistance = Norm(between - Dot(between, z) * z);
  return verticalsFit && result.archCentreDistance < 15.0;
}

double
Ramp(double value, double zero, double one)
{
  return std::clamp((value - zero) / (one - zero), 0.0, 1.0);
}

/** Baseline, midpoint, incisal edge and the confidences, from the jaw's own U; the axes are set. */
void
Describe(const Jaw & jaw, DentalJawFrame & frame)
{
  const Arch & arch = jaw.arch;
  const auto   onArch = [&](double phi) {
    const double  radius = ArchRadius(arch.terms, phi);
    const Vector3 p = arch.centre + (radius * std::cos(phi)) * arch.anterior + (radius * std::sin(phi)) * arch.lateral;
    // The U lies in the plane of the crowns.
    return p - Dot(p - jaw.vertical.centre, jaw.vertical.direction) * jaw.vertical.direction;
  };
  // At the molars: where the crowns end, but not behind the U's widest place (the ridge behind a cast's last molar).
  double widest = arch.reach;
  double width = 0.0;
  for (double phi = 0.35 * Pi; phi <= arch.reach; phi += Degree)
  {
    const double across = ArchRadius(arch.terms, phi) * std::sin(phi);
    if (across > width)
    {
      width = across;
      widest = phi;
    }
  }
  frame.baselineLeft = onArch(widest);
  frame.baselineRight = onArch(-widest);
  frame.midpoint = 0.5 * (frame.baselineLeft + frame.baselineRight);

  // The edge: the highest points where the U crosses its axis. Samples first, so that a speck above cannot be it.
  const Vector3 front = onArch(0.0);
  const auto    nearFront = [&](const Vector3 & p) {
    const Vector3 d = p - front;
    return std::abs(Dot(d, arch.lateral)) < 4.0 && std::abs(Dot(d, arch.anterior)) < 6.0;
  };
  double highest = -std::numeric_limits<double>::infinity();
  for (const Vector3 & p : jaw.samples.points)
  {
    if (nearFront(p))
    {
      highest = std::max(highest, Dot(p - front, jaw.vertical.direction));
    }
  }
  frame.incisalEdge = front;
  if (std::isfinite(highest))
  {
    std::vector<double>  heights;
    std::vector<Vector3> edge;
    for (const Vector3 & p : jaw.surface->points)
    {
      const double height = Dot(p - front, jaw.vertical.direction);
      if (height > highest - 1.5 && height < highest + 0.7 && nearFront(p))
      {
        heights.push_back(height);
        edge.push_back(p);
      }
    }
    if (!edge.empty())
    {
      const double crest = Quantile(heights, 0.98) - 0.4;
      Vector3      sum{ 0.0, 0.0, 0.0 };
      double       count = 0.0;
      double       height = 0.0;
      for (std::size_t i = 0; i < edge.size(); ++i)
      {
        if (heights[i] >= crest)
        {
          sum = sum + edge[i];
          height = std::max(height, heights[i]);
          count += 1.0;
        }
      }
      frame.incisalEdge = (1.0 / count) * sum;
    }
  }
  frame.archWidth = Norm(frame.baselineLeft - frame.baselineRight);
  frame.archDepth = Dot(frame.incisalEdge - frame.midpoint, frame.axes[0]);
  frame.openness = Norm(jaw.samples.netNormal);
  frame.windingAgreement = frame.openness > 0.0 ? (jaw.turned ? -1.0 : 1.0) *
                                                    Dot(jaw.samples.netNormal, jaw.vertical.direction) / frame.openness
                                                : 0.0;

  // Roughness alone, all that a closed body has, is a weaker sign than normals or contact.
  const double surest = frame.openness > 0.15 ? 1.0 : 0.7;
  frame.signConfidence = std::max(frame.signConfidence, surest * Ramp(jaw.margin, 0.0, 0.8));
  frame.planeConfidence = Ramp(jaw.vertical.thickness, 6.0, 3.0) * Ramp(jaw.vertical.inlierShare, 0.4, 0.75);
  frame.archConfidence = Ramp(arch.spread, 9.0, 4.5) * Ramp(arch.reach, 30.0 * Degree, 75.0 * Degree) *
                         Ramp(arch.radius, 12.0, 18.0) * Ramp(arch.radius, 60.0, 48.0) * Ramp(arch.resultant, 0.0, 0.5);
}
} // namespace

DentalFrameResult
EstimateDentalFrame(const TriangleSurface * upper, const TriangleSurface * lower, const DentalFrameOptions & options)
{
  DentalFrameResult  result;
  std::array<Jaw, 2> jaws;
  std::mutex         abortMutex;
  const auto         aborted = [&]() {
    const std::lock_guard<std::mutex> lock(abortMutex);
    return options.abort && options.abort();
  };
  ParallelFor(2, options.threads == 0 ? 2 : options.threads, [&](std::size_t j) {
    Jaw & jaw = jaws[j];
    jaw.upper = j == 0;
    jaw.surface = jaw.upper ? upper : lower;
    if (jaw.surface == nullptr || aborted())
    {
      return;
    }
    jaw.samples = TakeSamples(*jaw.surface, options.samples);
    if (jaw.surface->triangles.size() >= MinimumTriangles && jaw.samples.points.size() >= MinimumSamples && !aborted())
    {
      jaw.vertical = ChooseVertical(jaw.samples, Vector3{ 0.0, 0.0, 0.0 }, 0.0, options, jaw.margin);
      FindArch(jaw, options);
    }
  });
  if (aborted())
  {
    return result;
  }

  const bool both = jaws[0].valid && jaws[1].valid;
  if (both)
  {
    const Contact contact = FindContact(jaws[0].samples, jaws[1].samples);
    result.occlusionPlausible = TestOcclusion(jaws[0], jaws[1], contact, result);
    if (!result.occlusionPlausible && options.jawsShareFrame != DentalFrameEnums::JawsShareFrame::Off)
    {
      // One jaw's own estimate may have the wrong sign: a closed cast has no net normal, an inward winding a reversed
      // one. Contact decides, if everything fits then.
      std::array<std::array<Jaw, 2>, 2> trials{ { { { jaws[0], jaws[0] } }, { { jaws[1], jaws[1] } } } };
      for (unsigned int j = 0; j < 2; ++j)
      {
        TurnSamples(trials[j][1]);
        for (Jaw & trial : trials[j])
        {
          trial.vertical = ChooseVertical(
            trial.samples, j == 0 ? -1.0 * contact.direction : contact.direction, 2.0, options, trial.margin);
        }
      }
      for (unsigned int variant = 0; variant < 4 && !result.occlusionPlausible && !aborted(); ++variant)
      {
        Jaw &             first = trials[0][variant & 1u];
        Jaw &             second = trials[1][variant >> 1];
        DentalFrameResult tested = result;
        // Only an open shell shows that it is wound inward.
        if ((first.turned && Norm(first.samples.netNormal) < 0.1) ||
            (second.turned && Norm(second.samples.netNormal) < 0.1) || !VerticalsFit(first, second, contact, tested))
        {
          continue;
        }
        FindArch(first, options);
        FindArch(second, options);
        if (first.valid && second.valid && TestOcclusion(first, second, contact, tested))
        {
          result = tested;
          result.occlusionPlausible = true;
          jaws = { first, second };
        }
      }
      if (aborted())
      {
        return DentalFrameResult();
      }
    }
    result.jawsShareFrame =
      options.jawsShareFrame == DentalFrameEnums::JawsShareFrame::On ||
      (options.jawsShareFrame == DentalFrameEnums::JawsShareFrame::Check && result.occlusionPlausible);
  }

  if (result.jawsShareFrame && result.anteriorDisagreement > 4.0)
  {
    // One jaw's plane is wrong, as in an arch that lacks one side. The pair's common plane decides.
    const MidsagittalPlaneResult common = CoarseMirror({ MirrorSet(jaws[0], options), MirrorSet(jaws[1], options) },
                                                       Unit(jaws[0].Superior() + jaws[1].Superior()),
                                                       options);
    for (Jaw & jaw : jaws)
    {
      SetMirror(jaw, common);
    }
  }

  if (result.jawsShareFrame && Dot(jaws[0].arch.lateral, jaws[1].arch.lateral) < 0.0)
  {
    // Contradicting fronts: the clearer U has its way, and neither is surer of it than by what it is clearer.
    const unsigned int clearer = jaws[0].arch.resultant >= jaws[1].arch.resultant ? 0 : 1;
    Jaw &              other = jaws[1 - clearer];
    const double       lead = std::abs(jaws[0].arch.resultant - jaws[1].arch.resultant);
    other.arch = FitArch(other.samples, other.vertical, other.upper, other.arch.mirror, &jaws[clearer].arch.lateral);
    for (Jaw & jaw : jaws)
    {
      jaw.arch.resultant = std::min(jaw.arch.resultant, lead);
    }
  }

  // The shared lateral axis.
  std::array<Vector3, 2> laterals{ { jaws[0].arch.lateral, jaws[1].arch.lateral } };
  if (result.jawsShareFrame)
  {
    laterals[0] = laterals[1] = Unit(laterals[0] + laterals[1]);
  }

  if (options.refineMidline)
  {
    MidsagittalPlaneOptions fine = options.midline;
    fine.startRange = std::min(fine.startRange, 10.0);
    if (result.jawsShareFrame)
    {
      result.midsagittalUpper = EstimateMidsagittalPlane({ MirrorSet(jaws[0], options), MirrorSet(jaws[1], options) },
                                                         Unit(jaws[0].Superior() + jaws[1].Superior()),
                                                         laterals[0],
                                                         fine);
      result.midsagittalLower = result.midsagittalUpper;
    }
    else
    {
      // Its own plane is known already; its normal shall point to the left.
      for (unsigned int j = 0; j < 2; ++j)
      {
        if (jaws[j].valid)
        {
          MidsagittalPlaneResult & plane = j == 0 ? result.midsagittalUpper : result.midsagittalLower;
          plane = jaws[j].arch.mirror;
          if (Dot(plane.normal, laterals[j]) < 0.0)
          {
            plane.normal = -1.0 * plane.normal;
            plane.offset = -plane.offset;
          }
        }
      }
    }
  }
  if (aborted())
  {
    return DentalFrameResult();
  }

  for (unsigned int j = 0; j < 2; ++j)
  {
    const Jaw &                    jaw = jaws[j];
    DentalJawFrame &               frame = j == 0 ? result.upper : result.lower;
    const MidsagittalPlaneResult & plane = j == 0 ? result.midsagittalUpper : result.midsagittalLower;
    frame.centroid = frame.origin = jaw.samples.centroid;
    if (!jaw.valid)
    {
      continue;
    }
    const bool refined = plane.valid;
    // The paper's last step: keep y and x, and z follows, since y is not across the jaw's own z.
    frame.axes[1] = refined ? plane.normal : laterals[j];
    frame.axes[0] = Unit(Cross(frame.axes[1], jaw.Superior()));
    frame.axes[2] = Cross(frame.axes[0], frame.axes[1]);
    frame.midlineOffset =
      refined ? plane.offset - Dot(plane.normal, frame.centroid) : Dot(frame.axes[1], jaw.arch.centre - frame.centroid);
    if (refined)
    {
      frame.origin = frame.centroid + frame.midlineOffset * frame.axes[1];
    }
    if (result.jawsShareFrame && result.occlusionPlausible)
    {
      frame.signConfidence = 1.0;
    }
    Describe(jaw, frame);
    std::size_t left = 0;
    for (const std::uint32_t i : jaw.vertical.crowns)
    {
      left += Dot(jaw.samples.points[i] - jaw.arch.centre, jaw.arch.lateral) > 0.0 ? 1 : 0;
    }
    const double share = static_cast<double>(std::min(left, jaw.vertical.crowns.size() - left)) /
                         static_cast<double>(jaw.vertical.crowns.size());
    frame.symmetryConfidence = Ramp(share, 0.1, 0.3);
    const MidsagittalPlaneResult & mirror = refined ? plane : jaw.arch.mirror;
    frame.symmetryConfidence *= Ramp(mirror.inlierFraction, 0.5, 0.8) * (0.4 + 0.6 * Ramp(mirror.margin, 0.0, 0.15));
    frame.confidence = frame.signConfidence * frame.planeConfidence * frame.archConfidence * frame.symmetryConfidence;
    frame.valid = true;
  }

  if (result.jawsShareFrame)
  {
    DentalJawFrame & joint = result.joint;
    const double     upperArea = jaws[0].samples.area;
    const double     lowerArea = jaws[1].samples.area;
    joint = result.upper;
    joint.axes[0] = Unit(Cross(joint.axes[1], Unit(result.upper.axes[2] + result.lower.axes[2])));
    joint.axes[2] = Cross(joint.axes[0], joint.axes[1]);
    joint.centroid =
      (1.0 / (upperArea + lowerArea)) * (upperArea * result.upper.centroid + lowerArea * result.lower.centroid);
    joint.origin = joint.centroid;
    joint.midlineOffset =
      0.5 * (result.upper.midlineOffset + Dot(joint.axes[1], result.upper.centroid - joint.centroid) +
             result.lower.midlineOffset + Dot(joint.axes[1], result.lower.centroid - joint.centroid));
    if (result.midsagittalUpper.valid)
    {
      joint.midlineOffset = result.midsagittalUpper.offset - Dot(joint.axes[1], joint.centroid);
      joint.origin = joint.centroid + joint.midlineOffset * joint.axes[1];
    }
    joint.confidence = std::min(result.upper.confidence, result.lower.confidence);
    result.overjet = Dot(result.upper.incisalEdge - result.lower.incisalEdge, joint.axes[0]);
    result.overbite = Dot(result.lower.incisalEdge - result.upper.incisalEdge, joint.axes[2]);
  }
  else if (result.upper.valid != result.lower.valid)
  {
    result.joint = result.upper.valid ? result.upper : result.lower;
  }
  return result;
}
} // namespace itk
