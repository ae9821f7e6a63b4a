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
#ifndef itkPoseMeshContourModel_h
#define itkPoseMeshContourModel_h

#include "itkPoseContourModel.h"
#include "itkToothCode.h"
#include "itkTriangleSurface.h"

#include <array>
#include <memory>
#include <vector>

namespace itk
{
class MeshSilhouette;

/** \class PoseMeshContourModel
 * \brief Makes the moving contour of one jaw and side: the exact outer boundary of the selected triangles, resampled,
 * of which the occlusally and anteriorly facing part is kept.
 *
 * Facing is judged in the dental frame's own plane, so that the head's pitch does not change which part that is.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseMeshContourModel : public PoseContourModel
{
public:
  /** \param surface selected triangles in the dental frame, mm. */
  PoseMeshContourModel(const TriangleSurface & surface, ToothCode::JawEnum jaw, bool useFacingFilter);
  /** The middle of two contours, for a bisected tracing. The other surface is the other side. */
  PoseMeshContourModel(const TriangleSurface & surface,
                       const TriangleSurface & other,
                       ToothCode::JawEnum      jaw,
                       bool                    useFacingFilter);
  ~PoseMeshContourModel() override;

  PoseContour
  Compute(const PoseModel & model) const override;

private:
  OpenSilhouette
  ComputeOpen(const MeshSilhouette & silhouette, const PoseModel & model) const;

  std::unique_ptr<MeshSilhouette> m_Silhouette;
  std::unique_ptr<MeshSilhouette> m_Other;
  /** Corners of the box around the surfaces: where they may be seen the surfaces may. */
  std::vector<std::array<double, 3>> m_Corners;
  ToothCode::JawEnum                 m_Jaw;
  bool                               m_UseFacingFilter;
};
} // namespace itk

#endif
