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
#include "itkDampedNormalEquations.h"

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace itk
{
class DampedNormalEquations::WorkspaceType
{
public:
  // H row by row, of which the lower triangle is used.
  std::vector<double> information;
  std::vector<double> gradient;
  // Eigen's own memory: aligned alike in every run, so that sums by packets are in the same order.
  Eigen::MatrixXd              matrix;
  Eigen::VectorXd              step;
  Eigen::LDLT<Eigen::MatrixXd> solver;
};

DampedNormalEquations::DampedNormalEquations()
  : m_Workspace(new WorkspaceType)
{}

DampedNormalEquations::~DampedNormalEquations() = default;

bool
DampedNormalEquations::Set(const double * residuals,
                           const double * jacobian,
                           std::size_t    numberOfResiduals,
                           std::size_t    numberOfParameters)
{
  m_Workspace->information.assign(numberOfParameters * numberOfParameters, 0.0);
  m_Workspace->gradient.assign(numberOfParameters, 0.0);
  double * const h = m_Workspace->information.data();
  double * const g = m_Workspace->gradient.data();
  for (std::size_t i = 0; i < numberOfResiduals; ++i)
  {
    const double * const row = jacobian + numberOfParameters * i;
    for (std::size_t a = 0; a < numberOfParameters; ++a)
    {
      const double derivative = row[a];
      g[a] += derivative * residuals[i];
      for (std::size_t b = 0; b <= a; ++b)
      {
        h[numberOfParameters * a + b] += derivative * row[b];
      }
    }
  }
  // Each derivative enters its square.
  bool finite = true;
  for (std::size_t a = 0; a < numberOfParameters; ++a)
  {
    finite = finite && std::isfinite(g[a]) && std::isfinite(h[numberOfParameters * a + a]);
  }
  return finite;
}

bool
DampedNormalEquations::Solve(double damping, double * step)
{
  const auto           count = static_cast<Eigen::Index>(m_Workspace->gradient.size());
  const double * const h = m_Workspace->information.data();
  Eigen::MatrixXd &    matrix = m_Workspace->matrix;
  Eigen::VectorXd &    solution = m_Workspace->step;
  constexpr double     ridge = 1e-9;
  matrix.resize(count, count);
  solution.resize(count);
  for (Eigen::Index a = 0; a < count; ++a)
  {
    solution[a] = m_Workspace->gradient[static_cast<std::size_t>(a)];
    for (Eigen::Index b = 0; b <= a; ++b)
    {
      const double value = h[count * a + b];
      matrix(a, b) = value;
      matrix(b, a) = value;
    }
    const double diagonal = matrix(a, a);
    matrix(a, a) = diagonal + damping * diagonal;
    matrix(a, a) += ridge;
  }
  m_Workspace->solver.compute(matrix);
  m_Workspace->solver.solveInPlace(solution);
  bool finite = true;
  for (Eigen::Index a = 0; a < count; ++a)
  {
    step[a] = -solution[a];
    finite = finite && std::isfinite(step[a]);
  }
  return finite;
}
} // namespace itk
