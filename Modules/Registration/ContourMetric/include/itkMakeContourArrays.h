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
#ifndef itkMakeContourArrays_h
#define itkMakeContourArrays_h

#include "itkContourChamferKernel.h"
#include "itkDentalContour.h"

namespace itk
{
/** The contour's points by their identifiers, its line cells and its weights. Throws where a cell is no line or names a
 * point that is not there, or a point is not finite. */
ContourMetric_EXPORT ContourArrays
MakeContourArrays(const DentalContour & contour);
} // namespace itk

#endif
