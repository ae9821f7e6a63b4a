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
#include "itkOrientedContourIndex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
OrientedContourIndex::CodeMaskType
OrientedContourIndex::GetCodeMask(std::uint8_t fdi)
{
  const unsigned int quadrant = fdi / 10u;
  const unsigned int position = fdi % 10u;
  if (quadrant < 1 || quadrant > 4 || position < 1 || position > 8)
  {
    return 1u << 16;
  }
  return 1u << ((quadrant <= 2 ? 0u : 8u) + position - 1u);
}

OrientedContourIndex::CodeMaskType
OrientedContourIndex::GetAllowedCodes(std::uint8_t fdi, unsigned int range)
{
  CodeMaskType mask = GetCodeMask(fdi);
  if (mask == 1u << 16)
  {
    return AllCodes;
  }
  const CodeMaskType jaw = mask <= 0xff ? 0xffu : 0xff00u;
  for (unsigned int i = 0; i < std::min(range, 8u); ++i)
  {
    mask |= ((mask << 1) | (mask >> 1)) & jaw;
  }
  return mask | 1u << 16;
}

void
OrientedContourIndex::Initialize(const ContourArrays &              contour,
                                 const std::vector<ContourStrand> & strands,
                                 double                             directionSigma)
{
  m_Targets.clear();
  m_Boxes.clear();
  for (std::size_t s = 0; s < strands.size(); ++s)
  {
    const ContourStrand & strand = strands[s];
    const auto            codeOf = [&](std::uint32_t id) {
      return GetCodeMask(contour.codes.empty() ? std::uint8_t{ 0 } : contour.codes[id]);
    };
    const auto          arc = strand.GetArcLengths(contour);
    const auto          directions = strand.GetSegmentDirections(contour, directionSigma);
    const std::size_t   segments = strand.GetNumberOfSegments();
    const std::uint32_t number = static_cast<std::uint32_t>(s);
    if (segments == 0)
    {
      const std::uint32_t id = strand.ids[0];
      m_Targets.push_back({ contour.points[2 * id],
                            contour.points[2 * id + 1],
                            0.0,
                            0.0,
                            0.0,
                            0.0,
                            0.0,
                            codeOf(id),
                            id,
                            id,
                            number,
                            0.0,
                            0.0,
                            true,
                            true });
    }
    for (std::size_t i = 0; i < segments; ++i)
    {
      const std::uint32_t from = strand.ids[i];
      const std::uint32_t to = strand.ids[(i + 1) % strand.ids.size()];
      TargetType          target{};
      target.x = contour.points[2 * from];
      target.y = contour.points[2 * from + 1];
      target.dx = contour.points[2 * to] - target.x;
      target.dy = contour.points[2 * to + 1] - target.y;
      const double squaredLength = target.dx * target.dx + target.dy * target.dy;
      target.inverseSquaredLength = squaredLength > 0.0 ? 1.0 / squaredLength : 0.0;
      target.directionX = directions[2 * i];
      target.directionY = directions[2 * i + 1];
      // A segment between two teeth belongs to both.
      target.code = codeOf(from) | codeOf(to);
      target.from = from;
      target.to = to;
      target.strand = number;
      target.arc = arc[i];
      target.length = std::sqrt(squaredLength);
      target.startIsEnd = !strand.closed && i == 0;
      target.endIsEnd = !strand.closed && i + 1 == segments;
      m_Targets.push_back(target);
    }
  }
  for (std::size_t first = 0; first < m_Targets.size(); first += TargetsOfBox)
  {
    const std::size_t last = std::min(first + TargetsOfBox, m_Targets.size());
    BoxType           box{ { m_Targets[first].x, m_Targets[first].y }, { m_Targets[first].x, m_Targets[first].y }, 0 };
    for (std::size_t k = first; k < last; ++k)
    {
      const TargetType & target = m_Targets[k];
      box.low[0] = std::min({ box.low[0], target.x, target.x + target.dx });
      box.low[1] = std::min({ box.low[1], target.y, target.y + target.dy });
      box.high[0] = std::max({ box.high[0], target.x, target.x + target.dx });
      box.high[1] = std::max({ box.high[1], target.y, target.y + target.dy });
      box.codes |= target.code;
    }
    m_Boxes.push_back(box);
  }
}

OrientedContourIndex::MatchType
OrientedContourIndex::Find(
  double x, double y, double directionX, double directionY, double weight, CodeMaskType allowed) const
{
  MatchType  best{ std::numeric_limits<double>::infinity(), 0.0, x, y, 0, 0.0 };
  const auto boundOf = [&](const BoxType & box) {
    const double dx = std::max({ box.low[0] - x, x - box.high[0], 0.0 });
    const double dy = std::max({ box.low[1] - y, y - box.high[1], 0.0 });
    return dx * dx + dy * dy;
  };
  const auto scan = [&](std::size_t b) {
    const std::size_t last = std::min((b + 1) * TargetsOfBox, m_Targets.size());
    for (std::size_t k = b * TargetsOfBox; k < last; ++k)
    {
      const TargetType & target = m_Targets[k];
      if ((target.code & allowed) == 0)
      {
        continue;
      }
      const double part = std::min(
        1.0, std::max(0.0, ((x - target.x) * target.dx + (y - target.y) * target.dy) * target.inverseSquaredLength));
      const double footX = target.x + part * target.dx;
      const double footY = target.y + part * target.dy;
      const double ex = footX - x;
      const double ey = footY - y;
      const double d2 = ex * ex + ey * ey;
      const double sine = directionX * target.directionY - directionY * target.directionX;
      const double total = d2 + weight * sine * sine;
      const auto   number = static_cast<std::uint32_t>(k);
      if (total < best.squaredDistance || (total == best.squaredDistance && number < best.target))
      {
        best = { total, d2, footX, footY, number, part };
      }
    }
  };
  // The nearest box first: most others are then too far.
  std::size_t nearest = m_Boxes.size();
  double      bound = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < m_Boxes.size(); ++b)
  {
    if ((m_Boxes[b].codes & allowed) != 0)
    {
      const double d2 = boundOf(m_Boxes[b]);
      if (d2 < bound)
      {
        bound = d2;
        nearest = b;
      }
    }
  }
  if (nearest == m_Boxes.size())
  {
    return best;
  }
  scan(nearest);
  for (std::size_t b = 0; b < m_Boxes.size(); ++b)
  {
    if (b != nearest && (m_Boxes[b].codes & allowed) != 0 && boundOf(m_Boxes[b]) <= best.squaredDistance)
    {
      scan(b);
    }
  }
  return best;
}
} // namespace itk
