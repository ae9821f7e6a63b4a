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
#ifndef itkOpenSilhouetteContourSource_h
#define itkOpenSilhouetteContourSource_h

#include "SilhouetteContourExport.h"
#include "itkMeshSilhouetteContourSourceBase.h"
#include "itkOpenSilhouette.h"

#include "itkDataObjectDecorator.h"
#include "itkVersorRigid3DTransform.h"

#include <array>
#include <vector>

namespace itk
{
/** \class OpenSilhouetteContourSource
 * \brief The part of a jaw's outline that a tracing can lie on, as an open contour: the moving contour of the robust
 * registration.
 *
 * Of the exact outer boundary of the projected mesh (MeshSilhouette) stays what faces occlusally or anteriorly
 * (FacesOcclusallyOrAnteriorly()): incisal edges, cusps and the front of the incisors and of the gingiva before them,
 * not palate, underside or distal ends. Which way a normal faces is judged in the dental frame turned with the image,
 * so that neither the head's pitch nor the facing changes what stays.
 *
 * Inputs: one side of a jaw (mm), most often of MidlineSideMeshFilter; the geometry whose pose maps the mesh to the
 * cephalostat; optionally FrameTransform, mesh -> UMDA. Without it the mesh's own axes are the dental ones.
 *
 * Output: open polylines in continuous pixel indices, parts by size, along the loop's sense, samples at equal
 * distances. Each point has the point of the surface that projects to it and the outward unit normal in the image, over
 * neighbouring samples; GetRimPoints() and GetNormals() are the same of all points one after another.
 *
 * Errors: no mesh or geometry, an incomplete geometry, cells that are not triangles, points that are not finite or not
 * in front of the source. A mesh without triangles gives an empty contour.
 *
 * \ingroup SilhouetteContour
 */
template <typename TInputMesh>
class ITK_TEMPLATE_EXPORT OpenSilhouetteContourSource : public MeshSilhouetteContourSourceBase<TInputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(OpenSilhouetteContourSource);

  using Self = OpenSilhouetteContourSource;
  using Superclass = MeshSilhouetteContourSourceBase<TInputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(OpenSilhouetteContourSource, MeshSilhouetteContourSourceBase);

  using InputMeshType = TInputMesh;
  using GeometryType = CephalometricGeometry;
  using TransformType = VersorRigid3DTransform<double>;
  using JawEnum = ToothCode::JawEnum;
  using RimContainerType = std::vector<std::array<double, 3>>;
  using NormalContainerType = std::vector<std::array<double, 2>>;

  /** Mesh -> UMDA. Optional. */
  itkSetGetDecoratedObjectInputMacro(FrameTransform, TransformType);

  /** Upper (default) or Lower: which way is occlusal. */
  itkSetEnumMacro(Jaw, JawEnum);
  itkGetEnumMacro(Jaw, JawEnum);

  /** Between points of the output, mm in the detector plane. Default 0.125, that of the robust registration. */
  itkSetMacro(Spacing, double);
  itkGetConstMacro(Spacing, double);

  /** Of each point of the output, object frame, mm. Valid after Update(). */
  const RimContainerType &
  GetRimPoints() const
  {
    return m_RimPoints;
  }
  const NormalContainerType &
  GetNormals() const
  {
    return m_Normals;
  }

protected:
  OpenSilhouetteContourSource();
  ~OpenSilhouetteContourSource() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  JawEnum             m_Jaw{ JawEnum::Upper };
  double              m_Spacing{ 0.125 };
  RimContainerType    m_RimPoints;
  NormalContainerType m_Normals;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkOpenSilhouetteContourSource.hxx"
#endif

namespace itk
{
extern template class OpenSilhouetteContourSource<Mesh<float, 3>>;
extern template class OpenSilhouetteContourSource<Mesh<double, 3>>;
} // namespace itk

#endif
