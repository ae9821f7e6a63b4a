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
#ifndef itkMillimetresPerUnit_h
#define itkMillimetresPerUnit_h

#include "DentalCommonExport.h"

#include <array>
#include <string>

namespace itk
{
/** A unit of a scan. \ingroup DentalCommon */
struct MeshUnit
{
  const char * name;        /**< As case files and options write it. */
  double       millimetres; /**< mm in one unit. */
};

/** All units that a scan may be in: the one table of them. \ingroup DentalCommon */
constexpr std::array<MeshUnit, 5> MeshUnits{
  { { "mm", 1.0 }, { "cm", 10.0 }, { "inch", 25.4 }, { "m", 1000.0 }, { "um", 0.001 } }
};

/** mm in a unit of a scan: "mm", "cm", "inch", "m" or "um". Throws std::invalid_argument for any other.
 * \ingroup DentalCommon */
DentalCommon_EXPORT double
MillimetresPerUnitFromString(const std::string & unit);
} // namespace itk

#endif
