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
#ifndef itkReadDentalMesh_h
#define itkReadDentalMesh_h

#include "itkDentalInputError.h"
#include "itkOpenMeshMeshIO.h"

#include "itkMesh.h"
#include "itkMeshFileReader.h"
#include "itkMeshFileWriter.h"

#include <string>
#include <vector>

namespace itk
{
/** Reads a surface through the stock MeshFileReader with OpenMeshMeshIO; no factory needs to be registered. Coordinates
 * stay in the file's unit. Throws a DentalInputError, whose GetOneLine() is fit for a user, for whatever is wrong: also
 * for missing files and unknown formats, where the stock reader's own message has many lines. What is odd about the
 * file is added to warnings where they are wanted, each "file: what". */
template <typename TMesh>
typename TMesh::Pointer
ReadDentalMesh(const std::string & fileName, std::vector<std::string> * warnings = nullptr);

/** Writes a surface, binary where the format has it (STL, PLY). The format is the extension's. The file appears whole
 * or not at all. Throws a DentalInputError. */
template <typename TMesh>
void
WriteDentalMesh(const TMesh * mesh, const std::string & fileName);
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkReadDentalMesh.hxx"
#endif

#endif
