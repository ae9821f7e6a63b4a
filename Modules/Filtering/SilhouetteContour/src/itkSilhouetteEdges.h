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
#ifndef itkSilhouetteEdges_h
#define itkSilhouetteEdges_h

#include "itkPerspectiveProjection.h"
#include "itkSilhouetteArrangement.h"
#include "itkSilhouetteEdgeClusters.h"
#include "itkSilhouetteGrid.h"
#include "itkTriangleSurface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
/** The edges of a surface with their faces, points at one position merged, and which of them a projection needs. */
class SilhouetteEdges
{
public:
  using Vector3 = std::array<double, 3>;
  using GridPoint = SilhouetteGrid::GridPoint;

  struct EdgeType
  {
    std::uint32_t a;
    std::uint32_t b;
  };

  /** The rounding grid of one projection. */
  struct GridType
  {
    double u0;
    double v0;
    double scale;
    double depthMax;
    /** Largest length of an image vector that a unit vector in the surface's box projects to, px/mm. */
    double magnification;
  };

  /** Without clusters. Throws std::invalid_argument where a point is not finite or a triangle names a point that is not
   * there. */
  explicit SilhouetteEdges(const TriangleSurface & surface);

  /** Once: from then on a pose looks at few edges, and finds the same ones in the same order. */
  void
  ClusterEdges();

  /** Throws std::domain_error where a point of a triangle is not in front of the source. */
  GridType
  MakeGrid(const PerspectiveProjection & projection) const;

  GridPoint
  Snap(const PerspectiveProjection & projection, const GridType & grid, std::uint32_t point) const
  {
    double u = 0.0;
    double v = 0.0;
    projection.Project(m_Points[point].data(), u, v);
    return { static_cast<std::int64_t>((u - grid.u0) * grid.scale + 0.5),
             static_cast<std::int64_t>((v - grid.v0) * grid.scale + 0.5) };
  }

  /** The edges whose faces do not cover both sides of the projected edge. */
  std::vector<EdgeType>
  FindCandidates(const PerspectiveProjection & projection, const GridType & grid) const;

  /** The projected edges, without those that are a point. */
  std::vector<SilhouetteSegment>
  MakeSegments(const PerspectiveProjection & projection,
               const GridType &              grid,
               const std::vector<EdgeType> & edges) const;

  const std::vector<Vector3> &
  GetPoints() const
  {
    return m_Points;
  }
  std::size_t
  GetNumberOfEdges() const
  {
    return m_NumberOfEdges;
  }
  std::size_t
  GetNumberOfBoundaryEdges() const
  {
    return m_Boundary.size();
  }
  std::size_t
  GetNumberOfNonManifoldEdges() const
  {
    return m_NumberOfNonManifoldEdges;
  }
  std::size_t
  GetNumberOfComponents() const
  {
    return m_NumberOfComponents;
  }
  /** Of each point; nullptr where there is one component. */
  const std::uint32_t *
  GetComponentOfPoint() const
  {
    return m_ComponentOfPoint.empty() ? nullptr : m_ComponentOfPoint.data();
  }

private:
  using TriangleType = TriangleSurface::TriangleType;

  void
  TakePoints(const TriangleSurface & surface);
  const std::vector<TriangleType> &
  MergePoints(const std::vector<TriangleType> & triangles, std::vector<TriangleType> & merged) const;
  void
  MeasureBox(const std::vector<TriangleType> & triangles);
  void
  BuildComponents(const std::vector<TriangleType> & triangles);
  /** Candidates among the edges of two good faces, where there are no clusters: all are looked at. */
  void
  AppendLooseCandidates(const PerspectiveProjection & projection,
                        const GridType &              grid,
                        std::vector<EdgeType> &       candidates) const;
  std::vector<SilhouetteFace>
  MakeFaces(const std::vector<TriangleType> & triangles) const;
  void
  BuildEdges(const std::vector<TriangleType> & triangles);
  template <typename TIterator>
  bool
  IsCandidate(const PerspectiveProjection & projection,
              const GridType &              grid,
              const EdgeType &              edge,
              TIterator                     begin,
              TIterator                     end) const;

  std::vector<Vector3>       m_Points;
  std::size_t                m_NumberOfEdges{ 0 };
  std::size_t                m_NumberOfNonManifoldEdges{ 0 };
  std::size_t                m_NumberOfComponents{ 0 };
  std::vector<std::uint32_t> m_ComponentOfPoint;
  /** Edges with one face. */
  std::vector<EdgeType> m_Boundary;
  /** Edges that are always tested exactly, and the third points of their faces. */
  std::vector<EdgeType>      m_Special;
  std::vector<std::uint32_t> m_SpecialStarts;
  std::vector<std::uint32_t> m_SpecialOpposites;
  /** Edges of two good faces: what clusters are made of, until they are made. */
  std::vector<SilhouetteRegularEdge> m_LooseEdges;
  std::vector<SilhouetteHalfEdge>    m_LooseHalves;
  std::vector<SilhouetteFace>        m_LooseFaces;
  /** The same in clusters. */
  SilhouetteEdgeClusters m_Regular;
  std::size_t            m_NumberOfRegular{ 0 };

  Vector3 m_Low{};
  Vector3 m_High{};
  Vector3 m_Center{};
  double  m_Radius{ 0.0 };
};
} // namespace itk

#endif
