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
#include "itkPartialContourKernel.h"

#include "itkReproducibleRandom.h"

#include "itkGTest.h"

#include "vnl/algo/vnl_matrix_inverse.h"

#include <cmath>
#include <thread>

namespace
{
using KernelType = itk::PartialContourKernel;
using RobustKernelEnum = itk::ContourMetricEnums::RobustKernel;
constexpr double Pi = 3.14159265358979323846;

void
AddLine(itk::ContourArrays & contour, const std::vector<std::array<double, 2>> & points, std::uint8_t code = 0)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto id = static_cast<std::uint32_t>(contour.GetNumberOfPoints());
    contour.points.push_back(points[i][0]);
    contour.points.push_back(points[i][1]);
    contour.codes.push_back(code);
    if (i > 0)
    {
      contour.segments.push_back(id - 1);
      contour.segments.push_back(id);
    }
  }
}

/** A curve like a row of cusps, 240 px wide. */
std::array<double, 2>
Cusps(double part)
{
  return { { 240.0 * part - 120.0,
             40.0 * std::cos(2.5 * part) + 9.0 * std::abs(std::sin(5.0 * Pi * part)) + 20.0 * part } };
}

itk::ContourArrays
MakeMoving(std::size_t count = 160)
{
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back(Cusps(static_cast<double>(i) / static_cast<double>(count - 1)));
  }
  itk::ContourArrays contour;
  AddLine(contour, points);
  return contour;
}

std::array<double, 2>
Map(const itk::ContourSimilarity & similarity, const std::array<double, 2> & q)
{
  const double c = similarity.scale * std::cos(similarity.angle);
  const double s = similarity.scale * std::sin(similarity.angle);
  return { { c * q[0] - s * q[1] + similarity.tx, s * q[0] + c * q[1] + similarity.ty } };
}

const itk::ContourSimilarity Truth{ 1.05, 0.08, 300.0, 400.0 };

/** Two polylines of the moved curve with 1 px of noise and a gap of 12 % between them; some points weigh less. */
itk::ContourArrays
MakeFixed(double noise = 1.0, double from = 0.15, double to = 0.85)
{
  itk::ReproducibleRandom random(7);
  itk::ContourArrays      contour;
  const double            middle = 0.5 * (from + to);
  for (const auto & part : { std::array<double, 2>{ { from, middle - 0.06 } }, { { middle + 0.06, to } } })
  {
    std::vector<std::array<double, 2>> points;
    for (int i = 0; i < 30; ++i)
    {
      auto p = Map(Truth, Cusps(part[0] + (part[1] - part[0]) * i / 29.0));
      p[0] += random.Normal(0.0, noise);
      p[1] += random.Normal(0.0, noise);
      points.push_back(p);
    }
    AddLine(contour, points);
  }
  for (std::size_t i = 0; i < contour.GetNumberOfPoints(); ++i)
  {
    contour.weights.push_back(i % 7 == 3 ? 0.3 : 1.0);
  }
  return contour;
}

itk::ContourSimilarity
Shift(itk::ContourSimilarity similarity, unsigned int parameter, double step)
{
  double * values[4] = { &similarity.scale, &similarity.angle, &similarity.tx, &similarity.ty };
  *values[parameter] += step;
  return similarity;
}

/** Compares gradient and Jacobian with central differences at this similarity; one step a parameter. */
void
CheckDerivatives(const KernelType & kernel, const itk::ContourSimilarity & similarity)
{
  const std::size_t        n = kernel.GetNumberOfResiduals();
  std::vector<double>      residuals(n);
  std::vector<double>      jacobian(4 * n);
  KernelType::GradientType gradient;
  const double             value = kernel.Evaluate(similarity, &gradient);
  kernel.EvaluateResiduals(similarity, residuals.data(), jacobian.data());
  double sum = 0.0;
  for (const double residual : residuals)
  {
    sum += residual * residual;
  }
  EXPECT_NEAR(sum, value, 1e-12 * value);
  EXPECT_EQ(kernel.Evaluate(similarity), value);
  const double steps[4] = { 1e-8, 1e-8, 1e-6, 1e-6 };
  for (unsigned int k = 0; k < 4; ++k)
  {
    std::vector<double> after(n);
    std::vector<double> before(n);
    kernel.EvaluateResiduals(Shift(similarity, k, steps[k]), after.data());
    kernel.EvaluateResiduals(Shift(similarity, k, -steps[k]), before.data());
    // A residual may flip its sign where the side is open; its square does not.
    double largest = 1e-3;
    for (std::size_t i = 0; i < n; ++i)
    {
      largest = std::max(largest, std::abs(jacobian[4 * i + k]));
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      EXPECT_NEAR(jacobian[4 * i + k], (after[i] - before[i]) / (2.0 * steps[k]), 2e-5 * largest)
        << "residual " << i << " of " << n << ", parameter " << k;
    }
    const double difference =
      (kernel.Evaluate(Shift(similarity, k, steps[k])) - kernel.Evaluate(Shift(similarity, k, -steps[k]))) /
      (2.0 * steps[k]);
    EXPECT_NEAR(gradient[k], difference, 2e-5 * std::max(1.0, std::abs(gradient[k])));
  }
}

std::vector<itk::ContourSimilarity>
MakePoses()
{
  std::vector<itk::ContourSimilarity> poses;
  itk::ReproducibleRandom             random(11);
  for (int i = 0; i < 12; ++i)
  {
    poses.push_back({ Truth.scale * std::exp(random.Normal(0.0, 0.03)),
                      Truth.angle + random.Normal(0.0, 0.04),
                      Truth.tx + random.Normal(0.0, 4.0),
                      Truth.ty + random.Normal(0.0, 4.0) });
  }
  return poses;
}

KernelType::SettingsType
MakeSettings(RobustKernelEnum robust, double directionWeight, double reverseWeight)
{
  KernelType::SettingsType settings;
  settings.robustKernel = robust;
  settings.directionWeight = directionWeight;
  settings.reverseWeight = reverseWeight;
  settings.prior.logScale = std::log(1.02);
  settings.prior.logScaleSigma = 0.02;
  settings.prior.angleSigma = 0.1;
  settings.prior.at = { { 10.0, -20.0 } };
  settings.prior.position = { { 310.0, 385.0 } };
  settings.prior.positionSigma = 9.0;
  return settings;
}
} // namespace

TEST(PartialContourKernel, DerivativesAreThoseOfTheValue)
{
  for (const auto robust : { RobustKernelEnum::Squares, RobustKernelEnum::Huber, RobustKernelEnum::GemanMcClure })
  {
    for (const double direction : { 0.0, 8.0 })
    {
      for (const double reverse : { 0.0, 0.7 })
      {
        KernelType kernel;
        kernel.Initialize(MakeFixed(), MakeMoving(), MakeSettings(robust, direction, reverse));
        for (const auto & pose : MakePoses())
        {
          CheckDerivatives(kernel, pose);
        }
      }
    }
  }
}

TEST(PartialContourKernel, DerivativesOfTheCorrelatedValueAreItsOwn)
{
  for (const double direction : { 0.0, 8.0 })
  {
    KernelType kernel;
    kernel.Initialize(MakeFixed(), MakeMoving(), MakeSettings(RobustKernelEnum::GemanMcClure, direction, 0.5));
    ASSERT_TRUE(kernel.UpdateNoise(Truth));
    EXPECT_TRUE(kernel.HasCorrelatedNoise());
    for (const auto & pose : MakePoses())
    {
      CheckDerivatives(kernel, pose);
    }
  }
}

TEST(PartialContourKernel, ValueIsTheFormulaByBruteForce)
{
  const itk::ContourArrays fixed = MakeFixed();
  const itk::ContourArrays moving = MakeMoving();
  KernelType               kernel;
  KernelType::SettingsType settings;
  settings.width = 4.0;
  kernel.Initialize(fixed, moving, settings);
  for (const auto & pose : MakePoses())
  {
    double sum = 0.0;
    double sumOfWeights = 0.0;
    for (std::size_t i = 0; i < fixed.GetNumberOfPoints(); ++i)
    {
      double d2 = 1e300;
      for (std::size_t k = 0; k + 1 < moving.GetNumberOfPoints(); ++k)
      {
        const auto   a = Map(pose, { { moving.points[2 * k], moving.points[2 * k + 1] } });
        const auto   b = Map(pose, { { moving.points[2 * k + 2], moving.points[2 * k + 3] } });
        const double dx = b[0] - a[0];
        const double dy = b[1] - a[1];
        const double px = fixed.points[2 * i] - a[0];
        const double py = fixed.points[2 * i + 1] - a[1];
        const double t = std::min(1.0, std::max(0.0, (px * dx + py * dy) / (dx * dx + dy * dy)));
        d2 = std::min(d2, (px - t * dx) * (px - t * dx) + (py - t * dy) * (py - t * dy));
      }
      sum += fixed.weights[i] * 16.0 * d2 / (16.0 + d2);
      sumOfWeights += fixed.weights[i];
    }
    EXPECT_NEAR(kernel.Evaluate(pose), sum / sumOfWeights, 1e-10 * sum);
    EXPECT_NEAR(kernel.EvaluateApproximately(pose, 1000), sum / sumOfWeights, 1e-10 * sum);
  }
}

TEST(PartialContourKernel, RobustKernelsCountAsTheirFormulasSay)
{
  // One point, 5 px off a line.
  itk::ContourArrays fixed;
  AddLine(fixed, { { { 50.0, 5.0 } } });
  itk::ContourArrays moving;
  AddLine(moving, { { { 0.0, 0.0 } }, { { 100.0, 0.0 } } });
  const auto value = [&](RobustKernelEnum robust, double width) {
    KernelType::SettingsType settings;
    settings.robustKernel = robust;
    settings.width = width;
    KernelType kernel;
    kernel.Initialize(fixed, moving, settings);
    const double first = kernel.Evaluate(itk::ContourSimilarity());
    kernel.SetWidth(1e9);
    EXPECT_NEAR(kernel.Evaluate(itk::ContourSimilarity()), 25.0, 1e-9);
    return first;
  };
  EXPECT_NEAR(value(RobustKernelEnum::Squares, 2.0), 25.0, 1e-12);
  EXPECT_NEAR(value(RobustKernelEnum::Huber, 2.0), 2.0 * 2.0 * 5.0 - 4.0, 1e-12);
  EXPECT_NEAR(value(RobustKernelEnum::Huber, 6.0), 25.0, 1e-12);
  EXPECT_NEAR(value(RobustKernelEnum::GemanMcClure, 2.0), 4.0 * 25.0 / 29.0, 1e-12);
}

TEST(PartialContourKernel, ReverseDirectionCountsOnlyBesideTheTracing)
{
  // A tracing over the middle third of a line, 2 px above it.
  itk::ContourArrays fixed;
  AddLine(fixed, { { { 100.0, 2.0 } }, { { 150.0, 2.0 } }, { { 200.0, 2.0 } } });
  itk::ContourArrays                 moving;
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i <= 300; ++i)
  {
    points.push_back({ { static_cast<double>(i), 0.0 } });
  }
  AddLine(moving, points);
  KernelType::SettingsType settings;
  settings.robustKernel = RobustKernelEnum::Squares;
  settings.reverseWeight = 1.0;
  settings.taperLength = 10.0;
  KernelType kernel;
  kernel.Initialize(fixed, moving, settings);
  const auto distances = kernel.GetMovingDistances(itk::ContourSimilarity());
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    if (i > 100 && i < 200)
    {
      EXPECT_NEAR(distances[i], 2.0, 1e-12);
    }
    else
    {
      EXPECT_TRUE(std::isnan(distances[i])) << i;
    }
  }
  // 79 points in full from 110 to 190, the faded ones by their tapers; each stands for 1 px, a point of the tracing for
  // 100/3 px.
  double reverse = 81.0;
  for (int i = 1; i < 10; ++i)
  {
    const double g = 0.01 * i * i * (3.0 - 0.2 * i);
    reverse += 2.0 * g * g;
  }
  EXPECT_NEAR(kernel.Evaluate(itk::ContourSimilarity()), 4.0 + 4.0 * reverse / (100.0 / 3.0) / 3.0, 1e-9);
  const auto overlap = kernel.ComputeOverlap(itk::ContourSimilarity(), 3.0);
  EXPECT_NEAR(overlap.fixedShare, 1.0, 1e-12);
  EXPECT_NEAR(overlap.movingShare, 99.0 / 300.0, 1e-12);
  EXPECT_NEAR(overlap.rms, 2.0, 1e-12);
  EXPECT_NEAR(overlap.largest, 2.0, 1e-12);
  EXPECT_EQ(kernel.ComputeOverlap(itk::ContourSimilarity(), 1.0).movingShare, 0.0);

  // A gap in the tracing is censored as its ends are, unless it is short.
  itk::ContourArrays cut;
  AddLine(cut, { { { 100.0, 2.0 } }, { { 140.0, 2.0 } } });
  AddLine(cut, { { { 160.0, 2.0 } }, { { 200.0, 2.0 } } });
  kernel.Initialize(cut, moving, settings);
  EXPECT_TRUE(std::isnan(kernel.GetMovingDistances(itk::ContourSimilarity())[147]));
  EXPECT_FALSE(std::isnan(kernel.GetMovingDistances(itk::ContourSimilarity())[137]));
  settings.gapLength = 25.0;
  kernel.Initialize(cut, moving, settings);
  EXPECT_FALSE(std::isnan(kernel.GetMovingDistances(itk::ContourSimilarity())[147]));
}

TEST(PartialContourKernel, ClosedTracingIsNotCensored)
{
  itk::ContourArrays fixed;
  AddLine(fixed, { { { 0.0, 0.0 } }, { { 100.0, 0.0 } }, { { 100.0, 100.0 } }, { { 0.0, 100.0 } } });
  fixed.segments.push_back(3);
  fixed.segments.push_back(0);
  KernelType::SettingsType settings;
  settings.reverseWeight = 1.0;
  KernelType kernel;
  kernel.Initialize(fixed, MakeMoving(), settings);
  for (const double distance : kernel.GetMovingDistances(itk::ContourSimilarity()))
  {
    EXPECT_FALSE(std::isnan(distance));
  }
}

TEST(PartialContourKernel, ToothIsMatchedWithItselfOrItsNeighbour)
{
  // The nearest line is tooth 16's, two teeth away from 14; 15's and 13's lie behind it; 24 is 14's fellow.
  itk::ContourArrays fixed;
  AddLine(fixed, { { { 40.0, 0.0 } }, { { 60.0, 0.0 } } }, 14);
  const auto match = [&](const std::vector<std::pair<std::uint8_t, double>> & lines, unsigned int range, bool gate) {
    itk::ContourArrays moving;
    for (const auto & line : lines)
    {
      AddLine(moving, { { { 0.0, line.second } }, { { 100.0, line.second } } }, line.first);
    }
    KernelType::SettingsType settings;
    settings.toothRange = range;
    settings.gateByTooth = gate;
    KernelType kernel;
    kernel.Initialize(fixed, moving, settings);
    EXPECT_TRUE(std::isfinite(kernel.Evaluate(itk::ContourSimilarity())));
    return kernel.GetFixedDistances(itk::ContourSimilarity())[0];
  };
  EXPECT_NEAR(match({ { 16, 3.0 }, { 15, 5.0 } }, 1, true), 5.0, 1e-12);
  EXPECT_NEAR(match({ { 16, 3.0 }, { 13, -6.0 } }, 1, true), 6.0, 1e-12);
  EXPECT_NEAR(match({ { 16, 3.0 }, { 15, 5.0 }, { 14, 7.0 } }, 0, true), 7.0, 1e-12);
  EXPECT_NEAR(match({ { 16, 3.0 }, { 15, 5.0 } }, 2, true), 3.0, 1e-12);
  EXPECT_NEAR(match({ { 16, 3.0 }, { 15, 5.0 } }, 1, false), 3.0, 1e-12);
  EXPECT_NEAR(match({ { 24, 3.0 }, { 14, 5.0 } }, 0, true), 3.0, 1e-12);
  EXPECT_NEAR(match({ { 0, 3.0 }, { 14, 5.0 } }, 0, true), 3.0, 1e-12);
  EXPECT_NEAR(match({ { 44, 3.0 }, { 14, 5.0 } }, 7, true), 5.0, 1e-12);
  // Nothing allowed: the point says nothing, and the value is finite.
  EXPECT_TRUE(std::isnan(match({ { 47, 3.0 } }, 1, true)));
}

TEST(PartialContourKernel, DirectionKeepsAnEdgeFromTheOneThatCrossesIt)
{
  // A horizontal stretch of tracing; a vertical edge through it, a horizontal one 6 px away, drawn the other way round.
  itk::ContourArrays fixed;
  AddLine(fixed, { { { 48.0, 0.0 } }, { { 50.0, 0.0 } }, { { 52.0, 0.0 } } });
  itk::ContourArrays moving;
  AddLine(moving, { { { 50.0, -40.0 } }, { { 50.0, 40.0 } } });
  AddLine(moving, { { { 100.0, 6.0 } }, { { 0.0, 6.0 } } });
  KernelType::SettingsType settings;
  KernelType               kernel;
  kernel.Initialize(fixed, moving, settings);
  EXPECT_NEAR(kernel.GetFixedDistances(itk::ContourSimilarity())[1], 0.0, 1e-12);
  settings.directionWeight = 8.0;
  kernel.Initialize(fixed, moving, settings);
  EXPECT_NEAR(kernel.GetFixedDistances(itk::ContourSimilarity())[1], 6.0, 1e-12);
  settings.directionWeight = 4.0;
  kernel.Initialize(fixed, moving, settings);
  EXPECT_NEAR(kernel.GetFixedDistances(itk::ContourSimilarity())[1], 4.0, 1e-12);
}

TEST(PartialContourKernel, CorrelatedValueIsTheDenseFormula)
{
  // A straight tracing over a straight line: residuals and normals are plain.
  itk::ContourArrays                 fixed;
  std::vector<std::array<double, 2>> points;
  itk::ReproducibleRandom            random(3);
  for (int i = 0; i < 25; ++i)
  {
    points.push_back({ { 4.0 * i, 50.0 + random.Normal() } });
  }
  // One outlier.
  points[12][1] += 20.0;
  // In three pieces, out of order and one of them turned.
  AddLine(fixed, { points.begin() + 10, points.begin() + 18 });
  AddLine(fixed, { points.rbegin(), points.rbegin() + 7 });
  AddLine(fixed, { points.begin(), points.begin() + 10 });
  itk::ContourArrays moving;
  AddLine(moving, { { { -100.0, 0.0 } }, { { 300.0, 0.0 } } });
  KernelType::SettingsType settings;
  settings.estimateNoise = false;
  settings.directionSmoothing = 1e6;
  KernelType kernel;
  kernel.Initialize(fixed, moving, settings);
  const itk::ContourSimilarity pose{ 1.0, 0.0, 0.0, 50.2 };
  ASSERT_TRUE(kernel.UpdateNoise(pose));
  EXPECT_EQ(kernel.GetNoise().smooth, 1.3);
  double              arc = 0.0;
  std::vector<double> s;
  for (std::size_t i = 0; i < 25; ++i)
  {
    arc += i > 0 ? std::hypot(4.0, points[i][1] - points[i - 1][1]) : 0.0;
    s.push_back(arc);
  }
  vnl_matrix<double> k(25, 25);
  vnl_vector<double> r(25);
  for (unsigned int i = 0; i < 25; ++i)
  {
    r[i] = points[i][1] - 50.2;
    const double share = 9.0 / (9.0 + r[i] * r[i]);
    for (unsigned int j = 0; j < 25; ++j)
    {
      k(i, j) = 1.69 * std::exp(-0.5 * (s[i] - s[j]) * (s[i] - s[j]) / 144.0);
    }
    k(i, i) += 0.36;
    r[i] *= share;
  }
  const double expected = (1.69 + 0.36) / 25.0 * dot_product(r, vnl_matrix_inverse<double>(k).inverse() * r);
  EXPECT_NEAR(kernel.Evaluate(pose), expected, 0.01 * expected); // normals follow the smoothed noise, within 1 %
  kernel.ForgetNoise();
  EXPECT_FALSE(kernel.HasCorrelatedNoise());
}

TEST(PartialContourKernel, NoWeightLeftLeavesTheNoiseModelAlone)
{
  KernelType               kernel;
  KernelType::SettingsType settings;
  settings.width = 1e-3;
  kernel.Initialize(MakeFixed(), MakeMoving(), settings);
  EXPECT_FALSE(kernel.UpdateNoise({ 1.0, 0.0, 5000.0, 0.0 }));
  EXPECT_FALSE(kernel.HasCorrelatedNoise());
}

TEST(PartialContourKernel, LongTracingsAreThinnedForTheCorrelatedNoise)
{
  itk::ContourArrays                 fixed;
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i < 2000; ++i)
  {
    points.push_back(Map(Truth, Cusps(0.1 + 0.0004 * i)));
    points.back()[1] += std::sin(0.01 * i);
  }
  AddLine(fixed, points);
  KernelType::SettingsType settings;
  settings.estimateNoise = false;
  KernelType kernel;
  kernel.Initialize(fixed, MakeMoving(), settings);
  ASSERT_TRUE(kernel.UpdateNoise(Truth));
  const double thinned = kernel.Evaluate(Truth);
  settings.maximumNumberOfCorrelatedPoints = 1000;
  kernel.Initialize(fixed, MakeMoving(), settings);
  ASSERT_TRUE(kernel.UpdateNoise(Truth));
  // A slow wave: every fifth point of five times the weight tells as much as every second one of twice the weight.
  EXPECT_NEAR(kernel.Evaluate(Truth) / thinned, 1.0, 0.1);
}

TEST(PartialContourKernel, ThreadsThatShareAKernelGetTheSameBits)
{
  KernelType kernel;
  kernel.Initialize(MakeFixed(), MakeMoving(), MakeSettings(RobustKernelEnum::GemanMcClure, 8.0, 0.5));
  ASSERT_TRUE(kernel.UpdateNoise(Truth));
  const auto          poses = MakePoses();
  std::vector<double> expected;
  for (const auto & pose : poses)
  {
    expected.push_back(kernel.Evaluate(pose));
  }
  std::vector<std::vector<double>> values(4);
  std::vector<std::thread>         threads;
  for (std::size_t t = 0; t < 4; ++t)
  {
    threads.emplace_back([&, t] {
      for (const auto & pose : poses)
      {
        KernelType::GradientType gradient;
        values[t].push_back(kernel.Evaluate(pose, &gradient));
      }
    });
  }
  for (auto & thread : threads)
  {
    thread.join();
  }
  for (const auto & ofThread : values)
  {
    EXPECT_EQ(ofThread, expected);
  }
}

TEST(PartialContourKernel, RefusesWhatItCannotMeasure)
{
  KernelType         kernel;
  itk::ContourArrays empty;
  EXPECT_THROW(kernel.Initialize(empty, MakeMoving(), {}), std::invalid_argument);
  itk::ContourArrays weightless = MakeFixed();
  weightless.weights.assign(weightless.GetNumberOfPoints(), 0.0);
  EXPECT_THROW(kernel.Initialize(weightless, MakeMoving(), {}), std::invalid_argument);
  itk::ContourArrays broken = MakeFixed();
  broken.points[5] = std::nan("");
  EXPECT_THROW(kernel.Initialize(MakeMoving(), broken, {}), std::invalid_argument);
}
