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
#include "itkDentalPhantomModel.h"

#include "itkParallelFor.h"
#include "itkReproducibleRandom.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
constexpr double ArchStep = 0.05;
constexpr double ArchLength = 90.0;
constexpr double HalfPi = 1.5707963267948966;
/** Angle by which the fan goes below the horizontal. */
constexpr double FanAngle = HalfPi;

double
Clamp(double value, double low, double high)
{
  return std::min(std::max(value, low), high);
}

double
SmoothStep(double low, double high, double value)
{
  const double t = Clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/** Polynomial smooth maximum: rounds the edge where two bodies are cut, over a width of k. */
double
SmoothMax(double a, double b, double k)
{
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::max(a, b) + h * h * k * 0.25;
}

double
SmoothMin(double a, double b, double k)
{
  return -SmoothMax(-a, -b, k);
}

/** Coordinates on a raster of 1e-4 mm, so that the last bits of a mathematical library do not reach a file. */
double
Quantise(double value)
{
  return std::nearbyint(value * 1e4) / 1e4;
}

/** Ears of a simple polygon in the plane, best shaped first, in the polygon's own order of corners. */
std::vector<std::array<std::size_t, 3>>
ClipEars(const std::vector<std::array<double, 2>> & polygon)
{
  std::vector<std::size_t> left(polygon.size());
  double                   area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    left[i] = i;
    const auto & a = polygon[i];
    const auto & b = polygon[(i + 1) % polygon.size()];
    area += a[0] * b[1] - b[0] * a[1];
  }
  const double sign = area < 0.0 ? -1.0 : 1.0;
  const auto   cross = [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto & a = polygon[i];
    const auto & b = polygon[j];
    const auto & c = polygon[k];
    return sign * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
  };
  const auto quality = [&](std::size_t at) {
    const std::size_t n = left.size();
    const std::size_t i = left[(at + n - 1) % n];
    const std::size_t j = left[at];
    const std::size_t k = left[(at + 1) % n];
    const double      doubled = cross(i, j, k);
    if (doubled <= 1e-9)
    {
      return doubled - 1.0;
    }
    for (const std::size_t p : left)
    {
      if (p != i && p != j && p != k && cross(i, j, p) >= 0.0 && cross(j, k, p) >= 0.0 && cross(k, i, p) >= 0.0)
      {
        return -2.0;
      }
    }
    double longest = 0.0;
    for (const auto & side : { std::make_pair(i, j), std::make_pair(j, k), std::make_pair(k, i) })
    {
      const double dx = polygon[side.first][0] - polygon[side.second][0];
      const double dy = polygon[side.first][1] - polygon[side.second][1];
      longest = std::max(longest, dx * dx + dy * dy);
    }
    return doubled / longest;
  };
  std::vector<std::array<std::size_t, 3>> ears;
  std::vector<double>                     qualities;
  for (std::size_t at = 0; at < left.size(); ++at)
  {
    qualities.push_back(quality(at));
  }
  while (left.size() > 2)
  {
    const auto        best = std::max_element(qualities.begin(), qualities.end());
    const std::size_t at = static_cast<std::size_t>(best - qualities.begin());
    const std::size_t n = left.size();
    ears.push_back({ { left[(at + n - 1) % n], left[at], left[(at + 1) % n] } });
    left.erase(left.begin() + static_cast<long>(at));
    qualities.erase(best);
    // Neighbours change shape; corners that the clipped one blocked may be free: all that were blocked are asked again.
    for (std::size_t k = 0; k < left.size(); ++k)
    {
      if (k == at % left.size() || k == (at + left.size() - 1) % left.size() || qualities[k] == -2.0)
      {
        qualities[k] = quality(k);
      }
    }
  }
  return ears;
}
} // namespace

DentalPhantomModel::Profile::Profile(std::vector<double> xs, std::vector<double> ys)
  : x(std::move(xs))
  , y(std::move(ys))
  , slope(x.size())
{
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t a = i == 0 ? 0 : i - 1;
    const std::size_t b = i + 1 == n ? i : i + 1;
    slope[i] = (y[b] - y[a]) / (x[b] - x[a]);
  }
}

double
DentalPhantomModel::Profile::operator()(double t) const
{
  if (t <= x.front())
  {
    return y.front();
  }
  if (t >= x.back())
  {
    return y.back();
  }
  std::size_t i = 0;
  while (t > x[i + 1])
  {
    ++i;
  }
  const double h = x[i + 1] - x[i];
  const double a = (t - x[i]) / h;
  const double b = 1.0 - a;
  return b * b * (1.0 + 2.0 * a) * y[i] + a * a * (3.0 - 2.0 * a) * y[i + 1] + a * b * b * h * slope[i] -
         a * a * b * h * slope[i + 1];
}

auto
DentalPhantomModel::Body::ToLocal(const PointType & p) const -> PointType
{
  const double d[3] = { p[0] - cervix[0], p[1] - cervix[1], p[2] - cervix[2] };
  PointType    local;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    local[axis] = axes[axis][0] * d[0] + axes[axis][1] * d[1] + axes[axis][2] * d[2];
  }
  return local;
}

auto
DentalPhantomModel::Body::ToJaw(const PointType & local) const -> PointType
{
  PointType p;
  for (unsigned int d = 0; d < 3; ++d)
  {
    p[d] = cervix[d] + axes[0][d] * local[0] + axes[1][d] * local[1] + axes[2][d] * local[2];
  }
  return p;
}

double
DentalPhantomModel::Body::OcclusalHeight(double x, double y) const
{
  if (kind == 0)
  {
    const double a = x / (0.5 * width);
    const double corner = a < 0.0 ? cornerDistal : cornerMesial;
    const double a2 = a * a;
    return height - corner * a2 * a2 - 0.15 * a2;
  }
  // Rounded cones; their smooth maximum makes ridges, and fissures where two meet.
  double top = -std::numeric_limits<double>::infinity();
  for (const Cusp & cusp : cusps)
  {
    const double     dx = cusp.slopeX * (x - cusp.x);
    const double     dy = cusp.slopeY * (y - cusp.y);
    constexpr double round = 0.3;
    const double     cone = cusp.height - (std::sqrt(dx * dx + dy * dy + round * round) - round);
    top = top < cone - 1.0 ? cone : SmoothMax(top, cone, 0.35);
  }
  return top;
}

double
DentalPhantomModel::Body::Evaluate(const PointType & local, bool root) const
{
  const double x = local[0];
  const double y = local[1];
  const double z = local[2];
  const double h = Clamp(z / height, 0.0, 1.0);
  double       a = 0.5 * width * mesiodistal(h);
  double       front = depth * buccal(h);
  double       back = depth * lingual(h);
  if (z < 0.0)
  {
    const double shrink = root ? std::max(0.15, 1.0 - 0.8 * z * z / (rootLength * rootLength)) : 1.0;
    a *= shrink;
    front *= shrink;
    back *= shrink;
  }
  const double centre = 0.5 * (front + back);
  const double b = 0.5 * (front - back);
  const double dy = y - centre;
  const double r = std::sqrt(x * x + dy * dy);
  double       side = -std::min(a, b);
  if (r > 1e-6)
  {
    // A squircle (Fernandez Guasti) in the section's own proportions; square roots only, so the same bits everywhere.
    const double X = x / a;
    const double Y = dy / b;
    const double sum = X * X + Y * Y;
    const double rho = std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4.0 * squareness * X * X * Y * Y))));
    side = std::max(side, r - r / rho);
  }
  const double top = 0.85 * (z - this->OcclusalHeight(x, y));
  const double crown = SmoothMax(side, top, smoothness);
  // A scan ends a little below the gingiva's margin; a radiograph sees the root.
  return std::max(crown, root ? -rootLength - z : -1.0 - z);
}

DentalPhantomModel::DentalPhantomModel(const DentalPhantomParameters & parameters, unsigned int threads)
  : m_Parameters(parameters)
{
  m_Parameters.Validate();
  this->MakeArch();
  this->PlaceTeeth(0);
  this->PlaceTeeth(1);
  this->Settle(threads);
}

std::uint8_t
DentalPhantomModel::ToothFDI(unsigned int jaw, unsigned int tooth)
{
  const unsigned int left = tooth / 7;
  const unsigned int quadrant = jaw == 0 ? 1 + left : 4 - left;
  return static_cast<std::uint8_t>(10 * quadrant + tooth % 7 + 1);
}

double
DentalPhantomModel::HalfLength(unsigned int jaw, unsigned int side) const
{
  double sum = 0.0;
  for (unsigned int k = 0; k < 7; ++k)
  {
    const DentalPhantomTooth & tooth = m_Parameters.jaws[jaw].teeth[7 * side + k];
    sum += tooth.mesiodistal + tooth.mesialGap;
  }
  return sum;
}

void
DentalPhantomModel::MakeArch()
{
  const double p = m_Parameters.archExponent;
  const double power = 2.0 / p;
  const double coverage = m_Parameters.archCoverage;
  const double width = m_Parameters.archHalfWidth / std::pow(std::sin(coverage), power);
  const double length = 0.5 * (this->HalfLength(0, 0) + this->HalfLength(0, 1));

  constexpr unsigned int             samples = 6000;
  std::vector<std::array<double, 2>> unit(samples + 1);
  for (unsigned int i = 0; i <= samples; ++i)
  {
    // Cubic steps: an exponent above 2 moves fast near the midline.
    const double t = static_cast<double>(i) / samples;
    const double angle = coverage * t * t;
    unit[i] = { { std::pow(std::cos(angle), power), std::pow(std::sin(angle), power) } };
  }
  const auto measure = [&](double depth) {
    double sum = 0.0;
    for (unsigned int i = 1; i <= samples; ++i)
    {
      const double dx = depth * (unit[i][0] - unit[i - 1][0]);
      const double dy = width * (unit[i][1] - unit[i - 1][1]);
      sum += std::sqrt(dx * dx + dy * dy);
    }
    return sum;
  };
  double low = 5.0;
  double high = 150.0;
  for (unsigned int i = 0; i < 50; ++i)
  {
    const double middle = 0.5 * (low + high);
    (measure(middle) < length ? low : high) = middle;
  }
  const double depth = 0.5 * (low + high);

  // The molars' ends lie at x = 0, the front at positive x; straight on behind them.
  std::vector<std::array<double, 2>> upper;
  for (unsigned int i = 0; i <= samples; ++i)
  {
    upper.push_back({ { depth * (unit[i][0] - unit[samples][0]), width * unit[i][1] } });
  }
  std::array<double, 2> direction = { { upper[samples][0] - upper[samples - 20][0],
                                        upper[samples][1] - upper[samples - 20][1] } };
  const double          norm = std::hypot(direction[0], direction[1]);
  const auto            end = upper.back();
  upper.push_back({ { end[0] + 60.0 * direction[0] / norm, end[1] + 60.0 * direction[1] / norm } });

  const auto resample = [](const std::vector<std::array<double, 2>> & line, Jaw & jaw) {
    jaw.curve.clear();
    double      next = 0.0;
    double      done = 0.0;
    std::size_t i = 1;
    while (next <= ArchLength)
    {
      double segment = std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
      while (done + segment < next && i + 1 < line.size())
      {
        done += segment;
        ++i;
        segment = std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
      }
      const double t = segment > 0.0 ? (next - done) / segment : 0.0;
      jaw.curve.push_back(
        { { line[i - 1][0] + t * (line[i][0] - line[i - 1][0]), line[i - 1][1] + t * (line[i][1] - line[i - 1][1]) } });
      next += ArchStep;
    }
    const int n = static_cast<int>(jaw.curve.size());
    jaw.normals.resize(jaw.curve.size());
    // A wide window: the normals guide a grid, they need not follow every bend.
    constexpr int window = 60;
    const auto    at = [&](int k) {
      std::array<double, 2> q = jaw.curve[std::min(std::abs(k), n - 1)];
      if (k < 0)
      {
        q[1] = -q[1];
      }
      return q;
    };
    for (int k = 0; k < n; ++k)
    {
      const auto   a = at(k - window);
      const auto   b = at(std::min(k + window, n - 1));
      const double tx = b[0] - a[0];
      const double ty = b[1] - a[1];
      const double l = std::hypot(tx, ty);
      jaw.normals[k] = { { ty / l, -tx / l } };
    }
  };
  resample(upper, m_Jaws[0]);

  // The lower arch runs inside the upper one: by the overjet in front, half a cusp at the side.
  const double                       posterior = 0.23 * m_Parameters.jaws[0].teeth[5].buccolingual;
  std::vector<std::array<double, 2>> lower;
  for (std::size_t k = 0; k < m_Jaws[0].curve.size(); ++k)
  {
    const double s = k * ArchStep;
    const double inward = m_Parameters.overjet + (posterior - m_Parameters.overjet) * SmoothStep(8.0, 28.0, s);
    const auto & q = m_Jaws[0].curve[k];
    const auto & n = m_Jaws[0].normals[k];
    lower.push_back({ { q[0] - inward * n[0], k == 0 ? 0.0 : q[1] - inward * n[1] } });
  }
  resample(lower, m_Jaws[1]);
}

void
DentalPhantomModel::ArchPoint(unsigned int jaw, double s, double point[2], double normal[2]) const
{
  const Jaw &       arch = m_Jaws[jaw];
  const double      t = std::abs(s) / ArchStep;
  const std::size_t k = std::min(static_cast<std::size_t>(t), arch.curve.size() - 2);
  const double      a = t - static_cast<double>(k);
  const double      sign = s < 0.0 ? -1.0 : 1.0;
  for (unsigned int d = 0; d < 2; ++d)
  {
    point[d] = arch.curve[k][d] + a * (arch.curve[k + 1][d] - arch.curve[k][d]);
    normal[d] = arch.normals[k][d] + a * (arch.normals[k + 1][d] - arch.normals[k][d]);
  }
  const double l = std::hypot(normal[0], normal[1]);
  normal[0] /= l;
  normal[1] *= sign / l;
  point[1] *= sign;
}

void
DentalPhantomModel::PlaceTeeth(unsigned int jaw)
{
  const DentalPhantomJaw & source = m_Parameters.jaws[jaw];
  for (unsigned int i = 0; i < 14; ++i)
  {
    const DentalPhantomTooth & tooth = source.teeth[i];
    Body &                     body = m_Jaws[jaw].bodies[i];
    const unsigned int         k = i % 7;
    const double               side = i < 7 ? -1.0 : 1.0;
    const double               W = tooth.mesiodistal;
    const double               B = tooth.buccolingual;
    const double               H = tooth.height;
    body.present = !tooth.missing;
    body.width = W;
    body.depth = B;
    body.height = H;
    body.kind = k < 2 ? 0 : k == 2 ? 1 : k < 5 ? 2 : 3;
    double pivotY = 0.0;
    if (k < 3)
    {
      const bool   canine = k == 2;
      const double edge = canine ? 0.16 : 0.19;
      const double half = canine ? 0.11 : 0.085;
      body.mesiodistal = canine ? Profile({ 0.0, 0.3, 0.65, 0.85, 1.0 }, { 0.74, 0.9, 1.0, 0.93, 0.7 })
                                : Profile({ 0.0, 0.3, 0.75, 0.92, 1.0 }, { 0.70, 0.85, 1.0, 0.985, 0.94 });
      body.buccal = Profile({ 0.0, 0.15, 0.45, 0.75, 1.0 }, { 0.44, 0.485, 0.47, 0.39, edge + half });
      body.lingual = canine
                       ? Profile({ 0.0, 0.15, 0.35, 0.6, 0.85, 1.0 }, { -0.45, -0.5, -0.42, -0.2, -0.02, edge - half })
                       : Profile({ 0.0, 0.15, 0.35, 0.6, 0.85, 1.0 }, { -0.45, -0.5, -0.38, -0.12, 0.05, edge - half });
      body.squareness = canine ? 0.32 : 0.55;
      body.smoothness = 0.35;
      body.cornerMesial = 0.03 * W;
      body.cornerDistal = (k == 1 && jaw == 0 ? 0.16 : jaw == 0 ? 0.1 : 0.05) * W;
      body.edge = edge * B;
      pivotY = body.edge;
      body.rootLength = canine ? 16.0 : 12.5;
      if (canine)
      {
        body.cusps = { { 0.05 * W, body.edge, H, 0.55, 0.4, "cusp" } };
      }
    }
    else
    {
      body.mesiodistal = Profile({ 0.0, 0.35, 0.68, 0.88, 1.0 }, { 0.76, 0.92, 1.0, 0.96, 0.84 });
      body.buccal = Profile({ 0.0, 0.25, 0.6, 1.0 }, { 0.44, 0.5, 0.455, 0.33 });
      body.lingual = Profile({ 0.0, 0.4, 0.7, 1.0 }, { -0.43, -0.5, -0.47, -0.35 });
      body.smoothness = 0.5;
      body.rootLength = k < 5 ? 13.5 : 12.0;
      if (k < 5)
      {
        body.squareness = 0.39;
        const double drop = jaw == 0 ? (k == 3 ? 0.9 : 0.4) : (k == 3 ? 2.6 : 0.9);
        body.cusps = { { 0.02 * W, 0.25 * B, H, 0.62, 0.55, "B" },
                       { 0.06 * W, -0.26 * B, H - drop * H / 8.5, 0.6, 0.55, "L" } };
      }
      else
      {
        body.squareness = 0.65;
        const double u = H / 7.5;
        if (jaw == 0)
        {
          body.cusps = { { 0.23 * W, 0.26 * B, H, 0.62, 0.5, "MB" },
                         { -0.22 * W, 0.25 * B, H - 0.35 * u, 0.62, 0.5, "DB" },
                         { 0.15 * W, -0.25 * B, H - 0.1 * u, 0.5, 0.5, "ML" },
                         { -0.29 * W, -0.26 * B, H - (k == 5 ? 0.8 : 1.4) * u, 0.55, 0.55, "DL" } };
        }
        else
        {
          body.cusps = { { 0.26 * W, 0.25 * B, H, 0.62, 0.5, "MB" },
                         { (k == 5 ? -0.07 : -0.22) * W, 0.27 * B, H - 0.25 * u, 0.62, 0.5, "DB" },
                         { 0.24 * W, -0.26 * B, H - 0.2 * u, 0.6, 0.55, "ML" },
                         { -0.22 * W, -0.26 * B, H - 0.4 * u, 0.6, 0.55, "DL" } };
          if (k == 5)
          {
            body.cusps.push_back({ -0.36 * W, 0.13 * B, H - 0.8 * u, 0.65, 0.55, "D" });
          }
        }
      }
    }

    // Along the arch.
    double begin = 0.0;
    for (unsigned int m = 0; m < k; ++m)
    {
      begin += source.teeth[i - k + m].mesialGap + source.teeth[i - k + m].mesiodistal;
    }
    begin += tooth.mesialGap;
    body.begin = side < 0.0 ? -(begin + W) : begin;
    body.end = side < 0.0 ? -begin : begin + W;
    const double s = side * (begin + 0.5 * W);
    double       point[2];
    double       normal[2];
    this->ArchPoint(jaw, s, point, normal);
    // Of the chord, not of the arch's smooth guide.
    double a[2];
    double b[2];
    double unused[2];
    this->ArchPoint(jaw, body.begin, a, unused);
    this->ArchPoint(jaw, body.end, b, unused);
    // From right to left; outward is to its right-hand side seen from above.
    double tangent[2] = { b[0] - a[0], b[1] - a[1] };
    double l = std::hypot(tangent[0], tangent[1]);
    tangent[0] /= l;
    tangent[1] /= l;
    const double outward[3] = { tangent[1], -tangent[0], 0.0 };
    const double mesial[3] = { -side * tangent[0], -side * tangent[1], 0.0 };
    const double occlusal[3] = { 0.0, 0.0, 1.0 };

    const double spee = std::sin(3.141592653589793 * std::min(std::abs(s) / 60.0, 1.0));
    const double plane = -m_Parameters.speeDepth * spee * spee;
    const double over = k < 2 ? 0.5 * m_Parameters.overbite : k == 2 ? 0.25 * m_Parameters.overbite + 0.6 : 0.6;
    const double level = (jaw == 0 ? -plane : plane) + over + tooth.occlusalOffset;

    const double torque = tooth.torque * (k < 3 ? 1.0 : m_Parameters.wilson);
    const double ct = std::cos(torque);
    const double st = std::sin(torque);
    const double cp = std::cos(tooth.tip);
    const double sp = std::sin(tooth.tip);
    const double cr = std::cos(tooth.rotation);
    const double sr = std::sin(tooth.rotation);
    const auto   turn = [&](const PointType & v) {
      const PointType r = { { cr * v[0] - sr * v[1], sr * v[0] + cr * v[1], v[2] } };
      const PointType t = { { cp * r[0] + sp * r[2], r[1], -sp * r[0] + cp * r[2] } };
      return PointType{ { t[0], ct * t[1] + st * t[2], -st * t[1] + ct * t[2] } };
    };
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      PointType v{};
      v[axis] = 1.0;
      const PointType t = turn(v);
      for (unsigned int d = 0; d < 3; ++d)
      {
        body.axes[axis][d] = t[0] * mesial[d] + t[1] * outward[d] + t[2] * occlusal[d];
      }
    }
    // Turned about the edge or the occlusal surface, so that the arch line holds what the teeth show.
    const double target[3] = { point[0] + tooth.buccalOffset * outward[0],
                               point[1] + tooth.buccalOffset * outward[1],
                               level };
    for (unsigned int d = 0; d < 3; ++d)
    {
      body.cervix[d] = target[d] - body.axes[1][d] * pivotY - body.axes[2][d] * H;
    }
    body.centre = body.ToJaw({ { 0.0, 0.0, 0.5 * H } });
    body.radius = std::sqrt(0.25 * W * W + 0.25 * B * B + 0.25 * H * H) + 1.0;
  }
}

auto
DentalPhantomModel::MakeStation(unsigned int jaw, double s) const -> Station
{
  const DentalPhantomJaw & source = m_Parameters.jaws[jaw];
  Station                  station;
  double                   point[2];
  this->ArchPoint(jaw, s, point, station.normal);

  // Smooth along the arch: where the cervices are, how thick the teeth are there, how high the papillae.
  double sum = 0.0;
  double lateral = 0.0;
  double level = 0.0;
  double buccal = 0.0;
  double lingual = 0.0;
  double papilla = 0.0;
  double scallop = 1.0;
  double gingivaTop = 0.0;
  for (unsigned int i = 0; i < 14; ++i)
  {
    const Body & body = m_Jaws[jaw].bodies[i];
    const double c = 0.5 * (body.begin + body.end);
    // Beyond the last tooth everything stays as at the last tooth.
    const double first = 0.5 * (m_Jaws[jaw].bodies[6].begin + m_Jaws[jaw].bodies[6].end);
    const double last = 0.5 * (m_Jaws[jaw].bodies[13].begin + m_Jaws[jaw].bodies[13].end);
    const double d = (Clamp(s, first, last) - c) / 3.5;
    const double w = std::exp(-0.5 * d * d) + 1e-12;
    double       q[2];
    double       n[2];
    this->ArchPoint(jaw, c, q, n);
    const double offset = (body.cervix[0] - q[0]) * n[0] + (body.cervix[1] - q[1]) * n[1];
    sum += w;
    lateral += w * offset;
    level += w * body.cervix[2];
    buccal += w * 0.44 * body.depth;
    lingual += w * 0.45 * body.depth;
    papilla += w * (body.present ? (i % 7 < 3 ? 2.4 : 1.5) : 0.2);
    const double a = std::abs(s - c) / (0.5 * (body.end - body.begin));
    if (a < scallop)
    {
      scallop = a;
    }
  }
  lateral /= sum;
  level /= sum;
  papilla /= sum;
  const double firstEnd = m_Jaws[jaw].bodies[6].begin;
  const double lastEnd = m_Jaws[jaw].bodies[13].end;
  const double beyond = std::max({ 0.0, firstEnd - s, s - lastEnd });
  gingivaTop = 0.8 + papilla * scallop * scallop * (1.0 - SmoothStep(0.0, 2.5, beyond));

  station.origin = { { point[0] + lateral * station.normal[0], point[1] + lateral * station.normal[1], level } };
  station.buccalExtent = buccal / sum + 0.6;
  station.lingualExtent = lingual / sum + 0.6;
  station.crest = gingivaTop;

  // Neighbouring stations' planes meet at the arch's centre of curvature: stay on this side of it.
  double before[2];
  double after[2];
  double normalBefore[2];
  double normalAfter[2];
  this->ArchPoint(jaw, s - 5.0, before, normalBefore);
  this->ArchPoint(jaw, s + 5.0, after, normalAfter);
  const double bend = std::hypot(normalAfter[0] - normalBefore[0], normalAfter[1] - normalBefore[1]);
  const double radius = 10.0 / std::max(bend, 1e-3);
  station.lingualExtent = std::min(station.lingualExtent, std::max(1.5, radius + lateral - 5.0));

  const double wave = source.trimWave * (std::sin(0.23 * s + source.trimPhase) + 0.5 * std::sin(0.61 * s));
  const double slope = source.trimSlopeAnterior * (point[0] - 22.0) + source.trimSlopeLeft * point[1];
  station.buccalFlange = std::max(1.0, source.buccalFlange + slope + wave);
  station.lingualFlange = source.palate ? 2.0 : std::max(1.0, source.lingualFlange + slope - 0.6 * wave);

  station.numberOfNear = 0;
  for (unsigned int i = 0; i < 14; ++i)
  {
    const Body & body = m_Jaws[jaw].bodies[i];
    if (body.present && s > body.begin - 5.0 && s < body.end + 5.0 && station.numberOfNear < 6)
    {
      station.near[station.numberOfNear++] = static_cast<int>(i);
    }
  }
  return station;
}

double
DentalPhantomModel::Gingiva(unsigned int jaw, const Station & station, double q, double o) const
{
  // Flares apically, most on the palatal side; the papilla narrows occlusally.
  const double down = std::max(-o, 0.0);
  const double up = std::max(o, 0.0);
  const double buccal = station.buccalExtent + 0.12 * down - 0.3 * up;
  const double lingual =
    station.lingualExtent + (jaw == 0 || m_Parameters.jaws[jaw].palate ? 0.3 : 0.05) * down - 0.3 * up;
  return SmoothMax(std::max(q - buccal, -q - lingual), o - station.crest, 1.6);
}

auto
DentalPhantomModel::MakeJaw(unsigned int jaw, unsigned int threads, const ProgressType & progress) const -> JawSurface
{
  return this->MakeJaw(jaw, m_Parameters.numberOfTriangles, true, threads, progress);
}

auto
DentalPhantomModel::MakeJaw(unsigned int         jaw,
                            std::uint32_t        numberOfTriangles,
                            bool                 finish,
                            unsigned int         threads,
                            const ProgressType & progress) const -> JawSurface
{
  const DentalPhantomJaw & source = m_Parameters.jaws[jaw];
  const double             lengths[2] = { -m_Jaws[jaw].bodies[6].begin + source.distalExtension[0],
                                          m_Jaws[jaw].bodies[13].end + source.distalExtension[1] };
  // Rows and columns that give the wanted number of triangles with about square cells.
  const double fan = 27.0;
  const double palateLength = source.palate ? 20.0 : 0.0;
  const double lingualFlange = source.palate ? 2.0 : source.lingualFlange;
  // The base is coarser by half.
  const double wall = m_Parameters.baseHeight + 3.0;
  const double ground = 14.0;
  const double baseLength = m_Parameters.stoneBase ? 0.5 * ((source.palate ? 1.0 : 2.0) * wall + ground) : 0.0;
  const double profile = fan + source.buccalFlange + lingualFlange + palateLength + baseLength;
  const double cell = std::sqrt(2.0 * (lengths[0] + lengths[1]) * profile / numberOfTriangles);
  const int    buccalRows = std::max(1, static_cast<int>(std::lround(source.buccalFlange / cell)));
  const int    fanRows = std::max(6, static_cast<int>(std::lround(fan / cell)));
  const int    lingualRows = std::max(1, static_cast<int>(std::lround(lingualFlange / cell)));
  const int    palateRows = source.palate ? std::max(2, static_cast<int>(std::lround(palateLength / cell))) : 0;
  const int    wallRows = std::max(2, static_cast<int>(std::lround(0.5 * wall / cell)));
  const int    bottomRows = std::max(2, static_cast<int>(std::lround(0.5 * ground / cell)));
  const int    baseRows = m_Parameters.stoneBase ? (source.palate ? 1 : 2) * wallRows + bottomRows : 0;
  const int    rows = buccalRows + fanRows + lingualRows;
  const int    half =
    std::max(8, static_cast<int>(std::lround(numberOfTriangles / (4.0 * (rows + palateRows + baseRows)))));
  const int columns = 2 * half + 1;

  // Denser columns between the teeth, where the surface dives.
  std::vector<double> stations(columns, 0.0);
  for (unsigned int side = 0; side < 2; ++side)
  {
    std::vector<double> cumulative{ 0.0 };
    constexpr double    step = 0.05;
    const int           n = std::max(2, static_cast<int>(lengths[side] / step));
    for (int k = 0; k < n; ++k)
    {
      const double s = (side == 0 ? -1.0 : 1.0) * lengths[side] * (k + 0.5) / n;
      double       nearest = 1e9;
      for (const Body & body : m_Jaws[jaw].bodies)
      {
        nearest = std::min({ nearest, std::abs(s - body.begin), std::abs(s - body.end) });
      }
      cumulative.push_back(cumulative.back() + 1.0 + 1.2 * std::exp(-nearest * nearest / 0.8));
    }
    int k = 0;
    for (int i = 1; i <= half; ++i)
    {
      const double wanted = cumulative.back() * i / half;
      while (k + 1 < n && cumulative[k + 1] < wanted)
      {
        ++k;
      }
      const double t = Clamp((wanted - cumulative[k]) / (cumulative[k + 1] - cumulative[k]), 0.0, 1.0);
      stations[side == 0 ? half - i : half + i] = (side == 0 ? -1.0 : 1.0) * lengths[side] * (k + t) / n;
    }
  }
  // Denser rays upward, where the surface is far from the fan's centre.
  std::vector<double> angles(fanRows + 1);
  for (int j = 0; j <= fanRows; ++j)
  {
    const double t = 1.0 - 2.0 * j / fanRows;
    angles[j] = FanAngle * t * (0.62 + 0.38 * t * t);
  }

  const int                 rayRows = rows + 1;
  std::vector<PointType>    rays(static_cast<std::size_t>(columns) * rayRows);
  std::vector<std::uint8_t> rayLabels(rays.size(), 0);
  const auto                column = [&](std::size_t c) {
    const Station station = this->MakeStation(jaw, stations[c]);
    const auto    evaluate = [&](double q, double o, int * label) {
      const PointType p = {
        { station.origin[0] + q * station.normal[0], station.origin[1] + q * station.normal[1], station.origin[2] + o }
      };
      double teeth = 1e9;
      for (int k = 0; k < station.numberOfNear; ++k)
      {
        const Body & body = m_Jaws[jaw].bodies[station.near[k]];
        const double dx = p[0] - body.centre[0];
        const double dy = p[1] - body.centre[1];
        const double dz = p[2] - body.centre[2];
        const double far = std::sqrt(dx * dx + dy * dy + dz * dz) - body.radius;
        const double f = far > 0.5 ? far : body.Evaluate(body.ToLocal(p), false);
        if (label && f < teeth)
        {
          *label = station.near[k];
        }
        teeth = k == 0 ? f : SmoothMin(teeth, f, 0.15);
      }
      const double gingiva = this->Gingiva(jaw, station, q, o);
      if (label && gingiva < teeth)
      {
        *label = -1;
      }
      return SmoothMin(teeth, gingiva, 0.3);
    };
    for (int r = 0; r < rayRows; ++r)
    {
      // Horizontal rays on the flanges, a fan between them.
      double q = 1.0;
      double o = 0.0;
      double level = 0.0;
      if (r < buccalRows)
      {
        level = -station.buccalFlange * (1.0 - static_cast<double>(r) / buccalRows);
      }
      else if (r <= buccalRows + fanRows)
      {
        const double angle = angles[r - buccalRows];
        q = std::sin(angle);
        o = std::cos(angle);
      }
      else
      {
        q = -1.0;
        level = -station.lingualFlange * static_cast<double>(r - buccalRows - fanRows) / lingualRows;
      }
      // From outside inward to the first hit: the outer envelope. The field overestimates distances: half steps.
      double t = 17.0;
      double f = evaluate(t * q, level + t * o, nullptr);
      double outside = t;
      while (f > 0.0 && t > 0.2)
      {
        outside = t;
        t -= std::max(0.06, 0.45 * f);
        f = evaluate(t * q, level + t * o, nullptr);
      }
      double inside = t;
      for (unsigned int k = 0; k < 24; ++k)
      {
        const double middle = 0.5 * (inside + outside);
        (evaluate(middle * q, level + middle * o, nullptr) > 0.0 ? outside : inside) = middle;
      }
      int label = -1;
      t = 0.5 * (inside + outside);
      evaluate(t * q, level + t * o, &label);
      const std::size_t id = c * rayRows + r;
      rays[id] = { { station.origin[0] + t * q * station.normal[0],
                     station.origin[1] + t * q * station.normal[1],
                     station.origin[2] + level + t * o } };
      rayLabels[id] = label < 0 ? 0 : ToothFDI(jaw, static_cast<unsigned int>(label));
    }
  };
  constexpr std::size_t block = 32;
  for (std::size_t begin = 0; begin < static_cast<std::size_t>(columns); begin += block)
  {
    const std::size_t count = std::min(block, columns - begin);
    ParallelFor(count, threads, [&](std::size_t c) { column(begin + c); });
    if (progress)
    {
      progress(static_cast<double>(begin + count) / columns);
    }
  }

  // Points in the jaw's frame (o occlusal), ids of the grid.
  JawSurface                              result;
  std::vector<PointType> &                points = result.surface.points;
  std::vector<std::vector<std::uint32_t>> ids(columns);
  for (int c = 0; c < columns; ++c)
  {
    for (int r = 0; r < rayRows; ++r)
    {
      ids[c].push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(rays[static_cast<std::size_t>(c) * rayRows + r]);
      result.labels.push_back(rayLabels[static_cast<std::size_t>(c) * rayRows + r]);
    }
  }
  if (source.palate)
  {
    // From the lingual border to a seam on the midline that the two sides share.
    const auto   border = [&](int c) { return rays[static_cast<std::size_t>(c) * rayRows + rayRows - 1]; };
    const double front = border(half)[0] - 8.0;
    const double back = 0.5 * (border(0)[0] + border(columns - 1)[0]) - 1.0;
    std::vector<std::uint32_t> seam;
    for (int i = 0; i <= half; ++i)
    {
      const double t = static_cast<double>(i) / half;
      const double level = 0.5 * (border(half - i)[2] + border(half + i)[2]);
      seam.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back({ { front + (back - front) * std::pow(t, 1.2),
                           0.0,
                           level - source.palateDepth * (0.3 + 0.7 * SmoothStep(0.0, 0.7, t)) } });
      result.labels.push_back(0);
    }
    for (int c = 0; c < columns; ++c)
    {
      const PointType a = border(c);
      const PointType b = points[seam[std::abs(c - half)]];
      for (int r = 1; r < palateRows; ++r)
      {
        const double t = static_cast<double>(r) / palateRows;
        const double u = 1.0 - (1.0 - t) * (1.0 - t);
        ids[c].push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back({ { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + u * (b[2] - a[2]) } });
        result.labels.push_back(0);
      }
      ids[c].push_back(seam[std::abs(c - half)]);
    }
  }
  auto &     triangles = result.surface.triangles;
  const auto strip = [&](const std::vector<std::uint32_t> & first, const std::vector<std::uint32_t> & second) {
    for (std::size_t r = 0; r + 1 < first.size(); ++r)
    {
      const std::uint32_t a = first[r];
      const std::uint32_t b = second[r];
      const std::uint32_t d = first[r + 1];
      const std::uint32_t e = second[r + 1];
      // The shorter diagonal.
      double ae = 0.0;
      double bd = 0.0;
      for (unsigned int k = 0; k < 3; ++k)
      {
        ae += (points[a][k] - points[e][k]) * (points[a][k] - points[e][k]);
        bd += (points[b][k] - points[d][k]) * (points[b][k] - points[d][k]);
      }
      const bool other = ae < bd;
      for (const TriangleSurface::TriangleType & t : { TriangleSurface::TriangleType{ { a, b, other ? e : d } },
                                                       TriangleSurface::TriangleType{ { other ? a : b, e, d } } })
      {
        // Where columns meet in one point a cell is a triangle.
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        {
          triangles.push_back(t);
        }
      }
    }
  };
  for (int c = 0; c + 1 < columns; ++c)
  {
    strip(ids[c], ids[c + 1]);
  }
  if (m_Parameters.stoneBase)
  {
    // Below the border: walls, a plane bottom, and the two distal ends.
    double bottom = 1e9;
    for (const PointType & p : points)
    {
      bottom = std::min(bottom, p[2]);
    }
    bottom -= m_Parameters.baseHeight;
    const auto add = [&](double x, double y, double o) {
      points.push_back({ { x, y, o } });
      result.labels.push_back(0);
      return static_cast<std::uint32_t>(points.size() - 1);
    };
    std::vector<std::uint32_t> keel;
    if (source.palate)
    {
      for (int i = 0; i <= half; ++i)
      {
        keel.push_back(add(points[ids[half + i].back()][0], 0.0, bottom));
      }
    }
    std::vector<std::vector<std::uint32_t>> under(columns);
    for (int c = 0; c < columns; ++c)
    {
      const PointType buccal = points[ids[c].front()];
      const PointType lingual = points[ids[c].back()];
      double          unused[2];
      double          normal[2];
      this->ArchPoint(jaw, stations[c], unused, normal);
      // A drafted wall, as a trimmer leaves it.
      const double draft = 1.5;
      const double outer[2] = { buccal[0] + draft * normal[0], buccal[1] + draft * normal[1] };
      if (source.palate)
      {
        under[c].push_back(keel[std::abs(c - half)]);
      }
      else
      {
        under[c].push_back(ids[c].back());
        for (int r = 1; r <= wallRows; ++r)
        {
          const double t = static_cast<double>(r) / wallRows;
          under[c].push_back(add(lingual[0], lingual[1], lingual[2] + t * (bottom - lingual[2])));
        }
      }
      const PointType from = points[under[c].back()];
      for (int r = 1; r <= bottomRows; ++r)
      {
        const double t = static_cast<double>(r) / bottomRows;
        under[c].push_back(add(from[0] + t * (outer[0] - from[0]), from[1] + t * (outer[1] - from[1]), bottom));
      }
      for (int r = 1; r < wallRows; ++r)
      {
        const double t = static_cast<double>(r) / wallRows;
        under[c].push_back(add(outer[0] + t * (buccal[0] - outer[0]),
                               outer[1] + t * (buccal[1] - outer[1]),
                               bottom + t * (buccal[2] - bottom)));
      }
      under[c].push_back(ids[c].front());
    }
    for (int c = 0; c + 1 < columns; ++c)
    {
      strip(under[c], under[c + 1]);
    }
    // The two ends of a filled cast share a line from the palate's seam to the keel.
    std::vector<std::uint32_t> line;
    if (source.palate)
    {
      const PointType from = points[ids[0].back()];
      for (int r = 1; r < wallRows; ++r)
      {
        line.push_back(add(from[0], 0.0, from[2] + (bottom - from[2]) * r / wallRows));
      }
    }
    for (const int c : { 0, columns - 1 })
    {
      std::vector<std::uint32_t> ring(ids[c].begin(), ids[c].end());
      ring.insert(ring.end(), line.begin(), line.end());
      ring.insert(ring.end(), under[c].begin() + (source.palate ? 0 : 1), under[c].end() - 1);
      double unused[2];
      double normal[2];
      this->ArchPoint(jaw, stations[c], unused, normal);
      std::vector<std::array<double, 2>> polygon;
      for (const std::uint32_t id : ring)
      {
        polygon.push_back({ { points[id][0] * normal[0] + points[id][1] * normal[1], points[id][2] } });
      }
      for (const auto & ear : ClipEars(polygon))
      {
        triangles.push_back(c == 0 ? TriangleSurface::TriangleType{ { ring[ear[0]], ring[ear[1]], ring[ear[2]] } }
                                   : TriangleSurface::TriangleType{ { ring[ear[0]], ring[ear[2]], ring[ear[1]] } });
      }
    }
  }

  this->AddLandmarks(jaw, result);
  if (finish && m_Parameters.scannerNoise > 0.0)
  {
    const auto         normals = result.surface.VertexNormals();
    ReproducibleRandom random(m_Parameters.noiseSeed, jaw);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double d = random.Normal(0.0, m_Parameters.scannerNoise);
      for (unsigned int k = 0; k < 3; ++k)
      {
        points[i][k] += d * normals[i][k];
      }
    }
  }
  // From occlusal-up to the anatomical frame. The upper jaw is turned over, which turns the winding.
  for (PointType & p : points)
  {
    for (double & value : p)
    {
      value = Quantise(value);
    }
    if (jaw == 0)
    {
      p[2] = -p[2];
    }
  }
  if (jaw == 0)
  {
    for (auto & triangle : triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  for (Landmark & landmark : result.landmarks)
  {
    // The point field holds the vertex's id until here.
    landmark.point = points[static_cast<std::size_t>(landmark.point[0])];
  }
  return result;
}

void
DentalPhantomModel::AddLandmarks(unsigned int jaw, JawSurface & result) const
{
  for (unsigned int i = 0; i < 14; ++i)
  {
    const Body & body = m_Jaws[jaw].bodies[i];
    if (!body.present)
    {
      continue;
    }
    const unsigned int k = i % 7;
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
    for (const Cusp & cusp : body.cusps)
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
      const std::uint8_t fdi = ToothFDI(jaw, i);
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
      const char * quadrant = jaw == 0 ? (i < 7 ? "UR" : "UL") : (i < 7 ? "LR" : "LL");
      result.landmarks.push_back(
        { quadrant + std::to_string(k + 1) + "_" + w.name, { { static_cast<double>(nearest), 0.0, 0.0 } } });
    }
  }
}

void
DentalPhantomModel::Settle(unsigned int threads)
{
  // At a resolution of its own, so that the occlusion does not depend on that of the meshes.
  constexpr std::uint32_t resolution = 28000;
  const JawSurface        upper = this->MakeJaw(0, resolution, false, threads, {});
  // Lower envelope of the upper jaw at the nodes of a raster.
  constexpr double    step = 0.2;
  constexpr double    x0 = -30.0;
  constexpr double    y0 = -60.0;
  constexpr int       nx = 650;
  constexpr int       ny = 600;
  std::vector<double> envelope(static_cast<std::size_t>(nx) * ny, 1e9);
  for (const auto & triangle : upper.surface.triangles)
  {
    const PointType & a = upper.surface.points[triangle[0]];
    const PointType & b = upper.surface.points[triangle[1]];
    const PointType & c = upper.surface.points[triangle[2]];
    const double      det = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    if (std::abs(det) < 1e-12)
    {
      continue;
    }
    const int i0 = std::max(0, static_cast<int>(std::ceil((std::min({ a[0], b[0], c[0] }) - x0) / step)));
    const int i1 = std::min(nx - 1, static_cast<int>(std::floor((std::max({ a[0], b[0], c[0] }) - x0) / step)));
    const int j0 = std::max(0, static_cast<int>(std::ceil((std::min({ a[1], b[1], c[1] }) - y0) / step)));
    const int j1 = std::min(ny - 1, static_cast<int>(std::floor((std::max({ a[1], b[1], c[1] }) - y0) / step)));
    for (int j = j0; j <= j1; ++j)
    {
      for (int i = i0; i <= i1; ++i)
      {
        const double x = x0 + i * step - a[0];
        const double y = y0 + j * step - a[1];
        const double u = (x * (c[1] - a[1]) - (c[0] - a[0]) * y) / det;
        const double v = ((b[0] - a[0]) * y - x * (b[1] - a[1])) / det;
        if (u >= -1e-9 && v >= -1e-9 && u + v <= 1.0 + 1e-9)
        {
          double & value = envelope[static_cast<std::size_t>(j) * nx + i];
          value = std::min(value, a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]));
        }
      }
    }
  }
  const JawSurface       lower = this->MakeJaw(1, resolution, false, threads, {});
  std::array<double, 14> clearance;
  clearance.fill(1e9);
  for (std::size_t n = 0; n < lower.labels.size(); ++n)
  {
    if (lower.labels[n] == 0)
    {
      continue;
    }
    const PointType & p = lower.surface.points[n];
    const int         i = static_cast<int>(std::floor((p[0] - x0) / step));
    const int         j = static_cast<int>(std::floor((p[1] - y0) / step));
    if (i < 0 || j < 0 || i + 1 >= nx || j + 1 >= ny)
    {
      continue;
    }
    const std::size_t  id = static_cast<std::size_t>(j) * nx + i;
    const double       top = std::min({ envelope[id], envelope[id + 1], envelope[id + nx], envelope[id + nx + 1] });
    const unsigned int tooth = (lower.labels[n] / 10 == 3 ? 7u : 0u) + lower.labels[n] % 10 - 1u;
    clearance[tooth] = std::min(clearance[tooth], top - p[2]);
  }
  for (unsigned int i = 0; i < 14; ++i)
  {
    // Back teeth erupt until they touch; front teeth keep their overbite unless they would meet.
    const unsigned int k = i % 7;
    const double       highest = k < 2 ? 0.0 : k == 2 ? 0.3 : 1.2;
    const double       shift = std::min(clearance[i] - 0.04, highest);
    m_Settlement[i] = m_Jaws[1].bodies[i].present ? Quantise(shift) : 0.0;
    m_Jaws[1].bodies[i].cervix[2] += m_Settlement[i];
    m_Jaws[1].bodies[i].centre[2] += m_Settlement[i];
  }
}

std::array<double, 2>
DentalPhantomModel::RayThroughTooth(unsigned int      jaw,
                                    unsigned int      tooth,
                                    const PointType & origin,
                                    const PointType & direction) const
{
  const Body & body = m_Jaws[jaw].bodies[tooth];
  const double flip = jaw == 0 ? -1.0 : 1.0;
  const double radius = this->GetToothRadius(jaw, tooth);
  const auto   centre = this->GetToothCentre(jaw, tooth);
  double       along = 0.0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    along += (centre[d] - origin[d]) * direction[d];
  }
  double squared = 0.0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double r = origin[d] + along * direction[d] - centre[d];
    squared += r * r;
  }
  std::array<double, 2> length{ { 0.0, 0.0 } };
  if (!body.present || squared >= radius * radius)
  {
    return length;
  }
  const double     half = std::sqrt(radius * radius - squared);
  constexpr double step = 0.5;
  const double     begin = along - half + 0.5 * step;
  const PointType  a = body.ToLocal({ { origin[0] + begin * direction[0],
                                        origin[1] + begin * direction[1],
                                        flip * (origin[2] + begin * direction[2]) } });
  PointType        d{};
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    d[axis] =
      body.axes[axis][0] * direction[0] + body.axes[axis][1] * direction[1] + body.axes[axis][2] * flip * direction[2];
  }
  for (double t = 0.0; t < 2.0 * half; t += step)
  {
    const PointType local = { { a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2] } };
    if (local[2] > body.height + 1.0 || local[2] < -body.rootLength - 1.0 ||
        std::abs(local[0]) > 0.5 * body.width + 1.0 || std::abs(local[1]) > 0.55 * body.depth + 1.0)
    {
      continue;
    }
    const double f = body.Evaluate(local, true);
    // A soft step of the sampling width instead of a count of samples.
    length[local[2] > 0.0 ? 0 : 1] += step * Clamp(0.5 - f / step, 0.0, 1.0);
  }
  return length;
}

auto
DentalPhantomModel::GetToothCentre(unsigned int jaw, unsigned int tooth) const -> PointType
{
  const Body & body = m_Jaws[jaw].bodies[tooth];
  PointType    centre = body.ToJaw({ { 0.0, 0.0, 0.5 * (body.height - body.rootLength) } });
  if (jaw == 0)
  {
    centre[2] = -centre[2];
  }
  return centre;
}

double
DentalPhantomModel::GetToothRadius(unsigned int jaw, unsigned int tooth) const
{
  const Body & body = m_Jaws[jaw].bodies[tooth];
  const double half = 0.5 * (body.height + body.rootLength);
  return std::sqrt(half * half + 0.25 * body.width * body.width + 0.25 * body.depth * body.depth);
}

auto
DentalPhantomModel::GetBuccalDirection(unsigned int jaw, unsigned int tooth) const -> PointType
{
  const Body & body = m_Jaws[jaw].bodies[tooth];
  return { { body.axes[1][0], body.axes[1][1], jaw == 0 ? -body.axes[1][2] : body.axes[1][2] } };
}

auto
DentalPhantomModel::TransformToTooth(unsigned int jaw, unsigned int tooth, const PointType & point) const -> PointType
{
  return m_Jaws[jaw].bodies[tooth].ToLocal({ { point[0], point[1], jaw == 0 ? -point[2] : point[2] } });
}
} // namespace itk
