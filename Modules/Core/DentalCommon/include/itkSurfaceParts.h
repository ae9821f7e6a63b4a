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
#ifndef itkSurfaceParts_h
#define itkSurfaceParts_h

#include "DentalCommonExport.h"
#include "itkTriangleSurface.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace itk
{
/** \class SurfaceParts
 * \brief The connected parts of a surface: what is a jaw of it, and what are specks that a scanner left in the air.
 *
 * Triangles are connected where they have a corner at the same place, whether or not the file repeats the point, as STL
 * does. A part of less than SpeckShare of the whole area is a speck; points that no triangle has belong to no part.
 * Degenerate triangles have no part either. Free of ITK headers; of the surface nothing is kept.
 *
 * \ingroup DentalCommon
 */
class DentalCommon_EXPORT SurfaceParts
{
public:
  using PointType = TriangleSurface::PointType;

  /** Share of the surface's area below which a part is a speck: a single tooth without gingiva has more. */
  static constexpr double SpeckShare = 0.015;
  /** Of a triangle without an area. */
  static constexpr std::uint32_t NoPart = 0xffffffffu;

  /** One connected part. */
  struct PartType
  {
    /** mm^2. */
    double area{ 0.0 };
    /** Sum of the area-weighted normals: 0 for a closed body, as long as the area for a plane. */
    PointType normal{ { 0.0, 0.0, 0.0 } };
  };
  /** Finds the parts; the surface is not kept. */
  explicit SurfaceParts(const TriangleSurface & surface);

  /** In the order of their first triangles. */
  const std::vector<PartType> &
  GetParts() const
  {
    return m_Parts;
  }
  /** Index of the part of each triangle. */
  const std::vector<std::uint32_t> &
  GetPartOfTriangle() const
  {
    return m_PartOfTriangle;
  }
  /** Of each point the first that lies at the same place: it stands for all of them. */
  const std::vector<std::uint32_t> &
  GetWeldedPoints() const
  {
    return m_WeldedPoints;
  }
  double
  GetArea() const
  {
    return m_Area;
  }
  bool
  IsSpeck(std::uint32_t part) const
  {
    return m_Parts[part].area < SpeckShare * m_Area;
  }
  /** Whether a triangle is of a part that is no speck. */
  bool
  IsKept(std::size_t triangle) const
  {
    return m_PartOfTriangle[triangle] != NoPart && !this->IsSpeck(m_PartOfTriangle[triangle]);
  }

  /** Least and largest coordinate along a direction of what is no speck; {0, 0} where there is nothing.
   *
   * \param surface The one that the parts were found on. */
  std::pair<double, double>
  ComputeExtent(const TriangleSurface & surface, const PointType & direction) const;

  /** GetWeldedPoints() of a surface whose parts nobody needs. */
  static std::vector<std::uint32_t>
  Weld(const TriangleSurface & surface);

private:
  std::vector<std::uint32_t> m_WeldedPoints;
  std::vector<PartType>      m_Parts;
  std::vector<std::uint32_t> m_PartOfTriangle;
  std::vector<std::uint8_t>  m_IsPointKept;
  double                     m_Area{ 0.0 };
};
} // namespace itk

#endif
