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
#ifndef itkSurfaceDRRImageSource_hxx
#define itkSurfaceDRRImageSource_hxx

#include "itkSurfaceDRRImageSource.h"

#include "itkMakeTriangleSurface.h"
#include "itkMath.h"
#include "itkMultiThreaderBase.h"
#include "itkNumericTraits.h"
#include "itkParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>

namespace itk
{
template <typename TInputMesh, typename TOutputImage>
SurfaceDRRImageSource<TInputMesh, TOutputImage>::SurfaceDRRImageSource()
{
  this->AddRequiredInputName("Geometry");
  m_KernelSpacing.Fill(0.0);
  m_KernelOrigin.Fill(0.0);
}

template <typename TInputMesh, typename TOutputImage>
std::string
SurfaceDRRImageSource<TInputMesh, TOutputImage>::MeshInputName(unsigned int number)
{
  // Index 1 belongs to the superclass's reference image, hence names.
  return number == 0 ? "Primary" : "Mesh" + std::to_string(number);
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::SetInput(const InputMeshType * mesh)
{
  this->SetInput(0u, mesh);
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::SetInput(unsigned int number, const InputMeshType * mesh)
{
  if (mesh == nullptr && number > 0)
  {
    this->RemoveInput(MeshInputName(number));
    return;
  }
  this->ProcessObject::SetInput(MeshInputName(number), const_cast<InputMeshType *>(mesh));
}

template <typename TInputMesh, typename TOutputImage>
auto
SurfaceDRRImageSource<TInputMesh, TOutputImage>::GetInput(unsigned int number) const -> const InputMeshType *
{
  return dynamic_cast<const InputMeshType *>(this->ProcessObject::GetInput(MeshInputName(number)));
}

template <typename TInputMesh, typename TOutputImage>
unsigned int
SurfaceDRRImageSource<TInputMesh, TOutputImage>::GetNumberOfMeshes() const
{
  unsigned int number = 0;
  while (this->GetInput(number) != nullptr)
  {
    ++number;
  }
  return number;
}

template <typename TInputMesh, typename TOutputImage>
auto
SurfaceDRRImageSource<TInputMesh, TOutputImage>::Width(unsigned int number) -> WidthType &
{
  if (number >= m_Widths.size())
  {
    m_Widths.resize(number + 1);
  }
  return m_Widths[number];
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::SetMeshSigma(unsigned int number, double sigma)
{
  WidthType & width = this->Width(number);
  if (width.sigma != sigma)
  {
    width.sigma = sigma;
    this->Modified();
  }
}

template <typename TInputMesh, typename TOutputImage>
double
SurfaceDRRImageSource<TInputMesh, TOutputImage>::GetMeshSigma(unsigned int number) const
{
  return number < m_Widths.size() && m_Widths[number].sigma != 0.0 ? m_Widths[number].sigma : m_Sigma;
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::SetVertexSigmas(unsigned int                number,
                                                                 const std::vector<double> & sigmas)
{
  WidthType & width = this->Width(number);
  if (width.vertexSigmas != sigmas)
  {
    width.vertexSigmas = sigmas;
    this->Modified();
  }
}

template <typename TInputMesh, typename TOutputImage>
const std::vector<double> &
SurfaceDRRImageSource<TInputMesh, TOutputImage>::GetVertexSigmas(unsigned int number) const
{
  static const std::vector<double> none;
  return number < m_Widths.size() ? m_Widths[number].vertexSigmas : none;
}

template <typename TInputMesh, typename TOutputImage>
SurfaceSplatKernel::MethodEnum
SurfaceDRRImageSource<TInputMesh, TOutputImage>::GetSplatMethod(unsigned int number) const
{
  if (number >= m_Kernels.size())
  {
    itkExceptionMacro("Mesh " << number << " was not rendered yet; call Update() first.");
  }
  return m_Kernels[number].GetMethod();
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::VerifyPreconditions() ITKv5_CONST
{
  const unsigned int meshes = this->GetNumberOfMeshes();
  if (meshes == 0)
  {
    itkExceptionMacro("There is no mesh; call SetInput() with a mesh of triangles.");
  }
  if (this->GetGeometry() == nullptr)
  {
    itkExceptionMacro("There is no geometry; call SetGeometry() with a CephalometricGeometry.");
  }
  for (const std::string & name : this->GetInputNames())
  {
    if (name.compare(0, 4, "Mesh") == 0 && this->ProcessObject::GetInput(name) != nullptr &&
        std::stoul(name.substr(4)) >= meshes)
    {
      itkExceptionMacro("Meshes are numbered from 0 without a gap: there is a " << name << ", but no mesh " << meshes
                                                                                << ".");
    }
  }
  for (unsigned int number = 0; number < meshes; ++number)
  {
    const double sigma = this->GetMeshSigma(number);
    if (!(sigma > 0.0) || !std::isfinite(sigma))
    {
      itkExceptionMacro("The sigma of mesh " << number << " is " << sigma
                                             << " mm; give a positive one by SetSigma() or SetMeshSigma().");
    }
    for (const double vertexSigma : this->GetVertexSigmas(number))
    {
      if (!(vertexSigma > 0.0) || !std::isfinite(vertexSigma))
      {
        itkExceptionMacro("A vertex sigma of mesh " << number << " is " << vertexSigma
                                                    << " mm; give positive ones by SetVertexSigmas().");
      }
    }
  }
  if (!(m_Tolerance >= 1e-6 && m_Tolerance <= 0.1))
  {
    itkExceptionMacro("The tolerance is " << m_Tolerance << "; call SetTolerance() with a value in [1e-6, 0.1].");
  }
  if (!(m_Density >= 0.0) || !(m_Attenuation >= 0.0) || !std::isfinite(m_Density) || !std::isfinite(m_Attenuation) ||
      !std::isfinite(m_SourceIntensity))
  {
    itkExceptionMacro("Density " << m_Density << " and attenuation " << m_Attenuation
                                 << " must be finite and not negative, the source intensity " << m_SourceIntensity
                                 << " finite.");
  }
  if (this->GetUseReferenceImage() && this->GetReferenceImage() == nullptr)
  {
    itkExceptionMacro("UseReferenceImage is on but there is no reference image; call SetReferenceImage(), or "
                      "UseReferenceImageOff().");
  }
  if (!this->GetUseReferenceImage() && !m_CoverMeshes && !m_SizeIsSet)
  {
    itkExceptionMacro("The image has no size: call SetSize(), or CoverMeshesOn() for one that holds the meshes.");
  }
  if (!std::isfinite(m_CoverMargin))
  {
    itkExceptionMacro("The margin is " << m_CoverMargin << " mm; call SetCoverMargin() with a finite one.");
  }
  Superclass::VerifyPreconditions();
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::GenerateOutputInformation()
{
  // Each value is set once: by way of the superclass's defaults the image would be modified at every call, and all that
  // lies downstream would run again.
  OutputImageType *          image = this->GetOutput();
  const ImageBase<2> * const reference = this->GetUseReferenceImage() ? this->GetReferenceImage() : nullptr;
  const auto                 bringUpToDate = [](const DataObject * input) {
    if (input->GetSource() != nullptr)
    {
      const_cast<DataObject *>(input)->Update();
    }
  };
  // The pixel grid is a value of the geometry's, not of its information: it has to be there by now.
  const GeometryType * geometry = this->GetGeometry();
  bringUpToDate(geometry);
  geometry->VerifyComplete();
  SpacingType spacing = reference != nullptr ? reference->GetSpacing() : this->GetSpacing();
  PointType   origin = reference != nullptr ? reference->GetOrigin() : this->GetOrigin();
  if (m_UseGeometrySpacing)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      if (reference != nullptr)
      {
        origin[d] *= geometry->GetPixelSpacing()[d] / spacing[d];
      }
      spacing[d] = geometry->GetPixelSpacing()[d];
    }
  }
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(reference != nullptr ? reference->GetDirection() : this->GetDirection());
  for (unsigned int row = 0; row < 2; ++row)
  {
    for (unsigned int column = 0; column < 2; ++column)
    {
      if (std::abs(image->GetDirection()(row, column) - (row == column ? 1.0 : 0.0)) > 1e-9)
      {
        itkExceptionMacro("The direction is\n"
                          << image->GetDirection()
                          << "but a radiograph's pixels run along u and v: set the identity. Facing belongs in the "
                             "geometry's SetFacing().");
      }
    }
  }
  RegionType region(this->GetStartIndex(), this->GetSize());
  if (reference != nullptr)
  {
    region = reference->GetLargestPossibleRegion();
  }
  else if (m_CoverMeshes)
  {
    // Where the meshes project to is a value of theirs, too.
    for (unsigned int number = 0; number < this->GetNumberOfMeshes(); ++number)
    {
      bringUpToDate(this->GetInput(number));
    }
    region = this->ComputeCoveringRegion();
  }
  // Who had asked for the whole image goes on asking for the whole image.
  const bool whole = image->GetRequestedRegion() == image->GetLargestPossibleRegion();
  image->SetLargestPossibleRegion(region);
  if (whole)
  {
    image->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::FlattenMeshes()
{
  const unsigned int meshes = this->GetNumberOfMeshes();
  m_Surfaces.resize(meshes);
  for (unsigned int number = 0; number < meshes; ++number)
  {
    const InputMeshType * mesh = this->GetInput(number);
    SurfaceType &         surface = m_Surfaces[number];
    ModifiedTimeType      time = mesh->GetMTime();
    if (mesh->GetPoints() != nullptr)
    {
      time = std::max(time, mesh->GetPoints()->GetMTime());
    }
    if (mesh->GetCells() != nullptr)
    {
      time = std::max(time, mesh->GetCells()->GetMTime());
    }
    if (surface.mesh == mesh && surface.time == time)
    {
      continue;
    }
    surface = SurfaceType();
    TriangleSurface flat = MakeTriangleSurface(mesh);
    if (flat.triangles.empty())
    {
      itkExceptionMacro("Mesh " << number << " has " << flat.points.size()
                                << " points and no triangle: there is no surface to project. Check what was read.");
    }
    surface.areas = flat.VertexAreas();
    surface.points = std::move(flat.points);
    surface.mesh = mesh;
    surface.time = time;
    ++m_NumberOfFlattenings;
  }
}

template <typename TInputMesh, typename TOutputImage>
SurfaceSplatProjector
SurfaceDRRImageSource<TInputMesh, TOutputImage>::MakeProjector() const
{
  const GeometryType *    geometry = this->GetGeometry();
  const OutputImageType * image = this->GetOutput();
  SurfaceSplatProjector   projector;
  projector.projection = geometry->GetProjection();
  projector.sourceToMidsagittal = geometry->GetSourceToMidsagittalDistance();
  projector.sourceToDetector = geometry->GetSourceToDetectorDistance();
  projector.physical = m_Normalization == NormalizationEnum::Physical;
  for (unsigned int d = 0; d < 2; ++d)
  {
    projector.principalPoint[d] = geometry->GetPrincipalPoint()[d];
    projector.pixelSpacing[d] = geometry->GetPixelSpacing()[d];
    projector.scale[d] = geometry->GetPixelSpacing()[d] / image->GetSpacing()[d];
    projector.offset[d] = -image->GetOrigin()[d] / image->GetSpacing()[d];
  }
  return projector;
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::Project(unsigned int                  number,
                                                         const SurfaceSplatProjector & projector,
                                                         SurfaceSplatLayer &           layer)
{
  const SurfaceType & surface = m_Surfaces[number];
  const std::size_t   count = surface.points.size();
  layer.u.resize(count);
  layer.v.resize(count);
  layer.weight.resize(count);
  static_assert(sizeof(std::array<double, 3>) == sizeof(double[3]), "Points are flat.");
  const auto * points = reinterpret_cast<const double(*)[3]>(surface.points.data());
  // The first point that is wrong is that of the first part that has one.
  const std::size_t        parts = 1 + count / 4096;
  std::vector<std::size_t> goods(parts);
  ParallelFor(parts, this->ChooseNumberOfThreads(), [&](std::size_t part) {
    const std::size_t end = count * (part + 1) / parts;
    const std::size_t good = projector.Project(points, surface.areas.data(), count * part / parts, end, 1.0, layer);
    goods[part] = good < end ? good : count;
  });
  const std::size_t good = *std::min_element(goods.begin(), goods.end());
  if (good < count)
  {
    const auto & p = surface.points[good];
    itkExceptionMacro("Point " << good << " of mesh " << number << ", (" << p[0] << ", " << p[1] << ", " << p[2]
                               << "), is not in front of the X-ray source. Check the mesh's unit (mm) and the "
                                  "geometry's pose.");
  }
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::MakeKernels()
{
  const OutputImageType * image = this->GetOutput();
  const RegionType        region = image->GetLargestPossibleRegion();
  ModifiedTimeType        time = std::max(this->GetMTime(), this->GetGeometry()->GetMTime());
  for (const SurfaceType & surface : m_Surfaces)
  {
    time = std::max(time, surface.time);
  }
  if (m_KernelTime == time && m_Kernels.size() == m_Surfaces.size() && m_KernelRegion == region &&
      m_KernelSpacing == image->GetSpacing() && m_KernelOrigin == image->GetOrigin())
  {
    return;
  }
  m_Kernels.resize(m_Surfaces.size());
  m_KernelTime = 0;
  SurfaceSplatRegion grid;
  grid.startU = region.GetIndex(0);
  grid.startV = region.GetIndex(1);
  grid.sizeU = static_cast<std::int64_t>(region.GetSize(0));
  grid.sizeV = static_cast<std::int64_t>(region.GetSize(1));
  const SurfaceSplatProjector projector = this->MakeProjector();
  const bool                  physical = projector.physical;
  const SpacingType           spacing = image->GetSpacing();
  for (unsigned int number = 0; number < m_Surfaces.size(); ++number)
  {
    SurfaceSplatLayer layer;
    this->Project(number, projector, layer);
    const auto & sigmas = this->GetVertexSigmas(number);
    // A Gaussian over the plane integrates to 2 pi sigma^2.
    const auto factor = [this, physical](double sigma) {
      return m_Density * (physical ? 1.0 / (2.0 * Math::pi * sigma * sigma) : 1.0);
    };
    if (sigmas.empty())
    {
      const double sigma = this->GetMeshSigma(number);
      layer.sigmaU = sigma / spacing[0];
      layer.sigmaV = sigma / spacing[1];
      const auto scale = static_cast<float>(factor(sigma));
      for (float & weight : layer.weight)
      {
        weight *= scale;
      }
    }
    else
    {
      if (sigmas.size() != layer.u.size())
      {
        itkExceptionMacro("Mesh " << number << " has " << layer.u.size() << " points but " << sigmas.size()
                                  << " vertex sigmas; call SetVertexSigmas() with one a point.");
      }
      layer.sigmaUs.resize(sigmas.size());
      layer.sigmaVs.resize(sigmas.size());
      for (std::size_t i = 0; i < sigmas.size(); ++i)
      {
        layer.sigmaUs[i] = static_cast<float>(sigmas[i] / spacing[0]);
        layer.sigmaVs[i] = static_cast<float>(sigmas[i] / spacing[1]);
        layer.weight[i] *= static_cast<float>(factor(sigmas[i]));
      }
    }
    try
    {
      m_Kernels[number].Prepare(
        layer, grid, m_Tolerance, SurfaceSplatKernel::MethodEnum::Automatic, this->ChooseNumberOfThreads());
    }
    catch (const std::invalid_argument & error)
    {
      itkExceptionMacro("Mesh " << number << ": " << error.what());
    }
    this->CheckAbort();
  }
  ++m_NumberOfProjections;
  m_KernelTime = time;
  m_KernelRegion = region;
  m_KernelSpacing = image->GetSpacing();
  m_KernelOrigin = image->GetOrigin();
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::CheckAbort()
{
  if (this->GetAbortGenerateData())
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }
}

template <typename TInputMesh, typename TOutputImage>
unsigned int
SurfaceDRRImageSource<TInputMesh, TOutputImage>::ChooseNumberOfThreads()
{
  return std::max<unsigned int>(
    1, std::min(this->GetNumberOfWorkUnits(), this->GetMultiThreader()->GetMaximumNumberOfThreads()));
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::GenerateData()
{
  this->UpdateProgress(0.0f);
  this->FlattenMeshes();
  this->CheckAbort();
  this->UpdateProgress(0.3f);
  this->MakeKernels();
  this->UpdateProgress(0.5f);

  this->AllocateOutputs();
  OutputImageType *  image = this->GetOutput();
  const RegionType   buffered = image->GetBufferedRegion();
  SurfaceSplatRegion region;
  region.startU = buffered.GetIndex(0);
  region.startV = buffered.GetIndex(1);
  region.sizeU = static_cast<std::int64_t>(buffered.GetSize(0));
  region.sizeV = static_cast<std::int64_t>(buffered.GetSize(1));
  const SizeValueType width = buffered.GetSize(0);
  const SizeValueType height = buffered.GetSize(1);
  PixelType * const   pixels = image->GetBufferPointer();

  std::unique_ptr<float[]> scratch;
  float *                  thickness = nullptr;
  if constexpr (std::is_same<PixelType, float>::value)
  {
    thickness = pixels;
  }
  else
  {
    scratch.reset(new float[width * height]);
    thickness = scratch.get();
  }

  // By the threads of ParallelFor() throughout: they are awake between one step and the next, where those of an ITK
  // threader would have to be woken for each.
  const unsigned int      threads = this->ChooseNumberOfThreads();
  constexpr SizeValueType rowsOfJob = 16;
  const auto              forEachRow = [threads, height](const auto & visit) {
    ParallelFor((height + rowsOfJob - 1) / rowsOfJob, threads, [&](std::size_t job) {
      for (SizeValueType row = job * rowsOfJob; row < std::min<SizeValueType>(height, (job + 1) * rowsOfJob); ++row)
      {
        visit(row);
      }
    });
  };
  forEachRow([thickness, width](SizeValueType row) { std::fill_n(thickness + row * width, width, 0.0f); });
  for (std::size_t layer = 0; layer < m_Kernels.size(); ++layer)
  {
    SurfaceSplatKernel::Rendering rendering(m_Kernels[layer], region, thickness, width);
    for (std::size_t phase = 0; phase < rendering.GetNumberOfPhases(); ++phase)
    {
      ParallelFor(
        rendering.GetNumberOfJobs(phase), threads, [&rendering, phase](std::size_t job) { rendering.Run(phase, job); });
      this->CheckAbort();
    }
    this->UpdateProgress(0.5f + 0.4f * static_cast<float>(layer + 1) / static_cast<float>(m_Kernels.size()));
  }

  const auto finishRow = [this, width, thickness, pixels](SizeValueType row) {
    float * const values = thickness + row * width;
    const auto    attenuation = static_cast<float>(m_Attenuation);
    const auto    intensity = static_cast<float>(m_SourceIntensity);
    if (m_OutputMode == OutputEnum::Thickness)
    {
      // A fitted filter may undershoot zero.
      for (SizeValueType i = 0; i < width; ++i)
      {
        values[i] = std::max(0.0f, values[i]);
      }
    }
    else
    {
      for (SizeValueType i = 0; i < width; ++i)
      {
        values[i] = -attenuation * std::max(0.0f, values[i]);
      }
      SurfaceSplatExp(values, width);
      const bool inverted = m_OutputMode == OutputEnum::InvertedIntensity;
      for (SizeValueType i = 0; i < width; ++i)
      {
        values[i] = intensity * (inverted ? 1.0f - values[i] : values[i]);
      }
    }
    if constexpr (!std::is_same<PixelType, float>::value)
    {
      PixelType * const out = pixels + row * width;
      for (SizeValueType i = 0; i < width; ++i)
      {
        if constexpr (std::is_integral<PixelType>::value)
        {
          const double low = static_cast<double>(NumericTraits<PixelType>::NonpositiveMin());
          const double high = static_cast<double>(NumericTraits<PixelType>::max());
          out[i] = static_cast<PixelType>(std::clamp(std::floor(static_cast<double>(values[i]) + 0.5), low, high));
        }
        else
        {
          out[i] = static_cast<PixelType>(values[i]);
        }
      }
    }
  };
  forEachRow(finishRow);
  this->UpdateProgress(1.0f);
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::SetSizeToCoverMeshes(double margin)
{
  if (!(margin >= 0.0) || !std::isfinite(margin))
  {
    itkExceptionMacro("The margin is " << margin << " mm; give one that is not negative.");
  }
  this->SetUseReferenceImage(false);
  this->SetCoverMeshes(true);
  this->SetCoverMargin(margin);
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::SetSize(SizeType size)
{
  Superclass::SetSize(size);
  if (!m_SizeIsSet)
  {
    // It may be the superclass's default, which is no size of anybody's.
    m_SizeIsSet = true;
    this->Modified();
  }
  this->SetCoverMeshes(false);
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::SetSize(SizeValueType size[])
{
  this->SetSize(SizeType{ { size[0], size[1] } });
}

template <typename TInputMesh, typename TOutputImage>
auto
SurfaceDRRImageSource<TInputMesh, TOutputImage>::ComputeCoveringRegion() -> RegionType
{
  this->FlattenMeshes();
  const SurfaceSplatProjector projector = this->MakeProjector();
  double                      low[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::max() };
  double                      high[2] = { -low[0], -low[1] };
  double                      widest = 0.0;
  for (unsigned int number = 0; number < m_Surfaces.size(); ++number)
  {
    SurfaceSplatLayer layer;
    this->Project(number, projector, layer);
    const std::vector<double> * coordinates[2] = { &layer.u, &layer.v };
    for (unsigned int d = 0; d < 2; ++d)
    {
      const auto range = std::minmax_element(coordinates[d]->begin(), coordinates[d]->end());
      low[d] = std::min(low[d], *range.first);
      high[d] = std::max(high[d], *range.second);
    }
    const auto & sigmas = this->GetVertexSigmas(number);
    widest =
      std::max(widest, sigmas.empty() ? this->GetMeshSigma(number) : *std::max_element(sigmas.begin(), sigmas.end()));
  }
  const double margin = m_CoverMargin < 0.0 ? 4.0 * widest : m_CoverMargin;
  IndexType    start;
  SizeType     size;
  double       pixels = 1.0;
  for (unsigned int d = 0; d < 2; ++d)
  {
    const double width = margin / this->GetOutput()->GetSpacing()[d];
    const double first = std::floor(low[d] - width);
    const double last = std::ceil(high[d] + width);
    pixels *= last - first + 1.0;
    if (!(pixels <= 4294967296.0) || !(std::abs(first) < 1e9))
    {
      itkExceptionMacro("The projected meshes extend from pixel "
                        << low[d] << " to " << high[d] << " along axis " << d
                        << ": too large an image. Check the mesh's unit (mm), the geometry and SetCoverMargin().");
    }
    start[d] = static_cast<IndexValueType>(first);
    size[d] = static_cast<SizeValueType>(last - first) + 1;
  }
  return RegionType(start, size);
}

template <typename TInputMesh, typename TOutputImage>
void
SurfaceDRRImageSource<TInputMesh, TOutputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMeshes: " << this->GetNumberOfMeshes() << std::endl;
  os << indent << "Sigma: " << m_Sigma << std::endl;
  for (unsigned int number = 0; number < m_Widths.size(); ++number)
  {
    os << indent << "Width of mesh " << number << ": " << this->GetMeshSigma(number) << ", "
       << m_Widths[number].vertexSigmas.size() << " vertex sigmas" << std::endl;
  }
  os << indent << "Normalization: " << m_Normalization << std::endl;
  os << indent << "OutputMode: " << m_OutputMode << std::endl;
  os << indent << "Density: " << m_Density << std::endl;
  os << indent << "SourceIntensity: " << m_SourceIntensity << std::endl;
  os << indent << "Attenuation: " << m_Attenuation << std::endl;
  os << indent << "Tolerance: " << m_Tolerance << std::endl;
  os << indent << "UseGeometrySpacing: " << m_UseGeometrySpacing << std::endl;
  os << indent << "CoverMeshes: " << m_CoverMeshes << std::endl;
  os << indent << "CoverMargin: " << m_CoverMargin << std::endl;
  for (std::size_t number = 0; number < m_Kernels.size(); ++number)
  {
    os << indent << "Splat method of mesh " << number << ": " << m_Kernels[number].GetMethod() << std::endl;
  }
  os << indent << "KernelTime: " << m_KernelTime << std::endl;
  os << indent << "KernelRegion: " << m_KernelRegion << std::endl;
  os << indent << "KernelSpacing: " << m_KernelSpacing << std::endl;
  os << indent << "KernelOrigin: " << m_KernelOrigin << std::endl;
  os << indent << "NumberOfFlattenings: " << m_NumberOfFlattenings << std::endl;
  os << indent << "NumberOfProjections: " << m_NumberOfProjections << std::endl;
}
} // namespace itk

#endif
