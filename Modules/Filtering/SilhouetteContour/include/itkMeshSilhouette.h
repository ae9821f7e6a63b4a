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
#ifndef itkMeshSilhouette_h
#define itkMeshSilhouette_h

#include "SilhouetteContourExport.h"
#include "itkPerspectiveProjection.h"
#include "itkTriangleSurface.h"

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace itk
{
/** \struct SilhouetteLoop
 * \brief One closed outer boundary of a projection, with the points of the surface that make it.
 *
 * Points are continuous pixel indices, the first is not repeated. Segment i runs from points[i] to points[i + 1] (the
 * last to points[0]) and lies on the projection of one mesh edge. The inside is where v grows when u grows along the
 * loop: the shoelace area in (u, v) is positive, on the screen, where v points down, the loop runs clockwise. The
 * outward unit normal of a segment (du, dv) is therefore (dv, -du) / length.
 *
 * \ingroup SilhouetteContour
 */
struct SilhouetteLoop
{
  std::vector<std::array<double, 2>> points; /**< Pixels, in order; the first is not repeated. */
  /** Of segment i: the points on its mesh edge, in the object's frame (mm), that project to its start and its end. */
  std::vector<std::array<double, 3>> rimStart;
  std::vector<std::array<double, 3>> rimEnd;
  /** Of segment i: the ends of its mesh edge, as indices into the surface's points. */
  std::vector<std::array<std::uint32_t, 2>> edges;

  /** Enclosed area, square pixels. */
  double
  Area() const
  {
    double twice = 0.0;
    for (std::size_t i = 0, count = points.size(); i < count; ++i)
    {
      const std::array<double, 2> & p = points[i];
      const std::array<double, 2> & q = points[i + 1 < count ? i + 1 : 0];
      twice += (p[0] - points[0][0]) * (q[1] - points[0][1]) - (p[1] - points[0][1]) * (q[0] - points[0][0]);
    }
    return 0.5 * twice;
  }
};

/** \struct Silhouette
 * \brief The outer boundaries of the connected parts of a projection, largest area first.
 * \ingroup SilhouetteContour
 */
struct Silhouette
{
  std::vector<SilhouetteLoop> loops; /**< Outer boundaries, each closed; holes are left out. */
};

/** \class MeshSilhouette
 * \brief The exact outer boundary of a surface's perspective projection, that is of the union of all its projected
 * triangles. Free of ITK headers.
 *
 * The constructor prepares what does not depend on the pose: points at the same position are merged, edges are paired
 * with their faces and sorted into clusters of similar faces. A pose then costs much less than a look at every
 * triangle: clusters whose faces all look one way are skipped as a whole. Made for one pose, it looks at every edge.
 *
 * Projected points are rounded to a grid of a power of two, at most 2^-12 px for projections of up to 65 536 px
 * (2^-18 px at 1000 px), and everything that follows is decided in integers: which edges separate covered from
 * uncovered sides, which cross, in what order along an edge, where to turn. There is no tolerance and no pose or mesh
 * for which the walk around the boundary does not close: open shells, several parts, T-junctions, non-manifold edges,
 * duplicate, needle and degenerate triangles, axis-aligned views are ordinary input. Orientation of the triangles is
 * not needed. Faces seen exactly edge-on count as the line they project to, so that a loop may run there and back;
 * triangles with two corners at one position are left out.
 *
 * Holes are ignored, and parts that lie inside another part's outer boundary.
 *
 * Every method is const and safe to call from several threads; the result depends on mesh and projection alone.
 *
 * \ingroup SilhouetteContour
 */
class SilhouetteContour_EXPORT MeshSilhouette
{
public:
  using EdgeType = std::pair<std::uint32_t, std::uint32_t>;

  /** How many poses will be asked for. Clusters take some hundred times as long to make as they save in one pose; what
   * comes out is the same to the last bit, with them and without. */
  enum class PosesEnum : std::uint8_t
  {
    One,
    Many
  };

  /** Throws std::invalid_argument where a point is not finite or a triangle names a point that is not there. */
  explicit MeshSilhouette(const TriangleSurface & surface, PosesEnum poses = PosesEnum::Many);
  ~MeshSilhouette();
  MeshSilhouette(MeshSilhouette &&) noexcept;
  MeshSilhouette &
  operator=(MeshSilhouette &&) noexcept;

  /** Makes the clusters of one that was made for one pose, when more are asked for; not const, hence not while others
   * ask it. Does nothing where they are there. */
  void
  ClusterEdges();

  /** Empty for a surface without triangles. Throws std::domain_error where a point of a triangle is not in front of the
   * source or the projection is not finite. */
  Silhouette
  ComputeOuterBoundary(const PerspectiveProjection & projection) const;

  /** The contour generator: edges whose faces do not cover both sides of the edge's projection, hence also every
   * boundary edge. Pairs of indices into the surface's points (the first of those at one position), smaller index
   * first, in an order that depends on the mesh alone. */
  std::vector<EdgeType>
  ComputeSilhouetteEdges(const PerspectiveProjection & projection) const;

  /** Edges after merging, and those among them with one face and with more than two. */
  std::size_t
  GetNumberOfEdges() const;
  std::size_t
  GetNumberOfBoundaryEdges() const;
  std::size_t
  GetNumberOfNonManifoldEdges() const;
  /** Parts of the surface that share no point. */
  std::size_t
  GetNumberOfComponents() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> m_Implementation;
};

/** \struct SilhouetteSample
 * \brief A point of a silhouette with all that a registration needs of it.
 * \ingroup SilhouetteContour
 */
struct SilhouetteSample
{
  /** Continuous pixel index. */
  double u{ 0.0 };
  double v{ 0.0 };
  /** Outward unit normal in the image. */
  std::array<double, 2> normal{};
  /** The point of the surface that projects here, object frame, mm. As the pose changes, the silhouette moves along the
   * normal as this point does (to first order), which makes derivatives exact without the rim's own motion. */
  std::array<double, 3> rim{};
  /** Arc length from the loop's first point, px. */
  double arcLength{ 0.0 };
  /** Index of the loop's segment. */
  std::uint32_t segment{ 0 };
};

/** The corners of a loop; the normal is that of the segment that begins there. */
SilhouetteContour_EXPORT std::vector<SilhouetteSample>
                         SampleSilhouetteLoopCorners(const SilhouetteLoop & loop);

/** The given number of points at equal distances along a loop, beginning at its first point. The rim point is
 * interpolated on the mesh edge so that it projects to the sample. Empty for an empty loop or one of no length. */
SilhouetteContour_EXPORT std::vector<SilhouetteSample>
ResampleSilhouetteLoop(const SilhouetteLoop & loop, const PerspectiveProjection & projection, std::size_t count);

/** The same with about the given distance (px, > 0) between samples: the loop's length divided by the rounded number.
 */
SilhouetteContour_EXPORT std::vector<SilhouetteSample>
ResampleSilhouetteLoopBySpacing(const SilhouetteLoop & loop, const PerspectiveProjection & projection, double spacing);
} // namespace itk

#endif
