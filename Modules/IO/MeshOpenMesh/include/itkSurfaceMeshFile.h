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
#ifndef itkSurfaceMeshFile_h
#define itkSurfaceMeshFile_h

#include "MeshOpenMeshExport.h"
#include "itkMeshFileFormat.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace itk
{
/** \class SurfaceMeshFileError
 * \brief What is wrong with a mesh file, without its name: the ITK classes add it and throw a DentalInputError.
 * \ingroup MeshOpenMesh
 */
class MeshOpenMesh_EXPORT SurfaceMeshFileError : public std::runtime_error
{
public:
  /** \param field the record or line, e.g. "facet 17" or "line 12"; may be empty */
  SurfaceMeshFileError(const std::string & field, const std::string & problem, const std::string & remedy);
  ~SurfaceMeshFileError() override;

  std::string field;   /**< What in the file, such as "element vertex". */
  std::string problem; /**< What is wrong with it. */
  std::string remedy;  /**< What to do about it. */
};

/** \struct SurfaceMeshFile
 * \brief A triangle mesh as read from a file, in flat arrays. Free of ITK headers.
 *
 * Coordinates in the file's own unit. Exactly one of floatPoints and doublePoints is filled: STL holds 32-bit floats,
 * the others are kept in double precision. Points of STL are welded where all three coordinates are equal (-0 counts as
 * 0) and numbered in order of first appearance; the other formats keep their points, order and duplicates included.
 * Polygons are split into fans from their first corner. Faces that name a point twice are dropped and counted; all
 * others are kept, whether the mesh is manifold or not.
 *
 * \ingroup MeshOpenMesh
 */
struct MeshOpenMesh_EXPORT SurfaceMeshFile
{
  using TriangleType = std::array<std::uint32_t, 3>;

  MeshFileFormatEnum format{ MeshFileFormatEnum::Unknown }; /**< As the bytes tell it, whatever the file's name says. */
  std::vector<std::array<float, 3>>  floatPoints;           /**< Of a file of single precision; empty of another. */
  std::vector<std::array<double, 3>> doublePoints;          /**< Of a file of double precision; empty of another. */
  std::vector<TriangleType>          triangles;             /**< Indices of points; polygons are cut into triangles. */
  /** Faces as the file counts them. */
  std::size_t numberOfFacesInFile{ 0 };
  /** Triangles (after splitting and welding) left out because they name a point twice. */
  std::size_t numberOfDegenerateFaces{ 0 };
  /** PLY: the vertices' property `Universal_ID`, `UniversalID` or `PredictedID`, tooth labels, and which it was; else
   * empty. */
  std::vector<double> vertexLabels;
  std::string         vertexLabelName;
  /** What is odd about the file, in words; "" where nothing is. */
  std::string warning;
  /** Of either precision. */
  std::size_t
  GetNumberOfPoints() const
  {
    return floatPoints.empty() ? doublePoints.size() : floatPoints.size();
  }
};

/** Reads a mesh from bytes in memory. Every count is checked against the size before memory is taken for it. Throws a
 * SurfaceMeshFileError for anything that is not a whole, finite mesh with at least one triangle. The name serves to
 * tell the format where the content does not. */
MeshOpenMesh_EXPORT SurfaceMeshFile
ParseSurfaceMesh(const char * bytes, std::size_t size, const std::string & fileName);

/** Maps the file into memory and parses it. */
MeshOpenMesh_EXPORT SurfaceMeshFile
ReadSurfaceMeshFile(const std::string & fileName);
} // namespace itk

#endif
