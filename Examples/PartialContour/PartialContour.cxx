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
// What each part of PartialContourMetricv4 does: simulated cases, registered by a similarity once for each setting.
// The moving contour is the open occlusal and anterior part of the right half's outline, projected twice: with the
// central ray through the jaw, and again from where a first registration puts the jaw. Prints a Markdown table.
#include "itkAmoebaOptimizerv4.h"
#include "itkContourChamferMetricv4.h"
#include "itkDentalPhantomCaseSource.h"
#include "itkLBFGSBOptimizerv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkMidlineSideMeshFilter.h"
#include "itkPartialContourMetricv4.h"
#include "itkSilhouetteToContourRegistrationMethod.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using MeshType = itk::Mesh<float, 3>;
using CaseSourceType = itk::DentalPhantomCaseSource;
using GeometryType = itk::CephalometricGeometry;
using ContourType = itk::DentalContour;
using MetricType = itk::PartialContourMetricv4;
using MethodType = itk::SilhouetteToContourRegistrationMethod;
using PixelType = std::array<double, 2>;

/** One jaw of a case: what a method gets, and what it is measured with. */
struct Jaw
{
  ContourType::Pointer                                     tracing;
  ContourType::Pointer                                     outline;
  ContourType::Pointer                                     wholeOutline;
  std::vector<std::pair<PixelType, itk::Point<double, 2>>> landmarks;
};

std::uint8_t
FindLabel(const MeshType * mesh, const std::array<double, 3> & point)
{
  double       best = 1.0;
  std::uint8_t label = 0;
  auto         data = mesh->GetPointData()->Begin();
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it, ++data)
  {
    const double dx = it.Value()[0] - point[0];
    const double dy = it.Value()[1] - point[1];
    const double dz = it.Value()[2] - point[2];
    const double d2 = dx * dx + dy * dy + dz * dz;
    if (d2 < best)
    {
      best = d2;
      label = static_cast<std::uint8_t>(data.Value());
    }
  }
  return label;
}

/** The part of the outline that a tracing can show: what faces occlusally or to the front. One polyline a tooth; where
 * two meet they share a point. */
ContourType::Pointer
MakeOpenOutline(itk::MeshSilhouetteContourSource<MeshType> * source, const MeshType * labels, bool upper, double facing)
{
  const auto &              samples = source->GetSamples();
  std::vector<char>         keep;
  std::vector<std::uint8_t> code;
  for (const auto & sample : samples)
  {
    const double occlusal = upper ? sample.normal[1] : -sample.normal[1];
    keep.push_back(occlusal > -0.5 && (occlusal > 0.2 || facing * sample.normal[0] > 0.2) ? 1 : 0);
    code.push_back(keep.back() != 0 ? FindLabel(labels, sample.rim) : std::uint8_t{ 0 });
  }
  const auto  contour = ContourType::New();
  std::size_t start = 0;
  while (start < samples.size() && keep[start] != 0)
  {
    ++start;
  }
  ContourType::PolylineType polyline;
  for (std::size_t k = 0; k <= samples.size(); ++k)
  {
    const std::size_t      i = (start + k) % samples.size();
    const bool             on = k < samples.size() && keep[i] != 0;
    ContourType::PointType point;
    point[0] = samples[i].u;
    point[1] = samples[i].v;
    const itk::ToothCode tooth(code[i]);
    if (!polyline.points.empty() && (!on || tooth != polyline.code))
    {
      if (on)
      {
        polyline.points.push_back(point);
      }
      if (polyline.points.size() > 1)
      {
        contour->AddPolyline(polyline);
      }
      polyline.points.clear();
    }
    if (on)
    {
      polyline.code = tooth;
      polyline.points.push_back(point);
    }
  }
  return contour;
}

/** Moves the jaw to where the similarity shows it: turned about y, shifted in the midsagittal plane. */
void
PlaceJaw(const MethodType::TransformType * similarity, const GeometryType * nominal, GeometryType * geometry)
{
  const double               f = nominal->GetFacingSign();
  const double               m = nominal->GetSourceToDetectorDistance() / nominal->GetSourceToMidsagittalDistance();
  const auto                 offset = similarity->GetOffset();
  GeometryType::RotationType turn;
  turn.SetIdentity();
  turn(0, 0) = std::cos(similarity->GetAngle());
  turn(0, 2) = f * std::sin(similarity->GetAngle());
  turn(2, 0) = -turn(0, 2);
  turn(2, 2) = turn(0, 0);
  GeometryType::VectorType shift = turn * geometry->GetPoseTranslation();
  shift[0] += f * (offset[0] - nominal->GetPrincipalPoint()[0]) * nominal->GetPixelSpacing()[0] / m;
  shift[2] -= (offset[1] - nominal->GetPrincipalPoint()[1]) * nominal->GetPixelSpacing()[1] / m;
  geometry->SetPrincipalPoint(nominal->GetPrincipalPoint());
  geometry->SetPose(turn * geometry->GetPoseRotation(), shift);
}

MethodType::MetricType::Pointer
MakeChamfer(itk::ContourMetricEnums::Direction direction)
{
  const auto metric = itk::ContourChamferMetricv4::New();
  metric->SetDirection(direction);
  metric->SetDistance(itk::ContourMetricEnums::Distance::PointToSegment);
  return metric.GetPointer();
}

std::vector<Jaw>
MakeCase(std::uint64_t seed, CaseSourceType::CohortEnum cohort)
{
  const auto source = CaseSourceType::New();
  source->SetSeed(seed);
  source->SetCohort(cohort);
  source->MakeRadiographOff();
  source->Update();
  const auto axis = itk::UMidlineDentalAxisFilter<MeshType>::New();
  axis->SetUpperMesh(source->GetMesh(0));
  axis->SetLowerMesh(source->GetMesh(1));
  axis->RefineMidlineOn();
  axis->Update();
  std::vector<Jaw> jaws;
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    auto * const toFrame = jaw == 0 ? axis->GetUpperTransformOutput() : axis->GetLowerTransformOutput();
    // The central ray through the frame's origin: its projection is q.
    const auto geometry = GeometryType::New();
    geometry->CopyParameters(source->GetNominalGeometry());
    GeometryType::PixelIndexType origin;
    origin.Fill(0.0);
    geometry->SetPrincipalPoint(origin);
    geometry->SetPose(toFrame->Get()->GetMatrix(), toFrame->Get()->GetOffset());

    Jaw result;
    result.tracing = source->GetTracing(jaw);
    const auto side = itk::MidlineSideMeshFilter<MeshType>::New();
    side->SetInput(source->GetMesh(jaw));
    side->SetFrameTransformInput(toFrame);
    const auto right = itk::MeshSilhouetteContourSource<MeshType>::New();
    right->SetInput(side->GetOutput());
    right->SetGeometry(geometry);
    right->SetNumberOfPoints(800);
    for (unsigned int pass = 0; pass < 2; ++pass)
    {
      right->Update();
      result.outline = MakeOpenOutline(right, source->GetMesh(jaw), jaw == 0, geometry->GetFacingSign());
      if (pass == 0)
      {
        const auto first = MethodType::New();
        first->SetFixedContour(result.tracing);
        first->SetMovingContour(result.outline);
        first->SetMetric(MakeChamfer(itk::ContourMetricEnums::Direction::FixedToMoving));
        first->Update();
        PlaceJaw(first->GetTransform(), source->GetNominalGeometry(), geometry);
      }
    }
    const auto whole = itk::MeshSilhouetteContourSource<MeshType>::New();
    whole->SetInput(source->GetMesh(jaw));
    whole->SetGeometry(geometry);
    whole->SetNumberOfPoints(441);
    whole->Update();
    result.wholeOutline = whole->GetOutput();
    for (const auto & landmark : source->GetLandmarks2D(jaw)->GetLandmarks())
    {
      const auto q = geometry->ProjectPoint(source->GetLandmarks3D(jaw)->Find(landmark.name)->point);
      result.landmarks.push_back({ { { q[0], q[1] } }, landmark.point });
    }
    jaws.push_back(result);
  }
  return jaws;
}

double
MeanLandmarkError(const Jaw & jaw, const MethodType::TransformType * transform)
{
  double sum = 0.0;
  for (const auto & pair : jaw.landmarks)
  {
    itk::Point<double, 2> q;
    q[0] = pair.first[0];
    q[1] = pair.first[1];
    sum += transform->TransformPoint(q).EuclideanDistanceTo(pair.second);
  }
  return sum / static_cast<double>(jaw.landmarks.size());
}

/** Mean variance of a landmark that the metric's covariance predicts, px^2 (both coordinates). */
double
PredictLandmarkVariance(const Jaw & jaw, const MetricType * metric)
{
  const auto   covariance = metric->ComputeCovariance();
  const auto   similarity = metric->GetCurrentSimilarity();
  const double c = similarity.scale * std::cos(similarity.angle);
  const double s = similarity.scale * std::sin(similarity.angle);
  double       sum = 0.0;
  for (const auto & pair : jaw.landmarks)
  {
    const double x = (pair.first[0] - metric->GetPivot()[0]) / metric->GetReferenceLength();
    const double y = (pair.first[1] - metric->GetPivot()[1]) / metric->GetReferenceLength();
    const double rx = c * x - s * y;
    const double ry = s * x + c * y;
    const double rows[2][4] = { { rx, -ry, 1.0, 0.0 }, { ry, rx, 0.0, 1.0 } };
    for (const auto & row : rows)
    {
      for (unsigned int a = 0; a < 4; ++a)
      {
        for (unsigned int b = 0; b < 4; ++b)
        {
          sum += row[a] * covariance(a, b) * row[b];
        }
      }
    }
  }
  return sum / static_cast<double>(jaw.landmarks.size());
}

double
MeanSquaredLandmarkError(const Jaw & jaw, const MethodType::TransformType * transform)
{
  double sum = 0.0;
  for (const auto & pair : jaw.landmarks)
  {
    itk::Point<double, 2> q;
    q[0] = pair.first[0];
    q[1] = pair.first[1];
    sum += transform->TransformPoint(q).SquaredEuclideanDistanceTo(pair.second);
  }
  return sum / static_cast<double>(jaw.landmarks.size());
}

/** The best that any similarity does: least squares to the landmarks themselves. */
double
BestLandmarkError(const Jaw & jaw)
{
  double     mq[2] = { 0.0, 0.0 };
  double     mp[2] = { 0.0, 0.0 };
  const auto n = static_cast<double>(jaw.landmarks.size());
  for (const auto & pair : jaw.landmarks)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      mq[d] += pair.first[d] / n;
      mp[d] += pair.second[d] / n;
    }
  }
  double real = 0.0;
  double imaginary = 0.0;
  double squares = 0.0;
  for (const auto & pair : jaw.landmarks)
  {
    const double x = pair.first[0] - mq[0];
    const double y = pair.first[1] - mq[1];
    const double u = pair.second[0] - mp[0];
    const double v = pair.second[1] - mp[1];
    real += x * u + y * v;
    imaginary += x * v - y * u;
    squares += x * x + y * y;
  }
  real /= squares;
  imaginary /= squares;
  const auto                                transform = MethodType::TransformType::New();
  MethodType::TransformType::ParametersType parameters(4);
  parameters[0] = std::hypot(real, imaginary);
  parameters[1] = std::atan2(imaginary, real);
  parameters[2] = mp[0] - (real * mq[0] - imaginary * mq[1]);
  parameters[3] = mp[1] - (imaginary * mq[0] + real * mq[1]);
  transform->SetParameters(parameters);
  return MeanLandmarkError(jaw, transform);
}

struct Setting
{
  std::string                                         name;
  bool                                                whole;
  std::function<MethodType::MetricType::Pointer()>    makeMetric;
  std::function<MethodType::OptimizerType::Pointer()> makeOptimizer;
};

struct Figures
{
  std::vector<double> errors[2];
  double              iterations{ 0.0 };
  double              evaluations{ 0.0 };
  double              naive{ 0.0 };
  double              predicted{ 0.0 };
  double              actual{ 0.0 };
  double              seconds{ 0.0 };
};

void
Run(const Setting & setting, const std::vector<Jaw> & jaws, Figures & figures)
{
  for (std::size_t j = 0; j < jaws.size(); ++j)
  {
    const auto method = MethodType::New();
    const auto metric = setting.makeMetric();
    method->SetFixedContour(jaws[j].tracing);
    method->SetMovingContour(setting.whole ? jaws[j].wholeOutline : jaws[j].outline);
    method->SetMetric(metric);
    method->SetOptimizer(setting.makeOptimizer());
    method->SetNumberOfLevels(5);
    const std::clock_t begin = std::clock();
    method->Update();
    figures.seconds += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    for (const auto & level : method->GetLevelResults())
    {
      figures.iterations += static_cast<double>(level.numberOfIterations);
      figures.evaluations += static_cast<double>(level.numberOfEvaluations);
    }
    figures.errors[j].push_back(MeanLandmarkError(jaws[j], method->GetTransform()));
    if (auto * const partial = dynamic_cast<MetricType *>(metric.GetPointer()))
    {
      figures.naive += PredictLandmarkVariance(jaws[j], partial);
      partial->UpdateNoiseModel();
      figures.predicted += PredictLandmarkVariance(jaws[j], partial);
      figures.actual += MeanSquaredLandmarkError(jaws[j], method->GetTransform());
    }
  }
}

void
Print(const std::string & name, const Figures & figures)
{
  std::cout << "| " << name << " |" << std::fixed << std::setprecision(2);
  for (const auto & errors : figures.errors)
  {
    double sum = 0.0;
    for (const double error : errors)
    {
      sum += error;
    }
    auto sorted = errors;
    std::sort(sorted.begin(), sorted.end());
    std::cout << ' ' << sum / static_cast<double>(errors.size()) << " | " << sorted[sorted.size() / 2] << " | "
              << sorted.back() << " |";
  }
  const auto registrations = static_cast<double>(figures.errors[0].size() + figures.errors[1].size());
  std::cout << ' ' << std::setprecision(0) << figures.iterations / registrations << " | "
            << figures.evaluations / registrations << " | " << std::setprecision(1)
            << 1000.0 * figures.seconds / registrations << " | " << std::setprecision(2);
  if (figures.actual > 0.0)
  {
    std::cout << std::sqrt(figures.predicted / figures.actual) << " (" << std::sqrt(figures.naive / figures.actual)
              << ')';
  }
  std::cout << " |" << std::endl;
}

void
PrintMean(const std::string & name, const Figures & figures)
{
  double      sum = 0.0;
  std::size_t count = 0;
  for (const auto & errors : figures.errors)
  {
    for (const double error : errors)
    {
      sum += error;
      ++count;
    }
  }
  std::cout << name << " px: " << sum / static_cast<double>(count) << '\n';
}

/** The metric with everything that a setting then takes away or adds. */
template <typename TChange>
std::function<MethodType::MetricType::Pointer()>
Partial(const TChange & change)
{
  return [change] {
    const auto metric = MetricType::New();
    metric->SetScalePrior(1.0, MetricType::GetScaleSigma(itk::ContourMetricEnums::SpacingSource::Given));
    metric->SetRotationPrior(0.0, 0.35);
    change(metric.GetPointer());
    return MethodType::MetricType::Pointer(metric.GetPointer());
  };
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " ideal|typical|hard firstSeed numberOfCases" << std::endl;
    return EXIT_FAILURE;
  }
  const std::string name = argv[1];
  const auto        cohort = name == "hard"    ? CaseSourceType::CohortEnum::Hard
                             : name == "ideal" ? CaseSourceType::CohortEnum::Ideal
                                               : CaseSourceType::CohortEnum::Typical;
  const auto        first = static_cast<std::uint64_t>(std::strtoull(argv[2], nullptr, 10));
  const auto        count = static_cast<std::uint64_t>(std::strtoull(argv[3], nullptr, 10));

  const auto leastSquares = [] {
    return MethodType::OptimizerType::Pointer(itk::LevenbergMarquardtOptimizerv4::New().GetPointer());
  };
  const auto lbfgsb = [] { return MethodType::OptimizerType::Pointer(itk::LBFGSBOptimizerv4::New().GetPointer()); };
  const auto amoeba = [] { return MethodType::OptimizerType::Pointer(itk::AmoebaOptimizerv4::New().GetPointer()); };
  using Direction = itk::ContourMetricEnums::Direction;
  using Kernel = itk::ContourMetricEnums::RobustKernel;
  const std::vector<Setting> settings{
    { "symmetric Chamfer, whole outline", true, [] { return MakeChamfer(Direction::Symmetric); }, lbfgsb },
    { "symmetric Chamfer", false, [] { return MakeChamfer(Direction::Symmetric); }, lbfgsb },
    { "one-sided Chamfer", false, [] { return MakeChamfer(Direction::FixedToMoving); }, lbfgsb },
    { "**all** (below: all but)", false, Partial([](MetricType *) {}), leastSquares },
    { "no robust kernel (squares)",
      false,
      Partial([](MetricType * m) { m->SetRobustKernel(Kernel::Squares); }),
      leastSquares },
    { "Huber", false, Partial([](MetricType * m) { m->SetRobustKernel(Kernel::Huber); }), leastSquares },
    { "no annealing", false, Partial([](MetricType * m) { m->AnnealingOff(); }), leastSquares },
    { "no directions", false, Partial([](MetricType * m) { m->SetDirectionWeight(0.0); }), leastSquares },
    { "no tooth gate", false, Partial([](MetricType * m) { m->GateByToothOff(); }), leastSquares },
    { "tooth gate without neighbours", false, Partial([](MetricType * m) { m->SetToothRange(0); }), leastSquares },
    { "no scale prior", false, Partial([](MetricType * m) { m->SetScalePrior(1.0, INFINITY); }), leastSquares },
    { "and reverse direction, 0.1", false, Partial([](MetricType * m) { m->SetReverseWeight(0.1); }), leastSquares },
    { "and reverse direction, 0.5", false, Partial([](MetricType * m) { m->SetReverseWeight(0.5); }), leastSquares },
    { "and correlated noise", false, Partial([](MetricType * m) { m->CorrelatedNoiseOn(); }), leastSquares },
    { "and correlated noise, no directions",
      false,
      Partial([](MetricType * m) {
        m->CorrelatedNoiseOn();
        m->SetDirectionWeight(0.0);
      }),
      leastSquares },
    { "and correlated noise, levels not estimated",
      false,
      Partial([](MetricType * m) {
        m->CorrelatedNoiseOn();
        m->EstimateNoiseOff();
      }),
      leastSquares },
    { "all, LBFGSB", false, Partial([](MetricType *) {}), lbfgsb },
    { "all, Amoeba", false, Partial([](MetricType *) {}), amoeba }
  };
  try
  {
    std::vector<Figures> figures(settings.size());
    Figures              best;
    for (std::uint64_t k = 0; k < count; ++k)
    {
      const auto jaws = MakeCase(first + k, cohort);
      for (std::size_t s = 0; s < settings.size(); ++s)
      {
        Run(settings[s], jaws, figures[s]);
      }
      for (std::size_t j = 0; j < jaws.size(); ++j)
      {
        best.errors[j].push_back(BestLandmarkError(jaws[j]));
      }
    }
    std::cout
      << "| " << count << ' ' << name << " cases from seed " << first
      << " | upper: mean | median | worst | lower: mean | median | worst | iterations | evaluations | ms | sigma |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|\n";
    Print("best similarity to the landmarks", best);
    for (std::size_t s = 0; s < settings.size(); ++s)
    {
      Print(settings[s].name, figures[s]);
    }
    std::cout << '\n' << std::setprecision(6);
    PrintMean("best similarity", best);
    PrintMean("Chamfer", figures[0]);
    PrintMean("all", figures[3]);
  }
  catch (const itk::ExceptionObject & error)
  {
    std::cerr << error.GetDescription() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
