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
#include "itkCephalometricGeometry.h"

#include "itkPlaceByProjection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <tuple>

namespace
{
using GeometryType = itk::CephalometricGeometry;
using SideEnum = GeometryType::SourceSideEnum;
using FacingEnum = GeometryType::FacingEnum;
using DirectionEnum = GeometryType::DirectionEnum;

GeometryType::RotationType
RotationAbout(const itk::Vector<double, 3> & axis, double angle)
{
  // Rodrigues' formula.
  const double               c = std::cos(angle);
  const double               s = std::sin(angle);
  GeometryType::RotationType r;
  const double cross[3][3] = { { 0, -axis[2], axis[1] }, { axis[2], 0, -axis[0] }, { -axis[1], axis[0], 0 } };
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      r(i, j) = (i == j ? c : 0.0) + (1.0 - c) * axis[i] * axis[j] + s * cross[i][j];
    }
  }
  return r;
}

GeometryType::Pointer
MakeGeometry(SideEnum side, FacingEnum facing, DirectionEnum direction = DirectionEnum::Lateral)
{
  auto geometry = GeometryType::New();
  geometry->SetDirection(direction);
  if (direction == DirectionEnum::Lateral)
  {
    geometry->SetSourceSide(side);
    geometry->SetFacing(facing);
  }
  else
  {
    // The signs of the other direction, and what is said of the lateral one changes nothing.
    geometry->SetSourceSide(side == SideEnum::Right ? SideEnum::Left : SideEnum::Right);
    geometry->SetFrontalSource(side == SideEnum::Right ? GeometryType::FrontalSourceEnum::Behind
                                                       : GeometryType::FrontalSourceEnum::InFront);
    geometry->SetPatientLeft(facing == FacingEnum::Right ? GeometryType::PatientLeftEnum::Right
                                                         : GeometryType::PatientLeftEnum::Left);
  }
  GeometryType::PixelSpacingType spacing;
  spacing[0] = 0.25;
  spacing[1] = 0.2;
  geometry->SetPixelSpacing(spacing);
  GeometryType::PixelIndexType principal;
  principal[0] = 172.4;
  principal[1] = 421.0;
  geometry->SetPrincipalPoint(principal);
  return geometry;
}

void
SetSomePose(GeometryType * geometry)
{
  itk::Vector<double, 3> axis;
  axis[0] = 2.0 / 7.0;
  axis[1] = 3.0 / 7.0;
  axis[2] = 6.0 / 7.0;
  GeometryType::VectorType translation;
  translation[0] = 70.0;
  translation[1] = -2.5;
  translation[2] = -50.0;
  geometry->SetPose(RotationAbout(axis, 0.7), translation);
}

GeometryType::PointType
MakePoint(double x, double y, double z)
{
  GeometryType::PointType point;
  point[0] = x;
  point[1] = y;
  point[2] = z;
  return point;
}

class CephalometricGeometryCombinations
  : public ::testing::TestWithParam<std::tuple<SideEnum, FacingEnum, DirectionEnum>>
{
protected:
  static GeometryType::Pointer
  MakeGeometry()
  {
    return ::MakeGeometry(std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam()));
  }
};
} // namespace

// The formulas of formats.md and views.md, spelled out in numbers for each of the combinations.
TEST_P(CephalometricGeometryCombinations, ProjectsAsTheContractSays)
{
  const auto   geometry = MakeGeometry();
  const double k = std::get<0>(GetParam()) == SideEnum::Right ? 1.0 : -1.0;
  const double f = std::get<1>(GetParam()) == FacingEnum::Right ? 1.0 : -1.0;
  const double m = 1674.0 / (1524.0 + k * 28.0);
  const bool   isLateral = std::get<2>(GetParam()) == DirectionEnum::Lateral;
  const auto   pixel = geometry->ProjectPoint(isLateral ? MakePoint(40.0, 28.0, -30.0) : MakePoint(28.0, 40.0, -30.0));
  EXPECT_NEAR(pixel[0], 172.4 + f * m * 40.0 / 0.25, 1e-10);
  EXPECT_NEAR(pixel[1], 421.0 + m * 30.0 / 0.2, 1e-10);
}

TEST_P(CephalometricGeometryCombinations, MatrixAndKernelProjectAsProjectPoint)
{
  const auto geometry = MakeGeometry();
  SetSomePose(geometry);
  const auto projection = geometry->GetProjection();
  for (const auto & point : { MakePoint(0, 0, 0), MakePoint(12, -30, 7), MakePoint(-25, 28, 3) })
  {
    const auto pixel = geometry->ProjectPoint(point);
    double     u = 0.0;
    double     v = 0.0;
    EXPECT_GT(projection.Project(point.GetDataPointer(), u, v), 0.0);
    EXPECT_NEAR(u, pixel[0], 1e-9);
    EXPECT_NEAR(v, pixel[1], 1e-9);
  }
}

TEST_P(CephalometricGeometryCombinations, TakesEverythingButDistancesAndSideFromAProjection)
{
  const auto geometry = MakeGeometry();
  SetSomePose(geometry);
  // An estimated scale is smaller pixels about the principal point; a homogeneous matrix has any factor.
  constexpr double scale = 1.05;
  auto             matrix = geometry->GetProjection().matrix;
  for (unsigned int column = 0; column < 4; ++column)
  {
    for (unsigned int row = 0; row < 2; ++row)
    {
      const double principal = geometry->GetPrincipalPoint()[row] * matrix[8 + column];
      matrix[4 * row + column] = principal + scale * (matrix[4 * row + column] - principal);
    }
  }
  for (double & element : matrix)
  {
    element *= -3.0;
  }
  // The other facing: it is taken from the matrix.
  const FacingEnum other = std::get<1>(GetParam()) == FacingEnum::Right ? FacingEnum::Left : FacingEnum::Right;
  const auto       taken = ::MakeGeometry(std::get<0>(GetParam()), other, std::get<2>(GetParam()));
  itk::PlaceByProjection(matrix, taken);
  EXPECT_EQ(taken->GetFacingSign(), geometry->GetFacingSign());
  EXPECT_EQ(taken->GetSourceSign(), geometry->GetSourceSign());
  EXPECT_NEAR(taken->GetPixelSpacing()[0], geometry->GetPixelSpacing()[0] / scale, 1e-9);
  EXPECT_NEAR(taken->GetPixelSpacing()[1], geometry->GetPixelSpacing()[1] / scale, 1e-9);
  for (unsigned int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(taken->GetPoseTranslation()[d], geometry->GetPoseTranslation()[d], 1e-9);
    EXPECT_NEAR(taken->GetSourcePosition()[d], geometry->GetSourcePosition()[d], 1e-6);
  }
  for (const auto & point : { MakePoint(10, 20, 30), MakePoint(-40, 5, -12), MakePoint(0, 0, 0) })
  {
    const double * const p = point.GetDataPointer();
    const double         depth = matrix[8] * p[0] + matrix[9] * p[1] + matrix[10] * p[2] + matrix[11];
    const auto           pixel = taken->ProjectPoint(point);
    for (unsigned int row = 0; row < 2; ++row)
    {
      const double * const m = &matrix[4 * row];
      EXPECT_NEAR(pixel[row], (m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3]) / depth, 1e-8);
    }
  }
}

TEST(CephalometricGeometry, ATurnInTheImageBecomesOneOfTheHead)
{
  // As of the paper's similarity: pixels are turned, and moved, after the projection.
  const auto                     geometry = MakeGeometry(SideEnum::Right, FacingEnum::Left);
  GeometryType::PixelSpacingType square;
  square.Fill(0.25);
  geometry->SetPixelSpacing(square);
  const auto       nominal = geometry->GetProjection().matrix;
  auto             turned = nominal;
  constexpr double angle = 0.1;
  for (unsigned int column = 0; column < 4; ++column)
  {
    turned[column] =
      std::cos(angle) * nominal[column] - std::sin(angle) * nominal[4 + column] + 40.0 * nominal[8 + column];
    turned[4 + column] =
      std::sin(angle) * nominal[column] + std::cos(angle) * nominal[4 + column] - 9.0 * nominal[8 + column];
  }
  itk::PlaceByProjection(turned, geometry);
  const auto taken = geometry->GetProjection().matrix;
  for (unsigned int i = 0; i < 12; ++i)
  {
    EXPECT_NEAR(taken[i], turned[i], 1e-9) << i;
  }
}

TEST(CephalometricGeometry, RefusesWhatIsNoProjection)
{
  const auto geometry = MakeGeometry(SideEnum::Right, FacingEnum::Right);
  EXPECT_THROW(itk::PlaceByProjection({}, geometry), itk::ExceptionObject);
  auto matrix = geometry->GetProjection().matrix;
  std::fill(matrix.begin(), matrix.begin() + 4, 0.0);
  EXPECT_THROW(itk::PlaceByProjection(matrix, geometry), itk::ExceptionObject);
  matrix = geometry->GetProjection().matrix;
  matrix[11] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(itk::PlaceByProjection(matrix, geometry), itk::ExceptionObject);
}

TEST_P(CephalometricGeometryCombinations, PointJacobianAgreesWithDifferences)
{
  const auto geometry = MakeGeometry();
  SetSomePose(geometry);
  const auto   point = MakePoint(12, -30, 7);
  const auto   jacobian = geometry->ComputePointJacobian(point);
  const double h = 1e-3;
  for (unsigned int d = 0; d < 3; ++d)
  {
    auto forward = point;
    auto backward = point;
    forward[d] += h;
    backward[d] -= h;
    for (unsigned int row = 0; row < 2; ++row)
    {
      const double difference =
        (geometry->ProjectPoint(forward)[row] - geometry->ProjectPoint(backward)[row]) / (2.0 * h);
      EXPECT_NEAR(jacobian(row, d), difference, 1e-7);
    }
  }
}

TEST_P(CephalometricGeometryCombinations, PoseJacobianAgreesWithDifferences)
{
  const auto geometry = MakeGeometry();
  SetSomePose(geometry);
  const auto   point = MakePoint(12, -30, 7);
  const auto   jacobian = geometry->ComputePoseJacobian(point);
  const auto   rotation = geometry->GetPoseRotation();
  const auto   translation = geometry->GetPoseTranslation();
  const double h = 1e-5;
  for (unsigned int parameter = 0; parameter < 6; ++parameter)
  {
    double values[2][2];
    for (int side = 0; side < 2; ++side)
    {
      const double step = side == 0 ? h : -h;
      if (parameter < 3)
      {
        itk::Vector<double, 3> axis(0.0);
        axis[parameter] = 1.0;
        const auto turn = RotationAbout(axis, step);
        geometry->SetPose(turn * rotation, turn * translation);
      }
      else
      {
        auto moved = translation;
        moved[parameter - 3] += step;
        geometry->SetPose(rotation, moved);
      }
      const auto pixel = geometry->ProjectPoint(point);
      values[side][0] = pixel[0];
      values[side][1] = pixel[1];
    }
    for (unsigned int row = 0; row < 2; ++row)
    {
      EXPECT_NEAR(jacobian(row, parameter), (values[0][row] - values[1][row]) / (2.0 * h), 1e-5);
    }
  }
}

TEST_P(CephalometricGeometryCombinations, RayOfAProjectedPointPassesThroughIt)
{
  const auto geometry = MakeGeometry();
  SetSomePose(geometry);
  const auto point = MakePoint(12, -30, 7);
  const auto ray = geometry->BackProject(geometry->ProjectPoint(point));
  const auto toPoint = point - ray.origin;
  EXPECT_NEAR(toPoint * ray.direction, toPoint.GetNorm(), 1e-9);
  EXPECT_NEAR((toPoint - ray.direction * (toPoint * ray.direction)).GetNorm(), 0.0, 1e-9);
  EXPECT_NEAR(geometry->GetProjection().Depth(ray.origin.GetDataPointer()), 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(AllEight,
                         CephalometricGeometryCombinations,
                         ::testing::Combine(::testing::Values(SideEnum::Right, SideEnum::Left),
                                            ::testing::Values(FacingEnum::Right, FacingEnum::Left),
                                            ::testing::Values(DirectionEnum::Lateral, DirectionEnum::Frontal)));

TEST(CephalometricGeometry, MoreMagnificationNearerToTheSource)
{
  const auto right = MakeGeometry(SideEnum::Right, FacingEnum::Right);
  EXPECT_GT(right->GetMagnification(MakePoint(0, -28, 0)), right->GetMagnification(MakePoint(0, 28, 0)));
  const auto left = MakeGeometry(SideEnum::Left, FacingEnum::Right);
  EXPECT_LT(left->GetMagnification(MakePoint(0, -28, 0)), left->GetMagnification(MakePoint(0, 28, 0)));
}

TEST(CephalometricGeometry, RefusesToProjectWithoutASpacing)
{
  const auto geometry = GeometryType::New();
  EXPECT_FALSE(geometry->HasPixelSpacing());
  try
  {
    geometry->ProjectPoint(MakePoint(0, 0, 0));
    FAIL() << "projected with an unknown spacing";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("SetPixelSpacing"), std::string::npos);
  }
}

TEST(CephalometricGeometry, RefusesImpossibleDistancesAndPoses)
{
  const auto geometry = MakeGeometry(SideEnum::Right, FacingEnum::Right);
  geometry->SetSourceToMidsagittalDistance(1700.0);
  EXPECT_THROW(geometry->VerifyComplete(), itk::ExceptionObject);
  geometry->SetSourceToMidsagittalDistance(1524.0);
  EXPECT_NO_THROW(geometry->VerifyComplete());
  EXPECT_THROW(geometry->ProjectPoint(MakePoint(0, -1600, 0)), itk::ExceptionObject);

  GeometryType::RotationType mirror;
  mirror.SetIdentity();
  mirror(1, 1) = -1.0;
  EXPECT_THROW(geometry->SetPose(mirror, GeometryType::VectorType(0.0)), itk::ExceptionObject);
  mirror(1, 1) = 1.1;
  EXPECT_THROW(geometry->SetPose(mirror, GeometryType::VectorType(0.0)), itk::ExceptionObject);
}

TEST(CephalometricGeometry, EachSetterModifiesAndPrintsItself)
{
  const auto geometry = GeometryType::New();
  auto       before = geometry->GetMTime();
  const auto expectModified = [&](const char * what) {
    EXPECT_GT(geometry->GetMTime(), before) << what;
    before = geometry->GetMTime();
  };
  geometry->SetSourceToMidsagittalDistance(1500.0);
  expectModified("SourceToMidsagittalDistance");
  geometry->SetSourceToDetectorDistance(1650.0);
  expectModified("SourceToDetectorDistance");
  geometry->SetSourceSide(SideEnum::Left);
  expectModified("SourceSide");
  geometry->SetFacing(FacingEnum::Left);
  expectModified("Facing");
  geometry->SetPixelSpacing(GeometryType::PixelSpacingType(0.1));
  expectModified("PixelSpacing");
  SetSomePose(geometry);
  expectModified("Pose");
  geometry->SetFrontalSource(GeometryType::FrontalSourceEnum::InFront);
  expectModified("FrontalSource");
  geometry->SetPatientLeft(GeometryType::PatientLeftEnum::Left);
  expectModified("PatientLeft");
  geometry->SetDirection(DirectionEnum::Frontal);
  expectModified("Direction");
  geometry->SetFacing(FacingEnum::Left);
  EXPECT_EQ(geometry->GetMTime(), before);

  std::ostringstream text;
  geometry->Print(text);
  for (const char * name : { "Direction: Frontal",
                             "SourceToMidsagittalDistance: 1500",
                             "SourceSide: Left",
                             "Facing: Left",
                             "FrontalSource: InFront",
                             "PatientLeft: Left",
                             "PoseTranslation" })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }

  const auto copy = GeometryType::New();
  copy->Graft(geometry);
  EXPECT_EQ(copy->GetProjectionMatrix(), geometry->GetProjectionMatrix());
}
