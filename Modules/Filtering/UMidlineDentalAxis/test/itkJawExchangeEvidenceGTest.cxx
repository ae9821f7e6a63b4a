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
#include "itkJawExchangeEvidence.h"

#include "itkDentalFrameCohort.h"

#include <gtest/gtest.h>

namespace
{
using itk::JawExchangeEvidence;
} // namespace

TEST(JawExchangeEvidence, NothingMeasuredLeavesThePrior)
{
  const JawExchangeEvidence none(std::nullopt, std::nullopt);
  EXPECT_DOUBLE_EQ(none.GetLogLikelihoodRatio(), 0.0);
  EXPECT_NEAR(none.GetProbability(), 0.01, 1e-12);
}

TEST(JawExchangeEvidence, NamesExchangedChangeTheSignOfTheEvidence)
{
  for (const double width : { -7.0, -2.0, 0.5, 4.8 })
  {
    for (const double overjet : { -4.0, 1.0, 2.5 })
    {
      EXPECT_NEAR(JawExchangeEvidence(width, overjet).GetLogLikelihoodRatio(),
                  -JawExchangeEvidence(-width, -overjet).GetLogLikelihoodRatio(),
                  1e-12);
    }
  }
}

TEST(JawExchangeEvidence, NeitherACrossbiteNorAClassThreeAloneRaisesTheAlarm)
{
  // However far one measure is reversed, a person may have it.
  for (double reversed = 0.0; reversed <= 15.0; reversed += 0.25)
  {
    EXPECT_LT(JawExchangeEvidence(-reversed, std::nullopt).GetProbability(), 0.25) << reversed;
    EXPECT_LT(JawExchangeEvidence(std::nullopt, -reversed).GetProbability(), 0.25) << reversed;
    EXPECT_LT(JawExchangeEvidence(-reversed, 2.5).GetProbability(), 0.05) << reversed;
    EXPECT_LT(JawExchangeEvidence(4.8, -reversed).GetProbability(), 0.05) << reversed;
  }
  // An ordinary pair under the wrong names has both.
  EXPECT_GT(JawExchangeEvidence(-4.8, -2.5).GetProbability(), 0.5);
}

TEST(JawExchangeEvidence, ExchangedPhantomsAreToldFromThoseAsNamed)
{
  unsigned int           alarms = 0;
  unsigned int           missed = 0;
  constexpr unsigned int count = 12;
  for (std::uint64_t seed = 300; seed < 300 + count; ++seed)
  {
    const auto jaws = DentalFrameTest::MakePhantom(seed);
    const auto named = itk::EstimateDentalFrame(&jaws[0], &jaws[1], {});
    const auto exchanged = itk::EstimateDentalFrame(&jaws[1], &jaws[0], {});
    alarms += JawExchangeEvidence(named).GetProbability() > 0.5 ? 1 : 0;
    missed += JawExchangeEvidence(exchanged).GetProbability() > 0.5 ? 0 : 1;
  }
  EXPECT_EQ(alarms, 0u);
  // Flat overjets of the drawn phantoms leave it open; the registration tries both ways then.
  EXPECT_LE(missed, 4u);
}
