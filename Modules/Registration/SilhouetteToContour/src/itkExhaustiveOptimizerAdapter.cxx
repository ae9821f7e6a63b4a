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
#include "itkExhaustiveOptimizerAdapter.h"

#include <algorithm>

namespace itk
{
ExhaustiveOptimizerAdapter::ExhaustiveOptimizerAdapter(OwnType * optimizer)
  : OptimizerAdapter(optimizer)
  , m_Own(optimizer)
  , m_SetScales(!optimizer->GetScalesInitialized())
{}

void
ExhaustiveOptimizerAdapter::SetNumberOfIterations(SizeValueType)
{}

void
ExhaustiveOptimizerAdapter::Prepare(const ParametersType & start,
                                    const ParametersType & lower,
                                    const ParametersType & upper)
{
  const auto & steps = m_Own->GetNumberOfSteps();
  if (steps.GetSize() != 4)
  {
    itkGenericExceptionMacro("ExhaustiveOptimizerv4 has " << steps.GetSize()
                                                          << " numbers of steps; call SetNumberOfSteps() with 4.");
  }
  if (m_SetScales)
  {
    OptimizerType::ScalesType scales(4);
    for (unsigned int i = 0; i < 4; ++i)
    {
      const double reach = std::min(upper[i] - start[i], start[i] - lower[i]);
      scales[i] = steps[i] > 0 ? reach / (steps[i] * m_Own->GetStepLength()) : 1.0;
    }
    m_Own->SetScales(scales);
  }
}

void
ExhaustiveOptimizerAdapter::Restore()
{
  if (m_SetScales)
  {
    m_Own->SetScales(OptimizerType::ScalesType());
  }
}
} // namespace itk
