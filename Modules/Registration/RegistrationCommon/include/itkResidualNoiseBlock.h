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
#ifndef itkResidualNoiseBlock_h
#define itkResidualNoiseBlock_h

#include "itkResidualNoiseModel.h"

#include <cstddef>
#include <vector>

namespace itk
{
/** \struct ResidualNoiseBlock
 * \brief Residuals of one strand whose noise levels are to be estimated, before any weighting by these levels.
 * \ingroup RegistrationCommon
 */
struct ResidualNoiseBlock
{
  /** Blocks with the same model have the same levels. */
  const ResidualNoiseModel * model{ nullptr };
  std::size_t                count{ 0 };
  /** G, count x count. */
  std::vector<double> correlation;
  /** Robust weight times the weight that the tracing gives, one a residual. */
  std::vector<double> weights;
  std::vector<double> residuals;
  /** count rows, a column a parameter of the metric (held ones included, natural units), column by column. */
  std::vector<double> jacobian;
};
} // namespace itk

#endif
