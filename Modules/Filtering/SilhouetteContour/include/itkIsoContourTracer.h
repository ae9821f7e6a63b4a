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
#ifndef itkIsoContourTracer_h
#define itkIsoContourTracer_h

#include "SilhouetteContourExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
/** \class IsoContourTracer
 * \brief Marching squares on rows given one after another: the outer boundaries of what is above a level. Free of ITK
 * headers.
 *
 * A sample belongs to the object where its value is larger than the level. Crossings are interpolated linearly between
 * neighbouring samples; where two opposite corners of a square belong to the object, the mean of the four decides
 * whether they are connected. Around the image lies a frame of samples of the padding value, so that every contour is
 * closed: where the object touches the border the contour runs between the outermost samples and the frame.
 *
 * Holes are ignored, and what lies in them.
 *
 * \ingroup SilhouetteContour
 */
class SilhouetteContour_EXPORT IsoContourTracer
{
public:
  using LoopType = std::vector<std::array<double, 2>>;

  /** \param width    samples a row
   *  \param level    the iso-value */
  IsoContourTracer(std::size_t width, double level);

  /** Takes the next row. */
  void
  AddRow(const double * values);

  /** Ends the image. The padding comes last, so that an image whose smallest value is the padding needs to be seen only
   * once.
   * \param padding  value outside of the image; throws std::invalid_argument where it is above the level
   * \return the outer boundaries, largest area first, (column, row) with (0, 0) the first sample's centre; closed, the
   * first point not repeated, shoelace area positive. Call it once, after the last row. */
  std::vector<LoopType>
  Finish(double padding);

private:
  struct Segment
  {
    std::uint64_t         from;
    std::uint64_t         to;
    std::array<double, 2> point;
  };

  /** A crossing between the frame's sample at a place and the image's sample beside it, which the padding will tell. */
  struct FrameCrossing
  {
    std::size_t           segment;
    std::array<double, 2> frame;
    std::array<double, 2> step;
    double                value;
  };

  void
  AddPaddedRow();

  std::size_t   m_Width;
  double        m_Level;
  std::uint64_t m_Row{ 0 };
  /** Framed by minus infinity: below every level. */
  std::vector<double>        m_Previous;
  std::vector<double>        m_Current;
  std::vector<Segment>       m_Segments;
  std::vector<FrameCrossing> m_FrameCrossings;
};

/** Signed area of a closed polygon; positive where v grows when u grows along it with the inside on that side, as in
 * SilhouetteLoop. */
SilhouetteContour_EXPORT double
ComputeLoopArea(const IsoContourTracer::LoopType & loop);

/** The outer boundaries of a mask of 0 and 1, row by row: at its half level, under a Gaussian of width sigma samples
 * where that is not 0. Outside the mask is 0. Loops as IsoContourTracer::Finish() gives them. */
SilhouetteContour_EXPORT std::vector<IsoContourTracer::LoopType>
                         TraceMask(const std::vector<double> & mask, std::size_t width, double sigma);

/** Even-odd rule. */
SilhouetteContour_EXPORT bool
IsInsideLoop(const IsoContourTracer::LoopType & loop, const std::array<double, 2> & point);
} // namespace itk

#endif
