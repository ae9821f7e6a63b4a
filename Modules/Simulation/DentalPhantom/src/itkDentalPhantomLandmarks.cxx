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
#include "itkDentalPhantomLandmarks.h"

#include <cmath>
#include <string>
#include <vector>

namespace itk
{
namespace
{
using PointType = DentalPhantomDentition::PointType;
} // namespace

void
AddDentalPhantomLandmarks(unsigned int jaw, const DentalPhantomDentition & dentition, DentalPhantomJawSurface & result)
{
  for (unsigned int i = 0; i < DentalPhantomDentition::NumberOfTeeth; ++i)
  {
    const DentalPhantomToothBody & body = dentition.GetBody(jaw, i);
    if (!body.present)
    {
      continue;
    }
    const unsigned int k = DentalPhantomJaw::GetPosition(i);
    struct Wanted
    {
      const char * name;
      double       x;
      double       y;
    };
    std::vector<Wanted> wanted;
    if (k < 2)
    {
      wanted.push_back({ "tip", 0.0, body.edge });
    }
    for (const DentalPhantomToothBody::Cusp & cusp : body.cusps)
    {
      const std::string name = cusp.name;
      if (name == "cusp" || name == "B" || name == "MB" || (name == "DB" && k == 5))
      {
        wanted.push_back({ cusp.name, cusp.x, cusp.y });
      }
    }
    for (const Wanted & w : wanted)
    {
      // The occlusal-most point of the crown near the feature; along an edge the middle.
      const auto height = [&](double x, double y, PointType & local) {
        double low = 0.4 * body.height;
        double high = 1.1 * body.height;
        if (body.Evaluate({ { x, y, low } }, false) > 0.0)
        {
          return -1e9;
        }
        for (unsigned int n = 0; n < 40; ++n)
        {
          const double middle = 0.5 * (low + high);
          (body.Evaluate({ { x, y, middle } }, false) > 0.0 ? high : low) = middle;
        }
        local = { { x, y, low } };
        return body.ToJaw(local)[2];
      };
      PointType best{};
      double    x = w.x;
      double    y = w.y;
      double    value = height(x, y, best);
      for (double step = 0.4; step > 1e-3; step *= 0.5)
      {
        bool moved = true;
        for (unsigned int n = 0; n < 8 && moved; ++n)
        {
          moved = false;
          for (int direction = 0; direction < 4; ++direction)
          {
            const double dx = k < 2 ? 0.0 : direction == 0 ? step : direction == 1 ? -step : 0.0;
            const double dy = direction == 2 ? step : direction == 3 ? -step : 0.0;
            PointType    local{};
            const double h = height(x + dx, y + dy, local);
            if (h > value && std::abs(x + dx - w.x) < 1.5 && std::abs(y + dy - w.y) < 1.5)
            {
              value = h;
              x += dx;
              y += dy;
              best = local;
              moved = true;
            }
          }
        }
      }
      const PointType tip = body.ToJaw(best);
      // The nearest vertex of the crown moves there: the landmark lies on the mesh whatever its resolution.
      const std::uint8_t fdi = DentalPhantomDentition::ToothFDI(jaw, i);
      std::size_t        nearest = result.labels.size();
      double             distance = 1e9;
      for (std::size_t v = 0; v < result.labels.size(); ++v)
      {
        if (result.labels[v] == fdi)
        {
          const PointType & p = result.surface.points[v];
          const double      d =
            (p[0] - tip[0]) * (p[0] - tip[0]) + (p[1] - tip[1]) * (p[1] - tip[1]) + (p[2] - tip[2]) * (p[2] - tip[2]);
          if (d < distance)
          {
            distance = d;
            nearest = v;
          }
        }
      }
      if (nearest == result.labels.size())
      {
        continue;
      }
      result.surface.points[nearest] = tip;
      const char * quadrant =
        jaw == 0 ? (DentalPhantomJaw::IsLeft(i) ? "UL" : "UR") : (DentalPhantomJaw::IsLeft(i) ? "LL" : "LR");
      result.landmarks.push_back(
        { quadrant + std::to_string(k + 1) + "_" + w.name, { { static_cast<double>(nearest), 0.0, 0.0 } } });
    }
  }
}
} // namespace itk
