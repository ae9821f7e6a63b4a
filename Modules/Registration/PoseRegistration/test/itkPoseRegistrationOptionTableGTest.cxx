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
#include "itkPoseRegistrationOptionTable.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{
using TableType = itk::PoseRegistrationOptionTable;

std::string
MessageOf(const std::string & assignment)
{
  itk::PoseRegistrationOptions options;
  try
  {
    TableType::Set(options, assignment);
  }
  catch (const std::invalid_argument & error)
  {
    EXPECT_TRUE(TableType::GetChanges(options).empty());
    return error.what();
  }
  return "no error";
}
} // namespace

TEST(PoseRegistrationOptionTable, EveryOptionReadsBackAsItPrints)
{
  const itk::PoseRegistrationOptions defaults;
  itk::PoseRegistrationOptions       options;
  EXPECT_GE(TableType::GetEntries().size(), 31u);
  for (const auto & entry : TableType::GetEntries())
  {
    EXPECT_FALSE(entry.description.empty()) << entry.name;
    TableType::Set(options, entry.name, TableType::Get(defaults, entry.name));
  }
  EXPECT_TRUE(TableType::GetChanges(options).empty());
  // To the last bit, too.
  EXPECT_EQ(options.yawStarts, defaults.yawStarts);
  EXPECT_EQ(options.rollSigma, defaults.rollSigma);
}

TEST(PoseRegistrationOptionTable, SetsSwitchesNumbersAndLists)
{
  itk::PoseRegistrationOptions options;
  TableType::Set(options, "useSideSelection=off");
  TableType::Set(options, "correlationLength=20.5");
  TableType::Set(options, "startsPerYaw=2");
  TableType::Set(options, "yawStarts=-0.1,0.1");
  EXPECT_FALSE(options.useSideSelection);
  EXPECT_EQ(options.correlationLength, 20.5);
  EXPECT_EQ(options.startsPerYaw, 2u);
  EXPECT_EQ(options.yawStarts, (std::vector<double>{ -0.1, 0.1 }));
  EXPECT_EQ(TableType::GetChanges(options),
            (std::vector<std::string>{
              "useSideSelection=off", "correlationLength=20.5", "yawStarts=-0.1,0.1", "startsPerYaw=2" }));
}

TEST(PoseRegistrationOptionTable, SaysWhatIsWrongAndChangesNothing)
{
  EXPECT_NE(MessageOf("magic=1").find("useSideSelection"), std::string::npos);
  EXPECT_NE(MessageOf("useSideSelection").find("NAME=VALUE"), std::string::npos);
  for (const char * wrong : { "useSideSelection=maybe",
                              "correlationLength=0",
                              "correlationLength=nan",
                              "correlationLength=1x",
                              "correlationLength=",
                              "startsPerYaw=1.5",
                              "startsPerYaw=-1",
                              "yawStarts=",
                              "yawStarts=0,one",
                              "rollSigma=-1" })
  {
    const std::string name = std::string(wrong).substr(0, std::string(wrong).find('='));
    EXPECT_NE(MessageOf(wrong).find(name), std::string::npos) << wrong;
    EXPECT_NE(MessageOf(wrong).find("expected"), std::string::npos) << wrong;
  }
}
