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
#ifndef itkMakeAnonymous_h
#define itkMakeAnonymous_h

#include "CaseRegistrationExport.h"
#include "itkCaseResult.h"

#include <string>
#include <vector>

namespace itk
{
/** The same result without what tells whose it is: no paths, no names of files or folders, no command line. Where a
 * sentence has such a name the input's field stands instead ("<upper>"). Hashes stay: they tell nobody anything who has
 * not the files. What is burnt into the radiograph's own pixels is not touched. \ingroup CaseRegistration */
CaseRegistration_EXPORT CaseResult
MakeAnonymous(const CaseResult & result);

/** The same of the text of a report.json: it has no more than the command line that tells it. \ingroup CaseRegistration
 */
CaseRegistration_EXPORT std::string
                        MakeReportDetailsAnonymous(const std::string & json);

/** The same of the text of a result.json. \ingroup CaseRegistration */
CaseRegistration_EXPORT std::string
                        MakeResultFileAnonymous(const std::string & json);
} // namespace itk

#endif
