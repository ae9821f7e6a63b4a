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
#include "itkOpenSilhouetteContourSource.h"
#include "itkSilhouetteTestSurfaces.h"
#include "itkMessageOfCall.h"
#include "itkTestingMacros.h"

#include "itkTriangleCell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
using MeshType = itk::Mesh<double, 3>;
using SourceType = itk::OpenSilhouetteContourSource<MeshType>;
using GeometryType = itk::CephalometricGeometry;
using DentalContour = itk::DentalContour;
using TransformType = SourceType::TransformType;

constexpr double Degree = 3.14159265358979323846 / 180.0;

MeshType::Pointer
ToMesh(const itk::TriangleSurface & surface)
{
  auto mesh = MeshType::New();
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    mesh->SetPoint(i, MeshType::PointType(surface.points[i].data()));
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    MeshType::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
    for (unsigned int k = 0; k < 3; ++k)
    {
      cell->SetPointId(k, surface.triangles[t][k]);
    }
    mesh->SetCell(t, cell);
  }
  return mesh;
}

/** Pitch about y as in the robust registration: positive turns z forward. */
GeometryType::RotationType
Pitch(double angle)
{
  GeometryType::RotationType rotation;
  rotation.SetIdentity();
  rotation(0, 0) = rotation(2, 2) = std::cos(angle);
  rotation(0, 2) = std::sin(angle);
  rotation(2, 0) = -std::sin(angle);
  return rotation;
}

GeometryType::Pointer
MakeGeometry(double pitch = 0.0, double spacingU = 0.25, double spacingV = 0.25)
{
  auto                           geometry = GeometryType::New();
  GeometryType::PixelSpacingType spacing;
  spacing[0] = spacingU;
  spacing[1] = spacingV;
  geometry->SetPixelSpacing(spacing);
  GeometryType::PixelIndexType principal;
  principal[0] = 300.0;
  principal[1] = 400.0;
  geometry->SetPrincipalPoint(principal);
  GeometryType::VectorType zero;
  zero.Fill(0.0);
  geometry->SetPose(Pitch(pitch), zero);
  return geometry;
}

SourceType::Pointer
MakeSource(const MeshType * mesh, GeometryType * geometry)
{
  auto source = SourceType::New();
  source->SetInput(mesh);
  source->SetGeometry(geometry);
  return source;
}

MeshType::Pointer
MakeBall()
{
  return ToMesh(SilhouetteTest::MakeSphere({ { 0, 0, 0 } }, 15.0, 5));
}

/** Directions of a ball's outline from its centre in the detector plane, degrees from anterior (image facing right)
 * toward inferior. */
std::vector<double>
Directions(SourceType * source, double facing, double spacingU, double spacingV)
{
  std::vector<double> angles;
  for (const auto & polyline : source->GetOutput()->GetPolylines())
  {
    for (const auto & point : polyline.points)
    {
      angles.push_back(std::atan2((point[1] - 400.0) * spacingV, facing * (point[0] - 300.0) * spacingU) / Degree);
    }
  }
  return angles;
}

std::string
ErrorOf(SourceType * source)
{
  return itk::MessageOfCall([&] { source->Update(); });
}

int
ExerciseBasics()
{
  const auto source = SourceType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(source, OpenSilhouetteContourSource, MeshSilhouetteContourSourceBase);
  return EXIT_SUCCESS;
}
} // namespace

TEST(OpenSilhouetteContourSource, IsAnItkObject)
{
  EXPECT_EQ(ExerciseBasics(), EXIT_SUCCESS);
}

TEST(OpenSilhouetteContourSource, KeepsTheOcclusalAndAnteriorArcOfABall)
{
  // The rule: occlusal component above 0.2, or above -0.5 where anterior: from 30 degrees apical of anterior round to
  // asin(0.2) short of posterior.
  const double anterior = -30.0;
  const double posterior = 180.0 - std::asin(0.2) / Degree;
  const auto   ball = MakeBall();
  for (const bool upper : { true, false })
  {
    for (const double facing : { 1.0, -1.0 })
    {
      for (const double pitch : { 0.0, 20.0, -35.0 })
      {
        const double spacingV = pitch > 0.0 ? 0.2 : 0.25;
        auto         geometry = MakeGeometry(pitch * Degree, 0.25, spacingV);
        geometry->SetFacing(facing > 0.0 ? GeometryType::FacingEnum::Right : GeometryType::FacingEnum::Left);
        auto source = MakeSource(ball, geometry);
        source->SetJaw(upper ? SourceType::JawEnum::Upper : SourceType::JawEnum::Lower);
        source->Update();
        const auto polylines = source->GetOutput()->GetPolylines();
        ASSERT_EQ(polylines.size(), 1u);
        EXPECT_FALSE(polylines[0].closed);
        std::vector<double> angles = Directions(source, facing, 0.25, spacingV);
        for (double & angle : angles)
        {
          // Back to the dental frame, where the pitch turned anterior toward inferior; lower jaw: mirrored.
          angle -= pitch;
          angle = std::remainder(upper ? angle - 69.0 : -angle - 69.0, 360.0) + 69.0;
        }
        const auto range = std::minmax_element(angles.begin(), angles.end());
        // Facets of 2 degrees, and tangents over 3 pixels: a degree.
        EXPECT_NEAR(*range.first, anterior, 1.5) << "upper " << upper << " facing " << facing << " pitch " << pitch;
        EXPECT_NEAR(*range.second, posterior, 1.5) << "upper " << upper << " facing " << facing << " pitch " << pitch;
      }
    }
  }
}

TEST(OpenSilhouetteContourSource, LeavesTheHeadsPitchToTheFrame)
{
  // The same ball with a bump in scanner coordinates: frame and pose together say where it is.
  itk::TriangleSurface dental = SilhouetteTest::MakeSphere({ { 0, 0, 0 } }, 15.0, 4);
  SilhouetteTest::Append(dental, SilhouetteTest::MakeBox({ { 10, -4, -20 } }, { { 18, 4, -3 } }));
  itk::ReproducibleRandom   random(5);
  const auto                turn = SilhouetteTest::RandomRotation(random);
  itk::TriangleSurface      scanner = dental;
  auto                      frame = TransformType::New();
  TransformType::MatrixType matrix;
  for (unsigned int r = 0; r < 3; ++r)
  {
    for (unsigned int c = 0; c < 3; ++c)
    {
      matrix(r, c) = turn[r][c];
    }
  }
  frame->SetMatrix(matrix);
  for (std::size_t i = 0; i < dental.points.size(); ++i)
  {
    for (unsigned int c = 0; c < 3; ++c)
    {
      scanner.points[i][c] =
        turn[0][c] * dental.points[i][0] + turn[1][c] * dental.points[i][1] + turn[2][c] * dental.points[i][2];
    }
  }
  auto here = MakeSource(ToMesh(dental), MakeGeometry(0.3));
  here->Update();
  auto                     geometry = MakeGeometry();
  GeometryType::VectorType zero;
  zero.Fill(0.0);
  geometry->SetPose(Pitch(0.3) * GeometryType::RotationType(matrix.GetVnlMatrix()), zero);
  auto there = MakeSource(ToMesh(scanner), geometry);
  there->SetFrameTransform(frame);
  there->Update();
  const auto a = here->GetOutput()->GetPolylines();
  const auto b = there->GetOutput()->GetPolylines();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t l = 0; l < a.size(); ++l)
  {
    ASSERT_EQ(a[l].points.size(), b[l].points.size());
    for (std::size_t i = 0; i < a[l].points.size(); ++i)
    {
      EXPECT_LT(a[l].points[i].EuclideanDistanceTo(b[l].points[i]), 1e-3);
    }
  }
}

TEST(OpenSilhouetteContourSource, ProjectsItsRimOntoItsContourWithNormalsAcross)
{
  const auto geometry = MakeGeometry(0.1, 0.3, 0.2);
  const auto source = MakeSource(MakeBall(), geometry);
  source->SetSpacing(0.25);
  source->Update();
  const auto polylines = source->GetOutput()->GetPolylines();
  ASSERT_EQ(polylines.size(), 1u);
  const auto & points = polylines[0].points;
  ASSERT_EQ(source->GetRimPoints().size(), points.size());
  ASSERT_EQ(source->GetNormals().size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto index = geometry->ProjectPoint(GeometryType::PointType(source->GetRimPoints()[i].data()));
    EXPECT_NEAR(index[0], points[i][0], 1e-5);
    EXPECT_NEAR(index[1], points[i][1], 1e-5);
    const auto & normal = source->GetNormals()[i];
    EXPECT_NEAR(std::hypot(normal[0], normal[1]), 1.0, 1e-12);
    // The output's points know it themselves.
    ASSERT_EQ(polylines[0].rimPoints.size(), points.size());
    ASSERT_EQ(polylines[0].normals.size(), points.size());
    EXPECT_EQ(polylines[0].rimPoints[i], GeometryType::PointType(source->GetRimPoints()[i].data()));
    EXPECT_EQ(polylines[0].normals[i][0], normal[0]);
    EXPECT_EQ(polylines[0].normals[i][1], normal[1]);
    EXPECT_TRUE(polylines[0].teeth.empty());
    // Away from the centre (300, 400), and across the chord of the neighbours.
    EXPECT_GT(normal[0] * (points[i][0] - 300.0) + normal[1] * (points[i][1] - 400.0), 0.0);
    if (i > 0 && i + 1 < points.size())
    {
      const auto chord = points[i + 1] - points[i - 1];
      EXPECT_LT(std::abs(normal[0] * chord[0] + normal[1] * chord[1]), 0.1 * chord.GetNorm());
      const double mm = std::hypot(0.3 * (points[i][0] - points[i - 1][0]), 0.2 * (points[i][1] - points[i - 1][1]));
      EXPECT_NEAR(mm, 0.25, 0.01);
    }
  }
}

TEST(OpenSilhouetteContourSource, PointsKnowTheirToothByTheLabelsOfTheMesh)
{
  const auto mesh = MakeBall();
  for (MeshType::PointIdentifier id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    mesh->SetPointData(id, mesh->GetPoint(id)[0] > 0.0 ? 11.0 : 12.0);
  }
  const auto source = MakeSource(mesh, MakeGeometry());
  source->UseLabelsOn();
  source->Update();
  std::size_t     seen[2] = { 0, 0 };
  DentalContour & output = *source->GetOutput();
  for (DentalContour::PointIdentifier id = 0; id < output.GetNumberOfPoints(); ++id)
  {
    const double x = output.GetRimPoint(id)[0];
    // Within an edge's length of where labels change either may be nearer.
    if (std::abs(x) > 1.5)
    {
      EXPECT_EQ(output.GetToothCode(id).GetFDI(), x > 0.0 ? 11u : 12u) << x;
      ++seen[x > 0.0 ? 0 : 1];
    }
  }
  EXPECT_GT(std::min(seen[0], seen[1]), 20u);
}

TEST(OpenSilhouetteContourSource, FollowsItsInputsAndRunsOnlyThen)
{
  const auto source = MakeSource(MakeBall(), MakeGeometry());
  source->Update();
  const auto once = source->GetOutput()->GetUpdateMTime();
  const auto points = source->GetOutput()->GetNumberOfPoints();
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetUpdateMTime(), once);
  source->SetSpacing(0.25);
  source->Update();
  EXPECT_NEAR(static_cast<double>(points) / source->GetOutput()->GetNumberOfPoints(), 2.0, 0.05);
}

TEST(OpenSilhouetteContourSource, IsTheSameForAnyNumberOfWorkUnits)
{
  const auto                                                      ball = MakeBall();
  std::vector<std::vector<SourceType::OutputMeshType::PointType>> results;
  for (const unsigned int units : { 1u, 2u, 7u })
  {
    const auto source = MakeSource(ball, MakeGeometry(0.2));
    source->SetNumberOfWorkUnits(units);
    source->Update();
    results.push_back(source->GetOutput()->GetPolylines().at(0).points);
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

TEST(OpenSilhouetteContourSource, SaysWhatToCall)
{
  auto source = SourceType::New();
  EXPECT_NE(ErrorOf(source).find("SetInput()"), std::string::npos);
  source->SetInput(MakeBall());
  EXPECT_NE(ErrorOf(source).find("SetGeometry()"), std::string::npos);
  source->SetGeometry(GeometryType::New());
  EXPECT_NE(ErrorOf(source).find("SetPixelSpacing()"), std::string::npos);
  source->SetGeometry(MakeGeometry());
  source->SetSpacing(0.0);
  EXPECT_NE(ErrorOf(source).find("SetSpacing()"), std::string::npos);
  source->SetSpacing(0.125);
  source->SetJaw(SourceType::JawEnum::Unknown);
  EXPECT_NE(ErrorOf(source).find("SetJaw()"), std::string::npos);
  source->SetJaw(SourceType::JawEnum::Upper);
  source->SetInput(ToMesh(SilhouetteTest::MakeSphere({ { 0, -2000, 0 } }, 15.0, 2)));
  EXPECT_NE(ErrorOf(source).find("in front of"), std::string::npos);
  auto broken = MakeBall();
  broken->SetPoint(3, MeshType::PointType(std::numeric_limits<double>::quiet_NaN()));
  source->SetInput(broken);
  EXPECT_NE(ErrorOf(source).find("read or build it again"), std::string::npos);
  source->SetInput(MeshType::New());
  EXPECT_EQ(ErrorOf(source), "");
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0u);
}
