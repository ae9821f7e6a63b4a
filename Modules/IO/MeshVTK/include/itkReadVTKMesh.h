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
#ifndef itkReadVTKMesh_h
#define itkReadVTKMesh_h

#include "MeshVTKExport.h"
#include "itkVTKSurfaceFile.h"

#include "itkMesh.h"
#include "itkTriangleCell.h"

#include <string>

namespace itk
{
/** Reads a VTK surface (.vtk, .vtp) as a triangle mesh in the file's unit, points in the file's order, without data:
 * ToothLabelFileReader reads the labels, and turns them into FDI numbers. Throws a DentalInputError. */
template <typename TMesh>
typename TMesh::Pointer
ReadVTKMesh(const std::string & fileName)
{
  static_assert(TMesh::PointDimension == 3, "A surface has points in three dimensions.");
  const VTKSurfaceFile surface = ReadVTKSurfaceFile(fileName);
  auto                 points = TMesh::PointsContainer::New();
  points->Reserve(surface.points.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    typename TMesh::PointType point;
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] = static_cast<typename TMesh::CoordRepType>(surface.points[i][d]);
    }
    points->SetElement(i, point);
  }
  using TriangleType = TriangleCell<typename TMesh::CellType>;
  auto cells = TMesh::CellsContainer::New();
  cells->Reserve(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    auto * cell = new TriangleType;
    for (unsigned int k = 0; k < 3; ++k)
    {
      cell->SetPointId(static_cast<int>(k), surface.triangles[t][k]);
    }
    cells->SetElement(t, cell);
  }
  auto mesh = TMesh::New();
  mesh->SetPoints(points);
  mesh->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  mesh->SetCells(cells);
  return mesh;
}

extern template Mesh<float, 3>::Pointer
ReadVTKMesh<Mesh<float, 3>>(const std::string &);
extern template Mesh<double, 3>::Pointer
ReadVTKMesh<Mesh<double, 3>>(const std::string &);
} // namespace itk

#endif
