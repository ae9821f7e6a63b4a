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
#ifndef itkDentalPhantomOcclusion_h
#define itkDentalPhantomOcclusion_h

#include "itkDentalPhantomDentition.h"

#include <array>

namespace itk
{
/** Moves the lower crowns vertically until each touches the upper jaw; `settlement` gets by how much, mm upward. */
void
SettleDentalPhantom(DentalPhantomDentition &                                    dentition,
                    unsigned int                                                threads,
                    std::array<double, DentalPhantomDentition::NumberOfTeeth> & settlement);
} // namespace itk

#endif
