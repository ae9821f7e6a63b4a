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
#include "itkCaseRegistration.h"

#include "itkCaseResultWriter.h"
#include "itkDentalPhantomCaseSource.h"

#include "itkCommand.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

namespace
{
using JawEnum = itk::ToothCode::JawEnum;

/** A phantom case in memory; the 2-D landmarks stay outside of it. */
struct PhantomCase
{
  using SideEnum = itk::DentalPhantomCaseSource::TracedSideEnum;

  explicit PhantomCase(std::uint64_t seed, SideEnum side = SideEnum::Right)
  {
    auto source = itk::DentalPhantomCaseSource::New();
    source->SetSeed(seed);
    source->SetTracedSide(side);
    source->SetNumberOfTriangles(12000);
    source->SetMakeRadiograph(false);
    source->Update();
    data = std::make_shared<itk::DentalCaseData>();
    data->geometry = itk::CephalometricGeometry::New();
    data->geometry->CopyParameters(source->GetNominalGeometry());
    data->sources.pixelSpacing = itk::ValueSourceEnum::Given;
    data->sources.principalPoint = itk::ValueSourceEnum::Given;
    data->imageSize = { { 703, 938 } };
    data->landmarks3D = itk::DentalLandmarkSet<3>::New();
    marked = itk::DentalLandmarkSet<2>::New();
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      const unsigned int index = jaw == JawEnum::Upper ? 0 : 1;
      data->GetJaw(jaw).mesh = source->GetMesh(index);
      data->GetJaw(jaw).contour = source->GetTracing(index);
      for (const auto & landmark : source->GetLandmarks3D(index)->GetLandmarks())
      {
        data->landmarks3D->AddLandmark(landmark.name, landmark.point);
      }
      for (const auto & landmark : source->GetLandmarks2D(index)->GetLandmarks())
      {
        marked->AddLandmark(landmark.name, landmark.point);
      }
    }
  }
  std::shared_ptr<itk::DentalCaseData> data;
  itk::DentalLandmarkSet<2>::Pointer   marked;
};

itk::CaseResult
Register(const PhantomCase & phantom, itk::CasePresetEnum preset)
{
  auto registration = itk::CaseRegistration::New();
  registration->SetPreset(preset);
  registration->SetData(phantom.data);
  registration->Update();
  itk::CaseResult result = registration->GetResult();
  itk::MeasureLandmarkErrors(result, phantom.marked);
  return result;
}
} // namespace

TEST(CaseRegistration, RobustIsCloseWhereThePapersRecipeIsNot)
{
  const PhantomCase phantom(5);
  const auto        robust = Register(phantom, itk::CasePresetEnum::Robust);
  const auto        paper = Register(phantom, itk::CasePresetEnum::Paper);
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    ASSERT_TRUE(robust.jaws.at(jaw).error && paper.jaws.at(jaw).error);
    // Twice the worst case that method.md asks for: a coarse mesh, one case.
    EXPECT_LT(robust.jaws.at(jaw).error->mean, 3.0);
    EXPECT_LT(robust.jaws.at(jaw).error->mean, 0.5 * paper.jaws.at(jaw).error->mean);
    EXPECT_EQ(robust.jaws.at(jaw).landmarks.size(), 16u);
    EXPECT_GT(robust.jaws.at(jaw).landmarks.front().GetSigma(), 0.0);
  }
}

TEST(CaseRegistration, OptionsSwitchIngredientsAndStandInTheResult)
{
  const PhantomCase phantom(5);
  auto              registration = itk::CaseRegistration::New();
  registration->SetPreset(itk::CasePresetEnum::Robust);
  registration->SetData(phantom.data);
  registration->Update();
  EXPECT_TRUE(registration->GetResult().options.empty());
  const auto rollOf = [&]() {
    const auto & details = registration->GetResult().jaws.at(JawEnum::Upper).details;
    for (const auto & detail : details)
    {
      if (detail.first == "roll_rad")
      {
        return detail.second;
      }
    }
    return 1e9;
  };
  EXPECT_NE(rollOf(), 0.0);

  // A similarity has no roll.
  registration->SetOption("useFullPose=off");
  registration->SetOption("refineMidline=off");
  registration->Update();
  EXPECT_EQ(rollOf(), 0.0);
  EXPECT_EQ(registration->GetResult().options, (std::vector<std::string>{ "useFullPose=off", "refineMidline=off" }));
  std::ostringstream text;
  registration->Print(text);
  EXPECT_NE(text.str().find("PoseOptions: useFullPose=off"), std::string::npos);

  EXPECT_THROW(registration->SetOption("magic=1"), std::invalid_argument);
  EXPECT_THROW(registration->SetOption("refineMidline=perhaps"), std::invalid_argument);
  EXPECT_FALSE(registration->GetRefineMidline());
}

TEST(CaseRegistration, TheMiddleOfABisectedTracingHasItsOwnSigma)
{
  const PhantomCase phantom(5, PhantomCase::SideEnum::Mean);
  phantom.data->description.tracedSide = itk::TracedSideEnum::Mean;
  const auto result = Register(phantom, itk::CasePresetEnum::Robust);
  for (const auto & landmark : result.jaws.at(JawEnum::Upper).landmarks)
  {
    ASSERT_TRUE(landmark.middleCovariance.has_value()) << landmark.name;
    EXPECT_GT(landmark.GetMiddleSigma(), 0.0);
    // What no bisected tracing tells, the turn about the vertical, moves the sides and not their middle.
    if (landmark.name.find("7_") != std::string::npos)
    {
      EXPECT_LT(landmark.GetMiddleSigma(), landmark.GetSigma()) << landmark.name;
    }
  }
  const auto right = Register(PhantomCase(5), itk::CasePresetEnum::Robust);
  EXPECT_FALSE(right.jaws.at(JawEnum::Upper).landmarks.front().middleCovariance.has_value());
}

TEST(CaseRegistration, ThePapersPresetNeverVouchesForItself)
{
  const auto paper = Register(PhantomCase(5), itk::CasePresetEnum::BoundingBox);
  EXPECT_EQ(paper.GetStatus(), itk::CaseStatusEnum::Suspect);
  EXPECT_FALSE(paper.jaws.at(JawEnum::Upper).reasons.empty());
}

TEST(CaseRegistration, ASecondUpdateRunsNothing)
{
  const PhantomCase phantom(6);
  auto              registration = itk::CaseRegistration::New();
  registration->SetPreset(itk::CasePresetEnum::BoundingBox);
  registration->SetData(phantom.data);
  int starts = 0;
  registration->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++starts; });
  registration->Update();
  registration->Update();
  EXPECT_EQ(starts, 1);
  registration->SetPreset(itk::CasePresetEnum::SingleStage);
  registration->Update();
  EXPECT_EQ(starts, 2);
}

TEST(CaseRegistration, AbortsAtTheNextStage)
{
  for (const auto preset : { itk::CasePresetEnum::Robust, itk::CasePresetEnum::Paper })
  {
    const PhantomCase phantom(6);
    auto              registration = itk::CaseRegistration::New();
    registration->SetPreset(preset);
    registration->SetData(phantom.data);
    bool aborted = false;
    registration->AddObserver(itk::MultiResolutionIterationEvent(), [&](const itk::EventObject &) {
      if (registration->GetCurrentStage().find("registration") != std::string::npos)
      {
        registration->AbortGenerateDataOn();
      }
    });
    registration->AddObserver(itk::AbortEvent(), [&](const itk::EventObject &) { aborted = true; });
    EXPECT_THROW(registration->Update(), itk::ProcessAborted);
    EXPECT_TRUE(aborted);
  }
}

TEST(CaseRegistration, SaysWhatToCallWithoutData)
{
  auto registration = itk::CaseRegistration::New();
  try
  {
    registration->Update();
    FAIL() << "ran without data";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("SetData"), std::string::npos);
  }
  std::ostringstream text;
  registration->Print(text);
  EXPECT_NE(text.str().find("Preset"), std::string::npos);
}

TEST(CaseRegistration, OneJawsFailureDoesNotStopTheOther)
{
  PhantomCase phantom(6);
  auto        few = itk::DentalContour::New();
  few->AddPolyline({ phantom.data->upper.contour->GetPoint(0), phantom.data->upper.contour->GetPoint(1) });
  phantom.data->upper.contour = few;
  const auto result = Register(phantom, itk::CasePresetEnum::Robust);
  EXPECT_EQ(result.jaws.at(JawEnum::Upper).status, itk::CaseStatusEnum::Failed);
  EXPECT_TRUE(result.jaws.at(JawEnum::Lower).registered);
  EXPECT_EQ(result.GetStatus(), itk::CaseStatusEnum::Failed);
}

TEST(CaseRegistration, NoticesExchangedAndMirroredScans)
{
  PhantomCase exchanged(6);
  std::swap(exchanged.data->upper.mesh, exchanged.data->lower.mesh);
  auto result = Register(exchanged, itk::CasePresetEnum::BoundingBox);
  bool named = false;
  for (const std::string & reason : result.jaws.at(JawEnum::Upper).reasons)
  {
    named = named || reason.find("exchanged") != std::string::npos;
  }
  EXPECT_TRUE(named);

  PhantomCase mirrored(6);
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    auto * points = mirrored.data->GetJaw(jaw).mesh->GetPoints();
    for (auto it = points->Begin(); it != points->End(); ++it)
    {
      it.Value()[0] = -it.Value()[0];
    }
  }
  result = Register(mirrored, itk::CasePresetEnum::BoundingBox);
  named = false;
  for (const std::string & reason : result.jaws.at(JawEnum::Upper).reasons)
  {
    named = named || reason.find("mirrored") != std::string::npos;
  }
  EXPECT_TRUE(named);
}

TEST(CaseRegistration, NoticesAWrongUnit)
{
  // A file in mm that the case says is in cm.
  PhantomCase phantom(6);
  phantom.data->description.meshUnit = "cm";
  phantom.data->description.millimetresPerUnit = 10.0;
  auto * points = phantom.data->upper.mesh->GetPoints();
  for (auto it = points->Begin(); it != points->End(); ++it)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      it.Value()[d] *= 10.0F;
    }
  }
  const auto result = Register(phantom, itk::CasePresetEnum::BoundingBox);
  bool       named = false;
  for (const std::string & reason : result.jaws.at(JawEnum::Upper).reasons)
  {
    named = named || reason.find("\"mesh_unit\": \"mm\" would fit") != std::string::npos;
  }
  EXPECT_TRUE(named);
  EXPECT_NE(result.GetStatus(), itk::CaseStatusEnum::Ok);
}
