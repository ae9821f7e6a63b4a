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
#include "itkAmoebaOptimizerAdapter.h"

#include <typeinfo>

namespace itk
{
AmoebaOptimizerAdapter::AmoebaOptimizerAdapter(OwnType * optimizer)
  : OptimizerAdapter(optimizer)
  , m_Own(optimizer)
  , m_SetSimplex(optimizer->GetAutomaticInitialSimplex())
{}

void
AmoebaOptimizerAdapter::Prepare(const ParametersType &, const ParametersType & lower, const ParametersType & upper)
{
  if (m_SetSimplex)
  {
    ParametersType simplex(4);
    for (unsigned int i = 0; i < 4; ++i)
    {
      simplex[i] = 0.125 * (upper[i] - lower[i]);
    }
    m_Own->SetInitialSimplexDelta(simplex, false);
  }
}

bool
AmoebaOptimizerAdapter::IsIteration(const EventObject & event) const
{
  return OptimizerAdapter::IsIteration(event) || typeid(event) == typeid(FunctionEvaluationIterationEvent);
}

void
AmoebaOptimizerAdapter::Restore()
{
  if (m_SetSimplex)
  {
    m_Own->AutomaticInitialSimplexOn();
  }
}
} // namespace itk
