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
#ifndef itkDentalCaseLoader_h
#define itkDentalCaseLoader_h

#include "CaseRegistrationExport.h"
#include "itkDentalCaseData.h"

#include <memory>

namespace itk
{
/** Reads every file that the case names but its 2-D landmarks: scans (converted to mm), tracing, radiograph, 3-D
 * landmarks; settles the nominal geometry by case file, DICOM, default, in that order. Throws DentalInputError.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT std::shared_ptr<DentalCaseData>
                        LoadDentalCase(const DentalCase & description);
} // namespace itk

#endif
