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
#ifndef itkSilhouetteGrid_h
#define itkSilhouetteGrid_h

#include <cstdint>
#include <utility>

/** Exact decisions about points of the rounding grid. */
namespace itk
{
namespace SilhouetteGrid
{
/** Coordinates have this many bits: differences then have 29, cross products 59, and products of two of those fit in
 * 128. */
constexpr int GridBits = 28;

/** -1, 0, 1 as a b is less than, equal to, more than c d. */
inline int
CompareProducts(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d)
{
#ifdef __SIZEOF_INT128__
  __extension__ using Wide = unsigned __int128;
  const Wide left = static_cast<Wide>(a) * b;
  const Wide right = static_cast<Wide>(c) * d;
  return left < right ? -1 : (left > right ? 1 : 0);
#else
  const auto multiply = [](std::uint64_t x, std::uint64_t y) {
    const std::uint64_t xl = x & 0xffffffffu, xh = x >> 32, yl = y & 0xffffffffu, yh = y >> 32;
    const std::uint64_t ll = xl * yl, lh = xl * yh, hl = xh * yl;
    const std::uint64_t middle = (ll >> 32) + (lh & 0xffffffffu) + (hl & 0xffffffffu);
    return std::pair<std::uint64_t, std::uint64_t>(xh * yh + (lh >> 32) + (hl >> 32) + (middle >> 32),
                                                   (middle << 32) | (ll & 0xffffffffu));
  };
  const auto left = multiply(a, b);
  const auto right = multiply(c, d);
  return left < right ? -1 : (right < left ? 1 : 0);
#endif
}

/** The same for signed numbers. */
inline int
CompareSignedProducts(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d)
{
  const auto magnitude = [](std::int64_t x) { return static_cast<std::uint64_t>(x < 0 ? -x : x); };
  const auto sign = [](std::int64_t x) { return x < 0 ? -1 : (x > 0 ? 1 : 0); };
  const int  left = sign(a) * sign(b);
  const int  right = sign(c) * sign(d);
  if (left != right)
  {
    return left < right ? -1 : 1;
  }
  return left == 0 ? 0 : left * CompareProducts(magnitude(a), magnitude(b), magnitude(c), magnitude(d));
}

/** num / den in [0, 1], den > 0. */
struct Fraction
{
  std::int64_t num;
  std::int64_t den;

  double
  Value() const
  {
    return static_cast<double>(num) / static_cast<double>(den);
  }
};

inline int
Compare(const Fraction & a, const Fraction & b)
{
  return CompareProducts(static_cast<std::uint64_t>(a.num),
                         static_cast<std::uint64_t>(b.den),
                         static_cast<std::uint64_t>(b.num),
                         static_cast<std::uint64_t>(a.den));
}

struct GridPoint
{
  std::int64_t x;
  std::int64_t y;
};

inline GridPoint
operator-(const GridPoint & a, const GridPoint & b)
{
  return { a.x - b.x, a.y - b.y };
}

inline bool
operator==(const GridPoint & a, const GridPoint & b)
{
  return a.x == b.x && a.y == b.y;
}

inline std::int64_t
Cross(const GridPoint & a, const GridPoint & b)
{
  return a.x * b.y - a.y * b.x;
}

inline std::int64_t
Dot(const GridPoint & a, const GridPoint & b)
{
  return a.x * b.x + a.y * b.y;
}

inline std::int64_t
Orientation(const GridPoint & a, const GridPoint & b, const GridPoint & c)
{
  return Cross(b - a, c - a);
}
} // namespace SilhouetteGrid
} // namespace itk

#endif
