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
#ifndef itkProjectionSimilarityFilter_h
#define itkProjectionSimilarityFilter_h

#include "itkPoseSolution.h"

#include "itkDataObjectDecorator.h"
#include "itkMesh.h"
#include "itkProcessObject.h"
#include "itkSimilarity2DTransform.h"
#include "itkSimpleDataObjectDecorator.h"

namespace itk
{
/** \class ProjectionSimilarityFilter
 * \brief The 2-D similarity that comes nearest to a registered pose: what the paper's method would have to find.
 *
 * It acts in pixels about the origin on the geometry's own projection of a frame of the scan,
 * q = (f m x / sp_u, -m z / sp_v), p = s R q + t, and is the least squares fit over the scan's points. RMS is what it
 * leaves, pixels: a pose parallaxes with depth, and a similarity cannot.
 *
 * Inputs: the PoseSolution, the scan (mm) and the frame, mesh to dental frame, whose projection is meant (that of
 * UMidlineDentalAxisFilter for the jaw). Outputs: the transform, decorated, and RMS.
 *
 * Errors: a jaw that was not registered.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT ProjectionSimilarityFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ProjectionSimilarityFilter);

  using Self = ProjectionSimilarityFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ProjectionSimilarityFilter, ProcessObject);

  using JawEnum = ToothCode::JawEnum;
  using MeshType = Mesh<float, 3>;
  using FrameType = DataObjectDecorator<VersorRigid3DTransform<double>>;
  using TransformType = Similarity2DTransform<double>;
  using DecoratedTransformType = DataObjectDecorator<TransformType>;
  using DecoratedRealType = SimpleDataObjectDecorator<double>;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  /** What a registration found, the jaw's scan (mm), and its frame: mesh to dental frame. All must be set. */
  itkSetInputMacro(Solution, PoseSolution);
  itkGetInputMacro(Solution, PoseSolution);
  itkSetInputMacro(Mesh, MeshType);
  itkGetInputMacro(Mesh, MeshType);
  itkSetInputMacro(Frame, FrameType);
  itkGetInputMacro(Frame, FrameType);

  /** Upper (default) or Lower. */
  itkSetEnumMacro(Jaw, JawEnum);
  itkGetEnumMacro(Jaw, JawEnum);
  /** The similarity of the projected scan, pixels, and the root mean square of what it leaves, pixels. */
  DecoratedTransformType *
  GetTransformOutput();
  const TransformType *
  GetTransform();
  DecoratedRealType *
  GetRMSOutput();
  double
  GetRMS();

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  ProjectionSimilarityFilter();
  ~ProjectionSimilarityFilter() override = default;
  void
  VerifyInputInformation() ITKv5_CONST override
  {}
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  JawEnum m_Jaw{ JawEnum::Upper };
};
} // namespace itk

#endif
