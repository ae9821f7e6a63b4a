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
#ifndef itkMeshToVTKPolyDataFilter_hxx
#define itkMeshToVTKPolyDataFilter_hxx

#include "itkMeshToVTKPolyDataFilter.h"

#include "itkDefaultConvertPixelTraits.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <array>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace itk
{
template <typename TInputMesh>
MeshToVTKPolyDataFilter<TInputMesh>::MeshToVTKPolyDataFilter()
{
  this->SetNumberOfRequiredInputs(1);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

template <typename TInputMesh>
typename MeshToVTKPolyDataFilter<TInputMesh>::DataObjectPointer
MeshToVTKPolyDataFilter<TInputMesh>::MakeOutput(DataObjectPointerArraySizeType)
{
  return OutputDecoratorType::New().GetPointer();
}

template <typename TInputMesh>
void
MeshToVTKPolyDataFilter<TInputMesh>::SetInput(const InputMeshType * mesh)
{
  this->ProcessObject::SetNthInput(0, const_cast<InputMeshType *>(mesh));
}

template <typename TInputMesh>
const typename MeshToVTKPolyDataFilter<TInputMesh>::InputMeshType *
MeshToVTKPolyDataFilter<TInputMesh>::GetInput() const
{
  return itkDynamicCastInDebugMode<const InputMeshType *>(this->GetPrimaryInput());
}

template <typename TInputMesh>
vtkPolyData *
MeshToVTKPolyDataFilter<TInputMesh>::GetOutput() const
{
  const auto * decorator =
    itkDynamicCastInDebugMode<const OutputDecoratorType *>(this->ProcessObject::GetPrimaryOutput());
  return decorator->Get();
}

template <typename TInputMesh>
void
MeshToVTKPolyDataFilter<TInputMesh>::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("There is no mesh: call SetInput().");
  }
  Superclass::VerifyPreconditions();
}

namespace MeshToVTKPolyDataFilterDetail
{
/** An array of the values of a container at these ids, in their order; ids without a value have 0. */
template <typename TContainer>
vtkSmartPointer<vtkDataArray>
MakeArray(const TContainer & values, const std::vector<IdentifierType> & ids, const std::string & name)
{
  using PixelType = typename TContainer::Element;
  using Traits = DefaultConvertPixelTraits<PixelType>;
  // VTK has no array of truth values.
  using ComponentType = std::conditional_t<std::is_same<typename Traits::ComponentType, bool>::value,
                                           unsigned char,
                                           typename Traits::ComponentType>;
  const auto count = static_cast<int>(Traits::GetNumberOfComponents());
  auto       array = vtkSmartPointer<vtkAOSDataArrayTemplate<ComponentType>>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(count);
  array->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    PixelType  value{};
    const bool known = values.GetElementIfIndexExists(ids[i], &value);
    for (int component = 0; component < count; ++component)
    {
      array->SetTypedComponent(static_cast<vtkIdType>(i),
                               component,
                               known ? static_cast<ComponentType>(Traits::GetNthComponent(component, value))
                                     : ComponentType{});
    }
  }
  return array;
}
} // namespace MeshToVTKPolyDataFilterDetail

template <typename TInputMesh>
void
MeshToVTKPolyDataFilter<TInputMesh>::GenerateData()
{
  constexpr unsigned int dimension = TInputMesh::PointDimension;
  static_assert(dimension == 2 || dimension == 3, "VTK has points of three dimensions.");
  using CoordinateType = typename TInputMesh::CoordRepType;
  const InputMeshType * const mesh = this->GetInput();
  auto                        output = vtkSmartPointer<vtkPolyData>::New();

  std::vector<IdentifierType>                   pointIds;
  std::unordered_map<IdentifierType, vtkIdType> places;
  auto coordinates = vtkSmartPointer<vtkAOSDataArrayTemplate<CoordinateType>>::New();
  coordinates->SetNumberOfComponents(3);
  if (mesh->GetPoints() != nullptr)
  {
    pointIds.reserve(mesh->GetNumberOfPoints());
    places.reserve(mesh->GetNumberOfPoints());
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(mesh->GetNumberOfPoints()));
    for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
    {
      const auto place = static_cast<vtkIdType>(pointIds.size());
      for (unsigned int d = 0; d < 3; ++d)
      {
        coordinates->SetTypedComponent(place, static_cast<int>(d), d < dimension ? it.Value()[d] : CoordinateType{});
      }
      places.emplace(it.Index(), place);
      pointIds.push_back(it.Index());
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
  this->UpdateProgress(0.3F);

  // In the order of vtkPolyData's own cell ids.
  enum Kind : std::size_t
  {
    Vert,
    Line,
    Poly
  };
  std::array<vtkNew<vtkCellArray>, 3>        arrays;
  std::array<std::vector<IdentifierType>, 3> cellIds;
  if (mesh->GetCells() != nullptr)
  {
    std::vector<vtkIdType> corners;
    for (auto it = mesh->GetCells()->Begin(); it != mesh->GetCells()->End(); ++it)
    {
      const auto * const cell = it.Value();
      Kind               kind = Poly;
      switch (cell->GetType())
      {
        case CellGeometryEnum::VERTEX_CELL:
          kind = Vert;
          break;
        case CellGeometryEnum::LINE_CELL:
          kind = Line;
          break;
        case CellGeometryEnum::TRIANGLE_CELL:
        case CellGeometryEnum::QUADRILATERAL_CELL:
        case CellGeometryEnum::POLYGON_CELL:
          break;
        default:
          itkExceptionMacro("Cell " << it.Index() << " of the mesh is a " << cell->GetNameOfClass()
                                    << ", and vtkPolyData has none. Take it out, or extract its surface first.");
      }
      corners.clear();
      for (auto id = cell->PointIdsBegin(); id != cell->PointIdsEnd(); ++id)
      {
        const auto place = places.find(*id);
        if (place == places.end())
        {
          itkExceptionMacro("Cell " << it.Index() << " of the mesh names point " << *id
                                    << ", which it has not. The mesh is broken; read or build it again.");
        }
        corners.push_back(place->second);
      }
      if (kind == Poly && corners.size() < 3)
      {
        itkExceptionMacro("Cell " << it.Index() << " of the mesh is a polygon of " << corners.size()
                                  << " points. A polygon has three or more; take it out.");
      }
      arrays[kind]->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
      cellIds[kind].push_back(it.Index());
    }
  }
  this->UpdateProgress(0.8F);
  output->SetVerts(arrays[Vert]);
  output->SetLines(arrays[Line]);
  output->SetPolys(arrays[Poly]);

  if (mesh->GetPointData() != nullptr && mesh->GetPointData()->Size() > 0)
  {
    output->GetPointData()->SetScalars(
      MeshToVTKPolyDataFilterDetail::MakeArray(*mesh->GetPointData(), pointIds, m_PointDataName));
  }
  if (mesh->GetCellData() != nullptr && mesh->GetCellData()->Size() > 0)
  {
    std::vector<IdentifierType> ids;
    for (const auto & some : cellIds)
    {
      ids.insert(ids.end(), some.begin(), some.end());
    }
    output->GetCellData()->SetScalars(
      MeshToVTKPolyDataFilterDetail::MakeArray(*mesh->GetCellData(), ids, m_CellDataName));
  }
  itkDynamicCastInDebugMode<OutputDecoratorType *>(this->ProcessObject::GetPrimaryOutput())->Set(output);
}

template <typename TInputMesh>
void
MeshToVTKPolyDataFilter<TInputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "PointDataName: " << m_PointDataName << std::endl;
  os << indent << "CellDataName: " << m_CellDataName << std::endl;
}
} // namespace itk

#endif
