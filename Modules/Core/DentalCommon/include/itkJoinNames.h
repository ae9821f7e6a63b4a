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
#ifndef itkJoinNames_h
#define itkJoinNames_h

#include "DentalCommonExport.h"

#include <string>
#include <vector>

namespace itk
{
/** Names for a sentence: "a, b and c"; "" of none, and of more than eight the first seven and how many more there are.
 *
 * \ingroup DentalCommon */
DentalCommon_EXPORT std::string
                    JoinNames(const std::vector<std::string> & names);
} // namespace itk

#endif
