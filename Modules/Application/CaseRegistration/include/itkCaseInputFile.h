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
#ifndef itkCaseInputFile_h
#define itkCaseInputFile_h

#include "CaseRegistrationExport.h"

#include <string>

namespace itk
{
/** \struct CaseInputFile
 * \brief One file that a case was made of, so that a result says what it is the result of.
 * \ingroup CaseRegistration
 */
struct CaseInputFile
{
  /** The case file's field for it: "upper"; "case" for the case file itself. */
  std::string field;
  /** As it was given: in a case file relative to it, on the command line from the current directory. */
  std::string path;
  /** Of its bytes, 64 hexadecimal digits. */
  std::string sha256;
};

/** SHA-256 of a file's bytes, 64 hexadecimal digits. Throws DentalInputError where it cannot be read.
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT std::string
                        ComputeFileSHA256(const std::string & fileName);

/** SHA-256 of bytes, 64 hexadecimal digits. \ingroup CaseRegistration */
CaseRegistration_EXPORT std::string
                        ComputeSHA256(const std::string & bytes);

/** What is recorded of a file. `folder` is that of the case file, "" for the command line: a name that was joined to it
 * is told as it was given, also where it leads out of the folder. \ingroup CaseRegistration */
CaseRegistration_EXPORT CaseInputFile
MakeCaseInputFile(const std::string & field, const std::string & fileName, const std::string & folder);
} // namespace itk

#endif
