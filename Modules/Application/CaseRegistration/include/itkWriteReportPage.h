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
#ifndef itkWriteReportPage_h
#define itkWriteReportPage_h

#include "CaseRegistrationExport.h"

#include <string>
#include <vector>

namespace itk
{
/** \struct ReportPageSettings
 * \brief How the page of a result that has been written is made. \ingroup CaseRegistration */
struct ReportPageSettings
{
  /** The page; "": report.html beside the result. */
  std::string fileName;
  /** The radiograph; "": where the result says that it was. */
  std::string imageFile;
  /** Without paths and names, as MakeAnonymous() has it. */
  bool anonymous{ false };
};

/** Writes the page of a result from what lies in its folder: result.json, report.json and the scans in the cephalostat
 * frame. `result` is the folder or its result.json. What is not there any more is left out of the page, and told in
 * what is returned, a sentence each. Throws DentalInputError where there is no result of this version.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT std::vector<std::string>
WriteReportPage(const std::string & result, const ReportPageSettings & settings = ReportPageSettings());
} // namespace itk

#endif
