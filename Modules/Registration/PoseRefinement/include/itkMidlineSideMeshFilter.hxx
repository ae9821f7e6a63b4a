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
#ifndef itkMidlineSideMeshFilter_hxx
#define itkMidlineSideMeshFilter_hxx

#include "itkTriangleCell.h"

#include <unordered_map>

namespace itk
{
template <typename TMesh>
void
MidlineSideMeshFilter<TMesh>::GenerateData()
{
  using PointIdentifier = typename MeshType::PointIdentifier;
  using CellAutoPointer = typename MeshType::CellAutoPointer;
  const MeshType * input = this->GetInput();
  MeshType *       output = this->GetOutput();
  output->Initialize();
  // Outputs stay valid meshes where nothing is kept.
  output->SetPoints(MeshType::PointsContainer::New());
  output->SetCells(MeshType::CellsContainer::New());
  output->SetCellsAllocationMethod(MeshType::MeshClassCellsAllocationMethodEnum::CellsAllocatedDynamicallyCellByCell);
  if (input->GetPoints() == nullptr || input->GetCells() == nullptr)
  {
    return;
  }
  const double                                         sign = m_Side == SideEnum::Right ? 1.0 : -1.0;
  std::unordered_map<PointIdentifier, PointIdentifier> kept;
  PointIdentifier                                      points = 0;
  typename MeshType::CellIdentifier                    cells = 0;
  const auto *                                         pointData = input->GetPointData();
  const auto *                                         cellData = input->GetCellData();
  for (auto it = input->GetCells()->Begin(); it != input->GetCells()->End(); ++it)
  {
    const auto * cell = it.Value();
    if (cell->GetNumberOfPoints() != 3)
    {
      itkExceptionMacro("Cell " << it.Index() << " has " << cell->GetNumberOfPoints()
                                << " points; only triangles are supported. Triangulate the mesh first.");
    }
    double y = 0.0;
    for (auto id = cell->PointIdsBegin(); id != cell->PointIdsEnd(); ++id)
    {
      TransformType::InputPointType p;
      p.CastFrom(input->GetPoints()->ElementAt(*id));
      y += (m_Transform.IsNotNull() ? m_Transform->TransformPoint(p)[1] : p[1]) / 3.0;
    }
    if (sign * y >= m_Margin)
    {
      continue;
    }
    CellAutoPointer triangle;
    triangle.TakeOwnership(new TriangleCell<typename MeshType::CellType>);
    unsigned int corner = 0;
    for (auto id = cell->PointIdsBegin(); id != cell->PointIdsEnd(); ++id, ++corner)
    {
      const auto found = kept.emplace(*id, points);
      if (found.second)
      {
        output->SetPoint(points, input->GetPoints()->ElementAt(*id));
        typename MeshType::PixelType value;
        if (pointData != nullptr && pointData->GetElementIfIndexExists(*id, &value))
        {
          output->SetPointData(points, value);
        }
        ++points;
      }
      triangle->SetPointId(corner, found.first->second);
    }
    output->SetCell(cells, triangle);
    typename MeshType::CellPixelType value;
    if (cellData != nullptr && cellData->GetElementIfIndexExists(it.Index(), &value))
    {
      output->SetCellData(cells, value);
    }
    ++cells;
  }
}

template <typename TMesh>
void
MidlineSideMeshFilter<TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(Transform);
  os << indent << "Side: " << m_Side << std::endl;
  os << indent << "Margin: " << m_Margin << std::endl;
}
} // namespace itk

#endif
