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
#include "itkDentalFrameArch.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace DentalFrameKernel
{
namespace
{
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
} // namespace

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

Arch
FitArch(const Samples &                samples,
        const Vertical &               vertical,
        ToothCode::JawEnum             jaw,
        const MidsagittalPlaneResult & mirror,
        const Vector3 *                givenLateral)
{
  Arch          arch;
  const Vector3 superior = jaw == ToothCode::JawEnum::Upper ? -1.0 * vertical.direction : vertical.direction;
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
} // namespace DentalFrameKernel
} // namespace itk
