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
#ifndef itkReadPlacedGeometry_h
#define itkReadPlacedGeometry_h

#include "CaseRegistrationExport.h"

#include "itkCephalometricGeometry.h"
#include "itkToothCode.h"

#include <string>

namespace itk
{
/** The geometry of a radiograph with a jaw in it as an earlier run has placed it: its GetProjection() maps points of
 * the scan (mm, its own frame) to pixel indices, and is the result's projection_3x4. The scale that was estimated is in
 * the pixel spacing.
 *
 * \param result the result.json, or the folder that has it
 * \param jaw    of which the scan is
 * \param view   a further view by its name; "" for the case's own radiograph
 *
 * Throws DentalInputError, with the field, where the file is no result, has no such view, or has not placed the jaw.
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT CephalometricGeometry::Pointer
ReadPlacedGeometry(const std::string & result, ToothCode::JawEnum jaw, const std::string & view = {});
} // namespace itk

#endif
