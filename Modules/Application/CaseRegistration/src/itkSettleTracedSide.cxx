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
#include "itkDentalCaseLoader.h"

#include "itkTracedSideFilter.h"

#include <algorithm>
#include <string>

// Which side was traced, where the case does not say it.
namespace itk
{
namespace
{
using ReasonEnum = TracedSideFilter::ReasonEnum;
using JawEnum = ToothCode::JawEnum;

/** What the filter decided is said, unless it was given, or by names, or as it was. */
void
WarnOfSide(const TracedSideFilter & filter, DentalCaseData & data)
{
  const ReasonEnum reason = filter.GetReason();
  if (reason == ReasonEnum::Given || reason == ReasonEnum::Nothing || reason == ReasonEnum::SidesOfLandmarks)
  {
    return;
  }
  // Landmarks whose names have no sides mean what they always mean. Beside names with sides, these are what is ignored.
  if (reason == ReasonEnum::LandmarksAlone)
  {
    const auto & landmarks = data.cephalometricLandmarks->GetLandmarks();
    if (std::none_of(landmarks.begin(), landmarks.end(), [](const CephalometricLandmarkSet::LandmarkType & landmark) {
          return landmark.meaning.tooth.IsKnown();
        }))
    {
      return;
    }
  }
  data.warnings.push_back(data.description.fileName + ": traced_side: is not given; taken as \"" +
                          ToString(filter.GetSettledSide()) + "\", because " + ToString(reason));
}

void
WarnOfLeftOutTeeth(const TracedSideFilter & filter, DentalCaseData & data)
{
  std::string names;
  for (const ToothCode & tooth : filter.GetLeftOutTeeth())
  {
    names += (names.empty() ? "" : ", ") + tooth.GetName();
  }
  if (!names.empty())
  {
    data.warnings.push_back(
      data.description.fileName + ": traced_side: the tracing has teeth of both sides; " + names +
      (filter.GetSettledSide() == TracedSideEnum::Right ? " are not of the right side" : " are not of the left side") +
      " and left out (say \"both\" where both sides were traced)");
  }
}
} // namespace

void
SettleTracedSide(DentalCaseData & data)
{
  DentalCase & description = data.description;
  auto         filter = TracedSideFilter::New();
  filter->SetUpperContour(data.upper.contour);
  filter->SetLowerContour(data.lower.contour);
  filter->SetCephalometricLandmarks(data.cephalometricLandmarks);
  filter->SetTracedSide(description.tracedSide);
  filter->SetTracedSideIsGiven(description.tracedSideIsGiven || description.tracedSide != TracedSideEnum::Right);
  filter->SetCodesHaveSides(data.sidelessContours == 0);
  filter->Update();
  description.tracedSide = filter->GetSettledSide();
  WarnOfSide(*filter, data);
  WarnOfLeftOutTeeth(*filter, data);
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    // A contour of which nothing is left out stays the object that it is.
    DentalContour::Pointer & contour = data.GetJaw(jaw).contour;
    DentalContour::Pointer   kept = filter->GetOutput(jaw);
    if (contour.IsNotNull() && kept->GetNumberOfPoints() != contour->GetNumberOfPoints())
    {
      kept->DisconnectPipeline();
      contour = kept;
    }
  }
}
} // namespace itk
