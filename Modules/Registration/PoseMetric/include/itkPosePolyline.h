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
#ifndef itkPosePolyline_h
#define itkPosePolyline_h

#include "itkPoseTypes.h"

#include <array>
#include <cstdint>
#include <vector>


namespace itk
{
/** Which side's outline was traced. */
enum class PoseTracedSideEnum : std::uint8_t
{
  Right,
  Left,
  /** Double contours bisected. */
  Mean,
  /** Both sides, each polyline with the code of its side. */
  Both
};

/** A stretch of tracing, continuous pixel indices of the radiograph. */
struct PosePolyline
{
  std::vector<std::array<double, 2>> points;
  /** One a point in [0, 1], or empty: all 1. */
  std::vector<double> weights;
  /** FDI number of the tooth, 0 unknown. */
  std::uint8_t tooth{ 0 };
  bool         closed{ false };
};
} // namespace itk

#endif
