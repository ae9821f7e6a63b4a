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
#ifndef itkMeshFileFormat_h
#define itkMeshFileFormat_h

#include "MeshOpenMeshExport.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

namespace itk
{
/** What a mesh file holds, whatever its name says. */
enum class MeshFileFormatEnum : uint8_t
{
  Unknown,
  BinarySTL,
  AsciiSTL,
  PLY,
  OBJ,
  OFF
};

MeshOpenMesh_EXPORT std::ostream &
                    operator<<(std::ostream & os, MeshFileFormatEnum format);

/** The format that a name's extension (any case) stands for, ".stl" as BinarySTL; Unknown for any other. */
MeshOpenMesh_EXPORT MeshFileFormatEnum
MeshFileFormatFromName(const std::string & fileName);

/** What DetectMeshFileFormat() looks at. */
constexpr std::size_t MeshFileFormatHeadSize = 65536;

/** The format of these bytes. Content goes before the name: a binary STL whose header starts with "solid" is told by
 * its size, 84 + 50 n; PLY and OFF by their first word. The name decides where the content does not. Free of ITK
 * headers. */
MeshOpenMesh_EXPORT MeshFileFormatEnum
DetectMeshFileFormat(const char * bytes, std::size_t size, const std::string & fileName);
} // namespace itk

#endif
