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
#include "itkSilhouetteEdgeClusters.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** Planes are kept in 16 bits. */
constexpr float PlaneUnit = 32767.0f;

/** Asks for memory that will be read soon. */
inline void
Prefetch(const void * begin, std::size_t size = 1)
{
#ifdef __GNUC__
  for (std::size_t offset = 0; offset < size; offset += 64)
  {
    __builtin_prefetch(static_cast<const char *>(begin) + offset);
  }
#else
  (void)begin;
  (void)size;
#endif
}

/** -1 where the two faces run along the edge in the same direction, so that their outsides are opposite. */
inline float
TurnOf(const SilhouetteHalfEdge * half)
{
  return ((half[0].face ^ half[1].face) & 1u) == 0 ? -1.0f : 1.0f;
}

/** Eight bits to every fourth bit, of a number in [0, 1]. */
inline std::uint32_t
Spread(float x)
{
  auto bits = static_cast<std::uint32_t>(std::min(255.0f, std::max(0.0f, x * 256.0f)));
  bits = (bits | (bits << 12)) & 0x000f000fu;
  bits = (bits | (bits << 6)) & 0x03030303u;
  bits = (bits | (bits << 3)) & 0x11111111u;
  return bits;
}

/** Sorts by the upper 32 bits, equal ones as they come. */
void
SortByKey(std::vector<std::uint64_t> & values)
{
  constexpr unsigned int     Bits = 11;
  constexpr std::size_t      Buckets = std::size_t{ 1 } << Bits;
  std::vector<std::uint64_t> other(values.size());
  for (unsigned int shift = 32; shift < 64; shift += Bits)
  {
    std::array<std::uint32_t, Buckets> next{};
    for (const std::uint64_t value : values)
    {
      ++next[(value >> shift) & (Buckets - 1)];
    }
    std::uint32_t at = 0;
    for (std::uint32_t & count : next)
    {
      const std::uint32_t begin = at;
      at += count;
      count = begin;
    }
    for (const std::uint64_t value : values)
    {
      other[next[(value >> shift) & (Buckets - 1)]++] = value;
    }
    values.swap(other);
  }
}

inline std::int16_t
Quantize(float value)
{
  const float x = std::min(PlaneUnit, std::max(-PlaneUnit, value));
  return static_cast<std::int16_t>(static_cast<int>(x + std::copysign(0.5f, x)));
}
} // namespace

std::uint32_t
SilhouetteEdgeClusters::KeyOf(const SilhouetteRegularEdge &           edge,
                              const std::vector<SilhouetteHalfEdge> & halves,
                              const std::vector<SilhouetteFace> &     faces,
                              double                                  radius)
{
  // The source is far away in comparison with the surface, so that normals count more than distances.
  const float                      perDistance = 1.0f / (32.0f * static_cast<float>(radius));
  const SilhouetteHalfEdge * const half = &halves[edge.half];
  const SilhouetteFace &           first = faces[half[0].face / 2];
  const SilhouetteFace &           second = faces[half[1].face / 2];
  const float                      sign = TurnOf(half);
  std::uint32_t                    key = 0;
  for (unsigned int k = 0; k < 3; ++k)
  {
    key |= Spread(0.5f + 0.25f * (first.n[k] + sign * second.n[k])) << k;
  }
  key |= Spread(0.5f + (first.d + sign * second.d) * perDistance) << 3;
  return key;
}

void
SilhouetteEdgeClusters::Build(const std::vector<SilhouetteRegularEdge> & edges,
                              const std::vector<SilhouetteHalfEdge> &    halves,
                              const std::vector<SilhouetteFace> &        faces,
                              double                                     radius)
{
  m_Radius = static_cast<float>(radius);
  std::vector<std::uint64_t> order(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    order[i] = static_cast<std::uint64_t>(KeyOf(edges[i], halves, faces, radius)) << 32 | i;
  }
  SortByKey(order);

  const std::size_t clusters = (edges.size() + ClusterSize - 1) / ClusterSize;
  m_Edges.resize(clusters * ClusterSize);
  m_Blocks.resize(clusters * ClusterBlocks);
  m_BlockBounds.resize(clusters);
  for (std::vector<float> & bound : m_ClusterBounds)
  {
    bound.resize(clusters);
  }
  const float perRadius = PlaneUnit / m_Radius;
  for (std::size_t c = 0; c < clusters; ++c)
  {
    Planes planes;
    for (std::size_t i = 0; i < ClusterSize; ++i)
    {
      // They lie apart in memory: first the edge, then its half-edges, then its faces.
      const std::size_t at = c * ClusterSize + i;
      if (at + 24 < edges.size())
      {
        Prefetch(&edges[static_cast<std::uint32_t>(order[at + 24])]);
        Prefetch(&halves[edges[static_cast<std::uint32_t>(order[at + 16])].half]);
        const SilhouetteHalfEdge * const next = &halves[edges[static_cast<std::uint32_t>(order[at + 8])].half];
        Prefetch(&faces[next[0].face / 2]);
        Prefetch(&faces[next[1].face / 2]);
      }
      const SilhouetteRegularEdge &    edge = edges[static_cast<std::uint32_t>(order[std::min(at, edges.size() - 1)])];
      const SilhouetteHalfEdge * const half = &halves[edge.half];
      m_Edges[at] = { edge.point,
                      at < edges.size() ? half[0].other : edge.point,
                      { half[0].opposite, half[1].opposite } };
      for (unsigned int side = 0; side < 2; ++side)
      {
        const SilhouetteFace & face = faces[half[side].face / 2];
        const float            sign = side == 1 ? TurnOf(half) : 1.0f;
        const std::size_t      lane = 2 * i + side;
        planes.values[0][lane] = sign * face.n[0];
        planes.values[1][lane] = sign * face.n[1];
        planes.values[2][lane] = sign * face.n[2];
        planes.values[3][lane] = sign * face.d;
        planes.values[4][lane] = face.ratio;
        planes.values[5][lane] = face.inverseArea;
      }
    }
    const BoundsType whole = BoundsOf(planes, 0, 2 * ClusterSize);
    for (std::size_t k = 0; k < NumberOfBounds; ++k)
    {
      m_ClusterBounds[k][c] = whole[k];
    }
    for (std::size_t b = 0; b < ClusterBlocks; ++b)
    {
      const std::size_t first = 2 * BlockSize * b;
      const BoundsType  bounds = BoundsOf(planes, first, 2 * BlockSize);
      for (std::size_t k = 0; k < NumberOfBounds; ++k)
      {
        m_BlockBounds[c].values[k][b] = bounds[k];
      }
      Block & block = m_Blocks[c * ClusterBlocks + b];
      for (std::size_t i = 0; i < BlockSize; ++i)
      {
        for (unsigned int side = 0; side < 2; ++side)
        {
          const std::size_t lane = first + 2 * i + side;
          for (unsigned int k = 0; k < 3; ++k)
          {
            block.n[side][k][i] = Quantize(PlaneUnit * planes.values[k][lane]);
          }
          block.d[side][i] = Quantize(perRadius * planes.values[3][lane]);
        }
      }
    }
  }
}

/** The mean plane of some, and how far the others are from it. */
auto
SilhouetteEdgeClusters::BoundsOf(const Planes & planes, std::size_t begin, std::size_t count) -> BoundsType
{
  // Sums in four lanes, so that they are vectorised.
  constexpr std::size_t Lanes = 4;
  float                 mean[4];
  const float           weight = 1.0f / static_cast<float>(count);
  for (unsigned int k = 0; k < 4; ++k)
  {
    const float * const values = planes.values[k] + begin;
    float               sums[Lanes] = { 0.0f, 0.0f, 0.0f, 0.0f };
    for (std::size_t i = 0; i < count; i += Lanes)
    {
      for (std::size_t l = 0; l < Lanes; ++l)
      {
        sums[l] += values[i + l];
      }
    }
    mean[k] = weight * (sums[0] + sums[1] + sums[2] + sums[3]);
  }
  float squares[Lanes] = { 0.0f, 0.0f, 0.0f, 0.0f };
  float offsets[Lanes] = { 0.0f, 0.0f, 0.0f, 0.0f };
  float ratios[Lanes] = { 0.0f, 0.0f, 0.0f, 0.0f };
  float areas[Lanes] = { 0.0f, 0.0f, 0.0f, 0.0f };
  for (std::size_t i = 0; i < count; i += Lanes)
  {
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      const std::size_t at = begin + i + l;
      const float       x = planes.values[0][at] - mean[0];
      const float       y = planes.values[1][at] - mean[1];
      const float       z = planes.values[2][at] - mean[2];
      const float       square = x * x + y * y + z * z;
      const float       offset = std::abs(planes.values[3][at] - mean[3]);
      squares[l] = squares[l] < square ? square : squares[l];
      offsets[l] = offsets[l] < offset ? offset : offsets[l];
      ratios[l] = ratios[l] < planes.values[4][at] ? planes.values[4][at] : ratios[l];
      areas[l] = areas[l] < planes.values[5][at] ? planes.values[5][at] : areas[l];
    }
  }
  const auto largest = [](const float(&values)[Lanes]) { return *std::max_element(values, values + Lanes); };
  // Rounded up.
  return { mean[0],
           mean[1],
           mean[2],
           mean[3],
           1.00001f * std::sqrt(largest(squares)),
           1.00001f * largest(offsets),
           1.00001f * largest(ratios),
           1.00001f * largest(areas) };
}

/** By how much each set of planes has the source on one side, beyond doubt where positive. In a function of its own
 * with nothing to reload, so that it is vectorised. */
void
SilhouetteEdgeClusters::MeasureDecision(const SilhouettePlaneTest & test,
                                        const float * const         bounds[NumberOfBounds],
                                        std::size_t                 count,
                                        float *                     margins)
{
  const SilhouettePlaneTest t = test;
  const float * const       nx = bounds[0];
  const float * const       ny = bounds[1];
  const float * const       nz = bounds[2];
  const float * const       d = bounds[3];
  const float * const       radiusN = bounds[4];
  const float * const       radiusD = bounds[5];
  const float * const       ratio = bounds[6];
  const float * const       inverseArea = bounds[7];
  for (std::size_t i = 0; i < count; ++i)
  {
    const float value = std::abs(nx[i] * t.x + ny[i] * t.y + nz[i] * t.z - d[i]);
    const float bound =
      radiusN[i] * t.distance + radiusD[i] + t.perRatio * ratio[i] + t.perInverseArea * inverseArea[i] + t.slack;
    margins[i] = value - bound;
  }
}

/** Of each edge whether its faces may have the source on different sides (bits 0 to 7), and whether they have beyond
 * doubt (bits 8 to 15). */
std::uint32_t
SilhouetteEdgeClusters::ClassifyBlock(const Block & block, const SilhouettePlaneTest & test, float radius, float bound)
{
  static constexpr std::uint32_t Bit[BlockSize] = { 1, 2, 4, 8, 16, 32, 64, 128 };
  const SilhouettePlaneTest      t = test;
  float                          sides[2][BlockSize];
  for (unsigned int side = 0; side < 2; ++side)
  {
    const std::int16_t(&n)[3][BlockSize] = block.n[side];
    const std::int16_t(&d)[BlockSize] = block.d[side];
    for (std::size_t i = 0; i < BlockSize; ++i)
    {
      sides[side][i] = static_cast<float>(n[0][i]) * t.x + static_cast<float>(n[1][i]) * t.y +
                       static_cast<float>(n[2][i]) * t.z - static_cast<float>(d[i]) * radius;
    }
  }
  std::uint32_t result = 0;
  for (std::size_t i = 0; i < BlockSize; ++i)
  {
    const float low = sides[0][i] < sides[1][i] ? sides[0][i] : sides[1][i];
    const float high = sides[0][i] < sides[1][i] ? sides[1][i] : sides[0][i];
    // Not a number counts as undecided.
    const std::uint32_t apart = (low > bound) | (high < -bound);
    const std::uint32_t certain = (low < -bound) & (high > bound);
    result |= (apart - 1u) & Bit[i];
    result |= (0u - certain) & (Bit[i] << 8);
  }
  return result;
}

std::vector<std::uint32_t>
SilhouetteEdgeClusters::FindCandidates(const SilhouettePlaneTest & test) const
{
  std::vector<std::uint32_t> candidates;
  const std::size_t          clusters = m_BlockBounds.size();
  std::vector<float>         margins(clusters);
  const float *              clusterBounds[NumberOfBounds];
  for (std::size_t k = 0; k < NumberOfBounds; ++k)
  {
    clusterBounds[k] = m_ClusterBounds[k].data();
  }
  MeasureDecision(test, clusterBounds, clusters, margins.data());
  std::vector<std::uint32_t> active(clusters + 1);
  std::size_t                count = 0;
  for (std::size_t c = 0; c < clusters; ++c)
  {
    // Not a number counts as undecided.
    active[count] = static_cast<std::uint32_t>(c);
    count += margins[c] > 0.0f ? 0 : 1;
  }
  // Sixteen bits lose half a unit of each of the four numbers.
  const float blockSlack = 1.0f / PlaneUnit * (test.distance + m_Radius);
  candidates.resize(count * ClusterSize);
  std::size_t found = 0;
  for (std::size_t k = 0; k < count; ++k)
  {
    // They lie apart in memory.
    if (k + 6 < count)
    {
      const std::size_t ahead = active[k + 6];
      Prefetch(&m_BlockBounds[ahead], sizeof(BlockBounds));
      Prefetch(&m_Blocks[ahead * ClusterBlocks], ClusterBlocks * sizeof(Block));
    }
    const std::size_t c = active[k];
    const auto &      values = m_BlockBounds[c].values;
    const float *     blockBounds[NumberOfBounds];
    for (std::size_t j = 0; j < NumberOfBounds; ++j)
    {
      blockBounds[j] = values[j];
    }
    float blockMargins[ClusterBlocks];
    MeasureDecision(test, blockBounds, ClusterBlocks, blockMargins);
    for (std::size_t b = 0; b < ClusterBlocks; ++b)
    {
      if (blockMargins[b] > 0.0f)
      {
        continue;
      }
      const std::size_t at = c * ClusterBlocks + b;
      const float       bound =
        PlaneUnit * (test.perRatio * values[6][b] + test.perInverseArea * values[7][b] + test.slack + blockSlack);
      const std::uint32_t bits = ClassifyBlock(m_Blocks[at], test, m_Radius, bound);
      for (std::uint32_t i = 0; i < BlockSize; ++i)
      {
        candidates[found] = 2 * (static_cast<std::uint32_t>(at * BlockSize) + i) + ((bits >> (8 + i)) & 1u);
        found += (bits >> i) & 1u;
      }
    }
  }
  candidates.resize(found);
  return candidates;
}
} // namespace itk
