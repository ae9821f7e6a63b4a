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
#include "itkContourNoiseModel.h"

#include "itkContourNoiseReference.h"
#include "itkCorrelatedNoiseModel.h"
#include "itkReproducibleRandom.h"

#include "itkGTest.h"
#include "itkTestingMacros.h"

#include "vnl/algo/vnl_determinant.h"
#include "vnl/algo/vnl_matrix_inverse.h"

#include <cmath>
#include <vector>

namespace
{
/** A strand of points 2 px apart along an arc, with its residuals and a Jacobian of shift and tilt. */
struct Strand
{
  explicit Strand(std::size_t count)
    : arc(count)
    , nu(count)
    , nv(count)
    , weights(count, 1.0)
    , residuals(count)
    , jacobian(2 * count)
    , correlation(count * count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      arc[i] = 2.0 * static_cast<double>(i);
      nu[i] = std::sin(0.01 * arc[i]);
      nv[i] = std::cos(0.01 * arc[i]);
      jacobian[i] = nv[i];
      jacobian[count + i] = 0.01 * arc[i] - 0.8;
    }
    itk::ContourNoiseModel::ComputeCorrelation(arc.data(), nu.data(), nv.data(), count, 12.0, correlation.data());
  }

  /** Residuals with this noise: the drift from the Cholesky factor of G. */
  void
  Draw(double smooth, double white, std::uint64_t seed)
  {
    itk::ReproducibleRandom random(seed);
    const std::size_t       n = arc.size();
    std::vector<double>     factor(n * n, 0.0);
    std::vector<double>     normal(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      normal[i] = random.Normal();
      double drift = 0.0;
      for (std::size_t j = 0; j <= i; ++j)
      {
        double sum = correlation[i * n + j] + (i == j ? 1e-6 : 0.0);
        for (std::size_t k = 0; k < j; ++k)
        {
          sum -= factor[i * n + k] * factor[j * n + k];
        }
        factor[i * n + j] = i == j ? std::sqrt(sum) : sum / factor[j * n + j];
        drift += factor[i * n + j] * normal[j];
      }
      residuals[i] = smooth * drift + white * random.Normal();
    }
  }

  itk::ContourNoiseModel::BlockType
  View() const
  {
    return { arc.size(), correlation.data(), weights.data(), residuals.data(), jacobian.data() };
  }

  std::vector<double> arc;
  std::vector<double> nu;
  std::vector<double> nv;
  std::vector<double> weights;
  std::vector<double> residuals;
  std::vector<double> jacobian;
  std::vector<double> correlation;
};

int
ExerciseBasicObjectMethods()
{
  const auto model = itk::CorrelatedNoiseModel::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(model, CorrelatedNoiseModel, ResidualNoiseModel);
  return EXIT_SUCCESS;
}
} // namespace

TEST(ContourNoiseModel, CovarianceIsDriftPlusWhiteNoiseByWeight)
{
  const std::vector<double> arc{ 0.0, 12.0, 100.0 };
  const std::vector<double> nu{ 1.0, 0.6, 1.0 };
  const std::vector<double> nv{ 0.0, 0.8, 0.0 };
  const std::vector<double> weights{ 1.0, 0.25, 0.0 };
  std::vector<double>       correlation(9);
  itk::ContourNoiseModel::ComputeCorrelation(arc.data(), nu.data(), nv.data(), 3, 12.0, correlation.data());
  std::vector<double> covariance(9);
  itk::ContourNoiseModel::ComputeCovariance(correlation.data(), weights.data(), 3, { 2.0, 0.5 }, covariance.data());
  EXPECT_NEAR(covariance[0], 4.25, 1e-12);
  EXPECT_NEAR(covariance[1], 4.0 * std::exp(-0.5) * 0.6, 1e-12);
  EXPECT_EQ(covariance[1], covariance[3]);
  EXPECT_NEAR(covariance[4], 5.0, 1e-12);
  EXPECT_EQ(covariance[2], 0.0);
  EXPECT_NEAR(covariance[8], 4.0 + 0.25 / 1e-6, 1e-6);
  itk::ContourNoiseModel::ComputeCorrelation(arc.data(), nu.data(), nv.data(), 3, 0.0, correlation.data());
  EXPECT_EQ(correlation[1], 0.0);
  EXPECT_EQ(correlation[4], 1.0);
}

TEST(ContourNoiseModel, DevianceIsThatOfTheDenseFormula)
{
  Strand strand(40);
  strand.Draw(1.2, 0.6, 5);
  for (std::size_t i = 0; i < 40; ++i)
  {
    strand.weights[i] = i % 3 == 0 ? 0.4 : 1.0;
  }
  const double precision[2] = { 0.3, 2.0 };
  const double offset[2] = { 0.5, -0.2 };
  double       deviance = 0.0;
  const auto   levels =
    itk::ContourNoiseModel::Estimate({ strand.View() }, precision, offset, 2, itk::ContourNoiseLevels(), &deviance);
  vnl_matrix<double> k(40, 40);
  itk::ContourNoiseModel::ComputeCovariance(
    strand.correlation.data(), strand.weights.data(), 40, levels, k.data_block());
  vnl_matrix<double> j(40, 2);
  vnl_vector<double> r(40);
  for (unsigned int i = 0; i < 40; ++i)
  {
    j(i, 0) = strand.jacobian[i];
    j(i, 1) = strand.jacobian[40 + i];
    r[i] = strand.residuals[i];
  }
  const vnl_matrix<double> inverse = vnl_matrix_inverse<double>(k).inverse();
  vnl_matrix<double>       information = j.transpose() * inverse * j;
  vnl_vector<double>       gradient = j.transpose() * (inverse * r);
  double                   expected = dot_product(r, inverse * r) + std::log(vnl_determinant(k));
  for (unsigned int a = 0; a < 2; ++a)
  {
    information(a, a) += precision[a];
    gradient[a] += precision[a] * offset[a];
    expected += precision[a] * offset[a] * offset[a];
  }
  expected += std::log(vnl_determinant(information)) -
              dot_product(gradient, vnl_matrix_inverse<double>(information).inverse() * gradient);
  EXPECT_NEAR(deviance, expected, 1e-7);
}

TEST(ContourNoiseModel, CorrelationIsTheFormulaForUnevenArcsAndNormals)
{
  constexpr std::size_t   n = 12;
  itk::ReproducibleRandom random(21);
  std::vector<double>     arc(n);
  std::vector<double>     nu(n);
  std::vector<double>     nv(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double angle = random.Uniform(-1.5, 1.5);
    arc[i] = (i > 0 ? arc[i - 1] : 3.0) + random.Uniform(0.3, 6.0);
    nu[i] = std::cos(angle);
    nv[i] = std::sin(angle);
  }
  std::vector<double> correlation(n * n);
  itk::ContourNoiseModel::ComputeCorrelation(arc.data(), nu.data(), nv.data(), n, 7.5, correlation.data());
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = 0; j < n; ++j)
    {
      const double d = arc[i] - arc[j];
      // Left out is what is below exp(-20) = 2e-9.
      EXPECT_NEAR(
        correlation[i * n + j], std::exp(-d * d / (2.0 * 7.5 * 7.5)) * (nu[i] * nu[j] + nv[i] * nv[j]), 2.1e-9);
    }
  }
}

TEST(ContourNoiseModel, LevelsAndDevianceAreThoseOfTheDenseFormulaWithAllLengthsDistinct)
{
  // Two strands of uneven points that turn, weights from 0.1 to 3, three parameters with priors of their own, each of
  // them off its mean. Few points, and levels on either side of their priors' middle: then those count, too.
  for (const double size : { 0.15, 1.0, 6.0 })
  {
    itk::ReproducibleRandom                    random(77);
    constexpr double                           length = 9.0;
    std::vector<ContourNoiseReference::Strand> strands;
    for (const std::size_t n : { 17u, 26u })
    {
      ContourNoiseReference::Strand strand;
      strand.residuals.set_size(static_cast<unsigned int>(n));
      strand.jacobian.set_size(static_cast<unsigned int>(n), 3);
      double drift = 0.0;
      for (unsigned int i = 0; i < n; ++i)
      {
        const double step = random.Uniform(0.4, 5.0);
        const double angle = 0.11 * i + random.Uniform(-0.3, 0.3);
        strand.arc.push_back(i > 0 ? strand.arc.back() + step : 2.0);
        strand.nu.push_back(std::sin(angle));
        strand.nv.push_back(std::cos(angle));
        strand.weights.push_back(std::exp(random.Uniform(std::log(0.1), std::log(3.0))));
        drift += 0.4 * std::sqrt(step) * random.Normal();
        strand.residuals[i] = size * (drift + random.Normal(0.0, 0.5 / std::sqrt(strand.weights[i])));
        strand.jacobian(i, 0) = strand.nu[i];
        strand.jacobian(i, 1) = strand.nv[i];
        strand.jacobian(i, 2) = 0.05 * strand.arc[i] - 1.0;
      }
      strands.push_back(strand);
    }
    const vnl_vector<double> precision = [] {
      const double values[3] = { 1.0 / 0.09, 4.0, 0.25 };
      return vnl_vector<double>(values, 3);
    }();
    const vnl_vector<double> offset = [] {
      const double values[3] = { 0.6, -0.8, 1.7 };
      return vnl_vector<double>(values, 3);
    }();

    std::vector<std::vector<double>>               correlations;
    std::vector<std::vector<double>>               jacobians;
    std::vector<itk::ContourNoiseModel::BlockType> blocks;
    for (const auto & strand : strands)
    {
      const std::size_t n = strand.arc.size();
      correlations.emplace_back(n * n);
      itk::ContourNoiseModel::ComputeCorrelation(
        strand.arc.data(), strand.nu.data(), strand.nv.data(), n, length, correlations.back().data());
      jacobians.emplace_back();
      for (unsigned int a = 0; a < 3; ++a)
      {
        for (unsigned int i = 0; i < n; ++i)
        {
          jacobians.back().push_back(strand.jacobian(i, a));
        }
      }
    }
    for (std::size_t b = 0; b < strands.size(); ++b)
    {
      blocks.push_back({ strands[b].arc.size(),
                         correlations[b].data(),
                         strands[b].weights.data(),
                         strands[b].residuals.data_block(),
                         jacobians[b].data() });
    }
    double     deviance = 0.0;
    const auto levels =
      itk::ContourNoiseModel::Estimate(blocks, precision.data_block(), offset.data_block(), 3, { 0.9, 0.8 }, &deviance);
    // The same formula by another order of operations; G is cut off at 2e-9.
    EXPECT_NEAR(deviance,
                ContourNoiseReference::Deviance(strands, length, precision, offset, { levels.smooth, levels.white }),
                1e-5);
    // The search ends where its simplex spans 1e-4 of the objective: no level may be better by more than some of that.
    // The objective's curvature in the logarithms is above 10 here, which makes sqrt(2 2e-4 / 10) = 0.006 of it.
    const auto   best = ContourNoiseReference::Minimise(strands, length, precision, offset);
    const double least = ContourNoiseReference::Objective(strands, length, precision, offset, best);
    EXPECT_NEAR(ContourNoiseReference::Objective(strands, length, precision, offset, { levels.smooth, levels.white }),
                least,
                2e-4);
    EXPECT_NEAR(std::log(levels.smooth), std::log(best.smooth), 0.006);
    EXPECT_NEAR(std::log(levels.white), std::log(best.white), 0.006);
    // The case tells the formulas apart: twice the white level, or priors around other levels, is clearly worse.
    EXPECT_GT(ContourNoiseReference::Objective(strands, length, precision, offset, { best.smooth * 1.1, best.white }),
              least + 0.03);
    EXPECT_GT(ContourNoiseReference::Objective(strands, length, precision, offset, { best.smooth, best.white * 1.1 }),
              least + 0.03);
  }
}

TEST(ContourNoiseModel, RecoversTheLevelsOfSimulatedTracings)
{
  // 30 draws of 100 points: the standard error of the mean log level is about 0.03 and 0.015; the prior pulls a little.
  double           smooth = 0.0;
  double           white = 0.0;
  constexpr double Draws = 30.0;
  const double     free[2] = { 0.0, 0.0 };
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
  {
    Strand strand(100);
    strand.Draw(2.0, 0.5, seed);
    const auto levels = itk::ContourNoiseModel::Estimate({ strand.View() }, free, free, 2, itk::ContourNoiseLevels());
    smooth += std::log(levels.smooth) / Draws;
    white += std::log(levels.white) / Draws;
  }
  EXPECT_NEAR(std::exp(smooth), 2.0, 0.2);
  EXPECT_NEAR(std::exp(white), 0.5, 0.03);
}

TEST(ContourNoiseModel, PointsWithoutWeightAndEmptyBlocksSayNothing)
{
  Strand strand(60);
  strand.Draw(1.0, 0.5, 3);
  const double free[2] = { 0.0, 0.0 };
  Strand       part(59);
  part.residuals.assign(strand.residuals.begin(), strand.residuals.begin() + 59);
  const auto expected = itk::ContourNoiseModel::Estimate({ part.View() }, free, free, 2, {});
  strand.weights[59] = 0.0;
  strand.residuals[59] = 1e6;
  const auto levels =
    itk::ContourNoiseModel::Estimate({ strand.View(), itk::ContourNoiseModel::BlockType() }, free, free, 2, {});
  EXPECT_NEAR(levels.smooth, expected.smooth, 1e-9);
  EXPECT_NEAR(levels.white, expected.white, 1e-9);
}

TEST(ContourNoiseModel, PriorsAreAQuadraticFormAmongOthers)
{
  Strand strand(50);
  strand.Draw(1.4, 0.6, 8);
  const double precision[2] = { 0.7, 3.0 };
  const double offset[2] = { 0.4, -0.3 };
  double       byPriors = 0.0;
  const auto   expected = itk::ContourNoiseModel::Estimate({ strand.View() }, precision, offset, 2, {}, &byPriors);
  const double information[4] = { 0.7, 0.0, 0.0, 3.0 };
  const double gradient[2] = { 0.7 * 0.4, -3.0 * 0.3 };
  const double value = 0.7 * 0.16 + 3.0 * 0.09;
  double       byForm = 0.0;
  const auto levels = itk::ContourNoiseModel::Estimate({ strand.View() }, information, gradient, value, 2, {}, &byForm);
  // The same sums by another order of operations, and a search that goes on until its simplex spans 1e-4.
  EXPECT_NEAR(levels.smooth, expected.smooth, 1e-6);
  EXPECT_NEAR(levels.white, expected.white, 1e-6);
  EXPECT_NEAR(byForm, byPriors, 1e-6);
}

TEST(ContourNoiseModel, ResidualsOfKnownNoiseAreAQuadraticFormToo)
{
  // Two strands, of which one has noise that is known: what it says of the parameters enters by J'J, J'r and r'r, and
  // the deviance is that of both but for the known one's own determinant.
  Strand known(40), unknown(60);
  known.Draw(0.0, 0.5, 21);
  unknown.Draw(1.6, 0.5, 22);
  std::vector<double> information(4, 0.0), gradient(2, 0.0);
  double              value = 0.0;
  for (std::size_t i = 0; i < 40; ++i)
  {
    const double r = known.residuals[i] / 0.5;
    value += r * r;
    for (std::size_t a = 0; a < 2; ++a)
    {
      gradient[a] += known.jacobian[40 * a + i] / 0.5 * r;
      for (std::size_t b = 0; b < 2; ++b)
      {
        information[2 * a + b] += known.jacobian[40 * a + i] * known.jacobian[40 * b + i] / 0.25;
      }
    }
  }
  double     deviance = 0.0;
  const auto levels =
    itk::ContourNoiseModel::Estimate({ unknown.View() }, information.data(), gradient.data(), value, 2, {}, &deviance);
  vnl_matrix<double> k(60, 60);
  itk::ContourNoiseModel::ComputeCovariance(
    unknown.correlation.data(), unknown.weights.data(), 60, levels, k.data_block());
  vnl_matrix<double> covariance(100, 100, 0.0), j(100, 2);
  covariance.update(k, 40, 40);
  vnl_vector<double> r(100);
  for (unsigned int i = 0; i < 100; ++i)
  {
    const Strand &     strand = i < 40 ? known : unknown;
    const std::size_t  n = i < 40 ? 40 : 60;
    const unsigned int own = i < 40 ? i : i - 40;
    covariance(i, i) = i < 40 ? 0.25 : covariance(i, i);
    r[i] = strand.residuals[own];
    j(i, 0) = strand.jacobian[own];
    j(i, 1) = strand.jacobian[n + own];
  }
  const vnl_matrix<double> inverse = vnl_matrix_inverse<double>(covariance).inverse();
  const vnl_matrix<double> all = j.transpose() * inverse * j;
  const vnl_vector<double> slope = j.transpose() * (inverse * r);
  const double             expected = dot_product(r, inverse * r) + std::log(vnl_determinant(k)) -
                          dot_product(slope, vnl_matrix_inverse<double>(all).inverse() * slope) +
                          std::log(vnl_determinant(all));
  // G is cut off at 2e-9, and the two orders of operations differ by rounding.
  EXPECT_NEAR(deviance, expected, 1e-5);
}

TEST(ContourNoiseModel, FactorWhitensResidualsAndJacobian)
{
  Strand strand(30);
  strand.Draw(1.0, 0.5, 4);
  std::vector<double> covariance(900);
  itk::ContourNoiseModel::ComputeCovariance(
    strand.correlation.data(), strand.weights.data(), 30, { 1.1, 0.5 }, covariance.data());
  const vnl_matrix<double> inverse =
    vnl_matrix_inverse<double>(vnl_matrix<double>(covariance.data(), 30, 30)).inverse();
  std::vector<double> factor = covariance;
  ASSERT_TRUE(itk::ContourNoiseModel::Factor(factor.data(), 30));
  for (std::size_t i = 0; i < 30; ++i)
  {
    for (std::size_t j = 0; j <= i; ++j)
    {
      double sum = 0.0;
      for (std::size_t k = 0; k <= j; ++k)
      {
        sum += factor[30 * k + i] * factor[30 * k + j];
      }
      EXPECT_NEAR(sum, covariance[30 * i + j], 1e-12) << "L L' = K, column by column";
    }
  }
  std::vector<double> columns = strand.jacobian;
  std::vector<double> residuals = strand.residuals;
  itk::ContourNoiseModel::Whiten(factor.data(), 30, columns.data(), 2);
  itk::ContourNoiseModel::Whiten(factor.data(), 30, residuals.data(), 1);
  const vnl_vector<double> r(strand.residuals.data(), 30);
  double                   squares = 0.0, cross = 0.0, dense = 0.0;
  const vnl_vector<double> solved = inverse * r;
  for (std::size_t i = 0; i < 30; ++i)
  {
    squares += residuals[i] * residuals[i];
    cross += columns[30 + i] * residuals[i];
    dense += strand.jacobian[30 + i] * solved[static_cast<unsigned int>(i)];
  }
  EXPECT_NEAR(squares, dot_product(r, solved), 1e-9 * squares);
  EXPECT_NEAR(cross, dense, 1e-9 * (1.0 + std::abs(dense)));
  itk::ContourNoiseModel::WhitenTransposed(factor.data(), 30, residuals.data(), 1);
  for (unsigned int i = 0; i < 30; ++i)
  {
    EXPECT_NEAR(residuals[i], solved[i], 1e-9 * solved.magnitude()) << "K^-1 r";
  }
  // A correlation of -1 and 1 at once is none.
  std::vector<double> wrong{ 1.0, 2.0, 2.0, 1.0 };
  EXPECT_FALSE(itk::ContourNoiseModel::Factor(wrong.data(), 2));
}

TEST(CorrelatedNoiseModel, BasicObjectMethodsAndDefaults)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  const auto model = itk::CorrelatedNoiseModel::New();
  EXPECT_EQ(model->GetCorrelationLength(), 14.0);
  model->SetCorrelationLength(-3.0);
  EXPECT_EQ(model->GetCorrelationLength(), 0.0);
}

TEST(ContourNoiseModel, FactorWithinABandGivesBackTheCovarianceAndWhitensWithIt)
{
  // As of a tracing in two parts: a band, with points in between that are correlated with nothing.
  constexpr std::size_t n = 37;
  std::vector<double>   covariance(n * n, 0.0);
  const auto            entry = [](std::size_t i, std::size_t j) {
    const std::size_t apart = i > j ? i - j : j - i;
    const bool        isAlone = (i > 17 && i < 22) || (j > 17 && j < 22);
    return i == j ? 2.5 : (apart > 6 || isAlone ? 0.0 : std::exp(-0.1 * static_cast<double>(apart * apart)));
  };
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = 0; j < n; ++j)
    {
      covariance[j * n + i] = entry(i, j);
    }
  }
  ASSERT_TRUE(itk::ContourNoiseModel::Factor(covariance.data(), n));
  std::vector<double> columns(2 * n);
  for (std::size_t i = 0; i < n; ++i)
  {
    columns[i] = std::sin(1.0 + static_cast<double>(i));
    columns[n + i] = static_cast<double>(i % 5) - 2.0;
    for (std::size_t j = 0; j <= i; ++j)
    {
      double product = 0.0;
      for (std::size_t k = 0; k <= j; ++k)
      {
        product += covariance[k * n + i] * covariance[k * n + j];
      }
      EXPECT_NEAR(product, entry(i, j), 1e-14) << i << ' ' << j;
    }
  }
  const std::vector<double> given = columns;
  itk::ContourNoiseModel::Whiten(covariance.data(), n, columns.data(), 2);
  for (std::size_t c = 0; c < 2; ++c)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      double product = 0.0;
      for (std::size_t k = 0; k <= i; ++k)
      {
        product += covariance[k * n + i] * columns[c * n + k];
      }
      EXPECT_NEAR(product, given[c * n + i], 1e-13) << c << ' ' << i;
    }
  }
  std::vector<double> indefinite{ 1.0, 2.0, 2.0, 1.0 };
  EXPECT_FALSE(itk::ContourNoiseModel::Factor(indefinite.data(), 2));
}

TEST(CorrelatedNoiseModel, IsTheCorrelationOfTheFlatFormula)
{
  const auto                model = itk::CorrelatedNoiseModel::New();
  const std::vector<double> arc{ 0.0, 3.0, 11.0, 40.0, 95.0 };
  const std::vector<double> ones(5, 1.0), zeros(5, 0.0);
  std::vector<double>       g(25);
  for (const double length : { 14.0, 5.0, 0.0 })
  {
    model->SetCorrelationLength(length);
    itk::ContourNoiseModel::ComputeCorrelation(arc.data(), ones.data(), zeros.data(), 5, length, g.data());
    for (std::size_t i = 0; i < 5; ++i)
    {
      for (std::size_t j = 0; j < 5; ++j)
      {
        EXPECT_NEAR(model->GetCorrelation(arc[i] - arc[j]), g[5 * i + j], 1e-15) << length;
      }
    }
    EXPECT_EQ(model->GetCorrelation(0.0), 1.0);
  }
}
