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
#ifndef itkSilhouetteTestSurfaces_h
#define itkSilhouetteTestSurfaces_h

#include "itkPerspectiveProjection.h"
#include "itkReproducibleRandom.h"
#include "itkTriangleSurface.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

/** Analytic surfaces and projections for the tests of silhouettes. */
namespace SilhouetteTest
{
using Vector = std::array<double, 3>;
using Rotation = std::array<Vector, 3>;
constexpr double Pi = 3.14159265358979323846;

/** Source at (0, -distance, 0), the detector behind it in y: u = pu + x m / spacing, v = pv - z m / spacing. */
inline itk::PerspectiveProjection
MakeProjection(const Rotation & r, const Vector & t, double distance = 1524.0, double detector = 1674.0)
{
  const double               spacing = 0.25;
  const double               pu = 350.0;
  const double               pv = 400.0;
  const double               rows[3][4] = { { detector / (distance * spacing), pu / distance, 0.0, pu },
                                            { 0.0, pv / distance, -detector / (distance * spacing), pv },
                                            { 0.0, 1.0 / distance, 0.0, 1.0 } };
  itk::PerspectiveProjection projection;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      projection.matrix[4 * row + column] =
        rows[row][0] * r[0][column] + rows[row][1] * r[1][column] + rows[row][2] * r[2][column];
    }
    projection.matrix[4 * row + 3] = rows[row][0] * t[0] + rows[row][1] * t[1] + rows[row][2] * t[2] + rows[row][3];
  }
  const Vector c{ -t[0], -distance - t[1], -t[2] };
  for (unsigned int k = 0; k < 3; ++k)
  {
    projection.source[k] = r[0][k] * c[0] + r[1][k] * c[1] + r[2][k] * c[2];
  }
  return projection;
}

inline Rotation
Identity()
{
  return { Vector{ 1, 0, 0 }, Vector{ 0, 1, 0 }, Vector{ 0, 0, 1 } };
}

/** From a unit quaternion. */
inline Rotation
FromQuaternion(double w, double x, double y, double z)
{
  return { Vector{ 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y) },
           Vector{ 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x) },
           Vector{ 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y) } };
}

inline Rotation
RandomRotation(itk::ReproducibleRandom & random)
{
  double q[4];
  double norm = 0.0;
  for (double & x : q)
  {
    x = random.Normal();
    norm += x * x;
  }
  norm = std::sqrt(norm);
  return FromQuaternion(q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm);
}

/** One of the 24 turns that map axes to axes. */
inline Rotation
AxisAlignedRotation(unsigned int which)
{
  const unsigned int permutations[6][3] = {
    { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 2, 1, 0 }
  };
  const bool         odd[6] = { false, true, true, false, false, true };
  const unsigned int p = which / 4 % 6;
  const double       s0 = which & 1u ? -1.0 : 1.0;
  const double       s1 = which & 2u ? -1.0 : 1.0;
  const double       s2 = s0 * s1 * (odd[p] ? -1.0 : 1.0);
  Rotation           r{};
  r[0][permutations[p][0]] = s0;
  r[1][permutations[p][1]] = s1;
  r[2][permutations[p][2]] = s2;
  return r;
}

inline void
Append(itk::TriangleSurface & surface, const itk::TriangleSurface & other)
{
  const auto offset = static_cast<std::uint32_t>(surface.points.size());
  surface.points.insert(surface.points.end(), other.points.begin(), other.points.end());
  for (const auto & t : other.triangles)
  {
    surface.triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
  }
}

/** A box whose twelve triangles share eight points. */
inline itk::TriangleSurface
MakeBox(const Vector & low, const Vector & high)
{
  itk::TriangleSurface box;
  for (unsigned int i = 0; i < 8; ++i)
  {
    box.points.push_back({ i & 1u ? high[0] : low[0], i & 2u ? high[1] : low[1], i & 4u ? high[2] : low[2] });
  }
  const std::uint32_t quads[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
                                      { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto & q : quads)
  {
    box.triangles.push_back({ q[0], q[1], q[2] });
    box.triangles.push_back({ q[0], q[2], q[3] });
  }
  return box;
}

/** An icosahedron divided the given number of times, on a sphere. */
inline itk::TriangleSurface
MakeSphere(const Vector & center, double radius, unsigned int divisions)
{
  const double         g = (1.0 + std::sqrt(5.0)) / 2.0;
  std::vector<Vector>  unit{ { -1, g, 0 },  { 1, g, 0 },  { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g },  { 0, 1, g },
                            { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 },  { g, 0, 1 },  { -g, 0, -1 }, { -g, 0, 1 } };
  itk::TriangleSurface sphere;
  sphere.triangles = { { 0, 11, 5 }, { 0, 5, 1 },  { 0, 1, 7 },   { 0, 7, 10 }, { 0, 10, 11 },
                       { 1, 5, 9 },  { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 },
                       { 3, 9, 4 },  { 3, 4, 2 },  { 3, 2, 6 },   { 3, 6, 8 },  { 3, 8, 9 },
                       { 4, 9, 5 },  { 2, 4, 11 }, { 6, 2, 10 },  { 8, 6, 7 },  { 9, 8, 1 } };
  for (unsigned int d = 0; d < divisions; ++d)
  {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto                                                       middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto key = std::make_pair(std::min(a, b), std::max(a, b));
      const auto found = middles.find(key);
      if (found != middles.end())
      {
        return found->second;
      }
      unit.push_back({ unit[a][0] + unit[b][0], unit[a][1] + unit[b][1], unit[a][2] + unit[b][2] });
      const auto   id = static_cast<std::uint32_t>(unit.size() - 1);
      const double n = std::sqrt(unit[id][0] * unit[id][0] + unit[id][1] * unit[id][1] + unit[id][2] * unit[id][2]);
      for (double & x : unit[id])
      {
        x *= std::sqrt(1.0 + g * g) / n;
      }
      middles[key] = id;
      return id;
    };
    std::vector<itk::TriangleSurface::TriangleType> next;
    for (const auto & t : sphere.triangles)
    {
      const std::uint32_t a = middle(t[0], t[1]);
      const std::uint32_t b = middle(t[1], t[2]);
      const std::uint32_t c = middle(t[2], t[0]);
      next.push_back({ t[0], a, c });
      next.push_back({ t[1], b, a });
      next.push_back({ t[2], c, b });
      next.push_back({ a, b, c });
    }
    sphere.triangles = next;
  }
  for (const Vector & p : unit)
  {
    const double s = radius / std::sqrt(1.0 + g * g);
    sphere.points.push_back({ center[0] + s * p[0], center[1] + s * p[1], center[2] + s * p[2] });
  }
  return sphere;
}

/** A closed tube along a closed or an open curve of the plane, with bumps: a torus (bumps 0) or a horseshoe with
 * cusps. arc: opening angle in rad, 2 pi for a torus. An open tube has open ends. */
inline itk::TriangleSurface
MakeTube(
  double major, double minor, double arc, unsigned int along, unsigned int around, double bump, unsigned int bumps)
{
  itk::TriangleSurface tube;
  const bool           closed = arc >= 2.0 * Pi - 1e-9;
  const unsigned int   rows = closed ? along : along + 1;
  for (unsigned int i = 0; i < rows; ++i)
  {
    const double phi = arc * (static_cast<double>(i) / along - 0.5);
    for (unsigned int j = 0; j < around; ++j)
    {
      const double theta = 2.0 * Pi * j / around;
      const double r = minor * (1.0 + bump * std::cos(bumps * phi * 2.0 * Pi / arc) *
                                        (1.0 + 0.3 * std::sin(3.0 * theta) + 0.5 * std::cos(theta)));
      const double rho = major + r * std::cos(theta);
      tube.points.push_back({ rho * std::cos(phi), rho * std::sin(phi), r * std::sin(theta) });
    }
  }
  for (unsigned int i = 0; i < along; ++i)
  {
    for (unsigned int j = 0; j < around; ++j)
    {
      const std::uint32_t a = i * around + j;
      const std::uint32_t b = i * around + (j + 1) % around;
      const std::uint32_t c = (i + 1) % rows * around + j;
      const std::uint32_t d = (i + 1) % rows * around + (j + 1) % around;
      tube.triangles.push_back({ a, c, b });
      tube.triangles.push_back({ b, c, d });
    }
  }
  return tube;
}
} // namespace SilhouetteTest

#endif
