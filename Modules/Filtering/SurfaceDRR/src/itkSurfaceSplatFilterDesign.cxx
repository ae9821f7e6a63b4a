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
#include "itkSurfaceSplatFilterDesign.h"

#include "itkSurfaceSplatArithmetic.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace SurfaceSplatDetail
{
template <int VDegree>
double
FitFilter(double sigma, double cut, std::vector<float> & filter)
{
  constexpr int before = (VDegree - 1) / 2;
  const int     radius = std::max(1, static_cast<int>(std::ceil(cut * sigma)));
  const int     count = radius + 1;
  const int     reach = radius + VDegree;
  constexpr int positions = 16;
  // The normal equations are banded: a sample sees the neighbouring nodes only.
  constexpr int                          width = VDegree + 1;
  std::vector<std::array<double, width>> lower(count); // lower[r][d] = N(r, r - d)
  std::vector<double>                    right(count, 0.0);
  const auto gauss = [sigma](double d) { return std::exp(-0.5 * (d / sigma) * (d / sigma)); };
  for (auto & row : lower)
  {
    row.fill(0.0);
  }
  for (int s = 0; s < positions; ++s)
  {
    const double f = (s + 0.5) / positions;
    double       w[VDegree + 1];
    SplineWeights<VDegree>(f, w);
    for (int i = -reach; i <= reach; ++i)
    {
      int    ks[VDegree + 1];
      double as[VDegree + 1];
      int    used = 0;
      for (int n = 0; n <= VDegree; ++n)
      {
        const int k = std::abs(i - (n - before));
        if (k > radius)
        {
          continue;
        }
        const int at = static_cast<int>(std::find(ks, ks + used, k) - ks);
        if (at == used)
        {
          ks[used] = k;
          as[used++] = 0.0;
        }
        as[at] += w[n];
      }
      const double target = gauss(i - f);
      for (int a = 0; a < used; ++a)
      {
        right[ks[a]] += as[a] * target;
        for (int b = 0; b < used; ++b)
        {
          if (ks[b] <= ks[a])
          {
            lower[ks[a]][ks[a] - ks[b]] += as[a] * as[b];
          }
        }
      }
    }
  }
  // Cholesky in place, then both substitutions.
  for (int r = 0; r < count; ++r)
  {
    lower[r][0] *= 1.0 + 1e-12;
    for (int d = std::min(r, width - 1); d >= 0; --d)
    {
      const int c = r - d;
      double    sum = lower[r][d];
      for (int k = std::max(0, r - width + 1); k < c; ++k)
      {
        if (c - k < width)
        {
          sum -= lower[r][r - k] * lower[c][c - k];
        }
      }
      lower[r][d] = d == 0 ? std::sqrt(std::max(sum, 1e-300)) : sum / lower[c][0];
    }
  }
  for (int r = 0; r < count; ++r)
  {
    for (int d = 1; d <= std::min(r, width - 1); ++d)
    {
      right[r] -= lower[r][d] * right[r - d];
    }
    right[r] /= lower[r][0];
  }
  for (int r = count - 1; r >= 0; --r)
  {
    for (int d = 1; d < width && r + d < count; ++d)
    {
      right[r] -= lower[r + d][d] * right[r + d];
    }
    right[r] /= lower[r][0];
  }
  filter.assign(right.begin(), right.end());
  double error = 0.0;
  for (int s = 0; s <= 2 * positions; ++s)
  {
    const double f = 0.5 * s / positions;
    double       w[VDegree + 1];
    SplineWeights<VDegree>(f, w);
    for (int i = -reach - 2; i <= reach + 2; ++i)
    {
      double value = 0.0;
      for (int n = 0; n <= VDegree; ++n)
      {
        const int k = std::abs(i - (n - before));
        value += k <= radius ? w[n] * filter[k] : 0.0;
      }
      error = std::max(error, std::abs(value - gauss(i - f)));
    }
  }
  return error;
}

template double
FitFilter<3>(double, double, std::vector<float> &);
template double
FitFilter<5>(double, double, std::vector<float> &);
} // namespace SurfaceSplatDetail
} // namespace itk
