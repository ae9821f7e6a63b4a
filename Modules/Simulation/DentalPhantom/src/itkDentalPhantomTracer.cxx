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
#include "itkDentalPhantomTracer.h"

#include "itkReproducibleRandom.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
using PixelType = DentalPhantomTracer::PixelType;
using Polyline = DentalPhantomTracer::Polyline;

constexpr double Step = 0.1;

/** The largest second coordinate of triangles over a raster of the first, and which tooth has it. */
struct Envelope
{
  double                    begin{ 0.0 };
  std::vector<double>       value;
  std::vector<std::uint8_t> owner;

  Envelope(double low, double high)
    : begin(low)
    , value(static_cast<std::size_t>((high - low) / Step) + 2, -std::numeric_limits<double>::infinity())
    , owner(value.size(), 0)
  {}

  void
  Add(const PixelType corners[3], std::uint8_t fdi)
  {
    double low = corners[0][0];
    double high = low;
    for (unsigned int k = 1; k < 3; ++k)
    {
      low = std::min(low, corners[k][0]);
      high = std::max(high, corners[k][0]);
    }
    const long first = std::max(0L, static_cast<long>(std::ceil((low - begin) / Step)));
    const long last =
      std::min(static_cast<long>(value.size()) - 1, static_cast<long>(std::floor((high - begin) / Step)));
    for (long i = first; i <= last; ++i)
    {
      const double x = begin + static_cast<double>(i) * Step;
      for (unsigned int k = 0; k < 3; ++k)
      {
        const PixelType & a = corners[k];
        const PixelType & b = corners[(k + 1) % 3];
        if ((a[0] - x) * (b[0] - x) > 0.0)
        {
          continue;
        }
        const double span = b[0] - a[0];
        const double y = span == 0.0 ? std::max(a[1], b[1]) : a[1] + (x - a[0]) / span * (b[1] - a[1]);
        if (y > value[i])
        {
          value[i] = y;
          owner[i] = fdi;
        }
      }
    }
  }
};

double
Distance(const PixelType & a, const PixelType & b)
{
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

double
Length(const std::vector<PixelType> & points)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    sum += Distance(points[i - 1], points[i]);
  }
  return sum;
}

/** Equal steps of arc length over points[begin..end]. */
std::vector<PixelType>
Divide(const std::vector<PixelType> & points, std::size_t count)
{
  std::vector<PixelType> result{ points.front() };
  const double           total = Length(points);
  double                 done = 0.0;
  std::size_t            i = 1;
  for (std::size_t k = 1; k + 1 < count; ++k)
  {
    const double wanted = total * static_cast<double>(k) / static_cast<double>(count - 1);
    while (i + 1 < points.size() && done + Distance(points[i - 1], points[i]) < wanted)
    {
      done += Distance(points[i - 1], points[i]);
      ++i;
    }
    const double segment = Distance(points[i - 1], points[i]);
    const double t = segment > 0.0 ? std::min((wanted - done) / segment, 1.0) : 0.0;
    result.push_back({ { points[i - 1][0] + t * (points[i][0] - points[i - 1][0]),
                         points[i - 1][1] + t * (points[i][1] - points[i - 1][1]) } });
  }
  if (count > 1)
  {
    result.push_back(points.back());
  }
  return result;
}
} // namespace

std::vector<Polyline>
DentalPhantomTracer::TraceSide(const TriangleSurface &           surface,
                               const std::vector<std::uint8_t> & labels,
                               const std::vector<bool> &         use,
                               const PerspectiveProjection &     projection,
                               unsigned int                      jaw,
                               unsigned int                      quadrant,
                               int                               facing,
                               double                            pixelSize)
{
  // x posterior, y occlusal; for both jaws and facings alike.
  const double           xSign = -facing;
  const double           ySign = jaw == 0 ? 1.0 : -1.0;
  std::vector<PixelType> pixels(surface.points.size());
  double                 low[2] = { 1e300, 1e300 };
  double                 high[2] = { -1e300, -1e300 };
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    if (labels[i] / 10u != quadrant)
    {
      continue;
    }
    projection.Project(surface.points[i].data(), pixels[i][0], pixels[i][1]);
    pixels[i] = { { xSign * pixels[i][0], ySign * pixels[i][1] } };
    for (unsigned int d = 0; d < 2; ++d)
    {
      low[d] = std::min(low[d], pixels[i][d]);
      high[d] = std::max(high[d], pixels[i][d]);
    }
  }
  std::vector<Polyline> lines;
  if (low[0] > high[0])
  {
    return lines;
  }
  Envelope occlusal(low[0], high[0]);
  Envelope anterior(low[1], high[1]);
  for (const auto & triangle : surface.triangles)
  {
    const std::uint8_t fdi = labels[triangle[0]];
    if (fdi / 10u != quadrant || labels[triangle[1]] != fdi || labels[triangle[2]] != fdi ||
        (!use.empty() && !(use[triangle[0]] && use[triangle[1]] && use[triangle[2]])))
    {
      continue;
    }
    PixelType corners[3];
    PixelType turned[3];
    for (unsigned int k = 0; k < 3; ++k)
    {
      corners[k] = pixels[triangle[k]];
      turned[k] = { { corners[k][1], -corners[k][0] } };
    }
    occlusal.Add(corners, fdi);
    anterior.Add(turned, fdi);
  }

  const std::size_t columns = occlusal.value.size();
  for (unsigned int position = 1; position <= 8; ++position)
  {
    const auto fdi = static_cast<std::uint8_t>(10 * quadrant + position);
    // The longest run of columns in which this tooth is the outermost, closing holes of half a pixel.
    std::size_t bestBegin = 0;
    std::size_t bestEnd = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    for (std::size_t i = 0; i < columns; ++i)
    {
      if (occlusal.owner[i] != fdi)
      {
        continue;
      }
      if (end == 0 || i - end > 5)
      {
        begin = i;
      }
      end = i + 1;
      if (end - begin > bestEnd - bestBegin)
      {
        bestBegin = begin;
        bestEnd = end;
      }
    }
    if (bestEnd - bestBegin < 10)
    {
      continue;
    }
    std::size_t top = bestBegin;
    for (std::size_t i = bestBegin; i < bestEnd; ++i)
    {
      if (occlusal.owner[i] == fdi && occlusal.value[i] > occlusal.value[top])
      {
        top = i;
      }
    }
    // The border ends where the side of the crown begins: nobody draws into the contact.
    const double deepest = occlusal.value[top] - 3.0 / pixelSize;
    std::size_t  first = top;
    std::size_t  last = top;
    while (first > bestBegin && (occlusal.owner[first - 1] != fdi || occlusal.value[first - 1] > deepest))
    {
      --first;
    }
    while (last + 1 < bestEnd && (occlusal.owner[last + 1] != fdi || occlusal.value[last + 1] > deepest))
    {
      ++last;
    }

    Polyline line;
    line.fdi = fdi;
    if (position == 1)
    {
      // Up the labial border from the edge, until the border jumps back: there the gingiva begins. Where the lateral
      // incisor stands in front it is its border that is seen and drawn.
      const long             start = static_cast<long>((occlusal.value[top] - anterior.begin) / Step);
      std::vector<PixelType> labial;
      double                 before = 0.0;
      for (long i = std::min(start, static_cast<long>(anterior.value.size()) - 1); i >= 0; --i)
      {
        if (anterior.owner[i] == 0 && labial.empty())
        {
          continue;
        }
        const double x = -anterior.value[i];
        if (anterior.owner[i] % 10 > 2 || anterior.owner[i] == 0 ||
            (!labial.empty() && std::abs(x - before) > (labial.size() < 10 ? 8.0 : 1.0)))
        {
          break;
        }
        before = x;
        labial.push_back({ { x, anterior.begin + static_cast<double>(i) * Step } });
      }
      line.points.assign(labial.rbegin(), labial.rend());
      if (!labial.empty())
      {
        first = std::max(first, top);
      }
    }
    line.corner = line.points.size();
    for (std::size_t i = first; i <= last; ++i)
    {
      if (occlusal.owner[i] == fdi)
      {
        line.points.push_back({ { occlusal.begin + static_cast<double>(i) * Step, occlusal.value[i] } });
      }
    }
    for (PixelType & p : line.points)
    {
      p = { { xSign * p[0], ySign * p[1] } };
    }
    if (line.points.size() > 1)
    {
      lines.push_back(line);
    }
  }
  return lines;
}

std::vector<Polyline>
DentalPhantomTracer::Bisect(const std::vector<Polyline> & right, const std::vector<Polyline> & left)
{
  constexpr std::size_t count = 200;
  std::vector<Polyline> result;
  for (const Polyline & a : right)
  {
    for (const Polyline & b : left)
    {
      if (a.fdi % 10 != b.fdi % 10)
      {
        continue;
      }
      Polyline   line;
      const auto middle = [&line](const std::vector<PixelType> & p, const std::vector<PixelType> & q) {
        const auto first = Divide(p, count);
        const auto second = Divide(q, count);
        for (std::size_t i = 0; i < count; ++i)
        {
          line.points.push_back({ { 0.5 * (first[i][0] + second[i][0]), 0.5 * (first[i][1] + second[i][1]) } });
        }
      };
      line.fdi = a.fdi;
      // The labial border and the edge are matched apart.
      if (a.corner > 1 && b.corner > 1)
      {
        middle({ a.points.begin(), a.points.begin() + static_cast<long>(a.corner) },
               { b.points.begin(), b.points.begin() + static_cast<long>(b.corner) });
        line.corner = count;
      }
      if (a.corner + 1 < a.points.size() && b.corner + 1 < b.points.size())
      {
        middle({ a.points.begin() + static_cast<long>(a.corner), a.points.end() },
               { b.points.begin() + static_cast<long>(b.corner), b.points.end() });
      }
      result.push_back(line);
    }
  }
  return result;
}

std::vector<Polyline>
DentalPhantomTracer::Resample(const std::vector<Polyline> & lines, unsigned int numberOfPoints)
{
  std::vector<Polyline> result;
  double                total = 0.0;
  for (const Polyline & line : lines)
  {
    total += Length(line.points);
  }
  // Largest remainders, two for each line beforehand.
  const double free = std::max(0.0, static_cast<double>(numberOfPoints) - 2.0 * static_cast<double>(lines.size()));
  std::vector<std::size_t>                    counts;
  std::vector<std::pair<double, std::size_t>> remainders;
  std::size_t                                 given = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const double share = total > 0.0 ? free * Length(lines[i].points) / total : 0.0;
    counts.push_back(2 + static_cast<std::size_t>(share));
    given += counts.back();
    remainders.push_back({ std::floor(share) - share, i });
  }
  std::sort(remainders.begin(), remainders.end());
  for (std::size_t i = 0; i < remainders.size() && given < numberOfPoints; ++i, ++given)
  {
    ++counts[remainders[i].second];
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    Polyline line;
    line.fdi = lines[i].fdi;
    line.points = Divide(lines[i].points, counts[i]);
    result.push_back(line);
  }
  return result;
}

void
DentalPhantomTracer::AddNoise(std::vector<Polyline> & lines,
                              const Noise &           noise,
                              std::uint64_t           seed,
                              std::uint64_t           stream)
{
  ReproducibleRandom random(seed, stream);
  double             length = 0.0;
  PixelType          before{};
  for (const Polyline & line : lines)
  {
    for (const PixelType & p : line.points)
    {
      length += &p == &lines.front().points.front() ? 0.0 : Distance(before, p);
      before = p;
    }
  }
  // The drift: white noise on a raster, smoothed by a Gaussian whose self-convolution has the wanted width.
  constexpr double    raster = 0.5;
  const double        sigma = noise.correlationLength / std::sqrt(2.0);
  const long          reach = static_cast<long>(std::ceil(4.0 * sigma / raster));
  std::vector<double> kernel;
  double              energy = 0.0;
  for (long k = -reach; k <= reach; ++k)
  {
    const double t = static_cast<double>(k) * raster / sigma;
    kernel.push_back(std::exp(-0.5 * t * t));
    energy += kernel.back() * kernel.back();
  }
  const std::size_t      samples = static_cast<std::size_t>(length / raster) + 2 + 2 * static_cast<std::size_t>(reach);
  std::vector<PixelType> white(samples);
  for (PixelType & w : white)
  {
    w[0] = random.Normal();
    w[1] = random.Normal();
  }
  const auto drift = [&](double s) {
    // Between two raster positions linearly: they are far closer than the width.
    const double      t = s / raster;
    const std::size_t i = static_cast<std::size_t>(t);
    const double      a = t - static_cast<double>(i);
    PixelType         sum{};
    for (std::size_t k = 0; k < kernel.size(); ++k)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        sum[d] += kernel[k] * ((1.0 - a) * white[i + k][d] + a * white[std::min(i + k + 1, samples - 1)][d]);
      }
    }
    // Interpolation between neighbours loses next to no variance: their correlation is 1 - 1e-3.
    return PixelType{ { sum[0] / std::sqrt(energy), sum[1] / std::sqrt(energy) } };
  };
  // Arc length of the true lines, gaps included: the hand drifts over them as well.
  double s = 0.0;
  bool   first = true;
  for (Polyline & line : lines)
  {
    PixelType centre{};
    for (const PixelType & p : line.points)
    {
      centre[0] += p[0] / static_cast<double>(line.points.size());
      centre[1] += p[1] / static_cast<double>(line.points.size());
    }
    const double du = noise.toothShift * random.Normal();
    const double dv = noise.toothShift * random.Normal();
    const double turn = noise.toothRotation * random.Normal();
    const double grow = noise.toothScale * random.Normal();
    const double c = (1.0 + grow) * std::cos(turn);
    const double e = (1.0 + grow) * std::sin(turn);
    for (PixelType & p : line.points)
    {
      s += first ? 0.0 : Distance(before, p);
      first = false;
      before = p;
      const PixelType r = { { p[0] - centre[0], p[1] - centre[1] } };
      const PixelType d = drift(s);
      const double    wu = random.Normal();
      const double    wv = random.Normal();
      p[0] = centre[0] + du + c * r[0] - e * r[1] + noise.correlated * d[0] + noise.white * wu;
      p[1] = centre[1] + dv + e * r[0] + c * r[1] + noise.correlated * d[1] + noise.white * wv;
      p[0] = std::nearbyint(p[0] * 1e3) / 1e3;
      p[1] = std::nearbyint(p[1] * 1e3) / 1e3;
    }
  }
}
} // namespace itk
