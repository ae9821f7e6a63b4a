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
#ifndef itkPoseToothPlaces_h
#define itkPoseToothPlaces_h

#include "PoseMetricExport.h"
#include "itkPoseTracing.h"

#include <array>

namespace itk
{
/** \class PoseToothPlaces
 * \brief How far along the dental arch the teeth of a tracing are to be expected, to tell a slip by one tooth.
 *
 * By textbook widths, and as far as the first premolar. Behind it arches differ: an extracted tooth moves those behind
 * it by what is left of its gap, a milk molar by its own width, and by a textbook either looks like a slip. These teeth
 * have no place, but for the foremost of them where neither canine nor first premolar is drawn. Nothing is lost by
 * that: a slip moves all teeth alike. Third molars have no place either: where they stand is not settled.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseToothPlaces
{
public:
  PoseToothPlaces() = default;
  explicit PoseToothPlaces(const PoseTracing & tracing); /**< By its teeth. */

  /** Arc length of PoseArch from the midline to the middle of the tooth with this position in its quadrant, mm; 0 where
   * it was not drawn, or has no place. */
  double
  GetArc(unsigned int position) const
  {
    return position < m_Arc.size() ? m_Arc[position] : 0.0;
  }

private:
  /** By position, 1 to 7. */
  std::array<double, 8> m_Arc{};
};
} // namespace itk

#endif
