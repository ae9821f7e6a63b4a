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
#include "itkTracedToothRow.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** The direction in which points are spread most. */
std::array<double, 2>
FindDirection(const DentalContour::PolylinesType & polylines)
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

TracedToothRow::TracedToothRow(const DentalContour::PolylinesType & polylines)
  : m_Direction(FindDirection(polylines))
{
  for (const auto & polyline : polylines)
  {
    for (std::size_t i = 0; i < polyline.points.size(); ++i)
    {
      // What counts for nothing tells nothing.
      if (polyline.GetTooth(i).IsKnown() && (polyline.weights.empty() || polyline.weights[i] > 0.0))
      {
        SpanType &   span = m_Spans[polyline.GetTooth(i).GetFDI()];
        const double place = this->ToRow(polyline.points[i][0], polyline.points[i][1]);
        span.low = std::min(span.low, place);
        span.high = std::max(span.high, place);
        ++span.points;
      }
    }
  }
  double sum = 0.0;
  for (const auto & front : m_Spans)
  {
    for (const auto & back : m_Spans)
    {
      const ToothCode first(front.first);
      const ToothCode second(back.first);
      if (first.GetQuadrant() == second.GetQuadrant() && first.GetPosition() < second.GetPosition())
      {
        sum += back.second.GetMiddle() - front.second.GetMiddle();
      }
    }
  }
  m_Backward = sum > 0.0 ? 1.0 : sum < 0.0 ? -1.0 : 0.0;
}

const TracedToothRow::SpanType *
TracedToothRow::Find(const ToothCode & tooth) const
{
  const auto found = m_Spans.find(tooth.GetFDI());
  return found != m_Spans.end() && found->second.points >= FewestPoints ? &found->second : nullptr;
}

const TracedToothRow::SpanType *
TracedToothRow::FindPosition(unsigned int position) const
{
  const SpanType * found = nullptr;
  for (const auto & entry : m_Spans)
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

std::optional<TracedToothRow::SpanType>
TracedToothRow::FindWithin(const ToothCode & tooth) const
{
  if (const SpanType * line = this->Find(tooth))
  {
    return *line;
  }
  // Of the teeth between a neighbour on both sides; a gap of less than two thirds of their own extent was closed.
  constexpr double leastShare = 0.67;
  const auto       position = tooth.GetPosition();
  if (!tooth.IsKnown() || tooth.IsPrimary() || position < 2 || position > 7)
  {
    return {};
  }
  const SpanType * mesial = this->Find(ToothCode(static_cast<std::uint8_t>(tooth.GetFDI() - 1)));
  const SpanType * distal = this->Find(ToothCode(static_cast<std::uint8_t>(tooth.GetFDI() + 1)));
  if (mesial == nullptr || distal == nullptr || m_Backward == 0.0)
  {
    return {};
  }
  SpanType gap;
  gap.low = m_Backward > 0.0 ? mesial->high : distal->high;
  gap.high = m_Backward > 0.0 ? distal->low : mesial->low;
  const double own = 0.5 * (mesial->GetExtent() + distal->GetExtent());
  return gap.GetExtent() > leastShare * own ? std::optional<SpanType>(gap) : std::nullopt;
}
} // namespace itk
