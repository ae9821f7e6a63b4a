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
#ifndef itkDentalPhantomScanDefects_h
#define itkDentalPhantomScanDefects_h

#include "itkDentalPhantomJawSurface.h"
#include "itkDentalPhantomParameters.h"

namespace itk
{
/** Decimates a finished jaw (anatomical frame) and adds what a scan has beside teeth and gingiva: flaps on its border,
 * loose crumbs and specks, holes. Each kind has a random stream of its own. Landmarks stay where they are: a vertex
 * that is one is never decimated, and no hole opens within 1 mm of it. */
void
ApplyDentalPhantomScanDefects(unsigned int jaw, const DentalPhantomScan & scan, DentalPhantomJawSurface & result);
} // namespace itk

#endif
