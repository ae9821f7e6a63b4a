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
#ifndef itkMidlineSide_h
#define itkMidlineSide_h

#include "UMidlineDentalAxisExport.h"
#include "itkTriangleSurface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** 1 where a triangle's centre c has side * (c - origin).lateral < margin: side +1 keeps the patient's right, -1 the
 * left, and a positive margin (mm) a strip beyond the plane. `lateral` is the UMDA frame's y axis and `origin` a point
 * of its midline plane, both in the surface's frame. The one rule of MidlineSideMeshFilter and of the robust
 * registration. */
UMidlineDentalAxis_EXPORT std::vector<std::uint8_t>
                          SelectMidlineSide(const TriangleSurface &       surface,
                                            const std::array<double, 3> & lateral,
                                            const std::array<double, 3> & origin,
                                            double                        side,
                                            double                        margin);
} // namespace itk

#endif
