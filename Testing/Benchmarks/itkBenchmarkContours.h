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
#ifndef itkBenchmarkContours_h
#define itkBenchmarkContours_h

#include "itkContourChamferKernel.h"
#include "itkReproducibleRandom.h"

#include <cmath>
#include <cstdint>

namespace itk
{
/** A closed outline with bumps like cusps, 250 px wide, around its origin; part runs from 0 to 1. */
inline std::array<double, 2>
BenchmarkOutline(double part)
{
  const double t = 2.0 * 3.14159265358979 * part;
  return { 120.0 * std::cos(t) + 3.0 * std::sin(3.0 * t),
           45.0 * std::sin(t) + (std::sin(t) > 0.0 ? 6.0 * std::abs(std::sin(7.0 * t)) : 0.0) +
             8.0 * std::cos(2.0 * t) + 4.0 * std::sin(5.0 * t) };
}

/** Points on the outline, moved by a similarity, with white noise; the segments between them. */
inline ContourArrays
MakeBenchmarkContour(std::size_t               count,
                     const ContourSimilarity & similarity = ContourSimilarity(),
                     double                    noise = 0.0,
                     std::uint64_t             seed = 1)
{
  ReproducibleRandom random(seed);
  ContourArrays      contour;
  const double       c = similarity.scale * std::cos(similarity.angle);
  const double       s = similarity.scale * std::sin(similarity.angle);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto q = BenchmarkOutline((static_cast<double>(i) + 0.3) / static_cast<double>(count));
    contour.points.push_back(c * q[0] - s * q[1] + similarity.tx + random.Normal(0.0, noise));
    contour.points.push_back(s * q[0] + c * q[1] + similarity.ty + random.Normal(0.0, noise));
    contour.segments.push_back(static_cast<std::uint32_t>(i));
    contour.segments.push_back(static_cast<std::uint32_t>((i + 1) % count));
  }
  return contour;
}

/** Similarities about a place, one after the other, each new. */
class BenchmarkSimilarities
{
public:
  explicit BenchmarkSimilarities(double shift)
    : m_Shift(shift)
  {}

  ContourSimilarity
  Next()
  {
    ContourSimilarity similarity;
    similarity.scale = std::exp(m_Random.Uniform(-0.02, 0.02));
    similarity.angle = m_Random.Uniform(-0.02, 0.02);
    similarity.tx = m_Shift + m_Random.Uniform(-3.0, 3.0);
    similarity.ty = m_Random.Uniform(-3.0, 3.0);
    return similarity;
  }

private:
  double             m_Shift;
  ReproducibleRandom m_Random{ 7 };
};
} // namespace itk

#endif
