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

#include "itkContourChamferMetricv4.h"
#include "itkSilhouetteToContourRegistrationMethod.h"

#include "itkEuclideanDistancePointSetToPointSetMetricv4.h"
#include "itkGradientDescentOptimizerv4.h"
#include "itkImage.h"
#include "itkImageRegistrationMethodv4.h"
#include "itkPointSet.h"
#include "itkRegistrationParameterScalesFromPhysicalShift.h"
#include "itkSimilarity2DTransform.h"

#include "vtkIterativeClosestPointTransform.h"
#include "vtkLandmarkTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkCellArray.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace itk
{
namespace
{
constexpr std::size_t MovingPoints = 441;
constexpr std::size_t FixedPoints = 79;

/** A silhouette, and its tracing under a similarity that is to be found. */
struct Trial
{
  ContourSimilarity truth;
  ContourArrays     moving;
  ContourArrays     fixed;
};

/** Scale e^+-0.3, rotation +-0.5, shift +-60 px, 0.4 px of noise. */
const std::vector<Trial> &
Trials()
{
  static const std::vector<Trial> trials = []() {
    std::vector<Trial> made(IsBenchmarkSmokeTest() ? 3 : 100);
    ReproducibleRandom random(11);
    for (Trial & trial : made)
    {
      trial.truth.scale = std::exp(random.Uniform(-0.3, 0.3));
      trial.truth.angle = random.Uniform(-0.5, 0.5);
      trial.truth.tx = random.Uniform(-60.0, 60.0);
      trial.truth.ty = random.Uniform(-60.0, 60.0);
      trial.moving = MakeBenchmarkContour(MovingPoints);
      trial.fixed = MakeBenchmarkContour(FixedPoints, trial.truth, 0.4, 1 + (&trial - made.data()));
    }
    return made;
  }();
  return trials;
}

/** Largest distance on the outline from where it should be. */
double
ErrorOf(const Trial & trial, const ContourSimilarity & found)
{
  const auto map = [](const ContourSimilarity & s, const std::array<double, 2> & q) {
    const double c = s.scale * std::cos(s.angle);
    const double d = s.scale * std::sin(s.angle);
    return std::array<double, 2>{ c * q[0] - d * q[1] + s.tx, d * q[0] + c * q[1] + s.ty };
  };
  double largest = 0.0;
  for (int i = 0; i < 100; ++i)
  {
    const auto q = BenchmarkOutline(0.01 * i);
    const auto a = map(trial.truth, q);
    const auto b = map(found, q);
    largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1]));
  }
  return largest;
}

/** Registers a trial; what is made of the contours before may be kept for its calls. */
using RegisterFunction = std::function<ContourSimilarity(const Trial &)>;

DentalContour::Pointer
MakeContour(const ContourArrays & arrays)
{
  std::vector<DentalContour::PointType> points(arrays.GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i][0] = arrays.points[2 * i];
    points[i][1] = arrays.points[2 * i + 1];
  }
  const auto contour = DentalContour::New();
  contour->AddPolyline(points, ToothCode(), true);
  return contour;
}

ContourSimilarity
RegisterByOurs(const Trial & trial, ContourChamferKernel::DistanceEnum distance)
{
  const auto method = SilhouetteToContourRegistrationMethod::New();
  const auto metric = ContourChamferMetricv4::New();
  metric->SetDistance(distance);
  method->SetMetric(metric);
  method->SetPresetToGlobal();
  method->SetFixedContour(MakeContour(trial.fixed));
  method->SetMovingContour(MakeContour(trial.moving));
  method->Update();
  const auto &      parameters = method->GetTransform()->GetParameters();
  ContourSimilarity similarity;
  similarity.scale = parameters[0];
  similarity.angle = parameters[1];
  similarity.tx = parameters[2];
  similarity.ty = parameters[3];
  return similarity;
}

/** Similarity, centroids matched at the start, up to 200 iterations, every point. */
ContourSimilarity
RegisterByVTK(const Trial & trial)
{
  const auto makeData = [](const ContourArrays & contour) {
    vtkNew<vtkPoints>    points;
    vtkNew<vtkCellArray> cells;
    for (std::size_t i = 0; i < contour.GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(contour.points[2 * i], contour.points[2 * i + 1], 0.0);
    }
    for (std::size_t i = 0; i + 1 < contour.segments.size(); i += 2)
    {
      const vtkIdType ends[2] = { contour.segments[i], contour.segments[i + 1] };
      cells->InsertNextCell(2, ends);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(cells);
    return data;
  };
  const auto                                moving = makeData(trial.moving);
  const auto                                fixed = makeData(trial.fixed);
  vtkNew<vtkIterativeClosestPointTransform> icp;
  icp->SetSource(moving);
  icp->SetTarget(fixed);
  icp->GetLandmarkTransform()->SetModeToSimilarity();
  icp->SetMaximumNumberOfIterations(200);
  icp->SetMaximumNumberOfLandmarks(static_cast<int>(MovingPoints));
  icp->StartByMatchingCentroidsOn();
  icp->Update();
  const vtkMatrix4x4 * m = icp->GetMatrix();
  ContourSimilarity    similarity;
  similarity.scale = std::hypot(m->GetElement(0, 0), m->GetElement(1, 0));
  similarity.angle = std::atan2(m->GetElement(1, 0), m->GetElement(0, 0));
  similarity.tx = m->GetElement(0, 3);
  similarity.ty = m->GetElement(1, 3);
  return similarity;
}

/** Point sets, Euclidean distance metric, scales and step by physical shift, centroids and sizes matched at the start.
 */
ContourSimilarity
RegisterByITK(const Trial & trial)
{
  using PointSetType = PointSet<double, 2>;
  using ImageType = Image<float, 2>;
  using TransformType = Similarity2DTransform<double>;
  using MetricType = EuclideanDistancePointSetToPointSetMetricv4<PointSetType>;
  using MethodType = ImageRegistrationMethodv4<ImageType, ImageType, TransformType, ImageType, PointSetType>;
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
  // The transform maps the points of the set that it calls fixed.
  const auto from = makeSet(trial.moving);
  const auto to = makeSet(trial.fixed);
  auto       metric = MetricType::New();
  metric->SetFixedPointSet(from);
  metric->SetMovingPointSet(to);
  auto initial = TransformType::New();
  // The method wants a virtual domain: an image around both.
  using DomainType = MetricType::VirtualImageType;
  auto                    domain = DomainType::New();
  DomainType::SizeType    size{ { 64, 64 } };
  DomainType::SpacingType spacing;
  DomainType::PointType   origin;
  spacing.Fill(16.0);
  origin.Fill(-512.0);
  domain->SetRegions(size);
  domain->SetSpacing(spacing);
  domain->SetOrigin(origin);
  domain->Allocate(true);
  metric->SetVirtualDomainFromImage(domain);
  metric->SetMovingTransform(initial);
  metric->Initialize();
  using ScalesType = RegistrationParameterScalesFromPhysicalShift<MetricType>;
  auto scales = ScalesType::New();
  scales->SetMetric(metric);
  scales->SetVirtualDomainPointSet(metric->GetVirtualTransformedPointSet());
  scales->SetTransformForward(true);
  auto optimizer = GradientDescentOptimizerv4::New();
  optimizer->SetScalesEstimator(scales);
  optimizer->SetNumberOfIterations(200);
  optimizer->SetMaximumStepSizeInPhysicalUnits(1.0);
  optimizer->SetDoEstimateLearningRateOnce(false);
  optimizer->SetDoEstimateLearningRateAtEachIteration(true);
  optimizer->SetMinimumConvergenceValue(1e-6);
  optimizer->SetConvergenceWindowSize(10);
  auto                                          method = MethodType::New();
  typename MethodType::ShrinkFactorsArrayType   shrinkFactors(1);
  typename MethodType::SmoothingSigmasArrayType sigmas(1);
  shrinkFactors.Fill(1);
  sigmas.Fill(0.0);
  method->SetNumberOfLevels(1);
  method->SetShrinkFactorsPerLevel(shrinkFactors);
  method->SetSmoothingSigmasPerLevel(sigmas);
  method->SetFixedPointSet(from);
  method->SetMovingPointSet(to);
  method->SetMetric(metric);
  method->SetOptimizer(optimizer);
  method->SetInitialTransform(initial);
  method->InPlaceOn();
  method->Update();
  const auto &      parameters = method->GetModifiableTransform()->GetParameters();
  ContourSimilarity similarity;
  similarity.scale = parameters[0];
  similarity.angle = parameters[1];
  // About the transform's centre.
  const auto offset = method->GetModifiableTransform()->GetOffset();
  similarity.tx = offset[0];
  similarity.ty = offset[1];
  return similarity;
}

/** A call registers some of the trials. */
BenchmarkFunction
Run(const RegisterFunction & registerTrial, std::size_t count)
{
  return [registerTrial, count](benchmark::State & state) {
    for (auto _ : state)
    {
      for (std::size_t i = 0; i < std::min(count, Trials().size()); ++i)
      {
        benchmark::DoNotOptimize(registerTrial(Trials()[i]).scale);
      }
    }
  };
}

/** How many trials of a hundred end within 3 px everywhere. */
BenchmarkFunction
Successes(const RegisterFunction & registerTrial)
{
  return [registerTrial](benchmark::State & state) {
    for (auto _ : state)
    {
      std::size_t successes = 0;
      for (const Trial & trial : Trials())
      {
        successes += ErrorOf(trial, registerTrial(trial)) < 3.0 ? 1 : 0;
      }
      state.counters["figure"] = 100.0 * static_cast<double>(successes) / static_cast<double>(Trials().size());
    }
  };
}

void
RegisterAll()
{
  const std::string     kernel = "whole registration, global start";
  constexpr std::size_t Count = 10;
  for (const auto distance :
       { ContourChamferKernel::DistanceEnum::PointToPoint, ContourChamferKernel::DistanceEnum::PointToSegment })
  {
    const bool        isPoints = distance == ContourChamferKernel::DistanceEnum::PointToPoint;
    const std::string work = std::string("441 x 79 ") + (isPoints ? "points" : "segments") + ", 10 trials";
    const auto        ours = [distance](const Trial & trial) { return RegisterByOurs(trial, distance); };
    RegisterKernel(kernel, work, Run(ours, Count), 15.0 * Count);
    RegisterPeer(kernel, work, "vtkIterativeClosestPointTransform", 10.0, Run(RegisterByVTK, Count));
    RegisterPeer(kernel, work, "ITK ImageRegistrationMethodv4", 10.0, Run(RegisterByITK, Count));
    RegisterAtLeast(kernel, work, "successes of 100", 95.0, Successes(ours));
  }
}

const BenchmarkFile file(RegisterAll);
} // namespace
} // namespace itk
