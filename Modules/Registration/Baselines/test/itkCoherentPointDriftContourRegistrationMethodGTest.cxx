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
#include "itkCoherentPointDriftContourRegistrationMethod.h"

#include "itkSyntheticContours.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{
using MethodType = itk::CoherentPointDriftContourRegistrationMethod;
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

TEST(CoherentPointDriftContourRegistrationMethod, RecoversASimilarityFromTheBoundingBox)
{
  const auto truth = MakeTransform(1.2, 0.15, 310.0, 420.0);
  const auto method = MakeMethod(MakeTracing(truth, 220), MakeSilhouette(220));
  method->Update();
  // The same 220 places but for 0.3 of a step of 3 px.
  EXPECT_LT(LargestDifference(method->GetTransform(), truth), 1.0);
  EXPECT_LT(method->GetMetricValue(), 2.0);
}

TEST(CoherentPointDriftContourRegistrationMethod, RigidKeepsTheScaleOfTheStart)
{
  const auto method = MakeMethod(MakeTracing(MakeTransform(1.1, 0.1, 300.0, 400.0)), MakeSilhouette());
  method->SetMotion(itk::ContourBaselineEnums::Motion::Rigid);
  method->SetInitialTransform(MakeTransform(1.1, 0.0, 290.0, 410.0));
  method->Update();
  EXPECT_EQ(method->GetTransform()->GetScale(), 1.1);
  EXPECT_NEAR(method->GetTransform()->GetAngle(), 0.1, 0.01);
}

TEST(CoherentPointDriftContourRegistrationMethod, BackgroundForgivesOutliers)
{
  const auto truth = MakeTransform(1.0, 0.02, 300.0, 400.0);
  const auto tracing = MakeTracing(truth, 150);
  // Every tenth point somewhere around, more below than above.
  itk::ReproducibleRandom random(3);
  for (unsigned int i = 0; i < 150; i += 10)
  {
    auto point = tracing->GetPoint(i);
    point[0] += random.Uniform(-60.0, 60.0);
    point[1] += random.Uniform(-20.0, 60.0);
    tracing->SetPoint(i, point);
  }
  const auto run = [&](double outlierWeight) {
    const auto method = MakeMethod(tracing, MakeSilhouette(300));
    method->SetInitialTransform(MakeTransform(1.0, 0.0, 302.0, 400.0));
    method->SetOutlierWeight(outlierWeight);
    method->Update();
    return LargestDifference(method->GetTransform(), truth);
  };
  EXPECT_LT(run(0.3), 0.5 * run(0.0));
  EXPECT_LT(run(0.3), 2.0);
}

TEST(CoherentPointDriftContourRegistrationMethod, RepeatsBitByBitEndsOnAbortAndPrintsItself)
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
  std::ostringstream text;
  first->Print(text);
  EXPECT_NE(text.str().find("OutlierWeight: 0"), std::string::npos);
}
