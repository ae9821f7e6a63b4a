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
#ifndef itkFrontalToothOutline_h
#define itkFrontalToothOutline_h

#include "PoseMetricExport.h"

#include "itkDentalContour.h"
#include "itkPoseTypes.h"
#include "itkToothCode.h"
#include "itkToothOutline.h"

namespace itk
{
/** \class FrontalToothOutline
 * \brief What was drawn of one tooth on a frontal radiograph: an incisal edge, the buccal border of a molar, or the
 * closed outline of a crown.
 *
 * An open line is taken as it is. Of a closed one the part toward the root is left out, where gingiva covers the crown
 * on a scan. Normals look occlusally at a front tooth, and away from the patient's middle or occlusally at one behind
 * the canine. Centroid and reference are the middle of the points: a hand that is off with the border is off with
 * itself.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT FrontalToothOutline : public ToothOutline
{
public:
  /** Of its points, px of 0.25 mm: 2 mm, below which a line has no direction. */
  static constexpr double SmallestLength = 8.0;

  /** \param polyline  continuous pixel indices, with the code of its tooth */
  FrontalToothOutline(const PoseGeometry &                geometry,
                      const DentalContour::PolylineType & polyline,
                      ToothCode::JawEnum                  jaw);
};
} // namespace itk

#endif
