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
#include "itkTracedToothRow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace itk
{
namespace
{
/** From its place on the line of its tooth a landmark may lie by this share of the line's extent, and by this many mm
 * at the detector where the line shows a part of the tooth alone: more than half a tooth. */
constexpr double ShareOff = 0.6;
constexpr double LeastOff = 4.0;
/** The share for a middle of both sides, of which the textbook's place is on the next cusp or tooth or on its own:
 * of 14 first molars of phantoms (level typical, seeds 77010-77016) those of their own tooth lie up to 0.21 of its
 * extent off, the three of another one 0.48 or more. */
constexpr double MiddleShareOff = 0.4;
/** As many names as a sentence bears. */
constexpr std::size_t NamesSaid = 4;

/** Where along its tooth a landmark is, by its name: a share of the extent, from the middle toward the back. */
double
ShareOf(const std::string & name)
{
  const std::string suffix = name.substr(name.rfind('_') + 1);
  return suffix == "MB" || suffix == "ML"   ? -TracedToothRow::CuspShare
         : suffix == "DB" || suffix == "DL" ? TracedToothRow::CuspShare
                                            : 0.0;
}

/** How far a pixel is from where a landmark of that name is on a tooth, along the row. */
double
OffFrom(const TracedToothRow &           row,
        const TracedToothRow::SpanType & span,
        const std::string &              name,
        const std::array<double, 2> &    position)
{
  return std::abs(row.ToRow(position[0], position[1]) - row.GetPlace(span, ShareOf(name)));
}

/** Middles of posterior teeth whose place on the scan is a textbook's although the tooth was traced, since the scan
 * shows none there, and which come to lie on another tooth of the tracing: nothing else tells that, and their standard
 * deviations are of the place on the right tooth. */
void
DescribeMiddlesOffTeeth(const JawResult &          jaw,
                        const TracedToothRow &     row,
                        double                     pixel,
                        std::vector<std::string> & texts)
{
  constexpr unsigned int firstPremolar = 4;
  for (const auto & middle : jaw.middles)
  {
    const unsigned int position = CephalometricLandmarkSet::ParseName(middle.name).position;
    const auto *       span = position >= firstPremolar ? row.FindPosition(position) : nullptr;
    if (span == nullptr || middle.source.rfind("its place along the arch", 0) != 0)
    {
      continue;
    }
    const double off = OffFrom(row, *span, middle.name, middle.position);
    if (off > std::max(MiddleShareOff * span->GetExtent(), LeastOff / pixel))
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
} // namespace

std::vector<std::string>
DescribeLandmarksOffTeeth(const DentalCaseData & data, const CaseResult & result)
{
  std::vector<std::string> texts;
  if (data.description.tracedSide == TracedSideEnum::Standard || result.geometry.IsNull())
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
    const TracedToothRow row(contour->GetPolylines());
    std::string          names;
    std::size_t          count = 0;
    double               largest = 0.0;
    for (const LandmarkPrediction & landmark : jaw.landmarks)
    {
      const auto & unusable = result.unusableLandmarks;
      // The middle between both sides has each side's landmark beside it.
      if (data.description.tracedSide == TracedSideEnum::Mean)
      {
        break;
      }
      const auto * span = row.Find(DentalLandmarkSet<3>::ParseName(landmark.name));
      if (span == nullptr || std::find(unusable.begin(), unusable.end(), landmark.name) != unusable.end())
      {
        continue;
      }
      const double off = OffFrom(row, *span, landmark.name, landmark.position);
      if (off > std::max(ShareOff * span->GetExtent(), LeastOff / pixel))
      {
        names += count < NamesSaid ? (count == 0 ? "" : ", ") + landmark.name : "";
        ++count;
        largest = std::max(largest, off);
      }
    }
    DescribeMiddlesOffTeeth(jaw, row, pixel, texts);
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
