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
#ifndef itkDentalFrameOcclusion_h
#define itkDentalFrameOcclusion_h

#include "itkDentalFrameJaw.h"

#include <cstdint>
#include <vector>

// Whether two scans lie in one frame with teeth that can meet: contact between them is the one sign of the vertical
// that neither a cast's base nor a reversed winding can spoil. Private to this module.
namespace itk
{
namespace DentalFrameKernel
{
/** How near the jaws are to each other, sample by sample, and the direction across the band where they meet. */
struct Contact
{
  Vector3             direction{ 0.0, 0.0, 0.0 };
  double              distance{ 0.0 };
  std::vector<double> upperDistances;
  std::vector<double> lowerDistances;
  /** The sample of the other jaw that each is nearest to. */
  std::vector<std::uint32_t> upperNearest;
  std::vector<std::uint32_t> lowerNearest;
};

/** The contact band: samples of each jaw near the other. Its flattest direction is vertical whatever base, palate and
 * trimming the meshes have. */
Contact
FindContact(const Samples & upper, const Samples & lower);

/** How much the jaw's vertical looks like the occlusal direction, from what no winding can spoil: the roughness of its
 * crowns relative to the mean, less twice the share of them at the border of the shell. On phantoms of level real 0.5
 * or more for the occlusal direction and 0.1 or less for the opposite one, where the crowns are taken for the border of
 * the gingiva or a smooth palate. The rim is FindRim()'s; 0 where there is none. */
double
OcclusalLook(const Jaw & jaw, const std::vector<Vector3> & rim);

/** Fills in what the jaws' verticals say about occlusion. The limits are wide: an open bite of 6 mm or casts set apart
 * pass, meshes in frames of their own do not. */
bool
VerticalsFit(const Jaw & upper, const Jaw & lower, const Contact & contact, DentalFrameResult & result);

/** The whole test: one arch over the other as well. */
bool
TestOcclusion(const Jaw & upper, const Jaw & lower, const Contact & contact, DentalFrameResult & result);
} // namespace DentalFrameKernel
} // namespace itk

#endif
