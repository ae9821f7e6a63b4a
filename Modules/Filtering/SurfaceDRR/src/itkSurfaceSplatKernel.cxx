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
#include "itkVectorClones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <utility>

namespace itk
{
namespace
{
constexpr int    BandHeight = 32;
constexpr double LargestSigma = 1000.0;
constexpr double LargestPosition = std::numeric_limits<double>::max();
/** Of an image's width and height: indices are of 32 bits within. */
constexpr std::int64_t LargestSize = 1 << 28;
/** A square table that is not wider (pixels) is added in aligned rows. */
constexpr int WidestAlignedTable = 16;
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

#if defined(__GNUC__)
/** Four floats in a register. Sixteen bytes on purpose: wider vectors are taken apart where the machine has none. */
using Float4 = float __attribute__((vector_size(16)));
#else
struct Float4
{
  float values[4];
  float
  operator[](int i) const
  {
    return values[i];
  }
};
inline Float4
operator+(Float4 a, Float4 b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3] };
}
inline Float4
operator-(Float4 a, Float4 b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3] };
}
inline Float4
operator*(Float4 a, Float4 b)
{
  return { a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3] };
}
inline Float4 &
operator+=(Float4 & a, Float4 b)
{
  return a = a + b;
}
#endif

inline Float4
Broadcast(float x)
{
  return Float4{ x, x, x, x };
}

inline Float4
Load(const float * from)
{
  Float4 result;
  std::memcpy(&result, from, sizeof(result));
  return result;
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

/** The same as four, or eight with two zeros, floats; from the polynomials' coefficients. */
template <int VDegree>
inline void
SplineWeights(float f, Float4 * w)
{
  const Float4 x = Broadcast(f);
  if constexpr (VDegree == 3)
  {
    constexpr float s = 1.0f / 6.0f;
    w[0] =
      ((Float4{ -s, 0.5f, -0.5f, s } * x + Float4{ 0.5f, -1.0f, 0.5f, 0.0f }) * x + Float4{ -0.5f, 0.0f, 0.5f, 0.0f }) *
        x +
      Float4{ s, 4.0f * s, s, 0.0f };
  }
  else
  {
    constexpr float n = 1.0f / 120.0f;
    w[0] =
      ((((Float4{ -n, 5.0f * n, -10.0f * n, 10.0f * n } * x + Float4{ 5.0f * n, -20.0f * n, 30.0f * n, -20.0f * n }) *
           x +
         Float4{ -10.0f * n, 20.0f * n, 0.0f, -20.0f * n }) *
          x +
        Float4{ 10.0f * n, 20.0f * n, -60.0f * n, 20.0f * n }) *
         x +
       Float4{ -5.0f * n, -50.0f * n, 0.0f, 50.0f * n }) *
        x +
      Float4{ n, 26.0f * n, 66.0f * n, 26.0f * n };
    w[1] = ((((Float4{ -5.0f * n, n, 0.0f, 0.0f } * x + Float4{ 5.0f * n, 0.0f, 0.0f, 0.0f }) * x +
              Float4{ 10.0f * n, 0.0f, 0.0f, 0.0f }) *
               x +
             Float4{ 10.0f * n, 0.0f, 0.0f, 0.0f }) *
              x +
            Float4{ 5.0f * n, 0.0f, 0.0f, 0.0f }) *
             x +
           Float4{ n, 0.0f, 0.0f, 0.0f };
  }
}

#if defined(__GNUC__)
#  define Restrict __restrict__
#else
#  define Restrict
#endif

constexpr std::size_t ProjectedBlock = 64;

/** \return whether all points are finite and in front of the source. */
itkVectorClones bool
ProjectBlock(const SurfaceSplatProjector & projector,
             const double (*Restrict points)[3],
             const double * Restrict areas,
             int                     count,
             double                  factor,
             double * Restrict       us,
             double * Restrict       vs,
             float * Restrict        weights,
             double * Restrict       depths)
{
  const std::array<double, 12> m = projector.projection.matrix;
  const double                 magnification = projector.sourceToDetector / projector.sourceToMidsagittal;
  const double                 slopeU = projector.pixelSpacing[0] / projector.sourceToDetector;
  const double                 slopeV = projector.pixelSpacing[1] / projector.sourceToDetector;
  const double                 x0 = projector.principalPoint[0] * slopeU;
  const double                 y0 = projector.principalPoint[1] * slopeV;
  const double                 scaleU = projector.scale[0];
  const double                 scaleV = projector.scale[1];
  const double                 offsetU = projector.offset[0];
  const double                 offsetV = projector.offset[1];
  const double                 constant = projector.physical ? 0.0 : factor;
  const double                 physical = projector.physical ? factor * magnification * magnification : 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double x = points[i][0];
    const double y = points[i][1];
    const double z = points[i][2];
    const double depth = m[8] * x + m[9] * y + m[10] * z + m[11];
    const double inverse = 1.0 / depth;
    const double u = (m[0] * x + m[1] * y + m[2] * z + m[3]) * inverse;
    const double v = (m[4] * x + m[5] * y + m[6] * z + m[7]) * inverse;
    const double slope = u * slopeU - x0;
    const double rise = v * slopeV - y0;
    const double obliquity = std::sqrt(1.0 + slope * slope + rise * rise);
    us[i] = scaleU * u + offsetU;
    vs[i] = scaleV * v + offsetV;
    weights[i] = static_cast<float>(areas[i] * (constant + physical * inverse * inverse * obliquity));
    depths[i] = depth;
  }
  std::int64_t bad = 0;
  for (int i = 0; i < count; ++i)
  {
    // None is true of a value that is not a number.
    bad |= static_cast<std::int64_t>(!(depths[i] > 0.0)) |
           static_cast<std::int64_t>(!(std::abs(us[i]) <= LargestPosition)) |
           static_cast<std::int64_t>(!(std::abs(vs[i]) <= LargestPosition));
  }
  return bad == 0;
}

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

constexpr int SplitBlock = 256;

/** Positions relative to a start, cut into floor and rest, those far from [0, size) moved near, and the
 * range of the floors. Adding 1.5 * 2^30
 * leaves a double with 22 fractional bits at the end of its mantissa: floor and rest are bits of it, which needs
 * neither a library call nor a newer instruction set. */
itkVectorClones void
SplitPositions(const double * Restrict positions,
               int                     count,
               std::int64_t            start,
               std::int32_t            size,
               std::int32_t            half,
               std::int32_t * Restrict whole,
               float * Restrict        rest,
               std::int32_t            range[2])
{
  constexpr double        shift = 1610612736.0;
  constexpr std::uint64_t fractionMask = (1u << 22) - 1;
  const auto              first = static_cast<double>(start);
  const double            low = -1.0 - half;
  const double            high = 1.0 + size + half;
  // Both of the sum's leading bits are set: what they hold is taken off after the shift.
  constexpr auto offset = static_cast<std::int32_t>(0x60000000);
  for (int i = 0; i < count; ++i)
  {
    double x = positions[i] - first;
    x = x < low ? low : x;
    x = x > high ? high : x;
    x += shift;
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    whole[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(bits >> 22)) - offset;
    rest[i] = static_cast<float>(static_cast<std::int32_t>(bits & fractionMask)) * (1.0f / 4194304.0f);
  }
  std::int32_t least = INT32_MAX;
  std::int32_t greatest = INT32_MIN;
  for (int i = 0; i < count; ++i)
  {
    least = whole[i] < least ? whole[i] : least;
    greatest = whole[i] > greatest ? whole[i] : greatest;
  }
  range[0] = least;
  range[1] = greatest;
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
  // In blocks without a branch, which vectorise.
  for (std::size_t begin = first; begin < last; begin += ProjectedBlock)
  {
    const std::size_t end = std::min(begin + ProjectedBlock, last);
    double            depths[ProjectedBlock];
    if (!ProjectBlock(*this,
                      points + begin,
                      areas + begin,
                      static_cast<int>(end - begin),
                      factor,
                      layer.u.data() + begin,
                      layer.v.data() + begin,
                      layer.weight.data() + begin,
                      depths))
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (!(depths[i - begin] > 0.0) || !std::isfinite(layer.u[i]) || !std::isfinite(layer.v[i]))
        {
          return i;
        }
      }
    }
  }
  return last;
}

namespace
{
/** Some for each thread, so that one that is interrupted does not hold up the others. */
std::size_t
NumberOfChunks(std::size_t count, unsigned int threads)
{
  return threads <= 1 ? 1 : std::min<std::size_t>(4 * static_cast<std::size_t>(threads), 1 + count / 4096);
}
} // namespace

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
SurfaceSplatKernel::SortIntoBands(const SurfaceSplatLayer & layer, unsigned int threads)
{
  const std::size_t count = layer.u.size();
  const bool        perSplat = m_Method == MethodEnum::PerSplat;
  const bool        narrow = perSplat && layer.sigmaUs.empty();
  // Rows of nodes for the splines, of pixels otherwise.
  const std::int64_t haloU = m_FilterU.empty() ? 0 : static_cast<std::int64_t>(m_FilterU.size()) - 1;
  const std::int64_t haloV = m_FilterV.empty() ? 0 : static_cast<std::int64_t>(m_FilterV.size()) - 1;
  m_Domain = Dilate(m_Image, haloU, haloV);
  const auto bands = static_cast<std::size_t>((m_Domain.sizeV + BandHeight - 1) / BandHeight);
  m_BandBegin.assign(bands + 1, 0);
  if (bands == 0)
  {
    return;
  }

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
  // Neighbours on the surface mostly lie in the same bands: runs of them are put in order, not the splats. They are
  // made in chunks of splats, one after the other: the order is that of the numbers.
  const auto sizeU = static_cast<std::int32_t>(m_Domain.sizeU);
  const auto sizeV = static_cast<std::int32_t>(m_Domain.sizeV);
  m_WholeU.resize(count);
  m_WholeV.resize(count);
  m_FractionU.resize(count);
  m_FractionV.resize(count);
  m_Weight.resize(count);
  if (narrow)
  {
    m_SigmaU.assign(count, static_cast<float>(layer.sigmaU));
    m_SigmaV.assign(count, static_cast<float>(layer.sigmaV));
  }
  else
  {
    m_SigmaU = layer.sigmaUs;
    m_SigmaV = layer.sigmaVs;
  }
  struct ChunkType
  {
    std::vector<RunType>       runs;
    std::vector<std::uint64_t> bandsOfRuns;
    /** Number of its runs in each band, then the place of the next. */
    std::vector<std::size_t> places;
    std::size_t              splats{ 0 };
    std::int32_t             bounds[4] = { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN };
  };
  const auto forEachRun = [](const ChunkType & chunk, auto && visit) {
    for (std::size_t run = 0; run < chunk.runs.size(); ++run)
    {
      const auto last = static_cast<std::size_t>(chunk.bandsOfRuns[run] >> 32);
      for (std::size_t band = chunk.bandsOfRuns[run] & 0xffffffffu; band <= last; ++band)
      {
        visit(band, chunk.runs[run]);
      }
    }
  };
  const std::size_t      chunks = NumberOfChunks(count, threads);
  std::vector<ChunkType> work(chunks);
  ParallelFor(chunks, threads, [&](std::size_t number) {
    ChunkType &       chunk = work[number];
    const std::size_t chunkEnd = count * (number + 1) / chunks;
    auto              hu = static_cast<std::int32_t>(halfU);
    auto              hv = static_cast<std::int32_t>(halfV);
    const auto        cut = static_cast<std::int32_t>(perSplat ? std::ceil(m_Cut * LargestSigma) : std::max(hu, hv));
    constexpr auto    none = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t     bandsOfRun = none;
    for (std::size_t begin = count * number / chunks; begin < chunkEnd; begin += SplitBlock)
    {
      const auto size = static_cast<int>(std::min<std::size_t>(SplitBlock, chunkEnd - begin));
      std::copy_n(layer.weight.data() + begin, size, m_Weight.data() + begin);
      const std::int32_t * const us = m_WholeU.data() + begin;
      const std::int32_t * const vs = m_WholeV.data() + begin;
      std::int32_t               rangeU[2];
      std::int32_t               rangeV[2];
      SplitPositions(layer.u.data() + begin,
                     size,
                     m_Domain.startU,
                     sizeU,
                     cut,
                     m_WholeU.data() + begin,
                     m_FractionU.data() + begin,
                     rangeU);
      SplitPositions(layer.v.data() + begin,
                     size,
                     m_Domain.startV,
                     sizeV,
                     cut,
                     m_WholeV.data() + begin,
                     m_FractionV.data() + begin,
                     rangeV);
      const bool allReach = !perSplat && rangeU[0] + hu >= 0 && rangeU[1] - hu + 1 < sizeU && rangeV[0] + hv >= 0 &&
                            rangeV[1] - hv + 1 < sizeV;
      if (allReach)
      {
        chunk.splats += static_cast<std::size_t>(size);
        chunk.bounds[0] = std::min(chunk.bounds[0], rangeU[0] - hu + 1);
        chunk.bounds[1] = std::min(chunk.bounds[1], rangeV[0] - hv + 1);
        chunk.bounds[2] = std::max(chunk.bounds[2], rangeU[1] + hu);
        chunk.bounds[3] = std::max(chunk.bounds[3], rangeV[1] + hv);
      }
      for (int i = 0; i < size; ++i)
      {
        const std::size_t splat = begin + static_cast<std::size_t>(i);
        if (!allReach)
        {
          if (perSplat)
          {
            hu = std::max(1, static_cast<std::int32_t>(std::ceil(m_Cut * m_SigmaU[splat])));
            hv = std::max(1, static_cast<std::int32_t>(std::ceil(m_Cut * m_SigmaV[splat])));
          }
          if (us[i] + hu < 0 || us[i] - hu + 1 >= sizeU || vs[i] + hv < 0 || vs[i] - hv + 1 >= sizeV)
          {
            bandsOfRun = none;
            continue;
          }
          ++chunk.splats;
          chunk.bounds[0] = std::min(chunk.bounds[0], us[i] - hu + 1);
          chunk.bounds[1] = std::min(chunk.bounds[1], vs[i] - hv + 1);
          chunk.bounds[2] = std::max(chunk.bounds[2], us[i] + hu);
          chunk.bounds[3] = std::max(chunk.bounds[3], vs[i] + hv);
        }
        const std::uint32_t first = static_cast<std::uint32_t>(std::max(vs[i] - hv + 1, 0)) / BandHeight;
        const std::uint32_t last = static_cast<std::uint32_t>(std::min(vs[i] + hv, sizeV - 1)) / BandHeight;
        const std::uint64_t both = first | static_cast<std::uint64_t>(last) << 32;
        if (both != bandsOfRun)
        {
          bandsOfRun = both;
          chunk.runs.push_back({ splat, splat });
          chunk.bandsOfRuns.push_back(both);
        }
        chunk.runs.back().end = splat + 1;
      }
    }
    chunk.places.assign(bands, 0);
    forEachRun(chunk, [&chunk](std::size_t band, const RunType &) { ++chunk.places[band]; });
  });
  std::int32_t bounds[4] = { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN };
  for (const ChunkType & chunk : work)
  {
    m_NumberOfSplats += chunk.splats;
    bounds[0] = std::min(bounds[0], chunk.bounds[0]);
    bounds[1] = std::min(bounds[1], chunk.bounds[1]);
    bounds[2] = std::max(bounds[2], chunk.bounds[2]);
    bounds[3] = std::max(bounds[3], chunk.bounds[3]);
  }
  // In the order of the chunks, hence of the splats' numbers.
  std::size_t place = 0;
  for (std::size_t band = 0; band < bands; ++band)
  {
    for (ChunkType & chunk : work)
    {
      place += std::exchange(chunk.places[band], place);
    }
    m_BandBegin[band + 1] = place;
  }
  m_Runs.resize(place);
  ParallelFor(chunks, threads, [&](std::size_t number) {
    ChunkType & chunk = work[number];
    forEachRun(chunk, [this, &chunk](std::size_t band, const RunType & run) { m_Runs[chunk.places[band]++] = run; });
  });
  if (m_NumberOfSplats > 0)
  {
    m_SplatBounds.startU = m_Domain.startU + bounds[0];
    m_SplatBounds.startV = m_Domain.startV + bounds[1];
    m_SplatBounds.sizeU = bounds[2] - bounds[0] + 1;
    m_SplatBounds.sizeV = bounds[3] - bounds[1] + 1;
    m_SplatBounds = Intersect(m_SplatBounds, m_Domain);
  }
}

/** Rows of a band, four times: a splat of which the first tap is in column u goes into the copy u mod 4, where that
 * column begins a vector. A store of a neighbour that is loaded again then is one whole vector: unaligned ones that
 * overlap would have to wait for each other. */
struct SurfaceSplatKernel::Rendering::ScratchType
{
  std::vector<Float4> copies;
  std::vector<float>  row;
};

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
  m_NodeRows = Intersect(m_Nodes, kernel.m_SplatBounds);
  if (m_NodeRows.sizeV == 0)
  {
    return;
  }
  m_FirstBand = static_cast<std::size_t>((m_NodeRows.startV - kernel.m_Domain.startV) / BandHeight);
  const auto lastBand =
    static_cast<std::size_t>((m_NodeRows.startV + m_NodeRows.sizeV - 1 - kernel.m_Domain.startV) / BandHeight);
  m_Jobs.push_back(lastBand - m_FirstBand + 1);
  // The longest first, so that no thread is left alone with one at the end.
  std::vector<std::size_t> splats(m_Jobs[0], 0);
  for (std::size_t job = 0; job < m_Jobs[0]; ++job)
  {
    const std::size_t band = m_FirstBand + job;
    for (std::size_t run = kernel.m_BandBegin[band]; run < kernel.m_BandBegin[band + 1]; ++run)
    {
      splats[job] += kernel.m_Runs[run].end - kernel.m_Runs[run].begin;
    }
    m_BandsByWork.push_back(band);
  }
  std::stable_sort(m_BandsByWork.begin(), m_BandsByWork.end(), [this, &splats](std::size_t a, std::size_t b) {
    return splats[a - m_FirstBand] > splats[b - m_FirstBand];
  });
  if (spline)
  {
    m_NodeValues.resize(static_cast<std::size_t>(m_Reached.sizeU * m_NodeRows.sizeV));
    m_Jobs.push_back(static_cast<std::size_t>((m_Reached.sizeV + BandHeight - 1) / BandHeight));
  }
}

SurfaceSplatKernel::Rendering::~Rendering() = default;

auto
SurfaceSplatKernel::Rendering::TakeScratch() -> ScratchType
{
  const std::lock_guard<std::mutex> lock(m_ScratchMutex);
  if (m_Scratch.empty())
  {
    return {};
  }
  ScratchType scratch = std::move(m_Scratch.back());
  m_Scratch.pop_back();
  return scratch;
}

void
SurfaceSplatKernel::Rendering::ReturnScratch(ScratchType && scratch)
{
  const std::lock_guard<std::mutex> lock(m_ScratchMutex);
  m_Scratch.push_back(std::move(scratch));
}

void
SurfaceSplatKernel::Rendering::Run(std::size_t phase, std::size_t job)
{
  if (phase == 1)
  {
    this->FilterColumns(job);
    return;
  }
  const std::size_t band = m_BandsByWork[job];
  if (m_Kernel.m_Method == MethodEnum::PerSplat)
  {
    this->SplatEach(band);
  }
  else if (m_Kernel.m_Method == MethodEnum::Table &&
           (m_Kernel.m_TableU.taps > WidestAlignedTable || m_Kernel.m_TableU.taps != m_Kernel.m_TableV.taps))
  {
    this->SplatWideTable(band);
  }
  else
  {
    this->SplatAligned(band);
  }
}

namespace
{
/** The first tap's place in the copies of a band. */
struct AlignedRows
{
  Float4 *     copies;
  std::int32_t firstRow;
  std::int32_t firstColumn;
  /** In vectors. */
  std::ptrdiff_t width;

  Float4 *
  At(std::int32_t row, std::int32_t column) const
  {
    return copies + (4 * static_cast<std::ptrdiff_t>(row - firstRow) + (column & 3)) * width +
           ((column - (column & 3) - firstColumn) >> 2);
  }
};

/** The arrays of a kernel's splats. */
struct SplatArrays
{
  const std::int32_t * wholeU;
  const std::int32_t * wholeV;
  const float *        fractionU;
  const float *        fractionV;
  const float *        weight;
};

/** Adds the splats [i, end) of a band whose taps reach rows and columns of nodes. */
template <int VDegree>
void
BinSplats(const SplatArrays & splats,
          std::size_t         i,
          std::size_t         end,
          const AlignedRows & rows,
          std::int32_t        endRow,
          std::int32_t        endColumn)
{
  constexpr int taps = VDegree + 1;
  constexpr int before = (VDegree - 1) / 2;
  constexpr int vectors = (taps + 3) / 4;
  for (; i < end; ++i)
  {
    const std::int32_t u0 = splats.wholeU[i] - before;
    const std::int32_t v0 = splats.wholeV[i] - before;
    if (u0 < rows.firstColumn || u0 >= endColumn || v0 < rows.firstRow || v0 >= endRow)
    {
      continue;
    }
    Float4 wu[vectors];
    Float4 wv[vectors];
    SplineWeights<VDegree>(splats.fractionU[i], wu);
    SplineWeights<VDegree>(splats.fractionV[i], wv);
    const Float4 weight = Broadcast(splats.weight[i]);
    Float4 *     at = rows.At(v0, u0);
    for (int k = 0; k < vectors; ++k)
    {
      wu[k] = wu[k] * weight;
    }
    for (int j = 0; j < taps; ++j, at += 4 * rows.width)
    {
      const Float4 w = Broadcast(wv[j / 4][j % 4]);
      for (int k = 0; k < vectors; ++k)
      {
        at[k] += w * wu[k];
      }
    }
  }
}

/** The weights of a table at a position between two of its rows. */
template <int VVectors, typename TTable>
inline void
TableWeights(const TTable & table, float fraction, Float4 * w)
{
  const float   sample = fraction * static_cast<float>(table.rows);
  const int     index = std::min(static_cast<int>(sample), table.rows - 1);
  const Float4  t = Broadcast(sample - static_cast<float>(index));
  const float * values = table.values.data() + static_cast<std::size_t>(index) * (4 * VVectors);
  for (int k = 0; k < VVectors; ++k)
  {
    const Float4 a = Load(values + 4 * k);
    const Float4 b = Load(values + 4 * k + 4 * VVectors);
    w[k] = a + t * (b - a);
  }
}

/** The same by tables of so many taps. */
template <int VTaps, typename TTable>
void
AddTableSplats(const SplatArrays & splats,
               std::size_t         i,
               std::size_t         end,
               const TTable &      tableU,
               const TTable &      tableV,
               const AlignedRows & rows,
               std::int32_t        endRow,
               std::int32_t        endColumn)
{
  constexpr int vectors = (VTaps + 3) / 4;
  for (; i < end; ++i)
  {
    const std::int32_t u0 = splats.wholeU[i] - VTaps / 2 + 1;
    const std::int32_t v0 = splats.wholeV[i] - VTaps / 2 + 1;
    const int          first = std::max(0, rows.firstRow - v0);
    const int          last = std::min(VTaps, endRow - v0);
    if (u0 < rows.firstColumn || u0 >= endColumn || first >= last)
    {
      continue;
    }
    Float4 wu[vectors];
    Float4 wv[vectors];
    TableWeights<vectors>(tableU, splats.fractionU[i], wu);
    TableWeights<vectors>(tableV, splats.fractionV[i], wv);
    for (Float4 & w : wu)
    {
      w = w * Broadcast(splats.weight[i]);
    }
    Float4 * at = rows.At(v0, u0);
    if (first == 0 && last == VTaps)
    {
      for (int j = 0; j < VTaps; ++j, at += 4 * rows.width)
      {
        const Float4 w = Broadcast(wv[j / 4][j % 4]);
        for (int k = 0; k < vectors; ++k)
        {
          at[k] += w * wu[k];
        }
      }
    }
    else
    {
      at += 4 * rows.width * first;
      for (int j = first; j < last; ++j, at += 4 * rows.width)
      {
        const Float4 w = Broadcast(wv[j / 4][j % 4]);
        for (int k = 0; k < vectors; ++k)
        {
          at[k] += w * wu[k];
        }
      }
    }
  }
}

constexpr int FilterBlock = 32;

/** out[i] = sum_k h_k (in[i + radius - k] + in[i + radius + k]), in a fixed order. */
itkVectorClones void
FilterRow(const float * in, const std::vector<float> & h, float * out, std::int32_t count)
{
  const int radius = static_cast<int>(h.size()) - 1;
  in += radius;
  for (std::int32_t begin = 0; begin < count; begin += FilterBlock)
  {
    float     sum[FilterBlock];
    const int width = std::min<int>(FilterBlock, count - begin);
    if (width == FilterBlock)
    {
      for (int i = 0; i < FilterBlock; ++i)
      {
        sum[i] = h[0] * in[begin + i];
      }
      for (int k = 1; k <= radius; ++k)
      {
        const float * before = in + begin - k;
        const float * after = in + begin + k;
        const float   weight = h[k];
        for (int i = 0; i < FilterBlock; ++i)
        {
          sum[i] += weight * (before[i] + after[i]);
        }
      }
    }
    else
    {
      for (int i = 0; i < width; ++i)
      {
        sum[i] = h[0] * in[begin + i];
        for (int k = 1; k <= radius; ++k)
        {
          sum[i] += h[k] * (in[begin + i - k] + in[begin + i + k]);
        }
      }
    }
    std::copy_n(sum, width, out + begin);
  }
}

/** Adds to a row what rows row - radius ... row + radius of the nodes give, those that there are; in a fixed order. */
itkVectorClones void
FilterColumn(const float *              nodes,
             std::int64_t               rows,
             std::int64_t               row,
             const std::vector<float> & h,
             float *                    out,
             std::int32_t               count)
{
  const auto radius = static_cast<std::int64_t>(h.size()) - 1;
  for (std::int32_t begin = 0; begin < count; begin += FilterBlock)
  {
    float     sum[FilterBlock] = {};
    const int width = std::min<int>(FilterBlock, count - begin);
    for (std::int64_t r = std::max<std::int64_t>(0, row - radius); r <= std::min(rows - 1, row + radius); ++r)
    {
      const float * in = nodes + r * count + begin;
      const float   weight = h[static_cast<std::size_t>(std::abs(r - row))];
      if (width == FilterBlock)
      {
        for (int i = 0; i < FilterBlock; ++i)
        {
          sum[i] += weight * in[i];
        }
      }
      else
      {
        for (int i = 0; i < width; ++i)
        {
          sum[i] += weight * in[i];
        }
      }
    }
    for (int i = 0; i < width; ++i)
    {
      out[begin + i] += sum[i];
    }
  }
}
} // namespace

void
SurfaceSplatKernel::Rendering::SplatAligned(std::size_t band)
{
  const SurfaceSplatKernel & kernel = m_Kernel;
  const SurfaceSplatRegion & domain = kernel.m_Domain;
  const bool                 spline = IsSpline(kernel.m_Method);
  const auto                 degree = kernel.m_Method == MethodEnum::CubicSpline ? 3 : 5;
  const int                  tapsU = spline ? degree + 1 : kernel.m_TableU.stride;
  // Splines write whole splats, also beyond the rows that are wanted: then their loops have a fixed length.
  const int  padRows = spline ? degree : 0;
  const auto toLocal = [](std::int64_t index, std::int64_t start) { return static_cast<std::int32_t>(index - start); };
  const auto bandRow = static_cast<std::int32_t>(band * BandHeight);
  const auto firstRow = std::max(bandRow, toLocal(m_NodeRows.startV, domain.startV));
  const auto endRow = std::min(bandRow + BandHeight, toLocal(m_NodeRows.startV + m_NodeRows.sizeV, domain.startV));
  const auto firstColumn = toLocal(m_Nodes.startU, domain.startU);
  const auto endColumn = toLocal(m_Nodes.startU + m_Nodes.sizeU, domain.startU);

  AlignedRows rows;
  rows.firstRow = firstRow - padRows;
  // Room for splats that begin before the first column.
  rows.firstColumn = (firstColumn - std::max(3, tapsU - 1)) & ~3;
  rows.width = (endColumn - rows.firstColumn + tapsU + 3) / 4 + 1;
  const auto  height = static_cast<std::size_t>(endRow - firstRow + 2 * padRows);
  ScratchType scratch = this->TakeScratch();
  scratch.copies.resize(std::max(scratch.copies.size(), 4 * height * static_cast<std::size_t>(rows.width)),
                        Broadcast(0.0f));
  rows.copies = scratch.copies.data();

  const SplatArrays splats{ kernel.m_WholeU.data(),
                            kernel.m_WholeV.data(),
                            kernel.m_FractionU.data(),
                            kernel.m_FractionV.data(),
                            kernel.m_Weight.data() };
  const auto        forEachRun = [&](auto && visit) {
    for (std::size_t run = kernel.m_BandBegin[band]; run < kernel.m_BandBegin[band + 1]; ++run)
    {
      visit(kernel.m_Runs[run].begin, kernel.m_Runs[run].end);
    }
  };
  const auto addTable = [&](auto taps) {
    forEachRun([&](std::size_t begin, std::size_t end) {
      AddTableSplats<decltype(taps)::value>(
        splats, begin, end, kernel.m_TableU, kernel.m_TableV, rows, endRow, endColumn);
    });
  };
  if (kernel.m_Method == MethodEnum::CubicSpline)
  {
    forEachRun([&](std::size_t begin, std::size_t end) { BinSplats<3>(splats, begin, end, rows, endRow, endColumn); });
  }
  else if (spline)
  {
    forEachRun([&](std::size_t begin, std::size_t end) { BinSplats<5>(splats, begin, end, rows, endRow, endColumn); });
  }
  else
  {
    switch (kernel.m_TableU.taps)
    {
      case 2:
        addTable(std::integral_constant<int, 2>{});
        break;
      case 4:
        addTable(std::integral_constant<int, 4>{});
        break;
      case 6:
        addTable(std::integral_constant<int, 6>{});
        break;
      case 8:
        addTable(std::integral_constant<int, 8>{});
        break;
      case 10:
        addTable(std::integral_constant<int, 10>{});
        break;
      case 12:
        addTable(std::integral_constant<int, 12>{});
        break;
      case 14:
        addTable(std::integral_constant<int, 14>{});
        break;
      default:
        addTable(std::integral_constant<int, 16>{});
    }
  }

  // The four copies' sum, for the splines filtered along the row; the scratch is left clean.
  const std::int32_t columns = endColumn - firstColumn;
  const auto         copyWidth = static_cast<std::size_t>(4 * rows.width);
  scratch.row.resize(static_cast<std::size_t>(columns) + FilterBlock);
  for (std::int32_t row = firstRow; row < endRow; ++row)
  {
    Float4 * const copies = rows.copies + 4 * static_cast<std::ptrdiff_t>(row - rows.firstRow) * rows.width;
    const float *  copy = reinterpret_cast<const float *>(copies) + (firstColumn - rows.firstColumn);
    float *        sum = scratch.row.data();
    for (std::int32_t i = 0; i < columns; ++i)
    {
      sum[i] = (copy[i] + (copy + copyWidth)[i - 1]) + ((copy + 2 * copyWidth)[i - 2] + (copy + 3 * copyWidth)[i - 3]);
    }
    if (spline)
    {
      float * const out = m_NodeValues.data() + (domain.startV + row - m_NodeRows.startV) * m_Reached.sizeU;
      FilterRow(sum, kernel.m_FilterU, out, static_cast<std::int32_t>(m_Reached.sizeU));
    }
    else
    {
      float * const out = m_Buffer + (domain.startV + row - m_Region.startV) * static_cast<std::int64_t>(m_Stride) +
                          (m_Reached.startU - m_Region.startU);
      for (std::int32_t i = 0; i < columns; ++i)
      {
        out[i] += sum[i];
      }
    }
  }
  std::fill_n(rows.copies, 4 * height * static_cast<std::size_t>(rows.width), Broadcast(0.0f));
  this->ReturnScratch(std::move(scratch));
}

template <typename TFunction>
void
SurfaceSplatKernel::ForEachSplat(std::size_t band, TFunction && visit) const
{
  for (std::size_t run = m_BandBegin[band]; run < m_BandBegin[band + 1]; ++run)
  {
    for (std::size_t splat = m_Runs[run].begin; splat < m_Runs[run].end; ++splat)
    {
      visit(splat);
    }
  }
}

void
SurfaceSplatKernel::Rendering::SplatWideTable(std::size_t band)
{
  const SurfaceSplatKernel & kernel = m_Kernel;
  const TableType &          tableU = kernel.m_TableU;
  const TableType &          tableV = kernel.m_TableV;
  const std::int64_t         bandRow = kernel.m_Domain.startV + static_cast<std::int64_t>(band) * BandHeight;
  const std::int64_t         firstRow = std::max(bandRow, m_Reached.startV);
  const std::int64_t         endRow = std::min(bandRow + BandHeight, m_Reached.startV + m_Reached.sizeV);
  const std::int64_t         firstColumn = m_Reached.startU;
  const std::int64_t         endColumn = m_Reached.startU + m_Reached.sizeU;
  float * const      origin = m_Buffer - m_Region.startU - m_Region.startV * static_cast<std::int64_t>(m_Stride);
  std::vector<float> rowTaps(static_cast<std::size_t>(tableU.taps));
  kernel.ForEachSplat(band, [&](std::size_t s) {
    const std::int64_t u0 = kernel.m_Domain.startU + kernel.m_WholeU[s] - tableU.taps / 2 + 1;
    const std::int64_t v0 = kernel.m_Domain.startV + kernel.m_WholeV[s] - tableV.taps / 2 + 1;
    const std::int64_t rowBegin = std::max(v0, firstRow);
    const std::int64_t rowEnd = std::min(v0 + tableV.taps, endRow);
    const std::int64_t begin = std::max(u0, firstColumn);
    const std::int64_t end = std::min(u0 + tableU.taps, endColumn);
    if (rowBegin >= rowEnd || begin >= end)
    {
      return;
    }
    const float   sampleU = kernel.m_FractionU[s] * static_cast<float>(tableU.rows);
    const float   sampleV = kernel.m_FractionV[s] * static_cast<float>(tableV.rows);
    const int     indexU = std::min(static_cast<int>(sampleU), tableU.rows - 1);
    const int     indexV = std::min(static_cast<int>(sampleV), tableV.rows - 1);
    const float   fractionU = sampleU - static_cast<float>(indexU);
    const float   fractionV = sampleV - static_cast<float>(indexV);
    const float * valuesU = tableU.values.data() + static_cast<std::size_t>(indexU) * tableU.stride;
    const float * valuesV = tableV.values.data() + static_cast<std::size_t>(indexV) * tableV.stride;
    for (int i = 0; i < tableU.taps; ++i)
    {
      rowTaps[i] = valuesU[i] + fractionU * (valuesU[i + tableU.stride] - valuesU[i]);
    }
    for (std::int64_t row = rowBegin; row < rowEnd; ++row)
    {
      const auto  j = static_cast<std::size_t>(row - v0);
      const float w = valuesV[j] + fractionV * (valuesV[j + static_cast<std::size_t>(tableV.stride)] - valuesV[j]);
      AddScaledRow(origin + row * static_cast<std::int64_t>(m_Stride) + begin,
                   rowTaps.data() + (begin - u0),
                   kernel.m_Weight[s] * w,
                   static_cast<int>(end - begin));
    }
  });
}

void
SurfaceSplatKernel::Rendering::SplatEach(std::size_t band)
{
  const SurfaceSplatKernel & kernel = m_Kernel;
  const std::int64_t         bandRow = kernel.m_Domain.startV + static_cast<std::int64_t>(band) * BandHeight;
  const std::int64_t         firstRow = std::max(bandRow, m_Reached.startV);
  const std::int64_t         endRow = std::min(bandRow + BandHeight, m_Reached.startV + m_Reached.sizeV);
  const std::int64_t         firstColumn = m_Reached.startU;
  const std::int64_t         endColumn = m_Reached.startU + m_Reached.sizeU;
  float * const      origin = m_Buffer - m_Region.startU - m_Region.startV * static_cast<std::int64_t>(m_Stride);
  std::vector<float> taps(static_cast<std::size_t>(std::max<std::int64_t>(m_Reached.sizeU, BandHeight)) + 2);
  float              rowTaps[BandHeight];
  kernel.ForEachSplat(band, [&](std::size_t s) {
    const double       sigmaU = kernel.m_SigmaU[s];
    const double       sigmaV = kernel.m_SigmaV[s];
    const auto         halfU = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(kernel.m_Cut * sigmaU)));
    const auto         halfV = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(kernel.m_Cut * sigmaV)));
    const std::int64_t u0 = kernel.m_Domain.startU + kernel.m_WholeU[s] - halfU + 1;
    const std::int64_t v0 = kernel.m_Domain.startV + kernel.m_WholeV[s] - halfV + 1;
    const std::int64_t rowBegin = std::max(v0, firstRow);
    const std::int64_t rowEnd = std::min(v0 + 2 * halfV, endRow);
    const std::int64_t begin = std::max(u0, firstColumn);
    const std::int64_t end = std::min(u0 + 2 * halfU, endColumn);
    if (rowBegin >= rowEnd || begin >= end)
    {
      return;
    }
    const auto width = static_cast<int>(end - begin);
    const auto height = static_cast<int>(rowEnd - rowBegin);
    const auto beginU = static_cast<int>(begin - u0 - halfU + 1);
    const auto beginV = static_cast<int>(rowBegin - v0 - halfV + 1);
    const auto scaleU = static_cast<float>(std::max(-1e30, -0.5 / (sigmaU * sigmaU)));
    const auto scaleV = static_cast<float>(std::max(-1e30, -0.5 / (sigmaV * sigmaV)));
    for (int i = 0; i < width; ++i)
    {
      const float d = static_cast<float>(beginU + i) - kernel.m_FractionU[s];
      taps[i] = NegativeExp(d * d * scaleU);
    }
    for (int j = 0; j < height; ++j)
    {
      const float d = static_cast<float>(beginV + j) - kernel.m_FractionV[s];
      rowTaps[j] = kernel.m_Weight[s] * NegativeExp(d * d * scaleV);
    }
    float * pixel = origin + rowBegin * static_cast<std::int64_t>(m_Stride) + begin;
    for (int j = 0; j < height; ++j, pixel += m_Stride)
    {
      AddScaledRow(pixel, taps.data(), rowTaps[j], width);
    }
  });
}

void
SurfaceSplatKernel::Rendering::FilterColumns(std::size_t job)
{
  const std::int64_t begin = m_Reached.startV + static_cast<std::int64_t>(job) * BandHeight;
  const std::int64_t end = std::min(begin + BandHeight, m_Reached.startV + m_Reached.sizeV);
  for (std::int64_t row = begin; row < end; ++row)
  {
    float * out =
      m_Buffer + (row - m_Region.startV) * static_cast<std::int64_t>(m_Stride) + (m_Reached.startU - m_Region.startU);
    FilterColumn(m_NodeValues.data(),
                 m_NodeRows.sizeV,
                 row - m_NodeRows.startV,
                 m_Kernel.m_FilterV,
                 out,
                 static_cast<std::int32_t>(m_Reached.sizeU));
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
