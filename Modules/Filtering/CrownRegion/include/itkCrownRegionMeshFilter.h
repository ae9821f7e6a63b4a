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
#ifndef itkCrownRegionMeshFilter_h
#define itkCrownRegionMeshFilter_h

#include "CrownRegionExport.h"
#include "itkCrownRegionKernel.h"
#include "itkToothCode.h"
#include "itkUMidlineDentalAxisFilter.h"

#include "itkDataObjectDecorator.h"
#include "itkMesh.h"
#include "itkMeshToMeshFilter.h"
#include "itkVersorRigid3DTransform.h"

#include <vector>

namespace itk
{
/** \class CrownRegionMeshFilter
 * \brief The crowns of one jaw's scan, without gingiva, palate and plaster base.
 *
 * Input: triangles in mm, any orientation, either winding; open shells and closed casts. With tooth labels (point data
 * that is not 0 throughout, see LabelNumbering; ToothLabelFileReader reads them from files) the labels say what a crown
 * is. Without, or with UseLabels off, the shape does: what stands above the gingival valley along the arch.
 *
 * Optional input FrameTransform, mesh -> UMDA, as UMidlineDentalAxisFilter gives it: from both jaws it is better than
 * what this filter estimates from its one mesh where there is none. Not used with labels.
 *
 * Output: the crowns' triangles and their points, numbered anew, with the input's point and cell data; or with
 * KeepWholeMesh the whole mesh with 1 on crowns and 0 elsewhere as point data. GetPointMask() and GetTriangleMask() are
 * in the order of the input's containers either way.
 *
 * Errors: no triangles; labels that are no teeth or the other jaw's; a mesh in which no arch is found.
 *
 * Measured against the phantom's labels in Documentation/CrownRegion.md. The result does not depend on the number of
 * work units.
 *
 * \ingroup CrownRegion
 */
template <typename TMesh = Mesh<float, 3>>
class ITK_TEMPLATE_EXPORT CrownRegionMeshFilter : public MeshToMeshFilter<TMesh, TMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CrownRegionMeshFilter);

  using Self = CrownRegionMeshFilter;
  using Superclass = MeshToMeshFilter<TMesh, TMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CrownRegionMeshFilter, MeshToMeshFilter);

  static_assert(TMesh::PointDimension == 3, "A dental arch has points in three dimensions.");

  using MeshType = TMesh;
  using TransformType = VersorRigid3DTransform<double>;
  using JawEnum = ToothCode::JawEnum;
  using NumberingEnum = ToothCode::NumberingEnum;
  using MaskType = std::vector<std::uint8_t>;

  /** Mesh -> UMDA: q = R (p - o). Optional. */
  itkSetGetDecoratedObjectInputMacro(FrameTransform, TransformType);

  /** Default Upper. */
  itkSetEnumMacro(Jaw, JawEnum);
  itkGetEnumMacro(Jaw, JawEnum);

  /** Default on. */
  itkSetMacro(UseLabels, bool);
  itkGetConstMacro(UseLabels, bool);
  itkBooleanMacro(UseLabels);

  /** How the point data numbers teeth: FDI (default) or Universal, as in the array `Universal_ID`. */
  itkSetEnumMacro(LabelNumbering, NumberingEnum);
  itkGetEnumMacro(LabelNumbering, NumberingEnum);

  /** Default off. */
  itkSetMacro(KeepWholeMesh, bool);
  itkGetConstMacro(KeepWholeMesh, bool);
  itkBooleanMacro(KeepWholeMesh);

  /** Depths below the occlusal surface between which the margin is looked for, mm. Default 2.5 and 12.5. */
  itkSetMacro(MinimumCrownHeight, double);
  itkGetConstMacro(MinimumCrownHeight, double);
  itkSetMacro(MaximumCrownHeight, double);
  itkGetConstMacro(MaximumCrownHeight, double);

  /** Of the last Update(): 1 on crowns, 0 elsewhere. */
  const MaskType &
  GetPointMask() const
  {
    return m_Region.points;
  }
  const MaskType &
  GetTriangleMask() const
  {
    return m_Region.triangles;
  }
  /** Area of the crowns, mm^2. */
  double
  GetCrownArea() const
  {
    return m_Region.area;
  }
  /** Mean depth of the margin (mm) and turning angle across it (radians); 0 where labels were used. */
  double
  GetMeanCrownHeight() const
  {
    return m_Region.meanCrownHeight;
  }
  double
  GetMarginAngle() const
  {
    return m_Region.marginAngle;
  }
  /** Whether the last Update() took the labels. */
  itkGetConstMacro(LabelsWereUsed, bool);

protected:
  CrownRegionMeshFilter();
  ~CrownRegionMeshFilter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** FDI by point; empty where the mesh has no labels. */
  MaskType
  CollectLabels() const;

  JawEnum           m_Jaw{ JawEnum::Upper };
  bool              m_UseLabels{ true };
  NumberingEnum     m_LabelNumbering{ NumberingEnum::FDI };
  bool              m_KeepWholeMesh{ false };
  double            m_MinimumCrownHeight{ 2.5 };
  double            m_MaximumCrownHeight{ 12.5 };
  bool              m_LabelsWereUsed{ false };
  CrownRegionResult m_Region;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkCrownRegionMeshFilter.hxx"
#endif

#ifndef CROWNREGION_INSTANTIATE
namespace itk
{
extern template class CrownRegionMeshFilter<Mesh<float, 3>>;
extern template class CrownRegionMeshFilter<Mesh<double, 3>>;
} // namespace itk
#endif

#endif
