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
#ifndef itkDrawingOnPicture_h
#define itkDrawingOnPicture_h

#include "itkDentalContour.h"

#include "itkImage.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** What was done to a picture after it was drawn on; turns are clockwise, as it is seen. */
enum class PictureReadingEnum : uint8_t
{
  AsItIs,
  Turned90,
  Turned180,
  Turned270,
  /** Right and left exchanged. */
  Mirrored,
  /** Above and below exchanged. */
  MirroredUpsideDown,
  /** The drawing is of another place: of another patient's radiograph, or of a picture that was cut. */
  Shifted,
  /** No reading has the drawing on edges of the picture. */
  Untold
};

/** What grey values say of a drawing; not installed. */
struct DrawingOnPicture
{
  PictureReadingEnum reading{ PictureReadingEnum::Untold };
  /** How far the edges under the drawing are above those under the same drawing moved about there, standard deviations:
   * with the picture as it is, and in the reading. */
  double asItIs{ 0.0 };
  double inReading{ 0.0 };
  /** Of Shifted: from the drawing to where it lies on edges, pixels. */
  std::array<double, 2> shift{ { 0.0, 0.0 } };
};

/** Whether a drawing lies on edges of a picture: a registration fits drawings, and does not look at the picture. One
 * that was turned or mirrored after it was drawn on is told where the drawing lies on edges in that reading, better
 * than anywhere about, and is nothing special where it is; one that was not drawn on, where it does so elsewhere.
 * `spacing` is mm a pixel, for the width of an edge. */
DrawingOnPicture
CompareDrawingWithPicture(const Image<float, 2> *                    picture,
                          const std::vector<const DentalContour *> & drawings,
                          const std::array<double, 2> &              spacing);
} // namespace itk

#endif
