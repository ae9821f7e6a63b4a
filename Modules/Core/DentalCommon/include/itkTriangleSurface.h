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
#ifndef itkTriangleSurface_h
#define itkTriangleSurface_h

#include "DentalCommonExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
/** \struct TriangleSurface
 * \brief A triangle mesh as flat arrays, the form in which kernels take it. Free of ITK headers.
 *
 * Points in mm; triangles counter-clockwise seen from outside. Made once per mesh by MakeTriangleSurface().
 *
 * \ingroup DentalCommon
 */
struct DentalCommon_EXPORT TriangleSurface
{
  using PointType = std::array<double, 3>;
  using TriangleType = std::array<std::uint32_t, 3>;

  std::vector<PointType>    points;    /**< In the unit and the frame of whoever made the surface. */
  std::vector<TriangleType> triangles; /**< Indices of three points each, outward by the right hand. */

  /** \return the triangle's area-weighted normal: its length is the area. */
  PointType
  AreaNormal(std::size_t triangle) const;

  /** A third of the area of the triangles around each point, mm^2. */
  std::vector<double>
  VertexAreas() const;

  /** Unit normals at the points, area-weighted; zero at a point without a triangle. */
  std::vector<PointType>
  VertexNormals() const;

  /** Area-weighted centroid: it does not move with the scan's density. The mean of the points where there is no area.
   */
  PointType
  AreaCentroid() const;
  /** Sum over the triangles, in the square of the points' unit. */
  double
  Area() const;
};
} // namespace itk

#endif
