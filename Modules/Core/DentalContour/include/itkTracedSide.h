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
#ifndef itkTracedSide_h
#define itkTracedSide_h

#include "DentalContourExport.h"

#include <cstdint>
#include <iosfwd>
#include <string>

namespace itk
{
/** Which side's contours a tracing of a lateral radiograph shows. */
enum class TracedSideEnum : std::uint8_t
{
  Right,
  Left,
  /** Double contours bisected. */
  Mean,
  /** Both sides, each polyline with the code of its side. */
  Both,
  /** Whole teeth U1, L1, U6, L6, as a cephalometric analysis draws them. */
  Standard
};

/** "right", "left", "mean", "both" or "standard", as in a case file. */
DentalContour_EXPORT std::string
                     ToString(TracedSideEnum side);

/** Whether what was drawn of a tooth is the middle of the two sides' images: it does not carry roll and yaw. */
inline bool
IsBisected(TracedSideEnum side)
{
  return side == TracedSideEnum::Mean || side == TracedSideEnum::Standard;
}

/** Throws std::invalid_argument that names the text and what was expected. */
DentalContour_EXPORT TracedSideEnum
TracedSideFromString(const std::string & text);

DentalContour_EXPORT std::ostream &
                     operator<<(std::ostream & os, TracedSideEnum side);
} // namespace itk

#endif
