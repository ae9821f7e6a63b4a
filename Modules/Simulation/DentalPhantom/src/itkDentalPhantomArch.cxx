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
#include "itkDentalPhantomArch.h"

#include "itkDentalPhantomMath.h"

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
constexpr double ArchStep = 0.05;
constexpr double ArchLength = 90.0;
} // namespace

double
DentalPhantomArch::HalfLength(const DentalPhantomParameters & parameters, unsigned int jaw, unsigned int side)
{
  double sum = 0.0;
  for (unsigned int k = 0; k < 7; ++k)
  {
    const DentalPhantomTooth & tooth = parameters.jaws[jaw].teeth[7 * side + k];
    sum += tooth.mesiodistal + tooth.mesialGap;
  }
  return sum;
}

DentalPhantomArch::DentalPhantomArch(const DentalPhantomParameters & parameters)
{
  const double p = parameters.archExponent;
  const double power = 2.0 / p;
  const double coverage = parameters.archCoverage;
  const double width = parameters.archHalfWidth / std::pow(std::sin(coverage), power);
  const double length = 0.5 * (HalfLength(parameters, 0, 0) + HalfLength(parameters, 0, 1));

  constexpr unsigned int             samples = 6000;
  std::vector<std::array<double, 2>> unit(samples + 1);
  for (unsigned int i = 0; i <= samples; ++i)
  {
    // Cubic steps: an exponent above 2 moves fast near the midline.
    const double t = static_cast<double>(i) / samples;
    const double angle = coverage * t * t;
    unit[i] = { { std::pow(std::cos(angle), power), std::pow(std::sin(angle), power) } };
  }
  const auto measure = [&](double depth) {
    double sum = 0.0;
    for (unsigned int i = 1; i <= samples; ++i)
    {
      const double dx = depth * (unit[i][0] - unit[i - 1][0]);
      const double dy = width * (unit[i][1] - unit[i - 1][1]);
      sum += std::sqrt(dx * dx + dy * dy);
    }
    return sum;
  };
  double low = 5.0;
  double high = 150.0;
  for (unsigned int i = 0; i < 50; ++i)
  {
    const double middle = 0.5 * (low + high);
    (measure(middle) < length ? low : high) = middle;
  }
  const double depth = 0.5 * (low + high);

  // The molars' ends lie at x = 0, the front at positive x; straight on behind them.
  std::vector<std::array<double, 2>> upper;
  for (unsigned int i = 0; i <= samples; ++i)
  {
    upper.push_back({ { depth * (unit[i][0] - unit[samples][0]), width * unit[i][1] } });
  }
  std::array<double, 2> direction = { { upper[samples][0] - upper[samples - 20][0],
                                        upper[samples][1] - upper[samples - 20][1] } };
  const double          norm = std::hypot(direction[0], direction[1]);
  const auto            end = upper.back();
  upper.push_back({ { end[0] + 60.0 * direction[0] / norm, end[1] + 60.0 * direction[1] / norm } });

  const auto resample = [](const std::vector<std::array<double, 2>> & line, Line & jaw) {
    jaw.curve.clear();
    double      next = 0.0;
    double      done = 0.0;
    std::size_t i = 1;
    while (next <= ArchLength)
    {
      double segment = std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
      while (done + segment < next && i + 1 < line.size())
      {
        done += segment;
        ++i;
        segment = std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
      }
      const double t = segment > 0.0 ? (next - done) / segment : 0.0;
      jaw.curve.push_back(
        { { line[i - 1][0] + t * (line[i][0] - line[i - 1][0]), line[i - 1][1] + t * (line[i][1] - line[i - 1][1]) } });
      next += ArchStep;
    }
    const int n = static_cast<int>(jaw.curve.size());
    jaw.normals.resize(jaw.curve.size());
    // A wide window: the normals guide a grid, they need not follow every bend.
    constexpr int window = 60;
    const auto    at = [&](int k) {
      std::array<double, 2> q = jaw.curve[std::min(std::abs(k), n - 1)];
      if (k < 0)
      {
        q[1] = -q[1];
      }
      return q;
    };
    for (int k = 0; k < n; ++k)
    {
      const auto   a = at(k - window);
      const auto   b = at(std::min(k + window, n - 1));
      const double tx = b[0] - a[0];
      const double ty = b[1] - a[1];
      const double l = std::hypot(tx, ty);
      jaw.normals[k] = { { ty / l, -tx / l } };
    }
  };
  resample(upper, m_Lines[0]);

  // The lower arch runs inside the upper one: by the overjet in front, half a cusp at the side.
  const double                       posterior = 0.23 * parameters.jaws[0].teeth[5].buccolingual;
  std::vector<std::array<double, 2>> lower;
  for (std::size_t k = 0; k < m_Lines[0].curve.size(); ++k)
  {
    const double s = k * ArchStep;
    const double inward = parameters.overjet + (posterior - parameters.overjet) * SmoothStep(8.0, 28.0, s);
    const auto & q = m_Lines[0].curve[k];
    const auto & n = m_Lines[0].normals[k];
    lower.push_back({ { q[0] - inward * n[0], k == 0 ? 0.0 : q[1] - inward * n[1] } });
  }
  resample(lower, m_Lines[1]);
}

void
DentalPhantomArch::GetPoint(unsigned int jaw, double s, double point[2], double normal[2]) const
{
  const Line &      arch = m_Lines[jaw];
  const double      t = std::abs(s) / ArchStep;
  const std::size_t k = std::min(static_cast<std::size_t>(t), arch.curve.size() - 2);
  const double      a = t - static_cast<double>(k);
  const double      sign = s < 0.0 ? -1.0 : 1.0;
  for (unsigned int d = 0; d < 2; ++d)
  {
    point[d] = arch.curve[k][d] + a * (arch.curve[k + 1][d] - arch.curve[k][d]);
    normal[d] = arch.normals[k][d] + a * (arch.normals[k + 1][d] - arch.normals[k][d]);
  }
  const double l = std::hypot(normal[0], normal[1]);
  normal[0] /= l;
  normal[1] *= sign / l;
  point[1] *= sign;
}
} // namespace itk
