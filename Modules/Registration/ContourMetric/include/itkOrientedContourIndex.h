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
#ifndef itkOrientedContourIndex_h
#define itkOrientedContourIndex_h

#include "itkContourStrand.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
/** \class OrientedContourIndex
 * \brief Nearest place of a contour in position and line direction, among the teeth that are allowed.
 *
 * The targets are the contour's segments, and its points without a segment. The squared distance of a target is
 *
 *   D^2 = d^2 + weight sin^2(angle between the directions)
 *
 * with d the distance to the nearest point of the segment. Directions are those of lines, without a sense; where one is
 * unknown, (0, 0), the angle counts as 0. Of equally near targets the first one. Targets are searched in boxes of eight
 * along the contour; the result is that of the comparison with every target. Any number of threads may search at once.
 * Free of ITK.
 *
 * Source of the distance: Liu et al., Fast Directional Chamfer Matching, CVPR 2010.
 *
 * \ingroup ContourMetric
 */
class ContourMetric_EXPORT OrientedContourIndex
{
public:
  /** Bits 0 .. 7 upper teeth by position, 8 .. 15 lower teeth, 16 unknown. Sides of the patient are not told apart: on
   * a lateral radiograph a tooth lies on its fellow. */
  using CodeMaskType = std::uint32_t;
  static constexpr CodeMaskType AllCodes = 0x1ffff;

  static CodeMaskType
  GetCodeMask(std::uint8_t fdi);

  /** The codes that a point of this code may be matched with: itself, its neighbours up to range positions away in the
   * same jaw, and unknown ones; all for an unknown code. */
  static CodeMaskType
  GetAllowedCodes(std::uint8_t fdi, unsigned int range);
  /** What is searched for. */
  struct TargetType
  {
    double x;
    double y;
    double dx;
    double dy;
    double inverseSquaredLength;
    /** Smoothed line direction, unit or (0, 0). */
    double       directionX;
    double       directionY;
    CodeMaskType code;
    /** The segment's end points; equal for a lone point. */
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t strand;
    /** Arc length of its start along the strand. */
    double arc;
    double length;
    /** Whether the strand ends there. */
    bool startIsEnd;
    bool endIsEnd;
  };
  /** The nearest target of a query. */
  struct MatchType
  {
    /** D^2 and d^2; the target is meaningless where D^2 is infinite: nothing was allowed. */
    double        squaredDistance;
    double        squaredPositionDistance;
    double        x;
    double        y;
    std::uint32_t target;
    /** Place along the target, 0 .. 1. */
    double part;
  };

  /** Directions are smoothed along the contour by a Gaussian of this sigma. */
  void
  Initialize(const ContourArrays & contour, const std::vector<ContourStrand> & strands, double directionSigma);

  MatchType
  Find(double       x,
       double       y,
       double       directionX = 0.0,
       double       directionY = 0.0,
       double       weight = 0.0,
       CodeMaskType allowed = AllCodes) const;

  const std::vector<TargetType> &
  GetTargets() const
  {
    return m_Targets;
  }

private:
  struct BoxType
  {
    double       low[2];
    double       high[2];
    CodeMaskType codes;
  };
  static constexpr std::size_t TargetsOfBox = 8;

  std::vector<TargetType> m_Targets;
  std::vector<BoxType>    m_Boxes;
};
} // namespace itk

#endif
