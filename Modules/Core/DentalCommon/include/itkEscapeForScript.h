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
#ifndef itkEscapeForScript_h
#define itkEscapeForScript_h

#include "DentalCommonExport.h"

#include <string>

namespace itk
{
/** A JSON text as it can stand in a script element of a page: no "<" in it ends the element, or begins a comment.
 * \ingroup DentalCommon */
DentalCommon_EXPORT std::string
                    EscapeForScript(const std::string & json);
} // namespace itk

#endif
