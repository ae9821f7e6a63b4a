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
#include "itkExchangedJawsHypothesis.h"

#include <utility>

namespace itk
{
std::string
ExchangedJawsHypothesis::GetCode() const
{
  return Code;
}

bool
ExchangedJawsHypothesis::IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const
{
  // The names of landmarks say their jaw: what is exchanged here are the tracings.
  return problem.jaws.size() == 2 && (problem.jaws[0].tracing.IsNotNull() || problem.jaws[1].tracing.IsNotNull()) &&
         result.score > problem.options.poorScore;
}

PoseProblem
ExchangedJawsHypothesis::Apply(const PoseProblem & problem) const
{
  // Enough to tell a fit from none: where this is tried nothing fits, and the verdict asks for a clear gain.
  constexpr unsigned int evaluations = 6;
  PoseProblem            other = problem;
  other.options = MakeQuickOptions(problem.options, evaluations);
  other.completed.reset();
  std::swap(other.jaws[0].tracing, other.jaws[1].tracing);
  for (PoseJawInput & jaw : other.jaws)
  {
    // What was called upper is the lower jaw, the frame stands on its head about x.
    jaw.initialPose.reset();
    jaw.landmarks = nullptr;
    jaw.jaw = jaw.jaw == ToothCode::JawEnum::Upper ? ToothCode::JawEnum::Lower : ToothCode::JawEnum::Upper;
    for (int k = 3; k < 9; ++k)
    {
      jaw.frame.rotation[k] = -jaw.frame.rotation[k];
    }
  }
  return other;
}
} // namespace itk
