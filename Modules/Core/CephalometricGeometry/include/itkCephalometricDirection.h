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
#ifndef itkCephalometricDirection_h
#define itkCephalometricDirection_h

#include <cstdint>

namespace itk
{
/** From which side of the head the rays of a cephalogram come. In all of them z is superior and runs along the film.
 * \ingroup CephalometricGeometry */
enum class CephalometricDirectionEnum : std::uint8_t
{
  /** Across the head: x runs along the film. */
  Lateral,
  /** Along the head: y runs along the film. */
  Frontal
};
} // namespace itk

#endif
