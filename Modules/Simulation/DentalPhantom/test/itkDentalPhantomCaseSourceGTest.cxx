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
#include "itkDentalPhantomCaseSource.h"

#include "itkDentalPhantomModel.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace
{
using CaseType = itk::DentalPhantomCaseSource;
using CohortEnum = CaseType::CohortEnum;
using SideEnum = CaseType::TracedSideEnum;
using GeometryType = itk::CephalometricGeometry;

int
ExerciseBasics(CaseType * source)
{
  ITK_EXERCISE_BASIC_OBJECT_METHODS(source, DentalPhantomCaseSource, ProcessObject);
  return EXIT_SUCCESS;
}

CaseType::Pointer
Case(std::uint64_t seed, CohortEnum cohort = CohortEnum::Typical, SideEnum side = SideEnum::Right)
{
  auto source = CaseType::New();
  source->SetSeed(seed);
  source->SetCohort(cohort);
  source->SetTracedSide(side);
  source->SetNumberOfTriangles(12000);
  source->MakeRadiographOff();
  return source;
}

using TriangleType = std::array<std::array<double, 2>, 3>;

/** The projected crown triangles of a quadrant. */
std::vector<TriangleType>
Crowns(CaseType * source, unsigned int jaw, unsigned int quadrant)
{
  const auto *                       mesh = source->GetMesh(jaw);
  const auto *                       geometry = source->GetTrueGeometry(jaw);
  std::vector<std::array<double, 2>> pixels;
  for (itk::IdentifierType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const auto pixel = geometry->ProjectPoint(GeometryType::PointType(mesh->GetPoint(i)));
    pixels.push_back({ { pixel[0], pixel[1] } });
  }
  std::vector<TriangleType> triangles;
  for (auto it = mesh->GetCells()->Begin(); it != mesh->GetCells()->End(); ++it)
  {
    const auto * ids = it.Value()->GetPointIds();
    float        labels[3] = { 0.0f, 0.0f, 0.0f };
    for (unsigned int k = 0; k < 3; ++k)
    {
      mesh->GetPointData(ids[k], &labels[k]);
    }
    if (labels[0] == labels[1] && labels[1] == labels[2] && static_cast<unsigned int>(labels[0]) / 10 == quadrant)
    {
      triangles.push_back({ { pixels[ids[0]], pixels[ids[1]], pixels[ids[2]] } });
    }
  }
  return triangles;
}

/** The distance of a pixel from the projected crowns; 0 inside. */
double
DistanceFrom(const std::vector<TriangleType> & triangles, double u, double v)
{
  double best = std::numeric_limits<double>::infinity();
  for (const auto & t : triangles)
  {
    double area[3];
    for (unsigned int k = 0; k < 3; ++k)
    {
      const auto & a = t[k];
      const auto & b = t[(k + 1) % 3];
      area[k] = (b[0] - a[0]) * (v - a[1]) - (b[1] - a[1]) * (u - a[0]);
    }
    if ((area[0] >= 0 && area[1] >= 0 && area[2] >= 0) || (area[0] <= 0 && area[1] <= 0 && area[2] <= 0))
    {
      return 0.0;
    }
    for (unsigned int k = 0; k < 3; ++k)
    {
      const auto & a = t[k];
      const auto & b = t[(k + 1) % 3];
      const double x = b[0] - a[0];
      const double y = b[1] - a[1];
      const double l = x * x + y * y;
      const double s = l > 0.0 ? std::min(1.0, std::max(0.0, ((u - a[0]) * x + (v - a[1]) * y) / l)) : 0.0;
      best = std::min(best, std::hypot(u - a[0] - s * x, v - a[1] - s * y));
    }
  }
  return best;
}

std::size_t
NumberOfPoints(const itk::DentalContour * contour)
{
  return contour->GetNumberOfPoints();
}

/** Distance of a point from the nearest segment of a contour. */
double
DistanceToContour(const itk::DentalContour * contour, const itk::Point<double, 2> & point)
{
  double best = std::numeric_limits<double>::infinity();
  for (const auto & line : contour->GetPolylines())
  {
    for (std::size_t i = 1; i < line.points.size(); ++i)
    {
      const auto   a = line.points[i - 1];
      const auto   d = line.points[i] - a;
      const double s = std::min(1.0, std::max(0.0, ((point - a) * d) / std::max(d.GetSquaredNorm(), 1e-12)));
      best = std::min(best, point.EuclideanDistanceTo(a + d * s));
    }
  }
  return best;
}
} // namespace

TEST(DentalPhantomCaseSource, HasTheBasicMethods)
{
  EXPECT_EQ(ExerciseBasics(CaseType::New()), EXIT_SUCCESS);
}

TEST(DentalPhantomCaseSource, LastCallSetsWhatTheLevelAndASetterShare)
{
  auto level = CaseType::New()->GetLevel();
  level.tracedSide = "mean";
  level.frame = "upright";
  level.numberOfTriangles = 9000;
  const auto setEach = [](CaseType * source) {
    source->SetTracedSide(SideEnum::Left);
    source->SetFrame(CaseType::FrameEnum::SeparateScanner);
    source->SetNumberOfTriangles(7000);
  };

  // A level after the setters, the default one too, which says nothing new.
  const auto source = CaseType::New();
  setEach(source);
  source->SetLevel(level);
  EXPECT_EQ(source->GetTracedSide(), SideEnum::Mean);
  EXPECT_EQ(source->GetFrame(), CaseType::FrameEnum::UprightScanner);
  EXPECT_EQ(source->GetNumberOfTriangles(), 9000u);
  EXPECT_EQ(source->GetLevel(), level);
  setEach(source);
  source->SetCohort(CohortEnum::Typical);
  EXPECT_EQ(source->GetLevel(), CaseType::New()->GetLevel());

  // The setters after a level: they change it, and nothing else of it.
  source->SetLevel(level);
  setEach(source);
  EXPECT_EQ(source->GetTracedSide(), SideEnum::Left);
  EXPECT_EQ(source->GetFrame(), CaseType::FrameEnum::SeparateScanner);
  EXPECT_EQ(source->GetNumberOfTriangles(), 7000u);
  level.tracedSide = "left";
  level.frame = "separate";
  level.numberOfTriangles = 7000;
  EXPECT_EQ(source->GetLevel(), level);
  source->MakeRadiographOff();
  source->Update();
  EXPECT_EQ(source->GetParameters().frame, CaseType::FrameEnum::SeparateScanner);
  EXPECT_EQ(source->GetParameters().numberOfTriangles, 7000u);
  EXPECT_TRUE(source->GetTracing(0)->GetPolylines().front().code.IsLeft());

  // What is so already is no change; a frame instead of mixed ones is, though both may be SharedScanner.
  auto time = source->GetMTime();
  setEach(source);
  source->SetLevel(level);
  EXPECT_EQ(source->GetMTime(), time);
  level.frame = "mixed";
  source->SetLevel(level);
  EXPECT_EQ(source->GetFrame(), CaseType::FrameEnum::SharedScanner);
  time = source->GetMTime();
  source->SetFrame(CaseType::FrameEnum::SharedScanner);
  EXPECT_GT(source->GetMTime(), time);
  EXPECT_EQ(source->GetLevel().frame, "shared");

  // Every word of a level's frame and side has its enumerator.
  for (const auto & entry : itk::DentalPhantomLevel::GetEntries())
  {
    const std::string key = entry.key;
    for (const std::string & word : entry.words)
    {
      if (key == "frame" && word != "mixed")
      {
        level.frame = word;
        source->SetLevel(level);
        const auto frame = source->GetFrame();
        source->SetFrame(CaseType::FrameEnum::CentredScanner);
        source->SetFrame(frame);
        EXPECT_EQ(source->GetLevel().frame, word);
      }
      else if (key == "side")
      {
        level.tracedSide = word;
        source->SetLevel(level);
        EXPECT_EQ(itk::ToString(source->GetTracedSide()), word);
      }
    }
  }
  // Clamped as a level's numbers are checked.
  source->SetNumberOfTriangles(1);
  EXPECT_EQ(source->GetNumberOfTriangles(), 2000u);
  EXPECT_NO_THROW(source->GetLevel().Validate());
}

TEST(DentalPhantomCaseSource, TracingLiesOnTheBorderOfTheProjectedCrowns)
{
  for (const SideEnum side : { SideEnum::Right, SideEnum::Left })
  {
    const auto source = Case(3, CohortEnum::Typical, side);
    source->Update();
    for (const unsigned int jaw : { 0u, 1u })
    {
      const unsigned int quadrant = jaw == 0 ? (side == SideEnum::Right ? 1 : 2) : (side == SideEnum::Right ? 4 : 3);
      const auto         crowns = Crowns(source, jaw, quadrant);
      const double       outward = jaw == 0 ? 1.0 : -1.0;
      EXPECT_EQ(NumberOfPoints(source->GetTrueTracing(jaw)), jaw == 0 ? 79u : 75u);
      std::set<unsigned int> teeth;
      for (const auto & line : source->GetTrueTracing(jaw)->GetPolylines())
      {
        EXPECT_EQ(line.code.GetQuadrant(), quadrant);
        teeth.insert(line.code.GetPosition());
        std::size_t free = 0;
        for (const auto & p : line.points)
        {
          // The resampled line cuts corners of its own tenth-of-a-pixel raster only.
          EXPECT_LT(DistanceFrom(crowns, p[0], p[1]), 0.15) << line.code;
          // Outside of it there is no crown: anteriorly on the labial border, occlusally elsewhere.
          free +=
            DistanceFrom(crowns, p[0] + 0.3, p[1]) > 0.0 || DistanceFrom(crowns, p[0], p[1] + 0.3 * outward) > 0.0;
        }
        EXPECT_EQ(free, line.points.size()) << line.code;
      }
      EXPECT_EQ(teeth, (std::set<unsigned int>{ 1, 2, 3, 4, 5, 6, 7 }));
    }
  }
}

TEST(DentalPhantomCaseSource, NoiseIsThatOfTheCohort)
{
  for (const CohortEnum cohort : { CohortEnum::Ideal, CohortEnum::Typical, CohortEnum::Hard })
  {
    double      square = 0.0;
    std::size_t count = 0;
    for (const std::uint64_t seed : { 1, 2, 3, 4 })
    {
      const auto source = Case(seed, cohort);
      source->SetNumberOfTriangles(4000);
      source->Update();
      for (const unsigned int jaw : { 0u, 1u })
      {
        ASSERT_EQ(NumberOfPoints(source->GetTracing(jaw)), NumberOfPoints(source->GetTrueTracing(jaw)));
        for (itk::IdentifierType i = 0; i < source->GetTracing(jaw)->GetNumberOfPoints(); ++i)
        {
          square +=
            (source->GetTracing(jaw)->GetPoint(i) - source->GetTrueTracing(jaw)->GetPoint(i)).GetSquaredNorm() / 2.0;
          ++count;
        }
      }
    }
    const double rms = std::sqrt(square / static_cast<double>(count));
    if (cohort == CohortEnum::Ideal)
    {
      // Only the raster of 1e-3 px.
      EXPECT_LT(rms, 5e-4);
    }
    else
    {
      // Some 16 x 8 independent stretches of drift: 6 %, three times that allowed.
      const double expected = cohort == CohortEnum::Typical ? std::hypot(1.2, 0.5) : std::hypot(2.2, 1.0);
      EXPECT_NEAR(rms, expected, 0.18 * expected);
    }
  }
}

TEST(DentalPhantomCaseSource, TwoDimensionalLandmarksAreTheTrueProjections)
{
  for (const auto frame : { CaseType::FrameEnum::SharedScanner, CaseType::FrameEnum::SeparateScanner })
  {
    const auto source = Case(6, CohortEnum::Hard);
    source->SetFrame(frame);
    source->Update();
    for (const unsigned int jaw : { 0u, 1u })
    {
      const auto matrix = source->GetTrueGeometry(jaw)->GetProjectionMatrix();
      ASSERT_EQ(source->GetLandmarks2D(jaw)->GetNumberOfLandmarks(), 8u);
      for (const auto & landmark : source->GetLandmarks2D(jaw)->GetLandmarks())
      {
        EXPECT_TRUE(landmark.tooth.IsRight());
        const auto & p = source->GetLandmarks3D(jaw)->Find(landmark.name)->point;
        double       h[3];
        for (unsigned int row = 0; row < 3; ++row)
        {
          h[row] = matrix(row, 0) * p[0] + matrix(row, 1) * p[1] + matrix(row, 2) * p[2] + matrix(row, 3);
        }
        EXPECT_NEAR(landmark.point[0], h[0] / h[2], 1e-8);
        EXPECT_NEAR(landmark.point[1], h[1] / h[2], 1e-8);
        EXPECT_TRUE(landmark.point[0] > 350.0 && landmark.point[0] < 680.0) << landmark.point;
        EXPECT_TRUE(landmark.point[1] > 480.0 && landmark.point[1] < 800.0) << landmark.point;
      }
    }
    // Both jaws stay in occlusion on the radiograph whatever frames their files have.
    const double upper = source->GetLandmarks2D(0)->Find("UR1_tip")->point[0];
    const double lower = source->GetLandmarks2D(1)->Find("LR1_tip")->point[0];
    EXPECT_TRUE(upper - lower > 0.0 && upper - lower < 30.0) << upper << " " << lower;
  }
}

TEST(DentalPhantomCaseSource, TracingStylesDiffer)
{
  const auto right = Case(8, CohortEnum::Ideal, SideEnum::Right);
  const auto left = Case(8, CohortEnum::Ideal, SideEnum::Left);
  const auto mean = Case(8, CohortEnum::Ideal, SideEnum::Mean);
  const auto both = Case(8, CohortEnum::Ideal, SideEnum::Both);
  for (const auto & source : { right, left, mean, both })
  {
    source->Update();
  }
  for (const unsigned int jaw : { 0u, 1u })
  {
    for (const auto & line : left->GetTracing(jaw)->GetPolylines())
    {
      EXPECT_TRUE(line.code.IsLeft());
    }
    EXPECT_EQ(both->GetTracing(jaw)->GetPolylines().size(),
              right->GetTracing(jaw)->GetPolylines().size() + left->GetTracing(jaw)->GetPolylines().size());
    EXPECT_EQ(both->GetLandmarks2D(jaw)->GetNumberOfLandmarks(), 16u);
    EXPECT_EQ(mean->GetLandmarks2D(jaw)->GetNumberOfLandmarks(), 16u);
    EXPECT_EQ(left->GetLandmarks2D(jaw)->GetNumberOfLandmarks(), 8u);
    // The bisected tracing lies between the two: as a whole, by its mean height in the image.
    double height[3] = { 0.0, 0.0, 0.0 };
    int    index = 0;
    for (const auto & source : { right, mean, left })
    {
      const auto * tracing = source->GetTracing(jaw);
      for (itk::IdentifierType i = 0; i < tracing->GetNumberOfPoints(); ++i)
      {
        height[index] += tracing->GetPoint(i)[1] / static_cast<double>(tracing->GetNumberOfPoints());
      }
      ++index;
    }
    EXPECT_NEAR(height[1], 0.5 * (height[0] + height[2]), 0.5 + 0.25 * std::abs(height[0] - height[2]));
    EXPECT_TRUE(mean->GetTracing(jaw)->GetPolylines().front().code.IsRight());
  }
}

TEST(DentalPhantomCaseSource, BuccalOutlinePassesTheBuccalCusps)
{
  double whole = 0.0;
  double buccal = 0.0;
  int    inside = 0;
  for (const std::uint64_t seed : { 1, 2, 3, 4 })
  {
    const auto plain = Case(seed, CohortEnum::Ideal);
    const auto inner = Case(seed, CohortEnum::Ideal);
    inner->BuccalOutlineOn();
    plain->Update();
    inner->Update();
    const auto crowns = Crowns(plain, 0, 1);
    for (const char * name : { "UR4_B", "UR5_B", "UR6_MB", "UR6_DB", "UR7_MB" })
    {
      const auto & point = inner->GetLandmarks2D(0)->Find(name)->point;
      whole = std::max(whole, DistanceToContour(plain->GetTracing(0), point));
      buccal = std::max(buccal, DistanceToContour(inner->GetTracing(0), point));
    }
    for (itk::IdentifierType i = 0; i < inner->GetTracing(0)->GetNumberOfPoints(); ++i)
    {
      const auto p = inner->GetTracing(0)->GetPoint(i);
      inside += DistanceFrom(crowns, p[0], p[1] + 1.0) == 0.0 && DistanceFrom(crowns, p[0] + 1.0, p[1]) == 0.0;
    }
  }
  // A tracing of 79 points cuts a cusp's tip by half a pixel; a neighbour may hide a tip.
  EXPECT_LT(buccal, 1.5);
  EXPECT_GT(whole, buccal + 1.0);
  EXPECT_GT(inside, 10);
}

TEST(DentalPhantomCaseSource, FacingLeftMirrorsThePicture)
{
  const auto right = Case(4, CohortEnum::Ideal);
  const auto left = Case(4, CohortEnum::Ideal);
  left->SetFacing(GeometryType::FacingEnum::Left);
  right->Update();
  left->Update();
  ASSERT_EQ(NumberOfPoints(right->GetTracing(0)), NumberOfPoints(left->GetTracing(0)));
  for (itk::IdentifierType i = 0; i < right->GetTracing(0)->GetNumberOfPoints(); ++i)
  {
    const auto a = right->GetTracing(0)->GetPoint(i);
    const auto b = left->GetTracing(0)->GetPoint(i);
    // The column raster of the tracer begins at the first point, mirrored alike; two roundings of 1e-3 remain.
    EXPECT_NEAR(702.0 - a[0], b[0], 2e-3);
    EXPECT_NEAR(a[1], b[1], 2e-3);
  }
}

TEST(DentalPhantomCaseSource, SourceSideDecidesWhichSideIsMagnifiedMore)
{
  double span[2];
  for (const int k : { 0, 1 })
  {
    const auto source = Case(4, CohortEnum::Ideal);
    source->SetSourceSide(k == 0 ? GeometryType::SourceSideEnum::Right : GeometryType::SourceSideEnum::Left);
    source->Update();
    const auto * landmarks = source->GetLandmarks2D(0);
    span[k] = landmarks->Find("UR1_tip")->point.EuclideanDistanceTo(landmarks->Find("UR6_MB")->point);
    EXPECT_EQ(source->GetNominalGeometry()->GetSourceSide(), source->GetSourceSide());
  }
  // Molars 28 mm off the midline: 3.6 % between near and far.
  EXPECT_GT(span[0], 1.005 * span[1]);
}

TEST(DentalPhantomCaseSource, HardCasesLackTeethAndTracings)
{
  int missing = 0;
  int untraced = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
  {
    const auto source = Case(seed, CohortEnum::Hard);
    source->SetNumberOfTriangles(4000);
    source->Update();
    const auto & drawn = source->GetAcquisition();
    for (const unsigned int jaw : { 0u, 1u })
    {
      int teeth = 0;
      for (const auto & tooth : source->GetParameters().jaws[jaw].teeth)
      {
        teeth += tooth.missing ? 0 : 1;
      }
      const bool lacks = drawn.missingPosition != 0 && drawn.missingJaw == jaw;
      EXPECT_EQ(teeth, lacks ? 13 : 14);
      missing += lacks;
      for (const auto & line : source->GetTracing(jaw)->GetPolylines())
      {
        EXPECT_NE(line.code.GetPosition(), drawn.untracedPosition[jaw]);
      }
      untraced += drawn.untracedPosition[jaw] != 0;
      EXPECT_EQ(source->GetLandmarks2D(jaw)->GetNumberOfLandmarks(), 8u);
    }
  }
  // These seeds hold some of each.
  EXPECT_GT(missing, 0);
  EXPECT_GT(untraced, 0);
}

TEST(DentalPhantomCaseSource, DropOutShortensEveryTooth)
{
  const auto whole = Case(2);
  const auto part = Case(2);
  part->SetDropOutFraction(0.3);
  whole->Update();
  part->Update();
  EXPECT_NEAR(NumberOfPoints(part->GetTracing(0)), 0.7 * NumberOfPoints(whole->GetTracing(0)), 5.0);
  EXPECT_EQ(part->GetTracing(0)->GetPolylines().size(), whole->GetTracing(0)->GetPolylines().size());
}

TEST(DentalPhantomCaseSource, HeadTurnsAndTeethGoMissingOnDemand)
{
  const auto plain = Case(2);
  const auto changed = Case(2);
  changed->SetAdditionalYaw(0.05);
  changed->SetAdditionalRoll(-0.02);
  changed->SetMissingTeeth({ 14, 36 });
  plain->Update();
  changed->Update();
  EXPECT_DOUBLE_EQ(changed->GetAcquisition().yaw, plain->GetAcquisition().yaw + 0.05);
  EXPECT_DOUBLE_EQ(changed->GetAcquisition().roll, plain->GetAcquisition().roll - 0.02);
  EXPECT_TRUE(changed->GetParameters().jaws[0].teeth[3].missing);
  EXPECT_TRUE(changed->GetParameters().jaws[1].teeth[12].missing);
  for (const auto & line : changed->GetTracing(0)->GetPolylines())
  {
    EXPECT_NE(line.code.GetFDI(), 14);
  }
  EXPECT_THROW(changed->SetMissingTeeth({ 18 }), itk::ExceptionObject);
}

TEST(DentalPhantomCaseSource, SeedsOfTheFirstLevelsGiveTheBitsTheyAlwaysGave)
{
  // Tables, frozen answers and users' cases are of these seeds: whatever is added to the phantom must leave them alone.
  // Coordinates are on rasters (mesh 1e-4 mm, drawing 1e-3 px), so that the numbers are whole.
  const auto digest = [](CaseType * source) {
    std::uint64_t hash = 14695981039346656037u;
    const auto    add = [&hash](double value) {
      // FNV-1a, a byte each.
      auto bits = static_cast<std::uint64_t>(std::llround(value));
      for (unsigned int k = 0; k < 8; ++k, bits >>= 8)
      {
        hash = (hash ^ (bits & 0xffu)) * 1099511628211u;
      }
    };
    source->Update();
    for (const unsigned int jaw : { 0u, 1u })
    {
      const auto * mesh = source->GetMesh(jaw);
      for (itk::IdentifierType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        for (unsigned int d = 0; d < 3; ++d)
        {
          add(1e4 * mesh->GetPoint(i)[d]);
        }
      }
      for (auto it = mesh->GetCells()->Begin(); it != mesh->GetCells()->End(); ++it)
      {
        for (unsigned int corner = 0; corner < 3; ++corner)
        {
          add(static_cast<double>(it.Value()->GetPointIds()[corner]));
        }
      }
      const auto * tracing = source->GetTracing(jaw);
      for (itk::IdentifierType i = 0; i < tracing->GetNumberOfPoints(); ++i)
      {
        add(1e3 * tracing->GetPoint(i)[0]);
        add(1e3 * tracing->GetPoint(i)[1]);
      }
    }
    const auto * image = source->GetRadiograph();
    const auto   size = image->GetBufferedRegion().GetNumberOfPixels();
    for (itk::SizeValueType i = 0; i < size; i += 7)
    {
      add(image->GetBufferPointer()[i]);
    }
    return hash;
  };
  const std::tuple<CohortEnum, std::uint64_t, SideEnum, bool, std::uint64_t> cases[] = {
    { CohortEnum::Ideal, 1, SideEnum::Right, false, 12191899568347999256u },
    { CohortEnum::Typical, 2, SideEnum::Right, true, 2241907538000949805u },
    { CohortEnum::Typical, 3, SideEnum::Mean, false, 2735510016947020003u },
    { CohortEnum::Hard, 5, SideEnum::Left, false, 11161248881479646067u },
    { CohortEnum::Hard, 12, SideEnum::Both, false, 9705396233145494842u },
  };
  for (const auto & one : cases)
  {
    const auto source = Case(std::get<1>(one), std::get<0>(one), std::get<2>(one));
    source->SetMakeRadiograph(std::get<3>(one));
    EXPECT_EQ(digest(source), std::get<4>(one)) << std::get<0>(one) << " seed " << std::get<1>(one);
  }
}

TEST(DentalPhantomCaseSource, SameBitsForAnyNumberOfWorkUnitsOfAStandardTracingAndBothFilms)
{
  auto level = itk::DentalPhantomLevel::Named("practice");
  level.ParseJson(
    "{\"scan\": {\"decimate_to\": 0, \"gingiva_least\": 0.3, \"gingiva_most\": 0.6}, \"frontal\": {\"given\": "
    "true, \"same_head_position\": false}, \"tracing\": {\"confidence\": \"informative\"}}",
    "test");
  std::array<CaseType::Pointer, 2> sources;
  for (const unsigned int k : { 0u, 1u })
  {
    sources[k] = CaseType::New();
    sources[k]->SetLevel(level);
    sources[k]->SetNumberOfTriangles(12000);
    sources[k]->SetSeed(8);
    sources[k]->SetNumberOfWorkUnits(k == 0 ? 1 : 5);
    sources[k]->Update();
  }
  const auto * a = sources[0]->GetRadiograph();
  const auto   pixels = a->GetBufferedRegion().GetNumberOfPixels();
  ASSERT_GT(pixels, 0u);
  EXPECT_TRUE(
    std::equal(a->GetBufferPointer(), a->GetBufferPointer() + pixels, sources[1]->GetRadiograph()->GetBufferPointer()));
  ASSERT_NE(sources[0]->GetFrontalView(), nullptr);
  const auto * front = sources[0]->GetFrontalView()->image.GetPointer();
  EXPECT_TRUE(std::equal(front->GetBufferPointer(),
                         front->GetBufferPointer() + front->GetBufferedRegion().GetNumberOfPixels(),
                         sources[1]->GetFrontalView()->image->GetBufferPointer()));
  for (const unsigned int jaw : { 0u, 1u })
  {
    const auto * mesh = sources[0]->GetMesh(jaw);
    ASSERT_EQ(mesh->GetNumberOfPoints(), sources[1]->GetMesh(jaw)->GetNumberOfPoints());
    for (itk::IdentifierType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(mesh->GetPoint(i), sources[1]->GetMesh(jaw)->GetPoint(i));
    }
    const auto lines = sources[0]->GetTracing(jaw)->GetPolylines();
    ASSERT_EQ(lines.size(), 2u);
    for (std::size_t k = 0; k < lines.size(); ++k)
    {
      const auto other = sources[1]->GetTracing(jaw)->GetPolylines()[k];
      EXPECT_EQ(lines[k].points, other.points);
      EXPECT_EQ(lines[k].sigmas, other.sigmas);
    }
  }
}

TEST(DentalPhantomCaseSource, OutlinesSayWhatTheyAreAndHowSureTheyAre)
{
  auto level = itk::DentalPhantomLevel::Named("standard");
  for (const char * const confidence : { "none", "informative", "uninformative" })
  {
    level.confidence = confidence;
    auto source = CaseType::New();
    source->SetLevel(level);
    source->SetNumberOfTriangles(8000);
    source->MakeRadiographOff();
    source->Update();
    for (const unsigned int jaw : { 0u, 1u })
    {
      const auto & lines = source->GetTracing(jaw)->GetPolylines();
      const auto & outlines = source->GetStandardTracing()->GetOutlines(jaw);
      ASSERT_EQ(lines.size(), outlines.size());
      for (std::size_t k = 0; k < lines.size(); ++k)
      {
        EXPECT_EQ(lines[k].outline, itk::DentalContour::OutlineEnum::Tooth);
        EXPECT_TRUE(lines[k].closed);
        const std::vector<double> said(lines[k].points.size(), outlines[k].slip.statedSigma);
        EXPECT_EQ(lines[k].sigmas, level.confidence == "none" ? std::vector<double>() : said) << confidence;
      }
    }
  }
}

TEST(DentalPhantomCaseSource, SameBitsForAnyNumberOfWorkUnitsAndEveryRun)
{
  const auto one = Case(12);
  const auto many = Case(12);
  one->MakeRadiographOn();
  many->MakeRadiographOn();
  one->SetNumberOfWorkUnits(1);
  many->SetNumberOfWorkUnits(5);
  one->Update();
  many->Update();
  const auto * a = one->GetRadiograph();
  const auto * b = many->GetRadiograph();
  const auto   size = a->GetBufferedRegion().GetNumberOfPixels();
  ASSERT_EQ(size, 703u * 938u);
  EXPECT_TRUE(std::equal(a->GetBufferPointer(), a->GetBufferPointer() + size, b->GetBufferPointer()));
  for (const unsigned int jaw : { 0u, 1u })
  {
    for (itk::IdentifierType i = 0; i < one->GetTracing(jaw)->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(one->GetTracing(jaw)->GetPoint(i), many->GetTracing(jaw)->GetPoint(i));
    }
  }
  // The picture shows what the tracing follows: enamel above the edge of each first molar, air between the jaws is
  // darker by far more than the grain (3 grey values).
  const auto grey = [a](double u, double v) {
    double mean = 0.0;
    for (int i = -2; i <= 2; ++i)
    {
      for (int j = -2; j <= 2; ++j)
      {
        mean += a->GetPixel({ { std::lround(u) + i, std::lround(v) + j } }) / 25.0;
      }
    }
    return mean;
  };
  const auto & incisor = one->GetLandmarks2D(0)->Find("UR1_tip")->point;
  EXPECT_GT(grey(incisor[0] - 4.0, incisor[1] - 14.0), grey(incisor[0] + 14.0, incisor[1] + 6.0) + 25.0);
  // The ear-rod ring, 4 mm about the principal point.
  const auto & principal = one->GetNominalGeometry()->GetPrincipalPoint();
  const double radius = 4.0 * one->GetTrueGeometry(0)->GetSourceToDetectorDistance() /
                        one->GetTrueGeometry(0)->GetSourceToMidsagittalDistance() /
                        one->GetNominalGeometry()->GetPixelSpacing()[0];
  EXPECT_GT(grey(principal[0] + radius, principal[1]), grey(principal[0], principal[1]) + 20.0);
}
