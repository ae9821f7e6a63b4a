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
#include "itkPoseRegistrationMethod.h"

#include "itkPoseRegistrationTestCase.h"
#include "itkMessageOfCall.h"
#include "itkPoseSolutionTestCase.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>

// Where a registration is told to begin, and the geometry that this is of.
namespace
{
using itk::MessageOfCall;
using PoseSolutionTestCase::Contains;
using Source = itk::DentalPhantomCaseSource;
using MethodType = PoseRegistrationTestCase::MethodType;
using JawEnum = MethodType::JawEnum;

const PoseRegistrationTestCase &
Typical()
{
  static const PoseRegistrationTestCase typical(71, Source::CohortEnum::Typical, Source::TracedSideEnum::Right);
  return typical;
}

MethodType::Pointer
MakeMethod(const itk::PoseGeometry &            geometry = Typical().geometry,
           const itk::PoseRegistrationOptions & options = itk::PoseRegistrationOptions())
{
  const auto method = PoseRegistrationTestCase::MakeMethod(Typical().jaws, geometry, options);
  method->ClearHypotheses();
  return method;
}

const itk::PoseRegistrationResult &
Plain()
{
  static const itk::PoseRegistrationResult plain = [] {
    const auto method = MakeMethod();
    method->Update();
    return method->GetOutput()->GetResult();
  }();
  return plain;
}

/** Begins where the registration without a start ended. */
void
BeginAtPlain(MethodType * method)
{
  static const auto transform = [] {
    const auto plain = MakeMethod();
    plain->Update();
    return MethodType::RigidTransformType::ConstPointer(plain->GetTransform(JawEnum::Upper));
  }();
  method->SetInitialTransform(JawEnum::Upper, transform, std::exp(Plain().groups[0].parameters[itk::PoseKappa]));
}

/** Begins elsewhere. */
MethodType::Pointer
MakeMethodAt(const itk::PoseParameters & pose)
{
  itk::PoseRegistrationOptions options;
  options.useInitialPose = true;
  options.initialPose = pose;
  return MakeMethod(Typical().geometry, options);
}

/** Where the middle of the upper jaw is on the radiograph. */
std::array<double, 2>
PlaceOfTheMiddle(const itk::PoseRegistrationResult & result)
{
  const auto   p = Typical().surfaces[0].AreaCentroid();
  const auto & a = result.jaws[0].projection;
  const double w = a[8] * p[0] + a[9] * p[1] + a[10] * p[2] + a[11];
  return { { (a[0] * p[0] + a[1] * p[1] + a[2] * p[2] + a[3]) / w,
             (a[4] * p[0] + a[5] * p[1] + a[6] * p[2] + a[7]) / w } };
}

itk::PoseRegistrationOptions
AllHeld()
{
  itk::PoseRegistrationOptions options;
  options.fixScale = true;
  options.fixRotation = true;
  options.fixTranslation = true;
  return options;
}

itk::PoseGeometry
AnotherGeometry()
{
  itk::PoseGeometry other = Typical().geometry;
  other.principalPoint = { { other.principalPoint[0] + 37.0, other.principalPoint[1] - 21.0 } };
  other.pixelSpacing = { { 0.8 * other.pixelSpacing[0], 0.8 * other.pixelSpacing[1] } };
  other.sourceToMidsagittal -= 110.0;
  other.sourceToDetector -= 90.0;
  return other;
}
} // namespace

TEST(PoseRegistrationStart, TheAnswerDoesNotTellWhereInItsPlaceAStartWas)
{
  // Minima lie a fraction of a pixel apart: each of these starts by itself ends in another one.
  for (const double shift : { 0.0, 0.7, -1.1 })
  {
    auto pose = Plain().groups[0].parameters;
    pose[itk::PosePitch] += 0.02 * shift;
    pose[itk::PoseYaw] -= 0.03 * shift;
    pose[itk::PoseTz] += shift;
    const auto method = MakeMethodAt(pose);
    method->Update();
    for (unsigned int k = 0; k < 7; ++k)
    {
      EXPECT_NEAR(method->GetOutput()->GetResult().groups[0].parameters[k], Plain().groups[0].parameters[k], 1e-12)
        << "shift " << shift << ", parameter " << k;
    }
  }
}

TEST(PoseRegistrationStart, APlaceThatTheSearchDoesNotFindIsKept)
{
  auto pose = Plain().groups[0].parameters;
  pose[itk::PoseTz] += 60.0;
  const auto method = MakeMethodAt(pose);
  method->Update();
  // The nearest minimum to so far away is one that no search would take, and it is not exchanged for a better one.
  const auto & found = method->GetOutput()->GetResult().groups[0];
  EXPECT_GT(std::abs(found.parameters[itk::PoseTz] - Plain().groups[0].parameters[itk::PoseTz]), 1.0);
  EXPECT_GT(found.score, Plain().groups[0].score + 0.05);
}

TEST(PoseRegistrationStart, AStartOfAnotherGeometryKeepsItsPlaceOnTheRadiograph)
{
  const auto before = PlaceOfTheMiddle(Plain());
  const auto placeUnder = [&](const itk::CephalometricGeometry * initial) {
    const auto method = MakeMethod(AnotherGeometry(), AllHeld());
    BeginAtPlain(method);
    method->SetInitialGeometry(initial);
    method->Update();
    return PlaceOfTheMiddle(method->GetOutput()->GetResult());
  };
  const auto converted = placeUnder(PoseRegistrationTestCase::MakeGeometry(Typical().geometry));
  EXPECT_NEAR(converted[0], before[0], 1e-6);
  EXPECT_NEAR(converted[1], before[1], 1e-6);
  // Without it the same numbers mean another place.
  const auto unconverted = placeUnder(nullptr);
  EXPECT_GT(std::hypot(unconverted[0] - before[0], unconverted[1] - before[1]), 20.0);
}

TEST(PoseRegistrationStart, WhatIsNotKnownIsAsTheStartsGeometryHasItWhereSomethingIsHeld)
{
  const itk::PoseGeometry then = AnotherGeometry();
  itk::PoseGeometry       unknown = Typical().geometry;
  unknown.principalPointKnown = false;
  unknown.pixelSpacingKnown = false;
  const auto method = MakeMethod(unknown, AllHeld());
  BeginAtPlain(method);
  method->SetInitialGeometry(PoseRegistrationTestCase::MakeGeometry(then));
  method->Update();
  const auto & used = method->GetOutput()->GetResult().geometry;
  for (unsigned int d = 0; d < 2; ++d)
  {
    EXPECT_DOUBLE_EQ(used.principalPoint[d], then.principalPoint[d]) << d;
    EXPECT_DOUBLE_EQ(used.pixelSpacing[d], then.pixelSpacing[d]) << d;
  }
  EXPECT_FALSE(used.principalPointKnown);
  EXPECT_FALSE(used.pixelSpacingKnown);
}

TEST(PoseRegistrationStart, WhatIsNotKnownIsEstimatedAsWithoutAStartWhereNothingIsHeld)
{
  itk::PoseGeometry unknown = Typical().geometry;
  unknown.principalPointKnown = false;
  unknown.pixelSpacingKnown = false;
  const auto nothing = MakeMethod(unknown);
  nothing->Update();
  // Another estimate than this drawing gives, as that of a drawing with a tooth more.
  const auto method = MakeMethod(unknown);
  BeginAtPlain(method);
  method->SetInitialGeometry(PoseRegistrationTestCase::MakeGeometry(Typical().geometry));
  method->Update();
  const auto & expected = nothing->GetOutput()->GetResult();
  const auto & found = method->GetOutput()->GetResult();
  for (unsigned int d = 0; d < 2; ++d)
  {
    EXPECT_NE(expected.geometry.pixelSpacing[d], Typical().geometry.pixelSpacing[d]) << d;
    EXPECT_EQ(found.geometry.pixelSpacing[d], expected.geometry.pixelSpacing[d]) << d;
    EXPECT_EQ(found.geometry.principalPoint[d], expected.geometry.principalPoint[d]) << d;
  }
  EXPECT_FALSE(found.geometry.pixelSpacingKnown);
  for (unsigned int k = 0; k < 7; ++k)
  {
    EXPECT_NEAR(found.groups[0].parameters[k], expected.groups[0].parameters[k], 1e-12) << k;
  }
}

TEST(PoseRegistrationStart, TheInitialGeometryIsASettingThatRunsItAgainAndMayFaceNoOtherWay)
{
  const auto method = MakeMethod(Typical().geometry, AllHeld());
  EXPECT_EQ(method->GetInitialGeometry(), nullptr);
  BeginAtPlain(method);
  method->Update();
  const auto before = PlaceOfTheMiddle(method->GetOutput()->GetResult());
  method->SetInitialGeometry(PoseRegistrationTestCase::MakeGeometry(AnotherGeometry()));
  method->Update();
  const auto after = PlaceOfTheMiddle(method->GetOutput()->GetResult());
  EXPECT_GT(std::hypot(after[0] - before[0], after[1] - before[1]), 20.0);
  std::ostringstream text;
  method->Print(text);
  EXPECT_TRUE(Contains(text.str(), "InitialGeometry"));

  auto mirrored = Typical().geometry;
  mirrored.facingSign = -mirrored.facingSign;
  method->SetInitialGeometry(PoseRegistrationTestCase::MakeGeometry(mirrored));
  EXPECT_TRUE(Contains(MessageOfCall([&] { method->Update(); }), "a radiograph that faces another way"));
}
