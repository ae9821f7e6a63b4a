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
#ifndef itkSurfaceSplatKernel_h
#define itkSurfaceSplatKernel_h

#include "SurfaceDRRExport.h"
#include "itkPerspectiveProjection.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <ostream>
#include <vector>

namespace itk
{
/** \struct SurfaceSplatLayer
 * \brief The Gaussian splats of one surface, as the kernel takes them. Free of ITK headers.
 *
 * Splat i adds weight_i exp(-(du / sigma_u)^2 / 2 - (dv / sigma_v)^2 / 2) to the pixel at (u_i + du, v_i + dv).
 * Positions are continuous indices of the image and widths are in pixels.
 *
 * \ingroup SurfaceDRR
 */
struct SurfaceSplatLayer
{
  std::vector<double> u; /**< First continuous index of each splat's centre. */
  std::vector<double> v; /**< Second continuous index, as many. */
  /** Value at the splat's centre. */
  std::vector<float> weight;
  /** Width of every splat, unless there is one a splat below. */
  double sigmaU{ 1.0 };
  double sigmaV{ 1.0 };
  /** Widths one a splat; both empty or both as long as u. */
  std::vector<float> sigmaUs;
  std::vector<float> sigmaVs;
};

/** A rectangle of pixels: first index and size. */
struct SurfaceSplatRegion
{
  std::int64_t startU{ 0 }; /**< First column. */
  std::int64_t startV{ 0 }; /**< First row. */
  std::int64_t sizeU{ 0 };  /**< Number of columns. */
  std::int64_t sizeV{ 0 };  /**< Number of rows. */
};

/** \struct SurfaceSplatProjector
 * \brief Turns surface points with areas into splats.
 *
 * \ingroup SurfaceDRR
 */
struct SurfaceDRR_EXPORT SurfaceSplatProjector
{
  PerspectiveProjection projection; /**< From the points' frame to pixels. */
  /** mm. */
  double sourceToMidsagittal{ 0.0 };
  double sourceToDetector{ 0.0 };
  /** Of the detector, for the ray's angle. */
  double principalPoint[2]{ 0.0, 0.0 };
  double pixelSpacing[2]{ 0.0, 0.0 };
  /** Image index = scale * pixel + offset. */
  double scale[2]{ 1.0, 1.0 };
  double offset[2]{ 0.0, 0.0 };
  /** Weight by m^2 / cos(alpha): m the point's magnification, alpha the ray's angle to the detector's normal. */
  bool physical{ false };

  /** Projects points [first, last) with factor * area into the layer's slots of the same number.
   * \return the first point that is not finite or not in front of the source, or last. */
  std::size_t
  Project(const double (*points)[3],
          const double *      areas,
          std::size_t         first,
          std::size_t         last,
          double              factor,
          SurfaceSplatLayer & layer) const;
};

/** \class SurfaceSplatKernel
 * \brief Adds a layer of splats to a float image, within a tolerance and with the same bits for every way to cut the
 * work.
 *
 * Made once for a layer and the whole image; renders any region of it. Splats are sorted into bands of rows of the
 * image, never of the region, and a pixel takes its splats in an order that their numbers and positions give: value and
 * bits of a pixel do not depend on the region asked for or on the threads.
 *
 * Methods, chosen by the tolerance (relative to the maximum on the detector plane) and a cost model:
 *  - Table: outer product of two sampled Gaussians, interpolated between sub-pixel positions. Any width.
 *  - CubicSpline, QuinticSpline: weights are binned with B-splines, then filtered with a symmetric FIR fitted so that
 *    spline * FIR is the Gaussian. For wide splats; the error of the fit is computed for the width at hand.
 *  - PerSplat: taps of each splat's own width. Used where widths are given one a splat.
 *
 * Free of ITK headers.
 *
 * \ingroup SurfaceDRR
 */
class SurfaceDRR_EXPORT SurfaceSplatKernel
{
public:
  enum class MethodEnum : std::uint8_t
  {
    Automatic,
    Table,
    CubicSpline,
    QuinticSpline,
    PerSplat
  };

  SurfaceSplatKernel() = default;

  /** Throws std::invalid_argument where the tolerance is not in [1e-6, 0.1], a width is not positive and finite, a
   * position or weight is not finite, or the arrays differ in length.
   * \param layer  the splats; copied where they reach the image
   * \param image  the whole image
   * \param tolerance  largest error relative to the maximum on the detector plane
   * \param method  Automatic, but for tests and benchmarks; a spline that misses the tolerance is then used all the
   *                same */
  SurfaceSplatKernel(const SurfaceSplatLayer &  layer,
                     const SurfaceSplatRegion & image,
                     double                     tolerance,
                     MethodEnum                 method = MethodEnum::Automatic);

  /** What the constructor does, in the memory of the layer before: for the next pose.
   * \param threads 0: all of the machine's */
  void
  Prepare(const SurfaceSplatLayer &  layer,
          const SurfaceSplatRegion & image,
          double                     tolerance,
          MethodEnum                 method = MethodEnum::Automatic,
          unsigned int               threads = 1);
  /** What the tolerance and the cost model chose. */
  MethodEnum
  GetMethod() const
  {
    return m_Method;
  }

  /** Largest error of a single splat relative to its peak, as computed for the method and widths. */
  double
  GetSplatError() const
  {
    return m_SplatError;
  }

  /** Splats that reach the image. */
  std::size_t
  GetNumberOfSplats() const
  {
    return m_NumberOfSplats;
  }

  /** Adds the layer to a region of the image.
   * \param buffer  the region's first pixel; row-major
   * \param stride  pixels from one row to the next
   * \param threads 0: all of the machine's */
  void
  Render(const SurfaceSplatRegion & region, float * buffer, std::size_t stride, unsigned int threads = 1) const;

  /** The same cut into phases of independent jobs, for a caller with threads of its own: the jobs of a phase may run
   * at the same time, the phases one after the other. */
  class SurfaceDRR_EXPORT Rendering
  {
  public:
    Rendering(const SurfaceSplatKernel & kernel, const SurfaceSplatRegion & region, float * buffer, std::size_t stride);
    ~Rendering();
    /** Phases follow each other; the jobs of one may run at once. Run() does one job. */
    std::size_t
    GetNumberOfPhases() const
    {
      return m_Jobs.size();
    }
    std::size_t
    GetNumberOfJobs(std::size_t phase) const
    {
      return m_Jobs[phase];
    }
    void
    Run(std::size_t phase, std::size_t job);

  private:
    struct ScratchType;

    void
    SplatWideTable(std::size_t band);
    void
    SplatEach(std::size_t band);
    void
    SplatAligned(std::size_t band);
    void
    FilterColumns(std::size_t job);
    ScratchType
    TakeScratch();
    void
    ReturnScratch(ScratchType && scratch);

    const SurfaceSplatKernel & m_Kernel;
    SurfaceSplatRegion         m_Region;
    float *                    m_Buffer;
    std::size_t                m_Stride;
    std::vector<std::size_t>   m_Jobs;
    std::size_t                m_FirstBand{ 0 };
    std::vector<std::size_t>   m_BandsByWork;
    /** Pixels that are reached, and the splines' nodes: wider by the filter's radius. */
    SurfaceSplatRegion m_Reached;
    SurfaceSplatRegion m_Nodes;
    /** Rows of nodes that hold weight, filtered along u; as wide as m_Reached. */
    SurfaceSplatRegion m_NodeRows;
    std::vector<float> m_NodeValues;
    /** Clean scratch memory for jobs to come. */
    std::vector<ScratchType> m_Scratch;
    std::mutex               m_ScratchMutex;
  };

private:
  /** Sampled Gaussians, a row for each sub-pixel position; rows are padded with zeros to a multiple of four. */
  struct TableType
  {
    int                taps{ 0 };
    int                stride{ 0 };
    int                rows{ 0 };
    std::vector<float> values;
  };
  /** Splats [begin, end) that reach the same bands. */
  struct RunType
  {
    std::size_t begin;
    std::size_t end;
  };
  static TableType
  MakeTable(double sigma, double tolerance, double & error);

  template <typename TFunction>
  void
  ForEachSplat(std::size_t band, TFunction && visit) const;
  void
  SortIntoBands(const SurfaceSplatLayer & layer, unsigned int threads);

  SurfaceSplatRegion m_Image;
  double             m_Tolerance{ 1e-3 };
  MethodEnum         m_Method{ MethodEnum::Table };
  double             m_SplatError{ 0.0 };
  std::size_t        m_NumberOfSplats{ 0 };
  /** Half-width in standard deviations. */
  double    m_Cut{ 0.0 };
  TableType m_TableU;
  TableType m_TableV;
  /** h[0..R] of the symmetric filters. */
  std::vector<float> m_FilterU;
  std::vector<float> m_FilterV;
  /** Nodes that hold weight: first and one past the last. */
  SurfaceSplatRegion m_SplatBounds;

  /** The image, or its nodes: wider by the filter's radius. */
  SurfaceSplatRegion m_Domain;
  /** Floors of the positions, from the domain's first node, and the rest. */
  std::vector<std::int32_t> m_WholeU;
  std::vector<std::int32_t> m_WholeV;
  std::vector<float>        m_FractionU;
  std::vector<float>        m_FractionV;
  std::vector<float>        m_Weight;
  std::vector<float>        m_SigmaU;
  std::vector<float>        m_SigmaV;
  /** Runs of splats by band of the domain's rows; one that reaches two bands is in both. */
  std::vector<std::size_t> m_BandBegin;
  std::vector<RunType>     m_Runs;
};

SurfaceDRR_EXPORT std::ostream &
                  operator<<(std::ostream & os, SurfaceSplatKernel::MethodEnum method);

/** exp(x) for x <= 0 with a relative error below 4e-6, the same bits everywhere; writes in place. For Beer-Lambert over
 * an image. */
SurfaceDRR_EXPORT void
SurfaceSplatExp(float * values, std::size_t count);

/** The definition, in double and without shortcuts: adds the layer to a region, cut at 8 sigma. The oracle of tests and
 * the yardstick of benchmarks. */
SurfaceDRR_EXPORT void
SurfaceSplatReference(const SurfaceSplatLayer &  layer,
                      const SurfaceSplatRegion & region,
                      double *                   buffer,
                      std::size_t                stride);
} // namespace itk

#endif
