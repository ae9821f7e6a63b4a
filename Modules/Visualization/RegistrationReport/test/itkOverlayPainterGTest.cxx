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
#include "itkOverlayPainter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
using Scene = itk::OverlayScene;
using Layout = itk::OverlayLayout;
using Colour = std::array<std::uint8_t, 3>;
using Point = Scene::PointType;

constexpr int    Width = 700;
constexpr int    Height = 450;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

Scene
MakeCanvas()
{
  Scene scene;
  scene.width = 200;
  scene.height = 120;
  scene.view = { 0.0, 199.0, 0.0, 119.0 };
  return scene;
}

void
AddContour(Scene & scene, Scene::RoleEnum role, const std::vector<Point> & points, bool closed = false)
{
  Scene::ContourType contour;
  contour.role = role;
  contour.strokes.push_back({ points, closed });
  scene.contours.push_back(contour);
}

class Picture
{
public:
  explicit Picture(const Scene & scene)
    : m_Layout(itk::LayOutOverlay(scene, Width, Height))
    , m_Pixels(itk::PaintOverlay(scene, Width, Height))
  {
    EXPECT_EQ(m_Pixels.size(), static_cast<std::size_t>(3 * Width * Height));
  }

  Colour
  At(int x, int y) const
  {
    const auto * p = m_Pixels.data() + 3 * (static_cast<std::size_t>(y) * Width + x);
    return { p[0], p[1], p[2] };
  }

  /** The colour at a place of the radiograph. */
  Colour
  AtIndex(double u, double v) const
  {
    const Point p = m_Layout.ToPicture({ u, v });
    return this->At(static_cast<int>(std::lround(p[0])), static_cast<int>(std::lround(p[1])));
  }

  /** Pixels of a box that differ from its first. */
  int
  CountMarks(int x0, int y0, int x1, int y1) const
  {
    int count = 0;
    for (int y = y0; y < y1; ++y)
    {
      for (int x = x0; x < x1; ++x)
      {
        count += this->At(x, y) != this->At(x0, y0);
      }
    }
    return count;
  }

  const Layout &
  GetLayout() const
  {
    return m_Layout;
  }
  const std::vector<std::uint8_t> &
  GetPixels() const
  {
    return m_Pixels;
  }

private:
  Layout                    m_Layout;
  std::vector<std::uint8_t> m_Pixels;
};

int
Difference(const Colour & a, const Colour & b)
{
  int difference = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    difference = std::max(difference, std::abs(int(a[i]) - int(b[i])));
  }
  return difference;
}
} // namespace

TEST(OverlayPainter, ContoursHaveTheirColoursWhereTheyLie)
{
  Scene scene = MakeCanvas();
  AddContour(scene, Scene::RoleEnum::Fixed, { { 20, 30 }, { 180, 30 } });
  AddContour(scene, Scene::RoleEnum::Moving, { { 20, 70 }, { 180, 70 } });
  const Picture picture(scene);
  for (const double u : { 25.0, 60.0, 100.0, 175.0 })
  {
    EXPECT_LE(Difference(picture.AtIndex(u, 30), itk::OverlayColour::Tracing), 2) << u;
    // 1.8 pixels wide: the pixel at its middle is covered by at least 0.9.
    EXPECT_LE(Difference(picture.AtIndex(u, 70), itk::OverlayColour::Silhouette), 30) << u;
    EXPECT_EQ(picture.AtIndex(u, 50), itk::OverlayColour::Background) << u;
  }
  EXPECT_EQ(picture.AtIndex(10, 30), itk::OverlayColour::Background) << "beyond the end";
}

TEST(OverlayPainter, AgreeingContoursAreBothSeen)
{
  Scene scene = MakeCanvas();
  AddContour(scene, Scene::RoleEnum::Fixed, { { 20, 30 }, { 180, 30 } });
  AddContour(scene, Scene::RoleEnum::Moving, { { 20, 30 }, { 180, 30 } });
  const Picture picture(scene);
  const Point   p = picture.GetLayout().ToPicture({ 100, 30 });
  const int     x = static_cast<int>(std::lround(p[0]));
  const int     y = static_cast<int>(std::lround(p[1]));
  int           tracing = 255;
  int           silhouette = 255;
  for (int dy = -3; dy <= 3; ++dy)
  {
    tracing = std::min(tracing, Difference(picture.At(x, y + dy), itk::OverlayColour::Tracing));
    silhouette = std::min(silhouette, Difference(picture.At(x, y + dy), itk::OverlayColour::Silhouette));
  }
  // The halo of the upper line darkens the lower one.
  EXPECT_LE(tracing, 110);
  EXPECT_LE(silhouette, 30);
}

TEST(OverlayPainter, OnlyClosedContoursHaveAClosingEdge)
{
  for (const bool closed : { false, true })
  {
    Scene scene = MakeCanvas();
    AddContour(scene, Scene::RoleEnum::Fixed, { { 40, 20 }, { 160, 20 }, { 160, 100 }, { 40, 100 } }, closed);
    const Picture picture(scene);
    EXPECT_EQ(picture.AtIndex(40, 60) != itk::OverlayColour::Background, closed);
  }
}

TEST(OverlayPainter, PointsThatAreNotFiniteBreakTheLine)
{
  Scene scene = MakeCanvas();
  AddContour(scene, Scene::RoleEnum::Fixed, { { 20, 30 }, { 60, 30 }, { NaN, 30 }, { 140, 30 }, { 180, 30 } });
  const Picture picture(scene);
  EXPECT_LE(Difference(picture.AtIndex(40, 30), itk::OverlayColour::Tracing), 2);
  EXPECT_LE(Difference(picture.AtIndex(160, 30), itk::OverlayColour::Tracing), 2);
  EXPECT_EQ(picture.AtIndex(100, 30), itk::OverlayColour::Background);
}

TEST(OverlayPainter, HugeCoordinatesAreClippedNotWrapped)
{
  Scene scene = MakeCanvas();
  AddContour(scene, Scene::RoleEnum::Fixed, { { -1e12, 60 }, { 1e12, 60 } });
  AddContour(scene, Scene::RoleEnum::Fixed, { { 1e300, 1e300 }, { 1e301, -1e300 } });
  AddContour(scene, Scene::RoleEnum::Fixed, { { 1e308, 0 }, { -1e308, 50 } });
  scene.landmarks.push_back({ "UR1_tip", { 1e200, 1e200 }, { 100, 90 }, 1e300 });
  const Picture picture(scene);
  EXPECT_LE(Difference(picture.AtIndex(30, 60), itk::OverlayColour::Tracing), 2);
  EXPECT_LE(Difference(picture.AtIndex(170, 60), itk::OverlayColour::Tracing), 2);
  EXPECT_EQ(picture.AtIndex(30, 20), itk::OverlayColour::Background);
}

TEST(OverlayPainter, LandmarksAndErrorsHaveTheirColours)
{
  Scene scene = MakeCanvas();
  scene.landmarks.push_back({ "UR1_tip", { 120, 60 }, { 90, 60 }, 0.0 });
  const Picture picture(scene);
  EXPECT_LE(Difference(picture.AtIndex(120, 60), itk::OverlayColour::Silhouette), 2);
  EXPECT_LE(Difference(picture.AtIndex(105, 60), itk::OverlayColour::Error), 20);
  const double ring = 6.0 / picture.GetLayout().scale[0];
  EXPECT_LE(Difference(picture.AtIndex(90, 60 - ring), itk::OverlayColour::Tracing), 60);
  EXPECT_EQ(picture.AtIndex(150, 100), itk::OverlayColour::Background);
}

TEST(OverlayPainter, RadiographLiesUnderTheSameCoordinates)
{
  Scene scene = MakeCanvas();
  scene.grey.assign(200 * 120, 40);
  for (int v = 50; v < 60; ++v)
  {
    for (int u = 80; u < 100; ++u)
    {
      scene.grey[static_cast<std::size_t>(v * 200 + u)] = 240;
    }
  }
  const Picture picture(scene);
  const Colour  dark = picture.AtIndex(20, 20);
  const Colour  bright = picture.AtIndex(89.5, 54.5);
  EXPECT_EQ(dark[0], dark[2]);
  EXPECT_NEAR(dark[0], 0.85 * 40, 2);
  EXPECT_NEAR(bright[0], 0.85 * 240, 2);
  // Half-way between the centres of the pixels 79 and 80: the interpolated edge.
  const Point  p = picture.GetLayout().ToPicture({ 79.5, 55 });
  const auto   y = static_cast<int>(std::lround(p[1]));
  const auto   x = static_cast<int>(std::floor(p[0]));
  const double value = picture.At(x, y)[0] + (p[0] - x) * (double(picture.At(x + 1, y)[0]) - picture.At(x, y)[0]);
  EXPECT_NEAR(value, 0.85 * 140, 25);
}

TEST(OverlayPainter, PixelsAreShownInTheirTrueProportions)
{
  Scene scene = MakeCanvas();
  scene.pixelSpacing = { 0.1, 0.2 };
  const Layout layout = itk::LayOutOverlay(scene, Width, Height);
  EXPECT_DOUBLE_EQ(layout.scale[1], 2.0 * layout.scale[0]);
}

TEST(OverlayPainter, ViewHoldsTracingAndLandmarksWithABorder)
{
  Scene scene;
  scene.width = 2000;
  scene.height = 2400;
  AddContour(scene, Scene::RoleEnum::Fixed, { { 900, 1000 }, { 1200, 1100 } });
  // A result far off must not shrink the teeth.
  AddContour(scene, Scene::RoleEnum::Moving, { { 100, 100 }, { 5000, 9000 } });
  scene.landmarks.push_back({ "UR1_tip", { 1800, 200 }, { 1210, 1120 }, 0.0 });
  const Layout layout = itk::LayOutOverlay(scene, Width, Height);
  for (const Point & p : { Point{ 900 - 60, 1000 }, Point{ 1210 + 60, 1120 + 60 }, Point{ 900, 1000 - 60 } })
  {
    const Point q = layout.ToPicture(p);
    EXPECT_GE(q[0], layout.view[0] - 1.0);
    EXPECT_LE(q[0], layout.view[0] + layout.view[2] + 1.0);
    EXPECT_GE(q[1], layout.view[1] - 1.0);
    EXPECT_LE(q[1], layout.view[1] + layout.view[3] + 1.0);
  }
  EXPECT_GT(layout.scale[0], 1.0) << "magnified";
  // Nothing beside the radiograph is shown while there is radiograph to show.
  EXPECT_GE(layout.first[0], -0.5);
  EXPECT_GE(layout.first[1], -0.5);
}

TEST(OverlayPainter, PrintsTitleBadgeTextAndErrors)
{
  Scene         scene = MakeCanvas();
  const Picture bare(scene);
  EXPECT_EQ(bare.CountMarks(2, 2, Width - 2, 28), 0);
  scene.title = "Upper jaw";
  scene.status = "suspect";
  const Picture titled(scene);
  EXPECT_GT(titled.CountMarks(2, 2, 200, 28), 100);
  EXPECT_GT(titled.CountMarks(Width - 150, 2, Width - 2, 28), 500);
  const int panel = static_cast<int>(bare.GetLayout().view[2]) + 2;
  const int top = static_cast<int>(bare.GetLayout().view[1]) + 2;
  EXPECT_EQ(bare.CountMarks(panel, top, Width - 2, 250), 0);
  scene.lines = { "Preset: robust" };
  EXPECT_GT(Picture(scene).CountMarks(panel, top, Width - 2, 60), 60);
  // One landmark with an error adds legend and table, and another figure is another picture.
  scene.lines.clear();
  scene.landmarks.push_back({ "UR1_tip", { 100, 60 }, { 103, 60 }, 0.0 });
  const Picture three(scene);
  EXPECT_GT(three.CountMarks(panel, top, Width - 2, 250), 300);
  scene.pixelSpacing = { 0.25, 0.25 };
  const Picture millimetres(scene);
  EXPECT_GT(millimetres.CountMarks(panel, top, Width - 2, 250), three.CountMarks(panel, top, Width - 2, 250))
    << "a column of millimetres";
}

TEST(OverlayPainter, ScaleBarHasItsLength)
{
  Scene scene = MakeCanvas();
  scene.pixelSpacing = { 0.25, 0.25 };
  const Picture picture(scene);
  // The longest run of white in the view's lower left corner is the bar: a round number of millimetres.
  const Layout & layout = picture.GetLayout();
  int            longest = 0;
  for (int y = Height - 60; y < Height; ++y)
  {
    int run = 0;
    for (int x = 0; x < static_cast<int>(layout.view[2]); ++x)
    {
      run = Difference(picture.At(x, y), { 255, 255, 255 }) < 12 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  const double millimetres = longest / layout.scale[0] * 0.25;
  EXPECT_NEAR(millimetres, 10.0, 0.5) << "50 mm are shown: a quarter of them, rounded down to 1, 2 or 5";
}

TEST(OverlayPainter, PaintsTheSameBitsAgain)
{
  Scene scene = MakeCanvas();
  scene.title = "Twice";
  AddContour(scene, Scene::RoleEnum::Secondary, { { 20, 30 }, { 180, 90 }, { 20, 100 } }, true);
  scene.landmarks.push_back({ "UR1_tip", { 100, 60 }, { 103, 60 }, 2.0 });
  EXPECT_EQ(Picture(scene).GetPixels(), Picture(scene).GetPixels());
}

TEST(OverlayPainter, EmptyAndBrokenScenesArePainted)
{
  EXPECT_NO_THROW(Picture(Scene{}));
  Scene scene;
  AddContour(scene, Scene::RoleEnum::Fixed, {});
  AddContour(scene, Scene::RoleEnum::Moving, { { NaN, NaN } });
  AddContour(scene, Scene::RoleEnum::Moving, { { 5, 5 } });
  scene.landmarks.push_back({ "", { NaN, 1 }, { 1, NaN }, NaN });
  scene.landmarks.emplace_back();
  scene.pixelSpacing = { NaN, -1.0 };
  scene.margin = NaN;
  scene.view = { NaN, 3, 1, 0 };
  // Not UTF-8: overlong, cut off, surrogate, control.
  scene.title = "bad \xff\xc0\xaf \xe2\x82 \xed\xa0\x80 \x01 text";
  scene.status = "\xf5";
  scene.lines = { "", std::string(5000, 'x'), "\xe2\x82", std::string("nul\0nul", 7) };
  EXPECT_NO_THROW(Picture{ scene });
  // Everything at one place, and at places far apart.
  scene = Scene();
  for (int i = 0; i < 40; ++i)
  {
    scene.landmarks.push_back({ "UR1_tip", { 7.0, 7.0 }, { 7.0, 7.0 }, 1.0 });
  }
  EXPECT_NO_THROW(Picture{ scene });
  scene.landmarks[3].reference = { -1e15, 1e15 };
  EXPECT_NO_THROW(Picture{ scene });
}

TEST(OverlayPainter, RefusesSizesThatDoNotFit)
{
  Scene scene = MakeCanvas();
  EXPECT_THROW(itk::PaintOverlay(scene, 100, 100), std::invalid_argument);
  EXPECT_THROW(itk::PaintOverlay(scene, 100000, 400), std::invalid_argument);
  scene.grey.assign(10, 0);
  EXPECT_THROW(itk::PaintOverlay(scene, Width, Height), std::invalid_argument);
  EXPECT_NO_THROW(itk::PaintOverlay(MakeCanvas(), 320, 240));
}

TEST(OverlayPainter, ColoursAreToldApartWithAnyColourVision)
{
  // Machado, Oliveira, Fernandes 2009, severity 1: protanopia, deuteranopia, tritanopia; applied to linear RGB.
  const double matrices[4][9] = {
    { 1, 0, 0, 0, 1, 0, 0, 0, 1 },
    { 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998 },
    { 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881 },
    { 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900 }
  };
  const Colour colours[] = { itk::OverlayColour::Tracing, itk::OverlayColour::Silhouette, itk::OverlayColour::Error };
  for (const auto & matrix : matrices)
  {
    std::array<std::array<double, 3>, 3> seen;
    for (unsigned int c = 0; c < 3; ++c)
    {
      double linear[3];
      for (unsigned int i = 0; i < 3; ++i)
      {
        linear[i] = std::pow(colours[c][i] / 255.0, 2.2);
      }
      for (unsigned int i = 0; i < 3; ++i)
      {
        const double value = matrix[3 * i] * linear[0] + matrix[3 * i + 1] * linear[1] + matrix[3 * i + 2] * linear[2];
        seen[c][i] = 255.0 * std::pow(std::clamp(value, 0.0, 1.0), 1.0 / 2.2);
      }
    }
    for (unsigned int a = 0; a < 3; ++a)
    {
      for (unsigned int b = 0; b < a; ++b)
      {
        const double distance = std::hypot(seen[a][0] - seen[b][0], seen[a][1] - seen[b][1], seen[a][2] - seen[b][2]);
        EXPECT_GT(distance, 60.0) << a << " and " << b;
      }
    }
  }
}
