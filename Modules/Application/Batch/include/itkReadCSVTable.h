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
#ifndef itkReadCSVTable_h
#define itkReadCSVTable_h

#include "BatchExport.h"

#include <string>
#include <vector>

namespace itk
{
/** Rows of cells of a table of comma-separated values, the heading first; semicolons are taken where there is no comma
 * in that, as half of Europe writes it. \param text     of the file \param fileName that an error names:
 * DentalInputError for what is no such table, is not UTF-8, or has a quotation mark that is never closed, which would
 * take the rest of the table for one cell. \ingroup Batch */
Batch_EXPORT std::vector<std::vector<std::string>>
             ReadCSVTable(const std::string & text, const std::string & fileName);
} // namespace itk

#endif
