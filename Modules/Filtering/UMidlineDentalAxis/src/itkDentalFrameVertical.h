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
#ifndef itkDentalFrameVertical_h
#define itkDentalFrameVertical_h

#include "itkDentalFrameSamples.h"

#include <cstdint>
#include <vector>

// The estimator's second step: which way is occlusal, and which samples are crowns. Each needs the other, so they are
// found together; every direction that may be occlusal is tried. Private to this module.
namespace itk
{
namespace DentalFrameKernel
{
/** The occlusal direction with the crown candidates that gave it. */
struct Vertical
{
  Vector3                    direction{ 0.0, 0.0, 0.0 };
  Vector3                    centre{ 0.0, 0.0, 0.0 };
  double                     thickness{ 0.0 };
  double                     inlierShare{ 0.0 };
  std::vector<std::uint32_t> crowns;
  double                     score{ 0.0 };
};

/** Which samples lie within the band below the local occlusal envelope: the 98th percentile of the heights in polar
 * sectors about the centre. Sectors whose envelope lies far below the plate on the teeth have none: a palate's end, a
 * cast's heel, a gap. */
std::vector<std::uint32_t>
CrownBand(const Samples & samples, const Vector3 & occlusal, const Vector3 & centre, double band);

/** Tries the directions that may be occlusal and keeps the best. The margin is its score less that of the best
 * direction more than 60 degrees away. */
Vertical
ChooseVertical(const Samples &            samples,
               const Vector3 &            contact,
               double                     contactWeight,
               const DentalFrameOptions & options,
               double &                   margin);
} // namespace DentalFrameKernel
} // namespace itk

#endif
