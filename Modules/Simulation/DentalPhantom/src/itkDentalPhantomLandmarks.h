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
#ifndef itkDentalPhantomLandmarks_h
#define itkDentalPhantomLandmarks_h

#include "itkDentalPhantomDentition.h"
#include "itkDentalPhantomJawSurface.h"

namespace itk
{
/** Finds tips and buccal cusps of every crown and moves the nearest vertex there, in the jaw's frame with its occlusal
 * side up. A landmark's point holds its vertex's index until the surface is finished. */
void
AddDentalPhantomLandmarks(unsigned int jaw, const DentalPhantomDentition & dentition, DentalPhantomJawSurface & result);
} // namespace itk

#endif
