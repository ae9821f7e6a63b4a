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
#ifndef itkMoveDrawing_h
#define itkMoveDrawing_h

#include "itkPoseProblem.h"

#include "itkPoint.h"

#include <functional>

namespace itk
{
/** Not installed. A problem whose tracings and landmarks are moved point by point on the radiograph, pixels: the
 * question of a hypothesis about what was done to the radiograph between drawing and reading. What was completed from
 * the drawing and where it began are gone, and the principal point is unknown: it was given in pixels of either
 * radiograph. */
void
MoveDrawing(PoseProblem & problem, const std::function<Point<double, 2>(const Point<double, 2> &)> & move);
} // namespace itk

#endif
