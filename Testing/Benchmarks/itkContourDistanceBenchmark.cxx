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
#include "itkBenchmarkContours.h"

#include "itkEuclideanDistancePointSetToPointSetMetricv4.h"
#include "itkPointSet.h"
#include "itkSimilarity2DTransform.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace itk
{
namespace
{
/** A moving and a fixed contour, and how far apart the poses leave them. */
struct Scene
{
  std::size_t moving;
  std::size_t fixed;
  double      shift;

  ContourArrays
  MakeMoving() const
  {
    return MakeBenchmarkContour(BenchmarkSize(moving));
  }
  ContourArrays
  MakeFixed() const
  {
    return MakeBenchmarkContour(BenchmarkSize(fixed), ContourSimilarity(), 0.4);
  }
  /** A call of a benchmark evaluates so many poses. */
  std::size_t
  Poses() const
  {
    return moving > 1000 ? 4 : 64;
  }
};

using GradientType = ContourChamferKernel::GradientType;
using DistanceEnum = ContourChamferKernel::DistanceEnum;

BenchmarkFunction
Ours(const Scene & scene, DistanceEnum distance)
{
  return [scene, distance](benchmark::State & state) {
    ContourChamferKernel kernel;
    kernel.Initialize(scene.MakeFixed(), scene.MakeMoving(), distance);
    BenchmarkSimilarities similarities(scene.shift);
    GradientType          gradient{};
    for (auto _ : state)
    {
      for (std::size_t i = 0; i < scene.Poses(); ++i)
      {
        benchmark::DoNotOptimize(
          kernel.Evaluate(similarities.Next(), ContourChamferKernel::DirectionEnum::Symmetric, &gradient));
      }
    }
  };
}

/** A pose once the cells that some poses touch are filled, as in a registration. */
BenchmarkFunction
Growth(std::size_t count)
{
  return [count](benchmark::State & state) {
    const Scene          scene{ count, count, 0.0 };
    ContourChamferKernel kernel;
    kernel.Initialize(scene.MakeFixed(), scene.MakeMoving());
    std::vector<ContourSimilarity> poses(8);
    BenchmarkSimilarities          similarities(0.0);
    GradientType                   gradient{};
    for (ContourSimilarity & pose : poses)
    {
      pose = similarities.Next();
      kernel.Evaluate(pose);
    }
    std::size_t number = 0;
    for (auto _ : state)
    {
      benchmark::DoNotOptimize(
        kernel.Evaluate(poses[number++ % poses.size()], ContourChamferKernel::DirectionEnum::Symmetric, &gradient));
    }
  };
}

/** Adds one direction's share of value and gradient. */
void
AddPair(
  double rx, double ry, double dx, double dy, double scale, double weight, double & value, GradientType & gradient)
{
  const double distance = std::sqrt(dx * dx + dy * dy);
  value += weight * distance;
  const double nx = distance > 0.0 ? dx / distance : 0.0;
  const double ny = distance > 0.0 ? dy / distance : 0.0;
  gradient[0] += weight * (nx * rx + ny * ry) / scale;
  gradient[1] += weight * (ny * rx - nx * ry);
  gradient[2] += weight * nx;
  gradient[3] += weight * ny;
}

/** Value and gradient, the nearest points found by the functions. */
template <typename TNearestFixed, typename TNearestMoving>
double
Evaluate(const ContourArrays &     fixed,
         const ContourArrays &     moving,
         const ContourSimilarity & similarity,
         const TNearestFixed &     nearestFixed,
         const TNearestMoving &    nearestMoving,
         GradientType &            gradient)
{
  const double c = std::cos(similarity.angle);
  const double s = std::sin(similarity.angle);
  double       value = 0.0;
  gradient.fill(0.0);
  for (std::size_t i = 0; i < moving.GetNumberOfPoints(); ++i)
  {
    const double * q = &moving.points[2 * i];
    const double   rx = similarity.scale * (c * q[0] - s * q[1]);
    const double   ry = similarity.scale * (s * q[0] + c * q[1]);
    double         foot[2];
    nearestFixed(rx + similarity.tx, ry + similarity.ty, foot);
    AddPair(rx,
            ry,
            rx + similarity.tx - foot[0],
            ry + similarity.ty - foot[1],
            similarity.scale,
            1.0 / static_cast<double>(moving.GetNumberOfPoints()),
            value,
            gradient);
  }
  for (std::size_t i = 0; i < fixed.GetNumberOfPoints(); ++i)
  {
    const double * p = &fixed.points[2 * i];
    const double   x = (p[0] - similarity.tx) / similarity.scale;
    const double   y = (p[1] - similarity.ty) / similarity.scale;
    double         q[2];
    nearestMoving(c * x + s * y, -s * x + c * y, q);
    const double rx = similarity.scale * (c * q[0] - s * q[1]);
    const double ry = similarity.scale * (s * q[0] + c * q[1]);
    AddPair(rx,
            ry,
            rx + similarity.tx - p[0],
            ry + similarity.ty - p[1],
            similarity.scale,
            1.0 / static_cast<double>(fixed.GetNumberOfPoints()),
            value,
            gradient);
  }
  return value;
}

/** Every point or segment is asked. */
void
FindByAsking(const ContourArrays & contour, DistanceEnum distance, double x, double y, double foot[2])
{
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < contour.GetNumberOfPoints(); ++i)
  {
    const double * a = &contour.points[2 * contour.segments[2 * i]];
    const double * b = &contour.points[2 * contour.segments[2 * i + 1]];
    const double   dx = b[0] - a[0];
    const double   dy = b[1] - a[1];
    const double   along = ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy);
    const double   t = distance == DistanceEnum::PointToPoint ? 0.0 : std::min(1.0, std::max(0.0, along));
    const double   fx = a[0] + t * dx;
    const double   fy = a[1] + t * dy;
    const double   d = (x - fx) * (x - fx) + (y - fy) * (y - fy);
    if (d < best)
    {
      best = d;
      foot[0] = fx;
      foot[1] = fy;
    }
  }
}

/** Largest relative error of the value. */
BenchmarkFunction
Error(const Scene & scene, DistanceEnum distance)
{
  return [scene, distance](benchmark::State & state) {
    const ContourArrays  fixed = scene.MakeFixed();
    const ContourArrays  moving = scene.MakeMoving();
    ContourChamferKernel kernel;
    kernel.Initialize(fixed, moving, distance);
    const auto nearestFixed = [&](double x, double y, double foot[2]) { FindByAsking(fixed, distance, x, y, foot); };
    const auto nearestMoving = [&](double x, double y, double foot[2]) { FindByAsking(moving, distance, x, y, foot); };
    for (auto _ : state)
    {
      BenchmarkSimilarities similarities(scene.shift);
      double                worst = 0.0;
      for (std::size_t i = 0; i < scene.Poses(); ++i)
      {
        const ContourSimilarity similarity = similarities.Next();
        GradientType            gradient{};
        const double            expected = Evaluate(fixed, moving, similarity, nearestFixed, nearestMoving, gradient);
        worst = std::max(worst, std::abs(kernel.Evaluate(similarity) - expected) / expected);
      }
      state.counters["figure"] = worst;
    }
  };
}

/** The points of a contour as nanoflann reads them. */
struct Cloud
{
  explicit Cloud(const ContourArrays & contour)
    : points(contour.points)
    , tree(2, *this, nanoflann::KDTreeSingleIndexAdaptorParams(10))
  {
    tree.buildIndex();
  }
  std::size_t
  kdtree_get_point_count() const
  {
    return points.size() / 2;
  }
  double
  kdtree_get_pt(std::size_t i, std::size_t d) const
  {
    return points[2 * i + d];
  }
  template <typename TBox>
  bool
  kdtree_get_bbox(TBox &) const
  {
    return false;
  }
  void
  Find(double x, double y, double foot[2]) const
  {
    const double query[2] = { x, y };
    unsigned int index = 0;
    double       squared = 0.0;
    tree.knnSearch(query, 1, &index, &squared);
    foot[0] = points[2 * index];
    foot[1] = points[2 * index + 1];
  }

  std::vector<double>                                                                                  points;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2, unsigned> tree;
};

BenchmarkFunction
NanoflannPeer(const Scene & scene)
{
  return [scene](benchmark::State & state) {
    const ContourArrays   fixed = scene.MakeFixed();
    const ContourArrays   moving = scene.MakeMoving();
    const Cloud           fixedCloud(fixed);
    const Cloud           movingCloud(moving);
    BenchmarkSimilarities similarities(scene.shift);
    GradientType          gradient{};
    for (auto _ : state)
    {
      for (std::size_t i = 0; i < scene.Poses(); ++i)
      {
        benchmark::DoNotOptimize(Evaluate(
          fixed,
          moving,
          similarities.Next(),
          [&](double x, double y, double foot[2]) { fixedCloud.Find(x, y, foot); },
          [&](double x, double y, double foot[2]) { movingCloud.Find(x, y, foot); },
          gradient));
      }
    }
  };
}

/** Two metrics, so that neither tree moves: the moving contour under the similarity, the fixed one under its inverse.
 */
BenchmarkFunction
ITKPeer(const Scene & scene)
{
  return [scene](benchmark::State & state) {
    using PointSetType = PointSet<double, 2>;
    using MetricType = EuclideanDistancePointSetToPointSetMetricv4<PointSetType>;
    using TransformType = Similarity2DTransform<double>;
    const auto makeSet = [](const ContourArrays & contour) {
      auto set = PointSetType::New();
      for (std::size_t i = 0; i < contour.GetNumberOfPoints(); ++i)
      {
        PointSetType::PointType point;
        point[0] = contour.points[2 * i];
        point[1] = contour.points[2 * i + 1];
        set->SetPoint(i, point);
      }
      return set;
    };
    const auto makeMetric = [](PointSetType * from, PointSetType * to, TransformType * transform) {
      auto metric = MetricType::New();
      metric->SetFixedPointSet(from);
      metric->SetMovingPointSet(to);
      metric->SetMovingTransform(transform);
      metric->Initialize();
      return metric;
    };
    const auto            fixed = makeSet(scene.MakeFixed());
    const auto            moving = makeSet(scene.MakeMoving());
    auto                  forward = TransformType::New();
    auto                  backward = TransformType::New();
    const auto            forwardMetric = makeMetric(moving, fixed, forward);
    const auto            backwardMetric = makeMetric(fixed, moving, backward);
    BenchmarkSimilarities similarities(scene.shift);
    for (auto _ : state)
    {
      for (std::size_t i = 0; i < scene.Poses(); ++i)
      {
        const ContourSimilarity       similarity = similarities.Next();
        TransformType::ParametersType parameters(4);
        MetricType::MeasureType       value;
        MetricType::DerivativeType    derivative;
        parameters[0] = similarity.scale;
        parameters[1] = similarity.angle;
        parameters[2] = similarity.tx;
        parameters[3] = similarity.ty;
        forward->SetParameters(parameters);
        forward->GetInverse(backward);
        forwardMetric->GetValueAndDerivative(value, derivative);
        benchmark::DoNotOptimize(value);
        backwardMetric->GetValueAndDerivative(value, derivative);
        benchmark::DoNotOptimize(value);
      }
    }
  };
}

void
WriteScene(const Scene & scene, const std::string & folder)
{
  const ContourArrays fixed = scene.MakeFixed();
  const ContourArrays moving = scene.MakeMoving();
  WriteArray(folder + "/fixed.npy", fixed.points.data(), fixed.GetNumberOfPoints(), 2);
  WriteArray(folder + "/moving.npy", moving.points.data(), moving.GetNumberOfPoints(), 2);
  BenchmarkSimilarities similarities(scene.shift);
  std::vector<double>   poses;
  for (std::size_t i = 0; i < scene.Poses(); ++i)
  {
    const ContourSimilarity s = similarities.Next();
    poses.insert(poses.end(), { s.scale, s.angle, s.tx, s.ty });
  }
  WriteArray(folder + "/poses.npy", poses.data(), scene.Poses(), 4);
}

void
RegisterAll()
{
  const std::string kernel = "contour metric, value + gradient";
  const auto        name = [](const Scene & scene, const char * what) {
    return std::to_string(scene.moving) + " x " + std::to_string(scene.fixed) + what;
  };
  for (const double shift : { 0.0, 200.0 })
  {
    for (const Scene & scene : { Scene{ 441, 79, shift }, Scene{ 5000, 5000, shift } })
    {
      const bool        isSmall = scene.moving < 1000;
      const std::string work = name(scene, shift > 0.0 ? " points, 200 px away" : " points");
      RegisterKernel(kernel, work, Ours(scene, DistanceEnum::PointToPoint));
      RegisterScriptPeer(kernel, work, "scipy cKDTree", isSmall ? 15.0 : 8.0, [scene](const std::string & folder) {
        WriteScene(scene, folder);
      });
      RegisterPeer(kernel, work, "ITK EuclideanDistancePointSetToPointSetMetricv4, both ways", 12.0, ITKPeer(scene));
      RegisterPeer(kernel, work, "nanoflann", 2.0, NanoflannPeer(scene));
      RegisterAtMost(kernel, work, "relative error", 1e-12, Error(scene, DistanceEnum::PointToPoint));
      const std::string segments = name(scene, shift > 0.0 ? " segments, 200 px away" : " segments");
      RegisterKernel(kernel, segments, Ours(scene, DistanceEnum::PointToSegment));
      RegisterAtMost(kernel, segments, "relative error", 1e-12, Error(scene, DistanceEnum::PointToSegment));
    }
  }
  for (const std::size_t count : { 100u, 1000u, 10000u, 100000u })
  {
    RegisterGrowth("contour metric", "points a side, a pose", static_cast<double>(count), Growth(count));
  }
}

const BenchmarkFile file(RegisterAll);
} // namespace
} // namespace itk
