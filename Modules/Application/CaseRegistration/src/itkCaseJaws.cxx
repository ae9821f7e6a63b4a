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
#include "itkCaseJaws.h"

#include "itkCasePoseRegistration.h"
#include "itkJoinNames.h"

#include <algorithm>
#include <string>
#include <vector>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
constexpr JawEnum Jaws[] = { JawEnum::Upper, JawEnum::Lower };

bool
HasLandmarks(const DentalCaseData & data, const CaseResult & result, JawEnum jaw)
{
  // The paper's chain registers contours alone.
  if (result.preset != CasePresetEnum::Robust || data.cephalometricLandmarks.IsNull())
  {
    return false;
  }
  const auto & landmarks = data.cephalometricLandmarks->GetLandmarks();
  return std::any_of(landmarks.begin(), landmarks.end(), [&](const auto & landmark) {
    return landmark.meaning.jaw == jaw && landmark.meaning.feature != CephalometricLandmarkSet::FeatureEnum::Apex;
  });
}

/** Why a jaw of which nothing was drawn that registers it is left out. */
std::string
DescribeMissingDrawing(const DentalCaseData & data, const CaseResult & result, JawEnum jaw)
{
  if (data.cephalometricLandmarks.IsNull())
  {
    return "there is a scan, but no tracing of this jaw";
  }
  if (result.preset != CasePresetEnum::Robust)
  {
    return std::string("landmarks alone were marked of this jaw: preset ") + ToString(result.preset) +
           " registers contours, use preset robust";
  }
  // What else there were, HasLandmarks() found.
  std::vector<std::string> apices;
  for (const auto & landmark : data.cephalometricLandmarks->GetLandmarks())
  {
    if (landmark.meaning.jaw == jaw)
    {
      apices.push_back(landmark.name);
    }
  }
  return apices.empty() ? "there is a scan, but neither tracing nor landmark of this jaw"
                        : "of this jaw only " + JoinNames(apices) + (apices.size() == 1 ? " is" : " are") +
                            " marked, the end of a root, which no scan shows: mark incisal edges and molars";
}

bool
IsOnAView(const DentalCaseData & data, const CaseResult & result, JawEnum jaw)
{
  const auto isOfJaw = [jaw](const auto & landmark) { return landmark.meaning.jaw == jaw; };
  return result.preset == CasePresetEnum::Robust &&
         std::any_of(data.views.begin(), data.views.end(), [&](const DentalViewData & view) {
           return CountTracingPoints(view.GetContour(jaw)) > 0 ||
                  (view.cephalometricLandmarks.IsNotNull() &&
                   std::any_of(view.cephalometricLandmarks->GetLandmarks().begin(),
                               view.cephalometricLandmarks->GetLandmarks().end(),
                               isOfJaw));
         });
}
} // namespace

void
ChooseJaws(const DentalCaseData & data, CaseResult & result)
{
  for (const JawEnum jaw : Jaws)
  {
    const auto &       input = data.GetJaw(jaw);
    const unsigned int points = CountTracingPoints(input.contour);
    if (input.mesh.IsNull())
    {
      result.skipped[jaw] = points > 0 ? "traced, but there is no scan of this jaw" : "neither scan nor tracing";
    }
    else if (points == 0 && (HasLandmarks(data, result, jaw) || IsOnAView(data, result, jaw)))
    {
      result.jaws[jaw];
    }
    else if (points == 0)
    {
      const bool traced = input.contour.IsNotNull();
      const bool excluded =
        traced && input.contour->GetNumberOfPoints() == 0 && !data.description.excludedTeeth.empty();
      result.skipped[jaw] = excluded ? "all traced teeth of this jaw are excluded"
                            : traced && input.contour->GetNumberOfPoints() > 0
                              ? "every point of this jaw's tracing has weight 0"
                              : DescribeMissingDrawing(data, result, jaw);
    }
    else
    {
      JawResult & own = result.jaws[jaw];
      if (points < MinimumTracingPoints && !HasLandmarks(data, result, jaw))
      {
        own.AddFinding(RegistrationStatusEnum::Failed,
                       "few-points",
                       "the tracing has " + std::to_string(points) + " points that count; at least " +
                         std::to_string(MinimumTracingPoints) + " are needed, better 30 or more");
      }
    }
  }
  if (result.skipped.size() == 2 && result.jaws.empty())
  {
    for (auto & skipped : result.skipped)
    {
      if (!data.GetJaw(skipped.first).mesh.IsNull())
      {
        result.jaws[skipped.first].AddFinding(RegistrationStatusEnum::Failed, "not-drawn", skipped.second);
      }
    }
  }
}

void
PlaceJawsBesideTheOther(const DentalCaseData & data, CaseResult & result)
{
  for (const JawEnum jaw : Jaws)
  {
    const JawEnum other = OtherJaw(jaw);
    const auto    drawn = result.jaws.find(other);
    if (result.skipped.count(jaw) != 0 && data.GetJaw(jaw).mesh.IsNotNull() && drawn != result.jaws.end() &&
        drawn->second.status != RegistrationStatusEnum::Failed)
    {
      result.skipped.erase(jaw);
      result.jaws[jaw];
    }
  }
}
} // namespace itk
