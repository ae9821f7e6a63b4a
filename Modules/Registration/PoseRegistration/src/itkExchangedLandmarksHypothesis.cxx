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
#include "itkExchangedLandmarksHypothesis.h"

#include <algorithm>

namespace itk
{
namespace
{
/** Position of the last of the front teeth, the canine. */
constexpr unsigned int LastFrontTooth = 3;

/** The same point of the other jaw. */
std::string
NameOfOtherJaw(const CephalometricLandmarkSet::LandmarkType & landmark)
{
  CephalometricLandmarkSet::MeaningType meaning = landmark.meaning;
  meaning.jaw = OtherJaw(meaning.jaw);
  meaning.tooth = meaning.tooth.GetOpposing();
  return CephalometricLandmarkSet::MakeName(meaning);
}
} // namespace

std::string
ExchangedLandmarksHypothesis::GetCode() const
{
  return Code;
}

bool
ExchangedLandmarksHypothesis::IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const
{
  return problem.jaws.size() == 2 && result.score > PoorScore &&
         std::all_of(problem.jaws.begin(), problem.jaws.end(), [](const PoseJawInput & jaw) {
           return jaw.tracing.IsNull() && jaw.landmarks.IsNotNull() && jaw.counterparts.IsNotNull();
         });
}

std::string
ExchangedLandmarksHypothesis::GetObstacle(const PoseProblem & problem) const
{
  bool isFrontMarked = false, isBackMarked = false;
  for (const PoseJawInput & jaw : problem.jaws)
  {
    if (jaw.landmarks.IsNull())
    {
      continue;
    }
    for (const auto & landmark : jaw.landmarks->GetLandmarks())
    {
      if (landmark.meaning.feature != CephalometricLandmarkSet::FeatureEnum::Apex)
      {
        (landmark.meaning.position <= LastFrontTooth ? isFrontMarked : isBackMarked) = true;
      }
    }
  }
  return isFrontMarked && isBackMarked
           ? ""
           : "as front teeth alone, or teeth behind alone, fit with the names of the other jaw as well";
}

PoseProblem
ExchangedLandmarksHypothesis::Apply(const PoseProblem & problem) const
{
  PoseProblem other = problem;
  // As many steps as the result has had: the two are compared closely, and landmarks are quickly projected.
  other.options = MakeQuickOptions(problem.options, problem.options.maximumEvaluations);
  for (PoseJawInput & jaw : other.jaws)
  {
    jaw.initialPose.reset();
    if (jaw.landmarks.IsNull())
    {
      continue;
    }
    const auto exchanged = CephalometricLandmarkSet::New();
    for (const auto & landmark : jaw.landmarks->GetLandmarks())
    {
      exchanged->AddLandmark(NameOfOtherJaw(landmark), landmark.point, landmark.sigma, landmark.confidence);
    }
    jaw.landmarks = exchanged;
  }
  return other;
}
} // namespace itk
