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
#include "itkOverlayCanvas.h"
#include "itkOverlayFont.h"

#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace OverlayDrawing
{
std::string
Format(const char * format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

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

Canvas::Canvas(int width, int height)
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
Canvas::Get()
{
  return m_Context.get();
}

void
Canvas::Check()
{
  const cairo_status_t status = cairo_status(m_Context.get());
  if (status != CAIRO_STATUS_SUCCESS)
  {
    throw std::runtime_error(std::string("The overlay cannot be drawn: ") + cairo_status_to_string(status));
  }
}

void
Canvas::SetColour(const Colour & colour, double alpha)
{
  cairo_set_source_rgba(this->Get(), colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0, alpha);
}

void
Canvas::FillBox(const Box & box, const Colour & colour, double alpha, double radius)
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
Canvas::StrokeBox(const Box & box, const Colour & colour, double width)
{
  cairo_rectangle(this->Get(), box.x, box.y, box.width, box.height);
  this->SetColour(colour);
  cairo_set_line_width(this->Get(), width);
  cairo_stroke(this->Get());
}

void
Canvas::Line(const PixelPoint & from, const PixelPoint & to, const Colour & colour, double width, double alpha)
{
  cairo_move_to(this->Get(), from[0], from[1]);
  cairo_line_to(this->Get(), to[0], to[1]);
  this->SetColour(colour, alpha);
  cairo_set_line_width(this->Get(), width);
  cairo_stroke(this->Get());
}

void
Canvas::Ring(const PixelPoint & centre, double radius, const Colour & colour, double width, double alpha)
{
  cairo_new_sub_path(this->Get());
  cairo_arc(this->Get(), centre[0], centre[1], radius, 0.0, 2.0 * M_PI);
  this->SetColour(colour, alpha);
  cairo_set_line_width(this->Get(), width);
  cairo_stroke(this->Get());
}

void
Canvas::Dot(const PixelPoint & centre, double radius, const Colour & colour, double alpha)
{
  cairo_new_sub_path(this->Get());
  cairo_arc(this->Get(), centre[0], centre[1], radius, 0.0, 2.0 * M_PI);
  this->SetColour(colour, alpha);
  cairo_fill(this->Get());
}

void
Canvas::SetFont(double size, bool bold)
{
  cairo_set_font_face(this->Get(), GetFontFace(bold));
  cairo_set_font_size(this->Get(), size);
}

double
Canvas::TextWidth(const std::string & text)
{
  cairo_text_extents_t extents;
  cairo_text_extents(this->Get(), text.c_str(), &extents);
  return extents.x_advance;
}

void
Canvas::Text(const std::string & text, double x, double y, const Colour & colour, bool right)
{
  cairo_move_to(this->Get(), right ? x - this->TextWidth(text) : x, y);
  this->SetColour(colour);
  cairo_show_text(this->Get(), text.c_str());
  cairo_new_path(this->Get());
}

std::string
Canvas::Fit(const std::string & text, double width)
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
Canvas::Wrap(const std::string & text, double width)
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
Canvas::ClipTo(const Box & box)
{
  cairo_save(this->Get());
  cairo_rectangle(this->Get(), box.x, box.y, box.width, box.height);
  cairo_clip(this->Get());
}

void
Canvas::EndClip()
{
  cairo_restore(this->Get());
}

std::vector<std::uint8_t>
Canvas::GetPixels()
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
} // namespace OverlayDrawing
} // namespace itk
