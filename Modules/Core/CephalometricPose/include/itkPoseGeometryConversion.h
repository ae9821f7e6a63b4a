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
#ifndef itkPoseGeometryConversion_h
#define itkPoseGeometryConversion_h

#include "CephalometricPoseExport.h"
#include "itkCephalometricGeometry.h"
#include "itkPoseTypes.h"

// Between a geometry and what kernels take of it: the pose of the geometry is not part of it.
namespace itk
{
/** What a geometry says. Its pixel spacing may be unknown; the principal point counts as known. */
CephalometricPose_EXPORT PoseGeometry
ToPoseGeometry(const CephalometricGeometry & geometry);

/** Writes distances, direction, sides, principal point and, divided by a factor on the magnification, the pixel spacing
 * to a geometry. Its pose stays. */
CephalometricPose_EXPORT void
CopyToGeometry(const PoseGeometry & from, double scaleFactor, CephalometricGeometry & geometry);
} // namespace itk

#endif
