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
#include "itkSurfaceParts.h"

#include "itkDisjointSets.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace itk
{
std::vector<std::uint32_t>
SurfaceParts::Weld(const TriangleSurface & surface)
{
  // By open addressing: several times as fast as a map, and the same whatever the order of the hash.
  const std::size_t          size = surface.points.size();
  std::vector<std::uint32_t> first(size);
  {
    constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
    std::size_t             slots = 64;
    while (slots < 2 * size)
    {
      slots *= 2;
    }
    std::vector<std::uint32_t> table(slots, empty);
    for (std::uint32_t i = 0; i < size; ++i)
    {
      std::uint64_t hash = 0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double  value = surface.points[i][d] + 0.0; // -0 and 0 are one place
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof(value));
        hash = (hash ^ bits) * 0x9E3779B97F4A7C15ull;
        hash ^= hash >> 32;
      }
      std::size_t slot = hash & (slots - 1);
      while (table[slot] != empty && surface.points[table[slot]] != surface.points[i])
      {
        slot = (slot + 1) & (slots - 1);
      }
      if (table[slot] == empty)
      {
        table[slot] = i;
      }
      first[i] = table[slot];
    }
  }
  return first;
}

SurfaceParts::SurfaceParts(const TriangleSurface & surface)
  : m_WeldedPoints(Weld(surface))
{
  const std::size_t                  triangles = surface.triangles.size();
  const std::vector<std::uint32_t> & first = m_WeldedPoints;
  DisjointSets                       sets(surface.points.size());
  std::vector<PointType>             normals(triangles);
  std::vector<double>                areas(triangles, 0.0);
  for (std::size_t t = 0; t < triangles; ++t)
  {
    normals[t] = surface.AreaNormal(t);
    const double area =
      std::sqrt(normals[t][0] * normals[t][0] + normals[t][1] * normals[t][1] + normals[t][2] * normals[t][2]);
    if (!std::isfinite(area) || area <= 0.0)
    {
      continue;
    }
    areas[t] = area;
    const auto &  corners = surface.triangles[t];
    std::uint32_t root = first[corners[0]];
    for (unsigned int k = 1; k < 3; ++k)
    {
      root = sets.Join(root, first[corners[k]]);
    }
  }
  m_PartOfTriangle.assign(triangles, NoPart);
  std::vector<std::uint32_t> partOfRoot(surface.points.size(), NoPart);
  for (std::size_t t = 0; t < triangles; ++t)
  {
    if (areas[t] <= 0.0)
    {
      continue;
    }
    std::uint32_t & part = partOfRoot[sets.Find(first[surface.triangles[t][0]])];
    if (part == NoPart)
    {
      part = static_cast<std::uint32_t>(m_Parts.size());
      m_Parts.emplace_back();
    }
    m_PartOfTriangle[t] = part;
    m_Parts[part].area += areas[t];
    m_Area += areas[t];
    for (unsigned int d = 0; d < 3; ++d)
    {
      m_Parts[part].normal[d] += normals[t][d];
    }
  }
  m_IsPointKept.assign(surface.points.size(), 0);
  for (std::size_t t = 0; t < triangles; ++t)
  {
    if (this->IsKept(t))
    {
      for (const std::uint32_t corner : surface.triangles[t])
      {
        m_IsPointKept[corner] = 1;
      }
    }
  }
}

std::pair<double, double>
SurfaceParts::ComputeExtent(const TriangleSurface & surface, const PointType & direction) const
{
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    if (m_IsPointKept[i] != 0)
    {
      const PointType & p = surface.points[i];
      const double      along = direction[0] * p[0] + direction[1] * p[1] + direction[2] * p[2];
      low = std::min(low, along);
      high = std::max(high, along);
    }
  }
  return low > high ? std::make_pair(0.0, 0.0) : std::make_pair(low, high);
}
} // namespace itk
