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
#include "itkDentalPhantomStandardTracing.h"

#include "itkDentalPhantomFilm.h"
#include "itkDentalPhantomOutline.h"
#include "itkDentalPhantomTestCase.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace DentalPhantomTestCase;

namespace
{
using TracingType = itk::DentalPhantomStandardTracing;
using PixelType = TracingType::PixelType;

const std::string NoErrors =
  "\"drift_px\": 0, \"jitter_px\": 0, \"tooth_along_mm\": 0, \"tooth_across_mm\": 0, \"tooth_turn_deg\": 0, "
  "\"tooth_scale\": 0, \"reader_bias_mm\": 0, \"gross_probability\": 0, \"palatal_mm\": 0";

template <typename TPoint>
double
DistanceToSegment(const TPoint & a, const TPoint & b, const TPoint & p)
{
  const double x = b[0] - a[0];
  const double y = b[1] - a[1];
  const double t =
    std::min(1.0, std::max(0.0, ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / std::max(x * x + y * y, 1e-12)));
  return std::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}

double
DistanceTo(const std::vector<PixelType> & closed, const PixelType & p)
{
  double best = 1e9;
  for (std::size_t i = 0; i < closed.size(); ++i)
  {
    best = std::min(best, DistanceToSegment(closed[i], closed[(i + 1) % closed.size()], p));
  }
  return best;
}

/** The largest distance of two points, mm about the teeth. */
double
Length(const std::vector<PixelType> & points, double spacing)
{
  double best = 0.0;
  for (const auto & p : points)
  {
    for (const auto & q : points)
    {
      best = std::max(best, std::hypot(p[0] - q[0], p[1] - q[1]));
    }
  }
  return best * spacing / 1.1;
}

PixelType
Pixel(CaseType * source, const std::string & name)
{
  const auto & p = source->GetLandmarks2D(name[0] == 'U' ? 0 : 1)->Find(name)->point;
  return { { p[0], p[1] } };
}
} // namespace

TEST(DentalPhantomStandardTracing, DrawsWholeTeethOfTextbookLengthThroughTheirLandmarks)
{
  const auto source = Make(3, "{\"level\": \"standard\", \"tracing\": {" + NoErrors + "}}");
  const auto tracing = source->GetStandardTracing();
  ASSERT_NE(tracing, nullptr);
  const double spacing = source->GetNominalGeometry()->GetPixelSpacing()[0];
  for (const unsigned int jaw : { 0u, 1u })
  {
    const auto & outlines = tracing->GetOutlines(jaw);
    ASSERT_EQ(outlines.size(), 2u);
    EXPECT_EQ(outlines[0].fdi, jaw == 0 ? 11 : 41);
    EXPECT_EQ(outlines[1].fdi, jaw == 0 ? 16 : 46);
    // Wheeler: U1 10.5 + 13, L1 9 + 12.5, U6 7.7 + 13.2, L6 7.7 + 14; individual size 10 %, inclination 5 %.
    EXPECT_NEAR(Length(outlines[0].exact, spacing), jaw == 0 ? 23.5 : 21.5, 3.0);
    EXPECT_NEAR(Length(outlines[1].exact, spacing), jaw == 0 ? 21.0 : 22.0, 3.0);
    // The tip of the incisor is a point of its outline: the landmark is the crown's highest point.
    const std::string prefix = jaw == 0 ? "U" : "L";
    const double      right = DistanceTo(outlines[0].exact, Pixel(source, prefix + "R1_tip"));
    const double      left = DistanceTo(outlines[0].exact, Pixel(source, prefix + "L1_tip"));
    EXPECT_LT(std::min(right, left), 1.5);
    // The tracings of the case are the same, closed.
    const auto lines = source->GetTracing(jaw)->GetPolylines();
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_TRUE(lines[0].closed && lines[1].closed);
    for (std::size_t i = 0; i < outlines[0].exact.size(); ++i)
    {
      // Without errors only the raster of 1e-3 px.
      EXPECT_NEAR(lines[0].points[i][0], outlines[0].exact[i][0], 1e-3);
    }
  }
}

TEST(DentalPhantomStandardTracing, IncisorIsTheForemostAndMolarTheMiddleOfTheSides)
{
  for (const std::uint64_t seed : { 1, 2, 4 })
  {
    const auto                       source = Make(seed,
                             "{\"level\": \"standard\", \"tracing\": {" + NoErrors +
                               "}, \"landmarks\": {\"along_mm\": 0, \"across_mm\": 0, \"apices\": true}}",
                             8000);
    std::map<std::string, PixelType> marks;
    for (const auto & landmark : source->GetStandardTracing()->GetLandmarks())
    {
      marks[landmark.name] = landmark.drawn;
    }
    ASSERT_EQ(marks.size(), 6u);
    for (const std::string jaw : { "U", "L" })
    {
      EXPECT_NEAR(
        marks[jaw + "1_tip"][0], std::max(Pixel(source, jaw + "R1_tip")[0], Pixel(source, jaw + "L1_tip")[0]), 2e-3);
      for (unsigned int d = 0; d < 2; ++d)
      {
        EXPECT_NEAR(
          marks[jaw + "6_MB"][d], 0.5 * (Pixel(source, jaw + "R6_MB")[d] + Pixel(source, jaw + "L6_MB")[d]), 2e-3);
      }
      // The apex lies a root and a crown away, on the side of its own jaw.
      EXPECT_EQ(marks[jaw + "1A"][1] < marks[jaw + "1_tip"][1], jaw == "U");
    }
  }
}

TEST(DentalPhantomStandardTracing, TemplatesAreOneShapeMovedByTipAndAxis)
{
  std::set<unsigned int> used;
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5 })
  {
    const auto                       source = Make(seed,
                             "{\"level\": \"standard\", \"tracing\": {\"template_probability\": 1, " + NoErrors +
                               "}, \"landmarks\": {\"apices\": true}}",
                             6000);
    std::map<std::string, PixelType> marks;
    for (const auto & landmark : source->GetStandardTracing()->GetLandmarks())
    {
      marks[landmark.name] = landmark.exact;
    }
    const auto project = [&source](unsigned int jaw, const PointType & p) {
      const auto pixel = source->GetTrueGeometry(jaw)->ProjectPoint(itk::CephalometricGeometry::PointType(p.data()));
      return PixelType{ { pixel[0], pixel[1] } };
    };
    // A stock outline is magnified as the picture is: 20 mm of the median plane about the teeth.
    const PixelType               front = project(0, { { 30.0, 0.0, 0.0 } });
    const PixelType               back = project(0, { { 10.0, 0.0, 0.0 } });
    const double                  magnification = std::hypot(front[0] - back[0], front[1] - back[1]) / 20.0;
    const itk::DentalPhantomModel model(source->GetParameters());
    std::set<unsigned int>        sets;
    for (const unsigned int jaw : { 0u, 1u })
    {
      for (const bool molar : { false, true })
      {
        const auto & outline = source->GetStandardTracing()->GetOutlines(jaw)[molar ? 1 : 0];
        ASSERT_TRUE(outline.isTemplate);
        const std::string prefix = jaw == 0 ? "U" : "L";
        const PixelType   tip = marks.at(prefix + (molar ? "6_MB" : "1_tip"));
        // An incisor's axis runs from edge to apex; a molar has its direction from its own axis, cervix to crown.
        PixelType axis = marks.at(prefix + "1A");
        axis = { { axis[0] - tip[0], axis[1] - tip[1] } };
        if (molar)
        {
          const auto & body = model.GetDentition().GetBody(jaw, itk::DentalPhantomJaw::GetIndex(false, 5));
          PointType    root = body.ToJaw({ { 0.0, 0.0, -10.0 } });
          PointType    crown = body.ToJaw({ { 0.0, 0.0, body.height } });
          root[2] *= jaw == 0 ? -1.0 : 1.0;
          crown[2] *= jaw == 0 ? -1.0 : 1.0;
          const PixelType from = project(jaw, crown);
          const PixelType to = project(jaw, root);
          axis = { { to[0] - from[0], to[1] - from[1] } };
        }
        const double    length = std::hypot(axis[0], axis[1]);
        const PixelType apical = { { axis[0] / length, axis[1] / length } };
        // The face looks to the right, and so does the template's front.
        const double    side = apical[1] < 0.0 ? 1.0 : -1.0;
        const PixelType anterior = { { -side * apical[1], side * apical[0] } };
        EXPECT_GT(anterior[0], 0.5);
        for (const unsigned int set : { 0u, 1u })
        {
          const auto shape =
            itk::DentalPhantomOutline::Resample(TracingType::GetTemplate(jaw, molar, set), outline.exact.size());
          double worst = 0.0;
          for (std::size_t i = 0; i < shape.size(); ++i)
          {
            for (unsigned int d = 0; d < 2; ++d)
            {
              const double place = tip[d] + magnification * (shape[i][0] * anterior[d] + shape[i][1] * apical[d]);
              worst = std::max(worst, std::abs(place - outline.exact[i][d]));
            }
          }
          // The same points but for rounding; the other set is 1.2 mm longer.
          if (worst < 1e-6)
          {
            sets.insert(set);
          }
          else
          {
            EXPECT_GT(worst, 2.0) << seed << ' ' << outline.fdi + 0;
          }
        }
      }
    }
    // One set for all teeth of a film.
    EXPECT_EQ(sets.size(), 1u) << seed;
    used.insert(sets.begin(), sets.end());
  }
  // Of five films some are of either publisher.
  EXPECT_EQ(used.size(), 2u);
}

TEST(DentalPhantomHand, ErrsAsPracticeSays)
{
  LevelType level = LevelType::Named("standard");
  level.grossProbability = 0.01;
  double           along = 0.0;
  double           across = 0.0;
  double           turn = 0.0;
  double           scale = 0.0;
  double           gross = 0.0;
  double           bias = 0.0;
  double           together = 0.0;
  constexpr double spacing = 0.25;
  constexpr int    films = 4000;
  for (int film = 1; film <= films; ++film)
  {
    const itk::DentalPhantomHand hand(level, film, { { 0.8, 0.6 } }, spacing);
    const auto                   slip = hand.DrawOutline(11);
    const auto                   other = hand.DrawOutline(16);
    bias += hand.GetBias()[0] * hand.GetBias()[0] / films;
    gross += slip.gross;
    if (slip.gross || other.gross)
    {
      continue;
    }
    const double u = slip.shift[0] - hand.GetBias()[0];
    const double v = slip.shift[1] - hand.GetBias()[1];
    along += std::pow(0.8 * u + 0.6 * v, 2) / films;
    across += std::pow(-0.6 * u + 0.8 * v, 2) / films;
    turn += slip.turn * slip.turn / films;
    scale += std::pow(slip.scale - 1.0, 2) / films;
    together += u * (other.shift[0] - hand.GetBias()[0]) / films;
  }
  // 4000 draws: 1.1 % on a standard deviation, 2 % of the films left out.
  EXPECT_NEAR(spacing * std::sqrt(along), 0.45, 0.025);
  EXPECT_NEAR(spacing * std::sqrt(across), 0.6, 0.03);
  EXPECT_NEAR(std::sqrt(turn) * 57.29578, 2.0, 0.1);
  EXPECT_NEAR(std::sqrt(scale), 0.03, 0.002);
  EXPECT_NEAR(spacing * std::sqrt(bias), 0.15, 0.01);
  // 40 of them, sd 6.3.
  EXPECT_NEAR(gross, 40.0, 20.0);
  // Independent from tooth to tooth.
  EXPECT_LT(std::abs(together), 0.08 * along);
}

TEST(DentalPhantomHand, ConfidenceKnowsTheSpreadOnlyWhereItInforms)
{
  for (const std::string confidence : { "informative", "uninformative" })
  {
    LevelType level = LevelType::Named("standard");
    level.confidence = confidence;
    level.grossProbability = 0.0;
    // The rank correlation of what is said with what happened, as the share of concordant pairs.
    double loud = 0.0;
    double quiet = 0.0;
    int    count[2] = { 0, 0 };
    for (int film = 1; film <= 3000; ++film)
    {
      const itk::DentalPhantomHand hand(level, film, { { 1.0, 0.0 } }, 0.25);
      const auto                   slip = hand.DrawLandmark(11, 0);
      const double                 error =
        std::pow(slip.shift[0] - hand.GetBias()[0], 2) + std::pow(slip.shift[1] - hand.GetBias()[1], 2);
      const double middle = std::sqrt(0.5 * (0.45 * 0.45 + 0.6 * 0.6)) / 0.25;
      (slip.statedSigma > middle ? loud : quiet) += error;
      ++count[slip.statedSigma > middle];
    }
    const double ratio = (loud / count[1]) / (quiet / count[0]);
    // A lognormal spread of 0.4: those above the median err 3.6 times as much in the square as those below.
    if (confidence == "informative")
    {
      EXPECT_GT(ratio, 2.5);
    }
    else
    {
      EXPECT_NEAR(ratio, 1.0, 0.25);
    }
  }
}

TEST(DentalPhantomCaseSource, FrontalViewFollowsItsFormula)
{
  const auto   source = Make(5, "{\"frontal\": {\"given\": true, \"same_head_position\": true}}", 8000);
  const auto * view = source->GetFrontalView();
  ASSERT_NE(view, nullptr);
  EXPECT_EQ(view->trueLandmarks->GetNumberOfLandmarks(), 32u);
  // views.md: depth = S + x, u = pp + D / depth y / sp, v = pp - D / depth z / sp, with the lateral view's own pose.
  // D is not told to a clinic: 110 to 190 mm more than S, on a raster of 0.01 mm, and the same for all points.
  const double    distance = source->GetAcquisition().trueSourceToMidsagittal;
  double          toDetector = 0.0;
  const PixelType principal = { { view->principalPoint[0], view->principalPoint[1] } };
  const PixelType spacing = { { view->spacing[0], view->spacing[1] } };
  for (const unsigned int jaw : { 0u, 1u })
  {
    for (const auto & landmark : source->GetLandmarks3D(jaw)->GetLandmarks())
    {
      const auto   c = source->GetTrueGeometry(jaw)->TransformToCephalostat(landmark.point);
      double       uv[2];
      const double depth = view->projections[jaw].Project(landmark.point.GetDataPointer(), uv[0], uv[1]);
      EXPECT_NEAR(depth, distance + c[0], 1e-6);
      if (toDetector == 0.0)
      {
        toDetector = std::nearbyint(100.0 * (uv[0] - principal[0]) * spacing[0] * depth / c[1]) / 100.0;
        EXPECT_GE(toDetector, distance + 110.0);
        EXPECT_LE(toDetector, distance + 190.0);
      }
      EXPECT_NEAR(uv[0], principal[0] + toDetector / depth * c[1] / spacing[0], 1e-6) << landmark.name;
      EXPECT_NEAR(uv[1], principal[1] - toDetector / depth * c[2] / spacing[1], 1e-6) << landmark.name;
      const auto & told = view->trueLandmarks->Find(landmark.name)->point;
      EXPECT_NEAR(told[0], uv[0], 1e-9);
      EXPECT_NEAR(told[1], uv[1], 1e-9);
    }
  }
  // What a reader marks: both sides' central incisors, canines and first molars of both jaws.
  EXPECT_EQ(view->landmarks->GetNumberOfLandmarks(), 12u);
  double square = 0.0;
  for (const auto & landmark : view->landmarks->GetLandmarks())
  {
    square += (landmark.point - view->trueLandmarks->Find(landmark.name)->point).GetSquaredNorm() / 24.0;
  }
  // 0.5 mm an axis in the detector, 24 draws: 15 %, three times that.
  EXPECT_NEAR(std::sqrt(square) * spacing[0], 0.5, 0.23);
}

TEST(DentalPhantomCaseSource, FrontalHeadTurnsOnlyAsItsParametersSay)
{
  // One cause of motion at a time; by what the projections say of the head in the frontal and in the lateral view.
  for (const std::string part : { "pitch_sd_deg", "turn_sd_deg", "shift_sd_mm" })
  {
    const double spread = part == "pitch_sd_deg" ? 3.0 : 1.5;
    double       square = 0.0;
    int          draws = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      std::string text = "{\"frontal\": {\"given\": true, \"same_head_position\": false";
      for (const std::string key : { "pitch_sd_deg", "turn_sd_deg", "shift_sd_mm" })
      {
        text += ", \"" + key + "\": " + (key == part ? std::to_string(spread) : "0");
      }
      const auto   source = Make(seed, text + "}}", 2000);
      const auto * view = source->GetFrontalView();
      ASSERT_NE(view, nullptr);
      EXPECT_FALSE(view->sameHeadPosition);
      // The patient's left is on the right, turned or not.
      for (const auto & landmark : view->trueLandmarks->GetLandmarks())
      {
        if (landmark.tooth.IsLeft())
        {
          std::string twin = landmark.name;
          twin[1] = 'R';
          EXPECT_GT(landmark.point[0], view->trueLandmarks->Find(twin)->point[0]) << landmark.name << ' ' << seed;
        }
      }
      // Rows of the head's pose in the frontal view: (depth - S), u and v without principal point and magnification.
      const auto & m = view->projections[0].matrix;
      double       frontal[3][4];
      double       factor = 0.0;
      for (unsigned int column = 0; column < 3; ++column)
      {
        factor += std::pow(m[column] - view->principalPoint[0] * m[8 + column], 2);
      }
      factor = std::sqrt(factor);
      for (unsigned int column = 0; column < 4; ++column)
      {
        frontal[0][column] = m[8 + column] - (column == 3 ? source->GetAcquisition().trueSourceToMidsagittal : 0.0);
        frontal[1][column] = (m[column] - view->principalPoint[0] * m[8 + column]) / factor;
        frontal[2][column] = (view->principalPoint[1] * m[8 + column] - m[4 + column]) / factor;
      }
      // What turns the lateral pose into it: a rotation and a shift after it.
      const auto & rotation = source->GetTrueGeometry(0)->GetPoseRotation();
      const auto & translation = source->GetTrueGeometry(0)->GetPoseTranslation();
      double       more[3][3];
      double       shift[3];
      for (unsigned int row = 0; row < 3; ++row)
      {
        shift[row] = frontal[row][3];
        for (unsigned int column = 0; column < 3; ++column)
        {
          more[row][column] = 0.0;
          for (unsigned int k = 0; k < 3; ++k)
          {
            more[row][column] += frontal[row][k] * rotation(column, k);
          }
          shift[row] -= more[row][column] * translation[column];
        }
      }
      const double pitch = std::asin(more[0][2]) * 57.29577951308232;
      const double roll = std::asin(more[2][1]) * 57.29577951308232;
      const double yaw = std::asin(more[1][0]) * 57.29577951308232;
      const bool   pitches = part == "pitch_sd_deg";
      const bool   turns = part == "turn_sd_deg";
      // The last bits of a matrix whose numbers are about 1e6.
      constexpr double none = 1e-6;
      EXPECT_EQ(std::abs(roll) > none, turns) << part << ' ' << seed;
      EXPECT_EQ(std::abs(yaw) > none, turns) << part << ' ' << seed;
      // Yaw and roll together have a pitch of second order.
      EXPECT_TRUE(pitches ? std::abs(pitch) > none : std::abs(pitch) < none + std::abs(roll * yaw) / 57.0)
        << part << ' ' << seed << ' ' << pitch;
      for (const double s : shift)
      {
        EXPECT_EQ(std::abs(s) > none, part == "shift_sd_mm") << part << ' ' << seed;
      }
      square += pitches ? pitch * pitch
                : turns ? roll * roll + yaw * yaw
                        : shift[0] * shift[0] + shift[1] * shift[1] + shift[2] * shift[2];
      draws += pitches ? 1 : turns ? 2 : 3;
    }
    // The standard deviation of n normal draws is known to 1 / sqrt(2 n): three times that.
    EXPECT_NEAR(std::sqrt(square / draws), spread, 3.0 * spread / std::sqrt(2.0 * draws)) << part;
  }
}

TEST(DentalPhantomCaseSource, FrontalTracingFollowsEdgesAndTheMolarsBuccalContours)
{
  const auto source =
    Make(5, "{\"frontal\": {\"given\": true}, \"tracing\": {\"drift_px\": 0, \"jitter_px\": 0}}", 16000);
  const auto * view = source->GetFrontalView();
  ASSERT_NE(view, nullptr);
  for (const unsigned int jaw : { 0u, 1u })
  {
    std::set<std::string> teeth;
    double                farthest[2] = { 1e9, -1e9 };
    for (const auto & line : view->tracings[jaw]->GetPolylines())
    {
      for (const auto & p : line.points)
      {
        farthest[0] = std::min(farthest[0], p[0]);
        farthest[1] = std::max(farthest[1], p[0]);
      }
    }
    for (const auto & line : view->tracings[jaw]->GetPolylines())
    {
      const std::string tooth = line.code.GetName();
      teeth.insert(tooth.substr(1));
      if (line.code.GetPosition() < 6)
      {
        // The edge is the crown's lowest part in the upper jaw and its highest in the lower one, where the tip is.
        const auto * tip = view->trueLandmarks->Find(tooth + (line.code.GetPosition() == 3 ? "_cusp" : "_tip"));
        ASSERT_NE(tip, nullptr) << tooth;
        double nearest = 1e9;
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        {
          nearest = std::min(nearest, DistanceToSegment(line.points[i], line.points[i + 1], tip->point));
        }
        EXPECT_LT(nearest, 1.5) << tooth;
      }
      else
      {
        // No tooth that is drawn reaches farther out.
        double out = line.points[0][0];
        for (const auto & p : line.points)
        {
          out = line.code.IsLeft() ? std::max(out, p[0]) : std::min(out, p[0]);
        }
        EXPECT_EQ(out, farthest[line.code.IsLeft() ? 1 : 0]) << tooth;
      }
    }
    EXPECT_EQ(teeth, (std::set<std::string>{ "R1", "R2", "R3", "R6", "L1", "L2", "L3", "L6" }));
  }
}

TEST(DentalPhantomFilm, ShowsTeethAndIsTheSameForAnyNumberOfThreads)
{
  itk::DentalPhantomModel model(itk::DentalPhantomParameters::Draw(2));
  itk::DentalPhantomFilm  film;
  // The source 1.5 m to the right, 4 px a mm: u = 4 x + 200, v = 400 - 4 z in the median plane.
  film.projection.matrix = { { 6000.0, 200.0, 0.0, 300000.0, 0.0, 400.0, -6000.0, 600000.0, 0.0, 1.0, 0.0, 1500.0 } };
  film.projection.source = { { 0.0, -1500.0, 0.0 } };
  film.projection.source[0] = -(200.0 * -1500.0 + 300000.0) / 6000.0;
  film.projection.source[2] = (400.0 * -1500.0 + 600000.0) / 6000.0;
  film.earRod = { { -4.0, 256.0 } };
  film.pixelSize = 0.25;
  film.size = { { 500, 600 } };
  const auto one = film.Render(model, 1);
  const auto many = film.Render(model, 5);
  EXPECT_EQ(one, many);
  const auto grey = [&](const std::array<double, 3> & p) {
    double u = 0.0;
    double v = 0.0;
    film.projection.Project(p.data(), u, v);
    double sum = 0.0;
    for (int i = -2; i <= 2; ++i)
    {
      for (int j = -2; j <= 2; ++j)
      {
        sum +=
          one[static_cast<std::size_t>(std::lround(v) + j) * 500 + static_cast<std::size_t>(std::lround(u) + i)] / 25.0;
      }
    }
    return sum;
  };
  const auto & molar = model.GetDentition().GetBody(1, 5);
  const auto   crown = molar.ToJaw({ { 0.0, 0.0, 4.0 } });
  const auto   root = molar.ToJaw({ { 0.2 * molar.width, 0.0, -6.0 } });
  const auto & incisor = model.GetDentition().GetBody(0, 0);
  // Before the lips, which stand 14 mm in front of the edge.
  auto air = incisor.ToJaw({ { 0.0, 0.0, incisor.height } });
  air = { { air[0] + 26.0, 0.0, -air[2] } };
  // Enamel over dentine over air: the grain of 2.5 is 0.5 in a mean of 25.
  EXPECT_GT(grey(crown), grey(root) + 5.0);
  EXPECT_GT(grey(root), grey(air) + 60.0);

  // Bone is uneven (trabeculae of 1.3 mm), soft tissue is not: how bent the grey values are over 4 px, without grain.
  film.noise = 0.0;
  film.blur = 0.0;
  const auto smooth = film.Render(model, 1);
  const auto bend = [&](double u, double v) {
    double sum = 0.0;
    for (int i = -10; i <= 10; ++i)
    {
      for (int j = -10; j <= 10; ++j)
      {
        const std::size_t at =
          static_cast<std::size_t>(std::lround(v) + j) * 500 + static_cast<std::size_t>(std::lround(u) + i);
        sum += std::abs(smooth[at - 4] - 2.0 * smooth[at] + smooth[at + 4]) / 441.0;
      }
    }
    return sum;
  };
  double     below[2];
  const auto apex = molar.ToJaw({ { 0.0, 0.0, -19.0 } });
  film.projection.Project(apex.data(), below[0], below[1]);
  // The nose, 104 mm before and 4 mm above the ear rods.
  EXPECT_GT(bend(below[0], below[1]), 2.0 * bend(-4.0 + 104.0 / 0.25, 256.0 - 4.0 / 0.25) + 0.5);
}
