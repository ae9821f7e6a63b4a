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
#include "itkScanForPage.h"

#include "itkBase64.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <meshoptimizer.h>

namespace itk
{
namespace
{
/** How far the simplified surface may be away, as a share of the scan's extent: a scan of which this many triangles
 * cannot be had without leaving it by more keeps more of them. */
constexpr float LargestError = 0.02F;
/** A scan with more than so many times the triangles is first clustered to so many: by quadrics alone it would take
 * twice as long, and clusters of a sixth of a millimetre are not seen in what is left. */
constexpr std::size_t ClusteredShare = 3;
} // namespace

nlohmann::ordered_json
MakeScanForPage(const TriangleSurface & surface, unsigned int numberOfTriangles)
{
  std::vector<float> points;
  points.reserve(3 * surface.points.size());
  for (const auto & point : surface.points)
  {
    for (const double x : point)
    {
      points.push_back(static_cast<float>(x));
    }
  }
  std::vector<unsigned int> indices;
  indices.reserve(3 * surface.triangles.size());
  for (const auto & triangle : surface.triangles)
  {
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  }
  const std::size_t target = 3 * static_cast<std::size_t>(numberOfTriangles);
  if (indices.size() > target)
  {
    std::vector<unsigned int> simple(indices.size());
    float                     error = 0.0F;
    if (indices.size() > ClusteredShare * target)
    {
      simple.resize(meshopt_simplifySloppy(simple.data(),
                                           indices.data(),
                                           indices.size(),
                                           points.data(),
                                           surface.points.size(),
                                           3 * sizeof(float),
                                           ClusteredShare * target,
                                           LargestError,
                                           &error));
      std::swap(indices, simple);
      simple.resize(indices.size());
    }
    simple.resize(meshopt_simplify(simple.data(),
                                   indices.data(),
                                   indices.size(),
                                   points.data(),
                                   surface.points.size(),
                                   3 * sizeof(float),
                                   target,
                                   LargestError,
                                   0,
                                   &error));
    indices = std::move(simple);
  }
  // What no triangle uses any more is not to travel.
  const std::size_t count = meshopt_optimizeVertexFetch(
    points.data(), indices.data(), indices.size(), points.data(), surface.points.size(), 3 * sizeof(float));
  points.resize(3 * count);

  std::array<float, 3> low{ { 0, 0, 0 } };
  float                extent = 0.0F;
  for (std::size_t d = 0; d < 3 && count > 0; ++d)
  {
    low[d] = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
    for (std::size_t i = d; i < points.size(); i += 3)
    {
      low[d] = std::min(low[d], points[i]);
      high = std::max(high, points[i]);
    }
    extent = std::max(extent, high - low[d]);
  }
  constexpr float            largest = 65535.0F;
  const float                step = extent > 0.0F ? extent / largest : 1.0F;
  std::vector<std::uint16_t> numbers(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    numbers[i] = static_cast<std::uint16_t>(std::clamp(std::round((points[i] - low[i % 3]) / step), 0.0F, largest));
  }
  nlohmann::ordered_json json = { { "points", EncodeBase64(numbers.data(), 2 * numbers.size()) },
                                  { "origin", { low[0], low[1], low[2] } },
                                  { "step", step },
                                  { "wide", count > 65536 } };
  if (count > 65536)
  {
    json["triangles"] = EncodeBase64(indices.data(), 4 * indices.size());
  }
  else
  {
    const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
    json["triangles"] = EncodeBase64(narrow.data(), 2 * narrow.size());
  }
  return json;
}
} // namespace itk
