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
#ifndef itkRequireJsonName_h
#define itkRequireJsonName_h

#include "AnnotationExport.h"

#include <string>

namespace itk
{
/** Throws DentalInputError where the name of a file that JSON is to be written to is that of another format: whoever
 * asks for contours.csv would get a file that no reader of tables takes. `what` says what is written: "contours". An
 * empty name, and one without an extension, pass.
 *
 * \ingroup Annotation */
Annotation_EXPORT void
RequireJsonName(const std::string & fileName, const std::string & what);
} // namespace itk

#endif
