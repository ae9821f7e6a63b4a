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
#ifndef itkContourNoiseReference_h
#define itkContourNoiseReference_h

#include "vnl/algo/vnl_determinant.h"
#include "vnl/algo/vnl_matrix_inverse.h"
#include "vnl/vnl_matrix.h"
#include "vnl/vnl_vector.h"

#include <algorithm>
#include <cmath>
#include <vector>

/** The noise of a tracing as the documentation of ContourNoiseModel writes it, with dense matrices. */
namespace ContourNoiseReference
{
struct Strand
{
  std::vector<double> arc;
  std::vector<double> nu;
  std::vector<double> nv;
  std::vector<double> weights;
  vnl_vector<double>  residuals;
  /** A row a residual. */
  vnl_matrix<double> jacobian;
};

struct Levels
{
  double smooth;
  double white;
};

/** K = smooth^2 G + white^2 W^-1 */
inline vnl_matrix<double>
Covariance(const Strand & strand, double length, const Levels & levels)
{
  const auto         n = static_cast<unsigned int>(strand.arc.size());
  vnl_matrix<double> k(n, n);
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int j = 0; j < n; ++j)
    {
      const double d = (strand.arc[i] - strand.arc[j]) / length;
      const double cosine = strand.nu[i] * strand.nu[j] + strand.nv[i] * strand.nv[j];
      k(i, j) = levels.smooth * levels.smooth * std::exp(-0.5 * d * d) * cosine;
    }
    k(i, i) += levels.white * levels.white / strand.weights[i];
  }
  return k;
}

/** The strand without its points of no weight. */
inline Strand
Used(const Strand & strand)
{
  std::vector<unsigned int> ids;
  for (unsigned int i = 0; i < strand.arc.size(); ++i)
  {
    if (strand.weights[i] > 0.0)
    {
      ids.push_back(i);
    }
  }
  Strand     used;
  const auto n = static_cast<unsigned int>(ids.size());
  used.residuals.set_size(n);
  used.jacobian.set_size(n, strand.jacobian.cols());
  for (unsigned int i = 0; i < n; ++i)
  {
    used.arc.push_back(strand.arc[ids[i]]);
    used.nu.push_back(strand.nu[ids[i]]);
    used.nv.push_back(strand.nv[ids[i]]);
    used.weights.push_back(strand.weights[ids[i]]);
    used.residuals[i] = strand.residuals[ids[i]];
    used.jacobian.set_row(i, strand.jacobian.get_row(ids[i]));
  }
  return used;
}

/** Minus twice the restricted log likelihood: the parameters, near the estimate, integrated out under their prior. */
inline double
Deviance(const std::vector<Strand> & strands,
         double                      length,
         const vnl_vector<double> &  precision,
         const vnl_vector<double> &  offset,
         const Levels &              levels)
{
  const unsigned int p = precision.size();
  vnl_matrix<double> information(p, p, 0.0);
  vnl_vector<double> gradient(p, 0.0);
  double             value = 0.0;
  for (unsigned int a = 0; a < p; ++a)
  {
    information(a, a) = precision[a];
    gradient[a] = precision[a] * offset[a];
    value += precision[a] * offset[a] * offset[a];
  }
  for (const Strand & all : strands)
  {
    const Strand             strand = Used(all);
    const vnl_matrix<double> k = Covariance(strand, length, levels);
    const vnl_matrix<double> inverse = vnl_matrix_inverse<double>(k).inverse();
    information += strand.jacobian.transpose() * inverse * strand.jacobian;
    gradient += strand.jacobian.transpose() * (inverse * strand.residuals);
    value += dot_product(strand.residuals, inverse * strand.residuals) + std::log(vnl_determinant(k));
  }
  return value + std::log(vnl_determinant(information)) -
         dot_product(gradient, vnl_matrix_inverse<double>(information).inverse() * gradient);
}

/** What the estimated levels minimise: the deviance and the log-normal priors around 1.5 and 0.7 px, 0.8 wide. */
inline double
Objective(const std::vector<Strand> & strands,
          double                      length,
          const vnl_vector<double> &  precision,
          const vnl_vector<double> &  offset,
          const Levels &              levels)
{
  const double a = std::log(levels.smooth / 1.5) / 0.8;
  const double b = std::log(levels.white / 0.7) / 0.8;
  return Deviance(strands, length, precision, offset, levels) + a * a + b * b;
}

/** Its minimum by a pattern search in the logarithms, to 1e-4 of the levels. */
inline Levels
Minimise(const std::vector<Strand> & strands,
         double                      length,
         const vnl_vector<double> &  precision,
         const vnl_vector<double> &  offset)
{
  Levels best{ 1.0, 1.0 };
  double least = Objective(strands, length, precision, offset, best);
  for (double step = 0.4; step > 1e-4;)
  {
    bool better = false;
    for (const auto & move : { Levels{ 1.0, 0.0 }, { -1.0, 0.0 }, { 0.0, 1.0 }, { 0.0, -1.0 } })
    {
      const Levels trial{ best.smooth * std::exp(step * move.smooth), best.white * std::exp(step * move.white) };
      const double value = Objective(strands, length, precision, offset, trial);
      if (value < least)
      {
        least = value;
        best = trial;
        better = true;
      }
    }
    step = better ? step : 0.5 * step;
  }
  return best;
}
} // namespace ContourNoiseReference

#endif
