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
#ifndef itkSilhouetteEdgeClusters_h
#define itkSilhouetteEdgeClusters_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
/** The plane n.x = d of a face, n a unit vector, x relative to a common centre, and what rounding can do to it: the
 * sum of its longer sides over twice its area, and the inverse of that area. */
struct SilhouetteFace
{
  std::array<float, 3> n;
  float                d;
  float                ratio;
  float                inverseArea;
};

/** An edge as one of its faces has it: the larger of its points, the face's third point, and twice the face's number,
 * plus one where the face runs from the larger to the smaller point. */
struct SilhouetteHalfEdge
{
  std::uint32_t other;
  std::uint32_t opposite;
  std::uint32_t face;
};

/** An edge with two faces: its smaller point and where its two half-edges begin. */
struct SilhouetteRegularEdge
{
  std::uint32_t point;
  std::uint32_t half;
};

/** Where the source is, in single precision, and what tells which side of a face it is on: n.source - d is beyond
 * doubt if it is more than perRatio * ratio + perInverseArea * inverseArea + slack. */
struct SilhouettePlaneTest
{
  float x;
  float y;
  float z;
  /** Of the source from the common centre. */
  float distance;
  float perRatio;
  float perInverseArea;
  float slack;
};

/** Edges in clusters of similar faces, so that a pose looks at few of them: a cluster is skipped where mean plane and
 * radii prove that the source is on the same side of all its faces. */
class SilhouetteEdgeClusters
{
public:
  struct EdgeType
  {
    std::uint32_t                a;
    std::uint32_t                b;
    std::array<std::uint32_t, 2> opposites;
  };

  /** Along a Morton curve through the planes of an edge's faces. Clusters have the edges in the order of their keys,
   * and where these are the same in the order in which they are given. */
  static std::uint32_t
  KeyOf(const SilhouetteRegularEdge &           edge,
        const std::vector<SilhouetteHalfEdge> & halves,
        const std::vector<SilhouetteFace> &     faces,
        double                                  radius);

  /** Distances are at most radius. */
  void
  Build(const std::vector<SilhouetteRegularEdge> & edges,
        const std::vector<SilhouetteHalfEdge> &    halves,
        const std::vector<SilhouetteFace> &        faces,
        double                                     radius);

  /** The edges whose faces may have the source on different sides, in an order that depends on the mesh alone: twice
   * the number of the edge, plus one where they have beyond doubt. */
  std::vector<std::uint32_t>
  FindCandidates(const SilhouettePlaneTest & test) const;

  const EdgeType *
  GetEdges() const
  {
    return m_Edges.data();
  }

private:
  /** Edges a block, blocks a cluster. */
  static constexpr std::size_t BlockSize = 8;
  static constexpr std::size_t ClusterBlocks = 4;
  static constexpr std::size_t ClusterSize = BlockSize * ClusterBlocks;

  /** Of a set of planes: mean normal and distance, radii around both, largest ratio and inverse area. */
  static constexpr std::size_t NumberOfBounds = 8;
  using BoundsType = std::array<float, NumberOfBounds>;

  /** Eight edges with the planes of both faces: n in units of 1 / PlaneUnit, d of the radius / PlaneUnit. */
  struct Block
  {
    std::int16_t n[2][3][BlockSize];
    std::int16_t d[2][BlockSize];
  };
  struct BlockBounds
  {
    float values[NumberOfBounds][ClusterBlocks];
  };
  /** The planes of a cluster, faces of an edge side by side. */
  struct Planes
  {
    float values[6][2 * ClusterSize];
  };

  static BoundsType
  BoundsOf(const Planes & planes, std::size_t begin, std::size_t count);
  static void
  MeasureDecision(const SilhouettePlaneTest & test,
                  const float * const         bounds[NumberOfBounds],
                  std::size_t                 count,
                  float *                     margins);
  static std::uint32_t
  ClassifyBlock(const Block & block, const SilhouettePlaneTest & test, float radius, float bound);

  /** In blocks, padded at the end with edges from a point to itself. */
  std::vector<EdgeType>    m_Edges;
  std::vector<Block>       m_Blocks;
  std::vector<BlockBounds> m_BlockBounds;
  std::vector<float>       m_ClusterBounds[NumberOfBounds];
  float                    m_Radius{ 0.0f };
};
} // namespace itk

#endif
