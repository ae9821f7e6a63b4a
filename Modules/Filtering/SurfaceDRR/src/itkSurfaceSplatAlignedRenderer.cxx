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
#include "itkSurfaceSplatRestrict.h"

#include "itkVectorClones.h"

#include <algorithm>
#include <array>

namespace itk
{
// Adds splats of one width in whole vectors: those of a narrow table, and the nodes of splines, which are filtered.
namespace
{
using namespace SurfaceSplatDetail;

/** The first tap's place in the copies of a band. */
struct AlignedRows
{
  Float4 *     copies;
  std::int32_t firstRow;
  std::int32_t firstColumn;
  /** In vectors. */
  std::ptrdiff_t width;

  Float4 *
  At(std::int32_t row, std::int32_t column) const
  {
    return copies + (4 * static_cast<std::ptrdiff_t>(row - firstRow) + (column & 3)) * width +
           ((column - (column & 3) - firstColumn) >> 2);
  }
};

/** The arrays of a kernel's splats. */
struct SplatArrays
{
  const std::int32_t * wholeU;
  const std::int32_t * wholeV;
  const float *        fractionU;
  const float *        fractionV;
  const float *        weight;
};

/** Adds the splats [i, end) of a band whose taps reach rows and columns of nodes. */
template <int VDegree>
void
BinSplats(const SplatArrays & splats,
          std::size_t         i,
          std::size_t         end,
          const AlignedRows & rows,
          std::int32_t        endRow,
          std::int32_t        endColumn)
{
  constexpr int taps = VDegree + 1;
  constexpr int before = (VDegree - 1) / 2;
  constexpr int vectors = (taps + 3) / 4;
  for (; i < end; ++i)
  {
    const std::int32_t u0 = splats.wholeU[i] - before;
    const std::int32_t v0 = splats.wholeV[i] - before;
    if (u0 < rows.firstColumn || u0 >= endColumn || v0 < rows.firstRow || v0 >= endRow)
    {
      continue;
    }
    Float4 wu[vectors];
    Float4 wv[vectors];
    SplineWeights<VDegree>(splats.fractionU[i], wu);
    SplineWeights<VDegree>(splats.fractionV[i], wv);
    const Float4 weight = Broadcast(splats.weight[i]);
    Float4 *     at = rows.At(v0, u0);
    for (int k = 0; k < vectors; ++k)
    {
      wu[k] = wu[k] * weight;
    }
    for (int j = 0; j < taps; ++j, at += 4 * rows.width)
    {
      const Float4 w = Broadcast(wv[j / 4][j % 4]);
      for (int k = 0; k < vectors; ++k)
      {
        at[k] += w * wu[k];
      }
    }
  }
}

/** The weights of a table at a position between two of its rows. */
template <int VVectors, typename TTable>
inline void
TableWeights(const TTable & table, float fraction, Float4 * w)
{
  const float   sample = fraction * static_cast<float>(table.rows);
  const int     index = std::min(static_cast<int>(sample), table.rows - 1);
  const Float4  t = Broadcast(sample - static_cast<float>(index));
  const float * values = table.values.data() + static_cast<std::size_t>(index) * (4 * VVectors);
  for (int k = 0; k < VVectors; ++k)
  {
    const Float4 a = Load(values + 4 * k);
    const Float4 b = Load(values + 4 * k + 4 * VVectors);
    w[k] = a + t * (b - a);
  }
}

/** The same by tables of so many taps. */
template <int VTaps, typename TTable>
void
AddTableSplats(const SplatArrays & splats,
               std::size_t         i,
               std::size_t         end,
               const TTable &      tableU,
               const TTable &      tableV,
               const AlignedRows & rows,
               std::int32_t        endRow,
               std::int32_t        endColumn)
{
  constexpr int vectors = (VTaps + 3) / 4;
  for (; i < end; ++i)
  {
    const std::int32_t u0 = splats.wholeU[i] - VTaps / 2 + 1;
    const std::int32_t v0 = splats.wholeV[i] - VTaps / 2 + 1;
    const int          first = std::max(0, rows.firstRow - v0);
    const int          last = std::min(VTaps, endRow - v0);
    if (u0 < rows.firstColumn || u0 >= endColumn || first >= last)
    {
      continue;
    }
    Float4 wu[vectors];
    Float4 wv[vectors];
    TableWeights<vectors>(tableU, splats.fractionU[i], wu);
    TableWeights<vectors>(tableV, splats.fractionV[i], wv);
    for (Float4 & w : wu)
    {
      w = w * Broadcast(splats.weight[i]);
    }
    Float4 * at = rows.At(v0, u0);
    if (first == 0 && last == VTaps)
    {
      for (int j = 0; j < VTaps; ++j, at += 4 * rows.width)
      {
        const Float4 w = Broadcast(wv[j / 4][j % 4]);
        for (int k = 0; k < vectors; ++k)
        {
          at[k] += w * wu[k];
        }
      }
    }
    else
    {
      at += 4 * rows.width * first;
      for (int j = first; j < last; ++j, at += 4 * rows.width)
      {
        const Float4 w = Broadcast(wv[j / 4][j % 4]);
        for (int k = 0; k < vectors; ++k)
        {
          at[k] += w * wu[k];
        }
      }
    }
  }
}

constexpr int FilterBlock = 32;

/** out[i] = sum_k h_k (in[i + radius - k] + in[i + radius + k]), in a fixed order. */
itkVectorClones void
FilterRow(const float * in, const std::vector<float> & h, float * out, std::int32_t count)
{
  const int radius = static_cast<int>(h.size()) - 1;
  in += radius;
  for (std::int32_t begin = 0; begin < count; begin += FilterBlock)
  {
    float     sum[FilterBlock];
    const int width = std::min<int>(FilterBlock, count - begin);
    if (width == FilterBlock)
    {
      for (int i = 0; i < FilterBlock; ++i)
      {
        sum[i] = h[0] * in[begin + i];
      }
      for (int k = 1; k <= radius; ++k)
      {
        const float * before = in + begin - k;
        const float * after = in + begin + k;
        const float   weight = h[k];
        for (int i = 0; i < FilterBlock; ++i)
        {
          sum[i] += weight * (before[i] + after[i]);
        }
      }
    }
    else
    {
      for (int i = 0; i < width; ++i)
      {
        sum[i] = h[0] * in[begin + i];
        for (int k = 1; k <= radius; ++k)
        {
          sum[i] += h[k] * (in[begin + i - k] + in[begin + i + k]);
        }
      }
    }
    std::copy_n(sum, width, out + begin);
  }
}

/** Adds to a row what rows row - radius ... row + radius of the nodes give, those that there are; in a fixed order. */
itkVectorClones void
FilterColumn(const float *              nodes,
             std::int64_t               rows,
             std::int64_t               row,
             const std::vector<float> & h,
             float *                    out,
             std::int32_t               count)
{
  const auto radius = static_cast<std::int64_t>(h.size()) - 1;
  for (std::int32_t begin = 0; begin < count; begin += FilterBlock)
  {
    float     sum[FilterBlock] = {};
    const int width = std::min<int>(FilterBlock, count - begin);
    for (std::int64_t r = std::max<std::int64_t>(0, row - radius); r <= std::min(rows - 1, row + radius); ++r)
    {
      const float * in = nodes + r * count + begin;
      const float   weight = h[static_cast<std::size_t>(std::abs(r - row))];
      if (width == FilterBlock)
      {
        for (int i = 0; i < FilterBlock; ++i)
        {
          sum[i] += weight * in[i];
        }
      }
      else
      {
        for (int i = 0; i < width; ++i)
        {
          sum[i] += weight * in[i];
        }
      }
    }
    for (int i = 0; i < width; ++i)
    {
      out[begin + i] += sum[i];
    }
  }
}
} // namespace

void
SurfaceSplatKernel::Rendering::SplatAligned(std::size_t band)
{
  const SurfaceSplatKernel & kernel = m_Kernel;
  const SurfaceSplatRegion & domain = kernel.m_Domain;
  const bool                 spline = IsSpline(kernel.m_Method);
  const auto                 degree = kernel.m_Method == MethodEnum::CubicSpline ? 3 : 5;
  const int                  tapsU = spline ? degree + 1 : kernel.m_TableU.stride;
  // Splines write whole splats, also beyond the rows that are wanted: then their loops have a fixed length.
  const int  padRows = spline ? degree : 0;
  const auto toLocal = [](std::int64_t index, std::int64_t start) { return static_cast<std::int32_t>(index - start); };
  const auto bandRow = static_cast<std::int32_t>(band * BandHeight);
  const auto firstRow = std::max(bandRow, toLocal(m_NodeRows.startV, domain.startV));
  const auto endRow = std::min(bandRow + BandHeight, toLocal(m_NodeRows.startV + m_NodeRows.sizeV, domain.startV));
  const auto firstColumn = toLocal(m_Nodes.startU, domain.startU);
  const auto endColumn = toLocal(m_Nodes.startU + m_Nodes.sizeU, domain.startU);

  AlignedRows rows;
  rows.firstRow = firstRow - padRows;
  // Room for splats that begin before the first column.
  rows.firstColumn = (firstColumn - std::max(3, tapsU - 1)) & ~3;
  rows.width = (endColumn - rows.firstColumn + tapsU + 3) / 4 + 1;
  const auto  height = static_cast<std::size_t>(endRow - firstRow + 2 * padRows);
  ScratchType scratch = this->TakeScratch();
  scratch.copies.resize(std::max(scratch.copies.size(), 4 * height * static_cast<std::size_t>(rows.width)),
                        Broadcast(0.0f));
  rows.copies = scratch.copies.data();

  const SplatArrays splats{ kernel.m_WholeU.data(),
                            kernel.m_WholeV.data(),
                            kernel.m_FractionU.data(),
                            kernel.m_FractionV.data(),
                            kernel.m_Weight.data() };
  const auto        forEachRun = [&](auto && visit) {
    for (std::size_t run = kernel.m_BandBegin[band]; run < kernel.m_BandBegin[band + 1]; ++run)
    {
      visit(kernel.m_Runs[run].begin, kernel.m_Runs[run].end);
    }
  };
  const auto addTable = [&](auto taps) {
    forEachRun([&](std::size_t begin, std::size_t end) {
      AddTableSplats<decltype(taps)::value>(
        splats, begin, end, kernel.m_TableU, kernel.m_TableV, rows, endRow, endColumn);
    });
  };
  if (kernel.m_Method == MethodEnum::CubicSpline)
  {
    forEachRun([&](std::size_t begin, std::size_t end) { BinSplats<3>(splats, begin, end, rows, endRow, endColumn); });
  }
  else if (spline)
  {
    forEachRun([&](std::size_t begin, std::size_t end) { BinSplats<5>(splats, begin, end, rows, endRow, endColumn); });
  }
  else
  {
    switch (kernel.m_TableU.taps)
    {
      case 2:
        addTable(std::integral_constant<int, 2>{});
        break;
      case 4:
        addTable(std::integral_constant<int, 4>{});
        break;
      case 6:
        addTable(std::integral_constant<int, 6>{});
        break;
      case 8:
        addTable(std::integral_constant<int, 8>{});
        break;
      case 10:
        addTable(std::integral_constant<int, 10>{});
        break;
      case 12:
        addTable(std::integral_constant<int, 12>{});
        break;
      case 14:
        addTable(std::integral_constant<int, 14>{});
        break;
      default:
        addTable(std::integral_constant<int, 16>{});
    }
  }

  // The four copies' sum, for the splines filtered along the row; the scratch is left clean.
  const std::int32_t columns = endColumn - firstColumn;
  const auto         copyWidth = static_cast<std::size_t>(4 * rows.width);
  scratch.row.resize(static_cast<std::size_t>(columns) + FilterBlock);
  for (std::int32_t row = firstRow; row < endRow; ++row)
  {
    Float4 * const copies = rows.copies + 4 * static_cast<std::ptrdiff_t>(row - rows.firstRow) * rows.width;
    const float *  copy = reinterpret_cast<const float *>(copies) + (firstColumn - rows.firstColumn);
    float *        sum = scratch.row.data();
    for (std::int32_t i = 0; i < columns; ++i)
    {
      sum[i] = (copy[i] + (copy + copyWidth)[i - 1]) + ((copy + 2 * copyWidth)[i - 2] + (copy + 3 * copyWidth)[i - 3]);
    }
    if (spline)
    {
      float * const out = m_NodeValues.data() + (domain.startV + row - m_NodeRows.startV) * m_Reached.sizeU;
      FilterRow(sum, kernel.m_FilterU, out, static_cast<std::int32_t>(m_Reached.sizeU));
    }
    else
    {
      float * const out = m_Buffer + (domain.startV + row - m_Region.startV) * static_cast<std::int64_t>(m_Stride) +
                          (m_Reached.startU - m_Region.startU);
      for (std::int32_t i = 0; i < columns; ++i)
      {
        out[i] += sum[i];
      }
    }
  }
  std::fill_n(rows.copies, 4 * height * static_cast<std::size_t>(rows.width), Broadcast(0.0f));
  this->ReturnScratch(std::move(scratch));
}

void
SurfaceSplatKernel::Rendering::FilterColumns(std::size_t job)
{
  const std::int64_t begin = m_Reached.startV + static_cast<std::int64_t>(job) * BandHeight;
  const std::int64_t end = std::min(begin + BandHeight, m_Reached.startV + m_Reached.sizeV);
  for (std::int64_t row = begin; row < end; ++row)
  {
    float * out =
      m_Buffer + (row - m_Region.startV) * static_cast<std::int64_t>(m_Stride) + (m_Reached.startU - m_Region.startU);
    FilterColumn(m_NodeValues.data(),
                 m_NodeRows.sizeV,
                 row - m_NodeRows.startV,
                 m_Kernel.m_FilterV,
                 out,
                 static_cast<std::int32_t>(m_Reached.sizeU));
  }
}
} // namespace itk
