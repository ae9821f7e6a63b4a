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
#ifndef itkMarginCut_h
#define itkMarginCut_h

#include "itkTriangleSurface.h"

#include <cstdint>
#include <vector>

namespace itk
{
namespace CrownRegionParts
{
/** Marks the crowns' triangles: a closed line of least cost on the surface about where the margin was found. Its length
 * costs little in a valley and much elsewhere, and each mm^2 on the wrong side of the found margin costs by distance.
 *
 * `ids` are those of SurfaceParts::Weld(); `winding` is +1 where triangles are wound outward, -1 inward; `inside` is
 * the height of each point above the found margin (mm), far below 0 away from the teeth; triangles further than `reach`
 * (mm) from it stay on their side. */
std::vector<std::uint8_t>
CutAtMargin(const TriangleSurface &            surface,
            const std::vector<std::uint32_t> & ids,
            double                             winding,
            const std::vector<float> &         inside,
            double                             reach);
} // namespace CrownRegionParts
} // namespace itk

#endif
