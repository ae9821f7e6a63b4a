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
#ifndef itkSurfaceSplatWidthCalculator_h
#define itkSurfaceSplatWidthCalculator_h

#include "SurfaceDRRExport.h"
#include "itkCephalometricGeometry.h"

#include "itkMesh.h"
#include "itkProcessObject.h"
#include "itkSimpleDataObjectDecorator.h"

namespace itk
{
/** \class SurfaceSplatWidthCalculator
 * \brief The width of SurfaceDRRImageSource's splats that closes a scan's surface and no more.
 *
 * A splat stands for a vertex. Narrower than the distance between vertices, splats leave holes in the silhouette; wider
 * ones move its border outward. Inputs: the mesh (mm) and the geometry, which needs its pixel spacing but no pose.
 * Output: the standard deviation, mm in the detector plane, for SetSigma():
 *
 *   sigma = max(mean pixel spacing, WidthFactor * D / S * sqrt(area / vertices))
 *
 * with the distances D of the detector and S of the midsagittal plane from the source. The root is the mean distance
 * between vertices; a pixel is the finest that the image can show.
 *
 * Errors (ExceptionObject): no mesh or no geometry; a mesh without points; a geometry without a pixel spacing.
 *
 * \sa SurfaceDRRImageSource
 * \test itkSurfaceSplatWidthCalculatorGTest.cxx
 * \ingroup SurfaceDRR
 */
class SurfaceDRR_EXPORT SurfaceSplatWidthCalculator : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SurfaceSplatWidthCalculator);

  using Self = SurfaceSplatWidthCalculator;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(SurfaceSplatWidthCalculator, ProcessObject);

  using MeshType = Mesh<float, 3>;
  using GeometryType = CephalometricGeometry;
  using RealObjectType = SimpleDataObjectDecorator<double>;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  /** The scan, mm, and the geometry of the picture, with the object in place. Both must be set. */
  itkSetInputMacro(Mesh, MeshType);
  itkGetInputMacro(Mesh, MeshType);
  itkSetInputMacro(Geometry, GeometryType);
  itkGetInputMacro(Geometry, GeometryType);

  /** Standard deviation over the mean distance between vertices. 0.7 by default: the sum of such splats on a regular
   * grid is level to a part in a thousand. */
  itkSetMacro(WidthFactor, double);
  itkGetConstMacro(WidthFactor, double);

  /** mm in the detector plane; valid after Update(). */
  double
  GetSigma() const;
  RealObjectType *
  GetSigmaOutput();

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  SurfaceSplatWidthCalculator();
  ~SurfaceSplatWidthCalculator() override = default;
  /** A mesh and a geometry share no physical space that could be compared. */
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
  double m_WidthFactor{ 0.7 };
};
} // namespace itk

#endif
