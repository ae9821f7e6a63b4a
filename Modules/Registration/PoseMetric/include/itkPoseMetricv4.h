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
#ifndef itkPoseMetricv4_h
#define itkPoseMetricv4_h

#include "PoseMetricExport.h"
#include "itkCephalometricPoseTransform.h"
#include "itkLeastSquaresMetricv4.h"

#include <string>

namespace itk
{
/** \class PoseMetricv4
 * \brief Base of the terms whose residuals are those of a scan's pose on a radiograph.
 *
 * The geometry of the radiograph is that of the transform (fixed parameters), whose parameters are where the state
 * begins. Blocks read: the pose of a body and the scale of a view, "pose" and "scale" or as named (PoseStateBlocks), so
 * that a position holds pitch, roll, yaw, tx, ty, tz, kappa, as PoseParameters.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseMetricv4 : public LeastSquaresMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PoseMetricv4);

  using Self = PoseMetricv4;
  using Superclass = LeastSquaresMetricv4;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(PoseMetricv4, LeastSquaresMetricv4);

  using TransformType = CephalometricPoseTransform;
  static constexpr unsigned int NumberOfPoseParameters = TransformType::NumberOfParameters; /**< The transform's. */

  /** Geometry of the radiograph and where the pose begins. */
  virtual void
  SetTransform(const TransformType * transform);
  itkGetConstObjectMacro(Transform, TransformType);

  /** Names of the blocks: another body or view has others. The values go along. */
  void
  SetPoseBlock(const std::string & name);
  itkGetStringMacro(PoseBlock);
  void
  SetScaleBlock(const std::string & name);
  itkGetStringMacro(ScaleBlock);

  BlocksType
  DeclareBlocks() const override;

  /** Of the transform as well. */
  ModifiedTimeType
  GetMTime() const override;

protected:
  PoseMetricv4() = default;
  ~PoseMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  /** Throws where there is no transform, or it has no geometry. */
  void
  InitializeTerm() override;
  /** Copies transform, blocks and state, for InternalClone(). */
  void
  CopyPose(const Self & other);
  /** The pose and the scale of a position, from their blocks. */
  static PoseParameters
  ToPoseParameters(const PositionType & x);

private:
  void
  RenameBlock(std::string & block, const std::string & name);

  TransformType::ConstPointer m_Transform;
  std::string                 m_PoseBlock{ "pose" };
  std::string                 m_ScaleBlock{ "scale" };
};
} // namespace itk

#endif
