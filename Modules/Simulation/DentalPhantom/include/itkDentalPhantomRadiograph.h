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
#ifndef itkDentalPhantomRadiograph_h
#define itkDentalPhantomRadiograph_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomModel.h"
#include "itkPerspectiveProjection.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** \struct DentalPhantomRadiograph
 * \brief A simulated lateral radiograph of phantom jaws, eight bits, bright where much absorbs.
 *
 * Crowns and roots of both sides are projected as solids: the length of every ray in them, enamel denser than root.
 * Around them a soft-tissue profile, skull, jaws and the ear-rod ring as plain shapes, and grain. A picture to look at
 * and to read back; its grey values claim no physics. Free of ITK headers.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantom_EXPORT DentalPhantomRadiograph
{
  /** \param projection  from the model's anatomical frame to pixels, with the source
   *  \param facing      +1 where anterior is to the right in the image
   *  \param earRod      the principal point, px; drawn as a ring
   *  \param pixelSize   mm a pixel at the teeth
   *  \return width x height grey values, row by row; the same for any number of threads */
  static std::vector<std::uint8_t>
  Render(const DentalPhantomModel &          model,
         const PerspectiveProjection &       projection,
         int                                 facing,
         const std::array<double, 2> &       earRod,
         double                              pixelSize,
         const std::array<unsigned int, 2> & size,
         std::uint64_t                       seed,
         unsigned int                        threads);
};
} // namespace itk

#endif
