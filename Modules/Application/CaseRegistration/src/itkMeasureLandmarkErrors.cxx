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
#include "itkLeaveOutUsedLandmarks.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
namespace
{
/** What was marked, less what the case was registered with. */
DentalLandmarkSet<2>::Pointer
WithoutUsed(const DentalLandmarkSet<2> & marked, const DentalCaseData & data)
{
  std::vector<CephalometricLandmarkSet::MeaningType> used;
  if (data.cephalometricLandmarks.IsNotNull())
  {
    for (const auto & landmark : data.cephalometricLandmarks->GetLandmarks())
    {
      used.push_back(landmark.meaning);
    }
  }
  return LeaveOutUsedLandmarks(marked, used, data.description.tracedSide == TracedSideEnum::Standard);
}

/** The middles of a jaw without landmarks on its scan, as if both sides lay there, where both are marked. */
void
AddFoundMiddles(const JawResult & jaw, const DentalLandmarkSet<2> & marked, DentalLandmarkSet<2> & predicted)
{
  for (const MiddlePrediction & middle : jaw.middles)
  {
    const auto names = NamesOfSides(middle.name);
    if (marked.Find(names[0]) != nullptr && marked.Find(names[1]) != nullptr)
    {
      for (const std::string & name : names)
      {
        predicted.AddLandmark(name, DentalLandmarkSet<2>::PointType(middle.position.data()));
      }
    }
  }
}

/** What hands and registrations are never off by, mm on the detector. */
constexpr double GrossError = 5.0;
/** A factor on all marks explains their errors where so much of them is left; below this share it is no factor. */
constexpr double ExplainedShare = 0.25;
constexpr double SmallestFactor = 0.08;

std::string
TextOf(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

/** The marks as a copy of another size would have them: marked = factor * predicted, about the picture's corner. */
std::string
DescribeFactor(const std::vector<const LandmarkFigures *> & all, double pixelSpacing)
{
  double      product = 0.0, square = 0.0, before = 0.0, after = 0.0;
  std::size_t count = 0;
  for (const LandmarkFigures * figures : all)
  {
    for (std::size_t i = 0; i < figures->marked.size(); ++i)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        product += figures->marked[i][d] * figures->predicted[i][d];
        square += figures->predicted[i][d] * figures->predicted[i][d];
      }
    }
  }
  const double factor = square > 0.0 ? product / square : 1.0;
  for (const LandmarkFigures * figures : all)
  {
    for (std::size_t i = 0; i < figures->marked.size(); ++i, ++count)
    {
      const auto & m = figures->marked[i];
      const auto & p = figures->predicted[i];
      before += std::hypot(m[0] - p[0], m[1] - p[1]);
      after += std::hypot(m[0] / factor - p[0], m[1] / factor - p[1]);
    }
  }
  if (count < 3 || factor <= 0.0 || std::abs(std::log(factor)) < SmallestFactor ||
      before < static_cast<double>(count) * GrossError / pixelSpacing || after > ExplainedShare * before)
  {
    return std::string();
  }
  const bool isMillimetres = std::abs(std::log(factor / pixelSpacing)) < SmallestFactor;
  return "the landmarks were marked " + TextOf(before / static_cast<double>(count), 0) +
         " px from where they are predicted, and " + TextOf(after / static_cast<double>(count), 1) + " px were they " +
         (isMillimetres ? "divided by the pixel spacing: are they in mm? Give pixels"
                        : "divided by " + TextOf(factor, 2) +
                            ": were they marked on a copy of the radiograph of another size? Give its pixels");
}

/** Marks that are off as nothing else of their jaw is. */
std::string
DescribeStrays(const std::vector<const LandmarkFigures *> & all, double pixelSpacing)
{
  constexpr std::size_t listed = 4;
  const double          gross = GrossError / pixelSpacing;
  std::string           names;
  std::size_t           strays = 0;
  double                largest = 0.0;
  for (const LandmarkFigures * figures : all)
  {
    // A textbook's place may be as far off as a gross error: that says nothing against the mark.
    if (!figures->sources.empty())
    {
      continue;
    }
    std::vector<double> distances;
    for (const auto & landmark : figures->landmarks)
    {
      distances.push_back(landmark.second);
    }
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    if (distances.empty() || *middle > ExplainedShare * gross)
    {
      continue;
    }
    for (const auto & landmark : figures->landmarks)
    {
      if (landmark.second > gross)
      {
        names += strays >= listed ? "" : (strays > 0 ? ", " : "") + landmark.first;
        ++strays;
        largest = std::max(largest, landmark.second);
      }
    }
  }
  if (strays == 0)
  {
    return std::string();
  }
  return names + (strays > listed ? " and " + std::to_string(strays - listed) + " more" : "") +
         (strays > 1 ? " were marked up to " : " was marked ") + TextOf(largest, 0) +
         " px from where the rest of the jaw says: the right tooth and point? They count in \"error\"";
}

/** A registration never sees the marks: what is wrong with them shows in its error alone. */
void
WarnOfMarks(CaseResult & result)
{
  std::vector<const LandmarkFigures *> all;
  if (result.geometry.IsNull())
  {
    return;
  }
  for (const auto & entry : result.jaws)
  {
    // A jaw that has failed is elsewhere, and no mark is wrong for that.
    if (entry.second.error && entry.second.status != RegistrationStatusEnum::Failed)
    {
      all.push_back(&*entry.second.error);
    }
  }
  const auto  spacing = result.geometry->GetPixelSpacing();
  const auto  pixel = std::sqrt(spacing[0] * spacing[1]);
  std::string text = DescribeFactor(all, pixel);
  text = text.empty() ? DescribeStrays(all, pixel) : text;
  if (text.empty())
  {
    return;
  }
  text = (result.viewName.empty() ? "" : "views." + result.viewName + ".") + "landmarks_2d: " + text;
  if (std::find(result.warnings.begin(), result.warnings.end(), text) == result.warnings.end())
  {
    result.warnings.push_back(text);
  }
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
    const auto reference = WithoutUsed(*marked, *result.data);
    const bool isFound = jaw.landmarks.empty();
    if (isFound)
    {
      AddFoundMiddles(jaw, *reference, *predicted);
    }
    auto filter = FilterType::New();
    filter->SetPredictedLandmarks(predicted);
    filter->SetReferenceLandmarks(reference);
    filter->SetJaw(entry.first);
    filter->SetBisectSides(isFound || IsBisected(result.data->description.tracedSide));
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
    for (const auto & landmark : figures.landmarks)
    {
      const auto middle = std::find_if(jaw.middles.begin(), jaw.middles.end(), [&](const MiddlePrediction & each) {
        return landmark.first == NamesOfSides(each.name)[0] + '+' + NamesOfSides(each.name)[1];
      });
      if (isFound && middle != jaw.middles.end())
      {
        figures.sources[landmark.first] = middle->source;
      }
    }
    jaw.error = figures;
  }
  WarnOfMarks(result);
}
} // namespace itk
