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
#ifndef itkGeometryPlacementFilter_h
#define itkGeometryPlacementFilter_h

#include "CephalometricPoseExport.h"
#include "itkCephalometricGeometry.h"

#include "itkDataObjectDecorator.h"
#include "itkProcessObject.h"
#include "itkVersorRigid3DTransform.h"

namespace itk
{
/** \class GeometryPlacementFilter
 * \brief A radiograph's geometry with an object in it: the pose is a transform of the pipeline.
 *
 * Inputs: the geometry and the frame, a decorated rigid transform from the object's mesh to the cephalostat, as
 * UMidlineDentalAxisFilter gives it. The output is a copy of the geometry with that pose: ProjectPoint() of a mesh's
 * point is its place on the radiograph.
 *
 * With CentralRayThroughOrigin the principal point of the output is pixel (0, 0), so that places are relative to where
 * the frame's origin is seen: the projection q on which the paper's similarity acts. The principal point of the input
 * is then not used, and need not be known.
 *
 * Errors (ExceptionObject): no geometry; no frame, or an empty one.
 *
 * Source: the projection of the paper, with the central ray through the centroid of the arch.
 *
 * \test itkGeometryPlacementFilterGTest.cxx
 * \ingroup CephalometricPose
 */
class CephalometricPose_EXPORT GeometryPlacementFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(GeometryPlacementFilter);

  using Self = GeometryPlacementFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(GeometryPlacementFilter, ProcessObject);

  using GeometryType = CephalometricGeometry;
  using FrameType = DataObjectDecorator<VersorRigid3DTransform<double>>;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  /** The radiograph's geometry, and the object's frame: mesh (mm) to dental frame. Both must be set. */
  itkSetInputMacro(Geometry, GeometryType);
  itkGetInputMacro(Geometry, GeometryType);
  itkSetInputMacro(Frame, FrameType);
  itkGetInputMacro(Frame, FrameType);

  /** Off by default. */
  itkSetMacro(CentralRayThroughOrigin, bool);
  itkGetConstMacro(CentralRayThroughOrigin, bool);
  itkBooleanMacro(CentralRayThroughOrigin);
  /** A copy of the geometry with the object where the pose puts it. */
  GeometryType *
  GetOutput();

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  GeometryPlacementFilter();
  ~GeometryPlacementFilter() override = default;
  /** A geometry and a transform share no physical space that could be compared. */
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
  bool m_CentralRayThroughOrigin{ false };
};
} // namespace itk

#endif
