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
#ifndef itkCSVField_h
#define itkCSVField_h

#include "DentalCommonExport.h"

#include <string>

namespace itk
{
/** A text as a field of a table in CSV: quoted as RFC 4180 has it where it has to be, and with an apostrophe before it
 * where a spreadsheet would take it for a formula and run it (it begins with =, +, -, @, a tab or a carriage return and
 * is no number). Names come from others: of files, of cases, of landmarks.
 *
 * \ingroup DentalCommon */
DentalCommon_EXPORT std::string
                    ToCSVField(const std::string & text);
} // namespace itk

#endif
