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
#include "itkOverlayPainting.h"

#include "itkOverlayPainter.h"
#include "itkOverlayPanel.h"
#include "itkOverlayView.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace itk
{
namespace
{
using namespace OverlayDrawing;

/** The radiograph is shown a little darker than it is, so that the overlay stands out on bright crowns. */
constexpr double RadiographGain = 0.85;
} // namespace
} // namespace itk

void
DentalSCRPaintOverlay(const itk::OverlayScene &          scene,
                      const itk::OverlayLayout &         layout,
                      const itk::OverlayDrawing::Frame & frame,
                      int                                width,
                      int                                height,
                      std::vector<std::uint8_t> &        pixels)
{
  using namespace itk;
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t *)> radiograph(nullptr, cairo_surface_destroy);
  if (!scene.grey.empty())
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
    PixelPoint first = small(layout.first);
    PixelPoint last = small(
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
  pixels = canvas.GetPixels();
}
