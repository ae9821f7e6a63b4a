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
#ifndef itkCaseOverlay_h
#define itkCaseOverlay_h

#include "CaseRegistrationExport.h"

#include "itkCaseResult.h"
#include "itkRegistrationOverlayFilter.h"

#include <string>

namespace itk
{
/** The picture of one jaw, to be updated: radiograph, tracing, aligned silhouette, landmarks where known, errors
 * printed. Throws std::out_of_range for a jaw that the result has not. \ingroup CaseRegistration */
CaseRegistration_EXPORT RegistrationOverlayFilter::Pointer
                        MakeCaseOverlay(const CaseResult & result, ToothCode::JawEnum jaw);

/** Writes it as PNG. \ingroup CaseRegistration */
CaseRegistration_EXPORT void
WriteCaseOverlay(const CaseResult & result, ToothCode::JawEnum jaw, const std::string & fileName);
} // namespace itk

#endif
