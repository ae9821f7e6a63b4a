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

#include "itkOpenSilhouetteContourSource.h"
#include "itkPoseMeshContourModel.h"
#include "itkPoseRegistrationOptionTable.h"
#include "itkPoseRegistrationTestCase.h"
#include "itkRegistrationVerdictFilter.h"

#include "itkCommand.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace
{
using Source = itk::DentalPhantomCaseSource;
using MethodType = itk::PoseRegistrationMethod<>;
using JawEnum = MethodType::JawEnum;
constexpr JawEnum Jaws[] = { JawEnum::Upper, JawEnum::Lower };

Source *
Case()
{
  static const Source::Pointer source = [] {
    auto s = Source::New();
    s->SetSeed(73);
    s->SetNumberOfTriangles(16000);
    s->MakeRadiographOff();
    s->Update();
    return s;
  }();
  return source;
}

MethodType::Pointer
Method()
{
  auto method = MethodType::New();
  method->SetUpperMesh(Case()->GetMesh(0));
  method->SetLowerMesh(Case()->GetMesh(1));
  method->SetUpperContour(Case()->GetTracing(0));
  method->SetLowerContour(Case()->GetTracing(1));
  method->SetGeometry(Case()->GetNominalGeometry());
  return method;
}
} // namespace

TEST(PoseRegistrationMethod, BasicObject)
{
  auto method = MethodType::New();
  EXPECT_STREQ(method->GetNameOfClass(), "PoseRegistrationMethod");
  EXPECT_STREQ(method->Superclass::GetNameOfClass(), "PoseRegistrationMethodBase");
  EXPECT_STREQ(method->Superclass::Superclass::GetNameOfClass(), "ProcessObject");
  std::ostringstream text;
  method->Print(text);
  EXPECT_NE(text.str().find("PrincipalPointKnown: 1"), std::string::npos);
  for (const auto & entry : itk::PoseRegistrationOptionTable::GetEntries())
  {
    EXPECT_NE(text.str().find(entry.name + ": "), std::string::npos) << entry.name;
  }
}

TEST(PoseRegistrationMethod, AJawThatWasNotRegisteredIsNotSaidToLackCodes)
{
  itk::PoseRegistrationResult result;
  result.jaws.resize(1);
  const auto saysNoCodes = [&]() {
    const auto lines = itk::RegistrationVerdict::GetNotCheckable(result, itk::PoseRegistrationOptions());
    return std::any_of(lines.begin(), lines.end(), [](const std::string & line) {
      return line.find("no tooth codes") != std::string::npos;
    });
  };
  EXPECT_FALSE(saysNoCodes());
  result.jaws[0].registered = true;
  // Landmarks alone placed it: there is no tracing that could have codes.
  EXPECT_FALSE(saysNoCodes());
  result.jaws[0].fit.numberOfPoints = 80;
  EXPECT_TRUE(saysNoCodes());
  result.jaws[0].fit.hasCodes = true;
  EXPECT_FALSE(saysNoCodes());
}

TEST(PoseRegistrationMethod, RegistersMeshesAsTheyAreAndItsOutputsAgree)
{
  auto         method = Method();
  unsigned int levels = 0;
  auto         command = itk::CStyleCommand::New();
  command->SetClientData(&levels);
  command->SetCallback(
    [](itk::Object *, const itk::EventObject &, void * data) { ++*static_cast<unsigned int *>(data); });
  method->AddObserver(itk::MultiResolutionIterationEvent(), command);
  method->Update();
  EXPECT_EQ(levels, 4u);
  EXPECT_TRUE(method->GetJawsShareFrame());
  auto verdicts = itk::RegistrationVerdictFilter::New();
  verdicts->SetSolution(method->GetOutput());
  verdicts->Update();
  for (unsigned int j : { 0u, 1u })
  {
    const JawEnum jaw = Jaws[j];
    EXPECT_EQ(verdicts->GetVerdict(jaw).status, itk::RegistrationVerdict::StatusEnum::Ok);
    const auto & p = method->GetOutput()->GetResult().jaws[j].projection;
    double       sum = 0.0;
    const auto & landmarks = Case()->GetLandmarks2D(j)->GetLandmarks();
    for (const auto & landmark : landmarks)
    {
      const auto   x = Case()->GetLandmarks3D(j)->Find(landmark.name)->point;
      const auto   q = method->GetGeometryOutput(jaw)->ProjectPoint(x);
      const double w = p[8] * x[0] + p[9] * x[1] + p[10] * x[2] + p[11];
      EXPECT_NEAR(q[0], (p[0] * x[0] + p[1] * x[1] + p[2] * x[2] + p[3]) / w, 1e-6);
      EXPECT_NEAR(q[1], (p[4] * x[0] + p[5] * x[1] + p[6] * x[2] + p[7]) / w, 1e-6);
      const auto c = method->GetTransform(jaw)->TransformPoint(x);
      EXPECT_LT(c.EuclideanDistanceTo(method->GetGeometryOutput(jaw)->TransformToCephalostat(x)), 1e-6);
      sum += std::hypot(q[0] - landmark.point[0], q[1] - landmark.point[1]);
      const auto covariance = method->GetOutput()->ComputeCovariance(jaw, x);
      EXPECT_GT(covariance(0, 0), 0.0);
      EXPECT_GT(covariance(0, 0) * covariance(1, 1), covariance(0, 1) * covariance(1, 0));
    }
    EXPECT_LT(sum / landmarks.size(), 2.0);
  }
  // Nothing changed: nothing runs.
  const auto time = method->GetTransformOutput(JawEnum::Upper)->GetUpdateMTime();
  method->Update();
  EXPECT_EQ(time, method->GetTransformOutput(JawEnum::Upper)->GetUpdateMTime());
}

TEST(PoseRegistrationMethod, SaysWhatToCallWhereInputIsMissing)
{
  auto method = MethodType::New();
  method->SetGeometry(Case()->GetNominalGeometry());
  method->SetUpperMesh(Case()->GetMesh(0));
  try
  {
    method->Update();
    FAIL() << "no exception";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.what()).find("SetUpperContour()"), std::string::npos);
  }
}

TEST(PoseRegistrationMethod, AJawWithoutInputHasNoTransform)
{
  auto method = MethodType::New();
  method->SetGeometry(Case()->GetNominalGeometry());
  method->SetLowerMesh(Case()->GetMesh(1));
  method->SetLowerContour(Case()->GetTracing(1));
  method->Update();
  EXPECT_EQ(method->GetTransform(JawEnum::Upper), nullptr);
  EXPECT_NE(method->GetTransform(JawEnum::Lower), nullptr);
  EXPECT_EQ(method->GetOutput()->GetIndex(JawEnum::Upper), -1);
  EXPECT_THROW(method->GetOutput()->ComputeCovariance(JawEnum::Upper, itk::PoseSolution::PointType()),
               itk::ExceptionObject);
}

TEST(PoseRegistrationMethod, AbortEndsInProcessAborted)
{
  auto method = Method();
  auto command = itk::CStyleCommand::New();
  command->SetClientData(method.GetPointer());
  command->SetCallback([](itk::Object *, const itk::EventObject &, void * data) {
    static_cast<MethodType *>(data)->AbortGenerateDataOn();
  });
  method->AddObserver(itk::MultiResolutionIterationEvent(), command);
  EXPECT_THROW(method->Update(), itk::ProcessAborted);
}

TEST(PoseRegistrationMethod, ItsMovingContourIsThatOfTheFilter)
{
  using ContourType = itk::OpenSilhouetteContourSource<MethodType::MeshType>;
  const itk::TriangleSurface surface = itk::MakeTriangleSurface(Case()->GetMesh(1));
  itk::PoseGeometry          poseGeometry;
  poseGeometry.facingSign = -1.0;
  poseGeometry.pixelSpacing = { { 0.2, 0.3 } };
  poseGeometry.principalPoint = { { 100.0, 200.0 } };
  const itk::PoseModel   pose(poseGeometry, { { 0.15, 0.03, -0.05, 20.0, 1.0, -30.0, 0.0 } });
  const itk::PoseContour expected =
    itk::PoseMeshContourModel(surface, itk::ToothCode::JawEnum::Lower, true).Compute(pose);

  auto geometry = itk::CephalometricGeometry::New();
  geometry->SetFacing(itk::CephalometricGeometry::FacingEnum::Left);
  itk::CephalometricGeometry::PixelSpacingType spacing;
  itk::CephalometricGeometry::PixelIndexType   principal;
  itk::CephalometricGeometry::RotationType     rotation;
  itk::CephalometricGeometry::VectorType       translation;
  for (unsigned int d = 0; d < 2; ++d)
  {
    spacing[d] = poseGeometry.pixelSpacing[d];
    principal[d] = poseGeometry.principalPoint[d];
  }
  for (unsigned int d = 0; d < 3; ++d)
  {
    translation[d] = pose.GetParameters()[itk::PoseTx + d];
    for (unsigned int k = 0; k < 3; ++k)
    {
      rotation(d, k) = pose.GetRotation()[3 * d + k];
    }
  }
  geometry->SetPixelSpacing(spacing);
  geometry->SetPrincipalPoint(principal);
  geometry->SetPose(rotation, translation);
  auto source = ContourType::New();
  source->SetInput(Case()->GetMesh(1));
  source->SetGeometry(geometry);
  source->SetJaw(ContourType::JawEnum::Lower);
  source->Update();
  std::size_t i = 0;
  std::size_t lone = 0;
  for (std::size_t r = 0; r < expected.runs.size(); ++r)
  {
    lone += (r + 1 < expected.runs.size() ? expected.runs[r + 1] : expected.Size()) - expected.runs[r] == 1 ? 1 : 0;
  }
  ASSERT_EQ(lone, 0u);
  ASSERT_GT(expected.Size(), 500u);
  ASSERT_EQ(source->GetOutput()->GetNumberOfPoints(), expected.Size());
  for (const auto & polyline : source->GetOutput()->GetPolylines())
  {
    for (const auto & point : polyline.points)
    {
      const auto pixel = itk::PoseModel::ToPixel(poseGeometry, { { expected.u[i], expected.v[i] } });
      // Both round to a grid of 2^-18 px; the samples slide along by as little.
      EXPECT_NEAR(point[0], pixel[0], 1e-3);
      EXPECT_NEAR(point[1], pixel[1], 1e-3);
      ++i;
    }
  }
}
