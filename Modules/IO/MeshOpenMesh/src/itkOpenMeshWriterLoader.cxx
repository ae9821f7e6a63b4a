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
#include "itkOpenMeshWriter.h"

#ifdef DENTALSCR_OPENMESH_LIBRARY
#  include "itkLoadLibraryFunction.h"
#endif

namespace itk
{
bool
WriteWithOpenMesh(std::ostream &                                     stream,
                  MeshFileFormatEnum                                 format,
                  const std::vector<std::array<float, 3>> &          points,
                  const std::vector<SurfaceMeshFile::TriangleType> & triangles,
                  bool                                               binary)
{
#ifdef DENTALSCR_OPENMESH_LIBRARY
  static const auto write =
    LoadLibraryFunction<decltype(&DentalSCRWriteWithOpenMesh)>(DENTALSCR_OPENMESH_LIBRARY,
                                                               "DentalSCRWriteWithOpenMesh",
                                                               "Meshes cannot be written",
                                                               DENTALSCR_OPENMESH_LIBRARY " and OpenMesh");
  return write(stream, format, points, triangles, binary);
#else
  return DentalSCRWriteWithOpenMesh(stream, format, points, triangles, binary);
#endif
}
} // namespace itk
