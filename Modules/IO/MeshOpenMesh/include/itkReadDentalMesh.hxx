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
#ifndef itkReadDentalMesh_hxx
#define itkReadDentalMesh_hxx

#include "itkReadDentalMesh.h"

#include "itkSurfaceMeshFile.h"
#include "itkTriangleCell.h"

#include <cstddef>

namespace itk
{
template <typename TMesh>
typename TMesh::Pointer
ReadDentalMesh(const std::string & fileName, std::vector<std::string> * warnings)
{
  static_assert(TMesh::PointDimension == 3, "A surface has points in three dimensions.");
  if (fileName.empty())
  {
    itkDentalInputErrorMacro("mesh file", "", "the name is empty", "name an STL, PLY, OBJ or OFF file");
  }
  const auto meshIO = OpenMeshMeshIO::New();
  meshIO->SetFileName(fileName);
  meshIO->ReadMeshInformation();
  const SurfaceMeshFile & surface = *meshIO->GetSurface();
  if (warnings != nullptr && !surface.warning.empty())
  {
    warnings->push_back(fileName + ": " + surface.warning);
  }

  // What the stock reader makes of it, without its buffers and a time stamp for each point and cell.
  auto       mesh = TMesh::New();
  const auto points = TMesh::PointsContainer::New();
  points->Reserve(surface.GetNumberOfPoints());
  auto &     pointValues = points->CastToSTLContainer();
  const auto copyPoints = [&pointValues](const auto & from) {
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        pointValues[i][d] = static_cast<typename TMesh::CoordRepType>(from[i][d]);
      }
    }
  };
  copyPoints(surface.floatPoints);
  copyPoints(surface.doublePoints);
  mesh->SetPoints(points);

  using TriangleType = TriangleCell<typename TMesh::CellType>;
  const auto cells = TMesh::CellsContainer::New();
  cells->Reserve(surface.triangles.size());
  auto & cellValues = cells->CastToSTLContainer();
  mesh->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  mesh->SetCells(cells);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    auto * const triangle = new TriangleType;
    for (unsigned int corner = 0; corner < 3; ++corner)
    {
      triangle->SetPointId(static_cast<int>(corner), surface.triangles[i][corner]);
    }
    cellValues[i] = triangle;
  }
  return mesh;
}

template <typename TMesh>
void
WriteDentalMesh(const TMesh * mesh, const std::string & fileName)
{
  if (fileName.empty())
  {
    itkDentalInputErrorMacro("mesh file", "", "the name is empty", "name an STL, PLY, OBJ or OFF file");
  }
  const auto writer = MeshFileWriter<TMesh>::New();
  writer->SetMeshIO(OpenMeshMeshIO::New());
  writer->SetFileName(fileName);
  writer->SetFileTypeAsBINARY();
  writer->SetInput(mesh);
  writer->Write();
}

extern template Mesh<float, 3>::Pointer
ReadDentalMesh<Mesh<float, 3>>(const std::string &, std::vector<std::string> *);
extern template Mesh<double, 3>::Pointer
ReadDentalMesh<Mesh<double, 3>>(const std::string &, std::vector<std::string> *);
extern template void
WriteDentalMesh<Mesh<float, 3>>(const Mesh<float, 3> *, const std::string &);
extern template void
WriteDentalMesh<Mesh<double, 3>>(const Mesh<double, 3> *, const std::string &);
} // namespace itk

#endif
