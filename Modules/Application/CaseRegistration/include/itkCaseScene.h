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
#ifndef itkCaseScene_h
#define itkCaseScene_h

#include "CaseRegistrationExport.h"
#include "itkCaseResult.h"
#include "itkRegistrationSceneSource.h"

#include <array>
#include <string>

namespace itk
{
/** The scene of a registered case: its scans where the registration put them, and its radiograph as the view "lateral".
 * Update() it to compute it.
 *
 * The detector is as large as the scale that was found makes it, so that rays of scans end where their images are. Jaws
 * that were registered alone have a scale each: then it is their geometric mean's. A similarity of the paper's method
 * is no place in space (CephalometricGeometry): its silhouettes are where the method drew them, and the rays of its
 * landmarks bend at the scan.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT RegistrationSceneSource::Pointer
                        MakeCaseScene(const CaseResult & result);
} // namespace itk

#endif
