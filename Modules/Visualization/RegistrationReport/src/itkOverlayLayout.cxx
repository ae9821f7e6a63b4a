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
#include "itkOverlayLayout.h"

#include "itkOverlayFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
using namespace OverlayDrawing;
using RoleEnum = OverlayScene::RoleEnum;

struct Extent
{
  double low[2]{ std::numeric_limits<double>::max(), std::numeric_limits<double>::max() };
  double high[2]{ -std::numeric_limits<double>::max(), -std::numeric_limits<double>::max() };

  void
  Add(const PixelPoint & p)
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
  const auto worth = [&scene](const PixelPoint & p) {
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
        for (const PixelPoint & point : stroke.points)
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
} // namespace itk
