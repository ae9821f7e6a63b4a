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
#include "itkMillimetreLandmarksHypothesis.h"

#include <algorithm>

namespace itk
{
std::string
MillimetreLandmarksHypothesis::GetCode() const
{
  return Code;
}

bool
MillimetreLandmarksHypothesis::IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const
{
  // Two points of one jaw fit at any scale but for its prior: the score alone does not tell, where it is poor it does.
  return problem.nominal.pixelSpacingKnown && result.score > problem.options.poorScore &&
         std::all_of(problem.jaws.begin(), problem.jaws.end(), [](const PoseJawInput & jaw) {
           return jaw.tracing.IsNull() && jaw.landmarks.IsNotNull() && jaw.counterparts.IsNotNull();
         });
}

PoseProblem
MillimetreLandmarksHypothesis::Apply(const PoseProblem & problem) const
{
  PoseProblem other = problem;
  // As many steps as the result has had: landmarks are quickly projected.
  other.options = MakeQuickOptions(problem.options, problem.options.maximumEvaluations);
  for (PoseJawInput & jaw : other.jaws)
  {
    jaw.initialPose.reset();
    const auto pixels = CephalometricLandmarkSet::New();
    for (const auto & landmark : jaw.landmarks->GetLandmarks())
    {
      CephalometricLandmarkSet::PointType point;
      for (unsigned int d = 0; d < 2; ++d)
      {
        point[d] = landmark.point[d] / problem.nominal.pixelSpacing[d];
      }
      pixels->AddLandmark(landmark.name, point, landmark.sigma, landmark.confidence);
    }
    jaw.landmarks = pixels;
  }
  return other;
}
} // namespace itk
