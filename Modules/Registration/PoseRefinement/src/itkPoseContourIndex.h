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

#include "itkPoseContourModel.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace itk
{
/** Contour samples in buckets along u, for the oriented nearest neighbour. */
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
      const std::size_t k = next[bucket[i]]++;
      m_Sample[k] = { contour.u[i], contour.v[i], contour.nu[i], contour.nv[i], i };
    }
  }

  bool
  Empty() const
  {
    return m_Sample.empty();
  }

  std::size_t
  Nearest(double u, double v, double nu, double nv, double normalWeight2) const
  {
    const int   centre = std::min(m_Buckets - 1, std::max(0, static_cast<int>((u - m_Low) / Width)));
    double      best = std::numeric_limits<double>::infinity();
    std::size_t index = 0;
    const auto  scan = [&](int b) {
      for (std::size_t k = m_Start[b]; k < m_Start[b + 1]; ++k)
      {
        const Sample & s = m_Sample[k];
        const double   du = s.u - u;
        const double   dv = s.v - v;
        const double   d = du * du + dv * dv + normalWeight2 * (2.0 - 2.0 * (s.nu * nu + s.nv * nv));
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

private:
  static constexpr double Width = 8.0;
  struct Sample
  {
    double      u, v, nu, nv;
    std::size_t index;
  };
  double                   m_Low{ 0.0 };
  int                      m_Buckets{ 0 };
  std::vector<std::size_t> m_Start;
  std::vector<Sample>      m_Sample;
};
} // namespace itk

#endif
