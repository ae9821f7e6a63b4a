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
#include "itkLandmarksOffTeeth.h"

#include "itkCephalometricLandmarkSet.h"
#include "itkDentalLandmarkSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <locale>
#include <map>
#include <sstream>

namespace itk
{
namespace
{
/** From its place on the line of its tooth a landmark may lie by this share of the line's extent, and by this many mm
 * at the detector where the line shows a part of the tooth alone: more than half a tooth. */
constexpr double ShareOff = 0.6;
constexpr double LeastOff = 4.0;
/** Of a line that shows how far its tooth reaches. */
constexpr std::size_t FewestPoints = 10;
/** Cusps before and behind a molar's middle, by a share of its extent. */
constexpr double CuspShare = 0.24;
/** The same share for a middle of both sides, of which the textbook's place is on the next cusp or tooth or on its own:
 * of 14 first molars of phantoms (level typical, seeds 77010-77016) those of their own tooth lie up to 0.21 of its
 * extent off, the three of another one 0.48 or more. */
constexpr double MiddleShareOff = 0.4;
/** As many names as a sentence bears. */
constexpr std::size_t NamesSaid = 4;

using DirectionType = std::array<double, 2>;

/** The extent of a tooth along the row of teeth, pixels. */
struct SpanType
{
  double low{ std::numeric_limits<double>::max() };
  double high{ std::numeric_limits<double>::lowest() };
  /** Of the line. */
  std::size_t points{ 0 };

  double
  GetMiddle() const
  {
    return 0.5 * (low + high);
  }
};
using SpansType = std::map<std::uint8_t, SpanType>;

/** +1 where the teeth at the back lie at the higher end of the row, -1 where at the lower, 0 where no two tell. */
int
FindBackward(const SpansType & spans)
{
  double sum = 0.0;
  for (const auto & front : spans)
  {
    for (const auto & back : spans)
    {
      const ToothCode first(front.first);
      const ToothCode second(back.first);
      if (first.GetQuadrant() == second.GetQuadrant() && first.GetPosition() < second.GetPosition())
      {
        sum += back.second.GetMiddle() - front.second.GetMiddle();
      }
    }
  }
  return sum > 0.0 ? 1 : sum < 0.0 ? -1 : 0;
}

/** Where along its tooth a landmark is, by its name: a share of the extent, from the middle toward the back. */
double
ShareOf(const std::string & name)
{
  const std::string suffix = name.substr(name.rfind('_') + 1);
  return suffix == "MB" || suffix == "ML" ? -CuspShare : suffix == "DB" || suffix == "DL" ? CuspShare : 0.0;
}

/** How far a place is from where a landmark of that name is on a tooth, along the row. */
double
OffFrom(const SpanType & span, int backward, const std::string & name, double place)
{
  return std::abs(place - span.GetMiddle() - backward * ShareOf(name) * (span.high - span.low));
}

/** The traced tooth of a position, of whichever side; null where none or too little of one is drawn, or both sides. */
const SpanType *
FindTracedTooth(const SpansType & spans, unsigned int position)
{
  const SpanType * found = nullptr;
  for (const auto & entry : spans)
  {
    if (ToothCode(entry.first).GetPosition() == position)
    {
      if (found != nullptr)
      {
        return nullptr;
      }
      found = &entry.second;
    }
  }
  return found != nullptr && found->points >= FewestPoints ? found : nullptr;
}

/** Middles of posterior teeth whose place on the scan is a textbook's, and which come to lie on another tooth of the
 * tracing: nothing else tells that, and their standard deviations are of the place on the right tooth. */
void
DescribeMiddlesOffTeeth(const JawResult &          jaw,
                        const SpansType &          spans,
                        const DirectionType &      row,
                        int                        backward,
                        double                     pixel,
                        std::vector<std::string> & texts)
{
  constexpr unsigned int firstPremolar = 4;
  for (const auto & middle : jaw.middles)
  {
    const unsigned int position = CephalometricLandmarkSet::ParseName(middle.name).position;
    const SpanType *   span = position >= firstPremolar ? FindTracedTooth(spans, position) : nullptr;
    if (span == nullptr || middle.source.rfind("its place along the arch", 0) != 0)
    {
      continue;
    }
    const double place = row[0] * middle.position[0] + row[1] * middle.position[1];
    const double off = OffFrom(*span, backward, middle.name, place);
    if (off > std::max(MiddleShareOff * (span->high - span->low), LeastOff / pixel))
    {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text << "middles: " << middle.name << " is " << std::fixed << std::setprecision(0) << off
           << " px from where it is on the traced tooth of that code: it was found on the scan by its place along the "
              "arch alone, which seems to be another tooth; do not use it, or mark it in landmarks_3d";
      texts.push_back(text.str());
    }
  }
}

/** Whether the jaw is where its result says: nothing is doubted, or nothing but other landmarks of the scan, which are
 * not registered with where they cannot be used. */
bool
IsInPlace(const JawResult & jaw)
{
  return jaw.registered && jaw.status != RegistrationStatusEnum::Failed &&
         std::all_of(jaw.findings.begin(), jaw.findings.end(), [](const RegistrationFinding & finding) {
           return finding.code == "landmarks-coincide" || finding.code == "landmarks-off-scan" ||
                  finding.code == "landmarks-order";
         });
}

/** The row of teeth runs in the direction in which the points are spread most. */
DirectionType
FindRow(const DentalContour::PolylinesType & polylines)
{
  double sums[2] = { 0.0, 0.0 };
  double count = 0.0;
  for (const auto & polyline : polylines)
  {
    for (const auto & point : polyline.points)
    {
      sums[0] += point[0];
      sums[1] += point[1];
      count += 1.0;
    }
  }
  double along = 0.0;
  double across = 0.0;
  double mixed = 0.0;
  for (const auto & polyline : polylines)
  {
    for (const auto & point : polyline.points)
    {
      const double u = point[0] - sums[0] / count;
      const double v = point[1] - sums[1] / count;
      along += u * u;
      across += v * v;
      mixed += u * v;
    }
  }
  const double angle = 0.5 * std::atan2(2.0 * mixed, along - across);
  return { { std::cos(angle), std::sin(angle) } };
}
} // namespace

std::vector<std::string>
DescribeLandmarksOffTeeth(const DentalCaseData & data, const CaseResult & result)
{
  std::vector<std::string> texts;
  // The middle between both sides has each side's landmark beside it.
  if (IsBisected(data.description.tracedSide) || result.geometry.IsNull())
  {
    return texts;
  }
  const auto   spacing = result.geometry->GetPixelSpacing();
  const double pixel = std::sqrt(spacing[0] * spacing[1]);
  for (const auto & entry : result.jaws)
  {
    const JawResult & jaw = entry.second;
    const auto &      contour = data.GetJaw(entry.first).contour;
    // A jaw that is in doubt may be elsewhere, and no name is wrong for that.
    if (!IsInPlace(jaw) || contour.IsNull())
    {
      continue;
    }
    const auto          polylines = contour->GetPolylines();
    const DirectionType row = FindRow(polylines);
    SpansType           spans;
    for (const auto & polyline : polylines)
    {
      for (std::size_t i = 0; i < polyline.points.size(); ++i)
      {
        if (polyline.GetTooth(i).IsKnown())
        {
          SpanType &   span = spans[polyline.GetTooth(i).GetFDI()];
          const double place = row[0] * polyline.points[i][0] + row[1] * polyline.points[i][1];
          span.low = std::min(span.low, place);
          span.high = std::max(span.high, place);
          ++span.points;
        }
      }
    }
    const int   backward = FindBackward(spans);
    std::string names;
    std::size_t count = 0;
    double      largest = 0.0;
    for (const LandmarkPrediction & landmark : jaw.landmarks)
    {
      const auto & unusable = result.unusableLandmarks;
      const auto   found = spans.find(DentalLandmarkSet<3>::ParseName(landmark.name).GetFDI());
      if (found == spans.end() || std::find(unusable.begin(), unusable.end(), landmark.name) != unusable.end())
      {
        continue;
      }
      const SpanType & span = found->second;
      // A few points say where a tooth is, and not how far it reaches.
      if (span.points < FewestPoints)
      {
        continue;
      }
      const double place = row[0] * landmark.position[0] + row[1] * landmark.position[1];
      const double extent = span.high - span.low;
      const double off = OffFrom(span, backward, landmark.name, place);
      if (off > std::max(ShareOff * extent, LeastOff / pixel))
      {
        names += count < NamesSaid ? (count == 0 ? "" : ", ") + landmark.name : "";
        ++count;
        largest = std::max(largest, off);
      }
    }
    DescribeMiddlesOffTeeth(jaw, spans, row, backward, pixel, texts);
    if (count > 0)
    {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text << "landmarks_3d: the result puts " << names;
      if (count > NamesSaid)
      {
        text << " and " << count - NamesSaid << " more";
      }
      text
        << (count > 1 ? " up to " : " ") << std::fixed << std::setprecision(0) << largest << " px from where "
        << (count > 1 ? "they are" : "it is")
        << " on the traced tooth of that code: on the right tooth of the scan, and is the code of the tracing right?";
      texts.push_back(text.str());
    }
  }
  return texts;
}
} // namespace itk
