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
#include "itkLandmarkProjectionFilter.h"

#include "itkPoseCovarianceReference.h"
#include "itkMessageOfCall.h"
#include "itkPoseSolutionTestCase.h"

#include "itkTestingMacros.h"

#include "vnl/algo/vnl_symmetric_eigensystem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace
{
using itk::MessageOfCall;
using namespace PoseSolutionTestCase;
namespace Reference = PoseCovarianceReference;
using FilterType = itk::LandmarkProjectionFilter;

const std::map<std::string, std::array<double, 3>> Points{ { "UR1_tip", { { 20.0, -30.0, 5.0 } } },
                                                           { "UL1_tip", { { 22.0, 8.0, 4.0 } } },
                                                           { "UR6_MB", { { -25.0, 12.0, -18.0 } } },
                                                           { "LL6_DB", { { -12.0, 21.0, 3.0 } } } };

/** Landmarks in a unit of so many mm. */
FilterType::LandmarksType::Pointer
MakeLandmarks(double unit = 1.0)
{
  auto landmarks = FilterType::LandmarksType::New();
  for (const auto & entry : Points)
  {
    FilterType::LandmarksType::PointType point;
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] = entry.second[d] / unit;
    }
    landmarks->AddLandmark(entry.first, point);
  }
  return landmarks;
}

FilterType::Pointer
Project(const itk::PoseRegistrationResult & result, double unit = 1.0)
{
  auto filter = FilterType::New();
  filter->SetSolution(MakeSolution(result));
  filter->SetLandmarks(MakeLandmarks(unit));
  filter->SetMillimetresPerUnit(unit);
  filter->Update();
  return filter;
}

/** The covariance of a point of the mesh's frame by dense formulas and differences. */
vnl_matrix<double>
ExpectedCovariance(const itk::PoseRegistrationResult & result, unsigned int jaw, const std::array<double, 3> & point)
{
  const auto &             frame = result.jaws[jaw].frame;
  const auto &             g = result.geometry;
  const Reference::Imaging imaging{ g.sourceToMidsagittal, g.sourceToDetector, g.sourceSign,
                                    g.facingSign,          g.pixelSpacing,     g.principalPoint };
  Reference::Point         p{};
  for (unsigned int k = 0; k < 3; ++k)
  {
    for (unsigned int c = 0; c < 3; ++c)
    {
      p[k] += frame.rotation[3 * k + c] * (point[c] - frame.origin[c]);
    }
  }
  vnl_matrix<double> covariance(7, 7);
  covariance.copy_in(result.groups[jaw].covariance.data());
  return Reference::ProjectCovariance(
    [&](const Reference::Parameters & q) { return Reference::ProjectToPixel(imaging, q, p); },
    result.groups[jaw].parameters,
    covariance);
}

int
ExerciseBasicObjectMethods()
{
  const auto filter = Project(MakeResult());
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, LandmarkProjectionFilter, ProcessObject);
  return EXIT_SUCCESS;
}

/** A point that was found on the scan, at the places of both incisors' tips or one. */
itk::LandmarkCounterpartSet::Pointer
MakeCounterparts(const std::vector<std::string> &      places,
                 itk::LandmarkCounterpartSet::RuleEnum rule = itk::LandmarkCounterpartSet::RuleEnum::Foremost)
{
  itk::LandmarkCounterpartSet::CounterpartType counterpart;
  counterpart.name = "U1_mesial";
  counterpart.jaw = JawEnum::Upper;
  counterpart.rule = rule;
  counterpart.sigmaAlong = 2.0;
  counterpart.sigmaAcross = 0.5;
  counterpart.source = "tooth labels";
  for (const std::string & place : places)
  {
    counterpart.points.emplace_back(Points.at(place).data());
  }
  auto set = itk::LandmarkCounterpartSet::New();
  set->Add(counterpart);
  counterpart.name = "UR1_mesial";
  set->Add(counterpart);
  return set;
}

FilterType::Pointer
ProjectCounterparts(const itk::PoseRegistrationResult & result, const itk::LandmarkCounterpartSet * counterparts)
{
  auto filter = FilterType::New();
  filter->SetSolution(MakeSolution(result));
  filter->SetCounterparts(counterparts);
  filter->Update();
  return filter;
}

/** What a length at the midsagittal plane is on the detector, square pixels. */
double
ToSquarePixels(const itk::PoseRegistrationResult & result, double millimetres, unsigned int axis)
{
  const auto & g = result.geometry;
  const double pixels = millimetres * g.sourceToDetector / g.sourceToMidsagittal / g.pixelSpacing[axis];
  return pixels * pixels;
}

void
ExpectNear(const FilterType::CovarianceType & actual, const vnl_matrix<double> & expected, const std::string & what)
{
  for (unsigned int a = 0; a < 2; ++a)
  {
    for (unsigned int b = 0; b < 2; ++b)
    {
      // Differences leave 1e-7 of the derivatives.
      EXPECT_NEAR(actual(a, b), expected(a, b), 1e-6 * std::sqrt(expected(a, a) * expected(b, b))) << what;
    }
  }
}
} // namespace

TEST(LandmarkProjectionFilter, BasicObjectMethodsAndDefaults)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  EXPECT_EQ(FilterType::New()->GetMillimetresPerUnit(), 1.0);
}

TEST(LandmarkProjectionFilter, PlacesAndUncertaintyAreThoseOfTheProjectedPose)
{
  for (const double facing : { 1.0, -1.0 })
  {
    const auto result = MakeResult(facing, -facing);
    // The same points, in cm.
    for (const double unit : { 1.0, 10.0 })
    {
      const auto filter = Project(result, unit);
      ASSERT_EQ(filter->GetOutput()->GetNumberOfLandmarks(), Points.size());
      for (const auto & entry : Points)
      {
        const unsigned int jaw = entry.first[0] == 'U' ? 0 : 1;
        const auto &       a = result.jaws[jaw].projection;
        const auto &       p = entry.second;
        const auto *       found = filter->GetOutput()->Find(entry.first);
        ASSERT_NE(found, nullptr);
        const double w = a[8] * p[0] + a[9] * p[1] + a[10] * p[2] + a[11];
        EXPECT_NEAR(found->point[0], (a[0] * p[0] + a[1] * p[1] + a[2] * p[2] + a[3]) / w, 1e-9);
        EXPECT_NEAR(found->point[1], (a[4] * p[0] + a[5] * p[1] + a[6] * p[2] + a[7]) / w, 1e-9);
        const auto expected = ExpectedCovariance(result, jaw, p);
        ExpectNear(filter->GetCovariance(entry.first), expected, entry.first);
        EXPECT_NEAR(filter->GetSigma(entry.first),
                    std::sqrt(0.5 * (expected(0, 0) + expected(1, 1))),
                    1e-6 * filter->GetSigma(entry.first));
      }
    }
  }
}

TEST(LandmarkProjectionFilter, SigmaIsThatOfSimulatedPoses)
{
  // Poses drawn from the covariance, projected: 4000 of them know a standard deviation to 1.1 %, four times that is
  // allowed; the covariance is small enough that the projection is linear in it.
  auto result = MakeResult();
  for (double & c : result.groups[0].covariance)
  {
    c *= 0.01;
  }
  const auto         filter = Project(result);
  vnl_matrix<double> covariance(7, 7);
  covariance.copy_in(result.groups[0].covariance.data());
  const vnl_symmetric_eigensystem<double> eigen(covariance);
  itk::ReproducibleRandom                 random(7);
  const auto &                            point = Points.at("UR6_MB");
  double                                  sum[2] = { 0.0, 0.0 };
  double                                  squares = 0.0;
  constexpr unsigned int                  draws = 4000;
  for (unsigned int i = 0; i < draws; ++i)
  {
    itk::PoseParameters pose = result.groups[0].parameters;
    for (unsigned int k = 0; k < 7; ++k)
    {
      const double z = random.Normal() * std::sqrt(std::max(0.0, eigen.get_eigenvalue(static_cast<int>(k))));
      for (unsigned int a = 0; a < 7; ++a)
      {
        pose[a] += z * eigen.V(a, k);
      }
    }
    const auto   a = itk::PoseModel(result.geometry, pose).GetPixelProjection(result.jaws[0].frame);
    const double w = a[8] * point[0] + a[9] * point[1] + a[10] * point[2] + a[11];
    for (unsigned int d = 0; d < 2; ++d)
    {
      const double q = (a[4 * d] * point[0] + a[4 * d + 1] * point[1] + a[4 * d + 2] * point[2] + a[4 * d + 3]) / w -
                       filter->GetOutput()->Find("UR6_MB")->point[d];
      sum[d] += q / draws;
      squares += q * q / draws;
    }
  }
  const double variance = 0.5 * (squares - sum[0] * sum[0] - sum[1] * sum[1]);
  EXPECT_NEAR(std::sqrt(variance) / filter->GetSigma("UR6_MB"), 1.0, 0.045);
}

TEST(LandmarkProjectionFilter, MiddleIsThatOfALandmarkAndItsCounterpart)
{
  const auto result = MakeResult();
  const auto filter = Project(result, 10.0);
  for (const char * name : { "UR1_tip", "UL1_tip" })
  {
    ASSERT_TRUE(filter->HasMiddleCovariance(name));
    ExpectNear(filter->GetMiddleCovariance(name), ExpectedCovariance(result, 0, { { 21.0, -11.0, 4.5 } }), name);
  }
  // The other molar is of the other jaw.
  EXPECT_FALSE(filter->HasMiddleCovariance("UR6_MB"));
  EXPECT_FALSE(filter->HasMiddleCovariance("LL6_DB"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { filter->GetMiddleCovariance("UR6_MB"); }), "no counterpart"));
}

TEST(LandmarkProjectionFilter, ExpectedErrorIsTheMeanOverLandmarksOrOverMiddles)
{
  // The mean length of a normal error in two dimensions is sqrt(pi / 2) = 1.2533 of its standard deviation an axis.
  EXPECT_NEAR(FilterType::ToMeanDistance(2.0), 2.50662827463, 1e-11);
  auto         result = MakeResult();
  const auto   filter = Project(result);
  const double upper = (filter->GetSigma("UR1_tip") + filter->GetSigma("UL1_tip") + filter->GetSigma("UR6_MB")) / 3.0;
  EXPECT_FALSE(filter->GetBisected());
  EXPECT_DOUBLE_EQ(filter->GetExpectedError(JawEnum::Upper), FilterType::ToMeanDistance(upper));
  EXPECT_DOUBLE_EQ(filter->GetExpectedError(JawEnum::Lower), FilterType::ToMeanDistance(filter->GetSigma("LL6_DB")));
  filter->BisectedOn();
  filter->Update();
  ASSERT_EQ(filter->GetMiddles().size(), 1u);
  EXPECT_DOUBLE_EQ(filter->GetExpectedError(JawEnum::Upper),
                   FilterType::ToMeanDistance(FilterType::ToSigma(filter->GetMiddles()[0].covariance)));
  EXPECT_DOUBLE_EQ(filter->GetExpectedError(JawEnum::Lower), FilterType::ToMeanDistance(filter->GetSigma("LL6_DB")))
    << "no pair has a middle there";
  result.jaws[1].registered = false;
  const auto alone = Project(result);
  EXPECT_TRUE(alone->HasExpectedError(JawEnum::Upper));
  EXPECT_FALSE(alone->HasExpectedError(JawEnum::Lower));
  EXPECT_TRUE(Contains(MessageOfCall([&] { alone->GetExpectedError(JawEnum::Lower); }), "HasExpectedError()"));
}

TEST(LandmarkProjectionFilter, LandmarksOfAJawThatWasNotRegisteredAreLeftOut)
{
  auto result = MakeResult();
  result.jaws[1].registered = false;
  const auto filter = Project(result);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLandmarks(), 3u);
  EXPECT_EQ(filter->GetOutput()->Find("LL6_DB"), nullptr);
  EXPECT_TRUE(Contains(MessageOfCall([&] { filter->GetCovariance("LL6_DB"); }), "no landmark \"LL6_DB\""));
  EXPECT_TRUE(Contains(MessageOfCall([&] { filter->GetSigma("LL6_DB"); }), "call Update()"));
}

TEST(LandmarkProjectionFilter, FollowsASolutionThatChanges)
{
  auto       result = MakeResult();
  const auto solution = MakeSolution(result);
  auto       filter = FilterType::New();
  filter->SetSolution(solution);
  filter->SetLandmarks(MakeLandmarks());
  filter->Update();
  const double sigma = filter->GetSigma("UR1_tip");
  for (double & c : result.groups[0].covariance)
  {
    c *= 4.0;
  }
  solution->SetResult(result, itk::PoseRegistrationOptions());
  filter->Update();
  EXPECT_NEAR(filter->GetSigma("UR1_tip"), 2.0 * sigma, 1e-9 * sigma);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLandmarks(), Points.size()) << "not appended to what was there";
}

TEST(LandmarkProjectionFilter, ALandmarkWithoutAPlaceIsAnErrorNotAnInfinitePlace)
{
  // A unit with which every point is infinitely far away.
  auto filter = FilterType::New();
  filter->SetSolution(MakeSolution(MakeResult()));
  filter->SetLandmarks(MakeLandmarks());
  filter->SetMillimetresPerUnit(1e308);
  const std::string message = MessageOfCall([&] { filter->Update(); });
  EXPECT_TRUE(Contains(message, "The solution projects landmark LL6_DB to ")) << message;
  EXPECT_TRUE(Contains(message, "SetMillimetresPerUnit()")) << message;
}

TEST(LandmarkProjectionFilter, MiddlesOfPointsThatWereFoundKnowTheirPlacesOnTheScan)
{
  const auto result = MakeResult();
  const auto filter = ProjectCounterparts(result, MakeCounterparts({ "UR1_tip", "UL1_tip" }));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLandmarks(), 0u) << "they are no landmarks of the scan";
  filter->BisectedOn();
  filter->Update();
  EXPECT_FALSE(filter->HasExpectedError(JawEnum::Upper)) << "that of a jaw knows nothing of places on the scan";
  ASSERT_EQ(filter->GetMiddles().size(), 1u) << "a point of one side is no middle";
  const auto & middle = filter->GetMiddles().front();
  EXPECT_EQ(middle.name, "U1_mesial");
  EXPECT_EQ(middle.jaw, JawEnum::Upper);
  EXPECT_EQ(middle.source, "tooth labels");
  const auto both = Project(result)->GetMiddles();
  ASSERT_EQ(both.size(), 1u);
  EXPECT_EQ(both.front().source, "landmarks_3d");
  vnl_matrix<double> expected = ExpectedCovariance(result, 0, { { 21.0, -11.0, 4.5 } });
  expected(0, 0) += ToSquarePixels(result, 2.0, 0);
  expected(1, 1) += ToSquarePixels(result, 0.5, 1);
  ExpectNear(middle.covariance, expected, "two");
  for (unsigned int d = 0; d < 2; ++d)
  {
    EXPECT_NEAR(middle.point[d], both.front().point[d], 1e-9);
  }
}

TEST(LandmarkProjectionFilter, AMiddleOfOneSideMayBeElsewhere)
{
  using SetType = itk::LandmarkCounterpartSet;
  const auto result = MakeResult();
  for (const auto rule : { SetType::RuleEnum::Foremost, SetType::RuleEnum::Middle })
  {
    const auto filter = ProjectCounterparts(result, MakeCounterparts({ "UR1_tip" }, rule));
    ASSERT_EQ(filter->GetMiddles().size(), 1u);
    const auto & middle = filter->GetMiddles().front();
    EXPECT_EQ(middle.source, "tooth labels, one side");
    // Of posterior teeth the counterpart's own errors know it.
    const bool   wider = rule == SetType::RuleEnum::Foremost;
    const double along = wider ? std::hypot(2.0, SetType::OneSideSigmaAlong) : 2.0;
    const double across = wider ? std::hypot(0.5, SetType::OneSideSigmaAcross) : 0.5;
    auto         expected = ExpectedCovariance(result, 0, Points.at("UR1_tip"));
    expected(0, 0) += ToSquarePixels(result, along, 0);
    expected(1, 1) += ToSquarePixels(result, across, 1);
    ExpectNear(middle.covariance, expected, "one");
  }
}

TEST(LandmarkProjectionFilter, AMarkOfThePointTellsOfItsPlaceAsWell)
{
  auto           result = MakeResult();
  const auto     pose = ExpectedCovariance(result, 0, { { 21.0, -11.0, 4.5 } });
  const double   place[2] = { ToSquarePixels(result, 2.0, 0), ToSquarePixels(result, 0.5, 1) };
  constexpr auto near = 1e-5;

  itk::PoseLandmarkFit mark;
  mark.name = "U1_mesial";
  // Of the residual's variance the place has two thirds along and a third across.
  const double share[2] = { 2.0 / 3.0, 1.0 / 3.0 };
  mark.sigma = { { std::sqrt(place[0] / share[0]), std::sqrt(place[1] / share[1]) } };
  const auto covarianceOf = [&](const itk::PoseLandmarkFit & landmark) {
    result.jaws[0].landmarks = { landmark };
    const auto middles = ProjectCounterparts(result, MakeCounterparts({ "UR1_tip", "UL1_tip" }))->GetMiddles();
    EXPECT_EQ(middles.size(), 1u);
    return middles.front().covariance;
  };
  // The mark lies where the place is: it bears it out.
  vnl_matrix<double> told(2, 2);
  for (unsigned int d = 0; d < 2; ++d)
  {
    for (unsigned int k = 0; k < 2; ++k)
    {
      told(d, k) = (1.0 - share[d]) * (1.0 - share[k]) * pose(d, k) + (d == k ? (1.0 - share[d]) * place[d] : 0.0);
    }
  }
  ExpectNear(covarianceOf(mark), told, "on it");
  // Beside it, it says that the place is off by its share of that.
  mark.residual = { { 12.0, -3.0 } };
  const double off[2] = { share[0] * 12.0, share[1] * -3.0 };
  auto         beside = told;
  for (unsigned int d = 0; d < 2; ++d)
  {
    for (unsigned int k = 0; k < 2; ++k)
    {
      beside(d, k) += off[d] * off[k];
    }
  }
  ExpectNear(covarianceOf(mark), beside, "beside it");
  // What the kernel has let go tells nothing, and by half half of it.
  auto unmarked = pose;
  unmarked(0, 0) += place[0];
  unmarked(1, 1) += place[1];
  mark.weight = 0.0;
  ExpectNear(covarianceOf(mark), unmarked, "let go");
  mark.weight = 0.5;
  const auto half = covarianceOf(mark);
  for (unsigned int d = 0; d < 2; ++d)
  {
    EXPECT_NEAR(half(d, d), 0.5 * (unmarked(d, d) + beside(d, d)), near * half(d, d));
  }
}

TEST(LandmarkProjectionFilter, LandmarksGoBeforePointsThatWereFound)
{
  auto                                         set = itk::LandmarkCounterpartSet::New();
  itk::LandmarkCounterpartSet::CounterpartType counterpart;
  counterpart.name = "U1_tip";
  counterpart.jaw = JawEnum::Upper;
  counterpart.sigmaAlong = counterpart.sigmaAcross = 3.0;
  counterpart.source = "its place along the arch";
  counterpart.points.resize(1);
  set->Add(counterpart);
  auto filter = Project(MakeResult());
  filter->SetCounterparts(set);
  filter->Update();
  ASSERT_EQ(filter->GetMiddles().size(), 1u);
  EXPECT_EQ(filter->GetMiddles().front().source, "landmarks_3d");
}

TEST(LandmarkProjectionFilter, ThereMustBeSomethingToProject)
{
  auto filter = FilterType::New();
  filter->SetSolution(MakeSolution(MakeResult()));
  EXPECT_TRUE(Contains(MessageOfCall([&] { filter->Update(); }), "SetCounterparts()"));
}
