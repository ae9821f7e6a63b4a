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
#ifndef itkCaseResultWriter_h
#define itkCaseResultWriter_h

#include "CaseRegistrationExport.h"
#include "itkCaseResult.h"

#include <functional>
#include <string>

namespace itk
{
class OutputFolder;

/** \struct CaseOutputOptions
 * \brief What of a result is written. \ingroup CaseRegistration */
struct CaseOutputOptions
{
  /** What is for people: overlays, scans, the page and what it is drawn by. */
  bool report{ true };
  /** The page, where there is a report. */
  bool page{ true };
  /** Without paths and names (MakeAnonymous()). */
  bool anonymous{ false };
  /** Called between files. What it throws ends the writing, and the folder stays as it was. */
  std::function<void()> between;
};

/** Takes the files of an earlier result out of a folder, and leaves all others alone. \ingroup CaseRegistration */
CaseRegistration_EXPORT void
RemoveCaseResult(const std::string & folderName);

/** Writes everything that a result is made of into a folder: result.json, overlays, scans in the cephalostat frame,
 * transforms, the page. Made aside and moved when complete: the files of an earlier run are replaced, and where
 * result.json is, everything is. Throws DentalInputError where the folder can't be written.
 *
 * \param options what is written beside result.json and the transforms
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT void
WriteCaseResult(const CaseResult &        result,
                OutputFolder &            folder,
                const CaseOutputOptions & options = CaseOutputOptions());

/** The same into a folder that is owned for as long as this takes. \ingroup CaseRegistration */
CaseRegistration_EXPORT void
WriteCaseResult(const CaseResult &        result,
                const std::string &       folder,
                const CaseOutputOptions & options = CaseOutputOptions());

/** Writes the rigid map from a scan (mm) to its UMDA frame, row-major 3x4, as an ITK transform that Slicer loads
 * safely.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT void
WriteUMDATransform(const std::array<double, 12> & meshToUMDA, const std::string & fileName);
} // namespace itk

#endif
