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
#ifndef itkVTKPolyDataToMeshFilter_hxx
#define itkVTKPolyDataToMeshFilter_hxx

#include "itkVTKPolyDataToMeshFilter.h"

#include "itkDefaultConvertPixelTraits.h"
#include "itkLineCell.h"
#include "itkPolygonCell.h"
#include "itkQuadrilateralCell.h"
#include "itkTriangleCell.h"
#include "itkVertexCell.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkIdList.h>
#include <vtkPointData.h>

#include <vector>

namespace itk
{
template <typename TOutputMesh>
void
VTKPolyDataToMeshFilter<TOutputMesh>::SetInput(vtkPolyData * polyData)
{
  if (m_Input != polyData)
  {
    m_Input = polyData;
    this->Modified();
  }
}

template <typename TOutputMesh>
void
VTKPolyDataToMeshFilter<TOutputMesh>::UpdateOutputInformation()
{
  if (m_Input != nullptr && m_Input->GetMTime() != m_InputMTime)
  {
    m_InputMTime = m_Input->GetMTime();
    this->Modified();
  }
  Superclass::UpdateOutputInformation();
}

template <typename TOutputMesh>
void
VTKPolyDataToMeshFilter<TOutputMesh>::VerifyPreconditions() ITKv5_CONST
{
  if (m_Input == nullptr)
  {
    itkExceptionMacro("There is no vtkPolyData: call SetInput().");
  }
  Superclass::VerifyPreconditions();
}

namespace VTKPolyDataToMeshFilterDetail
{
/** Of that name, or the active scalars; null where none was asked for and there are none. Throws otherwise. */
template <typename TPixel>
vtkDataArray *
FindArray(vtkDataSetAttributes & attributes, const std::string & name, const char * what)
{
  if (name.empty() && attributes.GetScalars() == nullptr)
  {
    return nullptr;
  }
  vtkDataArray * const array = name.empty() ? attributes.GetScalars() : attributes.GetArray(name.c_str());
  if (array == nullptr)
  {
    std::string all;
    for (int i = 0; i < attributes.GetNumberOfArrays(); ++i)
    {
      const char * const own = attributes.GetArrayName(i);
      all += std::string(i == 0 ? "" : ", ") + (own == nullptr ? "one without a name" : own);
    }
    itkGenericExceptionMacro("The vtkPolyData has no array of numbers \""
                             << name << "\" at its " << what << ". It has: " << (all.empty() ? "none" : all) << '.');
  }
  const auto components = static_cast<int>(DefaultConvertPixelTraits<TPixel>::GetNumberOfComponents());
  if (array->GetNumberOfComponents() != components)
  {
    itkGenericExceptionMacro("The array \"" << (array->GetName() == nullptr ? "" : array->GetName()) << "\" of the "
                                            << what << " has " << array->GetNumberOfComponents()
                                            << " components, and the mesh's data have " << components
                                            << ". Name another array, or choose a mesh with such data.");
  }
  return array;
}

template <typename TPixel>
TPixel
GetValue(vtkDataArray & array, vtkIdType tuple)
{
  using Traits = DefaultConvertPixelTraits<TPixel>;
  TPixel value{};
  for (int component = 0; component < static_cast<int>(Traits::GetNumberOfComponents()); ++component)
  {
    Traits::SetNthComponent(
      component, value, static_cast<typename Traits::ComponentType>(array.GetComponent(tuple, component)));
  }
  return value;
}
} // namespace VTKPolyDataToMeshFilterDetail

template <typename TOutputMesh>
void
VTKPolyDataToMeshFilter<TOutputMesh>::GenerateData()
{
  constexpr unsigned int dimension = TOutputMesh::PointDimension;
  static_assert(dimension == 2 || dimension == 3, "VTK has points of three dimensions.");
  using CellType = typename TOutputMesh::CellType;
  using PixelType = typename TOutputMesh::MeshTraits::PixelType;
  using CellPixelType = typename TOutputMesh::MeshTraits::CellPixelType;
  namespace Detail = VTKPolyDataToMeshFilterDetail;

  OutputMeshType * const mesh = this->GetOutput();
  mesh->Initialize();
  // Without it the pipeline takes the output for incomplete, and runs again.
  mesh->SetBufferedRegion(0);
  mesh->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  const vtkIdType numberOfPoints = m_Input->GetNumberOfPoints();
  const auto      points = OutputMeshType::PointsContainer::New();
  points->Reserve(static_cast<IdentifierType>(numberOfPoints));
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    const double * const               from = m_Input->GetPoint(i);
    typename OutputMeshType::PointType point;
    for (unsigned int d = 0; d < dimension; ++d)
    {
      point[d] = static_cast<typename OutputMeshType::CoordRepType>(from[d]);
    }
    if (dimension == 2 && from[2] != 0.0)
    {
      itkExceptionMacro("Point " << i << " has z = " << from[2]
                                 << ", which a mesh of two dimensions cannot keep. Choose one of three.");
    }
    points->SetElement(static_cast<IdentifierType>(i), point);
  }
  mesh->SetPoints(points);
  this->UpdateProgress(0.3F);

  if (vtkDataArray * const array = Detail::FindArray<PixelType>(*m_Input->GetPointData(), m_PointDataName, "points"))
  {
    const auto values = OutputMeshType::PointDataContainer::New();
    values->Reserve(static_cast<IdentifierType>(numberOfPoints));
    for (vtkIdType i = 0; i < numberOfPoints; ++i)
    {
      values->SetElement(static_cast<IdentifierType>(i), Detail::GetValue<PixelType>(*array, i));
    }
    mesh->SetPointData(values);
  }

  vtkDataArray * const cellArray = Detail::FindArray<CellPixelType>(*m_Input->GetCellData(), m_CellDataName, "cells");
  const auto           cellValues = OutputMeshType::CellDataContainer::New();
  const auto           cells = OutputMeshType::CellsContainer::New();
  mesh->SetCells(cells);
  vtkIdType  inputCell = 0;
  const auto add = [&](CellType * made, const std::vector<vtkIdType> & corners) {
    typename OutputMeshType::CellAutoPointer cell;
    cell.TakeOwnership(made);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      cell->SetPointId(static_cast<int>(i), static_cast<IdentifierType>(corners[i]));
    }
    const auto id = cells->Size();
    mesh->SetCell(id, cell);
    if (cellArray != nullptr)
    {
      cellValues->InsertElement(id, Detail::GetValue<CellPixelType>(*cellArray, inputCell));
    }
  };
  const auto forEach = [&](vtkCellArray * array, const char * kind, vtkIdType fewest, auto && convert) {
    vtkNew<vtkIdList>      ids;
    std::vector<vtkIdType> corners;
    const vtkIdType        count = array == nullptr ? 0 : array->GetNumberOfCells();
    for (vtkIdType i = 0; i < count; ++i, ++inputCell)
    {
      array->GetCellAtId(i, ids);
      corners.assign(ids->begin(), ids->end());
      if (ids->GetNumberOfIds() < fewest)
      {
        itkExceptionMacro("Cell " << inputCell << " of the vtkPolyData is a " << kind << " of " << corners.size()
                                  << " points, and needs " << fewest << ". Run vtkCleanPolyData first.");
      }
      for (const vtkIdType id : corners)
      {
        if (id < 0 || id >= numberOfPoints)
        {
          itkExceptionMacro("Cell " << inputCell << " of the vtkPolyData names point " << id << " of " << numberOfPoints
                                    << ". The surface is broken; read or build it again.");
        }
      }
      convert(corners);
    }
  };
  forEach(m_Input->GetVerts(), "vertex", 1, [&](const std::vector<vtkIdType> & corners) {
    for (const vtkIdType id : corners)
    {
      add(new VertexCell<CellType>, { id });
    }
  });
  forEach(m_Input->GetLines(), "line", 2, [&](const std::vector<vtkIdType> & corners) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    {
      add(new LineCell<CellType>, { corners[i], corners[i + 1] });
    }
  });
  forEach(m_Input->GetPolys(), "polygon", 3, [&](const std::vector<vtkIdType> & corners) {
    if (corners.size() == 3)
    {
      add(new TriangleCell<CellType>, corners);
    }
    else if (corners.size() == 4)
    {
      add(new QuadrilateralCell<CellType>, corners);
    }
    else
    {
      add(new PolygonCell<CellType>(static_cast<unsigned int>(corners.size())), corners);
    }
  });
  forEach(m_Input->GetStrips(), "strip", 3, [&](const std::vector<vtkIdType> & corners) {
    for (std::size_t i = 0; i + 2 < corners.size(); ++i)
    {
      // Every other triangle of a strip is wound the other way round.
      const std::size_t odd = i % 2;
      add(new TriangleCell<CellType>, { corners[i + odd], corners[i + 1 - odd], corners[i + 2] });
    }
  });
  if (cellArray != nullptr)
  {
    mesh->SetCellData(cellValues);
  }
}

template <typename TOutputMesh>
void
VTKPolyDataToMeshFilter<TOutputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Input: " << m_Input.GetPointer() << std::endl;
  os << indent << "PointDataName: " << m_PointDataName << std::endl;
  os << indent << "CellDataName: " << m_CellDataName << std::endl;
}
} // namespace itk

#endif
