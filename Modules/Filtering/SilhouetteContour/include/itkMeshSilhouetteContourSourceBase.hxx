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
#ifndef itkMeshSilhouetteContourSourceBase_hxx
#define itkMeshSilhouetteContourSourceBase_hxx

#include <stdexcept>

namespace itk
{
template <typename TInputMesh>
MeshSilhouetteContourSourceBase<TInputMesh>::MeshSilhouetteContourSourceBase()
{
  this->SetNumberOfRequiredInputs(0);
}

template <typename TInputMesh>
void
MeshSilhouetteContourSourceBase<TInputMesh>::SetInput(const InputMeshType * mesh)
{
  this->ProcessObject::SetNthInput(0, const_cast<InputMeshType *>(mesh));
}

template <typename TInputMesh>
auto
MeshSilhouetteContourSourceBase<TInputMesh>::GetInput() const -> const InputMeshType *
{
  return itkDynamicCastInDebugMode<const InputMeshType *>(this->GetPrimaryInput());
}

template <typename TInputMesh>
void
MeshSilhouetteContourSourceBase<TInputMesh>::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("No mesh: call SetInput() with a mesh of triangles.");
  }
  if (this->GetGeometry() == nullptr)
  {
    itkExceptionMacro("No geometry: call SetGeometry() with a CephalometricGeometry.");
  }
  Superclass::VerifyPreconditions();
}

template <typename TInputMesh>
template <typename TFunction>
void
MeshSilhouetteContourSourceBase<TInputMesh>::UseSilhouette(TFunction && compute)
{
  try
  {
    const MeshSilhouette & silhouette = m_Cache.Update(this->GetInput());
    this->UpdateProgress(0.5f);
    compute(silhouette);
  }
  catch (const std::invalid_argument & error)
  {
    itkExceptionMacro(<< error.what() << " The mesh is broken; read or build it again.");
  }
  catch (const std::domain_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
}

template <typename TInputMesh>
void
MeshSilhouetteContourSourceBase<TInputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Cache: " << m_Cache.GetNumberOfEdges() << " edges" << std::endl;
}
} // namespace itk

#endif
