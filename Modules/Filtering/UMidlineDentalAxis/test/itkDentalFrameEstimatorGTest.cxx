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
#include "itkDentalFrameCohort.h"
#include "itkParallelFor.h"

#include "itkMath.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace
{
using namespace DentalFrameTest;

struct Statistics
{
  Vector3 mean{ { 0, 0, 0 } };
  Vector3 worst{ { 0, 0, 0 } };

  void
  Add(const Vector3 & errors, double count)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      mean[axis] += errors[axis] / count;
      worst[axis] = std::max(worst[axis], errors[axis]);
    }
  }
};

void
ExpectWithin(const Statistics & statistics, double mean, double worst, const char * what)
{
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    EXPECT_LE(statistics.mean[axis], mean) << what << ", axis "
                                           << "xyz"[axis];
    EXPECT_LE(statistics.worst[axis], worst) << what << ", axis "
                                             << "xyz"[axis];
  }
}

constexpr std::size_t Phantoms = 200;

/** Draws phantoms, trims every second jaw (a posterior corner, obliquely), turns them at random and keeps the errors of
 * both-jaw and single-jaw runs: [phantom][both upper, both lower, single jaw (upper of the even, lower of the odd)]. */
std::vector<std::array<Vector3, 3>>
PhantomErrors(bool refine, std::size_t count)
{
  std::vector<std::array<Vector3, 3>> errors(count);
  itk::ParallelFor(count, 0, [&](std::size_t k) {
    itk::ReproducibleRandom random(977, k);
    auto                    jaws = MakePhantom(20000 + k, 8000);
    for (itk::TriangleSurface & jaw : jaws)
    {
      if (random.Uniform() < 0.5)
      {
        const double side = random.Uniform() < 0.5 ? 1.0 : -1.0;
        double       back = 0.0;
        for (const Vector3 & p : jaw.points)
        {
          back = std::min(back, p[0]);
        }
        const double depth = random.Uniform(2.0, 12.0);
        const double slope = random.Uniform(-0.2, 0.2);
        Cut(jaw, [&](const Vector3 & p) { return p[1] * side > 3.0 && p[0] + slope * p[1] < back + depth; });
      }
    }
    const Motion               motion = RandomMotion(random);
    const itk::TriangleSurface upper = Moved(jaws[0], motion);
    const itk::TriangleSurface lower = Moved(jaws[1], motion);
    itk::DentalFrameOptions    options;
    options.refineMidline = refine;
    const auto both = itk::EstimateDentalFrame(&upper, &lower, options);
    errors[k][0] = AxisErrors(both.upper, motion);
    errors[k][1] = AxisErrors(both.lower, motion);
    if (!both.jawsShareFrame)
    {
      errors[k][0] = { 180.0, 180.0, 180.0 };
    }
    if (!refine)
    {
      const bool isUpper = k % 2 == 0;
      const auto single = isUpper ? itk::EstimateDentalFrame(&upper, nullptr, options)
                                  : itk::EstimateDentalFrame(nullptr, &lower, options);
      errors[k][2] = AxisErrors(isUpper ? single.upper : single.lower, motion);
    }
  });
  return errors;
}

/** A pair whose jaw number `turned` (0: upper) stands the wrong way round, half a turn about the vertical through the
 * middle of its arch, and without the foremost millimetres. */
std::array<itk::TriangleSurface, 2>
MakeContradictingPair(std::uint64_t seed, unsigned int turned, double missing)
{
  auto                   jaws = MakePhantom(seed);
  itk::TriangleSurface & jaw = jaws[turned];
  double                 front = -1e9;
  double                 back = 1e9;
  for (const Vector3 & p : jaw.points)
  {
    front = std::max(front, p[0]);
    back = std::min(back, p[0]);
  }
  Cut(jaw, [&](const Vector3 & p) { return p[0] > front - missing; });
  for (Vector3 & p : jaw.points)
  {
    p = { front + back - p[0], -p[1], p[2] };
  }
  return jaws;
}

/** Vertices and faces of an OBJ file, in mm from m; false where there is no file. */
bool
ReadCast(const std::string & name, itk::TriangleSurface & surface)
{
  std::ifstream file(std::string(DENTALSCR_SHARED_DIR) + "/cases/casts/" + name);
  if (!file)
  {
    return false;
  }
  std::string line;
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string        key;
    words >> key;
    if (key == "v")
    {
      Vector3 p{};
      words >> p[0] >> p[1] >> p[2];
      surface.points.push_back({ 1000.0 * p[0], 1000.0 * p[1], 1000.0 * p[2] });
    }
    else if (key == "f")
    {
      std::vector<std::uint32_t> corners;
      std::string                corner;
      while (words >> corner)
      {
        corners.push_back(static_cast<std::uint32_t>(std::stoul(corner) - 1));
      }
      for (std::size_t i = 2; i < corners.size(); ++i)
      {
        surface.triangles.push_back({ corners[0], corners[i - 1], corners[i] });
      }
    }
  }
  return !surface.triangles.empty();
}
} // namespace

TEST(DentalFrameEstimator, AxesOfTwoHundredTurnedPhantomsAreWithinThreeDegreesOnAverageAndSixAtWorst)
{
  const auto errors = PhantomErrors(false, Phantoms);
  Statistics upper;
  Statistics lower;
  Statistics single;
  for (const auto & phantom : errors)
  {
    upper.Add(phantom[0], Phantoms);
    lower.Add(phantom[1], Phantoms);
    single.Add(phantom[2], Phantoms);
  }
  ExpectWithin(upper, 3.0, 6.0, "upper of a pair");
  ExpectWithin(lower, 3.0, 6.0, "lower of a pair");
  ExpectWithin(single, 3.0, 6.0, "one jaw alone");
}

TEST(DentalFrameEstimator, RefinedLateralAxisOfPairsIsWithinHalfADegreeOnAverage)
{
  const auto errors = PhantomErrors(true, 30);
  Statistics upper;
  for (const auto & phantom : errors)
  {
    upper.Add(phantom[0], static_cast<double>(errors.size()));
  }
  EXPECT_LE(upper.mean[1], 0.5);
  // The arches themselves are not symmetric: teeth are turned by 5 degrees (1 sd) and displaced.
  EXPECT_LE(upper.worst[1], 2.0);
}

TEST(DentalFrameEstimator, TwoHundredRotationsOfTheCastsAgreeWithinAFifthOfADegree)
{
  std::array<itk::TriangleSurface, 2> casts;
  if (!ReadCast("upper.obj", casts[0]) || !ReadCast("lower.obj", casts[1]))
  {
    GTEST_SKIP() << "The casts are not in " << DENTALSCR_SHARED_DIR << "/cases/casts.";
  }
  const itk::DentalFrameOptions options;
  const auto                    reference = itk::EstimateDentalFrame(&casts[0], &casts[1], options);
  ASSERT_TRUE(reference.jawsShareFrame);
  // The patient's right is +y and the front is -x in these files.
  EXPECT_LT(Degrees(reference.upper.axes[0], { -1, 0, 0 }), 15.0);
  EXPECT_LT(Degrees(reference.upper.axes[1], { 0, -1, 0 }), 5.0);
  EXPECT_LT(Degrees(reference.lower.axes[1], { 0, -1, 0 }), 5.0);
  std::array<itk::DentalJawFrame, 2> alone;
  alone[0] = itk::EstimateDentalFrame(&casts[0], nullptr, options).upper;
  alone[1] = itk::EstimateDentalFrame(nullptr, &casts[1], options).lower;
  EXPECT_LT(Degrees(alone[0].axes[2], reference.upper.axes[2]), 3.0);
  EXPECT_LT(Degrees(alone[1].axes[2], reference.lower.axes[2]), 3.0);
  // A closed cast alone has no net normal: the sign is less sure than that of a pair.
  EXPECT_LT(alone[0].confidence, reference.upper.confidence);

  std::vector<double> worst(200, 0.0);
  itk::ParallelFor(200, 0, [&](std::size_t k) {
    itk::ReproducibleRandom random(31, k);
    const Motion            motion = RandomMotion(random);
    const auto              upper = Moved(casts[0], motion);
    const auto              lower = Moved(casts[1], motion);
    const auto              turned = itk::EstimateDentalFrame(&upper, &lower, options);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      worst[k] = std::max(worst[k], Degrees(turned.upper.axes[axis], motion.Turn(reference.upper.axes[axis])));
      worst[k] = std::max(worst[k], Degrees(turned.lower.axes[axis], motion.Turn(reference.lower.axes[axis])));
    }
    if (k < 20)
    {
      const bool isUpper = k % 2 == 0;
      const auto single = isUpper ? itk::EstimateDentalFrame(&upper, nullptr, options).upper
                                  : itk::EstimateDentalFrame(nullptr, &lower, options).lower;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        worst[k] = std::max(worst[k], Degrees(single.axes[axis], motion.Turn(alone[isUpper ? 0 : 1].axes[axis])));
      }
    }
  });
  EXPECT_LE(*std::max_element(worst.begin(), worst.end()), 0.2);
}

TEST(DentalFrameEstimator, FramesAreRightHandedRotationsAboutTheAreaCentroid)
{
  const auto jaws = MakePhantom(5);
  const auto result = itk::EstimateDentalFrame(&jaws[0], &jaws[1], {});
  for (const itk::DentalJawFrame * frame : { &result.upper, &result.lower })
  {
    ASSERT_TRUE(frame->valid);
    const auto & a = frame->axes;
    for (unsigned int r = 0; r < 3; ++r)
    {
      for (unsigned int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(Dot(a[r], a[c]), r == c ? 1.0 : 0.0, 1e-12);
      }
    }
    EXPECT_NEAR(a[0][1] * a[1][2] - a[0][2] * a[1][1], a[2][0], 1e-12);
  }
  // The phantom is one piece: the kernel's own centroid is that of the whole surface.
  const auto centroid = jaws[0].AreaCentroid();
  for (unsigned int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(result.upper.origin[d], centroid[d], 1e-9);
  }
  EXPECT_EQ(result.upper.axes[1], result.lower.axes[1]) << "the lateral axis is shared";
}

TEST(DentalFrameEstimator, DescribesTheArchOfAPhantom)
{
  const auto jaws = MakePhantom(7, 40000);
  const auto result = itk::EstimateDentalFrame(&jaws[0], &jaws[1], {});
  double     front = -1e9;
  for (const Vector3 & p : jaws[0].points)
  {
    front = std::max(front, p[0]);
  }
  const auto & upper = result.upper;
  EXPECT_GT(upper.baselineLeft[1], 15.0);
  EXPECT_LT(upper.baselineRight[1], -15.0);
  for (unsigned int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(upper.midpoint[d], 0.5 * (upper.baselineLeft[d] + upper.baselineRight[d]), 1e-12);
  }
  // The edge is at the front, on the midline within the width of an incisor's half, behind the labial gingiva.
  EXPECT_NEAR(upper.incisalEdge[1], 0.0, 3.0);
  EXPECT_NEAR(upper.incisalEdge[0], front, 6.0);
  EXPECT_GT(upper.archWidth, 40.0);
  EXPECT_LT(upper.archWidth, 75.0);
  EXPECT_GT(upper.archDepth, 25.0);
  EXPECT_LT(upper.archDepth, 60.0);
  EXPECT_GT(upper.confidence, 0.8);
}

TEST(DentalFrameEstimator, OverjetAndOverbiteFollowTheUpperJaw)
{
  const auto jaws = MakePhantom(11, 40000);
  const auto before = itk::EstimateDentalFrame(&jaws[0], &jaws[1], {});
  // The same pair with its upper jaw 1.5 mm forward and 1 mm down: the estimate of the pair's axes moves a little.
  Motion motion;
  motion.translation = { 1.5, 0.0, -1.0 };
  const auto moved = Moved(jaws[0], motion);
  const auto after = itk::EstimateDentalFrame(&moved, &jaws[1], {});
  ASSERT_TRUE(before.jawsShareFrame && after.jawsShareFrame);
  EXPECT_NEAR(after.overjet - before.overjet, 1.5, 0.1);
  EXPECT_NEAR(after.overbite - before.overbite, 1.0, 0.1);
}

TEST(DentalFrameEstimator, OcclusionIsSeenAndJawsInFramesOfTheirOwnAreToldApart)
{
  unsigned int wrong = 0;
  for (std::uint64_t k = 0; k < 12; ++k)
  {
    itk::ReproducibleRandom random(55, k);
    const auto              jaws = MakePhantom(300 + k);
    const Motion            shared = RandomMotion(random);
    const auto              upper = Moved(jaws[0], shared);
    const auto              lower = Moved(jaws[1], shared);
    wrong += itk::EstimateDentalFrame(&upper, &lower, {}).occlusionPlausible ? 0 : 1;
    // Each jaw about its own centroid, turned at random, or as it was: what scanners export.
    const auto ownFrame = [&](const itk::TriangleSurface & jaw, bool turn) {
      Motion centre;
      for (unsigned int d = 0; d < 3; ++d)
      {
        centre.translation[d] = -jaw.AreaCentroid()[d];
      }
      Motion rotation = turn ? RandomMotion(random) : Motion();
      rotation.translation = { 0, 0, 0 };
      return Moved(Moved(jaw, centre), rotation);
    };
    for (const bool turn : { false, true })
    {
      const auto ownUpper = ownFrame(jaws[0], turn);
      const auto ownLower = ownFrame(jaws[1], turn);
      const auto result = itk::EstimateDentalFrame(&ownUpper, &ownLower, {});
      wrong += result.occlusionPlausible || result.jawsShareFrame ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(DentalFrameEstimator, RealArchesShareAFrameInEveryArrangementInWhichTheyDo)
{
  // Seed 1016 was taken to be in occlusion with a jaw turned over while the winding was believed to be wrong first, as
  // 46 of 89 pairs of real arches were; 1000 has an arch whose mirror plane is found badly.
  for (const std::uint64_t seed : { 1000u, 1016u, 1024u, 1029u })
  {
    const ScannedPair pair = MakeScannedPair(seed, "real");
    for (const Arrangement arrangement : Arrangements)
    {
      const ArrangedPair arranged = Arrange(pair, arrangement, seed);
      const auto         result = itk::EstimateDentalFrame(&arranged.jaws[0], &arranged.jaws[1], {});
      EXPECT_EQ(result.jawsShareFrame, arranged.share)
        << NameOf(arrangement) << ", seed " << seed << ": " << itk::DescribeOcclusion(result);
      EXPECT_EQ(result.occlusionFinding == itk::DentalFrameEnums::OcclusionFinding::InOcclusion, arranged.share);
      for (unsigned int jaw = 0; jaw < 2; ++jaw)
      {
        // Turned over it would be some 180 degrees.
        EXPECT_LT(AxisErrors(jaw == 0 ? result.upper : result.lower, arranged.motions[jaw])[2], 15.0)
          << NameOf(arrangement) << ", seed " << seed << ", jaw " << jaw;
      }
    }
  }
}

TEST(DentalFrameEstimator, LowerIncisorsThatStandHighDoNotLeaveOutOneSide)
{
  // In a deep bite a plate that leans on the incisors and one side was preferred to one on both sides' molars, and the
  // other side was left out as if it had no crowns: 45 degrees off.
  for (const std::uint64_t seed : { 3000u, 3049u, 3073u })
  {
    itk::DentalFrameOptions options;
    options.refineMidline = true;
    const ScannedPair pair = MakeScannedPair(seed, "real");
    const auto        result = itk::EstimateDentalFrame(nullptr, &pair.jaws[1], options);
    EXPECT_LT(std::abs(result.lower.axes[0][1]), std::sin(5.0 * itk::Math::pi_over_180)) << "yaw, seed " << seed;
    EXPECT_LT(AxisErrors(result.lower, Motion())[2], 6.0) << "z, seed " << seed;
  }
}

TEST(DentalFrameEstimator, TeethWithoutAMirrorImageDoNotTurnTheAxis)
{
  // An extraction closed on one side: with distances that count up to 2 mm the arch interlocked one tooth off, 8
  // degrees.
  itk::DentalFrameOptions options;
  options.refineMidline = true;
  const ScannedPair pair = MakeScannedPair(3024, "real");
  const auto        result = itk::EstimateDentalFrame(nullptr, &pair.jaws[1], options);
  EXPECT_LT(std::abs(result.lower.axes[0][1]), std::sin(2.5 * itk::Math::pi_over_180));
}

TEST(DentalFrameEstimator, AnAxisOfAJawAloneWhoseSidesDifferIsUnsure)
{
  // Yaw is 4 degrees off; share of crowns with an image, balance and margin find nothing wrong.
  itk::DentalFrameOptions options;
  options.refineMidline = true;
  const ScannedPair pair = MakeScannedPair(3000, "real");
  EXPECT_LT(itk::EstimateDentalFrame(nullptr, &pair.jaws[1], options).lower.confidence, 0.5);
  // The other jaw's sides are alike, and of both together it tells where these differ.
  EXPECT_GT(itk::EstimateDentalFrame(&pair.jaws[0], nullptr, options).upper.confidence, 0.8);
  options.jawsShareFrame = itk::DentalFrameEnums::JawsShareFrame::On;
  const auto both = itk::EstimateDentalFrame(&pair.jaws[0], &pair.jaws[1], options);
  EXPECT_LT(std::abs(both.lower.axes[0][1]), std::sin(1.5 * itk::Math::pi_over_180));
  EXPECT_GT(both.lower.confidence, 0.5);
}

TEST(DentalFrameEstimator, WhatTheOcclusionTestFoundIsSaid)
{
  const auto jaws = MakePhantom(302);
  const auto moved = [&](const Vector3 & by) {
    Motion motion;
    motion.translation = by;
    return Moved(jaws[0], motion);
  };
  using FindingEnum = itk::DentalFrameEnums::OcclusionFinding;
  const auto find = [&](const itk::TriangleSurface & upper, const itk::TriangleSurface & lower) {
    return itk::EstimateDentalFrame(&upper, &lower, {});
  };
  const auto together = find(jaws[0], jaws[1]);
  EXPECT_EQ(together.occlusionFinding, FindingEnum::InOcclusion);
  EXPECT_LT(together.interpenetration, 0.02);
  EXPECT_EQ(itk::DescribeOcclusion(together).rfind("the jaws face each other", 0), 0u);
  // Casts are exported some millimetres apart; 20 mm are no bite.
  EXPECT_EQ(find(moved({ 0, 0, 4 }), jaws[1]).occlusionFinding, FindingEnum::InOcclusion);
  EXPECT_EQ(find(moved({ 0, 0, 20 }), jaws[1]).occlusionFinding, FindingEnum::FarApart);
  EXPECT_EQ(find(moved({ 0, 0, -5 }), jaws[1]).occlusionFinding, FindingEnum::Interpenetrating);
  EXPECT_EQ(find(jaws[1], jaws[1]).occlusionFinding, FindingEnum::NotOpposed);
  EXPECT_EQ(itk::EstimateDentalFrame(&jaws[0], nullptr, {}).occlusionFinding, FindingEnum::NotTested);
}

TEST(DentalFrameEstimator, InwardWindingOfAPairIsSeenByContactAndDoesNotTurnTheAxes)
{
  auto jaws = MakePhantom(21);
  for (itk::TriangleSurface & jaw : jaws)
  {
    for (auto & triangle : jaw.triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  const auto result = itk::EstimateDentalFrame(&jaws[0], &jaws[1], {});
  EXPECT_TRUE(result.jawsShareFrame);
  EXPECT_LT(AxisErrors(result.upper, Motion())[2], 6.0);
  EXPECT_LT(AxisErrors(result.lower, Motion())[2], 6.0);
  EXPECT_LT(result.upper.windingAgreement, -0.5);
  EXPECT_LT(result.lower.windingAgreement, -0.5);
}

TEST(DentalFrameEstimator, ClearerUDecidesForBothJawsWhereTheirFrontsContradict)
{
  itk::DentalFrameOptions options;
  options.jawsShareFrame = itk::DentalFrameEnums::JawsShareFrame::On;
  for (const std::uint64_t seed : { 7u, 33u })
  {
    for (const unsigned int turned : { 0u, 1u })
    {
      // Without its incisors a U is less clear than a whole one, here all the same enough to have a front of its own.
      const auto jaws = MakeContradictingPair(seed, turned, 15.0);
      const auto own = itk::EstimateDentalFrame(
        turned == 0 ? &jaws[0] : nullptr, turned == 0 ? nullptr : &jaws[1], itk::DentalFrameOptions());
      const auto result = itk::EstimateDentalFrame(&jaws[0], &jaws[1], options);
      EXPECT_LT(Dot((turned == 0 ? own.upper : own.lower).axes[0], { 1, 0, 0 }), 0.5);
      EXPECT_GT(result.anteriorDisagreement, 75.0);
      EXPECT_EQ(result.upper.axes[1], result.lower.axes[1]) << "the lateral axis is shared";
      for (const itk::DentalJawFrame * frame : { &result.upper, &result.lower })
      {
        // As good as a pair's without a contradiction.
        const Vector3 errors = AxisErrors(*frame, Motion());
        for (unsigned int axis = 0; axis < 3; ++axis)
        {
          EXPECT_LT(errors[axis], 6.0) << "seed " << seed << ", turned " << turned << ", axis " << axis;
        }
        // What is said of the arch is said in that frame: the baseline's left end lies left, the front in front.
        EXPECT_GT(frame->baselineLeft[1], 15.0) << "seed " << seed << ", turned " << turned;
        EXPECT_LT(frame->baselineRight[1], -15.0) << "seed " << seed << ", turned " << turned;
        EXPECT_GT(frame->archDepth, 10.0) << "seed " << seed << ", turned " << turned;
      }
    }
  }
}

TEST(DentalFrameEstimator, ContradictingFrontsThatAreAlikeClearAreNotTrusted)
{
  itk::DentalFrameOptions options;
  options.jawsShareFrame = itk::DentalFrameEnums::JawsShareFrame::On;
  for (const std::uint64_t seed : { 7u, 44u })
  {
    for (const unsigned int turned : { 0u, 1u })
    {
      const auto jaws = MakeContradictingPair(seed, turned, 0.0);
      const auto result = itk::EstimateDentalFrame(&jaws[0], &jaws[1], options);
      EXPECT_GT(result.anteriorDisagreement, 170.0);
      EXPECT_LT(result.upper.confidence, 0.5) << "seed " << seed << ", turned " << turned;
      EXPECT_LT(result.lower.confidence, 0.5) << "seed " << seed << ", turned " << turned;
      EXPECT_LT(result.joint.confidence, 0.5) << "seed " << seed << ", turned " << turned;
      // Whichever had its way, both frames have the same front, and both arches are described in it.
      EXPECT_GT(Dot(result.upper.axes[0], result.lower.axes[0]), 0.9);
      for (const itk::DentalJawFrame * frame : { &result.upper, &result.lower })
      {
        const Vector3 & left = frame->baselineLeft;
        const Vector3 & right = frame->baselineRight;
        EXPECT_GT(Dot({ left[0] - right[0], left[1] - right[1], left[2] - right[2] }, frame->axes[1]), 30.0);
        EXPECT_GT(frame->archDepth, 10.0);
      }
    }
  }
}

TEST(DentalFrameEstimator, SpecksRepeatedPointsAndHolesDoNotMoveTheAxes)
{
  const auto jaws = MakePhantom(33);
  const auto clean = itk::EstimateDentalFrame(&jaws[0], &jaws[1], {});

  // A triangle soup with a speck far above the teeth and holes in the palate side.
  std::array<itk::TriangleSurface, 2> soup;
  for (unsigned int j = 0; j < 2; ++j)
  {
    for (const auto & triangle : jaws[j].triangles)
    {
      const auto first = static_cast<std::uint32_t>(soup[j].points.size());
      for (const std::uint32_t corner : triangle)
      {
        soup[j].points.push_back(jaws[j].points[corner]);
      }
      soup[j].triangles.push_back({ first, first + 1, first + 2 });
    }
    const auto   same = itk::EstimateDentalFrame(j == 0 ? &soup[0] : nullptr, j == 0 ? nullptr : &soup[1], {});
    const auto   single = itk::EstimateDentalFrame(j == 0 ? &jaws[0] : nullptr, j == 0 ? nullptr : &jaws[1], {});
    const auto & a = j == 0 ? same.upper : same.lower;
    const auto & b = j == 0 ? single.upper : single.lower;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      EXPECT_LT(Degrees(a.axes[axis], b.axes[axis]), 0.01) << "repeated points are welded";
    }
    const double  side = j == 0 ? -1.0 : 1.0;
    const Vector3 away{ 0.0, 10.0, 25.0 * side };
    for (unsigned int k = 0; k < 30; ++k)
    {
      const auto first = static_cast<std::uint32_t>(soup[j].points.size());
      for (unsigned int corner = 0; corner < 3; ++corner)
      {
        soup[j].points.push_back(
          { away[0] + 0.3 * k * (corner == 1), away[1] + 0.5 * (corner == 2), away[2] + 0.1 * k });
      }
      soup[j].triangles.push_back({ first, first + 1, first + 2 });
    }
    Cut(soup[j], [&](const Vector3 & p) { return (p[0] - 3.0) * (p[0] - 3.0) + (p[1] - 20.0) * (p[1] - 20.0) < 4.0; });
  }
  const auto dirty = itk::EstimateDentalFrame(&soup[0], &soup[1], {});
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    EXPECT_LT(Degrees(clean.upper.axes[axis], dirty.upper.axes[axis]), 1.0);
    EXPECT_LT(Degrees(clean.lower.axes[axis], dirty.lower.axes[axis]), 1.0);
  }
}

TEST(DentalFrameEstimator, SameBitsForAnyNumberOfThreads)
{
  const auto              jaws = MakePhantom(44);
  itk::DentalFrameOptions options;
  options.refineMidline = true;
  const auto one = itk::EstimateDentalFrame(&jaws[0], &jaws[1], options);
  options.threads = 2;
  const auto two = itk::EstimateDentalFrame(&jaws[0], &jaws[1], options);
  EXPECT_EQ(one.upper.axes, two.upper.axes);
  EXPECT_EQ(one.lower.axes, two.lower.axes);
  EXPECT_EQ(one.upper.origin, two.upper.origin);
  EXPECT_EQ(one.joint.axes, two.joint.axes);
  EXPECT_EQ(one.upper.confidence, two.upper.confidence);
}

TEST(DentalFrameEstimator, HalfAnArchAndABallAreNotTrusted)
{
  auto jaws = MakePhantom(50);
  Cut(jaws[0], [](const Vector3 & p) { return p[1] > 2.0; });
  const auto half = itk::EstimateDentalFrame(&jaws[0], nullptr, {});
  EXPECT_LT(half.upper.confidence, 0.5);

  itk::TriangleSurface ball;
  constexpr unsigned   rings = 24;
  constexpr unsigned   sectors = 48;
  for (unsigned int r = 0; r <= rings; ++r)
  {
    for (unsigned int s = 0; s < sectors; ++s)
    {
      const double theta = 3.14159265358979 * r / rings;
      const double phi = 2.0 * 3.14159265358979 * s / sectors;
      ball.points.push_back(
        { 30 * std::sin(theta) * std::cos(phi), 30 * std::sin(theta) * std::sin(phi), 30 * std::cos(theta) });
    }
  }
  for (unsigned int r = 0; r < rings; ++r)
  {
    for (unsigned int s = 0; s < sectors; ++s)
    {
      const unsigned int a = r * sectors + s;
      const unsigned int b = r * sectors + (s + 1) % sectors;
      ball.triangles.push_back({ a, a + sectors, b });
      ball.triangles.push_back({ b, a + sectors, b + sectors });
    }
  }
  EXPECT_LT(itk::EstimateDentalFrame(&ball, nullptr, {}).upper.confidence, 0.5);
  EXPECT_FALSE(itk::EstimateDentalFrame(nullptr, nullptr, {}).upper.valid);
  const itk::TriangleSurface empty;
  EXPECT_FALSE(itk::EstimateDentalFrame(&empty, nullptr, {}).upper.valid);
}

TEST(DentalFrameEstimator, AFewTrianglesAreNoArch)
{
  // One triangle of a third of a millimetre, and as large as an arch: five thousand samples of it make a U as any cloud
  // of points does.
  for (const float size : { 0.3F, 60.0F })
  {
    itk::TriangleSurface surface;
    surface.points = { { { 0.0F, 0.0F, 0.0F } }, { { size, 0.0F, 0.0F } }, { { 0.0F, size, 0.0F } } };
    surface.triangles = { { { 0, 1, 2 } } };
    EXPECT_FALSE(itk::EstimateDentalFrame(&surface, nullptr, itk::DentalFrameOptions()).upper.valid) << size;
    EXPECT_FALSE(itk::EstimateDentalFrame(nullptr, &surface, itk::DentalFrameOptions()).lower.valid) << size;
  }
}
