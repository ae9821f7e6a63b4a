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
#ifndef itkAddedRadiograph_h
#define itkAddedRadiograph_h

#include "itkPoseProblem.h"

#include <string>

namespace itk
{
/** Not installed. Why a hypothesis that reads the radiograph in another way cannot be tried: a term that was added has
 * a geometry of its own, which nobody could change with the first view's. Empty where there is none. \param what  what
 * its radiograph has, to end the sentence "the added ClassName ..." */
std::string
DescribeAddedRadiograph(const PoseProblem & problem, const std::string & what);
} // namespace itk

#endif
