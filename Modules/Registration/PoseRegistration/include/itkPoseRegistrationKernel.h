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
#ifndef itkPoseRegistrationKernel_h
#define itkPoseRegistrationKernel_h

#include "PoseRegistrationExport.h"
#include "itkPoseRegistrationTypes.h"

namespace itk
{
/** \class PoseRegistrationKernel
 * \brief The robust registration: tracing and meshes to pose, scale and uncertainty, without a click. Free of ITK
 * headers.
 *
 * 1. the side that was traced is cut out at the midline plane, the outer boundary of its projection opened to the
 *    occlusal and anterior part (PoseContourModel);
 * 2. the tracing is ordered, turned and given normals (PoseTracing);
 * 3. global start: exhaustive search over rotation and shift from several yaw angles (PoseStartSearch), refined as
 *    similarities, distinct ones pooled;
 * 4. six degrees of freedom and scale with regenerated contours, correlated noise, robust kernel and priors
 *    (PoseEstimator), for all jaws that share a frame at once;
 * 5. choice among the refined candidates at one fixed kernel width with the tooth codes' places;
 * 6. covariance.
 *
 * The result is the same for any number of threads. Documentation/Robust.md has formulas, figures and limits.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PoseRegistrationKernel
{
public:
  /** Registers the jaws. With options.useJointPose all jaws must have been given the same frame. A jaw that cannot be
   * registered comes back with a reason; std::invalid_argument is thrown for unusable geometry or options only. */
  static PoseRegistrationResult
  Run(const std::vector<PoseJawInput> & jaws, const PoseGeometry & geometry, const PoseRegistrationOptions & options);

  /** 2x2 covariance (pixels squared of the radiograph, row-major) of the projection of a point of the mesh frame. */
  static std::array<double, 4>
  LandmarkCovariance(const PoseRegistrationResult &  result,
                     const PoseJawInput &          jaw,
                     std::size_t                   jawIndex,
                     const std::array<double, 3> & point);

  /** The triangles whose centre lies on one side: side * y < margin with side +1 for the right half, -1 for the left.
   */
  static TriangleSurface
  SelectSide(const TriangleSurface & dentalFrameSurface, double side, double margin);
};
} // namespace itk

#endif
