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
#include "itkDentalFrameSamples.h"

#include "itkFlatKdTree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace itk
{
namespace DentalFrameKernel
{
namespace
{
std::uint32_t
Find(std::vector<std::uint32_t> & parent, std::uint32_t i)
{
  while (parent[i] != i)
  {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

/** Of each point the first that lies at the same place, by open addressing: it stands for all of them. */
std::vector<std::uint32_t>
Weld(const TriangleSurface & surface)
{
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
} // namespace

std::vector<Vector3>
FindRim(const TriangleSurface & surface)
{
  const std::vector<std::uint32_t> first = Weld(surface);
  std::vector<std::uint64_t>       edges;
  edges.reserve(3 * surface.triangles.size());
  for (const auto & triangle : surface.triangles)
  {
    for (unsigned int e = 0; e < 3; ++e)
    {
      const std::uint64_t a = first[triangle[e]];
      const std::uint64_t b = first[triangle[(e + 1) % 3]];
      if (a != b)
      {
        edges.push_back(std::min(a, b) << 32 | std::max(a, b));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Vector3> rim;
  for (std::size_t i = 0; i < edges.size();)
  {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next] == edges[i])
    {
      ++next;
    }
    if (next == i + 1)
    {
      rim.push_back(0.5 * (surface.points[edges[i] >> 32] + surface.points[edges[i] & 0xffffffffu]));
    }
    i = next;
  }
  return rim;
}

double
Quantile(std::vector<double> values, double fraction)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto k = std::min(values.size() - 1, static_cast<std::size_t>(fraction * static_cast<double>(values.size())));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values.end());
  return values[k];
}

Samples
TakeSamples(const TriangleSurface & surface, unsigned int count)
{
  const std::size_t                size = surface.points.size();
  const std::vector<std::uint32_t> first = Weld(surface);
  const std::size_t                triangles = surface.triangles.size();
  std::vector<double>              areas(triangles, 0.0);
  std::vector<Vector3>             faces(triangles);
  std::vector<Vector3>             normals(size, Vector3{ 0.0, 0.0, 0.0 });
  std::vector<std::uint32_t>       parent(size);
  for (std::uint32_t i = 0; i < size; ++i)
  {
    parent[i] = i;
  }
  for (std::size_t t = 0; t < triangles; ++t)
  {
    const Vector3 normal = surface.AreaNormal(t);
    const double  area = Norm(normal);
    if (!std::isfinite(area) || area <= 0.0)
    {
      continue;
    }
    areas[t] = area;
    faces[t] = normal;
    const auto & corners = surface.triangles[t];
    for (const std::uint32_t corner : corners)
    {
      normals[first[corner]] = normals[first[corner]] + normal;
      parent[Find(parent, first[corner])] = Find(parent, first[corners[0]]);
    }
  }
  // Specks: parts of less than 1.5 % of the surface. A single tooth without gingiva has more.
  std::vector<double> partArea(size, 0.0);
  double              total = 0.0;
  for (std::size_t t = 0; t < triangles; ++t)
  {
    if (areas[t] > 0.0)
    {
      partArea[Find(parent, first[surface.triangles[t][0]])] += areas[t];
      total += areas[t];
    }
  }

  Samples      samples;
  const double speck = 0.015 * total;
  double       kept = 0.0;
  for (std::size_t t = 0; t < triangles; ++t)
  {
    if (areas[t] > 0.0 && partArea[Find(parent, first[surface.triangles[t][0]])] < speck)
    {
      areas[t] = 0.0;
    }
    kept += areas[t];
  }
  if (kept <= 0.0 || count == 0)
  {
    return samples;
  }
  samples.area = kept;
  samples.points.reserve(count);
  samples.normals.reserve(count);
  double        cumulated = 0.0;
  std::uint32_t k = 0;
  for (std::size_t t = 0; t < triangles; ++t)
  {
    if (areas[t] <= 0.0)
    {
      continue;
    }
    cumulated += areas[t];
    const Vector3 & a = surface.points[surface.triangles[t][0]];
    const Vector3 & b = surface.points[surface.triangles[t][1]];
    const Vector3 & c = surface.points[surface.triangles[t][2]];
    samples.centroid = samples.centroid + (areas[t] / (3.0 * kept)) * (a + b + c);
    samples.netNormal = samples.netNormal + (1.0 / kept) * faces[t];
    for (; k < count && (k + 0.5) * kept / count < cumulated; ++k)
    {
      // Spread within the triangle by an additive recurrence (Roberts 2018): coarse meshes have many samples a
      // triangle.
      double u = std::fmod(0.5 + 0.7548776662466927 * (k + 1.0), 1.0);
      double v = std::fmod(0.5 + 0.5698402909980532 * (k + 1.0), 1.0);
      if (u + v > 1.0)
      {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      const double w = 1.0 - u - v;
      samples.points.push_back(w * a + u * b + v * c);
      const Vector3 smooth = w * Unit(normals[first[surface.triangles[t][0]]]) +
                             u * Unit(normals[first[surface.triangles[t][1]]]) +
                             v * Unit(normals[first[surface.triangles[t][2]]]);
      samples.normals.push_back(Norm(smooth) > 0.1 ? Unit(smooth) : Unit(faces[t]));
    }
  }

  const FlatKdTree<3> tree(samples.points);
  samples.roughness.reserve(samples.points.size());
  for (const Vector3 & p : samples.points)
  {
    Vector3     sum{ 0.0, 0.0, 0.0 };
    std::size_t neighbours = 0;
    tree.Within(p, 2.0, [&](std::uint32_t index, double) {
      sum = sum + samples.normals[index];
      ++neighbours;
    });
    samples.roughness.push_back(1.0 - Norm(sum) / static_cast<double>(std::max<std::size_t>(1, neighbours)));
    samples.meanRoughness += samples.roughness.back() / static_cast<double>(samples.points.size());
  }
  return samples;
}
} // namespace DentalFrameKernel
} // namespace itk
