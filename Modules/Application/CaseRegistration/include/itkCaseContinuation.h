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
#ifndef itkCaseContinuation_h
#define itkCaseContinuation_h

#include "CaseRegistrationExport.h"
#include "itkDentalCase.h"

#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** \struct CaseContinuation
 * \brief What an earlier result says of how its case was registered, to go on from there.
 *
 * The result is a start as well (ReadInitialAlignment()). What a person had set stands here, as it stands in no case
 * file: who goes on sets it again, or something else in its place.
 *
 * \ingroup CaseRegistration
 */
struct CaseRegistration_EXPORT CaseContinuation
{
  /** result.json. */
  std::string resultFile;
  /** "" of a case that came out of no file, and where the case file is not there any more. */
  std::string caseFile;
  /** Of a case that options made: the case again, of the same files. Its warnings name those that have changed. */
  std::optional<DentalCase> description;
  /** Whether the case file is another than it was. */
  bool                     caseHasChanged{ false };
  std::vector<std::string> excludedTeeth;
  std::vector<std::string> fixed;
  /** "NAME=VALUE", for CaseRegistration::SetOption(). */
  std::vector<std::string> options;
  /** The landmarks that it was registered with, where the case file still is what it was. */
  std::string cephalometricLandmarksFile;

  /** Has the landmarks that stood in place of the case's stand there again. */
  void
  SetLandmarks(DentalCase & dentalCase) const;
};

/** Reads it from a result.json, or the folder that has one. `needsCase`: a case file that the result does not name, or
 * that is not there, is a DentalInputError, and so is a file of a case that options made. \ingroup CaseRegistration */
CaseRegistration_EXPORT CaseContinuation
ReadCaseContinuation(const std::string & name, bool needsCase);
} // namespace itk

#endif
