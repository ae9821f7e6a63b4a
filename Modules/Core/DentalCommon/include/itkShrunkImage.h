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
#ifndef itkShrunkImage_h
#define itkShrunkImage_h

#include "DentalCommonExport.h"

#include <cstddef>
#include <vector>

namespace itk
{
/** \struct ShrunkImage
 * \brief A grey image in blocks of a whole number of pixels, each the mean of its pixels that are finite.
 *
 * Blocks at the right and lower edge may reach beyond the image: their means are of what there is. A block without a
 * finite pixel is not finite (NaN).
 *
 * \ingroup DentalCommon
 */
struct DentalCommon_EXPORT ShrunkImage
{
  /** Row by row. */
  std::vector<float> pixels;
  std::size_t        width{ 0 };
  std::size_t        height{ 0 };
  /** Pixels of the image in a block's side. */
  std::size_t factor{ 1 };

  /** How often an image must be shrunk so that neither side is longer than `maximumSide`: 1 where it fits. */
  static std::size_t
  FindFactor(std::size_t width, std::size_t height, std::size_t maximumSide);

  /** \param pixels row by row */
  static ShrunkImage
  ToFit(const float * pixels, std::size_t width, std::size_t height, std::size_t maximumSide);
};
} // namespace itk

#endif
