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
#ifndef itkSilhouetteArrangement_h
#define itkSilhouetteArrangement_h

#include "itkSilhouetteGrid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
/** A projected edge from P to Q, and the points of the surface that it joins. */
struct SilhouetteSegment
{
  std::int32_t  px;
  std::int32_t  py;
  std::int32_t  qx;
  std::int32_t  qy;
  std::uint32_t a;
  std::uint32_t b;

  SilhouetteGrid::GridPoint
  P() const
  {
    return { px, py };
  }
  SilhouetteGrid::GridPoint
  Q() const
  {
    return { qx, qy };
  }
};

/** A stretch of the boundary: segment from one position to another. */
struct SilhouetteStretch
{
  std::uint32_t            segment;
  SilhouetteGrid::Fraction from;
  SilhouetteGrid::Fraction to;
};

/** The planar arrangement of the candidate edges, of which only what the walk touches is computed. */
class SilhouetteArrangement
{
public:
  using GridPoint = SilhouetteGrid::GridPoint;
  using Fraction = SilhouetteGrid::Fraction;
  using Segment = SilhouetteSegment;
  using Stretch = SilhouetteStretch;

  explicit SilhouetteArrangement(std::vector<Segment> segments);

  /** The outer boundaries of the connected parts. componentOfPoint has the part of the mesh that a point belongs to;
   * nullptr where there is one. */
  std::vector<std::vector<Stretch>>
  WalkOuterBoundaries(std::size_t components, const std::uint32_t * componentOfPoint);

  const Segment &
  GetSegment(std::uint32_t s) const
  {
    return m_Segments[s];
  }

private:
  /** Where another segment touches one: its position on both. */
  struct Event
  {
    double        t;
    Fraction      here;
    Fraction      there;
    std::uint32_t other;
  };
  struct Span
  {
    std::uint32_t begin;
    std::uint32_t count;
  };
  /** Heights of a loop's corners and its box, for the test of what lies inside. */
  struct LoopLocation
  {
    std::vector<double> y;
    double              low[2];
    double              high[2];
  };

  void
  BuildCells();
  template <typename TVisit>
  void
  ForEachCell(const Segment & segment, TVisit && visit) const;
  Span
  EventsOf(std::uint32_t s);
  void
  AddOverlap(const Segment & a, const Segment & b, const GridPoint & d, const GridPoint & e, std::uint32_t r);
  bool
  IsAt(const Segment & segment, const Fraction & t, const GridPoint & point) const;
  std::vector<Stretch>
  Walk(std::uint32_t start, std::vector<std::uint32_t> * met);
  LoopLocation
  Locate(const std::vector<Stretch> & loop) const;
  bool
  IsAbove(const Stretch & stretch, double approximate, std::int64_t height) const;
  bool
  IsInside(const GridPoint & point, const std::vector<Stretch> & loop, const LoopLocation & location) const;

  std::vector<Segment>       m_Segments;
  std::vector<Span>          m_Spans;
  std::vector<Event>         m_Events;
  std::vector<std::uint32_t> m_Stamps;
  std::uint32_t              m_Stamp{ 0 };
  std::vector<std::uint32_t> m_Near;
  GridPoint                  m_Low{ 0, 0 };
  int                        m_Shift{ 0 };
  std::size_t                m_Columns{ 0 };
  /** The segments that pass through each cell. */
  std::vector<std::uint32_t> m_CellStarts;
  std::vector<std::uint32_t> m_CellSegments;
};
} // namespace itk

#endif
