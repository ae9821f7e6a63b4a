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
#include "itkPoseRegistrationTestCase.h"

#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkOtherSideHypothesis.h"
#include "itkPoseStartSearch.h"
#include "itkRegistrationIterationCommand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <typeinfo>
#include <vector>

// What a registration tells while it runs, and how it is stopped.
namespace
{
using Source = itk::DentalPhantomCaseSource;
using MethodType = PoseRegistrationTestCase::MethodType;
using OptimizerType = itk::LevenbergMarquardtOptimizerv4;
using IterationType = MethodType::IterationType;

const PoseRegistrationTestCase &
Typical()
{
  static const PoseRegistrationTestCase typical(71, Source::CohortEnum::Typical, Source::TracedSideEnum::Right);
  return typical;
}

/** The patient said to face the other way: a poor fit, so that every hypothesis is tried. */
itk::PoseGeometry
WrongFacing()
{
  itk::PoseGeometry geometry = Typical().geometry;
  geometry.facingSign = -1.0;
  return geometry;
}

MethodType::Pointer
MakeMethod(const itk::PoseGeometry & geometry, bool jointPose = true, unsigned int threads = 2)
{
  itk::PoseRegistrationOptions options;
  options.useJointPose = jointPose;
  options.numberOfThreads = threads;
  return PoseRegistrationTestCase::MakeMethod(Typical().jaws, geometry, options);
}

OptimizerType *
OptimizerOf(MethodType * method)
{
  return dynamic_cast<OptimizerType *>(method->GetModifiableOptimizer());
}

/** CPU seconds of this process: not those that it waits for others on a busy machine. */
double
CpuTime()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/** Of a whole registration with hypotheses. */
double
WholeRun()
{
  static const double seconds = [] {
    const auto   method = MakeMethod(WrongFacing());
    const double start = CpuTime();
    method->Update();
    return CpuTime() - start;
  }();
  return seconds;
}

/** A level's event is an iteration's by inheritance: ITK has it so. */
bool
IsIteration(const itk::EventObject & event)
{
  return typeid(event) == typeid(itk::IterationEvent);
}

/** Everything that is told by all three that tell something. */
struct Recorder
{
  std::vector<IterationType> iterations;
  std::vector<unsigned int>  levelOfIteration;
  std::vector<unsigned int>  levels;
  std::size_t                ofOptimizer{ 0 };
  std::size_t                ofMetric{ 0 };
  bool                       isInCallingThread{ true };
  bool                       agrees{ true };

  explicit Recorder(MethodType * method)
  {
    const std::thread::id caller = std::this_thread::get_id();
    method->AddObserver(itk::MultiResolutionIterationEvent(), [=](const itk::EventObject &) {
      isInCallingThread = isInCallingThread && std::this_thread::get_id() == caller;
      levels.push_back(method->GetCurrentLevel());
      // Each group has a metric of its own.
      if (method->GetCurrentLevel() % 4 == 0)
      {
        itk::LeastSquaresSumMetricv4 * metric = method->GetModifiableMetric();
        metric->AddObserver(itk::IterationEvent(), [=](const itk::EventObject &) {
          isInCallingThread = isInCallingThread && std::this_thread::get_id() == caller;
          ++ofMetric;
          const auto pose = metric->GetBlockValues("pose");
          const auto position = method->GetOptimizerPosition();
          for (unsigned int k = 0; k < 6; ++k)
          {
            agrees = agrees && pose[k] == position[k];
          }
          agrees = agrees && metric->GetBlockValues("scale")[0] == position[6];
        });
      }
    });
    OptimizerType * optimizer = OptimizerOf(method);
    optimizer->AddObserver(itk::IterationEvent(), [=](const itk::EventObject &) {
      isInCallingThread = isInCallingThread && std::this_thread::get_id() == caller;
      ++ofOptimizer;
      const auto   last = optimizer->GetLastIteration();
      const auto & step = method->GetCurrentIteration().step;
      agrees = agrees && last.value == step.value && last.trialValue == step.trialValue &&
               last.accepted == step.accepted && last.position == step.position;
    });
    method->AddObserver(itk::IterationEvent(), [=](const itk::EventObject & event) {
      if (!IsIteration(event))
      {
        return;
      }
      isInCallingThread = isInCallingThread && std::this_thread::get_id() == caller;
      iterations.push_back(method->GetCurrentIteration());
      levelOfIteration.push_back(method->GetCurrentLevel());
      agrees = agrees && method->GetMetricValue() == method->GetCurrentIteration().step.value &&
               method->GetOptimizerIteration() == method->GetCurrentIteration().step.iteration;
    });
  }
  Recorder(const Recorder &) = delete;
};
} // namespace

TEST(PoseRegistrationEvents, MethodOptimizerAndMetricTellTheSameInTheCallingThread)
{
  for (const unsigned int threads : { 1u, 3u })
  {
    const auto method = MakeMethod(WrongFacing(), true, threads);
    Recorder   recorder(method);
    EXPECT_EQ(method->GetMetric(), nullptr) << "before the first group";
    method->Update();
    EXPECT_TRUE(recorder.isInCallingThread);
    EXPECT_TRUE(recorder.agrees);
    EXPECT_GT(recorder.iterations.size(), 100u);
    EXPECT_EQ(recorder.ofOptimizer, recorder.iterations.size());
    // The metric is the group's: a hypothesis has another.
    const auto ofHypotheses = static_cast<std::size_t>(
      std::count_if(recorder.iterations.begin(), recorder.iterations.end(), [](const IterationType & iteration) {
        return iteration.hypothesis;
      }));
    EXPECT_GT(ofHypotheses, 20u);
    EXPECT_EQ(recorder.ofMetric + ofHypotheses, recorder.iterations.size());
  }
}

TEST(PoseRegistrationEvents, ValueFallsByEveryAcceptedStepOfARun)
{
  const auto method = MakeMethod(Typical().geometry);
  Recorder   recorder(method);
  method->Update();
  // Runs of the optimizer are told apart by their candidate and by the count of what was tried, which begins anew.
  std::map<std::tuple<bool, itk::PoseStageEnum, unsigned int>, IterationType> last;
  std::size_t                                                                 compared = 0;
  for (const IterationType & iteration : recorder.iterations)
  {
    const auto & step = iteration.step;
    ASSERT_GE(step.evaluations, 1u);
    ASSERT_LE(step.iteration, step.evaluations);
    EXPECT_GT(iteration.kernelWidth, 0.0);
    EXPECT_GT(iteration.noise.white, 0.0);
    if (step.accepted)
    {
      EXPECT_EQ(step.trialValue, step.value);
    }
    else
    {
      EXPECT_FALSE(step.trialValue < step.value);
    }
    auto &       former = last[{ iteration.hypothesis, iteration.stage, iteration.candidate }];
    const auto & before = former.step;
    // An accepted step ends a run of the optimizer, and the next one has another criterion: kernel and noise move on.
    if (before.evaluations > 0 && before.evaluations + 1 == step.evaluations && !before.accepted &&
        former.kernelWidth == iteration.kernelWidth && former.noise.smooth == iteration.noise.smooth)
    {
      ++compared;
      EXPECT_EQ(step.accepted, step.value < before.value);
      EXPECT_EQ(step.iteration, before.iteration + (step.accepted ? 1 : 0));
      if (!step.accepted)
      {
        EXPECT_EQ(step.position, before.position) << "a rejected step leaves the best position";
      }
    }
    former = iteration;
  }
  EXPECT_GT(compared, 20u);
}

TEST(PoseRegistrationEvents, LevelsAreFourAGroupAndNeverRepeat)
{
  for (const bool joint : { true, false })
  {
    const auto method = MakeMethod(Typical().geometry, joint);
    Recorder   recorder(method);
    method->Update();
    std::vector<unsigned int> expected{ 0, 1, 2, 3 };
    if (!joint)
    {
      expected.insert(expected.end(), { 4, 5, 6, 7 });
    }
    EXPECT_EQ(recorder.levels, expected);
    EXPECT_EQ(method->GetNumberOfLevels(), expected.size());
    EXPECT_EQ(method->GetOutput()->GetResult().groups.size(), joint ? 1u : 2u);
    for (std::size_t i = 0; i < recorder.iterations.size(); ++i)
    {
      const IterationType & iteration = recorder.iterations[i];
      ASSERT_EQ(iteration.group, recorder.levelOfIteration[i] / 4);
      const auto stage = static_cast<itk::PoseStageEnum>(recorder.levelOfIteration[i] % 4);
      // Hypotheses are tried in the last one, and go through stages of their own.
      ASSERT_EQ(iteration.hypothesis ? itk::PoseStageEnum::Uncertainty : iteration.stage, stage) << i;
    }
    // All the levels but the last move something.
    std::set<unsigned int> moved(recorder.levelOfIteration.begin(), recorder.levelOfIteration.end());
    for (const unsigned int level : expected)
    {
      EXPECT_TRUE(moved.count(level) != 0) << level;
    }
    EXPECT_TRUE(recorder.isInCallingThread);
    EXPECT_TRUE(recorder.agrees);
  }
}

TEST(PoseRegistrationEvents, ProgressRunsFromNothingToAll)
{
  const auto         method = MakeMethod(Typical().geometry);
  std::vector<float> progress;
  method->AddObserver(itk::ProgressEvent(),
                      [&](const itk::EventObject &) { progress.push_back(method->GetProgress()); });
  method->Update();
  ASSERT_GT(progress.size(), 3u);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.front(), 0.0f);
  EXPECT_EQ(progress.back(), 1.0f);
  // Hypotheses are tried after the last of four levels, and tell of each.
  const auto ofHypotheses =
    std::count_if(progress.begin(), progress.end(), [](float value) { return value >= 0.875f && value < 1.0f; });
  EXPECT_GE(ofHypotheses, 5);
}

TEST(PoseRegistrationEvents, TheFirstLevelOfARunSaysNothingOfTheRunBefore)
{
  const auto method = MakeMethod(WrongFacing());
  method->Update();
  EXPECT_TRUE(method->GetCurrentIteration().hypothesis) << "the last step is one of a hypothesis";
  unsigned int levels = 0;
  method->AddObserver(itk::MultiResolutionIterationEvent(), [&](const itk::EventObject &) {
    if (levels++ == 0)
    {
      const IterationType & now = method->GetCurrentIteration();
      EXPECT_FALSE(now.hypothesis);
      EXPECT_EQ(now.stage, itk::PoseStageEnum::Start);
      EXPECT_EQ(now.step.evaluations, 0u);
      EXPECT_EQ(method->GetOptimizerIteration(), 0u);
    }
  });
  method->Modified();
  method->Update();
  EXPECT_EQ(levels, 4u);
}

TEST(PoseRegistrationEvents, TheReadyObserverRecordsThem)
{
  const auto method = MakeMethod(Typical().geometry);
  const auto command = itk::RegistrationIterationCommand::New();
  command->Observe(method);
  EXPECT_TRUE(method->GetOptimizerStopConditionDescription().empty()) << "before the first run";
  Recorder recorder(method);
  method->Update();
  const auto & records = command->GetRecords();
  using KindEnum = itk::RegistrationIterationCommand::KindEnum;
  const auto count = [&](KindEnum kind) {
    return static_cast<std::size_t>(
      std::count_if(records.begin(), records.end(), [&](const auto & record) { return record.kind == kind; }));
  };
  EXPECT_EQ(count(KindEnum::Level), 4u);
  EXPECT_EQ(count(KindEnum::Iteration), recorder.iterations.size());
  EXPECT_EQ(records.front().kind, KindEnum::Start);
  EXPECT_EQ(records.back().kind, KindEnum::End);
  EXPECT_EQ(records.back().parameters.Size(), 7u);
  EXPECT_NE(records.back().stopReason.find("LevenbergMarquardtOptimizerv4"), std::string::npos);
}

/** What a step is to be when the registration is stopped. */
struct Moment
{
  const char *                               name;
  bool                                       ofOptimizer;
  std::function<bool(const IterationType &)> when;
};

class PoseRegistrationAbort : public ::testing::TestWithParam<Moment>
{};

TEST_P(PoseRegistrationAbort, EndsItAtOnceAndTheNextRunIsWhole)
{
  const auto  method = MakeMethod(WrongFacing());
  bool        isOff = false;
  bool        isAborted = false;
  double      start = 0.0;
  std::size_t afterwards = 0;
  const auto  stop = [&](const itk::EventObject & event) {
    if (!IsIteration(event))
    {
      return;
    }
    afterwards += isAborted ? 1 : 0;
    if (!isOff && !isAborted && GetParam().when(method->GetCurrentIteration()))
    {
      isAborted = true;
      start = CpuTime();
      if (GetParam().ofOptimizer)
      {
        OptimizerOf(method)->StopOptimization();
      }
      else
      {
        method->AbortGenerateDataOn();
      }
    }
  };
  if (GetParam().ofOptimizer)
  {
    OptimizerOf(method)->AddObserver(itk::IterationEvent(), stop);
  }
  else
  {
    method->AddObserver(itk::IterationEvent(), stop);
  }
  EXPECT_THROW(method->Update(), itk::ProcessAborted);
  const double seconds = CpuTime() - start;
  ASSERT_TRUE(isAborted) << "the case has such a step";
  EXPECT_EQ(afterwards, 0u);
  // What runs in other threads ends with its step: a tenth of a second, or of a slow build's whole run the same part.
  EXPECT_LT(seconds, std::max(0.1, 0.05 * WholeRun()));

  isOff = true;
  isAborted = false;
  method->Update();
  const auto fresh = MakeMethod(WrongFacing());
  fresh->Update();
  EXPECT_EQ(method->GetOutput()->GetResult().groups[0].parameters,
            fresh->GetOutput()->GetResult().groups[0].parameters);
  EXPECT_EQ(method->GetOutput()->GetResult().groups[0].covariance,
            fresh->GetOutput()->GetResult().groups[0].covariance);
}

INSTANTIATE_TEST_SUITE_P(
  Moments,
  PoseRegistrationAbort,
  ::testing::Values(
    Moment{ "FirstStep", false, [](const IterationType &) { return true; } },
    Moment{ "Candidates", false, [](const IterationType & i) { return i.stage == itk::PoseStageEnum::Candidates; } },
    Moment{ "Refinement", false, [](const IterationType & i) { return i.stage == itk::PoseStageEnum::Refinement; } },
    Moment{ "Hypothesis", false, [](const IterationType & i) { return i.hypothesis; } },
    Moment{ "HypothesisRefined",
            false,
            [](const IterationType & i) { return i.hypothesis && i.stage == itk::PoseStageEnum::Refinement; } },
    Moment{
      "OptimizerStopped", true, [](const IterationType & i) { return i.stage == itk::PoseStageEnum::Candidates; } },
    Moment{ "OptimizerStoppedInHypothesis", true, [](const IterationType & i) { return i.hypothesis; } }),
  [](const auto & info) { return std::string(info.param.name); });

TEST(PoseRegistrationEvents, AHypothesisThatRunsAloneTellsItsStepsAndCanBeAborted)
{
  const auto method = MakeMethod(Typical().geometry);
  const auto side = itk::OtherSideHypothesis::New();
  method->ClearHypotheses();
  method->Update();
  std::size_t steps = 0;
  bool        abort = false;
  method->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    ++steps;
    EXPECT_TRUE(method->GetCurrentIteration().hypothesis);
    if (abort)
    {
      method->AbortGenerateDataOn();
    }
  });
  const auto first = method->TryHypothesis(side, MethodType::JawEnum::Upper);
  EXPECT_GT(steps, 10u);
  const std::size_t all = steps;
  steps = 0;
  abort = true;
  EXPECT_THROW(method->TryHypothesis(side, MethodType::JawEnum::Upper), itk::ProcessAborted);
  EXPECT_LT(steps, all);
  method->RemoveAllObservers();
  const auto again = method->TryHypothesis(side, MethodType::JawEnum::Upper);
  EXPECT_EQ(again.score, first.score);
  EXPECT_EQ(again.deviance, first.deviance);
}

TEST(PoseRegistrationEvents, AbortTellsObserversOfIt)
{
  const auto   method = MakeMethod(Typical().geometry);
  unsigned int aborts = 0;
  unsigned int ends = 0;
  method->AddObserver(itk::AbortEvent(), [&](const itk::EventObject &) { ++aborts; });
  method->AddObserver(itk::EndEvent(), [&](const itk::EventObject &) { ++ends; });
  method->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) { method->AbortGenerateDataOn(); });
  EXPECT_THROW(method->Update(), itk::ProcessAborted);
  EXPECT_EQ(aborts, 1u);
  EXPECT_EQ(ends, 0u);
}

TEST(PoseRegistrationEvents, WhatAnObserverThrowsPassesThrough)
{
  for (const unsigned int threads : { 1u, 3u })
  {
    const auto method = MakeMethod(Typical().geometry, true, threads);
    bool       isOff = false;
    const auto fail = [&](const itk::EventObject &) {
      if (!isOff && method->GetCurrentIteration().stage == itk::PoseStageEnum::Candidates)
      {
        throw std::domain_error("an observer's own");
      }
    };
    method->AddObserver(itk::IterationEvent(), fail);
    EXPECT_THROW(method->Update(), std::domain_error);
    isOff = true;
    method->Update();
    EXPECT_TRUE(method->GetOutput()->IsRegistered(MethodType::JawEnum::Upper));
  }
}

TEST(PoseRegistrationEvents, TheSameBitsAndTheSameStepsForAnyNumberOfThreads)
{
  std::vector<itk::PoseRegistrationResult> results;
  std::vector<std::size_t>                 steps;
  for (const unsigned int threads : { 1u, 2u, 3u })
  {
    const auto method = MakeMethod(WrongFacing(), true, threads);
    Recorder   recorder(method);
    method->Update();
    results.push_back(method->GetOutput()->GetResult());
    steps.push_back(recorder.iterations.size());
  }
  for (unsigned int i : { 1u, 2u })
  {
    EXPECT_EQ(steps[i], steps[0]);
    EXPECT_EQ(results[i].groups[0].parameters, results[0].groups[0].parameters);
    EXPECT_EQ(results[i].groups[0].covariance, results[0].groups[0].covariance);
    ASSERT_EQ(results[i].groups[0].outcomes.size(), results[0].groups[0].outcomes.size());
    for (const auto & outcome : results[0].groups[0].outcomes)
    {
      const auto * same = results[i].groups[0].FindOutcome(outcome.first);
      ASSERT_NE(same, nullptr) << outcome.first;
      EXPECT_EQ(same->score, outcome.second.score) << outcome.first;
      EXPECT_EQ(same->deviance, outcome.second.deviance) << outcome.first;
    }
    EXPECT_EQ(results[i].groups[0].evaluations, results[0].groups[0].evaluations);
    for (unsigned int j : { 0u, 1u })
    {
      EXPECT_EQ(results[i].jaws[j].projection, results[0].jaws[j].projection);
      EXPECT_EQ(results[i].jaws[j].fit.cost, results[0].jaws[j].fit.cost);
    }
  }
}
