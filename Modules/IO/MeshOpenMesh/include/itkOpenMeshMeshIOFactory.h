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
#ifndef itkOpenMeshMeshIOFactory_h
#define itkOpenMeshMeshIOFactory_h

#include "MeshOpenMeshExport.h"

#include "itkObjectFactoryBase.h"

namespace itk
{
/** \class OpenMeshMeshIOFactory
 * \brief Makes OpenMeshMeshIO objects. Also loaded from ITK_AUTOLOAD_PATH.
 * \sa RegisterOpenMeshMeshIOFactories
 * \ingroup MeshOpenMesh
 */
class MeshOpenMesh_EXPORT OpenMeshMeshIOFactory : public ObjectFactoryBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(OpenMeshMeshIOFactory);

  using Self = OpenMeshMeshIOFactory;
  using Superclass = ObjectFactoryBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkFactorylessNewMacro(Self);
  itkTypeMacro(OpenMeshMeshIOFactory, ObjectFactoryBase);
  /** ITK's version that it was built with, and what it makes, for the list of factories. */
  const char *
  GetITKSourceVersion() const override;
  const char *
  GetDescription() const override;

  /** The same as RegisterOpenMeshMeshIOFactories(). */
  static void
  RegisterOneFactory();

protected:
  OpenMeshMeshIOFactory();
  ~OpenMeshMeshIOFactory() override;
};

/** Makes the stock MeshFileReader and MeshFileWriter use OpenMeshMeshIO, before ITK's own OBJ and OFF classes. Call it
 * once at the start; further calls do nothing. A static object could not do it: linkers drop libraries of which no
 * symbol is used. */
MeshOpenMesh_EXPORT void
RegisterOpenMeshMeshIOFactories();
} // namespace itk

#endif
