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
#ifndef itkDentalFrameIncisors_h
#define itkDentalFrameIncisors_h

#include "itkDentalFrameMath.h"
#include "itkTriangleSurface.h"

#include <optional>

// How wide the incisors are, from the shape of their labial surface alone: those of the lower jaw are narrower by a
// third. Private to this module.
namespace itk
{
namespace DentalFrameKernel
{
using namespace DentalFrameMath;

/** From where the front of a jaw is looked at: unit directions, and the incisal edge on the midline. */
struct FrontView
{
  Vector3 anterior{ 0.0, 0.0, 0.0 };
  Vector3 lateral{ 0.0, 0.0, 0.0 };
  Vector3 occlusal{ 0.0, 0.0, 0.0 };
  Vector3 edge{ 0.0, 0.0, 0.0 };
  /** The surface is wound inward. */
  bool turned{ false };
};

/** The labial surface of each incisor is convex: along the arch its normal swings from one side to the other and jumps
 * back where the next tooth begins. The correlation of that swing with four incisors as wide as lower ones, less that
 * with four as wide as upper ones; each the best over places of the midline and widths up to a tenth from the mean. In
 * [-2, 2], positive: as of a lower jaw. None where there is too little surface in front. */
std::optional<double>
IncisorContrast(const TriangleSurface & surface, const FrontView & view);
} // namespace DentalFrameKernel
} // namespace itk

#endif
