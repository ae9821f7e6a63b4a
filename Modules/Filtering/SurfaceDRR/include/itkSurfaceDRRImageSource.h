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
#ifndef itkSurfaceDRRImageSource_h
#define itkSurfaceDRRImageSource_h

#include "SurfaceDRRExport.h"
#include "itkCephalometricGeometry.h"
#include "itkSurfaceSplatKernel.h"

#include "itkGenerateImageSource.h"
#include "itkImage.h"
#include "itkMesh.h"

#include <array>
#include <ostream>
#include <vector>

namespace itk
{
/** \class SurfaceDRRImageSourceEnums
 * \brief Enumerations of SurfaceDRRImageSource.
 *
 * \ingroup SurfaceDRR
 */
class SurfaceDRRImageSourceEnums
{
public:
  /** What a splat weighs; see SurfaceDRRImageSource. */
  enum class Normalization : uint8_t
  {
    Paper,
    Physical
  };
  /** What a pixel holds; see SurfaceDRRImageSource. */
  enum class Output : uint8_t
  {
    Thickness,
    Intensity,
    InvertedIntensity
  };
};
SurfaceDRR_EXPORT std::ostream &
                  operator<<(std::ostream & os, SurfaceDRRImageSourceEnums::Normalization normalization);
SurfaceDRR_EXPORT std::ostream &
                  operator<<(std::ostream & os, SurfaceDRRImageSourceEnums::Output output);

/** \class SurfaceDRRImageSource
 * \brief Digitally reconstructed radiograph of triangle meshes, taken as hollow shells: area-weighted Gaussian splats
 * in perspective.
 *
 * With (u_i, v_i) the projection of vertex i, a_i a third of the area of the triangles around it and distances in mm in
 * the detector plane,
 *
 *   L(u, v) = sum_i w_i exp(-|(u, v) - (u_i, v_i)|^2 / (2 sigma_i^2))
 *
 *  - Paper:    w_i = rho_0 a_i.
 *  - Physical: w_i = rho_0 a_i m_i^2 / (2 pi sigma_i^2 cos(alpha_i)), with m_i the vertex's magnification and alpha_i
 *    the ray's angle to the detector's normal. L is then the path length, in mm, through shells of thickness rho_0 mm:
 *    rho_0 / cos(theta) for each surface that the ray crosses at the angle theta to its normal, as the mesh is refined.
 *
 * Output: Thickness L; Intensity I_0 exp(-mu_0 L); InvertedIntensity I_0 (1 - exp(-mu_0 L)), bright where it is dense,
 * as a radiograph is shown. Integer pixels are rounded and clamped to their range.
 *
 * Grid: the image's physical space is the detector plane in mm with its origin at the centre of the cephalogram's pixel
 * (0, 0): physical point = pixel index * pixel spacing. With the defaults (spacing from the geometry, origin 0) an
 * index of the image, continuous or not, is the cephalogram's: that of CephalometricGeometry::ProjectPoint(). With
 * UseGeometrySpacingOff() spacing and origin are the user's or the reference's, in mm of the detector plane. The
 * direction must be the identity.
 *
 * Region, one of three:
 *  - CoverMeshes, the default: every projected vertex and CoverMargin around it. It follows the meshes, the pose and
 * the widths, so that nothing is clipped when an input changes. The start index may be negative. To know the region,
 * the source brings its meshes and the geometry up to date in UpdateOutputInformation().
 *  - SetSize(), which turns CoverMeshes off, and SetStartIndex().
 *  - UseReferenceImage, before the other two: the reference's region. Its origin is taken in its own pixels, so that a
 *    radiograph from a file without a spacing serves as a reference.
 *
 * Inputs: one or more meshes of triangles (mm, frame of the geometry's pose), each with a width of its own, per vertex
 * if wanted; the geometry. Output: one image, streamed by requested region. Same bits for any region, number of threads
 * and rerun.
 *
 * The error relative to the maximum on the detector plane stays within Tolerance; SurfaceSplatKernel and
 * Documentation/SurfaceDRR.md say how. Flattening and vertex areas are kept until a mesh changes, projected splats
 * until anything that they depend on changes: strips do not repeat them. A change made through the elements of a
 * container alone needs mesh->Modified().
 *
 * Errors: no mesh or geometry, a mesh without triangles, cells that are not triangles, a point not in front of the
 * source, a width that is not positive or is above 1000 pixels, an incomplete geometry, no region (CoverMeshesOff()
 * without a size, UseReferenceImageOn() without a reference). Triangles without area are no error and leave no trace.
 *
 * Source: the paper's sections on the surface-based DRR and on Gaussian splatting.
 *
 * \ingroup SurfaceDRR
 */
template <typename TInputMesh, typename TOutputImage = Image<float, 2>>
class SurfaceDRRImageSource : public GenerateImageSource<TOutputImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SurfaceDRRImageSource);

  using Self = SurfaceDRRImageSource;
  using Superclass = GenerateImageSource<TOutputImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(SurfaceDRRImageSource, GenerateImageSource);

  using InputMeshType = TInputMesh;
  using OutputImageType = TOutputImage;
  using PixelType = typename TOutputImage::PixelType;
  using RegionType = typename TOutputImage::RegionType;
  using SpacingType = typename TOutputImage::SpacingType;
  using PointType = typename TOutputImage::PointType;
  using IndexType = typename TOutputImage::IndexType;
  using SizeType = typename TOutputImage::SizeType;
  using GeometryType = CephalometricGeometry;
  using NormalizationEnum = SurfaceDRRImageSourceEnums::Normalization;
  using OutputEnum = SurfaceDRRImageSourceEnums::Output;

  static_assert(TOutputImage::ImageDimension == 2, "A radiograph has two dimensions.");
  static_assert(TInputMesh::PointDimension == 3, "A surface has points in three dimensions.");

  /** The only mesh, or the first. */
  using Superclass::SetInput;
  void
  SetInput(const InputMeshType * mesh);
  /** One of several meshes, numbered from 0 without a gap; null removes it. */
  void
  SetInput(unsigned int number, const InputMeshType * mesh);
  const InputMeshType *
  GetInput(unsigned int number = 0) const;
  unsigned int
  GetNumberOfMeshes() const;

  /** Source, detector, pixel grid and pose. */
  itkSetInputMacro(Geometry, GeometryType);
  itkGetInputMacro(Geometry, GeometryType);

  /** Width of the splats, mm in the detector plane, of every mesh without one of its own. Default 0.5. */
  itkSetMacro(Sigma, double);
  itkGetConstMacro(Sigma, double);

  /** Width for one mesh; 0 returns to Sigma. */
  void
  SetMeshSigma(unsigned int number, double sigma);
  double
  GetMeshSigma(unsigned int number) const;

  /** Widths for one mesh, one a vertex in the order of the points; empty returns to one width. */
  void
  SetVertexSigmas(unsigned int number, const std::vector<double> & sigmas);
  const std::vector<double> &
  GetVertexSigmas(unsigned int number) const;

  /** Default Physical. */
  itkSetEnumMacro(Normalization, NormalizationEnum);
  itkGetEnumMacro(Normalization, NormalizationEnum);

  /** Default Thickness. */
  itkSetEnumMacro(OutputMode, OutputEnum);
  itkGetEnumMacro(OutputMode, OutputEnum);

  /** rho_0: the shell's thickness in mm (Physical), a factor (Paper). Default 1. */
  itkSetMacro(Density, double);
  itkGetConstMacro(Density, double);

  /** I_0. Default 1; 255 suits unsigned char. */
  itkSetMacro(SourceIntensity, double);
  itkGetConstMacro(SourceIntensity, double);

  /** mu_0, a mm (Physical). Default 0.08, enamel at about 60 keV. */
  itkSetMacro(Attenuation, double);
  itkGetConstMacro(Attenuation, double);

  /** Largest error of L relative to the maximum on the detector plane, in [1e-6, 0.1]. Default 1e-3. */
  itkSetMacro(Tolerance, double);
  itkGetConstMacro(Tolerance, double);

  /** Take the pixel spacing from the geometry. Default on. */
  itkSetMacro(UseGeometrySpacing, bool);
  itkGetConstMacro(UseGeometrySpacing, bool);
  itkBooleanMacro(UseGeometrySpacing);

  /** The region holds every projected vertex and a margin, whatever the inputs become. Default on; SetSize() turns it
   * off. An image above 2^32 pixels is an error. */
  itkSetMacro(CoverMeshes, bool);
  itkGetConstMacro(CoverMeshes, bool);
  itkBooleanMacro(CoverMeshes);

  /** Margin of CoverMeshes, mm in the detector plane. Default -1: negative stands for four times the largest sigma, at
   * which a splat has fallen to 3e-4 of its peak, so that an iso-contour does not touch the border. */
  itkSetMacro(CoverMargin, double);
  itkGetConstMacro(CoverMargin, double);

  /** CoverMeshesOn(), UseReferenceImageOff() and SetCoverMargin() in one. Throws for a negative margin. */
  void
  SetSizeToCoverMeshes(double margin);

  /** A region of one's own: turns CoverMeshes off. */
  void
  SetSize(SizeType size) override;
  void
  SetSize(SizeValueType size[]) override;

  /** The method that rendered a mesh last. */
  SurfaceSplatKernel::MethodEnum
  GetSplatMethod(unsigned int number) const;

  /** How often a mesh was flattened and its areas computed, and how often the splats were projected and sorted, since
   * construction. */
  itkGetConstMacro(NumberOfFlattenings, SizeValueType);
  itkGetConstMacro(NumberOfProjections, SizeValueType);

protected:
  SurfaceDRRImageSource();
  ~SurfaceDRRImageSource() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateOutputInformation() override;
  void
  GenerateData() override;

private:
  struct SurfaceType
  {
    const InputMeshType *              mesh{ nullptr };
    ModifiedTimeType                   time{ 0 };
    std::vector<std::array<double, 3>> points;
    std::vector<double>                areas;
  };
  struct WidthType
  {
    double              sigma{ 0.0 };
    std::vector<double> vertexSigmas;
  };

  static std::string
  MeshInputName(unsigned int number);
  WidthType &
  Width(unsigned int number);
  /** The region of CoverMeshes, in the spacing and origin of the output. */
  RegionType
  ComputeCoveringRegion();
  void
  FlattenMeshes();
  void
  MakeKernels();
  SurfaceSplatProjector
  MakeProjector() const;
  /** Fills the layer with the splats of a surface; throws for a point behind the source. */
  void
  Project(unsigned int number, const SurfaceSplatProjector & projector, SurfaceSplatLayer & layer);
  void
  CheckAbort();
  /** As many as the user allows and ITK has. */
  unsigned int
  ChooseNumberOfThreads();

  double                 m_Sigma{ 0.5 };
  std::vector<WidthType> m_Widths;
  NormalizationEnum      m_Normalization{ NormalizationEnum::Physical };
  OutputEnum             m_OutputMode{ OutputEnum::Thickness };
  double                 m_Density{ 1.0 };
  double                 m_SourceIntensity{ 1.0 };
  double                 m_Attenuation{ 0.08 };
  double                 m_Tolerance{ 1e-3 };
  bool                   m_UseGeometrySpacing{ true };
  bool                   m_CoverMeshes{ true };
  double                 m_CoverMargin{ -1.0 };
  bool                   m_SizeIsSet{ false };

  std::vector<SurfaceType>        m_Surfaces;
  std::vector<SurfaceSplatKernel> m_Kernels;
  /** What the kernels were made from. */
  ModifiedTimeType m_KernelTime{ 0 };
  RegionType       m_KernelRegion;
  SpacingType      m_KernelSpacing;
  PointType        m_KernelOrigin;
  SizeValueType    m_NumberOfFlattenings{ 0 };
  SizeValueType    m_NumberOfProjections{ 0 };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkSurfaceDRRImageSource.hxx"
#endif

namespace itk
{
extern template class SurfaceDRRImageSource<Mesh<float, 3>, Image<float, 2>>;
extern template class SurfaceDRRImageSource<Mesh<double, 3>, Image<float, 2>>;
extern template class SurfaceDRRImageSource<Mesh<float, 3>, Image<unsigned char, 2>>;
extern template class SurfaceDRRImageSource<Mesh<double, 3>, Image<unsigned char, 2>>;
} // namespace itk

#endif
