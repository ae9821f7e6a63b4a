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
#ifndef itkDentalPhantomOutline_h
#define itkDentalPhantomOutline_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomModel.h"
#include "itkPerspectiveProjection.h"

#include <array>
#include <vector>

namespace itk
{
/** \class DentalPhantomOutline
 * \brief The outline of one tooth in a picture, crown and roots, straight from its solid.
 *
 * A pixel is inside where the ray through it enters the tooth: the smallest value of the implicit function along the
 * ray is negative there. The outline is the zero line of these smallest values (itk::ContourExtractor2DImageFilter), so
 * that neither a mesh nor the toolkit's silhouettes take part in it.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomOutline
{
public:
  using PixelType = std::array<double, 2>;

  /** The longest closed line, points about `step` px apart, without a repeated end; empty where the tooth is missing.
   *  \param projection  from the anatomical frame to pixels
   *  \param whole       with roots; else the crown alone, which ends at the cervix */
  static std::vector<PixelType>
  Trace(const DentalPhantomModel &    model,
        unsigned int                  jaw,
        unsigned int                  tooth,
        const PerspectiveProjection & projection,
        bool                          whole,
        double                        step,
        unsigned int                  threads);

  /** Equal steps along a closed line. */
  static std::vector<PixelType>
  Resample(const std::vector<PixelType> & closed, std::size_t numberOfPoints);
};
} // namespace itk

#endif
