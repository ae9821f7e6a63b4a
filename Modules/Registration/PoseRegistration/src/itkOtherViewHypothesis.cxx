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
#include "itkOtherViewHypothesis.h"

#include <algorithm>

namespace itk
{
std::string
OtherViewHypothesis::MakeCode(QuestionEnum question, const std::string & view)
{
  switch (question)
  {
    case QuestionEnum::Sides:
      return "view-sides:" + view;
    case QuestionEnum::Source:
      return "view-source:" + view;
    default:
      return "view-head-moved:" + view;
  }
}

std::string
OtherViewHypothesis::GetCode() const
{
  return MakeCode(m_Question, m_View);
}

bool
OtherViewHypothesis::IsWorthTrying(const PoseProblem & problem, const PoseGroupResult &) const
{
  const auto found = std::find_if(
    problem.views.begin(), problem.views.end(), [this](const PoseViewInput & view) { return view.name == m_View; });
  if (found == problem.views.end())
  {
    // It is an obstacle, and said as one.
    return true;
  }
  const PoseViewInput & view = *found;
  // Few landmarks beside a long tracing hardly show in a score: always, as it costs no search.
  if (m_Question == QuestionEnum::Head && !view.sameHeadPosition)
  {
    return false;
  }
  // What the view says of another group's jaw alone, it cannot say of these.
  return std::any_of(problem.jaws.begin(), problem.jaws.end(), [&view](const PoseJawInput & input) {
    const auto * const counterparts = view.counterparts.GetPointer();
    const auto         isOfJaw = [&input](const auto & counterpart) { return counterpart.jaw == input.jaw; };
    return view.tracings[input.jaw == ToothCode::JawEnum::Upper ? 0 : 1].IsNotNull() ||
           (counterparts != nullptr &&
            std::any_of(counterparts->GetCounterparts().begin(), counterparts->GetCounterparts().end(), isOfJaw));
  });
}

std::string
OtherViewHypothesis::GetObstacle(const PoseProblem & problem) const
{
  const bool isThere = std::any_of(
    problem.views.begin(), problem.views.end(), [this](const PoseViewInput & view) { return view.name == m_View; });
  return isThere ? "" : "there is no view \"" + m_View + "\"";
}

PoseProblem
OtherViewHypothesis::Apply(const PoseProblem & problem) const
{
  PoseProblem other = problem;
  other.options.checkHypotheses = false;
  for (PoseViewInput & view : other.views)
  {
    if (view.name != m_View)
    {
      continue;
    }
    if (m_Question == QuestionEnum::Head)
    {
      view.sameHeadPosition = false;
    }
    else
    {
      double & sign = m_Question == QuestionEnum::Sides ? view.geometry.facingSign : view.geometry.sourceSign;
      sign = -sign;
    }
  }
  for (PoseJawInput & jaw : other.jaws)
  {
    jaw.initialPose.reset();
  }
  return other;
}

void
OtherViewHypothesis::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Question: " << MakeCode(m_Question, m_View) << std::endl;
  os << indent << "View: " << m_View << std::endl;
}
} // namespace itk
