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
#include "itkCephalometricPoseTransform.h"

#include "itkMath.h"
#include "itkMessageOfCall.h"
#include "itkTestingMacros.h"
#include "itkTransformFactory.h"
#include "itkTransformFileReader.h"
#include "itkTransformFileWriter.h"
#include "itkTxtTransformIOFactory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{
using itk::MessageOfCall;
using TransformType = itk::CephalometricPoseTransform;
using ParametersType = TransformType::ParametersType;
using FixedParametersType = TransformType::FixedParametersType;
using PointType = TransformType::InputPointType;
using RotationType = TransformType::RotationType;
using TranslationType = TransformType::TranslationType;

constexpr double halfPi = itk::Math::pi / 2.0;

template <typename TArray>
TArray
Values(const std::vector<double> & values)
{
  TArray array(values.size());
  std::copy(values.begin(), values.end(), array.data_block());
  return array;
}

PointType
MakePoint(double x, double y, double z)
{
  const double values[3] = { x, y, z };
  return PointType(values);
}

/** 0 lateral, 1 frontal: of the geometries that are made. */
double direction = 0.0;

/** Unequal spacings and distances of no special ratio, so that no two of them can be confused. */
std::vector<double>
FixedValues(double source, double facing)
{
  return { 1500.0, 1700.0, source, facing, 0.2, 0.3, 412.5, 303.25, direction };
}

const std::vector<double> pose{ 0.2, -0.05, 0.08, 55.0, 1.5, -40.0, 0.01 };

TransformType::Pointer
MakeTransform(double source = 1.0, double facing = 1.0, const std::vector<double> & parameters = pose)
{
  auto transform = TransformType::New();
  transform->SetFixedParameters(Values<FixedParametersType>(FixedValues(source, facing)));
  transform->SetParameters(Values<ParametersType>(parameters));
  return transform;
}

itk::CephalometricGeometry::Pointer
MakeGeometry(double source, double facing)
{
  using GeometryType = itk::CephalometricGeometry;
  const std::vector<double>  values = FixedValues(source, facing);
  auto                       geometry = GeometryType::New();
  const double               principalPoint[2] = { values[6], values[7] };
  const double               spacing[2] = { values[4], values[5] };
  GeometryType::VectorType   away(100.0);
  GeometryType::RotationType identity;
  identity.SetIdentity();
  geometry->SetSourceToMidsagittalDistance(values[0]);
  geometry->SetSourceToDetectorDistance(values[1]);
  geometry->SetDirection(direction == 0.0 ? GeometryType::DirectionEnum::Lateral
                                          : GeometryType::DirectionEnum::Frontal);
  geometry->SetSourceSide(source > 0.0 ? GeometryType::SourceSideEnum::Right : GeometryType::SourceSideEnum::Left);
  geometry->SetFacing(facing > 0.0 ? GeometryType::FacingEnum::Right : GeometryType::FacingEnum::Left);
  geometry->SetFrontalSource(source > 0.0 ? GeometryType::FrontalSourceEnum::Behind
                                          : GeometryType::FrontalSourceEnum::InFront);
  geometry->SetPatientLeft(facing > 0.0 ? GeometryType::PatientLeftEnum::Right : GeometryType::PatientLeftEnum::Left);
  geometry->SetPrincipalPoint(principalPoint);
  geometry->SetPixelSpacing(GeometryType::PixelSpacingType(spacing));
  geometry->SetPose(identity, away);
  return geometry;
}

void
ForAllGeometries(const std::function<void(double, double)> & check)
{
  for (double source : { 1.0, -1.0 })
  {
    for (double facing : { 1.0, -1.0 })
    {
      for (const double where : { 0.0, 1.0 })
      {
        direction = where;
        SCOPED_TRACE(testing::Message() << "source sign " << source << ", facing sign " << facing << ", direction "
                                        << where);
        check(source, facing);
      }
      direction = 0.0;
    }
  }
}

void
ExpectMessage(const std::function<void()> & function, const std::vector<std::string> & parts)
{
  const std::string message = MessageOfCall(function);
  for (const std::string & part : parts)
  {
    EXPECT_NE(message.find(part), std::string::npos) << "\"" << part << "\" is not in: " << message;
  }
}

/** The three rotations written out beside the engine. */
RotationType
RotationOf(double pitch, double roll, double yaw)
{
  RotationType y, x, z;
  y.SetIdentity();
  x.SetIdentity();
  z.SetIdentity();
  y(0, 0) = y(2, 2) = std::cos(pitch);
  y(0, 2) = std::sin(pitch);
  y(2, 0) = -std::sin(pitch);
  x(1, 1) = x(2, 2) = std::cos(roll);
  x(1, 2) = -std::sin(roll);
  x(2, 1) = std::sin(roll);
  z(0, 0) = z(1, 1) = std::cos(yaw);
  z(0, 1) = -std::sin(yaw);
  z(1, 0) = std::sin(yaw);
  return y * x * z;
}

double
LargestDifference(const RotationType & a, const RotationType & b)
{
  double largest = 0.0;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      largest = std::max(largest, std::abs(a(row, column) - b(row, column)));
    }
  }
  return largest;
}

RotationType
RotationOf(const TransformType & transform)
{
  const ParametersType & p = transform.GetParameters();
  return RotationOf(p[itk::PosePitch], p[itk::PoseRoll], p[itk::PoseYaw]);
}

/** ITK's macro returns from the function that it is in. */
int
ExerciseBasics()
{
  const auto transform = TransformType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(transform, CephalometricPoseTransform, Transform);
  return EXIT_SUCCESS;
}

const std::vector<PointType> points{ MakePoint(12.0, -21.0, 7.0), MakePoint(-30.0, 25.0, -11.0), MakePoint(0, 0, 0) };
} // namespace

TEST(CephalometricPoseTransform, HasTheBasicsOfAnObject)
{
  auto transform = TransformType::New();
  EXPECT_EQ(ExerciseBasics(), EXIT_SUCCESS);
  MakeTransform()->Print(std::cout);
  EXPECT_EQ(transform->GetNumberOfParameters(), 7u);
  EXPECT_EQ(transform->GetNumberOfFixedParameters(), 9u);
  EXPECT_EQ(transform->GetParameters(), Values<ParametersType>({ 0, 0, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(transform->GetInputSpaceDimension(), 3u);
  EXPECT_EQ(transform->GetOutputSpaceDimension(), 2u);
  EXPECT_FALSE(transform->IsLinear());
  EXPECT_EQ(transform->GetTransformCategory(), TransformType::TransformCategoryEnum::UnknownTransformCategory);
  EXPECT_TRUE(transform->GetInverseTransform().IsNull());
}

TEST(CephalometricPoseTransform, AppliesYawThenRollThenPitchThenTranslation)
{
  // D = 2 S and a quarter turn about each axis: yaw takes x to y and y to -x, roll y to z and z to -y, pitch z to x and
  // x to -z. In this order x stays x, y goes to z, z to -y; in any other order x does not end at x.
  auto transform = TransformType::New();
  transform->SetFixedParameters(Values<FixedParametersType>({ 1000.0, 2000.0, 1.0, 1.0, 0.5, 0.25, 100.0, 200.0 }));
  transform->SetParameters(Values<ParametersType>({ halfPi, halfPi, halfPi, 0.0, 0.0, 0.0, 0.0 }));
  const auto expectPixel = [&](const PointType & point, double u, double v) {
    const TransformType::OutputPointType pixel = transform->TransformPoint(point);
    // Rounding of a quarter turn times 10 mm times 8 pixels a mm.
    EXPECT_NEAR(pixel[0], u, 1e-11) << point;
    EXPECT_NEAR(pixel[1], v, 1e-11) << point;
  };
  // m = 2: c = (10, 0, 0), u = 100 + 2 * 10 / 0.5.
  expectPixel(MakePoint(10.0, 0.0, 0.0), 140.0, 200.0);
  // c = (0, 0, 10), v = 200 - 2 * 10 / 0.25: z up is v down.
  expectPixel(MakePoint(0.0, 10.0, 0.0), 100.0, 120.0);
  // The translation is not rotated. c = (10, 600, 0) - 200 along y: m = 2000 / 1400.
  transform->SetParameters(Values<ParametersType>({ halfPi, halfPi, halfPi, 7.0, 600.0, -14.0, 0.0 }));
  expectPixel(MakePoint(0.0, 0.0, 200.0), 100.0 + 10.0 / 7.0 * 7.0 / 0.5, 200.0 + 10.0 / 7.0 * 14.0 / 0.25);
  // A source on the left is nearer to a point with c_y > 0, and a patient who faces left is mirrored: m = 2000 / 600.
  transform->SetFixedParameters(Values<FixedParametersType>({ 1000.0, 2000.0, -1.0, -1.0, 0.5, 0.25, 100.0, 200.0 }));
  expectPixel(MakePoint(0.0, 0.0, 200.0), 100.0 - 10.0 / 3.0 * 7.0 / 0.5, 200.0 + 10.0 / 3.0 * 14.0 / 0.25);
  // kappa = log 3 makes the picture three times as large about the principal point.
  transform->SetParameters(Values<ParametersType>({ halfPi, halfPi, halfPi, 7.0, 600.0, -14.0, std::log(3.0) }));
  expectPixel(MakePoint(0.0, 0.0, 200.0), 100.0 - 10.0 * 7.0 / 0.5, 200.0 + 10.0 * 14.0 / 0.25);
  EXPECT_NEAR(transform->GetScaleFactor(), 3.0, 1e-15);
}

TEST(CephalometricPoseTransform, ParameterJacobianMatchesDifferencesInAllGeometries)
{
  ForAllGeometries([](double source, double facing) {
    auto transform = MakeTransform(source, facing);
    for (const PointType & point : points)
    {
      transform->SetParameters(Values<ParametersType>(pose));
      TransformType::JacobianType jacobian;
      transform->ComputeJacobianWithRespectToParameters(point, jacobian);
      ASSERT_EQ(jacobian.rows(), 2u);
      ASSERT_EQ(jacobian.cols(), 7u);
      for (unsigned int k = 0; k < TransformType::NumberOfParameters; ++k)
      {
        const double        h = 1e-5;
        std::vector<double> less = pose, more = pose;
        less[k] -= h;
        more[k] += h;
        transform->SetParameters(Values<ParametersType>(less));
        const auto a = transform->TransformPoint(point);
        transform->SetParameters(Values<ParametersType>(more));
        const auto b = transform->TransformPoint(point);
        for (unsigned int row = 0; row < 2; ++row)
        {
          // h^2 / 6 times third derivatives of up to 500 pixels, and 1e-13 of rounding a pixel index / h: 2e-8
          // together.
          EXPECT_NEAR(jacobian(row, k), (b[row] - a[row]) / (2.0 * h), 1e-7) << row << ", " << k;
        }
      }
    }
  });
}

TEST(CephalometricPoseTransform, PositionJacobianMatchesDifferencesInAllGeometries)
{
  ForAllGeometries([](double source, double facing) {
    const auto transform = MakeTransform(source, facing);
    for (const PointType & point : points)
    {
      TransformType::JacobianPositionType jacobian;
      transform->ComputeJacobianWithRespectToPosition(point, jacobian);
      for (unsigned int k = 0; k < 3; ++k)
      {
        const double h = 1e-3;
        PointType    less = point, more = point;
        less[k] -= h;
        more[k] += h;
        const auto a = transform->TransformPoint(less);
        const auto b = transform->TransformPoint(more);
        for (unsigned int row = 0; row < 2; ++row)
        {
          // 1e-13 of rounding a pixel index / h; the third derivatives are below 1e-6 pixels a mm^3.
          EXPECT_NEAR(jacobian(row, k), (b[row] - a[row]) / (2.0 * h), 1e-9) << row << ", " << k;
        }
      }
      // ITK's pseudo-inverse of it: the shortest way of the point that moves the pixel.
      TransformType::InverseJacobianPositionType inverse;
      transform->ComputeInverseJacobianWithRespectToPosition(point, inverse);
      const auto product = jacobian * inverse;
      for (unsigned int row = 0; row < 2; ++row)
      {
        for (unsigned int column = 0; column < 2; ++column)
        {
          EXPECT_NEAR(product(row, column), row == column ? 1.0 : 0.0, 1e-12);
        }
      }
    }
  });
}

TEST(CephalometricPoseTransform, AgreesWithTheGeometryThatItIsCopiedTo)
{
  ForAllGeometries([](double source, double facing) {
    auto transform = TransformType::New();
    transform->SetGeometry(MakeGeometry(source, facing));
    EXPECT_EQ(transform->GetFixedParameters(), Values<FixedParametersType>(FixedValues(source, facing)));
    transform->SetParameters(Values<ParametersType>(pose));
    auto placed = itk::CephalometricGeometry::New();
    transform->CopyToGeometry(placed);
    for (const PointType & point : points)
    {
      const auto pixel = transform->TransformPoint(point);
      const auto expected = placed->ProjectPoint(point);
      EXPECT_NEAR(pixel[0], expected[0], 1e-9);
      EXPECT_NEAR(pixel[1], expected[1], 1e-9);
      TransformType::JacobianPositionType jacobian;
      transform->ComputeJacobianWithRespectToPosition(point, jacobian);
      const auto expectedJacobian = placed->ComputePointJacobian(point);
      for (unsigned int row = 0; row < 2; ++row)
      {
        for (unsigned int column = 0; column < 3; ++column)
        {
          EXPECT_NEAR(jacobian(row, column), expectedJacobian(row, column), 1e-12);
        }
      }
    }
    EXPECT_NEAR(placed->GetPixelSpacing()[0], 0.2 / std::exp(0.01), 1e-15);
    EXPECT_EQ(placed->GetFacingSign(), facing);
    EXPECT_EQ(placed->GetSourceSign(), source);
  });
}

TEST(CephalometricPoseTransform, TakesTheGeometryWithoutItsPose)
{
  // The geometry of this test has a pose that moves by 100 mm.
  auto       transform = TransformType::New();
  const auto geometry = MakeGeometry(1.0, 1.0);
  transform->SetGeometry(geometry);
  geometry->SetPoseToIdentity();
  for (const PointType & point : points)
  {
    const auto pixel = transform->TransformPoint(point);
    const auto expected = geometry->ProjectPoint(point);
    EXPECT_NEAR(pixel[0], expected[0], 1e-9);
    EXPECT_NEAR(pixel[1], expected[1], 1e-9);
  }
}

TEST(CephalometricPoseTransform, GivesKernelsWhatItUses)
{
  const auto              transform = MakeTransform(-1.0, -1.0);
  const itk::PoseGeometry geometry = transform->GetPoseGeometry();
  EXPECT_TRUE(geometry.pixelSpacingKnown);
  EXPECT_TRUE(geometry.principalPointKnown);
  const itk::PoseModel model(geometry, transform->GetPoseParameters());
  for (const PointType & point : points)
  {
    double w[2];
    ASSERT_TRUE(model.Project(point.GetDataPointer(), w));
    const auto expected = itk::PoseModel::ToPixel(geometry, { { w[0], w[1] } });
    const auto pixel = transform->TransformPoint(point);
    EXPECT_EQ(pixel[0], expected[0]);
    EXPECT_EQ(pixel[1], expected[1]);
  }
}

TEST(CephalometricPoseTransform, IsTheRigidTransformThenTheMagnifiedProjection)
{
  // Small poses, half turns and more than half turns, where a versor changes its sign.
  const std::vector<std::vector<double>> rotations{ { 0.2, -0.05, 0.08 },        { itk::Math::pi, 0.0, 0.0 },
                                                    { 0.0, 0.0, itk::Math::pi }, { 3.0, 0.4, -2.9 },
                                                    { 3.1415926, 1e-8, 1e-8 },   { -2.5, halfPi, 3.0 },
                                                    { 6.0, -3.0, 5.0 } };
  for (const std::vector<double> & angles : rotations)
  {
    std::vector<double> parameters = pose;
    std::copy(angles.begin(), angles.end(), parameters.begin());
    const auto transform = MakeTransform(-1.0, 1.0, parameters);
    const auto rigid = transform->GetRigidTransform();
    // Products of three matrices and of three versors: a few roundings.
    EXPECT_LT(LargestDifference(rigid->GetMatrix(), RotationOf(*transform)), 4e-15) << angles[0];
    EXPECT_EQ(rigid->GetTranslation()[0], 55.0);
    EXPECT_EQ(rigid->GetTranslation()[1], 1.5);
    EXPECT_EQ(rigid->GetTranslation()[2], -40.0);
    EXPECT_EQ(rigid->GetCenter(), MakePoint(0.0, 0.0, 0.0));
    const auto projection = MakeTransform(-1.0, 1.0, { 0, 0, 0, 0, 0, 0, std::log(transform->GetScaleFactor()) });
    const auto copy = itk::VersorRigid3DTransform<double>::New();
    copy->SetParameters(rigid->GetParameters());
    for (const PointType & point : points)
    {
      const auto pixel = transform->TransformPoint(point);
      EXPECT_LT(pixel.EuclideanDistanceTo(projection->TransformPoint(rigid->TransformPoint(point))), 1e-9);
      // ITK keeps the norm of versor parameters 1e-10 below one: 3e-5 rad away from a half turn, times 40 mm.
      EXPECT_LT(copy->TransformPoint(point).EuclideanDistanceTo(rigid->TransformPoint(point)), 2e-3);
    }
  }
}

TEST(CephalometricPoseTransform, FindsItsParametersInARotation)
{
  auto transform = TransformType::New();
  for (double pitch : { -3.1, -0.3, 0.0, 1.0, 2.5 })
  {
    for (double roll : { -1.5, -0.2, 0.0, 0.7, 1.57 })
    {
      for (double yaw : { -2.9, -0.1, 0.0, 1.6, 3.0 })
      {
        const TranslationType translation = MakePoint(1.0, -2.0, 3.0).GetVectorFromOrigin();
        transform->SetParametersFromRotation(RotationOf(pitch, roll, yaw), translation, 0.02);
        const ParametersType & p = transform->GetParameters();
        // One rounding of 1e-16 in a cosine of 8e-4 where the roll is 1.57.
        EXPECT_NEAR(p[itk::PosePitch], pitch, 1e-12);
        EXPECT_NEAR(p[itk::PoseRoll], roll, 1e-12);
        EXPECT_NEAR(p[itk::PoseYaw], yaw, 1e-12);
        EXPECT_EQ(p[itk::PoseTx], 1.0);
        EXPECT_EQ(p[itk::PoseTy], -2.0);
        EXPECT_EQ(p[itk::PoseTz], 3.0);
        EXPECT_EQ(p[itk::PoseKappa], 0.02);
      }
    }
  }
}

TEST(CephalometricPoseTransform, KeepsARotationAtAndNearTheGimbal)
{
  auto transform = TransformType::New();
  for (double sign : { 1.0, -1.0 })
  {
    for (double pitch : { -2.8, 0.0, 0.4 })
    {
      for (double yaw : { -0.9, 0.0, 2.0 })
      {
        for (double below : { 0.0, 1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-4 })
        {
          const RotationType rotation = RotationOf(pitch, sign * (halfPi - below), yaw);
          transform->SetParametersFromRotation(rotation, TranslationType(0.0), 0.0);
          // Within 1e-12 rad of the gimbal the roll is rounded to it; elsewhere only doubles are.
          EXPECT_LT(LargestDifference(RotationOf(*transform), rotation), 1e-12) << pitch << ' ' << yaw << ' ' << below;
          EXPECT_NEAR(transform->GetParameters()[itk::PoseRoll], sign * (halfPi - below), 2e-12);
          if (below < 1e-12)
          {
            EXPECT_EQ(transform->GetParameters()[itk::PoseYaw], 0.0);
          }
        }
      }
    }
  }
  // By hand: a quarter roll and a quarter yaw are a quarter turn of pitch the other way and the roll.
  transform->SetParametersFromRotation(RotationOf(0.0, halfPi, halfPi), TranslationType(0.0), 0.0);
  EXPECT_NEAR(transform->GetParameters()[itk::PosePitch], -halfPi, 1e-15);
  EXPECT_NEAR(transform->GetParameters()[itk::PoseRoll], halfPi, 1e-15);
}

TEST(CephalometricPoseTransform, ClonesParametersAndFixedParameters)
{
  const auto                   transform = MakeTransform(-1.0, 1.0);
  const TransformType::Pointer clone = transform->Clone();
  EXPECT_EQ(clone->GetParameters(), transform->GetParameters());
  EXPECT_EQ(clone->GetFixedParameters(), transform->GetFixedParameters());
  EXPECT_EQ(clone->TransformPoint(points[0]), transform->TransformPoint(points[0]));
  clone->SetIdentity();
  EXPECT_EQ(transform->GetParameters(), Values<ParametersType>(pose));

  auto unset = TransformType::New();
  unset->SetParameters(Values<ParametersType>(pose));
  const TransformType::Pointer unsetClone = unset->Clone();
  EXPECT_EQ(unsetClone->GetParameters(), unset->GetParameters());
  EXPECT_EQ(unsetClone->GetFixedParameters(), unset->GetFixedParameters());
  ExpectMessage([&]() { unsetClone->TransformPoint(points[0]); }, { "SetGeometry()" });
}

TEST(CephalometricPoseTransform, IsModifiedOnlyWhereAValueChanges)
{
  auto       transform = MakeTransform();
  const auto unchanged = [&](const std::function<void()> & function) {
    const itk::ModifiedTimeType before = transform->GetMTime();
    function();
    return transform->GetMTime() == before;
  };
  const ParametersType      same = Values<ParametersType>(pose);
  const FixedParametersType sameFixed = Values<FixedParametersType>(FixedValues(1.0, 1.0));
  EXPECT_TRUE(unchanged([&]() { transform->SetParameters(same); }));
  EXPECT_TRUE(unchanged([&]() { transform->SetParameters(transform->GetParameters()); }));
  EXPECT_TRUE(unchanged([&]() { transform->SetParametersByValue(same); }));
  EXPECT_TRUE(unchanged([&]() { transform->CopyInParameters(pose.data(), pose.data() + pose.size()); }));
  EXPECT_TRUE(unchanged([&]() {
    transform->UpdateTransformParameters(Values<ParametersType>({ 0, 0, 0, 0, 0, 0, 0 }));
  }));
  EXPECT_TRUE(unchanged([&]() { transform->SetFixedParameters(sameFixed); }));
  EXPECT_TRUE(unchanged([&]() { transform->SetFixedParameters(transform->GetFixedParameters()); }));
  EXPECT_TRUE(unchanged([&]() { transform->SetGeometry(MakeGeometry(1.0, 1.0)); }));
  EXPECT_TRUE(unchanged([&]() { transform->TransformPoint(points[0]); }));
  EXPECT_FALSE(unchanged([&]() { transform->SetGeometry(MakeGeometry(-1.0, 1.0)); }));
  EXPECT_FALSE(unchanged([&]() { transform->SetIdentity(); }));
  EXPECT_TRUE(unchanged([&]() { transform->SetIdentity(); }));
}

TEST(CephalometricPoseTransform, UpdatesAndCopiesInParametersAsAnOptimizerDoes)
{
  auto transform = MakeTransform();
  transform->UpdateTransformParameters(Values<ParametersType>({ 1, 2, 3, 4, 5, 6, 7 }), 0.01);
  for (unsigned int k = 0; k < TransformType::NumberOfParameters; ++k)
  {
    EXPECT_NEAR(transform->GetParameters()[k], pose[k] + 0.01 * (k + 1), 1e-14);
  }
  // The projection follows the parameters.
  std::vector<double> values(transform->GetParameters().begin(), transform->GetParameters().end());
  EXPECT_EQ(transform->TransformPoint(points[0]), MakeTransform(1.0, 1.0, values)->TransformPoint(points[0]));
  transform->CopyInParameters(pose.data(), pose.data() + pose.size());
  EXPECT_EQ(transform->TransformPoint(points[0]), MakeTransform()->TransformPoint(points[0]));
  const std::vector<double> fixed = FixedValues(-1.0, -1.0);
  transform->CopyInFixedParameters(fixed.data(), fixed.data() + fixed.size());
  EXPECT_EQ(transform->TransformPoint(points[0]), MakeTransform(-1.0, -1.0)->TransformPoint(points[0]));
}

TEST(CephalometricPoseTransform, RefusesBadParametersAndKeepsTheOldOnes)
{
  auto       transform = MakeTransform();
  const auto with = [&](unsigned int index, double value) {
    std::vector<double> values = pose;
    values[index] = value;
    return [transform, values]() { transform->SetParameters(Values<ParametersType>(values)); };
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectMessage(
    [&]() {
      transform->SetParameters(Values<ParametersType>({ 1, 2, 3 }));
    },
    { "3 parameters", "7", "pitch, roll and yaw in rad" });
  ExpectMessage([&]() { transform->CopyInParameters(pose.data(), pose.data() + 2); }, { "2 parameters", "7" });
  ExpectMessage([&]() { transform->UpdateTransformParameters(Values<ParametersType>({ 1, 2 })); }, { "2 values", "7" });
  ExpectMessage(with(itk::PoseYaw, nan), { "yaw is nan" });
  ExpectMessage(with(itk::PoseTx, std::numeric_limits<double>::infinity()), { "tx is inf", "smaller steps" });
  ExpectMessage(with(itk::PoseKappa, 1000.0), { "kappa = 1000", "natural logarithm" });
  ExpectMessage(with(itk::PoseKappa, -1000.0), { "kappa = -1000", "natural logarithm" });
  ParametersType update = Values<ParametersType>({ 1, 0, 0, 0, 0, 0, nan });
  ExpectMessage([&]() { transform->UpdateTransformParameters(update); }, { "kappa is nan" });
  EXPECT_EQ(transform->GetParameters(), Values<ParametersType>(pose));

  RotationType rotation = RotationOf(0.1, 0.2, 0.3);
  ExpectMessage([&]() { transform->SetParametersFromRotation(rotation * 1.01, TranslationType(0.0), 0.0); },
                { "not orthonormal" });
  ExpectMessage([&]() { transform->SetParametersFromRotation(rotation * -1.0, TranslationType(0.0), 0.0); },
                { "mirrors" });
  ExpectMessage([&]() { transform->SetParametersFromRotation(rotation, TranslationType(nan), 0.0); }, { "not finite" });
  EXPECT_EQ(transform->GetParameters(), Values<ParametersType>(pose));
}

TEST(CephalometricPoseTransform, RefusesBadFixedParametersAndKeepsTheOldOnes)
{
  auto         transform = MakeTransform();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto   with = [&](unsigned int index, double value) {
    std::vector<double> values = FixedValues(1.0, 1.0);
    values[index] = value;
    return [transform, values]() { transform->SetFixedParameters(Values<FixedParametersType>(values)); };
  };
  ExpectMessage(
    [&]() {
      transform->SetFixedParameters(Values<FixedParametersType>({ 1, 2 }));
    },
    { "Got 2 fixed parameters", "9 are needed", "SetGeometry()" });
  ExpectMessage([&]() { transform->CopyInFixedParameters(pose.data(), pose.data() + 7); }, { "7 fixed parameters" });
  ExpectMessage(with(TransformType::SourceToMidsagittal, 0.0), { "source-to-midsagittal distance 0 mm", "positive" });
  ExpectMessage(with(TransformType::SourceToMidsagittal, nan), { "nan", "positive" });
  ExpectMessage(with(TransformType::SourceToDetector, 1500.0), { "detector distance 1500 mm", "smaller" });
  ExpectMessage(with(TransformType::SourceToDetector, infinity), { "inf" });
  ExpectMessage(with(TransformType::SourceSign, 0.0), { "source sign is 0", "-1 on the left" });
  ExpectMessage(with(TransformType::FacingSign, 2.0), { "facing sign is 2", "+1 for a patient who faces right" });
  ExpectMessage(with(TransformType::PixelSpacingU, 0.0), { "pixel spacing is 0 x 0.3 mm", "never assumed" });
  ExpectMessage(with(TransformType::PixelSpacingV, -0.3), { "pixel spacing is 0.2 x -0.3 mm" });
  ExpectMessage(with(TransformType::PixelSpacingV, infinity), { "0.2 x inf" });
  ExpectMessage(with(TransformType::PrincipalPointU, nan), { "principal point is (nan, 303.25)", "ear-rod" });
  EXPECT_EQ(transform->GetFixedParameters(), Values<FixedParametersType>(FixedValues(1.0, 1.0)));
  EXPECT_EQ(transform->TransformPoint(points[0]), MakeTransform()->TransformPoint(points[0]));
}

TEST(CephalometricPoseTransform, NeverAssumesAPixelSpacing)
{
  auto transform = TransformType::New();
  ExpectMessage([&]() { transform->TransformPoint(points[0]); }, { "geometry is not set", "SetGeometry()" });
  TransformType::JacobianType         jacobian;
  TransformType::JacobianPositionType positionJacobian;
  ExpectMessage([&]() { transform->ComputeJacobianWithRespectToParameters(points[0], jacobian); }, { "SetGeometry()" });
  ExpectMessage([&]() { transform->ComputeJacobianWithRespectToPosition(points[0], positionJacobian); },
                { "SetGeometry()" });
  ExpectMessage([&]() { transform->GetPoseGeometry(); }, { "SetGeometry()" });
  const auto placed = itk::CephalometricGeometry::New();
  ExpectMessage([&]() { transform->CopyToGeometry(placed); }, { "SetGeometry()" });
  ExpectMessage([&]() { transform->SetFixedParameters(transform->GetFixedParameters()); },
                { "pixel spacing is 0 x 0" });
  ExpectMessage([&]() { transform->SetGeometry(placed); }, { "SetPixelSpacing()" });
  ExpectMessage([&]() { transform->SetGeometry(nullptr); }, { "not a null pointer" });
  ExpectMessage([&]() { MakeTransform()->CopyToGeometry(nullptr); }, { "not a null pointer" });
}

TEST(CephalometricPoseTransform, NamesThePointThatIsNotInFrontOfTheSource)
{
  const auto                          transform = MakeTransform(1.0, 1.0, { 0, 0, 0, 0, 0, 0, 0 });
  TransformType::JacobianType         jacobian;
  TransformType::JacobianPositionType positionJacobian;
  // The source stands at y = -1500 mm.
  const std::vector<std::string> parts{ "[1, -1600, 2]", "depth from there is -100 mm", "Check the mesh's unit" };
  const PointType                behind = MakePoint(1.0, -1600.0, 2.0);
  ExpectMessage([&]() { transform->TransformPoint(behind); }, parts);
  ExpectMessage([&]() { transform->ComputeJacobianWithRespectToParameters(behind, jacobian); }, parts);
  ExpectMessage([&]() { transform->ComputeJacobianWithRespectToPosition(behind, positionJacobian); }, parts);
  ExpectMessage([&]() { transform->TransformPoint(MakePoint(0.0, -1500.0, 0.0)); }, { "depth from there is 0 mm" });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectMessage([&]() { transform->TransformPoint(MakePoint(nan, nan, nan)); }, { "[nan, nan, nan]" });
  EXPECT_NO_THROW(transform->TransformPoint(MakePoint(1.0, 1600.0, 2.0)));
}

TEST(CephalometricPoseTransform, MapsVectorsOnlyAtAPointAndTensorsNowhere)
{
  const auto                          transform = MakeTransform();
  TransformType::JacobianPositionType jacobian;
  transform->ComputeJacobianWithRespectToPosition(points[0], jacobian);
  const double                                  values[3] = { 0.5, -1.0, 2.0 };
  const TransformType::InputVectorType          vector(values);
  const TransformType::InputVnlVectorType       vnlVector(values);
  const TransformType::InputVectorPixelType     pixelVector(values, 3);
  const auto                                    expected = jacobian * vnlVector;
  const TransformType::OutputVectorType         mapped = transform->TransformVector(vector, points[0]);
  const TransformType::OutputVnlVectorType      mappedVnl = transform->TransformVector(vnlVector, points[0]);
  const TransformType::OutputVectorPixelType    mappedPixel = transform->TransformVector(pixelVector, points[0]);
  const TransformType::InputCovariantVectorType covariant(values);
  for (unsigned int row = 0; row < 2; ++row)
  {
    EXPECT_NEAR(mapped[row], expected[row], 1e-13);
    EXPECT_NEAR(mappedVnl[row], expected[row], 1e-13);
    EXPECT_NEAR(mappedPixel[row], expected[row], 1e-13);
  }
  const std::string atAPoint = "TransformVector(vector, point)";
  ExpectMessage([&]() { transform->TransformVector(vector); }, { atAPoint });
  ExpectMessage([&]() { transform->TransformVector(vnlVector); }, { atAPoint });
  ExpectMessage([&]() { transform->TransformVector(pixelVector); }, { atAPoint });
  const std::string transposed = "transpose of ComputeJacobianWithRespectToPosition()";
  ExpectMessage([&]() { transform->TransformCovariantVector(covariant); }, { transposed });
  ExpectMessage([&]() { transform->TransformCovariantVector(covariant, points[0]); }, { transposed });
  ExpectMessage([&]() { transform->TransformCovariantVector(pixelVector); }, { transposed });
  ExpectMessage([&]() { transform->TransformCovariantVector(pixelVector, points[0]); }, { transposed });
  const TransformType::InputDiffusionTensor3DType         diffusion(1.0);
  const TransformType::InputSymmetricSecondRankTensorType symmetric(1.0);
  const std::string                                       tensor = "J C J^T";
  ExpectMessage([&]() { transform->TransformDiffusionTensor3D(diffusion); }, { tensor });
  ExpectMessage([&]() { transform->TransformDiffusionTensor3D(diffusion, points[0]); }, { tensor });
  ExpectMessage([&]() { transform->TransformDiffusionTensor3D(pixelVector); }, { tensor });
  ExpectMessage([&]() { transform->TransformDiffusionTensor3D(pixelVector, points[0]); }, { tensor });
  ExpectMessage([&]() { transform->TransformSymmetricSecondRankTensor(symmetric); }, { tensor });
  ExpectMessage([&]() { transform->TransformSymmetricSecondRankTensor(symmetric, points[0]); }, { tensor });
  ExpectMessage([&]() { transform->TransformSymmetricSecondRankTensor(pixelVector); }, { tensor });
  ExpectMessage([&]() { transform->TransformSymmetricSecondRankTensor(pixelVector, points[0]); }, { tensor });
}

TEST(CephalometricPoseTransform, SurvivesATransformFileToTheLastBit)
{
  itk::TxtTransformIOFactory::RegisterOneFactory();
  itk::TransformFactory<TransformType>::RegisterTransform();
  // ITK documents a second registration as harmless.
  itk::TransformFactory<TransformType>::RegisterTransform();
  std::vector<double> parameters = pose;
  parameters[itk::PosePitch] = 1.0 / 3.0;
  parameters[itk::PoseKappa] = 1e-17 / 3.0;
  const auto transform = MakeTransform(-1.0, -1.0, parameters);
  for (const std::string name : { "/pose.tfm", "/pose.txt" })
  {
    const std::string file = std::string(DENTALSCR_TEST_OUTPUT_DIR) + name;
    auto              writer = itk::TransformFileWriterTemplate<double>::New();
    writer->SetFileName(file);
    writer->SetInput(transform);
    writer->Update();
    auto reader = itk::TransformFileReaderTemplate<double>::New();
    reader->SetFileName(file);
    reader->Update();
    ASSERT_EQ(reader->GetTransformList()->size(), 1u);
    const auto * read = dynamic_cast<const TransformType *>(reader->GetTransformList()->front().GetPointer());
    ASSERT_NE(read, nullptr);
    EXPECT_EQ(read->GetParameters(), transform->GetParameters());
    EXPECT_EQ(read->GetFixedParameters(), transform->GetFixedParameters());
    EXPECT_EQ(read->TransformPoint(points[0]), transform->TransformPoint(points[0]));
  }
}
