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
#include "itkVTKPolyDataToMeshFilter.h"
#include "itkMessageOfCall.h"

#include "itkMesh.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include "gtest/gtest.h"

#include <string>
#include <vector>

namespace
{
using MeshType = itk::Mesh<float, 3>;
using FilterType = itk::VTKPolyDataToMeshFilter<MeshType>;

vtkSmartPointer<vtkPolyData>
MakePoints(vtkIdType count)
{
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(static_cast<double>(i), 2.0 * static_cast<double>(i), -1.0);
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(points);
  return polyData;
}

vtkSmartPointer<vtkCellArray>
MakeCells(const std::vector<std::vector<vtkIdType>> & list)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto & corners : list)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
  return cells;
}

std::string
GetMessage(FilterType * filter)
{
  return itk::MessageOfCall([&] { filter->Update(); });
}

std::vector<itk::IdentifierType>
GetCorners(const MeshType & mesh, itk::IdentifierType cell)
{
  MeshType::CellAutoPointer pointer;
  mesh.GetCell(cell, pointer);
  return { pointer->PointIdsBegin(), pointer->PointIdsEnd() };
}
} // namespace

TEST(VTKPolyDataToMeshFilter, TakesPolylinesAndStripsApartWithTheirData)
{
  const auto polyData = MakePoints(6);
  polyData->SetLines(MakeCells({ { 0, 1, 2 } }));
  polyData->SetStrips(MakeCells({ { 0, 1, 2, 3, 4 } }));
  vtkNew<vtkDoubleArray> values;
  values->SetName("number");
  values->InsertNextValue(5.0);
  values->InsertNextValue(7.0);
  polyData->GetCellData()->AddArray(values);
  auto filter = FilterType::New();
  filter->SetInput(polyData);
  filter->SetCellDataName("number");
  filter->Update();
  const MeshType & mesh = *filter->GetOutput();
  ASSERT_EQ(mesh.GetNumberOfCells(), 5u);
  using Corners = std::vector<itk::IdentifierType>;
  EXPECT_EQ(GetCorners(mesh, 0), (Corners{ 0, 1 }));
  EXPECT_EQ(GetCorners(mesh, 1), (Corners{ 1, 2 }));
  // As vtkTriangleStrip winds them.
  EXPECT_EQ(GetCorners(mesh, 2), (Corners{ 0, 1, 2 }));
  EXPECT_EQ(GetCorners(mesh, 3), (Corners{ 2, 1, 3 }));
  EXPECT_EQ(GetCorners(mesh, 4), (Corners{ 2, 3, 4 }));
  for (itk::IdentifierType cell = 0; cell < 5; ++cell)
  {
    float value = 0.0F;
    ASSERT_TRUE(filter->GetOutput()->GetCellData(cell, &value));
    EXPECT_EQ(value, cell < 2 ? 5.0F : 7.0F);
  }
}

TEST(VTKPolyDataToMeshFilter, TakesTheNamedArrayElseTheActiveOneElseNone)
{
  const auto             polyData = MakePoints(2);
  vtkNew<vtkDoubleArray> active;
  active->SetName("active");
  vtkNew<vtkDoubleArray> other;
  other->SetName("other");
  for (double value : { 1.0, 2.0 })
  {
    active->InsertNextValue(value);
    other->InsertNextValue(10.0 * value);
  }
  auto filter = FilterType::New();
  filter->SetInput(polyData);
  filter->Update();
  EXPECT_TRUE(filter->GetOutput()->GetPointData() == nullptr || filter->GetOutput()->GetPointData()->Size() == 0);
  polyData->GetPointData()->SetScalars(active);
  polyData->GetPointData()->AddArray(other);
  float value = 0.0F;
  filter->Update();
  ASSERT_TRUE(filter->GetOutput()->GetPointData(1, &value));
  EXPECT_EQ(value, 2.0F);
  filter->SetPointDataName("other");
  filter->Update();
  ASSERT_TRUE(filter->GetOutput()->GetPointData(1, &value));
  EXPECT_EQ(value, 20.0F);
}

TEST(VTKPolyDataToMeshFilter, SeesThatItsInputHasChanged)
{
  const auto polyData = MakePoints(3);
  auto       filter = FilterType::New();
  filter->SetInput(polyData);
  unsigned int runs = 0;
  filter->AddObserver(itk::StartEvent(), [&runs](const itk::EventObject &) { ++runs; });
  filter->Update();
  filter->Update();
  EXPECT_EQ(runs, 1u);
  polyData->SetPolys(MakeCells({ { 0, 1, 2 } }));
  filter->Update();
  EXPECT_EQ(runs, 2u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 1u);
}

TEST(VTKPolyDataToMeshFilter, NamesWhatIsWrong)
{
  EXPECT_NE(GetMessage(FilterType::New()).find("SetInput()"), std::string::npos);

  auto       missing = FilterType::New();
  const auto three = MakePoints(3);
  three->SetVerts(MakeCells({ { 0 } }));
  three->SetPolys(MakeCells({ { 0, 1, 9 } }));
  missing->SetInput(three);
  // Cells are counted as vtkPolyData does.
  EXPECT_NE(GetMessage(missing).find("Cell 1 of the vtkPolyData names point 9 of 3"), std::string::npos)
    << GetMessage(missing);

  auto       thin = FilterType::New();
  const auto flat = MakePoints(3);
  flat->SetPolys(MakeCells({ { 0, 1 } }));
  thin->SetInput(flat);
  EXPECT_NE(GetMessage(thin).find("a polygon of 2 points"), std::string::npos) << GetMessage(thin);

  auto absent = FilterType::New();
  absent->SetInput(MakePoints(3));
  absent->SetPointDataName("height");
  EXPECT_NE(GetMessage(absent).find("no array of numbers \"height\""), std::string::npos) << GetMessage(absent);

  auto                   vectors = FilterType::New();
  const auto             polyData = MakePoints(1);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("normals");
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(0.0, 0.0, 1.0);
  polyData->GetPointData()->AddArray(normals);
  vectors->SetInput(polyData);
  vectors->SetPointDataName("normals");
  EXPECT_NE(GetMessage(vectors).find("3 components"), std::string::npos) << GetMessage(vectors);

  auto flatMesh = itk::VTKPolyDataToMeshFilter<itk::Mesh<float, 2>>::New();
  flatMesh->SetInput(MakePoints(1));
  EXPECT_THROW(flatMesh->Update(), itk::ExceptionObject);
}
