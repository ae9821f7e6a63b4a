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
#ifndef itkDentalPhantomHead_h
#define itkDentalPhantomHead_h

#include "itkCephalometricGeometry.h"

#include <cmath>

namespace itk
{
/** yaw about z after roll about x after pitch about y. */
inline CephalometricGeometry::RotationType
DentalPhantomHeadRotation(double yaw, double roll, double pitch)
{
  const auto about = [](unsigned int axis, double angle) {
    CephalometricGeometry::RotationType rotation;
    rotation.SetIdentity();
    const unsigned int i = (axis + 1) % 3;
    const unsigned int j = (axis + 2) % 3;
    rotation(i, i) = std::cos(angle);
    rotation(i, j) = -std::sin(angle);
    rotation(j, i) = std::sin(angle);
    rotation(j, j) = std::cos(angle);
    return rotation;
  };
  return about(2, yaw) * about(0, roll) * about(1, pitch);
}
} // namespace itk

#endif
