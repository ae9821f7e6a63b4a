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
#ifndef itkDistalTissue_h
#define itkDistalTissue_h

#include "itkTriangleSurface.h"

#include <cstdint>
#include <vector>

namespace itk
{
namespace CrownRegionParts
{
/** Tissue behind the last molar may stand as high as the teeth. A premolar or molar has a groove between its buccal and
 * lingual cusps, tissue has none: marks as gaps all stations behind the valley that follows the last grooved ones. */
void
CutDistalTissue(const TriangleSurface &           surface,
                const std::vector<std::uint8_t> & band,
                const std::vector<float> &        station,
                const std::vector<float> &        offset,
                const std::vector<float> &        depth,
                const std::vector<double> &       transverse,
                double                            front,
                std::vector<std::uint8_t> &       gap);
} // namespace CrownRegionParts
} // namespace itk

#endif
