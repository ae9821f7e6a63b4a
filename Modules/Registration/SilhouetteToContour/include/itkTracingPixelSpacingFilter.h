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
#ifndef itkTracingPixelSpacingFilter_h
#define itkTracingPixelSpacingFilter_h

#include "SilhouetteToContourExport.h"
#include "itkCephalometricGeometry.h"
#include "itkDentalContour.h"
#include "itkToothCode.h"

#include "itkDataObjectDecorator.h"
#include "itkMesh.h"
#include "itkProcessObject.h"
#include "itkVersorRigid3DTransform.h"

namespace itk
{
/** \class TracingPixelSpacingFilter
 * \brief A geometry with a pixel spacing that makes scans and tracings equally wide: what is left where none is known.
 *
 * A radiograph without a pixel spacing can be registered, but whatever needs millimetres needs a rough one. For each
 * jaw whose mesh, contour and frame are set, the projection of the whole scan, central ray through the frame's origin,
 * is so many mm wide on the detector, and its tracing so many pixels. The ratio's mean over the jaws is the spacing of
 * the output, of both axes: the jaws lie in one image. Teeth that were not traced make it too large.
 *
 * Inputs: the geometry, whose own pixel spacing is not used; meshes (mm), contours (pixels) and frames (mesh to dental
 * frame, decorated) of one jaw or both. The output is a copy of the geometry with the spacing.
 *
 * Errors (ExceptionObject): no geometry. Jaws that are incomplete, or whose tracing has no width, are left out; where
 * nothing is left the spacing is DefaultPixelSpacing.
 *
 * \test itkTracingPixelSpacingFilterGTest.cxx
 * \ingroup SilhouetteToContour
 */
class SilhouetteToContour_EXPORT TracingPixelSpacingFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TracingPixelSpacingFilter);

  using Self = TracingPixelSpacingFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(TracingPixelSpacingFilter, ProcessObject);

  using JawEnum = ToothCode::JawEnum;
  using MeshType = Mesh<float, 3>;
  using ContourType = DentalContour;
  using GeometryType = CephalometricGeometry;
  using FrameType = DataObjectDecorator<VersorRigid3DTransform<double>>;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  /** Geometry, and a scan (mm), its frame and its tracing (continuous pixel indices) of one jaw at least. */
  itkSetInputMacro(Geometry, GeometryType);
  itkGetInputMacro(Geometry, GeometryType);
  itkSetInputMacro(UpperMesh, MeshType);
  itkGetInputMacro(UpperMesh, MeshType);
  itkSetInputMacro(LowerMesh, MeshType);
  itkGetInputMacro(LowerMesh, MeshType);
  itkSetInputMacro(UpperContour, ContourType);
  itkGetInputMacro(UpperContour, ContourType);
  itkSetInputMacro(LowerContour, ContourType);
  itkGetInputMacro(LowerContour, ContourType);
  itkSetInputMacro(UpperFrame, FrameType);
  itkGetInputMacro(UpperFrame, FrameType);
  itkSetInputMacro(LowerFrame, FrameType);
  itkGetInputMacro(LowerFrame, FrameType);

  /** The inputs of a jaw in one call. */
  void
  SetJaw(JawEnum jaw, const MeshType * mesh, const ContourType * contour, const FrameType * frame);

  /** mm a pixel in the detector plane where nothing can be measured. 0.25 by default, a scanned film at 100 dpi. */
  itkSetMacro(DefaultPixelSpacing, double);
  itkGetConstMacro(DefaultPixelSpacing, double);
  /** A copy of the geometry with the spacing. */
  GeometryType *
  GetOutput();

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  TracingPixelSpacingFilter();
  ~TracingPixelSpacingFilter() override = default;
  /** Meshes, contours and a geometry share no physical space that could be compared. */
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
  double
  Measure(const MeshType * mesh, const ContourType * contour, const FrameType * frame) const;

  double m_DefaultPixelSpacing{ 0.25 };
};
} // namespace itk

#endif
