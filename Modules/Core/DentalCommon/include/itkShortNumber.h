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
#ifndef itkShortNumber_h
#define itkShortNumber_h

#include "DentalCommonExport.h"

#include <string>

namespace itk
{
/** A number for a sentence: six digits at most, with an exponent where it is far from 1, in any locale. What was
 * mistaken in a file may be 1e300, which std::to_string() writes out.
 *
 * \ingroup DentalCommon */
DentalCommon_EXPORT std::string
                    ShortNumber(double value);
} // namespace itk

#endif
