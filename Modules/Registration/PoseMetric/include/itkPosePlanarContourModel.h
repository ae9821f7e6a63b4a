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
#ifndef itkPosePlanarContourModel_h
#define itkPosePlanarContourModel_h

#include "itkPoseContourModel.h"
#include "itkDentalContour.h"
#include "itkPoseTypes.h"

#include <vector>

namespace itk
{
/** \class PosePlanarContourModel
 * \brief A moving contour that was drawn or projected once, and moves as a drawing on the midsagittal plane does.
 *
 * For an outline without the scan that it is of: of another radiograph, of a DRR, of a segmentation. Its points are
 * taken back along their rays to the plane y = 0 of the dental frame, from the pose at which it was drawn. That plane
 * is parallel to the detector where roll and yaw are 0, and moves there by a similarity: pitch is its angle, tx and tz
 * its shift, ty or kappa its scale. Roll and yaw, which a drawing cannot tell, are for the caller to hold.
 *
 * Open polylines are taken whole; of closed ones the occlusally and anteriorly facing part is kept, as of a scan's
 * outline. Their normals face outward, of open ones occlusally or anteriorly.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PosePlanarContourModel : public PoseContourModel
{
public:
  /** \param outline  continuous pixel indices of the radiograph.
   *  \param pose  at which it is drawn. */
  PosePlanarContourModel(const PoseGeometry &                 geometry,
                         const DentalContour::PolylinesType & outline,
                         const PoseParameters &               pose,
                         ToothCode::JawEnum                   jaw,
                         bool                                 useFacingFilter);

  PoseContour
  Compute(const PoseModel & model) const override;

private:
  PoseModel   m_Drawn;
  PoseContour m_Contour;
};
} // namespace itk

#endif
