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

#include "itkPoseStateBlocks.h"

#include <algorithm>
#include <utility>

namespace itk
{
std::string
ExchangedJawsHypothesis::GetCode() const
{
  return Code;
}

namespace
{
/** The names of landmarks say their jaw: what is exchanged here are the tracings. */
bool
CanExchange(const PoseProblem & problem)
{
  return problem.jaws.size() == 2 && (problem.jaws[0].tracing.IsNotNull() || problem.jaws[1].tracing.IsNotNull());
}
} // namespace

bool
ExchangedJawsHypothesis::IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const
{
  return CanExchange(problem) && result.score > problem.options.poorScore;
}

std::string
ExchangedJawsHypothesis::GetObstacle(const PoseProblem & problem) const
{
  if (!CanExchange(problem))
  {
    return "two jaws that share a pose, and a tracing of at least one of them, are needed";
  }
  for (const PoseProblemTerm & term : problem.terms)
  {
    const auto blocks = term.metric->DeclareBlocks();
    if (std::any_of(blocks.begin(), blocks.end(), [](const auto & block) {
          return block.name == PoseStateBlocks::MakePose().name;
        }))
    {
      return std::string("the added ") + term.metric->GetNameOfClass() +
             " is about the jaws' dental frame, which turns over with them";
    }
  }
  return "";
}

namespace
{
/** The crowns that were cut out of each scan, under the codes that its teeth have in the other jaw. The frame turns
 * over about x, and the patient's right of one is the left of the other. */
ToothCrownSet::Pointer
RenameCrowns(const ToothCrownSet & crowns)
{
  const auto renamed = ToothCrownSet::New();
  for (ToothCrownSet::CrownType crown : crowns.GetCrowns())
  {
    crown.tooth = crown.tooth.GetOpposing().GetContralateral();
    renamed->Add(crown);
  }
  return renamed;
}
} // namespace

PoseProblem
ExchangedJawsHypothesis::Apply(const PoseProblem & problem) const
{
  // Enough to tell a fit from none: where this is tried nothing fits, and the verdict asks for a clear gain.
  constexpr unsigned int evaluations = 6;
  PoseProblem            other = problem;
  other.options = MakeQuickOptions(problem.options, evaluations);
  other.completed.reset();
  std::swap(other.jaws[0].tracing, other.jaws[1].tracing);
  for (PoseViewInput & view : other.views)
  {
    // Tracings of a view are found by their jaw, which turns over below.
    view.landmarks = nullptr;
  }
  for (PoseJawInput & jaw : other.jaws)
  {
    // What was called upper is the lower jaw, the frame stands on its head about x.
    jaw.initialPose.reset();
    jaw.landmarks = nullptr;
    jaw.crowns = jaw.crowns.IsNull() ? nullptr : RenameCrowns(*jaw.crowns);
    jaw.jaw = OtherJaw(jaw.jaw);
    for (int k = 3; k < 9; ++k)
    {
      jaw.frame.rotation[k] = -jaw.frame.rotation[k];
    }
  }
  return other;
}
} // namespace itk
