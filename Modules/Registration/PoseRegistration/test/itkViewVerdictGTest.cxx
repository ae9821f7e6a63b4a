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
#include "itkOtherViewHypothesis.h"
#include "itkViewVerdict.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

// Each threshold just inside and just outside, of results that are made by hand.

namespace
{
using QuestionEnum = itk::OtherViewHypothesis::QuestionEnum;

/** A view on which eight landmarks of one jaw lie as their errors tell. */
itk::PoseRegistrationResult
MakeResult()
{
  itk::PoseRegistrationResult result;
  result.groups.resize(1);
  itk::PoseViewResult view;
  view.name = "frontal";
  view.result.geometry.direction = itk::CephalometricDirectionEnum::Frontal;
  view.priorTensions = { 1.0 };
  itk::PoseJawResult jaw;
  jaw.registered = true;
  for (const char * name : { "UR1_tip", "UL1_tip", "UR3_cusp", "UL3_cusp", "UR6_MB", "UL6_MB", "UR6_DB", "UL6_DB" })
  {
    itk::PoseLandmarkFit landmark;
    landmark.name = name;
    landmark.distance = 1.4;
    jaw.landmarks.push_back(landmark);
  }
  view.result.jaws = { jaw };
  result.views = { view };
  return result;
}

std::vector<std::string>
CodesOf(const std::function<void(itk::PoseRegistrationResult &)> & change)
{
  itk::PoseRegistrationResult result = MakeResult();
  change(result);
  std::vector<std::string> codes;
  for (const auto & finding : itk::ViewVerdict::Evaluate(result, 0))
  {
    EXPECT_EQ(finding.severity, itk::RegistrationStatusEnum::Suspect);
    codes.push_back(finding.code);
  }
  return codes;
}

using Codes = std::vector<std::string>;

std::function<void(itk::PoseRegistrationResult &)>
WithDeviance(QuestionEnum question, double deviance)
{
  return [question, deviance](itk::PoseRegistrationResult & result) {
    auto & outcome = result.groups[0].outcomes[itk::OtherViewHypothesis::MakeCode(question, "frontal")];
    outcome.deviance = deviance;
    outcome.headMove = 1.1;
  };
}
} // namespace

TEST(ViewVerdict, AnAgreeingViewHasNoFindings)
{
  EXPECT_EQ(CodesOf([](itk::PoseRegistrationResult &) {}), Codes());
  EXPECT_EQ(itk::ViewVerdict::GetStatus({}), itk::RegistrationStatusEnum::Ok);
}

TEST(ViewVerdict, AnotherReadingThatExplainsItBetterIsNamed)
{
  EXPECT_EQ(CodesOf(WithDeviance(QuestionEnum::Sides, -9.9)), Codes());
  EXPECT_EQ(CodesOf(WithDeviance(QuestionEnum::Sides, -10.1)), Codes{ "view-sides" });
  EXPECT_EQ(CodesOf(WithDeviance(QuestionEnum::Source, -9.9)), Codes());
  EXPECT_EQ(CodesOf(WithDeviance(QuestionEnum::Source, -10.1)), Codes{ "view-source" });
  EXPECT_EQ(CodesOf(WithDeviance(QuestionEnum::Head, -11.9)), Codes());
  EXPECT_EQ(CodesOf(WithDeviance(QuestionEnum::Head, -12.1)), Codes{ "view-head-moved" });
  // By less than patients are turned: what the first radiograph leaves open.
  EXPECT_EQ(CodesOf([](itk::PoseRegistrationResult & result) {
              auto & outcome =
                result.groups[0].outcomes[itk::OtherViewHypothesis::MakeCode(QuestionEnum::Head, "frontal")];
              outcome.deviance = -100.0;
              outcome.headMove = 0.9;
            }),
            Codes());
  // Of another view it says nothing of this one.
  EXPECT_EQ(CodesOf([](itk::PoseRegistrationResult & result) {
              result.groups[0].outcomes[itk::OtherViewHypothesis::MakeCode(QuestionEnum::Sides, "other")].deviance =
                -100.0;
            }),
            Codes());
}

TEST(ViewVerdict, TheReadingThatExplainsMostIsSaidAndNotItsSymptoms)
{
  const auto withReadings = [](double sides, double source, double head, std::size_t apart) {
    return CodesOf([=](itk::PoseRegistrationResult & result) {
      WithDeviance(QuestionEnum::Sides, sides)(result);
      WithDeviance(QuestionEnum::Source, source)(result);
      WithDeviance(QuestionEnum::Head, head)(result);
      for (std::size_t i = 0; i < apart; ++i)
      {
        result.views[0].result.jaws[0].landmarks[i].distance = 50.0;
      }
    });
  };
  EXPECT_EQ(withReadings(-40.0, -20.0, -30.0, 3), Codes{ "view-sides" });
  EXPECT_EQ(withReadings(-20.0, -40.0, -30.0, 3), Codes{ "view-source" });
  EXPECT_EQ(withReadings(-20.0, -30.0, -40.0, 3), (Codes{ "view-landmark-apart", "view-head-moved" }));
  // Of eight landmarks five are let go: 8 for each of them.
  EXPECT_EQ(withReadings(-40.1, 0.0, 0.0, 5), Codes{ "view-sides" });
  EXPECT_EQ(withReadings(-39.9, 0.0, 0.0, 5), Codes{ "view-disagrees" });
  EXPECT_EQ(withReadings(0.0, -40.1, 0.0, 5), Codes{ "view-source" });
  EXPECT_EQ(withReadings(0.0, -39.9, 0.0, 5), Codes{ "view-disagrees" });
  // Of an outline 40.
  const auto withOutlines = [](double sides) {
    return CodesOf([=](itk::PoseRegistrationResult & result) {
      WithDeviance(QuestionEnum::Sides, sides)(result);
      itk::PoseOutlineFit outline;
      outline.distance = 50.0;
      result.views[0].result.jaws[0].outlines.assign(9, outline);
    });
  };
  EXPECT_EQ(withOutlines(-360.1), Codes{ "view-sides" });
  EXPECT_EQ(withOutlines(-359.9), Codes{ "view-disagrees" });
}

TEST(ViewVerdict, ALandmarkOrAnOutlineThatStandsApartIsNamed)
{
  const auto withLandmark = [](double distance) {
    return [distance](itk::PoseRegistrationResult & result) {
      result.views[0].result.jaws[0].landmarks[2].distance = distance;
    };
  };
  EXPECT_EQ(CodesOf(withLandmark(3.9)), Codes());
  EXPECT_EQ(CodesOf(withLandmark(4.1)), Codes{ "view-landmark-apart" });
  const auto withOutline = [](double distance) {
    return [distance](itk::PoseRegistrationResult & result) {
      itk::PoseOutlineFit outline;
      outline.name = "UL6";
      outline.distance = distance;
      result.views[0].result.jaws[0].outlines.push_back(outline);
    };
  };
  EXPECT_EQ(CodesOf(withOutline(3.9)), Codes());
  EXPECT_EQ(CodesOf(withOutline(4.1)), Codes{ "view-landmark-apart" });
  itk::PoseRegistrationResult result = MakeResult();
  withOutline(4.1)(result);
  EXPECT_EQ(itk::ViewVerdict::Evaluate(result, 0).front().text,
            "landmarks and outlines on it stand apart and were let go: outline UL6");
  // More against it than for it.
  EXPECT_EQ(CodesOf([](itk::PoseRegistrationResult & changed) {
              for (std::size_t i = 0; i < 5; ++i)
              {
                changed.views[0].result.jaws[0].landmarks[i].distance = 5.0;
              }
            }),
            Codes{ "view-disagrees" });
}

TEST(ViewVerdict, LandmarksThatAreRoughByAllAreNamed)
{
  const auto withAll = [](double distance) {
    return [distance](itk::PoseRegistrationResult & result) {
      for (auto & landmark : result.views[0].result.jaws[0].landmarks)
      {
        landmark.distance = distance;
      }
    };
  };
  // Two axes a landmark: 2 standard deviations an axis.
  EXPECT_EQ(CodesOf(withAll(1.98 * 1.4142135623730951)), Codes());
  EXPECT_EQ(CodesOf(withAll(2.02 * 1.4142135623730951)), Codes{ "view-landmarks-rough" });
}

TEST(ViewVerdict, ATracingThatFitsPoorlyAndAHeadElsewhereAreNamed)
{
  const auto withCost = [](double cost) {
    return [cost](itk::PoseRegistrationResult & result) {
      result.views[0].result.jaws[0].fit.numberOfPoints = 40;
      result.views[0].result.jaws[0].fit.cost = cost;
    };
  };
  EXPECT_EQ(CodesOf(withCost(0.49)), Codes());
  EXPECT_EQ(CodesOf(withCost(0.51)), Codes{ "view-poor-fit" });
  const auto withTension = [](double tension) {
    return [tension](itk::PoseRegistrationResult & result) { result.views[0].priorTensions = { 0.5, tension }; };
  };
  EXPECT_EQ(CodesOf(withTension(4.4)), Codes());
  EXPECT_EQ(CodesOf(withTension(4.6)), Codes{ "view-head-moved" });
}

TEST(ViewVerdict, AViewOfWhichNothingWasFoundIsNamed)
{
  EXPECT_EQ(CodesOf([](itk::PoseRegistrationResult & result) { result.views[0].result.jaws[0].landmarks.clear(); }),
            Codes{ "view-unused" });
}
