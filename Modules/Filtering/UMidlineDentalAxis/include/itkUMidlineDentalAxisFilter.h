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
#ifndef itkUMidlineDentalAxisFilter_h
#define itkUMidlineDentalAxisFilter_h

#include "UMidlineDentalAxisExport.h"
#include "itkDentalFrameEstimator.h"
#include "itkDentalFrameObject.h"

#include "itkDataObjectDecorator.h"
#include "itkMesh.h"
#include "itkMeshSource.h"
#include "itkPoint.h"
#include "itkVector.h"
#include "itkVersorRigid3DTransform.h"

#include <ostream>

namespace itk
{
/** \class UMidlineDentalAxisFilterEnums
 * \brief Enumerations of UMidlineDentalAxisFilter.
 * \ingroup UMidlineDentalAxis
 */
class UMidlineDentalAxisFilterEnums
{
public:
  /** Whether the two meshes are in one coordinate frame, in occlusion: said to be, said not to be, or tested. */
  using JawsShareFrame = DentalFrameEnums::JawsShareFrame;
};
UMidlineDentalAxis_EXPORT std::ostream &
                          operator<<(std::ostream & os, DentalFrameEnums::JawsShareFrame mode);

/** \class UMidlineDentalAxisFilter
 * \brief The anatomical frame of dental arches (U-midline dental axis, UMDA), from their shape alone.
 *
 * Frame of each jaw: origin at its area-weighted centroid; x anterior (toward the incisors), y to the patient's left, z
 * superior, for both jaws: the occlusal side is -z in the upper and +z in the lower jaw. Right-handed, mm.
 *
 * Inputs: upper and lower mesh, one of them or both; triangles wound outward, mm, in any orientation. Open shells,
 * palates, uneven trimming, holes and closed casts are expected. Which is upper and which is lower is the caller's
 * knowledge.
 *
 * Outputs, in this order: upper and lower mesh in their UMDA frames (point data and cells as they were), upper and
 * lower transform, joint transform. The joint one is one frame for both jaws where these are in occlusion, and empty
 * where they are not; registrations that give both jaws one pose take it. The transforms map MESH -> UMDA: q = R (p -
 * o), as TransformPoint() does, decorated, written by TransformFileWriter and loaded by Slicer. Outputs of a jaw
 * without input are empty: a mesh without points, a decorator whose Get() is null.
 *
 * When the jaws share a frame (JawsShareFrame; by default tested by contact, see GetFrame()) they get one common y,
 * Y_sh = unit(Y0_upper + Y0_lower); x = unit(Y_sh x Z) and z = x x y, so that projection along y is the same for both.
 *
 * With RefineMidline (off by default, as in the paper) y is the normal of the mirror plane, found on both jaws together
 * where they share a frame, and the origins are the feet of the centroids on that plane.
 *
 * EmbedAxes adds arrows to the output meshes for a look at them: x, y, z of lengths 1, 0.8 and 0.6 of AxesLength.
 *
 * The results depend on the initial orientation by rounding only, and not on the number of work units.
 *
 * Errors: no mesh at all; a cell that is not a triangle; a mesh in which no arch is found (the message says which).
 *
 * Source: the paper's section "U-Midline Dental Axis Construction"; what it leaves open is decided in
 * Documentation/UMDA.md, with formulas and measured errors.
 *
 * \ingroup UMidlineDentalAxis
 */
template <typename TMesh = Mesh<float, 3>>
class ITK_TEMPLATE_EXPORT UMidlineDentalAxisFilter : public MeshSource<TMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(UMidlineDentalAxisFilter);

  using Self = UMidlineDentalAxisFilter;
  using Superclass = MeshSource<TMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(UMidlineDentalAxisFilter, MeshSource);

  static_assert(TMesh::PointDimension == 3, "A dental arch has points in three dimensions.");

  using MeshType = TMesh;
  using TransformType = VersorRigid3DTransform<double>;
  using DecoratedTransformType = DataObjectDecorator<TransformType>;
  using FrameObjectType = DentalFrameObject;
  using PointType = Point<double, 3>;
  using VectorType = Vector<double, 3>;
  using JawEnum = ToothCode::JawEnum;
  using JawsShareFrameEnum = UMidlineDentalAxisFilterEnums::JawsShareFrame;
  using DataObjectPointer = ProcessObject::DataObjectPointer;
  using DataObjectPointerArraySizeType = ProcessObject::DataObjectPointerArraySizeType;

  /** A plane through a point; the normal is one of the frame's axes. In the mesh's frame. */
  struct PlaneType
  {
    PointType  point;  /**< mm, in the plane. */
    VectorType normal; /**< Of length 1. */
  };
  /** Scans, mm; one of them may be missing. */
  itkSetInputMacro(UpperMesh, MeshType);
  itkGetInputMacro(UpperMesh, MeshType);
  itkSetInputMacro(LowerMesh, MeshType);
  itkGetInputMacro(LowerMesh, MeshType);

  /** Default Check: the jaws share a frame if contact, heights and directions of the arches fit occlusion. */
  itkSetEnumMacro(JawsShareFrame, JawsShareFrameEnum);
  itkGetEnumMacro(JawsShareFrame, JawsShareFrameEnum);

  /** The paper's p as a share of the surface, in (0, 1]. Default 0.15. */
  itkSetMacro(CrownFraction, double);
  itkGetConstMacro(CrownFraction, double);

  /** Rounds of crown candidates, PCA, occlusal direction. Default 20; it stops when the direction does. */
  itkSetMacro(MaximumIterations, unsigned int);
  itkGetConstMacro(MaximumIterations, unsigned int);

  /** Default off. */
  itkSetMacro(RefineMidline, bool);
  itkGetConstMacro(RefineMidline, bool);
  itkBooleanMacro(RefineMidline);

  /** Default off. */
  itkSetMacro(EmbedAxes, bool);
  itkGetConstMacro(EmbedAxes, bool);
  itkBooleanMacro(EmbedAxes);

  /** Length of the x arrow, mm. Default 40. */
  itkSetMacro(AxesLength, double);
  itkGetConstMacro(AxesLength, double);

  /** Default on. Off: the output meshes stay empty, for those who want the frames alone and not a copy of the scans. */
  itkSetMacro(TransformMeshes, bool);
  itkGetConstMacro(TransformMeshes, bool);
  itkBooleanMacro(TransformMeshes);

  /** Default on: a mesh in which no arch is found is an error. Off: its outputs are empty, GetJawFrame().valid says so,
   * and the other jaw is none the worse for it. */
  itkSetMacro(RequireArches, bool);
  itkGetConstMacro(RequireArches, bool);
  itkBooleanMacro(RequireArches);
  /** The scans in their dental frames, mm; empty where TransformMeshes is off. */
  MeshType *
  GetUpperOutput();
  MeshType *
  GetLowerOutput();

  /** Mesh -> UMDA. */
  DecoratedTransformType *
  GetUpperTransformOutput();
  DecoratedTransformType *
  GetLowerTransformOutput();
  /** Mesh -> the frame that both jaws share; Get() is null where they share none. */
  DecoratedTransformType *
  GetJointTransformOutput();

  /** Everything found, for the filters that judge it (ScanCheckFilter). */
  FrameObjectType *
  GetFrameOutput();
  const FrameObjectType *
  GetFrameOutput() const;

  /** Everything found, in the meshes' frames: baseline, midpoint, incisal edge, arch width and depth, confidence and
   * its factors, occlusion test, overjet and overbite. Valid after Update(). */
  const DentalFrameResult &
  GetFrame() const
  {
    return this->GetFrameOutput()->Get();
  }
  /** What was found of one jaw. Throws std::invalid_argument of an unknown jaw, as all that takes one here. */
  const DentalJawFrame &
  GetJawFrame(JawEnum jaw) const
  {
    return this->GetFrame().GetJaw(jaw);
  }

  /** Molar baseline's ends and midpoint, and the incisal edge, in the mesh's frame. */
  PointType
  GetBaselineRight(JawEnum jaw) const;
  PointType
  GetBaselineLeft(JawEnum jaw) const;
  PointType
  GetBaselineMidpoint(JawEnum jaw) const;
  PointType
  GetIncisalEdge(JawEnum jaw) const;

  /** XY, XZ and YZ plane through the frame's origin. */
  PlaneType
  GetOcclusalPlane(JawEnum jaw) const;
  PlaneType
  GetMidlinePlane(JawEnum jaw) const;
  PlaneType
  GetCoronalPlane(JawEnum jaw) const;

  /** Length of the molar baseline, and from its midpoint to the incisal edge along x; mm. */
  double
  GetArchWidth(JawEnum jaw) const
  {
    return this->GetJawFrame(jaw).archWidth;
  }
  double
  GetArchDepth(JawEnum jaw) const
  {
    return this->GetJawFrame(jaw).archDepth;
  }

  /** In [0, 1]: the product of how clear the occlusal side, the crowns' plane, the U and its symmetry are. 1 for a full
   * arch; below 0.5 a person should look at the axes. */
  double
  GetConfidence(JawEnum jaw) const
  {
    return this->GetJawFrame(jaw).confidence;
  }

  /** Whether the jaws were treated as in one frame; overjet and overbite (mm, incisal edge to incisal edge) mean
   * something only then. */
  bool
  GetJawsAreInOneFrame() const
  {
    return this->GetFrame().jawsShareFrame;
  }
  double
  GetOverjet() const
  {
    return this->GetFrame().overjet;
  }
  double
  GetOverbite() const
  {
    return this->GetFrame().overbite;
  }

  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  UMidlineDentalAxisFilter();
  ~UMidlineDentalAxisFilter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  PlaneType
  MakePlane(JawEnum jaw, unsigned int axis) const;

  typename TransformType::Pointer
  MakeTransform(const DentalJawFrame & frame) const;

  void
  TransformJaw(const MeshType * input, const TransformType * transform, MeshType * output) const;

  void
  AddAxes(MeshType * output) const;

  JawsShareFrameEnum m_JawsShareFrame{ JawsShareFrameEnum::Check };
  double             m_CrownFraction{ 0.15 };
  unsigned int       m_MaximumIterations{ 20 };
  bool               m_RefineMidline{ false };
  bool               m_EmbedAxes{ false };
  double             m_AxesLength{ 40.0 };
  bool               m_TransformMeshes{ true };
  bool               m_RequireArches{ true };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkUMidlineDentalAxisFilter.hxx"
#endif

#ifndef UMIDLINEDENTALAXIS_INSTANTIATE
namespace itk
{
extern template class UMidlineDentalAxisFilter<Mesh<float, 3>>;
extern template class UMidlineDentalAxisFilter<Mesh<double, 3>>;
} // namespace itk
#endif

#endif
