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
  WarnOfMarks(result);
}
} // namespace itk
