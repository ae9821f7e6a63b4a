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
#ifndef itkDentalPhantomAnatomy_h
#define itkDentalPhantomAnatomy_h

#include <array>
#include <vector>

namespace itk
{
/** A region or a line of the head, mm from the ear rods: anterior (or to the patient's left) and up. */
struct DentalPhantomAnatomyPart
{
  using PlaneType = std::array<double, 2>;


  std::vector<PlaneType> knots;
  bool                   closed;
  /** What a region adds to the attenuation in its middle, and how far inside it is as thick as that. */
  double fill;
  double depth;
  /** What its border, or a line, adds, and its width. */
  double rim;
  double width;
  /** Paired: drawn twice, magnified a little differently (lateral) or mirrored (frontal). */
  bool paired;

  /** Lateral: x anterior, y up. */
  static std::vector<DentalPhantomAnatomyPart>
  GetLateral();
  /** Frontal: x to the patient's left, y up; paired parts are mirrored. */
  static std::vector<DentalPhantomAnatomyPart>
  GetFrontal();
};
} // namespace itk

#endif
