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

#include <cmath>
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
ToothCode
MeshSilhouetteContourSourceBase<TInputMesh>::ToothLookup::Find(const std::array<std::uint32_t, 2> & edge,
                                                               const std::array<double, 3> &        rim) const
{
  double distances[2] = { 0.0, 0.0 };
  for (unsigned int end = 0; end < 2; ++end)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double difference = m_Points[edge[end]][d] - rim[d];
      distances[end] += difference * difference;
    }
  }
  return m_Teeth[edge[distances[0] <= distances[1] ? 0 : 1]];
}

template <typename TInputMesh>
auto
MeshSilhouetteContourSourceBase<TInputMesh>::MakeToothLookup() const -> ToothLookup
{
  ToothLookup           lookup;
  const InputMeshType * mesh = this->GetInput();
  const auto *          data = mesh->GetPointData();
  if (mesh->GetPoints() == nullptr)
  {
    return lookup;
  }
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
  {
    const auto & p = it.Value();
    lookup.m_Points.push_back({ { static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]) } });
    typename InputMeshType::PixelType pixel{};
    if (data != nullptr)
    {
      data->GetElementIfIndexExists(it.Index(), &pixel);
    }
    const auto value = static_cast<double>(pixel);
    try
    {
      if (!(value >= 0.0 && value < 256.0 && value == std::floor(value)))
      {
        throw std::invalid_argument("no whole number");
      }
      lookup.m_Teeth.emplace_back(static_cast<unsigned int>(value));
    }
    catch (const std::invalid_argument &)
    {
      itkExceptionMacro("Point " << it.Index() << " of the mesh has the data " << value
                                 << ", which is no tooth's FDI number. Call UseLabelsOff() where the point data are no "
                                    "tooth labels.");
    }
  }
  return lookup;
}

template <typename TInputMesh>
void
MeshSilhouetteContourSourceBase<TInputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "UseLabels: " << (m_UseLabels ? "On" : "Off") << std::endl;
  os << indent << "Cache: " << m_Cache.GetNumberOfEdges() << " edges" << std::endl;
}
} // namespace itk

#endif
