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
#ifndef itkDentalPhantomMath_h
#define itkDentalPhantomMath_h

#include <algorithm>
#include <cmath>

namespace itk
{
/** Small functions that the phantom's parts share. Square roots and products only: the same bits from every library. */
namespace DentalPhantomMath
{
/** In radians. */
constexpr double Degree = 0.017453292519943295;

inline double
Clamp(double value, double low, double high)
{
  return std::min(std::max(value, low), high);
}

inline double
SmoothStep(double low, double high, double value)
{
  const double t = Clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/** Polynomial smooth maximum: rounds the edge where two bodies are cut, over a width of k. */
inline double
SmoothMax(double a, double b, double k)
{
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::max(a, b) + h * h * k * 0.25;
}

inline double
SmoothMin(double a, double b, double k)
{
  return -SmoothMax(-a, -b, k);
}

/** Coordinates on a raster of 1e-4 mm, so that the last bits of a mathematical library do not reach a file. */
inline double
Quantise(double value)
{
  return std::nearbyint(value * 1e4) / 1e4;
}
} // namespace DentalPhantomMath
} // namespace itk

#endif
