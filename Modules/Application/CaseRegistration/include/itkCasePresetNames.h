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
#ifndef itkCasePresetNames_h
#define itkCasePresetNames_h

#include "CaseRegistrationExport.h"

#include <string>
#include <vector>

namespace itk
{
/** The names of all presets (CasePresetEnum) as a command line takes them, the default first.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT const std::vector<std::string> &
                              GetCasePresetNames();
} // namespace itk

#endif
