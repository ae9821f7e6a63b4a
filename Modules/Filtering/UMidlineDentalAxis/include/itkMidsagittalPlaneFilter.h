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
#ifndef itkMidsagittalPlaneFilter_h
#define itkMidsagittalPlaneFilter_h

#include "UMidlineDentalAxisExport.h"
#include "itkDentalFrameEstimator.h"

#include "itkMesh.h"
#include "itkPoint.h"
#include "itkProcessObject.h"
#include "itkSimpleDataObjectDecorator.h"
#include "itkVector.h"

namespace itk
{
/** \class MidsagittalPlaneFilter
 * \brief The plane about which one dental arch, or a pair in occlusion, is its own mirror image.
 *
 * Inputs: upper and/or lower mesh, triangles wound outward, mm, in any orientation; both in one frame. Only the crowns
 * are used: gingiva, palate, base and trimming do not count. Output: the plane dot(normal, p) = offset in the meshes'
 * frame, normal to the patient's left, with the mean mirror distance, the share of the crowns that have a mirror image
 * and the margin to the next best plane (MidsagittalPlaneResult). A margin below about 0.1 mm means that another plane
 * is nearly as good.
 *
 * Errors: no mesh; a mesh in which no arch is found.
 *
 * EstimateMidsagittalPlane() is the kernel; Documentation/UMDA.md has formulas and measured errors.
 *
 * \ingroup UMidlineDentalAxis
 */
template <typename TMesh = Mesh<float, 3>>
class ITK_TEMPLATE_EXPORT MidsagittalPlaneFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MidsagittalPlaneFilter);

  using Self = MidsagittalPlaneFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(MidsagittalPlaneFilter, ProcessObject);

  using MeshType = TMesh;
  using PlaneObjectType = SimpleDataObjectDecorator<MidsagittalPlaneResult>;
  using PointType = Point<double, 3>;
  using VectorType = Vector<double, 3>;
  using ProcessObject::MakeOutput;
  using DataObjectPointer = ProcessObject::DataObjectPointer;
  using DataObjectPointerArraySizeType = ProcessObject::DataObjectPointerArraySizeType;
  /** Scans in one frame, in occlusion, mm; one of them may be missing. */
  itkSetInputMacro(UpperMesh, MeshType);
  itkGetInputMacro(UpperMesh, MeshType);
  itkSetInputMacro(LowerMesh, MeshType);
  itkGetInputMacro(LowerMesh, MeshType);

  /** Kernel parameters. */
  void
  SetOptions(const MidsagittalPlaneOptions & options)
  {
    m_Options = options;
    this->Modified();
  }
  const MidsagittalPlaneOptions &
  GetOptions() const
  {
    return m_Options;
  }
  /** The plane, with how sure it is. */
  PlaneObjectType *
  GetPlaneOutput();
  const PlaneObjectType *
  GetPlaneOutput() const;

  /** Of the plane found by the last Update(). */
  VectorType
  GetNormal() const;
  double
  GetOffset() const;
  double
  SignedDistance(const PointType & point) const;

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  MidsagittalPlaneFilter();
  ~MidsagittalPlaneFilter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  MidsagittalPlaneOptions m_Options;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMidsagittalPlaneFilter.hxx"
#endif

#ifndef UMIDLINEDENTALAXIS_INSTANTIATE
namespace itk
{
extern template class MidsagittalPlaneFilter<Mesh<float, 3>>;
extern template class MidsagittalPlaneFilter<Mesh<double, 3>>;
} // namespace itk
#endif

#endif
