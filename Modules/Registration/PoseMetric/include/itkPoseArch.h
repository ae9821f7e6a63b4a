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
#ifndef itkPoseArch_h
#define itkPoseArch_h

#include "PoseMetricExport.h"
#include "itkToothCode.h"
#include "itkTriangleSurface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** \class PoseArch
 * \brief The dental arch as a curve in the occlusal plane, to tell how far along it a point is from the midline.
 *
 * Built from the crown band: points within 4 mm of the 99th height percentile of their polar sector, where
 * that is at most 8 mm below the others'. In the dental frame, mm. Not valid for a surface of fewer than 100 points, or
 * one that fills too few sectors.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT PoseArch
{
public:
  PoseArch() = default;
  PoseArch(const TriangleSurface & surface, ToothCode::JawEnum jaw); /**< In the dental frame, mm. */
  /** Whether the surface has enough of an arch; where not, it tells nothing. */
  bool
  IsValid() const
  {
    return m_Curve.size() >= 4;
  }

  /** Arc length from the midline to the nearest point of the curve, mm; negative on the patient's right. */
  double
  Arc(double x, double y) const;

  /** Distance of a point from the curve, mm; positive outside, on the lips' and cheeks' side. */
  double
  Offset(double x, double y) const;

  /** Width of the curve along y, mm. */
  double
  Width() const;

  /** The curve is through the middle of the crowns and smooth, and so shorter than the row of the teeth's widths by
   * this factor (phantoms: 0.94 to 0.96 at the first molars). */
  static constexpr double CurveShare = 0.95;

  /** Expected arc length from the midline to the middle of a tooth by textbook mesio-distal widths, mm; 0 for an
   * unknown tooth and for third molars, whose place is not settled. */
  static double
  ExpectedArc(std::uint8_t tooth);

  /** Textbook mesio-distal width of a tooth, mm; 0 where ExpectedArc() is. */
  static double
  ExpectedWidth(std::uint8_t tooth);

  /** Position in its quadrant, 1 (central incisor) to 8, of the tooth that stands at this distance from the midline by
   * the same widths; the sign of the arc does not matter. */
  static std::uint8_t
  ExpectedPosition(double arc, ToothCode::JawEnum jaw);

private:
  /** Arc and offset of a point by the nearest segment. */
  std::array<double, 2>
  Locate(double x, double y) const;

  std::vector<std::array<double, 2>> m_Curve;
  std::vector<double>                m_Arc;
};
} // namespace itk

#endif
