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
#ifndef itkFindSilhouettes_h
#define itkFindSilhouettes_h

#include "PoseRegistrationExport.h"

#include "itkSilhouettePoseMetricv4.h"

#include <vector>

namespace itk
{
/** A silhouette among the terms of a metric, and the part of the metric's position that it reads. */
struct FoundSilhouette
{
  const SilhouettePoseMetricv4 *       metric{ nullptr }; /**< The term; not owned. */
  SilhouettePoseMetricv4::PositionType position;          /**< That part, in the term's own order. */
};

/** The silhouettes of a metric, of a sum and of sums within it, in order, at the metric's current position. */
PoseRegistration_EXPORT std::vector<FoundSilhouette>
                        FindSilhouettes(const LeastSquaresMetricv4 & metric);
/** The same at a position. */
PoseRegistration_EXPORT std::vector<FoundSilhouette>
FindSilhouettes(const LeastSquaresMetricv4 & metric, const LeastSquaresMetricv4::PositionType & x);
/** Of these, the ones that a global start is to look at, at the metric's current position: they read the blocks "pose"
 * and "scale", which a start sets, and are of one radiograph, that of the first of them. A further view of a user's has
 * pixels and a place of its own, that mean nothing in the first one's. */
PoseRegistration_EXPORT std::vector<FoundSilhouette>
                        FindSilhouettesOfStart(const LeastSquaresMetricv4 & metric);
} // namespace itk

#endif
