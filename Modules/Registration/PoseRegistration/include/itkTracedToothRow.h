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
#ifndef itkTracedToothRow_h
#define itkTracedToothRow_h

#include "PoseRegistrationExport.h"
#include "itkDentalContour.h"
#include "itkToothCode.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

namespace itk
{
/** \class TracedToothRow
 * \brief Where along the row of teeth each tooth of a tracing is, to tell on which of them a point lies.
 *
 * The row runs in the direction in which the tracing's points are spread most. Places along it are in pixels of the
 * radiograph.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT TracedToothRow
{
public:
  /** Cusps stand before and behind a molar's middle, by this share of its extent. */
  static constexpr double CuspShare = 0.24;
  /** Of a line that shows how far its tooth reaches; a few points say where a tooth is, and not how far it reaches. */
  static constexpr std::size_t FewestPoints = 10;

  /** The extent of a tooth along the row, pixels. */
  struct SpanType
  {
    double      low{ std::numeric_limits<double>::max() };     /**< The end at the lower place. */
    double      high{ std::numeric_limits<double>::lowest() }; /**< The end at the higher place. */
    std::size_t points{ 0 };                                   /**< Of the tooth's line. */

    double
    GetMiddle() const
    {
      return 0.5 * (low + high);
    } /**< The place between both ends. */
    double
    GetExtent() const
    {
      return high - low;
    } /**< The distance of both ends. */
  };

  TracedToothRow() = default;
  /** Of a tracing's lines, continuous pixel indices; lines without a tooth's code tell the direction alone, as
   * points of weight 0 do. */
  explicit TracedToothRow(const DentalContour::PolylinesType & polylines);

  /** The place of a pixel along the row. */
  double
  ToRow(double u, double v) const
  {
    return m_Direction[0] * u + m_Direction[1] * v;
  }

  /** The tooth of a code; null where it has no line, or too few points. */
  const SpanType *
  Find(const ToothCode & tooth) const;
  /** The tooth of a position in its quadrant, 1 to 8, of whichever side; null where Find() is, or where both sides have
   * one. */
  const SpanType *
  FindPosition(unsigned int position) const;

  /** Find(), or where a tooth has no line of its own the gap between those of both its neighbours, where it is wide
   * enough for it; none where they do not tell. */
  std::optional<SpanType>
  FindWithin(const ToothCode & tooth) const;

  /** A place on a tooth, as a share of its extent from its middle toward the back. */
  double
  GetPlace(const SpanType & span, double shareBehindMiddle) const
  {
    return span.GetMiddle() + m_Backward * shareBehindMiddle * span.GetExtent();
  }

private:
  std::array<double, 2>            m_Direction{ { 1.0, 0.0 } };
  std::map<std::uint8_t, SpanType> m_Spans;
  /** +1 where the teeth at the back lie at the higher end of the row, -1 where at the lower, 0 where no two tell. */
  double m_Backward{ 0.0 };
};
} // namespace itk

#endif
