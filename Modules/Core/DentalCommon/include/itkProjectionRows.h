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
#ifndef itkProjectionRows_h
#define itkProjectionRows_h

#include "DentalCommonExport.h"

#include <array>

namespace itk
{
/** What maps points of another unit: the first three columns of a row-major 3x4 times a factor. \ingroup DentalCommon
 */
DentalCommon_EXPORT std::array<double, 12>
                    ScaleColumns(const std::array<double, 12> & matrix, double factor);

/** Product of a row-major 3x4 and the inverse of a rigid one. \ingroup DentalCommon */
DentalCommon_EXPORT std::array<double, 12>
                    TimesRigidInverse(const std::array<double, 12> & matrix, const std::array<double, 12> & rigid);
} // namespace itk

#endif
