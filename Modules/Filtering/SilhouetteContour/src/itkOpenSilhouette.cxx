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
#include "itkOpenSilhouette.h"

#include "itkForEachKeptSample.h"

#include <algorithm>
#include <cmath>

namespace itk
{
OpenSilhouette
ComputeOpenSilhouette(const MeshSilhouette &        silhouette,
                      const PerspectiveProjection & projection,
                      const OpenSilhouetteOptions & options)
{
  OpenSilhouette   contour;
  const Silhouette boundary = silhouette.ComputeOuterBoundary(projection);
  const double     cosPitch = std::cos(options.pitch);
  const double     sinPitch = std::sin(options.pitch);
  const double     largest = boundary.loops.empty() ? 0.0 : boundary.loops.front().Area();
  const auto reach = static_cast<std::size_t>(std::max(1.0, std::floor(options.tangentReach / options.spacing + 0.5)));
  for (const SilhouetteLoop & loop : boundary.loops)
  {
    // Specks are no anatomy.
    if (loop.Area() < options.smallestPart * largest)
    {
      continue;
    }
    const std::vector<SilhouetteSample> samples = ResampleSilhouetteLoopBySpacing(loop, projection, options.spacing);
    const std::size_t                   n = samples.size();
    if (n < 2 * reach + 2)
    {
      continue;
    }
    // The polygon has the mesh's facets: tangents over some samples.
    std::vector<double> nu(n), nv(n);
    std::vector<char>   keep(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      double tu = 0.0, tv = 0.0;
      for (std::size_t d = 1; d <= reach; ++d)
      {
        const SilhouetteSample & a = samples[(i + n - d) % n];
        const SilhouetteSample & b = samples[(i + d) % n];
        tu += b.u - a.u;
        tv += b.v - a.v;
      }
      const double length = std::hypot(tu, tv);
      nu[i] = length > 1e-9 ? tv / length : samples[i].normal[0];
      nv[i] = length > 1e-9 ? -tu / length : samples[i].normal[1];
      keep[i] = !options.facingOnly || CanBeTraced(cosPitch * nu[i] + sinPitch * nv[i],
                                                   -sinPitch * nu[i] + cosPitch * nv[i],
                                                   options.jaw,
                                                   options.direction);
    }
    ForEachKeptSample(keep, [&](std::size_t i, bool begins) {
      if (begins)
      {
        contour.runs.push_back(contour.u.size());
      }
      contour.u.push_back(samples[i].u);
      contour.v.push_back(samples[i].v);
      contour.nu.push_back(nu[i]);
      contour.nv.push_back(nv[i]);
      contour.rim.push_back(samples[i].rim);
      if (options.keepEdges)
      {
        contour.edges.push_back(loop.edges[samples[i].segment]);
      }
    });
  }
  return contour;
}
} // namespace itk
