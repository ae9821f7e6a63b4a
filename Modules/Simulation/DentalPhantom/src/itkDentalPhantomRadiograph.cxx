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
#include "itkDentalPhantomRadiograph.h"

#include "itkParallelFor.h"
#include "itkReproducibleRandom.h"
#include "itkInvertedProjection.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** An ellipse in mm about a centre in px, with a soft rim. */
struct Shape
{
  double u;
  double v;
  double a;
  double b;
  double cosine;
  double sine;
  /** Grey inside, and of a cortical rim. */
  double fill;
  double rim;
  double rimWidth;
};

double
SoftStep(double t)
{
  const double c = std::min(std::max(t, 0.0), 1.0);
  return c * c * (3.0 - 2.0 * c);
}

double
ShapeValue(const Shape & shape, double u, double v, double pixelSize)
{
  const double du = (u - shape.u) * pixelSize;
  const double dv = (v - shape.v) * pixelSize;
  const double x = (shape.cosine * du + shape.sine * dv) / shape.a;
  const double y = (shape.cosine * dv - shape.sine * du) / shape.b;
  const double r = std::sqrt(x * x + y * y);
  // Signed distance in mm, about.
  const double d = (r - 1.0) * std::min(shape.a, shape.b);
  const double t = d / shape.rimWidth;
  return shape.fill * SoftStep(0.5 - d / 3.0) + (std::abs(t) < 6.0 ? shape.rim * std::exp(-0.5 * t * t) : 0.0);
}
} // namespace

std::vector<std::uint8_t>
DentalPhantomRadiograph::Render(const DentalPhantomModel &          model,
                                const PerspectiveProjection &       projection,
                                int                                 facing,
                                const std::array<double, 2> &       earRod,
                                double                              pixelSize,
                                const std::array<unsigned int, 2> & size,
                                std::uint64_t                       seed,
                                unsigned int                        threads)
{
  ReproducibleRandom random(seed, 1);
  const auto         jitter = [&random](double scale) { return scale * (2.0 * random.Uniform() - 1.0); };

  const std::array<double, 9> inverse = InvertedProjection(projection);

  // Where the teeth are, and the box of each in the image.
  struct Box
  {
    unsigned int jaw;
    unsigned int tooth;
    double       centre[2];
    double       radius;
  };
  std::vector<Box> boxes;
  double           middle[2] = { 0.0, 0.0 };
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    for (unsigned int tooth = 0; tooth < DentalPhantomJaw::NumberOfTeeth; ++tooth)
    {
      if (!model.HasTooth(jaw, tooth))
      {
        continue;
      }
      Box        box{ jaw, tooth, { 0.0, 0.0 }, 1.05 * model.GetToothRadius(jaw, tooth) / pixelSize + 2.0 };
      const auto centre = model.GetToothCentre(jaw, tooth);
      projection.Project(centre.data(), box.centre[0], box.centre[1]);
      middle[0] += box.centre[0];
      middle[1] += box.centre[1];
      boxes.push_back(box);
    }
  }
  if (boxes.empty())
  {
    middle[0] = 0.5 * size[0];
    middle[1] = 0.5 * size[1];
  }
  else
  {
    middle[0] /= static_cast<double>(boxes.size());
    middle[1] /= static_cast<double>(boxes.size());
  }

  // Shapes by their place relative to the teeth: mm anterior and down.
  std::vector<Shape> shapes;
  const auto         add = [&](double anterior, double down, double a, double b, double turn, double fill, double rim) {
    const double u = middle[0] + facing * (anterior + jitter(2.0)) / pixelSize;
    const double v = middle[1] + (down + jitter(2.0)) / pixelSize;
    const double width = a * (1.0 + jitter(0.05));
    const double height = b * (1.0 + jitter(0.05));
    const double angle = facing * (turn + jitter(0.05));
    shapes.push_back({ u, v, width, height, std::cos(angle), std::sin(angle), fill, rim, 1.0 });
  };
  add(-62.0, -95.0, 95.0, 72.0, -0.15, 26.0, 26.0); // calvarium
  add(-50.0, -60.0, 40.0, 6.0, 0.25, 20.0, 6.0);    // skull base
  add(-44.0, -62.0, 7.0, 6.0, 0.0, -14.0, 16.0);    // sella
  add(-2.0, -52.0, 17.0, 19.0, 0.1, -26.0, 14.0);   // orbit
  add(-8.0, -32.0, 19.0, 11.0, 0.05, -18.0, 12.0);  // maxillary sinus
  add(-2.0, -17.0, 30.0, 7.0, 0.12, 32.0, 12.0);    // maxilla
  add(-2.0, 18.0, 32.0, 11.0, 0.16, 36.0, 18.0);    // body of the mandible
  add(22.0, 24.0, 8.0, 12.0, -0.1, 18.0, 10.0);     // symphysis
  add(-42.0, -6.0, 11.0, 34.0, 0.12, 28.0, 12.0);   // ramus
  add(-62.0, 12.0, 9.0, 55.0, -0.1, 22.0, 8.0);     // cervical column

  // Soft tissue: everything behind a profile line, mm anterior of the teeth over mm down.
  constexpr double profile[][2] = { { -140.0, 28.0 }, { -95.0, 34.0 }, { -70.0, 30.0 }, { -45.0, 46.0 },
                                    { -28.0, 34.0 },  { -10.0, 38.0 }, { 0.0, 36.0 },   { 10.0, 37.0 },
                                    { 22.0, 31.0 },   { 35.0, 34.0 },  { 48.0, 24.0 },  { 60.0, -10.0 },
                                    { 100.0, -22.0 } };
  const auto       profileAt = [&](double down) {
    constexpr int count = sizeof(profile) / sizeof(profile[0]);
    if (down <= profile[0][0])
    {
      return profile[0][1];
    }
    for (int i = 1; i < count; ++i)
    {
      if (down < profile[i][0])
      {
        const double t = SoftStep((down - profile[i - 1][0]) / (profile[i][0] - profile[i - 1][0]));
        return profile[i - 1][1] + t * (profile[i][1] - profile[i - 1][1]);
      }
    }
    return profile[count - 1][1];
  };

  std::vector<std::uint8_t> image(static_cast<std::size_t>(size[0]) * size[1]);
  ParallelFor(size[1], threads, [&](std::size_t row) {
    ReproducibleRandom grain(seed, 1000 + row);
    const double       v = static_cast<double>(row);
    double             memory = 0.0;
    for (unsigned int column = 0; column < size[0]; ++column)
    {
      const double u = column;
      const double anterior = facing * (u - middle[0]) * pixelSize;
      const double down = (v - middle[1]) * pixelSize;
      const double depth = profileAt(down) - anterior;
      double       grey = 14.0 + 52.0 * SoftStep(depth / 5.0) + 26.0 * SoftStep((depth - 5.0) / 45.0);
      for (const Shape & shape : shapes)
      {
        grey += ShapeValue(shape, u, v, pixelSize);
      }
      // Teeth.
      double                        crown = 0.0;
      double                        root = 0.0;
      bool                          hasDirection = false;
      DentalPhantomModel::PointType direction{};
      for (const Box & box : boxes)
      {
        if (std::abs(u - box.centre[0]) > box.radius || std::abs(v - box.centre[1]) > box.radius)
        {
          continue;
        }
        if (!hasDirection)
        {
          double norm = 0.0;
          for (unsigned int d = 0; d < 3; ++d)
          {
            direction[d] = inverse[3 * d] * u + inverse[3 * d + 1] * v + inverse[3 * d + 2];
            norm += direction[d] * direction[d];
          }
          for (double & value : direction)
          {
            value /= std::sqrt(norm);
          }
          hasDirection = true;
        }
        const auto length = model.RayThroughTooth(box.jaw, box.tooth, projection.source, direction);
        crown += length[0];
        root += length[1];
      }
      grey += 150.0 * (1.0 - std::exp(-0.055 * crown - 0.03 * root));
      // Ear rods.
      const double r = std::hypot(u - earRod[0], v - earRod[1]) * pixelSize;
      const double ring = (r - 4.0) / 0.5;
      grey += 90.0 * std::exp(-0.5 * ring * ring);
      // Grain, a little correlated along the row.
      memory = 0.4 * memory + grain.Normal();
      grey += 3.0 * memory;
      // A film's shoulder instead of clipping.
      if (grey > 200.0)
      {
        grey = 200.0 + 55.0 * (1.0 - std::exp(-(grey - 200.0) / 55.0));
      }
      image[row * size[0] + column] = static_cast<std::uint8_t>(std::min(std::max(std::lround(grey), 0L), 255L));
    }
  });
  return image;
}
} // namespace itk
