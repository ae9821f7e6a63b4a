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
#include "itkMeshToVTKPolyDataFilter.h"
#include "itkMessageOfCall.h"

#include "itkVTKPolyDataToMeshFilter.h"

#include "itkDefaultDynamicMeshTraits.h"
#include "itkDentalContour.h"
#include "itkLineCell.h"
#include "itkMesh.h"
#include "itkPolygonCell.h"
#include "itkQuadrilateralCell.h"
#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"
#include "itkVertexCell.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include "gtest/gtest.h"

#include <string>
#include <vector>

namespace
{
using MeshType = itk::Mesh<float, 3>;
using CellType = MeshType::CellType;

template <typename TMesh>
void
AddPoint(TMesh & mesh, itk::IdentifierType id, double x, double y, double z)
{
  typename TMesh::PointType point;
  point[0] = static_cast<typename TMesh::CoordRepType>(x);
  point[1] = static_cast<typename TMesh::CoordRepType>(y);
  point[2] = static_cast<typename TMesh::CoordRepType>(z);
  mesh.SetPoint(id, point);
}

template <typename TMesh>
void
AddCell(TMesh & mesh, typename TMesh::CellType * made, const std::vector<itk::IdentifierType> & corners)
{
  typename TMesh::CellAutoPointer cell;
  cell.TakeOwnership(made);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    cell->SetPointId(static_cast<int>(i), corners[i]);
  }
  mesh.SetCell(mesh.GetNumberOfCells(), cell);
}

/** Every kind of cell, not in VTK's order, with data at points and cells. */
template <typename TMesh>
typename TMesh::Pointer
MakeMixed()
{
  using OwnCell = typename TMesh::CellType;
  auto mesh = TMesh::New();
  for (unsigned int i = 0; i < 7; ++i)
  {
    AddPoint(*mesh, i, 0.1 * i, i * i, 7.0 - i);
  }
  AddCell(*mesh, new itk::TriangleCell<OwnCell>, { 0, 1, 2 });
  AddCell(*mesh, new itk::LineCell<OwnCell>, { 3, 4 });
  AddCell(*mesh, new itk::VertexCell<OwnCell>, { 5 });
  AddCell(*mesh, new itk::QuadrilateralCell<OwnCell>, { 0, 1, 4, 3 });
  AddCell(*mesh, new itk::PolygonCell<OwnCell>, { 0, 2, 4, 6, 5 });
  return mesh;
}

template <typename TMesh>
vtkSmartPointer<vtkPolyData>
Convert(const TMesh * mesh)
{
  auto filter = itk::MeshToVTKPolyDataFilter<TMesh>::New();
  filter->SetInput(mesh);
  filter->Update();
  return filter->GetOutput();
}

template <typename TMesh>
typename TMesh::Pointer
ConvertBack(vtkPolyData * polyData)
{
  auto filter = itk::VTKPolyDataToMeshFilter<TMesh>::New();
  filter->SetInput(polyData);
  filter->Update();
  typename TMesh::Pointer mesh = filter->GetOutput();
  mesh->DisconnectPipeline();
  return mesh;
}

/** Kind and corners of every cell. */
template <typename TMesh>
std::vector<std::vector<itk::IdentifierType>>
ListCells(const TMesh & mesh)
{
  std::vector<std::vector<itk::IdentifierType>> list;
  for (auto it = mesh.GetCells()->Begin(); it != mesh.GetCells()->End(); ++it)
  {
    list.emplace_back(it.Value()->PointIdsBegin(), it.Value()->PointIdsEnd());
    list.back().insert(list.back().begin(), static_cast<itk::IdentifierType>(it.Value()->GetType()));
  }
  return list;
}
} // namespace

TEST(MeshToVTKPolyDataFilter, KeepsPointsToTheBitAndTheirType)
{
  const auto single = Convert(MakeMixed<MeshType>().GetPointer());
  EXPECT_EQ(single->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(single->GetPoint(3)[0], static_cast<double>(static_cast<float>(0.1 * 3)));
  using DoubleMesh = itk::Mesh<double, 3, itk::DefaultStaticMeshTraits<double, 3, 3, double>>;
  const auto twice = Convert(MakeMixed<DoubleMesh>().GetPointer());
  EXPECT_EQ(twice->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(twice->GetPoint(3)[0], 0.1 * 3);
}

TEST(MeshToVTKPolyDataFilter, SortsCellsByKindAndTheirDataWithThem)
{
  const auto mesh = MakeMixed<MeshType>();
  for (unsigned int i = 0; i < 5; ++i)
  {
    mesh->SetCellData(i, static_cast<float>(10 * i));
  }
  for (unsigned int i = 0; i < 7; ++i)
  {
    mesh->SetPointData(i, static_cast<float>(i) + 0.5F);
  }
  auto filter = itk::MeshToVTKPolyDataFilter<MeshType>::New();
  filter->SetInput(mesh);
  filter->SetPointDataName("height");
  filter->Update();
  vtkPolyData * const polyData = filter->GetOutput();
  EXPECT_EQ(polyData->GetNumberOfVerts(), 1);
  EXPECT_EQ(polyData->GetNumberOfLines(), 1);
  EXPECT_EQ(polyData->GetNumberOfPolys(), 3);
  // Vertex, line, triangle, quadrilateral, polygon.
  const double expected[] = { 20.0, 10.0, 0.0, 30.0, 40.0 };
  for (vtkIdType i = 0; i < 5; ++i)
  {
    EXPECT_EQ(polyData->GetCellData()->GetArray("CellData")->GetComponent(i, 0), expected[i]);
  }
  ASSERT_NE(polyData->GetPointData()->GetArray("height"), nullptr);
  EXPECT_EQ(polyData->GetPointData()->GetScalars()->GetComponent(6, 0), 6.5);
}

TEST(MeshToVTKPolyDataFilter, ComesBackAsItWas)
{
  // Already in VTK's order: then cells and data come back in theirs.
  auto mesh = MeshType::New();
  for (unsigned int i = 0; i < 7; ++i)
  {
    AddPoint(*mesh, i, 0.1 * i, i * i, 7.0 - i);
    mesh->SetPointData(i, static_cast<float>(i) + 0.25F);
  }
  AddCell(*mesh, new itk::VertexCell<CellType>, { 5 });
  AddCell(*mesh, new itk::LineCell<CellType>, { 3, 4 });
  AddCell(*mesh, new itk::LineCell<CellType>, { 4, 0 });
  AddCell(*mesh, new itk::TriangleCell<CellType>, { 0, 1, 2 });
  AddCell(*mesh, new itk::QuadrilateralCell<CellType>, { 0, 1, 4, 3 });
  AddCell(*mesh, new itk::PolygonCell<CellType>, { 0, 2, 4, 6, 5 });
  for (unsigned int i = 0; i < 6; ++i)
  {
    mesh->SetCellData(i, static_cast<float>(i * i));
  }
  const auto back = ConvertBack<MeshType>(Convert(mesh.GetPointer()));
  ASSERT_EQ(back->GetNumberOfPoints(), 7u);
  EXPECT_EQ(ListCells(*back), ListCells(*mesh));
  for (unsigned int i = 0; i < 7; ++i)
  {
    float value = 0.0F;
    EXPECT_EQ(back->GetPoint(i), mesh->GetPoint(i));
    ASSERT_TRUE(back->GetPointData(i, &value));
    EXPECT_EQ(value, static_cast<float>(i) + 0.25F);
  }
  for (unsigned int i = 0; i < 6; ++i)
  {
    float value = 0.0F;
    ASSERT_TRUE(back->GetCellData(i, &value));
    EXPECT_EQ(value, static_cast<float>(i * i));
  }
}

TEST(MeshToVTKPolyDataFilter, TakesAnEmptyMesh)
{
  const auto empty = MeshType::New();
  const auto polyData = Convert(empty.GetPointer());
  EXPECT_EQ(polyData->GetNumberOfPoints(), 0);
  EXPECT_EQ(polyData->GetNumberOfCells(), 0);
  EXPECT_EQ(polyData->GetPointData()->GetNumberOfArrays(), 0);
  const auto back = ConvertBack<MeshType>(polyData);
  EXPECT_EQ(back->GetNumberOfPoints(), 0u);
  EXPECT_EQ(back->GetNumberOfCells(), 0u);
}

TEST(MeshToVTKPolyDataFilter, KeepsVectorsAndGivesNoughtWhereThereIsNone)
{
  using VectorMesh = itk::Mesh<itk::Vector<double, 3>, 3>;
  auto mesh = MakeMixed<VectorMesh>();
  // Of seven points one has a value.
  itk::Vector<double, 3> value;
  value[0] = 1.0;
  value[1] = 2.0;
  value[2] = 3.0;
  mesh->SetPointData(2, value);
  const auto     polyData = Convert(mesh.GetPointer());
  vtkDataArray * array = polyData->GetPointData()->GetArray("PointData");
  ASSERT_NE(array, nullptr);
  ASSERT_EQ(array->GetNumberOfComponents(), 3);
  EXPECT_EQ(array->GetNumberOfTuples(), 7);
  EXPECT_EQ(array->GetComponent(2, 2), 3.0);
  EXPECT_EQ(array->GetComponent(1, 1), 0.0);
  const auto             back = ConvertBack<VectorMesh>(polyData);
  itk::Vector<double, 3> returned;
  ASSERT_TRUE(back->GetPointData(2, &returned));
  EXPECT_EQ(returned, value);
}

TEST(MeshToVTKPolyDataFilter, ClosesGapsInTheIds)
{
  // A container with holes; that of the default traits is a vector, where all ids below the largest are there.
  using MapMesh = itk::Mesh<float, 3, itk::DefaultDynamicMeshTraits<float, 3, 3>>;
  auto sparse = MapMesh::New();
  AddPoint(*sparse, 3, 1.0, 0.0, 0.0);
  AddPoint(*sparse, 10, 2.0, 0.0, 0.0);
  AddPoint(*sparse, 700, 3.0, 0.0, 0.0);
  AddCell(*sparse, new itk::TriangleCell<MapMesh::CellType>, { 700, 3, 10 });
  const auto polyData = Convert(sparse.GetPointer());
  ASSERT_EQ(polyData->GetNumberOfPoints(), 3);
  vtkIdType         count = 0;
  const vtkIdType * corners = nullptr;
  polyData->GetPolys()->GetCellAtId(0, count, corners);
  ASSERT_EQ(count, 3);
  EXPECT_EQ(corners[0], 2);
  EXPECT_EQ(corners[1], 0);
  EXPECT_EQ(corners[2], 1);
}

TEST(MeshToVTKPolyDataFilter, GivesATracingWithItsTeethAtZ0)
{
  auto                                       tracing = itk::DentalContour::New();
  std::vector<itk::DentalContour::PointType> points(3);
  for (unsigned int i = 0; i < 3; ++i)
  {
    points[i][0] = 10.0 + i;
    points[i][1] = 20.5 * i;
  }
  tracing->AddPolyline(points, itk::ToothCode(16), true);
  const auto polyData = Convert<itk::DentalContour>(tracing);
  ASSERT_EQ(polyData->GetNumberOfPoints(), 3);
  EXPECT_EQ(polyData->GetNumberOfLines(), 3);
  EXPECT_EQ(polyData->GetPoint(2)[1], 41.0);
  EXPECT_EQ(polyData->GetPoint(2)[2], 0.0);
  EXPECT_EQ(polyData->GetPointData()->GetArray("PointData")->GetComponent(1, 0), 16.0);
}

TEST(MeshToVTKPolyDataFilter, NamesACellThatIsNoneOfASurface)
{
  auto solid = MakeMixed<MeshType>();
  AddCell(*solid, new itk::TetrahedronCell<CellType>, { 0, 1, 2, 3 });
  auto missing = MakeMixed<MeshType>();
  AddCell(*missing, new itk::TriangleCell<CellType>, { 0, 1, 99 });
  auto flat = MakeMixed<MeshType>();
  AddCell(*flat, new itk::PolygonCell<CellType>, { 0, 1 });
  const auto message = [](const MeshType * mesh) { return itk::MessageOfCall([&] { Convert(mesh); }); };
  EXPECT_NE(message(solid).find("Cell 5 of the mesh is a TetrahedronCell"), std::string::npos) << message(solid);
  EXPECT_NE(message(missing).find("names point 99"), std::string::npos) << message(missing);
  EXPECT_NE(message(flat).find("a polygon of 2 points"), std::string::npos) << message(flat);
  EXPECT_THROW(Convert<MeshType>(nullptr), itk::ExceptionObject);
}

TEST(MeshToVTKPolyDataFilter, RunsOnceAndLeavesWhatItGaveBefore)
{
  const auto mesh = MakeMixed<MeshType>();
  auto       filter = itk::MeshToVTKPolyDataFilter<MeshType>::New();
  filter->SetInput(mesh);
  filter->Update();
  const vtkSmartPointer<vtkPolyData> first = filter->GetOutput();
  filter->Update();
  EXPECT_EQ(filter->GetOutput(), first.GetPointer());
  AddPoint(*mesh, 7, 1.0, 1.0, 1.0);
  mesh->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 8);
  EXPECT_EQ(first->GetNumberOfPoints(), 7);
}
