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
#include "itkShrunkImage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
std::size_t
ShrunkImage::FindFactor(std::size_t width, std::size_t height, std::size_t maximumSide)
{
  const std::size_t limit = std::max<std::size_t>(1, maximumSide);
  return std::max<std::size_t>(1, (std::max(width, height) + limit - 1) / limit);
}

ShrunkImage
ShrunkImage::ToFit(const float * pixels, std::size_t width, std::size_t height, std::size_t maximumSide)
{
  ShrunkImage small;
  small.factor = FindFactor(width, height, maximumSide);
  small.width = (width + small.factor - 1) / small.factor;
  small.height = (height + small.factor - 1) / small.factor;
  if (small.factor == 1)
  {
    small.pixels.assign(pixels, pixels + width * height);
    return small;
  }
  small.pixels.resize(small.width * small.height);
  for (std::size_t row = 0; row < small.height; ++row)
  {
    const std::size_t bottom = std::min((row + 1) * small.factor, height);
    for (std::size_t column = 0; column < small.width; ++column)
    {
      const std::size_t right = std::min((column + 1) * small.factor, width);
      double            sum = 0.0;
      std::size_t       used = 0;
      for (std::size_t v = row * small.factor; v < bottom; ++v)
      {
        for (std::size_t u = column * small.factor; u < right; ++u)
        {
          const float value = pixels[v * width + u];
          if (std::isfinite(value))
          {
            sum += value;
            ++used;
          }
        }
      }
      small.pixels[row * small.width + column] =
        used == 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(sum / static_cast<double>(used));
    }
  }
  return small;
}
} // namespace itk
