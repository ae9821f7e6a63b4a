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
#ifndef itkSelectMeshTriangles_h
#define itkSelectMeshTriangles_h

#include "CrownRegionExport.h"
#include "itkDentalFrameEstimator.h"

#include "itkMesh.h"
#include "itkVersorRigid3DTransform.h"

#include <cstdint>
#include <vector>

namespace itk
{
/** Copies the cells with a mark (in the order of the container) and the points they use, with the data of both. Points
 * and cells are numbered anew from 0, in their old order. */
template <typename TMesh>
void
SelectMeshTriangles(const TMesh * input, const std::vector<std::uint8_t> & marks, TMesh * output)
{
  const auto * inputPoints = input->GetPoints();
  const auto * inputCells = input->GetCells();
  using PointIdentifier = typename TMesh::PointIdentifier;
  constexpr PointIdentifier    unused = static_cast<PointIdentifier>(-1);
  std::vector<PointIdentifier> position;
  for (auto it = inputPoints->Begin(); it != inputPoints->End(); ++it)
  {
    if (it.Index() >= position.size())
    {
      position.resize(it.Index() + 1, unused);
    }
  }
  std::size_t numberOfCells = 0;
  std::size_t rank = 0;
  for (auto it = inputCells->Begin(); it != inputCells->End(); ++it, ++rank)
  {
    if (marks[rank] != 0)
    {
      ++numberOfCells;
      for (auto id = it.Value()->PointIdsBegin(); id != it.Value()->PointIdsEnd(); ++id)
      {
        position[*id] = 0;
      }
    }
  }

  auto         points = TMesh::PointsContainer::New();
  const auto * inputPointData = input->GetPointData();
  auto         pointData = TMesh::PointDataContainer::New();
  for (auto it = inputPoints->Begin(); it != inputPoints->End(); ++it)
  {
    if (position[it.Index()] != unused)
    {
      const PointIdentifier id = points->Size();
      position[it.Index()] = id;
      points->InsertElement(id, it.Value());
      typename TMesh::PixelType value{};
      if (inputPointData != nullptr && inputPointData->GetElementIfIndexExists(it.Index(), &value))
      {
        pointData->InsertElement(id, value);
      }
    }
  }

  const auto * inputCellData = input->GetCellData();
  auto         cellData = TMesh::CellDataContainer::New();
  auto         cells = TMesh::CellsContainer::New();
  cells->Reserve(numberOfCells);
  typename TMesh::CellIdentifier cellId = 0;
  rank = 0;
  for (auto it = inputCells->Begin(); it != inputCells->End(); ++it, ++rank)
  {
    if (marks[rank] == 0)
    {
      continue;
    }
    typename TMesh::CellAutoPointer copy;
    it.Value()->MakeCopy(copy);
    for (auto id = copy->PointIdsBegin(); id != copy->PointIdsEnd(); ++id)
    {
      *id = position[*id];
    }
    cells->SetElement(cellId, copy.ReleaseOwnership());
    typename TMesh::CellPixelType value{};
    if (inputCellData != nullptr && inputCellData->GetElementIfIndexExists(it.Index(), &value))
    {
      cellData->InsertElement(cellId, value);
    }
    ++cellId;
  }
  output->SetPoints(points);
  output->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  output->SetCells(cells);
  if (pointData->Size() > 0)
  {
    output->SetPointData(pointData);
  }
  if (cellData->Size() > 0)
  {
    output->SetCellData(cellData);
  }
}

/** Axes and origin of a transform mesh -> UMDA. */
CrownRegion_EXPORT DentalJawFrame
JawFrameFromTransform(const VersorRigid3DTransform<double> & transform);
} // namespace itk

#endif
