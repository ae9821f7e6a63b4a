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
#ifndef itkForEachTerm_h
#define itkForEachTerm_h

#include "itkLeastSquaresSumMetricv4.h"

namespace itk
{
/** Not installed. Calls the function with each term of a kind in a metric, which may be such a term or a sum of sums,
 * and with its own position where the metric's is x. Here alone a term is asked what it is: a start for silhouettes has
 * no question that a prior could answer. */
template <typename TTerm, typename TFunction>
void
ForEachTerm(const LeastSquaresMetricv4 &               metric,
            const LeastSquaresMetricv4::PositionType & x,
            const TFunction &                          function)
{
  if (const auto * term = dynamic_cast<const TTerm *>(&metric))
  {
    function(*term, x);
  }
  else if (const auto * sum = dynamic_cast<const LeastSquaresSumMetricv4 *>(&metric))
  {
    for (SizeValueType t = 0; t < sum->GetNumberOfMetrics(); ++t)
    {
      ForEachTerm<TTerm>(*sum->GetMetric(t), sum->GetTermPosition(t, x), function);
    }
  }
}

/** The same where terms are to be changed and no position is asked for. */
template <typename TTerm, typename TFunction>
void
ForEachTerm(LeastSquaresMetricv4 & metric, const TFunction & function)
{
  if (auto * term = dynamic_cast<TTerm *>(&metric))
  {
    function(*term);
  }
  else if (auto * sum = dynamic_cast<LeastSquaresSumMetricv4 *>(&metric))
  {
    for (SizeValueType t = 0; t < sum->GetNumberOfMetrics(); ++t)
    {
      ForEachTerm<TTerm>(*sum->GetMetric(t), function);
    }
  }
}
} // namespace itk

#endif
