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
#ifndef itkDentalPhantomFilm_h
#define itkDentalPhantomFilm_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomModel.h"
#include "itkPerspectiveProjection.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** \class DentalPhantomFilm
 * \brief A radiograph that looks like one: teeth with roots and pulps as solids, around them bone, air and soft tissue.
 *
 * The attenuation of a pixel is summed: of the teeth along its ray, of skull and soft tissue as regions with a rounded
 * border and as cortical lines. Cranial structures hang on the ear rods, jaws, lips and chin follow the teeth; borders
 * of paired bones are doubled as the two sides' magnifications are. The anatomy is a median adult's, drawn from the
 * cephalometric norms; its grey values claim no physics. Kernel, free of ITK objects; the same for any number of
 * threads.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomFilm
{
public:
  enum class ViewEnum : std::uint8_t
  {
    Lateral,
    Frontal
  };
  /** From where the picture is taken; the bone and soft tissue around the teeth are of that view. */
  ViewEnum view{ ViewEnum::Lateral };
  /** From the model's anatomical frame to pixels, with the source. */
  PerspectiveProjection projection;
  /** +1 where anterior (lateral) or the patient's left (frontal) is to the right in the picture. */
  int facing{ 1 };
  /** The principal point, px: the ear rods. */
  std::array<double, 2> earRod{};
  /** mm a pixel at the midsagittal (midcoronal) plane. */
  double                      pixelSize{ 0.23 };
  std::array<unsigned int, 2> size{ { 703, 938 } };
  std::uint64_t               seed{ 1 };
  /** Grain, 1 sd, grey values; blur, 1 sd, px. */
  double noise{ 2.5 };
  double blur{ 0.7 };

  /** Width x height grey values, row by row. */
  std::vector<std::uint8_t>
  Render(const DentalPhantomModel & model, unsigned int threads) const;
};
} // namespace itk

#endif
