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
#ifndef itkKeepTriangles_h
#define itkKeepTriangles_h

#include "DentalCommonExport.h"
#include "itkTriangleSurface.h"

#include <cstdint>
#include <vector>

namespace itk
{
/** The triangles with a mark other than 0, one a triangle, with the points they use, numbered anew as they come. Throws
 * std::invalid_argument where the numbers differ. */
DentalCommon_EXPORT TriangleSurface
KeepTriangles(const TriangleSurface & surface, const std::vector<std::uint8_t> & marks);
} // namespace itk

#endif
