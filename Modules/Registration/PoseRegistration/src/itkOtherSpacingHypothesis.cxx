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
#include "itkOtherSpacingHypothesis.h"

#include "itkAddedRadiograph.h"


#include <algorithm>

namespace itk
{
std::string
OtherSpacingHypothesis::GetCode() const
{
  return Code;
}

namespace
{
/** Four marks of two jaws in one frame have eight coordinates, of which a pose and a scale take five: fewer fit at any
 * scale. */
constexpr std::size_t MinimumNumberOfLandmarks = 4;
/** Standard deviations of the scale's prior: one case of 20 with a right spacing has more. */
constexpr double LeaningOnScale = 2.0;

bool
HasEnoughLandmarks(const PoseProblem & problem)
{
  std::size_t count = 0;
  for (const PoseJawInput & jaw : problem.jaws)
  {
    if (jaw.landmarks.IsNull() || jaw.counterparts.IsNull())
    {
      return false;
    }
    // Each jaw is given the marks of both, and some have no place on a scan.
    const auto & marks = jaw.landmarks->GetLandmarks();
    count += static_cast<std::size_t>(std::count_if(marks.begin(), marks.end(), [&](const auto & mark) {
      return mark.meaning.jaw == jaw.jaw &&
             jaw.counterparts->Find(CephalometricLandmarkSet::MakeName(mark.meaning)) != nullptr;
    }));
  }
  return problem.jaws.size() == 2 && count >= MinimumNumberOfLandmarks;
}
} // namespace

bool
OtherSpacingHypothesis::IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const
{
  // A spacing that is wrong by less than the search bridges fits, and contradicts its prior. One that is too small by a
  // quarter may fit with the teeth beside their own: it leans on the prior all the same.
  const bool isTraced = std::any_of(
    problem.jaws.begin(), problem.jaws.end(), [](const PoseJawInput & jaw) { return jaw.tracing.IsNotNull(); });
  const bool isPoor = result.score > problem.options.poorScore;
  const bool leans = isTraced && result.priorTension[PoseKappa] > LeaningOnScale;
  return problem.nominal.pixelSpacingKnown && (isPoor || leans) && (isTraced || HasEnoughLandmarks(problem));
}

std::string
OtherSpacingHypothesis::GetObstacle(const PoseProblem & problem) const
{
  return DescribeAddedRadiograph(problem, "has a radiograph with a pixel spacing of its own");
}

PoseProblem
OtherSpacingHypothesis::Apply(const PoseProblem & problem) const
{
  PoseProblem other = problem;
  // As a case without a spacing is registered: the scale is searched, which takes its evaluations.
  other.options = MakeQuickOptions(problem.options, problem.options.maximumEvaluations);
  other.completed.reset();
  other.initialGeometry.reset();
  other.nominal.pixelSpacingKnown = false;
  for (PoseJawInput & jaw : other.jaws)
  {
    jaw.initialPose.reset();
  }
  return other;
}
} // namespace itk
