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
#include "itkSurfaceSplatChunks.h"
#include "itkSurfaceSplatKernel.h"
#include "itkSurfaceSplatRegions.h"
#include "itkSurfaceSplatRestrict.h"

#include "itkParallelFor.h"
#include "itkVectorClones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace itk
{
// Sorts splats into the bands of rows that they reach, in an order that no number of threads changes.
namespace
{
using namespace SurfaceSplatDetail;

constexpr int SplitBlock = 256;

/** Positions relative to a start, cut into floor and rest, those far from [0, size) moved near, and the
 * range of the floors. Adding 1.5 * 2^30
 * leaves a double with 22 fractional bits at the end of its mantissa: floor and rest are bits of it, which needs
 * neither a library call nor a newer instruction set. */
itkVectorClones void
SplitPositions(const double * Restrict positions,
               int                     count,
               std::int64_t            start,
               std::int32_t            size,
               std::int32_t            half,
               std::int32_t * Restrict whole,
               float * Restrict        rest,
               std::int32_t            range[2])
{
  constexpr double        shift = 1610612736.0;
  constexpr std::uint64_t fractionMask = (1u << 22) - 1;
  const auto              first = static_cast<double>(start);
  const double            low = -1.0 - half;
  const double            high = 1.0 + size + half;
  // Both of the sum's leading bits are set: what they hold is taken off after the shift.
  constexpr auto offset = static_cast<std::int32_t>(0x60000000);
  for (int i = 0; i < count; ++i)
  {
    double x = positions[i] - first;
    x = x < low ? low : x;
    x = x > high ? high : x;
    x += shift;
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    whole[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(bits >> 22)) - offset;
    rest[i] = static_cast<float>(static_cast<std::int32_t>(bits & fractionMask)) * (1.0f / 4194304.0f);
  }
  std::int32_t least = INT32_MAX;
  std::int32_t greatest = INT32_MIN;
  for (int i = 0; i < count; ++i)
  {
    least = whole[i] < least ? whole[i] : least;
    greatest = whole[i] > greatest ? whole[i] : greatest;
  }
  range[0] = least;
  range[1] = greatest;
}
} // namespace

void
SurfaceSplatKernel::SortIntoBands(const SurfaceSplatLayer & layer, unsigned int threads)
{
  const std::size_t count = layer.u.size();
  const bool        perSplat = m_Method == MethodEnum::PerSplat;
  const bool        narrow = perSplat && layer.sigmaUs.empty();
  // Rows of nodes for the splines, of pixels otherwise.
  const std::int64_t haloU = m_FilterU.empty() ? 0 : static_cast<std::int64_t>(m_FilterU.size()) - 1;
  const std::int64_t haloV = m_FilterV.empty() ? 0 : static_cast<std::int64_t>(m_FilterV.size()) - 1;
  m_Domain = Dilate(m_Image, haloU, haloV);
  const auto bands = static_cast<std::size_t>((m_Domain.sizeV + BandHeight - 1) / BandHeight);
  m_BandBegin.assign(bands + 1, 0);
  if (bands == 0)
  {
    return;
  }

  std::int64_t halfU = 0;
  std::int64_t halfV = 0;
  switch (m_Method)
  {
    case MethodEnum::CubicSpline:
      halfU = halfV = 2;
      break;
    case MethodEnum::QuinticSpline:
      halfU = halfV = 3;
      break;
    default:
      halfU = m_TableU.taps / 2;
      halfV = m_TableV.taps / 2;
  }
  // Neighbours on the surface mostly lie in the same bands: runs of them are put in order, not the splats. They are
  // made in chunks of splats, one after the other: the order is that of the numbers.
  const auto sizeU = static_cast<std::int32_t>(m_Domain.sizeU);
  const auto sizeV = static_cast<std::int32_t>(m_Domain.sizeV);
  m_WholeU.resize(count);
  m_WholeV.resize(count);
  m_FractionU.resize(count);
  m_FractionV.resize(count);
  m_Weight.resize(count);
  if (narrow)
  {
    m_SigmaU.assign(count, static_cast<float>(layer.sigmaU));
    m_SigmaV.assign(count, static_cast<float>(layer.sigmaV));
  }
  else
  {
    m_SigmaU = layer.sigmaUs;
    m_SigmaV = layer.sigmaVs;
  }
  struct ChunkType
  {
    std::vector<RunType>       runs;
    std::vector<std::uint64_t> bandsOfRuns;
    /** Number of its runs in each band, then the place of the next. */
    std::vector<std::size_t> places;
    std::size_t              splats{ 0 };
    std::int32_t             bounds[4] = { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN };
  };
  const auto forEachRun = [](const ChunkType & chunk, auto && visit) {
    for (std::size_t run = 0; run < chunk.runs.size(); ++run)
    {
      const auto last = static_cast<std::size_t>(chunk.bandsOfRuns[run] >> 32);
      for (std::size_t band = chunk.bandsOfRuns[run] & 0xffffffffu; band <= last; ++band)
      {
        visit(band, chunk.runs[run]);
      }
    }
  };
  const std::size_t      chunks = NumberOfChunks(count, threads);
  std::vector<ChunkType> work(chunks);
  ParallelFor(chunks, threads, [&](std::size_t number) {
    ChunkType &       chunk = work[number];
    const std::size_t chunkEnd = count * (number + 1) / chunks;
    auto              hu = static_cast<std::int32_t>(halfU);
    auto              hv = static_cast<std::int32_t>(halfV);
    const auto        cut = static_cast<std::int32_t>(perSplat ? std::ceil(m_Cut * LargestSigma) : std::max(hu, hv));
    constexpr auto    none = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t     bandsOfRun = none;
    for (std::size_t begin = count * number / chunks; begin < chunkEnd; begin += SplitBlock)
    {
      const auto size = static_cast<int>(std::min<std::size_t>(SplitBlock, chunkEnd - begin));
      std::copy_n(layer.weight.data() + begin, size, m_Weight.data() + begin);
      const std::int32_t * const us = m_WholeU.data() + begin;
      const std::int32_t * const vs = m_WholeV.data() + begin;
      std::int32_t               rangeU[2];
      std::int32_t               rangeV[2];
      SplitPositions(layer.u.data() + begin,
                     size,
                     m_Domain.startU,
                     sizeU,
                     cut,
                     m_WholeU.data() + begin,
                     m_FractionU.data() + begin,
                     rangeU);
      SplitPositions(layer.v.data() + begin,
                     size,
                     m_Domain.startV,
                     sizeV,
                     cut,
                     m_WholeV.data() + begin,
                     m_FractionV.data() + begin,
                     rangeV);
      const bool allReach = !perSplat && rangeU[0] + hu >= 0 && rangeU[1] - hu + 1 < sizeU && rangeV[0] + hv >= 0 &&
                            rangeV[1] - hv + 1 < sizeV;
      if (allReach)
      {
        chunk.splats += static_cast<std::size_t>(size);
        chunk.bounds[0] = std::min(chunk.bounds[0], rangeU[0] - hu + 1);
        chunk.bounds[1] = std::min(chunk.bounds[1], rangeV[0] - hv + 1);
        chunk.bounds[2] = std::max(chunk.bounds[2], rangeU[1] + hu);
        chunk.bounds[3] = std::max(chunk.bounds[3], rangeV[1] + hv);
      }
      for (int i = 0; i < size; ++i)
      {
        const std::size_t splat = begin + static_cast<std::size_t>(i);
        if (!allReach)
        {
          if (perSplat)
          {
            hu = std::max(1, static_cast<std::int32_t>(std::ceil(m_Cut * m_SigmaU[splat])));
            hv = std::max(1, static_cast<std::int32_t>(std::ceil(m_Cut * m_SigmaV[splat])));
          }
          if (us[i] + hu < 0 || us[i] - hu + 1 >= sizeU || vs[i] + hv < 0 || vs[i] - hv + 1 >= sizeV)
          {
            bandsOfRun = none;
            continue;
          }
          ++chunk.splats;
          chunk.bounds[0] = std::min(chunk.bounds[0], us[i] - hu + 1);
          chunk.bounds[1] = std::min(chunk.bounds[1], vs[i] - hv + 1);
          chunk.bounds[2] = std::max(chunk.bounds[2], us[i] + hu);
          chunk.bounds[3] = std::max(chunk.bounds[3], vs[i] + hv);
        }
        const std::uint32_t first = static_cast<std::uint32_t>(std::max(vs[i] - hv + 1, 0)) / BandHeight;
        const std::uint32_t last = static_cast<std::uint32_t>(std::min(vs[i] + hv, sizeV - 1)) / BandHeight;
        const std::uint64_t both = first | static_cast<std::uint64_t>(last) << 32;
        if (both != bandsOfRun)
        {
          bandsOfRun = both;
          chunk.runs.push_back({ splat, splat });
          chunk.bandsOfRuns.push_back(both);
        }
        chunk.runs.back().end = splat + 1;
      }
    }
    chunk.places.assign(bands, 0);
    forEachRun(chunk, [&chunk](std::size_t band, const RunType &) { ++chunk.places[band]; });
  });
  std::int32_t bounds[4] = { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN };
  for (const ChunkType & chunk : work)
  {
    m_NumberOfSplats += chunk.splats;
    bounds[0] = std::min(bounds[0], chunk.bounds[0]);
    bounds[1] = std::min(bounds[1], chunk.bounds[1]);
    bounds[2] = std::max(bounds[2], chunk.bounds[2]);
    bounds[3] = std::max(bounds[3], chunk.bounds[3]);
  }
  // In the order of the chunks, hence of the splats' numbers.
  std::size_t place = 0;
  for (std::size_t band = 0; band < bands; ++band)
  {
    for (ChunkType & chunk : work)
    {
      place += std::exchange(chunk.places[band], place);
    }
    m_BandBegin[band + 1] = place;
  }
  m_Runs.resize(place);
  ParallelFor(chunks, threads, [&](std::size_t number) {
    ChunkType & chunk = work[number];
    forEachRun(chunk, [this, &chunk](std::size_t band, const RunType & run) { m_Runs[chunk.places[band]++] = run; });
  });
  if (m_NumberOfSplats > 0)
  {
    m_SplatBounds.startU = m_Domain.startU + bounds[0];
    m_SplatBounds.startV = m_Domain.startV + bounds[1];
    m_SplatBounds.sizeU = bounds[2] - bounds[0] + 1;
    m_SplatBounds.sizeV = bounds[3] - bounds[1] + 1;
    m_SplatBounds = Intersect(m_SplatBounds, m_Domain);
  }
}
} // namespace itk
