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
#ifndef itkPoseJawDescription_h
#define itkPoseJawDescription_h

#include "itkLandmarkPoseMetricv4.h"
#include "itkPoseModel.h"
#include "itkPoseRegistrationTypes.h"
#include "itkSilhouettePoseMetricv4.h"
#include "itkToothOutlineComparison.h"
#include "itkToothOutlinePoseMetricv4.h"

#include <array>
#include <vector>

namespace itk
{
/** Not installed. What a result says of a jaw at the solution. */

/** Pose and projection in the mesh's frame. */
void
PlaceJaw(const PoseGeometry & geometry, const PoseParameters & parameters, PoseJawResult & result);

/** What the verdict wants to know of a jaw besides the fit. */
void
DescribeJaw(const PoseJawInput &            input,
            const TriangleSurface &         surface,
            const PoseRegistrationOptions & options,
            PoseJawResult &                 result);

/** How a jaw's tracing is explained at the solution, and its moving contour in pixels and on the mesh. */
void
DescribeFit(const SilhouettePoseMetricv4 &               metric,
            const SilhouettePoseMetricv4::PositionType & x,
            const std::array<double, 49> &               covariance,
            const PoseGeometry &                         geometry,
            PoseJawResult &                              jaw);

/** The outlines of whole teeth of a jaw at the solution, and which of them are templates by comparison. */
void
DescribeOutlines(const ToothOutlinePoseMetricv4 &                          metric,
                 const std::vector<ToothOutlineComparison::TemplateType> & templates,
                 const ToothOutlinePoseMetricv4::PositionType &            x,
                 PoseJawResult &                                           jaw);

/** The landmarks of a jaw at the solution. */
void
DescribeLandmarks(const LandmarkPoseMetricv4 &               metric,
                  const LandmarkPoseMetricv4::PositionType & x,
                  PoseJawResult &                            jaw);

/** The uncertainty of the middle of both sides at the front of the arch and 35 mm behind it, where first molars stand:
 * what drawings that are of no side determine. And the place of the cusps there, for the bite. */
void
DescribeMiddle(const TriangleSurface &        surface,
               const PoseGeometry &           geometry,
               const PoseModel &              model,
               const std::array<double, 49> & covariance,
               PoseJawResult &                jaw);
} // namespace itk

#endif
