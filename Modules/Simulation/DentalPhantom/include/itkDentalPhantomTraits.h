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
#ifndef itkDentalPhantomTraits_h
#define itkDentalPhantomTraits_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomLevel.h"
#include "itkDentalPhantomParameters.h"

#include <cstdint>
#include <string>
#include <vector>

namespace itk
{
/** \struct DentalPhantomTrait
 * \brief A trait of real arches that a dentition was given: what, where and how much.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantomTrait
{
  /** As the probability's key in DentalPhantomLevel, "open_bite". */
  std::string name;
  /** FDI numbers; none where it is the arches' as a whole. */
  std::vector<unsigned int> teeth;
  /** Its size, mm, as intended; what the settling of the teeth leaves of it is measured on the mesh. */
  double amount{ 0.0 };
};

/** \class DentalPhantomTraits
 * \brief Gives a drawn dentition the traits of a level.
 *
 * Each trait draws from a random stream of its own, whether it occurs or not, so that another trait, or another
 * probability of one, leaves the rest as it was. Where two want the same tooth the first in the list has it.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomTraits
{
public:
  /** Changes the parameters, which come from DentalPhantomParameters::Draw() with the same seed, and returns what was
   * given. */
  static std::vector<DentalPhantomTrait>
  Apply(std::uint64_t seed, const DentalPhantomLevel & level, DentalPhantomParameters & parameters);
};
} // namespace itk

#endif
