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
#ifndef itkSortFindings_h
#define itkSortFindings_h

#include "PoseRegistrationExport.h"
#include "itkRegistrationFinding.h"

#include <string>
#include <vector>

namespace itk
{
/** Where a finding stands by how much of the others it explains: first what is wrong with a file or with its reading,
 * from which all else follows, one code before the other; then what a side or a name may be; then how the fit looks,
 * and codes that nobody knows.
 * \ingroup PoseRegistration */
PoseRegistration_EXPORT unsigned int
GetWeightOrder(const std::string & code);

/** In the order of their weight: what explains the others first, then the severer ones, then as they were found. A
 * person reads the first line, and a wrong pixel spacing behind five of its symptoms is not read.
 * \ingroup PoseRegistration */
PoseRegistration_EXPORT void
SortFindings(std::vector<RegistrationFinding> & findings);
} // namespace itk

#endif
