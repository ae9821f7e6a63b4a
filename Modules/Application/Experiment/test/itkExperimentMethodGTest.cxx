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
#include "itkExperimentMethod.h"
#include "itkExperimentRecord.h"

#include "itkCaseRegistration.h"
#include "itkMeasureLandmarkErrors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
using CohortEnum = itk::DentalPhantomCaseSource::CohortEnum;
using JawEnum = itk::ToothCode::JawEnum;

double
MeanError(const itk::CaseResult & result, JawEnum jaw)
{
  return result.jaws.at(jaw).error->mean;
}
} // namespace

TEST(ExperimentMethod, GroupsAndOrderAreThoseOfTheTables)
{
  const auto chosen = itk::SelectExperimentMethods({ "robust", "icp", "paper" });
  ASSERT_EQ(chosen.size(), 3u);
  EXPECT_EQ(chosen[0].name, "paper");
  EXPECT_EQ(chosen[1].name, "robust");
  EXPECT_EQ(chosen[2].name, "icp");
  EXPECT_EQ(itk::SelectExperimentMethods({ "all" }).size(), itk::GetExperimentMethods().size());
  EXPECT_EQ(itk::SelectExperimentMethods({ "intensity" }).size(), 3u);
  EXPECT_EQ(itk::SelectExperimentMethods({ "default" }).size() + 3, itk::GetExperimentMethods().size());
  EXPECT_THROW(itk::SelectExperimentMethods({ "paper", "magic" }), std::invalid_argument);
  // One method, two names.
  ASSERT_EQ(itk::SelectExperimentMethods({ "no-coarse-to-fine", "single-stage" }).size(), 1u);
  EXPECT_EQ(itk::SelectExperimentMethods({ "no-coarse-to-fine" }).front().name, "single-stage");
}

TEST(ExperimentCase, SaysOfLandmarksAndOutlinesWhatItsLevelGives)
{
  auto level = itk::DentalPhantomLevel::Named("standard");
  level.numberOfTriangles = 6000;
  for (const char * const form : { "plain", "sigma", "detector" })
  {
    level.landmarkForm = form;
    level.confidence = level.landmarkForm == "plain" ? "none" : "informative";
    auto source = itk::DentalPhantomCaseSource::New();
    source->SetSeed(4);
    source->SetLevel(level);
    source->MakeRadiographOff();
    source->Update();
    const auto   experimentCase = itk::MakePhantomExperimentCase(4, level, false);
    const auto & marks = source->GetStandardTracing()->GetLandmarks();
    const auto & given = experimentCase.data->cephalometricLandmarks->GetLandmarks();
    ASSERT_EQ(given.size(), marks.size());
    for (std::size_t i = 0; i < marks.size(); ++i)
    {
      EXPECT_EQ(given[i].name, marks[i].name);
      EXPECT_EQ(given[i].point[0], marks[i].drawn[0]);
      EXPECT_EQ(given[i].sigma, level.landmarkForm == "sigma" ? marks[i].slip.statedSigma : 0.0) << form;
      EXPECT_EQ(given[i].confidence, level.landmarkForm == "detector" ? marks[i].slip.GetPeak() : -1.0) << form;
    }
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      const auto & lines = experimentCase.data->GetJaw(jaw).contour->GetPolylines();
      ASSERT_EQ(lines.size(), 2u);
      EXPECT_EQ(lines.front().outline, itk::DentalContour::OutlineEnum::Tooth);
      EXPECT_EQ(lines.front().sigmas.empty(), level.confidence == "none");
    }
  }
}

TEST(ExperimentMethod, ACaseThatIsMadeEndsWhereverItIsAborted)
{
  const auto   level = itk::DentalPhantomLevel::Named("typical");
  unsigned int polls = 0;
  itk::MakePhantomExperimentCase(5, level, true, {}, [&polls]() {
    ++polls;
    return false;
  });
  // Jaws, tracing and frames: no stage of them is made whole when somebody waits for the end.
  ASSERT_GT(polls, 20u);
  for (const unsigned int last : { 1u, polls / 2, polls - polls / 4 })
  {
    unsigned int asked = 0;
    EXPECT_THROW(itk::MakePhantomExperimentCase(5, level, true, {}, [&asked, last]() { return ++asked >= last; }),
                 itk::ProcessAborted)
      << last << " of " << polls;
    // A stage that has begun a word of progress may say it before it looks.
    EXPECT_LE(asked, last + 1);
  }
}

TEST(ExperimentMethod, PresetsGiveWhatTheProgramGives)
{
  const auto            experimentCase = itk::MakePhantomExperimentCase(3, CohortEnum::Typical, false);
  itk::ExperimentRunner runner(experimentCase);
  for (const auto & preset : { std::make_pair("paper", itk::CasePresetEnum::Paper),
                               std::make_pair("bounding-box", itk::CasePresetEnum::BoundingBox),
                               std::make_pair("single-stage", itk::CasePresetEnum::SingleStage) })
  {
    const auto ours = runner.Run(*itk::FindExperimentMethod(preset.first));
    auto       registration = itk::CaseRegistration::New();
    registration->SetPreset(preset.second);
    registration->SetData(experimentCase.data);
    registration->Update();
    auto reference = registration->GetResult();
    itk::MeasureLandmarkErrors(reference, experimentCase.marked);
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      EXPECT_EQ(ours.jaws.at(jaw).projection, reference.jaws.at(jaw).projection) << preset.first;
      EXPECT_EQ(MeanError(ours, jaw), MeanError(reference, jaw)) << preset.first;
    }
  }
}

TEST(ExperimentMethod, RobustBeatsEveryBaselineOnACase)
{
  const auto            experimentCase = itk::MakePhantomExperimentCase(4, CohortEnum::Typical, false);
  itk::ExperimentRunner runner(experimentCase);
  const auto            robust = runner.Run(*itk::FindExperimentMethod("robust"));
  for (const auto & method : itk::SelectExperimentMethods({ "default" }))
  {
    if (method.name != "robust")
    {
      const auto result = runner.Run(method);
      for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
      {
        ASSERT_TRUE(result.jaws.at(jaw).registered) << method.name;
        EXPECT_LT(MeanError(robust, jaw), MeanError(result, jaw)) << method.name;
      }
    }
  }
}

TEST(ExperimentMethod, IntensityNeedsARadiograph)
{
  const auto            experimentCase = itk::MakePhantomExperimentCase(4, CohortEnum::Typical, false);
  itk::ExperimentRunner runner(experimentCase);
  const auto            result = runner.RunJaw(*itk::FindExperimentMethod("mutual-information"), JawEnum::Upper);
  EXPECT_FALSE(result.registered);
  ASSERT_FALSE(result.GetReasons().empty());
  EXPECT_EQ(result.GetReasons().front().find("there is no radiograph"), 0u) << result.GetReasons().front();
}

TEST(ExperimentMethod, FileAxesOfAPhantomAreTiltedByAtMost15Degrees)
{
  for (const std::uint64_t seed : { 1u, 2u, 3u })
  {
    const auto experimentCase = itk::MakePhantomExperimentCase(seed, CohortEnum::Ideal, false);
    double     trace = 0.0;
    for (unsigned int row = 0; row < 3; ++row)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        trace += experimentCase.fileAxes[0][row][d] * experimentCase.frames.upper.axes[row][d];
      }
    }
    // The estimated frame is itself within some degrees of the anatomical one.
    EXPECT_LT(std::acos(std::min(1.0, 0.5 * (trace - 1.0))) * 180.0 / 3.14159265, 25.0);
    // Both jaws share one file frame.
    for (unsigned int row = 0; row < 3; ++row)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(experimentCase.fileAxes[0][row][d], experimentCase.fileAxes[1][row][d], 1e-12);
      }
    }
  }
}

TEST(ExperimentCase, VariationsDoWhatTheySay)
{
  const auto plain = itk::MakePhantomExperimentCase(7, CohortEnum::Ideal, false);

  itk::ExperimentVariation variation;
  variation.sourceDistanceFactor = 1.1;
  variation.spacingFactor = 0.97;
  const auto machine = itk::MakePhantomExperimentCase(7, CohortEnum::Ideal, false, variation);
  EXPECT_NEAR(machine.data->geometry->GetSourceToMidsagittalDistance(),
              1.1 * plain.data->geometry->GetSourceToMidsagittalDistance(),
              1e-9);
  EXPECT_NEAR(
    machine.data->geometry->GetSourceToDetectorDistance() - machine.data->geometry->GetSourceToMidsagittalDistance(),
    plain.data->geometry->GetSourceToDetectorDistance() - plain.data->geometry->GetSourceToMidsagittalDistance(),
    1e-9);
  EXPECT_NEAR(machine.data->geometry->GetPixelSpacing()[0], 0.97 * plain.data->geometry->GetPixelSpacing()[0], 1e-12);

  variation = itk::ExperimentVariation();
  variation.extraNoise = 2.0;
  const auto noisy = itk::MakePhantomExperimentCase(7, CohortEnum::Ideal, false, variation);
  double     squares = 0.0;
  const auto count = plain.data->upper.contour->GetNumberOfPoints();
  ASSERT_EQ(noisy.data->upper.contour->GetNumberOfPoints(), count);
  for (itk::IdentifierType i = 0; i < count; ++i)
  {
    squares +=
      noisy.data->upper.contour->GetPoint(i).SquaredEuclideanDistanceTo(plain.data->upper.contour->GetPoint(i));
  }
  // 79 points of which half the variance is correlated: within a factor of 1.6 of 2 px an axis.
  EXPECT_NEAR(std::log(std::sqrt(0.5 * squares / static_cast<double>(count)) / 2.0), 0.0, std::log(1.6));

  variation = itk::ExperimentVariation();
  variation.distalTrim = 10.0;
  const auto trimmed = itk::MakePhantomExperimentCase(7, CohortEnum::Ideal, false, variation);
  EXPECT_LT(trimmed.data->upper.mesh->GetNumberOfCells(), plain.data->upper.mesh->GetNumberOfCells());
  EXPECT_LT(trimmed.data->upper.mesh->GetNumberOfPoints(), plain.data->upper.mesh->GetNumberOfPoints());
  EXPECT_TRUE(trimmed.frames.upper.valid);
}

TEST(ExperimentCase, KnowsAsMuchAsItsVariationSays)
{
  itk::ExperimentVariation variation;
  variation.knowsPixelSpacing = false;
  variation.knowsPrincipalPoint = false;
  variation.facesLeft = true;
  variation.jaws = itk::ExperimentVariation::JawsEnum::LowerAlone;
  const auto less = itk::MakePhantomExperimentCase(7, CohortEnum::Ideal, false, variation);
  EXPECT_FALSE(less.data->HasPixelSpacing());
  EXPECT_FALSE(less.data->HasPrincipalPoint());
  EXPECT_EQ(less.data->geometry->GetFacingSign(), -1.0);
  EXPECT_EQ(less.data->geometry->GetSourceSign(), -1.0);
  EXPECT_TRUE(less.data->upper.mesh.IsNull());
  ASSERT_TRUE(less.data->lower.mesh.IsNotNull());
  EXPECT_TRUE(less.frames.lower.valid);

  variation = itk::ExperimentVariation();
  variation.tracedSide = itk::ExperimentVariation::TracedSideEnum::Mean;
  variation.separateFrames = true;
  const auto middle = itk::MakePhantomExperimentCase(7, CohortEnum::Ideal, false, variation);
  EXPECT_EQ(middle.data->description.tracedSide, itk::TracedSideEnum::Mean);
  EXPECT_FALSE(middle.frames.jawsShareFrame);
  // The middle's sigma reaches the record.
  itk::ExperimentRunner runner(middle);
  itk::ExperimentRecord record;
  record.Add("robust", runner.Run(*itk::FindExperimentMethod("robust")));
  ASSERT_NE(record.Find("robust", "upper"), nullptr);
  ASSERT_FALSE(record.Find("robust", "upper")->landmarks.empty());
  for (const auto & landmark : record.Find("robust", "upper")->landmarks)
  {
    EXPECT_TRUE(landmark.sigma.has_value()) << landmark.name;
  }
}

TEST(ExperimentCase, AStandardTracingComesWithItsLandmarks)
{
  const auto standard = itk::MakePhantomExperimentCase(7, CohortEnum::Standard, false);
  EXPECT_EQ(standard.data->description.tracedSide, itk::TracedSideEnum::Standard);
  ASSERT_TRUE(standard.data->cephalometricLandmarks.IsNotNull());
  for (const char * name : { "U1_tip", "U6_MB", "L1_tip", "L6_MB" })
  {
    const auto * drawn = standard.data->cephalometricLandmarks->Find(name);
    ASSERT_NE(drawn, nullptr) << name;
    // A reader's hand is not exact.
    const auto * exact = standard.marked->Find(std::string(name, 1) + "R" + (name + 1));
    ASSERT_NE(exact, nullptr) << name;
    EXPECT_GT(drawn->point.EuclideanDistanceTo(exact->point), 0.01) << name;
    EXPECT_LT(drawn->point.EuclideanDistanceTo(exact->point), 40.0) << name;
  }
  EXPECT_TRUE(itk::MakePhantomExperimentCase(7, CohortEnum::Ideal, false).data->cephalometricLandmarks.IsNull());
}

TEST(ExperimentRecord, KeepsTheUncertaintyOfTheMiddleWhereThereIsOne)
{
  itk::ExperimentRecord record;
  record.methods["robust"]["upper"].middleSigma = 2.25;
  record.methods["robust"]["lower"].registered = true;
  const auto read = itk::ExperimentRecord::FromJson(record.ToJson("key"), "key");
  ASSERT_NE(read.Find("robust", "upper"), nullptr);
  EXPECT_EQ(read.Find("robust", "upper")->middleSigma, 2.25);
  EXPECT_FALSE(read.Find("robust", "lower")->middleSigma.has_value());
}

TEST(ExperimentCase, MistakesAreMadeAsTheyAreCalled)
{
  using MistakeEnum = itk::ExperimentMistakeEnums::Mistake;
  const auto make = [](MistakeEnum mistake) {
    itk::ExperimentVariation variation;
    variation.mistake = mistake;
    return itk::MakePhantomExperimentCase(7, CohortEnum::Ideal, false, variation);
  };
  const auto plain = make(MistakeEnum::None);
  const auto diagonal = [](const itk::ExperimentCase & each, JawEnum jaw) {
    return std::sqrt(each.data->GetJaw(jaw).mesh->GetBoundingBox()->GetDiagonalLength2());
  };
  const auto codeOf = [](const itk::ExperimentCase & each, JawEnum jaw) {
    return each.data->GetJaw(jaw).contour->GetPolylines().front().code;
  };
  const JawEnum upper = JawEnum::Upper;

  EXPECT_EQ(diagonal(make(MistakeEnum::ScansExchanged), upper), diagonal(plain, JawEnum::Lower));
  // Points of a float mesh.
  EXPECT_NEAR(diagonal(make(MistakeEnum::WrongUnit), upper), 0.1 * diagonal(plain, upper), 1e-4);
  EXPECT_EQ(make(MistakeEnum::WrongFacing).data->geometry->GetFacingSign(), -plain.data->geometry->GetFacingSign());
  EXPECT_NEAR(make(MistakeEnum::WrongSpacing).data->geometry->GetPixelSpacing()[0],
              1.3 * plain.data->geometry->GetPixelSpacing()[0],
              1e-12);
  const auto exchanged = make(MistakeEnum::TracingsExchanged);
  EXPECT_EQ(exchanged.data->upper.contour->GetNumberOfPoints(), plain.data->lower.contour->GetNumberOfPoints());
  EXPECT_EQ(codeOf(exchanged, upper).GetJaw(), upper);
  EXPECT_TRUE(codeOf(make(MistakeEnum::OtherSideTraced), upper).IsRight());
  EXPECT_TRUE(codeOf(make(MistakeEnum::OtherSideTracedAndCoded), upper).IsLeft());
  for (const auto & polyline : make(MistakeEnum::FrontTeethOnly).data->upper.contour->GetPolylines())
  {
    EXPECT_LE(polyline.code.GetPosition(), 3u);
  }

  const auto mirrored = make(MistakeEnum::MirroredScans);
  EXPECT_GT(mirrored.frames.upper.windingAgreement, 0.2);
  EXPECT_LT(make(MistakeEnum::MirroredScansInward).frames.upper.windingAgreement, -0.2);
  const auto was = plain.data->landmarks3D->Find("UL6_MB")->point;
  const auto is = mirrored.data->landmarks3D->Find("UR6_MB")->point;
  EXPECT_EQ(is[0], -was[0]);
  EXPECT_EQ(is[1], was[1]);

  // The scans of another, the radiograph of this one.
  const auto other = make(MistakeEnum::OtherPatient);
  EXPECT_EQ(codeOf(other, upper), codeOf(plain, upper));
  EXPECT_NE(diagonal(other, upper), diagonal(plain, upper));
  EXPECT_EQ(other.marked->Find("UR6_MB")->point, plain.marked->Find("UR6_MB")->point);
}
