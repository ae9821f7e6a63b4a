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
#ifndef itkVIATable_h
#define itkVIATable_h

#include "itkAnnotationRecords.h"

#include <string>

namespace itk
{
/** Not installed. Whether a file is the table that the VGG Image Annotator (VIA 1 and 2) exports as CSV, by its header.
 */
bool
IsVIATable(const std::string & fileName);

/** Every polyline and every point of one picture of such a table, whose cells are the JSON of VIA's other exports.
 * Throws DentalInputError. */
AnnotationRecords
ReadVIATable(const std::string & fileName, const std::string & imageName);
} // namespace itk

#endif
