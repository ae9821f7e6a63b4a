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
#include "itkMeshSilhouetteContourSource.h"
#include "itkSilhouetteTestSurfaces.h"
#include "itkMessageOfCall.h"
#include "itkTestingMacros.h"

#include "itkTriangleCell.h"

#include <gtest/gtest.h>

namespace
{
using MeshType = itk::Mesh<double, 3>;
using SourceType = itk::MeshSilhouetteContourSource<MeshType>;
using GeometryType = itk::CephalometricGeometry;

template <typename TMesh>
typename TMesh::Pointer
ToMesh(const itk::TriangleSurface & surface)
{
  const auto mesh = TMesh::New();
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    typename TMesh::PointType point;
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] = static_cast<typename TMesh::CoordRepType>(surface.points[i][d]);
    }
    mesh->SetPoint(i, point);
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    typename TMesh::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TriangleCell<typename TMesh::CellType>);
    for (unsigned int k = 0; k < 3; ++k)
    {
      cell->SetPointId(k, surface.triangles[t][k]);
    }
    mesh->SetCell(t, cell);
  }
  return mesh;
}

GeometryType::Pointer
MakeGeometry()
{
  const auto                     geometry = GeometryType::New();
  GeometryType::PixelSpacingType spacing;
  spacing.Fill(0.25);
  geometry->SetPixelSpacing(spacing);
  GeometryType::PixelIndexType principal;
  principal[0] = 172.0;
  principal[1] = 421.0;
  geometry->SetPrincipalPoint(principal);
  return geometry;
}

int
ExerciseBasics()
{
  const auto source = SourceType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(source, MeshSilhouetteContourSource, MeshSilhouetteContourSourceBase);
  return EXIT_SUCCESS;
}
} // namespace

TEST(MeshSilhouetteContourSource, IsAnItkObject)
{
  EXPECT_EQ(ExerciseBasics(), EXIT_SUCCESS);
}

TEST(MeshSilhouetteContourSource, ProjectsItsRimOntoItsContour)
{
  const auto source = SourceType::New();
  const auto geometry = MakeGeometry();
  source->SetInput(ToMesh<MeshType>(SilhouetteTest::MakeTube(28, 6, 3.3, 60, 24, 0.15, 10)));
  source->SetGeometry(geometry);
  for (const unsigned int count : { 0u, 441u })
  {
    source->SetNumberOfPoints(count);
    source->Update();
    const auto polylines = source->GetOutput()->GetPolylines();
    ASSERT_EQ(polylines.size(), 1u);
    EXPECT_TRUE(polylines[0].closed);
    EXPECT_EQ(polylines[0].points.size(), count > 0 ? count : source->GetSilhouette().loops[0].points.size());
    ASSERT_EQ(source->GetSamples().size(), polylines[0].points.size());
    for (std::size_t i = 0; i < polylines[0].points.size(); ++i)
    {
      const auto &            sample = source->GetSamples()[i];
      GeometryType::PointType rim;
      for (unsigned int d = 0; d < 3; ++d)
      {
        rim[d] = sample.rim[d];
      }
      const auto index = geometry->ProjectPoint(rim);
      EXPECT_EQ(polylines[0].points[i][0], sample.u);
      EXPECT_NEAR(index[0], sample.u, 1e-5);
      EXPECT_NEAR(index[1], sample.v, 1e-5);
      EXPECT_NEAR(std::hypot(sample.normal[0], sample.normal[1]), 1.0, 1e-12);
      ASSERT_EQ(polylines[0].rimPoints.size(), polylines[0].points.size());
      EXPECT_EQ(polylines[0].rimPoints[i], rim);
      ASSERT_EQ(polylines[0].normals.size(), polylines[0].points.size());
      EXPECT_EQ(polylines[0].normals[i][0], sample.normal[0]);
      EXPECT_EQ(polylines[0].normals[i][1], sample.normal[1]);
    }
  }
}

TEST(MeshSilhouetteContourSource, FollowsPoseAndMesh)
{
  const auto source = SourceType::New();
  const auto geometry = MakeGeometry();
  const auto mesh = ToMesh<MeshType>(SilhouetteTest::MakeBox({ -5, -5, -5 }, { 5, 5, 5 }));
  source->SetInput(mesh);
  source->SetGeometry(geometry);
  source->Update();
  const auto first = source->GetOutput()->GetMTime();
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetMTime(), first);
  const double length = source->GetOutput()->GetLength();

  // The near face, at S - 5 mm, is the outline.
  EXPECT_NEAR(length, 4 * 10.0 * 1674.0 / 1519.0 / 0.25, 1e-4);
  GeometryType::RotationType identity;
  identity.SetIdentity();
  GeometryType::VectorType shift;
  shift.Fill(0.0);
  shift[1] = 100.0;
  geometry->SetPose(identity, shift);
  source->Update();
  EXPECT_NEAR(source->GetOutput()->GetLength(), 4 * 10.0 * 1674.0 / 1619.0 / 0.25, 1e-4);

  for (unsigned int i = 0; i < 8; ++i)
  {
    auto point = mesh->GetPoint(i);
    point[2] *= 2.0;
    mesh->SetPoint(i, point);
  }
  mesh->Modified();
  source->Update();
  EXPECT_NEAR(source->GetOutput()->GetLength(), 6 * 10.0 * 1674.0 / 1619.0 / 0.25, 1e-4);
}

TEST(MeshSilhouetteContourSource, PointsKnowTheirToothByTheLabelsOfTheMesh)
{
  // A ball whose front half is labelled UR1 and whose back half UR2, without a label below.
  const auto surface = SilhouetteTest::MakeSphere({ { 0, 0, 0 } }, 15.0, 5);
  const auto mesh = ToMesh<MeshType>(surface);
  const auto labelOf = [](double x, double z) { return z < -10.0 ? 0.0 : x > 0.0 ? 11.0 : 12.0; };
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    mesh->SetPointData(i, labelOf(surface.points[i][0], surface.points[i][2]));
  }
  const auto source = SourceType::New();
  source->SetInput(mesh);
  source->SetGeometry(MakeGeometry());
  source->SetNumberOfPoints(200);
  EXPECT_FALSE(source->GetUseLabels());
  source->Update();
  EXPECT_TRUE(source->GetOutput()->GetPolylines()[0].teeth.empty());
  EXPECT_FALSE(source->GetOutput()->GetToothCode(0).IsKnown());
  source->UseLabelsOn();
  source->Update();
  unsigned int     counts[3] = { 0, 0, 0 };
  constexpr double edge = 1.5;
  for (itk::DentalContour::PointIdentifier id = 0; id < source->GetOutput()->GetNumberOfPoints(); ++id)
  {
    const auto   rim = source->GetOutput()->GetRimPoint(id);
    const double expected = labelOf(rim[0], rim[2]);
    // Within an edge's length of where labels change either may be nearer.
    if (std::abs(rim[0]) > edge && std::abs(rim[2] + 10.0) > edge)
    {
      EXPECT_EQ(source->GetOutput()->GetToothCode(id).GetFDI(), static_cast<unsigned int>(expected)) << rim;
      ++counts[expected == 0.0 ? 0 : expected == 11.0 ? 1 : 2];
    }
  }
  EXPECT_GT(std::min({ counts[0], counts[1], counts[2] }), 20u);
  mesh->SetPointData(0, 19.0);
  mesh->Modified();
  try
  {
    source->Update();
    FAIL() << "FDI has no tooth 19";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("UseLabelsOff()"), std::string::npos) << error;
  }
}

TEST(MeshSilhouetteContourSource, GivesTheLargestPartOrAll)
{
  auto surface = SilhouetteTest::MakeBox({ 30, -5, -5 }, { 40, 5, 5 });
  SilhouetteTest::Append(surface, SilhouetteTest::MakeBox({ -15, -15, -15 }, { 15, 15, 15 }));
  const auto source = SourceType::New();
  source->SetInput(ToMesh<MeshType>(surface));
  source->SetGeometry(MakeGeometry());
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetPolylines().size(), 1u);
  const double largest = source->GetOutput()->GetLength();
  source->LargestPartOnlyOff();
  source->SetNumberOfPoints(100);
  source->Update();
  const auto polylines = source->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 2u);
  EXPECT_EQ(polylines[0].points.size(), 75u);
  EXPECT_EQ(polylines[1].points.size(), 25u);
  EXPECT_NEAR(largest, 4 * 30.0 * 1674.0 / 1509.0 / 0.25, 1e-4);
}

TEST(MeshSilhouetteContourSource, IsClosedForAPlateSeenEdgeOn)
{
  itk::TriangleSurface plate;
  plate.points = { { 0, -5, -5 }, { 0, 5, -5 }, { 0, 5, 5 }, { 0, -5, 5 } };
  plate.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  const auto source = SourceType::New();
  source->SetInput(ToMesh<MeshType>(plate));
  source->SetGeometry(MakeGeometry());
  source->Update();
  const auto polylines = source->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_TRUE(polylines[0].closed);
  EXPECT_NEAR(source->GetOutput()->GetLength(), 2 * 10.0 * 1674.0 / 1519.0 / 0.25, 1e-4);
}

TEST(MeshSilhouetteContourSource, SaysWhatIsMissing)
{
  const auto source = SourceType::New();
  const auto messageOf = [&source]() -> std::string { return itk::MessageOfCall([&] { source->Update(); }); };
  EXPECT_NE(messageOf().find("SetInput()"), std::string::npos);
  const auto mesh = ToMesh<MeshType>(SilhouetteTest::MakeBox({ -5, -5, -5 }, { 5, 5, 5 }));
  source->SetInput(mesh);
  EXPECT_NE(messageOf().find("SetGeometry()"), std::string::npos);
  source->SetGeometry(GeometryType::New());
  EXPECT_NE(messageOf().find("SetPixelSpacing()"), std::string::npos);
  const auto geometry = MakeGeometry();
  source->SetGeometry(geometry);
  source->SetNumberOfPoints(2);
  EXPECT_NE(messageOf().find("SetNumberOfPoints()"), std::string::npos);
  source->SetNumberOfPoints(0);
  EXPECT_EQ(messageOf(), "");
  GeometryType::RotationType identity;
  identity.SetIdentity();
  GeometryType::VectorType behind;
  behind.Fill(0.0);
  behind[1] = -1600.0;
  geometry->SetPose(identity, behind);
  EXPECT_NE(messageOf().find("not in front of the X-ray source"), std::string::npos);
  // An empty mesh has an empty contour.
  source->SetInput(MeshType::New());
  EXPECT_EQ(messageOf(), "");
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0u);
}

TEST(MeshSilhouetteContourSource, IsTheSameOnEveryRunAndForAnyNumberOfThreads)
{
  using FloatMeshType = itk::Mesh<float, 3>;
  const auto mesh = ToMesh<FloatMeshType>(SilhouetteTest::MakeTube(28, 6, 3.3, 60, 24, 0.15, 10));
  const auto run = [&mesh](unsigned int workUnits) {
    const auto source = itk::MeshSilhouetteContourSource<FloatMeshType>::New();
    source->SetInput(mesh);
    source->SetGeometry(MakeGeometry());
    source->SetNumberOfPoints(441);
    source->SetNumberOfWorkUnits(workUnits);
    source->Update();
    return source->GetOutput()->GetPolylines()[0].points;
  };
  const auto once = run(1);
  EXPECT_EQ(once, run(1));
  EXPECT_EQ(once, run(7));
}
