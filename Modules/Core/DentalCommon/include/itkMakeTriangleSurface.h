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
#ifndef itkMakeTriangleSurface_h
#define itkMakeTriangleSurface_h

#include "itkTriangleSurface.h"

#include "itkCellInterface.h"
#include "itkMacro.h"

namespace itk
{
/** Flattens the triangles of an itk::Mesh. Cells that are not triangles are an error that names the cell: silently
 * dropped faces would be holes in a silhouette. Call it once per MTime, not in a loop. */
template <typename TMesh>
TriangleSurface
MakeTriangleSurface(const TMesh * mesh)
{
  static_assert(TMesh::PointDimension == 3, "A surface has points in three dimensions.");
  TriangleSurface surface;
  if (mesh == nullptr || mesh->GetPoints() == nullptr)
  {
    return surface;
  }
  // Ids may have holes: map them to positions.
  const auto * points = mesh->GetPoints();
  surface.points.reserve(points->Size());
  std::vector<std::uint32_t> position;
  for (auto it = points->Begin(); it != points->End(); ++it)
  {
    const std::size_t id = it.Index();
    if (id >= position.size())
    {
      position.resize(id + 1, 0);
    }
    position[id] = static_cast<std::uint32_t>(surface.points.size());
    const auto & p = it.Value();
    surface.points.push_back({ static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]) });
  }
  const auto * cells = mesh->GetCells();
  if (cells == nullptr)
  {
    return surface;
  }
  surface.triangles.reserve(cells->Size());
  for (auto it = cells->Begin(); it != cells->End(); ++it)
  {
    const auto * cell = it.Value();
    if (cell->GetNumberOfPoints() != 3)
    {
      itkGenericExceptionMacro("Cell " << it.Index() << " of the mesh has " << cell->GetNumberOfPoints()
                                       << " points; only triangles are supported. Triangulate the mesh first.");
    }
    const auto *                  ids = cell->GetPointIds();
    TriangleSurface::TriangleType triangle;
    for (unsigned int corner = 0; corner < 3; ++corner)
    {
      if (static_cast<std::size_t>(ids[corner]) >= position.size())
      {
        itkGenericExceptionMacro("Cell " << it.Index() << " of the mesh names point " << ids[corner] << " of "
                                         << surface.points.size() << ". The mesh is broken; read or build it again.");
      }
      triangle[corner] = position[ids[corner]];
    }
    surface.triangles.push_back(triangle);
  }
  return surface;
}
} // namespace itk

#endif
