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
#ifndef itkDentalPhantomPicture_h
#define itkDentalPhantomPicture_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomParameters.h"
#include "itkTriangleSurface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** \class DentalPhantomPicture
 * \brief A shaded picture of a pair of phantom jaws, to see at a glance what a seed has made.
 *
 * Four views side by side: right, front, the upper and the lower occlusal surface; teeth light, milk molars yellowish,
 * gingiva pink. A depth buffer of its own, so that it needs no screen. Kernel, free of ITK headers.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomPicture
{
public:
  /** Meshes in their files' frames with FDI labels, and the parameters that made them.
   *  \param panel  width and height of one view, px
   *  \return 4 panel x panel pixels, three bytes each, row by row */
  static std::vector<std::uint8_t>
  Render(const std::array<TriangleSurface, 2> &           surfaces,
         const std::array<std::vector<std::uint8_t>, 2> & labels,
         const DentalPhantomParameters &                  parameters,
         unsigned int                                     panel);
};
} // namespace itk

#endif
