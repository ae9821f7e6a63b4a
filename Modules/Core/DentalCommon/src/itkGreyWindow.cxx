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
#include "itkGreyWindow.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace itk
{
GreyWindow
GreyWindow::FromQuantiles(const float * pixels, std::size_t count, double share, std::size_t stride)
{
  std::vector<float> finite;
  finite.reserve(count / stride + 1);
  for (std::size_t i = 0; i < count; i += stride)
  {
    if (std::isfinite(pixels[i]))
    {
      finite.push_back(pixels[i]);
    }
  }
  GreyWindow window;
  if (finite.empty())
  {
    return window;
  }
  const auto quantile = [&finite](double q) {
    const auto at = finite.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(finite.size() - 1));
    std::nth_element(finite.begin(), at, finite.end());
    return static_cast<double>(*at);
  };
  window.black = quantile(share);
  window.white = quantile(1.0 - share);
  if (!(window.white > window.black))
  {
    const auto ends = std::minmax_element(finite.begin(), finite.end());
    window.black = *ends.first;
    window.white = *ends.second;
  }
  return window;
}

std::uint8_t
GreyWindow::ToByte(double value) const
{
  const double range = white != black ? white - black : 1.0;
  const double share = std::isfinite(value) ? (value - black) / range : 0.0;
  return static_cast<std::uint8_t>(255.0 * std::clamp(share, 0.0, 1.0) + 0.5);
}
} // namespace itk
