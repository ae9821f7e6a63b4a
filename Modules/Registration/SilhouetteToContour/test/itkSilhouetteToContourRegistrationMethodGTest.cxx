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
#include "itkSilhouetteToContourRegistrationMethod.h"

#include "itkContourChamferMetricv4.h"
#include "itkContourDistanceFilter.h"
#include "itkSyntheticContours.h"

#include "itkAmoebaOptimizerv4.h"
#include "itkConjugateGradientLineSearchOptimizerv4.h"
#include "itkExhaustiveOptimizerv4.h"
#include "itkGradientDescentOptimizerv4.h"
#include "itkLBFGSBOptimizerv4.h"
#include "itkOnePlusOneEvolutionaryOptimizerv4.h"

#include "itkGTest.h"

#include <functional>
#include <sstream>
#include <thread>
#include <typeinfo>

namespace
{
using namespace SyntheticContours;
using MethodType = itk::SilhouetteToContourRegistrationMethod;

MethodType::Pointer
MakeMethod(const ContourType * fixed, const ContourType * moving)
{
  const auto method = MethodType::New();
  method->SetFixedContour(fixed);
  method->SetMovingContour(moving);
  return method;
}

itk::ContourChamferMetricv4::Pointer
MakeSegmentMetric()
{
  const auto metric = itk::ContourChamferMetricv4::New();
  metric->SetDistance(itk::ContourMetricEnums::Distance::PointToSegment);
  return metric;
}

TransformType::Pointer
MakeRandomTransform(itk::ReproducibleRandom & random)
{
  return MakeTransform(std::exp(random.Uniform(-0.3, 0.3)),
                       random.Uniform(-0.3, 0.3),
                       random.Uniform(340.0, 460.0),
                       random.Uniform(440.0, 560.0));
}
} // namespace

TEST(SilhouetteToContourRegistrationMethod, RecoversKnownSimilarityFromFarStart)
{
  // Without noise the answer is exact. From the start of an identity shifted by up to 50 px, not the bounding box.
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    itk::ReproducibleRandom random(seed);
    const auto              truth = MakeRandomTransform(random);
    const auto              method = MakeMethod(MakeTracing(truth, 79), MakeSilhouette());
    method->SetMetric(MakeSegmentMetric());
    method->SetInitialTransform(MakeTransform(1.0,
                                              0.0,
                                              truth->GetOffset()[0] + random.Uniform(-50.0, 50.0),
                                              truth->GetOffset()[1] + random.Uniform(-50.0, 50.0)));
    method->Update();
    // The chords of 79 points cut up to 0.7 px off the cusps, hence no exact zero.
    EXPECT_LT(LargestDifference(method->GetTransform(), truth), 0.5) << "seed " << seed;
  }
}

TEST(SilhouetteToContourRegistrationMethod, PaperPresetRecoversNoisySimilarity)
{
  // The paper's sizes and point-to-point metric; noise of 0.4 px.
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    itk::ReproducibleRandom random(seed);
    const auto              truth = MakeRandomTransform(random);
    const auto              method = MakeMethod(MakeTracing(truth, 79, 0.0, 1.0, 0.4, &random), MakeSilhouette(441));
    method->Update();
    // 0.4 px over 79 points leaves about 0.1 px; the paper's metric quantises to the silhouette's spacing of 1.3 px.
    EXPECT_LT(LargestDifference(method->GetTransform(), truth), 1.0) << "seed " << seed;
    ASSERT_EQ(method->GetLevelResults().size(), 3u);
    for (const auto & result : method->GetLevelResults())
    {
      EXPECT_LE(result.finalValue, result.initialValue);
    }
  }
}

TEST(SilhouetteToContourRegistrationMethod, GlobalPresetFindsWhatThePapersBoundsExclude)
{
  // 34 degrees, where the paper's levels reach 28 in all.
  for (const double angle : { -0.6, 0.6 })
  {
    const auto              truth = MakeTransform(1.2, angle, 340.0, 410.0);
    itk::ReproducibleRandom random(3);
    const auto              method = itk::SilhouetteToContourRegistrationMethod::New();
    method->SetMovingContour(MakeSilhouette(441));
    method->SetFixedContour(MakeTracing(truth, 79, 0.0, 1.0, 0.4, &random));
    method->SetPresetToGlobal();
    method->Update();
    // 0.4 px of noise on 79 points.
    EXPECT_LT(LargestDifference(method->GetTransform(), truth), 1.0);
    method->SetPresetToPaper();
    method->Update();
    EXPECT_GT(LargestDifference(method->GetTransform(), truth), 3.0);
  }
}

TEST(SilhouetteToContourRegistrationMethod, OpenTracingOfAPartIsFoundOneSided)
{
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    itk::ReproducibleRandom random(seed);
    const auto              truth = MakeRandomTransform(random);
    const auto              method = MakeMethod(MakeTracing(truth, 79, 0.02, 0.48, 0.4, &random), MakeSilhouette());
    const auto              metric = MakeSegmentMetric();
    metric->SetDirection(itk::ContourMetricEnums::Direction::FixedToMoving);
    method->SetMetric(metric);
    method->Update();
    found += static_cast<int>(LargestDifference(method->GetTransform(), truth) < 3.0);
  }
  // A part of the outline can lie well in more than one place.
  EXPECT_GE(found, 18);
}

TEST(SilhouetteToContourRegistrationMethod, BoundingBoxStartIsExact)
{
  // Two triangles of hand: boxes 30 x 40 and 3 x 4, centroids (20, 10) and (1, 2).
  const auto make = [](std::vector<std::array<double, 2>> points) {
    std::vector<PointType> list;
    for (const auto & xy : points)
    {
      PointType point;
      point[0] = xy[0];
      point[1] = xy[1];
      list.push_back(point);
    }
    const auto contour = ContourType::New();
    contour->AddPolyline(list);
    return contour;
  };
  const auto fixed = make({ { 10, -10 }, { 40, 10 }, { 10, 30 } });
  const auto moving = make({ { 0, 0 }, { 3, 2 }, { 0, 4 } });
  const auto method = MakeMethod(fixed, moving);
  method->SetPresetToBoundingBox();
  method->Update();
  const auto * transform = method->GetTransform();
  EXPECT_DOUBLE_EQ(transform->GetScale(), 10.0);
  EXPECT_EQ(transform->GetAngle(), 0.0);
  EXPECT_DOUBLE_EQ(transform->GetOffset()[0], 20.0 - 10.0 * 1.0);
  EXPECT_DOUBLE_EQ(transform->GetOffset()[1], 10.0 - 10.0 * 2.0);
  EXPECT_NEAR(method->GetMetricValue(), 0.0, 1e-13);
  EXPECT_TRUE(method->GetLevelResults().empty());
  // A similarity without rotation is undone exactly.
  const auto truth = MakeTransform(1.3, 0.0, 320.0, 410.0);
  const auto moved = ContourType::New();
  for (const auto & polyline : MakeSilhouette()->GetPolylines())
  {
    auto copy = polyline;
    for (auto & point : copy.points)
    {
      point = truth->TransformPoint(point);
    }
    moved->AddPolyline(copy);
  }
  EXPECT_LT(LargestDifference(MethodType::ComputeBoundingBoxTransform(moved, MakeSilhouette()), truth), 1e-10);
}

TEST(SilhouetteToContourRegistrationMethod, ResultStaysWithinTheBounds)
{
  const auto tracing = MakeTracing(MakeTransform(1.3, 0.25, 420.0, 500.0));
  const auto start = MakeTransform(1.0, 0.0, 400.0, 500.0);
  const auto amoeba = itk::AmoebaOptimizerv4::New();
  const auto descent = itk::GradientDescentOptimizerv4::New();
  descent->SetLearningRate(1.0);
  descent->SetNumberOfIterations(80);
  for (MethodType::OptimizerType * optimizer : { static_cast<MethodType::OptimizerType *>(nullptr),
                                                 static_cast<MethodType::OptimizerType *>(amoeba.GetPointer()),
                                                 static_cast<MethodType::OptimizerType *>(descent.GetPointer()) })
  {
    const auto method = MakeMethod(tracing, MakeSilhouette());
    method->SetOptimizer(optimizer);
    method->SetInitialTransform(start);
    method->SetNumberOfLevels(1);
    MethodType::LevelType level;
    level.scaleBound = 0.1;
    level.rotationBound = 0.05;
    level.translationBound = 0.5;
    method->SetLevel(0, level);
    method->SetPixelSpacing(0.1);
    method->Update();
    const auto * transform = method->GetTransform();
    // The truth lies outside of the bounds.
    EXPECT_LE(transform->GetScale(), 1.1 * (1.0 + 1e-12));
    EXPECT_GE(transform->GetScale(), 0.9);
    EXPECT_LE(std::abs(transform->GetAngle()), 0.05 * (1.0 + 1e-12));
    const auto & pivot = method->GetMetric()->GetPivot();
    const auto   shift = transform->TransformPoint(pivot) - start->TransformPoint(pivot);
    EXPECT_LE(std::abs(shift[0]), 5.0 + 1e-9);
    EXPECT_LE(std::abs(shift[1]), 5.0 + 1e-9);
    ASSERT_EQ(method->GetLevelResults().size(), 1u);
    if (optimizer == nullptr)
    {
      EXPECT_EQ(method->GetLevelResults()[0].boundsHit[0], 1);
      // Turned only, the other way.
      method->SetFixedContour(MakeTracing(MakeTransform(1.0, -0.25, 400.0, 500.0)));
      method->Update();
      EXPECT_EQ(method->GetLevelResults()[0].boundsHit[1], -1);
      // Within the bounds.
      method->SetFixedContour(MakeTracing(MakeTransform(1.02, 0.02, 401.0, 501.0)));
      method->Update();
      EXPECT_EQ(method->GetLevelResults()[0].boundsHit, (std::array<int, 4>{ 0, 0, 0, 0 }));
    }
  }
}

TEST(SilhouetteToContourRegistrationMethod, HoldsWhatIsFixed)
{
  const auto tracing = MakeTracing(MakeTransform(1.1, 0.1, 410.0, 490.0));
  const auto start = MakeTransform(1.0, 0.02, 400.0, 500.0);
  const auto method = MakeMethod(tracing, MakeSilhouette());
  method->SetInitialTransform(start);
  method->FixScaleOn();
  method->Update();
  EXPECT_DOUBLE_EQ(method->GetTransform()->GetScale(), 1.0);
  EXPECT_NE(method->GetTransform()->GetAngle(), 0.02);
  method->FixScaleOff();
  method->FixRotationOn();
  method->Update();
  EXPECT_DOUBLE_EQ(method->GetTransform()->GetAngle(), 0.02);
  EXPECT_NE(method->GetTransform()->GetScale(), 1.0);
  method->FixRotationOff();
  method->FixTranslationOn();
  method->Update();
  EXPECT_NEAR(method->GetTransform()->GetOffset()[0], 400.0, 1e-10);
  EXPECT_NEAR(method->GetTransform()->GetOffset()[1], 500.0, 1e-10);
  EXPECT_NE(method->GetTransform()->GetAngle(), 0.02);
  method->FixScaleOn();
  method->FixRotationOn();
  method->Update();
  EXPECT_LT(LargestDifference(method->GetTransform(), start), 1e-10);
}

TEST(SilhouetteToContourRegistrationMethod, EventsComeInOrder)
{
  const auto  method = MakeMethod(MakeTracing(MakeTransform(1.1, 0.1, 410.0, 490.0)), MakeSilhouette());
  std::string sequence;
  float       progress = 0.0f;
  method->AddObserver(itk::AnyEvent(), [&](const itk::EventObject & event) {
    if (typeid(event) == typeid(itk::StartEvent))
    {
      sequence += 'S';
    }
    else if (typeid(event) == typeid(itk::MultiResolutionIterationEvent))
    {
      sequence += static_cast<char>('0' + method->GetCurrentLevel());
      EXPECT_EQ(method->GetOptimizerIteration(), 0u);
      EXPECT_EQ(method->GetOptimizerStopConditionDescription().empty(), method->GetCurrentLevel() == 0);
    }
    else if (typeid(event) == typeid(itk::IterationEvent))
    {
      if (sequence.back() != 'i')
      {
        sequence += 'i';
      }
      EXPECT_GT(method->GetOptimizerIteration(), 0u);
      // What the getters say belongs together.
      const auto position = method->GetOptimizerPosition();
      ASSERT_EQ(position.GetSize(), 4u);
      EXPECT_NEAR(method->GetMetric()->EvaluateAt(method->GetMetric()->GetOptimizerParameters(
                    { position[0], position[1], position[2], position[3] })),
                  method->GetMetricValue(),
                  1e-9);
    }
    else if (typeid(event) == typeid(itk::ProgressEvent))
    {
      EXPECT_GE(method->GetProgress(), progress);
      progress = method->GetProgress();
    }
    else if (typeid(event) == typeid(itk::EndEvent))
    {
      sequence += 'E';
    }
  });
  method->Update();
  // The last levels may converge at once.
  sequence.erase(std::remove(sequence.begin() + 3, sequence.end(), 'i'), sequence.end());
  EXPECT_EQ(sequence, "S0i12E");
  EXPECT_EQ(progress, 1.0f);
  EXPECT_EQ(method->GetCurrentLevel(), 2u);
  EXPECT_FALSE(method->GetOptimizerStopConditionDescription().empty());
}

TEST(SilhouetteToContourRegistrationMethod, AbortStopsPromptlyAndARerunIsComplete)
{
  const auto tracing = MakeTracing(MakeTransform(1.1, 0.1, 410.0, 490.0));
  const auto amoeba = itk::AmoebaOptimizerv4::New();
  const auto descent = itk::GradientDescentOptimizerv4::New();
  descent->SetLearningRate(1.0);
  for (MethodType::OptimizerType * optimizer : { static_cast<MethodType::OptimizerType *>(nullptr),
                                                 static_cast<MethodType::OptimizerType *>(amoeba.GetPointer()),
                                                 static_cast<MethodType::OptimizerType *>(descent.GetPointer()) })
  {
    const auto method = MakeMethod(tracing, MakeSilhouette());
    method->SetOptimizer(optimizer);
    int  iterations = 0;
    bool aborted = false;
    bool ended = false;
    method->AddObserver(itk::AbortEvent(), [&](const itk::EventObject &) { aborted = true; });
    method->AddObserver(itk::EndEvent(), [&](const itk::EventObject &) { ended = true; });
    const auto tag = method->AddObserver(itk::IterationEvent(), [&](const itk::EventObject & event) {
      iterations += static_cast<int>(typeid(event) == typeid(itk::IterationEvent));
      if (iterations == 3)
      {
        method->AbortGenerateDataOn();
      }
    });
    EXPECT_THROW(method->Update(), itk::ProcessAborted);
    EXPECT_EQ(iterations, 3);
    EXPECT_TRUE(aborted);
    EXPECT_FALSE(ended);
    EXPECT_NE(method->GetOptimizerStopConditionDescription().find("Aborted"), std::string::npos);
    EXPECT_TRUE(method->GetLevelResults().empty());
    method->RemoveObserver(tag);
    method->Update();
    EXPECT_TRUE(ended);
    EXPECT_EQ(method->GetLevelResults().size(), 3u);
  }
  // Already during the candidates.
  const auto method = MakeMethod(tracing, MakeSilhouette());
  method->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    if (method->GetProgress() > 0.0f)
    {
      method->AbortGenerateDataOn();
    }
  });
  EXPECT_THROW(method->Update(), itk::ProcessAborted);
  EXPECT_EQ(method->GetOptimizerIteration(), 0u);
}

TEST(SilhouetteToContourRegistrationMethod, RerunAndThreadsGiveTheSameBits)
{
  itk::ReproducibleRandom random(3);
  const auto              tracing = MakeTracing(MakeTransform(1.1, 0.1, 410.0, 490.0), 79, 0.0, 1.0, 0.5, &random);
  for (const bool evolutionary : { false, true })
  {
    MethodType::ParametersType first;
    for (const unsigned int threads : { 1u, 1u, 2u, 5u })
    {
      itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
      const auto method = MakeMethod(tracing, MakeSilhouette());
      method->SetNumberOfWorkUnits(threads);
      if (evolutionary)
      {
        method->SetOptimizer(itk::OnePlusOneEvolutionaryOptimizerv4<double>::New());
      }
      for (int run = 0; run < 2; ++run)
      {
        method->Modified();
        method->Update();
        if (first.GetSize() == 0)
        {
          first = method->GetTransform()->GetParameters();
        }
        EXPECT_EQ(method->GetTransform()->GetParameters(), first);
      }
    }
  }
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(itk::MultiThreaderBase::GetGlobalMaximumNumberOfThreads());
}

TEST(SilhouetteToContourRegistrationMethod, AnyV4OptimizerImproves)
{
  const auto truth = MakeTransform(1.05, 0.08, 404.0, 497.0);
  const auto start = MakeTransform(1.0, 0.0, 400.0, 500.0);
  const auto tracing = MakeTracing(truth);
  const auto silhouette = MakeSilhouette();

  const auto lbfgsb = itk::LBFGSBOptimizerv4::New();
  const auto amoeba = itk::AmoebaOptimizerv4::New();
  const auto descent = itk::GradientDescentOptimizerv4::New();
  descent->SetLearningRate(0.5);
  descent->SetNumberOfIterations(60);
  const auto conjugate = itk::ConjugateGradientLineSearchOptimizerv4::New();
  conjugate->SetNumberOfIterations(20);
  conjugate->SetLowerLimit(0.0);
  conjugate->SetUpperLimit(5.0);
  conjugate->SetMaximumLineSearchIterations(15);
  const auto evolutionary = itk::OnePlusOneEvolutionaryOptimizerv4<double>::New();
  evolutionary->SetMaximumIteration(300);
  const auto                                    exhaustive = itk::ExhaustiveOptimizerv4<double>::New();
  itk::ExhaustiveOptimizerv4<double>::StepsType steps(4);
  steps.Fill(2);
  exhaustive->SetNumberOfSteps(steps);
  exhaustive->SetStepLength(0.5);

  for (MethodType::OptimizerType * optimizer : { static_cast<MethodType::OptimizerType *>(lbfgsb.GetPointer()),
                                                 static_cast<MethodType::OptimizerType *>(amoeba.GetPointer()),
                                                 static_cast<MethodType::OptimizerType *>(descent.GetPointer()),
                                                 static_cast<MethodType::OptimizerType *>(conjugate.GetPointer()),
                                                 static_cast<MethodType::OptimizerType *>(evolutionary.GetPointer()),
                                                 static_cast<MethodType::OptimizerType *>(exhaustive.GetPointer()) })
  {
    const auto method = MakeMethod(tracing, silhouette);
    method->SetOptimizer(optimizer);
    method->SetInitialTransform(start);
    method->SetNumberOfLevels(2);
    MethodType::LevelType level;
    level.scaleBound = 0.12;
    level.rotationBound = 0.15;
    level.translationBound = 4.0;
    method->SetLevel(0, level);
    level.scaleBound = 0.05;
    level.rotationBound = 0.05;
    level.translationBound = 1.5;
    method->SetLevel(1, level);
    int iterations = 0;
    method->AddObserver(itk::IterationEvent(), [&](const itk::EventObject & event) {
      iterations += static_cast<int>(typeid(event) == typeid(itk::IterationEvent));
    });
    method->Update();
    const auto & results = method->GetLevelResults();
    EXPECT_LT(results.back().finalValue, 0.5 * results.front().initialValue) << optimizer->GetNameOfClass();
    EXPECT_LE(results[0].finalValue, results[0].initialValue);
    EXPECT_LE(results[1].finalValue, results[1].initialValue);
    EXPECT_LT(LargestDifference(method->GetTransform(), truth), 0.5 * LargestDifference(start, truth))
      << optimizer->GetNameOfClass();
    EXPECT_GT(iterations, 3) << optimizer->GetNameOfClass();
    EXPECT_FALSE(results[0].stopConditionDescription.empty()) << optimizer->GetNameOfClass();
  }
  // The method gives an optimizer back as it was.
  EXPECT_TRUE(amoeba->GetAutomaticInitialSimplex());
  EXPECT_FALSE(exhaustive->GetScalesInitialized());
  EXPECT_EQ(descent->GetNumberOfIterations(), 60u);
}

TEST(SilhouetteToContourRegistrationMethod, SingleStageStopsAt80Iterations)
{
  itk::ReproducibleRandom random(5);
  const auto              truth = MakeTransform(1.1, 0.1, 410.0, 490.0);
  const auto              method = MakeMethod(MakeTracing(truth, 79, 0.02, 0.48, 2.0, &random), MakeSilhouette());
  const auto              descent = itk::GradientDescentOptimizerv4::New();
  descent->SetLearningRate(1e-3);
  method->SetPresetToSingleStage();
  method->SetOptimizer(descent);
  method->Update();
  ASSERT_EQ(method->GetLevelResults().size(), 1u);
  EXPECT_EQ(method->GetLevelResults()[0].numberOfIterations, 80u);
  EXPECT_EQ(method->GetLevelResults()[0].numberOfCandidates, 0u);
  method->SetOptimizer(nullptr);
  method->Update();
  EXPECT_LE(method->GetLevelResults()[0].numberOfIterations, 80u);
  EXPECT_LT(method->GetLevelResults()[0].finalValue, method->GetLevelResults()[0].initialValue);
}

TEST(SilhouetteToContourRegistrationMethod, FewPointsAreEnough)
{
  for (const std::size_t count : { 2u, 3u, 5u, 8u })
  {
    const auto truth = MakeTransform(1.1, 0.1, 410.0, 490.0);
    const auto method = MakeMethod(MakeTracing(truth, count), MakeSilhouette(count));
    method->Update();
    EXPECT_LE(method->GetMetricValue(), method->GetLevelResults().front().initialValue);
    EXPECT_TRUE(std::isfinite(method->GetMetricValue()));
  }
}

TEST(SilhouetteToContourRegistrationMethod, SaysWhatIsMissing)
{
  const auto expect = [](MethodType * method, const char * remedy) {
    try
    {
      method->Update();
      FAIL() << remedy;
    }
    catch (const itk::ExceptionObject & error)
    {
      EXPECT_NE(std::string(error.GetDescription()).find(remedy), std::string::npos) << error.GetDescription();
    }
  };
  const auto method = MethodType::New();
  expect(method, "SetFixedContour()");
  method->SetFixedContour(MakeSilhouette());
  expect(method, "SetMovingContour()");
  method->SetMovingContour(ContourType::New());
  expect(method, "no point of positive weight");
  method->SetMovingContour(MakeSilhouette(0));
  expect(method, "no point of positive weight");
  const auto single = ContourType::New();
  single->AddPolyline(std::vector<PointType>(1));
  method->SetMovingContour(single);
  expect(method, "two distinct points");
  method->SetMovingContour(MakeSilhouette());
  method->Update();
  EXPECT_THROW(method->SetPixelSpacing(0.0), itk::ExceptionObject);
  EXPECT_THROW(method->GetLevel(3), itk::ExceptionObject);
  MethodType::LevelType level = method->GetLevel(0);
  level.scaleBound = 1.0;
  EXPECT_THROW(method->SetLevel(0, level), itk::ExceptionObject);
  const auto exhaustive = itk::ExhaustiveOptimizerv4<double>::New();
  method->SetOptimizer(exhaustive);
  expect(method, "SetNumberOfSteps()");
}

TEST(SilhouetteToContourRegistrationMethod, ChangesRunOnlyWhatLiesDownstream)
{
  const auto registration = MakeMethod(MakeTracing(MakeTransform(1.1, 0.1, 410.0, 490.0)), MakeSilhouette());
  const auto metric = MakeSegmentMetric();
  registration->SetMetric(metric);
  const auto distances = itk::ContourDistanceFilter::New();
  distances->SetFixedContour(registration->GetFixedContour());
  distances->SetMovingContour(registration->GetMovingContour());
  distances->SetTransformInput(registration->GetOutput());
  int registrations = 0;
  int measurements = 0;
  registration->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++registrations; });
  distances->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++measurements; });
  const auto expect = [&](int expectedRegistrations, int expectedMeasurements) {
    distances->Update();
    distances->Update();
    EXPECT_EQ(registrations, expectedRegistrations);
    EXPECT_EQ(measurements, expectedMeasurements);
  };
  expect(1, 1);
  distances->SetDistance(itk::ContourMetricEnums::Distance::PointToSegment);
  expect(1, 2);
  EXPECT_NEAR(
    distances->GetMovingToFixedMean() + distances->GetFixedToMovingMean(), registration->GetMetricValue(), 1e-9);
  registration->FixScaleOn();
  expect(2, 3);
  metric->SetTruncation(20.0);
  expect(3, 4);
  registration->GetOptimizer()->SetNumberOfIterations(7);
  expect(4, 5);
}

TEST(SilhouetteToContourRegistrationMethod, LevelsAreAddedAndRemoved)
{
  const auto method = MethodType::New();
  ASSERT_EQ(method->GetNumberOfLevels(), 3u);
  method->SetNumberOfLevels(4);
  EXPECT_DOUBLE_EQ(method->GetLevel(3).scaleBound, 0.015);
  EXPECT_DOUBLE_EQ(method->GetLevel(3).translationBound, 0.5);
  EXPECT_DOUBLE_EQ(method->GetLevel(0).scaleBound, 0.35);
  method->SetNumberOfLevels(1);
  EXPECT_DOUBLE_EQ(method->GetLevel(0).translationBound, 15.0);
  method->SetPresetToPaper();
  // 60, 15 and 4 px of 0.25 mm.
  EXPECT_DOUBLE_EQ(method->GetLevel(0).translationBound / method->GetPixelSpacing(), 60.0);
  EXPECT_DOUBLE_EQ(method->GetLevel(1).translationBound / method->GetPixelSpacing(), 15.0);
  EXPECT_DOUBLE_EQ(method->GetLevel(2).translationBound / method->GetPixelSpacing(), 4.0);
  std::ostringstream text;
  method->Print(text);
  EXPECT_NE(text.str().find("PixelSpacing: 0.25"), std::string::npos);
}

TEST(SilhouetteToContourRegistrationMethod, MethodsAtTheSameTimeDoNotDisturbEachOther)
{
  // ITK's LBFGSB has static state.
  const auto run = [](int i) {
    const auto truth = MakeTransform(1.0 + 0.02 * i, 0.01 * i, 300.0, 400.0 + i);
    const auto method = MethodType::New();
    method->SetFixedContour(MakeTracing(truth));
    method->SetMovingContour(MakeSilhouette());
    method->Update();
    return method->GetTransform()->GetParameters();
  };
  constexpr int                              Count = 8;
  std::vector<TransformType::ParametersType> alone;
  for (int i = 0; i < Count; ++i)
  {
    alone.push_back(run(i));
  }
  std::vector<TransformType::ParametersType> together(Count);
  std::vector<std::thread>                   threads;
  for (int t = 0; t < 4; ++t)
  {
    threads.emplace_back([&, t]() {
      for (int i = t; i < Count; i += 4)
      {
        together[i] = run(i);
      }
    });
  }
  for (std::thread & thread : threads)
  {
    thread.join();
  }
  for (int i = 0; i < Count; ++i)
  {
    EXPECT_EQ(together[i], alone[i]);
  }
}
