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
#ifndef itkTextFile_h
#define itkTextFile_h

#include "AnnotationExport.h"

#include <cstddef>
#include <string>

namespace itk
{
/** The whole of a small file. Throws DentalInputError for a file that is missing, no regular file, not readable, empty,
 * longer than the cap, or changed while it is read; `what` names in the messages what was expected, with its article:
 * "a JSON file".
 *
 * \ingroup Annotation */
Annotation_EXPORT std::string
ReadTextFile(const std::string & fileName, const std::string & what, std::size_t maximumSize = 32u << 20);

/** Writes a file that appears whole or not at all (OutputFile): a temporary beside it is renamed over it. An existing
 * file is replaced, a symbolic link too; a device or a pipe is written to. Throws DentalInputError that names the file;
 * no temporary is left then.
 *
 * \ingroup Annotation */
Annotation_EXPORT void
WriteFileAtomically(const std::string & fileName, const std::string & content);
} // namespace itk

#endif
