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
#include "itkLeastSquaresSumMetricv4.h"

#include "itkCorrelatedNoiseModel.h"
#include "itkMessageOfCall.h"
#include "itkCurveFitMetric.h"
#include "itkLeastSquaresMetricChecker.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkParameterPriorMetricv4.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{
using itk::MessageOfCall;
using SumType = itk::LeastSquaresSumMetricv4;
using PriorMetricType = itk::ParameterPriorMetricv4;
using PositionType = SumType::PositionType;

PriorMetricType::Pointer
MakePrior(const std::string & block, const std::vector<PriorMetricType::PriorType> & priors)
{
  auto                       metric = PriorMetricType::New();
  PriorMetricType::BlockType declared{ block, {} };
  for (std::size_t k = 0; k < priors.size(); ++k)
  {
    declared.parameters.push_back({ std::string(1, static_cast<char>('a' + k)), 0.7 + k, 3.0 + k, 0.0, true });
  }
  metric->SetBlock(declared);
  metric->SetPriors(priors);
  return metric;
}

/** A curve; a prior on the same block; a sum within the sum, of a prior on a block of its own and one on the curve's.
 */
SumType::Pointer
MakeNestedSum()
{
  auto inner = SumType::New();
  inner->AddMetric(MakePrior("other", { { 0.2, 0.4, 4.0 }, { 1.0, 2.0, 0.0 }, { -1.0, 0.7, 0.0 } }));
  inner->AddMetric(MakePrior("curve", { { 2.0, 0.3, 0.0 }, { 0.1, 0.2, 0.0 } }));
  auto sum = SumType::New();
  sum->AddMetric(CurveFitMetric::New());
  sum->AddMetric(MakePrior("curve", { { 1.5, 0.8, 5.0 }, { 0.3, 0.5, 0.0 } }));
  sum->AddMetric(inner);
  sum->Initialize();
  return sum;
}

/** A metric without members: its clone is another one with its state. */
class PlainTerm : public itk::LeastSquaresMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PlainTerm);
  using Self = PlainTerm;
  using Superclass = itk::LeastSquaresMetricv4;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  itkNewMacro(Self);
  itkTypeMacro(PlainTerm, LeastSquaresMetricv4);

  BlocksType
  DeclareBlocks() const override
  {
    return { { "plain", { { "p", 1.0, 2.0, 0.0, true } } } };
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
    residuals[0] = x[0] * x[0] - 2.0;
    if (jacobian != nullptr)
    {
      jacobian->set_size(1, 1);
      (*jacobian)(0, 0) = 2.0 * x[0];
    }
  }

protected:
  PlainTerm() = default;
  ~PlainTerm() override = default;
  itk::LightObject::Pointer
  InternalClone() const override
  {
    auto clone = Self::New();
    clone->CopyState(*this);
    return clone.GetPointer();
  }
};

/** A term that keeps how far from the solution it was told to be. */
class ReachTerm : public PlainTerm
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ReachTerm);
  using Self = ReachTerm;
  using Superclass = PlainTerm;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  itkNewMacro(Self);
  itkTypeMacro(ReachTerm, PlainTerm);

  double reach{ 0.0 };

  void
  SetReach(double standardDeviations) override
  {
    reach = standardDeviations;
  }

protected:
  ReachTerm() = default;
  ~ReachTerm() override = default;
};

// Who derives from the base cannot forget InternalClone(): the class would be abstract. Who derives from a term can.
class ForgetfulTerm : public PlainTerm
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ForgetfulTerm);
  using Self = ForgetfulTerm;
  using Superclass = PlainTerm;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  itkNewMacro(Self);
  itkTypeMacro(ForgetfulTerm, PlainTerm);

  double setting{ 1.0 };

protected:
  ForgetfulTerm() = default;
  ~ForgetfulTerm() override = default;
};

/** Eight points of a level that nobody knows, with noise. */
class NoisyTerm : public itk::LeastSquaresMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(NoisyTerm);
  using Self = NoisyTerm;
  using Superclass = itk::LeastSquaresMetricv4;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  itkNewMacro(Self);
  itkTypeMacro(NoisyTerm, LeastSquaresMetricv4);

  double width{ 1.0 };
  double level{ 1.0 };

  BlocksType
  DeclareBlocks() const override
  {
    return { { "height", { { "h", 0.0, 1.0, 0.0, true } } } };
  }
  itk::SizeValueType
  GetNumberOfResiduals() const override
  {
    return 8;
  }
  void
  ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const override
  {
    residuals.set_size(8);
    for (unsigned int i = 0; i < 8; ++i)
    {
      residuals[i] = (x[0] - (i % 2 == 0 ? 0.0 : 1.0)) / level;
    }
    if (jacobian != nullptr)
    {
      jacobian->set_size(8, 1);
      jacobian->fill(1.0 / level);
    }
  }
  void
  SetKernelWidth(double value) override
  {
    width = value;
  }
  void
  SetNoiseLevels(const itk::ContourNoiseLevels & levels, const itk::ResidualNoiseModel *) override
  {
    level = levels.white;
  }
  bool
  GetNoiseLevels(itk::ContourNoiseLevels & levels, const itk::ResidualNoiseModel *) const override
  {
    levels = { 0.1, level };
    return true;
  }
  void
  AppendNoiseBlocks(const PositionType & x, std::vector<itk::ResidualNoiseBlock> & blocks) const override
  {
    itk::ResidualNoiseBlock block;
    block.model = m_Model;
    block.count = 8;
    block.weights.assign(8, 1.0);
    block.jacobian.assign(8, 1.0);
    block.correlation.assign(64, 0.0);
    for (unsigned int i = 0; i < 8; ++i)
    {
      block.residuals.push_back(x[0] - (i % 2 == 0 ? 0.0 : 1.0));
      block.correlation[9 * i] = 1.0;
    }
    blocks.push_back(block);
  }
  void
  AddFixedInformation(const PositionType &, MatrixType &, VectorType &, double &) const override
  {}

protected:
  NoisyTerm() = default;
  ~NoisyTerm() override = default;
  itk::LightObject::Pointer
  InternalClone() const override
  {
    auto clone = Self::New();
    clone->width = width;
    clone->level = level;
    clone->CopyState(*this);
    return clone.GetPointer();
  }

private:
  itk::ResidualNoiseModel::ConstPointer m_Model{ itk::CorrelatedNoiseModel::New().GetPointer() };
};

int
ExerciseBasicObjectMethods()
{
  const auto sum = MakeNestedSum();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(sum, LeastSquaresSumMetricv4, LeastSquaresMetricv4);
  return EXIT_SUCCESS;
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}
} // namespace

TEST(LeastSquaresSumMetricv4, BasicObjectMethodsAndTermsArePrinted)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  EXPECT_EQ(SumType::New()->GetNumberOfMetrics(), 0u);
  std::ostringstream text;
  MakeNestedSum()->Print(text);
  EXPECT_TRUE(Contains(text.str(), "Metric 2:"));
  EXPECT_TRUE(Contains(text.str(), "Block: other"));
}

TEST(LeastSquaresSumMetricv4, KeepsWhatEveryMetricPromisesWithSharedAndSeparateBlocksAndNested)
{
  const auto sum = MakeNestedSum();
  ASSERT_EQ(sum->GetNumberOfParameters(), 5u);
  ASSERT_EQ(sum->GetNumberOfResiduals(), 12u);
  LeastSquaresMetricChecker::Check(*sum);
  sum->SetBlockFree("other", { true, false, true });
  sum->SetBlockFree("curve", { false, true });
  LeastSquaresMetricChecker::Check(*sum);
}

TEST(LeastSquaresSumMetricv4, IsTheSumOfItsTermsOverTheUnionOfTheirBlocks)
{
  const auto         sum = MakeNestedSum();
  const PositionType x{ 2.9, 0.15, 0.4, 1.1, -0.6 };
  double             value = 0.0;
  EXPECT_EQ(sum->GetState().GetOffset("curve"), 0u) << "in the order in which terms were added";
  EXPECT_EQ(sum->GetState().GetOffset("other"), 2u);
  EXPECT_EQ(sum->GetTermPosition(0, x), (PositionType{ 2.9, 0.15 }));
  EXPECT_EQ(sum->GetTermPosition(1, x), (PositionType{ 2.9, 0.15 }));
  // The inner sum has its blocks in an order of its own.
  EXPECT_EQ(sum->GetTermPosition(2, x), (PositionType{ 0.4, 1.1, -0.6, 2.9, 0.15 }));
  SumType::VectorType gradient(5, 0.0);
  for (unsigned int t = 0; t < 3; ++t)
  {
    value += sum->GetMetric(t)->ComputeValue(sum->GetTermPosition(t, x));
  }
  EXPECT_EQ(sum->ComputeValue(x), value);
  // Terms' own information adds up to that of all residuals.
  SumType::VectorType residuals;
  SumType::MatrixType jacobian;
  sum->ComputeResiduals(x, residuals, &jacobian);
  SumType::MatrixType information(5, 5, 0.0);
  double              squares = 0.0;
  sum->AddFixedInformation(x, information, gradient, squares);
  EXPECT_NEAR(squares, residuals.squared_magnitude(), 1e-12 * squares);
  EXPECT_LT((information - jacobian.transpose() * jacobian).frobenius_norm(), 1e-12 * information.frobenius_norm());
  EXPECT_LT((gradient - jacobian.transpose() * residuals).magnitude(), 1e-12 * gradient.magnitude());
  // What a term does not read does not move it.
  for (unsigned int i = 0; i < 7; ++i)
  {
    for (unsigned int k = 2; k < 5; ++k)
    {
      EXPECT_EQ(jacobian(i, k), 0.0);
    }
  }
}

TEST(LeastSquaresSumMetricv4, TakesOverATermsValuesAndMasksUnlessItHasTheBlockAlready)
{
  const auto curve = CurveFitMetric::New();
  curve->SetBlockValues("curve", { 7.0, 0.4 });
  curve->SetBlockFree("curve", { true, false });
  const auto prior = MakePrior("curve", { { 1.5, 0.8, 5.0 }, { 0.3, 0.5, 0.0 } });
  prior->SetBlockValues("curve", { 8.0, 0.5 });
  const auto sum = SumType::New();
  sum->AddMetric(curve);
  sum->AddMetric(prior);
  EXPECT_EQ(sum->GetBlockValues("curve"), (std::vector<double>{ 7.0, 0.4 }));
  sum->Initialize();
  EXPECT_EQ(sum->GetNumberOfParameters(), 1u);
  // From then on the sum's are what counts.
  curve->SetBlockValues("curve", { 9.0, 0.6 });
  EXPECT_EQ(sum->GetBlockValues("curve"), (std::vector<double>{ 7.0, 0.4 }));
}

TEST(LeastSquaresSumMetricv4, RemovedTermTakesItsOwnBlocksWithItAndLeavesTheOthersValues)
{
  const auto sum = SumType::New();
  const auto curve = CurveFitMetric::New();
  const auto other = MakePrior("other", { { 0.2, 0.4, 4.0 } });
  sum->AddMetric(other);
  sum->AddMetric(curve);
  sum->SetBlockValues("curve", { 3.0, 0.1 });
  sum->SetBlockFree("curve", { false, true });
  sum->RemoveMetric(other);
  EXPECT_EQ(sum->GetNumberOfMetrics(), 1u);
  EXPECT_FALSE(sum->GetState().HasBlock("other"));
  EXPECT_EQ(sum->GetBlockValues("curve"), (std::vector<double>{ 3.0, 0.1 }));
  sum->Initialize();
  EXPECT_EQ(sum->GetNumberOfParameters(), 1u);
  EXPECT_TRUE(Contains(MessageOfCall([&] { sum->RemoveMetric(other); }), "no term of this sum"));
}

TEST(LeastSquaresSumMetricv4, FollowsATermThatReadsAnotherBlock)
{
  const auto curve = CurveFitMetric::New();
  const auto sum = SumType::New();
  sum->AddMetric(curve);
  sum->AddMetric(MakePrior("other", { { 0.2, 0.4, 4.0 } }));
  sum->SetBlockValues("other", { 0.9 });
  sum->Initialize();
  curve->block = "second";
  curve->SetBlockValues("second", { 5.0, 0.3 });
  sum->Initialize();
  EXPECT_EQ(sum->GetState().GetNumberOfParameters(), 3u);
  EXPECT_FALSE(sum->GetState().HasBlock("curve"));
  EXPECT_EQ(sum->GetBlockValues("second"), (std::vector<double>{ 5.0, 0.3 }));
  EXPECT_EQ(sum->GetBlockValues("other"), std::vector<double>{ 0.9 });
  LeastSquaresMetricChecker::Check(*sum);
}

TEST(LeastSquaresSumMetricv4, ClonesItsTerms)
{
  const auto             sum = MakeNestedSum();
  const SumType::Pointer clone = sum->Clone();
  ASSERT_EQ(clone->GetNumberOfMetrics(), 3u);
  for (unsigned int t = 0; t < 3; ++t)
  {
    EXPECT_NE(clone->GetMetric(t), sum->GetMetric(t));
  }
  const double value = sum->GetValue();
  dynamic_cast<PriorMetricType *>(clone->GetMetric(1))->SetPriors({ { 0.0, 0.1, 0.0 }, { 0.0, 0.1, 0.0 } });
  EXPECT_NE(clone->GetValue(), value);
  EXPECT_EQ(sum->GetValue(), value);
}

TEST(LeastSquaresSumMetricv4, ATermThatInheritsItsCloneIsAnErrorNotAnotherTerm)
{
  const auto forgetful = ForgetfulTerm::New();
  forgetful->setting = 3.0;
  const auto sum = SumType::New();
  sum->AddMetric(forgetful);
  sum->Initialize();
  const auto message = MessageOfCall([&] { sum->Clone(); });
  EXPECT_TRUE(Contains(message, "The term ForgetfulTerm cannot be cloned: implement InternalClone() of ForgetfulTerm"))
    << message;
  EXPECT_TRUE(Contains(message, "What it has now makes PlainTerm.")) << message;
}

TEST(LeastSquaresSumMetricv4, TermsWithoutMembersKeepTheirState)
{
  const auto plain = PlainTerm::New();
  plain->SetBlockValues("plain", { 4.0 });
  const auto sum = SumType::New();
  sum->AddMetric(plain);
  sum->AddMetric(CurveFitMetric::New());
  sum->Initialize();
  LeastSquaresMetricChecker::Check(*sum);
  const SumType::Pointer clone = sum->Clone();
  EXPECT_EQ(clone->GetMetric(0)->GetBlockValues("plain"), std::vector<double>{ 4.0 });
  clone->Hold(SumType::HoldEnum::Contours);
  EXPECT_EQ(clone->GetValue(), sum->GetValue());
}

TEST(LeastSquaresSumMetricv4, PriorPullsTheFitByItsShareOfTheInformation)
{
  // Linear in both: the mean of what two terms say, weighted by their precisions.
  const auto sum = SumType::New();
  sum->AddMetric(MakePrior("x", { { 1.0, 0.5, 0.0 } }));
  sum->AddMetric(MakePrior("x", { { 4.0, 1.0, 0.0 } }));
  sum->Initialize();
  const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
  optimizer->SetMetric(sum);
  optimizer->StartOptimization();
  EXPECT_NEAR(sum->GetBlockValues("x")[0], (4.0 * 1.0 + 1.0 * 4.0) / 5.0, 1e-7);
}

TEST(LeastSquaresSumMetricv4, ATermThatChangesChangesTheSumsTime)
{
  const auto sum = MakeNestedSum();
  const auto time = sum->GetMTime();
  dynamic_cast<PriorMetricType *>(sum->GetMetric(1))->SetPriors({ { 0.0, 0.1, 0.0 }, { 0.0, 0.1, 0.0 } });
  EXPECT_GT(sum->GetMTime(), time);
}

TEST(LeastSquaresSumMetricv4, ATermWithSettingsOfItsOwnIsNotConfigured)
{
  const auto sum = SumType::New();
  const auto ofTheSum = NoisyTerm::New();
  const auto own = NoisyTerm::New();
  sum->AddMetric(ofTheSum);
  sum->AddMetric(own, SumType::SettingsEnum::Own);
  sum->Initialize();
  EXPECT_EQ(sum->GetMetricSettings(0), SumType::SettingsEnum::OfTheSum);
  EXPECT_EQ(sum->GetMetricSettings(1), SumType::SettingsEnum::Own);
  EXPECT_TRUE(Contains(MessageOfCall([&] { sum->GetMetricSettings(2); }), "there is no term 2"));
  sum->SetKernelWidth(5.0);
  sum->SetNoiseLevels({ 0.0, 3.0 });
  EXPECT_EQ(ofTheSum->width, 5.0);
  EXPECT_EQ(ofTheSum->level, 3.0);
  EXPECT_EQ(own->width, 1.0);
  EXPECT_EQ(own->level, 1.0);
  // Only the sum's are estimated; a clone knows the difference.
  const SumType::Pointer clone = sum->Clone();
  EXPECT_EQ(clone->GetMetricSettings(1), SumType::SettingsEnum::Own);
  clone->EstimateNoise();
  EXPECT_NE(dynamic_cast<NoisyTerm *>(clone->GetMetric(0))->level, 3.0);
  EXPECT_EQ(dynamic_cast<NoisyTerm *>(clone->GetMetric(1))->level, 1.0);
  // What is known of the own one counts: all of its residuals.
  SumType::MatrixType information(1, 1, 0.0);
  SumType::VectorType gradient(1, 0.0);
  double              value = 0.0;
  sum->AddFixedInformation({ 0.5 }, information, gradient, value);
  EXPECT_EQ(information(0, 0), 8.0);
  EXPECT_EQ(gradient[0], -4.0 + 0.5 * 8.0);
}

TEST(LeastSquaresSumMetricv4, WhatIsKnownIsTheCriterionOfTheTermsWhoseNoiseIsNotEstimated)
{
  // At h = 0.75 the eight points are 0.75 and 0.25 off: 4 * 0.5625 + 4 * 0.0625 = 2.5. The prior has ((0.75 - 0.5) /
  // 0.5)^2 = 0.25.
  auto prior = MakePrior("height", { { 0.5, 0.5, 0.0 } });
  auto free = SumType::New();
  free->AddMetric(NoisyTerm::New());
  free->AddMetric(prior);
  EXPECT_DOUBLE_EQ(free->ComputeKnownDeviance({ 0.75 }, true), 0.25) << "the evidence has the points";
  EXPECT_DOUBLE_EQ(free->ComputeKnownDeviance({ 0.75 }, false), 2.75) << "there is no evidence beside it";
  auto own = SumType::New();
  own->AddMetric(NoisyTerm::New(), SumType::SettingsEnum::Own);
  own->AddMetric(prior);
  EXPECT_DOUBLE_EQ(own->ComputeKnownDeviance({ 0.75 }, true), 2.75) << "no noise of this term is estimated";
  auto outer = SumType::New();
  outer->AddMetric(free);
  EXPECT_DOUBLE_EQ(outer->ComputeKnownDeviance({ 0.75 }, true), 0.25) << "a sum in a sum is its terms";
}

TEST(LeastSquaresSumMetricv4, ATermIsClonedWithWhenItJoinsAndChangesTheSumsTime)
{
  auto term = PlainTerm::New();
  using JoinsEnum = PlainTerm::JoinsEnum;
  EXPECT_EQ(term->GetJoins(), JoinsEnum::Start);
  auto sum = SumType::New();
  sum->AddMetric(term);
  const auto before = sum->GetMTime();
  term->SetJoins(JoinsEnum::Start);
  EXPECT_EQ(sum->GetMTime(), before) << "nothing changed";
  term->SetJoins(JoinsEnum::Refinement);
  EXPECT_GT(sum->GetMTime(), before) << "a registration has to run again";
  EXPECT_EQ(sum->Clone()->GetMetric(0)->GetJoins(), JoinsEnum::Refinement);
}

TEST(LeastSquaresSumMetricv4, TheReachIsOfEveryTermWhateverSettingsItHas)
{
  auto shared = ReachTerm::New();
  auto own = ReachTerm::New();
  auto inner = SumType::New();
  inner->AddMetric(own, SumType::SettingsEnum::Own);
  auto sum = SumType::New();
  sum->AddMetric(shared);
  sum->AddMetric(inner);
  sum->SetReach(7.0);
  EXPECT_EQ(shared->reach, 7.0);
  EXPECT_EQ(own->reach, 7.0) << "of a term with settings of its own, in a sum in a sum";
  sum->SetReach(0.0);
  EXPECT_EQ(own->reach, 0.0);
}

TEST(LeastSquaresSumMetricv4, ErrorsSayWhatIsWrong)
{
  const auto sum = SumType::New();
  const auto nothing = MessageOfCall([&] { sum->Initialize(); });
  EXPECT_TRUE(Contains(nothing, "A sum of nothing: call AddMetric()")) << nothing;
  EXPECT_TRUE(Contains(MessageOfCall([&] { sum->AddMetric(nullptr); }), "it was given none"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { sum->AddMetric(sum); }), "a sum is none of its own"));
  sum->AddMetric(CurveFitMetric::New());
  EXPECT_TRUE(Contains(MessageOfCall([&] { sum->GetMetric(1); }), "The sum has 1 terms; there is no term 1"));
  const auto sizes = MessageOfCall([&] { sum->AddMetric(MakePrior("curve", { { 1.5, 0.8, 5.0 } })); });
  EXPECT_TRUE(Contains(sizes, "The block \"curve\" has 2 parameters in one metric and 1 in another")) << sizes;
  EXPECT_EQ(sum->GetNumberOfMetrics(), 1u) << "what was refused is no term";
  sum->Initialize();
  sum->SetBlockFree("curve", false);
  EXPECT_TRUE(Contains(MessageOfCall([&] { sum->Initialize(); }), "All parameters are held"));
  // A term that lacks something says so.
  const auto prior = PriorMetricType::New();
  sum->SetBlockFree("curve", true);
  sum->AddMetric(prior);
  EXPECT_TRUE(Contains(MessageOfCall([&] { sum->Initialize(); }), "call SetBlock()"));
}
