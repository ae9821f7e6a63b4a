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
#ifndef itkPoseToothContourModel_h
#define itkPoseToothContourModel_h

#include "PoseMetricExport.h"

#include "itkLandmarkCounterpartSet.h"
#include "itkPoseContourModel.h"
#include "itkToothCode.h"
#include "itkTriangleSurface.h"

#include <array>
#include <memory>
#include <vector>

namespace itk
{
class MeshSilhouette;

/** \class PoseToothContourModel
 * \brief Makes the outline of a single tooth's crown, as it is drawn: of one alone, as on a frontal radiograph, of the
 * one that stands foremost of two, or the middle of both sides' images.
 *
 * The outline of a crown is all of the outer boundary of its projection but what faces the root, where the crown was
 * cut out of the scan. For a middle each sample of the right tooth is paired with the left one's that lies nearest once
 * both crowns' centres are brought together, as the outlines of a tooth and its fellow are alike and their places are
 * not.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseToothContourModel : public PoseContourModel
{
public:
  using RuleEnum = LandmarkCounterpartSet::RuleEnum;

  /** \param crowns  one, or one of each side; dental frame, mm. */
  PoseToothContourModel(const std::vector<std::shared_ptr<const TriangleSurface>> & crowns,
                        RuleEnum                                                    rule,
                        ToothCode::JawEnum                                          jaw);
  ~PoseToothContourModel() override;

  PoseContour
  Compute(const PoseModel & model) const override;

  /** The middle of the crowns' centroids. */
  const std::array<double, 3> &
  GetCentre() const
  {
    return m_Centre;
  }

private:
  PoseContour
  ComputeOne(std::size_t crown, const PoseModel & model) const;
  PoseContour
  ComputeMiddle(const PoseModel & model) const;

  std::vector<std::unique_ptr<MeshSilhouette>> m_Silhouettes;
  std::vector<std::array<double, 3>>           m_Centroids;
  std::vector<std::array<double, 3>>           m_Corners;
  std::array<double, 3>                        m_Centre{};
  RuleEnum                                     m_Rule;
  ToothCode::JawEnum                           m_Jaw;
};
} // namespace itk

#endif
