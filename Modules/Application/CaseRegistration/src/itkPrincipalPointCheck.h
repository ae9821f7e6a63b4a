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
#ifndef itkPrincipalPointCheck_h
#define itkPrincipalPointCheck_h

#include "itkCephalometricGeometry.h"
#include "itkRegistrationFinding.h"

#include <array>
#include <optional>

namespace itk
{
/** Where a jaw was found, as the principal point has it: the cephalostat frame begins there. Not installed. */
struct JawSeenFromPrincipalPoint
{
  /** The jaw's middle: in front of the principal point and below it, mm in the midsagittal plane. */
  double forward{ 0.0 };
  double down{ 0.0 };
  /** How far the occlusal plane falls toward the incisors, rad. */
  double occlusalSlope{ 0.0 };
};

/** Whether a given principal point of a lateral radiograph is where ear rods are: behind the jaw and above it, within
 * the length of a skull base. A registration makes up for a wrong one by the pose and fits as well; only the depth of
 * what it projects is wrong, by pixels. Nothing is said of one within 40 mm of the jaw, as a picture's middle is, nor
 * where the head is tipped so far that both the radiograph's and the jaw's own directions do not agree on it.
 * `imageSize` is pixels, 0 where it is not known. */
std::optional<RegistrationFinding>
CheckPrincipalPoint(const CephalometricGeometry *       geometry,
                    const std::array<unsigned int, 2> & imageSize,
                    const JawSeenFromPrincipalPoint &   seen);

/** Whether the jaw lies above a given principal point, more than 40 mm from it, and would lie where teeth are below ear
 * rods with rows counted from the other edge: few marks fit mirrored as well as they are. */
std::optional<RegistrationFinding>
CheckRowOrder(const CephalometricGeometry *       geometry,
              const std::array<unsigned int, 2> & imageSize,
              const JawSeenFromPrincipalPoint &   seen);
} // namespace itk

#endif
