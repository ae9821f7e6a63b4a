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
#include "itkDentalPhantomFilm.h"

#include "itkDentalPhantomAnatomy.h"
#include "itkDentalPhantomMath.h"
#include "itkDentalPhantomSpline.h"
#include "itkParallelFor.h"
#include "itkReproducibleRandom.h"
#include "itkInvertedProjection.h"

#include <algorithm>
#include <cmath>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
using PointType = DentalPhantomModel::PointType;
using Part = DentalPhantomAnatomyPart;
using PlaneType = Part::PlaneType;

/** Distance from a line; of a closed one negative inside. */
double
Distance(const std::vector<PlaneType> & line, bool closed, double x, double z)
{
  double            best = 1e18;
  bool              inside = false;
  const std::size_t n = line.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i)
  {
    const PlaneType & a = line[i];
    const PlaneType & b = line[(i + 1) % n];
    const double      dx = b[0] - a[0];
    const double      dz = b[1] - a[1];
    const double      t = Clamp(((x - a[0]) * dx + (z - a[1]) * dz) / std::max(dx * dx + dz * dz, 1e-12), 0.0, 1.0);
    const double      ex = x - a[0] - t * dx;
    const double      ez = z - a[1] - t * dz;
    best = std::min(best, ex * ex + ez * ez);
    if (closed && (a[1] > z) != (b[1] > z) && x < a[0] + (z - a[1]) / (b[1] - a[1]) * dx)
    {
      inside = !inside;
    }
  }
  return inside ? -std::sqrt(best) : std::sqrt(best);
}

/** A part's attenuation at a signed distance from its line, mm. */
double
Attenuation(const Part & part, double d)
{
  double sum = 0.0;
  if (part.fill != 0.0 && d < 0.0)
  {
    // A rounded body: the chord of an ellipse.
    const double t = std::min(-d / part.depth, 1.0);
    sum += part.fill * std::sqrt(t * (2.0 - t));
  }
  const double r = d / part.width;
  if (part.rim != 0.0 && std::abs(r) < 4.0)
  {
    sum += part.rim * std::exp(-0.5 * r * r);
  }
  return sum;
}

/** Of a corner of a lattice, from -1 to 1. */
double
Chance(std::uint64_t seed, std::int64_t i, std::int64_t j)
{
  // SplitMix64's last steps.
  std::uint64_t bits =
    seed + 0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(i) + 0xc2b2ae3d27d4eb4fu * static_cast<std::uint64_t>(j);
  bits = (bits ^ (bits >> 30u)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27u)) * 0x94d049bb133111ebu;
  bits ^= bits >> 31u;
  return 2.0 * (static_cast<double>(bits >> 11u) / 9007199254740992.0) - 1.0;
}

/** What bone is not: even. Trabeculae, and thicker and thinner places of some millimetres and of centimetres. */
double
Texture(std::uint64_t seed, double x, double z)
{
  constexpr double scales[] = { 1.3, 4.5, 15.0 };
  constexpr double strengths[] = { 0.42, 0.34, 0.3 };
  double           sum = 0.0;
  for (unsigned int k = 0; k < 3; ++k)
  {
    const double u = x / scales[k];
    const double v = z / scales[k];
    const auto   i = static_cast<std::int64_t>(std::floor(u));
    const auto   j = static_cast<std::int64_t>(std::floor(v));
    const double s = SmoothStep(0.0, 1.0, u - static_cast<double>(i));
    const double t = SmoothStep(0.0, 1.0, v - static_cast<double>(j));
    sum += strengths[k] * ((1.0 - t) * ((1.0 - s) * Chance(seed + k, i, j) + s * Chance(seed + k, i + 1, j)) +
                           t * ((1.0 - s) * Chance(seed + k, i, j + 1) + s * Chance(seed + k, i + 1, j + 1)));
  }
  return sum;
}

struct Shadow
{
  double crown{ 0.0 };
  double root{ 0.0 };
  double pulp{ 0.0 };
  double metal{ 0.0 };
};
} // namespace

std::vector<std::uint8_t>
DentalPhantomFilm::Render(const DentalPhantomModel & model, unsigned int threads) const
{
  const std::array<double, 9> inverse = InvertedProjection(projection);

  // Where the teeth are: the upper incisors' edge in the lateral picture, the arch's front in the frontal one.
  double       edge[2] = { 0.0, 0.0 };
  double       count = 0.0;
  const auto & dentition = model.GetDentition();
  for (const unsigned int tooth : { 0u, 7u })
  {
    const auto & body = dentition.GetBody(0, tooth);
    if (body.space)
    {
      PointType p = body.ToJaw({ { 0.0, body.edge, body.height } });
      p[2] = -p[2];
      double u = 0.0;
      double v = 0.0;
      projection.Project(p.data(), u, v);
      edge[0] += facing * (u - earRod[0]) * pixelSize;
      edge[1] -= (v - earRod[1]) * pixelSize;
      count += 1.0;
    }
  }
  const bool   lateral = view == ViewEnum::Lateral;
  const double nominal[2] = { lateral ? 96.0 : 0.0, lateral ? -36.0 : -34.0 };
  double       shift[2] = { 0.0, 0.0 };
  for (unsigned int d = 0; d < 2 && count > 0.0; ++d)
  {
    shift[d] = edge[d] / count - nominal[d];
  }
  const auto warp = [&](PlaneType p) {
    // Nothing at the skull's base, all of it at the teeth and below; the joint stays where it is.
    const double w = (1.0 - SmoothStep(-14.0, 12.0, p[1])) * (lateral ? SmoothStep(8.0, 55.0, p[0]) : 1.0);
    return PlaneType{ { p[0] + w * shift[0], p[1] + w * shift[1] } };
  };

  // The parts' sum on a coarse raster.
  constexpr int      coarse = 3;
  const int          nu = static_cast<int>(size[0]) / coarse + 2;
  const int          nv = static_cast<int>(size[1]) / coarse + 2;
  std::vector<float> field(static_cast<std::size_t>(nu) * nv, 0.0f);
  struct Drawn
  {
    Part                   part;
    std::vector<PlaneType> line;
    double                 share;
    double                 box[4];
    bool                   bone;
  };
  std::vector<Drawn> drawn;
  ReproducibleRandom person(seed, 40);
  for (const Part & part : lateral ? Part::GetLateral() : Part::GetFrontal())
  {
    // Not the soft tissue, which comes first, nor the thin walls of what is full of air.
    const bool isBone = !drawn.empty() && (part.fill > 0.11 || part.rim > 0.2);
    for (unsigned int copy = 0; copy < (part.paired ? 2u : 1u); ++copy)
    {
      std::vector<PlaneType> knots;
      // Each person a little different, the two sides a little from each other.
      const double wobble = lateral ? 0.7 : 0.5;
      for (const PlaneType & knot : part.knots)
      {
        PlaneType p = warp(knot);
        p = { { p[0] + wobble * person.Normal(), p[1] + wobble * person.Normal() } };
        if (lateral && part.paired)
        {
          // The sides' magnifications: 3 % apart, about the ear rods.
          const double s = copy == 0 ? 0.985 : 1.015;
          p = { { s * p[0], s * p[1] } };
        }
        else if (copy == 1)
        {
          p[0] = -p[0];
        }
        knots.push_back(p);
      }
      Drawn one{ part,
                 DentalPhantomSpline(knots, part.closed, 4),
                 lateral && part.paired ? 0.6 : 1.0,
                 { 1e9, 1e9, -1e9, -1e9 },
                 isBone };
      for (const PlaneType & p : one.line)
      {
        one.box[0] = std::min(one.box[0], p[0]);
        one.box[1] = std::min(one.box[1], p[1]);
        one.box[2] = std::max(one.box[2], p[0]);
        one.box[3] = std::max(one.box[3], p[1]);
      }
      drawn.push_back(one);
    }
  }
  ParallelFor(static_cast<std::size_t>(nv), threads, [&](std::size_t row) {
    for (int column = 0; column < nu; ++column)
    {
      const double x = facing * (coarse * column - earRod[0]) * pixelSize;
      const double z = -(coarse * static_cast<double>(row) - earRod[1]) * pixelSize;
      double       sum = 0.0;
      const double texture = 1.0 + 0.3 * Texture(seed, x, z);
      for (const Drawn & one : drawn)
      {
        const double margin = 4.0 * one.part.width;
        if (x < one.box[0] - margin || x > one.box[2] + margin || z < one.box[1] - margin || z > one.box[3] + margin)
        {
          continue;
        }
        sum +=
          one.share * (one.bone ? texture : 1.0) * Attenuation(one.part, Distance(one.line, one.part.closed, x, z));
      }
      field[row * nu + column] = static_cast<float>(sum);
    }
  });

  // Teeth.
  struct Box
  {
    unsigned int jaw;
    unsigned int tooth;
    double       begin[2];
    double       end[2];
  };
  std::vector<Box> boxes;
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    for (unsigned int tooth = 0; tooth < DentalPhantomDentition::NumberOfTeeth; ++tooth)
    {
      const auto & body = dentition.GetBody(jaw, tooth);
      if (!body.present)
      {
        continue;
      }
      Box box{ jaw, tooth, { 1e9, 1e9 }, { -1e9, -1e9 } };
      for (unsigned int corner = 0; corner < 8; ++corner)
      {
        PointType p = body.ToJaw({ { ((corner & 1u) != 0 ? 0.75 : -0.75) * body.width,
                                     ((corner & 2u) != 0 ? 0.8 : -0.85) * body.depth,
                                     (corner & 4u) != 0 ? body.height + 0.5 : -19.0 } });
        p[2] *= jaw == 0 ? -1.0 : 1.0;
        double q[2];
        projection.Project(p.data(), q[0], q[1]);
        for (unsigned int d = 0; d < 2; ++d)
        {
          box.begin[d] = std::min(box.begin[d], q[d]);
          box.end[d] = std::max(box.end[d], q[d]);
        }
      }
      boxes.push_back(box);
    }
  }
  const auto shine = [&](const Box & box, const PointType & direction, Shadow & shadow) {
    const auto &    body = dentition.GetBody(box.jaw, box.tooth);
    const double    flip = box.jaw == 0 ? -1.0 : 1.0;
    const PointType source =
      body.ToLocal({ { projection.source[0], projection.source[1], flip * projection.source[2] } });
    PointType d{};
    for (unsigned int k = 0; k < 3; ++k)
    {
      d[k] = body.axes[k][0] * direction[0] + body.axes[k][1] * direction[1] + body.axes[k][2] * flip * direction[2];
    }
    const double low[3] = { -0.75 * body.width, -0.85 * body.depth, -19.0 };
    const double high[3] = { 0.75 * body.width, 0.8 * body.depth, body.height + 0.5 };
    double       begin = 0.0;
    double       end = 1e300;
    for (unsigned int k = 0; k < 3; ++k)
    {
      const double a = (low[k] - source[k]) / d[k];
      const double b = (high[k] - source[k]) / d[k];
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
    constexpr double step = 0.5;
    for (double t = begin + 0.5 * step; t < end; t += step)
    {
      const PointType p = { { source[0] + t * d[0], source[1] + t * d[1], source[2] + t * d[2] } };
      const double    f = body.EvaluateWhole(p);
      const double    part = step * Clamp(0.5 - f / step, 0.0, 1.0);
      if (part > 0.0)
      {
        // Enamel is a shell of the crown, about 1.3 mm thick.
        (p[2] > 0.5 && f > -1.3 ? shadow.crown : shadow.root) += part;
        const double narrow = (p[2] > 0.0 ? 0.17 : 0.1 * (1.0 + p[2] / 16.0)) * std::min(body.width, body.depth);
        if (p[2] < 0.55 * body.height && body.roots.size() == 1 && p[0] * p[0] + p[1] * p[1] < narrow * narrow)
        {
          shadow.pulp += part;
        }
        if (p[2] < 0.5 * body.height && p[2] > 0.0 && body.roots.size() > 1 && std::abs(p[0]) < 0.25 * body.width &&
            std::abs(p[1]) < 0.2 * body.depth)
        {
          shadow.pulp += part;
        }
      }
      if (body.bracket[0] > 0.0 && body.EvaluateBracket(p) < 0.0)
      {
        shadow.metal += step;
      }
    }
  };

  const std::size_t  pixels = static_cast<std::size_t>(size[0]) * size[1];
  std::vector<float> grey(pixels);
  ParallelFor(size[1], threads, [&](std::size_t row) {
    const double v = static_cast<double>(row);
    for (unsigned int column = 0; column < size[0]; ++column)
    {
      const double u = column;
      Shadow       shadow;
      bool         hasDirection = false;
      PointType    direction{};
      for (const Box & box : boxes)
      {
        if (u < box.begin[0] || u > box.end[0] || v < box.begin[1] || v > box.end[1])
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
        shine(box, direction, shadow);
      }
      const double      fu = u / coarse;
      const double      fv = v / coarse;
      const std::size_t iu = static_cast<std::size_t>(fu);
      const std::size_t iv = static_cast<std::size_t>(fv);
      const double      tu = fu - static_cast<double>(iu);
      const double      tv = fv - static_cast<double>(iv);
      const float *     f = &field[iv * nu + iu];
      double            sum = (1.0 - tv) * ((1.0 - tu) * f[0] + tu * f[1]) + tv * ((1.0 - tu) * f[nu] + tu * f[nu + 1]);
      sum = std::max(sum, 0.03);
      sum += 0.085 * shadow.crown + 0.044 * shadow.root - 0.035 * shadow.pulp + 0.35 * shadow.metal;
      // Ear rods: a ring with its bead.
      const double r = std::hypot(u - earRod[0], v - earRod[1]) * pixelSize;
      if (lateral)
      {
        const double ring = (r - 4.0) / 0.45;
        const double bead = std::hypot(u - earRod[0] - 4.0, v - earRod[1] - 5.0) * pixelSize;
        sum += 1.1 * std::exp(-0.5 * ring * ring) + 1.1 * SmoothStep(1.2, 0.8, bead);
      }
      else
      {
        const double x = std::abs(u - earRod[0]) * pixelSize;
        const double z = std::abs(v - earRod[1]) * pixelSize;
        sum += x > 66.0 ? 0.5 * SmoothStep(3.0, 2.2, z) * SmoothStep(64.0, 68.0, x) : 0.0;
      }
      // A film's curve: toe and shoulder.
      grey[row * size[0] + column] = static_cast<float>(6.0 + 238.0 * (1.0 - std::exp(-0.92 * sum)));
    }
  });

  // Focal spot and screen blur, then the grain, which the screen's blur does not touch.
  if (blur > 0.0)
  {
    const int           reach = static_cast<int>(std::ceil(3.0 * blur));
    std::vector<double> kernel;
    double              total = 0.0;
    for (int k = -reach; k <= reach; ++k)
    {
      kernel.push_back(std::exp(-0.5 * k * k / (blur * blur)));
      total += kernel.back();
    }
    std::vector<float> other(pixels);
    for (unsigned int pass = 0; pass < 2; ++pass)
    {
      ParallelFor(size[1], threads, [&](std::size_t row) {
        for (unsigned int column = 0; column < size[0]; ++column)
        {
          double sum = 0.0;
          for (int k = -reach; k <= reach; ++k)
          {
            const long c = pass == 0
                             ? std::min(std::max(static_cast<long>(column) + k, 0L), static_cast<long>(size[0]) - 1)
                             : static_cast<long>(column);
            const long r = pass == 1
                             ? std::min(std::max(static_cast<long>(row) + k, 0L), static_cast<long>(size[1]) - 1)
                             : static_cast<long>(row);
            sum += kernel[static_cast<std::size_t>(k + reach)] *
                   grey[static_cast<std::size_t>(r) * size[0] + static_cast<std::size_t>(c)];
          }
          other[row * size[0] + column] = static_cast<float>(sum / total);
        }
      });
      grey.swap(other);
    }
  }
  std::vector<std::uint8_t> image(pixels);
  ParallelFor(size[1], threads, [&](std::size_t row) {
    ReproducibleRandom grain(seed, 9000 + row);
    double             memory = 0.0;
    for (unsigned int column = 0; column < size[0]; ++column)
    {
      memory = 0.4 * memory + 0.917 * grain.Normal();
      const double value = grey[row * size[0] + column] + noise * memory;
      image[row * size[0] + column] = static_cast<std::uint8_t>(std::min(std::max(std::lround(value), 0L), 255L));
    }
  });
  return image;
}
} // namespace itk
