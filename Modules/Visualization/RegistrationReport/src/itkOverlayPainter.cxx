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

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
using Point = OverlayScene::PointType;
using Colour = std::array<std::uint8_t, 3>;
using RoleEnum = OverlayScene::RoleEnum;

constexpr Colour PanelColour{ 34, 37, 43 };
constexpr Colour TextColour{ 228, 230, 233 };
constexpr Colour FaintColour{ 150, 155, 163 };
constexpr Colour White{ 255, 255, 255 };
constexpr Colour Black{ 0, 0, 0 };
/** The radiograph is shown a little darker than it is, so that the overlay stands out on bright crowns. */
constexpr double RadiographGain = 0.85;

struct Box
{
  double x{ 0.0 };
  double y{ 0.0 };
  double width{ 0.0 };
  double height{ 0.0 };

  bool
  Holds(const Point & p) const
  {
    return p[0] >= x && p[0] <= x + width && p[1] >= y && p[1] <= y + height;
  }
  bool
  Overlaps(const Box & other) const
  {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height && other.y < y + height;
  }
  Box
  Grown(double by) const
  {
    return { x - by, y - by, width + 2.0 * by, height + 2.0 * by };
  }
};

bool
IsFinite(const Point & p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]);
}

double
Distance(const Point & a, const Point & b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

std::string
Format(const char * format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

/** Bytes that are no UTF-8 would put the drawing library into its error state: "?" instead. */
std::string
Sanitize(const std::string & text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size();)
  {
    const auto  c = static_cast<unsigned char>(text[i]);
    std::size_t length = 1;
    if (c >= 0xc2 && c < 0xe0)
    {
      length = 2;
    }
    else if (c >= 0xe0 && c < 0xf0)
    {
      length = 3;
    }
    else if (c >= 0xf0 && c < 0xf5)
    {
      length = 4;
    }
    bool good = (c >= 0x20 && c < 0x80) || length > 1;
    good = good && i + length <= text.size();
    for (std::size_t k = 1; good && k < length; ++k)
    {
      good = (static_cast<unsigned char>(text[i + k]) & 0xc0) == 0x80;
    }
    if (good && length > 2)
    {
      // Overlong forms, surrogates and what is above U+10FFFF.
      const auto second = static_cast<unsigned char>(text[i + 1]);
      good = !((c == 0xe0 && second < 0xa0) || (c == 0xed && second >= 0xa0) || (c == 0xf0 && second < 0x90) ||
               (c == 0xf4 && second >= 0x90));
    }
    if (good)
    {
      result.append(text, i, length);
      i += length;
    }
    else
    {
      result += '?';
      ++i;
    }
  }
  return result;
}

/** Cairo with the few words that the overlay needs. */
class Canvas
{
public:
  Canvas(int width, int height)
    : m_Width(width)
    , m_Height(height)
    , m_Surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy)
    , m_Context(cairo_create(m_Surface.get()), cairo_destroy)
  {
    this->Check();
    const std::unique_ptr<cairo_font_options_t, void (*)(cairo_font_options_t *)> options(cairo_font_options_create(),
                                                                                          cairo_font_options_destroy);
    // Not the desktop's settings: the picture is the same everywhere.
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(m_Context.get(), options.get());
    cairo_set_line_join(m_Context.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(m_Context.get(), CAIRO_LINE_CAP_ROUND);
  }

  cairo_t *
  Get()
  {
    return m_Context.get();
  }

  void
  Check()
  {
    const cairo_status_t status = cairo_status(m_Context.get());
    if (status != CAIRO_STATUS_SUCCESS)
    {
      throw std::runtime_error(std::string("The overlay cannot be drawn: ") + cairo_status_to_string(status));
    }
  }

  void
  SetColour(const Colour & colour, double alpha = 1.0)
  {
    cairo_set_source_rgba(this->Get(), colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0, alpha);
  }

  void
  FillBox(const Box & box, const Colour & colour, double alpha = 1.0, double radius = 0.0)
  {
    if (radius > 0.0)
    {
      const double right = box.x + box.width - radius;
      const double bottom = box.y + box.height - radius;
      cairo_new_sub_path(this->Get());
      cairo_arc(this->Get(), right, box.y + radius, radius, -M_PI_2, 0.0);
      cairo_arc(this->Get(), right, bottom, radius, 0.0, M_PI_2);
      cairo_arc(this->Get(), box.x + radius, bottom, radius, M_PI_2, M_PI);
      cairo_arc(this->Get(), box.x + radius, box.y + radius, radius, M_PI, 1.5 * M_PI);
      cairo_close_path(this->Get());
    }
    else
    {
      cairo_rectangle(this->Get(), box.x, box.y, box.width, box.height);
    }
    this->SetColour(colour, alpha);
    cairo_fill(this->Get());
  }

  void
  StrokeBox(const Box & box, const Colour & colour, double width)
  {
    cairo_rectangle(this->Get(), box.x, box.y, box.width, box.height);
    this->SetColour(colour);
    cairo_set_line_width(this->Get(), width);
    cairo_stroke(this->Get());
  }

  void
  Line(const Point & from, const Point & to, const Colour & colour, double width, double alpha = 1.0)
  {
    cairo_move_to(this->Get(), from[0], from[1]);
    cairo_line_to(this->Get(), to[0], to[1]);
    this->SetColour(colour, alpha);
    cairo_set_line_width(this->Get(), width);
    cairo_stroke(this->Get());
  }

  void
  Ring(const Point & centre, double radius, const Colour & colour, double width, double alpha = 1.0)
  {
    cairo_new_sub_path(this->Get());
    cairo_arc(this->Get(), centre[0], centre[1], radius, 0.0, 2.0 * M_PI);
    this->SetColour(colour, alpha);
    cairo_set_line_width(this->Get(), width);
    cairo_stroke(this->Get());
  }

  void
  Dot(const Point & centre, double radius, const Colour & colour, double alpha = 1.0)
  {
    cairo_new_sub_path(this->Get());
    cairo_arc(this->Get(), centre[0], centre[1], radius, 0.0, 2.0 * M_PI);
    this->SetColour(colour, alpha);
    cairo_fill(this->Get());
  }

  void
  SetFont(double size, bool bold = false)
  {
    cairo_select_font_face(
      this->Get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(this->Get(), size);
  }

  double
  TextWidth(const std::string & text)
  {
    cairo_text_extents_t extents;
    cairo_text_extents(this->Get(), text.c_str(), &extents);
    return extents.x_advance;
  }

  /** The baseline's left end; with `right` its right end. */
  void
  Text(const std::string & text, double x, double y, const Colour & colour, bool right = false)
  {
    cairo_move_to(this->Get(), right ? x - this->TextWidth(text) : x, y);
    this->SetColour(colour);
    cairo_show_text(this->Get(), text.c_str());
    cairo_new_path(this->Get());
  }

  /** The text, or as much of its beginning as fits. */
  std::string
  Fit(const std::string & text, double width)
  {
    if (this->TextWidth(text) <= width)
    {
      return text;
    }
    std::string cut = text;
    while (!cut.empty() && this->TextWidth(cut + "…") > width)
    {
      // Not through a character.
      while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xc0) == 0x80)
      {
        cut.pop_back();
      }
      if (!cut.empty())
      {
        cut.pop_back();
      }
    }
    return cut + "…";
  }

  std::vector<std::string>
  Wrap(const std::string & text, double width)
  {
    std::vector<std::string> lines;
    std::istringstream       words(text);
    std::string              word;
    std::string              line;
    while (words >> word)
    {
      const std::string longer = line.empty() ? word : line + " " + word;
      if (!line.empty() && this->TextWidth(longer) > width)
      {
        lines.push_back(line);
        line = word;
      }
      else
      {
        line = longer;
      }
    }
    lines.push_back(line);
    for (std::string & each : lines)
    {
      each = this->Fit(each, width);
    }
    return lines;
  }

  void
  ClipTo(const Box & box)
  {
    cairo_save(this->Get());
    cairo_rectangle(this->Get(), box.x, box.y, box.width, box.height);
    cairo_clip(this->Get());
  }
  void
  EndClip()
  {
    cairo_restore(this->Get());
  }

  std::vector<std::uint8_t>
  GetPixels()
  {
    this->Check();
    cairo_surface_flush(m_Surface.get());
    const unsigned char *     data = cairo_image_surface_get_data(m_Surface.get());
    const int                 stride = cairo_image_surface_get_stride(m_Surface.get());
    std::vector<std::uint8_t> pixels;
    pixels.reserve(static_cast<std::size_t>(m_Width) * m_Height * 3);
    for (int y = 0; y < m_Height; ++y)
    {
      const auto * row = reinterpret_cast<const std::uint32_t *>(data + static_cast<std::ptrdiff_t>(y) * stride);
      for (int x = 0; x < m_Width; ++x)
      {
        pixels.push_back(static_cast<std::uint8_t>(row[x] >> 16));
        pixels.push_back(static_cast<std::uint8_t>(row[x] >> 8));
        pixels.push_back(static_cast<std::uint8_t>(row[x]));
      }
    }
    return pixels;
  }

private:
  int                                                           m_Width;
  int                                                           m_Height;
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t *)> m_Surface;
  std::unique_ptr<cairo_t, void (*)(cairo_t *)>                 m_Context;
};

/** Liang-Barsky. \return false where nothing of the segment is in the box. */
bool
ClipSegment(Point & a, Point & b, const Box & box)
{
  const double d[2] = { b[0] - a[0], b[1] - a[1] };
  const double low[2] = { box.x, box.y };
  const double high[2] = { box.x + box.width, box.y + box.height };
  double       t0 = 0.0;
  double       t1 = 1.0;
  for (unsigned int axis = 0; axis < 2; ++axis)
  {
    if (!std::isfinite(d[axis]))
    {
      return false;
    }
    if (d[axis] == 0.0)
    {
      if (a[axis] < low[axis] || a[axis] > high[axis])
      {
        return false;
      }
      continue;
    }
    double enter = (low[axis] - a[axis]) / d[axis];
    double leave = (high[axis] - a[axis]) / d[axis];
    if (enter > leave)
    {
      std::swap(enter, leave);
    }
    t0 = std::max(t0, enter);
    t1 = std::min(t1, leave);
  }
  if (t0 > t1)
  {
    return false;
  }
  const Point start = a;
  for (unsigned int axis = 0; axis < 2; ++axis)
  {
    a[axis] = std::clamp(start[axis] + t0 * d[axis], low[axis], high[axis]);
    b[axis] = std::clamp(start[axis] + t1 * d[axis], low[axis], high[axis]);
  }
  return true;
}

/** How index coordinates come to lie in the picture. */
struct Mapping
{
  Point first;
  Point scale;
  Point offset;

  Point
  operator()(const Point & p) const
  {
    return { scale[0] * (p[0] - first[0]) + offset[0], scale[1] * (p[1] - first[1]) + offset[1] };
  }
};

/** Adds the strokes of a contour to the path, clipped: the library's coordinates are of 24 bits. */
void
TraceContour(Canvas & canvas, const OverlayScene::ContourType & contour, const Mapping & map, const Box & box)
{
  for (const OverlayScene::StrokeType & stroke : contour.strokes)
  {
    const std::size_t count = stroke.points.size();
    Point             pen{ -1e9, -1e9 };
    for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < count; ++i)
    {
      const Point & from = stroke.points[i];
      const Point & to = stroke.points[(i + 1) % count];
      if (!IsFinite(from) || !IsFinite(to))
      {
        continue;
      }
      Point a = map(from);
      Point b = map(to);
      if (!ClipSegment(a, b, box))
      {
        continue;
      }
      if (a != pen)
      {
        cairo_move_to(canvas.Get(), a[0], a[1]);
      }
      cairo_line_to(canvas.Get(), b[0], b[1]);
      pen = b;
    }
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

struct PenType
{
  Colour colour;
  double width;
  double alpha;
};

/** The tracing is drawn wide and the silhouette narrow on top of it: where they agree both are seen. */
PenType
PenOf(RoleEnum role)
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
      for (const OverlayScene::ContourType & contour : scene.contours)
      {
        if (contour.role != role)
        {
          continue;
        }
        cairo_new_path(canvas.Get());
        TraceContour(canvas, contour, map, box.Grown(64.0));
        canvas.SetColour(halo ? Black : pen.colour, halo ? 0.4 : pen.alpha);
        cairo_set_line_width(canvas.Get(), thickness * (pen.width + (halo ? 1.6 : 0.0)));
        cairo_stroke(canvas.Get());
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
  const Point corner = map({ -0.5, -0.5 });
  const Box   frame{ corner[0], corner[1], map.scale[0] * scene.width, map.scale[1] * scene.height };
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

/** Largest of 1, 2, 5 x 10^n that is not above the value. */
double
RoundLength(double value)
{
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double mantissa = value / power;
  return power * (mantissa >= 5.0 ? 5.0 : mantissa >= 2.0 ? 2.0 : 1.0);
}

double
LandmarkErrorInPixels(const OverlayScene::LandmarkType & landmark)
{
  return IsFinite(landmark.predicted) && IsFinite(landmark.reference) ? Distance(landmark.predicted, landmark.reference)
                                                                      : OverlayScene::LandmarkType::unknown;
}

bool
KnowsSpacing(const OverlayScene & scene)
{
  return scene.pixelSpacing[0] > 0.0 && scene.pixelSpacing[1] > 0.0 && std::isfinite(scene.pixelSpacing[0]) &&
         std::isfinite(scene.pixelSpacing[1]);
}

double
LandmarkErrorInMillimetres(const OverlayScene & scene, const OverlayScene::LandmarkType & landmark)
{
  return std::hypot((landmark.predicted[0] - landmark.reference[0]) * scene.pixelSpacing[0],
                    (landmark.predicted[1] - landmark.reference[1]) * scene.pixelSpacing[1]);
}

void
DrawLandmarks(Canvas & canvas, const OverlayScene & scene, const Mapping & map, const Box & box, double font)
{
  // Error vectors first, so that marks lie on top.
  for (const auto & landmark : scene.landmarks)
  {
    if (IsFinite(landmark.predicted) && IsFinite(landmark.reference))
    {
      Point a = map(landmark.reference);
      Point b = map(landmark.predicted);
      if (ClipSegment(a, b, box.Grown(64.0)))
      {
        canvas.Line(a, b, Black, 4.5, 0.5);
        canvas.Line(a, b, OverlayColour::Error, 2.2);
      }
    }
  }
  std::vector<Point> marks;
  for (const auto & landmark : scene.landmarks)
  {
    if (IsFinite(landmark.reference) && box.Holds(map(landmark.reference)))
    {
      const Point p = map(landmark.reference);
      canvas.Ring(p, 6.0, Black, 4.0, 0.5);
      canvas.Ring(p, 6.0, OverlayColour::Tracing, 2.0);
      marks.push_back(p);
    }
    if (IsFinite(landmark.predicted) && box.Holds(map(landmark.predicted)))
    {
      const Point p = map(landmark.predicted);
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
  std::vector<Point> contourPoints;
  for (const auto & contour : scene.contours)
  {
    for (const auto & stroke : contour.strokes)
    {
      for (const Point & point : stroke.points)
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
    const Point & anchorIndex = IsFinite(landmark.predicted) ? landmark.predicted : landmark.reference;
    if (!IsFinite(anchorIndex) || !box.Holds(map(anchorIndex)))
    {
      continue;
    }
    const Point  anchor = map(anchorIndex);
    std::string  text = LandmarkText(landmark.name);
    const double error = LandmarkErrorInPixels(landmark);
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
        for (const Point & mark : marks)
        {
          cost += candidate.Grown(6.0).Holds(mark) ? 20.0 : 0.0;
        }
        for (const Point & point : contourPoints)
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
    const Point middle{ best.x + 0.5 * best.width, best.y + 0.5 * best.height };
    Point       touch{ std::clamp(anchor[0], best.x, best.x + best.width),
                 std::clamp(anchor[1], best.y, best.y + best.height) };
    if (Distance(touch, anchor) > 10.0)
    {
      const double length = Distance(touch, anchor);
      const Point  start{ anchor[0] + 6.0 * (touch[0] - anchor[0]) / length,
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
    draw(Point{ box.x, y + 0.5 * row }, Point{ box.x + sample, y + 0.5 * row });
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
          [&](const Point & a, const Point & b) { canvas.Line(a, b, pen.colour, pen.width, pen.alpha); });
  }
  const auto any = [&scene](const auto & test) {
    return std::any_of(scene.landmarks.begin(), scene.landmarks.end(), test);
  };
  const auto middle = [](const Point & a, const Point & b) { return Point{ 0.5 * (a[0] + b[0]), a[1] }; };
  if (any([](const auto & l) { return IsFinite(l.predicted); }))
  {
    entry("Landmark of the scan, aligned", [&](const Point & a, const Point & b) {
      canvas.Dot(middle(a, b), 4.6, Black, 0.7);
      canvas.Dot(middle(a, b), 3.2, OverlayColour::Silhouette);
    });
  }
  if (any([](const auto & l) { return IsFinite(l.predicted) && l.sigma > 0.0; }))
  {
    entry("95 % region of a landmark", [&](const Point & a, const Point & b) {
      const double dashes[2] = { 4.0, 5.0 };
      cairo_set_dash(canvas.Get(), dashes, 2, 0.0);
      canvas.Ring(middle(a, b), 0.55 * font, OverlayColour::Silhouette, 1.2, 0.9);
      cairo_set_dash(canvas.Get(), nullptr, 0, 0.0);
    });
  }
  if (any([](const auto & l) { return IsFinite(l.reference); }))
  {
    entry("Landmark on the radiograph",
          [&](const Point & a, const Point & b) { canvas.Ring(middle(a, b), 6.0, OverlayColour::Tracing, 2.0); });
  }
  if (any([](const auto & l) { return std::isfinite(LandmarkErrorInPixels(l)); }))
  {
    entry("Error", [&](const Point & a, const Point & b) { canvas.Line(a, b, OverlayColour::Error, 2.2); });
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

struct Extent
{
  double low[2]{ std::numeric_limits<double>::max(), std::numeric_limits<double>::max() };
  double high[2]{ -std::numeric_limits<double>::max(), -std::numeric_limits<double>::max() };

  void
  Add(const Point & p)
  {
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  bool
  IsEmpty() const
  {
    return low[0] > high[0];
  }
};

/** What the eye wants to see: tracing and landmarks; the scan's contour where there is neither. A result far off must
 * not shrink the teeth to a speck. */
Extent
InterestingExtent(const OverlayScene & scene)
{
  const auto worth = [&scene](const Point & p) {
    const double u = scene.width > 0 ? scene.width : 1e5;
    const double v = scene.height > 0 ? scene.height : 1e5;
    return IsFinite(p) && p[0] > -0.25 * u && p[0] < 1.25 * u && p[1] > -0.25 * v && p[1] < 1.25 * v;
  };
  Extent     extent;
  const auto addContours = [&](RoleEnum role) {
    for (const auto & contour : scene.contours)
    {
      for (const auto & stroke : contour.strokes)
      {
        for (const Point & point : stroke.points)
        {
          if (contour.role == role && worth(point))
          {
            extent.Add(point);
          }
        }
      }
    }
  };
  addContours(RoleEnum::Fixed);
  for (const auto & landmark : scene.landmarks)
  {
    if (worth(landmark.reference))
    {
      extent.Add(landmark.reference);
    }
  }
  for (const RoleEnum role : { RoleEnum::Moving, RoleEnum::Secondary })
  {
    if (extent.IsEmpty())
    {
      addContours(role);
    }
  }
  if (extent.IsEmpty())
  {
    for (const auto & landmark : scene.landmarks)
    {
      if (worth(landmark.predicted))
      {
        extent.Add(landmark.predicted);
      }
    }
  }
  return extent;
}

struct Frame
{
  Box    header;
  Box    view;
  Box    panel;
  double font;
};

Frame
MakeFrame(int width, int height)
{
  if (width < 320 || height < 240 || width > 16384 || height > 16384)
  {
    throw std::invalid_argument("An overlay of " + std::to_string(width) + " x " + std::to_string(height) +
                                " pixels is asked for; give at least 320 x 240 and at most 16384 x 16384.");
  }
  Frame        frame;
  const double panel = std::clamp(std::round(0.27 * width), 150.0, 380.0);
  frame.font = std::clamp(std::round(0.5 * (panel / 24.0 + height / 60.0)), 9.0, 15.0);
  const double header = std::round(3.4 * frame.font);
  frame.header = { 0.0, 0.0, static_cast<double>(width), header };
  frame.view = { 0.0, header, width - panel, height - header };
  frame.panel = { width - panel, header, panel, height - header };
  return frame;
}
} // namespace

OverlayScene::PointType
OverlayLayout::ToPicture(const OverlayScene::PointType & index) const
{
  // Picture coordinates of the drawing have a pixel's corner at 0.
  return { scale[0] * (index[0] - first[0]) + offset[0] - 0.5, scale[1] * (index[1] - first[1]) + offset[1] - 0.5 };
}

OverlayLayout
LayOutOverlay(const OverlayScene & scene, int width, int height)
{
  const Frame  frame = MakeFrame(width, height);
  const double aspect = KnowsSpacing(scene) ? scene.pixelSpacing[1] / scene.pixelSpacing[0] : 1.0;
  Extent       extent;
  double       margin = 0.0;
  const auto & view = scene.view;
  if (view[1] > view[0] && view[3] > view[2] &&
      std::all_of(view.begin(), view.end(), [](double x) { return std::abs(x) < 1e6; }))
  {
    extent.Add({ view[0], view[2] });
    extent.Add({ view[1], view[3] });
  }
  else
  {
    extent = InterestingExtent(scene);
    margin = std::isfinite(scene.margin) ? std::max(0.0, scene.margin) : 0.0;
    if (extent.IsEmpty())
    {
      extent.Add({ -0.5, -0.5 });
      extent.Add({ std::max(1, scene.width) - 0.5, std::max(1, scene.height) - 0.5 });
      margin = 0.0;
    }
  }
  OverlayLayout layout;
  layout.view = { frame.view.x, frame.view.y, frame.view.width, frame.view.height };
  const double border =
    margin * std::max({ extent.high[0] - extent.low[0], aspect * (extent.high[1] - extent.low[1]), 10.0 });
  const double extentU = std::max(extent.high[0] - extent.low[0] + 2.0 * border, 1.0);
  const double extentV = std::max(aspect * (extent.high[1] - extent.low[1]) + 2.0 * border, 1.0);
  const double scale = std::min({ frame.view.width / extentU, frame.view.height / extentV, 24.0 });
  layout.scale = { scale, scale * aspect };
  const double size[2] = { frame.view.width / layout.scale[0], frame.view.height / layout.scale[1] };
  const int    pixels[2] = { scene.width, scene.height };
  for (unsigned int axis = 0; axis < 2; ++axis)
  {
    layout.first[axis] = 0.5 * (extent.low[axis] + extent.high[axis] - size[axis]);
    // Rather more of the radiograph than what is beside it.
    if (size[axis] <= pixels[axis])
    {
      layout.first[axis] = std::clamp(layout.first[axis], -0.5, pixels[axis] - 0.5 - size[axis]);
    }
    else if (pixels[axis] > 0)
    {
      layout.first[axis] = 0.5 * (pixels[axis] - 1.0 - size[axis]);
    }
  }
  layout.offset = { frame.view.x, frame.view.y };
  return layout;
}

std::vector<std::uint8_t>
PaintOverlay(const OverlayScene & scene, int width, int height)
{
  const OverlayLayout layout = LayOutOverlay(scene, width, height);
  const Frame         frame = MakeFrame(width, height);
  const bool          picture = !scene.grey.empty();
  if (scene.width < 0 || scene.height < 0 || scene.width > 32767 || scene.height > 32767 ||
      (picture && scene.grey.size() != static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height)))
  {
    throw std::invalid_argument("The radiograph has " + std::to_string(scene.grey.size()) +
                                " pixels, which do not fit " + std::to_string(scene.width) + " x " +
                                std::to_string(scene.height) + " (at most 32767 a side).");
  }
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t *)> radiograph(nullptr, cairo_surface_destroy);
  if (picture)
  {
    radiograph.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, scene.width, scene.height));
    if (cairo_surface_status(radiograph.get()) != CAIRO_STATUS_SUCCESS)
    {
      throw std::runtime_error("The overlay cannot be drawn: no memory for the radiograph.");
    }
    std::uint32_t shade[256];
    for (std::uint32_t value = 0; value < 256; ++value)
    {
      shade[value] = static_cast<std::uint32_t>(RadiographGain * value + 0.5);
    }
    unsigned char * data = cairo_image_surface_get_data(radiograph.get());
    const int       stride = cairo_image_surface_get_stride(radiograph.get());
    for (int y = 0; y < scene.height; ++y)
    {
      auto * row = reinterpret_cast<std::uint32_t *>(data + static_cast<std::ptrdiff_t>(y) * stride);
      for (int x = 0; x < scene.width; ++x)
      {
        const std::uint32_t g = shade[scene.grey[static_cast<std::size_t>(y) * scene.width + x]];
        row[x] = g << 16 | g << 8 | g;
      }
    }
    cairo_surface_mark_dirty(radiograph.get());
  }

  Canvas       canvas(width, height);
  const double font = frame.font;
  canvas.FillBox({ 0.0, 0.0, static_cast<double>(width), static_cast<double>(height) }, OverlayColour::Background);

  const Mapping map{ layout.first, layout.scale, layout.offset };
  canvas.ClipTo(frame.view);
  DrawRadiograph(canvas, radiograph.get(), scene, map);
  DrawContours(canvas, scene, map, frame.view, 1.0);
  DrawLandmarks(canvas, scene, map, frame.view, 0.9 * font);
  DrawScaleBar(canvas, scene, map, frame.view, 0.9 * font);
  canvas.EndClip();

  DrawHeader(canvas, scene, frame.header, font);

  const double inset = std::round(1.1 * font);
  Box          panel = frame.panel;
  canvas.FillBox(panel, PanelColour);
  canvas.ClipTo(panel);
  panel = { panel.x + inset, panel.y + inset, panel.width - 2.0 * inset, panel.height - 2.0 * inset };
  double       y = panel.y;
  const double bottom = panel.y + panel.height;
  // The whole radiograph, small, with the view's frame, at the bottom.
  double thumbTop = bottom;
  if (scene.width > 0 && scene.height > 0)
  {
    const double aspect = layout.scale[1] / layout.scale[0];
    // A long table needs the room more.
    const double  part = scene.landmarks.size() > 10 ? 0.2 : 0.3;
    const double  scale = std::min({ panel.width / scene.width, part * panel.height / (scene.height * aspect), 1.0 });
    const Mapping small{ { -0.5, -0.5 },
                         { scale, scale * aspect },
                         { panel.x + 0.5 * (panel.width - scale * scene.width),
                           bottom - scale * aspect * scene.height } };
    thumbTop = small.offset[1];
    const Box box{ small.offset[0], small.offset[1], scale * scene.width, scale * aspect * scene.height };
    canvas.ClipTo(box);
    canvas.FillBox(box, OverlayColour::Background);
    DrawRadiograph(canvas, radiograph.get(), scene, small);
    DrawContours(canvas, scene, small, box, 0.5);
    Point first = small(layout.first);
    Point last = small(
      { layout.first[0] + frame.view.width / layout.scale[0], layout.first[1] + frame.view.height / layout.scale[1] });
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
      first[axis] = std::clamp(first[axis], -100.0, 20000.0);
      last[axis] = std::clamp(last[axis], -100.0, 20000.0);
    }
    canvas.StrokeBox({ first[0], first[1], last[0] - first[0], last[1] - first[1] }, White, 1.2);
    canvas.EndClip();
    canvas.StrokeBox(box, FaintColour, 1.0);
    thumbTop -= inset;
  }
  canvas.SetFont(font);
  for (const std::string & text : scene.lines)
  {
    canvas.SetFont(font);
    for (const std::string & part : canvas.Wrap(Sanitize(text), panel.width))
    {
      if (y + 1.45 * font > thumbTop)
      {
        break;
      }
      canvas.Text(part, panel.x, y + font, TextColour);
      y += 1.45 * font;
    }
  }
  if (!scene.lines.empty())
  {
    y += 0.8 * font;
  }
  y = DrawLegend(canvas, scene, { panel.x, y, panel.width, std::max(0.0, thumbTop - y) }, 0.9 * font);
  y += 0.8 * font;
  DrawTable(canvas, scene, { panel.x, y, panel.width, std::max(0.0, thumbTop - y) }, font);
  canvas.EndClip();
  return canvas.GetPixels();
}
} // namespace itk
