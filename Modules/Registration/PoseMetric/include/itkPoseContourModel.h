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

#include <array>
#include <vector>

namespace itk
{
/** \class PoseContourModel
 * \brief What is matched with a tracing: makes the moving contour at a pose.
 *
 * The residuals, weights and noise of SilhouettePoseMetricv4 are the same whatever moves: a scan, whose outline is made
 * anew at each pose (PoseMeshContourModel), or an outline that was drawn or projected once (PosePlanarContourModel).
 *
 * A pose in which what moves is not in front of the source, is seen larger than LargestExtent, or is not finite is no
 * place where a scan may lie: an ExceptionObject says how it came to be asked. A value that is finite and huge would
 * help line searches to turn back, but has no slope: an optimizer without a line search would stop there content, and
 * a registration would end with a wrong answer instead of an error.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseContourModel
{
public:
  /** Distance between samples, px. */
  static constexpr double Spacing = 0.5;
  /** px of the working plane, along u and along v: 5 m on the detector, some 60 times an arch. Samples are made in
   * proportion to it. */
  static constexpr double LargestExtent = 20000.0;

  PoseContourModel() = default;
  virtual ~PoseContourModel();
  PoseContourModel(const PoseContourModel &) = delete;
  PoseContourModel &
  operator=(const PoseContourModel &) = delete;

  /** Empty where there is nothing to project. Throws where the pose is none of a scan before the source. May be called
   * from several threads. */
  virtual PoseContour
  Compute(const PoseModel & model) const = 0;

  /** Moves a contour's samples to another pose without making it anew. Throws as Compute() does. */
  static void
  Reproject(PoseContour & contour, const PoseModel & from, const PoseModel & to);

protected:
  /** Throws unless points of the dental frame, mm, are where a scan may be seen. */
  static void
  VerifyPlaces(const PoseModel & model, const std::vector<std::array<double, 3>> & points);
};
} // namespace itk

#endif
