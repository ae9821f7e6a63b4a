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
#ifndef itkScanForPage_h
#define itkScanForPage_h

#include "itkTriangleSurface.h"

#include <nlohmann/json_fwd.hpp>

namespace itk
{
/** A scan for the scene in space: about so many triangles, points as whole numbers of 16 bits.
 * {"points": base64, "triangles": base64, "wide": whether indices have 32 bits instead of 16, "origin": [x, y, z],
 * "step": mm}: point = origin + step * number, little endian. */
nlohmann::ordered_json
MakeScanForPage(const TriangleSurface & surface, unsigned int numberOfTriangles);
} // namespace itk

#endif
