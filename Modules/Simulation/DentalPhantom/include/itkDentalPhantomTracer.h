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
#ifndef itkDentalPhantomTracer_h
#define itkDentalPhantomTracer_h

#include "DentalPhantomExport.h"
#include "itkPerspectiveProjection.h"
#include "itkTriangleSurface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** \class DentalPhantomTracer
 * \brief What an orthodontist draws of one side's crowns, from projected meshes with tooth labels.
 *
 * The labial border of the central incisor from the gingival margin to the edge, then the incisal or occlusal border of
 * each crown as far as no other crown of that side hides it. Borders are the extreme points of the projected triangles
 * in image columns (rows on the labial border) of a tenth of a pixel, not a silhouette algorithm: what is tested
 * against this does not share code with it. Free of ITK headers.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomTracer
{
public:
  using PixelType = std::array<double, 2>;
  /** The border of one tooth, px. */
  struct Polyline
  {
    std::uint8_t           fdi{ 0 }; /**< The tooth, 11 to 48. */
    std::vector<PixelType> points;   /**< In order along the border, px. */
    /** Where the labial border ends and the incisal begins. */
    std::size_t corner{ 0 };
  };
  /** How the drawing hand errs. */
  struct Noise
  {
    /** Standard deviations of a coordinate, px: drift of the hand along the line and independent of it. */
    double correlated{ 0.0 };
    double white{ 0.0 };
    /** The drift's autocorrelation is exp(-s^2 / 2 l^2), px. */
    double correlationLength{ 15.0 };
    /** Each tooth's own error, standard deviations: shift px, rotation rad, scale. */
    double toothShift{ 0.0 };
    double toothRotation{ 0.0 };
    double toothScale{ 0.0 };
  };

  /** \param jaw         0 upper, 1 lower
   *  \param quadrant    FDI quadrant: 1, 2 upper right and left, 3, 4 lower left and right
   *  \param facing      +1 where anterior is to the right in the image, -1 to the left
   *  \param use         a flag a point: whether it belongs to what is drawn (all if empty)
   *  \param pixelSize   mm a pixel at the teeth */
  static std::vector<Polyline>
  TraceSide(const TriangleSurface &           surface,
            const std::vector<std::uint8_t> & labels,
            const std::vector<bool> &         use,
            const PerspectiveProjection &     projection,
            unsigned int                      jaw,
            unsigned int                      quadrant,
            int                               facing,
            double                            pixelSize);

  /** The middle of the double contours, tooth by tooth, under the first's codes; teeth that one side lacks are left
   * out. */
  static std::vector<Polyline>
  Bisect(const std::vector<Polyline> & right, const std::vector<Polyline> & left);

  /** Spreads a number of points over the polylines by length, at least two on each. */
  static std::vector<Polyline>
  Resample(const std::vector<Polyline> & lines, unsigned int numberOfPoints);

  /** Draws the lines as a person does, the last step: points on a raster of 1e-3 px. */
  static void
  AddNoise(std::vector<Polyline> & lines, const Noise & noise, std::uint64_t seed, std::uint64_t stream);
};
} // namespace itk

#endif
