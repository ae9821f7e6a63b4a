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
// A control either changes the answer or is said to have changed nothing: of every preset.
#include "itkCaseRegistrationTestCase.h"

#include "itkPoseRegistrationMethodBase.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace
{
using JawEnum = itk::ToothCode::JawEnum;
using PresetEnum = itk::CasePresetEnum;

constexpr PresetEnum AllPresets[] = {
  PresetEnum::Robust, PresetEnum::Paper, PresetEnum::SingleStage, PresetEnum::BoundingBox
};

/** The answer in numbers, and the sentences beside it. */
struct Answer
{
  std::vector<double>      numbers;
  std::vector<std::string> warnings;
};

using SettingType = std::function<void(itk::DentalCaseData &, itk::CaseRegistration &)>;

Answer
AnswerOf(PresetEnum preset, const SettingType & set)
{
  PhantomCase phantom(5, PhantomCase::SideEnum::Right, 2000);
  auto        registration = itk::CaseRegistration::New();
  registration->SetPreset(preset);
  set(*phantom.data, *registration);
  registration->SetData(phantom.data);
  registration->Update();
  Answer answer;
  answer.warnings = registration->GetResult().warnings;
  for (const auto & entry : registration->GetResult().jaws)
  {
    const itk::JawResult & jaw = entry.second;
    EXPECT_TRUE(jaw.registered);
    answer.numbers.insert(answer.numbers.end(), jaw.projection.begin(), jaw.projection.end());
    for (const auto & metric : jaw.metrics)
    {
      answer.numbers.push_back(metric.second.chamfer);
    }
  }
  return answer;
}

const Answer &
PlainAnswer(PresetEnum preset)
{
  static std::map<PresetEnum, Answer> answers;
  if (answers.count(preset) == 0)
  {
    answers[preset] = AnswerOf(preset, [](itk::DentalCaseData &, itk::CaseRegistration &) {});
  }
  return answers[preset];
}

struct Control
{
  std::string name;
  SettingType set;
  /** Of the sentence where it changes nothing. */
  std::string words;
};

void
PrintTo(const Control & control, std::ostream * os)
{
  *os << control.name;
}

class UnusedCaseControls : public ::testing::TestWithParam<Control>
{};

/** A start beside what any preset finds. */
itk::SimilarityParameters
Elsewhere()
{
  itk::SimilarityParameters similarity;
  similarity.scale = 1.03;
  similarity.rotation = 0.06;
  similarity.translation = { { 480.0, 600.0 } };
  return similarity;
}

/** Another hand's: the same drawing to the last digit would count twice, and is not used. */
itk::DentalContour::Pointer
Redrawn(const itk::DentalContour * contour)
{
  auto redrawn = itk::DentalContour::New();
  for (const auto & polyline : contour->GetPolylines())
  {
    auto points = polyline.points;
    for (auto & point : points)
    {
      point[0] += 0.5;
    }
    redrawn->AddPolyline(points, polyline.code);
  }
  return redrawn;
}

void
HoldAll(itk::DentalCase & description)
{
  description.fixScale = description.fixRotation = description.fixTranslation = true;
}
} // namespace

TEST_P(UnusedCaseControls, OnesThatChangeNothingAreSaid)
{
  for (const PresetEnum preset : AllPresets)
  {
    const Answer answer = AnswerOf(preset, GetParam().set);
    const bool   changes = answer.numbers != PlainAnswer(preset).numbers;
    EXPECT_NE(changes, HasLineWith(answer.warnings, GetParam().words)) << itk::ToString(preset);
    if (!changes)
    {
      EXPECT_TRUE(HasLineWith(answer.warnings, std::string("preset ") + itk::ToString(preset)));
    }
  }
}

TEST(UnusedCaseControls, WithoutAnyNothingIsSaid)
{
  for (const PresetEnum preset : AllPresets)
  {
    EXPECT_TRUE(PlainAnswer(preset).warnings.empty()) << PlainAnswer(preset).warnings.front();
  }
}

TEST(UnusedCaseControls, LabelsAreSaidToBeOfNoUseToTheWholeSilhouette)
{
  const auto answer = AnswerOf(PresetEnum::Paper, [](itk::DentalCaseData & data, itk::CaseRegistration &) {
    data.description.upperLabelsFile = "upper.json";
  });
  EXPECT_TRUE(HasLineWith(answer.warnings, "tooth labels of the scans are not used by preset paper"));
}

INSTANTIATE_TEST_SUITE_P(
  All,
  UnusedCaseControls,
  ::testing::Values(
    Control{ "fixScale",
             [](itk::DentalCaseData & data, itk::CaseRegistration &) { data.description.fixScale = true; },
             "\"fix\" changes nothing" },
    Control{ "fixRotation",
             [](itk::DentalCaseData & data, itk::CaseRegistration &) { data.description.fixRotation = true; },
             "\"fix\" changes nothing" },
    Control{ "fixTranslation",
             [](itk::DentalCaseData & data, itk::CaseRegistration &) { data.description.fixTranslation = true; },
             "\"fix\" changes nothing" },
    Control{ "initialSimilarityHeld",
             [](itk::DentalCaseData & data, itk::CaseRegistration &) {
               data.description.initialSimilarity[JawEnum::Upper] = Elsewhere();
               data.description.initialSimilarity[JawEnum::Lower] = Elsewhere();
               HoldAll(data.description);
             },
             "\"init\" is not used" },
    Control{ "initialPoseHeld",
             [](itk::DentalCaseData & data, itk::CaseRegistration & registration) {
               if (registration.GetPreset() == PresetEnum::Robust)
               {
                 HoldAll(data.description);
               }
               data.description.initialPose = { { 1, 0, 0, 40, 0, 1, 0, 0, 0, 0, 1, -50 } };
             },
             "\"init.pose\" is not used" },
    Control{
      "crowns",
      [](itk::DentalCaseData & data, itk::CaseRegistration &) { data.description.crowns = itk::CrownsEnum::Shape; },
      "\"crowns\": \"shape\" is not used" },
    Control{ "cephalometricLandmarks",
             [](itk::DentalCaseData & data, itk::CaseRegistration &) {
               itk::CephalometricLandmarkSet::PointType point;
               point[0] = 569.0;
               point[1] = 643.0;
               data.cephalometricLandmarks = itk::CephalometricLandmarkSet::New();
               data.cephalometricLandmarks->AddLandmark("U1_tip", point);
             },
             "\"cephalometric_landmarks\" are not used" },
    Control{ "views",
             [](itk::DentalCaseData & data, itk::CaseRegistration &) {
               itk::DentalViewData view;
               view.description.name = "second";
               view.description.direction = itk::CephalometricGeometry::DirectionEnum::Lateral;
               view.geometry = itk::CephalometricGeometry::New();
               view.geometry->CopyParameters(data.geometry);
               view.sources = data.sources;
               view.imageSize = data.imageSize;
               view.contours = { { Redrawn(data.upper.contour), Redrawn(data.lower.contour) } };
               data.views.push_back(view);
             },
             "\"views\" are not used" },
    Control{ "option",
             [](itk::DentalCaseData &, itk::CaseRegistration & registration) {
               registration.SetOption("useRobustKernel=off");
             },
             "useRobustKernel=off: options of preset robust" },
    Control{ "refineMidline",
             [](itk::DentalCaseData &, itk::CaseRegistration & registration) { registration.RefineMidlineOff(); },
             "refineMidline=off: options of preset robust" },
    Control{ "callback",
             [](itk::DentalCaseData &, itk::CaseRegistration & registration) {
               registration.SetPoseMethodCallback([](itk::PoseRegistrationMethodBase & method) {
                 auto options = method.GetOptions();
                 options.useRobustKernel = false;
                 method.SetOptions(options);
               });
             },
             "the callback for the method is not called" },
    Control{ "silhouette",
             [](itk::DentalCaseData &, itk::CaseRegistration & registration) { registration.UseSurfaceDRROff(); },
             "the silhouette's source is a choice" },
    Control{ "numberOfContourPoints",
             [](itk::DentalCaseData &, itk::CaseRegistration & registration) {
               registration.SetNumberOfUpperContourPoints(200);
             },
             "(none needed: every preset heeds it)" }),
  [](const ::testing::TestParamInfo<Control> & info) { return info.param.name; });
