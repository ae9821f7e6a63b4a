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
#include "itkToothOutlineComparison.h"

#include "itkContourResampling.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>

namespace itk
{
namespace
{
using PointType = ToothOutlineComparison::PointType;
using LineType = ToothOutlineComparison::LineType;
/** A plane similarity and its points are complex numbers. */
using ComplexLine = std::vector<std::complex<double>>;

constexpr std::size_t FewestPoints = 8;
/** Points at equal distances along each line: of a tooth of 70 mm circumference half a millimetre. */
constexpr std::size_t NumberOfPoints = 128;
/** ClosestRounds in which each point finds the other line anew: they move the similarity by less than a micrometre
 * then. */
constexpr int ClosestRounds = 20;
/** mm: lines that are further apart where their points are paired by the length along each are not looked at closely.
 * Of one line the pairs are half a step, a quarter of a millimetre, apart at most. */
constexpr double GlanceDistance = 1.0;

double
ComputeArea(const LineType & line)
{
  double area = 0.0;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const PointType & a = line[i];
    const PointType & b = line[(i + 1) % line.size()];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return area;
}

/** At equal distances along a closed line, counter-clockwise about its centroid at 0; nothing where it is no line. */
std::optional<ComplexLine>
MakeComparable(const LineType & drawn, bool reflected)
{
  LineType line;
  for (const PointType & p : drawn)
  {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
    {
      return std::nullopt;
    }
    line.push_back({ { reflected ? -p[0] : p[0], p[1] } });
  }
  const double area = ComputeArea(line);
  if (line.size() < FewestPoints || !(std::abs(area) > 0.0))
  {
    return std::nullopt;
  }
  if (area < 0.0)
  {
    std::reverse(line.begin(), line.end());
  }
  ComplexLine          even;
  std::complex<double> middle;
  for (const ContourPosition & position : ResamplePolyline(line, true, NumberOfPoints))
  {
    const PointType & from = line[position.segment];
    const PointType & to = line[(position.segment + 1) % line.size()];
    even.emplace_back(from[0] + position.share * (to[0] - from[0]), from[1] + position.share * (to[1] - from[1]));
    middle += even.back() / static_cast<double>(NumberOfPoints);
  }
  for (auto & p : even)
  {
    p -= middle;
  }
  return even;
}

/** The place on a closed line that is closest to a point. */
std::complex<double>
FindClosest(const std::complex<double> & point, const ComplexLine & line)
{
  std::complex<double> closest;
  double               smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const std::complex<double> side = line[(i + 1) % line.size()] - line[i];
    const double               norm = std::norm(side);
    const double share = norm > 0.0 ? std::clamp(((point - line[i]) * std::conj(side)).real() / norm, 0.0, 1.0) : 0.0;
    const std::complex<double> place = line[i] + share * side;
    if (std::norm(point - place) < smallest)
    {
      smallest = std::norm(point - place);
      closest = place;
    }
  }
  return closest;
}

/** Moves the first points onto the second by the least-squares similarity of the pairs. */
void
MoveOnto(ComplexLine & first, const ComplexLine & second)
{
  const auto           n = static_cast<double>(first.size());
  std::complex<double> a;
  std::complex<double> b;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    a += first[i] / n;
    b += second[i] / n;
  }
  std::complex<double> cross;
  double               squares = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    cross += std::conj(first[i] - a) * (second[i] - b);
    squares += std::norm(first[i] - a);
  }
  for (auto & p : first)
  {
    p = b + cross / squares * (p - a);
  }
}

double
ComputeSpread(const ComplexLine & from, const ComplexLine & to)
{
  double squares = 0.0;
  for (const auto & p : from)
  {
    squares += std::norm(p - FindClosest(p, to)) / static_cast<double>(from.size());
  }
  return std::sqrt(squares);
}

double
Compare(ComplexLine first, const ComplexLine & second, double glance)
{
  // Where the second begins on the first: the shift along the lines with the largest correlation.
  double      largest = -1.0;
  std::size_t shift = 0;
  for (std::size_t s = 0; s < NumberOfPoints; ++s)
  {
    std::complex<double> correlation;
    for (std::size_t i = 0; i < NumberOfPoints; ++i)
    {
      correlation += std::conj(first[i]) * second[(i + s) % NumberOfPoints];
    }
    if (std::norm(correlation) > largest)
    {
      largest = std::norm(correlation);
      shift = s;
    }
  }
  ComplexLine partner = second;
  std::rotate(partner.begin(), partner.begin() + static_cast<std::ptrdiff_t>(shift), partner.end());
  MoveOnto(first, partner);
  double squares = 0.0;
  for (std::size_t i = 0; i < NumberOfPoints; ++i)
  {
    squares += std::norm(first[i] - partner[i]) / static_cast<double>(NumberOfPoints);
  }
  if (std::sqrt(squares) > glance)
  {
    return std::sqrt(squares);
  }
  for (int round = 0; round < ClosestRounds; ++round)
  {
    std::transform(
      first.begin(), first.end(), partner.begin(), [&](const auto & point) { return FindClosest(point, second); });
    MoveOnto(first, partner);
  }
  return std::max(ComputeSpread(first, second), ComputeSpread(second, first));
}

double
Compare(const LineType & first, const LineType & second, double glance)
{
  double     distance = std::numeric_limits<double>::infinity();
  const auto to = MakeComparable(second, false);
  for (const bool reflected : { false, true })
  {
    const auto from = MakeComparable(first, reflected);
    if (from && to)
    {
      distance = std::min(distance, Compare(*from, *to, glance));
    }
  }
  return distance;
}
} // namespace

double
ToothOutlineComparison::ComputeDistance(const LineType & first, const LineType & second)
{
  return Compare(first, second, std::numeric_limits<double>::infinity());
}

std::vector<ToothOutlineComparison::TemplateType>
ToothOutlineComparison::FindTemplates(const std::vector<OutlineType> & outlines, const std::vector<OutlineType> & stock)
{
  std::vector<TemplateType> templates;
  for (std::size_t i = 0; i < outlines.size(); ++i)
  {
    TemplateType closest{ outlines[i].name, "", LargestDistance };
    const auto   compare = [&](const OutlineType & other) {
      const double distance = Compare(other.points, outlines[i].points, GlanceDistance);
      if (distance <= closest.distance)
      {
        closest.distance = distance;
        closest.of = other.name;
      }
    };
    for (std::size_t j = 0; j < outlines.size(); ++j)
    {
      if (j != i)
      {
        compare(outlines[j]);
      }
    }
    std::for_each(stock.begin(), stock.end(), compare);
    if (!closest.of.empty())
    {
      templates.push_back(closest);
    }
  }
  return templates;
}
} // namespace itk
