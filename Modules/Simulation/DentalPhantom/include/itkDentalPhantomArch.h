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
#ifndef itkDentalPhantomArch_h
#define itkDentalPhantomArch_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomParameters.h"

#include <array>
#include <vector>

namespace itk
{
/** \class DentalPhantomArch
 * \brief The two lines on which a phantom's teeth stand, by arc length from the midline.
 *
 * The upper one is a superellipse whose depth is solved so that the teeth fit; the lower one runs inside it, by the
 * overjet in front and half a cusp at the side. Both are straight behind the second molars.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomArch
{
public:
  explicit DentalPhantomArch(const DentalPhantomParameters & parameters); /**< Of both jaws. */

  /** The point and the outward unit normal at arc length s from the midline, mm; s is negative on the right. */
  void
  GetPoint(unsigned int jaw, double s, double point[2], double normal[2]) const;

private:
  /** A side's arc length up to the second molar's distal end. */
  static double
  HalfLength(const DentalPhantomParameters & parameters, unsigned int jaw, unsigned int side);

  struct Line
  {
    /** Left half of the arch at steps of ArchStep, and its outward normals. */
    std::vector<std::array<double, 2>> curve;
    std::vector<std::array<double, 2>> normals;
  };
  std::array<Line, 2> m_Lines;
};
} // namespace itk

#endif
