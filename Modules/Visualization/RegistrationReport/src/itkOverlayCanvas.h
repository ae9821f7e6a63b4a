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
#ifndef itkOverlayCanvas_h
#define itkOverlayCanvas_h

#include "itkOverlayGeometry.h"

#include <cairo.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// The one place that owns a cairo surface: boxes, lines, dots and text in the overlay's own words, so that what is
// drawn reads apart from how the drawing library is kept in order. Private to this module.
namespace itk
{
namespace OverlayDrawing
{
using Colour = std::array<std::uint8_t, 3>;

constexpr Colour PanelColour{ 34, 37, 43 };
constexpr Colour TextColour{ 228, 230, 233 };
constexpr Colour FaintColour{ 150, 155, 163 };
constexpr Colour White{ 255, 255, 255 };
constexpr Colour Black{ 0, 0, 0 };

/** The value as printf() writes it. */
std::string
Format(const char * format, double value);

/** Bytes that are no UTF-8 would put the drawing library into its error state: "?" instead. */
std::string
Sanitize(const std::string & text);

/** Cairo with the few words that the overlay needs. */
class Canvas
{
public:
  Canvas(int width, int height);

  cairo_t *
  Get();

  void
  Check();

  void
  SetColour(const Colour & colour, double alpha = 1.0);

  void
  FillBox(const Box & box, const Colour & colour, double alpha = 1.0, double radius = 0.0);

  void
  StrokeBox(const Box & box, const Colour & colour, double width);

  void
  Line(const PixelPoint & from, const PixelPoint & to, const Colour & colour, double width, double alpha = 1.0);

  void
  Ring(const PixelPoint & centre, double radius, const Colour & colour, double width, double alpha = 1.0);

  void
  Dot(const PixelPoint & centre, double radius, const Colour & colour, double alpha = 1.0);

  void
  SetFont(double size, bool bold = false);

  double
  TextWidth(const std::string & text);

  /** The baseline's left end; with `right` its right end. */
  void
  Text(const std::string & text, double x, double y, const Colour & colour, bool right = false);

  /** The text, or as much of its beginning as fits. */
  std::string
  Fit(const std::string & text, double width);

  std::vector<std::string>
  Wrap(const std::string & text, double width);

  void
  ClipTo(const Box & box);

  void
  EndClip();

  std::vector<std::uint8_t>
  GetPixels();

private:
  int                                                           m_Width;
  int                                                           m_Height;
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t *)> m_Surface;
  std::unique_ptr<cairo_t, void (*)(cairo_t *)>                 m_Context;
};
} // namespace OverlayDrawing
} // namespace itk

#endif
