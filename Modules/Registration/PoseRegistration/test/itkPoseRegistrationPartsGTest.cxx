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
#include "itkMessageOfCall.h"
#include "itkPoseSolutionTestCase.h"

#include "itkCorrelatedNoiseModel.h"
#include "itkExchangedJawsHypothesis.h"
#include "itkExchangedLandmarksHypothesis.h"
#include "itkFindSilhouettes.h"
#include "itkGemanMcClureKernel.h"
#include "itkLeastSquaresFunctionMetricv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkMillimetreLandmarksHypothesis.h"
#include "itkOtherSpacingHypothesis.h"
#include "itkTurnedDrawingHypothesis.h"
#include "itkUpwardDrawingHypothesis.h"
#include "itkOtherFacingHypothesis.h"
#include "itkOtherSideHypothesis.h"
#include "itkParameterPriorMetricv4.h"
#include "itkPosePriors.h"
#include "itkPoseStartSearch.h"
#include "itkPoseStateBlocks.h"
#include "itkRegistrationVerdict.h"
#include "itkSilhouettePoseMetricv4.h"
#include "itkSquaresKernel.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// The parts of a registration that a user may exchange or add.
namespace
{
using itk::MessageOfCall;
using PoseSolutionTestCase::Contains;
using Source = itk::DentalPhantomCaseSource;
using MethodType = PoseRegistrationTestCase::MethodType;
using JawEnum = MethodType::JawEnum;

constexpr double Infinity = std::numeric_limits<double>::infinity();

const PoseRegistrationTestCase &
Typical()
{
  static const PoseRegistrationTestCase typical(71, Source::CohortEnum::Typical, Source::TracedSideEnum::Right);
  return typical;
}

MethodType::Pointer
MakeMethod(const itk::PoseRegistrationOptions & options = itk::PoseRegistrationOptions())
{
  return PoseRegistrationTestCase::MakeMethod(Typical().jaws, Typical().geometry, options);
}

/** The result without anything exchanged or added. */
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

/** A prior on one of the pose's parameters. */
itk::ParameterPriorMetricv4::Pointer
MakePosePrior(unsigned int parameter, double mean, double sigma)
{
  auto prior = itk::ParameterPriorMetricv4::New();
  prior->SetBlock(itk::PoseStateBlocks::MakePose());
  std::vector<itk::ParameterPriorMetricv4::PriorType> priors(6, { 0.0, Infinity, 0.0 });
  priors[parameter] = { mean, sigma, 0.0 };
  prior->SetPriors(priors);
  return prior;
}

/** A user's own metric with an unknown of its own: the height plus an offset that nobody knows is three. */
class OffsetMetric : public itk::LeastSquaresMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(OffsetMetric);
  using Self = OffsetMetric;
  using Superclass = itk::LeastSquaresMetricv4;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  itkNewMacro(Self);
  itkTypeMacro(OffsetMetric, LeastSquaresMetricv4);

  BlocksType
  DeclareBlocks() const override
  {
    return { itk::PoseStateBlocks::MakePose(), { "offset", { { "height", 0.0, 1.0, 0.0, true } } } };
  }
  itk::SizeValueType
  GetNumberOfResiduals() const override
  {
    return 1;
  }
  void
  ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const override
  {
    residuals.set_size(1);
    residuals[0] = (x[itk::PoseTz] + x[6] - 3.0) / 100.0;
    if (jacobian != nullptr)
    {
      this->ComputeJacobianByDifferences(x, *jacobian);
    }
  }

protected:
  OffsetMetric() = default;
  ~OffsetMetric() override = default;
  itk::LightObject::Pointer
  InternalClone() const override
  {
    auto clone = Self::New();
    clone->CopyState(*this);
    return clone.GetPointer();
  }
};

/** A user's own metric that says of every place the same, but bets on it: so much is its known deviance. */
class BettingMetric : public OffsetMetric
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(BettingMetric);
  using Self = BettingMetric;
  using Superclass = OffsetMetric;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  itkNewMacro(Self);
  itkTypeMacro(BettingMetric, OffsetMetric);

  double bet{ 0.0 };

  double
  ComputeKnownDeviance(const PositionType &, bool) const override
  {
    return bet;
  }

protected:
  BettingMetric() = default;
  ~BettingMetric() override = default;
  itk::LightObject::Pointer
  InternalClone() const override
  {
    auto clone = Self::New();
    clone->bet = bet;
    clone->CopyState(*this);
    return clone.GetPointer();
  }
};

/** One start, given; counts what it is asked. */
class GivenStart : public itk::PoseStart
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(GivenStart);
  using Self = GivenStart;
  using Superclass = itk::PoseStart;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);
  itkTypeMacro(GivenStart, PoseStart);

  std::vector<StartType>            starts;
  mutable std::atomic<unsigned int> calls{ 0 };
  mutable std::atomic<bool>         searchesScale{ false };
  mutable std::atomic<bool>         holdsRotation{ false };
  mutable std::atomic<unsigned int> maximum{ 0 };

  std::vector<StartType>
  Search(const itk::LeastSquaresMetricv4 &, const RequestType & request) const override
  {
    ++calls;
    searchesScale = request.searchScale;
    holdsRotation = request.holdRotation;
    maximum = request.maximumNumberOfStarts;
    return starts;
  }

protected:
  GivenStart() = default;
  ~GivenStart() override = default;
};

/** Asks the same again. */
class SameAgain : public itk::PoseHypothesis
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SameAgain);
  using Self = SameAgain;
  using Superclass = itk::PoseHypothesis;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);
  itkTypeMacro(SameAgain, PoseHypothesis);

  bool                isWorthTrying{ true };
  mutable std::size_t jaws{ 0 };

  std::string
  GetCode() const override
  {
    return "same-again";
  }
  bool
  IsWorthTrying(const itk::PoseProblem & problem, const itk::PoseGroupResult &) const override
  {
    jaws = problem.jaws.size();
    return isWorthTrying;
  }
  itk::PoseProblem
  Apply(const itk::PoseProblem & problem) const override
  {
    itk::PoseProblem same = problem;
    same.options = MakeQuickOptions(problem.options, 14);
    return same;
  }
  bool
  GetComparesDeviance() const override
  {
    return true;
  }

protected:
  SameAgain() = default;
  ~SameAgain() override = default;
};

int
ExerciseBasicObjectMethods()
{
  const auto start = itk::PoseStartSearch::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(start, PoseStartSearch, PoseStart);
  const auto side = itk::OtherSideHypothesis::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(side, OtherSideHypothesis, PoseHypothesis);
  const auto facing = itk::OtherFacingHypothesis::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(facing, OtherFacingHypothesis, PoseHypothesis);
  const auto jaws = itk::ExchangedJawsHypothesis::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(jaws, ExchangedJawsHypothesis, PoseHypothesis);
  const auto millimetres = itk::MillimetreLandmarksHypothesis::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(millimetres, MillimetreLandmarksHypothesis, PoseHypothesis);
  const auto spacing = itk::OtherSpacingHypothesis::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(spacing, OtherSpacingHypothesis, PoseHypothesis);
  const auto turned = itk::TurnedDrawingHypothesis::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(turned, TurnedDrawingHypothesis, PoseHypothesis);
  const auto upward = itk::UpwardDrawingHypothesis::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(upward, UpwardDrawingHypothesis, PoseHypothesis);
  const auto landmarks = itk::ExchangedLandmarksHypothesis::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(landmarks, ExchangedLandmarksHypothesis, PoseHypothesis);
  return EXIT_SUCCESS;
}
} // namespace

TEST(PoseRegistrationParts, BasicObjectMethods)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
}

TEST(PoseRegistrationParts, DefaultsAreThoseOfThePreset)
{
  const auto method = MethodType::New();
  EXPECT_STREQ(method->GetOptimizer()->GetNameOfClass(), "LevenbergMarquardtOptimizerv4");
  EXPECT_STREQ(method->GetStart()->GetNameOfClass(), "PoseStartSearch");
  EXPECT_TRUE(method->GetMetrics().empty());
  EXPECT_TRUE(method->GetPrincipalPointKnown());
  EXPECT_EQ(method->GetTracedSide(), itk::TracedSideEnum::Right);
  EXPECT_EQ(method->GetMetric(), nullptr);
  EXPECT_EQ(method->GetNumberOfLevels(), 4u);
  EXPECT_EQ(method->GetCurrentLevel(), 0u);
  std::ostringstream text;
  method->Print(text);
  EXPECT_TRUE(Contains(text.str(),
                       "Hypotheses: other-side facing jaws-exchanged landmarks-exchanged landmarks-mm "
                       "pixel-spacing turned-90 turned-180 turned-270 upward-drawing"));
  const auto search = itk::PoseStartSearch::New();
  EXPECT_NEAR(search->GetRotationRange(), 32.0 * 0.017453292519943295, 1e-15);
  EXPECT_NEAR(search->GetRotationStep(), 4.0 * 0.017453292519943295, 1e-15);
  EXPECT_EQ(search->GetHorizontalRange(), 64.0);
  EXPECT_EQ(search->GetVerticalRange(), 40.0);
  EXPECT_EQ(search->GetShiftStep(), 8.0);
  EXPECT_EQ(search->GetKappas().size(), 11u);
  EXPECT_EQ(search->GetKappas().front(), 0.0) << "the nominal scale is tried first";
}

TEST(PoseRegistrationParts, AUsersPriorMovesTheAnswerAndCountsInTheCovariance)
{
  // Held to 0.02 mm where the tracing knows the depth to a millimetre: the prior has its way.
  const auto method = MakeMethod();
  method->AddMetric(MakePosePrior(itk::PoseTy, 1.5, 0.02));
  method->Update();
  const auto & group = method->GetOutput()->GetResult().groups[0];
  EXPECT_GT(std::abs(Plain().groups[0].parameters[itk::PoseTy] - 1.5), 0.2) << "the case tells them apart";
  EXPECT_NEAR(group.parameters[itk::PoseTy], 1.5, 0.05);
  const unsigned int variance = 8 * itk::PoseTy;
  EXPECT_GT(std::sqrt(Plain().groups[0].covariance[variance]), 0.5);
  EXPECT_LT(std::sqrt(group.covariance[variance]), 0.0201);
  EXPECT_GT(std::sqrt(group.covariance[variance]), 0.019);
  // The rest goes on as well as before.
  EXPECT_LT(Typical().Error(method->GetOutput()->GetResult(), 0, 'R'), 2.5);
}

TEST(PoseRegistrationParts, AUsersPriorPullsByItsShareOfTheInformation)
{
  // As wide as the registration's own uncertainty of the height, and as far away: half of the way, but for what moves
  // along, and half of the variance.
  const auto         plain = Plain().groups[0];
  const unsigned int variance = 8 * itk::PoseTz;
  const double       sigma = std::sqrt(plain.covariance[variance]);
  const auto         method = MakeMethod();
  method->AddMetric(MakePosePrior(itk::PoseTz, plain.parameters[itk::PoseTz] + 2.0 * sigma, sigma));
  method->Update();
  const auto & group = method->GetOutput()->GetResult().groups[0];
  // The fit's noise is estimated lower than the covariance's (a shorter correlation, nothing absorbed): the tracing
  // weighs up to three times as much there.
  const double moved = (group.parameters[itk::PoseTz] - plain.parameters[itk::PoseTz]) / sigma;
  EXPECT_GT(moved, 0.2);
  EXPECT_LT(moved, 1.3);
  EXPECT_NEAR(group.covariance[variance] / plain.covariance[variance], 0.5, 0.1);
}

TEST(PoseRegistrationParts, AnUnknownOfAUsersOwnIsEstimatedAndTellsNothingOfThePose)
{
  const auto method = MakeMethod();
  const auto own = OffsetMetric::New();
  // Near where it belongs, so that it is not the steps' length that is tried here.
  own->SetBlockValues("offset", { 3.0 - Plain().groups[0].parameters[itk::PoseTz] });
  method->AddMetric(own);
  method->Update();
  const auto & group = method->GetOutput()->GetResult().groups[0];
  for (unsigned int k = 0; k < 7; ++k)
  {
    // One residual and one unknown more, the same minimum. A loose one: a stiff coupling damps steps along the height
    // more, and another way over the rough criterion may end in another of its valleys.
    const double sigma = std::sqrt(Plain().groups[0].covariance[8 * k]);
    EXPECT_NEAR(group.parameters[k], Plain().groups[0].parameters[k], 0.1 * sigma) << k;
    EXPECT_NEAR(std::sqrt(group.covariance[8 * k]), sigma, 0.02 * sigma) << k;
  }
  ASSERT_NE(method->GetMetric(), nullptr);
  EXPECT_TRUE(method->GetMetric()->GetState().HasBlock("offset"));
}

TEST(PoseRegistrationParts, ATermOfAUsersOwnTakesPartInTheChoiceAmongMinima)
{
  const auto devianceWith = [](double bet) {
    itk::PoseRegistrationOptions options;
    options.useInitialPose = true;
    options.initialPose = Plain().groups[0].parameters;
    const auto method = MakeMethod(options);
    method->ClearHypotheses();
    const auto term = BettingMetric::New();
    term->bet = bet;
    method->AddMetric(term);
    method->Update();
    return method->GetOutput()->GetResult().groups[0].candidates.at(0).deviance;
  };
  // What is known counts by three fifths less the evidence's fifth: two fifths.
  EXPECT_NEAR(devianceWith(10.0) - devianceWith(0.0), 4.0, 1e-9);
}

TEST(PoseRegistrationParts, ATermJoinsWhenItSays)
{
  using JoinsEnum = itk::LeastSquaresMetricv4::JoinsEnum;
  // In the search for where to begin, and in the first steps from there.
  const auto evaluationsOf = [](JoinsEnum joins) {
    std::atomic<unsigned int>   evaluations{ 0 };
    std::array<unsigned int, 2> before{};
    const auto                  term = itk::LeastSquaresFunctionMetricv4::New();
    term->SetBlocks({ itk::PoseStateBlocks::MakePose() });
    term->SetFunction([&evaluations](const std::vector<double> & pose) {
      ++evaluations;
      return std::vector<double>{ pose[itk::PoseTy] / 50.0 };
    });
    term->SetJoins(joins);
    const auto method = MakeMethod();
    method->ClearHypotheses();
    method->AddMetric(term);
    method->AddObserver(itk::MultiResolutionIterationEvent(), [&](const itk::EventObject &) {
      const unsigned int level = method->GetCurrentLevel();
      if (level == 1 || level == 2)
      {
        before[level - 1] = evaluations;
      }
      if (level < 3)
      {
        evaluations = 0;
      }
    });
    method->Update();
    EXPECT_GT(evaluations, 0u) << "it joins the refinement whatever it says";
    return before;
  };
  const auto start = evaluationsOf(JoinsEnum::Start);
  EXPECT_GT(start[0], 0u);
  EXPECT_GT(start[1], 0u);
  const auto candidates = evaluationsOf(JoinsEnum::Candidates);
  EXPECT_EQ(candidates[0], 0u);
  EXPECT_GT(candidates[1], 0u);
  const auto refinement = evaluationsOf(JoinsEnum::Refinement);
  EXPECT_EQ(refinement[0], 0u);
  EXPECT_EQ(refinement[1], 0u);
}

TEST(PoseRegistrationParts, ATermsErrorsComeThrough)
{
  const auto method = MakeMethod();
  auto       wrong = itk::ParameterPriorMetricv4::New();
  wrong->SetBlock({ "pose", { { "height", 0.0, 1.0, 0.0, true } } });
  wrong->SetPriors({ { 0.0, 1.0, 0.0 } });
  method->AddMetric(wrong);
  EXPECT_TRUE(Contains(MessageOfCall([&] { method->Update(); }),
                       "The block \"pose\" has 6 parameters in one metric and 1 in another"));
  method->ClearMetrics();
  method->AddMetric(itk::ParameterPriorMetricv4::New());
  EXPECT_TRUE(Contains(MessageOfCall([&] { method->Update(); }), "call SetBlock()"));
  method->ClearMetrics();
  method->Update();
  EXPECT_EQ(method->GetOutput()->GetResult().groups[0].parameters, Plain().groups[0].parameters);
}

TEST(PoseRegistrationParts, WhatAUsersFunctionThrowsIsNotTakenForAWrongGeometry)
{
  const auto method = MakeMethod();
  const auto term = itk::LeastSquaresFunctionMetricv4::New();
  term->SetBlocks({ itk::PoseStateBlocks::MakePose() });
  term->SetFunction([](const std::vector<double> &) -> std::vector<double> {
    throw std::invalid_argument("a table of the user's has no such row");
  });
  method->AddMetric(term);
  try
  {
    method->Update();
    FAIL() << "it was swallowed";
  }
  catch (const std::invalid_argument & error)
  {
    EXPECT_STREQ(error.what(), "a table of the user's has no such row");
  }
  // A geometry that cannot be is still an ExceptionObject that says what to call.
  itk::PoseGeometry geometry = Typical().geometry;
  geometry.sourceToDetector = 0.5 * geometry.sourceToMidsagittal;
  const auto wrong = PoseRegistrationTestCase::MakeMethod(Typical().jaws, geometry, itk::PoseRegistrationOptions());
  EXPECT_TRUE(Contains(MessageOfCall([&] { wrong->Update(); }), "SetGeometry()"));
}

TEST(PoseRegistrationParts, UpdateExecutesWhereSomethingHasChangedAndNotElse)
{
  const auto method = MakeMethod();
  const auto prior = MakePosePrior(itk::PoseTy, 1.5, 0.5);
  const auto start = itk::PoseStartSearch::New();
  method->AddMetric(prior);
  method->SetStart(start);
  method->ClearHypotheses();
  unsigned int runs = 0;
  method->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++runs; });
  method->Update();
  EXPECT_EQ(runs, 1u);
  const auto before = method->GetOutput()->GetResult().groups[0].parameters;
  method->Update();
  EXPECT_EQ(runs, 1u) << "nothing changed";
  auto priors = prior->GetPriors();
  priors[itk::PoseTy].mean = -1.5;
  prior->SetPriors(priors);
  method->Update();
  EXPECT_EQ(runs, 2u) << "a term changed";
  EXPECT_NE(method->GetOutput()->GetResult().groups[0].parameters, before);
  start->SetShiftStep(7.0);
  method->Update();
  EXPECT_EQ(runs, 3u) << "the start changed";
  method->AddHypothesis(SameAgain::New());
  method->Update();
  EXPECT_EQ(runs, 4u) << "a hypothesis came";
  auto options = method->GetOptions();
  options.maximumEvaluations = 10;
  method->SetOptions(options);
  method->Update();
  EXPECT_EQ(runs, 5u) << "an option changed";
  method->SetTracedSide(method->GetTracedSide());
  method->Update();
  EXPECT_EQ(runs, 5u) << "the same side as before";
  const auto noise = itk::CorrelatedNoiseModel::New();
  method->SetNoiseModel(noise);
  method->Update();
  EXPECT_EQ(runs, 6u) << "a noise model came";
  noise->SetCorrelationLength(20.0);
  method->Update();
  EXPECT_EQ(runs, 7u) << "the noise model changed";
  method->Update();
  EXPECT_EQ(runs, 7u) << "nothing changed";
}

TEST(PoseRegistrationParts, AStartOfAUsersOwnIsWhereItBegins)
{
  const auto method = MakeMethod();
  const auto start = GivenStart::New();
  auto       given = Plain().groups[0].parameters;
  given[itk::PosePitch] += 0.02;
  given[itk::PoseTx] += 1.0;
  start->starts = { { given, 0.5 } };
  method->SetStart(start);
  method->ClearHypotheses();
  method->Update();
  // Once a yaw.
  EXPECT_EQ(start->calls, 3u);
  EXPECT_EQ(start->maximum, method->GetOptions().startsPerYaw + 2);
  EXPECT_FALSE(start->searchesScale);
  EXPECT_FALSE(start->holdsRotation);
  for (unsigned int k = 0; k < 7; ++k)
  {
    // The same minimum within a fraction of what is not known anyway: the criterion is rough where contours are made
    // anew.
    EXPECT_NEAR(method->GetOutput()->GetResult().groups[0].parameters[k],
                Plain().groups[0].parameters[k],
                0.5 * std::sqrt(Plain().groups[0].covariance[8 * k]))
      << k;
  }
}

TEST(PoseRegistrationParts, AStartIsToldWhatIsNotKnownAndWhatIsHeld)
{
  auto geometry = Typical().geometry;
  geometry.pixelSpacingKnown = false;
  itk::PoseRegistrationOptions options;
  options.fixRotation = true;
  const auto method = PoseRegistrationTestCase::MakeMethod(Typical().jaws, geometry, options);
  const auto start = GivenStart::New();
  method->SetStart(start);
  method->Update();
  EXPECT_TRUE(start->searchesScale);
  EXPECT_TRUE(start->holdsRotation);
  EXPECT_EQ(start->calls, 1u) << "a rotation that is held is not searched over yaws";
  EXPECT_EQ(start->maximum, 2 * (options.startsPerYaw + 2));
  // It found nothing: no jaw is registered, and the solution says why.
  EXPECT_FALSE(method->GetOutput()->IsRegistered(JawEnum::Upper));
  EXPECT_TRUE(Contains(method->GetOutput()->GetJaw(JawEnum::Upper).failure, "no start was found"));
}

TEST(PoseRegistrationParts, WhereTheSearchFindsNothingTheGivenTransformIsWhereItBegins)
{
  const auto plain = MakeMethod();
  plain->Update();
  const auto method = MakeMethod();
  const auto start = GivenStart::New();
  method->SetStart(start);
  method->SetInitialTransform(
    JawEnum::Upper, plain->GetTransform(JawEnum::Upper), std::exp(Plain().groups[0].parameters[itk::PoseKappa]));
  method->Update();
  EXPECT_EQ(start->calls, 3u);
  EXPECT_TRUE(method->GetOutput()->GetOptions().useInitialPose);
  EXPECT_FALSE(method->GetOptions().useInitialPose) << "the method's own options stay";
  EXPECT_LT(Typical().Error(method->GetOutput()->GetResult(), 0, 'R'), 2.5);
  EXPECT_TRUE(method->GetOutput()->GetResult().groups[0].outcomes.empty()) << "no hypotheses beside a given start";
  itk::PoseRegistrationOptions held;
  held.fixScale = true;
  method->SetOptions(held);
  method->Update();
  EXPECT_EQ(start->calls, 3u) << "a search knows nothing of what is held";
  EXPECT_TRUE(method->GetOutput()->IsRegistered(JawEnum::Upper));
  method->SetOptions(itk::PoseRegistrationOptions());
  method->ClearInitialTransforms();
  method->Update();
  EXPECT_EQ(start->calls, 6u);
  EXPECT_FALSE(method->GetOutput()->IsRegistered(JawEnum::Upper));
  EXPECT_TRUE(Contains(MessageOfCall([&] { method->SetInitialTransform(JawEnum::Upper, nullptr, 0.0); }),
                       "The scale factor 0 of SetInitialTransform() must be positive"));
}

TEST(PoseRegistrationParts, HypothesesAreTriedWhereTheyAreThereAndWorthIt)
{
  ASSERT_NE(Plain().groups[0].FindOutcome("other-side"), nullptr);
  EXPECT_NE(Plain().groups[0].FindOutcome("other-side")->deviance, 0.0);
  EXPECT_EQ(Plain().groups[0].outcomes.size(), 1u) << "a good fit needs no other facing or jaws";
  const auto method = MakeMethod();
  const auto own = SameAgain::New();
  method->ClearHypotheses();
  method->AddHypothesis(own);
  method->Update();
  const auto & group = method->GetOutput()->GetResult().groups[0];
  EXPECT_EQ(own->jaws, 2u);
  EXPECT_EQ(group.outcomes.size(), 1u) << "the others were cleared";
  const auto * outcome = group.FindOutcome("same-again");
  ASSERT_NE(outcome, nullptr);
  // The same question, more quickly: about as good, and no evidence for either.
  EXPECT_NEAR(outcome->score, group.score, 0.05);
  EXPECT_LT(std::abs(outcome->deviance), 5.0);
  EXPECT_EQ(group.parameters, Plain().groups[0].parameters) << "hypotheses change nothing else";
  own->isWorthTrying = false;
  own->Modified();
  method->Update();
  EXPECT_EQ(method->GetOutput()->GetResult().groups[0].FindOutcome("same-again"), nullptr) << "not tried";
}

TEST(PoseRegistrationParts, HypothesesTurnTheQuestionIntoAnother)
{
  itk::PoseProblem problem;
  problem.jaws.resize(2);
  problem.jaws[1].jaw = itk::ToothCode::JawEnum::Lower;
  problem.jaws[0].tracing = Typical().contours[0];
  problem.jaws[1].tracing = Typical().contours[1];
  problem.completed = problem.nominal;
  problem.options.useInitialPose = true;
  itk::PoseGroupResult result;
  result.score = 0.1;

  const auto side = itk::OtherSideHypothesis::New();
  EXPECT_EQ(side->GetCode(), "other-side");
  EXPECT_TRUE(side->GetComparesDeviance());
  EXPECT_TRUE(side->IsWorthTrying(problem, result)) << "whatever the fit";
  const auto otherSide = side->Apply(problem);
  EXPECT_EQ(otherSide.options.tracedSide, itk::TracedSideEnum::Left);
  EXPECT_EQ(side->Apply(otherSide).options.tracedSide, itk::TracedSideEnum::Right);
  EXPECT_FALSE(otherSide.options.checkHypotheses);
  EXPECT_FALSE(otherSide.options.useInitialPose);
  EXPECT_EQ(otherSide.options.yawStarts, std::vector<double>{ 0.0 });
  auto both = problem;
  both.options.tracedSide = itk::TracedSideEnum::Both;
  EXPECT_FALSE(side->IsWorthTrying(both, result));

  const auto facing = itk::OtherFacingHypothesis::New();
  EXPECT_EQ(facing->GetCode(), "facing");
  EXPECT_FALSE(facing->GetComparesDeviance());
  EXPECT_FALSE(facing->IsWorthTrying(problem, result)) << "a good fit";
  result.score = 0.3;
  EXPECT_TRUE(facing->IsWorthTrying(problem, result));
  EXPECT_EQ(facing->Apply(problem).nominal.facingSign, -problem.nominal.facingSign);
  EXPECT_FALSE(facing->Apply(problem).completed.has_value()) << "what was estimated is estimated anew";

  const auto exchanged = itk::ExchangedJawsHypothesis::New();
  EXPECT_EQ(exchanged->GetCode(), "jaws-exchanged");
  EXPECT_TRUE(exchanged->IsWorthTrying(problem, result));
  const auto other = exchanged->Apply(problem);
  EXPECT_EQ(other.jaws[0].jaw, itk::ToothCode::JawEnum::Lower);
  EXPECT_EQ(other.jaws[1].jaw, itk::ToothCode::JawEnum::Upper);
  EXPECT_EQ(other.jaws[0].tracing.GetPointer(), problem.jaws[1].tracing.GetPointer());
  EXPECT_EQ(other.jaws[0].frame.rotation[8], -1.0) << "it stands on its head";

  const auto landmarks = itk::ExchangedLandmarksHypothesis::New();
  EXPECT_EQ(landmarks->GetCode(), "landmarks-exchanged");
  EXPECT_FALSE(landmarks->IsWorthTrying(problem, result)) << "there are none";
  auto                                     marks = itk::CephalometricLandmarkSet::New();
  itk::CephalometricLandmarkSet::PointType point;
  point.Fill(1.0);
  marks->AddLandmark("Is", point, 2.5, 0.5);
  point.Fill(2.0);
  marks->AddLandmark("UL6_MB", point);
  for (auto & jaw : problem.jaws)
  {
    jaw.landmarks = marks;
    jaw.counterparts = itk::LandmarkCounterpartSet::New();
  }
  EXPECT_FALSE(landmarks->IsWorthTrying(problem, result)) << "a tracing says its jaw by itself";
  auto untraced = problem;
  untraced.jaws[0].tracing = nullptr;
  untraced.jaws[1].tracing = nullptr;
  EXPECT_TRUE(landmarks->IsWorthTrying(untraced, result));
  EXPECT_EQ(landmarks->GetObstacle(untraced), "");
  auto incisors = itk::CephalometricLandmarkSet::New();
  incisors->AddLandmark("Is", point);
  incisors->AddLandmark("Ii", point);
  incisors->AddLandmark("U1_root", point);
  auto inFront = untraced;
  for (auto & jaw : inFront.jaws)
  {
    jaw.landmarks = incisors;
  }
  EXPECT_NE(landmarks->GetObstacle(inFront), "") << "a turn of the head makes up for it";
  // Each jaw is given the marks of both: two are two, and fit at any spacing.
  const auto spacing = itk::OtherSpacingHypothesis::New();
  const auto isSpacingAsked = [&](std::initializer_list<const char *> names) {
    auto asked = untraced;
    asked.nominal.pixelSpacingKnown = true;
    auto all = itk::CephalometricLandmarkSet::New();
    auto places = itk::LandmarkCounterpartSet::New();
    for (const char * name : names)
    {
      all->AddLandmark(name, point);
      places->Add({ name,
                    itk::ToothCode::JawEnum::Unknown,
                    { {} },
                    itk::LandmarkCounterpartSet::RuleEnum::Middle,
                    0.2,
                    0.2,
                    "made" });
    }
    for (auto & jaw : asked.jaws)
    {
      jaw.landmarks = all;
      jaw.counterparts = places;
    }
    return spacing->IsWorthTrying(asked, result);
  };
  EXPECT_TRUE(isSpacingAsked({ "U1_tip", "U6_MB", "L1_tip", "L6_MB" }));
  EXPECT_FALSE(isSpacingAsked({ "U1_tip", "L1_tip" }));
  EXPECT_FALSE(isSpacingAsked({ "U1_tip", "U6_MB", "L1_tip" }));
  const auto renamed = landmarks->Apply(untraced).jaws[1].landmarks;
  ASSERT_EQ(renamed->GetNumberOfLandmarks(), 2u);
  ASSERT_NE(renamed->Find("L1_tip"), nullptr);
  EXPECT_EQ(renamed->Find("L1_tip")->sigma, 2.5);
  EXPECT_EQ(renamed->Find("L1_tip")->confidence, 0.5);
  ASSERT_NE(renamed->Find("LL6_MB"), nullptr) << "the side stays";
  EXPECT_EQ(renamed->Find("LL6_MB")->point, point);

  const auto millimetres = itk::MillimetreLandmarksHypothesis::New();
  EXPECT_FALSE(millimetres->IsWorthTrying(problem, result)) << "a tracing says its unit by its size";
  untraced.nominal.pixelSpacingKnown = true;
  untraced.nominal.pixelSpacing = { { 0.25, 0.5 } };
  EXPECT_TRUE(millimetres->IsWorthTrying(untraced, result));
  const auto pixels = millimetres->Apply(untraced).jaws[0].landmarks;
  EXPECT_DOUBLE_EQ(pixels->Find("U1_tip")->point[0], 4.0);
  EXPECT_DOUBLE_EQ(pixels->Find("U1_tip")->point[1], 2.0);
  untraced.nominal.pixelSpacingKnown = false;
  EXPECT_FALSE(millimetres->IsWorthTrying(untraced, result)) << "there is nothing to divide by";

  problem.jaws.resize(1);
  EXPECT_FALSE(exchanged->IsWorthTrying(problem, result)) << "there is nothing to exchange it with";
  untraced.jaws.resize(1);
  EXPECT_FALSE(landmarks->IsWorthTrying(untraced, result));
}

TEST(PoseRegistrationParts, ATurnedDrawingIsTurnedBackPointByPoint)
{
  itk::PoseProblem problem;
  problem.nominal.pixelSpacing = { { 0.2, 0.3 } };
  auto                          tracing = itk::DentalContour::New();
  itk::DentalContour::PointType point;
  point[0] = 10.0;
  point[1] = 3.0;
  tracing->AddPolyline({ point, point }, itk::ToothCode(11));
  itk::PoseJawInput jaw;
  jaw.tracing = tracing;
  auto marks = itk::CephalometricLandmarkSet::New();
  marks->AddLandmark("U1_tip", point, 2.5, 0.5);
  jaw.landmarks = marks;
  problem.jaws = { jaw };
  const auto turned = itk::TurnedDrawingHypothesis::New();
  EXPECT_EQ(turned->GetCode(), "turned-180");
  // Clockwise as it is seen: what is to the right comes to lie below.
  const std::array<std::array<double, 2>, 3> places{ { { { -3.0, 10.0 } }, { { -10.0, -3.0 } }, { { 3.0, -10.0 } } } };
  for (unsigned int turns = 1; turns <= 3; ++turns)
  {
    turned->SetQuarterTurns(turns);
    EXPECT_EQ(turned->GetCode(), "turned-" + std::to_string(90 * turns));
    const auto other = turned->Apply(problem);
    const auto polyline = other.jaws[0].tracing->GetPolylines().at(0);
    EXPECT_EQ(polyline.code, itk::ToothCode(11));
    for (unsigned int d = 0; d < 2; ++d)
    {
      EXPECT_EQ(polyline.points[0][d], places[turns - 1][d]) << turns;
      EXPECT_EQ(other.jaws[0].landmarks->Find("U1_tip")->point[d], places[turns - 1][d]) << turns;
      EXPECT_EQ(other.nominal.pixelSpacing[d],
                turns == 2 ? problem.nominal.pixelSpacing[d] : problem.nominal.pixelSpacing[1 - d]);
    }
    EXPECT_EQ(other.jaws[0].landmarks->Find("U1_tip")->sigma, 2.5);
    EXPECT_FALSE(other.nominal.principalPointKnown);
  }
  EXPECT_THROW(turned->SetQuarterTurns(0), itk::ExceptionObject);
  EXPECT_THROW(turned->SetQuarterTurns(4), itk::ExceptionObject);
}

TEST(PoseRegistrationParts, ADrawingThatCountedItsRowsFromBelowIsMirroredPointByPoint)
{
  itk::PoseProblem problem;
  problem.nominal.pixelSpacing = { { 0.2, 0.3 } };
  itk::DentalContour::PointType point;
  point[0] = 10.0;
  point[1] = 3.0;
  auto tracing = itk::DentalContour::New();
  tracing->AddPolyline({ point, point }, itk::ToothCode(11));
  auto marks = itk::CephalometricLandmarkSet::New();
  marks->AddLandmark("U1_tip", point, 2.5, 0.5);
  itk::PoseJawInput jaw;
  jaw.tracing = tracing;
  jaw.landmarks = marks;
  jaw.initialPose = itk::PoseParameters();
  problem.jaws = { jaw };
  const auto other = itk::UpwardDrawingHypothesis::New()->Apply(problem);
  const auto polyline = other.jaws[0].tracing->GetPolylines().at(0);
  EXPECT_EQ(polyline.code, itk::ToothCode(11));
  EXPECT_EQ(polyline.points[1][0], 10.0);
  EXPECT_EQ(polyline.points[1][1], -3.0);
  const auto * mark = other.jaws[0].landmarks->Find("U1_tip");
  EXPECT_EQ(mark->point[0], 10.0);
  EXPECT_EQ(mark->point[1], -3.0);
  EXPECT_EQ(mark->sigma, 2.5);
  EXPECT_EQ(mark->confidence, 0.5);
  EXPECT_FALSE(other.jaws[0].initialPose.has_value());
  EXPECT_FALSE(other.nominal.principalPointKnown);
  EXPECT_FALSE(other.nominal.pixelSpacingKnown) << "it may be in mm";
  EXPECT_EQ(problem.jaws[0].tracing->GetPolylines().at(0).points[0][1], 3.0) << "the problem's own stays";
}

TEST(PoseRegistrationParts, AHypothesisRunsAloneAndGivesWhatItGivesBesideTheResult)
{
  const auto method = MakeMethod();
  method->ClearHypotheses();
  const auto   alone = method->TryHypothesis(itk::OtherSideHypothesis::New(), JawEnum::Upper);
  const auto * beside = Plain().groups[0].FindOutcome("other-side");
  ASSERT_NE(beside, nullptr);
  EXPECT_EQ(alone.score, beside->score) << "the same bits";
  EXPECT_EQ(alone.deviance, beside->deviance);
  EXPECT_TRUE(method->GetOutput()->GetResult().groups[0].outcomes.empty()) << "the solution stays as it was";
  EXPECT_EQ(method->GetOutput()->GetResult().groups[0].parameters, Plain().groups[0].parameters);

  // One that a good fit makes not worth trying is tried nevertheless, and is as bad as it should be.
  const auto exchanged = method->TryHypothesis(itk::ExchangedJawsHypothesis::New(), JawEnum::Lower);
  EXPECT_GT(exchanged.score, Plain().groups[0].score + 0.1);
  EXPECT_EQ(exchanged.deviance, 0.0) << "its likelihood is not asked for";

  // A registration that stands does not run again; a changed one does.
  unsigned int runs = 0;
  method->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++runs; });
  method->TryHypothesis(SameAgain::New(), JawEnum::Upper);
  EXPECT_EQ(runs, 0u);
  method->SetTracedSide(itk::TracedSideEnum::Left);
  EXPECT_NE(method->TryHypothesis(itk::OtherSideHypothesis::New(), JawEnum::Upper).deviance, alone.deviance);
  EXPECT_EQ(runs, 1u);
}

TEST(PoseRegistrationParts, AHypothesisThatCannotBeAskedSaysWhy)
{
  const auto side = itk::OtherSideHypothesis::New();
  const auto facing = itk::OtherFacingHypothesis::New();
  const auto exchanged = itk::ExchangedJawsHypothesis::New();
  const auto messageOf = [](MethodType * method, const itk::PoseHypothesis * hypothesis) {
    return MessageOfCall([&] { method->TryHypothesis(hypothesis, JawEnum::Upper); });
  };
  const auto method = MakeMethod();
  EXPECT_TRUE(Contains(messageOf(method, nullptr), "TryHypothesis() was given no hypothesis"));
  itk::PoseRegistrationOptions options;
  options.useSideSelection = false;
  method->SetOptions(options);
  const std::string noSide = messageOf(method, side);
  EXPECT_TRUE(Contains(noSide, "\"other-side\" cannot be tried: the tracing is of no side")) << noSide;
  options = itk::PoseRegistrationOptions();
  options.useJointPose = false;
  method->SetOptions(options);
  EXPECT_TRUE(Contains(messageOf(method, exchanged), "two jaws that share a pose"));
  options.fixScale = true;
  method->SetOptions(options);
  EXPECT_TRUE(Contains(messageOf(method, side), "beside a given start or held values"));
  method->SetLowerContour(nullptr);
  EXPECT_TRUE(Contains(MessageOfCall([&] { method->TryHypothesis(side, JawEnum::Lower); }), "lower jaw"));
}

TEST(PoseRegistrationParts, ATermOfOnesOwnIsNotTriedAgainstUnderAnotherMeaning)
{
  // The patient said to face the other way: a poor fit, so that every hypothesis is worth trying.
  itk::PoseGeometry geometry = Typical().geometry;
  geometry.facingSign = -geometry.facingSign;
  const auto method = PoseRegistrationTestCase::MakeMethod(Typical().jaws, geometry, itk::PoseRegistrationOptions());
  using Codes = std::vector<std::string>;
  const auto codesOf = [](const auto & entries) {
    Codes codes;
    for (const auto & entry : entries)
    {
      codes.push_back(entry.first);
    }
    return codes;
  };
  const auto notTried = [&] {
    const auto lines =
      itk::RegistrationVerdict::GetNotCheckable(method->GetOutput()->GetResult(), method->GetOptions());
    return std::count_if(
      lines.begin(), lines.end(), [](const std::string & line) { return Contains(line, "\": not tried, the added "); });
  };
  method->Update();
  itk::PoseGroupResult group = method->GetOutput()->GetResult().groups[0];
  EXPECT_EQ(codesOf(group.outcomes),
            (Codes{ "facing",
                    "jaws-exchanged",
                    "other-side",
                    "pixel-spacing",
                    "turned-180",
                    "turned-270",
                    "turned-90",
                    "upward-drawing" }));
  EXPECT_TRUE(group.untried.empty());
  EXPECT_EQ(notTried(), 0);

  // About the patient: whichever way the patient faces, but not of a frame that stands on its head.
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Unknown })
  {
    method->ClearMetrics();
    method->AddMetric(MakePosePrior(itk::PoseTz, 0.0, 100.0), jaw);
    method->Update();
    group = method->GetOutput()->GetResult().groups[0];
    EXPECT_EQ(
      codesOf(group.outcomes),
      (Codes{ "facing", "other-side", "pixel-spacing", "turned-180", "turned-270", "turned-90", "upward-drawing" }));
    ASSERT_EQ(codesOf(group.untried), (Codes{ "jaws-exchanged" }));
    EXPECT_EQ(group.untried.begin()->second,
              "the added ParameterPriorMetricv4 is about the jaws' dental frame, which turns over with them");
    EXPECT_EQ(notTried(), 1);
  }

  // With a radiograph of its own: facing, spacing and turns are a matter of both.
  auto view = itk::SilhouettePoseMetricv4::New();
  auto transform = itk::CephalometricPoseTransform::New();
  transform->SetPoseGeometry(geometry);
  view->SetTransform(transform);
  view->SetFixedContour(Typical().contours[0]);
  view->SetMovingSurface(
    dynamic_cast<const itk::SilhouettePoseMetricv4 &>(*method->GetModifiableMetric()->GetMetric(0)).GetMovingSurface());
  method->ClearMetrics();
  method->AddMetric(view);
  method->Update();
  group = method->GetOutput()->GetResult().groups[0];
  EXPECT_EQ(codesOf(group.outcomes), (Codes{ "other-side" }));
  EXPECT_EQ(
    codesOf(group.untried),
    (Codes{ "facing", "jaws-exchanged", "pixel-spacing", "turned-180", "turned-270", "turned-90", "upward-drawing" }));
  EXPECT_EQ(notTried(), 7);

  // A block that is no pose is nothing that turns.
  method->ClearMetrics();
  auto scale = itk::ParameterPriorMetricv4::New();
  scale->SetBlock(itk::PoseStateBlocks::MakeScale());
  scale->SetPriors({ { 0.0, 1.0, 0.0 } });
  method->AddMetric(scale);
  method->Update();
  group = method->GetOutput()->GetResult().groups[0];
  EXPECT_TRUE(group.untried.empty());
  EXPECT_EQ(group.outcomes.size(), 8u);
}

TEST(PoseRegistrationParts, JawsWithPosesOfTheirOwnAreGroupsOfTheirOwn)
{
  itk::PoseRegistrationOptions options;
  options.useJointPose = false;
  const auto method = MakeMethod(options);
  method->AddMetric(MakePosePrior(itk::PoseTy, 0.0, 5.0));
  method->Update();
  const auto & result = method->GetOutput()->GetResult();
  ASSERT_EQ(result.groups.size(), 2u);
  EXPECT_EQ(result.groupOfJaw, (std::vector<std::size_t>{ 0, 1 }));
  EXPECT_NE(result.groups[0].parameters, result.groups[1].parameters);
  for (unsigned int jaw : { 0u, 1u })
  {
    EXPECT_EQ(result.groups[jaw].jaws, std::vector<std::size_t>{ jaw });
    EXPECT_LT(Typical().Error(result, jaw, 'R'), 2.5);
    EXPECT_TRUE(result.jaws[jaw].registered);
  }
  EXPECT_EQ(&method->GetOutput()->GetGroup(JawEnum::Lower), &result.groups[1]);
  EXPECT_TRUE(method->GetJawsShareFrame()) << "one frame, two poses";
}

TEST(PoseRegistrationParts, ATermOfOneJawLeavesTheOthersPoseAlone)
{
  itk::PoseRegistrationOptions options;
  options.useJointPose = false;
  options.checkHypotheses = false;
  const auto plain = MakeMethod(options);
  plain->Update();
  const auto method = MakeMethod(options);
  method->AddMetric(MakePosePrior(itk::PoseTy, 1.5, 0.02), JawEnum::Lower);
  EXPECT_EQ(method->GetMetricJaws(), std::vector<JawEnum>{ JawEnum::Lower });
  method->Update();
  const auto & without = plain->GetOutput()->GetResult().groups;
  const auto & with = method->GetOutput()->GetResult().groups;
  ASSERT_EQ(with.size(), 2u);
  EXPECT_EQ(with[0].parameters, without[0].parameters) << "to the bit";
  EXPECT_GT(std::abs(without[1].parameters[itk::PoseTy] - 1.5), 0.2) << "the case tells them apart";
  EXPECT_NEAR(with[1].parameters[itk::PoseTy], 1.5, 0.05);
  // One pose is that of both jaws.
  const auto joint = MakeMethod();
  joint->AddMetric(MakePosePrior(itk::PoseTy, 1.5, 0.02), JawEnum::Lower);
  joint->Update();
  EXPECT_NEAR(joint->GetOutput()->GetResult().groups[0].parameters[itk::PoseTy], 1.5, 0.05);
  joint->SetLowerContour(nullptr);
  EXPECT_TRUE(
    Contains(MessageOfCall([&] { joint->Update(); }), "a term of the lower jaw, which lacks its mesh or contour"));
}

TEST(PoseRegistrationParts, AUsersSilhouetteKeepsItsKernelAndItsNoise)
{
  // The user's is the upper jaw's silhouette once more, with settings of its own.
  itk::PoseRegistrationOptions options;
  options.checkHypotheses = false;
  options.yawStarts = { 0.0 };
  const auto                           first = MakeMethod(options);
  itk::SilhouettePoseMetricv4::Pointer own;
  first->AddObserver(itk::MultiResolutionIterationEvent(), [&](const itk::EventObject &) {
    if (own.IsNull())
    {
      own = dynamic_cast<const itk::SilhouettePoseMetricv4 *>(first->GetMetric()->GetMetric(0))->Clone();
    }
  });
  first->Update();
  ASSERT_TRUE(own.IsNotNull());
  auto model = itk::CorrelatedNoiseModel::New();
  model->SetCorrelationLength(5.0);
  const auto kernel = itk::SquaresKernel::New();
  own->SetRobustKernel(kernel);
  own->SetKernelWidth(7.0);
  own->SetNoiseModel(model);
  own->SetNoiseLevels({ 3.0, 2.0 });
  const auto method = MakeMethod(options);
  method->AddMetric(own);
  method->Update();
  const auto check = [&](const itk::SilhouettePoseMetricv4 * silhouette) {
    ASSERT_NE(silhouette, nullptr);
    EXPECT_EQ(silhouette->GetRobustKernel(), kernel.GetPointer());
    EXPECT_EQ(silhouette->GetKernelWidth(), 7.0);
    EXPECT_EQ(silhouette->GetNoiseModel(), model.GetPointer());
    itk::ContourNoiseLevels levels;
    EXPECT_TRUE(silhouette->GetNoiseLevels(levels));
    EXPECT_EQ(levels.smooth, 3.0);
    EXPECT_EQ(levels.white, 2.0);
  };
  check(own);
  const auto * sum = method->GetMetric();
  const auto   last = sum->GetNumberOfMetrics() - 1;
  EXPECT_EQ(sum->GetMetricSettings(last), itk::LeastSquaresSumMetricv4::SettingsEnum::Own);
  EXPECT_EQ(sum->GetMetricSettings(0), itk::LeastSquaresSumMetricv4::SettingsEnum::OfTheSum);
  check(dynamic_cast<const itk::SilhouettePoseMetricv4 *>(sum->GetMetric(last)));
  // Those of the method's own are annealed and estimated all the same.
  const auto * ofMethod = dynamic_cast<const itk::SilhouettePoseMetricv4 *>(sum->GetMetric(0));
  EXPECT_NE(ofMethod->GetKernelWidth(), 7.0);
  EXPECT_GT(method->GetOutput()->GetResult().groups[0].whiteSigma, 0.0);
  EXPECT_NE(method->GetOutput()->GetResult().groups[0].smoothSigma, 3.0);
  unsigned int runs = 0;
  method->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++runs; });
  method->Update();
  EXPECT_EQ(runs, 0u) << "a run changes nothing of the user's metric";

  // What is set to the value that it has changes nothing; any other change of the term is a change of the answer.
  const auto updateAfter = [&](const auto & change) {
    runs = 0;
    change();
    method->Update();
    return runs;
  };
  EXPECT_EQ(updateAfter([&] {
              own->SetRobustKernel(kernel);
              own->SetKernelWidth(7.0);
              own->SetNoiseModel(model);
              own->SetNoiseLevels({ 3.0, 2.0 });
              own->SetNoiseLevels({ 9.0, 9.0 }, itk::CorrelatedNoiseModel::New());
            }),
            0u);
  const auto before = method->GetOutput()->GetResult().groups[0].parameters;
  EXPECT_EQ(updateAfter([&] { own->SetNoiseLevels({ 0.1, 0.1 }); }), 1u);
  EXPECT_NE(method->GetOutput()->GetResult().groups[0].parameters, before) << "the new answer, not the old one";
  EXPECT_EQ(updateAfter([&] { own->SetKernelWidth(6.0); }), 1u);
  EXPECT_EQ(updateAfter([&] { model->SetCorrelationLength(6.0); }), 1u);
  EXPECT_EQ(updateAfter([&] { own->SetNoiseModel(itk::CorrelatedNoiseModel::New()); }), 1u);
  EXPECT_EQ(updateAfter([&] { own->SetRobustKernel(itk::GemanMcClureKernel::New()); }), 1u);
  EXPECT_EQ(updateAfter([] {}), 0u);
}

TEST(PoseRegistrationParts, TheStartSeesTheJawsAndNotAUsersFurtherView)
{
  // A second radiograph of the same pose, with pixels of half the size and another place of them: what a start would
  // take from it, centroids and an outline in its pixels, lies far from the first one's.
  itk::PoseRegistrationOptions options;
  options.checkHypotheses = false;
  options.yawStarts = { 0.0 };
  const auto                           first = MakeMethod(options);
  itk::SilhouettePoseMetricv4::Pointer own;
  first->AddObserver(itk::MultiResolutionIterationEvent(), [&](const itk::EventObject &) {
    if (own.IsNull())
    {
      own = dynamic_cast<const itk::SilhouettePoseMetricv4 *>(first->GetMetric()->GetMetric(0))->Clone();
    }
  });
  first->Update();
  ASSERT_TRUE(own.IsNotNull());
  const auto moveAway = [&](itk::SilhouettePoseMetricv4 * silhouette) {
    itk::PoseGeometry geometry = silhouette->GetTransform()->GetPoseGeometry();
    for (unsigned int d = 0; d < 2; ++d)
    {
      geometry.pixelSpacing[d] *= 0.5;
      geometry.principalPoint[d] += 600.0;
    }
    auto transform = itk::CephalometricPoseTransform::New();
    transform->SetPoseGeometry(geometry);
    silhouette->SetTransform(transform);
    // A word at most: with large errors the term hardly counts in the fit, and the answer is that of the jaws.
    silhouette->SetNoiseLevels({ 1e4, 1e4 });
  };
  for (const bool isOwnBlock : { false, true })
  {
    const itk::SilhouettePoseMetricv4::Pointer view = own->Clone();
    if (isOwnBlock)
    {
      view->SetScaleBlock("scale of the second view");
      // Nothing else tells it.
      view->SetBlockFree("scale of the second view", false);
    }
    moveAway(view);
    auto sum = itk::LeastSquaresSumMetricv4::New();
    sum->AddMetric(own);
    sum->AddMetric(view, itk::LeastSquaresSumMetricv4::SettingsEnum::Own);
    sum->Initialize();
    EXPECT_EQ(itk::FindSilhouettes(*sum).size(), 2u);
    const auto ofStart = itk::FindSilhouettesOfStart(*sum);
    ASSERT_EQ(ofStart.size(), 1u);
    EXPECT_EQ(ofStart[0].metric, own.GetPointer());
    const auto method = MakeMethod(options);
    method->AddMetric(view);
    method->Update();
    const auto & parameters = method->GetOutput()->GetResult().groups[0].parameters;
    const auto & expected = first->GetOutput()->GetResult().groups[0].parameters;
    // The term's information is that of errors ten thousand times as large, 1e-8 of the jaws'. But its samples count in
    // the step by which the search ends, so that it ends elsewhere in the flat bottom: a tenth of the roll's and the
    // height's own uncertainty. From a start that is mixed up the answer is tens of degrees or millimetres off.
    for (unsigned int k = 0; k < 7; ++k)
    {
      EXPECT_NEAR(parameters[k], expected[k], k < 3 || k == 6 ? 5e-3 : 0.2) << "parameter " << k;
    }
  }
}

TEST(PoseRegistrationParts, PriorsFollowTheOptions)
{
  itk::PoseRegistrationOptions options;
  const itk::PosePriors        known(options, true);
  const itk::PosePriors        unknown(options, false);
  const auto                   fit = known.GetFitSigmas(false);
  EXPECT_EQ(fit[itk::PosePitch], Infinity);
  EXPECT_EQ(fit[itk::PoseRoll], options.rollSigma);
  EXPECT_EQ(fit[itk::PoseTy], options.tySigma);
  EXPECT_EQ(fit[itk::PoseKappa], options.kappaSigma);
  EXPECT_EQ(unknown.GetFitSigmas(false)[itk::PoseKappa], options.kappaSigmaWithoutSpacing);
  const auto similarity = known.GetFitSigmas(true);
  EXPECT_EQ(similarity[itk::PoseRoll], 0.0);
  EXPECT_EQ(similarity[itk::PoseYaw], 0.0);
  EXPECT_EQ(similarity[itk::PoseTy], 0.0);
  EXPECT_EQ(similarity[itk::PoseTz], Infinity);
  for (const double sigma : known.GetHeldSigmas())
  {
    EXPECT_EQ(sigma, 0.0);
  }
  // A user's prior on the same block stays as it is.
  auto       sum = itk::LeastSquaresSumMetricv4::New();
  const auto own = MakePosePrior(itk::PoseTy, 1.5, 0.5);
  known.AddTo(*sum);
  sum->AddMetric(own);
  known.SetPriors(*sum, known.GetCovarianceSigmas(), true);
  EXPECT_EQ(own->GetPriors()[itk::PoseTy].sigma, 0.5);
  EXPECT_FALSE(own->GetUseVariancePrecision());
  const auto * first = dynamic_cast<const itk::ParameterPriorMetricv4 *>(sum->GetMetric(0));
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->GetPriors()[itk::PoseYaw].degreesOfFreedom, options.rotationPriorFreedom);
  EXPECT_TRUE(first->GetUseVariancePrecision());
  itk::PosePriors::SetFree(*sum, similarity);
  EXPECT_EQ(sum->GetNumberOfParameters(), 4u);
}

TEST(PoseRegistrationParts, ErrorsSayWhatToCall)
{
  const auto method = MakeMethod();
  method->SetOptimizer(nullptr);
  EXPECT_TRUE(Contains(MessageOfCall([&] { method->Update(); }), "No optimizer: call SetOptimizer()"));
  method->SetOptimizer(itk::LevenbergMarquardtOptimizerv4::New());
  method->SetStart(nullptr);
  EXPECT_TRUE(Contains(MessageOfCall([&] { method->Update(); }), "No start: call SetStart()"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { method->AddMetric(nullptr); }), "AddMetric() was given no metric"));
  EXPECT_TRUE(
    Contains(MessageOfCall([&] { method->AddHypothesis(nullptr); }), "AddHypothesis() was given no hypothesis"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { method->AddHypothesis(itk::OtherSideHypothesis::New()); }),
                       "There is a hypothesis with the code \"other-side\" already"));
  auto geometry = Typical().geometry;
  geometry.sourceToDetector = 1000.0;
  const auto inconsistent =
    PoseRegistrationTestCase::MakeMethod(Typical().jaws, geometry, itk::PoseRegistrationOptions());
  const auto message = MessageOfCall([&] { inconsistent->Update(); });
  EXPECT_TRUE(Contains(message, "must be positive and smaller than the source-to-detector distance")) << message;
  EXPECT_TRUE(Contains(message, "SetGeometry()")) << message;
}
