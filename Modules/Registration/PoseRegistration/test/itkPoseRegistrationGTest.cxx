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
#include "itkPoseRegistrationTestCase.h"
#include "itkRegistrationVerdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using Source = itk::DentalPhantomCaseSource;
using CohortEnum = Source::CohortEnum;
using SideEnum = Source::TracedSideEnum;
using StatusEnum = itk::RegistrationVerdict::StatusEnum;

const PoseRegistrationTestCase &
Typical()
{
  static const PoseRegistrationTestCase typical(71, CohortEnum::Typical, SideEnum::Right);
  return typical;
}

bool
HasReason(const itk::RegistrationVerdict::JawVerdict & verdict, const std::string & code)
{
  return std::any_of(
    verdict.findings.begin(), verdict.findings.end(), [&](const auto & reason) { return reason.code == code; });
}
} // namespace

TEST(PoseRegistration, FindsTheTruthWhereTheTracingHasNoNoise)
{
  const PoseRegistrationTestCase c(70, CohortEnum::Ideal, SideEnum::Right);
  const auto result = PoseRegistrationTestCase::Run(c.jaws, c.geometry, itk::PoseRegistrationOptions());
  for (unsigned int jaw : { 0u, 1u })
  {
    // A mesh of 16 000 triangles has facets of 1-2 px.
    EXPECT_LT(c.Error(result, jaw, 'R'), 0.5);
    EXPECT_GT(result.jaws[jaw].fit.inlierShare, 0.95);
  }
}

TEST(PoseRegistration, IsBelowTwoPixelsWithNoiseAndAPoseAndKnowsIt)
{
  const auto result = PoseRegistrationTestCase::Run(Typical().jaws, Typical().geometry, itk::PoseRegistrationOptions());
  const auto verdicts = itk::RegistrationVerdict::Evaluate(result);
  for (unsigned int jaw : { 0u, 1u })
  {
    // Noise of 1.2 px: the worst of 34 cases was 1.5 px.
    EXPECT_LT(Typical().Error(result, jaw, 'R'), 2.0);
    EXPECT_EQ(verdicts[jaw].status, StatusEnum::Ok);
    EXPECT_GT(result.jaws[jaw].fit.predictedSigma, 0.2);
    EXPECT_LT(result.jaws[jaw].fit.predictedSigma, 3.0);
  }
  EXPECT_EQ(result.groups.size(), 1u);
}

TEST(PoseRegistration, MinimaAreRankedByTheirPosteriorAndTheCovarianceHoldsThoseThatMayBeTrue)
{
  unsigned int reordered = 0, mixed = 0;
  for (const std::uint64_t seed : { 304, 305, 306 })
  {
    const PoseRegistrationTestCase c(seed, CohortEnum::Hard, SideEnum::Right);
    for (const unsigned int jaw : { 0u, 1u })
    {
      const itk::PoseRegistrationOptions options;
      const auto                         result = PoseRegistrationTestCase::Run({ c.jaws[jaw] }, c.geometry, options);
      const auto &                       group = result.groups[0];
      const auto &                       best = group.candidates[0];
      EXPECT_EQ(best.parameters, group.parameters);
      double margin = 1.0;
      for (std::size_t i = 1; i < group.candidates.size(); ++i)
      {
        const itk::PoseCandidate & other = group.candidates[i];
        EXPECT_GE(other.deviance, group.candidates[i - 1].deviance);
        reordered += other.score < group.candidates[i - 1].score ? 1 : 0;
        const double odds = std::exp(-0.5 * (other.deviance - best.deviance));
        margin = other.distance > options.placeDistance ? std::min(margin, 1.0 - odds) : margin;
        if (odds < 0.01 || other.distance < 1.0)
        {
          continue;
        }
        // Of four minima at the most, the best of which weighs 1: a share of a quarter of its odds, or more.
        ++mixed;
        for (unsigned int k = 0; k < 7; ++k)
        {
          const double apart = other.parameters[k] - best.parameters[k];
          EXPECT_GT(group.covariance[8 * k], 0.25 * odds * apart * apart) << "seed " << seed << ", parameter " << k;
        }
      }
      // Rounding.
      EXPECT_NEAR(group.margin, margin, 1e-12);
    }
  }
  EXPECT_GT(reordered, 0u) << "the claims need minima that the score ranks in another order";
  EXPECT_GT(mixed, 0u) << "and minima that may be the true ones";
}

TEST(PoseRegistration, RegionsContainTheTruthAsOftenAsTheySay)
{
  // 24 cases, 384 landmarks that err together in each case: an effective number of some 60, of which 95 % +- 3 % (1 sd)
  // lie inside where the regions are right.
  unsigned int inside = 0, all = 0;
  for (std::uint64_t seed = 300; seed < 324; ++seed)
  {
    const PoseRegistrationTestCase c(seed, seed % 2 == 0 ? CohortEnum::Typical : CohortEnum::Hard, SideEnum::Right);
    const auto result = PoseRegistrationTestCase::Run(c.jaws, c.geometry, itk::PoseRegistrationOptions());
    for (const auto & landmark : c.landmarks)
    {
      if (landmark.first[1] != 'R')
      {
        continue;
      }
      const unsigned int jaw = landmark.first[0] == 'U' ? 0 : 1;
      const auto         s = PoseRegistrationTestCase::LandmarkCovariance(result, jaw, landmark.second);
      const auto &       a = result.jaws[jaw].projection;
      const auto &       p = landmark.second;
      const auto &       q = c.truth.at(landmark.first);
      const double       w = a[8] * p[0] + a[9] * p[1] + a[10] * p[2] + a[11];
      const double       error = std::hypot((a[0] * p[0] + a[1] * p[1] + a[2] * p[2] + a[3]) / w - q[0],
                                      (a[4] * p[0] + a[5] * p[1] + a[6] * p[2] + a[7]) / w - q[1]);
      inside += error < 2.448 * std::sqrt(0.5 * (s(0, 0) + s(1, 1))) ? 1 : 0;
      ++all;
    }
  }
  ASSERT_EQ(all, 384u);
  EXPECT_GT(inside, all * 86 / 100);
}

TEST(PoseRegistration, ATurnedHeadIsNotPulledStraight)
{
  // 10 degrees, where the prior's standard deviation is 3.5: its tails let the data decide.
  const PoseRegistrationTestCase turned(73, CohortEnum::Typical, SideEnum::Right, 0.1745);
  itk::PoseRegistrationOptions   options;
  const auto                     result = PoseRegistrationTestCase::Run(turned.jaws, turned.geometry, options);
  const auto                     verdicts = itk::RegistrationVerdict::Evaluate(result);
  for (unsigned int jaw : { 0u, 1u })
  {
    EXPECT_LT(turned.Error(result, jaw, 'R'), 2.0);
    EXPECT_FALSE(HasReason(verdicts[jaw], "prior-tension"));
  }
  options.rotationPriorFreedom = 0.0;
  options.rollSigma = options.yawSigma = 0.0349;
  const auto gaussian = PoseRegistrationTestCase::Run(turned.jaws, turned.geometry, options);
  EXPECT_LT(std::abs(gaussian.groups[0].parameters[itk::PoseYaw]), std::abs(result.groups[0].parameters[itk::PoseYaw]));
}

TEST(PoseRegistration, EachPriorIsJudgedByItsOwnLimit)
{
  auto result = PoseRegistrationTestCase::Run(Typical().jaws, Typical().geometry, itk::PoseRegistrationOptions());
  result.groups[0].priorTension = { { 0.0, 4.0, 4.0, 0.0, 0.0, 0.0, 0.0 } };
  EXPECT_FALSE(HasReason(itk::RegistrationVerdict::Evaluate(result)[0], "prior-tension"));
  result.groups[0].priorTension[itk::PoseYaw] = 6.0;
  EXPECT_TRUE(HasReason(itk::RegistrationVerdict::Evaluate(result)[0], "prior-tension"));
  result.groups[0].priorTension = { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 5.0 } };
  EXPECT_TRUE(HasReason(itk::RegistrationVerdict::Evaluate(result)[0], "prior-tension"));
}

TEST(PoseRegistration, GivesTheSameBitsForAnyNumberOfThreads)
{
  itk::PoseRegistrationOptions options;
  options.numberOfThreads = 1;
  const auto one = PoseRegistrationTestCase::Run(Typical().jaws, Typical().geometry, options);
  options.numberOfThreads = 3;
  const auto three = PoseRegistrationTestCase::Run(Typical().jaws, Typical().geometry, options);
  EXPECT_EQ(one.groups[0].parameters, three.groups[0].parameters);
  EXPECT_EQ(one.groups[0].covariance, three.groups[0].covariance);
  EXPECT_EQ(one.jaws[1].projection, three.jaws[1].projection);
  EXPECT_EQ(one.groups[0].outcomes.at("other-side").deviance, three.groups[0].outcomes.at("other-side").deviance);
}

TEST(PoseRegistration, DirectionAndOrderOfThePolylinesDoNotMatter)
{
  auto jaws = Typical().jaws;
  for (auto & jaw : jaws)
  {
    std::reverse(jaw.tracing.begin(), jaw.tracing.end());
    std::reverse(jaw.tracing[1].points.begin(), jaw.tracing[1].points.end());
    std::reverse(jaw.tracing[4].points.begin(), jaw.tracing[4].points.end());
  }
  const itk::PoseRegistrationOptions options;
  const auto                         shuffled = PoseRegistrationTestCase::Run(jaws, Typical().geometry, options);
  const auto                         plain = PoseRegistrationTestCase::Run(Typical().jaws, Typical().geometry, options);
  EXPECT_EQ(shuffled.groups[0].parameters, plain.groups[0].parameters);
}

TEST(PoseRegistration, MirroredImageWithTheOtherFacingIsTheSameCase)
{
  auto jaws = Typical().jaws;
  auto geometry = Typical().geometry;
  geometry.facingSign = -1.0;
  geometry.principalPoint[0] = 702.0 - geometry.principalPoint[0];
  for (auto & jaw : jaws)
  {
    for (auto & polyline : jaw.tracing)
    {
      for (auto & p : polyline.points)
      {
        p[0] = 702.0 - p[0];
      }
    }
  }
  const itk::PoseRegistrationOptions options;
  const auto                         mirrored = PoseRegistrationTestCase::Run(jaws, geometry, options);
  const auto                         plain = PoseRegistrationTestCase::Run(Typical().jaws, Typical().geometry, options);
  for (unsigned int k = 0; k < 7; ++k)
  {
    // Rounding of 702 - u, amplified by discrete matches.
    EXPECT_NEAR(mirrored.groups[0].parameters[k], plain.groups[0].parameters[k], 1e-3);
  }
}

TEST(PoseRegistration, RegistersOneJawAlone)
{
  for (unsigned int jaw : { 0u, 1u })
  {
    const PoseRegistrationTestCase::JawsType alone{ Typical().jaws[jaw] };
    const auto result = PoseRegistrationTestCase::Run(alone, Typical().geometry, itk::PoseRegistrationOptions());
    itk::PoseRegistrationResult placed;
    placed.jaws = { result.jaws[0], result.jaws[0] };
    EXPECT_LT(Typical().Error(placed, jaw, 'R'), 2.5);
  }
}

TEST(PoseRegistration, EstimatesAScaleWithoutAPixelSpacingAndSaysSoInTheCovariance)
{
  auto geometry = Typical().geometry;
  geometry.pixelSpacingKnown = false;
  geometry.principalPointKnown = false;
  const itk::PoseRegistrationOptions options;
  const auto                         free = PoseRegistrationTestCase::Run(Typical().jaws, geometry, options);
  const auto                         known = PoseRegistrationTestCase::Run(Typical().jaws, Typical().geometry, options);
  EXPECT_LT(Typical().Error(free, 0, 'R'), 3.0);
  EXPECT_LT(Typical().Error(free, 1, 'R'), 3.0);
  EXPECT_GT(free.groups[0].covariance[48], known.groups[0].covariance[48]);
}

TEST(PoseRegistration, FixedScaleStays)
{
  itk::PoseRegistrationOptions options;
  options.fixScale = true;
  const auto result = PoseRegistrationTestCase::Run(Typical().jaws, Typical().geometry, options);
  EXPECT_EQ(result.groups[0].parameters[itk::PoseKappa], 0.0);
  // Held, not known: the prior's width comes on top.
  EXPECT_NEAR(result.groups[0].covariance[48], options.kappaSigma * options.kappaSigma, 1e-12);
}

TEST(PoseRegistration, HeldValuesAreNotReportedAsCertain)
{
  itk::PoseRegistrationOptions options;
  options.fixRotation = options.fixTranslation = options.fixScale = true;
  const auto result = PoseRegistrationTestCase::Run(Typical().jaws, Typical().geometry, options);
  const auto s = PoseRegistrationTestCase::LandmarkCovariance(result, 0, Typical().landmarks.begin()->second);
  // A millimetre is 4 px.
  EXPECT_GT(std::sqrt(0.5 * (s(0, 0) + s(1, 1))), 3.0);
  const auto lines = itk::RegistrationVerdict::GetNotCheckable(result, options);
  EXPECT_TRUE(std::any_of(
    lines.begin(), lines.end(), [](const auto & line) { return line.find("held values") != std::string::npos; }));
}

TEST(PoseRegistration, CodesOfTheNextToothAndARepeatedPointAreNamed)
{
  auto shifted = Typical().jaws;
  for (auto & jaw : shifted)
  {
    for (auto & polyline : jaw.tracing)
    {
      polyline.code = itk::ToothCode(polyline.code.GetFDI() + 1u);
    }
  }
  const itk::PoseRegistrationOptions options;
  auto                               verdicts =
    itk::RegistrationVerdict::Evaluate(PoseRegistrationTestCase::Run(shifted, Typical().geometry, options));
  EXPECT_TRUE(HasReason(verdicts[0], "code-offset"));
  auto jaws = Typical().jaws;
  for (auto & polyline : jaws[0].tracing)
  {
    polyline.points.assign(20, jaws[0].tracing[0].points[0]);
  }
  const auto result = PoseRegistrationTestCase::Run(jaws, Typical().geometry, options);
  EXPECT_FALSE(result.jaws[0].registered);
  EXPECT_TRUE(result.jaws[1].registered);
}

TEST(PoseRegistration, ReportsAJawWithTooFewPoints)
{
  auto jaws = Typical().jaws;
  jaws[1].tracing.resize(1);
  jaws[1].tracing[0].points.resize(4);
  const auto result = PoseRegistrationTestCase::Run(jaws, Typical().geometry, itk::PoseRegistrationOptions());
  EXPECT_TRUE(result.jaws[0].registered);
  EXPECT_FALSE(result.jaws[1].registered);
  EXPECT_EQ(itk::RegistrationVerdict::Evaluate(result)[1].status, StatusEnum::Failed);
}

/** A spacing that is half or double, of 300 dpi, or 1: what it would have to be is said, to two per cent. */
TEST(PoseRegistration, AWrongPixelSpacingIsNamedWithTheRightOne)
{
  for (const double wrong : { 0.125, 0.5, 25.4 / 300.0, 1.0 })
  {
    auto         geometry = Typical().geometry;
    const double right = geometry.pixelSpacing[0];
    geometry.pixelSpacing = { { wrong, wrong } };
    const auto result = PoseRegistrationTestCase::Run(Typical().jaws, geometry, itk::PoseRegistrationOptions());
    for (const auto & verdict : itk::RegistrationVerdict::Evaluate(result))
    {
      EXPECT_EQ(verdict.status, StatusEnum::Failed) << wrong;
      const auto found = std::find_if(verdict.findings.begin(), verdict.findings.end(), [](const auto & finding) {
        return finding.code == "pixel-spacing";
      });
      ASSERT_NE(found, verdict.findings.end()) << wrong;
      EXPECT_NEAR(*found->value, right, 0.02 * right) << wrong;
      EXPECT_EQ(*found->limit, wrong);
      EXPECT_FALSE(HasReason(verdict, "facing"));
      EXPECT_FALSE(HasReason(verdict, "turned-image"));
    }
  }
}

/** Drawn on a film that was turned afterwards, by the centre of a 703 x 938 picture. */
TEST(PoseRegistration, ATurnedRadiographIsNamedWithItsTurn)
{
  for (const unsigned int turns : { 1, 2, 3 })
  {
    auto jaws = Typical().jaws;
    for (auto & jaw : jaws)
    {
      for (auto & polyline : jaw.tracing)
      {
        for (auto & point : polyline.points)
        {
          const double u = point[0] - 351.0;
          const double v = point[1] - 468.5;
          // Counter-clockwise as it is seen, so that it has to be turned back clockwise.
          point[0] = (turns == 1 ? v : turns == 2 ? -u : -v) + 468.5;
          point[1] = (turns == 1 ? -u : turns == 2 ? -v : u) + 468.5;
        }
      }
    }
    const auto result = PoseRegistrationTestCase::Run(jaws, Typical().geometry, itk::PoseRegistrationOptions());
    for (const auto & verdict : itk::RegistrationVerdict::Evaluate(result))
    {
      EXPECT_EQ(verdict.status, StatusEnum::Failed) << turns;
      const auto found = std::find_if(verdict.findings.begin(), verdict.findings.end(), [](const auto & finding) {
        return finding.code == "turned-image";
      });
      ASSERT_NE(found, verdict.findings.end()) << turns;
      EXPECT_NE(found->text.find("turned by " + std::to_string(90 * turns) + " degrees"), std::string::npos)
        << found->text;
      EXPECT_FALSE(HasReason(verdict, "facing")) << turns;
    }
  }
}

/** By a program that plots: rows from below, in pixels and in mm, with the spacing and without. */
TEST(PoseRegistration, ADrawingWhoseRowsWereCountedFromBelowIsNamed)
{
  for (const bool spacingKnown : { true, false })
  {
    for (const double unit : { 1.0, Typical().geometry.pixelSpacing[0] })
    {
      auto jaws = Typical().jaws;
      for (auto & jaw : jaws)
      {
        for (auto & polyline : jaw.tracing)
        {
          for (auto & point : polyline.points)
          {
            point[0] *= unit;
            point[1] = unit * (938.0 - point[1]);
          }
        }
      }
      auto geometry = Typical().geometry;
      geometry.pixelSpacingKnown = spacingKnown;
      const auto result = PoseRegistrationTestCase::Run(jaws, geometry, itk::PoseRegistrationOptions());
      for (const auto & verdict : itk::RegistrationVerdict::Evaluate(result))
      {
        EXPECT_EQ(verdict.status, StatusEnum::Failed) << spacingKnown << ' ' << unit;
        EXPECT_TRUE(HasReason(verdict, "upward-drawing")) << spacingKnown << ' ' << unit;
        for (const char * other : { "facing", "turned-image", "pixel-spacing" })
        {
          EXPECT_FALSE(HasReason(verdict, other)) << other;
        }
      }
    }
  }
}

TEST(PoseRegistration, WrongFacingAndWrongUnitAreNotOk)
{
  auto geometry = Typical().geometry;
  geometry.facingSign = -1.0;
  const itk::PoseRegistrationOptions options;
  auto verdicts = itk::RegistrationVerdict::Evaluate(PoseRegistrationTestCase::Run(Typical().jaws, geometry, options));
  EXPECT_NE(verdicts[0].status, StatusEnum::Ok);
  EXPECT_TRUE(HasReason(verdicts[0], "facing"));

  auto                 jaws = Typical().jaws;
  itk::TriangleSurface small[2];
  for (unsigned int j = 0; j < 2; ++j)
  {
    small[j] = Typical().surfaces[j];
    for (auto & p : small[j].points)
    {
      for (double & x : p)
      {
        x *= 0.1;
      }
    }
    jaws[j].surface = &small[j];
  }
  verdicts = itk::RegistrationVerdict::Evaluate(PoseRegistrationTestCase::Run(jaws, Typical().geometry, options));
  ASSERT_TRUE(HasReason(verdicts[0], "arch-width"));
  const auto reason = std::find_if(
    verdicts[0].findings.begin(), verdicts[0].findings.end(), [](const auto & r) { return r.code == "arch-width"; });
  EXPECT_NE(reason->text.find("may be in cm"), std::string::npos);
}

TEST(PoseRegistration, InwardWindingIsNamed)
{
  auto                 jaws = Typical().jaws;
  itk::TriangleSurface inward = Typical().surfaces[0];
  for (auto & triangle : inward.triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  jaws[0].surface = &inward;
  const auto verdicts = itk::RegistrationVerdict::Evaluate(
    PoseRegistrationTestCase::Run(jaws, Typical().geometry, itk::PoseRegistrationOptions()));
  EXPECT_TRUE(HasReason(verdicts[0], "inward-winding"));
  EXPECT_FALSE(HasReason(verdicts[1], "inward-winding"));
}

TEST(PoseRegistration, StopsWhereAnObserverOfItsProgressSaysSo)
{
  const auto method =
    PoseRegistrationTestCase::MakeMethod(Typical().jaws, Typical().geometry, itk::PoseRegistrationOptions());
  method->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    if (method->GetProgress() > 0.1f)
    {
      method->AbortGenerateDataOn();
    }
  });
  EXPECT_THROW(method->Update(), itk::ProcessAborted);
}
