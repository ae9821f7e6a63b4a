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
#ifndef itkDentalPhantomMeshSource_h
#define itkDentalPhantomMeshSource_h

#include "DentalPhantomExport.h"
#include "itkDentalLandmarkSet.h"
#include "itkDentalPhantomParameters.h"

#include "itkDefaultStaticMeshTraits.h"
#include "itkMatrix.h"
#include "itkMesh.h"
#include "itkMeshSource.h"
#include "itkVector.h"

#include <memory>

namespace itk
{
class DentalPhantomModel;

/** \class DentalPhantomMeshSource
 * \brief A pair of parametric dental arches in occlusion, with tooth labels, landmarks and known axes.
 *
 * Outputs are the upper and the lower jaw as manifold triangle meshes, wound outward, in mm: open shells as an
 * intraoral scanner makes them, or closed casts (DentalPhantomParameters::stoneBase). The pixel data of a point is its
 * tooth's FDI number, 0 for gingiva. Two more outputs hold the landmarks of both sides; each is a vertex of the mesh.
 * By construction the anatomical axes are known: in the frame Anatomical they are the coordinate axes (x anterior, y
 * patient's left, z superior), else GetFrameRotation() and GetFrameTranslation() lead from there to the mesh.
 * Coordinates lie on a raster of 1e-4 mm; the bits are the same for any number of work units.
 *
 * Throws where a parameter is out of its range (DentalPhantomParameters::Validate()). Documentation/Phantom.md
 * describes the shapes.
 *
 * \ingroup DentalPhantom
 */
template <typename TOutputMesh = Mesh<float, 3>>
class ITK_TEMPLATE_EXPORT DentalPhantomMeshSource : public MeshSource<TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalPhantomMeshSource);

  using Self = DentalPhantomMeshSource;
  using Superclass = MeshSource<TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using OutputMeshType = TOutputMesh;
  using LandmarkSetType = DentalLandmarkSet<3>;
  using ParametersType = DentalPhantomParameters;
  using RotationType = Matrix<double, 3, 3>;
  using VectorType = Vector<double, 3>;
  using DataObjectPointer = ProcessObject::DataObjectPointer;
  using DataObjectPointerArraySizeType = ProcessObject::DataObjectPointerArraySizeType;

  static_assert(TOutputMesh::PointDimension == 3, "A dental arch has points in three dimensions.");

  itkNewMacro(Self);
  itkTypeMacro(DentalPhantomMeshSource, MeshSource);

  /** What to make. Default: an average pair without irregularity, in the anatomical frame. */
  void
  SetParameters(const ParametersType & parameters);
  const ParametersType &
  GetParameters() const
  {
    return m_Parameters;
  }
  /** DentalPhantomParameters::Draw(): one of a kind for a seed. */
  void
  DrawParameters(std::uint64_t seed);

  /** Outputs 0 and 1. */
  TOutputMesh *
  GetUpperOutput();
  TOutputMesh *
  GetLowerOutput();

  /** Outputs 2 and 3, in the frame of the meshes. */
  LandmarkSetType *
  GetUpperLandmarks();
  LandmarkSetType *
  GetLowerLandmarks();

  /** From the anatomical frame to that of a jaw's mesh, 0 upper, 1 lower: mesh point = rotation * p + translation.
   * Valid without Update(), but for a centred frame, whose origin is the centroid of the scan that Update() makes. */
  RotationType
  GetFrameRotation(unsigned int jaw) const;
  VectorType
  GetFrameTranslation(unsigned int jaw) const;

  /** The solids behind the meshes, in the anatomical frame; made by Update(), null before. */
  std::shared_ptr<const DentalPhantomModel>
  GetModel() const
  {
    return m_Model;
  }

  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  DentalPhantomMeshSource();
  ~DentalPhantomMeshSource() override = default;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  ParametersType                            m_Parameters;
  std::shared_ptr<const DentalPhantomModel> m_Model;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkDentalPhantomMeshSource.hxx"
#endif

#ifndef DENTALPHANTOM_INSTANTIATE
namespace itk
{
extern template class DentalPhantomMeshSource<Mesh<float, 3>>;
extern template class DentalPhantomMeshSource<Mesh<double, 3>>;
} // namespace itk
#endif

#endif
