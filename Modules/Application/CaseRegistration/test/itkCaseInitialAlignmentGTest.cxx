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
// What a case says to start from, and what holds it there.
#include "itkCaseRegistrationTestCase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

namespace
{
using JawEnum = itk::ToothCode::JawEnum;

struct Start
{
  itk::OcclusionEnum occlusion;
  bool               fixed;
};

void
PrintTo(const Start & start, std::ostream * os)
{
  *os << (start.occlusion == itk::OcclusionEnum::Yes ? "one frame" : "frames of their own")
      << (start.fixed ? ", fixed" : "");
}

class CaseInitialAlignment : public ::testing::TestWithParam<Start>
{};
} // namespace

TEST_P(CaseInitialAlignment, ASimilarityOfTheResultLeadsBackToIt)
{
  const PhantomCase phantom(5, PhantomCase::SideEnum::Right, 16000);
  phantom.data->description.occlusion = GetParam().occlusion;
  const auto before = Register(phantom);
  for (const auto & jaw : before.jaws)
  {
    ASSERT_TRUE(jaw.second.registered);
    phantom.data->description.initialSimilarity[jaw.first] = jaw.second.similarity;
  }
  const bool fixed = GetParam().fixed;
  phantom.data->description.fixScale = fixed;
  phantom.data->description.fixRotation = fixed;
  phantom.data->description.fixTranslation = fixed;
  const auto after = Register(phantom);
  for (const auto & entry : after.jaws)
  {
    const itk::JawResult & now = entry.second;
    const itk::JawResult & then = before.jaws.at(entry.first);
    ASSERT_TRUE(now.registered);
    // A similarity leaves out the turns about the other axes: that is its rms.
    EXPECT_LT(now.error->mean, then.error->mean + Detail(then, "similarity_rms_px") + 1.0) << entry.first;
    // Jaws with one pose start from the upper one's; what is free may find a better place.
    if (fixed && (entry.first == JawEnum::Upper || GetParam().occlusion == itk::OcclusionEnum::No))
    {
      EXPECT_NEAR(now.similarity.rotation, then.similarity.rotation, 0.01) << entry.first;
      EXPECT_NEAR(now.similarity.scale, then.similarity.scale, 0.01) << entry.first;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Starts,
                         CaseInitialAlignment,
                         ::testing::Values(Start{ itk::OcclusionEnum::Yes, false },
                                           Start{ itk::OcclusionEnum::Yes, true },
                                           Start{ itk::OcclusionEnum::No, false },
                                           Start{ itk::OcclusionEnum::No, true }));

TEST(CaseInitialAlignment, APoseOfTheResultHoldsForEachJawInItsOwnFrame)
{
  const PhantomCase phantom(5, PhantomCase::SideEnum::Right, 16000);
  phantom.data->description.occlusion = itk::OcclusionEnum::No;
  const auto before = Register(phantom);
  phantom.data->description.initialPose = before.jaws.at(JawEnum::Upper).meshToCephalostat;
  phantom.data->description.fixScale = true;
  phantom.data->description.fixRotation = true;
  phantom.data->description.fixTranslation = true;
  const auto after = Register(phantom);
  for (const auto & jaw : after.jaws)
  {
    for (unsigned int i = 0; i < 12; ++i)
    {
      EXPECT_NEAR(jaw.second.meshToCephalostat[i], (*phantom.data->description.initialPose)[i], 1e-6) << jaw.first;
    }
  }
}
