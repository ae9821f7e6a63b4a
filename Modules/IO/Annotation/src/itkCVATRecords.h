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
#ifndef itkCVATRecords_h
#define itkCVATRecords_h

#include "itkAnnotationRecords.h"

#include <string>

namespace itk
{
/** Not installed. Polylines, polygons and points of one picture of "CVAT for images 1.1". Throws DentalInputError, also
 * for entities that a document type declares: a few lines of them can stand for gigabytes. */
AnnotationRecords
ReadCVATRecords(const std::string & fileName, const std::string & imageName);
} // namespace itk

#endif
