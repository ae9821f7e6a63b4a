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

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace itk
{
namespace
{
/** Log-normal priors of the two levels, px of 0.25 mm: about their middle, and this wide in the logarithm, a factor of
 * 2.2 either way. They lie between the phantom's typical hand (drift 1.2, jitter 0.5 px) and its hard one (2.2 and 1;
 * Documentation/Phantom.md). Some dozens of points outweigh them; they keep a short tracing, which cannot tell the
 * levels, from a level of 0 or without end. */
constexpr double PriorSmooth = 1.5;
constexpr double PriorWhite = 0.7;
constexpr double PriorLogSigma = 0.8;
// The simplex search in the logarithms of the levels.
/** px: a start at 0 has no logarithm. */
constexpr double SmallestStart = 1e-3;
/** First edge, a factor of 1.6: less than the priors are wide, and more than the estimate moves between two calls. */
constexpr double SimplexEdge = 0.5;
/** Ends where the deviance differs by less over the simplex: odds of 1.00005, of no concern to any fit. */
constexpr double Tolerance = 1e-4;
/** Far more than the some twenty that two parameters take. */
constexpr int MaximumIterations = 60;

/** A block in the eigenvectors of W^1/2 G W^1/2, where both parts of the covariance are diagonal. */
struct DiagonalBlock
{
  Eigen::VectorXd eigenvalues;
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;
  double          logWeights{ 0.0 };
};

double
Deviance(const std::vector<DiagonalBlock> & blocks,
         const Eigen::MatrixXd &            fixedInformation,
         const Eigen::VectorXd &            fixedGradient,
         double                             fixedValue,
         double                             smooth2,
         double                             white2)
{
  const Eigen::Index p = fixedGradient.size();
  Eigen::MatrixXd    information = fixedInformation;
  Eigen::VectorXd    gradient = fixedGradient;
  double             value = fixedValue;
  for (const DiagonalBlock & block : blocks)
  {
    const Eigen::ArrayXd  variance = (smooth2 * block.eigenvalues.array().max(0.0) + white2).max(1e-12);
    const Eigen::MatrixXd scaled = block.jacobian.array().colwise() / variance;
    information.noalias() += scaled.transpose() * block.jacobian;
    gradient.noalias() += scaled.transpose() * block.residual;
    value += (block.residual.array().square() / variance).sum() + variance.log().sum() - block.logWeights;
  }
  const Eigen::LDLT<Eigen::MatrixXd> solver(information);
  value -= gradient.dot(solver.solve(gradient));
  for (Eigen::Index i = 0; i < p; ++i)
  {
    value += std::log(std::max(solver.vectorD()[i], 1e-300));
  }
  return value;
}

/** Of each column of a lower triangle, column by column, behind which row it has nothing but zeros, nor has any column
 * before it. */
std::vector<std::size_t>
ColumnEnds(const double * triangle, std::size_t count)
{
  std::vector<std::size_t> ends(count);
  std::size_t              end = 0;
  for (std::size_t j = 0; j < count; ++j)
  {
    const double * const column = triangle + j * count;
    std::size_t          last = count;
    while (last > std::max(end, j + 1) && column[last - 1] == 0.0)
    {
      --last;
    }
    end = std::max(end, last);
    ends[j] = end;
  }
  return ends;
}
} // namespace

void
ContourNoiseModel::ComputeCorrelation(
  const double * arc, const double * nu, const double * nv, std::size_t count, double length, double * correlation)
{
  const double scale = length > 0.0 ? 0.5 / (length * length) : 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    correlation[i * count + i] = 1.0;
    for (std::size_t j = 0; j < i; ++j)
    {
      const double d = arc[i] - arc[j];
      const double rho =
        length > 0.0 && d * d * scale < 20.0 ? std::exp(-d * d * scale) * (nu[i] * nu[j] + nv[i] * nv[j]) : 0.0;
      correlation[i * count + j] = rho;
      correlation[j * count + i] = rho;
    }
  }
}

void
ContourNoiseModel::ComputeCovariance(const double *             correlation,
                                     const double *             weights,
                                     std::size_t                count,
                                     const ContourNoiseLevels & levels,
                                     double *                   covariance)
{
  const double smooth2 = levels.smooth * levels.smooth;
  for (std::size_t k = 0; k < count * count; ++k)
  {
    covariance[k] = smooth2 * correlation[k];
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    covariance[i * count + i] += levels.white * levels.white / std::max(weights[i], 1e-6);
  }
}

ContourNoiseLevels
ContourNoiseModel::Estimate(const std::vector<BlockType> & blocks,
                            const double *                 precisionOfParameters,
                            const double *                 offsetOfParameters,
                            std::size_t                    numberOfParameters,
                            const ContourNoiseLevels &     start,
                            double *                       deviance)
{
  const auto            p = static_cast<Eigen::Index>(numberOfParameters);
  const Eigen::VectorXd precision = Eigen::Map<const Eigen::VectorXd>(precisionOfParameters, p);
  const Eigen::VectorXd offset = Eigen::Map<const Eigen::VectorXd>(offsetOfParameters, p);
  const Eigen::MatrixXd information = precision.asDiagonal();
  const Eigen::VectorXd gradient = precision.cwiseProduct(offset);
  return Estimate(
    blocks, information.data(), gradient.data(), offset.dot(gradient), numberOfParameters, start, deviance);
}

ContourNoiseLevels
ContourNoiseModel::Estimate(const std::vector<BlockType> & blocks,
                            const double *                 fixedInformation,
                            const double *                 fixedGradient,
                            double                         fixedValue,
                            std::size_t                    numberOfParameters,
                            const ContourNoiseLevels &     start,
                            double *                       deviance)
{
  const auto                 p = static_cast<Eigen::Index>(numberOfParameters);
  const Eigen::MatrixXd      information = Eigen::Map<const Eigen::MatrixXd>(fixedInformation, p, p);
  const Eigen::VectorXd      gradient = Eigen::Map<const Eigen::VectorXd>(fixedGradient, p);
  std::vector<DiagonalBlock> diagonal;
  for (const BlockType & block : blocks)
  {
    const auto                              count = static_cast<Eigen::Index>(block.count);
    const Eigen::Map<const Eigen::MatrixXd> correlation(block.correlation, count, count);
    const Eigen::Map<const Eigen::VectorXd> weight(block.weights, count);
    const Eigen::Map<const Eigen::VectorXd> residual(block.residuals, count);
    const Eigen::Map<const Eigen::MatrixXd> jacobian(block.jacobian, count, p);
    // Points without weight say nothing: leave them out before the decomposition, which is the costly part.
    std::vector<Eigen::Index> used;
    for (Eigen::Index i = 0; i < count; ++i)
    {
      if (weight[i] > 1e-4)
      {
        used.push_back(i);
      }
    }
    const Eigen::Index n = static_cast<Eigen::Index>(used.size());
    if (n == 0)
    {
      continue;
    }
    Eigen::MatrixXd g(n, n);
    Eigen::VectorXd r(n);
    Eigen::MatrixXd j(n, p);
    DiagonalBlock   d;
    for (Eigen::Index a = 0; a < n; ++a)
    {
      const double root = std::sqrt(weight[used[a]]);
      r[a] = root * residual[used[a]];
      j.row(a) = root * jacobian.row(used[a]);
      d.logWeights += 2.0 * std::log(root);
      for (Eigen::Index b = 0; b < n; ++b)
      {
        g(a, b) = root * correlation(used[a], used[b]) * std::sqrt(weight[used[b]]);
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(g);
    d.eigenvalues = solver.eigenvalues();
    d.residual = solver.eigenvectors().transpose() * r;
    d.jacobian = solver.eigenvectors().transpose() * j;
    diagonal.push_back(std::move(d));
  }
  const auto value = [&](const std::array<double, 2> & x) {
    const double a = (x[0] - std::log(PriorSmooth)) / PriorLogSigma;
    const double b = (x[1] - std::log(PriorWhite)) / PriorLogSigma;
    return Deviance(diagonal, information, gradient, fixedValue, std::exp(2.0 * x[0]), std::exp(2.0 * x[1])) + a * a +
           b * b;
  };
  // Nelder-Mead with an explicit first simplex.
  using Vertex = std::pair<double, std::array<double, 2>>;
  const double          s0 = std::log(std::max(start.smooth, SmallestStart));
  const double          w0 = std::log(std::max(start.white, SmallestStart));
  std::array<Vertex, 3> simplex;
  simplex[0].second = { { s0, w0 } };
  simplex[1].second = { { s0 + SimplexEdge, w0 } };
  simplex[2].second = { { s0, w0 - SimplexEdge } };
  for (Vertex & vertex : simplex)
  {
    vertex.first = value(vertex.second);
  }
  const auto order = [](const Vertex & a, const Vertex & b) { return a.first < b.first; };
  for (int iteration = 0; iteration < MaximumIterations; ++iteration)
  {
    std::stable_sort(simplex.begin(), simplex.end(), order);
    if (simplex[2].first - simplex[0].first < Tolerance)
    {
      break;
    }
    const std::array<double, 2> middle{ { 0.5 * (simplex[0].second[0] + simplex[1].second[0]),
                                          0.5 * (simplex[0].second[1] + simplex[1].second[1]) } };
    const auto                  along = [&](double t) {
      Vertex vertex;
      vertex.second = { { middle[0] + t * (simplex[2].second[0] - middle[0]),
                          middle[1] + t * (simplex[2].second[1] - middle[1]) } };
      vertex.first = value(vertex.second);
      return vertex;
    };
    const Vertex reflected = along(-1.0);
    if (reflected.first < simplex[0].first)
    {
      const Vertex expanded = along(-2.0);
      simplex[2] = expanded.first < reflected.first ? expanded : reflected;
    }
    else if (reflected.first < simplex[1].first)
    {
      simplex[2] = reflected;
    }
    else
    {
      const Vertex contracted = along(reflected.first < simplex[2].first ? -0.5 : 0.5);
      if (contracted.first < std::min(simplex[2].first, reflected.first))
      {
        simplex[2] = contracted;
      }
      else
      {
        for (int k = 1; k < 3; ++k)
        {
          for (int c = 0; c < 2; ++c)
          {
            simplex[k].second[c] = 0.5 * (simplex[k].second[c] + simplex[0].second[c]);
          }
          simplex[k].first = value(simplex[k].second);
        }
      }
    }
  }
  std::stable_sort(simplex.begin(), simplex.end(), order);
  const ContourNoiseLevels noise{ std::exp(simplex[0].second[0]), std::exp(simplex[0].second[1]) };
  if (deviance != nullptr)
  {
    *deviance =
      Deviance(diagonal, information, gradient, fixedValue, noise.smooth * noise.smooth, noise.white * noise.white);
  }
  return noise;
}

bool
ContourNoiseModel::Factor(double * covariance, std::size_t count)
{
  // Noise is correlated over a part of a tracing, and the factor has no entries where the covariance has none before
  // them in the row: column by column, each takes what those before it that reach it leave over.
  const std::vector<std::size_t> ends = ColumnEnds(covariance, count);
  // Columns are taken off four at a time: one pass over memory instead of four.
  std::size_t first = 0;
  for (std::size_t j = 0; j < count; ++j)
  {
    double * const column = covariance + j * count;
    while (ends[first] <= j)
    {
      ++first;
    }
    std::size_t k = first;
    for (; k + 4 <= j; k += 4)
    {
      const double * const a = covariance + k * count;
      const double * const b = a + count;
      const double * const c = b + count;
      const double * const d = c + count;
      const double         fa = a[j];
      const double         fb = b[j];
      const double         fc = c[j];
      const double         fd = d[j];
      for (std::size_t i = j; i < ends[k + 3]; ++i)
      {
        column[i] -= fa * a[i] + fb * b[i] + (fc * c[i] + fd * d[i]);
      }
    }
    for (; k < j; ++k)
    {
      const double * const a = covariance + k * count;
      const double         fa = a[j];
      for (std::size_t i = j; i < ends[k]; ++i)
      {
        column[i] -= fa * a[i];
      }
    }
    if (!(column[j] > 0.0))
    {
      return false;
    }
    const double diagonal = std::sqrt(column[j]);
    const double inverse = 1.0 / diagonal;
    column[j] = diagonal;
    for (std::size_t i = j + 1; i < ends[j]; ++i)
    {
      column[i] *= inverse;
    }
  }
  return true;
}

void
ContourNoiseModel::Whiten(const double * factor, std::size_t count, double * columns, std::size_t numberOfColumns)
{
  const std::vector<std::size_t> ends = ColumnEnds(factor, count);
  for (std::size_t j = 0; j < count; ++j)
  {
    const double * const l = factor + j * count;
    for (std::size_t c = 0; c < numberOfColumns; ++c)
    {
      double * const x = columns + c * count;
      x[j] /= l[j];
      const double value = x[j];
      for (std::size_t i = j + 1; i < ends[j]; ++i)
      {
        x[i] -= value * l[i];
      }
    }
  }
}

void
ContourNoiseModel::WhitenTransposed(const double * factor,
                                    std::size_t    count,
                                    double *       columns,
                                    std::size_t    numberOfColumns)
{
  const auto                              n = static_cast<Eigen::Index>(count);
  const Eigen::Map<const Eigen::MatrixXd> l(factor, n, n);
  Eigen::Map<Eigen::MatrixXd>             x(columns, n, static_cast<Eigen::Index>(numberOfColumns));
  l.transpose().triangularView<Eigen::Upper>().solveInPlace(x);
}
} // namespace itk
