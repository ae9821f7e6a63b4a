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
#ifndef itkGreyWindow_h
#define itkGreyWindow_h

#include "DentalCommonExport.h"

#include <cstddef>
#include <cstdint>

namespace itk
{
/** \struct GreyWindow
 * \brief The grey values of a radiograph that are shown as black and as white.
 *
 * \ingroup DentalCommon
 */
struct DentalCommon_EXPORT GreyWindow
{
  double black{ 0.0 }; /**< Grey value that is shown as black, and all below it. */
  double white{ 1.0 }; /**< Grey value that is shown as white, and all above it. */

  /** Between the quantiles of `share` and 1 - `share` of the pixels that are finite: a few that are very bright, as a
   * marker of lead is, don't darken all others. Where these are one value the window is from the least to the greatest
   * one; 0 and 1 where no pixel is finite.
   * \param stride one of so many pixels is looked at */
  static GreyWindow
  FromQuantiles(const float * pixels, std::size_t count, double share, std::size_t stride = 1);

  /** 0 to 255, rounded; what is not finite is black. */
  std::uint8_t
  ToByte(double value) const;
};
} // namespace itk

#endif
