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
#ifndef itkMeasureLandmarkErrors_h
#define itkMeasureLandmarkErrors_h

#include "CaseRegistrationExport.h"
#include "itkCaseResult.h"

namespace itk
{
/** Adds the landmark errors: the only place where 2-D landmarks meet a result. With a bisected tracing the errors are
 * those of the middle between a right and its left landmark. Marks of a copy of another size, in mm, or far from where
 * all others of a registered jaw are, are warned of.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT void
MeasureLandmarkErrors(CaseResult & result, const DentalLandmarkSet<2> * marked);
} // namespace itk

#endif
