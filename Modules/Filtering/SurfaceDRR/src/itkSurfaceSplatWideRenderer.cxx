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
#include "itkSurfaceSplatRegions.h"
#include "itkSurfaceSplatRendering.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace itk
{
// Adds splats row by row: those of a wide table, and those that have each a width of its own.
namespace
{
using namespace SurfaceSplatDetail;

inline void
AddScaledRow(float * row, const float * taps, float scale, int count)
{
  for (int i = 0; i < count; ++i)
  {
    row[i] += scale * taps[i];
  }
}
} // namespace

template <typename TFunction>
void
SurfaceSplatKernel::ForEachSplat(std::size_t band, TFunction && visit) const
{
  for (std::size_t run = m_BandBegin[band]; run < m_BandBegin[band + 1]; ++run)
  {
    for (std::size_t splat = m_Runs[run].begin; splat < m_Runs[run].end; ++splat)
    {
      visit(splat);
    }
  }
}

void
SurfaceSplatKernel::Rendering::SplatWideTable(std::size_t band)
{
  const SurfaceSplatKernel & kernel = m_Kernel;
  const TableType &          tableU = kernel.m_TableU;
  const TableType &          tableV = kernel.m_TableV;
  const std::int64_t         bandRow = kernel.m_Domain.startV + static_cast<std::int64_t>(band) * BandHeight;
  const std::int64_t         firstRow = std::max(bandRow, m_Reached.startV);
  const std::int64_t         endRow = std::min(bandRow + BandHeight, m_Reached.startV + m_Reached.sizeV);
  const std::int64_t         firstColumn = m_Reached.startU;
  const std::int64_t         endColumn = m_Reached.startU + m_Reached.sizeU;
  float * const      origin = m_Buffer - m_Region.startU - m_Region.startV * static_cast<std::int64_t>(m_Stride);
  std::vector<float> rowTaps(static_cast<std::size_t>(tableU.taps));
  kernel.ForEachSplat(band, [&](std::size_t s) {
    const std::int64_t u0 = kernel.m_Domain.startU + kernel.m_WholeU[s] - tableU.taps / 2 + 1;
    const std::int64_t v0 = kernel.m_Domain.startV + kernel.m_WholeV[s] - tableV.taps / 2 + 1;
    const std::int64_t rowBegin = std::max(v0, firstRow);
    const std::int64_t rowEnd = std::min(v0 + tableV.taps, endRow);
    const std::int64_t begin = std::max(u0, firstColumn);
    const std::int64_t end = std::min(u0 + tableU.taps, endColumn);
    if (rowBegin >= rowEnd || begin >= end)
    {
      return;
    }
    const float   sampleU = kernel.m_FractionU[s] * static_cast<float>(tableU.rows);
    const float   sampleV = kernel.m_FractionV[s] * static_cast<float>(tableV.rows);
    const int     indexU = std::min(static_cast<int>(sampleU), tableU.rows - 1);
    const int     indexV = std::min(static_cast<int>(sampleV), tableV.rows - 1);
    const float   fractionU = sampleU - static_cast<float>(indexU);
    const float   fractionV = sampleV - static_cast<float>(indexV);
    const float * valuesU = tableU.values.data() + static_cast<std::size_t>(indexU) * tableU.stride;
    const float * valuesV = tableV.values.data() + static_cast<std::size_t>(indexV) * tableV.stride;
    for (int i = 0; i < tableU.taps; ++i)
    {
      rowTaps[i] = valuesU[i] + fractionU * (valuesU[i + tableU.stride] - valuesU[i]);
    }
    for (std::int64_t row = rowBegin; row < rowEnd; ++row)
    {
      const auto  j = static_cast<std::size_t>(row - v0);
      const float w = valuesV[j] + fractionV * (valuesV[j + static_cast<std::size_t>(tableV.stride)] - valuesV[j]);
      AddScaledRow(origin + row * static_cast<std::int64_t>(m_Stride) + begin,
                   rowTaps.data() + (begin - u0),
                   kernel.m_Weight[s] * w,
                   static_cast<int>(end - begin));
    }
  });
}

void
SurfaceSplatKernel::Rendering::SplatEach(std::size_t band)
{
  const SurfaceSplatKernel & kernel = m_Kernel;
  const std::int64_t         bandRow = kernel.m_Domain.startV + static_cast<std::int64_t>(band) * BandHeight;
  const std::int64_t         firstRow = std::max(bandRow, m_Reached.startV);
  const std::int64_t         endRow = std::min(bandRow + BandHeight, m_Reached.startV + m_Reached.sizeV);
  const std::int64_t         firstColumn = m_Reached.startU;
  const std::int64_t         endColumn = m_Reached.startU + m_Reached.sizeU;
  float * const      origin = m_Buffer - m_Region.startU - m_Region.startV * static_cast<std::int64_t>(m_Stride);
  std::vector<float> taps(static_cast<std::size_t>(std::max<std::int64_t>(m_Reached.sizeU, BandHeight)) + 2);
  float              rowTaps[BandHeight];
  kernel.ForEachSplat(band, [&](std::size_t s) {
    const double       sigmaU = kernel.m_SigmaU[s];
    const double       sigmaV = kernel.m_SigmaV[s];
    const auto         halfU = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(kernel.m_Cut * sigmaU)));
    const auto         halfV = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(kernel.m_Cut * sigmaV)));
    const std::int64_t u0 = kernel.m_Domain.startU + kernel.m_WholeU[s] - halfU + 1;
    const std::int64_t v0 = kernel.m_Domain.startV + kernel.m_WholeV[s] - halfV + 1;
    const std::int64_t rowBegin = std::max(v0, firstRow);
    const std::int64_t rowEnd = std::min(v0 + 2 * halfV, endRow);
    const std::int64_t begin = std::max(u0, firstColumn);
    const std::int64_t end = std::min(u0 + 2 * halfU, endColumn);
    if (rowBegin >= rowEnd || begin >= end)
    {
      return;
    }
    const auto width = static_cast<int>(end - begin);
    const auto height = static_cast<int>(rowEnd - rowBegin);
    const auto beginU = static_cast<int>(begin - u0 - halfU + 1);
    const auto beginV = static_cast<int>(rowBegin - v0 - halfV + 1);
    const auto scaleU = static_cast<float>(std::max(-1e30, -0.5 / (sigmaU * sigmaU)));
    const auto scaleV = static_cast<float>(std::max(-1e30, -0.5 / (sigmaV * sigmaV)));
    for (int i = 0; i < width; ++i)
    {
      const float d = static_cast<float>(beginU + i) - kernel.m_FractionU[s];
      taps[i] = NegativeExp(d * d * scaleU);
    }
    for (int j = 0; j < height; ++j)
    {
      const float d = static_cast<float>(beginV + j) - kernel.m_FractionV[s];
      rowTaps[j] = kernel.m_Weight[s] * NegativeExp(d * d * scaleV);
    }
    float * pixel = origin + rowBegin * static_cast<std::int64_t>(m_Stride) + begin;
    for (int j = 0; j < height; ++j, pixel += m_Stride)
    {
      AddScaledRow(pixel, taps.data(), rowTaps[j], width);
    }
  });
}
} // namespace itk
