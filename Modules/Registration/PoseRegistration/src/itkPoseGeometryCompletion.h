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
#ifndef itkPoseGeometryCompletion_h
#define itkPoseGeometryCompletion_h

#include "itkPoseProblem.h"

#include <stdexcept>

namespace itk
{
/** Not installed. A geometry that cannot be. A type of its own: a start, a hypothesis or a term of a user's may throw
 * std::invalid_argument about anything. */
class PoseGeometryError : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

/** Not installed. The geometry of a problem, with what is not known filled in: the principal point by the drawing's
 * centroid, the spacing from the arch's length. Where something is held at a start of another geometry, or nothing was
 * drawn that they could be estimated from, both are as that geometry has them. */
PoseGeometry
CompleteGeometry(const PoseProblem & problem);

/** Throws PoseGeometryError for distances or a spacing that cannot be. */
void
CheckGeometry(const PoseGeometry & geometry);
} // namespace itk

#endif
