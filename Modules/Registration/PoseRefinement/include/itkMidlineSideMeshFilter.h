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
#ifndef itkMidlineSideMeshFilter_h
#define itkMidlineSideMeshFilter_h

#include "PoseRefinementExport.h"

#include "itkMesh.h"
#include "itkMeshToMeshFilter.h"
#include "itkVersorRigid3DTransform.h"

#include <ostream>

namespace itk
{
/** \class MidlineSideMeshFilterEnums
 * \brief Enumeration of MidlineSideMeshFilter.
 * \ingroup PoseRefinement
 */
class MidlineSideMeshFilterEnums
{
public:
  enum class Side : uint8_t
  {
    Right,
    Left
  };
};
PoseRefinement_EXPORT std::ostream &
                      operator<<(std::ostream & os, MidlineSideMeshFilterEnums::Side side);

/** \class MidlineSideMeshFilter
 * \brief The triangles of one side of the midline plane, so that a silhouette shows what a one-sided tracing shows.
 *
 * Keeps the triangles whose centre has y < Margin in the dental frame (right), or y > -Margin (left), with their points
 * and cell data; points keep their coordinates and data and are numbered anew from 0. The frame is given by the
 * transform mesh -> dental frame (a transform output of UMidlineDentalAxisFilter with RefineMidline); without one the
 * mesh is taken to be in that frame.
 *
 * Errors: no input; a cell that is not a triangle.
 *
 * \ingroup PoseRefinement
 */
template <typename TMesh = Mesh<float, 3>>
class ITK_TEMPLATE_EXPORT MidlineSideMeshFilter : public MeshToMeshFilter<TMesh, TMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MidlineSideMeshFilter);

  using Self = MidlineSideMeshFilter;
  using Superclass = MeshToMeshFilter<TMesh, TMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(MidlineSideMeshFilter, MeshToMeshFilter);

  using MeshType = TMesh;
  using TransformType = VersorRigid3DTransform<double>;
  using SideEnum = MidlineSideMeshFilterEnums::Side;

  /** Mesh to dental frame. */
  itkSetConstObjectMacro(Transform, TransformType);
  itkGetConstObjectMacro(Transform, TransformType);

  /** Default Right. */
  itkSetEnumMacro(Side, SideEnum);
  itkGetEnumMacro(Side, SideEnum);

  /** How far beyond the midline triangles are kept, mm. Default 0.5. */
  itkSetMacro(Margin, double);
  itkGetConstMacro(Margin, double);

protected:
  MidlineSideMeshFilter() = default;
  ~MidlineSideMeshFilter() override = default;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  TransformType::ConstPointer m_Transform;
  SideEnum                    m_Side{ SideEnum::Right };
  double                      m_Margin{ 0.5 };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMidlineSideMeshFilter.hxx"
#endif

#ifndef POSEREFINEMENT_INSTANTIATE
namespace itk
{
extern template class MidlineSideMeshFilter<Mesh<float, 3>>;
extern template class MidlineSideMeshFilter<Mesh<double, 3>>;
} // namespace itk
#endif

#endif
