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
#ifndef itkVTKPolyDataToMeshFilter_h
#define itkVTKPolyDataToMeshFilter_h

#include "itkMeshSource.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace itk
{
/** \class VTKPolyDataToMeshFilter
 * \brief Copies a vtkPolyData to an itk::Mesh of two or three dimensions.
 *
 * Cells become VertexCell, LineCell, TriangleCell, QuadrilateralCell and PolygonCell. ITK 5.2 has no cell for a
 * polyline and none for a strip: each segment and each triangle of these is a cell of its own, with the strip's sense
 * kept. A mesh of two dimensions takes points with z = 0.
 *
 * The array PointDataName becomes the points' data and CellDataName the cells'; where the name is empty, the default,
 * that is the active scalars, if any. What a polyline or strip becomes has its value. Values are converted to the
 * mesh's pixel type, which must have as many components.
 *
 * The input is VTK's: bring its pipeline up to date first. A change of it since the last Update() is seen.
 *
 * Errors (ExceptionObject): no input; an array that is not there, or has another number of components or no numbers; a
 * cell that names a point that is not there, and lines and polygons with too few points.
 *
 * A header for whoever links VTK::CommonCore and VTK::CommonDataModel; the libraries of DentalSCR link neither.
 *
 * \sa MeshToVTKPolyDataFilter
 * \test itkMeshToVTKPolyDataFilterGTest.cxx
 * \ingroup RegistrationScene
 */
template <typename TOutputMesh>
class ITK_TEMPLATE_EXPORT VTKPolyDataToMeshFilter : public MeshSource<TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VTKPolyDataToMeshFilter);

  using Self = VTKPolyDataToMeshFilter;
  using Superclass = MeshSource<TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(VTKPolyDataToMeshFilter, MeshSource);

  using OutputMeshType = TOutputMesh;
  /** What is copied. Must be set. */
  using Superclass::SetInput;
  void
  SetInput(vtkPolyData * polyData);
  vtkPolyData *
  GetInput() const
  {
    return m_Input;
  }

  /** Default "": the active scalars. */
  itkSetStringMacro(PointDataName);
  itkGetStringMacro(PointDataName);

  /** Default "": the active scalars. */
  itkSetStringMacro(CellDataName);
  itkGetStringMacro(CellDataName);
  /** Looks whether the input has changed, as VTK says it. */
  void
  UpdateOutputInformation() override;

protected:
  VTKPolyDataToMeshFilter() = default;
  ~VTKPolyDataToMeshFilter() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  /** The input has no information that a mesh could copy. */
  void
  GenerateOutputInformation() override
  {}
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  vtkSmartPointer<vtkPolyData> m_Input;
  /** VTK's clock is not ITK's: that it has moved is all that can be told. */
  vtkMTimeType m_InputMTime{ 0 };
  std::string  m_PointDataName;
  std::string  m_CellDataName;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkVTKPolyDataToMeshFilter.hxx"
#endif

#endif
