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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>

// Which side was traced, where the case does not say it.
namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;

/** Length by width of what a curve covers, along its own axes. */
double
ComputeElongation(const DentalContour::PolylineType & polyline)
{
  const double          count = static_cast<double>(polyline.points.size());
  double                mean[2] = { 0.0, 0.0 };
  std::array<double, 3> moments{ { 0.0, 0.0, 0.0 } };
  std::array<double, 2> lowest{ { 0.0, 0.0 } };
  std::array<double, 2> highest{ { 0.0, 0.0 } };
  for (const auto & point : polyline.points)
  {
    mean[0] += point[0] / count;
    mean[1] += point[1] / count;
  }
  for (const auto & point : polyline.points)
  {
    const double u = point[0] - mean[0];
    const double v = point[1] - mean[1];
    moments = { { moments[0] + u * u, moments[1] + u * v, moments[2] + v * v } };
  }
  const double angle = 0.5 * std::atan2(2.0 * moments[1], moments[0] - moments[2]);
  for (const auto & point : polyline.points)
  {
    const double u = point[0] - mean[0];
    const double v = point[1] - mean[1];
    const double along = std::cos(angle) * u + std::sin(angle) * v;
    const double across = std::cos(angle) * v - std::sin(angle) * u;
    lowest = { { std::min(lowest[0], along), std::min(lowest[1], across) } };
    highest = { { std::max(highest[0], along), std::max(highest[1], across) } };
  }
  const double width = highest[1] - lowest[1];
  return width > 0.0 ? (highest[0] - lowest[0]) / width : 0.0;
}

/** Closed outlines of incisors and molars of one side each, incisors with their roots. A whole incisor is three times
 * as long as wide in a lateral view and its crown one and a half times; a molar's shape tells nothing. */
bool
IsStandardTracing(const DentalCaseData & data)
{
  using OutlineEnum = DentalContour::OutlineEnum;
  constexpr double  minimumElongation = 2.0;
  unsigned int      incisors = 0;
  unsigned int      molars = 0;
  std::set<uint8_t> seen;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (data.GetJaw(jaw).contour.IsNull())
    {
      continue;
    }
    for (const auto & polyline : data.GetJaw(jaw).contour->GetPolylines())
    {
      if (polyline.points.empty())
      {
        continue;
      }
      const unsigned int position = polyline.code.GetPosition();
      const bool         incisor = position == 1 || position == 2;
      const bool         molar = position >= 6;
      // What the file says of an outline goes before its shape.
      const bool said = polyline.outline != OutlineEnum::Unspecified;
      if (!polyline.closed || !(incisor || molar) || seen.count(polyline.code.GetContralateral().GetFDI()) > 0 ||
          (said && polyline.outline != OutlineEnum::Tooth) ||
          (!said && incisor && ComputeElongation(polyline) < minimumElongation))
      {
        return false;
      }
      seen.insert(polyline.code.GetFDI());
      incisors += incisor ? 1 : 0;
      molars += molar ? 1 : 0;
    }
  }
  return incisors > 0 && molars > 0;
}

/** Teeth that are drawn of both sides, each with its own code: the codes of the right ones, by jaw. */
std::set<std::uint8_t>
FindPairs(const DentalContour * contour)
{
  std::set<std::uint8_t> right;
  std::set<std::uint8_t> left;
  for (const auto & polyline : contour->GetPolylines())
  {
    if (!polyline.points.empty() && polyline.code.IsKnown())
    {
      (polyline.code.IsRight() ? right : left).insert(polyline.code.GetFDI());
    }
  }
  std::set<std::uint8_t> pairs;
  for (const std::uint8_t tooth : right)
  {
    if (left.count(ToothCode(tooth).GetContralateral().GetFDI()) != 0)
    {
      pairs.insert(tooth);
    }
  }
  return pairs;
}

/** Where the case does not say which side was traced, what is drawn may. */
void
ReadTracedSideFromDrawing(DentalCaseData & data)
{
  DentalCase & description = data.description;
  if (description.tracedSideIsGiven || description.tracedSide != TracedSideEnum::Right)
  {
    return;
  }
  const auto isTraced = [&](JawEnum jaw) {
    return data.GetJaw(jaw).contour.IsNotNull() && data.GetJaw(jaw).contour->GetNumberOfPoints() > 0;
  };
  const bool traced = isTraced(JawEnum::Upper) || isTraced(JawEnum::Lower);
  const bool landmarksAlone = !traced && data.cephalometricLandmarks.IsNotNull();
  if (landmarksAlone)
  {
    // Names that tell their sides are taken at their word.
    bool right = false, left = false, sideless = false;
    for (const auto & landmark : data.cephalometricLandmarks->GetLandmarks())
    {
      const ToothCode & tooth = landmark.meaning.tooth;
      sideless = sideless || !tooth.IsKnown();
      right = right || tooth.IsRight();
      left = left || tooth.IsLeft();
    }
    if (!sideless && (right || left))
    {
      description.tracedSide = right && left ? TracedSideEnum::Both
                               : right       ? TracedSideEnum::Right
                                             : TracedSideEnum::Left;
      return;
    }
  }
  const bool sideless = data.sidelessContours > 0;
  if (landmarksAlone || sideless || IsStandardTracing(data))
  {
    description.tracedSide = TracedSideEnum::Standard;
    data.warnings.push_back(description.fileName + ": traced_side: is not given; taken as \"standard\", because " +
                            (landmarksAlone ? "there are landmarks of a cephalometric analysis and no tracing"
                             : sideless     ? "codes of the tracing (U1, L6) do not say their side"
                                            : "whole incisors and molars alone are traced"));
  }
  else
  {
    // The incisors of both sides are often drawn together; teeth further back are drawn twice on purpose.
    std::size_t pairs = 0;
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      const auto found = isTraced(jaw) ? FindPairs(data.GetJaw(jaw).contour) : std::set<std::uint8_t>();
      pairs += static_cast<std::size_t>(
        std::count_if(found.begin(), found.end(), [](std::uint8_t tooth) { return tooth % 10 > 2; }));
    }
    if (pairs >= 2)
    {
      description.tracedSide = TracedSideEnum::Both;
      data.warnings.push_back(description.fileName +
                              ": traced_side: is not given; taken as \"both\", because teeth of both sides are traced");
    }
  }
}

/** A tooth that is drawn of both sides under one traced side: the other side's has no outline to lie on. */
void
LeaveOutOtherSide(DentalCaseData & data)
{
  const TracedSideEnum side = data.description.tracedSide;
  if (side != TracedSideEnum::Right && side != TracedSideEnum::Left)
  {
    return;
  }
  std::string names;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    auto &     contour = data.GetJaw(jaw).contour;
    const auto pairs = contour.IsNull() ? std::set<std::uint8_t>() : FindPairs(contour);
    if (pairs.empty())
    {
      continue;
    }
    auto kept = DentalContour::New();
    for (const auto & polyline : contour->GetPolylines())
    {
      const bool      isOther = side == TracedSideEnum::Right ? polyline.code.IsLeft() : polyline.code.IsRight();
      const ToothCode right = polyline.code.IsRight() ? polyline.code : polyline.code.GetContralateral();
      if (isOther && pairs.count(right.GetFDI()) != 0)
      {
        names += (names.empty() ? "" : ", ") + polyline.code.GetName();
      }
      else
      {
        kept->AddPolyline(polyline);
      }
    }
    contour = kept;
  }
  if (!names.empty())
  {
    data.warnings.push_back(
      data.description.fileName + ": traced_side: the tracing has teeth of both sides; " + names +
      (side == TracedSideEnum::Right ? " are not of the right side" : " are not of the left side") +
      " and left out (say \"both\" where both sides were traced)");
  }
}
} // namespace

void
SettleTracedSide(DentalCaseData & data)
{
  ReadTracedSideFromDrawing(data);
  LeaveOutOtherSide(data);
}
} // namespace itk
