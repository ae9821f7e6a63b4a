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

#include "CrownRegionExport.h"

#include "itkDataObjectDecorator.h"
#include "itkMesh.h"
#include "itkMeshToMeshFilter.h"
#include "itkVersorRigid3DTransform.h"

#include <cstdint>
#include <ostream>
#include <vector>

namespace itk
{
/** \class MidlineSideMeshFilterEnums
 * \brief Enumerations of MidlineSideMeshFilter.
 * \ingroup CrownRegion
 */
class MidlineSideMeshFilterEnums
{
public:
  /** The patient's. */
  enum class Side : uint8_t
  {
    Right,
    Left
  };
};
CrownRegion_EXPORT std::ostream &
                   operator<<(std::ostream & os, MidlineSideMeshFilterEnums::Side side);

/** \class MidlineSideMeshFilter
 * \brief The part of a jaw on one side of the midline plane y = 0 of its UMDA frame.
 *
 * Keeps the triangles whose centre has y < Margin (Right) or y > -Margin (Left); triangles are not cut. With a margin
 * above 0 (mm) a strip of the other side stays, so that the incisors' border at the midline is not lost where the plane
 * is off by less. What is kept on both sides together is the whole mesh where Margin > 0.
 *
 * Required input FrameTransform: mesh -> UMDA, of UMidlineDentalAxisFilter with RefineMidline on: without it the origin
 * is the centroid, which lies some tenths of a mm off the midline.
 *
 * Output: the triangles and their points, numbered anew, with the input's point and cell data. GetTriangleMask() is in
 * the order of the input's cells.
 *
 * Errors: no transform; no triangles; nothing left on that side.
 *
 * \ingroup CrownRegion
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

  static_assert(TMesh::PointDimension == 3, "A dental arch has points in three dimensions.");

  using MeshType = TMesh;
  using TransformType = VersorRigid3DTransform<double>;
  using SideEnum = MidlineSideMeshFilterEnums::Side;
  using MaskType = std::vector<std::uint8_t>;

  /** Mesh -> UMDA: q = R (p - o). */
  itkSetGetDecoratedObjectInputMacro(FrameTransform, TransformType);

  /** Default Right. */
  itkSetEnumMacro(Side, SideEnum);
  itkGetEnumMacro(Side, SideEnum);

  /** mm beyond the plane. Default -0.5: the other side's incisor, where its edge stands in front, must not be the outline.
   */
  itkSetMacro(Margin, double);
  itkGetConstMacro(Margin, double);

  /** Of the last Update(): 1 where a triangle was kept. */
  const MaskType &
  GetTriangleMask() const
  {
    return m_TriangleMask;
  }

protected:
  MidlineSideMeshFilter();
  ~MidlineSideMeshFilter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  SideEnum m_Side{ SideEnum::Right };
  double   m_Margin{ -0.5 };
  MaskType m_TriangleMask;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMidlineSideMeshFilter.hxx"
#endif

#ifndef CROWNREGION_INSTANTIATE
namespace itk
{
extern template class MidlineSideMeshFilter<Mesh<float, 3>>;
extern template class MidlineSideMeshFilter<Mesh<double, 3>>;
} // namespace itk
#endif

#endif
