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
#include "itkRegistrationVerdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// Results made by hand, nothing registered: what the table of Documentation/Robust.md says of each.
namespace
{
using Verdict = itk::RegistrationVerdict;
using StatusEnum = Verdict::StatusEnum;
using Thresholds = Verdict::Thresholds;
using Named = std::vector<std::pair<std::string, StatusEnum>>;

constexpr StatusEnum Suspect = StatusEnum::Suspect;
constexpr StatusEnum Failed = StatusEnum::Failed;

/** Jaws in one group, with nothing to complain about. */
itk::PoseRegistrationResult
MakeGoodResult(std::size_t numberOfJaws = 1)
{
  itk::PoseRegistrationResult result;
  itk::PoseGroupResult        group;
  for (std::size_t j = 0; j < numberOfJaws; ++j)
  {
    itk::PoseJawResult jaw;
    jaw.jaw = j == 0 ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower;
    jaw.registered = true;
    jaw.archWidth = 58.0;
    jaw.winding = 0.4;
    jaw.fit.numberOfPoints = 100;
    jaw.fit.cost = 0.1;
    jaw.fit.medianResidual = 0.8;
    jaw.fit.p90Residual = 2.0;
    jaw.fit.inlierShare = 0.98;
    jaw.fit.hasCodes = true;
    jaw.fit.codeOffset = 1.0;
    jaw.fit.predictedSigma = 0.6;
    jaw.fit.extrapolatedSigma = 1.2;
    result.jaws.push_back(jaw);
    result.groupOfJaw.push_back(0);
    group.jaws.push_back(j);
  }
  group.smoothSigma = 1.1;
  group.whiteSigma = 0.5;
  group.score = 0.4;
  group.converged = true;
  result.groups.push_back(group);
  return result;
}

Named
NamesOf(const Verdict::JawVerdict & verdict)
{
  Named names;
  for (const auto & reason : verdict.findings)
  {
    names.emplace_back(reason.code, reason.severity);
    EXPECT_FALSE(reason.text.empty()) << reason.code;
  }
  return names;
}

/** The status of a jaw is its worst reason's. */
StatusEnum
WorstOf(const Named & names)
{
  StatusEnum worst = StatusEnum::Ok;
  for (const auto & name : names)
  {
    worst = std::max(worst, name.second);
  }
  return worst;
}

const itk::RegistrationFinding &
OnlyReason(const std::vector<Verdict::JawVerdict> & verdicts)
{
  static const itk::RegistrationFinding none;
  EXPECT_EQ(verdicts.at(0).findings.size(), 1u);
  return verdicts.at(0).findings.empty() ? none : verdicts.at(0).findings.front();
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

/** A threshold, the number in Documentation/Robust.md, and what is named on either side of it. */
struct Limit
{
  const char * name;
  double Thresholds::*                                       member;
  double                                                     documented;
  bool                                                       badAbove;
  std::function<void(itk::PoseRegistrationResult &, double)> set;
  Named                                                      within;
  Named                                                      beyond;
};

void
PrintTo(const Limit & limit, std::ostream * os)
{
  *os << limit.name;
}

using Result = itk::PoseRegistrationResult;

std::vector<Limit>
MakeLimits()
{
  return {
    { "SuspectCost",
      &Thresholds::suspectCost,
      0.36,
      true,
      [](Result & r, double x) { r.jaws[0].fit.cost = x; },
      {},
      { { "poor-fit", Suspect } } },
    { "FailedCost",
      &Thresholds::failedCost,
      0.50,
      true,
      [](Result & r, double x) { r.jaws[0].fit.cost = x; },
      { { "poor-fit", Suspect } },
      { { "no-fit", Failed } } },
    { "SuspectP90",
      &Thresholds::suspectP90,
      6.0,
      true,
      [](Result & r, double x) { r.jaws[0].fit.p90Residual = x; },
      {},
      { { "poor-fit", Suspect } } },
    { "SuspectMedian",
      &Thresholds::suspectMedian,
      2.7,
      true,
      [](Result & r, double x) { r.jaws[0].fit.medianResidual = x; },
      {},
      { { "poor-fit", Suspect } } },
    { "SuspectInlierShare",
      &Thresholds::suspectInlierShare,
      0.70,
      false,
      [](Result & r, double x) { r.jaws[0].fit.inlierShare = x; },
      {},
      { { "poor-fit", Suspect } } },
    { "FailedInlierShare",
      &Thresholds::failedInlierShare,
      0.50,
      false,
      [](Result & r, double x) { r.jaws[0].fit.inlierShare = x; },
      { { "poor-fit", Suspect } },
      { { "no-fit", Failed } } },
    { "SuspectSmoothSigma",
      &Thresholds::suspectSmoothSigma,
      3.0,
      true,
      [](Result & r, double x) { r.groups[0].smoothSigma = x; },
      {},
      { { "rough-tracing", Suspect } } },
    { "SuspectPredictedSigma",
      &Thresholds::suspectPredictedSigma,
      2.6,
      true,
      [](Result & r, double x) { r.jaws[0].fit.predictedSigma = x; },
      {},
      { { "uncertain", Suspect } } },
    { "SuspectExtrapolatedSigma",
      &Thresholds::suspectExtrapolatedSigma,
      5.5,
      true,
      [](Result & r, double x) { r.jaws[0].fit.extrapolatedSigma = x; },
      {},
      { { "uncertain", Suspect } } },
    { "FailedPredictedSigma",
      &Thresholds::failedPredictedSigma,
      20.0,
      true,
      [](Result & r, double x) { r.jaws[0].fit.predictedSigma = x; },
      { { "uncertain", Suspect } },
      { { "undetermined", Failed }, { "uncertain", Suspect } } },
    { "FailedPredictedSigmaOfABisectedTracing",
      &Thresholds::failedPredictedSigma,
      20.0,
      true,
      [](Result & r, double x) {
        r.groups[0].bisected = true;
        r.jaws[0].fit.predictedSigma = x;
        r.jaws[0].fit.extrapolatedSigma = x;
      },
      {},
      { { "undetermined", Failed } } },
    { "SuspectCodeOffset",
      &Thresholds::suspectCodeOffset,
      5.0,
      true,
      [](Result & r, double x) { r.jaws[0].fit.codeOffset = x; },
      {},
      { { "code-offset", Suspect } } },
    { "SuspectCodeOffsetTheOtherWay",
      &Thresholds::suspectCodeOffset,
      5.0,
      true,
      [](Result & r, double x) { r.jaws[0].fit.codeOffset = -x; },
      {},
      { { "code-offset", Suspect } } },
    { "SuspectMargin",
      &Thresholds::suspectMargin,
      0.78,
      false,
      [](Result & r, double x) { r.groups[0].margin = x; },
      {},
      { { "ambiguous", Suspect } } },
    { "SuspectPitch",
      &Thresholds::suspectPitch,
      0.54,
      true,
      [](Result & r, double x) { r.groups[0].parameters[itk::PosePitch] = x; },
      {},
      { { "search-limit", Suspect } } },
    { "SuspectPitchDown",
      &Thresholds::suspectPitch,
      0.54,
      true,
      [](Result & r, double x) { r.groups[0].parameters[itk::PosePitch] = -x; },
      {},
      { { "search-limit", Suspect } } },
    { "SuspectPriorTensionOfScale",
      &Thresholds::suspectPriorTension,
      4.5,
      true,
      [](Result & r, double x) { r.groups[0].priorTension[itk::PoseKappa] = x; },
      {},
      { { "prior-tension", Suspect } } },
    { "SuspectPriorTensionOfLateralShift",
      &Thresholds::suspectPriorTension,
      4.5,
      true,
      [](Result & r, double x) { r.groups[0].priorTension[itk::PoseTy] = x; },
      {},
      { { "prior-tension", Suspect } } },
    { "SuspectRotationTensionOfRoll",
      &Thresholds::suspectRotationTension,
      5.0,
      true,
      [](Result & r, double x) { r.groups[0].priorTension[itk::PoseRoll] = x; },
      {},
      { { "prior-tension", Suspect } } },
    { "SuspectRotationTensionOfYaw",
      &Thresholds::suspectRotationTension,
      5.0,
      true,
      [](Result & r, double x) { r.groups[0].priorTension[itk::PoseYaw] = x; },
      {},
      { { "prior-tension", Suspect } } },
    { "SuspectOtherSideDeviance",
      &Thresholds::suspectOtherSideDeviance,
      -5.0,
      false,
      [](Result & r, double x) { r.groups[0].outcomes["other-side"].deviance = x; },
      {},
      { { "other-side", Suspect } } },
    { "SuspectWinding",
      &Thresholds::suspectWinding,
      -0.1,
      false,
      [](Result & r, double x) { r.jaws[0].winding = x; },
      {},
      { { "inward-winding", Suspect } } },
    { "SuspectDraftedShare",
      &Thresholds::suspectDraftedShare,
      0.5,
      true,
      [](Result & r, double x) { r.jaws[0].draftedShare = x; },
      {},
      { { "drafts-unmended", Suspect } } },
    { "MinimumArchWidth",
      &Thresholds::minimumArchWidth,
      30.0,
      false,
      [](Result & r, double x) { r.jaws[0].archWidth = x; },
      {},
      { { "arch-width", Suspect } } },
    { "MaximumArchWidth",
      &Thresholds::maximumArchWidth,
      120.0,
      true,
      [](Result & r, double x) { r.jaws[0].archWidth = x; },
      {},
      { { "arch-width", Suspect } } },
    { "HypothesisGainOfExchangedJaws",
      &Thresholds::hypothesisGain,
      0.03,
      true,
      [](Result & r, double x) { r.groups[0].outcomes["jaws-exchanged"].score = r.groups[0].score - x; },
      {},
      { { "jaws-exchanged", Failed } } },
    { "HypothesisGainOfExchangedLandmarks",
      &Thresholds::hypothesisGain,
      0.03,
      true,
      [](Result & r, double x) { r.groups[0].outcomes["landmarks-exchanged"].score = r.groups[0].score - x; },
      {},
      { { "landmarks-exchanged", Failed } } },
    { "HypothesisGainOfLandmarksInMillimetres",
      &Thresholds::hypothesisGain,
      0.03,
      true,
      [](Result & r, double x) { r.groups[0].outcomes["landmarks-mm"].score = r.groups[0].score - x; },
      {},
      { { "landmarks-mm", Failed } } },
    { "FailedPitch",
      &Thresholds::failedPitch,
      1.57,
      true,
      [](Result & r, double x) { r.groups[0].parameters[itk::PosePitch] = x; },
      { { "search-limit", Suspect } },
      { { "upside-down", Failed } } },
    { "HypothesisGainOfATurnedDrawing",
      &Thresholds::hypothesisGain,
      0.03,
      true,
      [](Result & r, double x) { r.groups[0].outcomes["turned-270"].score = r.groups[0].score - x; },
      {},
      { { "turned-image", Failed } } },
    { "HypothesisGainOfAnotherSpacing",
      &Thresholds::hypothesisGain,
      0.03,
      true,
      [](Result & r, double x) {
        r.groups[0].score = 0.15;
        r.groups[0].outcomes["pixel-spacing"] = { r.groups[0].score - x, 0.0, { { 0.5, 0.5 } } };
      },
      { { "pixel-spacing", Suspect } },
      { { "pixel-spacing", Failed } } },
    { "SpacingScore",
      &Thresholds::spacingScore,
      0.15,
      true,
      [](Result & r, double x) {
        r.groups[0].score = 0.9;
        r.groups[0].outcomes["pixel-spacing"] = { x, 0.0, { { 0.5, 0.5 } } };
      },
      { { "pixel-spacing", Failed } },
      { { "pixel-spacing", Suspect } } },
    { "SpacingShare",
      &Thresholds::spacingShare,
      0.95,
      true,
      [](Result & r, double x) {
        r.groups[0].score = 0.3;
        r.groups[0].outcomes["pixel-spacing"] = { 0.3 * x, 0.0, { { 0.5, 0.5 } } };
      },
      { { "pixel-spacing", Suspect } },
      {} },
    { "HypothesisGainOfTheOtherFacing",
      &Thresholds::hypothesisGain,
      0.03,
      true,
      [](Result & r, double x) { r.groups[0].outcomes["facing"].score = r.groups[0].score - x; },
      {},
      { { "facing", Failed } } },
  };
}
} // namespace

class RegistrationVerdictLimit : public ::testing::TestWithParam<Limit>
{
protected:
  /** At the limit all is well still; a billionth beyond it is named. */
  static void
  Check(const Limit & limit, double value, const Thresholds * thresholds)
  {
    for (const double excess : { -1e-9, 0.0, 1e-9 })
    {
      Result result = MakeGoodResult();
      limit.set(result, limit.badAbove ? value + excess : value - excess);
      const auto verdicts = thresholds == nullptr ? Verdict::Evaluate(result) : Verdict::Evaluate(result, *thresholds);
      const Named & expected = excess > 0.0 ? limit.beyond : limit.within;
      ASSERT_EQ(verdicts.size(), 1u);
      EXPECT_EQ(NamesOf(verdicts[0]), expected) << limit.name << ", excess " << excess;
      EXPECT_EQ(verdicts[0].status, WorstOf(expected)) << limit.name << ", excess " << excess;
    }
  }
};

TEST_P(RegistrationVerdictLimit, IsTheDocumentedNumber)
{
  const Limit & limit = GetParam();
  EXPECT_EQ(Thresholds().*limit.member, limit.documented);
  Check(limit, limit.documented, nullptr);
}

TEST_P(RegistrationVerdictLimit, MovesWithTheThreshold)
{
  const Limit & limit = GetParam();
  Thresholds    thresholds;
  thresholds.*limit.member = 1.25 * limit.documented;
  Check(limit, 1.25 * limit.documented, &thresholds);
}

/** For programs: what was measured, and the limit that it is beyond, on the side on which that is bad. */
TEST_P(RegistrationVerdictLimit, IsToldWithTheValueThatIsBeyondIt)
{
  const Limit & limit = GetParam();
  if (limit.beyond.empty())
  {
    // Beyond it nothing is wrong.
    return;
  }
  Result       result = MakeGoodResult();
  const double value = limit.documented + (limit.badAbove ? 1e-3 : -1e-3);
  limit.set(result, value);
  const auto verdicts = Verdict::Evaluate(result);
  ASSERT_FALSE(verdicts.at(0).findings.empty());
  const itk::RegistrationFinding & finding = verdicts[0].findings.front();
  ASSERT_TRUE(finding.value && finding.limit) << limit.name;
  if (finding.code == "pixel-spacing")
  {
    // It tells the two spacings.
    EXPECT_EQ(*finding.value, 0.5);
    return;
  }
  const double unit = finding.unit == "deg" ? 180.0 / 3.14159265358979323846 : 1.0;
  EXPECT_NEAR(*finding.limit, unit * limit.documented, 1e-9) << limit.name;
  EXPECT_NEAR(*finding.value, unit * value, 1e-9) << limit.name;
}

INSTANTIATE_TEST_SUITE_P(Table,
                         RegistrationVerdictLimit,
                         ::testing::ValuesIn(MakeLimits()),
                         [](const ::testing::TestParamInfo<Limit> & info) { return std::string(info.param.name); });

/** A scale that is free differs a little by itself: from 8 % on it is another spacing, whichever way. */
TEST(RegistrationVerdict, AnotherSpacingDiffersByEightPerCent)
{
  EXPECT_EQ(Thresholds().spacingDifference, 0.08);
  for (const double sign : { -1.0, 1.0 })
  {
    for (const double difference : { 0.0799, 0.0801 })
    {
      Result       result = MakeGoodResult();
      const double given = result.geometry.pixelSpacing[0];
      const double found = given * std::exp(sign * difference);
      result.groups[0].score = 0.9;
      result.groups[0].outcomes["pixel-spacing"] = { 0.1, 0.0, { { found, found } } };
      const auto verdict = Verdict::Evaluate(result).at(0);
      ASSERT_EQ(verdict.findings.size(), difference > 0.08 ? 1u : 0u) << difference;
      if (!verdict.findings.empty())
      {
        EXPECT_EQ(verdict.findings[0].code, "pixel-spacing");
        EXPECT_EQ(*verdict.findings[0].value, found);
        EXPECT_EQ(*verdict.findings[0].limit, given);
      }
    }
  }
}

/** Of several readings the one that fits best is named; where the jaws were exchanged that alone is. */
TEST(RegistrationVerdict, OneReadingOfTheDrawingIsNamed)
{
  Result result = MakeGoodResult();
  result.groups[0].score = 0.9;
  result.groups[0].outcomes["facing"].score = 0.5;
  result.groups[0].outcomes["turned-90"].score = 0.4;
  result.groups[0].outcomes["pixel-spacing"] = { 0.1, 0.0, { { 0.5, 0.5 } } };
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "pixel-spacing", Failed } }));
  result.groups[0].outcomes["pixel-spacing"].score = 0.2;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "turned-image", Failed } }))
    << "better by far, and yet not good";
  result.groups[0].outcomes["jaws-exchanged"].score = 0.3;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "jaws-exchanged", Failed } }));
}

/** It frees the scale, as another spacing does: it has to be far better than both. */
TEST(RegistrationVerdict, RowsThatWereCountedFromBelowAreNamedWhereTheyExplainMuchMoreThanAnyScale)
{
  Result result = MakeGoodResult();
  result.geometry.pixelSpacing = { { 0.25, 0.25 } };
  result.geometry.pixelSpacingKnown = true;
  result.groups[0].score = 0.4;
  auto & upward = result.groups[0].outcomes["upward-drawing"];
  upward = { 0.31, 0.0, { { 0.25, 0.25 } } };
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), Named());
  upward.score = 0.29;
  const auto verdict = Verdict::Evaluate(result).at(0);
  EXPECT_EQ(NamesOf(verdict), (Named{ { "upward-drawing", Failed } }));
  EXPECT_NEAR(*verdict.findings[0].value, 0.11, 1e-12);
  EXPECT_EQ(verdict.findings[0].text.find("pixel spacing of"), std::string::npos) << verdict.findings[0].text;
  EXPECT_EQ(verdict.findings[0].text.find("in mm"), std::string::npos) << verdict.findings[0].text;
  // A drawing in mm.
  upward.pixelSpacing = { { 1.01, 1.01 } };
  const std::string text = Verdict::Evaluate(result).at(0).findings[0].text;
  EXPECT_NE(text.find("and a pixel spacing of 1.01 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("and in mm?"), std::string::npos) << text;
  // With the scale alone it would be almost as good.
  result.groups[0].outcomes["pixel-spacing"] = { 0.3, 0.0, { { 0.5, 0.5 } } };
  EXPECT_NE(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "upward-drawing", Failed } }));
}

/** The unit in which a film has the usual length comes first. */
TEST(RegistrationVerdict, AFilmThatIsTooShortNamesTheUnitsThatWouldExplainIt)
{
  Result result = MakeGoodResult();
  result.geometry.pixelSpacingKnown = true;
  const auto textAt = [&](double spacing) {
    result.geometry.pixelSpacing = { { spacing, spacing } };
    const auto verdicts = Verdict::Evaluate(result, Thresholds(), { { 800, 1000 } });
    for (const auto & finding : verdicts.at(0).findings)
    {
      if (finding.code == "film-size")
      {
        return finding.text.substr(std::string("by its pixel spacing the radiograph would be ").size());
      }
    }
    return std::string();
  };
  EXPECT_EQ(textAt(0.25), "");
  EXPECT_EQ(textAt(0.025), "25 mm long, and 250 mm were pixel_spacing_mm in cm: give mm a pixel");
  EXPECT_EQ(textAt(0.25 / 25.4),
            "10 mm long, and 250 mm were pixel_spacing_mm in inches, 98 mm in cm: give mm a pixel");
  EXPECT_EQ(textAt(0.0076), "8 mm long, and 193 mm were pixel_spacing_mm in inches: give mm a pixel");
  EXPECT_EQ(textAt(0.015), "15 mm long, and 381 mm were pixel_spacing_mm in inches, 150 mm in cm: give mm a pixel");
  EXPECT_EQ(textAt(0.001), "1 mm long: is pixel_spacing_mm of another resolution?");
  EXPECT_EQ(textAt(0.06), "60 mm long: is pixel_spacing_mm of another resolution?");
}

/** Where the fit alone tells the spacing the film is judged by its longer side; where it was given it is not. */
TEST(RegistrationVerdict, AFilmIsNoLongerThanFilmsAre)
{
  EXPECT_EQ(Thresholds().suspectFilmLength, 400.0);
  EXPECT_EQ(Thresholds().failedFilmLength, 450.0);
  Result result = MakeGoodResult();
  result.geometry.pixelSpacing = { { 0.5, 0.25 } };
  result.geometry.pixelSpacingKnown = false;
  const auto named = [&](std::size_t width, std::size_t height) {
    return NamesOf(Verdict::Evaluate(result, Thresholds(), { { width, height } }).at(0));
  };
  EXPECT_EQ(named(800, 1600), Named());
  EXPECT_EQ(named(801, 100), (Named{ { "film-size", Suspect } }));
  EXPECT_EQ(named(100, 1601), (Named{ { "film-size", Suspect } }));
  EXPECT_EQ(named(900, 100), (Named{ { "film-size", Suspect } }));
  EXPECT_EQ(named(901, 100), (Named{ { "film-size", Failed } }));
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), Named()) << "a size that nobody knows";
  result.geometry.pixelSpacingKnown = true;
  EXPECT_EQ(named(900, 1800), Named()) << "450 mm";
  EXPECT_EQ(named(901, 100), (Named{ { "film-size", Suspect } }));
  EXPECT_EQ(Thresholds().shortestFilm, 80.0);
  EXPECT_EQ(named(160, 320), Named()) << "80 mm";
  EXPECT_EQ(named(159, 319), (Named{ { "film-size", Suspect } }));
}

TEST(RegistrationVerdict, GoodResultIsOkWithoutReasons)
{
  for (const auto & verdict : Verdict::Evaluate(MakeGoodResult(2)))
  {
    EXPECT_EQ(verdict.status, StatusEnum::Ok);
    EXPECT_TRUE(verdict.findings.empty());
  }
}

TEST(RegistrationVerdict, JawThatWasNotRegisteredFailsWithItsOwnWords)
{
  Result result = MakeGoodResult(2);
  result.groups[0].jaws = { 0 };
  // Figures that nobody computed say nothing.
  result.jaws[1] = itk::PoseJawResult();
  result.jaws[1].failure = "no tracing";
  result.groupOfJaw[1] = 1;
  const auto verdicts = Verdict::Evaluate(result);
  EXPECT_EQ(verdicts[0].status, StatusEnum::Ok);
  EXPECT_EQ(verdicts[1].status, Failed);
  EXPECT_EQ(NamesOf(verdicts[1]), (Named{ { "not-registered", Failed } }));
  EXPECT_EQ(verdicts[1].findings[0].text, "no tracing");
}

TEST(RegistrationVerdict, WhatAGroupSharesIsNamedForItsJawsAlone)
{
  Result result = MakeGoodResult(2);
  result.groups[0].margin = 0.0;
  for (const auto & verdict : Verdict::Evaluate(result))
  {
    EXPECT_EQ(NamesOf(verdict), (Named{ { "ambiguous", Suspect } }));
  }
  result.groups.push_back(MakeGoodResult().groups[0]);
  result.groups[0].jaws = { 0 };
  result.groups[1].jaws = { 1 };
  result.groupOfJaw = { 0, 1 };
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result)[0]), (Named{ { "ambiguous", Suspect } }));
  EXPECT_TRUE(NamesOf(Verdict::Evaluate(result)[1]).empty());
}

TEST(RegistrationVerdict, PoorFitOfOneJawIsNamedForTheOtherThatSharesThePose)
{
  for (const double cost : { 0.4, 0.6 })
  {
    Result result = MakeGoodResult(2);
    // The other one does not bear the pose out.
    result.jaws[0].fit.cost = 0.25;
    result.jaws[1].fit.cost = cost;
    const auto verdicts = Verdict::Evaluate(result);
    EXPECT_EQ(NamesOf(verdicts[0]), (Named{ { "other-jaw", Suspect } }));
    EXPECT_EQ(NamesOf(verdicts[1]), (cost < 0.5 ? Named{ { "poor-fit", Suspect } } : Named{ { "no-fit", Failed } }));
  }
  Result result = MakeGoodResult(2);
  result.jaws[1].fit.cost = 0.36;
  EXPECT_TRUE(NamesOf(Verdict::Evaluate(result)[0]).empty());
}

TEST(RegistrationVerdict, AJawThatTheOtherOnePlacedIsAsBadAsThatOne)
{
  Result result = MakeGoodResult(2);
  result.jaws[1].placedByOther = true;
  result.jaws[1].fit.numberOfPoints = 0;
  const auto severity = [&result]() {
    for (const auto & name : NamesOf(Verdict::Evaluate(result).at(1)))
    {
      if (name.first == "placed-by-other")
      {
        return name.second;
      }
    }
    ADD_FAILURE() << "it is not said";
    return StatusEnum::Ok;
  };
  EXPECT_EQ(severity(), StatusEnum::Ok);
  result.jaws[0].fit.predictedSigma = 25.0;
  EXPECT_EQ(severity(), Failed);
}

TEST(RegistrationVerdict, SideCodesAreNamedFromMoreThanHalf)
{
  Result result = MakeGoodResult();
  result.jaws[0].otherSideCodes = 0.5;
  EXPECT_TRUE(NamesOf(Verdict::Evaluate(result)[0]).empty());
  result.jaws[0].otherSideCodes = 0.5 + 1e-9;
  const itk::RegistrationFinding reason = OnlyReason(Verdict::Evaluate(result));
  EXPECT_EQ(reason.code, "side-codes");
  EXPECT_EQ(reason.severity, Suspect);
  EXPECT_TRUE(Contains(reason.text, "traced_side"));
}

TEST(RegistrationVerdict, CodeOffsetNeedsCodesAndUncertaintyIsNotJudgedOnBisectedTracings)
{
  Result result = MakeGoodResult();
  result.jaws[0].fit.hasCodes = false;
  result.jaws[0].fit.codeOffset = 30.0;
  EXPECT_TRUE(NamesOf(Verdict::Evaluate(result)[0]).empty());
  result.groups[0].bisected = true;
  result.jaws[0].fit.predictedSigma = 19.0;
  result.jaws[0].fit.extrapolatedSigma = 60.0;
  EXPECT_TRUE(NamesOf(Verdict::Evaluate(result)[0]).empty());
}

TEST(RegistrationVerdict, OnlyWhatHasAPriorCanBeInTensionAndTheTextSaysWhatIs)
{
  const std::vector<std::pair<unsigned int, std::string>> words{ { itk::PoseRoll, "rolled by -20.0 degrees" },
                                                                 { itk::PoseYaw, "turned by -20.0 degrees" },
                                                                 { itk::PoseTy, "midline would be -0.3 mm" },
                                                                 { itk::PoseKappa,
                                                                   "scale contradicts pixel spacing" } };
  for (const auto & word : words)
  {
    Result result = MakeGoodResult();
    result.groups[0].priorTension[word.first] = 6.0;
    result.groups[0].parameters[word.first] = -0.3490658503988659;
    const itk::RegistrationFinding reason = OnlyReason(Verdict::Evaluate(result));
    EXPECT_EQ(reason.code, "prior-tension");
    EXPECT_TRUE(Contains(reason.text, word.second)) << reason.text;
  }
  Result result = MakeGoodResult();
  result.groups[0].priorTension[itk::PoseKappa] = 6.0;
  result.groups[0].parameters[itk::PoseKappa] = 0.0953101798043249;
  EXPECT_TRUE(Contains(OnlyReason(Verdict::Evaluate(result)).text, "by 10.0 %"));
  for (const unsigned int free : { itk::PosePitch, itk::PoseTx, itk::PoseTz })
  {
    Result untouched = MakeGoodResult();
    untouched.groups[0].priorTension[free] = 100.0;
    EXPECT_TRUE(NamesOf(Verdict::Evaluate(untouched)[0]).empty());
  }
}

TEST(RegistrationVerdict, ArchOfAnotherUnitIsNamedWithTheUnitThatFitsAndSilencesHypotheses)
{
  // 58 mm in other units; 25 and 500 mm are an arch in none.
  const std::vector<std::pair<double, std::string>> widths{ { 5.8, " cm (it would then be 58.0 mm)" },
                                                            { 58.0 / 25.4, " inch (it would then be 58.0 mm)" },
                                                            { 0.058, " m (it would then be 58.0 mm)" },
                                                            { 58000.0, " um (it would then be 58.0 mm)" } };
  for (const auto & width : widths)
  {
    Result result = MakeGoodResult();
    result.jaws[0].archWidth = width.first;
    result.groups[0].outcomes["jaws-exchanged"].score = 0.0;
    result.groups[0].outcomes["facing"].score = 0.0;
    const itk::RegistrationFinding reason = OnlyReason(Verdict::Evaluate(result));
    EXPECT_EQ(reason.code, "arch-width");
    EXPECT_TRUE(Contains(reason.text, width.second)) << reason.text;
  }
  for (const double width : { 25.0, 500.0 })
  {
    Result result = MakeGoodResult();
    result.jaws[0].archWidth = width;
    EXPECT_FALSE(Contains(OnlyReason(Verdict::Evaluate(result)).text, "may be in")) << width;
  }
}

TEST(RegistrationVerdict, AUsersOwnHypothesisIsForTheUserToJudge)
{
  Result result = MakeGoodResult();
  result.groups[0].outcomes["same-again"] = { 0.0, -100.0 };
  EXPECT_TRUE(Verdict::Evaluate(result)[0].findings.empty());
}

TEST(RegistrationVerdict, HypothesesAreNamedByWhatToCheck)
{
  const auto evaluate = [](const std::function<void(itk::PoseGroupResult &)> & change) {
    Result result = MakeGoodResult();
    change(result.groups[0]);
    return OnlyReason(Verdict::Evaluate(result));
  };
  itk::RegistrationFinding reason =
    evaluate([](itk::PoseGroupResult & g) { g.outcomes["other-side"].deviance = -6.0; });
  EXPECT_EQ(reason.code, "other-side");
  EXPECT_TRUE(Contains(reason.text, "other side") && Contains(reason.text, "mirrored")) << reason.text;
  reason = evaluate([](itk::PoseGroupResult & g) { g.outcomes["jaws-exchanged"].score = 0.2; });
  EXPECT_EQ(reason.code, "jaws-exchanged");
  EXPECT_TRUE(Contains(reason.text, "upper and lower scan")) << reason.text;
  reason = evaluate([](itk::PoseGroupResult & g) { g.outcomes["landmarks-exchanged"].score = 0.2; });
  EXPECT_EQ(reason.code, "landmarks-exchanged");
  EXPECT_TRUE(Contains(reason.text, "names of upper and lower landmarks")) << reason.text;
  reason = evaluate([](itk::PoseGroupResult & g) { g.outcomes["landmarks-mm"].score = 0.2; });
  EXPECT_EQ(reason.code, "landmarks-mm");
  EXPECT_TRUE(Contains(reason.text, "in mm")) << reason.text;
  // Of readings that fit better the best: exchanged names fit the other facing a little better, too.
  reason = evaluate([](itk::PoseGroupResult & g) {
    g.outcomes["landmarks-exchanged"].score = 0.1;
    g.outcomes["facing"].score = 0.2;
  });
  EXPECT_EQ(reason.code, "landmarks-exchanged");
  reason = evaluate([](itk::PoseGroupResult & g) {
    g.outcomes["landmarks-exchanged"].score = 0.2;
    g.outcomes["facing"].score = 0.1;
  });
  EXPECT_EQ(reason.code, "facing");
  reason = evaluate([](itk::PoseGroupResult & g) { g.outcomes["facing"].score = 0.2; });
  EXPECT_EQ(reason.code, "facing");
  EXPECT_TRUE(Contains(reason.text, "`facing`")) << reason.text;
  // The place of the minimum that is elsewhere, not that of a neighbour of the best.
  reason = evaluate([](itk::PoseGroupResult & g) {
    g.margin = 0.01;
    g.candidates.resize(3);
    g.candidates[1].distance = 3.9;
    g.candidates[2].distance = 27.2;
  });
  EXPECT_EQ(reason.code, "ambiguous");
  EXPECT_TRUE(Contains(reason.text, "27 px")) << reason.text;
}

TEST(RegistrationVerdict, WithoutATracingAnotherPlaceIsOneThatItsSigmaDoesNotHold)
{
  // Landmarks and outlines err by some px: a minimum 7 px away is in their sigma, one 9 px away is another answer.
  for (const double distance : { 7.0, 9.0 })
  {
    Result result = MakeGoodResult();
    result.jaws[0].fit.numberOfPoints = 0;
    result.groups[0].margin = 0.01;
    result.groups[0].candidates.resize(2);
    result.groups[0].candidates[1].distance = distance;
    result.groups[0].candidates[1].deviance = 1.0;
    const Named expected = distance > 8.0 ? Named{ { "ambiguous", Suspect } } : Named{};
    EXPECT_EQ(NamesOf(Verdict::Evaluate(result)[0]), expected) << distance;
    // Of odds that are none.
    result.groups[0].candidates[1].deviance = 10.0;
    EXPECT_TRUE(NamesOf(Verdict::Evaluate(result)[0]).empty()) << distance;
  }
  // Where the other jaw, which shares the pose, is traced, its tracing tells places apart for both.
  Result shared = MakeGoodResult(2);
  shared.jaws[0].fit.numberOfPoints = 0;
  shared.groups[0].margin = 0.01;
  shared.groups[0].candidates.resize(2);
  shared.groups[0].candidates[1].distance = 7.0;
  for (const auto & verdict : Verdict::Evaluate(shared))
  {
    EXPECT_EQ(NamesOf(verdict), (Named{ { "ambiguous", Suspect } }));
  }
}

TEST(RegistrationVerdict, NotCheckableIsWhatTheDataOfTheCaseLeavesOpen)
{
  using Lines = std::vector<std::string>;
  const std::string view = "source distance, depth and pixel spacing: one view shows their product alone";
  const std::string source = "which side the X-ray source was on";
  const std::string mirrored = "a mirrored scan of a nearly symmetric dentition";
  const std::string patient = "whether scan and radiograph are of one patient, where the dentitions are alike";
  const std::string spacing = "pixel spacing: it was not given, the scale is the fit's own";
  const std::string principal = "principal point: it was not given, the tracing's centre was used";
  const std::string codes = "whether each tooth lies on its own: the tracing has no tooth codes";
  const std::string closed = "winding of a closed cast";
  const std::string manual =
    "exchanged jaws, facing, other side, other minima: not searched beside a given start or held values";
  const std::string                  roll = "roll and yaw of the head: a bisected tracing does not carry them";
  const std::string                  middle = "whether the tracing really is the middle of both sides";
  const itk::PoseRegistrationOptions none;

  EXPECT_EQ(Verdict::GetNotCheckable(MakeGoodResult(2), none), (Lines{ view, source, mirrored, patient }));

  Result result = MakeGoodResult();
  result.geometry.pixelSpacingKnown = false;
  EXPECT_EQ(Verdict::GetNotCheckable(result, none), (Lines{ view, source, spacing, mirrored, patient }));
  result = MakeGoodResult();
  result.geometry.principalPointKnown = false;
  EXPECT_EQ(Verdict::GetNotCheckable(result, none), (Lines{ view, source, principal, mirrored, patient }));

  // Codes in one jaw are enough to say that the tracing has some.
  result = MakeGoodResult(2);
  result.jaws[0].fit.hasCodes = false;
  EXPECT_EQ(Verdict::GetNotCheckable(result, none), (Lines{ view, source, mirrored, patient }));
  result.jaws[1].fit.hasCodes = false;
  EXPECT_EQ(Verdict::GetNotCheckable(result, none), (Lines{ view, source, codes, mirrored, patient }));

  for (const double winding : { 0.1, -0.1, 0.0999, -0.0999 })
  {
    result = MakeGoodResult(2);
    result.jaws[1].winding = winding;
    EXPECT_EQ(Verdict::GetNotCheckable(result, none),
              (std::abs(winding) < 0.1 ? Lines{ view, source, closed, mirrored, patient }
                                       : Lines{ view, source, mirrored, patient }))
      << winding;
  }
  EXPECT_EQ(closed, Verdict::ClosedCastLine);

  // Of a jaw that was not registered nobody looked at codes or winding.
  result = MakeGoodResult();
  result.jaws[0] = itk::PoseJawResult();
  EXPECT_EQ(Verdict::GetNotCheckable(result, none), (Lines{ view, source, mirrored, patient }));

  for (bool itk::PoseRegistrationOptions::*held : { &itk::PoseRegistrationOptions::useInitialPose,
                                                    &itk::PoseRegistrationOptions::fixRotation,
                                                    &itk::PoseRegistrationOptions::fixScale,
                                                    &itk::PoseRegistrationOptions::fixTranslation })
  {
    itk::PoseRegistrationOptions options;
    options.*held = true;
    EXPECT_EQ(Verdict::GetNotCheckable(MakeGoodResult(), options), (Lines{ view, source, manual, mirrored, patient }));
  }
  for (const auto side :
       { itk::TracedSideEnum::Right, itk::TracedSideEnum::Left, itk::TracedSideEnum::Both, itk::TracedSideEnum::Mean })
  {
    itk::PoseRegistrationOptions options;
    options.tracedSide = side;
    EXPECT_EQ(Verdict::GetNotCheckable(MakeGoodResult(), options),
              (side == itk::TracedSideEnum::Mean ? Lines{ view, source, roll, middle, mirrored, patient }
                                                 : Lines{ view, source, mirrored, patient }));
  }
}

namespace
{
/** A jaw that two landmarks of its own and two of the other placed. */
itk::PoseRegistrationResult
MakeResultOfLandmarks()
{
  itk::PoseRegistrationResult result = MakeGoodResult(2);
  const char *                names[2][2] = { { "U1_tip", "U6_MB" }, { "L1_tip", "L6_MB" } };
  for (std::size_t j = 0; j < 2; ++j)
  {
    result.jaws[j].fit = itk::PoseFitStatistics();
    result.jaws[j].middleSigma = 1.8;
    result.jaws[j].largestMiddleSigma = 2.1;
    for (const char * name : names[j])
    {
      itk::PoseLandmarkFit landmark;
      landmark.name = name;
      landmark.distance = 1.2;
      result.jaws[j].landmarks.push_back(landmark);
    }
  }
  return result;
}
} // namespace

/** What was drawn in mm fits at a spacing of 1 mm; four marks tell the scale to a tenth, a tracing to a twentieth. */
TEST(RegistrationVerdict, ASpacingNearOneMillimetreIsAskedForMillimetres)
{
  const auto textAt = [](Result result, double spacing) {
    result.groups[0].score = 0.9;
    result.groups[0].outcomes["pixel-spacing"] = { 0.1, 0.0, { { spacing, spacing } } };
    const auto verdicts = Verdict::Evaluate(result);
    for (const auto & finding : verdicts.at(0).findings)
    {
      if (finding.code == "pixel-spacing")
      {
        return finding.text;
      }
    }
    return std::string();
  };
  const std::string inMillimetres = "drawn in mm instead of pixels";
  EXPECT_TRUE(Contains(textAt(MakeGoodResult(), std::exp(-0.049)), inMillimetres));
  EXPECT_TRUE(Contains(textAt(MakeGoodResult(), std::exp(-0.051)), "on a copy of the radiograph"));
  EXPECT_TRUE(Contains(textAt(MakeResultOfLandmarks(), std::exp(-0.099)), inMillimetres));
  EXPECT_TRUE(Contains(textAt(MakeResultOfLandmarks(), std::exp(0.101)), "on a copy of the radiograph"));
}

TEST(RegistrationVerdict, APitchThatTheMarksDoNotTellIsNotJudged)
{
  const Thresholds limits;
  for (const double pitch : { limits.failedPitch + 0.01, -limits.failedPitch - 0.01, limits.suspectPitch + 0.01 })
  {
    auto result = MakeResultOfLandmarks();
    result.groups[0].parameters[itk::PosePitch] = pitch;
    const bool isFailed = std::abs(pitch) > limits.failedPitch;
    EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)),
              isFailed ? (Named{ { "upside-down", Failed } }) : (Named{ { "search-limit", Suspect } }));
    // Incisors or molars alone, which turn about any axis without contradiction.
    for (const char * kept : { "1_tip", "6_MB" })
    {
      auto some = result;
      for (auto & jaw : some.jaws)
      {
        auto & marks = jaw.landmarks;
        marks.erase(std::remove_if(marks.begin(),
                                   marks.end(),
                                   [&](const auto & mark) { return mark.name.find(kept) == std::string::npos; }),
                    marks.end());
      }
      EXPECT_TRUE(NamesOf(Verdict::Evaluate(some).at(0)).empty()) << kept;
      // A tracing beside them tells it.
      some.jaws[0].fit = MakeGoodResult(2).jaws[0].fit;
      const auto names = NamesOf(Verdict::Evaluate(some).at(0));
      EXPECT_EQ(
        std::count_if(names.begin(),
                      names.end(),
                      [&](const auto & name) { return name.first == (isFailed ? "upside-down" : "search-limit"); }),
        1)
        << kept;
    }
  }
}

TEST(RegistrationVerdict, LandmarksAloneAreJudgedByTheMiddlesThatTheyDetermine)
{
  const Thresholds limits;
  auto             result = MakeResultOfLandmarks();
  EXPECT_EQ(Verdict::Evaluate(result).at(0).status, StatusEnum::Ok);
  result.jaws[0].middleSigma = limits.suspectMiddleSigma + 0.01;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "uncertain", Suspect } }));
  EXPECT_EQ(Verdict::Evaluate(result).at(1).status, StatusEnum::Ok);
  result.jaws[0].middleSigma = limits.suspectMiddleSigma - 0.01;
  result.jaws[0].largestMiddleSigma = limits.suspectLargestMiddleSigma + 0.01;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "uncertain", Suspect } }));
  result.jaws[0].middleSigma = limits.failedPredictedSigma + 0.01;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "undetermined", Failed } }));
}

TEST(RegistrationVerdict, ALandmarkThatStandsApartIsNamedForEveryJawOfItsPose)
{
  const Thresholds limits;
  auto             result = MakeResultOfLandmarks();
  result.jaws[1].landmarks[0].distance = limits.landmarkApart + 0.01;
  for (const auto & verdict : Verdict::Evaluate(result))
  {
    ASSERT_EQ(NamesOf(verdict), (Named{ { "landmark-apart", Suspect } }));
    EXPECT_TRUE(Contains(verdict.findings.front().text, "landmark L1_tip lies far"));
  }
  // Beside a tracing two are no more than that.
  result.jaws[1].landmarks[1].distance = limits.landmarkApart + 0.01;
  auto traced = result;
  traced.jaws[0].fit = MakeGoodResult().jaws[0].fit;
  EXPECT_TRUE(
    Contains(Verdict::Evaluate(traced).at(0).findings.front().text, "landmark L1_tip and landmark L6_MB lie far"));
  // One that is left has nothing that confirms it.
  result.jaws[0].landmarks[0].distance = limits.landmarkApart + 0.01;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "landmarks-disagree", Failed } }));
}

TEST(RegistrationVerdict, AsManyLandmarksApartAsTogetherDisagree)
{
  const Thresholds limits;
  auto             result = MakeResultOfLandmarks();
  for (auto & landmark : result.jaws[0].landmarks)
  {
    landmark.distance = limits.landmarkApart + 0.01;
  }
  const auto verdicts = Verdict::Evaluate(result);
  EXPECT_EQ(NamesOf(verdicts.at(0)), (Named{ { "landmarks-disagree", Failed } }));
  EXPECT_TRUE(Contains(verdicts.at(0).findings.front().text, "exchanged"));
}

/** A quarter off, of landmarks or outlines of four teeth: named, and first, where they fit at the other spacing and at
 * nothing else. */
TEST(RegistrationVerdict, ASpacingThatIsOffByAQuarterIsNamedOfLandmarksWhereNothingElseComesNear)
{
  const auto codesAt = [](double difference, double share) {
    auto result = MakeResultOfLandmarks();
    result.geometry.pixelSpacing = { { 0.25, 0.25 } };
    result.geometry.pixelSpacingKnown = true;
    result.groups[0].score = 0.4;
    result.groups[0].outcomes["jaws-exchanged"].score = 0.28;
    result.groups[0].outcomes["landmarks-exchanged"].score = 0.3;
    const double spacing = 0.25 * std::exp(difference);
    result.groups[0].outcomes["pixel-spacing"] = { 0.28 * share, 0.0, { { spacing, spacing } } };
    return Verdict::Evaluate(result).at(0);
  };
  for (const double sign : { -1.0, 1.0 })
  {
    const auto verdict = codesAt(0.26 * sign, 0.49);
    EXPECT_EQ(NamesOf(verdict), (Named{ { "pixel-spacing", Failed } }));
    EXPECT_NEAR(*verdict.findings.front().value, 0.25 * std::exp(0.26 * sign), 1e-12);
    EXPECT_TRUE(Contains(verdict.findings.front().text, "drawn at their neighbours look alike"));
    // What is no better than half of another reading's score is that reading's.
    EXPECT_EQ(codesAt(0.26 * sign, 0.51).findings.front().code, "jaws-exchanged");
    // A free scale is off by less than that.
    EXPECT_EQ(codesAt(0.151 * sign, 0.2).findings.front().code, "pixel-spacing");
    EXPECT_EQ(codesAt(0.149 * sign, 0.2).findings.front().code, "jaws-exchanged");
    // No tooth has a neighbour so far away.
    EXPECT_FALSE(Contains(codesAt(0.41 * sign, 0.2).findings.front().text, "neighbours"));
  }
}

/** Of few points a scale that is a little off looks like exchanged jaws or names; a tracing is not asked of it. */
TEST(RegistrationVerdict, ExchangesOfLandmarksAskForThePixelSpacing)
{
  const std::string question = "or is pixel_spacing_mm of another copy of the radiograph";
  for (const std::string code : { "jaws-exchanged", "landmarks-exchanged" })
  {
    auto result = MakeResultOfLandmarks();
    result.geometry.pixelSpacingKnown = true;
    result.groups[0].score = 2.0;
    result.groups[0].outcomes[code].score = 0.5;
    auto text = Verdict::Evaluate(result).at(0).findings.front().text;
    EXPECT_TRUE(Contains(text, question + "?")) << text;
    // No better than the exchange, and better than as it is.
    auto & spacing = result.groups[0].outcomes["pixel-spacing"];
    spacing.score = 0.6;
    spacing.pixelSpacing = { { 0.31, 0.31 } };
    text = Verdict::Evaluate(result).at(0).findings.front().text;
    EXPECT_TRUE(Contains(text, question + " (with 0.31 mm what was drawn fits better as well)?")) << text;
    result.geometry.pixelSpacingKnown = false;
    const auto verdicts = Verdict::Evaluate(result);
    for (const auto & finding : verdicts.at(0).findings)
    {
      EXPECT_FALSE(Contains(finding.text, question)) << finding.text;
    }
  }
  auto traced = MakeGoodResult();
  traced.geometry.pixelSpacingKnown = true;
  traced.groups[0].score = 2.0;
  traced.groups[0].outcomes["jaws-exchanged"].score = 0.5;
  EXPECT_FALSE(Contains(Verdict::Evaluate(traced).at(0).findings.front().text, question));
}

TEST(RegistrationVerdict, AnOutlineThatLiesOnNothingIsNamedAndBearsNobodyOut)
{
  const Thresholds limits;
  auto             result = MakeResultOfLandmarks();
  // As of a root without its crown: no point of it has a match, so that no residual speaks against it.
  itk::PoseOutlineFit root;
  root.name = "U1";
  root.distance = 1.0;
  root.weight = 0.9;
  root.matchedShare = 0.0;
  result.jaws[0].outlines = { root };
  for (const auto & verdict : Verdict::Evaluate(result))
  {
    ASSERT_EQ(NamesOf(verdict), (Named{ { "outline-unmatched", Suspect } }));
    EXPECT_TRUE(Contains(verdict.findings.front().text, "outline U1 lies on nothing"));
    EXPECT_EQ(verdict.findings.front().value, 0.0);
  }
  result.jaws[0].outlines[0].matchedShare = 0.49;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "outline-unmatched", Suspect } }));
  result.jaws[0].outlines[0].matchedShare = 0.51;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), Named{});
  // One that stands apart is named for that alone.
  result.jaws[0].outlines[0].matchedShare = 0.1;
  result.jaws[0].outlines[0].distance = limits.landmarkApart + 0.01;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "landmark-apart", Suspect } }));
  // It is no witness for the one mark that is left beside one that stands apart.
  result.jaws[0].outlines[0].distance = 1.0;
  result.jaws[1].landmarks.clear();
  result.jaws[0].landmarks[0].distance = limits.landmarkApart + 0.01;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)),
            (Named{ { "landmarks-disagree", Failed }, { "outline-unmatched", Suspect } }));
}

TEST(RegistrationVerdict, OutlinesThatDisagreeAreNotCalledLandmarks)
{
  const Thresholds limits;
  auto             result = MakeResultOfLandmarks();
  for (auto & jaw : result.jaws)
  {
    jaw.landmarks.clear();
    itk::PoseOutlineFit outline;
    outline.name = jaw.jaw == itk::ToothCode::JawEnum::Upper ? "U6" : "L6";
    outline.distance = 1.0;
    jaw.outlines = { outline };
  }
  result.jaws[0].outlines[0].distance = limits.landmarkApart + 0.01;
  const auto finding = Verdict::Evaluate(result).at(0).findings.front();
  EXPECT_EQ(finding.code, "landmarks-disagree");
  EXPECT_TRUE(Contains(finding.text,
                       "the outlines do not fit the scans: outline U6 lies far from where the others "
                       "put it;"))
    << finding.text;
}

TEST(RegistrationVerdict, MarksOfOneJawCannotTellWhichJawTheyAreOf)
{
  const std::string line = "whether what was marked is of this jaw: the same teeth of the other jaw fit as well";
  const itk::PoseRegistrationOptions options;
  const auto                         isSaid = [&](const itk::PoseRegistrationResult & result) {
    const auto lines = Verdict::GetNotCheckable(result, options);
    return std::count(lines.begin(), lines.end(), line) == 1;
  };
  auto result = MakeResultOfLandmarks();
  EXPECT_FALSE(isSaid(result));
  result.jaws[1].landmarks.clear();
  EXPECT_TRUE(isSaid(result));
  result.jaws[0].fit = MakeGoodResult().jaws[0].fit;
  EXPECT_FALSE(isSaid(result));
}

TEST(RegistrationVerdict, WhatIsMissingIsSaidByTheNamesOfWhatWasMarked)
{
  const auto textOf = [](std::size_t landmark) {
    auto result = MakeResultOfLandmarks();
    for (auto & jaw : result.jaws)
    {
      jaw.middleSigma = 12.0;
      if (landmark < jaw.landmarks.size())
      {
        jaw.landmarks = { jaw.landmarks[landmark] };
      }
    }
    return Verdict::Evaluate(result).at(0).findings.front().text;
  };
  EXPECT_TRUE(Contains(textOf(0), "front teeth alone do not tell how the head is tipped: mark molars")) << textOf(0);
  EXPECT_TRUE(Contains(textOf(1), "posterior teeth alone do not tell how the head is tipped: mark incisors"))
    << textOf(1);
  EXPECT_TRUE(Contains(textOf(2), "mark incisors and molars of both jaws")) << textOf(2);
}

TEST(RegistrationVerdict, AnUncertaintyWithoutBoundIsNoNumberOfManyDigits)
{
  auto result = MakeResultOfLandmarks();
  result.jaws[0].middleSigma = 107136.98;
  result.jaws[0].largestMiddleSigma = 151339.8;
  const auto finding = Verdict::Evaluate(result).at(0).findings.front();
  EXPECT_EQ(finding.code, "undetermined");
  EXPECT_TRUE(Contains(finding.text, "is more than 1000 px an axis and up to more than 1000 px")) << finding.text;
  EXPECT_EQ(finding.value, 107136.98);
}

TEST(RegistrationVerdict, LandmarksAloneDoNotVouchForAScaleThatNobodyGave)
{
  auto result = MakeResultOfLandmarks();
  result.geometry.pixelSpacingKnown = false;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "scale-by-landmarks", Suspect } }));
}

TEST(RegistrationVerdict, APatientOnTheHeadFailed)
{
  const Thresholds limits;
  auto             result = MakeResultOfLandmarks();
  result.groups[0].parameters[itk::PosePitch] = -limits.failedPitch - 0.01;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "upside-down", Failed } }));
  result.groups[0].parameters[itk::PosePitch] = -limits.failedPitch + 0.01;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)), (Named{ { "search-limit", Suspect } }));
}

TEST(RegistrationVerdict, LandmarksThatAllLieOffAreRough)
{
  const Thresholds limits;
  auto             result = MakeResultOfLandmarks();
  // Two residuals a landmark: their root mean square.
  const double limit = limits.suspectLandmarkRatio * std::sqrt(2.0);
  for (const double factor : { 0.99, 1.01 })
  {
    for (auto & jaw : result.jaws)
    {
      for (auto & landmark : jaw.landmarks)
      {
        landmark.distance = factor * limit;
      }
    }
    EXPECT_EQ(NamesOf(Verdict::Evaluate(result).at(0)),
              factor < 1.0 ? Named{} : (Named{ { "landmarks-rough", Suspect } }));
  }
}

TEST(RegistrationVerdict, APoorFitThatTheOtherJawBearsOutIsTakenBack)
{
  const Thresholds limits;
  auto             good = MakeGoodResult(2);
  good.groups[0].margin = limits.borneOutMargin;
  good.groups[0].smoothSigma = limits.borneOutSmoothSigma;
  good.jaws[0].fit.cost = limits.borneOutPoorCost;
  good.jaws[0].fit.inlierShare = limits.borneOutInlierShare;
  good.jaws[0].fit.p90Residual = 9.0;
  good.jaws[1].fit.cost = limits.borneOutOtherCost;
  const auto verdicts = Verdict::Evaluate(good);
  for (const auto & verdict : verdicts)
  {
    EXPECT_EQ(verdict.status, StatusEnum::Ok);
    EXPECT_TRUE(verdict.findings.empty());
  }
  ASSERT_EQ(verdicts[0].takenBack.size(), 1U);
  EXPECT_EQ(verdicts[0].takenBack.front().code, "poor-fit");
  EXPECT_TRUE(verdicts[1].takenBack.empty());

  // Whatever else is in doubt leaves it a reason, for both jaws.
  const auto expectSuspect = [&](const auto & change) {
    auto changed = good;
    change(changed);
    for (const auto & verdict : Verdict::Evaluate(changed))
    {
      EXPECT_EQ(verdict.status, StatusEnum::Suspect);
      EXPECT_TRUE(verdict.takenBack.empty());
    }
  };
  using ResultType = itk::PoseRegistrationResult;
  expectSuspect([&](ResultType & result) { result.groups[0].margin = limits.borneOutMargin - 0.01; });
  expectSuspect([&](ResultType & result) { result.groups[0].smoothSigma = limits.borneOutSmoothSigma + 0.01; });
  expectSuspect([&](ResultType & result) { result.jaws[0].fit.cost = limits.borneOutPoorCost + 0.01; });
  expectSuspect([&](ResultType & result) { result.jaws[0].fit.inlierShare = limits.borneOutInlierShare - 0.01; });
  expectSuspect([&](ResultType & result) { result.jaws[1].fit.cost = limits.borneOutOtherCost + 0.01; });
  expectSuspect([&](ResultType & result) { result.jaws[1].fit.codeOffset = limits.suspectCodeOffset + 0.01; });
  expectSuspect([&](ResultType & result) { result.jaws[0].fit.codeOffset = limits.suspectCodeOffset + 0.01; });
  expectSuspect([&](ResultType & result) { result.jaws[1].fit.p90Residual = limits.suspectP90 + 0.01; });
  // A further view of which nothing can be used.
  expectSuspect([&](ResultType & result) { result.views.emplace_back(); });
  // A jaw without a tracing bears nothing out.
  auto alone = good;
  alone.jaws[1].fit = itk::PoseFitStatistics();
  EXPECT_EQ(Verdict::Evaluate(alone)[0].status, StatusEnum::Suspect);
  EXPECT_TRUE(Verdict::Evaluate(alone)[0].takenBack.empty());
}

TEST(RegistrationVerdict, ADentalAxisIsBorneOutByATracingThatDeterminesItOrByWhatDependsLittleOnIt)
{
  const Thresholds                   limits;
  const itk::PoseRegistrationOptions options;
  auto                               result = MakeGoodResult(1);
  Verdict::JawVerdict                verdict;
  const auto                         isBorneOut = [&](const itk::PoseRegistrationOptions & used) {
    return Verdict::IsAxisBorneOut(result.groups[0], result.jaws[0], verdict, used, limits);
  };
  result.jaws[0].fit.cost = limits.borneOutCost;
  result.groups[0].margin = limits.borneOutMargin;
  EXPECT_TRUE(isBorneOut(options));
  result.jaws[0].fit.cost = limits.borneOutCost + 0.01;
  EXPECT_FALSE(isBorneOut(options));
  result.jaws[0].fit.cost = limits.borneOutCost;
  result.groups[0].margin = limits.borneOutMargin - 0.01;
  EXPECT_FALSE(isBorneOut(options));
  result.groups[0].margin = limits.borneOutMargin;
  // A poor fit that the other jaw's tracing excuses (of a cost within the limit, poor at single places) leaves this
  // jaw's no witness of its axis.
  itk::RegistrationFinding poor;
  poor.code = "poor-fit";
  poor.text = "the tracing fits the projected outline poorly";
  verdict.takenBack.push_back(poor);
  EXPECT_FALSE(isBorneOut(options));
  verdict.takenBack.clear();
  EXPECT_TRUE(isBorneOut(options));
  // Held rotations make up for no axis, and a bisected tracing determines none.
  auto held = options;
  held.fixRotation = true;
  EXPECT_FALSE(isBorneOut(held));
  held = options;
  held.useFullPose = false;
  EXPECT_FALSE(isBorneOut(held));
  result.groups[0].bisected = true;
  EXPECT_FALSE(isBorneOut(options));
  result.groups[0].bisected = false;
  // Without a tracing middles are what is determined; a jaw of which nothing was drawn determines nothing.
  result.jaws[0].fit = itk::PoseFitStatistics();
  EXPECT_FALSE(isBorneOut(options));
  result.jaws[0].landmarks.resize(1);
  EXPECT_FALSE(isBorneOut(options));
  result.jaws[0].landmarks.resize(2);
  EXPECT_TRUE(isBorneOut(options));
  result.jaws[0].landmarks.clear();
  result.jaws[0].outlines.resize(2);
  EXPECT_TRUE(isBorneOut(options));
}

TEST(RegistrationVerdict, JawsThatMarksPlaceApartBiteOnEachOther)
{
  const Thresholds limits;
  auto             together = MakeResultOfLandmarks();
  const double     perMillimetre =
    together.geometry.sourceToDetector / together.geometry.sourceToMidsagittal / itk::PoseWorkingPixel;
  for (auto & jaw : together.jaws)
  {
    jaw.molarPlace = { { -100.0, 0.0 } };
    jaw.molarSigma = 0.0;
  }
  auto apart = together;
  apart.groups.push_back(apart.groups[0]);
  apart.groups[0].jaws = { 0 };
  apart.groups[1].jaws = { 1 };
  apart.groupOfJaw = { 0, 1 };
  const auto withGap = [&](itk::PoseRegistrationResult result, double millimetres) {
    result.jaws[1].molarPlace[1] = perMillimetre * millimetres;
    return result;
  };
  const auto hasBite = [](const itk::PoseRegistrationResult & result) {
    unsigned int count = 0;
    for (const auto & verdict : Verdict::Evaluate(result))
    {
      for (const auto & finding : verdict.findings)
      {
        count += finding.code == "bite" && finding.severity == Suspect ? 1 : 0;
      }
    }
    return count;
  };
  const double reach = limits.suspectBite * limits.biteSigma;
  for (const double side : { -1.0, 1.0 })
  {
    EXPECT_EQ(hasBite(withGap(apart, limits.biteMean + side * (reach - 0.01))), 0u);
    EXPECT_EQ(hasBite(withGap(apart, limits.biteMean + side * (reach + 0.01))), 2u);
  }
  // One pose has the bite of the scans.
  EXPECT_EQ(hasBite(withGap(together, 20.0)), 0u);
  // What is predicted for both poses counts as well.
  auto unsure = withGap(apart, limits.biteMean + reach + 0.5);
  unsure.jaws[0].molarSigma = unsure.jaws[1].molarSigma = 0.5 * limits.biteSigma * perMillimetre;
  EXPECT_EQ(hasBite(unsure), 0u);
  // Across the occlusal plane: one that is tipped by 10 degrees has its molars further down where they are further
  // back.
  auto tipped = apart;
  for (auto & group : tipped.groups)
  {
    group.parameters[itk::PosePitch] = 10.0 / 57.29577951308232;
  }
  tipped.jaws[1].molarPlace = { { -100.0 + 30.0 * perMillimetre * std::cos(0.17453292519943295),
                                  30.0 * perMillimetre * std::sin(0.17453292519943295) } };
  EXPECT_EQ(hasBite(tipped), 0u);
  // A tracing says itself whether it fits, and where a scan has no molars nothing is known.
  auto traced = withGap(apart, 20.0);
  traced.jaws[0].fit.numberOfPoints = 50;
  EXPECT_EQ(hasBite(traced), 0u);
  auto toothless = withGap(apart, 20.0);
  toothless.jaws[1].molarPlace[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hasBite(toothless), 0u);
}

TEST(RegistrationVerdict, OutlinesThatShareOutAGrossErrorContradictEachOther)
{
  const Thresholds limits;
  auto             result = MakeResultOfLandmarks();
  // Four of the eight coordinates are the pose's: a shift of each is the root mean square of what is left free.
  for (auto & jaw : result.jaws)
  {
    jaw.landmarks.clear();
    for (const char * name : { "U1", "U6" })
    {
      itk::PoseOutlineFit outline;
      outline.name = name;
      outline.distance = 1.4;
      jaw.outlines.push_back(outline);
    }
  }
  const auto shifted = [&](double distance) {
    auto changed = result;
    for (auto & jaw : changed.jaws)
    {
      for (auto & outline : jaw.outlines)
      {
        outline.shiftDistance = distance;
      }
    }
    return changed;
  };
  EXPECT_EQ(NamesOf(Verdict::Evaluate(shifted(limits.suspectOutlineRatio - 0.01)).at(0)), Named{});
  for (const auto & verdict : Verdict::Evaluate(shifted(limits.suspectOutlineRatio + 0.01)))
  {
    EXPECT_EQ(NamesOf(verdict), (Named{ { "outlines-contradict", Suspect } }));
  }
  // One that was let go does not count, and of three two coordinates are left free.
  auto apart = shifted(limits.suspectOutlineRatio * std::sqrt(2.0 / 3.0) - 0.01);
  apart.jaws[1].outlines[0].distance = limits.landmarkApart + 0.01;
  apart.jaws[1].outlines[0].shiftDistance = 6.0;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(apart).at(0)), (Named{ { "landmark-apart", Suspect } }));
  for (auto & outline : apart.jaws[0].outlines)
  {
    outline.shiftDistance += 0.05;
  }
  EXPECT_EQ(NamesOf(Verdict::Evaluate(apart).at(0)),
            (Named{ { "landmark-apart", Suspect }, { "outlines-contradict", Suspect } }));
  // Landmarks or a tracing place the pose beside them, and are judged themselves; two outlines leave nothing free.
  auto marked = shifted(6.0);
  marked.jaws[1].landmarks = MakeResultOfLandmarks().jaws[1].landmarks;
  EXPECT_EQ(NamesOf(Verdict::Evaluate(marked).at(0)), Named{});
  auto few = shifted(6.0);
  few.jaws[1].outlines.clear();
  EXPECT_EQ(NamesOf(Verdict::Evaluate(few).at(0)), Named{});
}

TEST(RegistrationVerdict, ATracingThatCannotBeMatchedIsSaidWhereLandmarksPlacedTheJaw)
{
  auto result = MakeResultOfLandmarks();
  result.jaws[0].tracingFailure = "no part of it can lie on the outline";
  const auto names = NamesOf(Verdict::Evaluate(result).at(0));
  EXPECT_EQ(names, (Named{ { "tracing-unused", Suspect } }));
}
