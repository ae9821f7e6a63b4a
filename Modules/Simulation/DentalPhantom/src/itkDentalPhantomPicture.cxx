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
#include "itkDentalPhantomPicture.h"

#include <algorithm>
#include <cmath>

namespace itk
{
std::vector<std::uint8_t>
DentalPhantomPicture::Render(const std::array<TriangleSurface, 2> &           surfaces,
                             const std::array<std::vector<std::uint8_t>, 2> & labels,
                             const DentalPhantomParameters &                  parameters,
                             unsigned int                                     panel)
{
  using PointType = std::array<double, 3>;
  const unsigned int        width = 4 * panel;
  std::vector<std::uint8_t> image(static_cast<std::size_t>(width) * panel * 3, 255);
  std::vector<float>        depth(static_cast<std::size_t>(width) * panel, -1e9f);
  // Right, down and toward the viewer, in the anatomical frame; which jaws are seen.
  struct View
  {
    PointType right;
    PointType down;
    PointType toward;
    bool      jaws[2];
  };
  const View   views[4] = { { { { 1, 0, 0 } }, { { 0, 0, -1 } }, { { 0, -1, 0 } }, { true, true } },
                            { { { 0, 1, 0 } }, { { 0, 0, -1 } }, { { 1, 0, 0 } }, { true, true } },
                            { { { 0, 1, 0 } }, { { -1, 0, 0 } }, { { 0, 0, -1 } }, { true, false } },
                            { { { 0, 1, 0 } }, { { 1, 0, 0 } }, { { 0, 0, 1 } }, { false, true } } };
  const double scale = panel / 76.0;
  const auto   dot = [](const PointType & a, const PointType & b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  for (unsigned int v = 0; v < 4; ++v)
  {
    const View & view = views[v];
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      if (!view.jaws[jaw])
      {
        continue;
      }
      const auto             motion = parameters.ComputeFrame(jaw);
      std::vector<PointType> points;
      for (const auto & p : surfaces[jaw].points)
      {
        points.push_back(motion.ApplyInverse(p));
      }
      for (const auto & t : surfaces[jaw].triangles)
      {
        const PointType & a = points[t[0]];
        const PointType & b = points[t[1]];
        const PointType & c = points[t[2]];
        PointType         n = { { (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]),
                                  (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]),
                                  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) } };
        const double      l = std::max(std::sqrt(dot(n, n)), 1e-12);
        // Light over the viewer's left shoulder; a surface seen from behind is darker.
        const double facing = dot(n, view.toward) / l;
        const double light = std::abs(0.75 * facing - 0.35 * dot(n, view.down) / l - 0.2 * dot(n, view.right) / l);
        const double shade = 0.25 + 0.75 * std::min(light, 1.0) * (facing < 0.0 ? 0.55 : 1.0);
        std::uint8_t fdi = 0;
        for (const auto id : t)
        {
          fdi = std::max(fdi, labels[jaw][id]);
        }
        const bool left = fdi / 10 == 2 || fdi / 10 == 3;
        const bool milk =
          fdi != 0 && parameters.jaws[jaw].GetTooth(DentalPhantomJaw::GetIndex(left, fdi % 10u - 1u)).primary;
        const double colour[3] = { fdi == 0 ? 225.0 : 245.0,
                                   fdi == 0 ? 150.0
                                   : milk   ? 225.0
                                            : 240.0,
                                   fdi == 0 ? 145.0
                                   : milk   ? 150.0
                                            : 226.0 };
        double q[3][3];
        for (unsigned int k = 0; k < 3; ++k)
        {
          const PointType p = { { points[t[k]][0] - 22.0, points[t[k]][1], points[t[k]][2] } };
          q[k][0] = panel * (v + 0.5) + scale * dot(p, view.right);
          q[k][1] = panel * 0.5 + scale * dot(p, view.down);
          q[k][2] = dot(p, view.toward);
        }
        const double det = (q[1][0] - q[0][0]) * (q[2][1] - q[0][1]) - (q[2][0] - q[0][0]) * (q[1][1] - q[0][1]);
        if (std::abs(det) < 1e-12)
        {
          continue;
        }
        const int x0 =
          std::max(static_cast<int>(v * panel), static_cast<int>(std::floor(std::min({ q[0][0], q[1][0], q[2][0] }))));
        const int x1 = std::min(static_cast<int>((v + 1) * panel) - 1,
                                static_cast<int>(std::ceil(std::max({ q[0][0], q[1][0], q[2][0] }))));
        const int y0 = std::max(0, static_cast<int>(std::floor(std::min({ q[0][1], q[1][1], q[2][1] }))));
        const int y1 =
          std::min(static_cast<int>(panel) - 1, static_cast<int>(std::ceil(std::max({ q[0][1], q[1][1], q[2][1] }))));
        for (int y = y0; y <= y1; ++y)
        {
          for (int x = x0; x <= x1; ++x)
          {
            const double dx = x - q[0][0];
            const double dy = y - q[0][1];
            const double s = (dx * (q[2][1] - q[0][1]) - (q[2][0] - q[0][0]) * dy) / det;
            const double r = ((q[1][0] - q[0][0]) * dy - dx * (q[1][1] - q[0][1])) / det;
            if (s < -0.01 || r < -0.01 || s + r > 1.01)
            {
              continue;
            }
            const float       z = static_cast<float>(q[0][2] + s * (q[1][2] - q[0][2]) + r * (q[2][2] - q[0][2]));
            const std::size_t id = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
            if (z > depth[id])
            {
              depth[id] = z;
              for (unsigned int k = 0; k < 3; ++k)
              {
                image[3 * id + k] = static_cast<std::uint8_t>(std::min(255.0, shade * colour[k]));
              }
            }
          }
        }
      }
    }
  }
  return image;
}
} // namespace itk
