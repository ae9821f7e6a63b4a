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
#include "itkWholeToothOutline.h"

#include "itkContourResampling.h"
#include "itkPoseModel.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** Share of a tooth's length that is its crown: first to third tooth, and those behind them. */
constexpr double UpperFrontShare = 10.5 / 23.5;
constexpr double LowerFrontShare = 9.0 / 21.5;
constexpr double UpperBackShare = 7.5 / 20.0;
constexpr double LowerBackShare = 7.5 / 21.5;
/** Of the crown from its occlusal end: what gingiva leaves free. */
constexpr double FreeShare = 0.9;
/** Of what the scan shows of it: where a crown was cut across, its outline ends at different heights all around. */
constexpr double ScannedShare = 0.85;
/** Shortest and longest tooth with its root, mm. Of the shared standard tracings lower incisors are 11 to 14.5 mm long,
 * as roots alone are: those are told by where they lie. A lower central incisor of 16 mm and a canine of 33 are known;
 * roots are resorbed by a quarter in orthodontic treatment, are seen at a slant, and hands end them early, where bone
 * hides them. */
constexpr double ShortestTooth = 10.0;
constexpr double LongestTooth = 40.0;
/** Length over width. A molar with its roots is twice as long as it is wide, and half of the difference to a crown
 * alone, which is as wide as it is high, may be lost by roots that are drawn short. */
constexpr double SmallestElongation = 1.1;
/** Of a front tooth: whole ones of phantoms and of the shared tracings have 2.3 or more, with roots that are drawn
 * short, and their crowns alone 1.5 to 1.8. */
constexpr double SmallestFrontElongation = 2.05;
/** Of the long axis of a tooth behind the canine against the film's vertical, degrees: whole ones lean by 23 at most, a
 * crown alone is wider than it is high, and its long axis lies along the arch. */
constexpr double LargestBackTilt = 50.0;
constexpr double DegreesPerRadian = 57.29577951308232;
/** px over which the lingual side begins behind the incisal edge, 1.5 mm. */
constexpr double EdgeLength = 6.0;
/** Points of a crown, 2.5 px apart, that say where it lies. */
constexpr std::size_t FewestCrownPoints = 5;
/** Position of the canine. */
constexpr unsigned int LastFrontPosition = 3;

double
ShareOf(ToothCode::JawEnum jaw, unsigned int position)
{
  const bool upper = jaw == ToothCode::JawEnum::Upper;
  return position <= LastFrontPosition ? (upper ? UpperFrontShare : LowerFrontShare)
                                       : (upper ? UpperBackShare : LowerBackShare);
}
} // namespace

WholeToothOutline::WholeToothOutline(const PoseGeometry &                geometry,
                                     const DentalContour::PolylineType & polyline,
                                     ToothCode::JawEnum                  jaw,
                                     double                              scanned)
{
  m_Position = polyline.code.GetPosition();
  std::vector<PointType> drawn;
  for (const auto & pixel : polyline.points)
  {
    drawn.push_back(PoseModel::ToWorkingPlane(geometry, { { pixel[0], pixel[1] } }));
  }
  if (polyline.outline == DentalContour::OutlineEnum::Crown || polyline.outline == DentalContour::OutlineEnum::Labial)
  {
    m_Failure = polyline.outline == DentalContour::OutlineEnum::Crown
                  ? "it is of a crown without its root, as its \"outline\" says"
                  : "it is of a labial side alone, as its \"outline\" says";
    return;
  }
  if (drawn.size() < 8)
  {
    m_Failure = "it has " + std::to_string(drawn.size()) + " points, at least 8 are needed";
    return;
  }
  const double length = ComputePolylineLength(drawn, true);
  const double gap = std::hypot(drawn.front()[0] - drawn.back()[0], drawn.front()[1] - drawn.back()[1]);
  if (!polyline.closed && gap > 0.1 * length)
  {
    m_Failure = "it is not closed";
    return;
  }
  std::vector<PointType> points = Resample(drawn, true);
  const std::size_t      count = points.size();
  if (points.empty())
  {
    m_Failure = "all its points are one";
    return;
  }
  // The long axis of the line as a wire.
  for (const PointType & p : points)
  {
    m_Centroid[0] += p[0] / static_cast<double>(count);
    m_Centroid[1] += p[1] / static_cast<double>(count);
  }
  double uu = 0.0, uv = 0.0, vv = 0.0;
  for (const PointType & p : points)
  {
    const double a = p[0] - m_Centroid[0];
    const double b = p[1] - m_Centroid[1];
    uu += a * a;
    uv += a * b;
    vv += b * b;
  }
  const double angle = 0.5 * std::atan2(2.0 * uv, uu - vv);
  m_Axis = { { std::cos(angle), std::sin(angle) } };
  const double occlusal = jaw == ToothCode::JawEnum::Upper ? 1.0 : -1.0;
  if (occlusal * m_Axis[1] < 0.0)
  {
    m_Axis = { { -m_Axis[0], -m_Axis[1] } };
  }
  const auto along = [&](const PointType & p) {
    return (p[0] - m_Centroid[0]) * m_Axis[0] + (p[1] - m_Centroid[1]) * m_Axis[1];
  };
  // Perpendicular to the axis, anterior.
  PointType anterior{ { -m_Axis[1], m_Axis[0] } };
  if (anterior[0] < 0.0)
  {
    anterior = { { -anterior[0], -anterior[1] } };
  }
  const auto across = [&](const PointType & p) {
    return (p[0] - m_Centroid[0]) * anterior[0] + (p[1] - m_Centroid[1]) * anterior[1];
  };
  double low = 0.0, high = 0.0, back = 0.0, front = 0.0;
  for (const PointType & p : points)
  {
    low = std::min(low, along(p));
    high = std::max(high, along(p));
    back = std::min(back, across(p));
    front = std::max(front, across(p));
  }
  m_Length = high - low;
  const bool isFront = m_Position <= LastFrontPosition;
  m_Elongation = m_Length / (front - back);
  const double tilt = std::acos(std::min(1.0, std::abs(m_Axis[1]))) * DegreesPerRadian;
  std::string  doubt;
  if (m_Elongation < SmallestElongation)
  {
    doubt = "it is about as wide as it is long";
  }
  else if (isFront && m_Elongation < SmallestFrontElongation)
  {
    doubt = "it is too wide for its length";
  }
  else if (!isFront && tilt > LargestBackTilt)
  {
    doubt = "its long axis lies along the arch";
  }
  if (!doubt.empty() && polyline.outline != DentalContour::OutlineEnum::Tooth)
  {
    m_Failure =
      doubt + ": is it a crown without its root? Draw the whole tooth; if it is one say so by \"outline\": \"tooth\"";
    return;
  }
  const double millimetres = m_Length * PoseWorkingPixel * geometry.sourceToMidsagittal / geometry.sourceToDetector;
  if (geometry.pixelSpacingKnown && (millimetres < ShortestTooth || millimetres > LongestTooth))
  {
    m_Failure = "it is " + std::to_string(std::lround(millimetres)) +
                " mm long, and no tooth is: is it a root or a crown alone, or is pixel_spacing_mm wrong?";
    return;
  }
  // From the root's end around, so that the crown is one run.
  std::rotate(points.begin(),
              std::min_element(points.begin(),
                               points.end(),
                               [&](const PointType & a, const PointType & b) { return along(a) < along(b); }),
              points.end());
  double area = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const PointType & a = points[i];
    const PointType & b = points[(i + 1) % count];
    area += a[0] * b[1] - a[1] * b[0];
  }
  const double sign = area > 0.0 ? 1.0 : -1.0;
  // Of a label map the border of one jaw against the other is the other tooth's edge, and has no weight.
  const auto isHidden = [&](const PointType & p) {
    if (polyline.weights.empty())
    {
      return false;
    }
    const auto nearest = std::min_element(drawn.begin(), drawn.end(), [&p](const PointType & a, const PointType & b) {
      return std::hypot(a[0] - p[0], a[1] - p[1]) < std::hypot(b[0] - p[0], b[1] - p[1]);
    });
    return !(polyline.weights[static_cast<std::size_t>(nearest - drawn.begin())] > 0.0);
  };
  const double neck = high - std::min(FreeShare * ShareOf(jaw, m_Position) * m_Length, ScannedShare * scanned);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (along(points[i]) < neck || isHidden(points[i]))
    {
      continue;
    }
    PointType normal = ComputeNormal(points, i, true);
    normal = { { sign * normal[0], sign * normal[1] } };
    double lingual = 0.0;
    if (m_Position <= LastFrontPosition && normal[0] * anterior[0] + normal[1] * anterior[1] < 0.0)
    {
      lingual = std::min(1.0, (high - along(points[i])) / EdgeLength);
    }
    this->AddPoint(points[i], normal, lingual);
  }
  if (m_Points.size() < FewestCrownPoints)
  {
    m_Failure = "next to nothing of its crown's border is its own: the rest has no weight, as where it lies against a "
                "tooth of the other jaw";
    return;
  }
  m_Reference = *std::max_element(
    m_Points.begin(), m_Points.end(), [&](const PointType & a, const PointType & b) { return along(a) < along(b); });
  if (m_Position > LastFrontPosition)
  {
    m_Reference = { { 0.0, 0.0 } };
    for (const PointType & p : m_Points)
    {
      m_Reference[0] += p[0] / static_cast<double>(m_Points.size());
      m_Reference[1] += p[1] / static_cast<double>(m_Points.size());
    }
  }
}
} // namespace itk
