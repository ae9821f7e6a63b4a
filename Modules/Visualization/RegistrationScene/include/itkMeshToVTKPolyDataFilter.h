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
#ifndef itkMeshToVTKPolyDataFilter_h
#define itkMeshToVTKPolyDataFilter_h

#include "itkProcessObject.h"
#include "itkSimpleDataObjectDecorator.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace itk
{
/** \class MeshToVTKPolyDataFilter
 * \brief Copies an itk::Mesh of two or three dimensions to a vtkPolyData.
 *
 * Points keep their type (float or double); those of a mesh of two dimensions, such as a DentalContour, get z = 0. Ids
 * with holes become consecutive ones. Cells that are vertices, lines, triangles, quadrilaterals and polygons become
 * verts, lines and polys; any other is an error, and so is one that names a point that is not there.
 *
 * Point and cell data become arrays under the names PointDataName and CellDataName, and the active scalars, with as
 * many components as the pixel type has. A mesh that has none gets no array; a point or cell without a value gets 0.
 * VTK orders cells by kind (verts, lines, polys): so are their data.
 *
 * A header for whoever links VTK::CommonCore and VTK::CommonDataModel; the libraries of DentalSCR link neither. The
 * output is an object of VTK's in a decorator of ITK's, so that an ITK pipeline may end here:
 *
 * \code
 * auto toVTK = itk::MeshToVTKPolyDataFilter<MeshType>::New();
 * toVTK->SetInput(reader->GetOutput());
 * toVTK->Update();
 * mapper->SetInputData(toVTK->GetOutput());
 * \endcode
 *
 * \sa VTKPolyDataToMeshFilter
 * \test itkMeshToVTKPolyDataFilterGTest.cxx
 * \ingroup RegistrationScene
 */
template <typename TInputMesh>
class ITK_TEMPLATE_EXPORT MeshToVTKPolyDataFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MeshToVTKPolyDataFilter);

  using Self = MeshToVTKPolyDataFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(MeshToVTKPolyDataFilter, ProcessObject);

  using InputMeshType = TInputMesh;
  using OutputDecoratorType = SimpleDataObjectDecorator<vtkSmartPointer<vtkPolyData>>;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  /** The mesh. Must be set. */
  using Superclass::SetInput;
  void
  SetInput(const InputMeshType * mesh);
  const InputMeshType *
  GetInput() const;

  /** Default "PointData". */
  itkSetStringMacro(PointDataName);
  itkGetStringMacro(PointDataName);

  /** Default "CellData". */
  itkSetStringMacro(CellDataName);
  itkGetStringMacro(CellDataName);

  /** Valid after Update(), and made anew by each that runs: what was taken before stays as it is. */
  vtkPolyData *
  GetOutput() const;

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  MeshToVTKPolyDataFilter();
  ~MeshToVTKPolyDataFilter() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  /** A mesh has no spacing or origin that could be compared. */
  void
  VerifyInputInformation() ITKv5_CONST override
  {}
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string m_PointDataName{ "PointData" };
  std::string m_CellDataName{ "CellData" };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMeshToVTKPolyDataFilter.hxx"
#endif

#endif
