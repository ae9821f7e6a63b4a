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
#ifndef itkPoseContourIndex_h
#define itkPoseContourIndex_h

#include "itkPoseContour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace itk
{
/** Contour samples in buckets along u, for the oriented nearest neighbour.
 *
 * The directions that are compared are those of the contour smoothed as the tracing's are (PoseTracing fits lines over
 * some 12 px): in the notch between two teeth a tracing's direction turns slowly, and against the contour's own it
 * would match beside the notch. */
class PoseContourIndex
{
public:
  explicit PoseContourIndex(const PoseContour & contour)
  {
    const std::size_t n = contour.Size();
    if (n == 0)
    {
      return;
    }
    m_Direction = ComputeDirections(contour);
    m_Low = *std::min_element(contour.u.begin(), contour.u.end());
    const double high = *std::max_element(contour.u.begin(), contour.u.end());
    m_Buckets = static_cast<int>((high - m_Low) / Width) + 1;
    m_Start.assign(m_Buckets + 1, 0);
    std::vector<int> bucket(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      bucket[i] = std::min(m_Buckets - 1, static_cast<int>((contour.u[i] - m_Low) / Width));
      ++m_Start[bucket[i] + 1];
    }
    for (int b = 0; b < m_Buckets; ++b)
    {
      m_Start[b + 1] += m_Start[b];
    }
    std::vector<std::size_t> next(m_Start.begin(), m_Start.end() - 1);
    m_Sample.resize(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t   k = next[bucket[i]]++;
      const std::uint32_t position = contour.position.empty() ? 1u : 1u << contour.position[i];
      m_Sample[k] = { contour.u[i], contour.v[i], m_Direction[i][0], m_Direction[i][1], i, position };
    }
  } /**< The contour is not kept. */

  /** Smoothed unit normals: of tangents between the means of the samples behind and before, by running sums; the ends
   * of a run have what is there. */
  static std::vector<std::array<double, 2>>
  ComputeDirections(const PoseContour & contour)
  {
    const std::size_t                  n = contour.Size();
    std::vector<std::array<double, 2>> directions(n);
    std::vector<std::array<double, 2>> sum(n + 1, { { 0.0, 0.0 } });
    for (std::size_t i = 0; i < n; ++i)
    {
      sum[i + 1] = { { sum[i][0] + contour.u[i], sum[i][1] + contour.v[i] } };
    }
    for (std::size_t r = 0; r < contour.runs.size(); ++r)
    {
      const std::size_t begin = contour.runs[r];
      const std::size_t end = r + 1 < contour.runs.size() ? contour.runs[r + 1] : n;
      // On which side of the run's direction its normals are.
      double side = 0.0;
      for (std::size_t i = begin; i + 1 < end; ++i)
      {
        side += (contour.v[i + 1] - contour.v[i]) * contour.nu[i] - (contour.u[i + 1] - contour.u[i]) * contour.nv[i];
      }
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::size_t first = i >= begin + Reach ? i - Reach : begin;
        const std::size_t last = std::min(end, i + Reach + 1);
        const double      before = static_cast<double>(i + 1 - first);
        const double      behind = static_cast<double>(last - i);
        const double      tu = (sum[last][0] - sum[i][0]) / behind - (sum[i + 1][0] - sum[first][0]) / before;
        const double      tv = (sum[last][1] - sum[i][1]) / behind - (sum[i + 1][1] - sum[first][1]) / before;
        const double      length = std::copysign(std::hypot(tu, tv), side);
        directions[i] = { { contour.nu[i], contour.nv[i] } };
        if (std::abs(length) > 1e-9)
        {
          directions[i] = { { tv / length, -tu / length } };
        }
      }
    }
    return directions;
  }

  /** Smoothed unit normal of a sample. */
  const std::array<double, 2> &
  GetDirection(std::size_t sample) const
  {
    return m_Direction[sample];
  }
  /** Whether there is nothing to find. */
  bool
  Empty() const
  {
    return m_Sample.empty();
  }

  /** The sample with the smallest du^2 + dv^2 + normalWeight2 |difference of the directions|^2. */
  std::size_t
  Nearest(double u, double v, double nu, double nv, double normalWeight2) const
  {
    return this->Search<false>(u, v, nu, nv, normalWeight2, 0);
  }

  /** The same among the samples whose tooth's position (PoseContour) has its bit set in `allowed`; None without one. */
  std::size_t
  NearestAllowed(double u, double v, double nu, double nv, double normalWeight2, std::uint32_t allowed) const
  {
    return this->Search<true>(u, v, nu, nv, normalWeight2, allowed);
  }
  /** Index of no sample: none is near enough, or none may be matched. */
  static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();

private:
  template <bool VGated>
  std::size_t
  Search(double u, double v, double nu, double nv, double normalWeight2, std::uint32_t allowed) const
  {
    const int   centre = std::min(m_Buckets - 1, std::max(0, static_cast<int>((u - m_Low) / Width)));
    double      best = std::numeric_limits<double>::infinity();
    std::size_t index = None;
    const auto  scan = [&](int b) {
      for (std::size_t k = m_Start[b]; k < m_Start[b + 1]; ++k)
      {
        const Sample & s = m_Sample[k];
        if (VGated && (s.position & allowed) == 0)
        {
          continue;
        }
        const double du = s.u - u;
        const double dv = s.v - v;
        const double d = du * du + dv * dv + normalWeight2 * (2.0 - 2.0 * (s.nu * nu + s.nv * nv));
        if (d < best || (d == best && s.index < index))
        {
          best = d;
          index = s.index;
        }
      }
    };
    scan(centre);
    for (int step = 1; step < m_Buckets; ++step)
    {
      // Distance along u to the nearer side of the next buckets.
      const int    left = centre - step;
      const int    right = centre + step;
      const double dl = u - (m_Low + (left + 1) * Width);
      const double dr = m_Low + right * Width - u;
      const bool   useLeft = left >= 0 && (dl <= 0.0 || dl * dl <= best);
      const bool   useRight = right < m_Buckets && (dr <= 0.0 || dr * dr <= best);
      if (useLeft)
      {
        scan(left);
      }
      if (useRight)
      {
        scan(right);
      }
      if (!useLeft && !useRight)
      {
        break;
      }
    }
    return index;
  }

  static constexpr double Width = 8.0;
  /** Samples to either side: with 0.5 px between them 12 px, whose mean distance is that of a line fit of sigma 5 px.
   */
  static constexpr std::size_t Reach = 24;
  struct Sample
  {
    double      u, v, nu, nv;
    std::size_t index;
    /** One bit. */
    std::uint32_t position;
  };
  double                   m_Low{ 0.0 };
  int                      m_Buckets{ 0 };
  std::vector<std::size_t> m_Start;
  std::vector<Sample>      m_Sample;

  std::vector<std::array<double, 2>> m_Direction;
};
} // namespace itk

#endif
