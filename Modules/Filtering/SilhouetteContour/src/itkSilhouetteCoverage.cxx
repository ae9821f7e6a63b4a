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
#include "itkSilhouetteCoverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
/** Marks the samples that the border reaches through uncovered ones with 2. */
void
FloodFromBorder(std::vector<std::uint8_t> & mask, std::size_t columns, std::size_t rows)
{
  std::vector<std::size_t> open;
  const auto               reach = [&](std::size_t at) {
    if (mask[at] == 0)
    {
      mask[at] = 2;
      open.push_back(at);
    }
  };
  for (std::size_t i = 0; i < columns; ++i)
  {
    reach(i);
    reach((rows - 1) * columns + i);
  }
  for (std::size_t j = 0; j < rows; ++j)
  {
    reach(j * columns);
    reach(j * columns + columns - 1);
  }
  while (!open.empty())
  {
    const std::size_t at = open.back();
    open.pop_back();
    const std::size_t i = at % columns;
    if (i > 0)
    {
      reach(at - 1);
    }
    if (i + 1 < columns)
    {
      reach(at + 1);
    }
    if (at >= columns)
    {
      reach(at - columns);
    }
    if (at + columns < mask.size())
    {
      reach(at + columns);
    }
  }
}
} // namespace

double
SilhouetteCoverage::Area() const
{
  double area = 0.0;
  for (const float value : values)
  {
    area += value;
  }
  return area;
}

SilhouetteCoverage
ComputeSilhouetteCoverage(const TriangleSurface &       surface,
                          const PerspectiveProjection & projection,
                          std::size_t                   width,
                          std::size_t                   height,
                          unsigned int                  subsamples,
                          bool                          fillHoles)
{
  if (width == 0 || height == 0 || subsamples == 0)
  {
    throw std::invalid_argument("A coverage image needs a width, a height and subsamples of at least 1.");
  }
  const std::size_t         columns = width * subsamples;
  const std::size_t         rows = height * subsamples;
  std::vector<std::uint8_t> mask(columns * rows, 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    // In samples: sample i lies at index (i + 0.5) / subsamples - 0.5.
    double x[3];
    double y[3];
    for (unsigned int k = 0; k < 3; ++k)
    {
      double u = 0.0;
      double v = 0.0;
      if (!(projection.Project(surface.points[surface.triangles[t][k]].data(), u, v) > 0.0))
      {
        std::ostringstream message;
        message << "Triangle " << t << " of the surface is not in front of the X-ray source. Check the mesh's unit and "
                << "the pose.";
        throw std::domain_error(message.str());
      }
      x[k] = (u + 0.5) * subsamples - 0.5;
      y[k] = (v + 0.5) * subsamples - 0.5;
    }
    const double first = std::max(0.0, std::ceil(std::min({ y[0], y[1], y[2] })));
    const double last = std::min(static_cast<double>(rows) - 1.0, std::floor(std::max({ y[0], y[1], y[2] })));
    for (double row = first; row <= last; row += 1.0)
    {
      double low = static_cast<double>(columns);
      double high = -1.0;
      for (unsigned int k = 0; k < 3; ++k)
      {
        const unsigned int n = (k + 1) % 3;
        if (std::min(y[k], y[n]) > row || std::max(y[k], y[n]) < row)
        {
          continue;
        }
        for (const double at : y[k] == y[n]
                                 ? std::array<double, 2>{ x[k], x[n] }
                                 : std::array<double, 2>{ x[k] + (row - y[k]) / (y[n] - y[k]) * (x[n] - x[k]),
                                                          x[k] + (row - y[k]) / (y[n] - y[k]) * (x[n] - x[k]) })
        {
          low = std::min(low, at);
          high = std::max(high, at);
        }
      }
      const double begin = std::max(0.0, std::ceil(low));
      const double end = std::min(static_cast<double>(columns) - 1.0, std::floor(high));
      if (begin <= end)
      {
        const auto offset = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * columns);
        std::fill(mask.begin() + offset + static_cast<std::ptrdiff_t>(begin),
                  mask.begin() + offset + static_cast<std::ptrdiff_t>(end) + 1,
                  std::uint8_t{ 1 });
      }
    }
  }
  if (fillHoles)
  {
    FloodFromBorder(mask, columns, rows);
    for (std::uint8_t & sample : mask)
    {
      sample = sample == 2 ? 0 : 1;
    }
  }
  SilhouetteCoverage coverage;
  coverage.width = width;
  coverage.height = height;
  coverage.values.resize(width * height);
  const float weight = 1.0f / static_cast<float>(subsamples * subsamples);
  for (std::size_t j = 0; j < height; ++j)
  {
    for (std::size_t i = 0; i < width; ++i)
    {
      unsigned int covered = 0;
      for (unsigned int s = 0; s < subsamples; ++s)
      {
        const std::uint8_t * const row = mask.data() + (j * subsamples + s) * columns + i * subsamples;
        for (unsigned int r = 0; r < subsamples; ++r)
        {
          covered += row[r];
        }
      }
      coverage.values[j * width + i] = weight * static_cast<float>(covered);
    }
  }
  return coverage;
}
} // namespace itk
