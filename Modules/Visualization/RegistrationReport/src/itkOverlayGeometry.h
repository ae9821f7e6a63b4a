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
#ifndef itkOverlayGeometry_h
#define itkOverlayGeometry_h

#include "itkOverlayScene.h"

#include <cmath>

// Boxes, segments and the way from pixel index to picture: what layout, canvas and the drawing of the parts all
// reckon with, apart from any drawing library so that each can be read alone. Private to this module.
namespace itk
{
namespace OverlayDrawing
{
using PixelPoint = OverlayScene::PointType;

/** A rectangle of the picture, its corner at the top left. */
struct Box
{
  double x{ 0.0 };
  double y{ 0.0 };
  double width{ 0.0 };
  double height{ 0.0 };

  bool
  Holds(const PixelPoint & p) const
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

inline bool
IsFinite(const PixelPoint & p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]);
}

inline double
Distance(const PixelPoint & a, const PixelPoint & b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/** Cuts the segment to the box (Liang, Barsky 1984). \return false where nothing of the segment is in the box. */
bool
ClipSegment(PixelPoint & a, PixelPoint & b, const Box & box);

/** How index coordinates come to lie in the picture. */
struct Mapping
{
  PixelPoint first;
  PixelPoint scale;
  PixelPoint offset;

  PixelPoint
  operator()(const PixelPoint & p) const
  {
    return { scale[0] * (p[0] - first[0]) + offset[0], scale[1] * (p[1] - first[1]) + offset[1] };
  }
};
} // namespace OverlayDrawing
} // namespace itk

#endif
