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
#include "itkContourNoiseReference.h"
#include "itkPartialContourMetricv4.h"
#include "itkReproducibleRandom.h"

#include "itkGTest.h"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

// The noise of a tracing with a kernel that is not 1 px wide, weights that are not 1 and priors that pull, against
// dense matrices. The silhouette is one straight line: then residual, direction and matched normal of every point are
// plain, and nothing else of the metric comes in.
namespace
{
using KernelType = itk::PartialContourKernel;
using MetricType = itk::PartialContourMetricv4;
using ContourNoiseReference::Levels;
using ContourNoiseReference::Strand;

constexpr double KernelWidth = 4.5;
constexpr double DirectionWeight = 6.0;
constexpr double CorrelationLength = 15.0;

/** The silhouette: y of the line in its own frame. */
constexpr double LineHeight = 35.0;

const itk::ContourSimilarity Pose{ 1.3, 0.5, 3.0, 48.0 };

double
Square(double x)
{
  return x * x;
}

/** Tight and some sigmas off: so the levels depend on every part of it. */
itk::PartialContourPrior
MakePrior()
{
  itk::PartialContourPrior prior;
  prior.logScale = std::log(1.29);
  prior.logScaleSigma = 0.003;
  prior.angle = 0.495;
  prior.angleSigma = 0.0015;
  prior.at = { { 40.0, -30.0 } };
  prior.position = { { 67.1, 38.2 } };
  prior.positionSigma = 0.25;
  return prior;
}

/** Two jaws traced along a line that lies at Pose, from left to right: drift, white noise and some gross errors. */
struct Tracing
{
  struct Jaw
  {
    std::uint8_t                       code;
    std::vector<std::array<double, 2>> points;
    std::vector<double>                weights;
  };
  std::vector<Jaw> jaws;

  Tracing()
  {
    itk::ReproducibleRandom random(91);
    for (const std::uint8_t code : { std::uint8_t{ 14 }, std::uint8_t{ 44 } })
    {
      Jaw          jaw;
      double       along = code == 14 ? -90.0 : 20.0;
      double       drift = 0.0;
      const double c = std::cos(Pose.angle);
      const double s = std::sin(Pose.angle);
      jaw.code = code;
      for (int i = 0; i < (code == 14 ? 30 : 23); ++i)
      {
        const double step = random.Uniform(1.5, 5.0);
        along += step;
        drift += 0.25 * std::sqrt(step) * random.Normal();
        const double across = Pose.scale * LineHeight + drift + random.Normal(0.0, 0.4) + (i % 11 == 6 ? 9.0 : 0.0);
        jaw.points.push_back({ { c * along - s * across + Pose.tx, s * along + c * across + Pose.ty } });
        jaw.weights.push_back(random.Uniform(0.15, 1.0));
      }
      jaws.push_back(jaw);
    }
  }

  /** Signed distance of a point from the line under a similarity. */
  static double
  Distance(const std::array<double, 2> & point, const itk::ContourSimilarity & similarity)
  {
    return -std::sin(similarity.angle) * (point[0] - similarity.tx) +
           std::cos(similarity.angle) * (point[1] - similarity.ty) - similarity.scale * LineHeight;
  }

  /** What a point's line direction, that of its two segments' mean, makes of the direction weight. */
  static double
  Direction(const Jaw & jaw, std::size_t i, const itk::ContourSimilarity & similarity)
  {
    double u[2] = { 0.0, 0.0 };
    for (std::size_t k = i > 0 ? i - 1 : 0; k < i + 1 && k + 1 < jaw.points.size(); ++k)
    {
      const double dx = jaw.points[k + 1][0] - jaw.points[k][0];
      const double dy = jaw.points[k + 1][1] - jaw.points[k][1];
      u[0] += dx / std::hypot(dx, dy);
      u[1] += dy / std::hypot(dx, dy);
    }
    return DirectionWeight * std::sin(std::atan2(u[1], u[0]) - similarity.angle);
  }

  static double
  SquaredMatch(const Jaw & jaw, std::size_t i, const itk::ContourSimilarity & similarity)
  {
    return Square(Distance(jaw.points[i], similarity)) + Square(Direction(jaw, i, similarity));
  }

  double
  SumOfWeights() const
  {
    double sum = 0.0;
    for (const Jaw & jaw : jaws)
    {
      for (const double weight : jaw.weights)
      {
        sum += weight;
      }
    }
    return sum;
  }

  /** The strands at Pose. Only points within the kernel's width have weight where the levels are estimated. The
   * Jacobian is by the priors' own parameters: log scale and angle about the prior's point, and where that lands. */
  std::vector<Strand>
  MakeStrands(bool forLevels) const
  {
    const itk::PartialContourPrior prior = MakePrior();
    const double                   c = std::cos(Pose.angle);
    const double                   s = std::sin(Pose.angle);
    const double                   place[2] = { Pose.scale * (c * prior.at[0] - s * prior.at[1]) + Pose.tx,
                                                Pose.scale * (s * prior.at[0] + c * prior.at[1]) + Pose.ty };
    std::vector<Strand>            strands;
    for (const Jaw & jaw : jaws)
    {
      Strand     strand;
      const auto n = static_cast<unsigned int>(jaw.points.size());
      strand.residuals.set_size(n);
      strand.jacobian.set_size(n, 4);
      for (unsigned int i = 0; i < n; ++i)
      {
        const auto & p = jaw.points[i];
        strand.arc.push_back(
          i > 0 ? strand.arc.back() + std::hypot(p[0] - jaw.points[i - 1][0], p[1] - jaw.points[i - 1][1]) : 0.0);
        strand.nu.push_back(-s);
        strand.nv.push_back(c);
        const bool within = SquaredMatch(jaw, i, Pose) <= KernelWidth * KernelWidth;
        strand.weights.push_back(!forLevels || within ? jaw.weights[i] : 0.0);
        strand.residuals[i] = Distance(p, Pose);
        // r = n (p - place) + s (at_y - height)
        strand.jacobian(i, 0) = Pose.scale * (prior.at[1] - LineHeight);
        strand.jacobian(i, 1) = -(c * (p[0] - place[0]) + s * (p[1] - place[1]));
        strand.jacobian(i, 2) = s;
        strand.jacobian(i, 3) = -c;
      }
      strands.push_back(strand);
    }
    return strands;
  }
};

/** Priors' differences from their means at a similarity, each over its sigma. */
std::array<double, 4>
PriorResiduals(const itk::ContourSimilarity & similarity)
{
  const itk::PartialContourPrior prior = MakePrior();
  const double                   c = similarity.scale * std::cos(similarity.angle);
  const double                   s = similarity.scale * std::sin(similarity.angle);
  return { { (std::log(similarity.scale) - prior.logScale) / prior.logScaleSigma,
             (similarity.angle - prior.angle) / prior.angleSigma,
             (c * prior.at[0] - s * prior.at[1] + similarity.tx - prior.position[0]) / prior.positionSigma,
             (s * prior.at[0] + c * prior.at[1] + similarity.ty - prior.position[1]) / prior.positionSigma } };
}

Levels
ExpectedLevels(const Tracing & tracing)
{
  const itk::PartialContourPrior prior = MakePrior();
  const double sigmas[4] = { prior.logScaleSigma, prior.angleSigma, prior.positionSigma, prior.positionSigma };
  const std::array<double, 4> difference = PriorResiduals(Pose);
  vnl_vector<double>          precision(4);
  vnl_vector<double>          offset(4);
  for (unsigned int a = 0; a < 4; ++a)
  {
    precision[a] = 1.0 / Square(sigmas[a]);
    offset[a] = difference[a] * sigmas[a];
  }
  return ContourNoiseReference::Minimise(tracing.MakeStrands(true), CorrelationLength, precision, offset);
}

/** Geman-McClure: the weight of a square z. */
double
RobustWeight(double z)
{
  return Square(KernelWidth * KernelWidth / (KernelWidth * KernelWidth + z));
}

/** sum over jaws of A' V K^-1 V A, for rows A(jaw, point) that the caller makes. */
vnl_matrix<double>
GeneralisedSquares(const Tracing &                                                           tracing,
                   const Levels &                                                            levels,
                   unsigned int                                                              columns,
                   const std::function<vnl_vector<double>(const Tracing::Jaw &, unsigned)> & rowOf)
{
  const std::vector<Strand> strands = tracing.MakeStrands(false);
  vnl_matrix<double>        sum(columns, columns, 0.0);
  for (std::size_t j = 0; j < strands.size(); ++j)
  {
    const Tracing::Jaw & jaw = tracing.jaws[j];
    const auto           n = static_cast<unsigned int>(jaw.points.size());
    vnl_matrix<double>   rows(n, columns);
    for (unsigned int i = 0; i < n; ++i)
    {
      rows.set_row(i, std::sqrt(RobustWeight(Tracing::SquaredMatch(jaw, i, Pose))) * rowOf(jaw, i));
    }
    const vnl_matrix<double> k = ContourNoiseReference::Covariance(strands[j], CorrelationLength, levels);
    sum += rows.transpose() * vnl_matrix_inverse<double>(k).inverse() * rows;
  }
  return sum;
}

itk::ContourArrays
MakeFixedArrays(const Tracing & tracing)
{
  itk::ContourArrays fixed;
  for (const auto & jaw : tracing.jaws)
  {
    for (std::size_t i = 0; i < jaw.points.size(); ++i)
    {
      const auto id = static_cast<std::uint32_t>(fixed.GetNumberOfPoints());
      fixed.points.push_back(jaw.points[i][0]);
      fixed.points.push_back(jaw.points[i][1]);
      fixed.weights.push_back(jaw.weights[i]);
      fixed.codes.push_back(jaw.code);
      if (i > 0)
      {
        fixed.segments.push_back(id - 1);
        fixed.segments.push_back(id);
      }
    }
  }
  return fixed;
}

KernelType
MakeKernel(const Tracing & tracing, bool estimate)
{
  itk::ContourArrays moving;
  moving.points = { -300.0, LineHeight, 300.0, LineHeight };
  moving.segments = { 0, 1 };
  KernelType::SettingsType settings;
  settings.width = KernelWidth;
  settings.directionWeight = DirectionWeight;
  settings.directionSmoothing = 0.0;
  settings.correlationLength = CorrelationLength;
  settings.estimateNoise = estimate;
  settings.noise = { 0.9, 0.4 };
  settings.prior = MakePrior();
  KernelType kernel;
  kernel.Initialize(MakeFixedArrays(tracing), moving, settings);
  return kernel;
}

MetricType::Pointer
MakeMetric(const Tracing & tracing, bool estimate)
{
  const auto fixed = itk::DentalContour::New();
  for (const auto & jaw : tracing.jaws)
  {
    itk::DentalContour::PolylineType polyline;
    polyline.code = itk::ToothCode(jaw.code);
    polyline.weights = jaw.weights;
    for (const auto & p : jaw.points)
    {
      itk::DentalContour::PointType point;
      point[0] = p[0];
      point[1] = p[1];
      polyline.points.push_back(point);
    }
    fixed->AddPolyline(polyline);
  }
  const auto                                 moving = itk::DentalContour::New();
  std::vector<itk::DentalContour::PointType> ends(2);
  ends[0][0] = -300.0;
  ends[0][1] = LineHeight;
  ends[1][0] = 300.0;
  ends[1][1] = LineHeight;
  moving->AddPolyline(ends);
  const auto                 transform = MetricType::TransformType::New();
  MetricType::ParametersType parameters(4);
  parameters[0] = Pose.scale;
  parameters[1] = Pose.angle;
  parameters[2] = Pose.tx;
  parameters[3] = Pose.ty;
  transform->SetParameters(parameters);
  const auto metric = MetricType::New();
  metric->SetFixedContour(fixed);
  metric->SetMovingContour(moving);
  metric->SetMovingTransform(transform);
  metric->SetKernelWidth(KernelWidth);
  metric->SetDirectionWeight(DirectionWeight);
  metric->SetDirectionSmoothing(0.0);
  metric->SetCorrelationLength(CorrelationLength);
  metric->SetEstimateNoise(estimate);
  metric->SetSmoothNoise(0.9);
  metric->SetWhiteNoise(0.4);
  const itk::PartialContourPrior prior = MakePrior();
  metric->SetScalePrior(std::exp(prior.logScale), prior.logScaleSigma);
  metric->SetRotationPrior(prior.angle, prior.angleSigma);
  MetricType::PointType at;
  MetricType::PointType position;
  for (unsigned int d = 0; d < 2; ++d)
  {
    at[d] = prior.at[d];
    position[d] = prior.position[d];
  }
  metric->SetTranslationPrior(at, position, prior.positionSigma);
  // The pivot and the length of the metric's parameters shall be none of the other lengths.
  MetricType::PointType pivot;
  pivot[0] = 25.0;
  pivot[1] = 70.0;
  metric->SetPivot(pivot);
  metric->Initialize();
  return metric;
}

/** Derivatives by the metric's parameters of a function of the similarity, by central differences. */
vnl_vector<double>
Differentiate(const MetricType * metric, const std::function<double(const itk::ContourSimilarity &)> & function)
{
  vnl_vector<double> derivatives(4);
  for (unsigned int a = 0; a < 4; ++a)
  {
    MetricType::ParametersType after = metric->GetParameters();
    MetricType::ParametersType before = after;
    after[a] += 1e-3;
    before[a] -= 1e-3;
    derivatives[a] = (function(metric->GetSimilarity(after)) - function(metric->GetSimilarity(before))) / 2e-3;
  }
  return derivatives;
}

void
ExpectSameCovariance(const MetricType::CovarianceType & actual, const vnl_matrix<double> & information)
{
  const vnl_matrix<double> expected = vnl_matrix_inverse<double>(information).inverse();
  for (unsigned int a = 0; a < 4; ++a)
  {
    for (unsigned int b = 0; b < 4; ++b)
    {
      // Central differences over 1e-3 px leave some 1e-7 of the derivatives.
      EXPECT_NEAR(actual(a, b), expected(a, b), 2e-6 * std::sqrt(expected(a, a) * expected(b, b))) << a << ", " << b;
    }
  }
}

/** The levels are those of the dense formula within what the search's end leaves open, 2e-4 of the objective with a
 * curvature above 10. */
void
ExpectNear(const itk::ContourNoiseLevels & actual, const Levels & expected)
{
  EXPECT_NEAR(std::log(actual.smooth), std::log(expected.smooth), 0.006);
  EXPECT_NEAR(std::log(actual.white), std::log(expected.white), 0.006);
}
} // namespace

TEST(PartialContourNoise, LevelsAreThoseOfThePointsWithinTheKernelByTheDenseFormula)
{
  const Tracing tracing;
  KernelType    kernel = MakeKernel(tracing, true);
  ASSERT_TRUE(kernel.UpdateNoise(Pose));
  ExpectNear(kernel.GetNoise(), ExpectedLevels(tracing));
}

TEST(PartialContourNoise, ValueIsGeneralisedLeastSquaresWithBifactorWeightsAndPriors)
{
  const Tracing tracing;
  for (const bool estimate : { false, true })
  {
    KernelType kernel = MakeKernel(tracing, estimate);
    ASSERT_TRUE(kernel.UpdateNoise(Pose));
    const Levels levels{ kernel.GetNoise().smooth, kernel.GetNoise().white };
    double       sum = GeneralisedSquares(tracing, levels, 1, [](const Tracing::Jaw & jaw, unsigned int i) {
      return vnl_vector<double>(1, Tracing::Distance(jaw.points[i], Pose));
    })(0, 0);
    for (const double residual : PriorResiduals(Pose))
    {
      sum += residual * residual;
    }
    const double variance = Square(levels.smooth) + Square(levels.white);
    const double expected = variance / tracing.SumOfWeights() * sum;
    // G is cut off at exp(-20).
    EXPECT_NEAR(kernel.Evaluate(Pose), expected, 1e-7 * expected);
    EXPECT_NEAR(kernel.GetValueOfUnitInformation(), variance / tracing.SumOfWeights(), 1e-12);
    // Weights and K are held whatever the width is afterwards.
    kernel.SetWidth(2.0 * KernelWidth);
    EXPECT_NEAR(kernel.Evaluate(Pose), expected, 1e-7 * expected);
  }
}

TEST(PartialContourNoise, CovarianceOfTheMetricIsTheDenseFormula)
{
  const Tracing tracing;
  for (const bool estimate : { false, true })
  {
    const auto metric = MakeMetric(tracing, estimate);
    ASSERT_TRUE(metric->UpdateNoiseModel());
    const Levels levels{ metric->GetNoiseLevels().smooth, metric->GetNoiseLevels().white };
    if (estimate)
    {
      ExpectNear(metric->GetNoiseLevels(), ExpectedLevels(tracing));
    }
    else
    {
      EXPECT_EQ(levels.smooth, 0.9);
      EXPECT_EQ(levels.white, 0.4);
    }
    vnl_matrix<double> information =
      GeneralisedSquares(tracing, levels, 4, [&](const Tracing::Jaw & jaw, unsigned int i) {
        return Differentiate(metric, [&](const itk::ContourSimilarity & similarity) {
          return Tracing::Distance(jaw.points[i], similarity);
        });
      });
    for (unsigned int k = 0; k < 4; ++k)
    {
      const vnl_vector<double> row =
        Differentiate(metric, [k](const itk::ContourSimilarity & similarity) { return PriorResiduals(similarity)[k]; });
      information += outer_product(row, row);
    }
    ExpectSameCovariance(metric->ComputeCovariance(), information);
  }
}

TEST(PartialContourNoise, CovarianceWithoutANoiseModelTakesPointsAsIndependentWithBothLevels)
{
  const Tracing      tracing;
  const auto         metric = MakeMetric(tracing, true);
  vnl_matrix<double> information(4, 4, 0.0);
  for (const Tracing::Jaw & jaw : tracing.jaws)
  {
    for (std::size_t i = 0; i < jaw.points.size(); ++i)
    {
      // Distance and direction, each by the factor that makes the robust charge of the match of their squares.
      for (const bool direction : { false, true })
      {
        const vnl_vector<double> row = Differentiate(metric, [&](const itk::ContourSimilarity & similarity) {
          const double factor =
            std::sqrt(Square(KernelWidth) / (Square(KernelWidth) + Tracing::SquaredMatch(jaw, i, similarity)));
          return factor *
                 (direction ? Tracing::Direction(jaw, i, similarity) : Tracing::Distance(jaw.points[i], similarity));
        });
        information += jaw.weights[i] / (Square(0.9) + Square(0.4)) * outer_product(row, row);
      }
    }
  }
  for (unsigned int k = 0; k < 4; ++k)
  {
    const vnl_vector<double> row =
      Differentiate(metric, [k](const itk::ContourSimilarity & similarity) { return PriorResiduals(similarity)[k]; });
    information += outer_product(row, row);
  }
  ExpectSameCovariance(metric->ComputeCovariance(), information);
}
