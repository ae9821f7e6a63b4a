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
#ifndef itkSurfaceSpikes_h
#define itkSurfaceSpikes_h

#include "DentalCommonExport.h"
#include "itkTriangleSurface.h"

#include <cstdint>
#include <vector>

namespace itk
{
/** A point that stands out of a surface by itself. */
struct SurfaceSpike
{
  /** The first point of the surface at its place. */
  std::uint32_t point{ 0 };
  /** Its distance from the nearest of the points that it is connected with, in the surface's unit. */
  double length{ 0.0 };
};

/** Points that are further than a length from all the points they are connected with, while these lie together, within
 * a quarter of that distance: one wrong number of a scan's file, or what a scanner saw beside the teeth. The projected
 * outline runs to their ends. A hole that was closed with a fan, the walls of a base and coarse triangles have points
 * far from each other on the other side, and are none.
 *
 * \param welded SurfaceParts::GetWeldedPoints(), so that the triangles of an STL file are connected
 * \param length from which on a point stands out
 *
 * In the order of their points. \ingroup DentalCommon */
DentalCommon_EXPORT std::vector<SurfaceSpike>
FindSurfaceSpikes(const TriangleSurface & surface, const std::vector<std::uint32_t> & welded, double length);
} // namespace itk

#endif
