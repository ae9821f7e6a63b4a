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
#include "itkPoseReverseDirection.h"

#include "itkPoseContourIndex.h"
#include "itkPoseMatching.h"

#include <algorithm>
#include <cmath>

namespace itk
{
using namespace PoseMatching;

namespace
{
/** Place of the foot of the perpendicular along a segment's line: 0 at its first point, 1 at its second. */
double
PlaceAlong(const PoseTracing & tracing, std::size_t from, double u, double v)
{
  const double eu = tracing.u[from + 1] - tracing.u[from];
  const double ev = tracing.v[from + 1] - tracing.v[from];
  return ((u - tracing.u[from]) * eu + (v - tracing.v[from]) * ev) / (eu * eu + ev * ev);
}

/** Sample k of n: the middle of each n-th part of the contour. */
std::size_t
GetSample(std::size_t k, std::size_t n, const PoseContour & contour)
{
  return (2 * k + 1) * contour.Size() / (2 * n);
}
} // namespace

PoseReverseDirection::PoseReverseDirection(const PoseTracing & tracing, const Settings & settings)
  : m_Settings(settings)
{
  const std::size_t n = tracing.Size();
  for (const double weight : tracing.weight)
  {
    m_Weight += settings.weight * weight / static_cast<double>(n);
  }
  std::size_t first = 0;
  const auto  close = [&](std::size_t last) {
    for (; first < m_Segments.size(); ++first)
    {
      m_Segments[first].end = tracing.arc[last];
    }
  };
  double begin = 0.0;
  for (std::size_t i = 0; i + 1 < n; ++i)
  {
    const double length = tracing.arc[i + 1] - tracing.arc[i];
    const bool   between = std::find(tracing.runs.begin(), tracing.runs.end(), i + 1) != tracing.runs.end();
    if (between && !(length < settings.gapLength))
    {
      close(i);
      begin = tracing.arc[i + 1];
      continue;
    }
    const double nu = tracing.nu[i] + tracing.nu[i + 1];
    const double nv = tracing.nv[i] + tracing.nv[i + 1];
    const double size = std::hypot(nu, nv);
    if (length > 0.0 && size > 0.0)
    {
      const std::uint32_t allowed = settings.gateByTooth
                                      ? GetAllowedPositions(tracing.tooth[i], settings.toothRange) |
                                          GetAllowedPositions(tracing.tooth[i + 1], settings.toothRange)
                                      : ~0u;
      m_Segments.push_back({ i, nu / size, nv / size, begin, 0.0, allowed });
    }
  }
  if (n > 0)
  {
    close(n - 1);
  }
}

void
PoseReverseDirection::Match(const PoseTracing & tracing, const PoseContour & contour, Linearization & lin) const
{
  const double normalWeight2 = m_Settings.orientationWeight * m_Settings.orientationWeight;
  const auto   directions = PoseContourIndex::ComputeDirections(contour);
  for (std::size_t k = 0; k < lin.match.size(); ++k)
  {
    const std::size_t j = GetSample(k, lin.match.size(), contour);
    const auto &      direction = directions[j];
    const auto        position = contour.position.empty() ? ~0u : 1u << contour.position[j];
    double            best = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < m_Segments.size(); ++s)
    {
      const std::size_t i = m_Segments[s].from;
      if ((position & m_Segments[s].allowed) == 0)
      {
        continue;
      }
      const double t = std::min(1.0, std::max(0.0, PlaceAlong(tracing, i, contour.u[j], contour.v[j])));
      const double du = contour.u[j] - tracing.u[i] - t * (tracing.u[i + 1] - tracing.u[i]);
      const double dv = contour.v[j] - tracing.v[i] - t * (tracing.v[i + 1] - tracing.v[i]);
      const double cosine = direction[0] * m_Segments[s].nu + direction[1] * m_Segments[s].nv;
      const double d = du * du + dv * dv + normalWeight2 * (2.0 - 2.0 * cosine);
      if (d < best)
      {
        best = d;
        lin.match[k] = s;
        lin.facing[k] = normalWeight2 > 0.0 ? FacingWeight(cosine) : 1.0;
      }
    }
  }
}

PoseReverseDirection::Linearization
PoseReverseDirection::Linearize(const PoseTracing &   tracing,
                                const PoseModel &     model,
                                const PoseContour &   contour,
                                const Linearization * held) const
{
  const std::size_t n = tracing.Size();
  Linearization     lin;
  lin.residual.assign(n, 0.0);
  lin.squaredDistance.assign(n, 0.0);
  lin.facing.assign(n, 0.0);
  lin.taper.assign(n, 0.0);
  lin.match.assign(n, NoMatch);
  lin.jacobian.assign(7 * n, 0.0);
  lin.distanceJacobian.assign(7 * n, 0.0);
  lin.taperJacobian.assign(7 * n, 0.0);
  if (contour.Size() == 0)
  {
    return lin;
  }
  if (held != nullptr)
  {
    lin.match = held->match;
    lin.facing = held->facing;
  }
  else
  {
    this->Match(tracing, contour, lin);
  }
  for (std::size_t k = 0; k < n; ++k)
  {
    if (lin.match[k] == NoMatch)
    {
      continue;
    }
    const Segment &   segment = m_Segments[lin.match[k]];
    const std::size_t j = GetSample(k, n, contour);
    const std::size_t i = segment.from;
    const double      eu = tracing.u[i + 1] - tracing.u[i];
    const double      ev = tracing.v[i + 1] - tracing.v[i];
    const double      length = tracing.arc[i + 1] - tracing.arc[i];
    // The nearest point, or beside a corner the line's: a residual without a kink as long as the segment is held.
    const double t = PlaceAlong(tracing, i, contour.u[j], contour.v[j]);
    const double du = contour.u[j] - tracing.u[i] - t * eu;
    const double dv = contour.v[j] - tracing.v[i] - t * ev;
    const double along = segment.nu * dv - segment.nv * du;
    const double beyond = BeyondEnd(along);
    lin.residual[k] = segment.nu * du + segment.nv * dv;
    lin.squaredDistance[k] = lin.residual[k] * lin.residual[k] + beyond * beyond;
    // Censored: where the tracing ends, no more was drawn.
    const double toBegin = tracing.arc[i] + t * length - segment.begin;
    const double toEnd = segment.end - segment.begin - toBegin;
    const double reach = std::min(m_Settings.taperLength, 0.5 * (segment.end - segment.begin));
    const double nearest = std::min(toBegin, toEnd);
    const double part = std::min(1.0, std::max(0.0, reach > 0.0 ? nearest / reach : std::copysign(1.0, nearest)));
    lin.taper[k] = part * part * (3.0 - 2.0 * part);
    const double byPlace = reach > 0.0 ? 6.0 * part * (1.0 - part) / reach * (toBegin < toEnd ? 1.0 : -1.0) : 0.0;
    const double slope = 2.0 * std::copysign(beyond, along);
    double       jacobian[14];
    ComputeSampleJacobian(model, contour, j, jacobian);
    for (int a = 0; a < 7; ++a)
    {
      const double ju = jacobian[a];
      const double jv = jacobian[7 + a];
      const double jt = (ju * eu + jv * ev) / (eu * eu + ev * ev);
      const double jdu = ju - jt * eu;
      const double jdv = jv - jt * ev;
      lin.jacobian[7 * k + a] = segment.nu * jdu + segment.nv * jdv;
      lin.distanceJacobian[7 * k + a] =
        2.0 * lin.residual[k] * lin.jacobian[7 * k + a] + slope * (segment.nu * jdv - segment.nv * jdu);
      lin.taperJacobian[7 * k + a] = byPlace * jt * length;
    }
  }
  return lin;
}
} // namespace itk
