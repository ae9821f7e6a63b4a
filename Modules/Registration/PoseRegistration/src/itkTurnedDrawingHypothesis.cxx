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
#include "itkTurnedDrawingHypothesis.h"

#include "itkAddedRadiograph.h"
#include "itkMoveDrawing.h"


#include <algorithm>
#include <utility>

namespace itk
{
namespace
{
/** Quarter turns clockwise, as it is seen (u to the right, v down), about the first pixel: where to is the start's to
 * find. */
Point<double, 2>
Turn(Point<double, 2> point, unsigned int quarterTurns)
{
  for (unsigned int i = 0; i < quarterTurns; ++i)
  {
    const double u = point[0];
    point[0] = -point[1];
    point[1] = u;
  }
  return point;
}
} // namespace

void
TurnedDrawingHypothesis::SetQuarterTurns(unsigned int turns)
{
  if (turns < 1 || turns > 3)
  {
    itkExceptionMacro("SetQuarterTurns() takes 1, 2 or 3, not " << turns << '.');
  }
  if (m_QuarterTurns != turns)
  {
    m_QuarterTurns = turns;
    this->Modified();
  }
}

std::string
TurnedDrawingHypothesis::GetCode() const
{
  return Code + std::to_string(90 * m_QuarterTurns);
}

bool
TurnedDrawingHypothesis::IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const
{
  // A few landmarks, or outlines of four teeth, fit a turned jaw as well as a right one where one of them is a gross
  // error; a row of crowns does not.
  return result.score > problem.options.poorScore && problem.options.tracedSide != TracedSideEnum::Standard &&
         std::any_of(
           problem.jaws.begin(), problem.jaws.end(), [](const PoseJawInput & jaw) { return jaw.tracing.IsNotNull(); });
}

std::string
TurnedDrawingHypothesis::GetObstacle(const PoseProblem & problem) const
{
  return DescribeAddedRadiograph(problem, "was drawn on a radiograph of its own");
}

PoseProblem
TurnedDrawingHypothesis::Apply(const PoseProblem & problem) const
{
  // Enough to tell a fit from none, as for the other facing.
  constexpr unsigned int evaluations = 6;
  PoseProblem            other = problem;
  other.options = MakeQuickOptions(problem.options, evaluations);
  if (m_QuarterTurns != 2)
  {
    std::swap(other.nominal.pixelSpacing[0], other.nominal.pixelSpacing[1]);
  }
  MoveDrawing(other, [this](const Point<double, 2> & point) { return Turn(point, m_QuarterTurns); });
  return other;
}

void
TurnedDrawingHypothesis::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "QuarterTurns: " << m_QuarterTurns << std::endl;
}
} // namespace itk
