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
#ifndef itkLandmarkPoseStart_h
#define itkLandmarkPoseStart_h

#include "PoseRegistrationExport.h"

#include "itkLandmarkPoseMetricv4.h"
#include "itkPoseStart.h"
#include "itkToothOutlinePoseMetricv4.h"

#include <vector>

namespace itk
{
/** \class LandmarkPoseStart
 * \brief Starts from landmarks and from whole teeth: the similarity in the plane of the picture that brings those of
 * the scan to what is drawn.
 *
 * Looks at the terms of the metric that are LandmarkPoseMetricv4 or ToothOutlinePoseMetricv4, whose crowns have their
 * centres for marks, and read the blocks "pose" and "scale". Of four marks
 * or more each is left out once, so that one of the starts is without a gross error wherever it may be. One mark gives
 * the shift alone.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT LandmarkPoseStart : public PoseStart
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LandmarkPoseStart);

  using Self = LandmarkPoseStart;
  using Superclass = PoseStart;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LandmarkPoseStart, PoseStart);

  std::vector<StartType>
  Search(const LeastSquaresMetricv4 & metric, const RequestType & request) const override;

  /** The landmark terms of a metric or a sum that read the method's own blocks, in their order. */
  static std::vector<const LandmarkPoseMetricv4 *>
  FindTerms(const LeastSquaresMetricv4 & metric);

  /** The same of the terms of whole teeth. */
  static std::vector<const ToothOutlinePoseMetricv4 *>
  FindOutlineTerms(const LeastSquaresMetricv4 & metric);

protected:
  LandmarkPoseStart() = default;
  ~LandmarkPoseStart() override = default;
};
} // namespace itk

#endif
