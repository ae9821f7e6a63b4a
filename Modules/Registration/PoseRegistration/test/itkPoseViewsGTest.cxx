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
#include "itkPoseRegistrationMethod.h"
#include "itkMessageOfCall.h"

#include "itkDentalPhantomCaseSource.h"
#include "itkDentalPhantomFrontalView.h"
#include "itkExchangedJawsHypothesis.h"
#include "itkLandmarkProjectionFilter.h"
#include "itkRegistrationVerdict.h"
#include "itkToothCrownFilter.h"
#include "itkUMidlineDentalAxisFilter.h"
#include "itkViewVerdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using itk::MessageOfCall;
using Source = itk::DentalPhantomCaseSource;
using MethodType = itk::PoseRegistrationMethod<>;
using JawEnum = MethodType::JawEnum;
using GeometryType = itk::CephalometricGeometry;
using Level = itk::DentalPhantomLevel;

Source::Pointer
MakeCase(bool sameHeadPosition, std::uint64_t seed = 105)
{
  auto  source = Source::New();
  Level level = Level::Named("typical");
  level.frontalView = true;
  level.sameHeadPosition = sameHeadPosition;
  source->SetLevel(level);
  source->SetSeed(seed);
  source->SetNumberOfTriangles(16000);
  source->MakeRadiographOff();
  source->Update();
  return source;
}

Source *
Case()
{
  static const Source::Pointer source = MakeCase(true);
  return source;
}

/** Of the teeth that were drawn on the view, by the scans' labels or by their places along the arch. */
itk::ToothCrownSet::Pointer
FindCrowns(Source * source, bool byLabels, bool exchange = false)
{
  const unsigned int first = exchange ? 1 : 0;
  auto               axis = itk::UMidlineDentalAxisFilter<MethodType::MeshType>::New();
  axis->SetUpperMesh(source->GetMesh(first));
  axis->SetLowerMesh(source->GetMesh(1 - first));
  axis->RefineMidlineOn();
  axis->TransformMeshesOff();
  axis->Update();
  auto filter = itk::ToothCrownFilter::New();
  filter->SetUpperMesh(source->GetMesh(first));
  filter->SetLowerMesh(source->GetMesh(1 - first));
  filter->SetUpperFrame(axis->GetUpperTransformOutput());
  filter->SetLowerFrame(axis->GetLowerTransformOutput());
  filter->SetUpperContour(source->GetFrontalView()->tracings[0]);
  filter->SetLowerContour(source->GetFrontalView()->tracings[1]);
  for (unsigned int jaw = 0; byLabels && jaw < 2; ++jaw)
  {
    std::vector<std::uint8_t> labels;
    const auto *              data = source->GetMesh(jaw)->GetPointData();
    for (auto it = data->Begin(); it != data->End(); ++it)
    {
      labels.push_back(static_cast<std::uint8_t>(it.Value()));
    }
    filter->SetLabels(jaw == 0 ? JawEnum::Upper : JawEnum::Lower, labels);
  }
  filter->Update();
  return filter->GetOutput();
}

MethodType::Pointer
MakeMethod(Source * source)
{
  auto method = MethodType::New();
  method->SetUpperMesh(source->GetMesh(0));
  method->SetLowerMesh(source->GetMesh(1));
  method->SetUpperContour(source->GetTracing(0));
  method->SetLowerContour(source->GetTracing(1));
  method->SetGeometry(source->GetNominalGeometry());
  return method;
}

GeometryType::Pointer
MakeFrontalGeometry(Source * source)
{
  const auto & frontal = *source->GetFrontalView();
  auto         geometry = GeometryType::New();
  geometry->SetDirection(GeometryType::DirectionEnum::Frontal);
  geometry->SetSourceToMidsagittalDistance(frontal.sourceToMidcoronal);
  geometry->SetSourceToDetectorDistance(frontal.sourceToDetector);
  geometry->SetPrincipalPoint(frontal.principalPoint);
  geometry->SetPixelSpacing(frontal.spacing);
  return geometry;
}

void
SetLandmarks(Source * source, itk::CephalogramView * view, bool exchangeSides = false)
{
  auto marks = itk::CephalometricLandmarkSet::New();
  auto counterparts = itk::LandmarkCounterpartSet::New();
  for (const auto & landmark : source->GetFrontalView()->landmarks->GetLandmarks())
  {
    std::string name = landmark.name;
    if (exchangeSides)
    {
      name[1] = name[1] == 'R' ? 'L' : 'R';
    }
    marks->AddLandmark(name, landmark.point, 2.0);
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      if (const auto * place = source->GetLandmarks3D(jaw)->Find(landmark.name))
      {
        itk::LandmarkCounterpartSet::CounterpartType counterpart;
        counterpart.name =
          itk::CephalometricLandmarkSet::MakeName(itk::CephalometricLandmarkSet::ParseName(landmark.name));
        counterpart.jaw = jaw == 0 ? JawEnum::Upper : JawEnum::Lower;
        counterpart.points = { place->point };
        counterparts->Add(counterpart);
      }
    }
  }
  view->SetCephalometricLandmarks(marks);
  view->SetLandmarkCounterparts(counterparts);
}

itk::CephalogramView::Pointer
MakeView(Source * source, bool landmarks, bool contours)
{
  auto view = itk::CephalogramView::New();
  view->SetGeometry(MakeFrontalGeometry(source));
  view->SetSameHeadPosition(source->GetFrontalView()->sameHeadPosition);
  if (landmarks)
  {
    SetLandmarks(source, view);
  }
  if (contours)
  {
    view->SetUpperContour(source->GetFrontalView()->tracings[0]);
    view->SetLowerContour(source->GetFrontalView()->tracings[1]);
  }
  return view;
}

/** How far the found rotation is from the true one: degrees of roll about x, yaw about z, and mm of lateral shift at
 * the upper scan's middle. */
struct ErrorType
{
  double roll;
  double yaw;
  double shift;
};

ErrorType
MeasureError(Source * source, MethodType * method)
{
  const auto * found = method->GetTransform(JawEnum::Upper);
  const auto * truth = source->GetTrueGeometry(0);
  const auto   turn = found->GetMatrix() * GeometryType::RotationType(truth->GetPoseRotation().GetTranspose());
  double       middle[3] = { 0.0, 0.0, 0.0 };
  const auto * mesh = source->GetMesh(0);
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      middle[d] += it.Value()[d] / static_cast<double>(mesh->GetNumberOfPoints());
    }
  }
  const GeometryType::PointType point(middle);
  const double                  degrees = 57.29577951308232;
  return { degrees * 0.5 * (turn(2, 1) - turn(1, 2)),
           degrees * 0.5 * (turn(1, 0) - turn(0, 1)),
           found->TransformPoint(point)[1] - truth->TransformToCephalostat(point)[1] };
}

std::vector<std::string>
CodesOf(const MethodType * method)
{
  std::vector<std::string> codes;
  for (const auto & finding : itk::ViewVerdict::Evaluate(method->GetOutput()->GetResult(), 0))
  {
    codes.push_back(finding.code);
  }
  return codes;
}

bool
Has(const std::vector<std::string> & codes, const std::string & code)
{
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

} // namespace

TEST(PoseViews, AFrontalViewTellsRollYawAndLateralShift)
{
  for (const bool sameHead : { true, false })
  {
    const auto source = sameHead ? Source::Pointer(Case()) : MakeCase(false);
    for (const bool contours : { false, true })
    {
      auto method = MakeMethod(source);
      method->AddView(MakeView(source, !contours, contours));
      method->SetToothCrowns(FindCrowns(source, true));
      method->Update();
      const ErrorType error = MeasureError(source, method);
      // Linearised bounds of twelve landmarks of 0.5 mm: 0.44 degrees of yaw, 0.7 mm with a principal point known to
      // 1 mm; three times that. A head that was turned adds its own 1.5.
      const double factor = sameHead ? 1.0 : 2.5;
      EXPECT_LT(std::abs(error.roll), 1.3 * factor) << sameHead << contours;
      EXPECT_LT(std::abs(error.yaw), 1.4 * factor) << sameHead << contours;
      EXPECT_LT(std::abs(error.shift), 2.1 * factor) << sameHead << contours;
      EXPECT_TRUE(CodesOf(method).empty()) << CodesOf(method).front();
      const auto * solution = method->GetOutput();
      ASSERT_EQ(solution->GetViewNames(), std::vector<std::string>{ "frontal" });
      // What the covariance claims is what the errors are.
      const auto & covariance = solution->GetGroup(JawEnum::Upper).covariance;
      EXPECT_LT(std::sqrt(covariance[8 * itk::PoseYaw]), 0.045);
      const auto & view = solution->GetView("frontal");
      if (sameHead)
      {
        EXPECT_EQ(view.moves[0][0], 0.0);
        EXPECT_EQ(view.moveSigmas[0][0], 0.0);
      }
      EXPECT_GT(view.moveSigmas[0][4], 0.2);
    }
  }
}

TEST(PoseViews, WithoutAViewNothingChangesAndWithOneSigmaOfTheUnseenShrinks)
{
  auto alone = MakeMethod(Case());
  alone->Update();
  auto both = MakeMethod(Case());
  both->AddView(MakeView(Case(), true, false));
  both->Update();
  const auto & one = alone->GetOutput()->GetGroup(JawEnum::Upper).covariance;
  const auto & two = both->GetOutput()->GetGroup(JawEnum::Upper).covariance;
  for (const unsigned int k : { itk::PoseRoll, itk::PoseYaw, itk::PoseTy })
  {
    EXPECT_LT(two[8 * k], 0.8 * one[8 * k]) << k;
  }
  // A change of the view runs the registration again.
  const auto time = both->GetOutput()->GetMTime();
  both->Update();
  EXPECT_EQ(both->GetOutput()->GetMTime(), time);
  both->ClearViews();
  both->Update();
  EXPECT_EQ(both->GetOutput()->GetGroup(JawEnum::Upper).parameters,
            alone->GetOutput()->GetGroup(JawEnum::Upper).parameters);
}

TEST(PoseViews, LandmarksComeOutOnTheViewWithTheirSigma)
{
  auto method = MakeMethod(Case());
  method->AddView(MakeView(Case(), true, false));
  method->Update();
  const auto solution = method->GetOutput()->MakeViewSolution("frontal");
  auto       projection = itk::LandmarkProjectionFilter::New();
  projection->SetSolution(solution);
  projection->SetLandmarks(Case()->GetLandmarks3D(0));
  projection->Update();
  const auto & frontal = *Case()->GetFrontalView();
  double       sum = 0.0;
  std::size_t  inside = 0;
  std::size_t  count = 0;
  for (const auto & landmark : projection->GetOutput()->GetLandmarks())
  {
    double truth[2];
    frontal.projections[0].Project(
      Case()->GetLandmarks3D(0)->Find(landmark.name)->point.GetDataPointer(), truth[0], truth[1]);
    const double distance = std::hypot(landmark.point[0] - truth[0], landmark.point[1] - truth[1]);
    sum += distance;
    ++count;
    inside += distance < 2.448 * projection->GetSigma(landmark.name) ? 1 : 0;
  }
  ASSERT_GT(count, 10u);
  // Marks of 2 px, twelve of them.
  EXPECT_LT(sum / static_cast<double>(count), 3.0);
  EXPECT_GE(inside, count - count / 4);
}

TEST(PoseViews, WhatWasSaidWrongIsNamed)
{
  {
    auto view = MakeView(Case(), false, false);
    SetLandmarks(Case(), view, true);
    auto method = MakeMethod(Case());
    method->AddView(view);
    method->Update();
    EXPECT_TRUE(Has(CodesOf(method), "view-sides"));
  }
  {
    auto view = MakeView(Case(), true, false);
    auto geometry = MakeFrontalGeometry(Case());
    geometry->SetPatientLeft(GeometryType::PatientLeftEnum::Left);
    view->SetGeometry(geometry);
    auto method = MakeMethod(Case());
    method->AddView(view);
    method->Update();
    EXPECT_TRUE(Has(CodesOf(method), "view-sides"));
    // The lateral radiograph stands all the same.
    EXPECT_LT(std::abs(MeasureError(Case(), method).shift), 6.0);
  }
  {
    // The head stood 30 mm to the side of what the principal point says.
    auto view = MakeView(Case(), true, false);
    auto geometry = MakeFrontalGeometry(Case());
    auto principal = geometry->GetPrincipalPoint();
    principal[1] += 120.0;
    geometry->SetPrincipalPoint(principal);
    view->SetGeometry(geometry);
    auto method = MakeMethod(Case());
    method->AddView(view);
    method->Update();
    EXPECT_FALSE(CodesOf(method).empty());
  }
}

TEST(PoseViews, AJawThatWasDrawnOnTheViewAlone)
{
  auto method = MakeMethod(Case());
  method->SetLowerContour(nullptr);
  method->AddView(MakeView(Case(), true, true));
  method->SetToothCrowns(FindCrowns(Case(), true));
  method->Update();
  const auto * solution = method->GetOutput();
  ASSERT_TRUE(solution->IsRegistered(JawEnum::Lower));
  EXPECT_FALSE(solution->GetJaw(JawEnum::Lower).placedByOther);
  EXPECT_FALSE(solution->GetView("frontal").result.jaws[1].landmarks.empty());
  EXPECT_FALSE(solution->GetView("frontal").result.jaws[1].outlines.empty());
}

TEST(PoseViews, EachToothOfATracingIsComparedWithItsOwnCrown)
{
  auto method = MakeMethod(Case());
  auto view = MakeView(Case(), false, true);
  // A border that lies 5 mm beside its tooth is let go and named, and moves no jaw.
  auto drawn = itk::DentalContour::New();
  for (auto polyline : Case()->GetFrontalView()->tracings[0]->GetPolylines())
  {
    for (auto & point : polyline.points)
    {
      point[0] += polyline.code.GetFDI() == 26 ? 20.0 : 0.0;
    }
    drawn->AddPolyline(polyline);
  }
  view->SetUpperContour(drawn);
  method->AddView(view);
  // Without crowns nothing can be compared.
  EXPECT_NE(MessageOfCall([&] { method->Update(); }).find("SetToothCrowns()"), std::string::npos);
  method->SetToothCrowns(FindCrowns(Case(), true));
  method->Update();
  std::size_t seen = 0;
  for (const auto & outline : method->GetOutput()->GetView("frontal").result.jaws[0].outlines)
  {
    seen += outline.name == "UR1" || outline.name == "UL6" ? 1 : 0;
    EXPECT_EQ(outline.distance > 3.0, outline.name == "UL6") << outline.name << ' ' << outline.distance;
    EXPECT_GT(outline.matchedShare, 0.7) << outline.name;
    EXPECT_FALSE(outline.isTemplate);
  }
  EXPECT_EQ(seen, 2u);
  EXPECT_LT(std::abs(MeasureError(Case(), method).yaw), 1.4);
  EXPECT_LT(std::abs(MeasureError(Case(), method).shift), 2.1);
}

TEST(PoseViews, SpeakForAJawWhoseTracingCannotBeUsed)
{
  // Whole teeth of which no crown is known, and a view that both jaws were drawn on.
  auto method = MakeMethod(Case());
  method->SetTracedSide(itk::TracedSideEnum::Standard);
  method->SetToothCrowns(itk::ToothCrownSet::New());
  method->SetUpperContour(nullptr);
  auto marks = itk::CephalometricLandmarkSet::New();
  auto counterparts = itk::LandmarkCounterpartSet::New();
  for (const char * name : { "UR1_tip", "UR6_MB" })
  {
    const auto * place = Case()->GetLandmarks3D(0)->Find(name);
    ASSERT_NE(place, nullptr);
    marks->AddLandmark(name, Case()->GetTrueGeometry(0)->ProjectPoint(place->point), 2.0);
    itk::LandmarkCounterpartSet::CounterpartType counterpart;
    counterpart.name = itk::CephalometricLandmarkSet::MakeName(itk::CephalometricLandmarkSet::ParseName(name));
    counterpart.jaw = JawEnum::Upper;
    counterpart.points = { place->point };
    counterparts->Add(counterpart);
  }
  method->SetCephalometricLandmarks(marks);
  method->SetLandmarkCounterparts(counterparts);
  method->AddView(MakeView(Case(), true, false));
  method->Update();
  const auto & lower = method->GetOutput()->GetJaw(JawEnum::Lower);
  EXPECT_TRUE(lower.registered) << lower.failure;
  EXPECT_FALSE(lower.placedByOther);
  EXPECT_FALSE(lower.unusedOutlines.empty());
}

TEST(PoseViews, ExchangedScansAreFoundBesideATracedView)
{
  auto exchanged = MakeMethod(Case());
  exchanged->SetUpperMesh(Case()->GetMesh(1));
  exchanged->SetLowerMesh(Case()->GetMesh(0));
  exchanged->AddView(MakeView(Case(), false, true));
  exchanged->SetToothCrowns(FindCrowns(Case(), false, true));
  exchanged->Update();
  const auto & group = exchanged->GetOutput()->GetGroup(JawEnum::Upper);
  const auto * outcome = group.FindOutcome(itk::ExchangedJawsHypothesis::Code);
  ASSERT_NE(outcome, nullptr);
  // The jaws exchanged back, each tracing of each view is that of its scan, and each crown that of its tooth, but for
  // how a textbook's widths of the other jaw have cut it.
  auto right = MakeMethod(Case());
  right->AddView(MakeView(Case(), false, true));
  right->SetToothCrowns(FindCrowns(Case(), false));
  right->Update();
  EXPECT_LT(outcome->score, group.score - itk::RegistrationVerdict::Thresholds().hypothesisGain);
  EXPECT_NEAR(outcome->score, right->GetOutput()->GetGroup(JawEnum::Upper).score, 0.05);
}

TEST(PoseViews, SameBitsForAnyNumberOfThreads)
{
  std::vector<itk::PoseParameters> found;
  for (const unsigned int threads : { 1u, 3u })
  {
    auto method = MakeMethod(Case());
    method->AddView(MakeView(Case(), true, true));
    method->SetToothCrowns(FindCrowns(Case(), true));
    method->SetNumberOfWorkUnits(threads);
    method->Update();
    found.push_back(method->GetOutput()->GetGroup(JawEnum::Upper).parameters);
  }
  EXPECT_EQ(found[0], found[1]);
}

TEST(PoseViews, SaysWhatIsMissing)
{
  auto method = MakeMethod(Case());
  auto view = itk::CephalogramView::New();
  method->AddView(view);
  EXPECT_NE(MessageOfCall([&] { method->Update(); }).find("SetGeometry()"), std::string::npos);
  view->SetGeometry(GeometryType::New());
  EXPECT_NE(MessageOfCall([&] { method->Update(); }).find("SetPixelSpacing()"), std::string::npos);
  view->SetGeometry(MakeFrontalGeometry(Case()));
  EXPECT_NE(MessageOfCall([&] { method->Update(); }).find("SetUpperContour()"), std::string::npos);
  EXPECT_NE(MessageOfCall([&] { method->AddView(itk::CephalogramView::New()); }).find("another name"),
            std::string::npos);
  EXPECT_NE(MessageOfCall([&] { method->AddView(nullptr); }).find("no view"), std::string::npos);
  auto solution = itk::PoseSolution::New();
  EXPECT_NE(MessageOfCall([&] { solution->MakeViewSolution("frontal"); }).find("no view \"frontal\""),
            std::string::npos);
}
