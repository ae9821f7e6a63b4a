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
#ifndef itkSilhouetteCoverage_h
#define itkSilhouetteCoverage_h

#include "SilhouetteContourExport.h"
#include "itkPerspectiveProjection.h"
#include "itkTriangleSurface.h"

#include <cstddef>
#include <vector>

namespace itk
{
/** \struct SilhouetteCoverage
 * \brief A pixel mask of a projection: the covered share of each pixel, row by row.
 * \ingroup SilhouetteContour
 */
struct SilhouetteCoverage
{
  std::size_t        width{ 0 };  /**< Pixels a row. */
  std::size_t        height{ 0 }; /**< Rows. */
  std::vector<float> values;      /**< 0 to 1, row by row; width times height of them. */

  /** Covered area, square pixels. */
  double
  Area() const;
};

/** Rasterises the union of all projected triangles, with subsamples x subsamples samples a pixel. Pixel (0, 0) has its
 * centre at index (0, 0). With fillHoles everything that cannot be reached from the border through uncovered samples
 * counts as covered, as in the outer boundary of MeshSilhouette: this is its slow and independent counterpart, good to
 * about 1 / subsamples px. Throws std::invalid_argument for an empty image or no subsamples, and std::domain_error
 * where a point is not in front of the source. */
SilhouetteContour_EXPORT SilhouetteCoverage
ComputeSilhouetteCoverage(const TriangleSurface &       surface,
                          const PerspectiveProjection & projection,
                          std::size_t                   width,
                          std::size_t                   height,
                          unsigned int                  subsamples,
                          bool                          fillHoles);
} // namespace itk

#endif
