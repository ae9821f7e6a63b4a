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
#include "itkMessageOfCall.h"
#include "itkPoseSolutionTestCase.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{
using itk::MessageOfCall;
using namespace PoseSolutionTestCase;

SolutionType::PointType
MakePoint(double x, double y, double z)
{
  SolutionType::PointType point;
  point[0] = x;
  point[1] = y;
  point[2] = z;
  return point;
}

int
ExerciseBasicObjectMethods()
{
  const auto solution = MakeSolution(MakeResult());
  ITK_EXERCISE_BASIC_OBJECT_METHODS(solution, PoseSolution, DataObject);
  return EXIT_SUCCESS;
}
} // namespace

TEST(PoseSolution, BasicObjectMethodsAndWhatIsPrinted)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  const auto empty = SolutionType::New();
  EXPECT_TRUE(empty->GetResult().jaws.empty());
  EXPECT_EQ(empty->GetIndex(JawEnum::Upper), -1);
  EXPECT_FALSE(empty->IsRegistered(JawEnum::Lower));
  auto result = MakeResult();
  result.jaws[1].registered = false;
  result.jaws[1].failure = "of no use";
  std::ostringstream text;
  MakeSolution(result)->Print(text);
  for (const char * line : { "upper: registered", "lower: of no use", "Groups: 2", "score 0.1, candidates 0" })
  {
    EXPECT_TRUE(Contains(text.str(), line)) << line;
  }
}

TEST(PoseSolution, ProjectionsTransformsAndGeometryAgree)
{
  for (const double facing : { 1.0, -1.0 })
  {
    for (const double source : { 1.0, -1.0 })
    {
      const auto result = MakeResult(facing, source);
      const auto solution = MakeSolution(result);
      for (const JawEnum jaw : Jaws)
      {
        const auto rigid = solution->MakeRigidTransform(jaw);
        const auto pose = solution->MakePoseTransform(jaw);
        auto       geometry = itk::CephalometricGeometry::New();
        solution->CopyToGeometry(jaw, geometry);
        auto bare = itk::CephalometricGeometry::New();
        bare->CopyParameters(geometry);
        bare->SetPoseToIdentity();
        for (const auto & point : { MakePoint(20.0, -30.0, 5.0), MakePoint(-25.0, 12.0, -18.0) })
        {
          const auto                                      expected = solution->ProjectPoint(jaw, point);
          const auto                                      byGeometry = geometry->ProjectPoint(point);
          const auto                                      byRigid = bare->ProjectPoint(rigid->TransformPoint(point));
          const auto &                                    frame = solution->GetJaw(jaw).frame;
          itk::CephalometricPoseTransform::InputPointType dental;
          for (unsigned int k = 0; k < 3; ++k)
          {
            dental[k] = 0.0;
            for (unsigned int c = 0; c < 3; ++c)
            {
              dental[k] += frame.rotation[3 * k + c] * (point[c] - frame.origin[c]);
            }
          }
          const auto   byPose = pose->TransformPoint(dental);
          const auto   p = solution->GetProjectionMatrix(jaw);
          const double w = p(2, 0) * point[0] + p(2, 1) * point[1] + p(2, 2) * point[2] + p(2, 3);
          for (unsigned int d = 0; d < 2; ++d)
          {
            // Rounding of some 500 px.
            EXPECT_NEAR(
              expected[d], (p(d, 0) * point[0] + p(d, 1) * point[1] + p(d, 2) * point[2] + p(d, 3)) / w, 1e-9);
            EXPECT_NEAR(byGeometry[d], expected[d], 1e-9);
            EXPECT_NEAR(byRigid[d], expected[d], 1e-9);
            EXPECT_NEAR(byPose[d], expected[d], 1e-9);
          }
        }
      }
    }
  }
}

TEST(PoseSolution, MovingContourHoldsAllThatCouldBeMatched)
{
  const auto contour = MakeSolution(MakeResult())->MakeMovingContour(JawEnum::Lower);
  ASSERT_EQ(contour->GetNumberOfPoints(), 3u);
  EXPECT_EQ(contour->GetPolylines()[0].points[2][0], 3.5);
  EXPECT_FALSE(contour->GetPolylines()[0].closed);
  EXPECT_FALSE(contour->HasRimPoints()) << "nobody gave the solution any";
  auto result = MakeResult();
  result.jaws[1].contourPoints = { { { 1, 2, 3 } }, { { 4, 5, 6 } }, { { 7, 8, 9 } } };
  result.jaws[1].contourNormals = { { { 1, 0 } }, { { 0.6, 0.8 } }, { { 0, -1 } } };
  const auto polyline = MakeSolution(result)->MakeMovingContour(JawEnum::Lower)->GetPolylines()[0];
  ASSERT_EQ(polyline.rimPoints.size(), 3u);
  EXPECT_EQ(polyline.rimPoints[1][2], 6.0);
  ASSERT_EQ(polyline.normals.size(), 3u);
  EXPECT_EQ(polyline.normals[1][1], 0.8);
}

TEST(PoseSolution, AlternativesAreMinimaThatArePlacesOfTheirOwnInTheUnitThatIsAskedFor)
{
  itk::PoseRegistrationResult result = PoseSolutionTestCase::MakeResult();
  itk::PoseGroupResult &      group = result.groups[0];
  itk::PoseCandidate          best;
  best.parameters = group.parameters;
  best.score = 0.1;
  group.candidates = { best, best, best };
  // A second way to the same place, just within a working pixel of it, and a place of its own.
  group.candidates[1].distance = 0.99;
  group.candidates[1].score = 0.11;
  group.candidates[2].distance = 8.0;
  group.candidates[2].score = 0.2;
  group.candidates[2].parameters[itk::PoseTx] += 2.0;
  const auto solution = SolutionType::New();
  solution->SetResult(result, itk::PoseRegistrationOptions());
  const auto alternatives = solution->GetAlternatives(JawEnum::Upper);
  ASSERT_EQ(alternatives.size(), 2u);
  EXPECT_EQ(alternatives[0].projection, solution->GetProjectionMatrix(JawEnum::Upper));
  EXPECT_EQ(alternatives[0].score, 0.1);
  EXPECT_EQ(alternatives[0].distance, 0.0);
  EXPECT_EQ(alternatives[1].score, 0.2);
  // 8 px of 0.25 mm are 2 mm on the detector, whose pixels of 0.31 by 0.19 mm are 0.25 mm in the mean.
  EXPECT_NEAR(alternatives[1].distance, 8.0, 1e-12);
  EXPECT_NE(alternatives[1].projection, alternatives[0].projection);

  // A point of a file in metres: its coordinates are a thousandth, its place on the radiograph is the same.
  const auto metres = solution->GetAlternatives(JawEnum::Upper, 1000.0)[1].projection;
  for (unsigned int row = 0; row < 3; ++row)
  {
    double inMetres = metres(row, 3);
    double inMillimetres = alternatives[1].projection(row, 3);
    for (unsigned int column = 0; column < 3; ++column)
    {
      const double point = 10.0 + 3.0 * column;
      inMetres += metres(row, column) * point / 1000.0;
      inMillimetres += alternatives[1].projection(row, column) * point;
    }
    EXPECT_NEAR(inMetres, inMillimetres, 1e-9 * std::abs(inMillimetres)) << row;
  }
  EXPECT_TRUE(solution->GetAlternatives(JawEnum::Lower).empty()) << "made by hand, without minima";
}

TEST(PoseSolution, MotionIsThatOfTheMatchedPointsOnTheDetector)
{
  auto result = MakeResult();
  // Two points of the upper jaw's midsagittal plane, where all is magnified by 1650 / 1500, and one before it.
  result.geometry.pixelSpacing = { { 0.25, 0.25 } };
  for (auto & jaw : result.jaws)
  {
    jaw.frame.rotation = { { 1, 0, 0, 0, 1, 0, 0, 0, 1 } };
    jaw.frame.origin = { { 0, 0, 0 } };
    jaw.contourPoints.clear();
  }
  result.jaws[0].contourPoints = { { { 10.0, 0.0, 3.0 } }, { { -4.0, 0.0, 2.0 } } };
  itk::PoseParameters from{ {} };
  itk::PoseParameters to{ {} };
  to[itk::PoseTx] = 3.0;
  to[itk::PoseTz] = 4.0;
  const auto solution = MakeSolution(result);
  // 5 mm of both, magnified, in pixels of 0.25 mm.
  EXPECT_NEAR(solution->ComputeMotion(0, from, to), 5.0 * 1.1 / 0.25, 1e-9);
  EXPECT_EQ(solution->ComputeMotion(0, to, to), 0.0);
  EXPECT_EQ(solution->ComputeMotion(1, from, to), 0.0) << "nothing was matched there";
  // The factor exp(kappa) moves a point by its distance from the principal point: root mean square of |p| 1.1 / 0.25.
  to = from;
  to[itk::PoseKappa] = std::log(1.01);
  const double squares = (10.0 * 10.0 + 3.0 * 3.0 + 4.0 * 4.0 + 2.0 * 2.0) / 2.0;
  EXPECT_NEAR(solution->ComputeMotion(0, from, to), 0.01 * std::sqrt(squares) * 1.1 / 0.25, 1e-9);
  EXPECT_TRUE(Contains(MessageOfCall([&] { solution->ComputeMotion(2, from, to); }), "no group 2"));
}

TEST(PoseSolution, SigmasOfWhatWasDrawnAreInPixelsOfTheRadiograph)
{
  auto result = MakeResult();
  result.jaws[0].fit.predictedSigma = 3.0;
  result.jaws[0].middleSigma = 5.0;
  // Pixels of 0.31 by 0.19 mm, 0.25 on average, as those that it works in.
  EXPECT_NEAR(MakeSolution(result)->GetTracingSigma(JawEnum::Upper), 3.0, 1e-12);
  result.geometry.pixelSpacing = { { 0.12, 0.08 } };
  EXPECT_NEAR(MakeSolution(result)->GetTracingSigma(JawEnum::Upper), 7.5, 1e-12);
  EXPECT_NEAR(MakeSolution(result)->GetMiddleSigma(JawEnum::Upper), 12.5, 1e-12);
}

TEST(PoseSolution, ProjectsUnderOtherParametersOfThePoseToo)
{
  const auto result = MakeResult();
  const auto solution = MakeSolution(result);
  for (const JawEnum jaw : Jaws)
  {
    EXPECT_EQ(solution->GetProjectionMatrix(jaw, solution->GetGroup(jaw).parameters, 10.0),
              solution->GetProjectionMatrix(jaw, 10.0));
  }
  EXPECT_NE(solution->GetProjectionMatrix(JawEnum::Upper, result.groups[1].parameters),
            solution->GetProjectionMatrix(JawEnum::Upper));
}

TEST(PoseSolution, GraftCopiesAndInitializeForgets)
{
  const auto solution = MakeSolution(MakeResult());
  auto       options = itk::PoseRegistrationOptions();
  options.kappaSigma = 0.5;
  solution->SetResult(MakeResult(), options);
  auto copy = SolutionType::New();
  copy->Graft(solution);
  EXPECT_EQ(copy->GetResult().jaws.size(), 2u);
  EXPECT_EQ(copy->GetOptions().kappaSigma, 0.5);
  EXPECT_EQ(copy->GetGroup(JawEnum::Lower).parameters, solution->GetGroup(JawEnum::Lower).parameters);
  copy->Initialize();
  EXPECT_TRUE(copy->GetResult().jaws.empty());
  EXPECT_EQ(copy->GetOptions().kappaSigma, itk::PoseRegistrationOptions().kappaSigma);
  EXPECT_TRUE(Contains(MessageOfCall([&] { copy->Graft(itk::CephalometricGeometry::New()); }), "takes a PoseSolution"));
}

TEST(PoseSolution, AJawOfNoUseIsAnErrorThatSaysWhy)
{
  auto result = MakeResult();
  result.jaws[1].registered = false;
  result.jaws[1].failure = "the tracing has 4 different points";
  const auto solution = MakeSolution(result);
  EXPECT_EQ(solution->GetIndex(JawEnum::Lower), 1);
  EXPECT_TRUE(solution->IsRegistered(JawEnum::Upper));
  EXPECT_FALSE(solution->IsRegistered(JawEnum::Lower));
  EXPECT_FALSE(solution->IsRegistered(JawEnum::Unknown));
  const SolutionType::PointType point = MakePoint(0.0, 0.0, 0.0);
  for (const std::string & message : { MessageOfCall([&] { solution->ProjectPoint(JawEnum::Lower, point); }),
                                       MessageOfCall([&] { solution->ComputeCovariance(JawEnum::Lower, point); }),
                                       MessageOfCall([&] { solution->MakeRigidTransform(JawEnum::Lower); }),
                                       MessageOfCall([&] { solution->MakePoseTransform(JawEnum::Lower); }) })
  {
    EXPECT_TRUE(Contains(message, "The lower jaw was not registered: the tracing has 4 different points"));
    EXPECT_TRUE(Contains(message, "IsRegistered()")) << message;
  }
  result.jaws.resize(1);
  result.groupOfJaw.resize(1);
  result.groups.resize(1);
  EXPECT_TRUE(Contains(MessageOfCall([&] { MakeSolution(result)->GetJaw(JawEnum::Lower); }),
                       "The lower jaw had no input: give the registration its mesh and its contour."));
}

TEST(PoseSolution, AResultThatNamesWhatItDoesNotHaveIsRefused)
{
  auto result = MakeResult();
  result.groups[1].jaws = { 2 };
  EXPECT_TRUE(Contains(MessageOfCall([&] { MakeSolution(result); }), "Group 1 has jaw 2, of 2 jaws"));
  result = MakeResult();
  result.groupOfJaw[0] = 2;
  EXPECT_TRUE(Contains(MessageOfCall([&] { MakeSolution(result); }), "groupOfJaw of jaw 0 is 2, of 2 groups"));
  // A jaw that was not registered has no group.
  result.jaws[0].registered = false;
  EXPECT_EQ(MakeSolution(result)->GetIndex(JawEnum::Upper), 0);
  result.groupOfJaw.pop_back();
  EXPECT_TRUE(Contains(MessageOfCall([&] { MakeSolution(result); }), "2 jaws and groups of 1"));
}

TEST(PoseSolution, AJawThatTheOtherOnePlacedIsAsUncertainAsTheBiteToo)
{
  auto       result = PoseSolutionTestCase::MakeResult();
  const auto own = itk::PoseSolution::New();
  own->SetResult(result, itk::PoseRegistrationOptions());
  result.jaws[0].placedByOther = true;
  const auto placed = itk::PoseSolution::New();
  placed->SetResult(result, itk::PoseRegistrationOptions());
  itk::PoseSolution::PointType point;
  point[0] = 12.0;
  point[1] = -7.0;
  point[2] = 3.0;
  const auto before = own->ComputeCovariance(JawEnum::Upper, point);
  const auto after = placed->ComputeCovariance(JawEnum::Upper, point);
  // 0.3 mm, magnified 1650 / 1500, on pixels of 0.31 x 0.19 mm.
  EXPECT_NEAR(after(0, 0) - before(0, 0), std::pow(0.3 * 1.1 / 0.31, 2.0), 1e-9);
  EXPECT_NEAR(after(1, 1) - before(1, 1), std::pow(0.3 * 1.1 / 0.19, 2.0), 1e-9);
  EXPECT_EQ(after(0, 1), before(0, 1));
  EXPECT_EQ(placed->ComputeCovariance(JawEnum::Lower, point), own->ComputeCovariance(JawEnum::Lower, point));
}
