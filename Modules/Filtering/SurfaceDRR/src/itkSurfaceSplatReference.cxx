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
#include "itkSurfaceSplatArithmetic.h"
#include "itkSurfaceSplatKernel.h"

#include <algorithm>
#include <cmath>

namespace itk
{
// What the kernel is tested against: every splat summed in doubles, and its exponential.
namespace
{
using namespace SurfaceSplatDetail;
} // namespace

void
SurfaceSplatExp(float * values, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    values[i] = NegativeExp(values[i]);
  }
}

void
SurfaceSplatReference(const SurfaceSplatLayer &  layer,
                      const SurfaceSplatRegion & region,
                      double *                   buffer,
                      std::size_t                stride)
{
  for (std::size_t i = 0; i < layer.u.size(); ++i)
  {
    const double sigmaU = layer.sigmaUs.empty() ? layer.sigmaU : layer.sigmaUs[i];
    const double sigmaV = layer.sigmaVs.empty() ? layer.sigmaV : layer.sigmaVs[i];
    const auto   clip = [](double x, std::int64_t start, std::int64_t size) {
      return static_cast<std::int64_t>(std::clamp(x, static_cast<double>(start), static_cast<double>(start + size)));
    };
    const std::int64_t beginU = clip(std::ceil(layer.u[i] - 8.0 * sigmaU), region.startU, region.sizeU);
    const std::int64_t endU = clip(std::floor(layer.u[i] + 8.0 * sigmaU) + 1.0, region.startU, region.sizeU);
    const std::int64_t beginV = clip(std::ceil(layer.v[i] - 8.0 * sigmaV), region.startV, region.sizeV);
    const std::int64_t endV = clip(std::floor(layer.v[i] + 8.0 * sigmaV) + 1.0, region.startV, region.sizeV);
    for (std::int64_t v = beginV; v < endV; ++v)
    {
      double * row = buffer + (v - region.startV) * static_cast<std::int64_t>(stride) - region.startU;
      for (std::int64_t u = beginU; u < endU; ++u)
      {
        const double du = (static_cast<double>(u) - layer.u[i]) / sigmaU;
        const double dv = (static_cast<double>(v) - layer.v[i]) / sigmaV;
        row[u] += layer.weight[i] * std::exp(-0.5 * (du * du + dv * dv));
      }
    }
  }
}
} // namespace itk
