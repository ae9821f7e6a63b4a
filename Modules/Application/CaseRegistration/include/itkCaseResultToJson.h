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
#ifndef itkCaseResultToJson_h
#define itkCaseResultToJson_h

#include "CaseRegistrationExport.h"
#include "itkCaseResult.h"

#include <string>
#include <vector>

namespace itk
{
/** The text of result.json (Documentation/FileFormats.md). \ingroup CaseRegistration */
CaseRegistration_EXPORT std::string
                        CaseResultToJson(const CaseResult & result);

/** The text of a list of findings as it stands there. \ingroup CaseRegistration */
CaseRegistration_EXPORT std::string
                        FindingsToJson(const std::vector<RegistrationFinding> & findings);
} // namespace itk

#endif
