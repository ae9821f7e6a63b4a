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
#ifndef itkDrawnLines_h
#define itkDrawnLines_h

#include "itkDentalContour.h"

#include "itkImage.h"

#include <cstdint>

namespace itk
{
/** \class DrawnLines
 * \brief Thin lines in a picture as polylines: somebody drew contours with a pen of a pixel or two; not installed.
 *
 * The line's middle is found by thinning and walked from pixel to pixel. Where lines meet they are cut; stumps that are
 * left over from thinning are dropped. A pixel is as sure as its centre: half a pixel.
 *
 * \ingroup Annotation
 */
class DrawnLines
{
public:
  using ImageType = Image<std::uint8_t, 2>;

  /** Whether all that is not 0 is thin: nothing of it is left when two pixels are taken off its border. */
  static bool
  AreDrawn(const ImageType * image);

  static DentalContour::PolylinesType
  Trace(const ImageType * image);
};
} // namespace itk

#endif
