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
#include "itkOverlayPanel.h"

#include "itkOverlayFrame.h"
#include "itkOverlayPainter.h"
#include "itkOverlayView.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace OverlayDrawing
{
namespace
{
double
LandmarkErrorInMillimetres(const OverlayScene & scene, const OverlayScene::LandmarkType & landmark)
{
  return std::hypot((landmark.predicted[0] - landmark.reference[0]) * scene.pixelSpacing[0],
                    (landmark.predicted[1] - landmark.reference[1]) * scene.pixelSpacing[1]);
}

struct BadgeType
{
  Colour      colour;
  Colour      text;
  std::string label;
};

BadgeType
BadgeOf(const std::string & status)
{
  if (status == "ok")
  {
    return { { 0, 114, 178 }, White, "✔ ok" };
  }
  if (status == "suspect")
  {
    return { { 230, 159, 0 }, Black, "! suspect" };
  }
  if (status == "failed")
  {
    return { { 213, 94, 0 }, White, "✘ failed" };
  }
  return { { 80, 86, 96 }, White, Sanitize(status) };
}
} // namespace

void
DrawHeader(Canvas & canvas, const OverlayScene & scene, const Box & box, double font)
{
  canvas.FillBox(box, PanelColour);
  double right = box.x + box.width - 14.0;
  if (!scene.status.empty())
  {
    const BadgeType badge = BadgeOf(scene.status);
    canvas.SetFont(font, true);
    const std::string label = canvas.Fit(badge.label, 0.4 * box.width);
    const double      width = canvas.TextWidth(label) + 24.0;
    const Box         plate{ right - width, box.y + 0.5 * (box.height - font - 14.0), width, font + 14.0 };
    canvas.FillBox(plate, badge.colour, 1.0, 6.0);
    canvas.Text(label, plate.x + 12.0, plate.y + 0.5 * plate.height + 0.36 * font, badge.text);
    right = plate.x - 14.0;
  }
  canvas.SetFont(1.25 * font, true);
  canvas.Text(canvas.Fit(Sanitize(scene.title), right - box.x - 16.0),
              box.x + 16.0,
              box.y + 0.5 * box.height + 0.45 * font,
              TextColour);
}

/** \return the first free row. */
double
DrawLegend(Canvas & canvas, const OverlayScene & scene, const Box & box, double font)
{
  const double row = 1.65 * font;
  double       y = box.y;
  const double sample = 34.0;
  const auto   entry = [&](const std::string & text, const auto & draw) {
    if (y + row > box.y + box.height)
    {
      return;
    }
    draw(PixelPoint{ box.x, y + 0.5 * row }, PixelPoint{ box.x + sample, y + 0.5 * row });
    canvas.SetFont(font);
    canvas.Text(canvas.Fit(Sanitize(text), box.width - sample - 12.0),
                box.x + sample + 12.0,
                y + 0.5 * row + 0.36 * font,
                TextColour);
    y += row;
  };
  for (const auto & contour : scene.contours)
  {
    if (contour.label.empty())
    {
      continue;
    }
    const PenType pen = PenOf(contour.role);
    entry(contour.label,
          [&](const PixelPoint & a, const PixelPoint & b) { canvas.Line(a, b, pen.colour, pen.width, pen.alpha); });
  }
  const auto any = [&scene](const auto & test) {
    return std::any_of(scene.landmarks.begin(), scene.landmarks.end(), test);
  };
  const auto middle = [](const PixelPoint & a, const PixelPoint & b) {
    return PixelPoint{ 0.5 * (a[0] + b[0]), a[1] };
  };
  if (any([](const auto & l) { return IsFinite(l.predicted); }))
  {
    entry("Landmark of the scan, aligned", [&](const PixelPoint & a, const PixelPoint & b) {
      canvas.Dot(middle(a, b), 4.6, Black, 0.7);
      canvas.Dot(middle(a, b), 3.2, OverlayColour::Silhouette);
    });
  }
  if (any([](const auto & l) { return IsFinite(l.predicted) && l.sigma > 0.0; }))
  {
    entry("95 % region of a landmark", [&](const PixelPoint & a, const PixelPoint & b) {
      const double dashes[2] = { 4.0, 5.0 };
      cairo_set_dash(canvas.Get(), dashes, 2, 0.0);
      canvas.Ring(middle(a, b), 0.55 * font, OverlayColour::Silhouette, 1.2, 0.9);
      cairo_set_dash(canvas.Get(), nullptr, 0, 0.0);
    });
  }
  if (any([](const auto & l) { return IsFinite(l.reference); }))
  {
    entry("Landmark on the radiograph", [&](const PixelPoint & a, const PixelPoint & b) {
      canvas.Ring(middle(a, b), 6.0, OverlayColour::Tracing, 2.0);
    });
  }
  if (any([](const auto & l) { return std::isfinite(LandmarkErrorInPixels(l)); }))
  {
    entry("Error", [&](const PixelPoint & a, const PixelPoint & b) { canvas.Line(a, b, OverlayColour::Error, 2.2); });
  }
  return y;
}

void
DrawTable(Canvas & canvas, const OverlayScene & scene, const Box & box, double font)
{
  std::vector<const OverlayScene::LandmarkType *> rows;
  for (const auto & landmark : scene.landmarks)
  {
    if (std::isfinite(LandmarkErrorInPixels(landmark)))
    {
      rows.push_back(&landmark);
    }
  }
  if (rows.empty())
  {
    return;
  }
  const bool   millimetres = KnowsSpacing(scene);
  const double wanted = static_cast<double>(rows.size()) + 2.0;
  const double row = std::clamp(box.height / wanted, 1.15 * 10.0, 1.6 * font);
  const double size = std::min(font, row / 1.25);
  const auto   fitting = static_cast<std::size_t>(std::max(0.0, std::floor(box.height / row + 1e-9)));
  if (fitting < 3)
  {
    return;
  }
  const double right = box.x + box.width;
  const double pixelColumn = millimetres ? right - 5.0 * size : right;
  double       y = box.y;
  const auto   line =
    [&](const std::string & name, const std::string & px, const std::string & mm, bool bold, const Colour & colour) {
      canvas.SetFont(size, bold);
      const double base = y + 0.5 * row + 0.36 * size;
      canvas.Text(canvas.Fit(name, pixelColumn - box.x - 5.0 * size), box.x, base, colour);
      canvas.Text(px, pixelColumn, base, colour, true);
      if (millimetres)
      {
        canvas.Text(mm, right, base, colour, true);
      }
      y += row;
    };
  line("Landmark error", "px", "mm", false, FaintColour);
  const std::size_t shown = rows.size() + 2 <= fitting ? rows.size() : fitting - 3;
  double            sum[2] = { 0.0, 0.0 };
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const double px = LandmarkErrorInPixels(*rows[i]);
    const double mm = LandmarkErrorInMillimetres(scene, *rows[i]);
    sum[0] += px;
    sum[1] += mm;
    if (i < shown)
    {
      line(LandmarkText(rows[i]->name), Format("%.2f", px), Format("%.2f", mm), false, TextColour);
    }
  }
  if (shown < rows.size())
  {
    line("… and " + std::to_string(rows.size() - shown) + " more", "", "", false, FaintColour);
  }
  const auto count = static_cast<double>(rows.size());
  canvas.Line({ box.x, y }, { right, y }, FaintColour, 1.0);
  line("Mean", Format("%.2f", sum[0] / count), Format("%.2f", sum[1] / count), true, TextColour);
}
} // namespace OverlayDrawing
} // namespace itk
