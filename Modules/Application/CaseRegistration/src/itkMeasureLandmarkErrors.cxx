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
#include "itkMeasureLandmarkErrors.h"

#include "itkCephalometricLandmarkSet.h"
#include "itkLandmarkErrorFilter.h"

#include <algorithm>
#include <utility>

namespace itk
{
namespace
{
/** What was marked, less what was registered with: a landmark of the case never scores, nor does either side's where it
 * has none. */
DentalLandmarkSet<2>::Pointer
WithoutUsed(const DentalLandmarkSet<2> & marked, const DentalCaseData & data)
{
  auto       kept = DentalLandmarkSet<2>::New();
  const bool ignoreSides = data.description.tracedSide == TracedSideEnum::Standard;
  for (const auto & landmark : marked.GetLandmarks())
  {
    const auto own =
      CephalometricLandmarkSet::ParseName(landmark.tooth.GetName() + landmark.name.substr(landmark.name.find('_')));
    bool used = false;
    if (data.cephalometricLandmarks.IsNotNull())
    {
      for (const auto & other : data.cephalometricLandmarks->GetLandmarks())
      {
        const auto & meaning = other.meaning;
        const bool   sameSide = ignoreSides || !meaning.tooth.IsKnown() || meaning.tooth == own.tooth;
        // A molar's point of which the name does not say which was registered with as its mesiobuccal cusp.
        const bool samePoint =
          meaning.feature == own.feature || (meaning.feature == CephalometricLandmarkSet::FeatureEnum::Unspecified &&
                                             own.feature == CephalometricLandmarkSet::FeatureEnum::MesiobuccalCusp);
        used = used || (meaning.jaw == own.jaw && meaning.position == own.position && sameSide && samePoint);
      }
    }
    if (!used)
    {
      kept->AddLandmark(landmark.name, landmark.point);
    }
  }
  return kept;
}
} // namespace

void
MeasureLandmarkErrors(CaseResult & result, const DentalLandmarkSet<2> * marked)
{
  using FilterType = LandmarkErrorFilter;
  for (auto & entry : result.jaws)
  {
    JawResult & jaw = entry.second;
    jaw.error.reset();
    if (!jaw.registered || marked == nullptr)
    {
      continue;
    }
    auto predicted = DentalLandmarkSet<2>::New();
    for (const LandmarkPrediction & landmark : jaw.landmarks)
    {
      const auto & unusable = result.unusableLandmarks;
      if (std::find(unusable.begin(), unusable.end(), landmark.name) != unusable.end())
      {
        continue;
      }
      DentalLandmarkSet<2>::PointType point;
      point[0] = landmark.position[0];
      point[1] = landmark.position[1];
      predicted->AddLandmark(landmark.name, point);
    }
    auto filter = FilterType::New();
    filter->SetPredictedLandmarks(predicted);
    filter->SetReferenceLandmarks(WithoutUsed(*marked, *result.data));
    filter->SetJaw(entry.first);
    filter->SetBisectSides(IsBisected(result.data->description.tracedSide));
    filter->Update();
    const auto & statistics = filter->GetStatistics();
    if (statistics.GetCount() == 0)
    {
      continue;
    }
    LandmarkFigures figures;
    figures.count = statistics.GetCount();
    figures.mean = statistics.GetMean();
    figures.rmse = statistics.GetRMSE();
    figures.standardDeviation = statistics.GetStandardDeviation();
    const std::pair<const char *, ToothCode::GroupEnum> groups[] = { { "incisors_canines",
                                                                       ToothCode::GroupEnum::IncisorsAndCanines },
                                                                     { "premolars", ToothCode::GroupEnum::Premolars },
                                                                     { "molars", ToothCode::GroupEnum::Molars } };
    for (const auto & group : groups)
    {
      if (statistics.GetCount(group.second) > 0)
      {
        figures.groups[group.first] = statistics.GetMean(group.second);
      }
    }
    for (const auto & error : filter->GetErrors())
    {
      figures.landmarks.emplace_back(error.name, error.distance);
      figures.marked.push_back({ { error.reference[0], error.reference[1] } });
      figures.predicted.push_back({ { error.predicted[0], error.predicted[1] } });
    }
    jaw.error = figures;
  }
}
} // namespace itk
