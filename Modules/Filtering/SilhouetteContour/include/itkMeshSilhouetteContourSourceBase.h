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
#ifndef itkMeshSilhouetteContourSourceBase_h
#define itkMeshSilhouetteContourSourceBase_h

#include "SilhouetteContourExport.h"
#include "itkCephalometricGeometry.h"
#include "itkDentalContour.h"
#include "itkMesh.h"
#include "itkMeshSilhouette.h"
#include "itkMeshSilhouetteCache.h"
#include "itkMeshSource.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** \class MeshSilhouetteContourSourceBase
 * \brief What the exact silhouettes of a mesh share, the whole one and the part that a tracing can lie on: their
 * inputs, and what of the mesh is prepared once for any pose.
 *
 * Inputs: a mesh of triangles (mm, frame of the geometry's pose) and the geometry. Both are pipeline inputs: a change
 * of pose re-executes the source. What depends on the mesh alone is prepared once for each of its states. A change made
 * through the elements of a container alone needs mesh->Modified().
 *
 * The output's points know the point of the mesh that projects to them (DentalContour::PolylineType::rimPoints, frame
 * and unit of the mesh) and their outward normal; with UseLabels also their tooth, by the label of the nearer end of
 * the mesh edge that they lie on.
 *
 * Errors: no mesh or geometry, cells that are not triangles, points that are not finite or not in front of the source;
 * with UseLabels point data that are no FDI numbers.
 *
 * \ingroup SilhouetteContour
 */
template <typename TInputMesh>
class ITK_TEMPLATE_EXPORT MeshSilhouetteContourSourceBase : public MeshSource<DentalContour>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MeshSilhouetteContourSourceBase);

  using Self = MeshSilhouetteContourSourceBase;
  using Superclass = MeshSource<DentalContour>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(MeshSilhouetteContourSourceBase, MeshSource);

  using InputMeshType = TInputMesh;
  using GeometryType = CephalometricGeometry;
  /** The mesh, in the unit of the geometry, mm. Must be set. */
  using Superclass::SetInput;
  void
  SetInput(const InputMeshType * mesh);
  const InputMeshType *
  GetInput() const;

  /** Where source, detector and object are. */
  itkSetInputMacro(Geometry, GeometryType);
  itkGetInputMacro(Geometry, GeometryType);

  /** Whether the mesh's point data are FDI numbers of teeth, 0 where there is none, as CrownRegionMeshFilter and
   * ToothLabelFileReader give them. Default off. */
  itkSetMacro(UseLabels, bool);
  itkGetConstMacro(UseLabels, bool);
  itkBooleanMacro(UseLabels);

protected:
  MeshSilhouetteContourSourceBase();
  ~MeshSilhouetteContourSourceBase() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  /** Neither the mesh nor the geometry has information that a contour could copy. */
  void
  GenerateOutputInformation() override
  {}

  /** Prepares the mesh where it has changed and calls compute(silhouette); half of the progress lies between. What is
   * wrong with the mesh or its place becomes an ExceptionObject. */
  template <typename TFunction>
  void
  UseSilhouette(TFunction && compute);

  /** Where the mesh lies and which tooth it is at a point of the surface, for the points of the output. */
  class ToothLookup
  {
  public:
    /** The tooth of the nearer end of an edge (indices into the surface's points) to a point on it. */
    ToothCode
    Find(const std::array<std::uint32_t, 2> & edge, const std::array<double, 3> & rim) const;

  private:
    std::vector<std::array<double, 3>> m_Points;
    std::vector<ToothCode>             m_Teeth;

    friend class MeshSilhouetteContourSourceBase;
  };
  /** Reads the labels, with UseLabels on. Throws where one is no tooth's. */
  ToothLookup
  MakeToothLookup() const;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  bool m_UseLabels{ false };

  MeshSilhouetteCache<InputMeshType> m_Cache;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMeshSilhouetteContourSourceBase.hxx"
#endif

namespace itk
{
extern template class MeshSilhouetteContourSourceBase<Mesh<float, 3>>;
extern template class MeshSilhouetteContourSourceBase<Mesh<double, 3>>;
} // namespace itk

#endif
