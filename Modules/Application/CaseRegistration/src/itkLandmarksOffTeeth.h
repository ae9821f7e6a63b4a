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
#ifndef itkLandmarksOffTeeth_h
#define itkLandmarksOffTeeth_h

#include "itkCaseResult.h"
#include "itkDentalCaseData.h"

#include <string>
#include <vector>

namespace itk
{
/** Landmarks of the scan that the result puts on another tooth of the tracing than their own, one by one: a sentence a
 * jaw. A landmark is looked at where the tracing has a line with its tooth's code, of one side and not of the middle
 * between both. Along the row of teeth it lies in the middle of that line's extent, a molar's cusps before or behind
 * it, or off by no more than half a tooth. So are middles of posterior teeth that were found on the scan by their place
 * along the arch, a sentence each. */
std::vector<std::string>
DescribeLandmarksOffTeeth(const DentalCaseData & data, const CaseResult & result);
} // namespace itk

#endif
