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
#include "itkTriangleSurface.h"

#include "itkMakeTriangleSurface.h"
#include "itkMesh.h"
#include "itkQuadrilateralCell.h"
#include "itkTriangleCell.h"

#include <gtest/gtest.h>

namespace
{
itk::TriangleSurface
MakeUnitSquare()
{
  itk::TriangleSurface square;
  square.points = { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  square.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  return square;
}
} // namespace

TEST(TriangleSurface, UnitSquareHasUnitAreaSharedByItsCorners)
{
  const itk::TriangleSurface square = MakeUnitSquare();
  EXPECT_DOUBLE_EQ(square.Area(), 1.0);
  const std::vector<double> areas = square.VertexAreas();
  EXPECT_DOUBLE_EQ(areas[0], 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(areas[1], 1.0 / 6.0);
  for (const auto & normal : square.VertexNormals())
  {
    EXPECT_EQ(normal, (itk::TriangleSurface::PointType{ 0.0, 0.0, 1.0 }));
  }
}

TEST(TriangleSurface, CentroidDoesNotMoveWithTheDensityOfPoints)
{
  itk::TriangleSurface square = MakeUnitSquare();
  // Split the first triangle at its centroid: more points there, the same surface.
  square.points.push_back({ 2.0 / 3.0, 1.0 / 3.0, 1.0 });
  square.triangles = { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 0, 4 }, { 0, 2, 3 } };
  const auto centroid = square.AreaCentroid();
  EXPECT_NEAR(centroid[0], 0.5, 1e-15);
  EXPECT_NEAR(centroid[1], 0.5, 1e-15);
  EXPECT_NEAR(centroid[2], 1.0, 1e-15);
}

TEST(TriangleSurface, EmptyAndDegenerateAreHarmless)
{
  itk::TriangleSurface empty;
  EXPECT_EQ(empty.Area(), 0.0);
  EXPECT_EQ(empty.AreaCentroid(), (itk::TriangleSurface::PointType{ 0.0, 0.0, 0.0 }));
  itk::TriangleSurface needle;
  needle.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  needle.triangles = { { 0, 1, 2 } };
  EXPECT_EQ(needle.AreaCentroid(), (itk::TriangleSurface::PointType{ 1.0, 0.0, 0.0 }));
  EXPECT_EQ(needle.VertexNormals()[0], (itk::TriangleSurface::PointType{ 0.0, 0.0, 0.0 }));
}

TEST(MakeTriangleSurface, KeepsPointsAndTrianglesAndRefusesOtherCells)
{
  using MeshType = itk::Mesh<float, 3>;
  auto                mesh = MeshType::New();
  MeshType::PointType p;
  for (unsigned int i = 0; i < 4; ++i)
  {
    p[0] = static_cast<float>(i % 2);
    p[1] = static_cast<float>(i / 2);
    p[2] = 0.0f;
    mesh->SetPoint(i, p);
  }
  MeshType::CellAutoPointer cell;
  cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
  const MeshType::PointIdentifier ids[] = { 0, 1, 3, 2 };
  cell->SetPointIds(ids);
  mesh->SetCell(0, cell);
  const itk::TriangleSurface surface = itk::MakeTriangleSurface(mesh.GetPointer());
  ASSERT_EQ(surface.points.size(), 4u);
  ASSERT_EQ(surface.triangles.size(), 1u);
  EXPECT_EQ(surface.triangles[0], (itk::TriangleSurface::TriangleType{ 0, 1, 3 }));

  cell.TakeOwnership(new itk::QuadrilateralCell<MeshType::CellType>);
  cell->SetPointIds(ids);
  mesh->SetCell(1, cell);
  EXPECT_THROW(itk::MakeTriangleSurface(mesh.GetPointer()), itk::ExceptionObject);
}
