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
#ifndef itkVTKSurfaceFile_h
#define itkVTKSurfaceFile_h

#include "MeshVTKExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace itk
{
/** \struct VTKSurfaceFile
 * \brief A surface of a VTK file in flat arrays, with its tooth labels.
 *
 * Coordinates in the file's unit; points keep their order. Polygons are split into fans from their first corner, strips
 * into triangles; faces that name a point twice are dropped and counted.
 *
 * \ingroup MeshVTK
 */
struct MeshVTK_EXPORT VTKSurfaceFile
{
  std::vector<std::array<double, 3>>        points;    /**< In the file's unit and frame. */
  std::vector<std::array<std::uint32_t, 3>> triangles; /**< Indices of points; polygons are cut into triangles. */
  std::size_t                               numberOfFacesInFile{ 0 }; /**< Polygons, before they were cut. */
  std::size_t numberOfDegenerateFaces{ 0 }; /**< Left out: two corners of them are one point. */
  /** The first of the point arrays `Universal_ID`, `UniversalID`, `PredictedID` that is there, else empty. */
  std::string labelName;
  /** Its values as they are, one a point; empty without. */
  std::vector<double> labels;
  /** Such an array is there, but as cell data. */
  bool labelsOfCells{ false };
};

/** Whether the name's extension (any case) is .vtk or .vtp. */
MeshVTK_EXPORT bool
IsVTKSurfaceFileName(const std::string & fileName);

/** Reads PolyData from a legacy file (up to version 5.1, ASCII or binary) or an XML file (ascii, binary or appended,
 * plain or with zlib). The parsers are ours: ITK 5.2.1 crashes or hangs on version 5.1, and VTK's own readers crash on
 * damaged files. Counts are checked against the file's size before memory is taken for them. Throws a DentalInputError
 * for anything that is not a whole, finite surface with at least one triangle. */
MeshVTK_EXPORT VTKSurfaceFile
ReadVTKSurfaceFile(const std::string & fileName);
} // namespace itk

#endif
