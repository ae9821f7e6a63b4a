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
#include "itkLBFGSBOptimizerAdapter.h"

#include <algorithm>
#include <mutex>
#include <sstream>

namespace itk
{
namespace
{
Array<double>
MakeArray(const OptimizerParameters<double> & parameters)
{
  Array<double> array(parameters.GetSize());
  std::copy(parameters.begin(), parameters.end(), array.begin());
  return array;
}

/** ITK's LBFGSB keeps its state in static variables of netlib's code: two at a time in one process disturb each other.
 */
std::recursive_mutex &
OneAtATime()
{
  static std::recursive_mutex mutex;
  return mutex;
}
} // namespace

LBFGSBOptimizerAdapter::LBFGSBOptimizerAdapter(OwnType * optimizer)
  : OptimizerAdapter(optimizer)
  , m_Own(optimizer)
{}

void
LBFGSBOptimizerAdapter::Prepare(const ParametersType & start,
                                const ParametersType & lower,
                                const ParametersType & upper)
{
  LBFGSBOptimizerv4::BoundSelectionType selection(4);
  selection.Fill(LBFGSBOptimizerv4::BOTHBOUNDED);
  m_Own->SetLowerBound(MakeArray(lower));
  m_Own->SetUpperBound(MakeArray(upper));
  m_Own->SetBoundSelection(selection);
  m_Own->SetInitialPosition(start);
}

std::string
LBFGSBOptimizerAdapter::Start()
{
  {
    const std::lock_guard<std::recursive_mutex> lock(OneAtATime());
    m_Own->StartOptimization();
  }
  if (m_Own->GetCurrentIteration() >= m_Own->GetNumberOfIterations())
  {
    // ITK's text for it is "User requested".
    std::ostringstream text;
    text << m_Own->GetNameOfClass() << ": Maximum number of iterations (" << m_Own->GetNumberOfIterations()
         << ") reached.";
    return text.str();
  }
  return m_Own->GetStopConditionDescription();
}
} // namespace itk
