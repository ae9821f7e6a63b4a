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
#ifndef itkPlaceByProjection_h
#define itkPlaceByProjection_h

#include "CephalometricGeometryExport.h"
#include "itkCephalometricGeometry.h"

#include <array>

namespace itk
{
/** Gives a geometry the pose, pixel spacing, principal point and mirroring (Facing, PatientLeft) of a projection of the
 * object's frame (mm) to homogeneous pixel index, row-major 3x4 of any factor, so that its GetProjection() is that one.
 *
 * Distances, direction and side of the source stay. A scale that was estimated is in the spacing then, and a turn in
 * the image in the pose. What no such geometry has, a skew of the pixels' axes, is left out. Throws an ExceptionObject
 * where the matrix is no projection of which the origin of the object's frame is in front of the source.
 * \ingroup CephalometricGeometry */
CephalometricGeometry_EXPORT void
PlaceByProjection(const std::array<double, 12> & matrix, CephalometricGeometry * geometry);
} // namespace itk

#endif
