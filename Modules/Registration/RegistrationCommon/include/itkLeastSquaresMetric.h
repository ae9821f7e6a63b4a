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
#ifndef itkLeastSquaresMetric_h
#define itkLeastSquaresMetric_h

#include "RegistrationCommonExport.h"

#include "itkIntTypes.h"
#include "itkOptimizerParameters.h"

#include "vnl/vnl_matrix.h"
#include "vnl/vnl_vector.h"

namespace itk
{
/** \class LeastSquaresMetric
 * \brief What a v4 metric offers beside its value when that value is, or is majorised by, a sum of squares.
 *
 * For LevenbergMarquardtOptimizerv4 and LeastSquaresMetricCostFunction. GetValue() of the metric is what a step has to
 * lower. Of a plain metric it is the sum of the squared residuals. Of a robust one it is the criterion of the robust
 * kernel; the residuals are then those whose sum of squares, with matches, weights and noise held at the current
 * position, has the step that lowers it (iteratively reweighted least squares). The Jacobian has the plus sign, unlike
 * a v4 metric's GetDerivative().
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT LeastSquaresMetric
{
public:
  using ParametersType = OptimizerParameters<double>;

  virtual ~LeastSquaresMetric() = default;

  /** Does not change while an optimizer runs. */
  virtual SizeValueType
  GetNumberOfResiduals() const = 0;

  /** Residuals at the metric's current position, and where not null, their derivatives: a row a residual, a column a
   * parameter. Sizes are set. */
  virtual void
  GetResiduals(vnl_vector<double> & residuals, vnl_matrix<double> * jacobian) const = 0;

  /** How far a step moves what is matched: the root mean square distance in the metric's own unit of length, for stop
   * rules that mean the same at any scale of the parameters. By default the norm of the difference. */
  virtual double
  GetStepLength(const ParametersType & from, const ParametersType & to) const;

  /** The longest step that an optimizer should take in each parameter, since the linearisation holds no further; empty
   * (default), or 0 for a parameter, is no limit. */
  virtual ParametersType
  GetMaximumSteps() const;
};
} // namespace itk

#endif
