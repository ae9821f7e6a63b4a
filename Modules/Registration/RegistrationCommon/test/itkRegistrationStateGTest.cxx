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
#include "itkRegistrationState.h"

#include "itkMessageOfCall.h"
#include "itkCurveFitMetric.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace
{
using itk::MessageOfCall;
using StateType = itk::RegistrationState;
using Values = std::vector<double>;

/** Two blocks in which no two numbers are alike. */
StateType
MakeState()
{
  StateType state;
  state.AddBlock({ "pose", { { "pitch", 0.1, 64.0, 0.2, true }, { "tx", -3.0, 1.0, 0.0, true } } });
  state.AddBlock({ "scale", { { "kappa", 0.02, 32.0, 0.03, true } } });
  return state;
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}
} // namespace

TEST(RegistrationState, KeepsTheOrderInWhichBlocksWereAdded)
{
  StateType state = MakeState();
  EXPECT_EQ(state.GetNumberOfParameters(), 3u);
  EXPECT_EQ(state.GetValues(), (Values{ 0.1, -3.0, 0.02 }));
  EXPECT_EQ(state.GetOffset("pose"), 0u);
  EXPECT_EQ(state.GetOffset("scale"), 2u);
  EXPECT_EQ(state.GetBlock("pose").parameters[1].name, "tx");
  EXPECT_TRUE(state.HasBlock("scale"));
  EXPECT_FALSE(state.HasBlock("lower"));
  // A block that is there stays as it is.
  state.AddBlock({ "scale", { { "other", 5.0, 1.0, 0.0, false } } });
  EXPECT_EQ(state.GetBlocks().size(), 2u);
  EXPECT_EQ(state.GetBlockValues("scale"), Values{ 0.02 });
  EXPECT_TRUE(state.GetBlock("scale").parameters[0].isFree);
}

TEST(RegistrationState, FreeParametersAreScaledAndHeldOnesAreNotThere)
{
  StateType state = MakeState();
  EXPECT_EQ(state.GetFreeParameters(),
            StateType::OptimizerParametersType(std::vector<double>{ 6.4, -3.0, 0.64 }.data(), 3));
  EXPECT_EQ(state.GetMaximumSteps()[0], 12.8);
  EXPECT_EQ(state.GetMaximumSteps()[1], 0.0);
  EXPECT_EQ(state.GetMaximumSteps()[2], 0.96);
  state.SetBlockFree("pose", { false, true });
  EXPECT_EQ(state.GetNumberOfFreeParameters(), 2u);
  EXPECT_EQ(state.GetFreeIndices(), (std::vector<std::size_t>{ 1, 2 }));
  EXPECT_EQ(state.GetFreeScale(0), 1.0);
  EXPECT_EQ(state.GetFreeScale(1), 32.0);
  StateType::OptimizerParametersType parameters(2);
  parameters[0] = 7.0;
  parameters[1] = 1.6;
  EXPECT_EQ(state.Expand(parameters), (Values{ 0.1, 7.0, 0.05 }));
  EXPECT_EQ(state.GetValues(), (Values{ 0.1, -3.0, 0.02 })) << "expanding changes nothing";
  state.SetFreeParameters(parameters);
  EXPECT_EQ(state.GetValues(), (Values{ 0.1, 7.0, 0.05 }));
  EXPECT_EQ(state.GetBlockValues("scale"), Values{ 0.05 });
  state.SetBlockFree("pose", false);
  EXPECT_EQ(state.GetNumberOfFreeParameters(), 1u);
  state.SetBlockFree("pose", true);
  EXPECT_EQ(state.GetNumberOfFreeParameters(), 3u);
}

TEST(RegistrationState, SetsValuesOfABlockOrOfAll)
{
  StateType state = MakeState();
  state.SetBlockValues("pose", { 0.3, 4.0 });
  EXPECT_EQ(state.GetValues(), (Values{ 0.3, 4.0, 0.02 }));
  state.SetValues({ 1.0, 2.0, 3.0 });
  EXPECT_EQ(state.GetBlockValues("pose"), (Values{ 1.0, 2.0 }));
  std::ostringstream text;
  state.SetBlockFree("scale", false);
  state.Print(text, "  ");
  EXPECT_EQ(text.str(), "  pose: pitch=1 tx=2\n  scale: kappa=3 (held)\n");
}

TEST(RegistrationState, DefaultsOfAParameterAreAUnitThatIsFreeWithoutLimit)
{
  const StateType::ParameterType parameter;
  EXPECT_EQ(parameter.value, 0.0);
  EXPECT_EQ(parameter.scale, 1.0);
  EXPECT_EQ(parameter.maximumStep, 0.0);
  EXPECT_TRUE(parameter.isFree);
}

TEST(RegistrationState, ErrorsNameBlocksAndNumbers)
{
  StateType state = MakeState();
  EXPECT_TRUE(Contains(MessageOfCall([] { StateType().GetBlock("pose"); }),
                       "There is no block \"pose\" in the state; there is none: call Initialize()"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { state.GetBlockValues("lower"); }),
                       "There is no block \"lower\" in the state; there are \"pose\", \"scale\"."));
  EXPECT_TRUE(Contains(MessageOfCall([&] { state.GetOffset("lower"); }), "there are \"pose\", \"scale\""));
  const std::string sizes = MessageOfCall([&] { state.AddBlock({ "pose", { { "pitch", 0.0, 1.0, 0.0, true } } }); });
  EXPECT_TRUE(Contains(sizes, "\"pose\" has 2 parameters in one metric and 1 in another")) << sizes;
  EXPECT_TRUE(Contains(sizes, "(DeclareBlocks(); blocks() in Python)")) << sizes;
  EXPECT_TRUE(Contains(MessageOfCall([&] { state.SetBlockValues("pose", { 1.0 }); }),
                       "\"pose\" has 2 parameters, not 1 as in SetBlockValues()"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { state.SetBlockFree("pose", std::vector<bool>(3, true)); }),
                       "\"pose\" has 2 parameters, not 3 as in SetBlockFree()"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { state.SetValues({ 1.0 }); }), "The state has 3 parameters, not 1"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { state.Expand(StateType::OptimizerParametersType(2)); }),
                       "The state has 3 free parameters, not 2"));
  // What was refused changed nothing.
  EXPECT_EQ(state.GetValues(), (Values{ 0.1, -3.0, 0.02 }));
  EXPECT_EQ(state.GetNumberOfFreeParameters(), 3u);
}
