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
#ifndef itkLeaveOutUsedLandmarks_h
#define itkLeaveOutUsedLandmarks_h

#include "CaseRegistrationExport.h"
#include "itkCephalometricLandmarkSet.h"
#include "itkDentalLandmarkSet.h"

#include <array>
#include <string>
#include <vector>

namespace itk
{
/** What was marked to measure errors, less what was registered with: such a landmark never scores, nor does either
 * side's where its name has no side. Sides of the used ones are ignored where the drawing is a standard one.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT DentalLandmarkSet<2>::Pointer
                        LeaveOutUsedLandmarks(const DentalLandmarkSet<2> &                               marked,
                                              const std::vector<CephalometricLandmarkSet::MeaningType> & used,
                                              bool                                                       ignoreSides);

/** "UR6_MB" and "UL6_MB" of the middle "U6_MB".
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT std::array<std::string, 2>
                        NamesOfSides(const std::string & middle);
} // namespace itk

#endif
