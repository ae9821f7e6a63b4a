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
#ifndef itkCrownPieces_h
#define itkCrownPieces_h

#include "itkTriangleSurface.h"

#include <cstdint>
#include <vector>

namespace itk
{
namespace CrownRegionParts
{
double
TriangleArea(const TriangleSurface & surface, std::size_t triangle);

/** Connected pieces of marked or of unmarked triangles below an area (mm^2) go to what surrounds them; loose specks,
 * that nothing surrounds, lose their marks. `ids` are those of SurfaceParts::Weld(). */
void
MergeSmallPieces(const TriangleSurface &            surface,
                 const std::vector<std::uint32_t> & ids,
                 double                             minimumArea,
                 std::vector<std::uint8_t> &        marks);
} // namespace CrownRegionParts
} // namespace itk

#endif
