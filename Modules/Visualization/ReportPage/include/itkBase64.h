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
#ifndef itkBase64_h
#define itkBase64_h

#include "ReportPageExport.h"

#include <cstddef>
#include <string>

namespace itk
{
/** RFC 4648, padded: how bytes travel in a data URI. \ingroup ReportPage */
ReportPage_EXPORT std::string
                  EncodeBase64(const void * bytes, std::size_t count);
} // namespace itk

#endif
