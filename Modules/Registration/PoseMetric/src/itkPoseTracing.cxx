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
#include "itkPoseTracing.h"

#include "itkIsoContourTracer.h"
#include "itkOpenSilhouette.h"
#include "itkPoseModel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
using Point2 = std::array<double, 2>;

/** px: a tracing's direction at a point is that of a line fitted to its neighbours with this sigma. Hands jitter by up
 * to a pixel from point to point, and a tooth's outline turns over some ten; the moving contour's directions are
 * smoothed alike (PoseContourIndex), so that both are compared at one scale. */
constexpr double DirectionSigma = 5.0;
/** px along the tracing beyond which neighbours weigh nothing: three sigma. */
constexpr double DirectionReach = 15.0;
/** Weight of a lone polyline's direction beside the lengths of gaps, px: it breaks a tie and decides nothing else. */
constexpr double TieBreak = 1e-3;

/** px of 0.25 mm: what a hand's jitter is where the file does not say it (ContourNoiseLevels). A sigma of the file
 * stands in its place: the jitter's variance is divided by the weight. */
constexpr double UsualSigma = 0.6;
/** Weight of the best hand: below half a usual error it is the outline of the scan that is wrong, not the hand. */
constexpr double LargestWeight = 4.0;

/** The weight of a point by what the file says of it; scale: px of 0.25 mm in a pixel. */
double
ComputeWeight(const DentalContour::PolylineType & polyline, std::size_t i, double scale)
{
  const double weight = polyline.weights.empty() ? 1.0 : polyline.weights[i];
  const double sigma = polyline.sigmas.empty() ? 0.0 : scale * polyline.sigmas[i];
  return sigma > 0.0 ? weight * std::min(LargestWeight, UsualSigma * UsualSigma / (sigma * sigma)) : weight;
}

/** px of 0.25 mm: how far apart two crowns of a row may be drawn whose sides face each other. What is drawn there is
 * the side of a tooth that its neighbour hides, where the scan's outline has nothing. */
constexpr double ContactReach = 4.0;
/** Steps of a half and then whole px along an outward normal: label maps give both teeth the very same border. */
constexpr double ContactStart = 0.5;
/** More closed outlines of one jaw than both dentitions have teeth are no row of teeth: contacts aren't looked for. */
constexpr std::size_t MaximumOutlines = 52;
/** Corners of a crown by which it is asked whether a point lies in it: fewer than a pixel apart are not needed. */
constexpr std::size_t MaximumCorners = 400;

struct Strand
{
  std::vector<Point2> points;
  std::vector<double> weights;
  std::uint8_t        tooth{ 0 };
  Point2              centroid{ { 0, 0 } };
};

double
Distance(const Point2 & a, const Point2 & b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/** A closed outline as it was drawn: its corners, thinned, in the box that holds them. */
struct ClosedOutline
{
  explicit ClosedOutline(const Strand & strand)
    : tooth(strand.tooth)
  {
    const std::size_t step = (strand.points.size() + MaximumCorners - 1) / MaximumCorners;
    for (std::size_t i = 0; i < strand.points.size(); i += step)
    {
      const Point2 & p = strand.points[i];
      corners.push_back(p);
      for (int k = 0; k < 2; ++k)
      {
        lower[k] = std::min(lower[k], p[k]);
        upper[k] = std::max(upper[k], p[k]);
      }
    }
  }

  bool
  Holds(const Point2 & p) const
  {
    return p[0] >= lower[0] && p[0] <= upper[0] && p[1] >= lower[1] && p[1] <= upper[1] && IsInsideLoop(corners, p);
  }

  std::vector<Point2> corners;
  Point2              lower{ { std::numeric_limits<double>::max(), std::numeric_limits<double>::max() } };
  Point2              upper{ { std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest() } };
  std::uint8_t        tooth;
};

/** Whether a point of a tooth's outline faces another tooth beside it, or lies in it: there is no edge of the row. */
bool
FacesNeighbour(const Point2 &                     point,
               const Point2 &                     normal,
               std::size_t                        own,
               const std::vector<ClosedOutline> & outlines)
{
  for (std::size_t k = 0; k < outlines.size(); ++k)
  {
    // A tooth that was drawn in two parts, or twice, is no neighbour of itself.
    if (k == own || (outlines[k].tooth != 0 && outlines[k].tooth == outlines[own].tooth))
    {
      continue;
    }
    for (double t = ContactStart; t < ContactReach; t += 1.0)
    {
      if (outlines[k].Holds({ { point[0] + t * normal[0], point[1] + t * normal[1] } }))
      {
        return true;
      }
    }
  }
  return false;
}

/** The part of a closed polyline that can lie on the open moving contour, as one open polyline: what faces the right
 * way, and no neighbour. outlines: all closed ones of the jaw, of which the one at own is this. */
void
OpenClosedPolyline(Strand &                           strand,
                   std::size_t                        own,
                   const std::vector<ClosedOutline> & outlines,
                   ToothCode::JawEnum                 jaw,
                   CephalometricDirectionEnum         direction)
{
  const std::size_t n = strand.points.size();
  if (n < 3)
  {
    return;
  }
  double area = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point2 & a = strand.points[i];
    const Point2 & b = strand.points[(i + 1) % n];
    area += a[0] * b[1] - a[1] * b[0];
  }
  const double      sign = area > 0.0 ? 1.0 : -1.0;
  const bool        isRow = outlines.size() > 1 && outlines.size() <= MaximumOutlines;
  std::vector<char> keep(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point2 & a = strand.points[(i + n - 1) % n];
    const Point2 & b = strand.points[(i + 1) % n];
    const double   length = std::max(Distance(a, b), 1e-12);
    const Point2   normal{ { sign * (b[1] - a[1]) / length, -sign * (b[0] - a[0]) / length } };
    keep[i] = CanBeTraced(normal[0], normal[1], jaw, direction) &&
              !(isRow && FacesNeighbour(strand.points[i], normal, own, outlines));
  }
  // Cut behind the longest run of points that do not face the right way; twice around, so that a run over the first
  // point is one.
  std::size_t best = 0, bestLength = 0, run = 0;
  for (std::size_t i = 0; i < 2 * n; ++i)
  {
    run = keep[i % n] ? 0 : std::min(run + 1, n);
    if (run > bestLength)
    {
      bestLength = run;
      best = (i + 1) % n;
    }
  }
  Strand open;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = (best + i) % n;
    if (keep[j])
    {
      open.points.push_back(strand.points[j]);
      open.weights.push_back(strand.weights[j]);
    }
  }
  strand.points.swap(open.points);
  strand.weights.swap(open.weights);
}

/** Every k-th point, so that at most maximum are left in the jaw; the white noise of neighbours averages out anyway. */
void
Thin(std::vector<Strand> & strands, unsigned int maximum)
{
  std::size_t count = 0;
  for (const Strand & strand : strands)
  {
    count += strand.points.size();
  }
  if (maximum == 0 || count <= maximum)
  {
    return;
  }
  const std::size_t step = (count + maximum - 1) / maximum;
  for (Strand & strand : strands)
  {
    Strand thin;
    // Centred, so that neither end is favoured.
    for (std::size_t i = ((strand.points.size() - 1) % step) / 2; i < strand.points.size(); i += step)
    {
      thin.points.push_back(strand.points[i]);
      thin.weights.push_back(strand.weights[i]);
    }
    strand.points.swap(thin.points);
    strand.weights.swap(thin.weights);
  }
}
} // namespace

PoseTracing::PoseTracing(const PoseGeometry &                 geometry,
                         const DentalContour::PolylinesType & polylines,
                         ToothCode::JawEnum                   jaw,
                         unsigned int                         maximumPoints)
{
  std::vector<Strand>        strands;
  std::vector<std::size_t>   closed;
  std::vector<ClosedOutline> outlines;
  for (const DentalContour::PolylineType & polyline : polylines)
  {
    if (polyline.points.empty())
    {
      continue;
    }
    Strand strand;
    strand.tooth = polyline.code.GetFDI();
    const double scale = 0.5 * (geometry.pixelSpacing[0] + geometry.pixelSpacing[1]) / PoseWorkingPixel;
    for (std::size_t i = 0; i < polyline.points.size(); ++i)
    {
      const auto & pixel = polyline.points[i];
      strand.points.push_back(PoseModel::ToWorkingPlane(geometry, { { pixel[0], pixel[1] } }));
      strand.weights.push_back(ComputeWeight(polyline, i, scale));
    }
    if (polyline.closed)
    {
      closed.push_back(strands.size());
      outlines.emplace_back(strand);
    }
    strands.push_back(std::move(strand));
  }
  for (std::size_t k = 0; k < closed.size(); ++k)
  {
    OpenClosedPolyline(strands[closed[k]], k, outlines, jaw, geometry.direction);
  }
  strands.erase(
    std::remove_if(strands.begin(), strands.end(), [](const Strand & strand) { return strand.points.empty(); }),
    strands.end());
  if (strands.empty())
  {
    return;
  }
  for (Strand & strand : strands)
  {
    for (const Point2 & p : strand.points)
    {
      strand.centroid[0] += p[0] / strand.points.size();
      strand.centroid[1] += p[1] / strand.points.size();
    }
    for (std::size_t i = 1; i < strand.points.size(); ++i)
    {
      length += Distance(strand.points[i - 1], strand.points[i]);
    }
  }
  // From front to back, or of a frontal picture from side to side, where codes of both sides meet at the midline.
  const bool isLateral = geometry.direction == CephalometricDirectionEnum::Lateral;
  const bool coded =
    isLateral && std::all_of(strands.begin(), strands.end(), [](const Strand & s) { return s.tooth != 0; });
  std::stable_sort(strands.begin(), strands.end(), [coded](const Strand & a, const Strand & b) {
    if (coded && a.tooth % 10 != b.tooth % 10)
    {
      return a.tooth % 10 < b.tooth % 10;
    }
    return a.centroid[0] > b.centroid[0];
  });

  // Directions by dynamic programming over (as is, reversed). The first link prefers the front end first.
  const std::size_t                  count = strands.size();
  std::vector<std::array<double, 2>> best(count);
  std::vector<std::array<int, 2>>    from(count);
  const auto first = [](const Strand & s, int r) { return r ? s.points.back() : s.points.front(); };
  const auto last = [](const Strand & s, int r) { return r ? s.points.front() : s.points.back(); };
  for (std::size_t i = 0; i < count; ++i)
  {
    for (int r = 0; r < 2; ++r)
    {
      best[i][r] = 0.0;
      if (i == 0)
      {
        best[i][r] = TieBreak * (last(strands[0], r)[0] - first(strands[0], r)[0]);
        from[i][r] = 0;
        continue;
      }
      best[i][r] = std::numeric_limits<double>::max();
      for (int q = 0; q < 2; ++q)
      {
        const double cost = best[i - 1][q] + Distance(last(strands[i - 1], q), first(strands[i], r));
        if (cost < best[i][r])
        {
          best[i][r] = cost;
          from[i][r] = q;
        }
      }
    }
  }
  int reversed = best[count - 1][0] <= best[count - 1][1] ? 0 : 1;
  for (std::size_t i = count; i-- > 0;)
  {
    const int previous = from[i][reversed];
    if (reversed)
    {
      std::reverse(strands[i].points.begin(), strands[i].points.end());
      std::reverse(strands[i].weights.begin(), strands[i].weights.end());
    }
    reversed = previous;
  }
  Thin(strands, maximumPoints);

  for (const Strand & strand : strands)
  {
    runs.push_back(u.size());
    for (std::size_t i = 0; i < strand.points.size(); ++i)
    {
      const Point2 & p = strand.points[i];
      arc.push_back(u.empty() ? 0.0 : arc.back() + std::hypot(p[0] - u.back(), p[1] - v.back()));
      u.push_back(p[0]);
      v.push_back(p[1]);
      weight.push_back(strand.weights[i]);
      tooth.push_back(strand.tooth);
    }
  }
  const bool        upper = jaw == ToothCode::JawEnum::Upper;
  const std::size_t n = u.size();
  nu.resize(n);
  nv.resize(n);
  double outward = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    // Slopes of u and v over arc length.
    double sw = 0, ss = 0, sss = 0, su = 0, sv = 0, ssu = 0, ssv = 0;
    for (std::size_t j = 0; j < n; ++j)
    {
      const double d = arc[j] - arc[i];
      if (std::abs(d) > DirectionReach)
      {
        continue;
      }
      const double w = std::exp(-d * d / (2.0 * DirectionSigma * DirectionSigma));
      sw += w;
      ss += w * d;
      sss += w * d * d;
      su += w * u[j];
      sv += w * v[j];
      ssu += w * d * u[j];
      ssv += w * d * v[j];
    }
    double       tu = sw * ssu - ss * su;
    double       tv = sw * ssv - ss * sv;
    const double size = std::hypot(tu, tv);
    if (size > 1e-12)
    {
      tu /= size;
      tv /= size;
    }
    else
    {
      tu = -1.0;
      tv = 0.0;
    }
    nu[i] = upper ? tv : -tv;
    nv[i] = upper ? -tu : tu;
    outward += (isLateral ? nu[i] : 0.0) + (upper ? nv[i] : -nv[i]);
    centroid[0] += u[i] / n;
    centroid[1] += v[i] / n;
  }
  // Occlusal or anterior: a labial border alone may face apically where the incisors lean forward. In a frontal picture
  // occlusal or away from the middle.
  for (std::size_t i = 0; !isLateral && i < n; ++i)
  {
    outward += u[i] >= centroid[0] ? nu[i] : -nu[i];
  }
  if (outward < 0.0)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      nu[i] = -nu[i];
      nv[i] = -nv[i];
    }
  }
}
} // namespace itk
