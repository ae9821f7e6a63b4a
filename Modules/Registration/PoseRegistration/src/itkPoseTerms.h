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
#ifndef itkPoseTerms_h
#define itkPoseTerms_h

#include "itkLandmarkPoseMetricv4.h"
#include "itkPoseRegistrationTypes.h"
#include "itkSilhouettePoseMetricv4.h"
#include "itkToothOutlinePoseMetricv4.h"

#include <memory>
#include <string>
#include <vector>

namespace itk
{
/** Not installed. The terms of a jaw's sum, of the first view and of further ones. */

/** The triangles of a scan in its dental frame. */
std::shared_ptr<const TriangleSurface>
ToDentalFrame(const TriangleSurface & surface, const PoseFrame & frame);

/** The term of landmarks; null where none of them is of the jaw. */
LandmarkPoseMetricv4::Pointer
MakeLandmarkTerm(const PoseJawInput &               jaw,
                 const LandmarkCounterpartSet *     all,
                 const CephalometricLandmarkSet *   landmarks,
                 const CephalometricPoseTransform * transform,
                 const PoseRegistrationOptions &    options);

/** The term of a tracing, without the surface that it is compared with. */
SilhouettePoseMetricv4::Pointer
MakeSilhouetteTerm(ToothCode::JawEnum                 jaw,
                   const DentalContour *              tracing,
                   const CephalometricPoseTransform * transform,
                   const PoseRegistrationOptions &    options);

/** A jaw's crowns of a set of both jaws, or of null, in its dental frame. */
ToothCrownSet::Pointer
ToDentalFrame(const ToothCrownSet * crowns, const PoseJawInput & jaw);

/** The term of outlines of single teeth, of which the crowns are in the dental frame; prepared: where none of them can
 * be used its GetFailure() says why. Where it is registered with landmarks as well (their set and their term, or null)
 * both are told of what they share. */
ToothOutlinePoseMetricv4::Pointer
MakeOutlineTerm(const PoseJawInput &               jaw,
                const ToothCrownSet *              crowns,
                const DentalContour *              tracing,
                const CephalometricLandmarkSet *   landmarks,
                LandmarkPoseMetricv4 *             landmarkTerm,
                const CephalometricPoseTransform * transform,
                const PoseRegistrationOptions &    options);

/** What of its tracing it does not use, and why: a line a reason, with the outlines. */
std::vector<std::string>
DescribeUnused(const ToothOutlinePoseMetricv4 & term);
} // namespace itk

#endif
