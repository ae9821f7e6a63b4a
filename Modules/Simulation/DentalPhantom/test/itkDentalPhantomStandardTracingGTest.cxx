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
#include "itkDentalPhantomTestCase.h"

#include <gtest/gtest.h>

#include <map>

using namespace DentalPhantomTestCase;

namespace
{
using TracingType = itk::DentalPhantomStandardTracing;
using PixelType = TracingType::PixelType;

const std::string NoErrors =
  "\"drift_px\": 0, \"jitter_px\": 0, \"tooth_along_mm\": 0, \"tooth_across_mm\": 0, \"tooth_turn_deg\": 0, "
  "\"tooth_scale\": 0, \"reader_bias_mm\": 0, \"gross_probability\": 0, \"palatal_mm\": 0";

double
DistanceTo(const std::vector<PixelType> & closed, const PixelType & p)
{
  double best = 1e9;
  for (std::size_t i = 0; i < closed.size(); ++i)
  {
    const auto & a = closed[i];
    const auto & b = closed[(i + 1) % closed.size()];
    const double x = b[0] - a[0];
    const double y = b[1] - a[1];
    const double t =
      std::min(1.0, std::max(0.0, ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / std::max(x * x + y * y, 1e-12)));
    best = std::min(best, std::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y));
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
  std::vector<std::vector<PixelType>> outlines;
  std::vector<double>                 sizes;
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5 })
  {
    const auto source =
      Make(seed, "{\"level\": \"standard\", \"tracing\": {\"template_probability\": 1, " + NoErrors + "}}", 6000);
    const auto & outline = source->GetStandardTracing()->GetOutlines(0)[0];
    EXPECT_TRUE(outline.isTemplate);
    sizes.push_back(Length(outline.exact, source->GetNominalGeometry()->GetPixelSpacing()[0]));
    const std::string sides[] = { "R", "L" };
    double            nearest = 1e9;
    for (const auto & side : sides)
    {
      nearest = std::min(nearest, DistanceTo(outline.exact, Pixel(source, "U" + side + "1_tip")));
    }
    EXPECT_LT(nearest, 1.0) << seed;
  }
  std::sort(sizes.begin(), sizes.end());
  // Two sets 5 % apart, the machine's magnification another 3 %; patients' incisors differ by three times that.
  EXPECT_LT(sizes.back() / sizes.front(), 1.1);
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
  for (const bool same : { true, false })
  {
    const auto source =
      Make(5,
           std::string("{\"frontal\": {\"given\": true, \"same_head_position\": ") + (same ? "true" : "false") + "}}",
           8000);
    const auto * view = source->GetFrontalView();
    ASSERT_NE(view, nullptr);
    const auto & acquisition = source->GetAcquisition();
    EXPECT_EQ(view->trueLandmarks->GetNumberOfLandmarks(), 32u);
    EXPECT_EQ(view->landmarks->GetNumberOfLandmarks(), 12u);
    double square = 0.0;
    for (const auto & landmark : view->landmarks->GetLandmarks())
    {
      const auto * exact = view->trueLandmarks->Find(landmark.name);
      square += (landmark.point - exact->point).GetSquaredNorm() / 24.0;
      // The patient's left is on the right.
      EXPECT_EQ(exact->point[0] > view->principalPoint[0] + 3.0 * acquisition.yaw * 300.0,
                landmark.tooth.IsLeft() || false)
        << landmark.name;
    }
    // 0.5 mm an axis in the detector, 24 draws: 15 %, three times that.
    EXPECT_NEAR(std::sqrt(square) * view->spacing[0], 0.5, 0.23);
    if (same)
    {
      // views.md: depth = S + x, u = pp + m y / sp, v = pp - m z / sp, with the lateral view's own pose.
      const auto & geometry = *source->GetTrueGeometry(0);
      for (const auto & landmark : source->GetLandmarks3D(0)->GetLandmarks())
      {
        const auto   c = geometry.TransformToCephalostat(landmark.point);
        double       uv[2];
        const double depth = view->projections[0].Project(landmark.point.GetDataPointer(), uv[0], uv[1]);
        EXPECT_NEAR(depth, acquisition.trueSourceToMidsagittal + c[0], 1e-6);
        const double m = (uv[0] - view->principalPoint[0]) / c[1];
        EXPECT_NEAR(view->principalPoint[1] - m * c[2], uv[1], 1e-6);
      }
    }
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
}
