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
#ifndef itkCheckWholeTeeth_h
#define itkCheckWholeTeeth_h

#include "itkCephalometricGeometry.h"
#include "itkCephalometricLandmarkSet.h"
#include "itkDentalContour.h"
#include "itkRegistrationFinding.h"
#include "itkToothCode.h"

#include <optional>

namespace itk
{
/** What is wrong where a jaw's tracing is compared with the silhouette of a scan as it is, root and all: outlines that
 * are of whole teeth by what their file says, or by their shape. Failed where most of the tracing is of such. */
std::optional<RegistrationFinding>
FindWholeTeeth(const DentalContour & tracing, ToothCode::JawEnum jaw, const CephalometricGeometry & geometry);

/** What is wrong where outlines of whole teeth do not reach the landmarks that were marked at the same teeth: they are
 * of roots without their crowns, or of other teeth. */
std::optional<RegistrationFinding>
FindOutlinesApartFromLandmarks(const DentalContour &            tracing,
                               ToothCode::JawEnum               jaw,
                               const CephalometricLandmarkSet & landmarks,
                               const CephalometricGeometry &    geometry);

/** What is wrong where closed outlines of the same tooth of jaws in occlusion end short of each other: of teeth that
 * touch, or nearly, both or one are roots without their crowns. Failed where all that have an antagonist do. */
std::optional<RegistrationFinding>
FindOutlinesShortOfTheBite(const DentalContour &         upper,
                           const DentalContour &         lower,
                           const CephalometricGeometry & geometry);
} // namespace itk

#endif
