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

#include "itkCephalometricGeometry.h"
#include "itkParallelFor.h"
#include "itkSurfaceSplatKernel.h"

#include "itkDiscreteGaussianImageFilter.h"
#include "itkImage.h"
#include "itkPointSet.h"
#include "itkPointSetToImageFilter.h"
#include "vtkFloatArray.h"
#include "vtkGaussianSplatter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
namespace
{
constexpr int Width = 938;
constexpr int Height = 703;

struct Scene
{
  const TriangleSurface * surface{ nullptr };
  std::vector<double>     areas;
  SurfaceSplatProjector   projector;
};

/** The surface seen from the right, 656 pixels wide in the middle of the image. */
Scene
MakeScene(const TriangleSurface & surface)
{
  Scene scene;
  scene.surface = &surface;
  scene.areas = surface.VertexAreas();
  double low[3] = { 1e300, 1e300, 1e300 };
  double high[3] = { -1e300, -1e300, -1e300 };
  for (const auto & point : surface.points)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      low[d] = std::min(low[d], point[d]);
      high[d] = std::max(high[d], point[d]);
    }
  }
  auto                                geometry = CephalometricGeometry::New();
  CephalometricGeometry::RotationType rotation;
  CephalometricGeometry::VectorType   shift;
  rotation.SetIdentity();
  for (unsigned int d = 0; d < 3; ++d)
  {
    shift[d] = -0.5 * (low[d] + high[d]);
  }
  geometry->SetPose(rotation, shift);
  CephalometricGeometry::PixelSpacingType spacing;
  spacing.Fill(1.1 * (high[0] - low[0]) / 656.0);
  geometry->SetPixelSpacing(spacing);
  CephalometricGeometry::PixelIndexType principal;
  principal[0] = 0.5 * Width;
  principal[1] = 0.5 * Height;
  geometry->SetPrincipalPoint(principal);
  SurfaceSplatProjector & projector = scene.projector;
  projector.projection = geometry->GetProjection();
  projector.sourceToMidsagittal = geometry->GetSourceToMidsagittalDistance();
  projector.sourceToDetector = geometry->GetSourceToDetectorDistance();
  projector.physical = true;
  for (unsigned int d = 0; d < 2; ++d)
  {
    projector.principalPoint[d] = principal[d];
    projector.pixelSpacing[d] = spacing[d];
  }
  return scene;
}

void
ProjectScene(const Scene & scene, double sigma, SurfaceSplatLayer & layer, unsigned int threads = 1)
{
  const std::size_t count = scene.surface->points.size();
  layer.u.resize(count);
  layer.v.resize(count);
  layer.weight.resize(count);
  layer.sigmaU = sigma;
  layer.sigmaV = sigma;
  const auto * points = reinterpret_cast<const double(*)[3]>(scene.surface->points.data());
  ParallelFor(threads, threads, [&](std::size_t part) {
    scene.projector.Project(
      points, scene.areas.data(), count * part / threads, count * (part + 1) / threads, 1.0 / (sigma * sigma), layer);
  });
}

SurfaceSplatLayer
ProjectScene(const Scene & scene, double sigma)
{
  SurfaceSplatLayer layer;
  ProjectScene(scene, sigma, layer);
  return layer;
}

/** Makes a scene once, when it is needed. */
using SceneFunction = const Scene & (*)();

struct Renderer
{
  SurfaceSplatLayer  layer;
  SurfaceSplatKernel kernel;
  std::vector<float> image;

  /** What the next pose costs: projection, sorting, splats. */
  void
  Render(const Scene & scene, double sigma, double tolerance, unsigned int threads)
  {
    const SurfaceSplatRegion region{ 0, 0, Width, Height };
    image.resize(Width * Height);
    ParallelFor(Height, threads, [this](std::size_t row) { std::fill_n(image.data() + row * Width, Width, 0.0f); });
    ProjectScene(scene, sigma, layer, threads);
    kernel.Prepare(layer, region, tolerance, SurfaceSplatKernel::MethodEnum::Automatic, threads);
    kernel.Render(region, image.data(), Width, threads);
  }
};

BenchmarkFunction
Ours(SceneFunction scene, double sigma, double tolerance, unsigned int threads)
{
  return [scene, sigma, tolerance, threads](benchmark::State & state) {
    const Scene & made = scene();
    Renderer      renderer;
    for (auto _ : state)
    {
      renderer.Render(made, sigma, tolerance, threads);
      benchmark::DoNotOptimize(renderer.image.data());
    }
  };
}

/** Nearest pixels, unweighted: what the toolkit offers. */
BenchmarkFunction
ITKPeer(SceneFunction scene, double sigma)
{
  return [scene, sigma](benchmark::State & state) {
    using PointSetType = PointSet<float, 2>;
    using ImageType = Image<float, 2>;
    const SurfaceSplatLayer layer = ProjectScene(scene(), sigma);
    auto                    points = PointSetType::New();
    for (std::size_t i = 0; i < layer.u.size(); ++i)
    {
      PointSetType::PointType point;
      point[0] = static_cast<float>(layer.u[i]);
      point[1] = static_cast<float>(layer.v[i]);
      points->SetPoint(i, point);
    }
    for (auto _ : state)
    {
      using BinFilterType = PointSetToImageFilter<PointSetType, ImageType>;
      auto                          bin = BinFilterType::New();
      const BinFilterType::SizeType size{ { Width, Height } };
      const double                  origin[2] = { 0.0, 0.0 };
      const double                  spacing[2] = { 1.0, 1.0 };
      bin->SetInput(points);
      bin->SetSize(size);
      bin->SetOrigin(origin);
      bin->SetSpacing(spacing);
      auto smooth = DiscreteGaussianImageFilter<ImageType, ImageType>::New();
      smooth->SetInput(bin->GetOutput());
      smooth->SetVariance(sigma * sigma);
      smooth->SetMaximumError(1e-3);
      smooth->SetUseImageSpacing(false);
      smooth->Update();
      benchmark::DoNotOptimize(smooth->GetOutput()->GetBufferPointer());
    }
  };
}

/** A volume of two slices, the least that it takes; the target counts a slice. */
BenchmarkFunction
VTKPeer(SceneFunction scene, double sigma)
{
  return [scene, sigma](benchmark::State & state) {
    const SurfaceSplatLayer layer = ProjectScene(scene(), sigma);
    vtkNew<vtkPoints>       points;
    vtkNew<vtkFloatArray>   weights;
    for (std::size_t i = 0; i < layer.u.size(); ++i)
    {
      points->InsertNextPoint(layer.u[i], layer.v[i], 0.0);
      weights->InsertNextValue(layer.weight[i]);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->GetPointData()->SetScalars(weights);
    for (auto _ : state)
    {
      vtkNew<vtkGaussianSplatter> splatter;
      splatter->SetInputData(data);
      splatter->SetSampleDimensions(Width, Height, 2);
      splatter->SetModelBounds(0.0, Width - 1.0, 0.0, Height - 1.0, 0.0, 1.0);
      // Cut at four standard deviations, as SciPy's.
      splatter->SetRadius(4.0 * sigma / (Width - 1.0));
      splatter->SetExponentFactor(-8.0);
      splatter->NormalWarpingOff();
      splatter->ScalarWarpingOn();
      splatter->CappingOff();
      splatter->SetAccumulationModeToSum();
      splatter->Update();
      benchmark::DoNotOptimize(splatter->GetOutput()->GetScalarPointer());
    }
  };
}

/** What our own benchmark starts from as well. */
void
WriteScene(const Scene & scene, double sigma, const std::string & folder)
{
  std::vector<double> points;
  for (std::size_t i = 0; i < scene.surface->points.size(); ++i)
  {
    const auto & point = scene.surface->points[i];
    points.insert(points.end(), { point[0], point[1], point[2], scene.areas[i] });
  }
  const SurfaceSplatProjector & projector = scene.projector;
  WriteArray(folder + "/points.npy", points.data(), scene.areas.size(), 4);
  WriteArray(folder + "/projection.npy", projector.projection.matrix.data(), 3, 4);
  const double frame[] = { sigma,
                           Width,
                           Height,
                           projector.principalPoint[0],
                           projector.principalPoint[1],
                           projector.pixelSpacing[0] / projector.sourceToDetector,
                           projector.sourceToDetector / projector.sourceToMidsagittal };
  WriteArray(folder + "/frame.npy", frame, 1, 7);
}

void
RegisterScene(const std::string & name, SceneFunction scene)
{
  for (const double sigma : { 1.0, 2.0, 3.0 })
  {
    std::ostringstream work;
    work << name << ", sigma " << sigma;
    const std::string kernel = "surface DRR";
    RegisterKernel(kernel, work.str(), Ours(scene, sigma, 1e-3, 1));
    RegisterThreaded(kernel, work.str(), 1.7, Ours(scene, sigma, 1e-3, 2));
    RegisterScriptPeer(kernel,
                       work.str(),
                       "numpy projection + add.at + gaussian_filter",
                       sigma < 2.0 ? 6.0 : 10.0,
                       [scene, sigma](const auto & f) { WriteScene(scene(), sigma, f); });
    RegisterPeer(kernel, work.str(), "ITK PointSetToImage + DiscreteGaussian", 10.0, ITKPeer(scene, sigma));
    // Two slices.
    RegisterPeer(kernel, work.str(), "vtkGaussianSplatter, two slices", 100.0, VTKPeer(scene, sigma));
  }
  RegisterAtMost("surface DRR", name + ", sigma 1", "error over maximum", 1e-3, [scene](benchmark::State & state) {
    const Scene & made = scene();
    for (auto _ : state)
    {
      Renderer renderer;
      renderer.Render(made, 1.0, 1e-3, 1);
      std::vector<double>      truth(Width * Height, 0.0);
      const SurfaceSplatRegion region{ 0, 0, Width, Height };
      SurfaceSplatReference(renderer.layer, region, truth.data(), Width);
      double error = 0.0;
      double peak = 0.0;
      for (std::size_t i = 0; i < truth.size(); ++i)
      {
        error = std::max(error, std::abs(truth[i] - renderer.image[i]));
        peak = std::max(peak, truth[i]);
      }
      state.counters["figure"] = error / peak;
    }
  });
  RegisterAtMost(
    "surface DRR", name + ", sigma 2", "memory over input + output", 4.0, [scene](benchmark::State & state) {
      const Scene & made = scene();
      const double  input = static_cast<double>(made.surface->points.size()) * (3 + 1) * sizeof(double);
      const double  output = sizeof(float) * Width * Height;
      for (auto _ : state)
      {
        const double peak = PeakMemory([&]() { Renderer().Render(made, 2.0, 1e-3, 1); });
        state.counters["figure"] = (peak + input) / (input + output);
      }
    });
}

const Scene &
Phantom()
{
  static const Scene scene = MakeScene(PhantomSurface(200000));
  return scene;
}

const Scene &
Cast()
{
  static const Scene scene = MakeScene(CastSurface());
  return scene;
}

template <int VVertices>
const Scene &
GrowingPhantom()
{
  static const Scene scene = MakeScene(PhantomSurface(2 * VVertices));
  return scene;
}

void
RegisterAll()
{
  RegisterScene("phantom, 100 k vertices", Phantom);
  if (!CastSurface().points.empty())
  {
    std::ostringstream name;
    name << "scan of a cast, " << (CastSurface().points.size() + 500) / 1000 << " k vertices";
    RegisterScene(name.str(), Cast);
  }
  const std::pair<int, SceneFunction> scenes[] = { { 1000, GrowingPhantom<1000> },
                                                   { 10000, GrowingPhantom<10000> },
                                                   { 100000, GrowingPhantom<100000> },
                                                   { 1000000, GrowingPhantom<1000000> } };
  for (const auto & [vertices, scene] : scenes)
  {
    RegisterGrowth("surface DRR", "vertices, sigma 2", vertices, Ours(scene, 2.0, 1e-3, 1));
  }
}

const BenchmarkFile file(RegisterAll);
} // namespace
} // namespace itk
