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
#include "itkOtherSideHypothesis.h"

namespace itk
{
std::string
OtherSideHypothesis::GetCode() const
{
  return Code;
}

bool
OtherSideHypothesis::IsWorthTrying(const PoseProblem & problem, const PoseGroupResult &) const
{
  const PoseRegistrationOptions & options = problem.options;
  return options.useSideSelection &&
         (options.tracedSide == TracedSideEnum::Right || options.tracedSide == TracedSideEnum::Left);
}

std::string
OtherSideHypothesis::GetObstacle(const PoseProblem & problem) const
{
  return this->IsWorthTrying(problem, PoseGroupResult())
           ? ""
           : "the tracing is of no side that could be the other one, or useSideSelection is off";
}

PoseProblem
OtherSideHypothesis::Apply(const PoseProblem & problem) const
{
  // More than for a fit that is clear: likelihoods of two good fits are compared. Sides differ by a shift and little
  // yaw, so that three starts from yaw 0 find the place.
  constexpr unsigned int evaluations = 8;
  PoseProblem            other = problem;
  other.options = MakeQuickOptions(problem.options, evaluations);
  other.options.startsPerYaw = 3;
  other.options.tracedSide =
    problem.options.tracedSide == TracedSideEnum::Right ? TracedSideEnum::Left : TracedSideEnum::Right;
  for (PoseJawInput & jaw : other.jaws)
  {
    jaw.initialPose.reset();
  }
  return other;
}
} // namespace itk
