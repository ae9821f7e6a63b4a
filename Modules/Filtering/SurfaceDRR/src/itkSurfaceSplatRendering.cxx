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
#include "itkSurfaceSplatRendering.h"

#include "itkSurfaceSplatRegions.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace itk
{
// What a rendering has to do, cut into jobs, and which renderer does it.
namespace
{
using namespace SurfaceSplatDetail;

/** A square table that is not wider (pixels) is added in aligned rows. */
constexpr int WidestAlignedTable = 16;
} // namespace

SurfaceSplatKernel::Rendering::Rendering(const SurfaceSplatKernel & kernel,
                                         const SurfaceSplatRegion & region,
                                         float *                    buffer,
                                         std::size_t                stride)
  : m_Kernel(kernel)
  , m_Region(region)
  , m_Buffer(buffer)
  , m_Stride(stride)
{
  const auto radiusU = static_cast<std::int64_t>(kernel.m_FilterU.size()) - 1;
  const auto radiusV = static_cast<std::int64_t>(kernel.m_FilterV.size()) - 1;
  const bool spline = IsSpline(kernel.m_Method);
  m_Reached = Intersect(Intersect(region, kernel.m_Image),
                        spline ? Dilate(kernel.m_SplatBounds, radiusU, radiusV) : kernel.m_SplatBounds);
  if (m_Reached.sizeU == 0)
  {
    return;
  }
  m_Nodes = spline ? Dilate(m_Reached, radiusU, radiusV) : m_Reached;
  m_NodeRows = Intersect(m_Nodes, kernel.m_SplatBounds);
  if (m_NodeRows.sizeV == 0)
  {
    return;
  }
  m_FirstBand = static_cast<std::size_t>((m_NodeRows.startV - kernel.m_Domain.startV) / BandHeight);
  const auto lastBand =
    static_cast<std::size_t>((m_NodeRows.startV + m_NodeRows.sizeV - 1 - kernel.m_Domain.startV) / BandHeight);
  m_Jobs.push_back(lastBand - m_FirstBand + 1);
  // The longest first, so that no thread is left alone with one at the end.
  std::vector<std::size_t> splats(m_Jobs[0], 0);
  for (std::size_t job = 0; job < m_Jobs[0]; ++job)
  {
    const std::size_t band = m_FirstBand + job;
    for (std::size_t run = kernel.m_BandBegin[band]; run < kernel.m_BandBegin[band + 1]; ++run)
    {
      splats[job] += kernel.m_Runs[run].end - kernel.m_Runs[run].begin;
    }
    m_BandsByWork.push_back(band);
  }
  std::stable_sort(m_BandsByWork.begin(), m_BandsByWork.end(), [this, &splats](std::size_t a, std::size_t b) {
    return splats[a - m_FirstBand] > splats[b - m_FirstBand];
  });
  if (spline)
  {
    m_NodeValues.resize(static_cast<std::size_t>(m_Reached.sizeU * m_NodeRows.sizeV));
    m_Jobs.push_back(static_cast<std::size_t>((m_Reached.sizeV + BandHeight - 1) / BandHeight));
  }
}

SurfaceSplatKernel::Rendering::~Rendering() = default;

auto
SurfaceSplatKernel::Rendering::TakeScratch() -> ScratchType
{
  const std::lock_guard<std::mutex> lock(m_ScratchMutex);
  if (m_Scratch.empty())
  {
    return {};
  }
  ScratchType scratch = std::move(m_Scratch.back());
  m_Scratch.pop_back();
  return scratch;
}

void
SurfaceSplatKernel::Rendering::ReturnScratch(ScratchType && scratch)
{
  const std::lock_guard<std::mutex> lock(m_ScratchMutex);
  m_Scratch.push_back(std::move(scratch));
}

void
SurfaceSplatKernel::Rendering::Run(std::size_t phase, std::size_t job)
{
  if (phase == 1)
  {
    this->FilterColumns(job);
    return;
  }
  const std::size_t band = m_BandsByWork[job];
  if (m_Kernel.m_Method == MethodEnum::PerSplat)
  {
    this->SplatEach(band);
  }
  else if (m_Kernel.m_Method == MethodEnum::Table &&
           (m_Kernel.m_TableU.taps > WidestAlignedTable || m_Kernel.m_TableU.taps != m_Kernel.m_TableV.taps))
  {
    this->SplatWideTable(band);
  }
  else
  {
    this->SplatAligned(band);
  }
}
} // namespace itk
