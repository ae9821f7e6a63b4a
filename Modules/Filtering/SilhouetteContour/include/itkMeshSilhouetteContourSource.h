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
#ifndef itkMeshSilhouetteContourSource_h
#define itkMeshSilhouetteContourSource_h

#include "SilhouetteContourExport.h"
#include "itkMeshSilhouetteContourSourceBase.h"

#include <vector>

namespace itk
{
/** \class MeshSilhouetteContourSource
 * \brief The exact outer silhouette of a mesh in a cephalogram, as a closed contour.
 *
 * Inputs: see the base. Once the mesh is prepared, a pose costs about a millisecond for 200 000 triangles.
 *
 * Output: closed polylines in continuous pixel indices, largest area first, in the sense that SilhouetteLoop defines.
 * It is the boundary of the union of all projected triangles without its holes; see MeshSilhouette. Each point has the
 * point of the surface that projects to it and the outward normal, at a corner that of the segment which begins there;
 * GetSamples() has these with their place along the loop.
 *
 * Errors: no mesh or geometry, an incomplete geometry, cells that are not triangles, points that are not finite or not
 * in front of the source. A mesh without triangles gives an empty contour.
 *
 * Source: the paper's contour of the DRR, here without a picture in between.
 *
 * \ingroup SilhouetteContour
 */
template <typename TInputMesh>
class ITK_TEMPLATE_EXPORT MeshSilhouetteContourSource : public MeshSilhouetteContourSourceBase<TInputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MeshSilhouetteContourSource);

  using Self = MeshSilhouetteContourSource;
  using Superclass = MeshSilhouetteContourSourceBase<TInputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(MeshSilhouetteContourSource, MeshSilhouetteContourSourceBase);

  using InputMeshType = TInputMesh;
  using GeometryType = CephalometricGeometry;
  using SamplesType = std::vector<SilhouetteSample>;

  /** Only the part with the largest area (the default), or all parts that do not hide in another. */
  itkSetMacro(LargestPartOnly, bool);
  itkGetConstMacro(LargestPartOnly, bool);
  itkBooleanMacro(LargestPartOnly);

  /** Points of the output in total, at equal distances along each part and shared out by length, at least 3 a part; 0
   * (the default): the corners of the silhouette. */
  itkSetMacro(NumberOfPoints, SizeValueType);
  itkGetConstMacro(NumberOfPoints, SizeValueType);

  /** Of each point of the output: rim point (object frame, mm), outward normal, arc length within its part. Valid after
   * Update(). */
  const SamplesType &
  GetSamples() const
  {
    return m_Samples;
  }

  /** The silhouette with its mesh edges, all parts. Valid after Update(). */
  const Silhouette &
  GetSilhouette() const
  {
    return m_Silhouette;
  }

protected:
  MeshSilhouetteContourSource() = default;
  ~MeshSilhouetteContourSource() override = default;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  bool          m_LargestPartOnly{ true };
  SizeValueType m_NumberOfPoints{ 0 };

  Silhouette  m_Silhouette;
  SamplesType m_Samples;
};

} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMeshSilhouetteContourSource.hxx"
#endif

namespace itk
{
extern template class MeshSilhouetteContourSource<Mesh<float, 3>>;
extern template class MeshSilhouetteContourSource<Mesh<double, 3>>;
} // namespace itk

#endif
