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
#include "itkRegistrationIterationCommand.h"

#include "itkLeastSquaresTestMetric.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkRegistrationIterationInformation.h"
#include "itkSquaresKernel.h"

#include "itkLBFGSBOptimizerv4.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace
{
using CommandType = itk::RegistrationIterationCommand;
using KindEnum = CommandType::KindEnum;

/** A registration of two levels that do nothing but tell of it. */
class Registration
  : public itk::Object
  , public itk::RegistrationIterationInformation
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(Registration);
  using Self = Registration;
  using Superclass = itk::Object;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);
  itkTypeMacro(Registration, Object);

  unsigned int
  GetCurrentLevel() const override
  {
    return level;
  }
  std::size_t
  GetOptimizerIteration() const override
  {
    return iteration;
  }
  double
  GetMetricValue() const override
  {
    return 10.0 - static_cast<double>(iteration);
  }
  itk::OptimizerParameters<double>
  GetOptimizerPosition() const override
  {
    itk::OptimizerParameters<double> position(2);
    position.Fill(static_cast<double>(iteration));
    return position;
  }
  std::string
  GetOptimizerStopConditionDescription() const override
  {
    return "enough";
  }

  void
  Run()
  {
    this->InvokeEvent(itk::StartEvent());
    for (level = 0; level < 2; ++level)
    {
      iteration = 0;
      this->InvokeEvent(itk::MultiResolutionIterationEvent());
      for (iteration = 1; iteration < 4; ++iteration)
      {
        this->InvokeEvent(itk::IterationEvent());
        this->InvokeEvent(itk::FunctionEvaluationIterationEvent());
      }
    }
    this->InvokeEvent(itk::EndEvent());
  }

protected:
  Registration() = default;
  ~Registration() override = default;

private:
  unsigned int level{ 0 };
  std::size_t  iteration{ 0 };
};

std::size_t
CountIterations(const CommandType * command)
{
  const auto & records = command->GetRecords();
  return static_cast<std::size_t>(std::count_if(
    records.begin(), records.end(), [](const auto & record) { return record.kind == KindEnum::Iteration; }));
}
} // namespace

TEST(RegistrationIterationCommand, RecordsWhatAnyRegistrationTellsOfItself)
{
  const auto registration = Registration::New();
  const auto command = CommandType::New();
  EXPECT_STREQ(command->GetNameOfClass(), "RegistrationIterationCommand");
  command->Observe(registration);
  registration->Run();
  const std::vector<KindEnum> expected{ KindEnum::Start,     KindEnum::Level, KindEnum::Iteration, KindEnum::Iteration,
                                        KindEnum::Iteration, KindEnum::Level, KindEnum::Iteration, KindEnum::Iteration,
                                        KindEnum::Iteration, KindEnum::End };
  std::vector<KindEnum>       kinds;
  for (const auto & record : command->GetRecords())
  {
    kinds.push_back(record.kind);
  }
  EXPECT_EQ(kinds, expected) << "evaluations are no iterations";
  const auto & third = command->GetRecords()[7];
  EXPECT_EQ(third.level, 1u);
  EXPECT_EQ(third.iteration, 2u);
  EXPECT_EQ(third.value, 8.0);
  EXPECT_EQ(third.parameters[1], 2.0);
  EXPECT_TRUE(third.stopReason.empty());
  EXPECT_EQ(command->GetRecords().back().stopReason, "enough");
  registration->Run();
  EXPECT_EQ(command->GetRecords().size(), expected.size()) << "starts anew with every run";
}

TEST(RegistrationIterationCommand, WritesALineAnEvent)
{
  const auto         registration = Registration::New();
  const auto         command = CommandType::New();
  std::ostringstream text;
  EXPECT_EQ(command->GetWriteEvery(), 1u);
  command->SetStream(&text);
  command->SetWriteEvery(2);
  command->Observe(registration);
  registration->Run();
  EXPECT_EQ(text.str(),
            "start\n"
            "level 0 value 10 parameters 0 0 (enough)\n"
            "level 0 iteration 2 value 8 parameters 2 2\n"
            "level 1 value 10 parameters 0 0 (enough)\n"
            "level 1 iteration 2 value 8 parameters 2 2\n"
            "end level 2 iteration 4 value 6 parameters 4 4 (enough)\n");
}

TEST(RegistrationIterationCommand, CountsIterationsOfABareOptimizerNotEvaluations)
{
  const auto                                 optimizer = itk::LBFGSBOptimizerv4::New();
  itk::LBFGSBOptimizerv4::BoundSelectionType selection(2);
  selection.Fill(itk::LBFGSBOptimizerv4::UNBOUNDED);
  optimizer->SetBoundSelection(selection);
  optimizer->SetNumberOfIterations(5);
  optimizer->SetMetric(LeastSquaresTest::MakeRosenbrock());
  const auto command = CommandType::New();
  command->Observe(optimizer);
  optimizer->StartOptimization();
  EXPECT_EQ(CountIterations(command), 5u);
  EXPECT_EQ(command->GetRecords().back().kind, KindEnum::End);
  EXPECT_FALSE(command->GetRecords().back().stopReason.empty());
}

TEST(RegistrationIterationCommand, RecordsEveryTriedStepOfLevenbergMarquardt)
{
  const auto optimizer = itk::LevenbergMarquardtOptimizerv4::New();
  optimizer->SetMetric(LeastSquaresTest::MakeRosenbrock());
  const auto command = CommandType::New();
  command->Observe(optimizer);
  optimizer->StartOptimization();
  EXPECT_EQ(CountIterations(command), optimizer->GetNumberOfEvaluations());
  EXPECT_EQ(command->GetRecords().back().stopReason, optimizer->GetStopConditionDescription());
  EXPECT_EQ(command->GetRecords().back().parameters, optimizer->GetCurrentPosition());
}

TEST(RegistrationIterationCommand, ErrorsSayWhatToGive)
{
  const auto command = CommandType::New();
  EXPECT_THROW(command->SetWriteEvery(0), itk::ExceptionObject);
  EXPECT_THROW(command->Observe(nullptr), itk::ExceptionObject);
  const auto  silent = itk::SquaresKernel::New();
  std::string message;
  try
  {
    command->Observe(silent);
  }
  catch (const itk::ExceptionObject & error)
  {
    message = error.GetDescription();
  }
  EXPECT_NE(message.find("SquaresKernel tells nothing of iterations: give Observe()"), std::string::npos) << message;
  EXPECT_FALSE(silent->HasObserver(itk::StartEvent()));
}
