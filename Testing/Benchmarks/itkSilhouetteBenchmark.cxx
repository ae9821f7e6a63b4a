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
#include "itkBenchmark.h"

#include "itkMeshSilhouette.h"
#include "itkReproducibleRandom.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataSilhouette.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <sstream>
#include <string>
#include <vector>

namespace itk
{
namespace
{
constexpr std::size_t Poses = 12;

/** A scan, what is prepared of it, and views of it from everywhere. */
struct Scene
{
  const TriangleSurface *            surface;
  MeshSilhouette                     silhouette;
  std::vector<PerspectiveProjection> poses;
};

/** A film of 0.25 mm pixels, the scan turned about its middle, 1524 mm from the source. */
PerspectiveProjection
MakePose(const std::array<double, 9> & r, const std::array<double, 3> & center)
{
  const double          distance = 1524.0;
  const double          focal = 1674.0 / 0.25;
  std::array<double, 3> t{};
  for (unsigned int i = 0; i < 3; ++i)
  {
    t[i] = -r[3 * i] * center[0] - r[3 * i + 1] * center[1] - r[3 * i + 2] * center[2];
  }
  const double          rows[3][4] = { { focal, 350.0, 0.0, 350.0 * distance },
                                       { 0.0, 400.0, -focal, 400.0 * distance },
                                       { 0.0, 1.0, 0.0, distance } };
  PerspectiveProjection projection;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int k = 0; k < 3; ++k)
    {
      projection.matrix[4 * row + k] = rows[row][0] * r[k] + rows[row][1] * r[3 + k] + rows[row][2] * r[6 + k];
    }
    projection.matrix[4 * row + 3] = rows[row][0] * t[0] + rows[row][1] * t[1] + rows[row][2] * t[2] + rows[row][3];
  }
  for (unsigned int k = 0; k < 3; ++k)
  {
    projection.source[k] = center[k] - distance * r[3 + k];
  }
  return projection;
}

std::array<double, 9>
RandomRotation(ReproducibleRandom & random)
{
  double q[4];
  double norm = 0.0;
  for (double & x : q)
  {
    x = random.Normal();
    norm += x * x;
  }
  norm = std::sqrt(norm);
  const double w = q[0] / norm, x = q[1] / norm, y = q[2] / norm, z = q[3] / norm;
  return { 1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
           2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
           2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y) };
}

/** One of the turns that map axes to axes. */
std::array<double, 9>
AxisAlignedRotation(unsigned int which)
{
  const unsigned int    orders[3][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 } };
  std::array<double, 9> r{};
  const double          s0 = which & 1u ? -1.0 : 1.0;
  const double          s1 = which & 2u ? -1.0 : 1.0;
  r[orders[which / 4 % 3][0]] = s0;
  r[3 + orders[which / 4 % 3][1]] = s1;
  r[6 + orders[which / 4 % 3][2]] = s0 * s1;
  return r;
}

Scene
MakeScene(const TriangleSurface & surface)
{
  Scene              scene{ &surface, MeshSilhouette(surface), {} };
  const auto         center = surface.AreaCentroid();
  ReproducibleRandom random(17);
  for (std::size_t i = 0; i < Poses; ++i)
  {
    scene.poses.push_back(MakePose(RandomRotation(random), center));
  }
  return scene;
}

using SceneFunction = const Scene & (*)();

BenchmarkFunction
Edges(SceneFunction scene)
{
  return [scene](benchmark::State & state) {
    const Scene & made = scene();
    std::size_t   edges = 0;
    for (auto _ : state)
    {
      edges = 0;
      for (const PerspectiveProjection & pose : made.poses)
      {
        edges += made.silhouette.ComputeSilhouetteEdges(pose).size();
      }
    }
    state.counters["edges"] = static_cast<double>(edges) / Poses;
  };
}

BenchmarkFunction
Boundary(SceneFunction scene)
{
  return [scene](benchmark::State & state) {
    const Scene & made = scene();
    std::size_t   segments = 0;
    for (auto _ : state)
    {
      segments = 0;
      for (const PerspectiveProjection & pose : made.poses)
      {
        for (const SilhouetteLoop & loop : made.silhouette.ComputeOuterBoundary(pose).loops)
        {
          segments += loop.points.size();
        }
      }
    }
    state.counters["segments"] = static_cast<double>(segments) / Poses;
  };
}

BenchmarkFunction
SetUp(SceneFunction scene)
{
  return [scene](benchmark::State & state) {
    const TriangleSurface & surface = *scene().surface;
    for (auto _ : state)
    {
      const MeshSilhouette silhouette(surface);
      benchmark::DoNotOptimize(silhouette.GetNumberOfEdges());
    }
  };
}

BenchmarkFunction
VTKPeer(SceneFunction scene)
{
  return [scene](benchmark::State & state) {
    const Scene &        made = scene();
    vtkNew<vtkPoints>    points;
    vtkNew<vtkCellArray> cells;
    points->SetDataTypeToDouble();
    for (const auto & point : made.surface->points)
    {
      points->InsertNextPoint(point.data());
    }
    for (const auto & triangle : made.surface->triangles)
    {
      const vtkIdType corners[3] = { triangle[0], triangle[1], triangle[2] };
      cells->InsertNextCell(3, corners);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    vtkNew<vtkPolyDataSilhouette> filter;
    filter->SetInputData(data);
    filter->SetDirectionToSpecifiedOrigin();
    filter->SetEnableFeatureAngle(0);
    filter->BorderEdgesOn();
    // It prepares the mesh at its first run, as MeshSilhouette did.
    filter->SetOrigin(made.poses[0].source[0], made.poses[0].source[1], made.poses[0].source[2]);
    filter->Update();
    vtkIdType lines = 0;
    for (auto _ : state)
    {
      lines = 0;
      for (const PerspectiveProjection & pose : made.poses)
      {
        filter->SetOrigin(pose.source[0], pose.source[1], pose.source[2]);
        filter->Update();
        lines += filter->GetOutput()->GetNumberOfLines();
      }
    }
    state.counters["edges"] = static_cast<double>(lines) / Poses;
  };
}

/** Contours that throw, are empty, or do not close: each mesh point where a piece ends must project to the corner where
 * the next begins. */
std::size_t
CountFailures(const Scene & scene, std::size_t poses)
{
  ReproducibleRandom random(23);
  const auto         center = scene.surface->AreaCentroid();
  std::size_t        failures = 0;
  for (std::size_t i = 0; i < poses; ++i)
  {
    const PerspectiveProjection pose =
      MakePose(i % 4 == 0 ? AxisAlignedRotation(static_cast<unsigned int>(i / 4)) : RandomRotation(random), center);
    bool failed = false;
    try
    {
      const Silhouette boundary = scene.silhouette.ComputeOuterBoundary(pose);
      failed = boundary.loops.empty();
      for (const SilhouetteLoop & loop : boundary.loops)
      {
        failed = failed || !(loop.Area() >= 0.0);
        for (std::size_t k = 0; k < loop.points.size() && !failed; ++k)
        {
          double u = 0.0;
          double v = 0.0;
          pose.Project(loop.rimEnd[k].data(), u, v);
          const auto & next = loop.points[(k + 1) % loop.points.size()];
          failed = !(std::hypot(u - next[0], v - next[1]) < 1e-4);
        }
      }
    }
    catch (const std::exception &)
    {
      failed = true;
    }
    failures += failed ? 1 : 0;
  }
  return failures;
}

void
RegisterScene(const std::string & name, SceneFunction scene, bool isFullSize)
{
  const std::string work = name + ", 12 poses";
  RegisterKernel("silhouette edges", work, Edges(scene));
  RegisterPeer("silhouette edges", work, "vtkPolyDataSilhouette", 100.0, VTKPeer(scene));
  RegisterKernel("exact outer boundary", work, Boundary(scene), isFullSize ? static_cast<double>(Poses) : 0.0);
  RegisterPeer("exact outer boundary", work, "vtkPolyDataSilhouette, edges only", 15.0, VTKPeer(scene));
}

double
SecondsOf(const Scene & scene)
{
  double best = 1e300;
  for (unsigned int repetition = 0; repetition < 9; ++repetition)
  {
    const std::clock_t start = std::clock();
    for (const PerspectiveProjection & pose : scene.poses)
    {
      benchmark::DoNotOptimize(scene.silhouette.ComputeOuterBoundary(pose).loops.size());
    }
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

template <int VTriangles>
const Scene &
Phantom()
{
  static const Scene scene = MakeScene(PhantomSurface(VTriangles));
  return scene;
}

const Scene &
Cast()
{
  static const Scene scene = MakeScene(CastSurface());
  return scene;
}

void
RegisterAll()
{
  RegisterScene("phantom, 200 k triangles", Phantom<200000>, true);
  if (!CastSurface().points.empty())
  {
    std::ostringstream name;
    name << "scan of a cast, " << (CastSurface().triangles.size() + 500) / 1000 << " k triangles";
    RegisterScene(name.str(), Cast, false);
    RegisterAtMost(
      "exact outer boundary", name.str() + ", 12 poses", "failures in 10 000 poses", 0.0, [](benchmark::State & state) {
        for (auto _ : state)
        {
          state.counters["figure"] = static_cast<double>(CountFailures(Cast(), IsBenchmarkSmokeTest() ? 50 : 10000));
        }
      });
  }
  RegisterAtMost("exact outer boundary",
                 "phantom, 200 k triangles, 12 poses",
                 "exponent of growth, 50 k to 1 M triangles",
                 0.7,
                 [](benchmark::State & state) {
                   const Scene & small = Phantom<50000>();
                   const Scene & large = Phantom<1000000>();
                   for (auto _ : state)
                   {
                     const double sizes = static_cast<double>(large.surface->triangles.size()) /
                                          static_cast<double>(small.surface->triangles.size());
                     state.counters["figure"] =
                       sizes > 1.0 ? std::log(SecondsOf(large) / SecondsOf(small)) / std::log(sizes) : 0.5;
                   }
                 });
  const std::pair<double, SceneFunction> scenes[] = { { 2e3, Phantom<2000> },
                                                      { 1e4, Phantom<10000> },
                                                      { 5e4, Phantom<50000> },
                                                      { 2e5, Phantom<200000> },
                                                      { 1e6, Phantom<1000000> } };
  for (const auto & [triangles, scene] : scenes)
  {
    RegisterGrowth("silhouette edges", "triangles, 12 poses", triangles, Edges(scene));
    RegisterGrowth("exact outer boundary", "triangles, 12 poses", triangles, Boundary(scene));
    RegisterGrowth("silhouette set-up", "triangles", triangles, SetUp(scene));
  }
}

const BenchmarkFile file(RegisterAll);
} // namespace
} // namespace itk
