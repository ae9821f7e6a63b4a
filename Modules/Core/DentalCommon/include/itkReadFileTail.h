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
#ifndef itkReadFileTail_h
#define itkReadFileTail_h

#include "DentalCommonExport.h"

#include <cstddef>
#include <string>

namespace itk
{
/** The last bytes of a file, where archives have their directories; nothing of what is no regular file. All of the file
 * is read to come there. \ingroup DentalCommon */
DentalCommon_EXPORT std::string
                    ReadFileTail(const std::string & fileName, std::size_t size);
} // namespace itk

#endif
