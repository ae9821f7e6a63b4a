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
#include "itkDentalFrameIncisors.h"

#include "itkDentalFrameSamples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace itk
{
namespace DentalFrameKernel
{
namespace
{
/** Mesiodistal widths of central and lateral incisor, mm (Wheeler's Dental Anatomy). */
constexpr std::array<double, 2> UpperWidths{ { 8.5, 6.5 } };
constexpr std::array<double, 2> LowerWidths{ { 5.4, 5.9 } };
/** People's incisors differ by some 6 % (sd) in width. */
constexpr std::array<double, 5> WidthFactors{ { 0.90, 0.95, 1.0, 1.05, 1.1 } };
/** mm: how far the contact of the central incisors may lie from the midline, and the steps in which it is looked for.
 */
constexpr double MidlineRange = 2.5;
constexpr double MidlineStep = 0.25;
/** mm along the arch on either side of the midline that are compared, the bins' step and their width (sd). */
constexpr double      HalfLength = 12.0;
constexpr double      BinStep = 0.5;
constexpr double      BinSigma = 0.4;
constexpr std::size_t Bins = 49;
/** mm behind the incisal edge: the centre of the front's polar coordinates, and how far back surface is taken. */
constexpr double CentreBehind = 20.0;
constexpr double FrontDepth = 12.0;
/** mm below the edges of the teeth that the labial surface is taken from and to. */
constexpr double LabialFrom = 0.3;
constexpr double LabialTo = 5.5;
/** Least cosine between a triangle's normal and the direction outward: labial surfaces, not edges. */
constexpr double LeastOutward = 0.45;
/** Fewer triangles are no labial surface. */
constexpr std::size_t FewestTriangles = 100;
/** Terms of the curve r(theta) along the labial surfaces, a polynomial: it follows an arch and no single tooth. */
constexpr std::size_t CurveTerms = 5;
/** Least part of the median bin's area that a bin needs. */
constexpr double LeastBin = 0.05;

/** A triangle of the front, about the centre: direction, distance, height, and its normal's angle. */
struct Facet
{
  double theta;
  double radius;
  double height;
  double outward;
  double normalAngle;
  double area;
};

std::vector<Facet>
TakeFront(const TriangleSurface & surface, const FrontView & view)
{
  std::vector<Facet> facets;
  const Vector3      centre = view.edge - CentreBehind * view.anterior;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto &  corners = surface.triangles[t];
    const Vector3 d =
      (1.0 / 3.0) * (surface.points[corners[0]] + surface.points[corners[1]] + surface.points[corners[2]]) - centre;
    const double x = Dot(d, view.anterior);
    if (!(x > CentreBehind - FrontDepth))
    {
      continue;
    }
    const double  y = Dot(d, view.lateral);
    const Vector3 normal = surface.AreaNormal(t);
    const double  area = Norm(normal);
    if (!(area > 0.0))
    {
      continue;
    }
    const double sign = view.turned ? -1.0 : 1.0;
    const double nx = sign * Dot(normal, view.anterior) / area;
    const double ny = sign * Dot(normal, view.lateral) / area;
    Facet        facet{};
    facet.theta = std::atan2(y, x);
    facet.radius = std::hypot(x, y);
    facet.height = Dot(d, view.occlusal);
    facet.outward = nx * std::cos(facet.theta) + ny * std::sin(facet.theta);
    facet.normalAngle = std::atan2(ny, nx);
    facet.area = area;
    facets.push_back(facet);
  }
  return facets;
}

/** Keeps the labial surface: what faces outward in a band below the teeth's own edges, which are the 98th percentile of
 * heights in overlapping sectors. */
std::vector<Facet>
KeepLabial(const std::vector<Facet> & front)
{
  constexpr double      Step = 0.08; // 1.7 mm
  constexpr double      First = -1.6;
  constexpr std::size_t Sectors = 41;
  std::vector<double>   edges(Sectors, std::numeric_limits<double>::quiet_NaN());
  std::size_t           known = 0;
  for (std::size_t s = 0; s < Sectors; ++s)
  {
    std::vector<double> heights;
    for (const Facet & facet : front)
    {
      if (std::abs(facet.theta - (First + Step * static_cast<double>(s))) < Step)
      {
        heights.push_back(facet.height);
      }
    }
    if (heights.size() > 5)
    {
      edges[s] = Quantile(std::move(heights), 0.98);
      ++known;
    }
  }
  std::vector<Facet> labial;
  if (known < 8)
  {
    return labial;
  }
  // A crown's edge is where its neighbours' are: the mean of the known ones among five.
  std::vector<double> smooth(Sectors);
  for (std::size_t s = 0; s < Sectors; ++s)
  {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t k = s < 2 ? 0 : s - 2; k < std::min(Sectors, s + 3); ++k)
    {
      if (!std::isnan(edges[k]))
      {
        sum += edges[k];
        count += 1.0;
      }
    }
    smooth[s] = count > 0.0 ? sum / count : -std::numeric_limits<double>::infinity();
  }
  for (const Facet & facet : front)
  {
    const double at = std::clamp((facet.theta - First) / Step, 0.0, static_cast<double>(Sectors - 1) - 1e-9);
    const auto   s = static_cast<std::size_t>(at);
    const double part = at - static_cast<double>(s);
    const double depth = (1.0 - part) * smooth[s] + part * smooth[s + 1] - facet.height;
    if (depth > LabialFrom && depth < LabialTo && facet.outward > LeastOutward)
    {
      labial.push_back(facet);
    }
  }
  return labial;
}

using Curve = std::array<double, CurveTerms>;

double
RadiusAt(const Curve & curve, double theta)
{
  double radius = 0.0;
  for (std::size_t k = CurveTerms; k-- > 0;)
  {
    radius = radius * theta + curve[k];
  }
  return radius;
}

double
SlopeAt(const Curve & curve, double theta)
{
  double slope = 0.0;
  for (std::size_t k = CurveTerms; k-- > 1;)
  {
    slope = slope * theta + static_cast<double>(k) * curve[k];
  }
  return slope;
}

/** The curve on the outermost of the labial surface; what lies inward of it (embrasures, a tooth behind the others)
 * counts less. */
bool
FitCurve(const std::vector<Facet> & labial, Curve & curve)
{
  for (unsigned int round = 0; round < 4; ++round)
  {
    std::array<std::array<double, CurveTerms>, CurveTerms> a{};
    Curve                                                  b{};
    for (const Facet & facet : labial)
    {
      double weight = facet.area;
      if (round > 0)
      {
        const double residual = facet.radius - RadiusAt(curve, facet.theta);
        const double z = residual < 0.0 ? residual / 1.0 : residual / 1.5; // mm
        weight *= std::exp(-0.5 * z * z);
      }
      Curve powers{ { 1.0 } };
      for (std::size_t k = 1; k < CurveTerms; ++k)
      {
        powers[k] = powers[k - 1] * facet.theta;
      }
      for (std::size_t p = 0; p < CurveTerms; ++p)
      {
        b[p] += weight * powers[p] * facet.radius;
        for (std::size_t q = 0; q <= p; ++q)
        {
          a[p][q] += weight * powers[p] * powers[q];
        }
      }
    }
    if (!SolveSymmetric(a, b))
    {
      return false;
    }
    curve = b;
  }
  return true;
}

/** mm along the curve from the midline to an angle. */
class ArcLength
{
public:
  explicit ArcLength(const Curve & curve)
  {
    for (std::size_t i = 1; i < m_Lengths.size(); ++i)
    {
      const double theta = From + Step * (static_cast<double>(i) - 0.5);
      m_Lengths[i] = m_Lengths[i - 1] + Step * std::hypot(RadiusAt(curve, theta), SlopeAt(curve, theta));
    }
    const double middle = m_Lengths[m_Lengths.size() / 2];
    for (double & length : m_Lengths)
    {
      length -= middle;
    }
  }

  double
  operator()(double theta) const
  {
    const double at = std::clamp((theta - From) / Step, 0.0, static_cast<double>(m_Lengths.size() - 1) - 1e-9);
    const auto   i = static_cast<std::size_t>(at);
    const double part = at - static_cast<double>(i);
    return (1.0 - part) * m_Lengths[i] + part * m_Lengths[i + 1];
  }

private:
  static constexpr double From = -1.6;
  static constexpr double Step = 0.005;
  std::array<double, 641> m_Lengths{};
};

using Profile = std::array<double, Bins>;

double
PlaceOf(std::size_t bin)
{
  return BinStep * static_cast<double>(bin) - HalfLength;
}

/** The mean angle between the surface's normal and the curve's along the arch, radians. */
bool
SwingAlongArch(const std::vector<Facet> & labial, const Curve & curve, Profile & swing)
{
  const ArcLength arc(curve);
  Profile         areas{};
  swing.fill(0.0);
  for (const Facet & facet : labial)
  {
    const double residual = facet.radius - RadiusAt(curve, facet.theta);
    // The outward normal of r(theta).
    const double along = std::atan2(SlopeAt(curve, facet.theta), RadiusAt(curve, facet.theta));
    const double angle = std::remainder(facet.normalAngle - (facet.theta - along), 2.0 * Pi);
    if (residual < -2.5 || std::abs(angle) > 1.2)
    {
      continue;
    }
    const double place = arc(facet.theta);
    for (std::size_t bin = 0; bin < Bins; ++bin)
    {
      const double z = (place - PlaceOf(bin)) / BinSigma;
      if (std::abs(z) < 4.0)
      {
        const double weight = facet.area * std::exp(-0.5 * z * z);
        areas[bin] += weight;
        swing[bin] += weight * angle;
      }
    }
  }
  const double median = Quantile(std::vector<double>(areas.begin(), areas.end()), 0.5);
  if (!(median > 0.0))
  {
    return false;
  }
  for (std::size_t bin = 0; bin < Bins; ++bin)
  {
    swing[bin] = areas[bin] > LeastBin * median ? swing[bin] / areas[bin] : 0.0;
  }
  return true;
}

/** Correlation of two profiles; 0 where one of them is flat. */
double
Correlation(const Profile & first, const Profile & second)
{
  double firstMean = 0.0;
  double secondMean = 0.0;
  for (std::size_t bin = 0; bin < Bins; ++bin)
  {
    firstMean += first[bin] / static_cast<double>(Bins);
    secondMean += second[bin] / static_cast<double>(Bins);
  }
  double product = 0.0;
  double firstSquares = 0.0;
  double secondSquares = 0.0;
  for (std::size_t bin = 0; bin < Bins; ++bin)
  {
    const double x = first[bin] - firstMean;
    const double y = second[bin] - secondMean;
    product += x * y;
    firstSquares += x * x;
    secondSquares += y * y;
  }
  const double norm = std::sqrt(firstSquares * secondSquares);
  return norm > 0.0 ? product / norm : 0.0;
}

/** The best correlation with four incisors of these widths, on each of which the angle goes from -1 to 1. */
double
BestMatch(const Profile & swing, const std::array<double, 2> & widths)
{
  double best = -1.0;
  for (const double factor : WidthFactors)
  {
    const double central = factor * widths[0];
    const double both = central + factor * widths[1];
    for (double midline = -MidlineRange; midline <= MidlineRange + 1e-9; midline += MidlineStep)
    {
      Profile expected{};
      for (std::size_t bin = 0; bin < Bins; ++bin)
      {
        const double from = PlaceOf(bin) - midline;
        const double away = std::abs(from);
        if (away < both)
        {
          // From its mesial to its distal end.
          const double onTooth = away < central ? away / central : (away - central) / (both - central);
          expected[bin] = (from < 0.0 ? -1.0 : 1.0) * (2.0 * onTooth - 1.0);
        }
      }
      best = std::max(best, Correlation(swing, expected));
    }
  }
  return best;
}
} // namespace

std::optional<double>
IncisorContrast(const TriangleSurface & surface, const FrontView & view)
{
  const std::vector<Facet> labial = KeepLabial(TakeFront(surface, view));
  Curve                    curve{};
  Profile                  swing{};
  if (labial.size() < FewestTriangles || !FitCurve(labial, curve) || !SwingAlongArch(labial, curve, swing))
  {
    return std::nullopt;
  }
  return BestMatch(swing, LowerWidths) - BestMatch(swing, UpperWidths);
}
} // namespace DentalFrameKernel
} // namespace itk
