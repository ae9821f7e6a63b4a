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
#ifndef itkSimilarityPlacementFilter_h
#define itkSimilarityPlacementFilter_h

#include "SilhouetteToContourExport.h"
#include "itkCephalometricGeometry.h"

#include "itkDataObjectDecorator.h"
#include "itkMatrix.h"
#include "itkProcessObject.h"
#include "itkSimilarity2DTransform.h"
#include "itkSimpleDataObjectDecorator.h"
#include "itkVersorRigid3DTransform.h"

namespace itk
{
/** \class SimilarityPlacementFilter
 * \brief Where a 2-D similarity of a silhouette puts the scan: projection onto the radiograph, and place in the
 * cephalostat.
 *
 * The similarity p = s R q + t acts in pixels on the projection q of a frame of the scan with the central ray through
 * the frame's origin (GeometryPlacementFilter with CentralRayThroughOriginOn()), as
 * SilhouetteToContourRegistrationMethod finds it. Two things follow:
 *
 * - the projection matrix from the mesh to the homogeneous continuous pixel index, which is exact: similarity times
 *   projection;
 * - a rigid transform from the mesh to the cephalostat: the in-plane rotation becomes one about y, the shift one in the
 *   midsagittal plane. The scale is no rigid motion, but a factor on the magnification, which says how many mm a pixel
 *   is. It is exact for points of the midsagittal plane; others parallax with depth, which a similarity cannot.
 *
 * Inputs: the similarity and the frame (mesh, mm, to dental frame), decorated, and the geometry with its pixel spacing
 * and principal point. ProjectionSimilarityFilter goes the other way.
 *
 * Errors (ExceptionObject): a missing input; a geometry without a pixel spacing; a scale that is not positive.
 *
 * \test itkSimilarityPlacementFilterGTest.cxx
 * \ingroup SilhouetteToContour
 */
class SilhouetteToContour_EXPORT SimilarityPlacementFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SimilarityPlacementFilter);

  using Self = SimilarityPlacementFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(SimilarityPlacementFilter, ProcessObject);

  using GeometryType = CephalometricGeometry;
  using SimilarityType = Similarity2DTransform<double>;
  using RigidTransformType = VersorRigid3DTransform<double>;
  using FrameType = DataObjectDecorator<RigidTransformType>;
  using DecoratedTransformType = DataObjectDecorator<RigidTransformType>;
  using ProjectionMatrixType = CephalometricGeometry::ProjectionMatrixType;
  using DecoratedMatrixType = SimpleDataObjectDecorator<ProjectionMatrixType>;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  /** SetSimilarityInput() takes the decorated output of a registration. */
  itkSetGetDecoratedObjectInputMacro(Similarity, SimilarityType);
  itkSetInputMacro(Frame, FrameType);
  itkGetInputMacro(Frame, FrameType);
  itkSetInputMacro(Geometry, GeometryType);
  itkGetInputMacro(Geometry, GeometryType);

  /** The projection matrix acts on points in this unit, which is that of the mesh's file. 1 by default: mm. */
  itkSetMacro(MillimetresPerUnit, double);
  itkGetConstMacro(MillimetresPerUnit, double);

  /** Mesh, in the unit of the file, to homogeneous continuous pixel index; valid after Update(). */
  const ProjectionMatrixType &
  GetProjectionMatrix();
  DecoratedMatrixType *
  GetProjectionMatrixOutput();
  /** Mesh, mm, to cephalostat; valid after Update(). */
  const RigidTransformType *
  GetTransform();
  DecoratedTransformType *
  GetTransformOutput();

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  SimilarityPlacementFilter();
  ~SimilarityPlacementFilter() override = default;
  /** Transforms and a geometry share no physical space that could be compared. */
  void
  VerifyInputInformation() ITKv5_CONST override
  {}
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  double m_MillimetresPerUnit{ 1.0 };
};
} // namespace itk

#endif
