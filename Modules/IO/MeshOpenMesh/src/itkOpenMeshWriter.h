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
#ifndef itkOpenMeshWriter_h
#define itkOpenMeshWriter_h

#include "itkSurfaceMeshFile.h"

#include <ostream>

namespace itk
{
/** Writes a surface with OpenMesh's writer for the format, whatever the program's locale. \return false where OpenMesh
 * or the stream fails. OpenMesh has a tenth of all symbols that a program with this module would look up when it
 * starts, and few write a mesh: the first call loads it. Throws an ExceptionObject where it cannot. */
bool
WriteWithOpenMesh(std::ostream &                                     stream,
                  MeshFileFormatEnum                                 format,
                  const std::vector<std::array<float, 3>> &          points,
                  const std::vector<SurfaceMeshFile::TriangleType> & triangles,
                  bool                                               binary);
} // namespace itk

/** WriteWithOpenMesh() of the part that links OpenMesh. */
extern "C" __attribute__((visibility("default"))) bool
DentalSCRWriteWithOpenMesh(std::ostream &                                          stream,
                           itk::MeshFileFormatEnum                                 format,
                           const std::vector<std::array<float, 3>> &               points,
                           const std::vector<itk::SurfaceMeshFile::TriangleType> & triangles,
                           bool                                                    binary);

#endif
