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
#ifndef itkPoseContourModel_h
#define itkPoseContourModel_h

#include "PoseMetricExport.h"
#include "itkPoseContour.h"
#include "itkPoseModel.h"

namespace itk
{
/** \class PoseContourModel
 * \brief What is matched with a tracing: makes the moving contour at a pose.
 *
 * The residuals, weights and noise of SilhouettePoseMetricv4 are the same whatever moves: a scan, whose outline is made
 * anew at each pose (PoseMeshContourModel), or an outline that was drawn or projected once (PosePlanarContourModel).
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseContourModel
{
public:
  /** Distance between samples, px. */
  static constexpr double Spacing = 0.5;

  PoseContourModel() = default;
  virtual ~PoseContourModel();
  PoseContourModel(const PoseContourModel &) = delete;
  PoseContourModel &
  operator=(const PoseContourModel &) = delete;

  /** Empty where there is nothing to project. May be called from several threads. */
  virtual PoseContour
  Compute(const PoseModel & model) const = 0;

  /** Moves a contour's samples to another pose without making it anew. */
  static void
  Reproject(PoseContour & contour, const PoseModel & from, const PoseModel & to);
};
} // namespace itk

#endif
