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
#ifndef itkMakeUTF8_h
#define itkMakeUTF8_h

#include "DentalCommonExport.h"

#include <string>

namespace itk
{
/** Text in UTF-8: what is none is taken for ISO 8859-1, byte by byte, as spreadsheets of western Europe save tables,
 * and what is in UTF-8 stays as it is. For what files hold and messages repeat: JSON and Python take nothing else.
 *
 * \ingroup DentalCommon */
DentalCommon_EXPORT std::string
                    MakeUTF8(const std::string & text);
} // namespace itk

#endif
