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
#ifndef itkCaseJaws_h
#define itkCaseJaws_h

#include "itkCaseResult.h"
#include "itkDentalCaseData.h"

namespace itk
{
/** Not installed. Which jaws of a case its preset can register: these have an entry in CaseResult::jaws, the others one
 * in CaseResult::skipped that says what they lack. Where none can be, the scans' jaws are there and have failed. */
void
ChooseJaws(const DentalCaseData & data, CaseResult & result);

/** Not installed. A scan of which nothing was drawn goes along with the other jaw, where that one is registered and
 * both are in occlusion: it is skipped no longer. */
void
PlaceJawsBesideTheOther(const DentalCaseData & data, CaseResult & result);
} // namespace itk

#endif
