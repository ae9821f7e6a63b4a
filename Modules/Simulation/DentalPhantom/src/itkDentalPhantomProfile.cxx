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
#include "itkDentalPhantomProfile.h"

#include <utility>

namespace itk
{
DentalPhantomProfile::DentalPhantomProfile(std::vector<double> xs, std::vector<double> ys)
  : x(std::move(xs))
  , y(std::move(ys))
  , slope(x.size())
{
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t a = i == 0 ? 0 : i - 1;
    const std::size_t b = i + 1 == n ? i : i + 1;
    slope[i] = (y[b] - y[a]) / (x[b] - x[a]);
  }
}

double
DentalPhantomProfile::operator()(double t) const
{
  if (t <= x.front())
  {
    return y.front();
  }
  if (t >= x.back())
  {
    return y.back();
  }
  std::size_t i = 0;
  while (t > x[i + 1])
  {
    ++i;
  }
  const double h = x[i + 1] - x[i];
  const double a = (t - x[i]) / h;
  const double b = 1.0 - a;
  return b * b * (1.0 + 2.0 * a) * y[i] + a * a * (3.0 - 2.0 * a) * y[i + 1] + a * b * b * h * slope[i] -
         a * a * b * h * slope[i + 1];
}
} // namespace itk
