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
#ifndef itkSurfaceSplatArithmetic_h
#define itkSurfaceSplatArithmetic_h

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

// Arithmetic of the innermost loops, in the headers so that it is inlined there: a fast exponential, four floats at a
// time, the weights of B-splines. Private to this module.
namespace itk
{
namespace SurfaceSplatDetail
{
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
} // namespace SurfaceSplatDetail
} // namespace itk

#endif
