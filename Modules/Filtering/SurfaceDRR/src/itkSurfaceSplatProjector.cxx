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
#include "itkSurfaceSplatKernel.h"
#include "itkSurfaceSplatRegions.h"
#include "itkSurfaceSplatRestrict.h"

#include "itkVectorClones.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace itk
{
// From points of the surface to splats: the one step that knows the projection.
namespace
{
using namespace SurfaceSplatDetail;

constexpr std::size_t ProjectedBlock = 64;

/** \return whether all points are finite and in front of the source. */
itkVectorClones bool
ProjectBlock(const SurfaceSplatProjector & projector,
             const double (*Restrict points)[3],
             const double * Restrict areas,
             int                     count,
             double                  factor,
             double * Restrict       us,
             double * Restrict       vs,
             float * Restrict        weights,
             double * Restrict       depths)
{
  const std::array<double, 12> m = projector.projection.matrix;
  const double                 magnification = projector.sourceToDetector / projector.sourceToMidsagittal;
  const double                 slopeU = projector.pixelSpacing[0] / projector.sourceToDetector;
  const double                 slopeV = projector.pixelSpacing[1] / projector.sourceToDetector;
  const double                 x0 = projector.principalPoint[0] * slopeU;
  const double                 y0 = projector.principalPoint[1] * slopeV;
  const double                 scaleU = projector.scale[0];
  const double                 scaleV = projector.scale[1];
  const double                 offsetU = projector.offset[0];
  const double                 offsetV = projector.offset[1];
  const double                 constant = projector.physical ? 0.0 : factor;
  const double                 physical = projector.physical ? factor * magnification * magnification : 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double x = points[i][0];
    const double y = points[i][1];
    const double z = points[i][2];
    const double depth = m[8] * x + m[9] * y + m[10] * z + m[11];
    const double inverse = 1.0 / depth;
    const double u = (m[0] * x + m[1] * y + m[2] * z + m[3]) * inverse;
    const double v = (m[4] * x + m[5] * y + m[6] * z + m[7]) * inverse;
    const double slope = u * slopeU - x0;
    const double rise = v * slopeV - y0;
    const double obliquity = std::sqrt(1.0 + slope * slope + rise * rise);
    us[i] = scaleU * u + offsetU;
    vs[i] = scaleV * v + offsetV;
    weights[i] = static_cast<float>(areas[i] * (constant + physical * inverse * inverse * obliquity));
    depths[i] = depth;
  }
  std::int64_t bad = 0;
  for (int i = 0; i < count; ++i)
  {
    // None is true of a value that is not a number.
    bad |= static_cast<std::int64_t>(!(depths[i] > 0.0)) |
           static_cast<std::int64_t>(!(std::abs(us[i]) <= LargestPosition)) |
           static_cast<std::int64_t>(!(std::abs(vs[i]) <= LargestPosition));
  }
  return bad == 0;
}
} // namespace

std::size_t
SurfaceSplatProjector::Project(const double (*points)[3],
                               const double *      areas,
                               std::size_t         first,
                               std::size_t         last,
                               double              factor,
                               SurfaceSplatLayer & layer) const
{
  // In blocks without a branch, which vectorise.
  for (std::size_t begin = first; begin < last; begin += ProjectedBlock)
  {
    const std::size_t end = std::min(begin + ProjectedBlock, last);
    double            depths[ProjectedBlock];
    if (!ProjectBlock(*this,
                      points + begin,
                      areas + begin,
                      static_cast<int>(end - begin),
                      factor,
                      layer.u.data() + begin,
                      layer.v.data() + begin,
                      layer.weight.data() + begin,
                      depths))
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (!(depths[i - begin] > 0.0) || !std::isfinite(layer.u[i]) || !std::isfinite(layer.v[i]))
        {
          return i;
        }
      }
    }
  }
  return last;
}
} // namespace itk
