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
#ifndef itkCaseChecks_h
#define itkCaseChecks_h

#include "itkCaseResult.h"
#include "itkDentalFrameEstimator.h"

namespace itk
{
/** Openness (DentalJawFrame) up to which a scan counts as a closed body, whose winding says nothing. */
constexpr double OpennessOfClosedCast = 0.2;

/** What can be said of the inputs before any registration: wrong unit, exchanged jaws, mirrored scan, unsure frame.
 * Adds reasons to the jaws, and to notCheckable what the data can't tell. */
void
CheckCase(const DentalCaseData & data, const DentalFrameResult & frames, CaseResult & result);
} // namespace itk

#endif
