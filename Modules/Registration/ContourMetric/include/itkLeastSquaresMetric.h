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

#include "ContourMetricExport.h"

#include "itkIntTypes.h"

#include "vnl/vnl_matrix.h"
#include "vnl/vnl_vector.h"

namespace itk
{
/** \class LeastSquaresMetric
 * \brief What a v4 metric offers beside its value when that value is a sum of squares.
 *
 * For LevenbergMarquardtOptimizerv4 and LeastSquaresMetricCostFunction. Within the bounds that a metric may have, the
 * sum of the squared residuals is GetValue(). The Jacobian has the plus sign, unlike a v4 metric's GetDerivative().
 *
 * \ingroup ContourMetric
 */
class ContourMetric_EXPORT LeastSquaresMetric
{
public:
  virtual ~LeastSquaresMetric() = default;

  /** Does not change while an optimizer runs. */
  virtual SizeValueType
  GetNumberOfResiduals() const = 0;

  /** Residuals at the metric's current position, and where not null, their derivatives: a row a residual, a column a
   * parameter. Sizes are set. */
  virtual void
  GetResiduals(vnl_vector<double> & residuals, vnl_matrix<double> * jacobian) const = 0;
};
} // namespace itk

#endif
