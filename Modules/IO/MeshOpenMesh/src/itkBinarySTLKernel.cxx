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
#include "itkBinarySTLKernel.h"

#include "itkScanFile.h"
#include "itkSurfaceMeshFile.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#if defined(__linux__)
#  include <sys/mman.h>
#endif

namespace itk
{
namespace
{
constexpr std::size_t   HeaderSize = 84;
constexpr std::size_t   FacetSize = 50;
constexpr std::size_t   FacetsPerBatch = 16;
constexpr std::size_t   CornersPerBatch = 3 * FacetsPerBatch;
constexpr std::uint32_t EmptySlot = 0xffffffffu;

using KeyType = std::array<std::uint32_t, 3>;

std::uint32_t
LoadLittleEndian(const char * bytes)
{
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  std::uint32_t value;
  std::memcpy(&value, bytes, 4);
  return value;
#else
  const auto * b = reinterpret_cast<const unsigned char *>(bytes);
  return b[0] | b[1] << 8 | b[2] << 16 | static_cast<std::uint32_t>(b[3]) << 24;
#endif
}

void
Prefetch(const void * address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}

/** Takes a vector's memory in huge pages where the system has them: a fifth of the time goes into page faults and
 * address translation else. */
template <typename T>
void
ReserveHuge(std::vector<T> & vector, std::size_t count)
{
  vector.reserve(count);
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t page = std::uintptr_t{ 1 } << 21;
  const auto               begin = (reinterpret_cast<std::uintptr_t>(vector.data()) + page - 1) / page * page;
  const auto               end = reinterpret_cast<std::uintptr_t>(vector.data() + vector.capacity()) / page * page;
  if (begin < end)
  {
    // Advice: whether it is taken does not matter.
    static_cast<void>(::madvise(reinterpret_cast<void *>(begin), end - begin, MADV_HUGEPAGE));
  }
#endif
}

std::uint64_t
Hash(const KeyType & key)
{
  std::uint64_t h = (key[0] | static_cast<std::uint64_t>(key[1]) << 32) * 0x9e3779b97f4a7c15ULL;
  h ^= h >> 29;
  h = (h + key[2]) * 0xbf58476d1ce4e5b9ULL;
  return h ^ (h >> 32);
}

/** Point numbers by coordinates: open addressing, the points themselves are the keys. */
class PointTable
{
public:
  explicit PointTable(std::size_t expectedPoints)
  {
    std::size_t slots = 1024;
    while (slots < 4 * expectedPoints)
    {
      slots *= 2;
    }
    ReserveHuge(m_Slots, slots);
    m_Slots.assign(slots, EmptySlot);
    ReserveHuge(m_Points, expectedPoints + expectedPoints / 8 + CornersPerBatch);
  }

  /** Makes room for that many more points; slots that were looked up before are to be looked up again. */
  void
  Reserve(std::size_t count)
  {
    if (2 * (m_Points.size() + count) > m_Slots.size())
    {
      this->Grow();
    }
  }

  void
  PrefetchSlot(std::uint64_t hash) const
  {
    Prefetch(&m_Slots[this->GetSlot(hash)]);
  }

  void
  PrefetchPoint(std::uint64_t hash) const
  {
    const std::uint32_t number = m_Slots[this->GetSlot(hash)];
    if (number != EmptySlot)
    {
      Prefetch(&m_Points[number]);
    }
  }

  /** The number of the point, which is added where it is new. */
  std::uint32_t
  Insert(const KeyType & key, std::uint64_t hash)
  {
    for (std::size_t slot = this->GetSlot(hash);; slot = (slot + 1) & (m_Slots.size() - 1))
    {
      const std::uint32_t number = m_Slots[slot];
      if (number == EmptySlot)
      {
        const auto           added = static_cast<std::uint32_t>(m_Points.size());
        std::array<float, 3> point;
        std::memcpy(point.data(), key.data(), sizeof(point));
        m_Points.push_back(point);
        m_Slots[slot] = added;
        return added;
      }
      if (std::memcmp(m_Points[number].data(), key.data(), sizeof(KeyType)) == 0)
      {
        return number;
      }
    }
  }

  std::vector<std::array<float, 3>> &
  GetPoints()
  {
    return m_Points;
  }

private:
  std::size_t
  GetSlot(std::uint64_t hash) const
  {
    return static_cast<std::size_t>(hash) & (m_Slots.size() - 1);
  }

  void
  Grow()
  {
    const std::size_t slots = 2 * m_Slots.size();
    m_Slots = {};
    ReserveHuge(m_Slots, slots);
    m_Slots.assign(slots, EmptySlot);
    for (std::size_t number = 0; number < m_Points.size(); ++number)
    {
      KeyType key;
      std::memcpy(key.data(), m_Points[number].data(), sizeof(key));
      std::size_t slot = this->GetSlot(Hash(key));
      while (m_Slots[slot] != EmptySlot)
      {
        slot = (slot + 1) & (m_Slots.size() - 1);
      }
      m_Slots[slot] = static_cast<std::uint32_t>(number);
    }
  }

  std::vector<std::uint32_t>        m_Slots;
  std::vector<std::array<float, 3>> m_Points;
};

struct BatchType
{
  std::size_t   facets{ 0 };
  KeyType       keys[CornersPerBatch];
  std::uint64_t hashes[CornersPerBatch];
};

/** \return false where a coordinate is not finite. */
bool
Decode(const char * facetBytes, std::size_t facets, BatchType & batch)
{
  std::uint32_t notFinite = 0;
  batch.facets = facets;
  for (std::size_t facet = 0; facet < facets; ++facet)
  {
    const char * corner = facetBytes + facet * FacetSize + 12;
    for (std::size_t c = 0; c < 3; ++c)
    {
      KeyType & key = batch.keys[3 * facet + c];
      for (std::size_t d = 0; d < 3; ++d, corner += 4)
      {
        const std::uint32_t bits = LoadLittleEndian(corner);
        notFinite |= static_cast<std::uint32_t>((bits & 0x7f800000u) == 0x7f800000u);
        key[d] = bits == 0x80000000u ? 0u : bits;
      }
      batch.hashes[3 * facet + c] = Hash(key);
    }
  }
  return notFinite == 0;
}

std::size_t
CheckedFacetCount(const char * bytes, std::size_t size)
{
  const std::string remedy = "export or copy the scan again";
  if (size < HeaderSize)
  {
    throw SurfaceMeshFileError(
      "", "has " + std::to_string(size) + " bytes; a binary STL has at least " + std::to_string(HeaderSize), remedy);
  }
  const std::uint64_t count = LoadLittleEndian(bytes + 80);
  const std::uint64_t expected = HeaderSize + FacetSize * count;
  // A whole number of facets too many means that the count is wrong; so does a rest that is larger than what it counts.
  const bool trailing = size > expected && (size - expected) % FacetSize != 0 && size - expected <= FacetSize * count;
  if (size != expected && !trailing)
  {
    throw SurfaceMeshFileError("",
                               std::string(size < expected ? "is truncated" : "is too long") + ": " +
                                 std::to_string(count) + " facets need " + std::to_string(expected) +
                                 " bytes, the file has " + std::to_string(size),
                               remedy);
  }
  if (count == 0)
  {
    throw SurfaceMeshFileError("", "has no triangles", remedy);
  }
  if (count > (EmptySlot - 1) / 3)
  {
    throw SurfaceMeshFileError(
      "", "has " + std::to_string(count) + " facets, more than can be numbered", "decimate it");
  }
  return static_cast<std::size_t>(count);
}

[[noreturn]] void
ThrowNotFinite(const char * bytes, std::size_t firstFacet, std::size_t facets)
{
  for (std::size_t facet = firstFacet; facet < firstFacet + facets; ++facet)
  {
    for (unsigned int i = 0; i < 9; ++i)
    {
      const std::uint32_t bits = LoadLittleEndian(bytes + HeaderSize + facet * FacetSize + 12 + 4 * i);
      if ((bits & 0x7f800000u) == 0x7f800000u)
      {
        throw SurfaceMeshFileError("facet " + std::to_string(facet + 1),
                                   std::string("corner ") + std::to_string(i / 3 + 1) + " has a coordinate that is " +
                                     ((bits & 0x007fffffu) != 0 ? "not a number" : "infinite"),
                                   "repair the mesh in the scanner's software");
      }
    }
  }
  throw SurfaceMeshFileError("", "a coordinate is not finite", "repair the mesh in the scanner's software");
}
} // namespace

WeldedTriangles
ParseBinarySTL(const char * bytes, std::size_t size)
{
  const std::size_t facets = CheckedFacetCount(bytes, size);
  WeldedTriangles   result;
  result.numberOfFacets = facets;
  result.numberOfTrailingBytes = size - HeaderSize - FacetSize * facets;
  ReserveHuge(result.triangles, facets);
  result.triangles.resize(facets);
  // A closed surface has half as many points as triangles.
  PointTable        table(facets / 2);
  std::size_t       kept = 0;
  const std::size_t batches = (facets + FacetsPerBatch - 1) / FacetsPerBatch;
  BatchType         ring[3];
  // A pipeline of three batches, so that the cache misses of look-ups overlap with work: decode and fetch the slots of
  // one, fetch the points of the one before, compare and insert the one before that.
  for (std::size_t step = 0; step < batches + 2; ++step)
  {
    if (step < batches)
    {
      const std::size_t first = step * FacetsPerBatch;
      const std::size_t count = std::min(FacetsPerBatch, facets - first);
      BatchType &       batch = ring[step % 3];
      if (!Decode(bytes + HeaderSize + first * FacetSize, count, batch))
      {
        ThrowNotFinite(bytes, first, count);
      }
      for (std::size_t i = 0; i < 3 * count; ++i)
      {
        table.PrefetchSlot(batch.hashes[i]);
      }
    }
    if (step >= 1 && step <= batches)
    {
      const BatchType & batch = ring[(step - 1) % 3];
      for (std::size_t i = 0; i < 3 * batch.facets; ++i)
      {
        table.PrefetchPoint(batch.hashes[i]);
      }
    }
    if (step >= 2)
    {
      const BatchType & batch = ring[(step - 2) % 3];
      table.Reserve(3 * batch.facets);
      for (std::size_t facet = 0; facet < batch.facets; ++facet)
      {
        const std::uint32_t a = table.Insert(batch.keys[3 * facet], batch.hashes[3 * facet]);
        const std::uint32_t b = table.Insert(batch.keys[3 * facet + 1], batch.hashes[3 * facet + 1]);
        const std::uint32_t c = table.Insert(batch.keys[3 * facet + 2], batch.hashes[3 * facet + 2]);
        result.triangles[kept] = { a, b, c };
        kept += static_cast<std::size_t>(a != b && b != c && c != a);
      }
    }
  }
  if (kept == 0)
  {
    throw SurfaceMeshFileError("",
                               "all of its " + std::to_string(facets) + " facets have two corners in one point",
                               "check the unit and the number of digits of the export");
  }
  result.triangles.resize(kept);
  result.numberOfDegenerateFacets = facets - kept;
  result.points = std::move(table.GetPoints());
  return result;
}

WeldedTriangles
ReadBinarySTL(const char * fileName)
{
  const ScanFile file(fileName);
  return ParseBinarySTL(file.GetData(), file.GetSize());
}

std::vector<std::array<float, 4>>
ComputeNormalsAndAreas(const std::vector<std::array<float, 3>> &         points,
                       const std::vector<std::array<std::uint32_t, 3>> & triangles)
{
  std::vector<std::array<float, 4>> sums;
  ReserveHuge(sums, points.size());
  sums.assign(points.size(), std::array<float, 4>{ 0.0f, 0.0f, 0.0f, 0.0f });
  for (const std::array<std::uint32_t, 3> & triangle : triangles)
  {
    const std::array<float, 3> & a = points[triangle[0]];
    const std::array<float, 3> & b = points[triangle[1]];
    const std::array<float, 3> & c = points[triangle[2]];
    const float                  u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const float                  v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
    const float n[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
    // Twice the area.
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (const std::uint32_t corner : triangle)
    {
      std::array<float, 4> & sum = sums[corner];
      sum[0] += n[0];
      sum[1] += n[1];
      sum[2] += n[2];
      sum[3] += length;
    }
  }
  for (std::array<float, 4> & sum : sums)
  {
    const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    const float scale = length > 0.0f ? 1.0f / length : 0.0f;
    sum = { sum[0] * scale, sum[1] * scale, sum[2] * scale, sum[3] / 6.0f };
  }
  return sums;
}
} // namespace itk
