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

#include "itkParallelFor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <type_traits>

namespace itk
{
namespace
{
constexpr std::int64_t BandHeight = 32;
constexpr double       LargestSigma = 1000.0;
/** Below this width (pixels) the table would need too many sub-pixel rows. */
constexpr double SmallestTableSigma = 0.05;

/** exp(x) for x <= 0: 2^n by the exponent bits, 2^f by a polynomial; no branch, so that loops over it vectorise. */
inline float
NegativeExp(float x)
{
  float t = x * 1.44269504f;
  t = t < -126.0f ? -126.0f : t;
  // Rounds to the nearest integer without SSE4.1.
  const float r = (t + 12582912.0f) - 12582912.0f;
  const float f = (t - r) * 0.69314718f;
  float       p = 1.0f / 720.0f;
  p = p * f + 1.0f / 120.0f;
  p = p * f + 1.0f / 24.0f;
  p = p * f + 1.0f / 6.0f;
  p = p * f + 0.5f;
  p = p * f + 1.0f;
  p = p * f + 1.0f;
  const std::int32_t bits = (static_cast<std::int32_t>(r) + 127) * (1 << 23);
  float              power;
  std::memcpy(&power, &bits, sizeof(power));
  return p * power;
}

/** Floor of a value that fits; std::floor is a library call without SSE4.1. */
inline std::int64_t
FloorToInteger(double x)
{
  const auto i = static_cast<std::int64_t>(x);
  return i - (x < static_cast<double>(i) ? 1 : 0);
}

/** The B-spline's values at the nodes floor(x) - (degree - 1) / 2, ... for the fraction f of x. */
template <int VDegree, typename TReal>
inline void
SplineWeights(TReal f, TReal * w)
{
  if constexpr (VDegree == 3)
  {
    const TReal g = TReal(1) - f;
    w[0] = g * g * g * TReal(1.0 / 6.0);
    w[1] = TReal(2.0 / 3.0) - f * f * (TReal(1) - TReal(0.5) * f);
    w[2] = TReal(2.0 / 3.0) - g * g * (TReal(1) - TReal(0.5) * g);
    w[3] = f * f * f * TReal(1.0 / 6.0);
  }
  else
  {
    // Unser, Aldroubi, Eden 1993, in Thevenaz's form.
    TReal f2 = f * f;
    w[5] = TReal(1.0 / 120.0) * f * f2 * f2;
    f2 -= f;
    const TReal f4 = f2 * f2;
    const TReal c = f - TReal(0.5);
    const TReal t = f2 * (f2 - TReal(3));
    w[0] = TReal(1.0 / 24.0) * (TReal(0.2) + f2 + f4) - w[5];
    TReal even = TReal(1.0 / 24.0) * (f2 * (f2 - TReal(5)) + TReal(9.2));
    TReal odd = TReal(-1.0 / 12.0) * c * (t + TReal(4));
    w[2] = even + odd;
    w[3] = even - odd;
    even = TReal(1.0 / 16.0) * (TReal(1.8) - t);
    odd = TReal(1.0 / 24.0) * c * (f4 - f2 - TReal(5));
    w[1] = even + odd;
    w[4] = even - odd;
  }
}

/** Least-squares fit of a symmetric filter h[0..R] such that the spline filtered by h is the Gaussian of this width, at
 * all sub-pixel positions alike. \return the largest error, relative to the peak. */
template <int VDegree>
double
FitFilter(double sigma, double cut, std::vector<float> & filter)
{
  constexpr int before = (VDegree - 1) / 2;
  const int     radius = std::max(1, static_cast<int>(std::ceil(cut * sigma)));
  const int     count = radius + 1;
  const int     reach = radius + VDegree;
  constexpr int positions = 16;
  // The normal equations are banded: a sample sees the neighbouring nodes only.
  constexpr int                          width = VDegree + 1;
  std::vector<std::array<double, width>> lower(count); // lower[r][d] = N(r, r - d)
  std::vector<double>                    right(count, 0.0);
  const auto gauss = [sigma](double d) { return std::exp(-0.5 * (d / sigma) * (d / sigma)); };
  for (auto & row : lower)
  {
    row.fill(0.0);
  }
  for (int s = 0; s < positions; ++s)
  {
    const double f = (s + 0.5) / positions;
    double       w[VDegree + 1];
    SplineWeights<VDegree>(f, w);
    for (int i = -reach; i <= reach; ++i)
    {
      int    ks[VDegree + 1];
      double as[VDegree + 1];
      int    used = 0;
      for (int n = 0; n <= VDegree; ++n)
      {
        const int k = std::abs(i - (n - before));
        if (k > radius)
        {
          continue;
        }
        const int at = static_cast<int>(std::find(ks, ks + used, k) - ks);
        if (at == used)
        {
          ks[used] = k;
          as[used++] = 0.0;
        }
        as[at] += w[n];
      }
      const double target = gauss(i - f);
      for (int a = 0; a < used; ++a)
      {
        right[ks[a]] += as[a] * target;
        for (int b = 0; b < used; ++b)
        {
          if (ks[b] <= ks[a])
          {
            lower[ks[a]][ks[a] - ks[b]] += as[a] * as[b];
          }
        }
      }
    }
  }
  // Cholesky in place, then both substitutions.
  for (int r = 0; r < count; ++r)
  {
    lower[r][0] *= 1.0 + 1e-12;
    for (int d = std::min(r, width - 1); d >= 0; --d)
    {
      const int c = r - d;
      double    sum = lower[r][d];
      for (int k = std::max(0, r - width + 1); k < c; ++k)
      {
        if (c - k < width)
        {
          sum -= lower[r][r - k] * lower[c][c - k];
        }
      }
      lower[r][d] = d == 0 ? std::sqrt(std::max(sum, 1e-300)) : sum / lower[c][0];
    }
  }
  for (int r = 0; r < count; ++r)
  {
    for (int d = 1; d <= std::min(r, width - 1); ++d)
    {
      right[r] -= lower[r][d] * right[r - d];
    }
    right[r] /= lower[r][0];
  }
  for (int r = count - 1; r >= 0; --r)
  {
    for (int d = 1; d < width && r + d < count; ++d)
    {
      right[r] -= lower[r + d][d] * right[r + d];
    }
    right[r] /= lower[r][0];
  }
  filter.assign(right.begin(), right.end());
  double error = 0.0;
  for (int s = 0; s <= 2 * positions; ++s)
  {
    const double f = 0.5 * s / positions;
    double       w[VDegree + 1];
    SplineWeights<VDegree>(f, w);
    for (int i = -reach - 2; i <= reach + 2; ++i)
    {
      double value = 0.0;
      for (int n = 0; n <= VDegree; ++n)
      {
        const int k = std::abs(i - (n - before));
        value += k <= radius ? w[n] * filter[k] : 0.0;
      }
      error = std::max(error, std::abs(value - gauss(i - f)));
    }
  }
  return error;
}

SurfaceSplatRegion
Intersect(const SurfaceSplatRegion & a, const SurfaceSplatRegion & b)
{
  SurfaceSplatRegion result;
  result.startU = std::max(a.startU, b.startU);
  result.startV = std::max(a.startV, b.startV);
  result.sizeU = std::max<std::int64_t>(0, std::min(a.startU + a.sizeU, b.startU + b.sizeU) - result.startU);
  result.sizeV = std::max<std::int64_t>(0, std::min(a.startV + a.sizeV, b.startV + b.sizeV) - result.startV);
  if (result.sizeU == 0 || result.sizeV == 0)
  {
    result.sizeU = 0;
    result.sizeV = 0;
  }
  return result;
}

SurfaceSplatRegion
Dilate(SurfaceSplatRegion region, std::int64_t radiusU, std::int64_t radiusV)
{
  if (region.sizeU > 0 && region.sizeV > 0)
  {
    region.startU -= radiusU;
    region.startV -= radiusV;
    region.sizeU += 2 * radiusU;
    region.sizeV += 2 * radiusV;
  }
  return region;
}

inline void
AddScaledRow(float * row, const float * taps, float scale, int count)
{
  for (int i = 0; i < count; ++i)
  {
    row[i] += scale * taps[i];
  }
}

bool
IsSpline(SurfaceSplatKernel::MethodEnum method)
{
  return method == SurfaceSplatKernel::MethodEnum::CubicSpline ||
         method == SurfaceSplatKernel::MethodEnum::QuinticSpline;
}
} // namespace

std::ostream &
operator<<(std::ostream & os, SurfaceSplatKernel::MethodEnum method)
{
  static const char * const names[] = { "Automatic", "Table", "CubicSpline", "QuinticSpline", "PerSplat" };
  return os << names[static_cast<unsigned int>(method)];
}

std::size_t
SurfaceSplatProjector::Project(const double (*points)[3],
                               const double *      areas,
                               std::size_t         first,
                               std::size_t         last,
                               double              factor,
                               SurfaceSplatLayer & layer) const
{
  const double magnificationAtUnitDepth = sourceToDetector / sourceToMidsagittal;
  for (std::size_t i = first; i < last; ++i)
  {
    double       u;
    double       v;
    const double depth = projection.Project(points[i], u, v);
    if (!(depth > 0.0) || !std::isfinite(u) || !std::isfinite(v))
    {
      return i;
    }
    double weight = factor * areas[i];
    if (physical)
    {
      const double m = magnificationAtUnitDepth / depth;
      const double x = (u - principalPoint[0]) * pixelSpacing[0] / sourceToDetector;
      const double y = (v - principalPoint[1]) * pixelSpacing[1] / sourceToDetector;
      weight *= m * m * std::sqrt(1.0 + x * x + y * y);
    }
    layer.u[i] = scale[0] * u + offset[0];
    layer.v[i] = scale[1] * v + offset[1];
    layer.weight[i] = static_cast<float>(weight);
  }
  return last;
}

SurfaceSplatKernel::SurfaceSplatKernel(const SurfaceSplatLayer &  layer,
                                       const SurfaceSplatRegion & image,
                                       double                     tolerance,
                                       MethodEnum                 method)
  : m_Image(image)
  , m_Tolerance(tolerance)
{
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
  for (std::size_t i = 0; i < count; ++i)
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
    this->SortIntoBands(layer);
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
    double low[2] = { 1e300, 1e300 };
    double high[2] = { -1e300, -1e300 };
    for (std::size_t i = 0; i < count; ++i)
    {
      low[0] = std::min(low[0], layer.u[i]);
      low[1] = std::min(low[1], layer.v[i]);
      high[0] = std::max(high[0], layer.u[i]);
      high[1] = std::max(high[1], layer.v[i]);
    }
    const double rU = m_Cut * layer.sigmaU;
    const double rV = m_Cut * layer.sigmaV;
    const double width =
      std::min<double>(high[0] + rU, image.startU + image.sizeU) - std::max<double>(low[0] - rU, image.startU);
    const double height =
      std::min<double>(high[1] + rV, image.startV + image.sizeV) - std::max<double>(low[1] - rV, image.startV);
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
  this->SortIntoBands(layer);
}

auto
SurfaceSplatKernel::MakeTable(double sigma, double tolerance, double & error) -> TableType
{
  TableType    table;
  const double cut = std::sqrt(2.0 * std::log(2.0 / tolerance));
  const int    half = std::max(1, static_cast<int>(std::ceil(cut * sigma)));
  table.taps = 2 * half;
  // Linear interpolation between sub-pixel rows errs by (step / sigma)^2 / 8.
  table.rows = std::max(64, static_cast<int>(std::ceil(1.0 / (sigma * std::sqrt(0.5 * tolerance)))));
  table.values.resize(static_cast<std::size_t>(table.rows + 1) * table.taps);
  for (int row = 0; row <= table.rows; ++row)
  {
    const double f = static_cast<double>(row) / table.rows;
    for (int tap = 0; tap < table.taps; ++tap)
    {
      const double d = (tap - half + 1 - f) / sigma;
      table.values[static_cast<std::size_t>(row) * table.taps + tap] = static_cast<float>(std::exp(-0.5 * d * d));
    }
  }
  const double step = 1.0 / (table.rows * sigma);
  error = std::max(step * step / 8.0, std::exp(-0.5 * (half / sigma) * (half / sigma)));
  return table;
}

void
SurfaceSplatKernel::SortIntoBands(const SurfaceSplatLayer & layer)
{
  const std::size_t count = layer.u.size();
  const bool        perSplat = m_Method == MethodEnum::PerSplat;
  const bool        narrow = perSplat && layer.sigmaUs.empty();
  // Rows of nodes for the splines, of pixels otherwise.
  const std::int64_t       haloU = m_FilterU.empty() ? 0 : static_cast<std::int64_t>(m_FilterU.size()) - 1;
  const std::int64_t       haloV = m_FilterV.empty() ? 0 : static_cast<std::int64_t>(m_FilterV.size()) - 1;
  const SurfaceSplatRegion domain = Dilate(m_Image, haloU, haloV);
  m_FirstBandRow = domain.startV;
  const auto bands = static_cast<std::size_t>((domain.sizeV + BandHeight - 1) / BandHeight);
  m_BandBegin.assign(bands + 1, 0);

  std::int64_t halfU = 0;
  std::int64_t halfV = 0;
  switch (m_Method)
  {
    case MethodEnum::CubicSpline:
      halfU = halfV = 2;
      break;
    case MethodEnum::QuinticSpline:
      halfU = halfV = 3;
      break;
    default:
      halfU = m_TableU.taps / 2;
      halfV = m_TableV.taps / 2;
  }
  struct Span
  {
    std::uint32_t first;
    std::uint32_t last;
  };
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<Span>       spans(count);
  std::int64_t            bounds[4] = { INT64_MAX, INT64_MAX, INT64_MIN, INT64_MIN };
  for (std::size_t i = 0; i < count; ++i)
  {
    spans[i].first = none;
    if (perSplat)
    {
      halfU = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(std::ceil(m_Cut * (narrow ? layer.sigmaU : layer.sigmaUs[i]))));
      halfV = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(std::ceil(m_Cut * (narrow ? layer.sigmaV : layer.sigmaVs[i]))));
    }
    // Compared before the conversion: a point may be anywhere.
    const double u = layer.u[i];
    const double v = layer.v[i];
    if (!(u >= static_cast<double>(domain.startU - halfU) &&
          u < static_cast<double>(domain.startU + domain.sizeU + halfU) &&
          v >= static_cast<double>(domain.startV - halfV) &&
          v < static_cast<double>(domain.startV + domain.sizeV + halfV)) ||
        layer.weight[i] == 0.0f)
    {
      continue;
    }
    const std::int64_t iu = FloorToInteger(u);
    const std::int64_t iv = FloorToInteger(v);
    const std::int64_t firstU = std::max(iu - halfU + 1, domain.startU);
    const std::int64_t lastU = std::min(iu + halfU, domain.startU + domain.sizeU - 1);
    const std::int64_t firstV = std::max(iv - halfV + 1, domain.startV);
    const std::int64_t lastV = std::min(iv + halfV, domain.startV + domain.sizeV - 1);
    if (firstU > lastU || firstV > lastV)
    {
      continue;
    }
    bounds[0] = std::min(bounds[0], firstU);
    bounds[1] = std::min(bounds[1], firstV);
    bounds[2] = std::max(bounds[2], lastU);
    bounds[3] = std::max(bounds[3], lastV);
    spans[i].first = static_cast<std::uint32_t>((firstV - m_FirstBandRow) / BandHeight);
    spans[i].last = static_cast<std::uint32_t>((lastV - m_FirstBandRow) / BandHeight);
    for (std::uint32_t band = spans[i].first; band <= spans[i].last; ++band)
    {
      ++m_BandBegin[band + 1];
    }
    ++m_NumberOfSplats;
  }
  for (std::size_t band = 0; band < bands; ++band)
  {
    m_BandBegin[band + 1] += m_BandBegin[band];
  }
  const std::size_t total = m_BandBegin[bands];
  m_U.resize(total);
  m_V.resize(total);
  m_Weight.resize(total);
  if (perSplat)
  {
    m_SigmaU.resize(total);
    m_SigmaV.resize(total);
  }
  std::vector<std::size_t> next(m_BandBegin.begin(), m_BandBegin.end());
  for (std::size_t i = 0; i < count; ++i)
  {
    if (spans[i].first == none)
    {
      continue;
    }
    for (std::uint32_t band = spans[i].first; band <= spans[i].last; ++band)
    {
      const std::size_t slot = next[band]++;
      m_U[slot] = layer.u[i];
      m_V[slot] = layer.v[i];
      m_Weight[slot] = layer.weight[i];
      if (perSplat)
      {
        m_SigmaU[slot] = narrow ? static_cast<float>(layer.sigmaU) : layer.sigmaUs[i];
        m_SigmaV[slot] = narrow ? static_cast<float>(layer.sigmaV) : layer.sigmaVs[i];
      }
    }
  }
  if (m_NumberOfSplats > 0)
  {
    m_SplatBounds.startU = bounds[0];
    m_SplatBounds.startV = bounds[1];
    m_SplatBounds.sizeU = bounds[2] - bounds[0] + 1;
    m_SplatBounds.sizeV = bounds[3] - bounds[1] + 1;
  }
}

SurfaceSplatKernel::Rendering::Rendering(const SurfaceSplatKernel & kernel,
                                         const SurfaceSplatRegion & region,
                                         float *                    buffer,
                                         std::size_t                stride)
  : m_Kernel(kernel)
  , m_Region(region)
  , m_Buffer(buffer)
  , m_Stride(stride)
{
  const auto radiusU = static_cast<std::int64_t>(kernel.m_FilterU.size()) - 1;
  const auto radiusV = static_cast<std::int64_t>(kernel.m_FilterV.size()) - 1;
  const bool spline = IsSpline(kernel.m_Method);
  m_Reached = Intersect(Intersect(region, kernel.m_Image),
                        spline ? Dilate(kernel.m_SplatBounds, radiusU, radiusV) : kernel.m_SplatBounds);
  if (m_Reached.sizeU == 0)
  {
    return;
  }
  m_Nodes = spline ? Dilate(m_Reached, radiusU, radiusV) : m_Reached;
  const SurfaceSplatRegion splatRows = Intersect(m_Nodes, kernel.m_SplatBounds);
  if (splatRows.sizeV == 0)
  {
    return;
  }
  m_FirstBand = static_cast<std::size_t>((splatRows.startV - kernel.m_FirstBandRow) / BandHeight);
  const auto lastBand =
    static_cast<std::size_t>((splatRows.startV + splatRows.sizeV - 1 - kernel.m_FirstBandRow) / BandHeight);
  m_Jobs.push_back(lastBand - m_FirstBand + 1);
  if (spline)
  {
    m_NodeValues.assign(static_cast<std::size_t>(m_Nodes.sizeU * m_Nodes.sizeV), 0.0f);
    m_Jobs.push_back(static_cast<std::size_t>((m_Nodes.sizeV + BandHeight - 1) / BandHeight));
    m_Jobs.push_back(static_cast<std::size_t>((m_Reached.sizeV + BandHeight - 1) / BandHeight));
  }
}

void
SurfaceSplatKernel::Rendering::Run(std::size_t phase, std::size_t job)
{
  if (phase == 1)
  {
    this->FilterRows(job);
    return;
  }
  if (phase == 2)
  {
    this->FilterColumns(job);
    return;
  }
  const std::size_t band = m_FirstBand + job;
  switch (m_Kernel.m_Method)
  {
    case MethodEnum::CubicSpline:
      this->Bin<3>(band);
      break;
    case MethodEnum::QuinticSpline:
      this->Bin<5>(band);
      break;
    case MethodEnum::PerSplat:
      this->SplatEach(band);
      break;
    default:
      this->SplatTable(band);
  }
}

template <int VTaps>
void
SurfaceSplatKernel::Rendering::SplatTableOfWidth(std::size_t band)
{
  const SurfaceSplatKernel & kernel = m_Kernel;
  const TableType &          tableU = kernel.m_TableU;
  const TableType &          tableV = kernel.m_TableV;
  const int                  tapsU = VTaps > 0 ? VTaps : tableU.taps;
  const int                  tapsV = tableV.taps;
  const std::int64_t         bandRow = kernel.m_FirstBandRow + static_cast<std::int64_t>(band) * BandHeight;
  const std::int64_t         firstRow = std::max(bandRow, m_Reached.startV);
  const std::int64_t         endRow = std::min(bandRow + BandHeight, m_Reached.startV + m_Reached.sizeV);
  const std::int64_t         firstColumn = m_Reached.startU;
  const std::int64_t         endColumn = m_Reached.startU + m_Reached.sizeU;
  float * const      origin = m_Buffer - m_Region.startU - m_Region.startV * static_cast<std::int64_t>(m_Stride);
  std::vector<float> longRow(VTaps > 0 ? 0 : tapsU);
  float              shortRow[VTaps > 0 ? VTaps : 1];
  float * const      rowTaps = VTaps > 0 ? shortRow : longRow.data();
  for (std::size_t s = kernel.m_BandBegin[band]; s < kernel.m_BandBegin[band + 1]; ++s)
  {
    const std::int64_t floorU = FloorToInteger(kernel.m_U[s]);
    const std::int64_t floorV = FloorToInteger(kernel.m_V[s]);
    const std::int64_t u0 = floorU - tapsU / 2 + 1;
    const std::int64_t v0 = floorV - tapsV / 2 + 1;
    const std::int64_t rowBegin = std::max(v0, firstRow);
    const std::int64_t rowEnd = std::min(v0 + tapsV, endRow);
    if (rowBegin >= rowEnd || u0 >= endColumn || u0 + tapsU <= firstColumn)
    {
      continue;
    }
    const auto    sampleU = static_cast<float>((kernel.m_U[s] - static_cast<double>(floorU)) * tableU.rows);
    const auto    sampleV = static_cast<float>((kernel.m_V[s] - static_cast<double>(floorV)) * tableV.rows);
    const int     indexU = std::min(static_cast<int>(sampleU), tableU.rows - 1);
    const int     indexV = std::min(static_cast<int>(sampleV), tableV.rows - 1);
    const float   fractionU = sampleU - static_cast<float>(indexU);
    const float   fractionV = sampleV - static_cast<float>(indexV);
    const float * valuesU = tableU.values.data() + static_cast<std::size_t>(indexU) * tapsU;
    const float * valuesV = tableV.values.data() + static_cast<std::size_t>(indexV) * tapsV;
    for (int i = 0; i < tapsU; ++i)
    {
      rowTaps[i] = valuesU[i] + fractionU * (valuesU[i + tapsU] - valuesU[i]);
    }
    const float weight = kernel.m_Weight[s];
    const auto  rowWeight = [&](std::int64_t row) {
      const auto j = static_cast<std::size_t>(row - v0);
      return weight * (valuesV[j] + fractionV * (valuesV[j + static_cast<std::size_t>(tapsV)] - valuesV[j]));
    };
    if (u0 >= firstColumn && u0 + tapsU <= endColumn)
    {
      float * pixel = origin + rowBegin * static_cast<std::int64_t>(m_Stride) + u0;
      for (std::int64_t row = rowBegin; row < rowEnd; ++row, pixel += m_Stride)
      {
        AddScaledRow(pixel, rowTaps, rowWeight(row), tapsU);
      }
    }
    else
    {
      const std::int64_t begin = std::max(u0, firstColumn);
      const std::int64_t end = std::min(u0 + tapsU, endColumn);
      for (std::int64_t row = rowBegin; row < rowEnd; ++row)
      {
        AddScaledRow(origin + row * static_cast<std::int64_t>(m_Stride) + begin,
                     rowTaps + (begin - u0),
                     rowWeight(row),
                     static_cast<int>(end - begin));
      }
    }
  }
}

void
SurfaceSplatKernel::Rendering::SplatTable(std::size_t band)
{
  switch (m_Kernel.m_TableU.taps)
  {
    case 4:
      return this->SplatTableOfWidth<4>(band);
    case 6:
      return this->SplatTableOfWidth<6>(band);
    case 8:
      return this->SplatTableOfWidth<8>(band);
    case 10:
      return this->SplatTableOfWidth<10>(band);
    case 12:
      return this->SplatTableOfWidth<12>(band);
    case 16:
      return this->SplatTableOfWidth<16>(band);
    default:
      return this->SplatTableOfWidth<0>(band);
  }
}

void
SurfaceSplatKernel::Rendering::SplatEach(std::size_t band)
{
  const SurfaceSplatKernel & kernel = m_Kernel;
  const std::int64_t         bandRow = kernel.m_FirstBandRow + static_cast<std::int64_t>(band) * BandHeight;
  const std::int64_t         firstRow = std::max(bandRow, m_Reached.startV);
  const std::int64_t         endRow = std::min(bandRow + BandHeight, m_Reached.startV + m_Reached.sizeV);
  const std::int64_t         firstColumn = m_Reached.startU;
  const std::int64_t         endColumn = m_Reached.startU + m_Reached.sizeU;
  float * const      origin = m_Buffer - m_Region.startU - m_Region.startV * static_cast<std::int64_t>(m_Stride);
  std::vector<float> taps(static_cast<std::size_t>(std::max(m_Reached.sizeU, BandHeight)) + 2);
  float              rowTaps[BandHeight];
  for (std::size_t s = kernel.m_BandBegin[band]; s < kernel.m_BandBegin[band + 1]; ++s)
  {
    const double       sigmaU = kernel.m_SigmaU[s];
    const double       sigmaV = kernel.m_SigmaV[s];
    const auto         halfU = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(kernel.m_Cut * sigmaU)));
    const auto         halfV = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(kernel.m_Cut * sigmaV)));
    const std::int64_t floorU = FloorToInteger(kernel.m_U[s]);
    const std::int64_t floorV = FloorToInteger(kernel.m_V[s]);
    const std::int64_t u0 = floorU - halfU + 1;
    const std::int64_t v0 = floorV - halfV + 1;
    const std::int64_t rowBegin = std::max(v0, firstRow);
    const std::int64_t rowEnd = std::min(v0 + 2 * halfV, endRow);
    const std::int64_t begin = std::max(u0, firstColumn);
    const std::int64_t end = std::min(u0 + 2 * halfU, endColumn);
    if (rowBegin >= rowEnd || begin >= end)
    {
      continue;
    }
    const auto  width = static_cast<int>(end - begin);
    const auto  height = static_cast<int>(rowEnd - rowBegin);
    const auto  fractionU = static_cast<float>(kernel.m_U[s] - static_cast<double>(floorU));
    const auto  fractionV = static_cast<float>(kernel.m_V[s] - static_cast<double>(floorV));
    const auto  beginU = static_cast<int>(begin - u0 - halfU + 1);
    const auto  beginV = static_cast<int>(rowBegin - v0 - halfV + 1);
    const auto  scaleU = static_cast<float>(std::max(-1e30, -0.5 / (sigmaU * sigmaU)));
    const auto  scaleV = static_cast<float>(std::max(-1e30, -0.5 / (sigmaV * sigmaV)));
    const float weight = kernel.m_Weight[s];
    for (int i = 0; i < width; ++i)
    {
      const float d = static_cast<float>(beginU + i) - fractionU;
      taps[i] = NegativeExp(d * d * scaleU);
    }
    for (int j = 0; j < height; ++j)
    {
      const float d = static_cast<float>(beginV + j) - fractionV;
      rowTaps[j] = weight * NegativeExp(d * d * scaleV);
    }
    float * pixel = origin + rowBegin * static_cast<std::int64_t>(m_Stride) + begin;
    for (int j = 0; j < height; ++j, pixel += m_Stride)
    {
      AddScaledRow(pixel, taps.data(), rowTaps[j], width);
    }
  }
}

template <int VDegree>
void
SurfaceSplatKernel::Rendering::Bin(std::size_t band)
{
  constexpr int              taps = VDegree + 1;
  constexpr int              before = (VDegree - 1) / 2;
  const SurfaceSplatKernel & kernel = m_Kernel;
  const std::int64_t         bandRow = kernel.m_FirstBandRow + static_cast<std::int64_t>(band) * BandHeight;
  const std::int64_t         firstRow = std::max(bandRow, m_Nodes.startV);
  const std::int64_t         endRow = std::min(bandRow + BandHeight, m_Nodes.startV + m_Nodes.sizeV);
  const std::int64_t         firstColumn = m_Nodes.startU;
  const std::int64_t         endColumn = m_Nodes.startU + m_Nodes.sizeU;
  const std::int64_t         stride = m_Nodes.sizeU;
  float * const              origin = m_NodeValues.data() - m_Nodes.startU - m_Nodes.startV * stride;
  for (std::size_t s = kernel.m_BandBegin[band]; s < kernel.m_BandBegin[band + 1]; ++s)
  {
    const std::int64_t floorU = FloorToInteger(kernel.m_U[s]);
    const std::int64_t floorV = FloorToInteger(kernel.m_V[s]);
    const std::int64_t u0 = floorU - before;
    const std::int64_t v0 = floorV - before;
    const std::int64_t rowBegin = std::max(v0, firstRow);
    const std::int64_t rowEnd = std::min(v0 + taps, endRow);
    const std::int64_t begin = std::max(u0, firstColumn);
    const std::int64_t end = std::min(u0 + taps, endColumn);
    if (rowBegin >= rowEnd || begin >= end)
    {
      continue;
    }
    float wu[taps];
    float wv[taps];
    SplineWeights<VDegree>(static_cast<float>(kernel.m_U[s] - static_cast<double>(floorU)), wu);
    SplineWeights<VDegree>(static_cast<float>(kernel.m_V[s] - static_cast<double>(floorV)), wv);
    const float weight = kernel.m_Weight[s];
    if (end - begin == taps && rowEnd - rowBegin == taps)
    {
      float * node = origin + v0 * stride + u0;
      for (int j = 0; j < taps; ++j, node += stride)
      {
        AddScaledRow(node, wu, weight * wv[j], taps);
      }
    }
    else
    {
      for (std::int64_t row = rowBegin; row < rowEnd; ++row)
      {
        AddScaledRow(
          origin + row * stride + begin, wu + (begin - u0), weight * wv[row - v0], static_cast<int>(end - begin));
      }
    }
  }
}

namespace
{
constexpr int FilterBlock = 32;

/** sum_k h_k (in[-k step] + in[+k step]) for `count` neighbouring columns, in a fixed order. */
template <bool VAdd>
inline void
FilterBlockOf(const float * in, std::ptrdiff_t step, const std::vector<float> & h, float * out, int count)
{
  float     sum[FilterBlock];
  const int radius = static_cast<int>(h.size()) - 1;
  if (count == FilterBlock)
  {
    for (int i = 0; i < FilterBlock; ++i)
    {
      sum[i] = h[0] * in[i];
    }
    for (int k = 1; k <= radius; ++k)
    {
      const float * before = in - k * step;
      const float * after = in + k * step;
      const float   weight = h[k];
      for (int i = 0; i < FilterBlock; ++i)
      {
        sum[i] += weight * (before[i] + after[i]);
      }
    }
  }
  else
  {
    for (int i = 0; i < count; ++i)
    {
      sum[i] = h[0] * in[i];
      for (int k = 1; k <= radius; ++k)
      {
        sum[i] += h[k] * (in[i - k * step] + in[i + k * step]);
      }
    }
  }
  for (int i = 0; i < count; ++i)
  {
    out[i] = VAdd ? out[i] + sum[i] : sum[i];
  }
}
} // namespace

void
SurfaceSplatKernel::Rendering::FilterRows(std::size_t job)
{
  const std::int64_t begin = m_Nodes.startV + static_cast<std::int64_t>(job) * BandHeight;
  const std::int64_t end = std::min(begin + BandHeight, m_Nodes.startV + m_Nodes.sizeV);
  const auto         radius = static_cast<std::int64_t>(m_Kernel.m_FilterU.size()) - 1;
  std::vector<float> filtered(static_cast<std::size_t>(m_Reached.sizeU));
  for (std::int64_t row = begin; row < end; ++row)
  {
    // No weight was binned outside these rows.
    if (row < m_Kernel.m_SplatBounds.startV || row >= m_Kernel.m_SplatBounds.startV + m_Kernel.m_SplatBounds.sizeV)
    {
      continue;
    }
    float * nodes = m_NodeValues.data() + (row - m_Nodes.startV) * m_Nodes.sizeU;
    for (std::int64_t column = 0; column < m_Reached.sizeU; column += FilterBlock)
    {
      FilterBlockOf<false>(nodes + radius + column,
                           1,
                           m_Kernel.m_FilterU,
                           filtered.data() + column,
                           static_cast<int>(std::min<std::int64_t>(FilterBlock, m_Reached.sizeU - column)));
    }
    std::copy(filtered.begin(), filtered.end(), nodes + radius);
  }
}

void
SurfaceSplatKernel::Rendering::FilterColumns(std::size_t job)
{
  const std::int64_t begin = m_Reached.startV + static_cast<std::int64_t>(job) * BandHeight;
  const std::int64_t end = std::min(begin + BandHeight, m_Reached.startV + m_Reached.sizeV);
  const auto         radius = static_cast<std::int64_t>(m_Kernel.m_FilterU.size()) - 1;
  for (std::int64_t row = begin; row < end; ++row)
  {
    const float * nodes = m_NodeValues.data() + (row - m_Nodes.startV) * m_Nodes.sizeU + radius;
    float *       out =
      m_Buffer + (row - m_Region.startV) * static_cast<std::int64_t>(m_Stride) + (m_Reached.startU - m_Region.startU);
    for (std::int64_t column = 0; column < m_Reached.sizeU; column += FilterBlock)
    {
      FilterBlockOf<true>(nodes + column,
                          m_Nodes.sizeU,
                          m_Kernel.m_FilterV,
                          out + column,
                          static_cast<int>(std::min<std::int64_t>(FilterBlock, m_Reached.sizeU - column)));
    }
  }
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

void
SurfaceSplatExp(float * values, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    values[i] = NegativeExp(values[i]);
  }
}

void
SurfaceSplatReference(const SurfaceSplatLayer &  layer,
                      const SurfaceSplatRegion & region,
                      double *                   buffer,
                      std::size_t                stride)
{
  for (std::size_t i = 0; i < layer.u.size(); ++i)
  {
    const double sigmaU = layer.sigmaUs.empty() ? layer.sigmaU : layer.sigmaUs[i];
    const double sigmaV = layer.sigmaVs.empty() ? layer.sigmaV : layer.sigmaVs[i];
    const auto   clip = [](double x, std::int64_t start, std::int64_t size) {
      return static_cast<std::int64_t>(std::clamp(x, static_cast<double>(start), static_cast<double>(start + size)));
    };
    const std::int64_t beginU = clip(std::ceil(layer.u[i] - 8.0 * sigmaU), region.startU, region.sizeU);
    const std::int64_t endU = clip(std::floor(layer.u[i] + 8.0 * sigmaU) + 1.0, region.startU, region.sizeU);
    const std::int64_t beginV = clip(std::ceil(layer.v[i] - 8.0 * sigmaV), region.startV, region.sizeV);
    const std::int64_t endV = clip(std::floor(layer.v[i] + 8.0 * sigmaV) + 1.0, region.startV, region.sizeV);
    for (std::int64_t v = beginV; v < endV; ++v)
    {
      double * row = buffer + (v - region.startV) * static_cast<std::int64_t>(stride) - region.startU;
      for (std::int64_t u = beginU; u < endU; ++u)
      {
        const double du = (static_cast<double>(u) - layer.u[i]) / sigmaU;
        const double dv = (static_cast<double>(v) - layer.v[i]) / sigmaV;
        row[u] += layer.weight[i] * std::exp(-0.5 * (du * du + dv * dv));
      }
    }
  }
}
} // namespace itk
