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
#include "itkOpenSilhouette.h"
#include "itkPoseModel.h"
#include "itkPosePolyline.h"

#include <array>
#include <memory>
#include <vector>

namespace itk
{
class MeshSilhouette;

/** \struct PoseContour
 * \brief The moving contour at one pose: an open silhouette on the working plane, rim points in the dental frame.
 * \ingroup PoseMetric
 */
struct PoseContour : OpenSilhouette
{
  /** Where the contour is the middle of two (bisected tracing): the other side's points, else empty. */
  std::vector<std::array<double, 3>> rimOther;
};

/** \class PoseContourModel
 * \brief Makes the moving contour of one jaw and side: the exact outer boundary of the selected triangles, resampled,
 * of which the occlusally and anteriorly facing part is kept.
 *
 * Facing is judged in the dental frame's own plane, so that the head's pitch does not change which part that is.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseContourModel
{
public:
  /** Distance between samples, px. */
  static constexpr double Spacing = 0.5;

  /** \param surface selected triangles in the dental frame, mm. */
  PoseContourModel(const TriangleSurface & surface, bool upper, bool useFacingFilter);
  /** The middle of two contours, for a bisected tracing. The other surface is the other side. */
  PoseContourModel(const TriangleSurface & surface, const TriangleSurface & other, bool upper, bool useFacingFilter);
  ~PoseContourModel();
  PoseContourModel(PoseContourModel &&) noexcept;
  PoseContourModel &
  operator=(PoseContourModel &&) noexcept;

  /** Empty where there is nothing to project. */
  PoseContour
  Compute(const PoseModel & model) const;

  /** Moves a contour's samples to another pose without making it anew. */
  static void
  Reproject(PoseContour & contour, const PoseModel & from, const PoseModel & to);

private:
  OpenSilhouette
  ComputeOpen(const MeshSilhouette & silhouette, const PoseModel & model) const;

  std::unique_ptr<MeshSilhouette> m_Silhouette;
  std::unique_ptr<MeshSilhouette> m_Other;
  bool                            m_Upper;
  bool                            m_UseFacingFilter;
};
} // namespace itk

#endif
