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
#include "itkSurfaceSplatKernel.h"

#include "itkSurfaceSplatChunks.h"
#include "itkSurfaceSplatFilterDesign.h"
#include "itkSurfaceSplatRegions.h"

#include "itkParallelFor.h"
#include "itkVectorClones.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace itk
{
namespace
{
using namespace SurfaceSplatDetail;

/** Of an image's width and height: indices are of 32 bits within. */
constexpr std::int64_t LargestSize = 1 << 28;
/** Below this width (pixels) the table would need too many sub-pixel rows. */
constexpr double SmallestTableSigma = 0.05;

/** Smallest and largest value, in lanes that do not wait for each other. \return whether all are finite. */
itkVectorClones bool
FiniteRange(const double * values, std::size_t count, double range[2])
{
  constexpr int lanes = 8;
  double        low[lanes];
  double        high[lanes];
  std::fill_n(low, lanes, LargestPosition);
  std::fill_n(high, lanes, -LargestPosition);
  // A difference is not a number where either is none or infinite, and stays so in the sum.
  double      sum[lanes] = {};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
  {
    for (int k = 0; k < lanes; ++k)
    {
      const double x = values[i + static_cast<std::size_t>(k)];
      low[k] = x < low[k] ? x : low[k];
      high[k] = x > high[k] ? x : high[k];
      sum[k] += x - x;
    }
  }
  for (; i < count; ++i)
  {
    low[0] = values[i] < low[0] ? values[i] : low[0];
    high[0] = values[i] > high[0] ? values[i] : high[0];
    sum[0] += values[i] - values[i];
  }
  for (int k = 1; k < lanes; ++k)
  {
    low[0] = std::min(low[0], low[k]);
    high[0] = std::max(high[0], high[k]);
    sum[0] += sum[k];
  }
  range[0] = low[0];
  range[1] = high[0];
  return sum[0] == 0.0;
}
} // namespace

std::ostream &
operator<<(std::ostream & os, SurfaceSplatKernel::MethodEnum method)
{
  static const char * const names[] = { "Automatic", "Table", "CubicSpline", "QuinticSpline", "PerSplat" };
  return os << names[static_cast<unsigned int>(method)];
}

SurfaceSplatKernel::SurfaceSplatKernel(const SurfaceSplatLayer &  layer,
                                       const SurfaceSplatRegion & image,
                                       double                     tolerance,
                                       MethodEnum                 method)
{
  this->Prepare(layer, image, tolerance, method);
}

void
SurfaceSplatKernel::Prepare(const SurfaceSplatLayer &  layer,
                            const SurfaceSplatRegion & image,
                            double                     tolerance,
                            MethodEnum                 method,
                            unsigned int               threads)
{
  threads = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  m_Image = image;
  m_Tolerance = tolerance;
  m_NumberOfSplats = 0;
  m_SplatBounds = {};
  m_FilterU.clear();
  m_FilterV.clear();
  m_TableU = {};
  m_TableV = {};
  const auto fail = [](const char * what, double value, const char * remedy) {
    std::ostringstream message;
    message << what << value << remedy;
    throw std::invalid_argument(message.str());
  };
  if (!(tolerance >= 1e-6 && tolerance <= 0.1))
  {
    fail("The tolerance is ", tolerance, "; give a value in [1e-6, 0.1].");
  }
  const std::size_t count = layer.u.size();
  const bool        perSplat = !layer.sigmaUs.empty() || !layer.sigmaVs.empty();
  if (layer.v.size() != count || layer.weight.size() != count ||
      (perSplat && (layer.sigmaUs.size() != count || layer.sigmaVs.size() != count)))
  {
    fail("The arrays of a splat layer differ in length: u has ", static_cast<double>(count), " values.");
  }
  const auto checkSigma = [&fail](double sigma) {
    if (!(sigma > 0.0 && sigma <= LargestSigma))
    {
      fail("A splat is ", sigma, " pixels wide (sigma); give a width above 0 and up to 1000 pixels.");
    }
  };
  if (perSplat)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      checkSigma(layer.sigmaUs[i]);
      checkSigma(layer.sigmaVs[i]);
    }
  }
  else
  {
    checkSigma(layer.sigmaU);
    checkSigma(layer.sigmaV);
  }
  for (const std::int64_t size : { image.sizeU, image.sizeV })
  {
    if (!(size >= 0 && size <= LargestSize))
    {
      fail("The image is ", static_cast<double>(size), " pixels wide or high; give 0 to 2^28.");
    }
  }
  struct CheckType
  {
    double rangeU[2];
    double rangeV[2];
    bool   finite;
  };
  std::vector<CheckType> checks(NumberOfChunks(count, threads));
  ParallelFor(checks.size(), threads, [&](std::size_t number) {
    CheckType &       check = checks[number];
    const std::size_t begin = count * number / checks.size();
    const std::size_t size = count * (number + 1) / checks.size() - begin;
    check.finite = FiniteRange(layer.u.data() + begin, size, check.rangeU);
    check.finite &= FiniteRange(layer.v.data() + begin, size, check.rangeV);
    for (std::size_t i = begin; i < begin + size; ++i)
    {
      check.finite &= std::abs(layer.weight[i]) <= std::numeric_limits<float>::max();
    }
  });
  double rangeU[2] = { checks[0].rangeU[0], checks[0].rangeU[1] };
  double rangeV[2] = { checks[0].rangeV[0], checks[0].rangeV[1] };
  bool   finite = true;
  for (const CheckType & check : checks)
  {
    finite &= check.finite;
    rangeU[0] = std::min(rangeU[0], check.rangeU[0]);
    rangeU[1] = std::max(rangeU[1], check.rangeU[1]);
    rangeV[0] = std::min(rangeV[0], check.rangeV[0]);
    rangeV[1] = std::max(rangeV[1], check.rangeV[1]);
  }
  for (std::size_t i = 0; !finite && i < count; ++i)
  {
    if (!std::isfinite(layer.u[i]) || !std::isfinite(layer.v[i]) || !std::isfinite(layer.weight[i]))
    {
      fail("A splat is not finite: number ", static_cast<double>(i), ".");
    }
  }

  // The largest value that is cut off is half the tolerance.
  m_Cut = std::sqrt(2.0 * std::log(2.0 / tolerance));
  const bool narrow = !perSplat && std::min(layer.sigmaU, layer.sigmaV) < SmallestTableSigma;
  if (perSplat || (narrow && !IsSpline(method)))
  {
    m_Method = MethodEnum::PerSplat;
    m_SplatError = 0.5 * tolerance;
    this->SortIntoBands(layer, threads);
    return;
  }

  double     cubicError = 0.0;
  double     quinticError = 0.0;
  double     tableError = 0.0;
  const auto fit = [&](auto degree, double & error) {
    constexpr int d = decltype(degree)::value;
    const double  u = FitFilter<d>(layer.sigmaU, m_Cut, m_FilterU);
    const double  v = layer.sigmaV == layer.sigmaU ? u : FitFilter<d>(layer.sigmaV, m_Cut, m_FilterV);
    if (layer.sigmaV == layer.sigmaU)
    {
      m_FilterV = m_FilterU;
    }
    error = u + v + u * v;
  };
  using Cubic = std::integral_constant<int, 3>;
  using Quintic = std::integral_constant<int, 5>;

  m_Method = method;
  if (method == MethodEnum::Automatic)
  {
    // Costs in nanoseconds, measured; only their order matters. The area is the layer's, not a region's, so that every
    // region chooses alike.
    const double rU = m_Cut * layer.sigmaU;
    const double rV = m_Cut * layer.sigmaV;
    const double width =
      std::min<double>(rangeU[1] + rU, image.startU + image.sizeU) - std::max<double>(rangeU[0] - rU, image.startU);
    const double height =
      std::min<double>(rangeV[1] + rV, image.startV + image.sizeV) - std::max<double>(rangeV[0] - rV, image.startV);
    const double area = std::max(0.0, width) * std::max(0.0, height);
    const double n = static_cast<double>(count);
    const double tableCost = n * (10.0 + 0.35 * 4.0 * std::ceil(rU) * std::ceil(rV));
    const double filterCost = area * (1.0 + 0.2 * (rU + rV));
    // The errors of neighbouring splats may add up: three quarters of the tolerance for one.
    m_Method = MethodEnum::Table;
    if (n * 12.0 + filterCost < tableCost)
    {
      fit(Cubic{}, cubicError);
      if (cubicError <= 0.75 * tolerance)
      {
        m_Method = MethodEnum::CubicSpline;
        m_SplatError = cubicError;
      }
      else if (n * 22.0 + filterCost < tableCost)
      {
        fit(Quintic{}, quinticError);
        if (quinticError <= 0.75 * tolerance)
        {
          m_Method = MethodEnum::QuinticSpline;
          m_SplatError = quinticError;
        }
      }
    }
  }
  else if (method == MethodEnum::CubicSpline)
  {
    fit(Cubic{}, m_SplatError);
  }
  else if (method == MethodEnum::QuinticSpline)
  {
    fit(Quintic{}, m_SplatError);
  }
  else
  {
    m_Method = MethodEnum::Table;
  }
  if (m_Method == MethodEnum::Table)
  {
    m_FilterU.clear();
    m_FilterV.clear();
    m_TableU = MakeTable(layer.sigmaU, tolerance, tableError);
    m_SplatError = tableError;
    m_TableV = MakeTable(layer.sigmaV, tolerance, tableError);
    m_SplatError += tableError;
  }
  this->SortIntoBands(layer, threads);
}

auto
SurfaceSplatKernel::MakeTable(double sigma, double tolerance, double & error) -> TableType
{
  TableType    table;
  const double cut = std::sqrt(2.0 * std::log(2.0 / tolerance));
  const int    half = std::max(1, static_cast<int>(std::ceil(cut * sigma)));
  table.taps = 2 * half;
  table.stride = (table.taps + 3) / 4 * 4;
  // Linear interpolation between sub-pixel rows errs by (step / sigma)^2 / 8.
  table.rows = std::max(64, static_cast<int>(std::ceil(1.0 / (sigma * std::sqrt(0.5 * tolerance)))));
  table.values.assign(static_cast<std::size_t>(table.rows + 1) * table.stride, 0.0f);
  for (int row = 0; row <= table.rows; ++row)
  {
    const double f = static_cast<double>(row) / table.rows;
    for (int tap = 0; tap < table.taps; ++tap)
    {
      const double d = (tap - half + 1 - f) / sigma;
      table.values[static_cast<std::size_t>(row) * table.stride + tap] = static_cast<float>(std::exp(-0.5 * d * d));
    }
  }
  const double step = 1.0 / (table.rows * sigma);
  error = std::max(step * step / 8.0, std::exp(-0.5 * (half / sigma) * (half / sigma)));
  return table;
}

void
SurfaceSplatKernel::Render(const SurfaceSplatRegion & region,
                           float *                    buffer,
                           std::size_t                stride,
                           unsigned int               threads) const
{
  Rendering rendering(*this, region, buffer, stride);
  for (std::size_t phase = 0; phase < rendering.GetNumberOfPhases(); ++phase)
  {
    ParallelFor(rendering.GetNumberOfJobs(phase), threads, [&](std::size_t job) { rendering.Run(phase, job); });
  }
}

} // namespace itk
