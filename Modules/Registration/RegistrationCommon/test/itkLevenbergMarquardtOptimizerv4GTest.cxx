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
#include "itkLeastSquaresMetricCostFunction.h"
#include "itkLeastSquaresSumMetricv4.h"
#include "itkLeastSquaresTestMetric.h"
#include "itkLevenbergMarquardtOptimizerv4.h"

#include "itkLevenbergMarquardtOptimizer.h"

#include "itkGTest.h"
#include "itkMessageOfCall.h"
#include "itkTestingMacros.h"

#include "vnl/algo/vnl_svd.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

using namespace LeastSquaresTest;

namespace
{
using OptimizerType = itk::LevenbergMarquardtOptimizerv4;
using StopCondition = OptimizerType::StopConditionEnum;
using IterationType = OptimizerType::IterationType;

OptimizerType::Pointer
MakeOptimizer(Metric * metric)
{
  const auto optimizer = OptimizerType::New();
  optimizer->SetMetric(metric);
  return optimizer;
}

/** Every tried step of a run. */
std::vector<IterationType>
Record(OptimizerType * optimizer)
{
  std::vector<IterationType> record;
  const auto                 tag = optimizer->AddObserver(
    itk::IterationEvent(), [&](const itk::EventObject &) { record.push_back(optimizer->GetLastIteration()); });
  optimizer->StartOptimization();
  optimizer->RemoveObserver(tag);
  return record;
}

std::string
MessageOf(OptimizerType * optimizer)
{
  return itk::MessageOfCall([&] { optimizer->StartOptimization(); });
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

/** An ordinary metric: one without residuals. */
class PlainMetric : public itk::ObjectToObjectMetricBaseTemplate<double>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PlainMetric);
  using Self = PlainMetric;
  using Superclass = itk::ObjectToObjectMetricBaseTemplate<double>;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);
  itkTypeMacro(PlainMetric, ObjectToObjectMetricBaseTemplate);
  void
  Initialize() override
  {}
  MeasureType
  GetValue() const override
  {
    return 0.0;
  }
  void
  GetDerivative(DerivativeType &) const override
  {}
  void
  GetValueAndDerivative(MeasureType &, DerivativeType &) const override
  {}
  NumberOfParametersType
  GetNumberOfParameters() const override
  {
    return 1;
  }
  NumberOfParametersType
  GetNumberOfLocalParameters() const override
  {
    return 1;
  }
  void
  SetParameters(ParametersType &) override
  {}
  const ParametersType &
  GetParameters() const override
  {
    return m_Parameters;
  }
  bool
  HasLocalSupport() const override
  {
    return false;
  }
  void
  UpdateTransformParameters(const DerivativeType &, ParametersValueType) override
  {}

protected:
  PlainMetric() = default;
  ~PlainMetric() override = default;

private:
  ParametersType m_Parameters{ 1 };
};

int
ExerciseBasicObjectMethods()
{
  const auto optimizer = MakeOptimizer(MakeRosenbrock());
  ITK_EXERCISE_BASIC_OBJECT_METHODS(optimizer, LevenbergMarquardtOptimizerv4, ObjectToObjectOptimizerBaseTemplate);
  return EXIT_SUCCESS;
}
} // namespace

TEST(LevenbergMarquardtOptimizerv4, BasicObjectMethodsAndEverySettingIsPrinted)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  std::ostringstream text;
  OptimizerType::New()->Print(text);
  for (const char * line : { "MaximumNumberOfEvaluations: 1000",
                             "StepTolerance: 1e-06",
                             "ValueTolerance: 1e-08",
                             "InitialDamping: 0",
                             "StopCondition: itk::LevenbergMarquardtOptimizerv4Enums::StopCondition::NotStarted" })
  {
    EXPECT_TRUE(Contains(text.str(), line)) << line;
  }
}

TEST(LevenbergMarquardtOptimizerv4, SolvesACurvedValleyAndReportsEveryStepHonestly)
{
  const auto   metric = MakeRosenbrock();
  const auto   optimizer = MakeOptimizer(metric);
  const double start = metric->Evaluate(metric->GetParameters());
  unsigned int starts = 0;
  unsigned int ends = 0;
  unsigned int steps = 0;
  unsigned int accepted = 0;
  double       best = start;
  optimizer->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) {
    ++starts;
    EXPECT_EQ(optimizer->GetCurrentMetricValue(), start);
    EXPECT_EQ(optimizer->GetStopCondition(), StopCondition::Running);
  });
  optimizer->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    ++steps;
    accepted += optimizer->GetStepAccepted() ? 1 : 0;
    EXPECT_EQ(optimizer->GetNumberOfEvaluations(), steps);
    EXPECT_EQ(optimizer->GetCurrentIteration(), accepted);
    EXPECT_EQ(optimizer->GetTrialValue(), metric->Evaluate(metric->GetParameters()));
    EXPECT_EQ(optimizer->GetCurrentMetricValue(), metric->Evaluate(optimizer->GetCurrentPosition()));
    EXPECT_EQ(optimizer->GetStepAccepted(), optimizer->GetTrialValue() < best);
    EXPECT_EQ(optimizer->GetCurrentMetricValue(), std::min(best, optimizer->GetTrialValue()));
    best = optimizer->GetCurrentMetricValue();
    EXPECT_EQ(optimizer->GetStepAccepted(), optimizer->GetCurrentPosition() == metric->GetParameters());
  });
  optimizer->AddObserver(itk::EndEvent(), [&](const itk::EventObject &) {
    ++ends;
    EXPECT_EQ(optimizer->GetCurrentPosition(), metric->GetParameters());
    EXPECT_TRUE(optimizer->HasConverged());
  });
  optimizer->StartOptimization();
  EXPECT_EQ(starts, 1u);
  EXPECT_EQ(ends, 1u);
  EXPECT_GT(steps, accepted);
  EXPECT_LT(steps, 50u);
  EXPECT_NEAR(metric->GetParameters()[0], 1.0, 1e-9);
  EXPECT_NEAR(metric->GetParameters()[1], 1.0, 1e-9);
  EXPECT_TRUE(optimizer->HasConverged());
  EXPECT_TRUE(Contains(optimizer->GetStopConditionDescription(), "LevenbergMarquardtOptimizerv4: Converged"));
}

TEST(LevenbergMarquardtOptimizerv4, StepsAreThoseOfTheRule)
{
  // The rule written down anew; a singular value decomposition instead of LDLT leaves rounding times the condition.
  const auto metric = MakeRosenbrock();
  const auto optimizer = MakeOptimizer(metric);
  optimizer->SetInitialDamping(0.5);
  optimizer->SetValueTolerance(0.0);
  const std::vector<IterationType> record = Record(optimizer);
  ASSERT_GT(record.size(), 10u);

  const auto         reference = MakeRosenbrock();
  ParametersType     x = reference->GetParameters();
  double             value = reference->Evaluate(x);
  double             damping = 0.5;
  vnl_vector<double> r;
  vnl_matrix<double> j;
  reference->GetResiduals(r, &j);
  for (std::size_t i = 0; i < record.size(); ++i)
  {
    vnl_matrix<double> a = j.transpose() * j;
    for (unsigned int k = 0; k < 2; ++k)
    {
      a(k, k) += damping * a(k, k);
      a(k, k) += 1e-9;
    }
    const vnl_vector<double> step = -vnl_svd<double>(a).solve(r * j);
    ParametersType           next = x;
    next[0] += step[0];
    next[1] += step[1];
    const double trial = reference->Evaluate(next);
    const bool   accepted = trial < value;
    EXPECT_NEAR(record[i].trialValue, trial, 1e-9 * std::max(1.0, trial)) << i;
    EXPECT_NEAR(record[i].stepLength, step.two_norm(), 1e-9) << i;
    // At the floor of double precision rounding decides which is lower.
    if (trial < 1e-20)
    {
      break;
    }
    ASSERT_EQ(record[i].accepted, accepted) << i;
    if (accepted)
    {
      x = next;
      value = trial;
      damping = damping > 1e-4 ? 0.1 * damping : 0.0;
      EXPECT_EQ(record[i].damping, damping) << i;
      reference->SetParameters(x);
      reference->GetResiduals(r, &j);
    }
    else
    {
      EXPECT_EQ(record[i].damping, damping) << i;
      damping = std::max(10.0 * damping, 1e-2);
    }
  }
}

TEST(LevenbergMarquardtOptimizerv4, JudgesARobustMetricByItsCriterion)
{
  const auto                       metric = MakeRobustLine();
  const auto                       optimizer = MakeOptimizer(metric);
  const std::vector<IterationType> record = Record(optimizer);
  EXPECT_TRUE(optimizer->HasConverged());
  double last = metric->Evaluate(MakeRobustLine()->GetParameters());
  for (const auto & iteration : record)
  {
    EXPECT_EQ(iteration.accepted, iteration.value < last);
    last = iteration.value;
  }
  // The points that are elsewhere pull by their distance to the third: hundredths here.
  const ParametersType x = metric->GetParameters();
  EXPECT_NEAR(x[0], 2.0, 0.01);
  EXPECT_NEAR(x[1], 1.0, 0.01);
  for (unsigned int k = 0; k < 2; ++k)
  {
    ParametersType after = x;
    ParametersType before = x;
    after[k] += 1e-4;
    before[k] -= 1e-4;
    EXPECT_NEAR((metric->Evaluate(after) - metric->Evaluate(before)) / 2e-4, 0.0, 1e-4);
  }
  // The sum of the reweighted residuals' squares is another figure: it lacks what the points let go cost.
  vnl_vector<double> r;
  metric->GetResiduals(r, nullptr);
  EXPECT_GT(std::abs(metric->Evaluate(x) - r.squared_magnitude()), 1.0);
}

TEST(LevenbergMarquardtOptimizerv4, StepsBackFromWhereTheValueIsNoNumber)
{
  const auto                       metric = MakeLogarithm();
  const auto                       optimizer = MakeOptimizer(metric);
  const std::vector<IterationType> record = Record(optimizer);
  ASSERT_FALSE(record.empty());
  EXPECT_TRUE(std::isnan(record[0].trialValue));
  EXPECT_FALSE(record[0].accepted);
  EXPECT_TRUE(optimizer->HasConverged());
  EXPECT_NEAR(metric->GetParameters()[0], 0.01, 1e-9);

  // Minus infinity is lower than all, and no minimum.
  const auto pit = MakeLogarithm();
  pit->criterion = [](const ParametersType & x) {
    return x[0] > 0.0 ? std::pow(std::log(x[0] / 0.01), 2) : -std::numeric_limits<double>::infinity();
  };
  MakeOptimizer(pit)->StartOptimization();
  EXPECT_NEAR(pit->GetParameters()[0], 0.01, 1e-9);
}

TEST(LevenbergMarquardtOptimizerv4, SaysWhenThereIsNothingToStartFrom)
{
  const auto outside = MakeLogarithm(-1.0);
  const auto optimizer = MakeOptimizer(outside);
  optimizer->StartOptimization();
  EXPECT_EQ(optimizer->GetStopCondition(), StopCondition::NotFinite);
  EXPECT_FALSE(optimizer->HasConverged());
  EXPECT_EQ(optimizer->GetNumberOfEvaluations(), 0u);
  EXPECT_TRUE(Contains(optimizer->GetStopConditionDescription(), "not finite"));

  const auto broken = MakeLogarithm();
  broken->function = [](const ParametersType &, vnl_vector<double> & r, vnl_matrix<double> & j) {
    r[0] = 1.0;
    j(0, 0) = std::nan("");
  };
  optimizer->SetMetric(broken);
  optimizer->StartOptimization();
  EXPECT_EQ(optimizer->GetStopCondition(), StopCondition::NotFinite);
  EXPECT_EQ(broken->GetParameters()[0], 4.0);
}

TEST(LevenbergMarquardtOptimizerv4, ParameterThatNothingObservesStays)
{
  const auto metric =
    Metric::Make({ 3.0, 0.7, -2.0 }, 2, [](const ParametersType & x, vnl_vector<double> & r, vnl_matrix<double> & j) {
      r[0] = x[0] - 1.0;
      r[1] = 2.0 * (x[2] - 5.0);
      j(0, 0) = 1.0;
      j(1, 2) = 2.0;
    });
  MakeOptimizer(metric)->StartOptimization();
  EXPECT_NEAR(metric->GetParameters()[0], 1.0, 1e-8);
  EXPECT_EQ(metric->GetParameters()[1], 0.7);
  EXPECT_NEAR(metric->GetParameters()[2], 5.0, 1e-8);
}

TEST(LevenbergMarquardtOptimizerv4, TakesFewerResidualsThanParameters)
{
  // The shortest way to the line x + y = 3, as the ridge has it, whose share of the pivot is 1e-9.
  const auto metric =
    Metric::Make({ 0.0, 0.0 }, 1, [](const ParametersType & x, vnl_vector<double> & r, vnl_matrix<double> & j) {
      r[0] = x[0] + x[1] - 3.0;
      j(0, 0) = 1.0;
      j(0, 1) = 1.0;
    });
  const auto optimizer = MakeOptimizer(metric);
  optimizer->StartOptimization();
  EXPECT_TRUE(optimizer->HasConverged());
  EXPECT_NEAR(metric->GetParameters()[0], 1.5, 1e-5);
  EXPECT_NEAR(metric->GetParameters()[1], 1.5, 1e-5);
}

TEST(LevenbergMarquardtOptimizerv4, LimitsShortenAStepWithoutTurningIt)
{
  const auto make = [] {
    return Metric::Make(
      { 0.0, 0.0, 0.0 }, 3, [](const ParametersType & x, vnl_vector<double> & r, vnl_matrix<double> & j) {
        const double goal[3] = { 4.0, -2.0, 1.0 };
        for (unsigned int k = 0; k < 3; ++k)
        {
          r[k] = x[k] - goal[k];
          j(k, k) = 1.0;
        }
      });
  };
  const auto metric = make();
  metric->maximumSteps.SetSize(3);
  // No limit, half the step, a quarter of the step.
  metric->maximumSteps[0] = 0.0;
  metric->maximumSteps[1] = 1.0;
  metric->maximumSteps[2] = 0.25;
  const auto optimizer = MakeOptimizer(metric);
  optimizer->SetNumberOfIterations(1);
  optimizer->StartOptimization();
  EXPECT_NEAR(metric->GetParameters()[0], 1.0, 1e-8);
  EXPECT_NEAR(metric->GetParameters()[1], -0.5, 1e-8);
  EXPECT_NEAR(metric->GetParameters()[2], 0.25, 1e-8);
  // Four quarters: no limit is in the way at the end.
  optimizer->SetNumberOfIterations(100);
  optimizer->StartOptimization();
  EXPECT_NEAR(metric->GetParameters()[0], 4.0, 1e-8);

  const auto wrong = make();
  wrong->maximumSteps.SetSize(2);
  EXPECT_TRUE(Contains(MessageOf(MakeOptimizer(wrong)), "GetMaximumSteps() of Metric gave 2 limits"));
}

TEST(LevenbergMarquardtOptimizerv4, AsksTheMetricForNoMoreThanItNeeds)
{
  // One accepted step: value and residuals at the start, then value and step length at the new position.
  const auto metric = MakeRosenbrock();
  const auto optimizer = MakeOptimizer(metric);
  optimizer->SetNumberOfIterations(1);
  optimizer->SetInitialDamping(1.0);
  optimizer->StartOptimization();
  EXPECT_EQ(metric->calls, "VRMSVL");
  // Rejected steps use the residuals that there are; the metric is put back at the end.
  const auto rejecting = MakeRosenbrock();
  rejecting->criterion = [](const ParametersType & x) { return x[0] == -1.2 ? 1.0 : 2.0; };
  optimizer->SetMetric(rejecting);
  optimizer->SetMaximumNumberOfEvaluations(3);
  optimizer->StartOptimization();
  EXPECT_EQ(rejecting->calls, "VRMSVLSVLSVLS");
  EXPECT_EQ(rejecting->GetParameters()[0], -1.2);
  // Two accepted steps: residuals anew for the second only.
  const auto twice = MakeRosenbrock();
  optimizer->SetMetric(twice);
  optimizer->SetNumberOfIterations(2);
  optimizer->SetMaximumNumberOfEvaluations(1000);
  optimizer->SetInitialDamping(10.0);
  optimizer->StartOptimization();
  EXPECT_EQ(twice->calls, "VRMSVLRMSVL");
  // No step at all.
  const auto none = MakeRosenbrock();
  optimizer->SetMetric(none);
  optimizer->SetNumberOfIterations(0);
  optimizer->StartOptimization();
  EXPECT_EQ(none->calls, "V");
}

TEST(LevenbergMarquardtOptimizerv4, RunsOfOneStepWithTheDampingOfTheLastAreOneLongRun)
{
  const auto                 metric = MakeRosenbrock();
  const auto                 optimizer = MakeOptimizer(metric);
  std::vector<IterationType> whole = Record(optimizer);
  ASSERT_TRUE(optimizer->HasConverged());

  const auto pieces = MakeRosenbrock();
  const auto stepper = MakeOptimizer(pieces);
  stepper->SetNumberOfIterations(1);
  std::vector<IterationType> record;
  unsigned int               runs = 0;
  do
  {
    stepper->SetInitialDamping(stepper->GetDamping());
    const std::vector<IterationType> run = Record(stepper);
    record.insert(record.end(), run.begin(), run.end());
    ++runs;
  } while (!stepper->HasConverged() && runs < 100);
  EXPECT_GT(runs, 5u);
  ASSERT_EQ(record.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    EXPECT_EQ(record[i].position, whole[i].position) << i;
    EXPECT_EQ(record[i].trialValue, whole[i].trialValue) << i;
    EXPECT_EQ(record[i].damping, whole[i].damping) << i;
  }
  EXPECT_EQ(pieces->GetParameters(), metric->GetParameters());
}

TEST(LevenbergMarquardtOptimizerv4, EachEndHasItsConditionAndItsSentence)
{
  const auto optimizer = OptimizerType::New();
  const auto check = [&optimizer](StopCondition condition, bool converged, const std::string & part) {
    EXPECT_EQ(optimizer->GetStopCondition(), condition) << condition;
    EXPECT_EQ(optimizer->HasConverged(), converged) << condition;
    EXPECT_TRUE(Contains(optimizer->GetStopConditionDescription(), part)) << optimizer->GetStopConditionDescription();
  };
  check(StopCondition::NotStarted, false, "not run yet");
  const auto run = [&optimizer](Metric * metric) {
    optimizer->SetMetric(metric);
    optimizer->StartOptimization();
  };
  for (const itk::SizeValueType maximum : { 0, 1, 2 })
  {
    const auto metric = MakeRosenbrock();
    optimizer->SetNumberOfIterations(maximum);
    run(metric);
    check(StopCondition::MaximumNumberOfIterations, false, "Maximum number of iterations (" + std::to_string(maximum));
    EXPECT_EQ(optimizer->GetCurrentIteration(), maximum);
    EXPECT_EQ(optimizer->GetCurrentMetricValue(), metric->Evaluate(metric->GetParameters()));
    EXPECT_EQ(optimizer->GetCurrentMetricValue() < MakeRosenbrock()->GetValue(), maximum > 0);
  }
  optimizer->SetNumberOfIterations(100);
  optimizer->SetMaximumNumberOfEvaluations(4);
  run(MakeRosenbrock());
  check(StopCondition::MaximumNumberOfEvaluations, false, "Maximum number of evaluations (4) reached.");
  EXPECT_EQ(optimizer->GetNumberOfEvaluations(), 4u);
  optimizer->SetMaximumNumberOfEvaluations(1000);
  optimizer->SetStepTolerance(100.0);
  run(MakeRosenbrock());
  check(StopCondition::StepTolerance, true, "shorter than the tolerance (100).");
  EXPECT_EQ(optimizer->GetNumberOfEvaluations(), 1u);
  // The sentence is that of the run, whatever is set afterwards.
  optimizer->SetStepTolerance(0.0);
  check(StopCondition::StepTolerance, true, "shorter than the tolerance (100).");
  optimizer->SetValueTolerance(0.9);
  run(MakeRobustLine());
  check(StopCondition::ValueTolerance, true, "less than the tolerance (0.9) of it.");
  // A rejected step that is short ends the run as well: there is nothing to gain.
  const auto flat = MakeRosenbrock();
  flat->criterion = [](const ParametersType &) { return 1.0; };
  optimizer->SetStepTolerance(1e-3);
  run(flat);
  check(StopCondition::StepTolerance, true, "shorter than");
  EXPECT_EQ(optimizer->GetCurrentIteration(), 0u);
  EXPECT_LT(optimizer->GetStepLength(), 1e-3);
  EXPECT_FALSE(optimizer->GetStepAccepted());

  std::ostringstream text;
  for (unsigned char value = 0; value <= 9; ++value)
  {
    text << static_cast<StopCondition>(value) << ' ';
  }
  for (const char * name : { "::NotStarted ",
                             "::Running ",
                             "::StepTolerance ",
                             "::ValueTolerance ",
                             "::MaximumNumberOfIterations ",
                             "::MaximumNumberOfEvaluations ",
                             "::StoppedByObserver ",
                             "::NotFinite ",
                             "::Exception ",
                             "INVALID VALUE FOR itk::LevenbergMarquardtOptimizerv4Enums::StopCondition" })
  {
    EXPECT_TRUE(Contains(text.str(), name)) << name;
  }
}

TEST(LevenbergMarquardtOptimizerv4, ObserverStopsItBeforeTheNextEvaluation)
{
  const auto metric = MakeRosenbrock();
  const auto optimizer = MakeOptimizer(metric);
  auto       tag = optimizer->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    if (optimizer->GetNumberOfEvaluations() == 3)
    {
      optimizer->StopOptimization();
    }
  });
  optimizer->StartOptimization();
  EXPECT_EQ(optimizer->GetNumberOfEvaluations(), 3u);
  EXPECT_EQ(optimizer->GetStopCondition(), StopCondition::StoppedByObserver);
  EXPECT_FALSE(optimizer->HasConverged());
  EXPECT_TRUE(Contains(optimizer->GetStopConditionDescription(), "observer"));
  EXPECT_EQ(metric->Evaluate(metric->GetParameters()), optimizer->GetCurrentMetricValue());
  optimizer->RemoveObserver(tag);
  tag = optimizer->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { optimizer->StopOptimization(); });
  optimizer->StartOptimization();
  EXPECT_EQ(optimizer->GetNumberOfEvaluations(), 0u);
  EXPECT_EQ(optimizer->GetStopCondition(), StopCondition::StoppedByObserver);
  optimizer->RemoveObserver(tag);
  optimizer->StartOptimization();
  EXPECT_TRUE(optimizer->HasConverged());
}

TEST(LevenbergMarquardtOptimizerv4, PassesOnWhatObserverOrMetricThrowsFromTheBestPosition)
{
  // The first full step along the valley is rejected with this damping: the metric stands elsewhere when it throws.
  const auto   metric = MakeRosenbrock();
  const auto   optimizer = MakeOptimizer(metric);
  double       best = 0.0;
  const auto   tag = optimizer->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    best = optimizer->GetCurrentMetricValue();
    if (!optimizer->GetStepAccepted())
    {
      itkGenericExceptionMacro("enough");
    }
  });
  unsigned int ends = 0;
  optimizer->AddObserver(itk::EndEvent(), [&](const itk::EventObject &) { ++ends; });
  EXPECT_TRUE(Contains(MessageOf(optimizer), "enough"));
  EXPECT_EQ(ends, 0u);
  EXPECT_EQ(optimizer->GetStopCondition(), StopCondition::Exception);
  EXPECT_EQ(metric->Evaluate(metric->GetParameters()), best);
  EXPECT_EQ(optimizer->GetCurrentPosition(), metric->GetParameters());
  optimizer->RemoveObserver(tag);
  EXPECT_NO_THROW(optimizer->StartOptimization());
  EXPECT_EQ(ends, 1u);
  EXPECT_TRUE(optimizer->HasConverged());

  const auto throwing = MakeRosenbrock();
  throwing->criterion = [](const ParametersType & x) {
    if (x[0] != -1.2)
    {
      itkGenericExceptionMacro("too far");
    }
    return 1.0;
  };
  EXPECT_TRUE(Contains(MessageOf(MakeOptimizer(throwing)), "too far"));
  EXPECT_EQ(throwing->GetParameters()[0], -1.2);
}

TEST(LevenbergMarquardtOptimizerv4, SaysWhatItNeeds)
{
  EXPECT_TRUE(Contains(MessageOf(OptimizerType::New()), "call SetMetric() first."));
  const auto optimizer = OptimizerType::New();
  optimizer->SetMetric(PlainMetric::New());
  const std::string message = MessageOf(optimizer);
  EXPECT_TRUE(Contains(message, "PlainMetric has no residuals"));
  EXPECT_TRUE(Contains(message, "LBFGSBOptimizerv4"));
  const auto held = Metric::Make({}, 1, nullptr);
  EXPECT_TRUE(Contains(MessageOf(MakeOptimizer(held)), "No parameter of the metric Metric is free"));
  EXPECT_TRUE(Contains(MessageOf(MakeOptimizer(held)), "SetBlockFree()"));
  const auto empty = OptimizerType::New();
  empty->SetMetric(itk::LeastSquaresSumMetricv4::New());
  EXPECT_TRUE(Contains(MessageOf(empty), "A sum of nothing: call AddMetric() with at least one term."))
    << MessageOf(empty);
  const auto crooked = MakeRosenbrock();
  crooked->function = [](const ParametersType &, vnl_vector<double> & r, vnl_matrix<double> & j) {
    r.fill(1.0);
    j.set_size(2, 3);
    j.fill(1.0);
  };
  EXPECT_TRUE(Contains(MessageOf(MakeOptimizer(crooked)), "2 residuals and a Jacobian of 2 x 3"));
  const auto settings = MakeOptimizer(MakeRosenbrock());
  settings->SetStepTolerance(-1.0);
  EXPECT_TRUE(Contains(MessageOf(settings), "StepTolerance is -1"));
  settings->SetStepTolerance(0.0);
  settings->SetValueTolerance(std::nan(""));
  EXPECT_TRUE(Contains(MessageOf(settings), "ValueTolerance"));
  settings->SetValueTolerance(0.0);
  settings->SetInitialDamping(-1.0);
  EXPECT_TRUE(Contains(MessageOf(settings), "InitialDamping"));
  EXPECT_NO_THROW(MakeOptimizer(MakeRosenbrock())->StartOptimization(true));
}

TEST(LevenbergMarquardtOptimizerv4, MetricMayFreeOrHoldParametersBetweenRuns)
{
  const auto optimizer = MakeOptimizer(MakeRosenbrock());
  optimizer->StartOptimization();
  const auto metric = MakeLogarithm();
  optimizer->SetMetric(metric);
  optimizer->StartOptimization();
  EXPECT_NEAR(metric->GetParameters()[0], 0.01, 1e-9);
  const auto again = MakeRosenbrock();
  optimizer->SetMetric(again);
  optimizer->StartOptimization();
  EXPECT_NEAR(again->GetParameters()[0], 1.0, 1e-9);
}

TEST(LevenbergMarquardtOptimizerv4, CloneHasTheSettingsButNotMetricAndObservers)
{
  const auto optimizer = MakeOptimizer(MakeRosenbrock());
  optimizer->SetNumberOfIterations(7);
  optimizer->SetMaximumNumberOfEvaluations(11);
  optimizer->SetStepTolerance(0.5);
  optimizer->SetValueTolerance(0.25);
  optimizer->SetInitialDamping(0.125);
  optimizer->AddObserver(itk::IterationEvent(), [](const itk::EventObject &) {});
  const OptimizerType::Pointer clone = optimizer->Clone();
  EXPECT_EQ(clone->GetNumberOfIterations(), 7u);
  EXPECT_EQ(clone->GetMaximumNumberOfEvaluations(), 11u);
  EXPECT_EQ(clone->GetStepTolerance(), 0.5);
  EXPECT_EQ(clone->GetValueTolerance(), 0.25);
  EXPECT_EQ(clone->GetInitialDamping(), 0.125);
  EXPECT_EQ(clone->GetMetric(), nullptr);
  EXPECT_FALSE(clone->HasObserver(itk::IterationEvent()));
  EXPECT_EQ(clone->GetStopCondition(), StopCondition::NotStarted);
}

TEST(LevenbergMarquardtOptimizerv4, ClonesInThreadsGiveTheSameBitsAndTheirOwnerReportsThem)
{
  const auto expectedMetric = MakeRobustLine();
  const auto owner = MakeOptimizer(expectedMetric);
  const auto expected = Record(owner);

  std::vector<IterationType> seen;
  owner->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    seen.push_back(owner->GetLastIteration());
    EXPECT_EQ(owner->GetCurrentPosition(), seen.back().position);
  });
  std::mutex                   mutex;
  std::vector<Metric::Pointer> metrics;
  std::vector<std::thread>     threads;
  for (int i = 0; i < 4; ++i)
  {
    metrics.push_back(MakeRobustLine());
    threads.emplace_back([&mutex, &owner, metric = metrics.back()] {
      const OptimizerType::Pointer clone = owner->Clone();
      clone->SetMetric(metric);
      clone->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
        const std::lock_guard<std::mutex> lock(mutex);
        owner->ReportIteration(clone->GetLastIteration());
      });
      clone->StartOptimization();
    });
  }
  for (auto & thread : threads)
  {
    thread.join();
  }
  for (const auto & metric : metrics)
  {
    EXPECT_EQ(metric->GetParameters(), expectedMetric->GetParameters());
  }
  EXPECT_EQ(seen.size(), 4 * expected.size());
  // Every step of the run was reported as it was, four times over.
  for (const auto & iteration : expected)
  {
    EXPECT_EQ(std::count_if(seen.begin(),
                            seen.end(),
                            [&iteration](const IterationType & other) {
                              return other.evaluations == iteration.evaluations &&
                                     other.position == iteration.position && other.value == iteration.value &&
                                     other.trialValue == iteration.trialValue &&
                                     other.stepLength == iteration.stepLength && other.damping == iteration.damping &&
                                     other.accepted == iteration.accepted && other.iteration == iteration.iteration;
                            }),
              4);
  }
}

TEST(LevenbergMarquardtOptimizerv4, ReportSaysWhetherAnObserverWantsTheOwnersRunsToEnd)
{
  const auto    owner = OptimizerType::New();
  IterationType iteration;
  iteration.position = ParametersType(1);
  iteration.position.Fill(3.0);
  iteration.value = 2.0;
  EXPECT_TRUE(owner->ReportIteration(iteration));
  EXPECT_EQ(owner->GetCurrentMetricValue(), 2.0);
  bool stop = true;
  owner->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    EXPECT_EQ(owner->GetCurrentPosition()[0], 3.0);
    EXPECT_THROW(owner->ReportIteration(IterationType()), itk::ExceptionObject);
    if (stop)
    {
      owner->StopOptimization();
    }
  });
  EXPECT_FALSE(owner->ReportIteration(iteration));
  stop = false;
  EXPECT_TRUE(owner->ReportIteration(iteration));
  // Between two reports, as by a button.
  owner->StopOptimization();
  EXPECT_FALSE(owner->ReportIteration(iteration));
  EXPECT_TRUE(owner->ReportIteration(iteration));
}

TEST(LeastSquaresMetricCostFunction, MinpackFindsTheSameMinimumOnTheSameInterface)
{
  const auto metric = MakeRosenbrock();
  const auto cost = itk::LeastSquaresMetricCostFunction::New();
  cost->SetMetric(metric);
  const auto minpack = itk::LevenbergMarquardtOptimizer::New();
  minpack->SetUseCostFunctionGradient(true);
  minpack->SetCostFunction(cost);
  itk::LevenbergMarquardtOptimizer::ParametersType start(2);
  std::copy(metric->GetParameters().begin(), metric->GetParameters().end(), start.begin());
  minpack->SetInitialPosition(start);
  minpack->SetNumberOfIterations(200);
  minpack->StartOptimization();
  EXPECT_NEAR(minpack->GetCurrentPosition()[0], 1.0, 1e-6);
  EXPECT_NEAR(minpack->GetCurrentPosition()[1], 1.0, 1e-6);
}
