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
#include "itkOtherFacingHypothesis.h"

#include "itkAddedRadiograph.h"


namespace itk
{
std::string
OtherFacingHypothesis::GetCode() const
{
  return Code;
}

bool
OtherFacingHypothesis::IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const
{
  return result.score > problem.options.poorScore;
}

std::string
OtherFacingHypothesis::GetObstacle(const PoseProblem & problem) const
{
  return DescribeAddedRadiograph(problem, "has a radiograph with a facing of its own");
}

PoseProblem
OtherFacingHypothesis::Apply(const PoseProblem & problem) const
{
  // Enough to tell a fit from none: where this is tried nothing fits, and the verdict asks for a clear gain.
  constexpr unsigned int evaluations = 6;
  PoseProblem            other = problem;
  other.options = MakeQuickOptions(problem.options, evaluations);
  other.completed.reset();
  other.nominal.facingSign = -problem.nominal.facingSign;
  for (PoseJawInput & jaw : other.jaws)
  {
    jaw.initialPose.reset();
  }
  return other;
}
} // namespace itk
