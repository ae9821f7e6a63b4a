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
#ifndef itkMeshSilhouetteCache_h
#define itkMeshSilhouetteCache_h

#include "itkMakeTriangleSurface.h"
#include "itkMeshSilhouette.h"

#include <algorithm>
#include <memory>

namespace itk
{
/** \class MeshSilhouetteCache
 * \brief What of a mesh's silhouette depends on the mesh alone, made once for each of its states.
 *
 * Edges are put into clusters when a state is asked for a second time: most scans are looked at from one pose.
 *
 * A change made through the elements of a container alone needs mesh->Modified().
 *
 * \ingroup SilhouetteContour
 */
template <typename TMesh>
class MeshSilhouetteCache
{
public:
  /** Throws std::invalid_argument where a point is not finite or a triangle names a point that is not there. */
  const MeshSilhouette &
  Update(const TMesh * mesh)
  {
    ModifiedTimeType time = std::max(mesh->GetMTime(), mesh->GetUpdateMTime());
    if (mesh->GetPoints() != nullptr)
    {
      time = std::max(time, mesh->GetPoints()->GetMTime());
    }
    if (mesh->GetCells() != nullptr)
    {
      time = std::max(time, mesh->GetCells()->GetMTime());
    }
    if (m_Silhouette == nullptr || m_Mesh != mesh || m_Time != time)
    {
      m_Silhouette.reset();
      m_Silhouette = std::make_unique<MeshSilhouette>(MakeTriangleSurface(mesh), MeshSilhouette::PosesEnum::One);
      m_Mesh = mesh;
      m_Time = time;
    }
    else
    {
      m_Silhouette->ClusterEdges();
    }
    return *m_Silhouette;
  }

  /** 0 before the first Update(). */
  std::size_t
  GetNumberOfEdges() const
  {
    return m_Silhouette == nullptr ? 0 : m_Silhouette->GetNumberOfEdges();
  }

private:
  std::unique_ptr<MeshSilhouette> m_Silhouette;
  const TMesh *                   m_Mesh{ nullptr };
  ModifiedTimeType                m_Time{ 0 };
};
} // namespace itk

#endif
