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
#ifndef itkReadDentalMesh_hxx
#define itkReadDentalMesh_hxx

#include "itkReadDentalMesh.h"

#include <filesystem>
#include <system_error>

namespace itk
{
template <typename TMesh>
typename TMesh::Pointer
ReadDentalMesh(const std::string & fileName)
{
  static_assert(TMesh::PointDimension == 3, "A surface has points in three dimensions.");
  if (fileName.empty())
  {
    itkDentalInputErrorMacro("mesh file", "", "the name is empty", "name an STL, PLY, OBJ or OFF file");
  }
  const auto      meshIO = OpenMeshMeshIO::New();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(fileName, ignored))
  {
    // Throws what is wrong; the stock reader would wait for ever for the other end of a named pipe.
    meshIO->SetFileName(fileName);
    meshIO->ReadMeshInformation();
  }
  const auto reader = MeshFileReader<TMesh>::New();
  reader->SetMeshIO(meshIO);
  reader->SetFileName(fileName);
  reader->Update();
  typename TMesh::Pointer mesh = reader->GetOutput();
  mesh->DisconnectPipeline();
  return mesh;
}

template <typename TMesh>
void
WriteDentalMesh(const TMesh * mesh, const std::string & fileName)
{
  if (fileName.empty())
  {
    itkDentalInputErrorMacro("mesh file", "", "the name is empty", "name an STL, PLY, OBJ or OFF file");
  }
  const auto writer = MeshFileWriter<TMesh>::New();
  writer->SetMeshIO(OpenMeshMeshIO::New());
  writer->SetFileName(fileName);
  writer->SetFileTypeAsBINARY();
  writer->SetInput(mesh);
  writer->Write();
}

extern template Mesh<float, 3>::Pointer
ReadDentalMesh<Mesh<float, 3>>(const std::string &);
extern template Mesh<double, 3>::Pointer
ReadDentalMesh<Mesh<double, 3>>(const std::string &);
extern template void
WriteDentalMesh<Mesh<float, 3>>(const Mesh<float, 3> *, const std::string &);
extern template void
WriteDentalMesh<Mesh<double, 3>>(const Mesh<double, 3> *, const std::string &);
} // namespace itk

#endif
