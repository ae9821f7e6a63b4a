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
#ifndef itkDampedNormalEquations_h
#define itkDampedNormalEquations_h

#include <cstddef>
#include <memory>

namespace itk
{
/** \class DampedNormalEquations
 * \brief (J'J + damping diag(J'J) + 1e-9 I) step = -J'r, on plain arrays.
 *
 * A private header: the linear algebra of LevenbergMarquardtOptimizerv4, whose file includes ITK and so cannot include
 * Eigen. Sums run over the residuals in their order, so that the same input gives the same bits. Memory is kept while
 * the number of parameters stays.
 *
 * \ingroup RegistrationCommon
 */
class DampedNormalEquations
{
public:
  DampedNormalEquations();
  ~DampedNormalEquations();
  DampedNormalEquations(const DampedNormalEquations &) = delete;
  DampedNormalEquations &
  operator=(const DampedNormalEquations &) = delete;

  /** H = J'J and g = J'r; the Jacobian row by row. False where they are not finite: the factorisation would take what
   * is no number for a parameter that nothing observes. */
  bool
  Set(const double * residuals, const double * jacobian, std::size_t numberOfResiduals, std::size_t numberOfParameters);

  /** The step into numberOfParameters doubles; false where it is not finite. */
  bool
  Solve(double damping, double * step);

private:
  class WorkspaceType;
  std::unique_ptr<WorkspaceType> m_Workspace;
};
} // namespace itk

#endif
