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
#ifndef itkSurfaceSplatRegions_h
#define itkSurfaceSplatRegions_h

#include "itkSurfaceSplatKernel.h"

#include <algorithm>
#include <cstdint>
#include <limits>

// Rectangles of the image and what the parts of the kernel say of them alike: the height of a band, how far a position
// may be, which methods reach beyond a splat's own nodes. Private to this module.
namespace itk
{
namespace SurfaceSplatDetail
{
constexpr int    BandHeight = 32;
constexpr double LargestPosition = std::numeric_limits<double>::max();

inline SurfaceSplatRegion
Intersect(const SurfaceSplatRegion & a, const SurfaceSplatRegion & b)
{
  SurfaceSplatRegion result;
  result.startU = std::max(a.startU, b.startU);
  result.startV = std::max(a.startV, b.startV);
  result.sizeU = std::max<std::int64_t>(0, std::min(a.startU + a.sizeU, b.startU + b.sizeU) - result.startU);
  result.sizeV = std::max<std::int64_t>(0, std::min(a.startV + a.sizeV, b.startV + b.sizeV) - result.startV);
  if (result.sizeU == 0 || result.sizeV == 0)
  {
    result.sizeU = 0;
    result.sizeV = 0;
  }
  return result;
}

inline SurfaceSplatRegion
Dilate(SurfaceSplatRegion region, std::int64_t radiusU, std::int64_t radiusV)
{
  if (region.sizeU > 0 && region.sizeV > 0)
  {
    region.startU -= radiusU;
    region.startV -= radiusV;
    region.sizeU += 2 * radiusU;
    region.sizeV += 2 * radiusV;
  }
  return region;
}

inline bool
IsSpline(SurfaceSplatKernel::MethodEnum method)
{
  return method == SurfaceSplatKernel::MethodEnum::CubicSpline ||
         method == SurfaceSplatKernel::MethodEnum::QuinticSpline;
}
} // namespace SurfaceSplatDetail
} // namespace itk

#endif
