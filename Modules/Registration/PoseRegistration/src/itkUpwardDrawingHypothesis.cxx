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
#include "itkUpwardDrawingHypothesis.h"

#include "itkAddedRadiograph.h"
#include "itkMoveDrawing.h"

#include <algorithm>

namespace itk
{
std::string
UpwardDrawingHypothesis::GetCode() const
{
  return Code;
}

bool
UpwardDrawingHypothesis::IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const
{
  // A few landmarks, or outlines of four teeth, are not told from exchanged names.
  return result.score > problem.options.poorScore && problem.options.tracedSide != TracedSideEnum::Standard &&
         std::any_of(
           problem.jaws.begin(), problem.jaws.end(), [](const PoseJawInput & jaw) { return jaw.tracing.IsNotNull(); });
}

std::string
UpwardDrawingHypothesis::GetObstacle(const PoseProblem & problem) const
{
  return DescribeAddedRadiograph(problem, "was drawn on a radiograph of its own");
}

PoseProblem
UpwardDrawingHypothesis::Apply(const PoseProblem & problem) const
{
  // Enough to tell a fit from none, as for the other facing: the verdict asks for a clear gain.
  constexpr unsigned int evaluations = 6;
  PoseProblem            other = problem;
  other.options = MakeQuickOptions(problem.options, evaluations);
  // In mm as often as in pixels.
  other.nominal.pixelSpacingKnown = false;
  MoveDrawing(other, [](Point<double, 2> point) {
    point[1] = -point[1];
    return point;
  });
  return other;
}
} // namespace itk
