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
#include "itkPoseCovariance.h"

#include "itkFindSilhouettes.h"
#include "itkPoseCovarianceReference.h"
#include "itkPoseMeshContourModel.h"
#include "itkPosePriors.h"
#include "itkPoseSolution.h"
#include "itkSilhouettePoseMetricv4.h"

#include "itkContourNoiseModel.h"
#include "itkCorrelatedNoiseModel.h"
#include "itkReproducibleRandom.h"
#include "itkSquaresKernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

// What is said of the uncertainty of a pose against dense formulas in which no two lengths are alike.
namespace
{
namespace Reference = PoseCovarianceReference;

constexpr double Degree = 0.017453292519943295;

/** Pose off the middle of every prior. */
const itk::PoseParameters Pose{ { 0.12, 0.06, -0.09, 3.0, 0.8, -2.0, 0.015 } };

itk::PoseGeometry
MakeGeometry(double sourceSign = 1.0, double facingSign = 1.0)
{
  itk::PoseGeometry geometry;
  geometry.sourceToMidsagittal = 1500.0;
  geometry.sourceToDetector = 1650.0;
  geometry.sourceSign = sourceSign;
  geometry.facingSign = facingSign;
  geometry.pixelSpacing = { { 0.31, 0.19 } };
  geometry.principalPoint = { { 420.0, 530.0 } };
  return geometry;
}

Reference::Imaging
ImagingOf(const itk::PoseGeometry & geometry)
{
  return { geometry.sourceToMidsagittal, geometry.sourceToDetector, geometry.sourceSign,
           geometry.facingSign,          geometry.pixelSpacing,     geometry.principalPoint };
}

/** Half an arch on the right like a row of crowns: a tube along a circle whose thickness swells nine times. */
itk::TriangleSurface
MakeArch(double scale = 1.0)
{
  constexpr unsigned int rings = 90;
  constexpr unsigned int sectors = 28;
  itk::TriangleSurface   surface;
  for (unsigned int i = 0; i <= rings; ++i)
  {
    const double phi = 0.02 + 1.8 * i / rings;
    const double radius = 4.0 + 1.3 * std::sin(10.0 * phi);
    for (unsigned int s = 0; s < sectors; ++s)
    {
      const double theta = 2.0 * 3.14159265358979323846 * s / sectors;
      const double r = 24.0 + radius * std::cos(theta);
      surface.points.push_back(
        { scale * r * std::cos(phi), -scale * r * std::sin(phi), scale * radius * std::sin(theta) });
    }
  }
  for (unsigned int i = 0; i < rings; ++i)
  {
    for (unsigned int s = 0; s < sectors; ++s)
    {
      const unsigned int a = i * sectors + s;
      const unsigned int b = i * sectors + (s + 1) % sectors;
      surface.triangles.push_back({ a, b, a + sectors });
      surface.triangles.push_back({ b, b + sectors, a + sectors });
    }
  }
  return surface;
}

using SumType = itk::LeastSquaresSumMetricv4;
using JawEnum = itk::ToothCode::JawEnum;

/** Two jaws: tracings by hand beside the contours at the pose, with weights and gaps of their own. */
struct Scene
{
  itk::PoseGeometry                           geometry;
  itk::PoseRegistrationOptions                options;
  std::shared_ptr<const itk::TriangleSurface> surfaces[2];

  explicit Scene(double sourceSign = 1.0)
    : geometry(MakeGeometry(sourceSign))
    , surfaces{ std::make_shared<const itk::TriangleSurface>(MakeArch()),
                std::make_shared<const itk::TriangleSurface>(MakeArch(0.9)) }
  {
    options.correlationLength = 9.0;
    options.covarianceCorrelationLength = 21.0;
    options.covarianceInflation = 1.3;
    options.absorbedNoise = 0.2;
    options.rollSigma = 0.05;
    options.yawSigma = 0.08;
    options.rotationPriorFreedom = 5.0;
    options.tySigma = 1.7;
    options.kappaSigma = 0.02;
    options.kappaSigmaWithoutSpacing = 0.3;
    options.estimateNoise = false;
  }

  itk::PosePriors
  MakePriors() const
  {
    return itk::PosePriors(options, geometry.pixelSpacingKnown);
  }

  /** Both jaws' terms and the priors, at the pose, with these levels of the noise. */
  SumType::Pointer
  MakeMetric(const itk::ContourNoiseLevels & levels) const
  {
    auto sum = SumType::New();
    for (unsigned int j = 0; j < 2; ++j)
    {
      auto term = itk::SilhouettePoseMetricv4::New();
      term->SetTransform(this->MakeTransform());
      term->SetMovingSurface(surfaces[j]);
      term->SetFixedContour(this->MakeTracing(j));
      term->SetJaw(j == 0 ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower);
      // The arch ends at the midline.
      term->UseSideSelectionOff();
      auto noise = itk::CorrelatedNoiseModel::New();
      noise->SetCorrelationLength(options.useCorrelatedNoise ? options.correlationLength : 0.0);
      term->SetNoiseModel(noise);
      if (!options.useRobustKernel)
      {
        term->SetRobustKernel(itk::SquaresKernel::New());
      }
      sum->AddMetric(term);
    }
    // One model and one estimate.
    auto noise = itk::CorrelatedNoiseModel::New();
    noise->SetCorrelationLength(options.useCorrelatedNoise ? options.correlationLength : 0.0);
    sum->SetNoiseModel(noise);
    sum->SetNoiseLevels(levels);
    this->MakePriors().AddTo(*sum);
    sum->Initialize();
    return sum;
  }

private:
  itk::CephalometricPoseTransform::Pointer
  MakeTransform() const
  {
    using TransformType = itk::CephalometricPoseTransform;
    TransformType::FixedParametersType fixed(TransformType::NumberOfFixedParameters);
    fixed[TransformType::SourceToMidsagittal] = geometry.sourceToMidsagittal;
    fixed[TransformType::SourceToDetector] = geometry.sourceToDetector;
    fixed[TransformType::SourceSign] = geometry.sourceSign;
    fixed[TransformType::FacingSign] = geometry.facingSign;
    fixed[TransformType::PixelSpacingU] = geometry.pixelSpacing[0];
    fixed[TransformType::PixelSpacingV] = geometry.pixelSpacing[1];
    fixed[TransformType::PrincipalPointU] = geometry.principalPoint[0];
    fixed[TransformType::PrincipalPointV] = geometry.principalPoint[1];
    fixed[TransformType::Direction] = 0.0;
    TransformType::ParametersType parameters(TransformType::NumberOfParameters);
    std::copy(Pose.begin(), Pose.end(), parameters.begin());
    auto transform = TransformType::New();
    transform->SetFixedParameters(fixed);
    transform->SetParameters(parameters);
    return transform;
  }

  itk::DentalContour::Pointer
  MakeTracing(unsigned int j) const
  {
    itk::ReproducibleRandom random(19 + j);
    const itk::PoseContour  contour =
      itk::PoseMeshContourModel(
        *surfaces[j], j == 0 ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower, true)
        .Compute(itk::PoseModel(geometry, Pose));
    itk::DentalContour::PolylineType polyline;
    auto                             tracing = itk::DentalContour::New();
    double                           drift = 0.0;
    for (std::size_t i = 4 + 3 * j; i < contour.Size(); i += 3 + random.Integer(5))
    {
      // A gap in the middle of the upper one.
      if (j == 0 && i > contour.Size() / 2 && i < contour.Size() / 2 + 40)
      {
        tracing->AddPolyline(polyline);
        polyline.points.clear();
        polyline.weights.clear();
        continue;
      }
      // Some points lie elsewhere, the last of them far, and a stretch is drawn at an angle to the contour: weights are
      // near 0 and between.
      drift = 0.9 * drift + random.Normal(0.0, 0.35);
      const double across = drift + random.Normal(0.0, 0.3) + (random.Uniform() < 0.06 ? 4.0 : 0.0);
      const double gross = i + 30 > contour.Size() ? 40.0 : 0.0;
      const double begin = 0.25 * static_cast<double>(contour.Size());
      const double along = static_cast<double>(i) - begin;
      const double leaves = along > 0.0 && along < 60.0 ? 0.8 * along : 0.0;
      const double offset = across + gross + leaves;
      const auto   pixel = itk::PoseModel::ToPixel(
        geometry, { { contour.u[i] + offset * contour.nu[i], contour.v[i] + offset * contour.nv[i] } });
      itk::DentalContour::PointType point;
      point[0] = pixel[0];
      point[1] = pixel[1];
      polyline.points.push_back(point);
      polyline.weights.push_back(random.Uniform(0.2, 1.0));
    }
    tracing->AddPolyline(polyline);
    return tracing;
  }
};

/** The strands by the documentation's formulas: only which sample a point is matched with, its normal and whether it
 * faces the same way are the metric's. */
std::vector<Reference::Strand>
MakeStrands(const Scene & scene, const SumType & metric, double width, double leastWeight = 0.0)
{
  const Reference::Imaging       imaging = ImagingOf(scene.geometry);
  std::vector<Reference::Strand> strands;
  for (const itk::FoundSilhouette & found : itk::FindSilhouettes(metric))
  {
    const auto &             kernel = found.metric->GetKernel();
    const itk::PoseContour & contour = found.metric->GetContours(found.position).front();
    const auto               lin = kernel.Linearize(0, Pose, contour, false);
    const itk::PoseTracing & tracing = kernel.GetStrands().front().tracing;
    Reference::Strand        strand;
    strand.arc = tracing.arc;
    strand.jacobian.set_size(static_cast<unsigned int>(tracing.Size()), 7);
    for (unsigned int i = 0; i < tracing.Size(); ++i)
    {
      const std::size_t sample = lin.match[i];
      const double      nu = contour.nu[sample];
      const double      nv = contour.nv[sample];
      strand.nu.push_back(nu);
      strand.nv.push_back(nv);
      strand.residuals.push_back(nu * (tracing.u[i] - contour.u[sample]) + nv * (tracing.v[i] - contour.v[sample]));
      strand.weights.push_back(std::max(leastWeight,
                                        lin.facing[i] * tracing.weight[i] *
                                          Reference::RobustWeight(std::sqrt(lin.squaredDistance[i]), width)));
      const Reference::Point   rim = contour.rim[sample];
      const vnl_matrix<double> byPose = Reference::Differentiate(
        [&](const Reference::Parameters & q) { return Reference::ProjectToWorkingPlane(imaging, q, rim); }, Pose);
      for (unsigned int a = 0; a < 7; ++a)
      {
        strand.jacobian(i, a) = -(nu * byPose(0, a) + nv * byPose(1, a));
      }
    }
    strands.push_back(strand);
  }
  return strands;
}

/** Flat arrays of strands for the estimate of the noise; owns what it points to. */
struct NoiseBlocks
{
  std::vector<Reference::Strand>                 strands;
  std::vector<vnl_matrix<double>>                correlations;
  std::vector<vnl_matrix<double>>                jacobians;
  std::vector<itk::ContourNoiseModel::BlockType> blocks;

  NoiseBlocks(std::vector<Reference::Strand> ofStrands, double length)
    : strands(std::move(ofStrands))
  {
    for (const auto & strand : strands)
    {
      correlations.push_back(Reference::NoiseCovariance(strand, length, 1.0, 0.0));
      jacobians.push_back(strand.jacobian.transpose());
    }
    for (std::size_t s = 0; s < strands.size(); ++s)
    {
      blocks.push_back({ strands[s].arc.size(),
                         correlations[s].data_block(),
                         strands[s].weights.data(),
                         strands[s].residuals.data(),
                         jacobians[s].data_block() });
    }
  }
  NoiseBlocks(const NoiseBlocks &) = delete;
};

std::array<double, 49>
CovarianceOf(const Scene & scene, const SumType & metric)
{
  return itk::ComputePoseCovariance(metric, scene.options, scene.MakePriors());
}

/** Precisions of the priors: Gaussian, but for roll and yaw. */
Reference::Parameters
MakePrecision(const Scene & scene, double (*ofT)(double, double, double))
{
  const auto & o = scene.options;
  return { { 0.0,
             ofT(Pose[itk::PoseRoll], o.rollSigma, o.rotationPriorFreedom),
             ofT(Pose[itk::PoseYaw], o.yawSigma, o.rotationPriorFreedom),
             0.0,
             1.0 / (o.tySigma * o.tySigma),
             0.0,
             1.0 / (o.kappaSigma * o.kappaSigma) } };
}

void
ExpectNear(const std::array<double, 49> & actual, const vnl_matrix<double> & expected, const char * what)
{
  for (unsigned int a = 0; a < 7; ++a)
  {
    for (unsigned int b = 0; b < 7; ++b)
    {
      // Differences leave 1e-7 of the derivatives; their inverse magnifies it, the flattest direction most.
      EXPECT_NEAR(actual[7 * a + b], expected(a, b), 1e-5 * std::sqrt(expected(a, a) * expected(b, b)))
        << what << ", " << a << ", " << b;
    }
  }
}

/** A covariance with every correlation. */
vnl_matrix<double>
MakeCovariance()
{
  const double            sigmas[7] = { 0.01, 0.03, 0.04, 0.5, 1.5, 0.4, 0.02 };
  itk::ReproducibleRandom random(29);
  vnl_matrix<double>      root(7, 7);
  for (unsigned int a = 0; a < 7; ++a)
  {
    for (unsigned int b = 0; b < 7; ++b)
    {
      root(a, b) = sigmas[a] * (a == b ? 1.0 : random.Uniform(-0.5, 0.5));
    }
  }
  return root * root.transpose();
}

std::array<double, 49>
Flatten(const vnl_matrix<double> & matrix)
{
  std::array<double, 49> flat{};
  std::copy(matrix.begin(), matrix.end(), flat.begin());
  return flat;
}

/** The nearest contour point absorbs noise: factor on both levels; the contour's own 0.15 px in squares. */
itk::ContourNoiseLevels
Inflate(const itk::ContourNoiseLevels & noise, double absorbed)
{
  const double factor = std::min(1.6, 1.0 + absorbed * noise.smooth * noise.smooth);
  return { std::hypot(factor * noise.smooth, 0.15), factor * noise.white };
}

double
KernelWidth(const itk::ContourNoiseLevels & noise)
{
  return std::max(3.0, 2.5 * std::hypot(noise.smooth, noise.white));
}
} // namespace

TEST(PoseCovariance, CaseHasPointsThatCountFullyHalfAndNotAtAll)
{
  const Scene  scene;
  const auto   metric = scene.MakeMetric({ 1.1, 0.5 });
  unsigned int full = 0, between = 0, none = 0;
  for (const itk::FoundSilhouette & found : itk::FindSilhouettes(*metric))
  {
    ASSERT_EQ(found.metric->GetKernel().GetStrands().size(), 1u);
    const auto lin =
      found.metric->GetKernel().Linearize(0, Pose, found.metric->GetContours(found.position).front(), false);
    for (const double facing : lin.facing)
    {
      full += facing == 1.0 ? 1 : 0;
      between += facing > 0.02 && facing < 0.98 ? 1 : 0;
      none += facing == 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(full, 40u);
  EXPECT_GT(between, 1u);
  EXPECT_GT(none, 1u);
}

TEST(PoseCovariance, IsTheInverseOfDenseInformationAndPriorsWithTheLongerCorrelationLength)
{
  for (const double sourceSign : { 1.0, -1.0 })
  {
    const Scene                   scene(sourceSign);
    const itk::ContourNoiseLevels levels{ 1.1, 0.5 };
    const auto                    metric = scene.MakeMetric(levels);
    const auto                    strands = MakeStrands(scene, *metric, KernelWidth(levels));
    ASSERT_EQ(strands.size(), 2u);
    ASSERT_GT(strands[0].arc.size(), 20u);
    ASSERT_GT(strands[1].arc.size(), 20u);
    const auto inflated = Inflate(levels, 0.2);
    const auto information = Reference::Information(
      strands, 21.0, inflated.smooth, inflated.white, MakePrecision(scene, Reference::VariancePrecisionOfT));
    ExpectNear(CovarianceOf(scene, *metric), Reference::Covariance(information, {}, {}, 1.3), "all parameters");
  }
}

TEST(PoseCovariance, AModelOfTheCallersIsTakenInThePlaceOfItsOwn)
{
  const Scene                   scene;
  const itk::ContourNoiseLevels levels{ 1.1, 0.5 };
  const auto                    metric = scene.MakeMetric(levels);
  const auto                    strands = MakeStrands(scene, *metric, KernelWidth(levels));
  const auto                    inflated = Inflate(levels, 0.2);
  const auto                    model = itk::CorrelatedNoiseModel::New();
  model->SetCorrelationLength(9.0);
  const auto information = Reference::Information(
    strands, 9.0, inflated.smooth, inflated.white, MakePrecision(scene, Reference::VariancePrecisionOfT));
  ExpectNear(itk::ComputePoseCovariance(*metric, scene.options, scene.MakePriors(), model),
             Reference::Covariance(information, {}, {}, 1.3),
             "correlation length of the caller's model");
}

TEST(PoseCovariance, LeavesTheMetricAsItIs)
{
  Scene scene;
  scene.options.estimateNoise = true;
  const auto metric = scene.MakeMetric({ 1.1, 0.5 });
  const auto value = metric->GetValue();
  const auto position = metric->GetParameters();
  CovarianceOf(scene, *metric);
  EXPECT_EQ(metric->GetValue(), value);
  EXPECT_EQ(metric->GetParameters(), position);
  itk::ContourNoiseLevels levels;
  metric->GetNoiseLevels(levels);
  EXPECT_EQ(levels.smooth, 1.1);
  EXPECT_EQ(levels.white, 0.5);
}

TEST(PoseCovariance, WithoutCorrelationOrRobustKernelIsThatOfIndependentPoints)
{
  Scene scene;
  scene.options.useCorrelatedNoise = false;
  scene.options.useRobustKernel = false;
  const auto metric = scene.MakeMetric({ 0.7, 0.9 });
  const auto inflated = Inflate({ 0.7, 0.9 }, 0.2);
  const auto information = Reference::Information(MakeStrands(scene, *metric, 1e9),
                                                  0.0,
                                                  inflated.smooth,
                                                  inflated.white,
                                                  MakePrecision(scene, Reference::VariancePrecisionOfT));
  ExpectNear(CovarianceOf(scene, *metric), Reference::Covariance(information, {}, {}, 1.3), "independent points");
}

TEST(PoseCovariance, AbsorbedNoiseGrowsWithTheDriftUpToItsLimit)
{
  Scene scene;
  for (const double absorbed : { 0.0, 0.05, 0.2 })
  {
    scene.options.absorbedNoise = absorbed;
    for (const double smooth : { 0.4, 1.7, 2.6 })
    {
      const itk::ContourNoiseLevels levels{ smooth, 0.8 };
      const auto                    metric = scene.MakeMetric(levels);
      const auto                    expected = Inflate(levels, absorbed);
      const auto information = Reference::Information(MakeStrands(scene, *metric, KernelWidth(levels)),
                                                      21.0,
                                                      expected.smooth,
                                                      expected.white,
                                                      MakePrecision(scene, Reference::VariancePrecisionOfT));
      ExpectNear(CovarianceOf(scene, *metric),
                 Reference::Covariance(information, {}, {}, 1.3),
                 ("absorbed " + std::to_string(absorbed) + ", smooth " + std::to_string(smooth)).c_str());
    }
  }
  // By hand: 1 + 0.2 1.7^2 = 1.578, and 1.6 for 2.6 px.
  EXPECT_NEAR(Inflate({ 1.7, 0.8 }, 0.2).white, 1.578 * 0.8, 1e-12);
  EXPECT_NEAR(Inflate({ 2.6, 0.8 }, 0.2).white, 1.6 * 0.8, 1e-12);
}

TEST(PoseCovariance, NoiseIsEstimatedWithTheCovariancesOwnLengthAndPriors)
{
  Scene scene;
  scene.options.estimateNoise = true;
  const itk::ContourNoiseLevels start{ 1.1, 0.5 };
  const auto                    metric = scene.MakeMetric(start);
  const auto                    strands = MakeStrands(scene, *metric, KernelWidth(start));
  const auto                    precision = MakePrecision(scene, Reference::VariancePrecisionOfT);
  const NoiseBlocks             noise(strands, 21.0);
  const auto levels = itk::ContourNoiseModel::Estimate(noise.blocks, precision.data(), Pose.data(), 7, start);
  const auto inflated = Inflate(levels, 0.2);
  EXPECT_GT(std::abs(inflated.smooth - Inflate(start, 0.2).smooth), 0.02) << "the case tells them apart";

  // The metric's own estimate under the same model.
  const SumType::Pointer own = metric->Clone();
  const auto             priors = scene.MakePriors();
  itk::PosePriors::SetFree(*own, priors.GetCovarianceSigmas());
  priors.SetPriors(*own, priors.GetCovarianceSigmas(), true);
  auto model = itk::CorrelatedNoiseModel::New();
  model->SetCorrelationLength(21.0);
  own->SetNoiseModel(model);
  own->Initialize();
  own->SetKernelWidth(KernelWidth(start));
  own->EstimateNoise();
  itk::ContourNoiseLevels estimated;
  ASSERT_TRUE(own->GetNoiseLevels(estimated));
  // Both end their search where the criterion changes by 1e-4, on input that differs by rounding.
  EXPECT_NEAR(estimated.smooth, levels.smooth, 1e-3);
  EXPECT_NEAR(estimated.white, levels.white, 1e-3);

  // With the levels that were estimated the covariance is that of the formula.
  const auto used = Inflate(estimated, 0.2);
  const auto information = Reference::Information(strands, 21.0, used.smooth, used.white, precision);
  ExpectNear(CovarianceOf(scene, *metric), Reference::Covariance(information, {}, {}, 1.3), "estimated noise");
}

TEST(PoseCovariance, DevianceTakesTheTangentPrecisionOfTheTPriorAndTheShorterLength)
{
  const Scene                   scene;
  const itk::ContourNoiseLevels start{ 1.1, 0.5 };
  const auto                    metric = scene.MakeMetric(start);
  const auto                    precision = MakePrecision(scene, Reference::TangentPrecisionOfT);
  const NoiseBlocks             noise(MakeStrands(scene, *metric, 4.0, 1e-3), 9.0);
  double                        deviance = 0.0;
  itk::ContourNoiseModel::Estimate(noise.blocks, precision.data(), Pose.data(), 7, start, &deviance);
  metric->SetKernelWidth(4.0);
  // The criterion's own search ends within 1e-4.
  EXPECT_NEAR(metric->EstimateNoise(1e-3), deviance, 1e-3);
}

TEST(PoseCovariance, TPriorHasItsVarianceAndTheSlopeOfItsLogDensity)
{
  // Of the reference itself, by hand: (nu + 1) / ((nu - 2) s^2 + x^2), and 1 / s^2 at 0 for the covariance.
  for (const double x : { 0.0, 0.03, 0.2 })
  {
    EXPECT_NEAR(Reference::TangentPrecisionOfT(x, 0.06, 4.0) * (2.0 * 0.0036 + x * x), 5.0, 1e-5);
    EXPECT_NEAR(Reference::VariancePrecisionOfT(x, 0.06, 4.0) * (2.0 * 0.0036 + x * x), 2.0, 1e-5);
  }
}

TEST(PoseCovariance, HeldParametersHaveTheirOwnWidthAndTheOthersFollow)
{
  struct Case
  {
    const char *          what;
    bool                  scale;
    bool                  rotation;
    bool                  translation;
    bool                  spacingKnown;
    Reference::Parameters held;
  };
  const Case cases[] = {
    { "scale", true, false, false, true, { { 0, 0, 0, 0, 0, 0, 0.02 } } },
    { "scale without a spacing", true, false, false, false, { { 0, 0, 0, 0, 0, 0, 0.3 } } },
    { "rotation", false, true, false, true, { { 1.5 * Degree, 2.5 * Degree, 2.5 * Degree, 0, 0, 0, 0 } } },
    { "translation", false, false, true, true, { { 0, 0, 0, 1.2, 1.2, 1.2, 0 } } },
    { "rotation and scale", true, true, false, true, { { 1.5 * Degree, 2.5 * Degree, 2.5 * Degree, 0, 0, 0, 0.02 } } },
    { "all", true, true, true, true, { { 1.5 * Degree, 2.5 * Degree, 2.5 * Degree, 1.2, 1.2, 1.2, 0.02 } } },
  };
  for (const Case & c : cases)
  {
    Scene scene;
    scene.options.fixScale = c.scale;
    scene.options.fixRotation = c.rotation;
    scene.options.fixTranslation = c.translation;
    scene.options.heldPitchSigma = 1.5 * Degree;
    scene.options.unobservedRotationSigma = 2.5 * Degree;
    scene.options.heldTranslationSigma = 1.2;
    scene.geometry.pixelSpacingKnown = c.spacingKnown;
    const itk::ContourNoiseLevels levels{ 1.1, 0.5 };
    const auto                    metric = scene.MakeMetric(levels);
    for (unsigned int k = 0; k < 7; ++k)
    {
      EXPECT_NEAR(scene.MakePriors().GetHeldSigmas()[k], c.held[k], 1e-15) << c.what << ", " << k;
    }
    const auto inflated = Inflate(levels, 0.2);
    const auto covariance = CovarianceOf(scene, *metric);
    const auto information = Reference::Information(MakeStrands(scene, *metric, KernelWidth(levels)),
                                                    21.0,
                                                    inflated.smooth,
                                                    inflated.white,
                                                    MakePrecision(scene, Reference::VariancePrecisionOfT));
    ExpectNear(covariance, Reference::Covariance(information, c.held, {}, 1.3), c.what);
    for (unsigned int k = 0; k < 7; ++k)
    {
      if (c.held[k] > 0.0)
      {
        EXPECT_NEAR(std::sqrt(covariance[8 * k]), c.held[k], 1e-9) << c.what << ", " << k;
      }
    }
  }
}

TEST(PoseCovariance, RotationsThatATracingDoesNotCarryEnterWithTheirOwnWidth)
{
  Scene scene;
  scene.options.tracedSide = itk::TracedSideEnum::Mean;
  scene.options.unobservedRotationSigma = 2.5 * Degree;
  const itk::ContourNoiseLevels levels{ 1.1, 0.5 };
  const auto                    metric = scene.MakeMetric(levels);
  const auto                    inflated = Inflate(levels, 0.2);
  auto                          precision = MakePrecision(scene, Reference::VariancePrecisionOfT);
  precision[itk::PoseRoll] = Reference::VariancePrecisionOfT(Pose[itk::PoseRoll], 2.5 * Degree, 5.0);
  precision[itk::PoseYaw] = Reference::VariancePrecisionOfT(Pose[itk::PoseYaw], 2.5 * Degree, 5.0);
  const auto information = Reference::Information(
    MakeStrands(scene, *metric, KernelWidth(levels)), 21.0, inflated.smooth, inflated.white, precision);
  ExpectNear(CovarianceOf(scene, *metric), Reference::Covariance(information, {}, {}, 1.3), "bisected");
  // What the pose itself is estimated with: nothing of roll, yaw and lateral shift.
  const auto sigmas = scene.MakePriors().GetFitSigmas(false);
  EXPECT_EQ(sigmas[itk::PoseRoll], 0.0);
  EXPECT_EQ(sigmas[itk::PoseYaw], 0.0);
  EXPECT_EQ(sigmas[itk::PoseTy], 0.0);
  EXPECT_EQ(sigmas[itk::PosePitch], std::numeric_limits<double>::infinity());
}

TEST(PoseCovariance, PredictedSigmaIsThatOfTheProjectedCovariance)
{
  const Scene              scene(-1.0);
  const auto               metric = scene.MakeMetric({ 1.1, 0.5 });
  const Reference::Imaging imaging = ImagingOf(scene.geometry);
  const vnl_matrix<double> covariance = MakeCovariance();
  for (const itk::FoundSilhouette & found : itk::FindSilhouettes(*metric))
  {
    const itk::PoseContour & contour = found.metric->GetContours(found.position).front();
    const auto               lin = found.metric->GetKernel().Linearize(0, Pose, contour, false);
    const auto               variance = [&](std::size_t sample) {
      const Reference::Point   rim = contour.rim[sample];
      const vnl_matrix<double> c = Reference::ProjectCovariance(
        [&](const Reference::Parameters & q) { return Reference::ProjectToWorkingPlane(imaging, q, rim); },
        Pose,
        covariance);
      return 0.5 * (c(0, 0) + c(1, 1));
    };
    const std::size_t n = lin.match.size();
    double            sum = 0.0;
    for (std::size_t i = 0; i < n; ++i)
    {
      sum += variance(lin.match[i]) / static_cast<double>(n);
    }
    double largest = 0.0;
    for (std::size_t j = 0; j < contour.Size(); ++j)
    {
      largest = std::max(largest, variance(j));
    }
    const auto sigma = found.metric->PredictSigma(0, found.position, Flatten(covariance));
    EXPECT_NEAR(sigma[0], std::sqrt(sum), 1e-6 * sigma[0]);
    // Every tenth sample is looked at, 5 px apart: between them the sigma changes by less than 1 %.
    EXPECT_LE(sigma[1], std::sqrt(largest) * (1.0 + 1e-6));
    EXPECT_GE(sigma[1], std::sqrt(largest) * 0.99);
    EXPECT_GT(sigma[1], 1.02 * sigma[0]);
  }
}

TEST(PoseCovariance, LandmarksCovarianceIsThatOfTheProjectedPixelWhereNoTwoLengthsAreAlike)
{
  const vnl_matrix<double> covariance = MakeCovariance();
  for (const double sourceSign : { 1.0, -1.0 })
  {
    for (const double facingSign : { 1.0, -1.0 })
    {
      itk::PoseRegistrationResult result;
      result.geometry = MakeGeometry(sourceSign, facingSign);
      result.groups.resize(2);
      result.groups[0].parameters = Pose;
      result.groups[0].covariance = Flatten(covariance);
      result.groups[1].parameters = { { -0.1, 0.02, 0.11, -4.0, -1.0, 6.0, -0.03 } };
      result.groups[1].covariance = Flatten(3.0 * covariance.transpose());
      result.jaws.resize(2);
      result.jaws[1].jaw = itk::ToothCode::JawEnum::Lower;
      result.groupOfJaw = { 1, 0 };
      // A frame that turns and shifts: rows are the axes.
      itk::PoseJawResult jaw;
      jaw.frame.rotation = { { 0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6 } };
      jaw.frame.origin = { { 7.0, -11.0, 4.0 } };
      for (auto & own : result.jaws)
      {
        own.registered = true;
        own.frame = jaw.frame;
      }
      auto solution = itk::PoseSolution::New();
      solution->SetResult(result, itk::PoseRegistrationOptions());
      for (const std::array<double, 3> point :
           { std::array<double, 3>{ { 20.0, -30.0, 5.0 } }, { { -25.0, 12.0, -18.0 } } })
      {
        for (unsigned int j = 0; j < 2; ++j)
        {
          Reference::Point p{};
          for (unsigned int k = 0; k < 3; ++k)
          {
            for (unsigned int c = 0; c < 3; ++c)
            {
              p[k] += jaw.frame.rotation[3 * k + c] * (point[c] - jaw.frame.origin[c]);
            }
          }
          const auto imaging = ImagingOf(result.geometry);
          const auto expected = Reference::ProjectCovariance(
            [&](const Reference::Parameters & q) { return Reference::ProjectToPixel(imaging, q, p); },
            result.groups[1 - j].parameters,
            j == 0 ? 3.0 * covariance : covariance);
          itk::PoseSolution::PointType landmark;
          std::copy(point.begin(), point.end(), landmark.Begin());
          const auto actual = solution->ComputeCovariance(j == 0 ? JawEnum::Upper : JawEnum::Lower, landmark);
          for (unsigned int a = 0; a < 2; ++a)
          {
            for (unsigned int b = 0; b < 2; ++b)
            {
              EXPECT_NEAR(actual(a, b), expected(a, b), 1e-6 * std::sqrt(expected(a, a) * expected(b, b)));
            }
          }
          // The geometry tells the axes apart, and the axes are correlated.
          EXPECT_GT(std::abs(expected(0, 0) / expected(1, 1) - 1.0), 0.1);
        }
      }
      // A jaw that was not registered has no uncertainty: that is an error, not a zero.
      result.jaws[1].registered = false;
      solution->SetResult(result, itk::PoseRegistrationOptions());
      EXPECT_THROW(solution->ComputeCovariance(JawEnum::Lower, itk::PoseSolution::PointType()), itk::ExceptionObject);
    }
  }
}
