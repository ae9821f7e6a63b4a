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
#include "itkIterativeClosestPointContourRegistrationMethod.h"

#include "itkRegistrationIterationCommand.h"
#include "itkSyntheticContours.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{
using MethodType = itk::IterativeClosestPointContourRegistrationMethod;
using namespace SyntheticContours;

MethodType::Pointer
MakeMethod(const ContourType * fixed, const ContourType * moving)
{
  auto method = MethodType::New();
  method->SetFixedContour(fixed);
  method->SetMovingContour(moving);
  return method;
}
} // namespace

TEST(IterativeClosestPointContourRegistrationMethod, RecoversASimilarityWherePointsHavePartners)
{
  const auto silhouette = MakeSilhouette(2000);
  const auto truth = MakeTransform(1.05, 0.04, 310.0, 420.0);
  const auto tracing = MakeTracing(truth, 100);
  const auto method = MakeMethod(tracing, silhouette);
  method->SetInitialTransform(MakeTransform(1.03, 0.03, 312.0, 419.0));
  method->SetMaximumNumberOfIterations(1000);
  method->Update();
  // Vertices are 0.4 px apart: the tracing's points lie between them.
  EXPECT_LT(LargestDifference(method->GetTransform(), truth), 0.2);
}

TEST(IterativeClosestPointContourRegistrationMethod, RigidKeepsTheScaleOne)
{
  const auto method = MakeMethod(MakeTracing(MakeTransform(1.2, 0.1, 300.0, 400.0)), MakeSilhouette());
  method->SetMotion(itk::ContourBaselineEnums::Motion::Rigid);
  method->Update();
  EXPECT_EQ(method->GetTransform()->GetScale(), 1.0);
  EXPECT_NE(method->GetTransform()->GetAngle(), 0.0);
}

TEST(IterativeClosestPointContourRegistrationMethod, PlainValueNeverGrows)
{
  const auto method = MakeMethod(MakeTracing(MakeTransform(1.1, 0.1, 300.0, 400.0)), MakeSilhouette());
  const auto observer = itk::RegistrationIterationCommand::New();
  observer->Observe(method);
  method->Update();
  double       last = 1e300;
  unsigned int iterations = 0;
  for (const auto & record : observer->GetRecords())
  {
    if (record.kind == itk::RegistrationIterationCommand::KindEnum::Iteration)
    {
      EXPECT_LE(record.value, last * (1.0 + 1e-12));
      last = record.value;
      ++iterations;
    }
  }
  EXPECT_GT(iterations, 2u);
  EXPECT_NE(method->GetOptimizerStopConditionDescription().find("Converged"), std::string::npos);
}

TEST(IterativeClosestPointContourRegistrationMethod, TrimmingForgivesOutliers)
{
  const auto silhouette = MakeSilhouette(1000);
  const auto truth = MakeTransform(1.0, 0.02, 300.0, 400.0);
  const auto tracing = MakeTracing(truth, 100);
  // A fifth of the tracing 25 px away.
  for (unsigned int i = 0; i < 20; ++i)
  {
    auto point = tracing->GetPoint(i);
    point[1] += 25.0;
    tracing->SetPoint(i, point);
  }
  const auto run = [&](double fraction) {
    const auto method = MakeMethod(tracing, silhouette);
    method->SetInitialTransform(MakeTransform(1.0, 0.0, 302.0, 400.0));
    method->SetTrimmedFraction(fraction);
    method->SetMaximumNumberOfIterations(500);
    method->Update();
    return LargestDifference(method->GetTransform(), truth);
  };
  EXPECT_LT(run(0.3), 0.5 * run(0.0));
  EXPECT_LT(run(0.3), 1.0);
}

TEST(IterativeClosestPointContourRegistrationMethod, RepeatsBitByBitAndEndsOnAbort)
{
  const auto fixed = MakeTracing(MakeTransform(1.1, 0.1, 300.0, 400.0));
  const auto first = MakeMethod(fixed, MakeSilhouette());
  const auto second = MakeMethod(fixed, MakeSilhouette());
  second->SetNumberOfWorkUnits(4);
  first->Update();
  second->Update();
  EXPECT_EQ(first->GetTransform()->GetParameters(), second->GetTransform()->GetParameters());

  const auto third = MakeMethod(fixed, MakeSilhouette());
  third->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) { third->AbortGenerateDataOn(); });
  EXPECT_THROW(third->Update(), itk::ProcessAborted);
}

TEST(IterativeClosestPointContourRegistrationMethod, SaysWhatIsMissingAndPrintsItself)
{
  const auto method = MethodType::New();
  try
  {
    method->Update();
    FAIL();
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("SetFixedContour"), std::string::npos);
  }
  std::ostringstream text;
  method->Print(text);
  EXPECT_NE(text.str().find("TrimmedFraction: 0"), std::string::npos);
  EXPECT_NE(text.str().find("Motion: Similarity"), std::string::npos);
}
