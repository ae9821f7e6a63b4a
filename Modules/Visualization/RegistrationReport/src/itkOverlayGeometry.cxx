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
#include "itkOverlayGeometry.h"

#include <algorithm>
#include <utility>

namespace itk
{
namespace OverlayDrawing
{
bool
ClipSegment(PixelPoint & a, PixelPoint & b, const Box & box)
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
  const PixelPoint start = a;
  for (unsigned int axis = 0; axis < 2; ++axis)
  {
    a[axis] = std::clamp(start[axis] + t0 * d[axis], low[axis], high[axis]);
    b[axis] = std::clamp(start[axis] + t1 * d[axis], low[axis], high[axis]);
  }
  return true;
}
} // namespace OverlayDrawing
} // namespace itk
