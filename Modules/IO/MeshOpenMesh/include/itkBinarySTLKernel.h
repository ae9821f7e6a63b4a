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
#ifndef itkBinarySTLKernel_h
#define itkBinarySTLKernel_h

#include "MeshOpenMeshExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
/** \struct WeldedTriangles
 * \brief What a binary STL holds after identical points were welded. Free of ITK headers.
 * \ingroup MeshOpenMesh
 */
struct MeshOpenMesh_EXPORT WeldedTriangles
{
  std::vector<std::array<float, 3>>         points;              /**< Each place once, in the order of first use. */
  std::vector<std::array<std::uint32_t, 3>> triangles;           /**< Indices of points. */
  std::size_t                               numberOfFacets{ 0 }; /**< As the file counts them. */
  std::size_t numberOfDegenerateFacets{ 0 };                     /**< Left out: two corners of them are one point. */
  /** Bytes behind the facets that were not looked at. */
  std::size_t numberOfTrailingBytes{ 0 };
};

/** Decodes and welds a binary STL in memory: points are one where their 96 bits are, with -0 taken as 0; they are
 * numbered in order of first appearance. Some programs append a block of their own (colours, a
 * signature), which is not looked at: bytes behind the facets that are no further facets by their number, and fewer
 * than the facets' own. Throws a SurfaceMeshFileError where the size is not 84 + 50 n otherwise, a coordinate is not
 * finite, or no facet is left. */
MeshOpenMesh_EXPORT WeldedTriangles
ParseBinarySTL(const char * bytes, std::size_t size);

/** Maps a file into memory and parses it. */
MeshOpenMesh_EXPORT WeldedTriangles
ReadBinarySTL(const char * fileName);

/** In one pass over the triangles: (nx, ny, nz, area) of each point, the unit normal weighted by area (zero where there
 * is no area) and a third of the area of the triangles around the point, in squared units of the file. */
MeshOpenMesh_EXPORT std::vector<std::array<float, 4>>
                    ComputeNormalsAndAreas(const std::vector<std::array<float, 3>> &         points,
                                           const std::vector<std::array<std::uint32_t, 3>> & triangles);
} // namespace itk

#endif
