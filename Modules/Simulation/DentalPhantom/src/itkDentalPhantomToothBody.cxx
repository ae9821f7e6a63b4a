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
#include "itkDentalPhantomToothBody.h"

#include "itkDentalPhantomMath.h"

#include <limits>

namespace itk
{
using namespace DentalPhantomMath;

void
DentalPhantomToothBody::Shape(unsigned int jaw, unsigned int position, const DentalPhantomTooth & tooth)
{
  const unsigned int k = position;
  const double       W = tooth.mesiodistal;
  const double       B = tooth.buccolingual;
  const double       H = tooth.height;
  this->present = !tooth.missing;
  this->width = W;
  this->depth = B;
  this->height = H;
  this->kind = k < 2 ? 0 : k == 2 ? 1 : k < 5 ? 2 : 3;
  this->wear = tooth.wear;
  this->settles = tooth.settles;
  this->ShapeRoots(jaw, position, tooth.primary);
  if (tooth.bracket)
  {
    // 0.022 inch systems: about 3 mm wide and high on incisors, tubes of 4 x 2.4 mm on molars; 1.7 mm off the tooth.
    this->bracket[0] = k >= 5 ? 2.0 : k < 2 && jaw == 1 ? 1.3 : 1.6;
    this->bracket[1] = 1.1;
    this->bracket[2] = k >= 5 ? 1.2 : 1.5;
  }
  if (tooth.primary)
  {
    this->ShapePrimaryMolar(jaw, position);
    return;
  }
  if (k < 3)
  {
    const bool   canine = k == 2;
    const double edgeAt = canine ? 0.16 : 0.19;
    const double half = canine ? 0.11 : 0.085;
    this->mesiodistal = canine ? DentalPhantomProfile({ 0.0, 0.3, 0.65, 0.85, 1.0 }, { 0.74, 0.9, 1.0, 0.93, 0.7 })
                               : DentalPhantomProfile({ 0.0, 0.3, 0.75, 0.92, 1.0 }, { 0.70, 0.85, 1.0, 0.985, 0.94 });
    this->buccal = DentalPhantomProfile({ 0.0, 0.15, 0.45, 0.75, 1.0 }, { 0.44, 0.485, 0.47, 0.39, edgeAt + half });
    this->lingual =
      canine
        ? DentalPhantomProfile({ 0.0, 0.15, 0.35, 0.6, 0.85, 1.0 }, { -0.45, -0.5, -0.42, -0.2, -0.02, edgeAt - half })
        : DentalPhantomProfile({ 0.0, 0.15, 0.35, 0.6, 0.85, 1.0 }, { -0.45, -0.5, -0.38, -0.12, 0.05, edgeAt - half });
    this->squareness = canine ? 0.32 : 0.55;
    this->smoothness = 0.35;
    this->cornerMesial = 0.03 * W;
    this->cornerDistal = (k == 1 && jaw == 0 ? 0.16 : jaw == 0 ? 0.1 : 0.05) * W;
    this->edge = edgeAt * B;
    this->rootLength = canine ? 16.0 : 12.5;
    if (canine)
    {
      this->cusps = { { 0.05 * W, this->edge, H, 0.55, 0.4, "cusp" } };
    }
  }
  else
  {
    this->mesiodistal = DentalPhantomProfile({ 0.0, 0.35, 0.68, 0.88, 1.0 }, { 0.76, 0.92, 1.0, 0.96, 0.84 });
    this->buccal = DentalPhantomProfile({ 0.0, 0.25, 0.6, 1.0 }, { 0.44, 0.5, 0.455, 0.33 });
    this->lingual = DentalPhantomProfile({ 0.0, 0.4, 0.7, 1.0 }, { -0.43, -0.5, -0.47, -0.35 });
    this->smoothness = 0.5;
    this->rootLength = k < 5 ? 13.5 : 12.0;
    if (k < 5)
    {
      this->squareness = 0.39;
      const double drop = jaw == 0 ? (k == 3 ? 0.9 : 0.4) : (k == 3 ? 2.6 : 0.9);
      this->cusps = { { 0.02 * W, 0.25 * B, H, 0.62, 0.55, "B" },
                      { 0.06 * W, -0.26 * B, H - drop * H / 8.5, 0.6, 0.55, "L" } };
    }
    else
    {
      this->squareness = 0.65;
      const double u = H / 7.5;
      if (jaw == 0)
      {
        this->cusps = { { 0.23 * W, 0.26 * B, H, 0.62, 0.5, "MB" },
                        { -0.22 * W, 0.25 * B, H - 0.35 * u, 0.62, 0.5, "DB" },
                        { 0.15 * W, -0.25 * B, H - 0.1 * u, 0.5, 0.5, "ML" },
                        { -0.29 * W, -0.26 * B, H - (k == 5 ? 0.8 : 1.4) * u, 0.55, 0.55, "DL" } };
      }
      else
      {
        this->cusps = { { 0.26 * W, 0.25 * B, H, 0.62, 0.5, "MB" },
                        { (k == 5 ? -0.07 : -0.22) * W, 0.27 * B, H - 0.25 * u, 0.62, 0.5, "DB" },
                        { 0.24 * W, -0.26 * B, H - 0.2 * u, 0.6, 0.55, "ML" },
                        { -0.22 * W, -0.26 * B, H - 0.4 * u, 0.6, 0.55, "DL" } };
        if (k == 5)
        {
          this->cusps.push_back({ -0.36 * W, 0.13 * B, H - 0.8 * u, 0.65, 0.55, "D" });
        }
      }
    }
  }
}

void
DentalPhantomToothBody::ShapePrimaryMolar(unsigned int jaw, unsigned int position)
{
  // Bulbous at the neck, narrow occlusal table; the second one looks like a small first molar, the first like none.
  const double W = width;
  const double B = depth;
  const double H = height;
  kind = 3;
  mesiodistal = DentalPhantomProfile({ 0.0, 0.3, 0.65, 0.88, 1.0 }, { 0.72, 0.95, 1.0, 0.93, 0.8 });
  buccal = DentalPhantomProfile({ 0.0, 0.2, 0.6, 1.0 }, { 0.44, 0.5, 0.4, 0.27 });
  lingual = DentalPhantomProfile({ 0.0, 0.3, 0.65, 1.0 }, { -0.42, -0.5, -0.44, -0.3 });
  squareness = position == 4 ? 0.6 : 0.45;
  smoothness = 0.5;
  rootLength = 10.0;
  const double u = H / 7.5;
  cusps = { { 0.22 * W, 0.22 * B, H, 0.5, 0.42, "MB" },
            { -0.2 * W, 0.22 * B, H - 0.35 * u, 0.5, 0.42, "DB" },
            { 0.18 * W, -0.22 * B, H - 0.2 * u, 0.45, 0.42, "ML" },
            { -0.22 * W, -0.22 * B, H - 0.7 * u, 0.5, 0.45, "DL" } };
  if (jaw == 1 && position == 4)
  {
    cusps.push_back({ -0.34 * W, 0.1 * B, H - 0.6 * u, 0.5, 0.45, "D" });
  }
}

void
DentalPhantomToothBody::ShapeRoots(unsigned int jaw, unsigned int position, bool isPrimary)
{
  // Lengths: Nelson and Ash, Wheeler's Dental Anatomy; a primary molar's roots are thin and spread around the germ.
  constexpr double lengths[2][8] = { { 13.0, 13.0, 17.0, 14.0, 14.0, 12.5, 11.5, 11.0 },
                                     { 12.5, 14.0, 16.0, 14.0, 14.5, 14.0, 13.0, 11.0 } };
  const double     W = width;
  const double     B = depth;
  const double     L = isPrimary ? 10.0 : lengths[jaw][position];
  const double     slim = isPrimary ? 0.75 : 1.0;
  const double     spread = isPrimary ? 1.6 : 1.0;
  trunk = 0.0;
  if (isPrimary || position >= 5)
  {
    trunk = isPrimary ? 1.5 : position == 5 ? 3.6 : 4.2;
    // Second and third molars' roots stand closer together.
    const double open = spread * (position == 5 || isPrimary ? 1.0 : position == 6 ? 0.7 : 0.4);
    if (jaw == 0)
    {
      roots = {
        { 0.19 * W, 0.17 * B, (0.19 + 0.06 * open) * W, (0.17 + 0.06 * open) * B, L, 0.15 * W * slim, 0.2 * B * slim },
        { -0.2 * W,
          0.15 * B,
          (-0.2 - 0.1 * open) * W,
          (0.15 + 0.04 * open) * B,
          L - 0.5,
          0.14 * W * slim,
          0.18 * B * slim },
        { -0.02 * W, -0.18 * B, -0.06 * W, (-0.2 - 0.16 * open) * B, L + 0.7, 0.19 * W * slim, 0.17 * B * slim }
      };
    }
    else
    {
      roots = { { 0.2 * W, 0.0, (0.18 + 0.06 * open) * W, 0.02 * B, L, 0.15 * W * slim, 0.34 * B * slim },
                { -0.2 * W, 0.0, (-0.24 - 0.12 * open) * W, 0.0, L - 0.9, 0.15 * W * slim, 0.31 * B * slim } };
    }
    return;
  }
  // A single root, a little distal at its end; the upper first premolar's two are seen as one from the side.
  const double bend = position == 1 ? -0.12 : -0.06;
  roots = { { 0.0, 0.0, bend * W, position < 3 ? -0.08 * B : 0.0, L, 0.36 * W, (position < 3 ? 0.43 : 0.4) * B } };
}

auto
DentalPhantomToothBody::GetApex() const -> PointType
{
  const Root * longest = nullptr;
  for (const Root & root : roots)
  {
    if (longest == nullptr || root.length > longest->length)
    {
      longest = &root;
    }
  }
  return longest == nullptr ? PointType{ { 0.0, 0.0, -rootLength } }
                            : PointType{ { longest->apexX, longest->apexY, -longest->length } };
}

double
DentalPhantomToothBody::EvaluateWhole(const PointType & local) const
{
  double result = this->Evaluate(local, false);
  if (local[2] > 1.5)
  {
    return result;
  }
  const double z = std::min(local[2], 0.0);
  if (trunk > 0.0)
  {
    // The common trunk: the cervical section, tapering to the furcation.
    const double shrink = 1.0 - 0.12 * std::min(-z / trunk, 1.5);
    const double side = this->Evaluate({ { local[0] / shrink, local[1] / shrink, std::max(z, -0.9) } }, false) * shrink;
    result = SmoothMin(result, SmoothMax(side, -trunk - local[2], 1.2), 0.3);
  }
  for (const Root & root : roots)
  {
    const double t = -z / root.length;
    if (t > 1.3)
    {
      continue;
    }
    // Nearly straight sides that close to a blunt apex.
    const double taper = std::sqrt(std::max(0.0, 1.0 - std::pow(std::min(t, 1.0), 1.7)));
    const double rx = std::max(root.radiusX * (0.25 * taper + 0.75 * taper * (1.0 - 0.45 * t)), 0.05);
    const double ry = std::max(root.radiusY * (0.25 * taper + 0.75 * taper * (1.0 - 0.45 * t)), 0.05);
    const double bend = t * (0.6 + 0.4 * t);
    const double X = (local[0] - root.baseX - bend * (root.apexX - root.baseX)) / rx;
    const double Y = (local[1] - root.baseY - bend * (root.apexY - root.baseY)) / ry;
    const double side = (std::sqrt(X * X + Y * Y) - 1.0) * std::min(rx, ry);
    const double body = std::max({ side, -root.length - local[2], local[2] - 1.0 });
    result = SmoothMin(result, body, 0.5);
  }
  return result;
}

double
DentalPhantomToothBody::EvaluateBracket(const PointType & local) const
{
  if (bracket[0] <= 0.0)
  {
    return 1e9;
  }
  const double z = 0.5 * height;
  // Its base reaches into the crown, so that no gap is left on a curved surface.
  const double y = depth * buccal(0.5) + 0.5 * bracket[1];
  return std::max(
    { std::abs(local[0]) - bracket[0], std::abs(local[1] - y) - bracket[1], std::abs(local[2] - z) - bracket[2] });
}

auto
DentalPhantomToothBody::ToLocal(const PointType & p) const -> PointType
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
DentalPhantomToothBody::ToJaw(const PointType & local) const -> PointType
{
  PointType p;
  for (unsigned int d = 0; d < 3; ++d)
  {
    p[d] = cervix[d] + axes[0][d] * local[0] + axes[1][d] * local[1] + axes[2][d] * local[2];
  }
  return p;
}

double
DentalPhantomToothBody::OcclusalHeight(double x, double y) const
{
  if (kind == 0)
  {
    const double a = x / (0.5 * width);
    const double corner = a < 0.0 ? cornerDistal : cornerMesial;
    const double a2 = a * a;
    const double edgeHeight = height - corner * a2 * a2 - 0.15 * a2;
    return wear > 0.0 ? SmoothMin(edgeHeight, height - wear, 0.2) : edgeHeight;
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
  if (wear > 0.0)
  {
    // A facet: the plane that the antagonists have ground.
    top = SmoothMin(top, height - wear, 0.25);
  }
  return top;
}

double
DentalPhantomToothBody::Evaluate(const PointType & local, bool root) const
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
} // namespace itk
