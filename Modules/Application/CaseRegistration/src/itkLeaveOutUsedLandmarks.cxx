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
#include "itkLeaveOutUsedLandmarks.h"

#include <algorithm>

namespace itk
{
DentalLandmarkSet<2>::Pointer
LeaveOutUsedLandmarks(const DentalLandmarkSet<2> &                               marked,
                      const std::vector<CephalometricLandmarkSet::MeaningType> & used,
                      bool                                                       ignoreSides)
{
  using FeatureEnum = CephalometricLandmarkSet::FeatureEnum;
  auto kept = DentalLandmarkSet<2>::New();
  for (const auto & landmark : marked.GetLandmarks())
  {
    const auto own =
      CephalometricLandmarkSet::ParseName(landmark.tooth.GetName() + landmark.name.substr(landmark.name.find('_')));
    const bool isUsed =
      std::any_of(used.begin(), used.end(), [&](const CephalometricLandmarkSet::MeaningType & meaning) {
        const bool sameSide = ignoreSides || !meaning.tooth.IsKnown() || meaning.tooth == own.tooth;
        // A molar's point of which the name does not say which was registered with as its mesiobuccal cusp.
        const bool samePoint = meaning.feature == own.feature || (meaning.feature == FeatureEnum::Unspecified &&
                                                                  own.feature == FeatureEnum::MesiobuccalCusp);
        return meaning.jaw == own.jaw && meaning.position == own.position && sameSide && samePoint;
      });
    if (!isUsed)
    {
      kept->AddLandmark(landmark.name, landmark.point);
    }
  }
  return kept;
}

std::array<std::string, 2>
NamesOfSides(const std::string & middle)
{
  return { { middle.substr(0, 1) + "R" + middle.substr(1), middle.substr(0, 1) + "L" + middle.substr(1) } };
}
} // namespace itk
