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
#include "itkOpenMeshMeshIOFactory.h"

#include "itkCreateObjectFunction.h"
#include "itkOpenMeshMeshIO.h"
#include "itkVersion.h"

#include <mutex>

namespace itk
{
OpenMeshMeshIOFactory::OpenMeshMeshIOFactory()
{
  this->RegisterOverride("itkMeshIOBase",
                         "itkOpenMeshMeshIO",
                         "Strict STL, PLY, OBJ and OFF",
                         true,
                         CreateObjectFunction<OpenMeshMeshIO>::New());
}

OpenMeshMeshIOFactory::~OpenMeshMeshIOFactory() = default;

const char *
OpenMeshMeshIOFactory::GetITKSourceVersion() const
{
  return ITK_SOURCE_VERSION;
}

const char *
OpenMeshMeshIOFactory::GetDescription() const
{
  return "OpenMesh mesh IO: strict STL, PLY, OBJ and OFF";
}

void
OpenMeshMeshIOFactory::RegisterOneFactory()
{
  RegisterOpenMeshMeshIOFactories();
}

void
RegisterOpenMeshMeshIOFactories()
{
  static std::mutex                 mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto                        factories = ObjectFactoryBase::GetRegisteredFactories();
  // First in the list, or ITK's own readers of OBJ and OFF win.
  if (factories.empty() || dynamic_cast<const OpenMeshMeshIOFactory *>(factories.front()) == nullptr)
  {
    ObjectFactoryBase::RegisterFactory(OpenMeshMeshIOFactory::New(),
                                       ObjectFactoryBase::InsertionPositionEnum::INSERT_AT_FRONT);
  }
}
} // namespace itk

/** For ITK_AUTOLOAD_PATH. ITK appends what it is given, behind its own readers: hence the one in front as well. */
extern "C" MeshOpenMesh_EXPORT itk::ObjectFactoryBase *
                               itkLoad()
{
  itk::RegisterOpenMeshMeshIOFactories();
  static const itk::OpenMeshMeshIOFactory::Pointer factory = itk::OpenMeshMeshIOFactory::New();
  return factory.GetPointer();
}
