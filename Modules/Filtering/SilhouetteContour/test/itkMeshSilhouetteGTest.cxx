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
#include "itkMeshSilhouette.h"

#include "itkParallelFor.h"
#include "itkSilhouetteCoverage.h"
#include "itkSilhouetteTestSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace SilhouetteTest;

namespace
{
using Pixel = std::array<double, 2>;
using Projection = itk::PerspectiveProjection;
using Surface = itk::TriangleSurface;

Pixel
Project(const Projection & projection, const Vector & point)
{
  Pixel p{};
  projection.Project(point.data(), p[0], p[1]);
  return p;
}

double
Turn(const Pixel & a, const Pixel & b, const Pixel & c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/** Every triangle is asked: nothing in common with the implementation. */
bool
IsCovered(const std::vector<std::array<Pixel, 3>> & triangles, const Pixel & p)
{
  for (const auto & t : triangles)
  {
    const double a = Turn(t[0], t[1], p);
    const double b = Turn(t[1], t[2], p);
    const double c = Turn(t[2], t[0], p);
    if ((a >= 0 && b >= 0 && c >= 0 && a + b + c > 0) || (a <= 0 && b <= 0 && c <= 0 && a + b + c < 0))
    {
      return true;
    }
  }
  return false;
}

bool
IsInside(const itk::SilhouetteLoop & loop, const Pixel & p)
{
  bool              inside = false;
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Pixel & a = loop.points[i];
    const Pixel & b = loop.points[(i + 1) % n];
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
    {
      inside = !inside;
    }
  }
  return inside;
}

double
DistanceToLoop(const itk::SilhouetteLoop & loop, const Pixel & p, std::size_t except = ~std::size_t{ 0 })
{
  double            best = std::numeric_limits<double>::max();
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Pixel & a = loop.points[i];
    const Pixel & b = loop.points[(i + 1) % n];
    const double  du = b[0] - a[0];
    const double  dv = b[1] - a[1];
    const double  square = du * du + dv * dv;
    const double  t =
      square > 0.0 ? std::min(1.0, std::max(0.0, ((p[0] - a[0]) * du + (p[1] - a[1]) * dv) / square)) : 0.0;
    if (i != except)
    {
      best = std::min(best, std::hypot(p[0] - a[0] - t * du, p[1] - a[1] - t * dv));
    }
  }
  return best;
}

/** The grid's cell is 2^-18 px at the sizes used here; offsets are well above it. */
constexpr double Offset = 1e-3;

/** What makes the loops the outer boundary: just outside of every stretch nothing is covered, just inside something
 * is, and nothing covered is outside. Rims project to the loop. */
void
ExpectOuterBoundary(const Surface &         surface,
                    const Projection &      projection,
                    const itk::Silhouette & silhouette,
                    bool                    flatPartsAllowed = false)
{
  std::vector<std::array<Pixel, 3>> triangles;
  for (const auto & t : surface.triangles)
  {
    // A triangle with two corners at one position is no triangle.
    if (surface.points[t[0]] == surface.points[t[1]] || surface.points[t[1]] == surface.points[t[2]] ||
        surface.points[t[2]] == surface.points[t[0]])
    {
      continue;
    }
    triangles.push_back({ Project(projection, surface.points[t[0]]),
                          Project(projection, surface.points[t[1]]),
                          Project(projection, surface.points[t[2]]) });
  }
  double previousArea = std::numeric_limits<double>::max();
  for (const itk::SilhouetteLoop & loop : silhouette.loops)
  {
    const std::size_t n = loop.points.size();
    ASSERT_GE(n, 2u);
    ASSERT_EQ(loop.rimStart.size(), n);
    ASSERT_EQ(loop.rimEnd.size(), n);
    ASSERT_EQ(loop.edges.size(), n);
    EXPECT_GE(loop.Area(), -1e-9);
    EXPECT_LE(loop.Area(), previousArea);
    previousArea = loop.Area();
    for (std::size_t i = 0; i < n; ++i)
    {
      const Pixel & a = loop.points[i];
      const Pixel & b = loop.points[(i + 1) % n];
      const Pixel   rimA = Project(projection, loop.rimStart[i]);
      const Pixel   rimB = Project(projection, loop.rimEnd[i]);
      EXPECT_LT(std::hypot(rimA[0] - a[0], rimA[1] - a[1]), 1e-4);
      EXPECT_LT(std::hypot(rimB[0] - b[0], rimB[1] - b[1]), 1e-4);
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      if (length < 10.0 * Offset)
      {
        continue;
      }
      const Pixel normal{ (b[1] - a[1]) / length, -(b[0] - a[0]) / length };
      const Pixel middle{ 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) };
      const Pixel outside{ middle[0] + Offset * normal[0], middle[1] + Offset * normal[1] };
      const Pixel inside{ middle[0] - Offset * normal[0], middle[1] - Offset * normal[1] };
      // In a slit narrower than the offset the other side is met.
      if (IsCovered(triangles, outside))
      {
        EXPECT_LT(DistanceToLoop(loop, outside, i), Offset) << "segment " << i << " of " << n << " length " << length;
      }
      if (!flatPartsAllowed)
      {
        EXPECT_TRUE(IsCovered(triangles, inside)) << "segment " << i << " of " << n << " length " << length;
      }
    }
  }
  const auto expectInside = [&](const Pixel & p) {
    bool   inside = false;
    double distance = std::numeric_limits<double>::max();
    for (const itk::SilhouetteLoop & loop : silhouette.loops)
    {
      inside = inside || IsInside(loop, p);
      distance = std::min(distance, inside ? 0.0 : DistanceToLoop(loop, p));
    }
    EXPECT_LT(distance, 1e-4) << p[0] << ", " << p[1];
  };
  for (const auto & t : triangles)
  {
    expectInside(t[0]);
    expectInside({ (t[0][0] + t[1][0] + t[2][0]) / 3.0, (t[0][1] + t[1][1] + t[2][1]) / 3.0 });
  }
}

/** Area of the convex hull of projected points. */
double
HullArea(std::vector<Pixel> points)
{
  std::sort(points.begin(), points.end());
  std::vector<Pixel> hull;
  for (unsigned int pass = 0; pass < 2; ++pass)
  {
    const std::size_t base = hull.size();
    for (const Pixel & p : points)
    {
      while (hull.size() >= base + 2 && Turn(hull[hull.size() - 2], hull.back(), p) <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  double twice = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i)
  {
    twice += Turn(hull[0], hull[i], hull[(i + 1) % hull.size()]);
  }
  return 0.5 * twice;
}

double
TotalArea(const itk::Silhouette & silhouette)
{
  double area = 0.0;
  for (const itk::SilhouetteLoop & loop : silhouette.loops)
  {
    area += loop.Area();
  }
  return area;
}

Surface
MakeSoup(itk::ReproducibleRandom & random, unsigned int triangles, double size, double lattice)
{
  Surface soup;
  for (unsigned int t = 0; t < triangles; ++t)
  {
    Vector center{ random.Uniform(-20, 20), random.Uniform(-20, 20), random.Uniform(-20, 20) };
    for (std::uint32_t k = 0; k < 3; ++k)
    {
      Vector p{};
      for (unsigned int d = 0; d < 3; ++d)
      {
        p[d] = center[d] + random.Uniform(-size, size);
        if (lattice > 0.0)
        {
          p[d] = lattice * std::round(p[d] / lattice);
        }
      }
      soup.points.push_back(p);
    }
    soup.triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  return soup;
}
} // namespace

TEST(MeshSilhouette, OfNothingIsEmpty)
{
  const itk::MeshSilhouette nothing{ Surface() };
  EXPECT_TRUE(nothing.ComputeOuterBoundary(Projection()).loops.empty());
  EXPECT_TRUE(nothing.ComputeSilhouetteEdges(Projection()).empty());
  Surface points;
  points.points = { { 0, 0, 0 }, { 1, 0, 0 } };
  points.triangles = { { 0, 1, 1 } };
  EXPECT_TRUE(itk::MeshSilhouette(points).ComputeOuterBoundary(MakeProjection(Identity(), {})).loops.empty());
}

TEST(MeshSilhouette, RefusesBrokenInput)
{
  Surface surface = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  surface.triangles.push_back({ 0, 1, 8 });
  EXPECT_THROW(itk::MeshSilhouette{ surface }, std::invalid_argument);
  surface = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  surface.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(itk::MeshSilhouette{ surface }, std::invalid_argument);
  const itk::MeshSilhouette behind{ MakeBox({ 0, -3000, 0 }, { 1, 1, 1 }) };
  EXPECT_THROW(behind.ComputeOuterBoundary(MakeProjection(Identity(), {})), std::domain_error);
}

TEST(MeshSilhouette, OfASphereIsThePerspectiveEllipse)
{
  // Not on the central ray, and near: an ellipse, not a circle. Tangent cone from source s to the sphere (c, r): x is
  // on it where ((x - s).(c - s))^2 = |x - s|^2 (|c - s|^2 - r^2).
  const Surface    sphere = MakeSphere({ 60, 5, 40 }, 25, 6);
  const Projection projection = MakeProjection(Identity(), {}, 200.0, 260.0);
  const auto       silhouette = itk::MeshSilhouette(sphere).ComputeOuterBoundary(projection);
  ASSERT_EQ(silhouette.loops.size(), 1u);
  const Vector w{ 60, 205, 40 };
  const double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
  double       largest = 0.0;
  for (const Pixel & p : silhouette.loops[0].points)
  {
    // Ray of the pixel from the definition of the projection.
    const Vector d{ (p[0] - 350.0) * 0.25, 260.0, -(p[1] - 400.0) * 0.25 };
    const double norm = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double along = (d[0] * w[0] + d[1] * w[1] + d[2] * w[2]) / norm;
    // Distance of the ray from the centre against the radius, in pixels at the sphere's depth.
    largest = std::max(largest, std::abs(std::sqrt(square - along * along) - 25.0) * 260.0 / 205.0 / 0.25);
  }
  // The polyhedron lies inside its sphere by edge^2 / 8 r = 0.0017 mm (edge 0.47 mm), once more between its silhouette
  // corners: below 0.02 px at 5 px/mm.
  EXPECT_LT(largest, 0.02);
  EXPECT_GT(silhouette.loops[0].points.size(), 200u);
}

TEST(MeshSilhouette, OfABoxIsItsConvexHullInEveryPose)
{
  itk::ReproducibleRandom   random(1);
  const Surface             box = MakeBox({ -11, -7, -5 }, { 9, 8, 13 });
  const itk::MeshSilhouette silhouette(box);
  EXPECT_EQ(silhouette.GetNumberOfEdges(), 18u);
  EXPECT_EQ(silhouette.GetNumberOfBoundaryEdges(), 0u);
  for (unsigned int pose = 0; pose < 10000; ++pose)
  {
    // Every other one axis-aligned, with and without a shift, near and far.
    const Rotation r = pose % 2 == 0 ? RandomRotation(random) : AxisAlignedRotation(pose / 2);
    const Vector t{ pose % 3 == 0 ? 0.0 : random.Uniform(-50, 50), 0.0, pose % 5 == 0 ? 0.0 : random.Uniform(-50, 50) };
    const Projection projection = MakeProjection(r, t, pose % 7 == 0 ? 150.0 : 1524.0);
    const auto       result = silhouette.ComputeOuterBoundary(projection);
    ASSERT_EQ(result.loops.size(), 1u) << pose;
    std::vector<Pixel> corners;
    for (const Vector & p : box.points)
    {
      corners.push_back(Project(projection, p));
    }
    // Rounding moves a boundary of some 500 px by 2^-19 px.
    ASSERT_NEAR(result.loops[0].Area(), HullArea(corners), 2e-2) << pose;
    ASSERT_GE(result.loops[0].points.size(), 4u) << pose;
  }
}

TEST(MeshSilhouette, OfCurvedBodiesIsTheirOuterBoundary)
{
  itk::ReproducibleRandom random(2);
  Surface                 spheres = MakeSphere({ -6, 0, 0 }, 10, 2);
  Append(spheres, MakeSphere({ 7, 2, 1 }, 8, 2));
  const Surface surfaces[] = { MakeTube(15, 5, 2 * Pi, 30, 12, 0.0, 0),
                               MakeTube(20, 5, 3.3, 40, 12, 0.2, 8),
                               MakeSphere({ 0, 0, 0 }, 12, 2),
                               spheres };
  for (const Surface & surface : surfaces)
  {
    const itk::MeshSilhouette silhouette(surface);
    for (unsigned int pose = 0; pose < 24; ++pose)
    {
      const Rotation   r = pose % 2 == 0 ? RandomRotation(random) : AxisAlignedRotation(pose);
      const Projection projection = MakeProjection(r, { 3.5, 0, -2 }, pose % 3 == 0 ? 100.0 : 1524.0);
      const auto       result = silhouette.ComputeOuterBoundary(projection);
      SCOPED_TRACE(pose);
      EXPECT_EQ(result.loops.size(), 1u);
      ExpectOuterBoundary(surface, projection, result);
    }
  }
}

TEST(MeshSilhouette, OfATorusIgnoresItsHole)
{
  const Surface    torus = MakeTube(20, 5, 2 * Pi, 200, 60, 0.0, 0);
  const Rotation   faceOn{ Vector{ 1, 0, 0 }, Vector{ 0, 0, 1 }, Vector{ 0, -1, 0 } };
  const Projection projection = MakeProjection(faceOn, {}, 1e6, 1.1e6);
  const auto       result = itk::MeshSilhouette(torus).ComputeOuterBoundary(projection);
  ASSERT_EQ(result.loops.size(), 1u);
  // A polygon of 200 corners on a circle of 25 mm, 4.4 px/mm, from so far away that perspective counts for nothing.
  const double radius = 25.0 * 1.1 / 0.25;
  EXPECT_NEAR(result.loops[0].Area() / (0.5 * 200 * radius * radius * std::sin(2 * Pi / 200)), 1.0, 1e-4);
}

TEST(MeshSilhouette, OfOpenShellsUsesTheirRims)
{
  itk::ReproducibleRandom random(3);
  // A bowl: the lower half of a sphere, cut through triangles' corners, and half a tube cut lengthwise.
  Surface bowl = MakeSphere({ 0, 0, 0 }, 12, 3);
  Surface half;
  half.points = bowl.points;
  for (const auto & t : bowl.triangles)
  {
    if (bowl.points[t[0]][2] + bowl.points[t[1]][2] + bowl.points[t[2]][2] < 0.0)
    {
      half.triangles.push_back(t);
    }
  }
  Surface gutter = MakeTube(20, 6, 3.2, 40, 16, 0.1, 6);
  Surface cut;
  cut.points = gutter.points;
  for (const auto & t : gutter.triangles)
  {
    if (t[0] % 16 < 9 && t[1] % 16 < 9 && t[2] % 16 < 9)
    {
      cut.triangles.push_back(t);
    }
  }
  for (const Surface & surface : { half, cut })
  {
    const itk::MeshSilhouette silhouette(surface);
    EXPECT_GT(silhouette.GetNumberOfBoundaryEdges(), 20u);
    for (unsigned int pose = 0; pose < 30; ++pose)
    {
      const Rotation   r = pose % 2 == 0 ? RandomRotation(random) : AxisAlignedRotation(pose);
      const Projection projection = MakeProjection(r, {});
      SCOPED_TRACE(pose);
      const auto result = silhouette.ComputeOuterBoundary(projection);
      EXPECT_EQ(result.loops.size(), 1u);
      ExpectOuterBoundary(surface, projection, result);
    }
  }
}

TEST(MeshSilhouette, OfSeparatePartsHasALoopEach)
{
  const Projection projection = MakeProjection(Identity(), {});
  Surface          surface = MakeBox({ -30, -5, -5 }, { -20, 5, 5 });
  Append(surface, MakeSphere({ 0, 0, 0 }, 12, 3));
  // Hidden behind the sphere: no loop of its own.
  Append(surface, MakeBox({ -3, 20, -3 }, { 3, 24, 3 }));
  // In front of the sphere's limb: one loop with it.
  Append(surface, MakeBox({ 10, -30, -2 }, { 16, -25, 2 }));
  const itk::MeshSilhouette silhouette(surface);
  EXPECT_EQ(silhouette.GetNumberOfComponents(), 4u);
  const auto result = silhouette.ComputeOuterBoundary(projection);
  ASSERT_EQ(result.loops.size(), 2u);
  EXPECT_GT(result.loops[0].Area(), result.loops[1].Area());
  ExpectOuterBoundary(surface, projection, result);
}

TEST(MeshSilhouette, OfASoupIsItsOuterBoundary)
{
  itk::ReproducibleRandom random(4);
  for (unsigned int trial = 0; trial < 150; ++trial)
  {
    // Loose triangles, large and small, every third time on a lattice so that corners and edges coincide.
    const Surface    soup = MakeSoup(random, 5 + trial % 40, trial % 2 == 0 ? 15.0 : 4.0, trial % 3 == 0 ? 4.0 : 0.0);
    const Projection projection = MakeProjection(
      trial % 6 < 3 ? AxisAlignedRotation(trial) : RandomRotation(random), {}, trial % 5 == 0 ? 90 : 1524);
    SCOPED_TRACE(trial);
    const auto result = itk::MeshSilhouette(soup).ComputeOuterBoundary(projection);
    ExpectOuterBoundary(soup, projection, result, trial % 3 == 0);
  }
}

TEST(MeshSilhouette, AgreesWithTheRaster)
{
  itk::ReproducibleRandom   random(5);
  const Surface             surface = MakeTube(28, 6, 3.3, 120, 30, 0.15, 14);
  const itk::MeshSilhouette silhouette(surface);
  for (unsigned int pose = 0; pose < 6; ++pose)
  {
    const Projection projection = MakeProjection(RandomRotation(random), {});
    const auto       result = silhouette.ComputeOuterBoundary(projection);
    const auto       raster = itk::ComputeSilhouetteCoverage(surface, projection, 700, 800, 4, true);
    // The area of a raster of n samples a pixel is good to about its boundary's samples' root: 1500 px * 4 samples,
    // each wrong by up to half a sample of 1/16 px^2 at random; 5 standard deviations.
    EXPECT_NEAR(TotalArea(result), raster.Area(), 5.0 * std::sqrt(1500.0 * 4.0) * 0.3 / 16.0) << pose;
    // No pixel is half covered away from the contour.
    for (std::size_t j = 0; j < raster.height; j += 7)
    {
      for (std::size_t i = 0; i < raster.width; i += 7)
      {
        const float value = raster.values[j * raster.width + i];
        if (value > 0.0f && value < 1.0f)
        {
          EXPECT_LT(DistanceToLoop(result.loops[0], { static_cast<double>(i), static_cast<double>(j) }), 1.0);
        }
      }
    }
  }
}

TEST(MeshSilhouette, SurvivesAdversarialTopology)
{
  // Axis-aligned boxes that share faces and edges without sharing points (T-junctions), a duplicated triangle, one of
  // the opposite sense, a fin (three faces at an edge), needles, collinear triangles, and coincident points.
  Surface surface = MakeBox({ 0, 0, 0 }, { 10, 10, 10 });
  Append(surface, MakeBox({ 10, 0, 0 }, { 15, 5, 5 }));
  Append(surface, MakeBox({ 10, 5, 2.5 }, { 12.5, 10, 7.5 }));
  Append(surface, MakeBox({ -4, 0, 0 }, { 0, 10, 10 }));
  surface.triangles.push_back(surface.triangles[0]);
  surface.triangles.push_back({ surface.triangles[1][0], surface.triangles[1][2], surface.triangles[1][1] });
  const auto fin = static_cast<std::uint32_t>(surface.points.size());
  surface.points.push_back({ 5, 20, 5 });
  surface.points.push_back({ 5, 10, 10.0000001 });
  surface.points.push_back({ 5, 10, 10 });
  surface.points.push_back({ 8, 10, 10 });
  surface.points.push_back({ 30, 10, 10 });
  surface.points.push_back({ 10, 10, 10 });
  surface.triangles.push_back({ 2, 3, fin });
  surface.triangles.push_back({ 6, 7, fin + 1 });
  surface.triangles.push_back({ 6, 7, fin + 2 });
  surface.triangles.push_back({ fin + 2, fin + 3, fin + 4 });
  surface.triangles.push_back({ fin + 5, 7, fin + 3 });
  const itk::MeshSilhouette silhouette(surface);
  EXPECT_GT(silhouette.GetNumberOfNonManifoldEdges(), 0u);
  itk::ReproducibleRandom random(6);
  for (unsigned int pose = 0; pose < 200; ++pose)
  {
    const Rotation   r = pose % 2 == 0 ? AxisAlignedRotation(pose / 2) : RandomRotation(random);
    const Vector     t{ pose % 3 == 0 ? 0.0 : random.Uniform(-9, 9), 0.0, pose % 5 == 0 ? 0.0 : random.Uniform(-9, 9) };
    const Projection projection = MakeProjection(r, t, pose % 7 == 0 ? 150.0 : 1524.0);
    SCOPED_TRACE(pose);
    const auto result = silhouette.ComputeOuterBoundary(projection);
    EXPECT_EQ(result.loops.size(), 1u);
    ExpectOuterBoundary(surface, projection, result, true);
  }
}

TEST(MeshSilhouette, OfAFlatPartSeenEdgeOnRunsThereAndBack)
{
  // A plate in the plane x = 0, seen along it from a source in that plane.
  Surface plate;
  plate.points = { { 0, -5, -5 }, { 0, 5, -5 }, { 0, 5, 5 }, { 0, -5, 5 } };
  plate.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  const auto result = itk::MeshSilhouette(plate).ComputeOuterBoundary(MakeProjection(Identity(), {}));
  ASSERT_EQ(result.loops.size(), 1u);
  EXPECT_EQ(result.loops[0].Area(), 0.0);
  double low = 1e9;
  double high = -1e9;
  for (const Pixel & p : result.loops[0].points)
  {
    EXPECT_NEAR(p[0], 350.0, 1e-5);
    low = std::min(low, p[1]);
    high = std::max(high, p[1]);
  }
  // The near edge, at depth 1519 mm, is the longest.
  EXPECT_NEAR(high - low, 10.0 * 1674.0 / 1519.0 / 0.25, 1e-4);
}

TEST(MeshSilhouette, NeverFailsOnRandomSoups)
{
  itk::ReproducibleRandom random(7);
  for (unsigned int trial = 0; trial < 10000; ++trial)
  {
    // Lattices of few values make every kind of coincidence frequent.
    const double     lattice = trial % 4 == 0 ? 0.0 : (trial % 4 == 1 ? 1.0 : 8.0);
    const Surface    soup = MakeSoup(random, 1 + trial % 30, trial % 2 == 0 ? 12.0 : 2.0, lattice);
    const Projection projection = MakeProjection(
      trial % 3 == 0 ? RandomRotation(random) : AxisAlignedRotation(trial), {}, trial % 5 == 0 ? 64.0 : 1e5, 1.1e5);
    const auto result = itk::MeshSilhouette(soup).ComputeOuterBoundary(projection);
    for (const itk::SilhouetteLoop & loop : result.loops)
    {
      ASSERT_GE(loop.points.size(), 2u) << trial;
      ASSERT_GE(loop.Area(), -1e-6) << trial;
    }
  }
}

TEST(MeshSilhouette, EdgesAreThoseOfTheDefinition)
{
  // The clusters must not lose an edge: compare with every edge looked at in double precision.
  itk::ReproducibleRandom   random(8);
  const Surface             surface = MakeTube(28, 6, 3.3, 60, 24, 0.15, 10);
  const itk::MeshSilhouette silhouette(surface);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> opposites;
  for (const auto & t : surface.triangles)
  {
    for (unsigned int k = 0; k < 3; ++k)
    {
      opposites[std::minmax(t[k], t[(k + 1) % 3])].push_back(t[(k + 2) % 3]);
    }
  }
  EXPECT_EQ(silhouette.GetNumberOfEdges(), opposites.size());
  for (unsigned int pose = 0; pose < 60; ++pose)
  {
    const Projection projection = MakeProjection(RandomRotation(random), {}, 60.0 + 40 * pose);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (const auto & entry : opposites)
    {
      const Pixel a = Project(projection, surface.points[entry.first.first]);
      const Pixel b = Project(projection, surface.points[entry.first.second]);
      bool        left = false;
      bool        right = false;
      for (const std::uint32_t c : entry.second)
      {
        const double side = Turn(a, b, Project(projection, surface.points[c]));
        left = left || side > 0;
        right = right || side < 0;
      }
      if (!(left && right))
      {
        expected.push_back(entry.first);
      }
    }
    auto edges = silhouette.ComputeSilhouetteEdges(projection);
    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(edges, expected) << pose;
  }
}

TEST(MeshSilhouette, IsTheSameFromAnyThread)
{
  const itk::MeshSilhouette silhouette(MakeTube(28, 6, 3.3, 60, 24, 0.15, 10));
  itk::ReproducibleRandom   random(9);
  std::vector<Projection>   projections;
  for (unsigned int pose = 0; pose < 32; ++pose)
  {
    projections.push_back(MakeProjection(RandomRotation(random), {}));
  }
  const auto run = [&](unsigned int threads) {
    std::vector<itk::Silhouette> results(projections.size());
    itk::ParallelFor(projections.size(), threads, [&](std::size_t i) {
      results[i] = silhouette.ComputeOuterBoundary(projections[i]);
    });
    return results;
  };
  const auto one = run(1);
  const auto four = run(4);
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_EQ(one[i].loops[0].points, four[i].loops[0].points);
    EXPECT_EQ(one[i].loops[0].rimStart, four[i].loops[0].rimStart);
  }
}

TEST(MeshSilhouette, MadeForOnePoseIsThatMadeForManyToTheLastBit)
{
  using PosesEnum = itk::MeshSilhouette::PosesEnum;
  itk::ReproducibleRandom random(12);
  std::vector<Surface>    surfaces{ MakeTube(28, 6, 3.3, 60, 24, 0.15, 10), MakeSphere({ 20, 5, 10 }, 25, 4) };
  // Doubled and needle-like triangles, edges of three faces, several parts.
  for (unsigned int soup = 0; soup < 6; ++soup)
  {
    surfaces.push_back(MakeSoup(random, 60, 12.0, soup % 2 == 0 ? 0.0 : 2.0));
  }
  const auto expectSame = [](const itk::Silhouette & found, const itk::Silhouette & expected) {
    ASSERT_EQ(found.loops.size(), expected.loops.size());
    for (std::size_t l = 0; l < found.loops.size(); ++l)
    {
      EXPECT_EQ(found.loops[l].points, expected.loops[l].points);
      EXPECT_EQ(found.loops[l].rimStart, expected.loops[l].rimStart);
      EXPECT_EQ(found.loops[l].rimEnd, expected.loops[l].rimEnd);
      EXPECT_EQ(found.loops[l].edges, expected.loops[l].edges);
    }
  };
  for (const Surface & surface : surfaces)
  {
    const itk::MeshSilhouette many(surface);
    itk::MeshSilhouette       one(surface, PosesEnum::One);
    EXPECT_EQ(one.GetNumberOfEdges(), many.GetNumberOfEdges());
    for (unsigned int pose = 0; pose < 12; ++pose)
    {
      // From the sixth pose on it has clusters, too; asked for them again it keeps those that it has.
      if (pose >= 6)
      {
        one.ClusterEdges();
      }
      const Projection projection = MakeProjection(RandomRotation(random), {});
      EXPECT_EQ(one.ComputeSilhouetteEdges(projection), many.ComputeSilhouetteEdges(projection)) << pose;
      expectSame(one.ComputeOuterBoundary(projection), many.ComputeOuterBoundary(projection));
    }
  }
  const Surface surface = MakeSphere({ 0, 0, 0 }, 25, 3);
  for (const PosesEnum poses : { PosesEnum::One, PosesEnum::Many })
  {
    Projection behind = MakeProjection(RandomRotation(random), {});
    behind.matrix[11] = 0.0;
    EXPECT_THROW(itk::MeshSilhouette(surface, poses).ComputeOuterBoundary(behind), std::domain_error);
    EXPECT_TRUE(itk::MeshSilhouette(Surface(), poses).ComputeOuterBoundary(behind).loops.empty());
  }
}

TEST(MeshSilhouette, DoesNotDependOnWeldingOrOrientation)
{
  const Surface           welded = MakeTube(28, 6, 3.3, 60, 24, 0.15, 10);
  itk::ReproducibleRandom random(10);
  Surface                 loose;
  for (const auto & t : welded.triangles)
  {
    const auto first = static_cast<std::uint32_t>(loose.points.size());
    for (const std::uint32_t corner : t)
    {
      loose.points.push_back(welded.points[corner]);
    }
    // Every other triangle the wrong way round.
    loose.triangles.push_back(first % 2 == 0 ? Surface::TriangleType{ first, first + 1, first + 2 }
                                             : Surface::TriangleType{ first, first + 2, first + 1 });
  }
  const itk::MeshSilhouette a(welded);
  const itk::MeshSilhouette b(loose);
  EXPECT_EQ(a.GetNumberOfEdges(), b.GetNumberOfEdges());
  for (unsigned int pose = 0; pose < 10; ++pose)
  {
    const Projection projection = MakeProjection(RandomRotation(random), {});
    EXPECT_EQ(a.ComputeOuterBoundary(projection).loops[0].points, b.ComputeOuterBoundary(projection).loops[0].points);
  }
}

TEST(MeshSilhouette, SamplesAreEquidistantWithRimAndNormal)
{
  const Surface    sphere = MakeSphere({ 20, 5, 10 }, 25, 5);
  const Projection projection = MakeProjection(Identity(), {}, 200.0, 260.0);
  const auto       loop = itk::MeshSilhouette(sphere).ComputeOuterBoundary(projection).loops.at(0);
  const auto       samples = itk::ResampleSilhouetteLoop(loop, projection, 441);
  ASSERT_EQ(samples.size(), 441u);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const auto & sample = samples[i];
    const Pixel  rim = Project(projection, sample.rim);
    EXPECT_NEAR(rim[0], sample.u, 1e-5);
    EXPECT_NEAR(rim[1], sample.v, 1e-5);
    EXPECT_NEAR(std::hypot(sample.normal[0], sample.normal[1]), 1.0, 1e-12);
    EXPECT_FALSE(IsInside(loop, { sample.u + 0.01 * sample.normal[0], sample.v + 0.01 * sample.normal[1] }));
    EXPECT_TRUE(IsInside(loop, { sample.u - 0.01 * sample.normal[0], sample.v - 0.01 * sample.normal[1] }));
    EXPECT_NEAR(sample.arcLength, samples[1].arcLength * static_cast<double>(i), 1e-9);
  }
  const double length = samples[1].arcLength * 441.0;
  EXPECT_EQ(itk::ResampleSilhouetteLoopBySpacing(loop, projection, 2.0).size(),
            static_cast<std::size_t>(std::floor(length / 2.0 + 0.5)));
  EXPECT_THROW(itk::ResampleSilhouetteLoopBySpacing(loop, projection, 0.0), std::invalid_argument);
  EXPECT_TRUE(itk::ResampleSilhouetteLoop(itk::SilhouetteLoop(), projection, 5).empty());
}

TEST(SilhouetteCoverage, OfASquareIsExact)
{
  // Corners at half pixels.
  Surface          square;
  const Projection projection = MakeProjection(Identity(), {}, 1000.0, 1250.0);
  const double     s = 0.2; // mm a pixel at depth 1000
  for (const auto & corner :
       { Pixel{ -300.5, -350.5 }, Pixel{ -290.5, -350.5 }, Pixel{ -290.5, -340.5 }, Pixel{ -300.5, -340.5 } })
  {
    square.points.push_back({ s * corner[0], 0.0, -s * corner[1] });
  }
  square.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  const auto coverage = itk::ComputeSilhouetteCoverage(square, projection, 100, 100, 3, false);
  EXPECT_NEAR(coverage.Area(), 100.0, 1e-3);
  EXPECT_EQ(coverage.values[50 * 100 + 50], 1.0f);
  EXPECT_EQ(coverage.values[49 * 100 + 50], 0.0f);
  EXPECT_THROW(itk::ComputeSilhouetteCoverage(square, projection, 0, 100, 3, false), std::invalid_argument);
}
