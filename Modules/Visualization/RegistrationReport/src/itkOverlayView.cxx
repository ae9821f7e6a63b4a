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
#include "itkOverlayView.h"

#include "itkOverlayFrame.h"
#include "itkOverlayPainter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace OverlayDrawing
{
namespace
{
using RoleEnum = OverlayScene::RoleEnum;

/** A path of more segments than a person draws is drawn in pieces: the library looks for all crossings of a path's
 * segments, which of a scribble of 10,000 take a minute, and of a million hours. */
constexpr std::size_t LongestPath = 2000;
constexpr std::size_t PieceOfPath = 50;
/** Pixels along all contours of a role; outlines of all teeth have a twentieth. The lines of as many cover a picture,
 * and what would be drawn over them takes minutes. */
constexpr double LongestInk = 1e6;

/** Draws the strokes of a contour, clipped: the library's coordinates are of 24 bits. \param ink  how long all is that
 * was drawn so far */
void
StrokeContour(Canvas &                          canvas,
              const OverlayScene::ContourType & contour,
              const Mapping &                   map,
              const Box &                       box,
              const Colour &                    colour,
              double                            alpha,
              double &                          ink)
{
  std::size_t total = 0;
  for (const OverlayScene::StrokeType & stroke : contour.strokes)
  {
    total += stroke.points.size();
  }
  const bool isInPieces = total > LongestPath;
  if (isInPieces)
  {
    // Opaque first and all of it made lighter then, so that where pieces overlap is not to be seen.
    cairo_push_group(canvas.Get());
  }
  canvas.SetColour(colour, isInPieces ? 1.0 : alpha);
  std::size_t segments = 0;
  cairo_new_path(canvas.Get());
  for (const OverlayScene::StrokeType & stroke : contour.strokes)
  {
    const std::size_t count = stroke.points.size();
    PixelPoint        pen{ -1e9, -1e9 };
    for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < count; ++i)
    {
      const PixelPoint & from = stroke.points[i];
      const PixelPoint & to = stroke.points[(i + 1) % count];
      if (!IsFinite(from) || !IsFinite(to))
      {
        continue;
      }
      PixelPoint a = map(from);
      PixelPoint b = map(to);
      if (ink > LongestInk || !ClipSegment(a, b, box))
      {
        continue;
      }
      ink += std::hypot(b[0] - a[0], b[1] - a[1]);
      if (isInPieces && segments == PieceOfPath)
      {
        cairo_stroke(canvas.Get());
        segments = 0;
        // Ends and corners are round both, so that a corner between two pieces is one.
        pen = { -1e9, -1e9 };
      }
      if (a != pen)
      {
        cairo_move_to(canvas.Get(), a[0], a[1]);
      }
      cairo_line_to(canvas.Get(), b[0], b[1]);
      ++segments;
      pen = b;
    }
  }
  cairo_stroke(canvas.Get());
  if (isInPieces)
  {
    cairo_pop_group_to_source(canvas.Get());
    cairo_paint_with_alpha(canvas.Get(), alpha);
  }
}

/** Points without a neighbour. */
void
DotLonePoints(Canvas &                          canvas,
              const OverlayScene::ContourType & contour,
              const Mapping &                   map,
              const Box &                       box,
              double                            radius,
              const Colour &                    colour)
{
  for (const OverlayScene::StrokeType & stroke : contour.strokes)
  {
    if (stroke.points.size() == 1 && IsFinite(stroke.points[0]) && box.Holds(map(stroke.points[0])))
    {
      canvas.Dot(map(stroke.points[0]), radius + 1.0, Black, 0.5);
      canvas.Dot(map(stroke.points[0]), radius, colour);
    }
  }
}

/** Largest of 1, 2, 5 x 10^n that is not above the value. */
double
RoundLength(double value)
{
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double mantissa = value / power;
  return power * (mantissa >= 5.0 ? 5.0 : mantissa >= 2.0 ? 2.0 : 1.0);
}
} // namespace

PenType
PenOf(OverlayScene::RoleEnum role)
{
  switch (role)
  {
    case RoleEnum::Fixed:
      return { OverlayColour::Tracing, 4.0, 1.0 };
    case RoleEnum::Moving:
      return { OverlayColour::Silhouette, 1.8, 1.0 };
    default:
      return { OverlayColour::Secondary, 1.4, 0.9 };
  }
}

void
DrawContours(Canvas & canvas, const OverlayScene & scene, const Mapping & map, const Box & box, double thickness)
{
  for (const RoleEnum role : { RoleEnum::Secondary, RoleEnum::Fixed, RoleEnum::Moving })
  {
    const PenType pen = PenOf(role);
    for (const bool halo : { true, false })
    {
      double ink = 0.0;
      for (const OverlayScene::ContourType & contour : scene.contours)
      {
        if (contour.role != role)
        {
          continue;
        }
        cairo_set_line_width(canvas.Get(), thickness * (pen.width + (halo ? 1.6 : 0.0)));
        StrokeContour(canvas, contour, map, box.Grown(64.0), halo ? Black : pen.colour, halo ? 0.4 : pen.alpha, ink);
        if (!halo)
        {
          DotLonePoints(canvas, contour, map, box, thickness * 2.5, pen.colour);
        }
      }
    }
  }
}

void
DrawRadiograph(Canvas & canvas, cairo_surface_t * radiograph, const OverlayScene & scene, const Mapping & map)
{
  const PixelPoint corner = map({ -0.5, -0.5 });
  const Box        frame{ corner[0], corner[1], map.scale[0] * scene.width, map.scale[1] * scene.height };
  if (radiograph != nullptr)
  {
    cairo_save(canvas.Get());
    cairo_translate(canvas.Get(), frame.x, frame.y);
    cairo_scale(canvas.Get(), map.scale[0], map.scale[1]);
    cairo_set_source_surface(canvas.Get(), radiograph, 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(canvas.Get()), CAIRO_FILTER_GOOD);
    cairo_paint(canvas.Get());
    cairo_restore(canvas.Get());
  }
  else if (scene.width > 0 && scene.height > 0)
  {
    canvas.StrokeBox(frame, FaintColour, 1.0);
  }
}

std::string
LandmarkText(const std::string & name)
{
  std::string text = Sanitize(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

double
LandmarkErrorInPixels(const OverlayScene::LandmarkType & landmark)
{
  return IsFinite(landmark.predicted) && IsFinite(landmark.reference) ? Distance(landmark.predicted, landmark.reference)
                                                                      : OverlayScene::LandmarkType::unknown;
}

void
DrawLandmarks(Canvas & canvas, const OverlayScene & scene, const Mapping & map, const Box & box, double font)
{
  // Error vectors first, so that marks lie on top.
  for (const auto & landmark : scene.landmarks)
  {
    if (IsFinite(landmark.predicted) && IsFinite(landmark.reference))
    {
      PixelPoint a = map(landmark.reference);
      PixelPoint b = map(landmark.predicted);
      if (ClipSegment(a, b, box.Grown(64.0)))
      {
        canvas.Line(a, b, Black, 4.5, 0.5);
        canvas.Line(a, b, OverlayColour::Error, 2.2);
      }
    }
  }
  std::vector<PixelPoint> marks;
  for (const auto & landmark : scene.landmarks)
  {
    if (IsFinite(landmark.reference) && box.Holds(map(landmark.reference)))
    {
      const PixelPoint p = map(landmark.reference);
      canvas.Ring(p, 6.0, Black, 4.0, 0.5);
      canvas.Ring(p, 6.0, OverlayColour::Tracing, 2.0);
      marks.push_back(p);
    }
    if (IsFinite(landmark.predicted) && box.Holds(map(landmark.predicted)))
    {
      const PixelPoint p = map(landmark.predicted);
      if (landmark.sigma > 0.0 && std::isfinite(landmark.sigma) && landmark.sigma * map.scale[0] < box.width)
      {
        // 95 % of a round normal distribution in the plane.
        const double dashes[2] = { 4.0, 5.0 };
        cairo_set_dash(canvas.Get(), dashes, 2, 0.0);
        canvas.Ring(p, 2.448 * landmark.sigma * map.scale[0], OverlayColour::Silhouette, 1.2, 0.9);
        cairo_set_dash(canvas.Get(), nullptr, 0, 0.0);
      }
      canvas.Dot(p, 4.6, Black, 0.7);
      canvas.Dot(p, 3.2, OverlayColour::Silhouette);
      marks.push_back(p);
    }
  }
  // Labels: of all places around the mark the one that hides least.
  std::vector<PixelPoint> contourPoints;
  for (const auto & contour : scene.contours)
  {
    for (const auto & stroke : contour.strokes)
    {
      for (const PixelPoint & point : stroke.points)
      {
        if (contour.role != RoleEnum::Secondary && IsFinite(point) && box.Holds(map(point)))
        {
          contourPoints.push_back(map(point));
        }
      }
    }
  }
  std::vector<Box> labels;
  canvas.SetFont(font, true);
  for (const auto & landmark : scene.landmarks)
  {
    const PixelPoint & anchorIndex = IsFinite(landmark.predicted) ? landmark.predicted : landmark.reference;
    if (!IsFinite(anchorIndex) || !box.Holds(map(anchorIndex)))
    {
      continue;
    }
    const PixelPoint anchor = map(anchorIndex);
    std::string      text = LandmarkText(landmark.name);
    const double     error = LandmarkErrorInPixels(landmark);
    if (std::isfinite(error))
    {
      text += Format("  %.1f px", error);
    }
    text = canvas.Fit(text, 0.3 * box.width);
    Box best;
    best.width = canvas.TextWidth(text) + 8.0;
    best.height = font + 6.0;
    double bestCost = std::numeric_limits<double>::max();
    Box    candidate = best;
    for (const double radius : { 18.0, 30.0, 46.0, 66.0, 90.0, 120.0 })
    {
      for (int direction = 0; direction < 16; ++direction)
      {
        const double angle = M_PI * direction / 8.0;
        candidate.x = anchor[0] + (radius + 0.5 * best.width - 10.0) * std::cos(angle) - 0.5 * best.width;
        candidate.y = anchor[1] + radius * std::sin(angle) - 0.5 * best.height;
        double cost = 0.08 * radius;
        if (candidate.x < box.x + 2.0 || candidate.y < box.y + 2.0 ||
            candidate.x + best.width > box.x + box.width - 2.0 || candidate.y + best.height > box.y + box.height - 2.0)
        {
          cost += 1000.0;
        }
        for (const Box & label : labels)
        {
          cost += label.Overlaps(candidate.Grown(2.0)) ? 100.0 : 0.0;
        }
        for (const PixelPoint & mark : marks)
        {
          cost += candidate.Grown(6.0).Holds(mark) ? 20.0 : 0.0;
        }
        for (const PixelPoint & point : contourPoints)
        {
          cost += candidate.Grown(2.0).Holds(point) ? 1.0 : 0.0;
        }
        if (cost < bestCost)
        {
          bestCost = cost;
          best = candidate;
        }
      }
    }
    labels.push_back(best);
    const PixelPoint middle{ best.x + 0.5 * best.width, best.y + 0.5 * best.height };
    PixelPoint       touch{ std::clamp(anchor[0], best.x, best.x + best.width),
                      std::clamp(anchor[1], best.y, best.y + best.height) };
    if (Distance(touch, anchor) > 10.0)
    {
      const double     length = Distance(touch, anchor);
      const PixelPoint start{ anchor[0] + 6.0 * (touch[0] - anchor[0]) / length,
                              anchor[1] + 6.0 * (touch[1] - anchor[1]) / length };
      canvas.Line(start, touch, Black, 3.0, 0.5);
      canvas.Line(start, touch, White, 1.2);
    }
    canvas.FillBox(best, Black, 0.6, 3.0);
    canvas.Text(text, best.x + 4.0, middle[1] + 0.36 * font, White);
  }
}

void
DrawScaleBar(Canvas & canvas, const OverlayScene & scene, const Mapping & map, const Box & box, double font)
{
  const bool   known = KnowsSpacing(scene);
  const double unit = known ? map.scale[0] / scene.pixelSpacing[0] : map.scale[0];
  const double length = RoundLength(0.25 * box.width / unit);
  if (!std::isfinite(length) || !(length > 0.0))
  {
    return;
  }
  const std::string text = Format("%g ", length) + (known ? "mm in the detector plane" : "px (pixel spacing unknown)");
  canvas.SetFont(font);
  const double width = std::max(length * unit, canvas.TextWidth(text));
  const Box    plate{ box.x + 12.0, box.y + box.height - font - 34.0, width + 20.0, font + 22.0 };
  canvas.FillBox(plate, Black, 0.55, 4.0);
  const double y = plate.y + plate.height - 10.0;
  const double x = plate.x + 10.0;
  canvas.Line({ x, y }, { x + length * unit, y }, White, 2.0);
  canvas.Line({ x, y - 4.0 }, { x, y + 4.0 }, White, 2.0);
  canvas.Line({ x + length * unit, y - 4.0 }, { x + length * unit, y + 4.0 }, White, 2.0);
  canvas.Text(text, x, plate.y + font + 2.0, White);
}
} // namespace OverlayDrawing
} // namespace itk
